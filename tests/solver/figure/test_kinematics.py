"""The batched kinematics and its adjoint, against MuJoCo and Taylor expansions."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from random_samples import random_samples
from taylor import taylor_slope

from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.adjoint import QUANTITIES, Cotangent
from dynsplines.solver.figure.algebra import turned_back, vector_product
from dynsplines.solver.figure.forward import boxes
from dynsplines.solver.figure.kinematics import Samples


def test_link_positions_and_orientations_are_those_of_mj_kinematics(figure, rng):
    samples = random_samples(figure, rng)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data = kinematics(figure.model, qpos)
        for link_index, link in enumerate(figure.links[1:], start=1):
            if figure.body_link[link.body] != link_index:
                continue
            np.testing.assert_allclose(samples.links.x[:, link_index, i], data.xpos[link.body], atol=1e-12)
            np.testing.assert_allclose(
                samples.links.rotation[:, :, link_index, i].ravel(), data.xmat[link.body], atol=1e-12
            )
            if link.kind != link.kind.SLIDE:  # MuJoCo gives a slide's anchor before the displacement
                np.testing.assert_allclose(samples.links.anchor[:, link_index, i], data.xanchor[link.joint], atol=1e-12)


@pytest.mark.parametrize("name", ["x", "x_d", "x_dd", "omega", "alpha"])
def test_the_adjoint_of_each_quantity_has_taylor_slope_two(figure, rng, name):
    samples = random_samples(figure, rng)
    weights = rng.normal(size=(3, len(figure.links), samples.count))
    cotangent = Cotangent(samples)
    cotangent.accumulate(name, weights)
    gradients = cotangent.gradients()

    def value(point: np.ndarray) -> float:
        return float(np.sum(weights * getattr(Samples(figure, *point).links, name)))

    assert taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), np.stack(gradients), rng) > 1.95


def test_the_adjoint_of_rotations_has_taylor_slope_two(figure, rng):
    samples = random_samples(figure, rng)
    weights = rng.normal(size=(3, 3, len(figure.links), samples.count))
    rotation = samples.links.rotation
    cotangent = Cotangent(samples)
    cotangent.accumulate("turn", np.cross(rotation, weights, axis=0).sum(axis=1))
    gradients = cotangent.gradients()

    def value(point: np.ndarray) -> float:
        return float(np.sum(weights * Samples(figure, *point).links.rotation))

    assert taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), np.stack(gradients), rng) > 1.95


@pytest.mark.parametrize("direction", ["accumulate", "buffer"])
def test_a_gradient_with_respect_to_nothing_that_there_is_is_refused(figure, rng, direction):
    cotangent = Cotangent(random_samples(figure, rng))
    with pytest.raises(ValueError, match=r"'spin'; there are: y, y_d, .*omega"):
        getattr(cotangent, direction)("spin", *([] if direction == "buffer" else [np.zeros(3)]))


@pytest.mark.parametrize("name", QUANTITIES)
def test_a_gradient_may_be_added_into_a_buffer_as_well_as_given_whole(figure, rng, name):
    samples = random_samples(figure, rng, 3)
    links = (len(figure.links), 3)
    shapes = {"y": samples.y.shape, "q": samples.q.shape, "swing": (3, 3, *links)}
    gradient = rng.normal(size=shapes.get(name.split("_")[0], (3, *links)))
    given, added = Cotangent(samples), Cotangent(samples)
    given.accumulate(name, gradient)
    assert added.buffer(name).shape == gradient.shape
    added.buffer(name)[...] += gradient
    for own, other in zip(given.gradients(), added.gradients(), strict=True):
        np.testing.assert_array_equal(own, other)


@pytest.mark.parametrize(("v", "q"), [((5, 7), (5, 7)), ((4, 3, 6), (4, 1, 6)), ((1, 6), (4, 6))])
def test_the_product_of_a_vector_and_a_quaternion_is_hamiltons(rng, v, q):
    vector, quaternion = rng.normal(size=(3, *v)), rng.normal(size=(4, *q))
    pure = np.concatenate([np.zeros((1, *v)), vector])
    expected = quat.product(np.moveaxis(pure, 0, -1), np.moveaxis(quaternion, 0, -1))
    product = turned_back(vector_product(quaternion), vector)
    np.testing.assert_allclose(np.moveaxis(product, 0, -1), expected, atol=1e-14)


def test_boxes_are_around_the_vertices_of_a_turned_mesh(rng):
    vertices = " ".join(f"{x:.6f}" for x in rng.exponential(size=24))
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><asset><mesh name="stone" vertex="{vertices}"/></asset><worldbody><body pos="1 2 3">'
        '<freejoint/><geom type="mesh" mesh="stone" quat=".9 .1 -.2 .3"/></body></worldbody></mujoco>'
    )
    data = kinematics(model, model.qpos0)
    centre, half = boxes(model, data, np.array([0]))
    corners = model.mesh_vert @ data.geom_xmat[0].reshape(3, 3).T + data.geom_xpos[0]
    assert np.all(np.abs(corners - centre) <= half + 1e-6)
