"""The distance of a path from the optimum (appendix C, eqs. 32-34).

The reduction of E per time is approximately δ(t) · EL(t). δ is the distance between the path and a local optimum: each
segment is solved separately on a finer spline, with its position and velocity fixed at both ends.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.objective import Objective
from dynsplines.solver.refine.subdivision import residual

from .nearest import optimise

NODES = 6  # nodes per span of Gauss's rule
MOST_EVALUATIONS = 60  # of a segment's search


@dataclass(frozen=True)
class Displacement:
    """The displacement of every segment between neighbouring frames, (M − 1,) each.

    Attributes:
        distance: ∫ |Y_opt − Y_EL| dt (eq. 33).
        gap: ∫ δ(t) |EL(t)| dt, an upper estimate of the remaining reduction of E in the segment (eq. 32).
        reduction: The actual reduction of E by the local solve.
    """

    distance: Array
    gap: Array
    reduction: Array


def displacement(
    objective: Objective, timeline: Timeline, *, variable: int = 3, tolerance: float = 1e-7
) -> Displacement:
    """Return the displacement of every segment, by a local solve of each.

    Args:
        objective: E.
        variable: The number of variable frames inside each segment.
        tolerance: Relative progress at which a solve ends.
    """
    path = path_of(timeline)
    local_objective = replace(objective, quadrature=replace(objective.quadrature, kind="gauss", points=5))
    strength = residual(objective, path)
    rows = []
    for i, (a, b) in enumerate(zip(timeline.times[:-1], timeline.times[1:], strict=True)):
        local = _segment(path, float(a), float(b), variable)
        better = optimise(local_objective, local, max_evaluations=MOST_EVALUATIONS, tolerance=tolerance)
        t, w = gauss_nodes(np.array([a, b]), NODES)
        delta = np.linalg.norm(path.at(t) - path_of(better).at(t), axis=1)
        level = np.interp(t, strength.t[i], strength.size[i])
        saved = local_objective.value(path_of(local)) - local_objective.value(path_of(better))
        rows.append((w @ delta, w @ (delta * level), saved))
    distance, gap, decrease = np.array(rows).T
    return Displacement(distance, gap, decrease)


def _segment(path: Path, first: float, last: float, variable: int) -> Timeline:
    """Return one segment as a clip with fixed positions and velocities at its ends and frames on the curve."""
    states, slopes = path.at(np.array([first, last])), path.at(np.array([first, last]), 1)
    ends = (Frame.key(first, states[0]), Frame.key(last, states[1]))
    inner = np.linspace(first, last, variable + 2)[1:-1]
    frames = [Frame.variable(t, y) for t, y in zip(inner, path.at(inner), strict=True)]
    return Timeline(ends, slopes, "clamped").insert(frames)
