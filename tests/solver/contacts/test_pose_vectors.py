"""The way that a figure faces, as a polynomial of the time: a line through few poses, bent through more."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL, EVERY_JOINT, figure_of
from gaits import FIGURE, WALK, gait
from random_keys import random_qpos

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts.pose_vectors import Heading, PoseVectors
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure


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


def seen(figure: Figure, poses: Array, times: Array) -> PoseVectors:
    found = PoseVectors.of(figure, raw_timeline(figure, [Frame.key(t, q) for t, q in zip(times, poses, strict=True)]))
    assert found is not None
    return found


@pytest.mark.parametrize("text", [EVERY_JOINT, "walk"])
def test_vectors_tell_the_poses_that_they_were_made_of(text, rng):
    """Back through rotation vectors, angles and heights, the heading on again."""
    figure, times = (FIGURE if text == "walk" else figure_of(text)), np.linspace(0.5, 3.0, 12)
    poses = np.array([random_qpos(figure, rng) for _ in times])
    found = seen(figure, poses, times)
    vectors = found.map.vectors(found.map.off_heading(poses, times))
    np.testing.assert_allclose(vectors, found.rows[: times.size], atol=1e-9)
    rotations, (angles, heights) = found.map.rotations(vectors, times), found.map.numbers(vectors)
    given = poses[:, found.map.columns.T]
    np.testing.assert_allclose(np.abs(np.sum(rotations * given, axis=-1)), 1, atol=1e-9)
    np.testing.assert_allclose(angles, poses[:, figure.tables.hinge_columns], atol=1e-12)
    np.testing.assert_allclose(heights[:, 0], poses[:, 2], atol=1e-12)
    assert found.sides == (2 if text == "walk" else 1)
    assert vectors.shape[1] == 3 * given.shape[1] + angles.shape[1] + 1


def test_wherever_a_figure_walks_and_whichever_way_it_faces_its_vectors_are_the_same():
    keys = gait(WALK, 0.25).keys
    times, poses = keys.times, FIGURE.to_qpos(keys.states)
    about = quat.from_rotation_vector(np.array([0, 0, 1.9]))
    moved = np.array(poses)
    moved[:, :3] = quat.rotated(about, poses[:, :3]) + np.array([3.0, -1, 0])
    moved[:, 3:7] = quat.product(about, poses[:, 3:7])
    one, other = seen(FIGURE, poses, times), seen(FIGURE, moved, times)
    assert one.sides == other.sides == 2
    np.testing.assert_allclose(one.rows @ one.rows.T, other.rows @ other.rows.T, atol=1e-9)  # the signs of means apart
    assert np.ptp(one.rows, axis=0).max() > 0.5


def test_a_body_that_turns_evenly_and_rises_and_falls_tells_its_height_alone():
    figure, times = figure_of(BALL), np.linspace(0, 2, 9)
    heights = np.array([1.0, 1.2, 1.1, 0.9, 1.3, 1.0, 1.1, 1.2, 0.8])
    poses = np.zeros((9, 7))
    poses[:, 0], poses[:, 2] = 0.7 * times, heights
    poses[:, 3:] = quat.from_rotation_vector(np.outer(0.5 + 1.4 * times, [0, 0, 1.0]))
    found = seen(figure, poses, times)
    np.testing.assert_allclose(found.rows[:, :3], 0, atol=1e-9)
    np.testing.assert_allclose(found.rows[:9, 3], found.map.up * (heights - heights.mean()), atol=1e-12)
    still = Frame.key(0, poses[0]), Frame.key(1, poses[0]), Frame.key(2, poses[0])
    assert PoseVectors.of(figure, raw_timeline(figure, list(still))) is None
