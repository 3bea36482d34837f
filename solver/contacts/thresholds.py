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
    """The thresholds of a figure in metres, seconds and their powers, grouped by what they decide.

    The defaults are those of an adult.
    """

    # A stance, from keyframes, and its check: is a point planted?
    near_surface: float = _metres(0.012)  # distance of a planted sole from its surface, and of two contacts of one body
    same_spot: float = _metres(0.05)  # distance of a planted point's positions, heights of level ground; beyond an edge
    fast: float = _of(0.35, 1, -1)  # speed from which a point is not planted, and a body travels in a gait
    clear: float = _metres(0.05)  # height from which a point is in the air: tips of shoes bend, recordings drift
    slight: float = _metres(0.005)  # height of a heel or toe that drags; noise of soles that hides stances

    # A step: does it swing, and does the figure travel?
    strode: float = _metres(0.08)  # displacement of a point between two keyframes that implies a swing in the air
    shortly: float = _seconds(0.25)  # time too short for a stance as well as a swing: that of a running step
    far_apart: float = _seconds(0.4)  # time long enough for a step, and to push off before and after a jump
    travels: float = _of(0.5, 1, -1)  # horizontal speed of a travelling root or a dragged foot: half that of a walk

    # A flight
    rise: float = _metres(0.6)  # largest rise of the centre of mass in an inferred flight

    # A grasp
    object_arm: float = _metres(0.2)  # from an object's origin to the points that fix its pose: half its size
    out_of_reach: float = _metres(0.15)  # distance that keyframes may miss: of a hold, of an arc of free fall
    away: float = _metres(0.3)  # distance of a hand that holds nothing, height of a foot in the air: twice a stance's

    # A stance, from a recording
    rolls: float = _metres(0.015)  # standard deviation of a planted point about its mean: feet roll
    hovers: float = _metres(0.04)  # error of the height or depth of a standing sole: calibration, thickness of soles
    moved: float = _metres(0.02)  # of a planted point between the parts of a stance, or above the rest of its foot
    longest: float = _seconds(1.0)  # longest stance that is examined at once
    lively: float = _of(100.0, 2, -3)  # squared acceleration by frequency: 45 m/s² of a foot or hand, up to 10 Hz

    # A gait cycle; `smooth` are correlation times of other motion: the first beside a cycle, all without one
    any_period: tuple[float, float] = field(default=(0.3, 3.0), metadata={"time": 1})  # without travel
    smooth: tuple[float, ...] = field(default=(0.15, 0.25, 0.5, 1.0), metadata={"time": 1})
    height_turn: float = _of(5.0, -1, 0)  # [rad/m] rotation of a joint as large as a metre of height

    # The cost of contacts
    settling: float = _seconds(0.05)  # a speed costs as much as the distance covered in this time
    slip_reach: float = _metres(0.033)  # height at which the cost of slipping has fallen to 1/e
    float_blend: float = _metres(0.002)  # difference of heights over which points share the role of the lowest

    # What counts as none
    tiny: float = _metres(0.001)  # distance or depth
    lift_off: float = _seconds(0.02)  # uncertainty of the time of a contact; time between samples of motion
    moment: float = _seconds(0.1)  # interval

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
