"""The way that a figure faces, as a polynomial of the time: a line through few poses, bent through more."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.reading.pose_vectors import Heading


def facing(angles: Array) -> Array:
    """(n, 4) orientations that face ways about z [rad], and lean as they like."""
    lean = quat.from_rotation_vector(np.array([0.3, 0.0, 0.0]))
    return quat.product(quat.from_rotation_vector(np.outer(angles, [0.0, 0, 1])), lean)


@pytest.mark.parametrize(("poses", "coefficients"), [(2, 1), (3, 2), (5, 2), (8, 2), (9, 4), (20, 4)])
def test_few_poses_tell_an_even_turn_and_more_than_eight_a_bent_one(poses, coefficients):
    times = np.linspace(1.0, 2.0, poses)
    found = Heading.of(times, facing(0.4 * (times - 1.5)))
    assert found.coefficients.size == coefficients
    assert found.middle == pytest.approx(1.5)
    if poses > 2:
        np.testing.assert_allclose(found.coefficients[-2:], [0.4, 0.0], atol=1e-9)


def test_a_heading_that_goes_round_more_than_once_is_followed():
    times = np.linspace(0.0, 3.0, 30)
    found = Heading.of(times, facing(4.0 * times - 0.3 * times**3))
    np.testing.assert_allclose(
        np.polyval(found.coefficients, times - found.middle), 4.0 * times - 0.3 * times**3, atol=1e-9
    )
