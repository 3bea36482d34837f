"""Holds: joints with the same value in two neighbouring keyframes stay near this value in between.

A spline through a hold next to a fast motion would overshoot in the hold. In an oscillation, two keyframes on both
sides of a peak may have the same value; loops and gait cycles therefore have no holds.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from ... import quaternion as quat
from ...array import Mask
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
SWAY = np.radians(8)  # [rad] angle by which a root may turn beyond its rotations in two keyframes
LITTLE = np.radians(20)  # [rad] change of its rotation up to which it is bounded
ASIDE = 0.03  # [m] distance by which it may move beyond its positions in two keyframes up to BRIEFLY [s] apart
BRIEFLY = 0.5  # [s] in longer segments, this distance is proportional to their duration
ASTRAY = 0.1  # [1] further distance, relative to that between the two positions


def overshoot(holds: Sequence[Range]) -> JointRange | None:
    """Return the penalty of joints that leave a held value by more than 1° or 1 cm; None without such joints."""
    ranges = []
    for joint in holds:
        margin = ROOM[_unit(joint)]
        low = joint.low if joint.home is not None else joint.low - margin
        ranges.append(replace(joint, low=low, high=joint.high + margin))
    return JointRange(tuple(ranges), term_name="limits.overshoot") if ranges else None


def holds(figure: Figure, keys: Timeline, flights: Sequence[tuple[float, float]] = ()) -> list[Range]:
    """Return the values of joints that two neighbouring keyframes fix alike, each as a range in this interval.

    They are those in segments in which the spline through the keyframes would leave such a value by 3° or 3 cm. All
    joints that are alike are held there, so that none moves for the sake of another one.

    Args:
        flights: The intervals (first, last) [s] in which roots rise and fall.
    """
    begins, ends = keys.times[:-1], keys.times[1:]
    in_flight = np.zeros(begins.size, bool)
    for first, last in flights:
        in_flight |= (begins < last) & (first < ends)
    qpos, is_long, ranges = figure.to_qpos(keys.states), ends - begins >= BRIEF, list[Range]()
    for i, link in enumerate(figure.links[1:], start=1):
        is_free, quaternion = link.kind is JointKind.FREE, quaternion_columns(link)
        if quaternion is not None:
            values = qpos[:, quaternion]
            turns = quat.rotation_vector(quat.product(quat.inverse(values[:-1]), values[1:]))
            is_same = np.linalg.norm(turns, axis=1) <= SAME["angle"]
            for k in _held(is_same & is_long, keys, quaternion):
                home, span = tuple(values[k].tolist()), (float(begins[k]), float(ends[k]))
                ranges.append(Range(link.name, i, JointKind.BALL, 0.0, 0.0, 0, home, *span))
        for axis in range(3 if is_free else int(quaternion is None)):
            kind = JointKind.SLIDE if is_free else link.kind
            unit = "angle" if kind is JointKind.HINGE else "length"
            values = qpos[:, link.qpos + axis]
            is_same = (np.abs(np.diff(values)) <= SAME[unit]) & ~(in_flight & is_free)
            for k in _held(is_same & is_long, keys, slice(link.qpos + axis, link.qpos + axis + 1)):
                value, span = float(values[k]), (float(begins[k]), float(ends[k]))
                ranges.append(Range(link.name, i, kind, value, value, axis, None, *span))
    return _swinging(figure, keys, ranges)


def _swinging(figure: Figure, keys: Timeline, ranges: Sequence[Range]) -> list[Range]:
    """Return the ranges in the segments in which the spline through the keyframes leaves any of them."""
    segments = sorted({(joint.first, joint.last) for joint in ranges})
    if not segments:
        return []
    share = (np.arange(LOOKS) + 0.5) / LOOKS
    t = np.concatenate([first + share * (last - first) for first, last in segments])
    most = JointRange(tuple(ranges)).beyond(Samples.still(figure, path_of(keys).at(t), t=t)).max(axis=1)
    swinging = {joint.first for joint, off in zip(ranges, most, strict=True) if off > SWINGS[_unit(joint)]}
    return [joint for joint in ranges if joint.first in swinging]


def _unit(joint: Range) -> str:
    return "length" if joint.kind is JointKind.SLIDE else "angle"


def root_ranges(
    figure: Figure, keys: Timeline, flights: Sequence[tuple[float, float]], grasped: Collection[int]
) -> list[Range]:
    """Return the ranges of roots between two keyframes that fix them: the way between both, and a margin.

    A rotation has a range if it changes by at most 20°, a horizontal position if it is in no flight.

    Args:
        flights: The intervals (first, last) [s] of free fall.
        grasped: The links of grasped objects, which move with hands.
    """
    qpos, ranges = figure.to_qpos(keys.states), list[Range]()
    for i in (i for i in figure.tables.free_links.tolist() if figure.tables.children[i] and i not in grasped):
        link = figure.links[i]
        first, quaternion = link.qpos, slice(link.qpos + 3, link.qpos + 7)
        turns = quat.rotation_vector(quat.product(quat.inverse(qpos[:-1, quaternion]), qpos[1:, quaternion]))
        for k in _held(np.linalg.norm(turns, axis=1) <= LITTLE, keys, quaternion):
            middle = quat.product(qpos[k, quaternion], quat.from_rotation_vector(turns[k] / 2))
            high, home = float(np.linalg.norm(turns[k])) / 2 + SWAY, tuple(middle.tolist())
            ranges.append(Range(link.name, i, JointKind.BALL, 0.0, high, 0, home, *keys.times[k : k + 2].tolist()))
        for axis in range(2):
            for k in _held(np.ones(keys.times.size - 1, bool), keys, slice(first + axis, first + axis + 1)):
                begin, end = keys.times[k : k + 2].tolist()
                if any(begin < last and since < end for since, last in flights):
                    continue
                both = qpos[k : k + 2, first : first + 2]
                margin = ASIDE * max(1.0, (end - begin) / BRIEFLY) + ASTRAY * float(np.linalg.norm(both[1] - both[0]))
                low, high = float(both[:, axis].min()) - margin, float(both[:, axis].max()) + margin
                ranges.append(Range(link.name, i, JointKind.SLIDE, low, high, axis, None, begin, end))
    return ranges


def _held(is_same: Mask, keys: Timeline, columns: slice) -> list[int]:
    """Return the segments of same values (K - 1,) whose two keyframes fix them."""
    fixed: Mask = np.asarray(keys.fixed[:, columns].all(axis=1))
    return np.flatnonzero(is_same & fixed[:-1] & fixed[1:]).tolist()
