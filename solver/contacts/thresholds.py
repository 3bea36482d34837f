"""All thresholds of stances, flights, grasps and gait, relative to the size of the figure.

Each is given for an adult on earth and scaled with the lengths and times of the figure. So a doll, a robot and a giant
that move alike have the same stances, flights and gait cycle.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import lru_cache
from typing import Any

from ..figure.figure import Figure
from ..figure.size import Size


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
    near_surface: float = _metres(0.012)  # distance of a planted sole from its surface: posing is no more exact
    same_spot: float = _metres(0.05)  # between the positions of a planted point in neighbouring keyframes
    same_place: float = _metres(0.001)  # likewise of an object at rest, which does not drift
    object_arm: float = _metres(0.2)  # from an object's origin to the points that fix its pose: half its size
    touching: float = _metres(0.05)  # height of the lowest point of a keyframe on the ground: tips of shoes bend
    stretch: float = _metres(0.01)  # change of the distance between two contact points of one body
    moved: float = _metres(0.02)  # displacement of a recorded contact point by a keyframe that ends the contact
    shallow: float = _metres(0.002)  # difference between equal depths
    ankle: float = _metres(0.002)  # height above the toes of the body that carries them
    as_tall: float = _metres(0.001)  # difference between the heights of equally tall poses
    far_apart: float = _seconds(0.4)  # shortest time between keyframes that is long enough for a step
    longest_step: float = _metres(0.7)  # largest lead of one foot over the other
    mid_step: float = _metres(0.12)  # height of a foot in the middle of a step, in an initial guess
    turning: float = _metres(
        0.1
    )  # in the order of two steps, travel to the side that counts as much as a turn of 1 rad
    travels: float = _of(0.5, 1, -1)  # horizontal speed of a travelling root: half that of a walk

    # Contacts, in soft constraints
    settling: float = _seconds(0.05)  # a speed costs as much as the distance covered in this time
    slip_reach: float = _metres(0.033)  # height at which the cost of slipping has fallen to 1/e
    float_reach: float = _metres(0.05)  # height from which a body is in the air
    float_blend: float = _metres(0.01)  # difference of heights over which points share the role of the lowest
    strode: float = _metres(0.08)  # displacement of a point between two keyframes that implies a swing in the air
    shortly: float = _seconds(0.25)  # time between them that leaves no time for a stance as well
    long: float = _seconds(0.45)  # time between keyframes from which they specify the feet between them poorly

    # Flights
    aloft: float = _metres(0.05)  # height of all soles in the air
    rise: float = _metres(0.6)  # largest rise of the centre of mass in an inferred flight
    stray: float = _metres(0.15)  # distance of keyframes from the free fall: flights are posed by eye
    step: float = _seconds(0.2)  # time for which a foot is on the ground in a running step
    lowering: float = _of(2.0, 1, -1)  # speed of a foot that is put down for a step or lifted after it
    lift_off: float = _seconds(0.02)  # uncertainty of the time at which a foot leaves or reaches the ground
    brief_flight: float = _seconds(0.1)  # a shorter time in the air is the moment before a landing

    # Grasps
    out_of_reach: float = _metres(0.15)  # distance of a target beyond a limb that still stretches towards it
    at_hand: float = _metres(0.5)  # distance of a hand that starts or ends a hold of an object at rest
    met: float = _metres(0.001)  # distance at which a pose meets a grasp

    # Stances, from recordings
    rolls: float = _metres(0.015)  # standard deviation of a planted point about its mean: feet roll
    hovers: float = _metres(0.04)  # standard deviation of a stance's height: calibration, thickness of soles
    raised: float = _metres(0.05)  # height from which a resting point is in the air: stances drift by up to 5 cm
    tilted: float = _metres(0.02)  # height above the lowest point of its foot, from which a point is in the air
    highest: float = _metres(0.3)  # range of heights of points in the air; no stance is half as high
    edge: float = _metres(0.1)  # distance of a planted point beyond the edge of a surface: recordings drift
    longest: float = _seconds(1.0)  # longest stance that is examined at once
    finest: float = _of(60.0, 0, -1)  # rate of the samples that are examined
    fast: float = _of(0.35, 1, -1)  # speed from which a point is not planted
    still: float = _of(0.05, 1, -1)  # likewise in a recording whose planted points do not move
    blurred: float = _seconds(0.03)  # noise of positions over this time is noise of smoothed speeds
    interrupted: float = _seconds(0.1)  # gap between two parts of one stance: heel and toes take turns
    drift: float = _of(0.2, 1, -1)  # speed of a planted point in a recording that drifts
    long_stance: float = _seconds(0.3)  # a longer stance is none of the moments in which a moving foot is slow
    same_middle: float = _metres(0.03)  # distance between the means of two parts of one stance
    lively: float = _of(100.0, 2, -3)  # squared acceleration by frequency: 45 m/s² of a foot or hand, up to 10 Hz
    fastest: float = _of(3.0, 1, -1)  # standard deviation of the initial speed of a point
    floor_off: float = _metres(0.05)  # distance of a floor that is a fault of the recording
    level: float = _metres(0.001)  # distance of a recording from its floor that is left unchanged
    noisy: float = _metres(0.004)  # noise of soles from which stances are inferred twice
    unsure: float = _seconds(0.1)  # time at the ends of stances in which a point may move, hidden by noise
    deep: float = _metres(0.04)  # depth of soles, likewise: stiff feet sink in by their tips
    flush: float = _metres(0.0005)  # depth of the other points of a sole below the planted one

    # Gait
    slowest: float = _of(0.25, 1, -1)  # speed from which a body travels
    floor_level: float = _metres(0.05)  # range of ground heights that count as level
    low: float = _metres(0.04)  # height above the lowest height of a sole that is to stand
    any_period: tuple[float, float] = field(default=(0.3, 3.0), metadata={"time": 1})  # without travel
    smooth: float = _seconds(0.18)  # correlation time of motion that is not periodic
    alike: tuple[float, ...] = field(default=(0.15, 0.25, 0.5, 1.0), metadata={"time": 1})  # of rival models
    tick: float = _seconds(0.02)  # between the poses of a cycle
    height_turn: float = _of(5.0, -1, 0)  # [rad/m] rotation of a joint as large as a metre of height

    # Reports
    rests: float = _metres(0.01)  # distance from a surface up to which a moving point skates
    swings: float = _metres(0.01)  # height of a foot that is off the ground
    brushes: float = _metres(0.005)  # height of a heel or toe that drags
    dragged: float = _of(0.5, 1, -1)  # speed of a foot that does not swing although it is above the ground
    push_off: float = _seconds(0.32)  # longest time between contact and free fall, before and after a jump together
    brief_stance: float = _seconds(0.05)  # a shorter stance lies between two samples of a recording

    @classmethod
    def of(cls, figure: Figure) -> Thresholds:
        """Return the thresholds of a figure."""
        return _scaled(Size.of(figure))


@lru_cache(maxsize=64)
def _scaled(size: Size) -> Thresholds:
    scaled: dict[str, Any] = {}
    for each in fields(Thresholds):
        scale = size.length ** each.metadata.get("length", 0) * size.time ** each.metadata.get("time", 0)
        value = each.default
        scaled[each.name] = tuple(scale * v for v in value) if isinstance(value, tuple) else scale * value
    return Thresholds(**scaled)
