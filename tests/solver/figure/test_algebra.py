"""Component-first algebra against the same with the component last."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.algebra import turned_back, vector_product


@pytest.mark.parametrize(("v", "q"), [((5, 7), (5, 7)), ((4, 3, 6), (4, 1, 6)), ((1, 6), (4, 6))])
def test_the_product_of_a_vector_and_a_quaternion_is_hamiltons(rng, v, q):
    vector, quaternion = rng.normal(size=(3, *v)), rng.normal(size=(4, *q))
    pure = np.concatenate([np.zeros((1, *v)), vector])
    expected = quat.product(np.moveaxis(pure, 0, -1), np.moveaxis(quaternion, 0, -1))
    product = turned_back(vector_product(quaternion), vector)
    np.testing.assert_allclose(np.moveaxis(product, 0, -1), expected, atol=1e-14)
