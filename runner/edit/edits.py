"""Edits of motions: mirror, retime, trim, repeat, join. The results are motions without a clip."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit import timelines
from dynsplines.solver.edit.timelines import LEAST_FRAMES
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.problem import renormalise
from dynsplines.solver.search.descent import optimise
from dynsplines.solver.search.minimum import TOLERANCE

from ..clip.build import Clip
from ..clip.contacts import contacts
from ..clip.load import of_motion
from ..clip.mirror import figure_mirror
from ..clip.parse import LONGEST, SHORTEST, check_times, is_too_near, table_of
from ..clip.table import ClipTable, GraspTable
from ..clip.text import keyframe_tables, text_of
from ..errors import UserError
from ..motion import Saved
from ..system.progress import Progress

FRAME_SECONDS = 0.025  # [s] spacing of variable frames in a transition, short enough to avoid the floor near its ends


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


def _table(source: Clip | Saved) -> ClipTable:
    return table_of(source.text, source.name) if source.text else ClipTable(figure="")


def follows_recording(source: Clip | Saved) -> bool:
    """Return whether a clip, or that of a motion, follows a recording."""
    return _table(source).recording is not None


def without_clip(saved: Saved) -> Saved:
    """Return a motion without its clip's text and measurements.

    If the clip follows a recording, every frame becomes a complete keyframe, and the motion its own raw spline.
    """
    if follows_recording(saved):
        keys, timeline = _complete(saved.figure, saved.timeline, saved.timeline.times), saved.timeline
        frames = Frame.many(timeline.times, timeline.states, np.ones_like(timeline.fixed))
        timeline = replace(timeline, frames=tuple(frames))
        saved = replace(saved, keys=keys, timeline=timeline, raw=timeline)
    return replace(saved, text="", trace=[], report={}, search={})


def _complete(figure: Figure, timeline: Timeline, times: Sequence[float] | Array) -> tuple[Frame, ...]:
    """Return complete keyframes on a timeline."""
    qpos = figure.to_qpos(path_of(timeline).at(np.array(times)))
    return tuple(Frame.key(time, row) for time, row in zip(times, qpos, strict=True))


def mirror(saved: Saved) -> Saved:
    """Return the motion mirrored in the x-z plane, in the same scene."""
    mirror, saved = mirror_of(saved), without_clip(saved)
    keys = tuple(mirror.key(key) for key in saved.keys)
    return replace(saved, keys=keys, timeline=mirror.timeline(saved.timeline), raw=mirror.timeline(saved.raw))


def retime(saved: Saved, speed: float) -> Saved:
    """Return the motion at `speed` times the speed."""
    saved = without_clip(saved)
    with _with_name(saved.name):
        timeline, raw = timelines.retime(saved.timeline, speed), timelines.retime(saved.raw, speed)
    start = saved.keys[0].time
    keys = tuple(replace(key, time=start + (key.time - start) / speed) for key in saved.keys)
    check_times([key.time for key in keys], saved.name)
    return replace(saved, keys=keys, timeline=timeline, raw=raw)


def check_interval(source: Clip | Saved, first: float, last: float) -> None:
    """Raise UserError unless the motion covers the interval from `first` to `last` [s]."""
    with _with_name(source.name):
        timelines.check_interval((source.keys[0].time, source.keys[-1].time), first, last)
    check_times([first, last], source.name)


def trim(saved: Saved, first: float, last: float) -> Saved:
    """Return the part from `first` to `last` [s]. Its keyframes are complete, with the raw spline through them."""
    check_interval(saved, first, last)
    saved = without_clip(saved)
    timeline = timelines.trim(saved.timeline, first, last)
    begin, end = float(timeline.times[0]), float(timeline.times[-1])
    within = [key.time for key in saved.keys if begin < key.time < end]
    inside = [time for time in within if not is_too_near(begin, time) and not is_too_near(time, end)]
    return _with_keys(saved, timeline, [begin, *inside, end])


def _with_keys(saved: Saved, timeline: Timeline, times: Sequence[float]) -> Saved:
    """Return a motion with another timeline, complete keyframes on it, and the raw spline through these."""
    keys = _complete(saved.figure, timeline, times)
    return replace(saved, keys=keys, timeline=timeline, raw=raw_timeline(saved.figure, list(keys)))


def repeat(saved: Saved, count: int) -> Saved:
    """Return a loop repeated several times. At the seams, the entries are fixed that either end fixes."""
    if count == 1:
        return saved
    saved = without_clip(saved)
    first, *inside, last = saved.keys
    period = last.time - first.time
    if count * period > LONGEST:
        raise UserError(f"{saved.name}: {count} periods of {period:g} s are over {LONGEST:g} s")
    with _with_name(saved.name):
        timeline, raw = (timelines.repeat(saved.figure, path, count) for path in (saved.timeline, saved.raw))
    seam = replace(first, fixed=first.fixed | last.fixed, posed=first.known | last.known)
    rounds = [replace(key, time=key.time + period * i) for i in range(count) for key in (seam if i else first, *inside)]
    keys = [*rounds, replace(last, time=first.time + count * period)]
    states = saved.figure.to_qpos(path_of(raw).at(np.array([key.time for key in keys])))
    keys = tuple(replace(key, state=state) for key, state in zip(keys, states, strict=True))
    return replace(saved, keys=keys, timeline=timeline, raw=raw)


def join(before: Saved, after: Saved, transition: float, progress: Progress) -> Saved:
    """Return two motions in sequence, with a transition [s] that is solved as an in-between. What a hand holds at the
    end of the first and at the start of the second, according to their clips, it also holds in the transition."""
    check_transition(transition)
    check_alike(before, after)
    held = [
        row for row in _grasps(before, -1) if (row.point, row.body) in {(r.point, r.body) for r in _grasps(after, 0)}
    ]
    before, after = without_clip(before), without_clip(after)
    figure = before.figure
    one, two = (timelines.trim(part.timeline, *part.timeline.times[[0, -1]].tolist()) for part in (before, after))
    two = timelines.signed_like(figure, one, timelines.following(figure, one, two, transition).timeline(figure, two))
    shift = float(one.times[-1]) + transition - float(two.times[0])
    two = Timeline(tuple(replace(frame, time=frame.time + shift) for frame in two.frames), two.end_slope)
    timeline = timelines.join(one, _transition(before, one, two, held, progress), two)
    times = [*(key.time for key in before.keys), *(key.time + shift for key in after.keys)]
    check_times(times, "join")
    return _with_keys(before, timeline, times)


def check_transition(transition: float) -> None:
    """Raise UserError for a transition [s] that is too short or too long."""
    if not SHORTEST <= transition <= LONGEST:
        raise UserError(f"a transition lasts {SHORTEST:g} to {LONGEST:g} s, not {transition:g}")


def _grasps(saved: Saved, number: int) -> list[GraspTable]:
    """Return the grasps of a motion's clip at its first (0) or last (-1) keyframe."""
    time = saved.keys[number].time
    return [row for row in _table(saved).grasp if row.start - SHORTEST <= time <= row.end + SHORTEST]


