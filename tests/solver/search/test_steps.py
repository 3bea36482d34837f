"""Steps that leave whole keyframes alone: splines of fewer coefficients, by SciPy's B-splines."""

import numpy as np
import pytest
from scipy.interpolate import BSpline

from dynsplines.solver.curve.spline import Sampling, Spline
from dynsplines.solver.search.steps import LOCAL, Steps


@pytest.mark.parametrize("seed", range(40))
def test_they_are_zero_where_they_are_fixed_and_move_samples_as_their_coefficients_say(seed):
    rng = np.random.default_rng(seed)
    frames = int(rng.integers(3, 14))
    spline = Spline(np.cumsum(rng.uniform(0.2, 1, frames)))
    fixed = rng.random(spline.size) < rng.choice([0.0, 0.3, 0.5])
    steps = Steps.of(spline, fixed)
    if spline.size - fixed.sum() < LOCAL:
        assert steps.count == spline.size
        return
    assert steps.count == spline.size - fixed.sum()
    coefficients = rng.normal(size=(steps.count, 2))
    whole = steps.to_spline(coefficients)
    gradient = rng.normal(size=whole.shape)
    np.testing.assert_allclose(np.sum(steps.from_spline(gradient) * coefficients), np.sum(gradient * whole), rtol=1e-9)
    curve, size = BSpline(spline.knots, whole, 3), np.abs(whole).max()
    at_frames = np.concatenate([curve(spline.times), curve(spline.times[[0, -1]], 1)])
    assert np.abs(at_frames[fixed]).max(initial=0) < 1e-11 * size
    piece = Sampling.of(spline, np.sort(rng.uniform(*spline.times[[0, -1]], 30))).whole
    for order, moved in enumerate(steps.piece(piece).samples(coefficients)):
        expected = curve(piece.t, order)
        np.testing.assert_allclose(moved, expected, rtol=0, atol=1e-10 * max(size, np.abs(expected).max()))
