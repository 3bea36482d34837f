"""Edits of timelines: speed, trimming, repetition of a loop, and two motions in sequence.

A cubic spline's curve is determined by the states at its knots and the slopes at both ends. Speed, trimming and
repetition transform knots and slopes without fitting, so the result is the same curve up to rounding.

The second of two motions is moved to the end of the first, and a transition between them is solved. It matches y, y'
and y'' at both its ends, so the C² spline through the frames of all three parts equals each motion in its interval.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array
from ..curve.frame import Frame, Timeline, TimelineError
from ..curve.raw import raw_timeline
from ..curve.seam import Seam, sameness, turning_root
from ..curve.spline import path_of
from ..figure.figure import Figure, JointKind
from ..figure.kinematics import Samples
from ..tolerances import ROUNDING

LEAST_FRAMES = 4  # minimum number of variable frames, so that value, slope and curvature match at both ends
OF_TRUNK = 0.25  # [1] minimum share of the mass beyond a link of the trunk; it is less for feet with toes


def retime(timeline: Timeline, speed: float) -> Timeline:
    """Return the same path at `speed` times the speed, from the same start: y(t₀ + (t − t₀) · speed)."""
    if not (np.isfinite(speed) and speed > 0):
        raise TimelineError(f"speed must be a number above 0, not {speed:g}")
    # the end slopes of a loop are the jumps of y' and y'' at its seam
    powers = np.array([1, 2]) if timeline.ends == "periodic" else np.ones(2)
    times = timeline.times[0] + (timeline.times - timeline.times[0]) / speed
    frames = Frame.many(times, timeline.states, timeline.fixed)
    return Timeline(tuple(frames), timeline.end_slope * speed ** powers[:, None], timeline.ends)


def check_interval(span: tuple[float, float], first: float, last: float) -> None:
    """Raise TimelineError unless `first` to `last` [s] is within the motion."""
    if not first < last:
        raise TimelineError(f"an interval ends after it begins, not from {first:g} to {last:g} s")
    if first < span[0] - ROUNDING or last > span[1] + ROUNDING:
        raise TimelineError(f"from {first:g} to {last:g} s is not inside {span[0]:g} to {span[1]:g} s")


def trim(timeline: Timeline, first: float, last: float) -> Timeline:
    """Return the part of a timeline from `first` to `last` [s], with free ends; both are keyframes on the curve."""
    times = timeline.times
    check_interval((float(times[0]), float(times[-1])), first, last)
    near = times[np.abs(times[:, None] - np.array([first, last])).argmin(axis=0)]
    edges = np.where(np.abs(near - np.array([first, last])) <= ROUNDING, near, [first, last])
    path = path_of(timeline)
    inside = [frame for frame in timeline.frames if edges[0] < frame.time < edges[1]]
    whole = np.ones(timeline.width, bool)
    begin, end = (Frame(t, path.at(t)[0], whole) for t in edges.tolist())
    return Timeline((begin, *inside, end), path.at(edges, 1))


def repeat(figure: Figure, timeline: Timeline, count: int) -> Timeline:
    """Return a loop repeated `count` times as one loop, with accumulated travel and one frame at each inner seam."""
    if timeline.ends != "periodic":
        raise TimelineError(f"only a loop, with ends = 'periodic', can be repeated; these are '{timeline.ends}'")
    if count < 1:
        raise TimelineError(f"a loop is played at least once, not {count} times")
    seam, period = Seam.of(figure, timeline), timeline.times[-1] - timeline.times[0]
    frames = list(timeline.frames[:1])
    for number in range(count):
        states = seam.move(timeline.states[1:], number)
        frames += Frame.many(timeline.times[1:] + number * period, states, timeline.fixed[1:])
    return Timeline(tuple(frames), _jumps(timeline, seam, count), "periodic")


def _jumps(timeline: Timeline, seam: Seam, count: int) -> Array:
    """Return the jumps (2, N) of y' and y'' from the end of `count` periods to the start, see `Spline`."""
    start = path_of(timeline).motion(timeline.times[:1])[1:, 0]
    return seam.linear(start, count) - start


