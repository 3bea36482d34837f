"""Upright: the value by hand, gradient and curvature, and which keyframes it is about."""

import numpy as np
import pytest
from figures import BALL_TREE, figure_of
from oracles import kinematics
from penalty_slope import penalty_slope
from random_samples import at_times, random_samples

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Lean, Upright, leans

AXES = np.array([[0.6, 0.0, 0.8], [0.0, -1.0, 0.0]])
UP = np.array([0.0, 0, 1])


def upright_of(figure: Figure, *times: float) -> Upright:
    """Axes of the first and the last link at every time."""
    links = (1, len(figure.links) - 1)
    return Upright(tuple(Lean(link, t, axis) for t in times for link, axis in zip(links, AXES, strict=True)))


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


def test_the_gradient_has_taylor_slope_two(figure, rng):
    assert penalty_slope(upright_of(figure, 0.5, 1.0), some(figure, rng), rng) > 1.95


def test_it_is_about_keyframes_whose_roots_turn_was_posed_and_keeps_what_points_up_there():
    figure = figure_of(BALL_TREE, "world")
    qpos, free = np.array(figure.model.qpos0), np.zeros(figure.width, bool)
    qpos[3:7] = [np.cos(0.2), 0, np.sin(0.2), 0]
    free[3:7] = True
    keys = [Frame.key(0.0, qpos), Frame(1.0, qpos, ~free, free), Frame.key(2.0, qpos, ~free), Frame.key(3.0, qpos)]
    (lean,) = leans(figure, raw_timeline(figure, keys), figure.tables.free_links.tolist())
    assert (lean.link, lean.time) == (int(figure.tables.free_links[0]), 1.0)
    np.testing.assert_allclose(turned(figure, qpos, lean.link, lean.axis), UP, atol=1e-12)
