"""Kinematics, velocities, inverse dynamics and their adjoints on random models that mix all joints, against MuJoCo."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from oracles import mujoco_forces
from random_model import random_figure
from random_samples import random_samples
from taylor import taylor_slope

from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.dynamics import InverseDynamics, generalised_forces, velocities
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples

SEEDS = range(24)
COORDINATES = ("auto", "world", "joint")


def test_the_random_models_mix_what_they_should():
    figures = [random_figure(seed, "world")[0] for seed in SEEDS]
    kinds = [{link.kind for link in figure.links[1:]} for figure in figures]
    assert sum(kind == set(JointKind) for kind in kinds) > 3
    flags = [figure.tables.in_world[figure.tables.ball_links] for figure in figures]
    assert sum(bool(flag.any() and not flag.all()) for flag in flags) > 3
    assert any(figure.is_world for figure in figures) or any(flag.all() for flag in flags)
    assert any(figure.tables.free_links.size > 1 for figure in figures)
    assert any(figure.tables.free_links.size and figure.tables.free_links[0] > 1 for figure in figures)


@pytest.mark.parametrize("coordinates", COORDINATES)
@pytest.mark.parametrize("seed", SEEDS[:10])
def test_bodies_are_where_mujoco_has_them_and_its_forces_are_found(seed, coordinates):
    figure, rng = random_figure(seed, coordinates)
    samples = random_samples(figure, rng, 3)
    data = mujoco.MjData(figure.model)
    qpos = figure.to_qpos(samples.y)
    np.testing.assert_allclose(figure.to_qpos(figure.to_state(qpos)), qpos, atol=1e-12)
    qvel, _ = velocities(samples)
    for i in range(3):
        data.qpos[:], data.qvel[:] = qpos[i], qvel[i]
        mujoco.mj_fwdPosition(figure.model, data)
        mujoco.mj_fwdVelocity(figure.model, data)
        spin = np.zeros(6)
        for body in range(1, figure.model.nbody):
            link, place = figure.point_on_link(body, np.zeros(3))
            where, offset = samples.links.points(np.array([link]), place[:, None])
            np.testing.assert_allclose(where[:, 0, i], data.xpos[body], atol=1e-11)
            mujoco.mj_objectVelocity(figure.model, data, mujoco.mjtObj.mjOBJ_XBODY, body, spin, 0)
            np.testing.assert_allclose(samples.links.omega[:, link, i], spin[:3], atol=1e-9)
            velocity = samples.links.x_d[:, link, i] + np.cross(spin[:3], offset[:, 0, i])
            np.testing.assert_allclose(velocity, spin[3:], atol=1e-8)
    expected = mujoco_forces(samples)
    np.testing.assert_allclose(generalised_forces(samples), expected, atol=1e-9 * np.abs(expected).max())


@pytest.mark.parametrize("coordinates", ["auto", "joint"])
@pytest.mark.parametrize("seed", range(8))
def test_the_adjoint_of_forces_has_taylor_slope_two(seed, coordinates):
    figure, rng = random_figure(seed, coordinates)
    samples = random_samples(figure, rng, 3)
    shape = (3, len(figure.links), samples.count)
    for_moment, for_force = rng.normal(size=shape), rng.normal(size=shape)
    cotangent = Cotangent(samples)
    InverseDynamics(samples.links).pull_back(cotangent, for_moment, for_force)
    gradients = cotangent.gradients()

    def value(point: np.ndarray) -> float:
        inverse = InverseDynamics(Samples(figure, *point).links)
        return float(np.sum(for_moment * inverse.moment) + np.sum(for_force * inverse.force))

    assert taylor_slope(value, np.stack([samples.y, samples.y_d, samples.y_dd]), np.stack(gradients), rng) > 1.95
