"""A clip's soft constraints: every kind's default, what its [[penalty]] tables change, what its keyframes tell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from pydantic import ValidationError

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import BendLimits, Contact, Penalty

from ..errors import UserError, unknown
from .context import Context, knees_and_elbows
from .kinds import KINDS, RENAMED, BendOptions, CycleOptions, FlightOptions, Options, SoleMargin, limits
from .table import PenaltyTable, spoken

CARRIED = ("flight", "support", "peak")  # on by default where keyframes tell what carries the figure
ROOT_WEIGHT_CARRIED = 0.45  # of "root", which flight and support then know better
ANY = {option for kind in KINDS.values() for option in kind.options.model_fields}
NO_CYCLE = "no cycle: that takes three keyframes that fix every joint, not all alike, and one free joint or none"
DEEP = 0.02  # [m] of a sole point in something, by a keyframe, from which on the user is told


def chosen(entries: Sequence[PenaltyTable], where: str) -> dict[str, Options]:
    """What the tables say by kind; raises UserError for kinds and options that are not there, wrong or given twice."""
    given: dict[str, int] = {}
    found: dict[str, Options] = {}
    raw = {"penalty": [{"kind": entry.kind, **entry.said} for entry in entries]}
    for i, entry in enumerate(entries, 1):
        here = f"{where}: penalty {i}"
        if entry.kind in RENAMED:
            raise UserError(f"{here}: penalty '{entry.kind}' is called '{RENAMED[entry.kind]}' now")
        if entry.kind not in KINDS:
            raise UserError(f"{here}: {unknown('penalty', entry.kind, KINDS)}")
        if entry.kind in given:
            raise UserError(f"{here}: kind '{entry.kind}' is given already by penalty {given[entry.kind]}")
        options = KINDS[entry.kind].options
        for option in sorted(entry.said.keys() - options.model_fields.keys()):
            takes = ["weight", *sorted(options.model_fields.keys() - {"weight"})]
            if option not in ANY:
                raise UserError(f"{here}: {unknown('key', option, takes)}")
            raise UserError(f"{here}: '{option}' is not for kind '{entry.kind}', which takes: {', '.join(takes)}")
        try:
            found[entry.kind] = options.model_validate(entry.said)
        except ValidationError as error:
            raise UserError(f"{where}: {spoken(error, raw, ('penalty', i - 1))}") from None
        given[entry.kind] = i
    return found


@dataclass(frozen=True)
class Constraints:
    """The soft constraints of a clip with their weights, what they were made of, a line on everything to know."""

    context: Context
    penalties: tuple[tuple[Penalty, float], ...]
    notes: tuple[str, ...]


def constraints(context: Context, entries: Sequence[PenaltyTable]) -> Constraints:
    """What a clip's keyframes and tables make; raises UserError for what does not fit the figure."""
    said = chosen(entries, context.where)
    default = {kind.name: kind.options(weight=kind.weight) for kind in KINDS.values() if kind.weight is not None}
    every = default | said
    notes = context.lacking
    context = _asked(context, every, said)
    if "cycle" in said and every["cycle"].weight > 0 and context.rhythm is None:
        notes.append(NO_CYCLE)
    told = context.support is not None and context.support.tells
    absent = {kind for kind in CARRIED if kind not in said and not told}
    if told and "root" not in said:
        every["root"] = Options(weight=ROOT_WEIGHT_CARRIED)
    built = [(_made(context, kind, options), options.weight) for kind, options in every.items() if kind not in absent]
    found = [(penalty, weight) for penalty, weight in built if penalty is not None]
    notes += _deep(
        context, [penalty for penalty, _ in found if isinstance(penalty, Contact) and penalty.name == "contact"]
    )
    return Constraints(context, tuple((penalty, weight) for penalty, weight in found if weight > 0), tuple(notes))


def _made(context: Context, kind: str, options: Options) -> Penalty | None:
    try:
        return KINDS[kind].make(context, options)
    except UserError:
        raise
    except ValueError as error:
        raise UserError(f"{context.where}: penalty '{kind}': {error}") from None


def _asked(context: Context, every: Mapping[str, Options], said: Mapping[str, Options]) -> Context:
    """What some options say of the whole clip: the points of its soles, its limbs, its flights, its cycle."""
    soles, bend, flight, cycle = (every[kind] for kind in ("contact", "bend", "flight", "cycle"))
    assert isinstance(soles, SoleMargin) and isinstance(bend, BendOptions)
    assert isinstance(flight, FlightOptions) and isinstance(cycle, CycleOptions)
    if soles.points is not None:
        context = replace(context, points=context.sites(soles.points))
    if bend.joints is not None:
        context = replace(context, bends=context.limbs(bend.joints))
    context = replace(context, support=context.carried_when(flight.intervals, "flight" in said))
    return replace(context, rhythm=context.cycle(cycle.period, "cycle" in said)) if cycle.weight > 0 else context


def _deep(context: Context, found: Sequence[Contact]) -> Iterator[str]:
    """A line on keyframes that drive a foot into something: the motion goes through them all the same."""
    for contact in found:
        if contact.allowed is None or not contact.allowed.excess.any():
            continue
        states = context.keys.states
        centres, _, _ = contact.centres(Samples.still(context.figure, states))
        inside = np.max([surface.inside(centres) for surface in contact.surfaces], axis=0)
        deepest = np.where(contact.allowed.excess > 0, inside, 0).max(axis=0)
        worst = int(deepest.argmax())
        if deepest[worst] <= DEEP:
            continue
        point, frame = contact.points[int(inside[:, worst].argmax())], context.keys.frames[worst]
        others = int(np.sum(deepest > DEEP)) - 1
        more = f", as do {others} more keyframe{'s' if others > 1 else ''}" if others else ""
        yield (
            f"keyframe {worst + 1} (t = {frame.time:g} s) puts {point.name} {1000 * deepest[worst]:.0f} mm deep "
            f"into something solid{more}; keyframes are met exactly, so there it goes"
        )


def posing_bends(figure: Figure, entries: Sequence[PenaltyTable]) -> BendLimits | None:
    """How far knees and elbows may go in a pose: as in the motion, or None where their penalty is taken away."""
    asked = chosen([entry for entry in entries if entry.kind == "bend"], "clip").get("bend", BendOptions())
    assert isinstance(asked, BendOptions)
    bends = tuple(bend for bend in knees_and_elbows(figure) if asked.joints is None or bend.name in asked.joints)
    return limits(bends, asked) if bends and asked.weight > 0 else None


def flights_given(entries: Sequence[PenaltyTable]) -> tuple[tuple[float, float], ...]:
    """(first, last) [s] of every flight that the tables give by themselves."""
    asked = chosen([entry for entry in entries if entry.kind == "flight"], "clip").get("flight", FlightOptions())
    assert isinstance(asked, FlightOptions)
    return tuple(asked.intervals or ())
