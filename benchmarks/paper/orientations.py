"""Seven orientations of one body, the paths through them that the paper compares, and what those are judged by.

"Energy" is always ∫ ¼|ω'|² of the normalised path.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache, cached_property

import mujoco
import numpy as np

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration, Penalty, UnitMagnitude
from dynsplines.solver.problem import Improvement, Problem, Settings, Solution
from dynsplines.solver.refine.subdivision import decrements
from dynsplines.system import signals

from .equations import PaperAcceleration, covariant_residual, tangential

KEYFRAMES = 7  # as many orientations as in the paper's figure 7
TENTHS = 10  # equal parts of a path, as in figure 10
REFERENCE_FRAMES = 15  # variable frames a segment that stand for the exact minimum
NODES = 8  # of Gauss in every part of a span
FEW_FRAMES = 2  # that the paper adds where the deviation is large

Weights = tuple[tuple[Penalty, float], ...]
PAPER: Weights = ((PaperAcceleration(), 5.0), (UnitMagnitude(), 2.0))
INTRINSIC: Weights = ((CovariantAcceleration(), 5.0), (UnitMagnitude(), 2.0))


@cache
def spinner() -> Figure:
    """The toy aeroplane that ships, held in its place: it turns on one ball joint."""
    spec = mujoco.MjSpec.from_string(models.figure_text("spinner"))
    spec.joint("spin").type = mujoco.mjtJoint.mjJNT_BALL
    return Figure(spec.compile())


def orientations(seed: int) -> Array:
    """(7, 4) unit quaternions that are drawn by `moderate`."""
    return moderate(np.random.default_rng(seed), KEYFRAMES)


def moderate(rng: np.random.Generator, count: int) -> Array:
    """(count, 4) unit quaternions: steps of 20-90° about random axes, by shortest arcs."""
    track = [np.array([1.0, 0.0, 0.0, 0.0])]
    for _ in range(count - 1):
        axis = rng.normal(size=3)
        turn = axis / np.linalg.norm(axis) * np.radians(rng.uniform(20, 90))
        track.append(quat.product(track[-1], quat.from_rotation_vector(turn)))
    return quat.align_signs(np.array(track))


def to_its_end(problem: Problem, improved: Callable[[Improvement], None] | None = None) -> Solution:
    """A search that no signal has cut short: its best path would be no answer. Raises KeyboardInterrupt for one."""
    solution = inbetween(problem, improved=improved)
    if signals.was_received():
        raise KeyboardInterrupt
    return solution


class Run:
    """Orientations at their times, and the paths through them, each solved once."""

    def __init__(self, keys: Sequence[Frame]) -> None:
        self.keys = list(keys)
        self._solved: dict[tuple[Weights, int], Solution] = {}

    def solved(self, weights: Weights, variable: int) -> Solution:
        """The optimum with `variable` frames in every segment."""
        if (weights, variable) not in self._solved:
            self._solved[weights, variable] = self.inbetween(weights, Settings(variable=variable, frames=0))
        return self._solved[weights, variable]

    def adaptive(self, weights: Weights, frames: int, criterion: str) -> Solution:
        """The optimum with `frames` variable frames in all, added one by one where the criterion is largest."""
        settings = Settings(variable=0, frames=frames, criterion=criterion, batch=1e-9, threshold=0.0)
        return self.inbetween(weights, settings)

    def inbetween(
        self, weights: Weights, settings: Settings, improved: Callable[[Improvement], None] | None = None
    ) -> Solution:
        """Tightly converged: the claims are about optima."""
        tight = replace(settings, tolerance=1e-9, max_evaluations=1000)
        return to_its_end(Problem(spinner(), self.keys, weights, tight), improved)

    @cached_property
    def least(self) -> float:
        """The energy of the near-exact minimum."""
        return energy(self.solved(INTRINSIC, REFERENCE_FRAMES).path)

    def ratio(self, path: Path) -> float:
        """A path's energy over the near-exact minimum."""
        return energy(path) / self.least


class Case(Run):
    """One of the fixed sets of keyframes, 1 s apart."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self.track = orientations(seed)
        super().__init__([Frame.key(float(i), q) for i, q in enumerate(self.track)])


def energy(path: Path) -> float:
    """∫ ¼|ω'|² dt of the normalised path, on panels of at most 0.1 s."""
    first, last = path.span
    t, w = gauss_nodes(np.union1d(path.spline.times, np.linspace(first, last, round(10 * (last - first)) + 1)), 5)
    samples = Objective.of(spinner(), INTRINSIC).samples(path, t)
    return float(w @ CovariantAcceleration().evaluate(samples))


def unit_deviation(path: Path) -> float:
    """max | |q| − 1 | on a grid of 1 kHz."""
    first, last = path.span
    grid = np.linspace(first, last, round(1000 * (last - first)) + 1)
    return float(np.max(np.abs(np.linalg.norm(path.at(grid), axis=1) - 1)))


def figure_ten(run: Run, weights: Weights) -> dict[str, Path]:
    """The paths of figure 10, and the adaptive one with as many frames as one a segment."""
    one, three = (run.solved(weights, variable) for variable in (1, 3))
    paths = {"raw": path_of(one.raw), "1": one.path, "3": three.path}
    added = (FEW_FRAMES, KEYFRAMES - 1)
    return paths | {f"adaptive {n}": run.adaptive(weights, n, "residual").path for n in added}


def promised(objective: Objective, path: Path) -> Array:
    """(P,) the decrease of E by a variable frame in the middle of each segment; the sum is about the remaining
    decrease."""
    times = np.asarray(path.spline.times)
    return decrements(objective, path, (times[1:] + times[:-1]) / 2)


def strong_tenths(objective: Objective, path: Path) -> dict[str, Array]:
    """The mean |EL| over tenths of the path, (10,): of eq. 10's left side and of its part off q."""
    cuts = np.linspace(*path.span, TENTHS + 1)
    t, w = gauss_nodes(np.union1d(path.spline.times, cuts), NODES)
    factors = {term.penalty.name: term.factor for term in objective.terms}
    value = covariant_residual(path, t, factors["unit"] / factors["acceleration.angular"])
    part = np.clip(np.searchsorted(cuts, t, side="right") - 1, 0, TENTHS - 1)
    parts = {"strong": value, "tangential": tangential(value, path.at(t))}
    length = np.diff(cuts)
    return {name: np.bincount(part, w * np.linalg.norm(v, axis=1), TENTHS) / length for name, v in parts.items()}


def weak_tenths(objective: Objective, path: Path) -> Array:
    """(10,) what variable frames promise over tenths of the path, each segment's promise spread evenly over it."""
    cumulative = np.concatenate([[0.0], np.cumsum(promised(objective, path))])
    return np.diff(np.interp(np.linspace(*path.span, TENTHS + 1), path.spline.times, cumulative))
