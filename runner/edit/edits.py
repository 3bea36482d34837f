"""Edits of saved motions and of clips' tables: mirror, retime, trim, repeat, join. They return new objects."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import TypeVar

import numpy as np

from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.edit import join, retime
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.problem import renormalised
from dynsplines.solver.search.descent import optimised

from ..clip.build import AROUND, Clip, around
from ..clip.contacts import grasps_of
from ..clip.file import standalone
from ..clip.load import of_motion
from ..clip.mirror import figure_mirror, mirrored_tables
from ..clip.parse import LONGEST, SHORTEST, check_times, is_too_near, table_of
from ..clip.table import ClipTable, ContactTable, GraspTable, KeyframeTable, PenaltyTable, SolveTable
from ..clip.text import keyframe_tables, written
from ..errors import UserError
from ..motion import Saved
from ..system.progress import Progress
from .targets import at_cut, moved_contacts, moved_targets, searched_targets, with_targets

Span = tuple[float, float]  # [s]
Row = TypeVar("Row", ContactTable, GraspTable)
Edit = Callable[[ClipTable], ClipTable]

FRAME_SECONDS = 0.025  # [s] spacing of variable frames in a transition, short enough to avoid the floor near its ends
LEAST_FRAMES = 6  # minimum number of variable frames in a transition
TOLERANCE = 1e-5  # [1] tolerance of a transition's search, relative to E


@contextmanager
def _with_name(name: str) -> Iterator[None]:
    """Raise errors of impossible edits as UserError in one line with the motion's name."""
    try:
        yield
    except TimelineError as error:
        raise UserError(f"{name}: {error}") from None


def mirror_of(source: Clip | Saved) -> Mirror:
    """Return the mirror symmetry of a figure. Raises UserError for a figure without left and right sides."""
    return figure_mirror(source.figure, _table(source), source.name)


def mirrored(saved: Saved) -> Saved:
    """Return the motion mirrored in the x-z plane, in the same scene."""
    mirror, saved = mirror_of(saved), standalone(saved)
    return replace(
        saved,
        text=_text(saved, lambda clip: mirrored_tables(clip, saved.figure, mirror)),
        keys=tuple(mirror.key(key) for key in saved.keys),
        timeline=mirror.timeline(saved.timeline),
        raw=mirror.timeline(saved.raw),
    )


def retimed(saved: Saved, speed: float) -> Saved:
    """Return the motion at `speed` times the speed."""
    saved = standalone(saved)
    with _with_name(saved.name):
        timeline, raw = retime.retimed(saved.timeline, speed), retime.retimed(saved.raw, speed)
    start = saved.keys[0].time
    keys = tuple(replace(key, time=start + (key.time - start) / speed) for key in saved.keys)
    check_times([key.time for key in keys], saved.name)
    return replace(
        saved, text=_text(saved, lambda clip: retimed_tables(clip, speed)), keys=keys, timeline=timeline, raw=raw
    )


def retimed_tables(clip: ClipTable, speed: float) -> ClipTable:
    """Return a clip's tables with the times of keyframes, contacts, grasps, flights and a cycle at another speed."""
    if clip.recording is not None:
        raise UserError("recording: set its speed in the clip, or retime the solved motion: -o NAME.npz")
    start = clip.keyframe[0].time

    def later(time: float) -> float:
        return start + (time - start) / speed

    return clip.changed(
        keyframe=[row.changed(time=later(row.time)) for row in clip.keyframe],
        contact=[row.changed(start=later(row.start), end=later(row.end)) for row in clip.contact],
        grasp=[row.changed(start=later(row.start), end=later(row.end)) for row in clip.grasp],
        penalty=[_paced(row, later, speed) for row in clip.penalty],
    )


def _paced(penalty: PenaltyTable, later: Callable[[float], float], speed: float) -> PenaltyTable:
    options = dict(penalty.options)
    if options.get("intervals"):
        options["intervals"] = [[later(first), later(last)] for first, last in options["intervals"]]
    if options.get("period"):
        options["period"] = options["period"] / speed
    return PenaltyTable.of(penalty.kind, **options)


@dataclass(frozen=True)
class TimedTables:
    """Contacts, grasps, flights and targets that a motion gets from another one; flights None: their times are
    unknown."""

    contacts: Sequence[ContactTable] = ()
    grasps: Sequence[GraspTable] = ()
    flights: Sequence[Span] | None = ()
    targets: Sequence[KeyframeTable] = ()


