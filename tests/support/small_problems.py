"""Small problems as the search sees them: discretised, in unknowns."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from dense_hessian import tiny_clip
from even_frames import evenly
from every_penalty import clip
from figures import ONE_BALL, TINY, figure_of

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Discretised, Evaluation, Objective
from dynsplines.solver.penalty import (
    CovariantAcceleration,
    Penalty,
    RootAcceleration,
    Torque,
    UnitMagnitude,
)
from dynsplines.solver.search.minimum import Minimum
from dynsplines.solver.search.nlopt_methods import minimise


def turning(turns: list[float], variable: int) -> tuple[Objective, Timeline]:
    """One ball joint turned about a slanted axis by so many degrees from keyframe to keyframe."""
    figure = figure_of(ONE_BALL)
    axis = np.array([0.6, 0, 0.8])
    poses = [quat.from_rotation_vector(np.radians(angle) * axis) for angle in np.cumsum([0, *turns])]
    raw = raw_timeline(figure, [Frame.key(float(i), pose) for i, pose in enumerate(poses)])
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 10.0)])
    return objective.renormalised(path_of(raw)), evenly(raw, variable)


TERMS: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (UnitMagnitude(), 0.5),
    (RootAcceleration(), 1.0),
    (Torque(), 0.5),
]


def problem_of(rng: np.random.Generator, ends: str = "free", coordinates: str = "world", terms=TERMS) -> Discretised:
    raw = tiny_clip(rng, ends, coordinates, partial=True)
    objective = Objective.of(figure_of(TINY, coordinates), terms).renormalised(path_of(raw))
    return objective.on(evenly(raw, 1))


def discretised(figure: Figure, rng: np.random.Generator, ends: str):
    timeline = clip(figure, rng, ends)
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0)])
    return objective.renormalised(path_of(timeline)).on(evenly(timeline, 2))


def slider(times: np.ndarray, variable: int):
    """One slide under its acceleration energy, the flat case."""
    figure = figure_of('<mujoco><worldbody><body><joint type="slide"/><geom size=".1"/></body></worldbody></mujoco>')
    keys = [Frame.key(t, [np.sin(3 * t)]) for t in times]
    raw = raw_timeline(figure, keys)
    return Objective.of(figure, [(RootAcceleration(), 1.0)]).renormalised(path_of(raw)).on(evenly(raw, variable))


class Watched(Discretised):
    """Counts its evaluations; `spoil` may change what the k-th gives, or raise."""

    def __init__(self, problem: Discretised, spoil: Callable[[int, Evaluation], Evaluation] | None = None) -> None:
        super().__init__(problem.objective, problem.timeline)
        self.values: list[float] = []
        self.points: list[Array] = []
        self.spoil = spoil

    def __call__(self, x: Array) -> Evaluation:
        evaluation = super().__call__(x)
        if self.spoil is not None:
            evaluation = self.spoil(len(self.values) + 1, evaluation)
        self.values.append(evaluation.value)
        self.points.append(x.copy())
        return evaluation


def by_nlopt(
    problem: Discretised, *, method: str = "lbfgs", max_evaluations: int = 5000, tolerance: float = 1e-13
) -> Minimum:
    """By E and its gradient in the unknowns, without any model."""

    def fun(x: Array) -> tuple[float, Array]:
        evaluation = problem(x)
        return evaluation.value, evaluation.gradient

    start = problem.unknowns.start
    return minimise(fun, start, method=method, max_evaluations=max_evaluations, tolerance=tolerance)
