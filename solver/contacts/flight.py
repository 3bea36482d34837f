"""Free falls around keyframes in the air, in which nothing can support the figure.

A keyframe does not state when the figure leaves the ground or reaches it. But the centre of mass follows an arc through
the keyframe, and as long as it is higher than that of a stretched figure on its toes, no leg reaches the ground.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array, Mask, runs
from ..figure.dynamics import RootWrench
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..surface.heights import FAR
from ..surface.points import Point, places_of
from .contact import Interval
from .keyframe_points import KeyframePoints
from .stances import is_grounded, is_near
from .thresholds import Thresholds

# height of the centre of mass above the ground of a stretched figure on its toes, relative to that at rest or in a
# keyframe on the ground; less would make falls longer than they are
STRETCHED = 1.15


@dataclass(frozen=True)
class Fall:
    """A free fall through keyframes in the air.

    Attributes:
        first: The start [s].
        last: The end [s].
        misses: The keyframe that is farthest from the arc of the centre of mass.
        by: How much higher than the arc that keyframe is [m].
        is_met: Whether this is so little that the figure falls freely.
    """

    first: float
    last: float
    misses: int
    by: float
    is_met: bool


@dataclass(frozen=True, eq=False)
class Air:
    """The centre of mass at K keyframes, and the ground below.

    Attributes:
        times: The times of the keyframes, (K,) [s].
        centre: The heights of the centre of mass, (K,) [m].
        tiptoe: The heights up to which a stretched figure reaches the ground there, (K,) [m].
        is_aloft: Whether the figure is in the air, (K,).
        is_grounded: Whether it is on the ground, (K,); neither in keyframes that leave the height free.
        gravity: The acceleration of free fall [m/s²].
    """

    times: Array
    centre: Array
    tiptoe: Array
    is_aloft: Mask
    is_grounded: Mask
    gravity: float
    limits: Thresholds
    held: Sequence[Interval]

    @classmethod
    def of(cls, root: int, body: KeyframePoints, soles: Sequence[Point], held: Sequence[Interval]) -> Air | None:
        """Return the keyframes of a figure, given by the link of its free joint.

        A keyframe is in the air if it sets the height of the root, no point is closer than 5 cm to the ground (for an
        adult), and the centre of mass is higher than that of a stretched figure on its toes.

        Args:
            body: All points of the figure.
            soles: Those of the feet.
            held: The intervals [s] in which contacts or grasps may carry the figure.
        """
        figure, feet = body.figure, body.with_points(soles)
        if not soles or not body.surfaces or not figure.gravity.any():
            return None
        times, lowest = np.asarray(body.keys.times), feet.heights.argmin(axis=0)
        low = feet.heights.min(axis=0)
        ground = np.take_along_axis(_bottoms(figure, feet), lowest[None], axis=0)[0] - low
        centre = _centre(body.samples, root)
        touches = is_near(feet).any(axis=0)
        rest = Samples.of_qpos(figure)
        tall = _centre(rest, root)[0] - _bottoms(figure, KeyframePoints(rest, body.keys, tuple(soles))).min()
        tiptoe = ground + STRETCHED * max(tall, (centre - ground)[touches].max(initial=0.0))
        is_known, is_low = body.keys.known[:, figure.links[root].qpos + 2], is_grounded(body)
        is_aloft = is_known & ~is_low & (low < FAR) & (centre > tiptoe)
        for first, last in held:
            is_aloft &= (times < first) | (last < times)
        return cls(
            times, centre, tiptoe, is_aloft, is_known & is_low, float(np.linalg.norm(figure.gravity)), body.limits, held
        )

    def falls(self) -> Iterator[Fall]:
        """Yield the free falls between keyframes on the ground, or from the start or to the end of the clip.

        Keyframes in the air in succession are on one arc through the first and the last of them. If a fall from one to
        the next would rise by more than 0.6 m (for an adult), the figure does not fall freely.
        """
        longest = 2 * np.sqrt(2 * self.limits.rise / self.gravity)
        for first, end in runs(self.is_aloft):
            beside = [k for k in (first - 1, end) if 0 <= k < self.times.size]
            if np.diff(self.times[first:end]).max(initial=0.0) <= longest and self.is_grounded[beside].all():
                yield self._fall(first, end - 1)

    def _fall(self, first: int, last: int) -> Fall:
        """Return the fall through keyframes."""
        times, g = self.times, self.gravity
        speed, high = self._start(first, last)
        around = np.arange(max(first - 1, 0), min(last + 2, times.size))
        t = times[around] - times[first]
        path = self.centre[first] + speed * t - g * t**2 / 2
        inside = (first <= around) & (around <= last)
        # a keyframe next to the fall is lower than the arc only if a stretched figure would not reach the ground there
        off = np.where(inside, self.centre[around] - path, np.minimum(self.tiptoe[around] - path, 0.0))
        if first == last:
            off = np.where(inside, high, 0.0)
        worst = int(np.abs(off).argmax())
        begin, end = times[first], times[last]
        rise = self._duration(self.centre[first] - self.tiptoe[max(first - 1, 0)], -speed)
        sink = self._duration(self.centre[last] - self.tiptoe[around[-1]], speed - g * (end - begin))
        carried = [until for _, until in self.held if until <= begin], [since for since, _ in self.held if end <= since]
        begin = max([times[around[0]], begin - rise, *carried[0]])
        end = min([times[around[-1]], end + sink, *carried[1]])
        by = float(off[worst])
        return Fall(float(begin), float(end), int(around[worst]), by, abs(by) <= self.limits.out_of_reach)

    def _start(self, first: int, last: int) -> tuple[float, float]:
        """Return the speed upward [m/s] at the first keyframe of a fall, and how much too high a single one is [m].

        The top of an arc through a single keyframe is halfway between it and the middle of its neighbours, as far as
        these leave time for it.
        """
        times, g = self.times, self.gravity
        if first < last:
            span = times[last] - times[first]
            return float((self.centre[last] - self.centre[first]) / span + g * span / 2), 0.0
        least, most, gaps = -np.inf, np.inf, [np.inf, np.inf]
        if first:
            gaps[0] = times[first] - times[first - 1]
            least = (self.centre[first] - self.tiptoe[first - 1]) / gaps[0] - g * gaps[0] / 2
        if last + 1 < times.size:
            gaps[1] = times[last + 1] - times[last]
            most = g * gaps[1] / 2 - (self.centre[last] - self.tiptoe[last + 1]) / gaps[1]
        middle = g * (gaps[1] - gaps[0]) / 4 if np.isfinite(gaps).all() else 0.0
        if least > most:
            return float(least + most) / 2, float(least - most) / (1 / gaps[0] + 1 / gaps[1])
        return float(np.clip(middle, least, most)), 0.0

    def _duration(self, height: float, speed: float) -> float:
        """Return the time [s] of a fall over a height [m] from an upward speed [m/s]."""
        return (speed + float(np.sqrt(speed**2 + 2 * self.gravity * max(height, 0.0)))) / self.gravity


def _bottoms(figure: Figure, points: KeyframePoints) -> Array:
    """Return the heights (n, K) [m] of the lowest spots of points, against gravity."""
    centres, radii = places_of(points.points, points.samples)
    return np.tensordot(_up(figure), centres, axes=1) - radii[:, None]


def _centre(samples: Samples, root: int) -> Array:
    """Return the height (S,) [m] of the centre of mass, against gravity."""
    return _up(samples.figure) @ RootWrench(samples, root).centre


def _up(figure: Figure) -> Array:
    return -figure.gravity / np.linalg.norm(figure.gravity)