@dataclass(frozen=True, eq=False)
class Placement:
    """A rotation about the vertical and a translation of everything with free joints.

    Attributes:
        turn: The rotation about z, (4,) wxyz.
        shift: The translation after the rotation, (3,) [m].
    """

    turn: Array
    shift: Array

    def slopes(self, figure: Figure, rates: Array) -> Array:
        """Return the moved derivatives of states (..., N)."""
        out = rates.copy()
        for link in figure.links[1:]:
            if link.kind is JointKind.FREE:
                columns = slice(link.qpos, link.qpos + 3)
                out[..., columns] = quat.rotate(self.turn, rates[..., columns])
        in_world = figure.coordinates == "world"
        for i, columns in zip(figure.tables.quaternion_links, figure.tables.quaternion_columns.T, strict=True):
            if turning_root(figure, int(i), in_world=in_world):
                out[..., columns] = quat.product(self.turn, rates[..., columns])
        return out

    def states(self, figure: Figure, states: Array) -> Array:
        """Return moved states (..., N)."""
        out = self.slopes(figure, states)
        for columns in figure.tables.position_columns.T:
            out[..., columns] += self.shift
        return out

    def timeline(self, figure: Figure, timeline: Timeline) -> Timeline:
        frames = Frame.many(timeline.times, self.states(figure, timeline.states), timeline.fixed)
        return Timeline(tuple(frames), self.slopes(figure, timeline.end_slope), timeline.ends)


def heading(rotation: Array) -> Array:
    """Return the rotation about z in rotation matrices (..., 3, 3), without their shortest tilt, (...) [rad]."""
    sine, cosine = rotation[..., 1, 0] - rotation[..., 0, 1], rotation[..., 0, 0] + rotation[..., 1, 1]
    return np.where(np.hypot(sine, cosine) > ROUNDING, np.arctan2(sine, cosine), 0.0)


def following(figure: Figure, before: Timeline, after: Timeline, duration: float) -> Placement:
    """Return the placement that continues a motion with its trunk's heading and both motions' mean velocity. Objects
    keep their positions next to a figure without a free root, such as an arm on a base."""
    if not _moves_freely(figure):
        return Placement(np.array([1.0, 0, 0, 0]), np.zeros(3))
    place = figure.tables.position_columns[:, 0]
    (end, end_d), (start, start_d) = _side(before, -1), _side(after, 0)
    turn = quat.from_rotation_vector(_heading_between(figure, start, end) * np.array([0.0, 0.0, 1.0]))
    pace = (end_d[place] + quat.rotate(turn, start_d[place])) / 2
    shift = end[place] + pace * duration - quat.rotate(turn, start[place])
    return Placement(turn, shift * np.array([1.0, 1, 0]))


def _moves_freely(figure: Figure) -> bool:
    """Return whether the articulated tree has a free root, or everything that moves is a free object."""
    root = figure.root
    is_alone = all(link.kind is JointKind.FREE for link in figure.links[1:])
    return root is not None and (root.limbs > 0 or is_alone)


def _heading_between(figure: Figure, start: Array, end: Array) -> float:
    """Return the rotation about z from one state (N,) to another [rad], the mean of the trunk's links. In walking,
    pelvis and chest rotate against each other, alternately with each step."""
    rest = figure.to_state(np.array(figure.model.qpos0))
    states = np.stack([rest, start, end])
    rotations = np.moveaxis(Samples.still(figure, states).links.rotation, (2, 3), (0, 1))
    turned = rotations[:, 1:] @ rotations[:, :1].swapaxes(-1, -2)
    headings = heading(turned)
    between = (headings[:, 1] - headings[:, 0])[trunk(figure)]
    off = between - between[0]  # relative to the root's, which may be any number of turns
    return float(between[0] + np.mean(np.arctan2(np.sin(off), np.cos(off))))


