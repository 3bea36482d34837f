"""Holds: joints with the same value in two neighbouring keyframes stay near this value in between.

A spline through a hold next to a fast motion would overshoot in the hold. In an oscillation, two keyframes on both
sides of a peak may have the same value; loops and gait cycles therefore have no holds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ... import quaternion as quat
from ...array import Array, Mask
from ...curve.frame import Timeline
from ...curve.spline import path_of
from ...figure.figure import Figure, JointKind, quaternion_columns
from ...figure.kinematics import Samples
from .joint_range import JointRange, Range

SAME = {"angle": np.radians(0.25), "length": 0.002}  # [rad, m] largest difference of keyframes of the same value
SWINGS = {"angle": np.radians(3), "length": 0.03}  # [rad, m] overshoot of the raw spline above which a joint is held
ROOM = {"angle": np.radians(1), "length": 0.01}  # [rad, m] distance that a held joint may move
LOOKS = 12  # samples per segment
BRIEF = 0.3  # [s] shorter segments are no holds


def overshoot(holds: Sequence[Range]) -> JointRange | None:
    """Return the penalty of joints that leave a held value by more than 1° or 1 cm; None without such joints."""
    ranges = []
    for joint in holds:
        margin = ROOM[_unit(joint)]
        low = joint.low if joint.home is not None else joint.low - margin
        ranges.append(replace(joint, low=low, high=joint.high + margin))
    return JointRange(tuple(ranges), name="limits.overshoot") if ranges else None


def holds(figure: Figure, keys: Timeline, flights: Sequence[tuple[float, float]] = ()) -> list[Range]:
    """Return the values of joints that two neighbouring keyframes fix alike, each as a range in this interval.

    They are those in segments in which the spline through the keyframes would leave such a value by 3° or 3 cm. All
    joints that are alike are held there, so that none moves for the sake of another one.

    Args:
        flights: The intervals (first, last) [s] in which roots rise and fall.
    """
    begins, ends = keys.times[:-1], keys.times[1:]
    qpos, is_long, ranges = figure.to_qpos(keys.states), ends - begins >= BRIEF, list[Range]()
    in_flight = _overlaps(keys, flights)
    for i, link in enumerate(figure.links[1:], start=1):
        is_free, quaternion = link.kind is JointKind.FREE, quaternion_columns(link)
        if quaternion is not None:
            is_same = np.linalg.norm(_turns(qpos[:, quaternion]), axis=1) <= SAME["angle"]
            for k in _fixed_at_both(is_same & is_long, keys, quaternion):
                home, span = tuple(qpos[k, quaternion].tolist()), (float(begins[k]), float(ends[k]))
                ranges.append(Range(link.name, i, JointKind.BALL, 0.0, 0.0, 0, home, *span))
        for axis in range(3 if is_free else int(quaternion is None)):
            kind = JointKind.SLIDE if is_free else link.kind
            unit = "angle" if kind is JointKind.HINGE else "length"
            values = qpos[:, link.qpos + axis]
            is_same = (np.abs(np.diff(values)) <= SAME[unit]) & ~(in_flight & is_free)
            for k in _fixed_at_both(is_same & is_long, keys, slice(link.qpos + axis, link.qpos + axis + 1)):
                value, span = float(values[k]), (float(begins[k]), float(ends[k]))
                ranges.append(Range(link.name, i, kind, value, value, axis, None, *span))
    return list(_swinging(figure, keys, ranges))


def _swinging(figure: Figure, keys: Timeline, ranges: Sequence[Range]) -> Iterator[Range]:
    """Yield the ranges in the segments in which the spline through the keyframes leaves any of them."""
    by_segment: dict[tuple[float, float], list[Range]] = {}
    for joint in ranges:
        by_segment.setdefault((joint.first, joint.last), []).append(joint)
    path = path_of(keys)
    for (first, last), joints in sorted(by_segment.items()):
        t = first + (np.arange(LOOKS) + 0.5) / LOOKS * (last - first)
        off = JointRange(tuple(joints)).beyond(Samples.still(figure, path.at(t), t=t)).max(axis=1)
        if any(most > SWINGS[_unit(joint)] for joint, most in zip(joints, off, strict=True)):
            yield from joints


def _unit(joint: Range) -> str:
    return "length" if joint.kind is JointKind.SLIDE else "angle"


def _overlaps(keys: Timeline, intervals: Sequence[tuple[float, float]]) -> Mask:
    """Return whether the segments between keyframes overlap any of the intervals, (K - 1,)."""
    edges = np.reshape(intervals, (-1, 2, 1))
    return np.asarray(((keys.times[:-1] < edges[:, 1]) & (edges[:, 0] < keys.times[1:])).any(axis=0))


def _turns(values: Array) -> Array:
    """Return the rotation vectors from each of the quaternions (K, 4) to the next, (K - 1, 3) [rad]."""
    return quat.rotation_vector(quat.product(quat.inverse(values[:-1]), values[1:]))


def _fixed_at_both(chosen: Mask, keys: Timeline, columns: slice) -> list[int]:
    """Return the chosen segments (K - 1,) whose two keyframes fix these columns."""
    fixed: Mask = np.asarray(keys.fixed[:, columns].all(axis=1))
    return np.flatnonzero(chosen & fixed[:-1] & fixed[1:]).tolist()
