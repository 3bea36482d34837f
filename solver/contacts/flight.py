"""Flights: intervals in which nothing supports the figure, inferred from keyframes and free fall."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..array import Array, Mask
from ..figure.dynamics import RootWrench
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..surface.points import Point, placed, places_of
from .footing import Interval
from .keyframe_points import KeyframePoints
from .stance import Rest, Stance
from .thresholds import Thresholds

# height of the centre of mass above the ground at take-off and landing, relative to the largest one of a pose on the
# ground: the body is stretched, on tiptoe; less would make flights longer than they are
STRETCHED = 1.15
HALVINGS = 60  # of the interval of a speed, which is then exact
PUSHED = 0.2  # least mean speed of the centre of mass before and after a flight, relative to take-off and landing


def flights(
    root: int, soles: KeyframePoints, stances: Sequence[Stance | Rest], body: Sequence[Point] = ()
) -> tuple[Interval, ...]:
    """Return the flights that a timeline of keyframes implies.

    A flight begins at the keyframe in which the last foot leaves the ground, or at the start of a clip that begins in
    the air. It ends at the keyframe in which the first foot lands, or at the end of the clip. If keyframes in the air
    are between keyframes on the ground, take-off and landing are between keyframes, see `_Arcs`.

    The feet must allow it. All keyframes of the flight fix the feet, or a height at which no foot reaches the ground.
    No foot keeps its place in two neighbouring keyframes, and no other point of the `body` touches a surface. A foot
    that leaves has stood before and is no longer flat on the ground. A foot that lands stands afterwards.

    The motion must be a free fall. It rises by at most 0.6 m and passes within 15 cm of the keyframes in between (for
    an adult, see `Thresholds`). In the segments before and after, the centre of mass rises and sinks with at least a
    fifth of its speeds at take-off and landing, as in a push-off and a landing.

    Keyframes that set the legs but no height are ignored in a flight between others that imply push-off and landing.
    """
    figure = soles.figure
    if not soles.points or not soles.surfaces or not figure.gravity.any():
        return ()
    column = figure.links[root].qpos + 2
    has_height = _tell_height(root, soles)
    is_posed = soles.keys.known[:, column] & ~has_height
    if is_posed.any():  # such keyframes count if they stand
        has_height |= is_posed & _KeyContacts.of(soles, stances, body).flat
    with_height = np.flatnonzero(has_height)
    if with_height.size < 2:
        return ()
    soles = soles.at_keyframes(with_height)
    times, rising = np.asarray(soles.keys.times), _centre(soles.samples, root)
    ground, tall = _lowest(soles.points, soles.samples) - soles.heights, _tall(figure, root, soles.points)
    is_high = soles.keys.fixed[:, column] & (rising - ground.max(axis=0) > STRETCHED * tall)
    contact = _KeyContacts.of(soles, stances, body, is_high)
    arcs = _Arcs.of(figure, times, contact, rising, ground.min(axis=0), tall)
    intervals, first = arcs.single(), 0
    for k in range(times.size - 1):
        if not contact.free[k]:
            first = k + 1
        elif k + 2 == times.size or contact.touched[k + 1] or not contact.free[k + 1]:
            begin, end = contact.in_the_air(first, k + 1)
            is_told = contact.leaves(begin) and contact.lands(end) and not contact.leaves_room(times, begin, end)
            if (
                with_height[end] - with_height[begin] > end - begin
            ):  # some keyframes are ignored, so a foot that touches must push
                is_told &= not contact.ends_down(begin, end)
            if is_told and _falls(figure, times, rising, begin, end):
                intervals.append(arcs.extended(begin, end))
            first = k + 1
    return tuple(sorted(intervals))


@dataclass(frozen=True)
class _KeyContacts:
    """Contact in keyframes.

    free     (K − 1,) segments that nothing carries
    touched  (K,) whether a foot touches;  flat  (K,) and with all its points;  aloft  (K,) whether all are in the air
    step     (K,) [s] time that the lowest foot needs to or from the middle of a step
    """

    free: Mask
    touched: Mask
    flat: Mask
    aloft: Mask
    step: Array

    @classmethod
    def of(
        cls,
        soles: KeyframePoints,
        stances: Sequence[Stance | Rest],
        body: Sequence[Point],
        high: Mask | bool = False,
    ) -> _KeyContacts:
        """Return the contacts in keyframes; `high` (K,) is True where no foot reaches the ground, whatever its pose."""
        height, limits = soles.heights, soles.limits
        low = height < limits.near_surface
        is_clear = np.logical_or.reduce(low) | (np.min(height, axis=0) > limits.aloft)  # otherwise contact is unknown
        known = (np.logical_and.reduce(soles.is_known) & is_clear) | high
        flat = np.zeros_like(known)
        for link in np.unique(soles.links):
            foot = soles.links == link
            if foot.sum() > 1:
                flat |= np.logical_and.reduce(low[foot])
        others = soles.with_points([point for point in body if point.link not in soles.links])
        known &= ~np.logical_or.reduce(others.heights < limits.near_surface)
        step = limits.step / 2 + height.min(axis=0) / limits.lowering
        begin, end = soles.keys.times[:-1], soles.keys.times[1:]
        carried = np.zeros(begin.size, bool)
        for stance in stances:
            carried |= (stance.first < end) & (begin < stance.last)
        touched = np.logical_or.reduce(low) & ~high
        return cls(~carried & known[:-1] & known[1:], touched, flat, known & ~touched, step)

    def leaves(self, k: int) -> bool:
        """Return whether a flight may begin at a keyframe."""
        return not self.touched[k] or (not self.flat[k] and (k == 0 or not self.free[k - 1]))

    def in_the_air(self, first: int, last: int) -> tuple[int, int]:
        """Return the first and last of several keyframes in the air, if flat feet before or after are no part of the
        flight; otherwise `first` and `last`."""
        inner = slice(first + 1, last)
        is_whole = last - first < 3 or not (self.touched[first] and self.touched[last] and self.aloft[inner].all())
        return (first, last) if is_whole or (self.leaves(first) and self.lands(last)) else (first + 1, last - 1)

    def ends_down(self, first: int, last: int) -> bool:
        """Return whether the keyframes begin with `first` or end with `last`, and a foot touches there."""
        return bool((first == 0 and self.touched[first]) or (last == self.free.size and self.touched[last]))

    def leaves_room(self, times: Array, first: int, last: int) -> bool:
        """Return whether there is time for a step between two neighbouring keyframes in the air."""
        if last > first + 1 or self.touched[first] or self.touched[last]:
            return False
        return bool(times[last] - times[first] >= self.step[first] + self.step[last])

    def lands(self, k: int) -> bool:
        """Return whether a flight may end at a keyframe."""
        return not self.touched[k] or k == self.free.size or not self.free[k]


@dataclass(frozen=True)
class _Arcs:
    """Free falls through keyframes in the air, from and to heights at which the stretched figure reaches the ground.

    times  (K,) [s];  rising  (K,) [m] height of the centre of mass
    reach  (K,) [m] its height at which the stretched figure touches the ground below each keyframe
    gravity  [m/s²]
    """

    times: Array
    rising: Array
    reach: Array
    contact: _KeyContacts
    limits: Thresholds
    gravity: float

    @classmethod
    def of(
        cls, figure: Figure, times: Array, contact: _KeyContacts, rising: Array, ground: Array, tall: float
    ) -> _Arcs:
        """Return the falls over the ground (K,) [m] below each keyframe, for a figure as tall as `tall` [m] or more."""
        tall = max(tall, float((rising - ground)[contact.touched].max(initial=0.0)))
        gravity = float(np.linalg.norm(figure.gravity))
        return cls(times, rising, ground + STRETCHED * tall, contact, Thresholds.of(figure), gravity)

    def single(self) -> list[Interval]:
        """Return the flights around single keyframes in the air between two on the ground.

        Their times on the ground before and after the flight are equal, since nothing else tells the speed.
        """
        arcs = list[Interval]()
        for k in (np.flatnonzero(self.contact.aloft[1:-1]) + 1).tolist():
            if not (self._is_grounded(k, k - 1) and self._is_grounded(k, k + 1)):
                continue
            speed = self._balanced(k)
            begin, end = self._end(k, k - 1, -speed), self._end(k, k + 1, speed)
            if begin is None or end is None or end - begin < self.limits.brief_flight:
                continue
            if self._rise(k, speed) <= self.limits.rise:
                arcs.append((begin, end))
        return arcs

    def _balanced(self, k: int) -> float:
        """Return the upward speed [m/s] at a keyframe for which the times on the ground before and after are equal."""
        high = self.gravity * float(self.times[k + 1] - self.times[k - 1])
        low = -high
        for _ in range(HALVINGS):
            speed = (low + high) / 2
            before = self.times[k] - self._fall(k, k - 1, -speed) - self.times[k - 1]
            after = self.times[k + 1] - self.times[k] - self._fall(k, k + 1, speed)
            low, high = (speed, high) if before < after else (low, speed)
        return (low + high) / 2

    def extended(self, first: int, last: int) -> Interval:
        """Return a flight between two keyframes, extended to take-off and landing if these are in the air."""
        t = self.times[last] - self.times[first]
        speed = (self.rising[last] - self.rising[first]) / t + self.gravity * t / 2
        begin = self._end(first, first - 1, -speed) if self._is_grounded(first, first - 1) else None
        end = self._end(last, last + 1, speed - self.gravity * t) if self._is_grounded(last, last + 1) else None
        return float(self.times[first] if begin is None else begin), float(self.times[last] if end is None else end)

    def _is_grounded(self, k: int, other: int) -> bool:
        """Return whether a keyframe in the air has a neighbour on the ground, with nothing in between that carries."""
        if not (0 <= other < self.times.size and self.contact.aloft[k] and self.contact.touched[other]):
            return False
        return bool(self.contact.free[min(k, other)] and self.rising[k] > self.reach[other])

    def _fall(self, k: int, other: int, speed: float) -> float:
        """Return the time [s] of the fall from a keyframe to a neighbour's ground, from an upward speed [m/s]."""
        height = max(self.rising[k] - self.reach[other], 0.0)
        return float(speed + np.sqrt(speed**2 + 2 * self.gravity * height)) / self.gravity

    def _end(self, k: int, other: int, speed: float) -> float | None:
        """Return the time [s] of take-off or landing between a keyframe in the air and a neighbour on the ground.

        None without enough time on the ground: the centre of mass is at most as fast there as in the air.
        """
        fall = self._fall(k, other, speed)
        left = abs(self.times[other] - self.times[k]) - fall
        if left * (self.gravity * fall - speed) < self.reach[other] - self.rising[other]:
            return None
        return float(self.times[k] + np.sign(other - k) * fall)

    def _rise(self, k: int, speed: float) -> float:
        """Return the height [m] of the top of a free fall above the lower one of take-off and landing."""
        return float(self.rising[k] + speed**2 / (2 * self.gravity) - self.reach[[k - 1, k + 1]].min())


