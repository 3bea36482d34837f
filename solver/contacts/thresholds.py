"""All thresholds of stances, flights, grasps and gait, relative to the size of the figure.

Each is given for an adult on earth and scaled with the lengths and times of the figure. So a doll, a robot and a giant
that move alike have the same stances, flights and gait cycle.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import lru_cache
from typing import Any

import numpy as np

from ..array import Array
from ..figure.dynamics import Size
from ..figure.figure import Figure


def _metres(value: float) -> Any:
    return field(default=value, metadata={"length": 1})


def _seconds(value: float) -> Any:
    return field(default=value, metadata={"time": 1})


def _of(value: float, length: int, time: int) -> Any:
    """A threshold in m^length s^time."""
    return field(default=value, metadata={"length": length, "time": time})


@dataclass(frozen=True)
class Thresholds:
    """The thresholds of a figure in metres, seconds and their powers. The defaults are those of an adult."""

    # Stances, from keyframes
    near_surface: float = _metres(0.012)  # distance of a planted sole from its surface, and of two contacts of one body
    clear: float = _metres(0.05)  # height from which a point is in the air: tips of shoes bend, recordings drift
    tiny: float = _metres(0.001)  # distance or depth that counts as none
    fast: float = _of(0.35, 1, -1)  # speed from which a point is not planted, in recordings, too
    same_spot: float = _metres(0.05)  # between the positions of a planted point, or the heights of level ground
    object_arm: float = _metres(0.2)  # from an object's origin to the points that fix its pose: half its size
    moved: float = _metres(0.02)  # of a recorded contact point from its place or from the lowest point of its foot
    far_apart: float = _seconds(0.4)  # shortest time between keyframes that is long enough for a step
    travels: float = _of(0.5, 1, -1)  # horizontal speed of a travelling root or a dragged foot: half that of a walk

    # Contacts, in soft constraints
    settling: float = _seconds(0.05)  # a speed costs as much as the distance covered in this time
    slip_reach: float = _metres(0.033)  # height at which the cost of slipping has fallen to 1/e
    float_blend: float = _metres(0.002)  # difference of heights over which points share the role of the lowest
    shortly: float = _seconds(0.25)  # time between keyframes that leaves no time for a stance as well as a swing
    strode: float = _metres(0.08)  # displacement of a point between two keyframes that implies a swing in the air

    # Flights
    rise: float = _metres(0.6)  # largest rise of the centre of mass in an inferred flight
    step: float = _seconds(0.2)  # time for which a foot is on the ground in a running step
    moment: float = _seconds(0.1)  # a shorter interval counts as none
    lift_off: float = _seconds(0.02)  # uncertainty of the time of a contact, and time between poses of a cycle

    # Grasps
    out_of_reach: float = _metres(0.15)  # distance that keyframes may miss: of a hold, of an arc of free fall
    at_hand: float = _metres(0.5)  # distance of a hand that starts or ends a hold of an object at rest

    # Stances, from recordings
    rolls: float = _metres(0.015)  # standard deviation of a planted point about its mean: feet roll
    hovers: float = _metres(0.04)  # error of the height or depth of a standing sole: calibration, thickness of soles
    highest: float = _metres(0.3)  # height of points in the air; no stance is half as high
    edge: float = _metres(0.1)  # distance of a planted point beyond the edge of a surface: recordings drift
    longest: float = _seconds(1.0)  # longest stance that is examined at once
    finest: float = _of(60.0, 0, -1)  # rate of the samples that are examined
    still: float = _of(0.05, 1, -1)  # the same in a recording whose planted points do not move
    blurred: float = _seconds(0.03)  # noise of positions over this time is noise of smoothed speeds
    same_middle: float = _metres(0.03)  # distance between the means of two parts of one stance
    lively: float = _of(100.0, 2, -3)  # squared acceleration by frequency: 45 m/s² of a foot or hand, up to 10 Hz
    fastest: float = _of(3.0, 1, -1)  # standard deviation of the initial speed of a point
    noisy: float = _metres(0.004)  # noise of soles from which stances are inferred twice

    # Gait
    slowest: float = _of(0.25, 1, -1)  # speed from which a body travels
    any_period: tuple[float, float] = field(default=(0.3, 3.0), metadata={"time": 1})  # without travel
    smooth: float = _seconds(0.18)  # correlation time of motion that is not periodic
    alike: tuple[float, ...] = field(default=(0.15, 0.25, 0.5, 1.0), metadata={"time": 1})  # of rival models
    height_turn: float = _of(5.0, -1, 0)  # [rad/m] rotation of a joint as large as a metre of height

    # Reports
    push_off: float = _seconds(0.32)  # longest time between contact and free fall, before and after a jump together
    brushes: float = _metres(0.005)  # height of a heel or toe that drags

    def farthest_planted(self, seconds: Array) -> Array:
        """Return how far [m] a planted point moves at most in a time [s]."""
        return np.minimum(self.same_spot, self.fast * seconds)

    @classmethod
    def of(cls, figure: Figure) -> Thresholds:
        """Return the thresholds of a figure."""
        return _scale(Size.of(figure))


@lru_cache(maxsize=64)
def _scale(size: Size) -> Thresholds:
    scaled: dict[str, Any] = {}
    for each in fields(Thresholds):
        scale = size.length ** each.metadata.get("length", 0) * size.time ** each.metadata.get("time", 0)
        value = each.default
        scaled[each.name] = tuple(scale * v for v in value) if isinstance(value, tuple) else scale * value
    return Thresholds(**scaled)
