"""Root acceleration: the columns that count, and the gradient."""

import numpy as np
from random_samples import random_samples

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.penalty import RootAcceleration


def test_it_is_the_squared_acceleration_of_root_and_slides_and_feels_nothing_else(figure, rng):
    samples = random_samples(figure, rng)
    counted = [0, 1, 2] + [link.qpos for link in figure.links[1:] if link.kind is link.kind.SLIDE]
    np.testing.assert_allclose(
        RootAcceleration().evaluate(samples), np.sum(samples.y_dd[:, counted] ** 2, axis=1), rtol=1e-14
    )
    cotangent = Cotangent(samples)
    RootAcceleration().evaluate(samples, cotangent)
    g0, g1, g2 = cotangent.gradients()
    assert not g0.any()
    assert not g1.any()
    expected = np.zeros_like(g2)
    expected[:, counted] = 2 * samples.y_dd[:, counted]
    np.testing.assert_array_equal(g2, expected)