def check_interval(source: Clip | Saved, first: float, last: float) -> None:
    """Raise UserError unless the motion covers the interval from `first` to `last` [s]."""
    with _with_name(source.name):
        retime.check_interval((source.keys[0].time, source.keys[-1].time), first, last)
    check_times([first, last], source.name)


def trimmed(saved: Saved, first: float, last: float) -> Saved:
    """Return the part from `first` to `last` [s], with the raw spline through its keyframes as `raw`."""
    check_interval(saved, first, last)
    saved = standalone(saved)
    timeline = retime.trimmed(saved.timeline, first, last)
    begin, end = float(timeline.times[0]), float(timeline.times[-1])
    within = [key for key in saved.keys if begin < key.time < end]
    inside = [key for key in within if not is_too_near(begin, key.time) and not is_too_near(key.time, end)]
    edges = (_key_on(saved.figure, timeline, number) for number in (0, -1))
    start, stop = (at_cut(edge, saved.keys, searched_targets(saved)) for edge in edges)
    return _with_keys(saved, (start, *inside, stop), timeline)


def repeated(saved: Saved, count: int) -> Saved:
    """Return a loop repeated several times."""
    if count == 1:
        return saved
    saved = standalone(saved)
    period = saved.keys[-1].time - saved.keys[0].time
    if count * period > LONGEST:
        raise UserError(f"{saved.name}: {count} periods of {period:g} s are over {LONGEST:g} s")
    with _with_name(saved.name):
        timeline, raw = (retime.repeated(saved.figure, path, count) for path in (saved.timeline, saved.raw))
    times = [key.time + period * i for i in range(count) for key in saved.keys[1 if i else 0 :]]
    seam_key = _seam_key(saved)
    first, *inside, last = saved.keys
    masked = [first, *[*inside, seam_key] * (count - 1), *inside, last]
    fixed, posed = zip(*((key.fixed, key.posed) for key in masked), strict=True)
    keys = Frame.many(times, saved.figure.to_qpos(path_of(timeline).at(np.array(times))), fixed, posed)
    seam = Seam.of(saved.figure, saved.timeline)
    table, flown = _table(saved), _flights(saved) or ()
    rounds = [(i, period * i, partial(seam.moved_points, saved.figure, periods=i)) for i in range(1, count)]
    targets = [row for row in searched_targets(saved) if row.time > first.time or not seam_key.is_key]
    more = TimedTables(
        [row for _, shift, displaced in rounds for row in moved_contacts(_later(table.contact, shift), displaced)],
        [row for _, shift, _ in rounds for row in _later(table.grasp, shift)],
        [(first + shift, last + shift) for _, shift, _ in rounds for first, last in flown],
        [row for _, shift, displaced in rounds for row in moved_targets(saved, targets, displaced, shift)],
    )
    displacement = around(replace(saved, timeline=timeline))
    names = [name for name in AROUND if getattr(_table(saved).solve, name) is not None]
    back = {name: getattr(displacement, name) or 0.0 for name in names}
    text = _keyed(saved, keys, _table(saved).solve.changed(**back), more)
    return replace(saved, text=text, keys=tuple(keys), timeline=timeline, raw=raw, trace=[], report={}, search={})


def _seam_key(saved: Saved) -> Frame:
    """Return the last keyframe of a loop as an inner seam of repeated cycles, with the entries that the first keyframe
    fixes or poses fixed or posed as well."""
    first, last = saved.keys[0], saved.keys[-1]
    fixed, specified = first.fixed | last.fixed, first.known | last.known
    return at_cut(Frame(last.time, last.state, fixed, specified & ~fixed), saved.keys, searched_targets(saved))


