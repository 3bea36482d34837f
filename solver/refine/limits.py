"""Hard joint ranges: projection of a path into the ranges at all times, with the least added acceleration.

A spline is linear in its rows. A deviation of one joint that keeps its values within bounds at many times is therefore
a convex problem: min ∫ a''² dt subject to low ≤ y + B a ≤ high. This is Lawson and Hanson's least distance programming
(Solving Least Squares Problems, 1974, ch. 23), solved by non-negative least squares. Keyframes do not move. If one is
on a bound, adjacent variable frames make the path tangent to it. A ball joint deviates along its angle, in a few steps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array
from ..curve.frame import Timeline
from ..curve.spline import path_of, spline_of
from ..figure.figure import Figure, JointKind, quaternion_columns
from ..figure.kinematics import Samples
from ..penalty.joints.joint_range import JointRange, Range
from .subdivision import split

RATE = 2000.0  # [1/s] sampling rate at which a path is compared with its bounds
ROUNDS = 12  # maximum number of projections
BEYOND = {JointKind.SLIDE: 2e-5}  # [m] tolerance of slides
TURNED = float(np.radians(0.02))  # [rad] tolerance of hinges and balls
LEEWAY = 1.5  # [1] multiple of the tolerance above which a joint is moved back
AROUND = 0.25  # [s] before and after a violation in which frames move
BRIEF, CLOSEST = 0.01, 0.004  # [s] minimum length of a violation for placing frames, and minimum spacing of these
FAINT = 1e-9  # [1] regularisation relative to the mean squared acceleration of a row
REACHED = 4  # frames on each side of a moved frame within which the spline is checked
RUN = 1000  # samples evaluated at once


@dataclass(frozen=True)
class _Violation:
    """A joint beyond its bounds in one or more intervals `spans`, (first, last) [s], which are close to each other."""

    joint: Range
    spans: tuple[tuple[float, float], ...]

    @property
    def reach(self) -> tuple[float, float]:
        """The interval in which frames move, (first, last) [s]."""
        return self.spans[0][0] - AROUND, self.spans[-1][1] + AROUND


def limited(figure: Figure, timeline: Timeline, joints: Sequence[Range]) -> Timeline:
    """Return the timeline with joints within their bounds at all times; variable frames are added if necessary.

    Bounds that cannot be met, because keyframes are beyond them or too close in time, are met as far as possible.
    """
    if timeline.ends == "held":
        return timeline
    for _ in range(ROUNDS):
        violations = list(_violations(figure, timeline, joints))
        if not violations:
            break
        timeline = _refined(timeline, violations)
        for violation in violations:
            timeline = _moved_back(figure, timeline, violation)
    return timeline


def farthest(figure: Figure, timeline: Timeline, joints: Sequence[Range]) -> list[tuple[Range, float, float]]:
    """Return joints that exceed their bounds beyond tolerance, with the largest excess [rad, m] and its time [s]."""
    excesses, t = [], _dense(timeline)
    for joint in joints:
        value = _values(figure, timeline, joint, t)
        over = np.maximum(joint.low - value, value - joint.high)
        worst = int(over.argmax())
        if over[worst] > LEEWAY * _tolerance(joint):
            excesses.append((joint, float(over[worst]), float(t[worst])))
    return excesses


def _dense(timeline: Timeline) -> Array:
    first, last = timeline.times[[0, -1]]
    return np.unique(np.append(np.linspace(first, last, int(np.ceil((last - first) * RATE)) + 1), timeline.times))


def _tolerance(joint: Range) -> float:
    return BEYOND.get(joint.kind, TURNED)


def _values(figure: Figure, timeline: Timeline, joint: Range, t: Array) -> Array:
    """Return the coordinate of a hinge or slide at times t, or a ball joint's angle, (T,) [rad, m]."""
    path = path_of(timeline)
    if joint.kind is not JointKind.BALL:
        return path.at(t)[:, figure.links[joint.link].qpos + joint.column]
    range_penalty = JointRange((joint,))
    parts = [t[first : first + RUN] for first in range(0, t.size, RUN)]
    beyond = [range_penalty.beyond(Samples.still(figure, path.at(part), t=part))[0] for part in parts]
    return np.concatenate(beyond) + joint.high


