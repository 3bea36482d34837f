"""Steps: legs that swing while another leg stands, hops, and the order in which two feet step between two keyframes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..array import Array, Index, Mask, segments_at
from ..figure.figure import Figure
from .keyframe_points import KeyframePoints
from .stance import Rest, Stance
from .thresholds import Thresholds

OVERLAP = 0.04  # [1] time from landing of the first foot to the middle of the segment, relative to the segment
FIRM = 10.0  # [1] weight of the stances, relative to those between keyframes of the same position
WIDEST = 1.75  # [rad] largest turn in two steps
UP = np.array([0.0, 0, 1])


@dataclass(frozen=True, eq=False)
class Steps:
    """The legs that take a step, over time.

    Attributes:
        times: The limits of the intervals, (n + 1,) [s].
        stepping: Which links belong to a leg that takes a step in each interval, (L, n).
        legs: Which links belong to a leg, (L,).
    """

    times: Array
    stepping: Mask
    legs: Mask

    @classmethod
    def of(cls, soles: KeyframePoints, standing: Sequence[Stance | Rest]) -> Steps:
        """Return the legs that take a step between keyframes.

        Such a leg moves a point by more than 8 cm (for an adult) from one keyframe to the next. It takes the step while
        the point of another leg stands, and none of its own. The links that carry both legs, such as the pelvis, do not
        belong to it.
        """
        key_times, path = soles.keys.times, soles.figure.tables.path > 0
        begin, end = key_times[[0, -1]]
        bounds = [t for stance in standing for t in (stance.first, stance.last) if begin < t < end]
        times = np.unique([*key_times, *bounds])
        stepping, legs = np.zeros((len(path), times.size - 1), bool), np.zeros(len(path), bool)
        if not soles.points or not standing:
            return cls(times, stepping, legs)
        legs = np.asarray(path[soles.links].any(axis=0) & ~path[soles.links].all(axis=0))
        moves = soles.moves > soles.limits.strode
        first, last = np.array([stance.first for stance in standing]), np.array([stance.last for stance in standing])
        feet = np.array([stance.point.link for stance in standing])
        same_leg = _same_leg(soles.figure)
        for k, segment in enumerate(segments_at(key_times, times[:-1]).tolist()):
            stands = np.unique(feet[(first <= times[k]) & (times[k + 1] <= last)])
            for link in np.unique(soles.links[moves[:, segment]]).tolist():
                if stands.size and not same_leg[link, stands].any():
                    stepping[:, k] |= path[link] & ~path[stands].any(axis=0)
        return cls(times, stepping, legs)

    def move(self, link: int, first: float, last: float) -> bool:
        """Return whether a link belongs to a leg while any leg takes a step between two times [s]."""
        inside = (first < self.times[1:]) & (self.times[:-1] < last)
        return bool(self.legs[link] and self.stepping[:, inside].any())

    def at(self, links: Index, t: Array) -> Mask:
        """Return which of the links (l,) belong to a leg that takes a step at times t (S,) [s], (l, S)."""
        return self.stepping[np.ix_(links, segments_at(self.times, t))]


def hops(body: KeyframePoints) -> Mask:
    """Return the segments in which a figure on one leg has to hop, (K − 1,).

    All points on the ground in either keyframe belong to one leg, and those on the ground in both move by more than
    8 cm (for an adult).
    """
    down, moves = body.heights < body.limits.touching, body.moves > body.limits.strode
    either, both, same_leg = down[:, :-1] | down[:, 1:], down[:, :-1] & down[:, 1:], _same_leg(body.figure)
    result = np.logical_or.reduce(both) & ~np.logical_or.reduce(both & ~moves)
    for k in np.flatnonzero(result):
        legs = np.unique(body.links[either[:, k]])
        result[k] = same_leg[np.ix_(legs, legs)].all()
    return result


@dataclass(frozen=True, eq=False)
class DoubleStep:
    """Two feet that step in turn between two keyframes, because both change their places.

    Attributes:
        segment: The index of the first keyframe.
        leading: The link of the foot that steps first.
        stances: The stances before, between and after the steps.
        swings: The points of the feet, each with the interval in which it moves.
    """

    segment: int
    leading: int
    stances: tuple[Stance, ...]
    swings: tuple[Rest, ...]


def double_steps(soles: KeyframePoints) -> tuple[tuple[DoubleStep, ...], ...]:
    """Return the pairs of steps between keyframes, each in all possible orders.

    In both keyframes, all points of both feet are near a surface. Both feet move, by 8 to 70 cm (for an adult), and the
    keyframes are at least 0.8 s apart. The figure turns by at most 100°. One foot steps after the other. In the first
    order, the leading foot is the one on the side to which the figure moves or turns, so that legs do not cross; if it
    does neither, the foot behind.

    One foot may also be in the air in one keyframe, if these are at least 0.6 s apart. In the first keyframe it is the
    leading foot, in the second one the following foot, and there is no other order.
    """
    feet = _feet(soles)
    if len(feet) != 2:
        return ()
    limits, centres, spans = soles.limits, soles.centres, np.diff(soles.keys.times)
    low, high = soles.is_near, (soles.heights > soles.limits.near_surface) & soles.is_known
    stands, raised = (np.array([points_at[foot].all(axis=0) for foot in feet]) for points_at in (low, high))
    steps = np.array([_is_step(soles.moves[foot], limits) for foot in feet])
    is_double = stands[:, :-1].all(axis=0) & stands[:, 1:].all(axis=0) & steps.all(axis=0)
    is_double &= spans >= 2 * limits.far_apart
    is_short = ~is_double & (spans >= 1.5 * limits.far_apart)
    result = list[tuple[DoubleStep, ...]]()
    for foot, other in ((0, 1), (1, 0)):
        is_whole = is_short & stands[other, :-1] & stands[other, 1:] & steps[other]
        for k in np.flatnonzero(is_whole & raised[foot, :-1] & stands[foot, 1:]).tolist():
            landing = _double_step(soles, k, feet[foot], feet[other], is_landing=True)
            result.append((landing,))
        for k in np.flatnonzero(is_whole & stands[foot, :-1] & raised[foot, 1:]).tolist():
            lifting = _double_step(soles, k, feet[other], feet[foot], is_lifting=True)
            result.append((lifting,))
    if is_double.any():
        places = np.array([centres[:, foot].mean(axis=1) for foot in feet])
        ankles = np.array([soles.samples.links.x[:, soles.links[foot[0]]] for foot in feet])
        ahead = (places - ankles).sum(axis=0)  # from ankles to soles
        turns = np.array([_turn(*pair) for pair in pairwise(ahead.T)])
        for k in np.flatnonzero(is_double & (np.abs(turns) < WIDEST)).tolist():
            first = _first(places[..., k : k + 2], ahead[:, k : k + 2], limits)
            orders = (feet[first], feet[1 - first]), (feet[1 - first], feet[first])
            result.append(tuple(_double_step(soles, k, *order) for order in orders))
    return tuple(sorted(result, key=lambda orders: orders[0].segment))


def _is_step(moves: Array, limits: Thresholds) -> Mask:
    """Return whether points of a foot that move by (n, K − 1) [m] take a step that is not too long, (K − 1,)."""
    least, most = moves.min(axis=0), moves.max(axis=0)
    return np.asarray((least > limits.same_spot) & (most > limits.strode) & (most < limits.longest_step))


def _double_step(
    soles: KeyframePoints,
    k: int,
    leading: Sequence[int],
    following: Sequence[int],
    *,
    is_landing: bool = False,
    is_lifting: bool = False,
) -> DoubleStep:
    """Return two steps from keyframe k to the next, of feet with these indices of points.

    Args:
        is_landing: Whether the leading foot is in the air in the first keyframe. Landing takes half as long as a step.
        is_lifting: Whether the following foot is in the air in the second keyframe.
    """
    begin, end = soles.keys.times[k : k + 2].tolist()
    overlap = OVERLAP * (end - begin)
    middle = begin + (end - begin) * (1 / 3 if is_landing else 2 / 3 if is_lifting else 1 / 2)
    stances, swings = [], []
    for foot, lift, land in (
        (leading, begin if is_landing else begin + overlap, middle - overlap),
        (following, middle + overlap, end if is_lifting else end - overlap),
    ):
        for i in foot:
            swings.append(Rest(soles.points[i], lift, land))
            for at, start, stop in ((k, begin, lift), (k + 1, land, end)):
                if start < stop:
                    spot = soles.centres[:, i, at]
                    stances.append(Stance(soles.points[i], start, stop, spot, spot, FIRM))
    return DoubleStep(k, int(soles.links[leading[0]]), tuple(stances), tuple(swings))


def _feet(soles: KeyframePoints) -> list[list[int]]:
    """Return the indices of the points of each foot, which may consist of several links in a chain."""
    feet: list[list[int]] = []
    same_leg = _same_leg(soles.figure)
    for i, link in enumerate(soles.links):
        foot = next((foot for foot in feet if same_leg[link, soles.links[foot[0]]]), None)
        if foot is None:
            feet.append([i])
        else:
            foot.append(i)
    return feet


def _same_leg(figure: Figure) -> Mask:
    """Return which pairs of links are in one chain, one carrying the other, (L, L)."""
    path = figure.tables.path > 0
    return path | path.T


def _first(places: Array, ahead: Array, limits: Thresholds) -> int:
    """Return the index of the foot that steps first.

    Args:
        places: The centres of the two feet in the two keyframes, (2, 3, 2) [m].
        ahead: Vectors that point forward in both, (3, 2); they may be zero for feet that are points.
    """
    apart = places[0] - places[1]  # from the second foot to the first, (3, 2)
    leftward = np.cross(UP, ahead.sum(axis=1))
    if np.linalg.norm(leftward) < limits.as_tall:
        leftward = apart.sum(axis=1) * (1 - UP)
    leftward /= max(float(np.linalg.norm(leftward)), limits.as_tall)
    travel = (places[..., 1] - places[..., 0]).sum(axis=0)
    # if the feet are farther apart sideways after the first step, the figure moves to the side of the foot that steps
    preference = np.sign(apart.sum(axis=1) @ leftward) * (travel @ leftward + limits.turning * _turn(*ahead.T))
    if abs(preference) > limits.as_tall:
        return int(preference < 0)
    return int(apart[:, 0] @ travel > 0)


def _turn(before: Array, after: Array) -> float:
    """Return the angle [rad] about the vertical between two vectors (3,)."""
    return float(np.arctan2(np.cross(before, after) @ UP, before[:2] @ after[:2]))
