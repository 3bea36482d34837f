"""The paper's claims that hold for every path, and its equations and derivatives against independent formulas."""

from dataclasses import replace

import numpy as np
import pytest
import shipped
from gradients import penalty_slope
from paper import study
from paper.equations import PaperAcceleration, by_objective, covariant_residual
from paper.orientations import INTRINSIC, KEYFRAMES, PAPER, Case, Run, energy, spinner
from random_models import random_samples

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import UnitMagnitude
from dynsplines.solver.refine import subdivision
from dynsplines.solver.refine.subdivision import residual

CHECKED = ("iterates", "unit magnitude")  # studies whose claims hold for every set of keyframes


@pytest.mark.slow
def test_what_holds_for_every_path_is_reproduced(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(study, "STUDIES", tuple(each for each in study.STUDIES if each.name in CHECKED))
    claims = study.run(seeds=1)
    for text in ("Keyframes are met", "E falls", "as the objective sees it", "10 : 1, 3 variable frames"):
        (claim,) = [claim for claim in claims if text in claim.text]
        assert claim.reproduced


def test_the_gradient_has_taylor_slope_two(figure, rng):
    assert penalty_slope(PaperAcceleration(), random_samples(figure, rng), rng, any_length=False) > 1.95


@pytest.mark.parametrize(("nodes", "close"), [(8, 1e-3), (16, 1e-7)])
def test_the_closed_form_is_half_the_residual_of_the_sample_gradients(
    nodes: int, close: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(subdivision, "NODES", nodes)
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
