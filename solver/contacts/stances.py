"""Where a figure stands, inferred from its keyframes: its stances, footings and steps.

A point is planted between two keyframes if it rests on one spot in both. Then it has a stance, a `Contact`. A segment
without stances is a flight if nothing can support the figure there, see `flight`. Otherwise its support is unknown,
because a foot may touch down and lift off in between. A footing is a point of a link with a stance by which a surface
can push. A step is a leg that swings while another leg stands, or a hop on one leg. Recordings have many frames and
noise instead, see `recorded_stances`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array, Index, Mask, segments_at
from ..figure.algebra import perpendicular
from ..surface import Plane
from ..surface.points import Point
from ..tolerances import ROUNDING
from .contact import Contact
from .keyframe_points import KeyframePoints

POSED = 10.0  # [1] weight of stances of posed keyframes, which meet positions only approximately
TURNED = 0.3  # rotation of search directions, as a fraction of the angle between them, so that no two points tie


def stances(soles: KeyframePoints) -> tuple[Contact, ...]:
    """Return the stances of points, one for each segment in which a point is planted, in order of time."""
    is_exact = soles.is_fixed[:, :-1] & soles.is_fixed[:, 1:]
    return tuple(
        contact_between(soles, i, k, 1.0 if is_exact[i, k] else POSED)
        for k, i in np.argwhere(planted_segments(soles).T).tolist()
    )


def contact_between(points: KeyframePoints, i: int, k: int, weight: float = 1.0) -> Contact:
    """Return the contact of point i from keyframe k to the next, from its position in the one to that in the other."""
    times = points.keys.times[k : k + 2]
    places = np.ascontiguousarray(points.centres[:, i, k : k + 2].T)
    return Contact(points.points[i], float(times[0]), float(times[1]), 0, places, times, weight=weight)


def planted_segments(points: KeyframePoints) -> Mask:
    """Return whether each point is planted between each two successive keyframes, (n, K − 1).

    In both, its position is known and near a surface. The two positions are close to each other (12 mm and 5 cm for an
    adult, see `Thresholds`), and the point moves slower than 0.35 m/s.
    """
    near, drift = is_near(points), points.limits.farthest_planted(np.diff(points.keys.times))
    return np.asarray(near[:, :-1] & near[:, 1:] & (points.moves < drift))


def planted_place(points: KeyframePoints, i: int, k: int) -> Array | None:
    """Return the position (3,) [m] of point i in keyframe k, which leaves it free, if it is planted around it, or None.

    The rule is that of `planted_segments`, between the nearest keyframes before and after that determine the position.
    If there is only one such keyframe, the point is planted if this has it near a surface.
    """
    keys, times, places = points.beside(i, k)
    if not keys.size or not is_near(points)[i, keys].all():
        return None
    if keys.size == 1:
        return places[0]
    move, seconds = places[1] - places[0], times[1] - times[0]
    if np.linalg.norm(move) >= points.limits.farthest_planted(seconds):
        return None
    return np.asarray(places[0] + (points.keys.times[k] - times[0]) / seconds * move)


def is_near(points: KeyframePoints) -> Mask:
    """Return whether the position of each point is known and near a surface in each keyframe, (n, K)."""
    return np.asarray((np.abs(points.heights) < points.limits.near_surface) & points.is_known)


def is_grounded(points: KeyframePoints) -> Mask:
    """Return whether the lowest of the points is on the ground in each keyframe, (K,)."""
    return np.asarray(points.heights.min(axis=0, initial=np.inf) < points.limits.clear)


def stride_segments(points: KeyframePoints) -> Mask:
    """Return whether each point moves so far between each two successive keyframes that it swings (8 cm for an adult),
    (n, K − 1)."""
    return np.asarray((points.moves > points.limits.strode) & points.is_known[:, :-1] & points.is_known[:, 1:])


def low_swing_segments(points: KeyframePoints) -> Mask:
    """Return whether each point strides within a short time (0.25 s), so that its foot may pass low over the ground,
    (n, K − 1)."""
    return np.asarray(stride_segments(points) & (np.diff(points.keys.times) <= points.limits.shortly))


def footings(soles: KeyframePoints, standing: Sequence[Contact], body: Sequence[Point] = ()) -> tuple[Contact, ...]:
    """Return the contacts by which a surface can push links that stand from one keyframe to the next.

    Their points are those of the sole and the `body` that touch a surface in one of the two keyframes, at the spot that
    touches it. Points inside the convex hull of the others are omitted.
    """
    begin, end = np.array([(contact.first, contact.last) for contact in standing]).reshape(-1, 2).T
    links = np.array([contact.point.link for contact in standing], np.intp)
    spots = soles.with_points((*soles.points, *(point for point in body if point.link in links)))
    near, result = is_near(spots), list[Contact]()
    for k, first, last in spots.segments():
        for link in np.unique(links[(begin <= first) & (last <= end)]).tolist():
            on, at = np.nonzero(near[:, k : k + 2] & (spots.links == link)[:, None])
            if on.size:
                outer, surface = _outermost(spots, link, on, k + at)
                result += [
                    Contact(Point(spots.points[i].name, link, p), first, last, surface=surface) for i, p in outer
                ]
    return tuple(result)


def _outermost(spots: KeyframePoints, link: int, points: Index, keys: Index) -> tuple[list[tuple[int, Array]], Plane]:
    """Return a link's outermost contact points in keyframes (m,), and the plane that they touch.

    A point is its index and its position of contact (3,) in the link's axes. Surfaces other than planes are taken to be
    level there.
    """
    surface = spots.surfaces[int(spots.nearest[points[0], keys[0]])]
    normal = surface.normal if isinstance(surface, Plane) else np.array([0.0, 0, 1])
    touched = spots.centres[:, points, keys] - spots.radii[points] * normal[:, None]
    plane = Plane(surface.name, touched[:, 0], normal)
    touched = touched - spots.samples.links.x[:, link, keys]
    rotation = spots.samples.links.rotation[:, :, link, keys]
    local = np.einsum("ijp,ip->jp", rotation, touched)
    directions = rotation[:, :, 0].T @ _around(normal)
    reach = local.T @ directions
    outer = np.unique(np.argmax(reach >= reach.max(axis=0) - ROUNDING, axis=0))
    return [(int(points[i]), local[:, i]) for i in outer], plane


def _around(normal: Array) -> Array:
    """Return eight unit vectors (3, 8) across a normal (3,), in all directions."""
    across = perpendicular(normal)
    angle = 2 * np.pi * (np.arange(8) + TURNED) / 8
    both = np.column_stack([across, np.cross(normal, across)])
    return np.asarray(both @ np.array([np.cos(angle), np.sin(angle)]), float)


@dataclass(frozen=True, eq=False)
class Steps:
    """The legs that take a step, over time.

    Attributes:
        times: The limits of the intervals, (n + 1,) [s].
        stepping: Which links belong to a leg that takes a step in each interval, (L, n).
        placing: Which links of legs place a foot, (L,): all but a foot with several sole points, which turns by itself.
    """

    times: Array
    stepping: Mask
    placing: Mask

    @classmethod
    def of(cls, soles: KeyframePoints, standing: Sequence[Contact]) -> Steps:
        """Return the legs that take a step between keyframes.

        Such a leg moves a point by more than 8 cm (for an adult) from one keyframe to the next. It takes the step while
        the point of another leg stands, and none of its own. The links that carry both legs, such as the pelvis, do not
        belong to it.
        """
        key_times, path = soles.keys.times, soles.figure.tables.path > 0
        begin, end = key_times[[0, -1]]
        bounds = [t for stance in standing for t in (stance.first, stance.last) if begin < t < end]
        times = np.unique([*key_times, *bounds])
        stepping = np.zeros((len(path), times.size - 1), bool)
        legs = np.asarray(path[soles.links].any(axis=0) & ~path[soles.links].all(axis=0))
        placing = legs & (np.bincount(soles.links, minlength=legs.size) < 2)
        if not soles.points or not standing:
            return cls(times, stepping, placing)
        first, last = np.array([stance.first for stance in standing]), np.array([stance.last for stance in standing])
        feet = np.array([stance.point.link for stance in standing])
        is_same_leg = path | path.T  # one link carries the other
        strides = stride_segments(soles)
        for k, segment in enumerate(segments_at(key_times, times[:-1]).tolist()):
            stands = np.unique(feet[(first <= times[k]) & (times[k + 1] <= last)])
            for link in np.unique(soles.links[strides[:, segment]]).tolist():
                if stands.size and not is_same_leg[link, stands].any():
                    stepping[:, k] |= path[link] & ~path[stands].any(axis=0)
        return cls(times, stepping, placing)

    def at(self, links: Index, t: Array) -> Mask:
        """Return which of the links (l,) belong to a leg that takes a step at times t (S,) [s], (l, S)."""
        return self.stepping[np.ix_(links, segments_at(self.times, t))]
