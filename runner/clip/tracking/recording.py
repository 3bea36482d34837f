"""A clip's [recording]: a motion that the clip follows and its keyframes edit.

Keyframes are exact. Around each of them, within `blend`, the recording's velocities and accelerations have more weight
than its poses, which preserves detail. If `blend` is specified, the rest of the recording stays unchanged.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.recorded_stances import infer_stances
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.recording import Track, between
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.edit.timelines import repeat
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import TrackingPenalty
from dynsplines.solver.problem import Problem
from dynsplines.solver.surface.points import Point, places_of, sets_places
from dynsplines.solver.tolerances import ROUNDING

from ...errors import UserError
from ...motion import RATE, Saved, continuous, sample_count
from ..context import Context
from ..kinds import Options
from ..parse import TOLERANCE
from ..table import RecordingTable
from .problem import NEXT_TO, tracking_problem

EASE = 0.4  # [s] default of `blend`
DETAIL = 0.02  # [1] cost per segment of detail that the spline may lose, less than 1 mm; see `TrackingPenalty.times`
INNER, MARGIN = 0.75, 6  # share of a blend within which frames are free; fixed frames from there to its end
EXACT = 2e-4  # [m], [1] error in entries of the state (0.02° in a quaternion) above which a fixed frame is inserted
# end conditions, by whether the slopes at the start and at the end are those of the recording
ENDS = {
    (True, True): "clamped",
    (True, False): "clamped start",
    (False, True): "clamped end",
    (False, False): "free",
}
SHORTEST = 0.01  # [s] minimum of `blend`, so that most fixed frames near its end are not next to the keyframe


@dataclass(frozen=True, eq=False)
class TrackedRecording:
    """A recording on the time axis of the clip.

    Attributes:
        knots: The times of the recording's frames, (M,) [s].
        table: The [recording] table.
    """

    recorded: Track
    knots: Array
    table: RecordingTable
    where: str

    @classmethod
    def of_motion(cls, figure: Figure, raw: Timeline, table: RecordingTable, where: str) -> TrackedRecording:
        """Return the recording that a saved motion follows, which is its raw path."""
        recorded = Track.of(figure, *_taken_down(figure, raw, RATE / 2), exact=True)
        return cls(recorded, raw.times, table, where)

    @property
    def width(self) -> float:
        """The interval before and after a keyframe that it affects [s]."""
        return self.table.blend or EASE

    def pose(self, time: float) -> Array:
        """Return qpos (nq,) at a time [s] of the clip. Raises UserError if the recording does not cover it."""
        first, last = self.recorded.path.span
        if not first - ROUNDING <= time <= last + ROUNDING:
            raise UserError(
                f"{self.where}: a keyframe at {time:g} s is outside the recording, which lasts from {first:g} to "
                f"{last:g} s in the clip"
            )
        return self.recorded.figure.to_qpos(self.recorded.path.at(np.array([time])))[0]

    def stances(self, context: Context, edits: Sequence[Frame], specified: Sequence[Contact]) -> tuple[Contact, ...]:
        """Return the recording's stances without points in contacts or moved by keyframes, and those of `specified`."""
        inferred, _ = infer_stances(self.recorded, context.points, context.surfaces)
        return (*(rest for rest in inferred if not self._is_void(rest, edits, specified)), *specified)

    def problem(self, context: Context, options: Mapping[str, Options], edits: Sequence[Frame]) -> Problem:
        """Return the problem of following the recording through keyframes."""
        near = TrackingPenalty(self._warp_to(edits), tuple((edit.time, self.width) for edit in edits))
        unweighted = tracking_problem(near, context, options, self._times(near, edits), edits)
        weights = [(p, self.table.weight * w if p is near else w) for p, w in unweighted.penalties]
        keys = [self._fixed_outside_blends(frame, edits) for frame in unweighted.keys]
        settings = replace(unweighted.settings, tolerance=TOLERANCE)  # an edit starts far from its goal
        first, last = self.recorded.path.span
        is_far = (self._is_far(np.array([first, last]), edits) & (self.table.blend is not None)).tolist()
        return replace(
            unweighted,
            keys=tuple(keys),
            penalties=tuple(weights),
            settings=settings,
            ends=ENDS[is_far[0], is_far[1]],
            end_slope=self.recorded.path.at(np.array([first, last]), 1),
        )

    def _warp_to(self, edits: Sequence[Frame]) -> Track:
        """Return the recording warped to the poses of keyframes (A. Witkin and Z. Popović 1995). The warp is per joint,
        and moves the root with the whole figure. It fades out before and after the keyframes."""
        recorded = self.recorded
        if not edits:
            return recorded
        keys = sorted(edits, key=lambda edit: edit.time)
        times, is_known = np.array([key.time for key in keys]), np.array([key.known for key in keys], bool)
        wanted = recorded.figure.to_state(np.array([key.state for key in keys]))
        displacements = between(recorded.figure, recorded.path.at(times), wanted, is_known)
        reach = EASE if self.table.blend is None else INNER * self.table.blend
        ends = [t for offset in (-reach, reach) for t in times + offset if np.abs(times - t).min() >= reach - ROUNDING]
        every = np.concatenate([times, ends])
        order = np.argsort(every)
        curve = _smooth(every[order], np.vstack([displacements, np.zeros((len(ends), displacements.shape[1]))])[order])
        return recorded.displace(curve(np.clip(recorded.times, every.min(), every.max())))

    def _times(self, near: TrackingPenalty, edits: Sequence[Frame]) -> Array:
        """Return the times of frames (M,) [s]: the recording's where it is unchanged, otherwise as many as needed."""
        times = near.times(DETAIL)
        if self.table.blend is None:
            return times
        span, knots = self.recorded.path.span, self._exact_knots()
        margin, beyond = self._pins(self.table.blend, float(np.diff(knots).max()))
        beside, spread = (
            np.array([e.time + offset for e in edits for offset in (*offsets, *-offsets)])
            for offsets in (margin, beyond)
        )
        fixed = [group[self._is_far(group, edits)] for group in (np.clip(beside, *span), knots, np.clip(spread, *span))]
        least = min(NEXT_TO / 2, float(margin[1] - margin[0]) / 2)
        return _apart([np.array(span), *fixed, times[~self._is_far(times, edits)]], least)

    def _pins(self, blend: float, longest: float) -> tuple[Array, Array]:
        """Return the offsets [s] from a keyframe of fixed frames: near the end of its blend, and beyond it.

        In the blend the curve leaves the recording. From there, its deviation decreases by a factor of about 4 per
        frame, if no interval is much longer than the previous one. Hence the frames beyond the blend have twice the
        distance each time, up to the longest interval of the recording.
        """
        margin = np.linspace(INNER * blend, blend, MARGIN)
        step = float(margin[1] - margin[0])
        count = max(0, int(np.ceil(np.log2(longest / step))))
        return margin, np.array([blend + step * (2.0**k - 2) for k in range(2, count + 2)])

    def _is_far(self, times: Array, edits: Sequence[Frame]) -> Mask:
        """Return whether times (M,) [s] are outside all blends, (M,)."""
        keys = np.array([edit.time for edit in edits])
        return _distances(times, np.sort(keys)) >= INNER * self.width - ROUNDING

    def _exact_knots(self) -> Array:
        """Return the knots, and midpoints where a spline through the knots alone differs from the recording. A
        difference arises where the recording's quaternions are not of unit length between its frames."""
        figure, path = self.recorded.figure, self.recorded.path
        knots = np.unique(np.clip(self.knots, *path.span))
        frames = Frame.many(knots, path.at(knots), np.ones((knots.size, figure.width), bool))
        spline = path_of(Timeline(tuple(frames), path.at(knots[[0, -1]], 1), "clamped"))
        middles = (knots[1:] + knots[:-1]) / 2
        errors = figure.to_qpos(spline.at(middles)) - figure.to_qpos(path.at(middles))
        return np.unique(np.append(knots, middles[np.abs(errors).max(axis=1) > EXACT]))

    def _fixed_outside_blends(self, frame: Frame, edits: Sequence[Frame]) -> Frame:
        """Return a frame, fixed to the recording if it is outside all blends."""
        if self.table.blend is None or frame.fixed.any() or not self._is_far(np.array([frame.time]), edits).all():
            return frame
        return Frame.key(frame.time, self.pose(frame.time))

    def _is_void(self, rest: Contact, edits: Sequence[Frame], specified: Sequence[Contact]) -> bool:
        """Return whether a stance of the recording is invalid in the clip, or outside all blends."""
        point, width = rest.point, self.width
        if self.table.blend is not None and not any(
            rest.first < edit.time + width and edit.time - width < rest.last for edit in edits
        ):
            return True
        if any(rest.overlaps(other) for other in specified):
            return True
        near = [edit for edit in edits if rest.first - width < edit.time < rest.last + width]
        return any(self._moves(point, edit) for edit in near)

    def _moves(self, point: Point, edit: Frame) -> bool:
        figure = self.recorded.figure
        if not sets_places(figure, edit.fixed[None], [point])[0, 0]:
            return False
        qpos = np.stack([edit.state, self.pose(edit.time)])
        places, _ = places_of((point,), Samples.of_qpos(figure, qpos))
        return float(np.linalg.norm(places[:, 0, 0] - places[:, 0, 1])) > Thresholds.of(figure).moved


