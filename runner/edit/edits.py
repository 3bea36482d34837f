"""Edits of motions: mirror, retime, trim, repeat. The results are motions without a clip."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit import timelines
from dynsplines.solver.figure.figure import Figure

from ..clip.build import Clip
from ..clip.mirror import figure_mirror
from ..clip.parse import LONGEST, check_times, is_too_near, table_of
from ..clip.table import ClipTable
from ..errors import UserError
from ..motion import Saved


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
