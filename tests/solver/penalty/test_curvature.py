"""Gauss-Newton curvature, one-sided residuals, sums, and predictions of the weak form."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
import pytest
from figures import BALL, FLOOR, SLOPE, figure_of, limits_of, random_points
from gradients import (
    RESIDUALS,
    assembled,
    assert_near,
    assert_squares,
    curvature_of,
    low_samples,
    sides_of,
    some_samples,
)
from problems import slider

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import (
    Collision,
    CovariantAcceleration,
    Normalization,
    Penalty,
    RootAcceleration,
)
from dynsplines.solver.penalty import curvature as curvature_module
from dynsplines.solver.penalty.block import Block, Dense, every
from dynsplines.solver.penalty.curvature import Curvature, OneSidedResiduals
from dynsplines.solver.refine.euler_lagrange import WeakForm
from dynsplines.solver.refine.subdivision import midpoints, split
from dynsplines.solver.surface.points import Point


@pytest.fixture(params=RESIDUALS)
def known(request: pytest.FixtureRequest) -> tuple[Penalty, Callable[[Samples], Array]]:
    """A penalty, and its residuals (S, r) at samples."""
    return RESIDUALS[request.param]


def test_the_quadratic_form_and_the_diagonal_are_those_of_the_same_matrices(figure, rng, known):
    penalty, _ = known
    samples = some_samples(figure, rng, 5)
    curvature = curvature_of(penalty, samples, rng.uniform(0.5, 2, samples.count))
    phi = rng.normal(size=(samples.count, 3))
    each = assembled(curvature, phi[:, :, None])
    for first, last in ((0, 5), (1, 3), (2, 2), (4, 5)):
        assert_near(curvature.quadratic(phi, first, last), each[first:last].sum(axis=0), 1e-12)
    by_acceleration = assembled(curvature, np.tile([[[0.0], [0], [1]]], (samples.count, 1, 1)))
    assert_near(curvature.acceleration(), np.einsum("snn->sn", by_acceleration), 1e-12)


@dataclass(frozen=True)
class BySweeps(CovariantAcceleration):
    """The covariant acceleration without a curvature of its own."""

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for block in super().residuals(samples):
            yield replace(block, curved=None) if isinstance(block, Dense) else block


def test_the_curvature_of_a_residual_without_one_of_its_own_is_twice_the_square_of_its_jacobian(figure, rng):
    _, residuals = RESIDUALS["covariant"]
    assert_squares(BySweeps(), residuals, some_samples(figure, rng), rng)


class Entry(Penalty):
    """Squares of the first entry of the state and its derivatives."""

    name, normalization = "entry", Normalization(1.0)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for order, weight in enumerate((20.0, 2.5, 0.15)):
            yield every(samples, np.zeros(1, int), order, weight=weight)


ONE_SIDED: dict[str, Callable[[Figure, np.random.Generator], Penalty]] = {
    "floor": lambda figure, rng: Collision(random_points(figure, rng), (FLOOR,), 0.01),
    "slope": lambda figure, rng: Collision(random_points(figure, rng), (SLOPE,)),
    "floor and slope": lambda figure, rng: Collision(random_points(figure, rng), (FLOOR, SLOPE)),
    "bend": lambda figure, rng: limits_of(figure),
}


@pytest.fixture(params=ONE_SIDED)
def one_sided(request: pytest.FixtureRequest, figure: Figure, rng: np.random.Generator) -> Penalty:
    return ONE_SIDED[request.param](figure, rng)


def test_one_sided_residuals_do_not_enter_the_curvature(figure, rng, one_sided):
    samples = low_samples(figure, rng, 6)
    curvature = curvature_of(one_sided, samples, np.ones(6))
    assert not curvature.quadratic(rng.normal(size=(6, 3)), 0, 6).any()


def test_sides_that_count_enter_a_curvature_as_squares(figure, rng, one_sided):
    samples = low_samples(figure, rng, 6)
    sides, scale, curvature = sides_of(one_sided, samples), rng.uniform(0.5, 2, 6), Curvature(samples)
    on_the_bound = np.arange(sides.value.size) == sides.value.argmax()
    sides = replace(sides, value=np.where(on_the_bound, 0.0, sides.value))  # where it neither pulls nor counts
    curvature.add_one_sided(sides, scale)
    phi = rng.normal(size=(6, 3))
    expected = np.zeros((figure.width, figure.width))
    for at, value, row in zip(sides.at, sides.value, sides.rows, strict=True):
        if value > 0:
            expected += 2 * scale[at] * phi[at, 0] ** 2 * np.outer(row, row)
    assert_near(curvature.quadratic(phi, 0, 6), expected, 1e-12)


@pytest.mark.parametrize("chosen", [slice(2, 3), slice(None)], ids=["one frame", "frames everywhere"])
def test_the_weak_form_promises_what_a_frame_moved_alone_brings_where_e_is_quadratic(rng, chosen):
    """A slide whose frames do not lie where its energy would have them, with a penalty of y besides."""
    problem = slider(np.linspace(0, 3, 4), 2)
    timeline = problem.timeline
    timeline = timeline.with_rows(timeline.rows + 0.1 * rng.normal(size=timeline.rows.shape))
    terms: list[tuple[Penalty, float]] = [(RootAcceleration(), 1.0), (Entry(), 1.0)]
    objective = Objective.of(problem.objective.figure, terms)
    candidates = midpoints(timeline)[chosen]
    finer, brought = split(timeline, candidates), []
    for row in np.searchsorted(finer.times, candidates):
        values = []
        for by in (-1.0, 0.0, 1.0):
            rows = np.array(finer.rows)
            rows[row] += by
            values.append(objective.value(path_of(finer.with_rows(rows))))
        slope, bent = (values[2] - values[0]) / 2, values[2] - 2 * values[1] + values[0]
        brought.append(slope**2 / (2 * bent))
    promised = WeakForm(objective, path_of(timeline)).decrements(candidates)
    np.testing.assert_allclose(promised, brought, rtol=2e-3)


def test_the_weak_form_ranks_the_segment_that_dips_into_the_floor_first():
    figure = figure_of(BALL)
    heights = [0.5, 0.4, 0.5, 0.12, 0.12, 0.5, 0.4]
    raw = raw_timeline(figure, [Frame.key(float(i), [0, 0, z, 1, 0, 0, 0]) for i, z in enumerate(heights)])
    contact = Collision((Point("ball", 1, np.zeros(3), 0.1),), (FLOOR,))
    objective = Objective.of(figure, [(RootAcceleration(), 1.0), (contact, 50.0)]).renormalised(path_of(raw))
    assert np.argmax(WeakForm(objective, path_of(raw)).decrements(midpoints(raw))) == 3


SAMPLES, WIDTH = 5, 7


def residuals_at(rng: np.random.Generator, at: list[int]) -> OneSidedResiduals:
    return OneSidedResiduals(np.array(at, int), rng.normal(size=len(at)), rng.normal(size=(len(at), WIDTH)))


@pytest.mark.parametrize("at_once", [2 * WIDTH, 10**6])
@pytest.mark.parametrize("at", [[0, 0, 3, 4], [4, 1, 1, 0, 4], []])
def test_what_a_change_moves_and_forces_pull_back_are_the_matrix_and_its_transpose(at_once, at, rng, monkeypatch):
    monkeypatch.setattr(curvature_module, "ENTRIES_AT_ONCE", at_once)
    change, sides = rng.normal(size=(SAMPLES, WIDTH)), residuals_at(rng, at)
    np.testing.assert_allclose(sides.moved(change), np.sum(sides.rows * change[sides.at], axis=1), rtol=1e-12)
    forces = rng.normal(size=len(at))
    for pushed in (forces, forces * (np.arange(len(at)) % 2), 0 * forces):
        pulled, expected = np.ones((2, SAMPLES, WIDTH))
        np.add.at(expected, sides.at, pushed[:, None] * sides.rows)
        sides.pull_back(pushed, pulled)
        np.testing.assert_allclose(pulled, expected, atol=1e-13)
