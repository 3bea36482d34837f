"""Level: the angle by MuJoCo, gradient and curvature, and a chest that rises between keyframes that bow."""

import numpy as np
import pytest
from oracles import kinematics
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines import inbetween, load
from dynsplines.solver.penalty import Level

BOW = """
figure = "human"
[[keyframe]]
time = 0
others = "rest"
root.rotation = {{rotvec = [0, 30, 0]}}
[[keyframe]]
time = 1
others = "rest"
root.rotation = {{rotvec = [0, 30, 0]}}
{more}
"""
ASKED = '[[penalty]]\nkind = "upright"\nbodies = ["chest"]'


@pytest.mark.parametrize("axis", [None, (0.3, -0.2, 1.0)])
def test_the_value_is_what_mujoco_computes_of_the_axis(figure, rng, axis):
    samples, model = random_samples(figure, rng, 4), figure.model
    bodies = [i for i in range(1, model.nbody) if figure.body_link[i]][:2]
    rest, expected = kinematics(model), np.zeros(4)
    for s, qpos in enumerate(figure.to_qpos(samples.y)):
        data = kinematics(model, qpos)
        for body in bodies:
            own = rest.xmat[body].reshape(3, 3).T @ [0, 0, 1] if axis is None else np.array(axis) / np.linalg.norm(axis)
            expected[s] += np.sum((data.xmat[body].reshape(3, 3) @ own - [0, 0, 1]) ** 2)
    np.testing.assert_allclose(Level.of(figure, bodies, axis).evaluate(samples), expected, atol=1e-9)


def test_the_gradient_has_taylor_slope_two(figure, rng):
    bodies = np.flatnonzero(figure.body_link)[:3].tolist()
    assert penalty_slope(Level.of(figure, bodies), random_samples(figure, rng, 5), rng) > 1.95


@pytest.mark.slow
def test_a_chest_rises_between_keyframes_that_bow():
    lean = {}
    for more in ("", ASKED):
        motion = inbetween(load(BOW.format(more=more)))
        model = motion.clip.figure.model
        data = kinematics(model, motion.at(0.5))
        lean[more] = np.degrees(np.arccos(data.body("chest").xmat[8]))
    assert lean[""] > 25
    assert lean[ASKED] < 0.5 * lean[""]