def trunk(figure: Figure) -> list[int]:
    """Return the first free root, and the links at which limbs branch off and beyond which much of the mass is."""
    tables = figure.tables
    root = int(tables.free_links[0])
    hangs = tables.mass @ tables.path
    forks = (tables.children > 1) & (tables.path[:, root] > 0) & (hangs > OF_TRUNK * hangs[root])
    return [root, *(i for i in np.flatnonzero(forks).tolist() if i != root)]


def _side(timeline: Timeline, end: int) -> Array:
    """Return y and y' at the first (0) or the last (-1) frame, (2, N)."""
    return path_of(timeline).motion(timeline.times[[end]])[:2, 0]


def bridge(figure: Figure, before: Timeline, after: Timeline, *, variable: int = LEAST_FRAMES) -> Timeline:
    """Return the initial transition: y, y', y'' of both sides, and variable frames on the quintic between them.

    Args:
        after: The second motion, which begins later than the first ends, see `signed_like` for its quaternions' signs.

    Raises:
        TimelineError: There are too few frames, or the transition has no duration.
    """
    if variable < LEAST_FRAMES:
        raise TimelineError(f"a transition has at least {LEAST_FRAMES} variable frames, not {variable}")
    first, last = float(before.times[-1]), float(after.times[0])
    if not first < last:
        raise TimelineError(f"a transition takes time; it cannot go from {first:g} to {last:g} s")
    begin = path_of(before).motion(before.times[-1:])[:, 0]
    end = path_of(after).motion(after.times[:1])[:, 0]
    times = np.linspace(first, last, variable + 2)
    states = _quintic(begin, end, (times - first) / (last - first), last - first)
    fixed = np.zeros(states.shape, bool)
    fixed[[0, -1]] = True
    rough = Timeline(tuple(Frame.many(times, states, fixed)), np.array([begin[1], end[1]]), "held")
    # the frames next to the ends are determined by y''
    spline, rows, beside = path_of(rough).spline, np.array(rough.rows), [1, variable]
    missing = np.array([begin[2], end[2]]) - path_of(rough).at([first, last], 2)
    unit = np.zeros((spline.size, 2))
    unit[beside, [0, 1]] = 1
    rows[beside] += np.linalg.solve(spline.evaluate(unit, [first, last], 2), missing)
    return rough.with_rows(rows)


def _quintic(begin: Array, end: Array, u: Array, length: float) -> Array:
    """Return the polynomial of degree 5 with y, y', y'' (3, N) at both ends, at fractions u (S,) of its length [s]."""
    power = u[:, None] ** np.arange(6)
    ends = np.zeros((6, 6))
    for order in range(3):
        for degree in range(order, 6):
            factor = float(np.prod(np.arange(degree - order + 1, degree + 1)))
            ends[order, degree] = factor if degree == order else 0.0
            ends[3 + order, degree] = factor
    scale = length ** np.arange(3)[:, None]
    return power @ np.linalg.solve(ends, np.concatenate([begin * scale, end * scale]))


def signed_like(figure: Figure, before: Timeline, after: Timeline) -> Timeline:
    """Return a motion with quaternion signs such that joints take the shortest arcs from another motion's end."""
    end, start = before.states[-1], after.states[0]
    keys = [Frame.key(t, figure.to_qpos(state)) for t, state in ((0.0, end), (1.0, start))]
    raw = raw_timeline(figure, keys).states
    signs = sameness(figure, raw[0], end) * sameness(figure, raw[1], start)
    return after.with_rows(after.rows * signs)


def join(before: Timeline, between: Timeline, after: Timeline) -> Timeline:
    """Return one motion of three in sequence, with free ends. Each begins where the previous one ends."""
    frames = (*before.frames, *between.frames[1:-1], *after.frames)
    return Timeline(frames, np.array([before.end_slope[0], after.end_slope[1]]))
