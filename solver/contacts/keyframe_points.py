"""Points of a figure at its keyframes: positions, heights above the ground, and whether keyframes determine them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..curve.frame import Timeline
from ..curve.seam import Seam
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..surface import Surface
from ..surface.heights import heights
from ..surface.points import Point, arrays_of, displacements, sets_places
from .thresholds import Thresholds


@dataclass(frozen=True, eq=False)
class KeyframePoints:
    """n points at K keyframes.

    Attributes:
        samples: The poses of the keyframes.
        keys: The keyframes.
        points: The points.
        surfaces: The surfaces that can support them.
    """

    samples: Samples
    keys: Timeline
    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...] = ()

    @classmethod
    def of(
        cls, figure: Figure, keys: Timeline, points: Sequence[Point], surfaces: Sequence[Surface] = ()
    ) -> KeyframePoints:
        """Return the points of a figure at keyframes."""
        return cls(Samples.still(figure, keys.states), keys, tuple(points), tuple(surfaces))

    def with_points(self, points: Sequence[Point]) -> KeyframePoints:
        """Return other points at the same keyframes."""
        return KeyframePoints(self.samples, self.keys, tuple(points), self.surfaces)

    @property
    def figure(self) -> Figure:
        return self.samples.figure

    @property
    def limits(self) -> Thresholds:
        return Thresholds.of(self.figure)

    @property
    def links(self) -> Index:
        """The links of the points, (n,)."""
        return self._arrays[0]

    @property
    def radii(self) -> Array:
        """The radii of the points, (n,) [m]."""
        return self._arrays[2]

    @cached_property
    def centres(self) -> Array:
        """The centres of the points, (3, n, K) [m]."""
        links, positions, _ = self._arrays
        return self.samples.links.points(links, positions)[0]

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) and radii (n,) of the points."""
        return arrays_of(self.points)

    @cached_property
    def moves(self) -> Array:
        """The distances between successive positions, (n, K − 1) [m]."""
        return displacements(self.centres)

    @property
    def heights(self) -> Array:
        """The heights of the points' lowest spots above the highest surface below them, (n, K) [m]; FAR without one."""
        return self._heights[0]

    @property
    def nearest(self) -> Index:
        """The index of the surface that `heights` refers to, (n, K); −1 without one."""
        return self._heights[1]

    @cached_property
    def _heights(self) -> tuple[Array, Index]:
        return heights(self.surfaces, self.centres, self.radii)

    @cached_property
    def is_known(self) -> Mask:
        """Whether the position is fixed, or computed by inverse kinematics, (n, K)."""
        return sets_places(self.figure, self.keys.known, self.points)

    @cached_property
    def is_fixed(self) -> Mask:
        """Whether the keyframe fixes the position, (n, K)."""
        return sets_places(self.figure, self.keys.fixed, self.points)

    def beside(self, i: int, k: int) -> tuple[Index, Array, Array]:
        """Return the nearest keyframes before and after k that determine point i, at most two, with their times [s] and
        the positions (m, 3) [m] of the point. In a loop, they may belong to the periods before and after."""
        numbers = self._beside(i, k)
        periods, keys = np.divmod(numbers, self._count)
        times, places = self.keys.times[keys], self.centres[:, i, keys].T
        if self._seam is not None:
            times = times + periods * (self.keys.times[-1] - self.keys.times[0])
            moved = [self._seam.moved_points(self.figure, p, int(n)) for p, n in zip(places, periods, strict=True)]
            places = np.reshape(moved, (-1, 3))
        return keys, times, places

    def orientation(self, i: int, k: int) -> Array:
        """Return the orientation (4,) of the link of point i in the nearest keyframe that determines it, else in k."""
        numbers, times = self._beside(i, k), self.beside(i, k)[1]
        n = int(numbers[np.abs(times - self.keys.times[k]).argmin()]) if numbers.size else k
        rotation = quat.from_matrix(self.samples.links.rotation[:, :, self.links[i], n % self._count])
        return rotation if self._seam is None else quat.product(self._seam.turn(n // self._count), rotation)

    def _beside(self, i: int, k: int) -> Index:
        """Return the numbers of `beside`. In a loop, numbers below zero and beyond the last belong to the periods
        before and after."""
        at = np.flatnonzero(self.is_known[i, : self._count])
        if self._seam is not None:
            at = np.concatenate([at - self._count, at, at + self._count])
        return np.concatenate([at[at < k][-1:], at[at > k][:1]])

    @cached_property
    def _seam(self) -> Seam | None:
        return Seam.of(self.figure, self.keys) if self.keys.ends == "periodic" else None

    @property
    def _count(self) -> int:
        """The number of keyframes; the last one of a loop, which repeats the first, does not count."""
        return len(self.keys.frames) - (self._seam is not None)

    def segments(self) -> Iterator[tuple[int, float, float]]:
        """Yield k, the time of keyframe k and the time of keyframe k + 1 [s], for every segment."""
        times = self.keys.times.tolist()
        yield from zip(range(len(times) - 1), times[:-1], times[1:], strict=True)
