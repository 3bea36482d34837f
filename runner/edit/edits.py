"""Edits of saved motions, and of clips' tables: mirrored, retimed, trimmed, repeated, joined. Each gives a new one."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.symmetry import MirrorError
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.edit import join, retime
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.problem import renormalised
from dynsplines.solver.search.descent import optimised
from dynsplines.solver.solution import Solution

from ..clip.build import AROUND, Clip, around
from ..clip.file import standing_alone
from ..clip.load import answered, of_motion
from ..clip.mirror import mirrored_tables
from ..clip.parse import LONGEST, SHORTEST, check_times, table_of
from ..clip.text import keyframe_tables, tables, written
from ..errors import UserError
from ..measure.problems import stop_of
from ..motion import Saved
from ..system.progress import Progress
from ..work import Solved

Rows = Sequence[dict[str, Any]]
Lasting = Mapping[str, Rows | None]
Edit = Callable[[dict[str, Any]], dict[str, Any]]
LASTING = ("contact", "hold")  # tables of a clip that last from one time to another

FRAME_SECONDS = 0.025  # a variable frame of a transition, about: its ends leave no time to get out of the floor
LEAST_FRAMES = 6
TOLERANCE = 1e-5  # of E of a transition


@contextmanager
def _told(name: str) -> Iterator[None]:
    """What cannot be done with a motion, in one line that names it."""
    try:
        yield
    except (TimelineError, MirrorError) as error:
        raise UserError(f"{name}: {error}") from None


def mirror_of(found: Clip | Saved) -> Mirror:
    """How left and right are exchanged; raises UserError for a figure without them."""
    with _told(found.name):
        return Mirror.of(found.figure)


def mirrored(saved: Saved) -> Saved:
    """Left and right exchanged, in the x-z plane; the scene stays."""
    mirror, saved = mirror_of(saved), standing_alone(saved)
    return replace(
        saved,
        text=_text(saved, lambda clip: mirrored_tables(clip, saved.figure, mirror)),
        keys=tuple(mirror.key(key) for key in saved.keys),
        timeline=mirror.timeline(saved.timeline),
        raw=mirror.timeline(saved.raw),
    )


def retimed(saved: Saved, speed: float) -> Saved:
    """Played `speed` times as fast."""
    saved = standing_alone(saved)
    with _told(saved.name):
        timeline, raw = retime.retimed(saved.timeline, speed), retime.retimed(saved.raw, speed)
    start = saved.keys[0].time
    keys = tuple(replace(key, time=start + (key.time - start) / speed) for key in saved.keys)
    check_times([key.time for key in keys], saved.name)
    return replace(
        saved, text=_text(saved, lambda clip: retimed_tables(clip, speed)), keys=keys, timeline=timeline, raw=raw
    )


def retimed_tables(clip: dict[str, Any], speed: float) -> dict[str, Any]:
    """A clip's tables with the times of keyframes, contacts, holds, flights and a cycle at another speed."""
    if "recording" in clip:
        raise UserError("recording: say its speed in the clip, or retime the solved motion: -o NAME.npz")
    start = clip["keyframe"][0]["time"]

    def later(time: float) -> float:
        return start + (time - start) / speed

    out = clip | {"keyframe": [row | {"time": later(row["time"])} for row in clip["keyframe"]]}
    for kind in clip.keys() & set(LASTING):
        out[kind] = [row | {key: later(row[key]) for key in ("from", "to")} for row in clip[kind]]
    if "penalty" in clip:
        out["penalty"] = [_paced(row, later, speed) for row in clip["penalty"]]
    return out


def _paced(penalty: dict[str, Any], later: Callable[[float], float], speed: float) -> dict[str, Any]:
    """A penalty's table at another speed."""
    out = dict(penalty)
    if penalty.get("intervals"):
        out["intervals"] = [[later(first), later(last)] for first, last in penalty["intervals"]]
    if penalty.get("period"):
        out["period"] = penalty["period"] / speed
    return out


def check_interval(found: Clip | Saved, first: float, last: float) -> None:
    """Raises UserError unless there is motion from `first` to `last` [s]."""
    with _told(found.name):
        retime.check_interval((found.keys[0].time, found.keys[-1].time), first, last)
    check_times([first, last], found.name)


def trimmed(saved: Saved, first: float, last: float) -> Saved:
    """The part from `first` to `last` [s]; before is the raw spline through its keyframes."""
    check_interval(saved, first, last)
    saved = standing_alone(saved)
    timeline = retime.trimmed(saved.timeline, first, last)
    begin, end = float(timeline.times[0]), float(timeline.times[-1])
    inside = [key for key in saved.keys if begin + SHORTEST <= key.time <= end - SHORTEST]
    keys = (_key_on(saved.figure, timeline, 0), *inside, _key_on(saved.figure, timeline, -1))
    return _with_keys(saved, keys, timeline)


