"""The unit-magnitude penalty: values by hand, the gradient by Taylor. Also the Taylor test of any penalty."""

import numpy as np
from figures import figure_of
from random_samples import random_samples

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import UnitMagnitude

BALL = '<mujoco><worldbody><body><joint type="ball"/><geom size="0.1"/></body></worldbody></mujoco>'


def test_the_square_is_the_sum_of_squared_excess_lengths(figure, rng):
    samples = random_samples(figure, rng)
    expected = sum((samples.y[:, c] ** 2).sum(axis=1) - 1 for c in figure.tables.quaternion_columns.T[:1]) ** 2
    for columns in figure.tables.quaternion_columns.T[1:]:
        expected = expected + ((samples.y[:, columns] ** 2).sum(axis=1) - 1) ** 2
    np.testing.assert_allclose(UnitMagnitude().evaluate(samples), expected, rtol=1e-12)


def test_the_reference_is_the_penalty_of_one_percent():
    np.testing.assert_allclose(UnitMagnitude().normalization.reference, (1.01**2 - 1) ** 2, rtol=0.02)


def test_a_raw_spline_that_is_far_off_unit_length_does_not_make_it_soft():
    figure = figure_of(BALL)
    turns = [[1.0, 0, 0, 0], [0.1, 1, 0, 0], [1, 0.1, 0, 0]]
    raw = path_of(raw_timeline(figure, [Frame.key(t, q) for t, q in zip((0.0, 0.1, 3.0), turns, strict=True)]))
    firm, soft = (Objective.of(figure, [(UnitMagnitude(most=m), 2.0)]).renormalised(raw).terms[0] for m in (0.01, 1e9))
    np.testing.assert_allclose(firm.factor, 2.0 / (0.01 * 3.0), rtol=1e-12)
    assert soft.factor < firm.factor / 2
