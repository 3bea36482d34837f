"""Placing of keyframes that set the legs and leave the root's height free: feet on the ground, where they stand.

It is the reverse of `standing_feet`, where the root is set and legs follow; here the root follows the legs. Heights on
a spline through other keyframes would leave bent legs in the air. Nothing is placed between two keyframes in the air,
nor in a flight that the clip specifies.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.contacts import ContactSchedule
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.dynamics import height
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import FAR, heights
from dynsplines.solver.surface.points import Point, body_points, free_root, hanging, placed
from dynsplines.solver.surface.surface import DEEP

HANGING = 0.15  # largest height above the ground, relative to the figure's, of a standing one, as in rest poses


@dataclass(frozen=True, eq=False)
class Grounding:
    """Places the tree of one root.

    root   the link that carries the tree
    mine   (n,) indices of the figure's sole points on it
    soles  these points;  points  of the whole tree, soles first
    aloft  (first, last) [s] of every flight that the clip specifies
    """

    figure: Figure
    root: int
    mine: Index
    soles: tuple[Point, ...]
    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    aloft: tuple[tuple[float, float], ...] = ()

    @classmethod
    def of(
        cls,
        figure: Figure,
        soles: Sequence[Point],
        surfaces: Sequence[Surface],
        aloft: Sequence[tuple[float, float]] = (),
    ) -> Grounding | None:
        """Return the grounding of the first root with feet; None without one, or without ground."""
        root = free_root(figure, soles)
        if root is None or not surfaces:
            return None
        mine = np.flatnonzero([figure.tables.path[point.link, root] for point in soles])
        soles_of_tree, body = hanging(figure, root, soles), hanging(figure, root, body_points(figure))
        return cls(figure, root, mine, soles_of_tree, (*soles_of_tree, *body), tuple(surfaces), tuple(aloft))

    def is_asked(self, keys: Sequence[Frame]) -> bool:
        """Return whether any keyframe leaves the height free."""
        return not all(key.known[self._height] for key in keys)

    def leaping(self, timeline: Timeline) -> Grounding:
        """Return the grounding with the flights that keyframes with a height imply."""
        schedule = ContactSchedule(self.figure, timeline, self.soles, self.surfaces)
        return replace(self, aloft=(*self.aloft, *schedule.flights))

    def put_down(self, keys: Sequence[Frame], timeline: Timeline, staying: Callable[[int], Array]) -> list[Frame]:
        """Return the keyframes, with standing ones moved onto the ground; `timeline` interpolates unspecified entries.

        staying  returns the positions (3, n) [m] of the sole points with a stance at keyframe k; NaN for others
        """
        points = KeyframePoints.of(self.figure, timeline, self.points, self.surfaces)
        centres, radii = points.centres, points.radii
        low = points.heights.min(axis=0)
        bottom = (centres[2] - radii[:, None]).min(axis=0)
        sets_height = timeline.known[:, self._height]
        standing = self._must_stand(timeline, low)
        moved = list(keys)
        for k, key in enumerate(keys):
            beside = _beside(sets_height | standing, k, loop=timeline.ends == "periodic")
            between = len(beside) > 1
            nearest = np.where(standing, 0.0, low)[beside if between else sets_height | standing]
            if sets_height[k] or not (standing[k] or self._stands(timeline, k, nearest, between=between)):
                continue
            levels = [np.max(bottom[beside] - low[beside])] if beside else [bottom[k], bottom[k] + self._length]
            above = [np.array([0.0, 0.0, level + DEEP - bottom[k]]) for level in levels]
            down = self._shallowest(centres[..., k], radii, self._drops(centres[..., k], radii, above))
            if down is None:
                continue
            stay = self._across(centres[..., k] + down[:, None], radii, staying(k)[:, self.mine])
            if stay is not None:
                loose = ~timeline.known[k, self._columns]
                beyond = [start + stay * loose for start in above]
                drops = self._drops(centres[..., k], radii, beyond)
                there = self._shallowest(centres[..., k], radii, [*drops, down])
                stay, down = (None, down) if there is None or there is down else (stay, there)
            moved[k] = self._place(key, timeline.states[k], down, is_across=stay is not None)
        return moved

    @property
    def _columns(self) -> slice:
        """The entries of the root's position."""
        first = self.figure.links[self.root].qpos
        return slice(first, first + 3)

    @property
    def _height(self) -> int:
        return self.figure.links[self.root].qpos + 2

    @property
    def _limits(self) -> Thresholds:
        return Thresholds.of(self.figure)

    @cached_property
    def _length(self) -> float:
        return height(self.figure, self.root)

    def _must_stand(self, timeline: Timeline, low: Array) -> Mask:
        """Return the keyframes before or after all those with a height that stand because no free fall lasts until the
        nearest of these, (K,). Those with a height are all in the air, low (K,) [m] above the ground."""
        sets_height, g = timeline.known[:, self._height], -float(self.figure.gravity[2])
        out = np.zeros_like(sets_height)
        if not sets_height.any() or g <= 0 or timeline.ends == "periodic" or (low[sets_height] < self._high).any():
            return out
        top = np.maximum(low, self._limits.rise)
        longest = (np.sqrt(2 * top) + np.sqrt(2 * (top - low))) / np.sqrt(g)
        for k in np.flatnonzero(~sets_height).tolist():
            beside = _beside(sets_height, k, loop=False)
            out[k] = len(beside) == 1 and abs(timeline.times[k] - timeline.times[beside[0]]) > longest[beside[0]]
        return out & ~np.array([self._is_aloft(time) for time in timeline.times])

    def _is_aloft(self, time: float) -> bool:
        """Return whether a time [s] is in a flight."""
        return any(first < time < last for first, last in self.aloft)

    @property
    def _high(self) -> float:
        """The height above the ground [m] from which the figure is in the air."""
        alone = self.figure.tables.free_links.size == 1
        return max(HANGING * self._length, self._limits.clear) if alone else self._limits.clear

    def _stands(self, timeline: Timeline, k: int, low: Array, *, between: bool) -> bool:
        """Return whether keyframe k, which sets no height, stands.

        low      [m] height of the figure in the nearest keyframes before and after that set it, of which at least one
                 must be low; in all such keyframes, if they are all before or all after
        between  whether there are two; then keyframe k must set the position of its ankles, except the height
        """
        if self._is_aloft(timeline.times[k]):
            return False
        if low.size and not (low < self._high).any():
            return False
        if not between:
            return True
        mask = np.array(timeline.known[k : k + 1])
        mask[:, self._columns] = True
        for point in self.soles:  # the foot's own joint may be free
            mask[:, self.figure.links[point.link].columns] = True
        return bool(placed(self.figure, mask, self.soles).all())

    def _drops(self, centres: Array, radii: Array, starts: Sequence[Array]) -> Iterator[Array]:
        """Yield displacements [m] of spheres (3, n) by a start (3,) and then vertically to the ground below soles or
        all."""
        for start in starts:
            for count in (len(self.soles), radii.size):
                moved = self._drop(centres[:, :count], radii[:count], start)
                if moved is not None:
                    yield moved

    def _drop(self, centres: Array, radii: Array, by: Array) -> Array | None:
        """Return the displacement for one start, onto the ground below all spheres; None without ground."""
        by = np.array(by)
        for _ in range(30):  # a few suffice unless surfaces are steep
            lowest = float(heights(self.surfaces, (centres + by[:, None])[..., None], radii)[0].min())
            if lowest >= FAR:
                return None
            by[2] -= lowest
            if abs(lowest) < 1e-9:
                return by
        return None

    def _shallowest(self, centres: Array, radii: Array, moves: Iterable[Array]) -> Array | None:
        """Return the displacement (3,) [m] of spheres (3, n) with the least depth in any surface, None of none."""
        axes = np.hstack([np.eye(3), -np.eye(3)])
        skin = (centres[..., None] + radii[:, None] * axes[:, None, :]).reshape(3, -1)
        best, least = None, np.inf
        for move in moves:
            deep = max(float(surface.inside(skin + move[:, None]).max()) for surface in self.surfaces)
            if deep < least - self._limits.tiny:
                best, least = move, deep
        return best

    def _across(self, centres: Array, radii: Array, spots: Array) -> Array | None:
        """Return the horizontal displacement (3,) [m] to the soles' stances, if it is about equal for all, else None.

        centres  (3, n) of all points, with soles first;  spots  (3, m) of stances, NaN without
        """
        count = len(self.soles)
        above, _ = heights(self.surfaces, centres[:, :count, None], radii[:count])
        away = (spots - centres[:, :count])[:2, (above[:, 0] < self._limits.clear) & ~np.isnan(spots[0])]
        if not away.size:
            return None
        mean = away.mean(axis=1)
        spread = float(np.linalg.norm(away - mean[:, None], axis=0).max())
        return np.array([*mean, 0.0]) if spread < self._limits.same_spot else None

    def _place(self, key: Frame, there: Array, by: Array, *, is_across: bool) -> Frame:
        """Return a keyframe with the root moved from a state (N,) by (3,) [m] along z, or all unspecified axes."""
        state, posed = np.array(key.state), np.zeros(key.fixed.shape, bool) if key.posed is None else key.posed.copy()
        posed[self._columns] |= np.array([is_across, is_across, True]) & ~key.fixed[self._columns]
        state[self._columns] = np.where(posed[self._columns], there[self._columns] + by, state[self._columns])
        return Frame(key.time, state, key.fixed, posed)


def _beside(told: Mask, k: int, *, loop: bool) -> list[int]:
    """Return the nearest keyframes before and after keyframe k in a mask (K,), in a loop across its end."""
    at = np.flatnonzero(told)
    before, after = at[at < k], at[at > k]
    if loop and at.size:
        return [int(before[-1] if before.size else at[-1]), int(after[0] if after.size else at[0])]
    return [*before[-1:].tolist(), *after[:1].tolist()]