def repeated(saved: Saved, count: int) -> Saved:
    """A loop played several times over."""
    if count == 1:
        return saved
    saved = standing_alone(saved)
    period = saved.keys[-1].time - saved.keys[0].time
    if count * period > LONGEST:
        raise UserError(f"{saved.name}: {count} periods of {period:g} s are over {LONGEST:g} s")
    with _told(saved.name):
        timeline, raw = (retime.repeated(saved.figure, each, count) for each in (saved.timeline, saved.raw))
    times = [key.time + period * i for i in range(count) for key in saved.keys[1 if i else 0 :]]
    said = [(key.fixed, key.posed) for i in range(count) for key in saved.keys[1 if i else 0 :]]
    fixed, posed = zip(*said, strict=True)
    keys = Frame.many(times, saved.figure.to_qpos(path_of(timeline).at(np.array(times))), fixed, posed)
    seam = Seam.of(saved.figure, saved.timeline)
    contacts, held, flown = _rows(saved, "contact"), _rows(saved, "hold"), _flights(saved) or ()
    rounds = range(1, count)
    more = {
        "contact": [row for i in rounds for row in _carried(_later(contacts, period * i), saved.figure, seam, i)],
        "hold": [row for i in rounds for row in _later(held, period * i)],
        "flight": [row for i in rounds for row in _later(flown, period * i)],
    }
    displacement = around(replace(saved, timeline=timeline))
    text = _keyed(saved, keys, lambda solve: _displaced(solve, displacement), more)
    return replace(saved, text=text, keys=tuple(keys), timeline=timeline, raw=raw, trace=[], report={}, search={})


def _displaced(solve: dict[str, Any], displacement: dict[str, Any]) -> dict[str, Any]:
    """[solve] of a loop that comes back another way, where it says how."""
    return solve | {name: displacement.get(name, 0.0) for name in AROUND if solve.get(name) is not None}


def joined(before: Saved, after: Saved, transition: float, progress: Progress) -> Saved:
    """The second motion from where the first ends, after a transition [s] that is solved as an in-between."""
    check_transition(transition)
    check_alike(before, after)
    before, after = standing_alone(before), standing_alone(after)
    figure = before.figure
    one, two = (retime.trimmed(each.timeline, *each.timeline.times[[0, -1]].tolist()) for each in (before, after))
    place = join.following(figure, one, two, transition)
    two = join.signed_like(figure, one, place.timeline(figure, two))
    shift = float(one.times[-1]) + transition - float(two.times[0])
    two = Timeline(tuple(replace(frame, time=frame.time + shift) for frame in two.frames), two.end_slope)
    moved = [_moved(figure, after.timeline, key, place, shift) for key in after.keys]
    ends = _key_on(figure, one, -1), _key_on(figure, two, 0)
    between = _transition(before, one, two, ends, progress)
    keys = (*before.keys[:-1], *ends, *moved[1:])
    with _told("join"):
        check_times([key.time for key in keys], "join")
    contacts, flown = _later(_rows(after, "contact"), shift), _flights(after)
    more: Lasting = {
        "contact": [row for row in contacts if row.get("position") is None],  # what has one has moved elsewhere
        "hold": _later(_rows(after, "hold"), shift),
        "flight": None if flown is None else _later(flown, shift),
    }
    return _with_keys(before, keys, join.joined(one, between, two), more)


def _moved(figure: Figure, timeline: Timeline, key: Frame, place: join.Placement, shift: float) -> Frame:
    """A keyframe where its motion is to go on from another: later, and turned with its root. What it leaves free is as
    the motion has it; where a root that turns was said along some axes, all of its position is."""
    at = figure.to_qpos(path_of(timeline).at(np.array([key.time])))[0]
    fixed = key.fixed.copy()
    for columns in figure.tables.position_columns.T:
        fixed[columns[:2]] |= fixed[columns[:2]].any()
    state = np.where(key.fixed, key.state, at)
    return replace(key, time=key.time + shift, state=place.states(figure, state, "joint"), fixed=fixed)


def check_transition(transition: float) -> None:
    """Raises UserError for a transition [s] that takes no time, or too much."""
    if not SHORTEST <= transition <= LONGEST:
        raise UserError(f"a transition lasts {SHORTEST:g} to {LONGEST:g} s, not {transition:g}")


def _transition(saved: Saved, one: Timeline, two: Timeline, ends: tuple[Frame, Frame], progress: Progress) -> Timeline:
    """The in-between from the end of one timeline to the start of the other, weighed as in the first motion."""
    count = max(LEAST_FRAMES, round((ends[1].time - ends[0].time) / FRAME_SECONDS))
    begin = join.bridge(saved.figure, one, two, variable=count)
    text = _text(saved, _without_flights)
    clip = of_motion(replace(saved, text=text, keys=ends, timeline=one))
    objective = renormalised(clip.problem.plain_objective, saved.raw)
    progress.step("solving the transition", 0.0, force=True)
    return optimised(objective, begin, tolerance=TOLERANCE)


def check_alike(before: Clip | Saved, after: Clip | Saved) -> None:
    """Raises UserError unless two motions are of one figure."""
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


