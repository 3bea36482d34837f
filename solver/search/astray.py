"""Whether a search ended in a heap: constraints cost more than all motion does, or a limb is far from where its
neighbouring keyframes have it. A limb that begins on the wrong side of a bound, behind its own knee, does not come
back through it; it is searched again from elsewhere, see `arcs`. And whether it came out dear: perhaps the long way
round an obstacle.
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
from ..penalty import Guide

DEAR = 2.0  # times what motion cost on the raw spline: from here on another way round an obstacle may be less
FAR = 0.5  # of a figure's size, its farthest joint at rest from its root
LONG = 2.0  # length of a quaternion that no search leaves: from here on a path begins too far out
LOOKS = 4  # a segment between frames of which something is fixed


def is_astray(objective: Objective, timeline: Timeline, parts: Mapping[str, float]) -> bool:
    """Whether a timeline that was searched should not be the last word; `parts` are the terms of its E by name."""
    figure = objective.figure
    return is_violent(objective, parts) or is_far(objective, timeline) or longest(figure, timeline) > LONG


def is_far(objective: Objective, timeline: Timeline) -> bool:
    """Whether a limb is far from where its neighbouring keyframes have it, or from a path that a term expects."""
    guides = [term.penalty for term in objective.terms if isinstance(term.penalty, Guide)]
    expected = next((guide.expected for guide in guides if guide.expected is not None), None)
    return farthest(objective.figure, timeline, expected) > FAR


def is_violent(objective: Objective, parts: Mapping[str, float]) -> bool:
    """Whether what constraints cost exceeds what motion costs and what motion cost on the raw spline."""
    bounds = {term.penalty.name for term in objective.terms if term.penalty.normalization.is_violation}
    violated = sum(value for name, value in parts.items() if name in bounds)
    return violated > max(sum(parts.values()) - violated, objective.raw_cost)


def is_dear(objective: Objective, parts: Mapping[str, float]) -> bool:
    """Whether motion costs more than twice what it cost on the raw spline, where there is something to go round:
    feet that must come off the floor or on a step cost as much whichever way they are searched."""
    measured = {term.penalty.name for term in objective.measured}
    cost = sum(value for name, value in parts.items() if name in measured)
    return cost > DEAR * objective.raw_cost and any(term.penalty.obstructs for term in objective.terms)


def farthest(figure: Figure, timeline: Timeline, expected: Path | None = None) -> float:
    """How far a joint is off a path that is expected, or else off the straight way between frames of which something is
    fixed, seen from its root, beside the figure's size."""
    given = np.flatnonzero(timeline.fixed.any(axis=1))
    if given.size < 2:
        return 0.0
    times = timeline.times[given]
    t = _looks(times)
    there = straight(figure, times, timeline.states[given], t) if expected is None else expected.at(t)
    apart = _from_root(figure, path_of(timeline).at(t)) - _from_root(figure, there)
    size = float(np.linalg.norm(_from_root(figure, figure.to_state(figure.model.qpos0[None])), axis=0).max())
    return float(np.linalg.norm(apart, axis=0).max()) / size if size > 0 else 0.0


def longest(figure: Figure, timeline: Timeline) -> float:
    """The longest quaternion between frames, seen LOOKS times in every segment."""
    quaternions = path_of(timeline).at(_looks(timeline.times))[:, figure.tables.quaternion_columns]
    return float(np.linalg.norm(quaternions, axis=1).max(initial=0.0))


def _looks(times: Array) -> Array:
    """Where one looks between times (K,) that rise, LOOKS times in every segment."""
    share = (np.arange(LOOKS) + 0.5) / LOOKS
    return (times[:-1, None] + share * np.diff(times)[:, None]).ravel()


def _from_root(figure: Figure, states: Array) -> Array:
    """(3, L − 1, S) [m] the links' origins beside that of the first link of their tree."""
    places = Samples.still(figure, states).links.x[:, 1:]
    root = np.arange(len(figure.links))
    for i, parent in enumerate(figure.tables.parents):
        if i and parent:
            root[i] = root[parent]
    return places - places[:, root[1:] - 1]
