"""Speed: what MuJoCo says of joints, gradient and curvature, and a joint that takes its time."""

import mujoco
import numpy as np
import pytest
from random_samples import random_samples

from dynsplines import inbetween, load
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.penalty import Speed

# An elbow that bends far, and comes back
SWING = """
figure = "human"
[[keyframe]]
time = 0
others = "rest"
[[keyframe]]
time = 0.5
others = "rest"
joints.left_elbow = {{rotvec = [0, -100, 0]}}
[[keyframe]]
time = 1
others = "rest"
{more}
"""


def unit_samples(figure, rng, count):
    """Random samples with quaternions of unit length, all the time."""
    samples = random_samples(figure, rng, count)
    y, y_d = samples.y.copy(), samples.y_d.copy()
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] /= np.linalg.norm(y[:, columns], axis=1, keepdims=True)
        y_d[:, columns] -= y[:, columns] * np.sum(y[:, columns] * y_d[:, columns], axis=1, keepdims=True)
    return type(samples)(figure, y, y_d, samples.y_dd)


def test_joints_are_as_fast_as_mujoco_computes(figure, rng):
    samples, model, h = unit_samples(figure, rng, 4), figure.model, 1e-6
    joints = [i for i, link in enumerate(figure.links) if i and link.kind in (JointKind.HINGE, JointKind.BALL)]
    before, after = (figure.to_qpos(samples.y + k * h * samples.y_d) for k in (-0.5, 0.5))
    expected = np.zeros((len(joints), 4))
    for s in range(4):
        qvel = np.zeros(model.nv)
        mujoco.mj_differentiatePos(model, qvel, h, before[s], after[s])
        for row, i in enumerate(joints):
            joint = figure.links[i].joint
            at, size = int(model.jnt_dofadr[joint]), 3 if figure.links[i].kind is JointKind.BALL else 1
            expected[row, s] = np.linalg.norm(qvel[at : at + size])
    speed = Speed.of(figure, 1.0)
    np.testing.assert_allclose(speed.speeds(samples), expected, rtol=1e-4, atol=1e-6)
    np.testing.assert_allclose(speed.evaluate(samples), np.sum(np.maximum(expected - 1, 0) ** 2, axis=0), rtol=1e-3)


@pytest.mark.slow
def test_a_joint_takes_its_time():
    """100 degrees in half a second, there and back, are 200 degrees a second on the average."""
    fastest = {}
    for more in ("", '[[penalty]]\nkind = "limits"\nspeed = 260'):
        motion = inbetween(load(SWING.format(more=more)))
        figure = motion.clip.figure
        times = np.linspace(0, 1, 500)
        qpos = np.array([motion.at(t) for t in times])
        at = int(figure.model.jnt_qposadr[figure.model.joint("left_elbow").id])
        size = np.abs(np.einsum("ij,ij->i", qpos[1:, at : at + 4], qpos[:-1, at : at + 4]))
        fastest[more] = float(np.degrees(2 * np.arccos(np.minimum(size, 1)) / np.diff(times)).max())
    free, limited = fastest.values()
    assert free > 280 and limited < 262, fastest
