"""The solver against the exact covariant interpolation, and the Euler-Lagrange formulas against independent ones."""

from functools import cache

import numpy as np
import pytest
from exact_path import ExactPath, exact_path
from figures import ONE_BALL, figure_of
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import CovariantAcceleration, UnitMagnitude
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.solution import Solution

EVEN = np.arange(7.0)
UNEVEN = np.cumsum([0, 1.0, 0.6, 1.5, 0.8, 1.2, 0.7])
INTRINSIC = ((CovariantAcceleration(), 5 / 7), (UnitMagnitude(), 2 / 7))


def orientations(seed: int) -> Array:
    """Seven unit quaternions, steps of 20-90° about random axes, (7, 4)."""
    rng = np.random.default_rng(seed)
    turn, out = Rotation.identity(), []
    for _ in range(7):
        out.append(turn.as_quat()[[3, 0, 1, 2]])
        axis = rng.normal(size=3)
        turn = turn * Rotation.from_rotvec(axis / np.linalg.norm(axis) * np.radians(rng.uniform(20, 90)))
    return np.array(out)


@cache
def exact(seed: int, even: bool = True) -> ExactPath:
    return exact_path(EVEN if even else UNEVEN, orientations(seed))


@cache
def motion(seed: int, variable: int, even: bool = True) -> Solution:
    times = EVEN if even else UNEVEN
    keys = [Frame.key(float(t), q) for t, q in zip(times, orientations(seed), strict=True)]
    settings = Settings(variable=variable, frames=0, tolerance=1e-10, max_evaluations=600)
    return inbetween(Problem(figure_of(ONE_BALL), keys, INTRINSIC, settings))


def energy(path: Path) -> float:
    """¼∫|ω'|² of the normalised path, its quaternion differentiated here: independent of the penalty."""
    t, w = gauss_nodes(np.unique(np.concatenate([path.spline.times, np.linspace(*path.span, 301)])), 5)
    q, q_d, q_dd = (path.at(t, order) for order in range(3))
    b, s = np.sum(q * q, axis=1, keepdims=True), np.sum(q * q_d, axis=1, keepdims=True)
    unit = q / np.sqrt(b)
    rate = q_dd / np.sqrt(b) - 2 * s * q_d / b**1.5
    rate -= np.sum(rate * unit, axis=1, keepdims=True) * unit
    return float(w @ np.sum(rate**2, axis=1))


@pytest.mark.parametrize(
    ("seed", "variable", "even", "excess"), [(0, 3, True, 5e-4), (0, 15, True, 1e-6), (1, 3, False, 5e-4)]
)
def test_few_variable_frames_come_close_to_the_exact_energy_and_many_closer(seed, variable, even, excess) -> None:
    ratio = energy(motion(seed, variable, even=even).path) / exact(seed, even).energy
    assert 1 - 1e-9 <= ratio <= 1 + excess