def _violations(figure: Figure, timeline: Timeline, joints: Sequence[Range]) -> Iterator[_Violation]:
    t = _dense(timeline)
    for joint in joints:
        value, tolerance = _values(figure, timeline, joint, t), LEEWAY * _tolerance(joint)
        over = np.maximum(joint.low - value, value - joint.high) > tolerance
        at = np.flatnonzero(over)
        for cluster in np.split(at, np.flatnonzero(np.diff(t[at]) > 2 * AROUND) + 1) if at.size else ():
            stretches = np.split(cluster, np.flatnonzero(np.diff(cluster) > 1) + 1)
            spans = [(float(t[max(one[0] - 1, 0)]), float(t[min(one[-1] + 1, t.size - 1)])) for one in stretches]
            yield _Violation(joint, tuple(spans))


def _refined(timeline: Timeline, violations: Sequence[_Violation]) -> Timeline:
    first, last = timeline.times[[0, -1]]
    times = timeline.times.tolist()
    new: list[float] = []
    for begin, end in (span for violation in violations for span in violation.spans):
        length, middle = max(end - begin, BRIEF), 0.5 * (begin + end)
        apart = max(CLOSEST, length / 8)
        for share in (0.0, -0.5, 0.5, -1.0, 1.0, -1.5, 1.5):
            t = middle + share * length
            if first + apart < t < last - apart and min(abs(t - other) for other in (*times, *new)) > apart:
                new.append(t)
    return split(timeline, np.array(sorted(new))) if new else timeline


def _moved_back(figure: Figure, timeline: Timeline, violation: _Violation) -> Timeline:
    """Return the timeline with one joint moved into its bounds around a violation; unchanged if no frame can move."""
    joint = violation.joint
    link = figure.links[joint.link]
    start = link.qpos + joint.column + (3 if joint.kind is JointKind.BALL and link.kind is JointKind.FREE else 0)
    unit = _cardinal(timeline, start, violation)
    if not unit.shape[1]:
        return timeline
    spline, t = spline_of(timeline), _check_times(timeline, unit)
    value, tolerance, cardinal = _values(figure, timeline, joint, t), _tolerance(joint), spline.evaluate(unit, t)
    over = value - joint.high - tolerance
    under = np.full(t.size, -np.inf) if joint.kind is JointKind.BALL else joint.low - tolerance - value
    outside = (t < violation.reach[0]) | (t > violation.reach[1])  # where other violations are
    least = np.concatenate([under, over])
    least = np.where(np.tile(outside, 2), np.minimum(least, 0), least)
    is_bounded = np.isfinite(least)
    amounts = _least(spline.evaluate(unit, t, 2), np.concatenate([cardinal, -cardinal])[is_bounded], least[is_bounded])
    if amounts is None:
        return timeline
    deviation = unit @ amounts
    if joint.kind is JointKind.BALL:
        return _turned_back(figure, timeline, joint, deviation)
    moved = np.array(timeline.rows)
    moved[:, start] += deviation
    return timeline.with_rows(moved)


def _check_times(timeline: Timeline, unit: Array) -> Array:
    """Return the times (T,) [s] at which a joint is compared with its bounds: the interval that moved rows affect."""
    frames, times = np.flatnonzero(unit[:-2].any(axis=1)), timeline.times
    begin = 0 if unit[-2].any() or not frames.size else max(frames[0] - REACHED, 0)
    end = times.size - 1 if unit[-1].any() or not frames.size else min(frames[-1] + REACHED, times.size - 1)
    inner = np.linspace(times[begin], times[end], int(np.ceil((times[end] - times[begin]) * RATE / 2)) + 2)
    return np.unique(np.append(inner, times[begin : end + 1]))


def _cardinal(timeline: Timeline, column: int, violation: _Violation) -> Array:
    """Return unit changes of the rows that may move around a violation, (M + 2, n). These rows are frames in which the
    column is free, and slopes at free ends."""
    times, count = timeline.times, len(timeline.frames)
    begin, end = violation.reach
    free = ~timeline.fixed[:, column] & (times > begin) & (times < end)
    rows: list[list[int]] = [[k] for k in np.flatnonzero(free).tolist()]
    if timeline.ends == "periodic":  # the last frame repeats the first
        rows = [row for row in rows if row[0] not in (0, count - 1)]
        if free[[0, -1]].any() and not timeline.fixed[[0, -1], column].any():
            rows.append([0, count - 1])
    near = begin < times[0], end > times[-1]
    rows += [[count + side] for side in (0, 1) if near[side] and timeline.free_slopes[side]]
    unit = np.zeros((count + 2, len(rows)))
    for k, row in enumerate(rows):
        unit[row, k] = 1.0
    return unit


