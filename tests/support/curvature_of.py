"""Gauss-Newton curvature of soft constraints beside residuals that are written anew and differences of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from ground import stance_of
from random_samples import at_times, random_samples

from dynsplines.solver.array import Array
from dynsplines.solver.figure.dynamics import generalised_forces
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    Attachment,
    CovariantAcceleration,
    Penalty,
    RootAcceleration,
    Torque,
    UnitMagnitude,
)
from dynsplines.solver.penalty.curvature import Curvature
from dynsplines.solver.penalty.one_sided import OneSidedResiduals
from dynsplines.solver.surface.points import places_of

STEP_SIZE = 1e-5
PLANTED = Attachment((stance_of(1, 0.2, 1.0), stance_of(2, 0.5, 2.0), stance_of(2, 0.0, 0.6)))


def _blocks(samples: Samples) -> tuple[Array, Array, Array]:
    """q, q', q'' of the state's quaternions, (S, n, 4) each."""
    columns = samples.figure.tables.quaternion_columns.T
    return samples.y[:, columns], samples.y_d[:, columns], samples.y_dd[:, columns]


def _along(a: Array, b: Array) -> Array:
    return np.sum(a * b, axis=-1, keepdims=True)


def _intrinsic(samples: Samples) -> Array:
    """P(q'' − 2 s q')/√b for quaternions, θ''/2 for hinges."""
    q, q_d, q_dd = _blocks(samples)
    b = _along(q, q)
    felt = q_dd - 2 * _along(q, q_d) / b * q_d
    felt = (felt - _along(felt, q) / b * q) / np.sqrt(b)
    return np.hstack([felt.reshape(samples.count, -1), samples.y_dd[:, samples.figure.tables.hinge_columns] / 2])


def _unit(samples: Samples) -> Array:
    q, _, _ = _blocks(samples)
    return 1 - np.sum(q * q, axis=-1)


def _root(samples: Samples) -> Array:
    tables = samples.figure.tables
    return samples.y_dd[:, [*tables.position_columns.ravel(), *tables.slide_columns]]


def _efforts(samples: Samples) -> Array:
    """MuJoCo's joint entries of qfrc_inverse, those of ball joints turned from the body's axes to the world's."""
    figure, forces = samples.figure, generalised_forces(samples)
    efforts = []
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind == link.kind.BALL:
            own = forces[:, link.dof : link.dof + 3]
            efforts.append(np.einsum("ijs,sj->si", samples.links.rotation[:, :, i], own))
        elif link.kind != link.kind.FREE:
            efforts.append(forces[:, link.dof : link.dof + 1])
    return np.hstack(efforts)


def _displacement(samples: Samples) -> Array:
    """Every planted point's way from its place, zeros when its stance is over."""
    centres, _ = places_of(tuple(s.point for s in PLANTED.stances), samples)
    away = []
    for stance, centre in zip(PLANTED.stances, centres.swapaxes(0, 1), strict=True):
        lasts = (samples.t >= stance.first) & (samples.t <= stance.last)
        away.append(((centre - stance.place(samples.t)) * lasts).T)
    return np.hstack(away)


RESIDUALS: dict[str, tuple[Penalty, Callable[[Samples], Array]]] = {
    "covariant": (CovariantAcceleration(), _intrinsic),
    "unit": (UnitMagnitude(), _unit),
    "root": (RootAcceleration(), _root),
    "torque": (Torque(), _efforts),
    "planted": (PLANTED, _displacement),
}


def shifted(samples: Samples, by: Array) -> Samples:
    """Samples moved by (3, S, N)."""
    return Samples(samples.figure, samples.y + by[0], samples.y_d + by[1], samples.y_dd + by[2], samples.t)


def jacobians(residuals: Callable[[Samples], Array], samples: Samples) -> Array:
    """(S, r, 3, N): central differences of residuals with respect to y, y', y''."""
    count, width = samples.y.shape
    out = []
    for order in range(3):
        for column in range(width):
            by = np.zeros((3, count, width))
            by[order, :, column] = STEP_SIZE
            out.append((residuals(shifted(samples, by)) - residuals(shifted(samples, -by))) / (2 * STEP_SIZE))
    return np.array(out).reshape(3, width, count, -1).transpose(2, 3, 0, 1)


def curvature_of(penalty: Penalty, samples: Samples, scale: Array) -> Curvature:
    curvature = Curvature(samples)
    penalty.curvature(samples, curvature, scale)
    return curvature


def assembled(curvature: Curvature, phi: Array) -> Array:
    """(S, K N, K N): the matrices of the coefficients of K directions (S, 3, K), from rows and blocks."""
    count, width, directions = curvature.samples.count, curvature.width, phi.shape[2]
    out = np.zeros((count, directions * width, directions * width))
    for at, left, right in curvature.rows(phi):
        assert np.all(np.diff(at) >= 0)
        rows = np.matmul(left, right).reshape(at.size, -1)
        np.add.at(out, at, rows[:, :, None] * rows[:, None, :])
    for columns, squares in curvature.squares():
        blocks = np.einsum("soa,snokpl,spb->snakbl", phi, squares, phi)
        for n, own in enumerate(columns):
            place = (np.arange(directions)[:, None] * width + own).ravel()
            size = place.size
            out[np.ix_(np.arange(count), place, place)] += blocks[:, n].reshape(count, size, size)
    return out


def assert_near(actual: Array, expected: Array, rtol: float = 1e-5) -> None:
    np.testing.assert_allclose(actual, expected, rtol=0, atol=rtol * max(np.abs(expected).max(), 1e-12))


def some_samples(figure: Figure, rng: np.random.Generator, count: int = 4) -> Samples:
    return at_times(random_samples(figure, rng, count), np.linspace(0.1, 1.3, count))


def assert_squares(penalty: Penalty, residuals: Callable[[Samples], Array], samples: Samples, rng: np.random.Generator):
    """That a penalty is the sum of squared residuals (S, r), and its matrices are 2 JᵀJ, J by differences."""
    np.testing.assert_allclose(np.sum(residuals(samples) ** 2, axis=1), penalty.evaluate(samples), rtol=1e-9)
    scale, phi = rng.uniform(0.5, 2, samples.count), rng.normal(size=(samples.count, 3, 2))
    moved = np.einsum("sron,soa->sran", jacobians(residuals, samples), phi)
    flat = moved.reshape(*moved.shape[:2], -1)
    expected = 2 * scale[:, None, None] * np.einsum("srx,sry->sxy", flat, flat)
    assert_near(assembled(curvature_of(penalty, samples, scale), phi), expected)


def low_samples(figure: Figure, rng: np.random.Generator, count: int = 40) -> Samples:
    """Samples about the floor."""
    samples = random_samples(figure, rng, count)
    samples.y[:, 2] = rng.uniform(-0.5, 0.5, count)
    return samples


def sides_of(penalty: Penalty, samples: Samples) -> OneSidedResiduals:
    sides = penalty.one_sided_residuals(samples)
    assert sides is not None
    assert sides.at.shape == sides.value.shape == sides.rows.shape[:1]
    return sides
