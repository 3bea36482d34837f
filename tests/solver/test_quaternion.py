"""Quaternion algebra against SciPy's rotations, finite differences and the axioms of the group."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat

component = st.floats(-2, 2, allow_nan=False).map(lambda x: round(x, 6))
few = settings(deadline=None, max_examples=25)
quaternions = st.tuples(*[component] * 4).map(np.array).filter(lambda q: np.linalg.norm(q) > 0.1)
vectors = st.tuples(*[component] * 3).map(np.array)


def scipy_rotation(q: np.ndarray) -> Rotation:
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


def test_matrices_are_scipys_at_any_length(rng):
    q = rng.normal(size=(5, 4)) * np.array([[0.01], [0.3], [1.0], [7.0], [200.0]])
    np.testing.assert_allclose(quat.matrices(q), scipy_rotation(q).as_matrix(), atol=1e-12)


@few
@given(quaternions)
def test_a_quaternion_times_its_inverse_is_the_identity_on_both_sides(q):
    one = [1, 0, 0, 0]
    np.testing.assert_allclose(quat.product(q, quat.inverse(q)), one, atol=1e-13)
    np.testing.assert_allclose(quat.product(quat.inverse(q), q), one, atol=1e-13)
    np.testing.assert_array_equal(quat.product(q, one), q)
    np.testing.assert_array_equal(quat.product(one, q), q)


@few
@given(quaternions, quaternions, vectors)
def test_rotations_compose_and_turn_vectors_as_scipys_do(p, q, v):
    np.testing.assert_allclose(quat.rotated(q, v), scipy_rotation(q).apply(v), atol=1e-12)
    np.testing.assert_allclose(
        quat.rotated(quat.product(p, q), v), (scipy_rotation(p) * scipy_rotation(q)).apply(v), atol=1e-12
    )


@few
@given(quaternions)
def test_exponential_and_logarithm_are_inverse_and_agree_with_scipy(q):
    log = quat.rotation_vector(q)
    assert np.linalg.norm(log) <= np.pi + 1e-12
    back = quat.from_rotation_vector(log)
    unit = quat.normalised(q)
    np.testing.assert_allclose(back * np.sign(back @ unit), unit, atol=1e-12)
    if np.linalg.norm(log) < 3.1:
        np.testing.assert_allclose(log, scipy_rotation(q).as_rotvec(), atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 1e-320, 1e-170, 1e-12, 1.9e-9, 2.1e-9, 1e-6, 1e-3, 3.0])
def test_small_angles_keep_their_relative_accuracy_through_exponential_and_logarithm(angle):
    v = angle * np.array([0.6, 0.0, -0.8])
    np.testing.assert_allclose(quat.rotation_vector(quat.from_rotation_vector(v)), v, rtol=1e-13, atol=5e-324)


@pytest.mark.parametrize("gap", [1e-3, 1e-9, 1e-14, 0.0, -1e-14, -1e-9, -1e-3])
def test_angles_about_pi_come_back_as_the_same_rotation_by_the_short_way(gap):
    v = (np.pi - gap) * np.array([0.0, 1.0, 0.0])
    log = quat.rotation_vector(quat.from_rotation_vector(v))
    np.testing.assert_allclose(np.linalg.norm(log), np.pi - abs(gap), rtol=1e-13)
    np.testing.assert_allclose(np.abs(log[1]), np.pi - abs(gap), rtol=1e-13)


@few
@given(quaternions, st.floats(0, np.pi), vectors.filter(lambda v: np.linalg.norm(v) > 0.1))
def test_angle_between_is_the_angle_of_the_rotation_between_whatever_length_and_sign(q, angle, axis):
    turned = quat.product(q, quat.from_rotation_vector(angle * axis / np.linalg.norm(axis)))
    np.testing.assert_allclose(quat.angle_between(q, -3 * turned), angle, atol=1e-7)


def test_an_aligned_track_has_neighbours_on_one_hemisphere_and_the_same_rotations(rng):
    track = rng.normal(size=(40, 3, 4))
    aligned = quat.aligned(track)
    assert np.all(np.sum(aligned[1:] * aligned[:-1], axis=-1) >= 0)
    np.testing.assert_array_equal(np.abs(aligned), np.abs(track))
    np.testing.assert_array_equal(aligned[0], track[0])
    signs = aligned / track
    np.testing.assert_array_equal(signs, np.broadcast_to(signs[..., :1], signs.shape))
    assert (signs < 0).any()


@pytest.mark.parametrize("size", [1e-3, 1.0, 30.0])
@pytest.mark.parametrize("vector", [0.0, 1e-13, 1e-9, 1e-3, 1.0])
def test_the_rotation_vector_of_one_is_that_of_many_and_scipys(vector, size):
    rng = np.random.default_rng(3)
    for real in (1.0, -1.0, 1e-12):
        q = size * np.append(real, vector * rng.normal(size=3))
        one = quat.rotation_vector(q)
        np.testing.assert_allclose(one, quat.rotation_vector(q[None])[0], rtol=1e-12, atol=1e-300)
        np.testing.assert_allclose(one, Rotation.from_quat(q[[1, 2, 3, 0]]).as_rotvec(), rtol=1e-6, atol=1e-12)
