"""Upright: the value, gradient and curvature, which keyframes it is about, and a chest that rises."""

import numpy as np
import pytest
from figures import BALL_TREE, figure_of
from oracles import kinematics
from random_samples import at_times, random_samples

from dynsplines import inbetween, load
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Lean, Upright, leans

AXES = np.array([[0.6, 0.0, 0.8], [0.0, -1.0, 0.0]])
UP = np.array([0.0, 0, 1])
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


def upright_of(figure: Figure, *times: float) -> Upright:
    """Axes of the first and the last link at every time."""
    links = (1, len(figure.links) - 1)
    return Upright(tuple(Lean(link, axis, t) for t in times for link, axis in zip(links, AXES, strict=True)))


def some(figure: Figure, rng: np.random.Generator) -> Samples:
    return at_times(random_samples(figure, rng, 6), np.array([0.0, 0.5, 0.5, 0.7, 1.0, 1.3]))


def turned(figure: Figure, qpos: Array, link: int, axis: Array) -> Array:
    """An axis of a link in the world, by MuJoCo's kinematics."""
    data = kinematics(figure.model, qpos)
    return data.body(figure.links[link].body).xmat.reshape(3, 3) @ axis


def test_it_is_the_squared_distance_of_the_axes_ends_at_its_time(figure, rng):
    samples = some(figure, rng)
    values = upright_of(figure, 0.5, 1.3).evaluate(samples)
    for i in (1, 2, 5):
        qpos, links = figure.to_qpos(samples.y[i]), (1, len(figure.links) - 1)
        away = [turned(figure, qpos, link, axis) - UP for link, axis in zip(links, AXES, strict=True)]
        assert values[i] == pytest.approx(float(np.sum(np.square(away))), rel=1e-9)
    assert not values[[0, 3, 4]].any()


def test_it_is_about_keyframes_whose_roots_turn_was_posed_and_keeps_what_points_up_there():
    figure = figure_of(BALL_TREE, "world")
    qpos, free = np.array(figure.model.qpos0), np.zeros(figure.width, bool)
    qpos[3:7] = [np.cos(0.2), 0, np.sin(0.2), 0]
    free[3:7] = True
    keys = [Frame.key(0.0, qpos), Frame(1.0, qpos, ~free, free), Frame.key(2.0, qpos, ~free), Frame.key(3.0, qpos)]
    (lean,) = leans(figure, raw_timeline(figure, keys), figure.tables.free_links.tolist())
    assert (lean.link, lean.time) == (int(figure.tables.free_links[0]), 1.0)
    np.testing.assert_allclose(turned(figure, qpos, lean.link, lean.axis), UP, atol=1e-12)


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
    np.testing.assert_allclose(Upright.of(figure, bodies, axis).evaluate(samples), expected, atol=1e-9)


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
