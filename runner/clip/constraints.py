"""A clip's soft constraints: the defaults of every kind, and the changes by its [[penalty]] tables."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from pydantic import ValidationError

from dynsplines.solver.contacts import Interval
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import BendLimits, Penalty

from ..errors import UserError, unknown
from .context import Context, knees_and_elbows
from .kinds import (
    KINDS,
    RENAMED,
    CollisionOptions,
    CycleOptions,
    FlightOptions,
    Kind,
    LimitOptions,
    Options,
    bend_limits,
)
from .table import PenaltyTable
from .table_errors import describe

CARRIED = ("flight", "support", "peak")  # kinds that are on by default only if the ground's support is known
LINEAR_WEIGHT_CARRIED = 0.45  # [1] weight of acceleration.linear with these kinds, which penalise similar errors
NO_CYCLE = "no cycle: that takes three keyframes that fix every joint, not all alike, and one free joint or none"


def chosen(entries: Sequence[PenaltyTable], where: str) -> dict[str, Options]:
    """Return the options of every listed kind.

    Raises:
        UserError: For unknown kinds, parts and options, wrong values, and kinds that are listed twice.
    """
    numbers: dict[str, int] = {}
    options: dict[str, Options] = {}
    raw = {"penalty": [{"kind": entry.kind, **entry.options} for entry in entries]}
    for i, entry in enumerate(entries, 1):
        here = f"{where}: penalty {i}"
        if entry.kind in RENAMED:
            now = f"kind '{entry.kind}' is '{RENAMED[entry.kind]}' now, with another weight"
            raise UserError(f"{here}: {now}; `dynsplines penalties` lists all kinds")
        if entry.kind not in KINDS:
            raise UserError(f"{here}: {unknown('penalty', entry.kind, KINDS)}")
        if entry.kind in numbers:
            raise UserError(f"{here}: kind '{entry.kind}' is given already by penalty {numbers[entry.kind]}")
        kind = KINDS[entry.kind]
        for option in sorted(entry.options.keys() - kind.options.model_fields.keys()):
            raise UserError(f"{here}: {_unknown_option(kind, option)}")
        try:
            options[entry.kind] = kind.options.model_validate(entry.options)
        except ValidationError as error:
            raise UserError(f"{where}: {describe(error, raw, kind.options, ('penalty', i - 1))}") from None
        _check_weight(kind, options[entry.kind], here)
        numbers[entry.kind] = i
    return options


def _unknown_option(kind: Kind, option: str) -> str:
    takes = ["weight", *sorted(kind.choices())]
    if any(option in other.options.model_fields for other in KINDS.values()):
        return f"'{option}' is not for kind '{kind.name}', which takes: {', '.join(takes)}"
    return unknown("key", option, takes)


def _check_weight(kind: Kind, options: Options, here: str) -> None:
    """Raise UserError for weights of parts that the kind does not have, or that are off."""
    if not isinstance(options.weight, dict):
        return
    parts = {part.name: part for part in kind.parts if part.name}
    if not parts:
        raise UserError(f"{here}: weight must be a number, not a table: '{kind.name}' is one term")
    for name in options.weight:
        if name not in parts:
            raise UserError(f"{here}: weight: {unknown('part', name, parts)}")
        option = parts[name].option
        if option is not None and not getattr(options, option):
            unit = kind.choices()[option]
            raise UserError(f"{here}: weight.{name} needs {option} = ... ({unit}); without it '{name}' is off")


@dataclass(frozen=True)
class Constraints:
    """The soft constraints of a clip with their weights, their context, and notes for the user."""

    context: Context
    penalties: tuple[tuple[Penalty, float], ...]
    notes: tuple[str, ...]


def constraints(context: Context, listed: Mapping[str, Options]) -> Constraints:
    """Return the soft constraints of a clip's keyframes and of the kinds that it lists.

    Raises:
        UserError: For options that do not fit the figure.
    """
    options = {kind.name: kind.options() for kind in KINDS.values() if kind.is_default} | dict(listed)
    notes = [*context.lacking, *context.released]
    context = _with_options(context, options, listed.keys())
    if "cycle" in listed and _weight("cycle", options["cycle"]) > 0 and context.schedule.gait_cycle is None:
        notes.append(NO_CYCLE)
    notes += context.assumed_steps
    notes += context.missing_steps if _weight("cycle", options["cycle"]) > 0 else []
    is_carried = context.schedule.has_support
    absent = {kind for kind in CARRIED if kind not in listed and not is_carried}
    penalties = list[tuple[Penalty, float]]()
    for name in [name for name in options if name not in absent]:
        kind = _carried(KINDS[name]) if is_carried else KINDS[name]
        terms = list(_built(context, kind, options[name]))
        if name in listed and name != "cycle" and not terms and any(kind.weights(options[name]).values()):
            measured = "; ".join(part.quantity for part in kind.parts)
            notes.append(f"penalty '{name}' has no effect in this clip; it measures: {measured}")
        penalties += terms
    return Constraints(context, tuple((p, weight) for p, weight in penalties if weight > 0), tuple(notes))


def _carried(kind: Kind) -> Kind:
    """Return a kind with the weights for a figure whose support by the ground is known."""
    if kind.name != "acceleration":
        return kind
    parts = [replace(part, weight=LINEAR_WEIGHT_CARRIED) if part.name == "linear" else part for part in kind.parts]
    return replace(kind, parts=tuple(parts))


def _built(context: Context, kind: Kind, options: Options) -> Iterator[tuple[Penalty, float]]:
    weights = kind.weights(options)
    for part in [part for part in kind.parts if part.name in weights]:
        try:
            penalty = part.build(context, options)
        except UserError:
            raise
        except ValueError as error:
            raise UserError(f"{context.where}: penalty '{kind.name}': {error}") from None
        if penalty is not None:
            yield penalty, weights[part.name]


def _weight(kind: str, options: Options, part: str = "") -> float:
    return KINDS[kind].weights(options)[part]


def _with_options(context: Context, options: Mapping[str, Options], listed: Container[str]) -> Context:
    """Return the context with the options that affect several kinds: points of soles, limbs, flights, the cycle."""
    collision, limits, flight, cycle = (options[kind] for kind in ("collision", "limits", "flight", "cycle"))
    assert isinstance(collision, CollisionOptions) and isinstance(limits, LimitOptions)
    assert isinstance(flight, FlightOptions) and isinstance(cycle, CycleOptions)
    if collision.points is not None:
        context = context.scheduled(points=context.sites(collision.points))
    if limits.bend_joints is not None:
        context = replace(context, bends=context.limbs(limits.bend_joints))
    has_cycle = (True if "cycle" in listed else None) if _weight("cycle", cycle) > 0 else False
    flights = _flights(context, flight.intervals, is_requested="flight" in listed)
    return context.scheduled(specified_flights=flights, has_cycle=has_cycle, period=cycle.period)


def _flights(
    context: Context, intervals: Sequence[Interval] | None, *, is_requested: bool
) -> tuple[Interval, ...] | None:
    """The flights that a clip specifies; None to infer them. Without surfaces, a requested flight lasts all along."""
    first, last = float(context.keys.times[0]), float(context.keys.times[-1])
    if context.schedule.root is None:
        return None
    if intervals is None:
        return ((first, last),) if is_requested and not context.surfaces else None
    for begin, end in intervals:
        if not first <= begin < end <= last:
            raise UserError(
                f"{context.where}: penalty 'flight': [{begin:g}, {end:g}] is not an interval of the clip, which runs "
                f"from {first:g} to {last:g} s"
            )
    return tuple(intervals)


def posing_bends(figure: Figure, listed: Mapping[str, Options]) -> BendLimits | None:
    """Return the limits of knees and elbows in a pose: those of the motion, or None if their penalty is off."""
    options = listed.get("limits", LimitOptions())
    assert isinstance(options, LimitOptions)
    names = options.bend_joints
    bends = tuple(bend for bend in knees_and_elbows(figure) if names is None or bend.name in names)
    return bend_limits(bends, options) if bends and _weight("limits", options, "bend") > 0 else None


def listed_flights(listed: Mapping[str, Options]) -> tuple[tuple[float, float], ...]:
    """Return the interval (first, last) [s] of every flight in the tables."""
    options = listed.get("flight", FlightOptions())
    assert isinstance(options, FlightOptions)
    return tuple(options.intervals or ())


def weight_factors(listed: Mapping[str, Options]) -> dict[str, float]:
    """Return factors of the weights of terms, by name, for a clip that follows a recording."""
    factors: dict[str, float] = {}
    for name, options in listed.items():
        weight, kind = options.weight, KINDS[name]
        for part in kind.parts:
            factor = weight.get(part.name) if isinstance(weight, dict) else weight
            if factor is not None:
                factors[kind.term(part)] = factor
    return factors
