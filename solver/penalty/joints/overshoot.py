"""Holds: joints with the same value in two neighbouring keyframes stay near this value in between.

A spline through a hold next to a fast motion overshoots in the hold. Where the raw spline of a joint does so, all
joints that the keyframes hold there are bounded to their values, see `JointRange`: the others must not move for its
sake. In an oscillation, two keyframes on both sides of a peak may have the same value; such turning points are not
holds. A clip oscillates if it repeats itself with segments of similar length.

A root may sway, so its rotation has wider bounds, between keyframes in which it changes little. Its horizontal position
has such bounds in all segments but flights.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask
from ...contacts.steps import Steps
from ...curve.frame import Frame, Timeline
from ...curve.spline import path_of
from ...figure.figure import Figure, JointKind, quaternion_columns
from ...figure.kinematics import Samples
from ..penalty import Guide
from .joint_range import JointRange, Range

SAME = {"angle": np.radians(0.25), "length": 0.002}  # [rad, m] maximum difference of keyframes of the same value
SWINGS = {"angle": np.radians(3), "length": 0.03}  # [rad, m] overshoot of the raw spline above which a joint is held
ROOM = {"angle": np.radians(1), "length": 0.01}  # [rad, m] distance that a held joint may move there
SWAY = np.radians(8)  # [rad] angle by which a root may turn beyond its rotations in the keyframes
LITTLE = np.radians(20)  # [rad] change of its rotation up to which it is bounded
ASIDE = 0.03  # [m] distance by which it may move beyond its positions in two keyframes up to BRIEFLY [s] apart
BRIEFLY = 0.5  # [s] in longer segments, this distance is proportional to their duration
ASTRAY = 0.1  # [1] further distance, relative to that between the two positions
LONG = 1.5  # [1] length, relative to the shorter adjacent segment, from which a segment is always a hold
BRIEF = 0.3  # [s] length below which other segments are no holds
LOOKS = 12  # samples per segment
BESIDE = 0.25  # [1] distance of variable frames from the ends of a hold, relative to the adjacent segment
CLOSEST = 0.02  # [s] minimum distance of such a frame from others
SEGMENTS_AT_ONCE = 20  # segments whose samples are in memory at once


@dataclass(frozen=True)
class OvershootPenalty(JointRange, Guide):
    """Σ over held joints of their squared excess [rad² or m²] over their bounds, see `of`.

    Attributes:
        frames: Times of variable frames that the spline needs to stay within the bounds [s].
    """

    term_name: str = "limits.overshoot"
    frames: tuple[float, ...] = ()
    figure: Figure = field(kw_only=True)

    @classmethod
    def of(cls, figure: Figure, holds: Holds, times: Array) -> OvershootPenalty | None:
        """Return the penalty of joints that swing in a clip of keyframes at times (K,) [s]; None if none does."""
        ranges, frames = [_widened(joint, ROOM[_unit(joint)]) for joint in holds.swinging], set[float]()
        for first, last in {(joint.first, joint.last) for joint in holds.swinging}:
            k, length = int(np.argmin(np.abs(times - first))), last - first
            beside = [times[k] - times[k - 1] if k else length, times[k + 2] - last if k + 2 < times.size else length]
            one, other = (float(min(BESIDE * length, BESIDE * span)) for span in beside)
            frames |= {first + one, last - other}
        return cls(tuple(ranges), frames=tuple(sorted(frames)), figure=figure) if ranges else None

    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """Return the timeline with held joints at their values, and variable frames near the ends of holds."""
        new = [t for t in self.frames if np.abs(timeline.times - t).min() > CLOSEST]
        if new and (most is None or timeline.variable_count + len(new) <= most):
            states = path_of(timeline).at(np.array(new))
            timeline = timeline.inserted(Frame.many(new, states, np.zeros(states.shape, bool)))
        rows = np.array(timeline.rows)
        loose = np.flatnonzero([frame.is_variable for frame in timeline.frames])
        rows[loose] = self._still(rows[loose], timeline.times[loose])
        return timeline.with_rows(rows)

    def _still(self, states: Array, times: Array) -> Array:
        """Return states (T, N) at times (T,) [s] with held joints at their values."""
        qpos = self.figure.to_qpos(states)
        for joint in self.joints:
            during, link = (joint.first < times) & (times < joint.last), self.figure.links[joint.link]
            columns = quaternion_columns(link) if joint.home is not None else None
            if columns is not None:
                qpos[during, columns] = joint.home
            else:
                qpos[during, link.qpos + joint.column] = 0.5 * (joint.low + joint.high)
        return self.figure.to_state_near(qpos, states)


def root_limits(holds: Holds, times: Array, durations: Array) -> JointRange | None:
    """Return the penalty of roots that lean or leave their way, see `Holds.roots`; None without such roots.

    Args:
        times: The times of the keyframes, (K,) [s].
        durations: The time for a step in each segment, (K − 1,) [s].
    """

    def margin(joint: Range) -> float:
        if joint.home is not None:
            return float(SWAY)
        return ASIDE * max(1.0, float(durations[np.searchsorted(times, joint.first)]) / BRIEFLY)

    ranges = tuple(_widened(joint, margin(joint)) for joint in holds.roots)
    return JointRange(ranges, term_name="upright.root") if ranges else None


@dataclass(frozen=True, eq=False)
class Track:
    """A coordinate of a joint, or its rotation.

    Attributes:
        unit: "angle" [rad] or "length" [m].
        columns: One column of qpos, or the four of a quaternion.
        axis: The axis of a free joint's position, 0 to 2.
    """

    name: str
    link: int
    unit: str
    columns: Index
    axis: int = 0

    @property
    def is_rotation(self) -> bool:
        return self.columns.size == 4

    def deviation(self, qpos: Array, home: Array) -> Array:
        """Return the deviation of configurations (..., nq) from values (..., 1 or 4), (..., 1 or 3) [rad, m]."""
        values = qpos[..., self.columns]
        return quat.rotation_vector(quat.product(quat.inverse(home), values)) if self.is_rotation else values - home

    def range_at(self, home: Array, first: float, last: float) -> Range:
        """Return a range that contains only one value (1 or 4) from one time to another [s]."""
        if self.is_rotation:
            return Range(
                self.name, self.link, JointKind.BALL, 0.0, 0.0, home=tuple(home.tolist()), first=first, last=last
            )
        kind, value = JointKind.HINGE if self.unit == "angle" else JointKind.SLIDE, float(home[0])
        return Range(self.name, self.link, kind, value, value, self.axis, first=first, last=last)


def tracks(figure: Figure) -> list[Track]:
    """Return the coordinates and rotations of all joints."""
    coordinates = []
    for i, link in enumerate(figure.links[1:], start=1):
        columns = quaternion_columns(link)
        if link.kind is JointKind.FREE:
            coordinates += [Track(link.name, i, "length", np.array([link.qpos + axis]), axis) for axis in range(3)]
        if columns is not None:
            coordinates.append(Track(link.name, i, "angle", np.arange(columns.start, columns.stop)))
        else:
            unit = "angle" if link.kind is JointKind.HINGE else "length"
            coordinates.append(Track(link.name, i, unit, np.array([link.qpos])))
    return coordinates


class Holds(NamedTuple):
    """The ranges of joints between the values of two neighbouring keyframes, where these are equal or similar.

    Attributes:
        swinging: Equal values, in segments in which the raw spline of a joint leaves its value.
        roots: Rotations of roots that change by at most 20 degrees, in other segments; a range is half of this angle
            around the middle. And horizontal positions of roots, with a share of the distance between both.
    """

    swinging: tuple[Range, ...]
    roots: tuple[Range, ...]

    @classmethod
    def of(
        cls,
        figure: Figure,
        raw: Timeline,
        *,
        repeats: bool = False,
        aloft: Sequence[tuple[float, float]] = (),
        grasped: Collection[int] = (),
        steps: Steps | None = None,
        durations: Array | None = None,
    ) -> Holds:
        """Find the holds of a clip with this raw spline.

        Args:
            repeats: Whether the clip is a loop or a gait cycle.
            aloft: Flights (first, last) [s], in which a root rises and falls between two keyframes of one height.
            grasped: Links of held objects, which move with hands.
            steps: The steps of legs, whose joints are not held meanwhile.
            durations: The time for a step in each segment, (K − 1,) [s]; None: all of the segment.
        """
        qpos, times = figure.to_qpos(raw.states), raw.times.tolist()
        equal, similar = list[Range](), list[Range]()
        for track in tracks(figure):
            is_root = figure.links[track.link].kind is JointKind.FREE
            is_height = is_root and track.unit == "length" and track.axis == 2
            for k in _held_segments(track, raw, qpos, repeats=repeats):
                is_step = steps is not None and steps.move(track.link, times[k], times[k + 1])
                if not is_step and not (is_height and _flies(times[k], times[k + 1], aloft)):
                    equal.append(track.range_at(qpos[k, track.columns], times[k], times[k + 1]))
            if is_root and track.is_rotation:
                both, change = _changes(track, raw, qpos)
                for k, turn in zip(both.tolist(), change, strict=True):
                    angle = float(np.linalg.norm(turn))
                    if angle <= LITTLE:
                        middle = quat.product(qpos[k, track.columns], quat.from_rotation_vector(turn / 2))
                        similar.append(replace(track.range_at(middle, times[k], times[k + 1]), high=angle / 2))
            elif is_root and not is_height and track.link not in grasped:
                ranges = _path_ranges(figure, track, times, qpos, durations)
                similar += [joint for joint in ranges if not _flies(joint.first, joint.last, aloft)]
        segments = _swinging(figure, equal, raw)
        swinging = tuple(joint for joint in equal if joint.first in segments)
        tight = {(joint.first, joint.link, joint.kind, joint.column) for joint in swinging}
        roots = (joint for joint in similar if (joint.first, joint.link, joint.kind, joint.column) not in tight)
        return cls(swinging, tuple(roots))


def _unit(joint: Range) -> str:
    return "length" if joint.kind is JointKind.SLIDE else "angle"


def _widened(joint: Range, room: float) -> Range:
    return replace(joint, low=joint.low if joint.home is not None else joint.low - room, high=joint.high + room)


def _swinging(figure: Figure, holds: Sequence[Range], raw: Timeline) -> set[float]:
    """Return the beginnings [s] of the segments in which the raw spline of a joint leaves its value."""
    by_segment: dict[tuple[float, float], list[Range]] = {}
    for joint in holds:
        by_segment.setdefault((joint.first, joint.last), []).append(joint)
    segments, share, path = sorted(by_segment), (np.arange(LOOKS) + 0.5) / LOOKS, path_of(raw)
    swinging: set[float] = set()
    for i in range(0, len(segments), SEGMENTS_AT_ONCE):
        batch = segments[i : i + SEGMENTS_AT_ONCE]
        t = np.concatenate([first + share * (last - first) for first, last in batch])
        joints = tuple(joint for segment in batch for joint in by_segment[segment])
        most = JointRange(joints).beyond(Samples.still(figure, path.at(t), t=t)).max(axis=1)
        swinging |= {joint.first for joint, off in zip(joints, most, strict=True) if off > SWINGS[_unit(joint)]}
    return swinging


def _changes(track: Track, keys: Timeline, qpos: Array) -> tuple[Index, Array]:
    """Return the segments (s,) whose two keyframes both fix a coordinate, and its change in them (s, 1 or 3)."""
    fixed: Mask = np.asarray(keys.fixed[:, track.columns].all(axis=1))
    both = np.flatnonzero(fixed[:-1] & fixed[1:])
    return both, track.deviation(qpos[both + 1], qpos[both][:, track.columns])


def _held_segments(track: Track, keys: Timeline, qpos: Array, *, repeats: bool) -> Iterator[int]:
    """Yield the first keyframe of each segment in which keyframes hold a coordinate."""
    both, change = _changes(track, keys, qpos)
    fixing = np.flatnonzero(keys.fixed[:, track.columns].all(axis=1))
    for k in both[np.linalg.norm(change, axis=1) <= SAME[track.unit]].tolist():
        beside, length = _neighbours(keys, fixing, k), float(keys.times[k + 1] - keys.times[k])
        lengths = [span for _, span in filter(None, beside)]
        is_long, is_brief = length >= LONG * min(lengths, default=0.0), length < BRIEF
        if is_long or not (is_brief or (repeats and _is_turning_point(track, qpos, k, beside))):
            yield k


def _is_turning_point(track: Track, qpos: Array, k: int, neighbours: Sequence[tuple[int, float] | None]) -> bool:
    """Return whether a coordinate reaches keyframe k from the same side to which it leaves keyframe k + 1."""
    off = [
        track.deviation(qpos[neighbour[0]], qpos[k, track.columns]) for neighbour in neighbours if neighbour is not None
    ]
    return len(off) == 2 and bool(off[0] @ off[1] > 0)


def _neighbours(keys: Timeline, fixing: Index, k: int) -> tuple[tuple[int, float] | None, tuple[int, float] | None]:
    """The nearest keyframes before k and after k + 1 that fix a coordinate, and their distances [s]. In a loop the
    search wraps around its end."""
    times, last, place = keys.times, len(keys.times) - 1, int(np.searchsorted(fixing, k))
    is_loop = keys.ends == "periodic"
    one = other = None
    if place:
        one = int(fixing[place - 1]), float(times[k] - times[fixing[place - 1]])
    if place + 2 < fixing.size:
        other = int(fixing[place + 2]), float(times[fixing[place + 2]] - times[k + 1])
    inner = fixing[(fixing > 0) & (fixing < last)] if is_loop else fixing
    if one is None and is_loop and inner.size:
        one = int(inner[-1]), float(times[k] - times[0] + times[last] - times[inner[-1]])
    if other is None and is_loop and inner.size:
        other = int(inner[0]), float(times[last] - times[k + 1] + times[inner[0]] - times[0])
    return one, other


def _path_ranges(
    figure: Figure, track: Track, times: Sequence[float], qpos: Array, durations: Array | None
) -> Iterator[Range]:
    """Yield the range of a root's coordinate in every segment: its two values, and a share of the way of a step."""
    first = figure.links[track.link].qpos
    far = np.linalg.norm(np.diff(qpos[:, first : first + 2], axis=0), axis=1)
    for k, (begin, end) in enumerate(pairwise(qpos[:, track.columns])):
        share = 1.0 if durations is None else float(durations[k]) / (times[k + 1] - times[k])
        margin = ASTRAY * float(far[k]) * share
        joint = track.range_at(begin, times[k], times[k + 1])
        yield replace(joint, low=min(joint.low, end.item()) - margin, high=max(joint.high, end.item()) + margin)


def _flies(since: float, until: float, aloft: Sequence[tuple[float, float]]) -> bool:
    return any(first < until and since < last for first, last in aloft)
