"""A loop that hops on, and turns while it does."""

from __future__ import annotations

import numpy as np
from even_frames import evenly
from every_penalty import every_penalty
from random_keys import mask_without
from taylor import taylor_slope

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration, Penalty, RootAcceleration, Torque, UnitMagnitude
from dynsplines.solver.refine.subdivision import split

PERIOD, STRIDE = 0.8, 0.6
TIMES = [0.0, 0.3, 0.5, PERIOD]
TERMS: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (RootAcceleration(), 1.0),
    (UnitMagnitude(), 1.0),
    (Torque(), 0.5),
]


def pose(time: float, turns: int = 0) -> Array:
    """qpos of a body that hops along x while its shin swings; with `turns`, it also turns about a slant axis."""
    a = 2 * np.pi * time / PERIOD
    root = [STRIDE * time / PERIOD + 0.1 * np.sin(a), 0.05 * np.sin(a), 1 + 0.03 * np.cos(2 * a)]
    sway = quat.from_rotation_vector([0.2 * np.sin(a), 0.1 * np.cos(a), 0.3 * np.sin(a + 1)])
    turn = quat.product(quat.from_rotation_vector(turns * a * np.array([0.6, 0, 0.8])), sway)
    return np.concatenate([root, turn, quat.from_rotation_vector([0, 0.6 + 0.5 * np.sin(a), 0.1 * np.cos(a)])])


def hop(periods: int = 1, turns: int = 0) -> list[Frame]:
    """Keyframes of some periods."""
    times = [0.0] + [t + PERIOD * k for k in range(periods) for t in TIMES[1:]]
    return [Frame.key(t, pose(t, turns)) for t in times]


def loop(figure: Figure, turns: int, *, partial: bool) -> Timeline:
    keys = hop(turns=turns)
    if partial:
        free = "knee" if turns else "root turn"  # without its turn at a third, a full turn would be none
        keys[1] = Frame.key(TIMES[1], keys[1].state, mask_without(figure, free, "root x"))
        keys[-1] = Frame.key(PERIOD, keys[-1].state, mask_without(figure, "root z", "knee"))
    return raw_timeline(figure, keys, "periodic")


def assert_exact_gradient(raw: Timeline, figure: Figure, rng: np.random.Generator) -> None:
    """Of all penalties together on a loop, by Taylor's slope; and that unknowns pull back what they push forward."""
    objective = Objective.of(figure, every_penalty(figure)).renormalised(path_of(raw))
    problem = objective.on(evenly(raw, 1))
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.9
    g = rng.normal(size=(problem.spline.size, figure.width))
    linear = problem.unknowns.rows(x) - problem.unknowns.rows(0 * x)
    np.testing.assert_allclose(np.sum(g * linear), problem.unknowns.pulled_back(g) @ x, rtol=1e-11, atol=1e-11)


def assert_splits_keep_the_curve(timeline: Timeline) -> Timeline:
    """With its derivatives; the loop with frames put in."""
    finer = split(timeline, np.array([0.02, 0.41, 0.79]))
    t = np.linspace(0, PERIOD, 101)
    for order in range(3):
        np.testing.assert_allclose(path_of(finer).at(t, order), path_of(timeline).at(t, order), atol=1e-9)
    return finer
