"""A basis of the splines that are zero at held rows: SciPy's null space, at any spacing of the frames."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import null_space

from dynsplines.solver.curve.elimination import Elimination
from dynsplines.solver.curve.spline import Sampling, Spline


@settings(max_examples=100)
@given(
    st.lists(st.floats(0.01, 1), min_size=2, max_size=12),
    st.sampled_from(["free", "periodic"]),
    st.randoms(use_true_random=False),
)
def test_its_functions_span_the_splines_whose_held_rows_are_zero(gaps, ends, random):
    spline = Spline(np.append(0.0, np.cumsum(gaps)), ends)
    held = np.array([random.random() < 0.5 for _ in range(spline.size)])
    held[int(random.random() * spline.size)] = False
    basis = Elimination(spline, held)
    matrix, rows = basis.matrix.toarray(), spline.states_and_slopes(np.eye(spline.size))
    scale = np.abs(matrix).max()
    np.testing.assert_allclose(rows[held] @ matrix, 0, atol=1e-9 * scale * np.abs(rows).max())
    constraints = rows[held] / np.linalg.norm(rows[held], axis=1, keepdims=True)
    freedoms = np.asarray(null_space(constraints)).shape[1] if held.any() else held.size
    assert np.linalg.matrix_rank(matrix) == basis.count == freedoms
    np.testing.assert_array_equal(basis.transposed.toarray(), matrix.T)


@pytest.mark.parametrize("held", [[0], [0, 2, 3, 5], [0, 1, 2, 3, 4, 5, 6], [0, 3, 6, 7, 8]], ids=str)
def test_at_samples_four_of_its_functions_are_nonzero(rng, held):
    spline = Spline(np.cumsum(rng.uniform(0.1, 1, 7)))
    basis = Elimination(spline, np.isin(np.arange(spline.size), held))
    sampling = Sampling.of(spline, np.sort(rng.uniform(*spline.times[[0, -1]], 50)))
    for ours, theirs in zip(basis.sampled(sampling).bases, sampling.bases, strict=True):
        np.testing.assert_allclose(ours.toarray(), theirs.toarray() @ basis.matrix.toarray(), atol=1e-9)
