"""Vectors of poses: what is left of keyframes without the heading."""

import numpy as np
from gaits import FIGURE, TIME, WALK

from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts.pose_vectors import Heading, PoseVectors
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline


def test_the_heading_is_the_angle_of_the_x_axis_without_jumps(rng):
    times = np.linspace(0, 2, 6)
    yaw = 2.8 + 1.5 * times  # beyond 180°
    lean = quat.from_rotation_vector(np.column_stack([0 * times, rng.uniform(-0.4, 0.4, 6), 0 * times]))
    rotations = quat.product(quat.from_rotation_vector(np.outer(yaw, [0.0, 0, 1])), lean)
    turned = quat.product(Heading.of(times, rotations).turn(times, -1), rotations)
    np.testing.assert_allclose(np.abs(np.sum(turned * lean, axis=1)), 1, atol=1e-12)


def test_poses_of_a_walk_in_a_circle_are_those_of_the_walk_on_a_line():
    picked = np.arange(0, TIME.size, TIME.size // 7)
    poses = []
    for angle in (0 * TIME, -1.0 + 0.4 * TIME):
        qpos = WALK.copy()
        qpos[:, 3:7] = quat.product(quat.from_rotation_vector(np.outer(angle, [0.0, 0, 1])), WALK[:, 3:7])
        poses.append(PoseVectors.of(FIGURE, raw_timeline(FIGURE, [Frame.key(TIME[k], qpos[k]) for k in picked])))
    assert poses[0] is not None
    assert poses[1] is not None
    np.testing.assert_allclose(poses[1].rows, poses[0].rows, atol=1e-9)
