"""The paper's claims that hold for every path, and its equations and derivatives against independent formulas."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shipped
from gradients import penalty_slope
from paper import study
from paper.barr import Discrete
from paper.equations import PaperAcceleration, by_objective, covariant_residual
from paper.orientations import INTRINSIC, KEYFRAMES, PAPER, Case, Run, energy, spinner
from random_models import random_samples

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import UnitMagnitude
from dynsplines.solver.refine import euler_lagrange
from dynsplines.solver.refine.euler_lagrange import residual

CHECKED = ("iterates", "unit magnitude")  # studies whose claims hold for every set of keyframes


@pytest.mark.slow
def test_what_holds_for_every_path_is_reproduced(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(study, "STUDIES", tuple(each for each in study.STUDIES if each.name in CHECKED))
    claims = study.run(seeds=1)
    for text in ("Keyframes are met", "E falls", "as the objective sees it", "10 : 1, 3 variable frames"):
        (claim,) = [claim for claim in claims if text in claim.text]
        assert claim.reproduced


def test_both_discrete_peers_find_the_same_unit_samples_through_the_keyframes() -> None:
    problem = Discrete(Case(0).track, 5)
    dense, exact = problem.by_slsqp(), problem.by_newton()
    np.testing.assert_allclose(dense, exact, atol=2e-3)
    for x in (dense, exact):
        assert abs(problem.length(x)).max() < 1e-5
        np.testing.assert_array_equal(problem.all_samples(x)[::5], Case(0).track)
    assert problem(exact)[0] == pytest.approx(problem(dense)[0], rel=1e-4)


def test_the_discrete_peers_derivatives_are_exact(rng: np.random.Generator) -> None:
    problem = Discrete(Case(1).track, 3)
    x = problem.start[problem.free].ravel() + 0.05 * rng.normal(size=4 * problem.free.size)
    direction = rng.normal(size=x.size)
    h = 1e-5
    (above, slope_above), (below, slope_below) = problem(x + h * direction), problem(x - h * direction)
    assert (above - below) / (2 * h) == pytest.approx(problem(x)[1] @ direction, rel=1e-7)
    turned = problem.hessian(x) @ direction
    np.testing.assert_allclose((slope_above - slope_below) / (2 * h), turned, rtol=1e-5, atol=1e-5 * abs(turned).max())


def test_the_gradient_has_taylor_slope_two(figure, rng):
    assert penalty_slope(PaperAcceleration(), random_samples(figure, rng), rng, any_length=False) > 1.95


@pytest.mark.parametrize(("nodes", "close"), [(8, 1e-3), (16, 1e-7)])
def test_the_closed_form_is_half_the_residual_of_the_sample_gradients(
    nodes: int, close: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(euler_lagrange, "NODES", nodes)
    path = Case(1).solved(PAPER, 1).path
    generic = residual(Objective.of(spinner(), [(PaperAcceleration(), 1.0), (UnitMagnitude(), 3.0)]), path)
    closed = covariant_residual(path, generic.t.ravel(), 3.0).reshape(generic.value.shape)
    np.testing.assert_allclose(closed, generic.value / 2, atol=close * abs(generic.value).max())


def test_the_segments_shares_add_up_to_e() -> None:
    motion = Case(1).solved(PAPER, 1)
    objective = replace(motion.objective, quadrature=Quadrature(points=6))
    assert by_objective(objective, motion.timeline).sum() == pytest.approx(objective.value(motion.path), rel=1e-9)


@pytest.mark.slow
def test_the_tumble_of_figure_7_turns_with_nearly_the_least_energy_and_less_than_its_raw_spline() -> None:
    tumble = shipped.of("tumble")
    keys = [Frame.key(key.time, key.state[3:7]) for key in tumble.clip.keys]
    assert len(keys) == KEYFRAMES
    least = energy(Run(keys).solved(INTRINSIC, 7).path)
    paths = (tumble.motion.path, path_of(tumble.motion.raw))
    solved, raw = (energy(Path(path.spline, path.rows[:, 3:7])) for path in paths)
    assert solved < 1.001 * least
    assert raw > 1.02 * least
