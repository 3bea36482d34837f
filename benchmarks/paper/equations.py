"""The paper's equations that the solver does not use: its covariant acceleration (eq. 9) and its residual (eq. 10).

The paper argues against two criteria of subdivision (§2), "objective" and "resolution". They are here for comparison.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.quadrature import gauss_nodes
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration
from dynsplines.solver.penalty.block import Block, Dense, every
from dynsplines.solver.penalty.curvature import Curvature
from dynsplines.solver.refine.subdivision import CRITERIA, midpoints, split

from .nearest import optimise


@dataclass(frozen=True)
class PaperAcceleration(CovariantAcceleration):
    """Σ of f₂ = |q'' − T q|² over quaternion blocks, T = (q''·q)/(q·q), and of θ''²/4 over hinges (eq. 9).

    It is the solver's penalty only while |q| = 1.
    """

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        q, q_dd = samples.q, samples.q_dd
        b = np.sum(q * q, axis=0)
        along = np.sum(q_dd * q, axis=0) / b

        def pulled_back(into: Cotangent, bar: Array) -> None:
            bar = bar.reshape(q.shape)
            across = np.sum(bar * q, axis=0) / b
            into.accumulate("q", across * (2 * along * q - q_dd) - along * bar, donate=True)
            into.accumulate("q_dd", bar - across * q, donate=True)

        yield Dense((q_dd - along * q).reshape(-1, samples.count), pulled_back, partial(_curved, samples))
        yield every(samples, samples.figure.tables.hinge_columns, 2, weight=0.25)


def _curved(samples: Samples, into: Curvature, scale: Array) -> None:
    q, q_dd = samples.q.transpose(2, 1, 0), samples.q_dd.transpose(2, 1, 0)
    b = np.sum(q * q, axis=-1)[..., None, None]
    along = np.sum(q_dd * q, axis=-1)[..., None, None] / b
    rows = np.zeros((*q.shape, 3, 4))
    rows[..., 0, :] = -along * np.eye(4) + q[..., :, None] * (2 * along * q[..., None, :] - q_dd[..., None, :]) / b
    rows[..., 2, :] = np.eye(4) - q[..., :, None] * q[..., None, :] / b
    into.add_blocks(samples.figure.tables.quaternion_columns.T, rows, scale)


def covariant_residual(path: Path, t: Array, unit_weight: float) -> Array:
    """X + Y'' + Z of eq. 10 for f = f₂ + λ f₁ on one quaternion, (S, 4): half of the left side of eq. 24.

    Args:
        t: Times, (S,) [s].
        unit_weight: The weight λ of f₁.
    """
    q, q_d, q_dd, q_ddd = (path.at(t, order) for order in range(4))

    def inner(a: Array, b: Array) -> Array:
        return np.sum(a * b, axis=1, keepdims=True)

    b = inner(q, q)
    b_d, b_dd = 2 * inner(q, q_d), 2 * (inner(q_d, q_d) + inner(q, q_dd))
    a = inner(q, q_dd)
    a_d = inner(q_d, q_dd) + inner(q, q_ddd)
    a_dd = inner(q_dd, q_dd) + 2 * inner(q_d, q_ddd)
    big_t = a / b
    t_d = (a_d - big_t * b_d) / b
    t_dd = (a_dd - 2 * t_d * b_d - big_t * b_dd) / b
    x = q * big_t**2 - q_dd * big_t
    y_dd = -(q_dd * big_t + 2 * q_d * t_d + q * t_dd)
    return x + y_dd + 2 * unit_weight * (b - 1) * q


def tangential(residual: Array, q: Array) -> Array:
    """The part of a residual (S, 4) orthogonal to q (S, 4), which alone changes the rotation."""
    along = np.sum(residual * q, axis=1, keepdims=True) / np.sum(q * q, axis=1, keepdims=True)
    return residual - along * q


def by_objective(objective: Objective, timeline: Timeline) -> Array:
    """Return ∫ f dt over every segment."""
    t, w = gauss_nodes(np.asarray(timeline.times), 6)
    density = objective.density(objective.samples(path_of(timeline), t))
    return (w * density).reshape(-1, 6).sum(axis=1)


def by_resolution(objective: Objective, timeline: Timeline) -> Array:
    """Return ∫ |y − y_fine| dt per segment, with y_fine the optimum at twice the resolution (Welch & Witkin 1992)."""
    fine = optimise(objective, split(timeline, midpoints(timeline)))
    t, w = gauss_nodes(np.asarray(timeline.times), 6)
    apart = np.linalg.norm(path_of(timeline).at(t) - path_of(fine).at(t), axis=1)
    return (w * apart).reshape(-1, 6).sum(axis=1)


CRITERIA.update({"objective": by_objective, "resolution": by_resolution})  # for `Settings.criterion`
