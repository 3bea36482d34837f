"""The problem of a motion that follows a recording: its frames, stances and soft constraints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from pydantic import TypeAdapter, ValidationError

from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact, ContactSchedule
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import TrackingPenalty
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Plane, static_surfaces
from dynsplines.solver.tolerances import ROUNDING

from ...errors import UserError
from ...scene.framing import spread
from ..context import Context, knees_and_elbows
from ..kinds import KINDS, Options
from ..posing.places import Places, sole_points, sphere_at
from ..table import ContactTable, StanceTable

STANCES = TypeAdapter(list[StanceTable])
# longest panel [s] of Gauss's rule, and its number of nodes, exact for polynomials of degree 5
LONGEST_PANEL, POINTS = 0.05, 3
TOLERANCE = 3e-3  # [1] progress relative to E at which a search ends
NEXT_TO = 0.008  # [s] minimum distance of frames from a keyframe, half of their minimum spacing


def tracking_context(figure: Figure, times: Array, states: Array, where: str) -> Context:
    """Return the inputs of soft constraints of a motion near samples at times (T,) [s], with states (T, N).

    Its soles are those of the samples, and its surfaces those of the model.
    """
    frames = Frame.many(times, states, np.zeros(states.shape, bool))
    samples = Timeline(tuple(frames[i] for i in spread(len(frames))), np.zeros((2, figure.width)))
    soles = tuple(sphere_at(figure, point) for point in sole_points(figure, figure.to_qpos(samples.states)))
    schedule = ContactSchedule(
        figure,
        samples,
        soles,
        static_surfaces(figure.model),
        specified_flights=(),
        has_cycle=False,
        is_recording=True,
    )
    return Context(schedule, where, tuple(knees_and_elbows(figure)))


def rests_of(context: Context, tables: Sequence[ContactTable], span: tuple[float, float]) -> tuple[Contact, ...]:
    """Return the stances of [[contact]] tables for a recording over a span [s]."""
    places, soles, rests = Places(context.figure, context.points), {p.name: p for p in context.points}, list[Contact]()
    for number, table in enumerate(tables, start=1):
        name = f"{context.where}: contact {number} ('{table.point}')"
        point = soles.get(table.point) or places.named_point(table.point, name)
        if not span[0] - ROUNDING <= table.start < table.end <= span[1] + ROUNDING:
            raise UserError(
                f"{name}: {table.start:g} to {table.end:g} s is not within the recording, {span[0]:g} to {span[1]:g} s"
            )
        if table.position is not None:
            raise UserError(f"{name}: beside a recording, which determines it, a contact has no position; remove it")
        rests.append(Contact(point, table.start, table.end, rolls=True))
    return tuple(rests)


def stances_of(rests: Sequence[Contact]) -> list[dict[str, object]]:
    """Return stances as stored in a motion's file, see `StanceTable`."""
    rows = list[StanceTable]()
    for rest in rests:
        on = None if rest.surface is None else (*rest.surface.point.tolist(), *rest.surface.normal.tolist())
        rows.append(StanceTable.without_checks(point=rest.point.name, start=rest.first, end=rest.last, on=on))
    return [row.model_dump(by_alias=True, exclude_none=True) for row in rows]


def stances_in(stances: object, context: Context) -> tuple[Contact, ...]:
    """Return the stances that a motion's file contains.

    Raises:
        UserError: The stances are damaged, or are not of this figure.
    """
    places, soles, rests = Places(context.figure, context.points), {p.name: p for p in context.points}, list[Contact]()
    try:
        rows = STANCES.validate_python(stances)
    except ValidationError:
        raise UserError(f"{context.where}: its stances are damaged; solve the clip again") from None
    for row in rows:
        point = soles.get(row.point) or places.point(row.point)
        if point is None or not row.start < row.end:
            raise UserError(f"{context.where}: its stances belong to another figure; solve the clip again")
        on = None if row.on is None else Plane("ground", np.array(row.on[:3]), np.array(row.on[3:]))
        rests.append(Contact(point, row.start, row.end, surface=on, rolls=True))
    return tuple(rests)


def tracking_problem(
    near: TrackingPenalty,
    context: Context,
    options: Mapping[str, Options],
    times: Array,
    edits: Sequence[Frame] = (),
) -> Problem:
    """Return the problem of tracking a recording.

    Args:
        context: The inputs of soft constraints, with the stances of the recording.
        options: The options of the soft constraints by kind, where they differ from the defaults.
        times: The times of the frames, (M,) [s].
        edits: The keyframes.
    """
    figure, path = near.recorded.figure, near.recorded.path
    free = _clear(times, np.array([edit.time for edit in edits]))
    frames = loose_frames(figure, free, path.at(free))
    keys = sorted([*edits, *frames], key=lambda frame: frame.time)
    quadrature = Quadrature("gauss", POINTS, LONGEST_PANEL)
    settings = Settings(variable=0, frames=0, tolerance=TOLERANCE, renormalise=False, quadrature=quadrature)
    terms = [term for name, kind in KINDS.items() for term in kind.terms(context, options.get(name, Options()))]
    return Problem(figure, tuple(keys), ((near, 1.0), *terms), settings)


def loose_frames(figure: Figure, times: Array, states: Array) -> tuple[Frame, ...]:
    """Return frames without fixed entries, at times (M,) [s], with initial states (M, N)."""
    everything = np.ones(figure.width, bool)
    poses = zip(times, figure.to_qpos(states), strict=True)
    return tuple(Frame(time, qpos, ~everything, everything) for time, qpos in poses)


def _clear(times: Array, key_times: Array) -> Array:
    """Return the times (M,) of frames that are not next to keyframes, where the spline would oscillate."""
    if not key_times.size:
        return times
    away = np.abs(times[:, None] - key_times).min(axis=1)
    ends = np.isin(times, (times[0], times[-1]))
    return times[(away > NEXT_TO) | (ends & (away > ROUNDING))]
