"""Placing of keyframes that set the legs and leave the root's height free: feet on the ground, where they stand.

It is the reverse of `standing_feet`, where the root is set and legs follow; here the root follows the legs. Heights on
a spline through other keyframes would leave bent legs in the air. Nothing is placed between two keyframes in the air,
nor in a flight that the clip specifies.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.contacts import ContactSchedule
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.stances import planted_place
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.dynamics import height
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.surface.heights import FAR, heights
from dynsplines.solver.surface.points import Point, body_points, free_root, hanging, sets_places
from dynsplines.solver.surface.surface import DEEP

HANGING = 0.15  # largest height above the ground, relative to the figure's, of a standing one, as in rest poses


def put_down(keys: Sequence[Frame], schedule: ContactSchedule, before: ContactSchedule) -> list[Frame]:
    """Return the keyframes of a schedule, with standing ones of the first root with feet moved onto the ground.

    Args:
        before: The contacts of the keyframes before feet were posed, with the stances of the soles.
    """
    root = free_root(schedule.figure, schedule.points)
    if root is None or not schedule.surfaces or schedule.keys.known[:, schedule.figure.links[root].qpos + 2].all():
        return list(keys)
    return _Grounding(schedule, root).put_down(keys, before)


@dataclass(frozen=True, eq=False)
class _Grounding:
    """Places the tree of one root.

    Attributes:
        schedule: The contacts and flights of keyframes, whose unspecified entries are interpolated.
        root: The link that carries the tree.
    """

    schedule: ContactSchedule
    root: int

    def put_down(self, keys: Sequence[Frame], before: ContactSchedule) -> list[Frame]:
        """Return the keyframes, with standing ones moved onto the ground, see `put_down`."""
        timeline, surfaces, soles = self.schedule.keys, self.schedule.surfaces, self._soles
        body = hanging(self.figure, self.root, body_points(self.figure))
        points = KeyframePoints.of(self.figure, timeline, (*soles, *body), surfaces)
        mine = [i for i, sole in enumerate(before.points) if self.figure.tables.path[sole.link, self.root]]
        centres, radii = points.centres, points.radii
        low = points.heights.min(axis=0)
        bottom = (centres[2] - radii[:, None]).min(axis=0)
        sets_height = timeline.known[:, self._height]
        standing = self._must_stand(timeline, low)
        moved, is_loop = list(keys), timeline.ends == "periodic"
        for k, key in enumerate(keys[: len(keys) - is_loop]):
            beside = _beside(sets_height | standing, k, loop=is_loop)
            between = len(beside) > 1
            nearest = np.where(standing, 0.0, low)[beside if between else sets_height | standing]
            if sets_height[k] or not (standing[k] or self._stands(timeline, k, nearest, between=between)):
                continue
            levels = [np.max(bottom[beside])] if beside else [bottom[k], bottom[k] + self._length]
            above = [np.array([0.0, 0.0, level + DEEP - bottom[k]]) for level in levels]
            down = self._shallowest(centres[..., k], radii, self._drops(centres[..., k], radii, above))
            if down is None:
                continue
            stances = [planted_place(before.resting_points, i, k) for i in mine]
            spots = np.array([np.full(3, np.nan) if spot is None else spot for spot in stances]).T
            stay = self._across(centres[..., k] + down[:, None], radii, spots)
            if stay is not None:
                loose = ~timeline.known[k, self._columns]
                beyond = [start + stay * loose for start in above]
                drops = self._drops(centres[..., k], radii, beyond)
                there = self._shallowest(centres[..., k], radii, [*drops, down])
                stay, down = (None, down) if there is None or there is down else (stay, there)
            moved[k] = self._place(key, timeline.states[k], down, is_across=stay is not None)
        return moved

    @property
    def figure(self) -> Figure:
        return self.schedule.figure

    @cached_property
    def _soles(self) -> tuple[Point, ...]:
        """The sole points of the tree."""
        return hanging(self.figure, self.root, self.schedule.points)

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
        return any(first < time < last for first, last in self.schedule.flights)

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
        for point in self._soles:  # the foot's own joint may be free
            mask[:, self.figure.links[point.link].columns] = True
        return bool(sets_places(self.figure, mask, self._soles).all())

    def _drops(self, centres: Array, radii: Array, starts: Sequence[Array]) -> Iterator[Array]:
        """Yield displacements [m] of spheres (3, n) by a start (3,) and then vertically to the ground below soles or
        all."""
        for start in starts:
            for count in (len(self._soles), radii.size):
                moved = self._drop(centres[:, :count], radii[:count], start)
                if moved is not None:
                    yield moved

    def _drop(self, centres: Array, radii: Array, by: Array) -> Array | None:
        """Return the displacement for one start, onto the ground below all spheres; None without ground."""
        by = np.array(by)
        for _ in range(30):  # a few suffice unless surfaces are steep
            lowest = float(heights(self.schedule.surfaces, (centres + by[:, None])[..., None], radii)[0].min())
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
            deep = max(float(surface.inside(skin + move[:, None]).max()) for surface in self.schedule.surfaces)
            if deep < least - self._limits.tiny:
                best, least = move, deep
        return best

    def _across(self, centres: Array, radii: Array, spots: Array) -> Array | None:
        """Return the horizontal displacement (3,) [m] to the soles' stances, if it is about equal for all, else None.

        centres  (3, n) of all points, with soles first;  spots  (3, m) of stances, NaN without
        """
        count = len(self._soles)
        above, _ = heights(self.schedule.surfaces, centres[:, :count, None], radii[:count])
        away = (spots - centres[:, :count])[:2, (above[:, 0] < self._limits.clear) & ~np.isnan(spots[0])]
        if not away.size:
            return None
        mean = away.mean(axis=1)
        spread = float(np.linalg.norm(away - mean[:, None], axis=0).max())
        return np.array([*mean, 0.0]) if spread < self._limits.same_spot else None

    def _place(self, key: Frame, there: Array, by: Array, *, is_across: bool) -> Frame:
        """Return a keyframe with the root moved from a state (N,) by (3,) [m] along z, or all unspecified axes.

        The search keeps the height if the keyframe specifies x and y.
        """
        state, posed = np.array(key.state), np.zeros(key.fixed.shape, bool) if key.posed is None else key.posed.copy()
        posed[self._columns] |= np.array([is_across, is_across, True]) & ~key.fixed[self._columns]
        state[self._columns] = np.where(posed[self._columns], there[self._columns] + by, state[self._columns])
        fixed = key.fixed.copy()
        fixed[self._height] |= fixed[self._columns][:2].all()
        return Frame(key.time, state, fixed, posed)


def _beside(sets_height: Mask, k: int, *, loop: bool) -> list[int]:
    """Return the nearest keyframes before and after keyframe k in a mask (K,), in a loop across its end."""
    at = np.flatnonzero(sets_height)
    before, after = at[at < k], at[at > k]
    if loop and at.size:
        return [int(before[-1] if before.size else at[-1]), int(after[0] if after.size else at[0])]
    return [*before[-1:].tolist(), *after[:1].tolist()]
