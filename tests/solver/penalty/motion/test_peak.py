"""Peaks of angular acceleration: the value by hand, gradient and curvature, and that they come down."""

import numpy as np
from curvature_of import assembled, assert_near, curvature_of, jacobians
from even_frames import evenly
from figures import TINY, figure_of
from random_samples import random_samples
from small_problems import turning

from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import CovariantAcceleration, PeakAcceleration, UnitMagnitude
from dynsplines.solver.search.descent import optimised


def sizes(samples: Samples) -> Array:
    """(S, joints): |α − α_parent| of ball joints and hinges, by the links' angular accelerations."""
    links, found = samples.links, []
    for i, link in enumerate(samples.figure.links):
        if i and link.kind in (link.kind.BALL, link.kind.HINGE):
            found.append(np.linalg.norm(links.alpha[:, i] - links.alpha[:, link.parent], axis=0))
    return np.array(found).T


def test_it_is_the_sum_of_eighth_powers(figure, rng):
    samples = random_samples(figure, rng)
    np.testing.assert_allclose(PeakAcceleration().evaluate(samples), np.sum(sizes(samples) ** 8, axis=1), rtol=1e-10)


def test_the_curvature_is_that_of_the_fourth_powers_times_seven_quarters(rng):
    for coordinates in ("world", "joint"):
        figure = figure_of(TINY, coordinates)
        samples = random_samples(figure, rng, 4)
        scale, phi = rng.uniform(0.5, 2, 4), rng.normal(size=(4, 3, 2))
        moved = np.einsum("sron,soa->sran", jacobians(lambda seen: sizes(seen) ** 4, samples), phi)
        flat = moved.reshape(*moved.shape[:2], -1)
        expected = 7 / 4 * 2 * scale[:, None, None] * np.einsum("srx,sry->sxy", flat, flat)
        assert_near(assembled(curvature_of(PeakAcceleration(), samples, scale), phi), expected)


def test_a_peak_comes_down():
    peaks = []
    for weight in (0.0, 3.0):
        objective, raw = turning([90.0, -60.0, 100.0, -100.0], 0)
        terms = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 10.0), (PeakAcceleration(), weight)]
        objective = Objective.of(objective.figure, terms).renormalised(path_of(raw))
        path = path_of(optimised(objective, evenly(raw, 3)))
        peaks.append(sizes(objective.samples(path, np.linspace(0, 4, 401))).max())
    assert peaks[1] < 0.9 * peaks[0]