def joined(before: Saved, after: Saved, transition: float, progress: Progress) -> Saved:
    """Return two motions in sequence, with a transition [s] that is solved as an in-between."""
    check_transition(transition)
    check_alike(before, after)
    before, after = standalone(before), standalone(after)
    figure = before.figure
    one, two = (retime.trimmed(part.timeline, *part.timeline.times[[0, -1]].tolist()) for part in (before, after))
    place = join.following(figure, one, two, transition)
    two = join.signed_like(figure, one, place.timeline(figure, two))
    shift = float(one.times[-1]) + transition - float(two.times[0])
    two = Timeline(tuple(replace(frame, time=frame.time + shift) for frame in two.frames), two.end_slope)
    moved = [_moved(figure, after.timeline, key, place, shift) for key in after.keys]
    ends = _key_on(figure, one, -1), _key_on(figure, two, 0)
    table, flown = _table(after), _flights(after)
    grasps = _grasps_across(figure, ends, _table(before).grasp, _later(table.grasp, shift))
    between = _transition(before, one, two, ends, grasps, progress)
    targets = moved_targets(after, searched_targets(after), place.points, shift)
    last, first = at_cut(ends[0], before.keys, searched_targets(before)), at_cut(ends[1], moved, targets)
    keys = (*before.keys[:-1], last, first, *moved[1:])
    with _with_name("join"):
        check_times([key.time for key in keys], "join")
    more = TimedTables(
        moved_contacts(_later(table.contact, shift), place.points),
        [*grasps, *_later(table.grasp, shift)],
        None if flown is None else [(first + shift, last + shift) for first, last in flown],
        targets,
    )
    return _with_keys(before, keys, join.joined(one, between, two), more)


def _moved(figure: Figure, timeline: Timeline, key: Frame, place: join.Placement, shift: float) -> Frame:
    """Return a keyframe of the second motion, shifted in time and rotated with its root. Free entries are those of the
    motion. If single axes of a rotated root are fixed, its whole position becomes fixed."""
    at = figure.to_qpos(path_of(timeline).at(np.array([key.time])))[0]
    fixed = key.fixed.copy()
    for columns in figure.tables.position_columns.T:
        fixed[columns[:2]] |= fixed[columns[:2]].any()
    state = np.where(key.fixed, key.state, at)
    return replace(key, time=key.time + shift, state=place.states(figure, state, "joint"), fixed=fixed)


def check_transition(transition: float) -> None:
    """Raise UserError for a transition [s] that is too short or too long."""
    if not SHORTEST <= transition <= LONGEST:
        raise UserError(f"a transition lasts {SHORTEST:g} to {LONGEST:g} s, not {transition:g}")


def _grasps_across(
    figure: Figure, ends: tuple[Frame, Frame], before: Sequence[GraspTable], after: Sequence[GraspTable]
) -> list[GraspTable]:
    """Return the grasps during a transition: a hand holds the same place of the same body before and after it."""
    first, last = (end.time for end in ends)
    again = {(row.hand, row.body) for row in after if row.start <= last + SHORTEST}
    held = [row for row in before if row.end >= first - SHORTEST and (row.hand, row.body) in again]
    grasps, timeline = list[GraspTable](), raw_timeline(figure, list(ends))
    for row in (row.changed(start=first, end=last) for row in held):
        with suppress(UserError):  # a hand that holds another place
            grasps_of(figure, timeline, [row], "join")
            grasps.append(row)
    return grasps


def _transition(
    saved: Saved,
    one: Timeline,
    two: Timeline,
    ends: tuple[Frame, Frame],
    grasps: Sequence[GraspTable],
    progress: Progress,
) -> Timeline:
    """Return the in-between from the end of one timeline to the start of the other, with the first motion's weights."""
    count = max(LEAST_FRAMES, round((ends[1].time - ends[0].time) / FRAME_SECONDS))
    begin = join.bridge(saved.figure, one, two, variable=count)
    keyframes = keyframe_tables(saved.figure, ends)
    text = _text(saved, lambda clip: _without_flights(clip).changed(contact=[], grasp=grasps, keyframe=keyframes))
    clip = of_motion(replace(saved, text=text, keys=ends, timeline=one), contacts=True)
    objective = renormalised(clip.problem.plain_objective, saved.raw)
    progress.step("solving the transition", 0.0, force=True)
    return optimised(objective, begin, max_evaluations=clip.settings.max_evaluations, tolerance=TOLERANCE)