def _tall(figure: Figure, root: int, points: Sequence[Point]) -> float:
    """Return the height [m] of the centre of mass above the soles in the rest pose."""
    rest = Samples.still(figure, figure.to_state(figure.model.qpos0)[None])
    return float(_centre(rest, root)[0] - _lowest(points, rest).min())


def _lowest(points: Sequence[Point], samples: Samples) -> Array:
    """Return the heights (n, S) [m] of the lowest spots of points, against gravity."""
    centres, radii = places_of(points, samples)
    return np.tensordot(_up(samples.figure), centres, axes=1) - radii[:, None]


def _centre(samples: Samples, root: int) -> Array:
    """Return the height (S,) [m] of the centre of mass, against gravity."""
    return _up(samples.figure) @ RootWrench(samples, root).centre


def _up(figure: Figure) -> Array:
    return -figure.gravity / np.linalg.norm(figure.gravity)


def _falls(figure: Figure, times: Array, height: Array, first: int, last: int) -> bool:
    """Return whether heights (K,) of a centre of mass fit a free fall between two keyframes. The segments before and
    after must fit a push-off and a landing."""
    limits = Thresholds.of(figure)
    g, t = float(np.linalg.norm(figure.gravity)), times[first : last + 1] - times[first]
    speed = (height[last] - height[first]) / t[-1] + g * t[-1] / 2
    rise = speed**2 / (2 * g) if 0 < speed < g * t[-1] else 0.0
    path = height[first] + speed * t - g * t**2 / 2
    falls = rise + min(height[first] - height[last], 0) <= limits.rise
    falls &= np.abs(height[first : last + 1] - path).max() <= limits.stray
    if first > 0:
        falls &= height[first] - height[first - 1] >= PUSHED * speed * (times[first] - times[first - 1])
    if last + 1 < times.size:
        falls &= height[last + 1] - height[last] <= PUSHED * (speed - g * t[-1]) * (times[last + 1] - times[last])
    return bool(falls)


def _tell_height(root: int, soles: KeyframePoints) -> Mask:
    """Return whether keyframes set a height, (K,); those that set only the legs do not, and stand where others do."""
    place = soles.figure.links[root].qpos + np.arange(3)
    fixed = np.array(soles.keys.fixed)
    fixed[:, place] = True
    return soles.keys.fixed[:, place[2]] | ~np.logical_and.reduce(placed(soles.figure, fixed, soles.points))
