"""A clip's [recording]: a motion that the clip follows and its keyframes edit.

Keyframes are exact. Around each of them, within `EASE`, the recording's velocities and accelerations have more weight
than its poses, which preserves detail.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from dynsplines.solver.array import Array
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
from ...motion import RESAMPLED, Saved, continuous, sample_count
from ..context import Context
from ..kinds import Options
from ..parse import TOLERANCE
from ..table import RecordingTable
from .problem import tracking_problem

EASE = 0.4  # [s] interval before and after a keyframe over which its change of the recording fades out
DETAIL = 0.02  # [1] cost per segment of detail that the spline may lose, less than 1 mm; see `TrackingPenalty.times`


def track_of(figure: Figure, raw: Timeline) -> Track:
    """Return the recording that a saved motion follows, which is its raw path."""
    return Track.of(figure, *_taken_down(figure, raw, RESAMPLED), exact=True)


def pose_at(recorded: Track, where: str, time: float) -> Array:
    """Return qpos (nq,) of a recording at a time [s]. Raises UserError if the recording does not cover it."""
    first, last = recorded.path.span
    if not first - ROUNDING <= time <= last + ROUNDING:
        raise UserError(
            f"{where}: a keyframe at {time:g} s is outside the recording, which lasts from {first:g} to {last:g} s in "
            "the clip"
        )
    return recorded.figure.to_qpos(recorded.path.at(np.array([time])))[0]


def stances_near(
    recorded: Track, context: Context, edits: Sequence[Frame], specified: Sequence[Contact]
) -> tuple[Contact, ...]:
    """Return a recording's stances without points in contacts or moved by keyframes, and those of `specified`."""
    inferred, _ = infer_stances(recorded, context.points, context.surfaces)
    return (*(rest for rest in inferred if not _is_void(recorded, rest, edits, specified)), *specified)


def following_problem(
    recorded: Track, weight: float, context: Context, options: Mapping[str, Options], edits: Sequence[Frame]
) -> Problem:
    """Return the problem of following a recording, with a factor of its weights, through keyframes."""
    near = TrackingPenalty(_warp_to(recorded, edits), tuple((edit.time, EASE) for edit in edits))
    unweighted = tracking_problem(near, context, options, near.times(DETAIL), edits)
    weights = [(p, weight * w if p is near else w) for p, w in unweighted.penalties]
    settings = replace(unweighted.settings, tolerance=TOLERANCE)  # an edit starts far from its goal
    first, last = recorded.path.span
    return replace(
        unweighted,
        penalties=tuple(weights),
        settings=settings,
        end_slope=recorded.path.at(np.array([first, last]), 1),
    )


def _warp_to(recorded: Track, edits: Sequence[Frame]) -> Track:
    """Return a recording warped to the poses of keyframes (A. Witkin and Z. Popović 1995). The warp is per joint, and
    moves the root with the whole figure. It fades out before and after the keyframes."""
    if not edits:
        return recorded
    keys = sorted(edits, key=lambda edit: edit.time)
    times, is_known = np.array([key.time for key in keys]), np.array([key.known for key in keys], bool)
    wanted = recorded.figure.to_state(np.array([key.state for key in keys]))
    displacements = between(recorded.figure, recorded.path.at(times), wanted, is_known)
    ends = [t for offset in (-EASE, EASE) for t in times + offset if np.abs(times - t).min() >= EASE - ROUNDING]
    every = np.concatenate([times, ends])
    order = np.argsort(every)
    curve = _smooth(every[order], np.vstack([displacements, np.zeros((len(ends), displacements.shape[1]))])[order])
    return recorded.displace(curve(np.clip(recorded.times, every.min(), every.max())))


def _is_void(recorded: Track, rest: Contact, edits: Sequence[Frame], specified: Sequence[Contact]) -> bool:
    """Return whether a stance of a recording is invalid in the clip."""
    if any(rest.overlaps(other) for other in specified):
        return True
    near = [edit for edit in edits if rest.first - EASE < edit.time < rest.last + EASE]
    return any(_moves(recorded, rest.point, edit) for edit in near)


def _moves(recorded: Track, point: Point, edit: Frame) -> bool:
    """Return whether a keyframe puts a point elsewhere than the recording."""
    figure = recorded.figure
    if not sets_places(figure, edit.fixed[None], [point])[0, 0]:
        return False
    there = figure.to_qpos(recorded.path.at(np.clip([edit.time], *recorded.path.span)))
    places, _ = places_of((point,), Samples.of_qpos(figure, np.stack([edit.state, there[0]])))
    return float(np.linalg.norm(places[:, 0, 0] - places[:, 0, 1])) > Thresholds.of(figure).moved


def recording_to_follow(table: RecordingTable, figure: Figure, motion: Saved | None, where: str) -> Track:
    """Return the recording that a clip follows, on the time axis of the clip.

    Raises:
        UserError: For a motion that is missing or of another figure, and for an invalid interval.
    """
    here = f"{where}: recording"
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
    return Track.of(figure, _clip_time(time, table), qpos, exact=True)


def _taken_down(figure: Figure, timeline: Timeline, fps: float) -> tuple[Array, Array]:
    """Return times (T,) [s] and qpos (T, nq) of a motion at a rate [1/s], at least RESAMPLED, with its end."""
    path, rate = path_of(timeline), max(fps, RESAMPLED)
    first, last = path.span
    time = first + np.arange(sample_count(last - first, rate)) / rate
    if last - time[-1] > 0.5 / rate:
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


def _clip_time(time: Array, table: RecordingTable) -> Array:
    """Return the clip times of times (T,) [s] of the used part of the recording."""
    if table.times is None:
        first = float(time[0])
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
