"""All thresholds of standing, flying, grasping and gait, relative to the size of the figure.

Each has the value of an adult on earth, and is scaled with the figure's lengths and times: a doll, a robot and a giant
that move alike have the same stances, flights and cycle.
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
    """The thresholds of a figure, in metres, seconds and their powers; by default those of an adult."""

    # Standing, by keyframes
    near_surface: float = _metres(0.012)  # a sole that stands is as near to its surface: posing is no more exact
    same_spot: float = _metres(0.05)  # two keyframes put a standing point no farther apart: feet are posed by eye
    same_place: float = _metres(0.001)  # the same of an object that lies: it has no reason to drift
    object_arm: float = _metres(
        0.2
    )  # from an object's origin to the points that hold it: half of what a person carries
    touching: float = _metres(0.05)  # the lowest point of a keyframe on the ground: tips of shoes bend
    stretch: float = _metres(
        0.01
    )  # two points of one body in two contacts change their distance: they are marked by eye
    moved: float = _metres(0.02)  # a keyframe puts a point of a recording elsewhere: beyond what skin gives
    shallow: float = _metres(0.002)  # two places of a foot are as deep as each other
    ankle: float = _metres(0.002)  # what carries toes is no higher than they are
    as_tall: float = _metres(0.001)  # two poses are as tall as each other

    # Standing, in soft constraints
    settling: float = _seconds(0.05)  # a speed counts like the way made in this time
    slip_reach: float = _metres(0.04)  # a point this high is 1/e as bound as on the ground
    float_reach: float = _metres(0.05)  # from this height on a body is in the air
    float_blend: float = _metres(0.01)  # points this near to the lowest count as lowest
    firm_blend: float = _metres(0.002)  # the same where nothing else sets the height
    strode: float = _metres(0.08)  # a point that goes farther between two keyframes is in the air in between
    shortly: float = _seconds(0.25)  # up to this time it cannot stand on the way as well
    long: float = _seconds(0.45)  # keyframes farther apart leave time for a step that they do not show

    # Flying
    aloft: float = _metres(0.05)  # all soles this high are in the air beyond doubt
    rise: float = _metres(0.6)  # the centre of mass rises no more in an inferred flight: the best athletes do
    stray: float = _metres(0.15)  # keyframes in the air are this near to the free fall: flights are posed by eye
    step: float = _seconds(0.2)  # a foot is down for so long in a running step
    lowering: float = _of(2.0, 1, -1)  # speed of a foot that comes down for a step, and is lifted after it

    # Grasping
    out_of_reach: float = _metres(0.15)  # a keyframe this far out of a limb's reach still shows the limb, stretched
    met: float = _metres(0.001)  # a grasp that a pose misses by no more is met

    # Standing, in recordings
    rolls: float = _metres(0.015)  # standard deviation of a standing point about its middle: feet roll
    hovers: float = _metres(0.04)  # standard deviation of a stance's height: calibration, and thickness of soles
    highest: float = _metres(0.3)  # range of heights of points that do not stand; no stance is half as high
    edge: float = _metres(0.1)  # a point may stand beside the edge by so much: recordings drift
    longest: float = _seconds(1.0)  # of a stance that is examined at once
    finest: float = _of(60.0, 0, -1)  # rate of samples that are distinguished
    fast: float = _of(0.35, 1, -1)  # speed from which on a point does not stand
    blurred: float = _seconds(0.03)  # noise of places over this time is noise of speeds, once smoothed
    interrupted: float = _seconds(0.1)  # gap between runs of one stance: heels and toes change over
    same_middle: float = _metres(0.03)  # between the middles of two runs of one stance
    lively: float = _of(100.0, 2, -3)  # squared acceleration by frequency: 45 m/s² of a foot or hand, up to 10 Hz
    fastest: float = _of(3.0, 1, -1)  # speed of a point of which nothing is known yet
    floor_off: float = _metres(0.05)  # a floor this far off is the fault of the recording
    level: float = _metres(0.001)  # a recording this near to its floor stays as it is
    noisy: float = _metres(0.008)  # noise of soles from which on stances are inferred twice
    deep: float = _metres(0.04)  # depth of soles, likewise: stiff feet go in by their tips
    flush: float = _metres(0.0005)  # what is beside a sole may be below it

    # Gait
    slowest: float = _of(0.25, 1, -1)  # a body with the hips of an adult that is slower does not travel
    floor_level: float = _metres(0.05)  # ground whose heights differ by less is level: steps are no cycle of poses
    low: float = _metres(0.04)  # a sole this near to its lowest height is to stand
    any_period: tuple[float, float] = field(default=(0.3, 3.0), metadata={"time": 1})  # of what does not travel
    smooth: float = _seconds(0.25)  # over which motion that is not periodic is alike
    alike: tuple[float, ...] = field(default=(0.15, 0.25, 0.5, 1.0), metadata={"time": 1})  # that a cycle has to beat
    tick: float = _seconds(0.02)  # between the poses of a cycle
    height_turn: float = _of(5.0, -1, 0)  # [rad/m] turn of a joint that counts like a metre of height

    # Reports
    rests: float = _metres(0.01)  # a point this near to a surface skates if it moves
    swings: float = _metres(0.01)  # a foot this high is off the ground
    brief_swing: float = _seconds(0.05)  # a shorter swing is a bounce
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