def measured(saved: Saved, progress: Progress, edit: str) -> Saved:
    """A motion with the report that belongs to it; `edit` says why no search stopped, where none did."""
    clip = answered(saved)
    objective = clip.problem.plain_objective
    if clip.settings.renormalise:
        objective = renormalised(objective, saved.raw)
    evaluations = saved.search.get("evaluations", 0)
    found = Solution(saved.figure, objective, saved.timeline, saved.raw, (), evaluations, stop_of(saved))
    again = Solved(clip, found, saved.search.get("seconds")).saved(progress)
    return replace(saved, report=again.report | {"stopped because": saved.search.get("stopped because", edit)})


def _key_on(figure: Figure, timeline: Timeline, number: int) -> Frame:
    """A whole keyframe where a timeline has a frame."""
    frame = timeline.frames[number]
    return Frame.key(frame.time, figure.to_qpos(frame.state))


def _with_keys(saved: Saved, keys: tuple[Frame, ...], timeline: Timeline, more: Lasting | None = None) -> Saved:
    """A motion with free ends through other keyframes, before it the raw spline through them."""
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


def _freed(solve: dict[str, Any]) -> dict[str, Any]:
    """[solve] of a clip whose ends are free now."""
    return {key: value for key, value in solve.items() if key not in ("ends", *AROUND)}


def _keyed(saved: Saved, keys: Sequence[Frame], ends: Edit = _freed, more: Lasting | None = None) -> str:
    """The clip's text with other keyframes, its [solve] table changed, its contacts, holds and flights, and more of
    them, cut to their time; no flights where more are known to be there, but not when."""
    span, more = (keys[0].time, keys[-1].time), more or {}

    def changed(clip: dict[str, Any]) -> dict[str, Any]:
        keyed = clip | {"solve": ends(clip.get("solve", {})), "keyframe": keyframe_tables(saved.figure, keys)}
        for kind in LASTING:
            keyed[kind] = _cut([*keyed.get(kind, ()), *(more.get(kind) or ())], *span)
        if "penalty" in keyed:
            keyed["penalty"] = [_flying(row, more.get("flight", ()), span) for row in keyed["penalty"]]
        return {key: value for key, value in keyed.items() if key not in LASTING or value}

    return _text(saved, changed)


def _flying(penalty: dict[str, Any], more: Rows | None, span: tuple[float, float]) -> dict[str, Any]:
    """A penalty's table with more flights, where it says any, in a span [s]."""
    if penalty.get("intervals") is None:
        return penalty
    if more is None:
        return _left_to_keyframes(penalty)
    rows = _cut([*_intervals(penalty), *more], *span)
    return penalty | {"intervals": [[row["from"], row["to"]] for row in rows]}


def _without_flights(clip: dict[str, Any]) -> dict[str, Any]:
    """A clip's tables whose flights are as its keyframes tell them."""
    return clip | {"penalty": [_left_to_keyframes(row) for row in clip["penalty"]]} if "penalty" in clip else clip


def _left_to_keyframes(penalty: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in penalty.items() if key != "intervals"}


def _intervals(penalty: dict[str, Any]) -> list[dict[str, Any]]:
    """The flights in a penalty's table, as rows from one time to another."""
    return [{"from": first, "to": last} for first, last in penalty.get("intervals") or ()]


def _flights(saved: Saved) -> Rows | None:
    """The flights of a motion's text, none where it leaves them to its keyframes."""
    said = tables(table_of(saved.text, saved.name)).get("penalty", []) if saved.text else []
    rows = [_intervals(row) for row in said if row.get("intervals") is not None]
    return [row for each in rows for row in each] if rows else None


def _rows(saved: Saved, kind: str) -> Rows:
    """The contacts or holds of a motion's text."""
    return tables(table_of(saved.text, saved.name)).get(kind, []) if saved.text else []


def _later(rows: Rows, shift: float) -> list[dict[str, Any]]:
    """Contacts, holds or flights a time [s] later."""
    return [row | {"from": row["from"] + shift, "to": row["to"] + shift} for row in rows]


def _carried(contacts: Rows, figure: Figure, seam: Seam, periods: int) -> list[dict[str, Any]]:
    """Contacts with their positions where a loop has them some periods later."""

    def later(position: ArrayLike) -> list[float]:
        return seam.carried(figure, np.array(position), periods).tolist()

    return [row | {"position": later(row["position"])} if row.get("position") is not None else row for row in contacts]


def _cut(rows: Rows, first: float, last: float) -> list[dict[str, Any]]:
    """The parts of contacts, holds or flights that lie between two times [s]."""
    cut = [row | {"from": max(row["from"], first), "to": min(row["to"], last)} for row in rows]
    return [row for row in cut if row["to"] - row["from"] >= SHORTEST]


def _text(saved: Saved, edit: Edit) -> str:
    """A motion's clip, edited; a motion that came from no clip has none."""
    return written(edit(tables(table_of(saved.text, saved.name)))) if saved.text else ""
