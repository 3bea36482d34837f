"""Restarts of a search: criteria of a poor local minimum, and the best timeline of several searches.

A minimum is poor if violations cost more than the motion itself. It also is, with smaller violations, if a limb is far
from its path between the neighbouring keyframes. A limb that starts on the wrong side of a bound, such as behind its
own knee, cannot cross the bound. The search therefore restarts from another path, see `curve.raw`. Another criterion
is a high cost of motion, for instance of a detour round the long side of an obstacle.

A search sums E over samples between its own frames. Its path may violate a sharp term between these samples: a knee can
pass through its own lower leg within one span. The sharpest case is a quaternion whose four components pass close to
zero, where the joint turns by half a turn in a moment. E is therefore compared on samples common to all timelines, with
more samples around every such moment, at distances proportional to its duration.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..array import ENTRIES_AT_ONCE, Array, Index
from ..curve.frame import Timeline
from ..curve.quadrature import Quadrature
from ..curve.raw import straight
from ..curve.spline import Path, path_of
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..objective import Objective
from ..penalty import Guide, Role
from ..tolerances import ROUNDING, SINGLE

NOTABLE = 0.02  # [1] share of violations in E from which a limb far from its path may be on the wrong side of a bound
COST_RATIO = 2.0  # [1] cost relative to the raw spline, above which a shorter route round an obstacle may exist
MAX_DEVIATION = 0.5  # [1] relative to the distance from the figure's root to its farthest joint at rest
MAX_QUATERNION_LENGTH = 2.0  # [1] norm above which a search no longer shortens a quaternion
SAMPLES_PER_SEGMENT = 4  # between neighbouring frames with specified degrees of freedom
SUBDIVISIONS = 3  # parts of each span between the frames of all timelines
SAMPLES_PER_SPAN = 32  # samples between two frames, to detect short quaternions
SHORT = 0.1  # norm of a quaternion below which its joint turns fast
MIN_DURATION = 1e-4  # [1] shortest moment that is resolved, relative to the time between two samples
OFFSETS = np.array([-10, -3, -1, -0.3, 0, 0.3, 1, 3, 10])  # [1] offsets of added samples, in durations of the moment


def is_poor_minimum(objective: Objective, timeline: Timeline, parts: Mapping[str, float]) -> bool:
    """Return whether a search should restart from another path.

    Args:
        objective: E, renormalised by the raw path.
        parts: The terms of E there, by name.
    """
    is_violated = violation_of(objective, parts) > NOTABLE * sum(parts.values())
    return (
        violation_dominates(objective, parts)
        or (is_violated and is_pose_outlier(objective, timeline))
        or longest_quaternion(objective.figure, timeline) > MAX_QUATERNION_LENGTH
    )


def is_pose_outlier(objective: Objective, timeline: Timeline) -> bool:
    """Return whether a limb is far from its path between neighbouring keyframes, or from a term's expected path."""
    guides = [term.penalty for term in objective.terms if isinstance(term.penalty, Guide)]
    expected = next((guide.expected for guide in guides if guide.expected is not None), None)
    return largest_deviation(objective.figure, timeline, expected) > MAX_DEVIATION


def violation_dominates(objective: Objective, parts: Mapping[str, float]) -> bool:
    """Return whether violations cost more than the motion, both here and on the raw spline."""
    violated = violation_of(objective, parts)
    return violated > max(sum(parts.values()) - violated, objective.raw_cost)


def violation_of(objective: Objective, parts: Mapping[str, float]) -> float:
    """Return the cost of violations.

    Violations of physics, and deviations from an expected path, do not count. The times of keyframes may make them
    inevitable, on any path.
    """
    bounds = {
        term.penalty.name
        for term in objective.terms
        if term.penalty.role.is_violation
        and term.penalty.role is not Role.PHYSICS
        and not isinstance(term.penalty, Guide)
    }
    return sum(value for name, value in parts.items() if name in bounds)


def cost_increased(objective: Objective, parts: Mapping[str, float]) -> bool:
    """Return whether motion and contact with obstacles cost more than COST_RATIO times the raw spline.

    Without obstacles the result is False: feet that must clear the floor or a step cost as much on any route.
    """
    obstacles = {term.penalty.name for term in objective.terms if term.penalty.role is Role.OBSTACLE}
    counted = obstacles | {term.penalty.name for term in objective.raw_normalized}
    cost = sum(value for name, value in parts.items() if name in counted)
    return bool(obstacles) and cost > COST_RATIO * objective.raw_cost


def largest_deviation(figure: Figure, timeline: Timeline, expected: Path | None = None) -> float:
    """Return the largest distance of a joint from a reference path, relative to the figure's size.

    Distances are between positions relative to the root of the joint's tree, so that the root's travel is ignored.

    Args:
        expected: The reference path; None: the straight path between frames with specified degrees of freedom.
    """
    fixed = np.flatnonzero(timeline.fixed.any(axis=1))
    size = float(np.linalg.norm(_from_root(figure, figure.to_state(figure.model.qpos0[None])), axis=0).max())
    if fixed.size < 2 or size == 0:
        return 0.0
    times = timeline.times[fixed]
    t = _inner_times(times)
    reference = straight(figure, times, timeline.states[fixed], t) if expected is None else expected.at(t)
    deviation = _from_root(figure, path_of(timeline).at(t)) - _from_root(figure, reference)
    return float(np.linalg.norm(deviation, axis=0).max()) / size


