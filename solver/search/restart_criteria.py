"""Restart criteria, which detect that a search ended in a poor local minimum.

A minimum is poor if violations cost more than the motion itself, or if a limb is far from its path between the
neighbouring keyframes. A limb that starts on the wrong side of a bound, such as behind its own knee, cannot cross the
bound. The search therefore restarts from another path, see `curve.arcs`. Another criterion is a high cost of motion,
for instance of a detour round the long side of an obstacle.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..array import Array
from ..curve.arcs import straight
from ..curve.frame import Timeline
from ..curve.spline import Path, path_of
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..objective import Objective
from ..penalty import Guide, Role

COST_RATIO = 2.0  # [1] cost relative to the raw spline, above which a shorter route round an obstacle may exist
MAX_DEVIATION = 0.5  # [1] relative to the distance from the figure's root to its farthest joint at rest
MAX_QUATERNION_LENGTH = 2.0  # [1] norm above which a search no longer shortens a quaternion
SAMPLES_PER_SEGMENT = 4  # between neighbouring frames with specified degrees of freedom


def is_poor_minimum(objective: Objective, timeline: Timeline, parts: Mapping[str, float]) -> bool:
    """Return whether a search should restart from another path.

    Args:
        objective: E, renormalised by the raw path.
        parts: The terms of E there, by name.
    """
    figure = objective.figure
    return (
        violation_dominates(objective, parts)
        or is_pose_outlier(objective, timeline)
        or longest_quaternion(figure, timeline) > MAX_QUATERNION_LENGTH
    )


def is_pose_outlier(objective: Objective, timeline: Timeline) -> bool:
    """Return whether a limb is far from its path between neighbouring keyframes, or from a term's expected path."""
    guides = [term.penalty for term in objective.terms if isinstance(term.penalty, Guide)]
    expected = next((guide.expected for guide in guides if guide.expected is not None), None)
    return largest_deviation(objective.figure, timeline, expected) > MAX_DEVIATION


def violation_dominates(objective: Objective, parts: Mapping[str, float]) -> bool:
    """Return whether violations cost more than the motion, both here and on the raw spline.

    Violations of physics do not count. The times of keyframes may make them inevitable, on any path.
    """
    bounds = {
        term.penalty.name
        for term in objective.terms
        if term.penalty.normalization.is_violation and term.penalty.role is not Role.PHYSICS
    }
    violated = sum(value for name, value in parts.items() if name in bounds)
    return violated > max(sum(parts.values()) - violated, objective.raw_cost)


def cost_increased(objective: Objective, parts: Mapping[str, float]) -> bool:
    """Return whether motion and contact with obstacles cost more than COST_RATIO times the raw spline.

    Without obstacles the result is False: feet that must clear the floor or a step cost as much on any route.
    """
    obstacles = {term.penalty.name for term in objective.terms if term.penalty.obstructs}
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
