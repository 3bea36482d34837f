"""Several soft constraints as one: everything of it is the sum of theirs."""

from __future__ import annotations

import numpy as np
from curvature_of import curvature_of, sides_of
from ground import FLOOR, SLOPE, random_points
from random_samples import random_samples

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.penalty import Contact, CovariantAcceleration, Sum, Torque


def test_its_value_gradient_and_curvature_are_the_sums_of_its_parts(figure, rng):
    samples, parts = random_samples(figure, rng, 4), (CovariantAcceleration(), Torque())
    both, scale = Sum(parts, "both"), rng.uniform(1, 2, 4)
    assert both.name == "both"
    assert both.normalization == parts[0].normalization
    into, own = Cotangent(samples), [Cotangent(samples) for _ in parts]
    values = [part.evaluate(samples, one, scale) for part, one in zip(parts, own, strict=True)]
    np.testing.assert_allclose(both.evaluate(samples, into, scale), values[0] + values[1])
    for found, *expected in zip(into.gradients(), *(one.gradients() for one in own), strict=True):
        np.testing.assert_allclose(found, sum(expected), atol=1e-9 * (1 + np.abs(sum(expected)).max()))
    phi = rng.normal(size=(4, 3))
    found, *expected = (curvature_of(one, samples, scale).quadratic(phi, 0, 4) for one in (both, *parts))
    np.testing.assert_allclose(found, sum(expected), rtol=1e-9, atol=1e-9 * np.abs(found).max())
    assert both.one_sided_residuals(samples) is None


def test_its_sides_are_those_of_the_parts_that_have_some_one_after_the_other(figure, rng):
    samples = random_samples(figure, rng, 4)
    samples.y[:, 2] = -0.3
    floor, slope = (Contact(random_points(figure, rng), (surface,)) for surface in (FLOOR, SLOPE))
    found = sides_of(Sum((floor, Torque(), slope), "all"), samples)
    expected = [sides_of(part, samples) for part in (floor, slope)]
    for name in ("at", "value", "rows"):
        np.testing.assert_array_equal(getattr(found, name), np.concatenate([getattr(each, name) for each in expected]))