def longest_quaternion(figure: Figure, timeline: Timeline) -> float:
    """Return the largest norm of a quaternion, sampled between frames. Rotations have norm 1."""
    quaternions = path_of(timeline).at(_inner_times(timeline.times))[:, figure.tables.quaternion_columns]
    return float(np.linalg.norm(quaternions, axis=1).max(initial=0.0))


def _inner_times(times: Array) -> Array:
    """Return SAMPLES_PER_SEGMENT times [s] inside every segment between rising times (K,) [s]."""
    share = (np.arange(SAMPLES_PER_SEGMENT) + 0.5) / SAMPLES_PER_SEGMENT
    return (times[:-1, None] + share * np.diff(times)[:, None]).ravel()


def _from_root(figure: Figure, states: Array) -> Array:
    """Return the positions (3, L − 1, S) [m] of the links' origins relative to the first link of their tree."""
    places = Samples.still(figure, states).links.x[:, 1:]
    root = np.arange(len(figure.links))
    for i, parent in enumerate(figure.tables.parents):
        if i and parent:
            root[i] = root[parent]
    return places - places[:, root[1:] - 1]


def select_best(objective: Objective, timelines: Sequence[Timeline]) -> Timeline:
    """Return the timeline of least E.

    Args:
        objective: E.
        timelines: Timelines of one clip; the first of several that are equally good is returned.
    """
    if len(timelines) == 1:
        return timelines[0]
    is_uneven = objective.quadrature.kind == "gauss"  # uniform samples as dense as those would be a million
    times = common_grid(timelines, objective.figure.tables.quaternion_columns.T if is_uneven else ())
    objective = _summable(objective, times)
    values = [objective.value(path_of(timeline), times) for timeline in timelines]
    values = [value if np.isfinite(value) else np.inf for value in values]
    bound = min(values) * (1 + SINGLE)
    return next(timeline for timeline, value in zip(timelines, values, strict=True) if value <= bound)


def is_resolved(figure: Figure, timeline: Timeline) -> bool:
    """Return whether E of a timeline needs no more samples: no quaternion of its path is short, see the module."""
    return not any(True for _ in _flips(timeline, figure.tables.quaternion_columns.T))


def _summable(objective: Objective, times: Array) -> Objective:
    """Return the objective, with Gauss's rule if uniform samples in such short spans would be too many."""
    try:
        objective.quadrature.nodes(times)
    except ValueError:
        return replace(objective, quadrature=Quadrature())
    return objective


def common_grid(timelines: Sequence[Timeline], quaternions: Sequence[Index] | Index = ()) -> Array:
    """Return the edges [s] of spans that are finer than those of any of the timelines.

    Args:
        quaternions: The columns (4,) of each quaternion to sample around moments at which it is short.
    """
    edges = np.concatenate([timeline.times for timeline in timelines])
    flips = [flip for timeline in timelines for flip in _flips(timeline, quaternions)]
    edges = np.unique(np.concatenate([edges, *flips]))
    edges = edges[np.append(True, np.diff(edges) > ROUNDING)]
    share = np.arange(SUBDIVISIONS) / SUBDIVISIONS
    return np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])


def _flips(timeline: Timeline, quaternions: Sequence[Index] | Index) -> Iterator[Array]:
    """Yield times [s] around every moment at which a quaternion of the path is short."""
    if not len(quaternions):
        return
    path, edges = path_of(timeline), timeline.times
    at_once = max(1, ENTRIES_AT_ONCE // (SAMPLES_PER_SPAN * path.coefficients.shape[1]))
    for first in range(0, edges.size - 1, at_once):
        for times in _flips_between(path, edges[first : first + at_once + 1], quaternions):
            yield times[(times > edges[0]) & (times < edges[-1])]


def _flips_between(path: Path, edges: Array, quaternions: Sequence[Index] | Index) -> Iterator[Array]:
    """Yield these times between neighbouring edges [s], with each quaternion linear between two samples of the path."""
    share = np.arange(SAMPLES_PER_SPAN) / SAMPLES_PER_SPAN
    times = np.append((edges[:-1, None] + share * np.diff(edges)[:, None]).ravel(), edges[-1])
    q, step = path.at(times)[:, quaternions], np.diff(times)
    change = np.diff(q, axis=0)
    squared = np.maximum(np.einsum("ikj,ikj->ik", change, change), np.finfo(float).tiny)
    share = np.clip(-np.einsum("ikj,ikj->ik", q[:-1], change) / squared, 0, 1)
    nearest = q[:-1] + share[..., None] * change
    length = np.sqrt(np.einsum("ikj,ikj->ik", nearest, nearest))
    for i, k in np.argwhere(length < SHORT):
        duration = np.clip(length[i, k] / np.sqrt(squared[i, k]), MIN_DURATION, 1) * step[i]
        yield times[i] + share[i, k] * step[i] + OFFSETS * duration