def check_alike(before: Clip | Saved, after: Clip | Saved) -> None:
    """Raise UserError unless two motions are of one figure."""
    one, two = before.figure, after.figure
    names = [[link.name for link in figure.links[1:]] for figure in (one, two)]
    if names[0] != names[1]:
        odd = sorted(set(names[0]) ^ set(names[1])) or ["their order"]
        raise UserError(
            f"'{before.name}' and '{after.name}' are of different figures; they differ in: {', '.join(odd)}"
        )
    if one.coordinates != two.coordinates:
        raise UserError(
            f"'{before.name}' is in {one.coordinates} coordinates, '{after.name}' in {two.coordinates} coordinates; "
            "solve both in the same"
        )
    for a, b in zip(one.links[1:], two.links[1:], strict=True):
        same = a.kind is b.kind and a.parent == b.parent and a.qpos == b.qpos
        if not same or any(
            not np.allclose(getattr(a, k), getattr(b, k), atol=1e-6) for k in ("turn", "offset", "axis")
        ):
            raise UserError(f"'{before.name}' and '{after.name}' are of different figures; they differ at '{a.name}'")


def _key_on(figure: Figure, timeline: Timeline, number: int) -> Frame:
    frame = timeline.frames[number]
    return Frame.key(frame.time, figure.to_qpos(frame.state))


def _with_keys(saved: Saved, keys: tuple[Frame, ...], timeline: Timeline, more: TimedTables = TimedTables()) -> Saved:
    """Return a motion with free ends and other keyframes, with the raw spline through these as `raw`."""
    raw = raw_timeline(saved.figure, list(keys))
    return replace(
        saved,
        text=_keyed(saved, keys, more=more),
        keys=keys,
        timeline=timeline,
        raw=raw,
        trace=[],
        report={},
        search={},
    )


def _keyed(
    saved: Saved, keys: Sequence[Frame], solve: SolveTable | None = None, more: TimedTables = TimedTables()
) -> str:
    """Return the clip's text with other keyframes, and its and `more`'s contacts, grasps, flights and targets, cut to
    its time. There are no flights if the times of those of `more` are unknown. With `solve` None the clip has free
    ends."""
    span, targets = (keys[0].time, keys[-1].time), [*searched_targets(saved), *more.targets]

    def changed(clip: ClipTable) -> ClipTable:
        return clip.changed(
            solve=clip.solve.without("ends", *AROUND) if solve is None else solve,
            contact=_cut([*clip.contact, *more.contacts], *span),
            grasp=_cut([*clip.grasp, *more.grasps], *span),
            penalty=[_flying(row, more.flights, span) for row in clip.penalty],
            keyframe=with_targets(keyframe_tables(saved.figure, keys), targets),
        )

    return _text(saved, changed)


def _flying(penalty: PenaltyTable, more: Sequence[Span] | None, span: Span) -> PenaltyTable:
    """Return a penalty's table with more flights in a span [s], if it lists flights."""
    intervals = penalty.options.get("intervals")
    if intervals is None:
        return penalty
    if more is None:
        return _without_intervals(penalty)
    inside = [(max(first, span[0]), min(last, span[1])) for first, last in [*intervals, *more]]
    flights = [[first, last] for first, last in inside if last - first >= SHORTEST]
    return PenaltyTable.of(penalty.kind, **{**penalty.options, "intervals": flights})


def _without_flights(clip: ClipTable) -> ClipTable:
    return clip.changed(penalty=[_without_intervals(row) for row in clip.penalty])


def _without_intervals(penalty: PenaltyTable) -> PenaltyTable:
    return PenaltyTable.of(penalty.kind, **{key: value for key, value in penalty.options.items() if key != "intervals"})


def _flights(saved: Saved) -> list[Span] | None:
    """Return the flights of a motion's text; None if they are inferred from its keyframes."""
    listed = [row.options["intervals"] for row in _table(saved).penalty if row.options.get("intervals") is not None]
    return [(first, last) for intervals in listed for first, last in intervals] if any(listed) else None


def _table(source: Clip | Saved) -> ClipTable:
    return table_of(source.text, source.name) if source.text else ClipTable(figure="")


def _later(rows: Sequence[Row], shift: float) -> list[Row]:
    return [row.changed(start=row.start + shift, end=row.end + shift) for row in rows]


def _cut(rows: Sequence[Row], first: float, last: float) -> list[Row]:
    """Return the parts of contacts or grasps between two times [s]."""
    cut = [row.changed(start=max(row.start, first), end=min(row.end, last)) for row in rows]
    return [row for row in cut if row.end - row.start >= SHORTEST]


def _text(saved: Saved, edit: Edit) -> str:
    """Return a motion's clip text, edited; "" for a motion without one."""
    return written(edit(table_of(saved.text, saved.name))) if saved.text else ""
