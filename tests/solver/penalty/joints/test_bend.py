"""Knees and elbows: angles against SciPy's Euler decomposition, nothing inside the limits, the gradient everywhere."""

import numpy as np
import pytest
from bends import DOWN, ELBOW, KNEE, limb, limits
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples


def bent(figure: Figure, lateral: np.ndarray, angles: np.ndarray, rng: np.random.Generator) -> Samples:
    """The limb with flexion about the lateral axis, then sideways, then twist about the long axis: angles (S, 3)."""
    axes = np.column_stack([lateral, np.cross(DOWN, lateral), DOWN])
    relative = Rotation.from_matrix(axes @ Rotation.from_euler("XYZ", angles).as_matrix() @ axes.T)
    turn = Rotation.from_quat(np.roll(figure.links[2].turn, -1))
    qpos = rng.normal(size=(len(angles), figure.width))
    qpos[:, 7:] = np.roll((turn.inv() * relative * turn).as_quat(), 1, axis=1)
    y = figure.to_state(qpos)
    return Samples(figure, y, 0 * y, 0 * y)


FIGURES = limb(), limb("joint", ".8 .1 -.2 .4")


@given(
    st.sampled_from(FIGURES), st.floats(-3, 3), st.floats(-1.4, 1.4), st.floats(-1.5, 1.5), st.sampled_from([1.0, -1.0])
)
@example(FIGURES[1], 1.5, 0.0, 0.0, 1.0)
@example(FIGURES[1], 0.0, 1.4, 0.0, -1.0)
@example(FIGURES[1], 0.0, 0.0, -1.5, 1.0)
@settings(deadline=None, max_examples=60)
def test_the_angles_are_the_euler_angles_with_the_twist_wide_by_the_sideways_bend(figure, flexion, side, twist, sign):
    samples = bent(figure, sign * KNEE, np.array([[flexion, side, twist]]), np.random.default_rng(1))
    seen = limits(sign * KNEE).angles(samples)[:, 0, 0]
    wide = np.arctan2(np.sin(twist), np.cos(twist) * np.cos(side))
    np.testing.assert_allclose(seen, [flexion, side, wide], atol=1e-10)


def test_a_knee_flexes_its_shin_backward_and_an_elbow_its_forearm_forward(rng):
    for lateral, sign in ((KNEE, -1), (ELBOW, 1)):
        figure = limb("joint")
        samples = bent(figure, lateral, np.array([[0.5, 0, 0]]), rng)
        samples = Samples(figure, np.hstack([[[0.0, 0, 0, 1, 0, 0, 0]], samples.y[:, 7:]]), samples.y_d, samples.y_dd)
        tip = samples.links.rotation[:, :, 2, 0] @ DOWN
        np.testing.assert_allclose(tip, [sign * np.sin(0.5), 0, -np.cos(0.5)], atol=1e-12)


@pytest.mark.parametrize("lateral", [KNEE, ELBOW], ids=["knee", "elbow"])
def test_inside_the_limits_it_is_exactly_zero_without_gradient_and_outside_the_squared_excess(rng, lateral):
    degrees = np.array([[30, 9, -9], [-20, 0, 0], [20, 25, 0], [20, -25, 0], [20, 0, 25], [20, 0, -25], [0.1, 0, 0]])
    samples = bent(limb(), lateral, np.radians(degrees), rng)
    cotangent = Cotangent(samples)
    values = limits(lateral).evaluate(samples, cotangent)
    np.testing.assert_allclose(np.degrees(np.sqrt(values)), [0, 20, 15, 15, 15, 15, 0], atol=1e-9)
    assert values[0] == 0
    gradient = np.abs(cotangent.gradients()[0]).max(axis=1)
    np.testing.assert_array_equal(gradient > 0, [False, True, True, True, True, True, False])


@pytest.mark.parametrize("gap", [1e-3, 1e-7, 1e-12, 0.0])
def test_a_limb_out_at_a_right_angle_sideways_has_a_true_angle_and_a_finite_gradient(rng, gap):
    samples = bent(limb(), KNEE, np.array([[0.3, np.pi / 2 - gap, 0.2]]), rng)
    penalty = limits(KNEE, least=-4.0, twist=4.0)
    np.testing.assert_allclose(penalty.angles(samples)[1], np.pi / 2 - gap, atol=2e-9)
    cotangent = Cotangent(samples)
    penalty.evaluate(samples, cotangent)
    assert np.abs(cotangent.gradients()[0]).max() < 20
