"""The paper's form of the covariant acceleration and its Euler-Lagrange residual, against independent formulas."""

from __future__ import annotations

import numpy as np
import pytest
from paper.equations import PaperAcceleration, covariant_residual
from paper.orientations import PAPER, Case, spinner
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import UnitMagnitude
from dynsplines.solver.refine import euler_lagrange
from dynsplines.solver.refine.euler_lagrange import residual


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