def _least(bend: Array, rows: Array, least: Array) -> Array | None:
    """Return the deviation a (n,) of least ∫ a''² with rows (C, n) a ≥ least (C,); None if bounds are infeasible."""
    from scipy.optimize import nnls  # imported here: slow to load, used by hard ranges alone

    square = bend.T @ bend / len(bend)
    square += FAINT * np.trace(square) / max(len(square), 1) * np.eye(len(square))
    try:
        upper = np.linalg.cholesky(square).T
    except np.linalg.LinAlgError:
        return None
    near = np.linalg.solve(upper.T, rows.T)
    sizes = np.maximum(np.linalg.norm(near, axis=0), 1e-12)
    binding = np.flatnonzero((least > 0) | (np.linalg.norm(rows, axis=1) > 1e-9))
    system = np.concatenate([near[:, binding] / sizes[binding], (least[binding] / sizes[binding])[None]])
    target = np.append(np.zeros(len(square)), 1.0)
    try:
        weights, distance = nnls(system, target, maxiter=20 * system.shape[1])
    except RuntimeError:
        return None
    residual = system @ weights - target
    if distance < 1e-9 or abs(residual[-1]) < 1e-12:
        return None
    return np.asarray(np.linalg.solve(upper, -residual[:-1] / residual[-1]))


def _turned_back(figure: Figure, timeline: Timeline, joint: Range, deviation: Array) -> Timeline:
    """Return the timeline with a changed angle of a ball joint. Descendant links rotate with it.

    Args:
        deviation: Changes of the angle at the frames [rad] and of its rates at both ends [rad/s], (M + 2,).
    """
    columns = quaternion_columns(figure.links[joint.link])
    assert columns is not None, "a joint with a rotation"
    rows, moved = np.array(timeline.rows), np.flatnonzero(deviation[:-2])
    qpos = figure.to_qpos(rows[moved])
    home = np.array([1.0, 0, 0, 0] if joint.home is None else joint.home)
    turn = quat.rotation_vector(quat.product(quat.inverse(home), qpos[:, columns]))
    angle = np.linalg.norm(turn, axis=1, keepdims=True)
    turn *= 1 + deviation[:-2][moved, None] / np.maximum(angle, 1e-9)
    qpos[:, columns] = quat.product(home, quat.from_rotation_vector(turn))
    states = figure.to_state(qpos)
    for quaternion in figure.tables.quaternion_columns.T:
        length = np.linalg.norm(rows[moved][:, quaternion], axis=1)
        sign = np.where(np.sum(states[:, quaternion] * rows[moved][:, quaternion], axis=1) < 0, -1, 1)
        states[:, quaternion] *= (sign * length)[:, None]
    rows[moved] = states
    for end, frame in ((-2, 0), (-1, len(timeline.frames) - 1)):
        if deviation[end]:
            _turn_slope(figure, rows, joint, frame, end, float(deviation[end]))
    return timeline.with_rows(rows)


def _turn_slope(figure: Figure, rows: Array, joint: Range, frame: int, end: int, rate: float) -> None:
    """Add a rate of a ball joint's angle [rad/s] to the slope at an end, in place."""
    samples, tables = Samples.still(figure, rows[[frame]]), figure.tables
    axis = JointRange((joint,)).axes(samples)[:, 0, 0]
    under = np.flatnonzero(tables.path[:, joint.link] > 0)
    for i in under.tolist():
        columns = quaternion_columns(figure.links[i])
        if columns is None or not (tables.in_world[i] or i == joint.link):
            continue
        spin = rate * axis
        if not tables.in_world[i]:
            base = quat.product(samples.links.Q[:, tables.parents[i], 0], tables.turn[:, i])
            spin = quat.rotated(quat.inverse(base), spin)
        rows[end, columns] += 0.5 * quat.product(np.append(0.0, spin), rows[frame, columns])