def _transition(saved: Saved, one: Timeline, two: Timeline, held: Sequence[GraspTable], progress: Progress) -> Timeline:
    """Return the in-between from the end of one timeline to the start of the other, with default soft constraints."""
    figure = saved.figure
    ends = (*_complete(figure, one, one.times[-1:]), *_complete(figure, two, two.times[:1]))
    grasps, between = list[GraspTable](), raw_timeline(figure, list(ends))
    samples = Samples.still(figure, between.states)
    for row in held:
        with suppress(UserError):  # a hand that holds another place
            contacts(samples, between, [row := row.change(start=ends[0].time, end=ends[1].time)], "join")
            grasps.append(row)
    count = max(LEAST_FRAMES, round((ends[1].time - ends[0].time) / FRAME_SECONDS))
    begin = timelines.bridge(figure, one, two, variable=count)
    text = text_of(ClipTable.without_checks(figure="", grasp=grasps, keyframe=keyframe_tables(figure, ends)))
    clip = of_motion(replace(saved, text=text, keys=ends, timeline=one))
    objective = renormalise(clip.problem.plain_objective, saved.raw)
    progress.step("solving the transition", 0.0, force=True)
    return optimise(objective, begin, max_evaluations=clip.settings.max_evaluations, tolerance=TOLERANCE)


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
            "solve both again"
        )
    for a, b in zip(one.links[1:], two.links[1:], strict=True):
        same = a.kind is b.kind and a.parent == b.parent and a.qpos == b.qpos
        if not same or any(
            not np.allclose(getattr(a, k), getattr(b, k), atol=1e-6) for k in ("turn", "offset", "axis")
        ):
            raise UserError(f"'{before.name}' and '{after.name}' are of different figures; they differ at '{a.name}'")