def _apart(groups: Sequence[Array], least: float) -> Array:
    """Return times (M,) [s] that are more than `least` apart; those of the first groups are kept first."""
    selected = np.empty(0)
    for group in groups:
        added = list[float]()
        for time in np.unique(group[_distances(group, selected) > least]).tolist():
            if not added or time - added[-1] > least:
                added.append(time)
        selected = np.sort(np.append(selected, added))
    return selected


def _distances(times: Array, others: Array) -> Array:
    """Return the distance [s] of each of the times (M,) from the nearest of others, which rise, (M,)."""
    padded = np.concatenate([[-np.inf], others, [np.inf]])
    after = np.searchsorted(others, times)
    return np.minimum(times - padded[after], padded[after + 1] - times)


def recording_to_follow(table: RecordingTable, figure: Figure, motion: Saved | None, where: str) -> TrackedRecording:
    """Return the recording that a clip follows, on the time axis of the clip.

    Raises:
        UserError: For a motion that is missing or of another figure, and for an invalid interval or blend.
    """
    here = f"{where}: recording"
    if table.blend is not None and table.blend < SHORTEST:
        raise UserError(f"{here}: blend = {table.blend:g} is too short; choose {SHORTEST:g} s or more")
    if motion is None:
        raise UserError(f"{here}: the motion of '{table.file}' is missing; load the clip with `dynsplines.load`")
    joints = [[link.name for link in model.links[1:]] for model in (figure, motion.figure)]
    if joints[0] != joints[1] or motion.figure.width != figure.width:
        raise UserError(f"{here}: '{table.file}' is of another figure: {', '.join(joints[1][:6])}, ...")
    try:
        timeline = motion.timeline if table.repeat is None else repeat(motion.figure, motion.timeline, table.repeat)
    except TimelineError as error:
        raise UserError(f"{here}: repeat: {error}") from None
    time, qpos = _cut(*_taken_down(motion.figure, timeline, motion.fps), table, here)
    recorded = Track.of(figure, _clip_time(time, table), qpos, exact=True)
    return TrackedRecording(recorded, _clip_time(timeline.times, table, time[0]), table, where)


