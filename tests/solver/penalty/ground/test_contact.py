"""The contact penalty: which points it makes of a body, its values by hand, its gradient, both sides of the surface."""

import mujoco
import numpy as np
import pytest
from ground import FLOOR, random_points
from oracles import kinematics
from random_samples import random_samples

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Contact
from dynsplines.solver.surface import Box, static_surfaces
from dynsplines.solver.surface.points import body_points

BLOCK = Box("block", np.array([0.1, -0.2, 0.0]), np.eye(3), np.array([2.0, 1.5, 1.0]), buried=False)
STEP = Box("step", np.array([0.0, 0, -0.5]), np.eye(3), np.array([2.0, 2.5, 1.0]), buried=True)


def test_it_is_the_sum_of_squared_depths_of_points_placed_by_mujoco(figure, rng):
    samples = random_samples(figure, rng, 8)
    samples.y[:, 2] = 0
    points = random_points(figure, rng)
    expected = []
    ends = {link.body: i for i, link in enumerate(figure.links) if i and figure.body_link[link.body] == i}
    points = tuple(p for p in points if p.link in ends.values())
    for qpos in figure.to_qpos(samples.y):
        data = kinematics(figure.model, qpos)
        total = 0.0
        for body, link in ends.items():
            for point in (p for p in points if p.link == link):
                height = (data.xpos[body] + data.xmat[body].reshape(3, 3) @ point.position)[2]
                total += max(point.radius + 0.05 - height, 0) ** 2
        expected.append(total)
    np.testing.assert_allclose(Contact(points, (FLOOR,), margin=0.05).evaluate(samples), expected, rtol=1e-10)
    assert np.count_nonzero(expected) > 4


@pytest.mark.parametrize("surface", [FLOOR, BLOCK, STEP], ids=lambda s: s.name)
def test_a_figure_outside_costs_exactly_nothing_and_has_no_gradient(figure, rng, surface):
    samples = random_samples(figure, rng)
    samples.y[:, 2] = 50
    points = tuple(p for p in random_points(figure, rng) if figure.tables.path[p.link, 1])
    cotangent = Cotangent(samples)
    assert not Contact(points, (surface,)).evaluate(samples, cotangent).any()
    assert not any(g.any() for g in cotangent.gradients())


def test_a_capsule_across_the_edge_of_a_box_is_noticed():
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><freejoint/><geom type="capsule" size=".024" fromto="-.2 0 0 .2 0 0"/></body>'
        '<geom name="beam" type="box" size=".01 .5 .1" pos="0 0 .1"/></worldbody></mujoco>'
    )
    figure = Figure(model)
    contact = Contact(body_points(figure), static_surfaces(model))
    for shift in np.linspace(-0.05, 0.05, 11):
        state = np.array([[shift, 0, 0.2 + 0.024 - 0.004, 1, 0, 0, 0]])
        assert contact.evaluate(Samples(figure, state, 0 * state, 0 * state))[0] > 0
