"""Thinning: few keyframes whose in-between stays within a bound of a recorded motion.

Keyframes are at instants of the recording, so a choice of keyframes is a set of instants. Keyframes are inserted where
the in-between deviates most, and then removed where they are not needed. The minimum would require a search of every
set. Sliding is more visible than a small offset in motion. The bound is therefore stricter for hands and feet while
they are still, which leads to keyframes where contacts begin and end.

Insertion at the largest deviation is the method of U. Ramer (1972) and D. Douglas & T. Peucker (1973), here for a
spline instead of a polygon. A spline changes on both sides of a keyframe, so a removal is tried on its neighbourhood,
which makes the time proportional to the length of a recording. The bound is then checked on the whole spline.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from ..array import Array, Index
from ..curve.frame import Frame, Timeline
from ..curve.raw import raw_timeline
from ..curve.spline import REACH, path_of
from ..figure.figure import Figure, on_links
from ..figure.kinematics import LinkMotion, States
from ..surface.points import body_points
from ..tolerances import ROUNDING

InBetween = Callable[[Sequence[Frame]], Timeline]

MARGIN = 3  # further keyframes on either side that the spline of a trial interpolates
SHARE = 0.5  # [1] deviation relative to the worst, from which segments get a keyframe in the same round


@dataclass(frozen=True, eq=False)
class Recorded:
    """The motion to approximate, and the bound.

    Attributes:
        times: The instants, (S,) [s], rising.
        qpos: The configurations, (S, nq).
        distance: The bound of the distance of a body's origin or site [m].
        angle: The bound of the angle of a link [rad].
        ends: The end conditions of the in-between, see `Problem`; also `travel` and `turn`.
    """

    figure: Figure
    times: Array
    qpos: Array
    distance: float
    angle: float
    ends: str = "free"
    travel: ArrayLike | None = None
    turn: float | None = None

    @cached_property
    def points(self) -> tuple[tuple[str, ...], Index, Array]:
        """The compared points: names, links (n,), and positions (3, n) [m] in the links.

        They are the origins of moving bodies, the sites on them, and the tips of limbs that have no site.
        """
        figure, model = self.figure, self.figure.model
        names = [model.body(i).name or f"body {i}" for i in range(model.nbody)]
        located = [(name, figure.point_on_link(i, np.zeros(3))) for i, name in enumerate(names)]
        for i in range(model.nsite):
            place = figure.point_on_link(int(model.site_bodyid[i]), model.site_pos[i])
            located.append((model.site(i).name or f"site {i} of {names[model.site_bodyid[i]]}", place))
        moving = [(name, link, place) for name, (link, place) in located if link]
        moving += tips(figure, {int(model.site_bodyid[i]) for i in range(model.nsite)})
        called, links, places = zip(*moving, strict=True)
        return called, np.array(links, np.intp), np.array(places).T

    @cached_property
    def _weights(self) -> Array:
        _, links, places = self.points
        return on_links(places, links, len(self.figure.links))

    def _poses(self, states: Array) -> tuple[Array, Array]:
        """Return positions of the points (3, n, S) and unit orientations of the links (4, L, S) for states (S, N)."""
        links = LinkMotion(States(self.figure, states, states, states))
        turned = links.Q / np.sqrt(links.length_squared)
        return links.x.take(self.points[1], axis=1) + links.sum_fixed(self._weights), turned

    @cached_property
    def _recorded_poses(self) -> tuple[Array, Array]:
        return self._poses(self.figure.to_state(self.qpos))

    def misses(self, timeline: Timeline) -> tuple[Array, Array]:
        """Return distances (n, S) [m] of the points and angles (L, S) [rad] of the links at the instants."""
        return self._misses(path_of(timeline).at(self.times), np.arange(len(self.times)))

    def _misses(self, states: Array, instants: Index) -> tuple[Array, Array]:
        """Return the deviations of states (R, N) at the instants (R,)."""
        places, turned = self._poses(states)
        own_places, own_turned = (own_values.take(instants, axis=2) for own_values in self._recorded_poses)
        apart = places - own_places
        sign = np.where(np.einsum("cls,cls->ls", turned, own_turned) < 0, -1.0, 1.0)
        chord = turned - sign * own_turned
        half = np.sqrt(np.einsum("cls,cls->ls", chord, chord)) / 2
        return np.sqrt(np.einsum("cns,cns->ns", apart, apart)), 4 * np.arcsin(half)

    def excess(self, timeline: Timeline) -> Array:
        """Return the largest deviation at every instant, as a multiple of the bound, (S,)."""
        return self._excess(*self.misses(timeline))

    def _excess(self, distance: Array, angle: Array) -> Array:
        return np.maximum(distance.max(axis=0) / self.distance, angle.max(axis=0) / self.angle)

    def excess_without(self, instants: Sequence[int], n: int) -> float:
        """Return the largest deviation of the raw spline without keyframe n, as a multiple of the bound.

        If n is far from both ends, only its neighbourhood is examined.
        """
        first, end = n - REACH - MARGIN, n + REACH + MARGIN + 1
        if first < 0 or end > len(instants):
            return float(self.excess(self.spline(self.frames([*instants[:n], *instants[n + 1 :]]))).max())
        near = raw_timeline(self.figure, self.frames([*instants[first:n], *instants[n + 1 : end]]))
        examined = np.arange(instants[n - REACH], instants[n + REACH] + 1)
        states = path_of(near).at(self.times[examined])
        return float(self._excess(*self._misses(states, examined)).max())

    def worst(self, timeline: Timeline) -> tuple[tuple[float, int, str], ...]:
        """Return the largest distance [m] and the largest angle [rad], each with its instant and the name of the point
        or link."""
        names = self.points[0], [link.name for link in self.figure.links]
        largest = []
        for missed, called in zip(self.misses(timeline), names, strict=True):
            row, instant = np.unravel_index(int(missed.argmax()), missed.shape)
            largest.append((float(missed[row, instant]), int(instant), called[row]))
        return tuple(largest)

    def frames(self, instants: Sequence[int]) -> list[Frame]:
        return Frame.many(
            self.times[list(instants)], self.qpos[list(instants)], np.ones((len(instants), self.figure.width), bool)
        )

    def spline(self, keys: Sequence[Frame]) -> Timeline:
        slope = np.zeros((2, self.figure.width)) if self.ends.startswith("clamped") else None
        travel, turn = (self.travel, self.turn) if self.ends == "periodic" else (None, None)
        return raw_timeline(self.figure, list(keys), self.ends, slope, travel, turn)


def thin(recorded: Recorded, report: Callable[[str], None] = lambda note: None) -> tuple[tuple[int, ...], Timeline]:
    """Return a small set of instants, and the raw spline through them, which stays within the bound at every sample."""
    selection, _ = refine(recorded, (0, len(recorded.times) - 1), recorded.spline, report)
    return refine(recorded, _without_redundant(recorded, selection, report), recorded.spline, report)


def refine(
    recorded: Recorded, instants: Sequence[int], inbetween: InBetween, report: Callable[[str], None] = lambda note: None
) -> tuple[tuple[int, ...], Timeline]:
    """Return more instants, each where the in-between deviates most, until it is within the bound at all samples;
    and the in-between."""
    chosen = sorted(instants)
    while True:
        timeline = inbetween(recorded.frames(chosen))
        excess = recorded.excess(timeline)
        report(f"{len(chosen)} keyframes, {excess.max():.3g} × the bound")
        if excess.max() <= 1 + ROUNDING or len(chosen) == len(recorded.times):
            return tuple(chosen), timeline
        excess[chosen] = 0.0
        least = max(1.0, SHARE * excess.max())
        peaks = [a + 1 + int(excess[a + 1 : b].argmax()) for a, b in pairwise(chosen) if b > a + 1]
        chosen = sorted([*chosen, *(peak for peak in peaks if excess[peak] >= min(least, excess.max()))])


def tips(figure: Figure, marked: Set[int]) -> list[tuple[str, int, Array]]:
    """Return the tips of limbs, farthest from their last joint: name, link and position (3,) [m] in it.

    Args:
        marked: Bodies that have a site, which serves as the tip of their limbs.
    """
    model, out = figure.model, []
    ends = {limb[0] for limb in figure.limbs}
    ends -= {figure.point_on_link(body, np.zeros(3))[0] for body in marked}
    far: dict[int, tuple[float, Array]] = {}
    for point in body_points(figure) if ends else ():
        size = float(np.linalg.norm(point.position))
        if point.link in ends and size > 0 and size + point.radius > far.get(point.link, (0.0,))[0]:
            far[point.link] = size + point.radius, point.position * (1 + point.radius / size)
    for link, (_, place) in sorted(far.items()):
        name = model.body(figure.links[link].body).name or f"body {figure.links[link].body}"
        out.append((f"tip of {name}", link, place))
    return out


def _without_redundant(recorded: Recorded, instants: Sequence[int], report: Callable[[str], None]) -> list[int]:
    """Return the keyframes without those that are not needed; those with the nearest neighbours are removed first."""
    remaining, before = list(instants), 0
    while len(remaining) != before:
        before = len(remaining)
        spans = {i: remaining[n + 1] - remaining[n - 1] for n, i in enumerate(remaining[1:-1], 1)}
        for i in sorted(spans, key=spans.__getitem__):
            n = remaining.index(i)
            if recorded.excess_without(remaining, n) <= 1 + ROUNDING:
                del remaining[n]
        report(f"{len(remaining)} keyframes")
    return remaining