def _taken_down(figure: Figure, timeline: Timeline, fps: float) -> tuple[Array, Array]:
    """Return times (T,) [s] and qpos (T, nq) of a motion, with its end, at half of RATE or more samples per second."""
    path, rate = path_of(timeline), max(fps, RATE / 2)
    first, last = path.span
    time = first + np.arange(sample_count(last - first, rate)) / rate
    if last - time[-1] > NEXT_TO / 2:
        time = np.append(time, last)
    time[-1] = last
    return time, continuous(figure, figure.to_qpos(path.at(time)))


def _cut(time: Array, qpos: Array, table: RecordingTable, where: str) -> tuple[Array, Array]:
    first = time[0] if table.start is None else table.start
    last = time[-1] if table.end is None else table.end
    if not time[0] - ROUNDING <= first < last <= time[-1] + ROUNDING:
        span = f"{time[0]:g} to {time[-1]:g} s"
        raise UserError(f"{where}: from = {first:g} and to = {last:g} are no part of it; it lasts from {span}")
    used = (time >= first - ROUNDING) & (time <= last + ROUNDING)
    if used.sum() < 5:
        raise UserError(f"{where}: {int(used.sum())} samples are left of it; 5 are the fewest")
    return time[used], qpos[used]


def _clip_time(time: Array, table: RecordingTable, begin: float | None = None) -> Array:
    """Return the clip times of times (T,) [s] of the recording, whose used part starts at `begin` or the first."""
    if table.times is None:
        first = float(time[0]) if begin is None else begin
        at = first if table.at is None else table.at
        return at + (time - first) / (table.speed or 1.0)
    return _warp(*np.array(table.times, float).T)(time)


def _warp(recorded_times: Array, clip_times: Array) -> Callable[[Array], Array]:
    """Return a rising, smooth function through pairs of times. Beyond them it is linear, as fast as between the two
    pairs next to it: the slope of a curve that ends there could be zero, which would stop the clip's time."""
    ends = [np.array([2 * t[0] - t[1], *t, 2 * t[-1] - t[-2]]) for t in (recorded_times, clip_times)]
    curve = _smooth(*ends)
    slopes = curve(recorded_times[[0, -1]], 1)

    def mapped(t: Array) -> Array:
        inside = curve(np.clip(t, recorded_times[0], recorded_times[-1]))
        before, after = np.minimum(t - recorded_times[0], 0), np.maximum(t - recorded_times[-1], 0)
        return np.asarray(inside + slopes[0] * before + slopes[1] * after)

    return mapped


def _smooth(times: Array, values: Array) -> Any:
    """Return a curve through values (K, ...) at times (K,) without overshoot (SciPy's)."""
    from scipy.interpolate import PchipInterpolator  # imported here because it is slow to load

    return PchipInterpolator(times, values)
