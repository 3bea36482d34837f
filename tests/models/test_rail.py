"""A limb that would go through an obstacle goes over it, measured by MuJoCo at 1 kHz; the cover that sees to that."""

from __future__ import annotations

import io

import mujoco
import numpy as np
import pytest
from curvature_of import assert_gradients
from figures import LEG
from ground import FLOOR, some_points
from paper.penetration import penetration
from penalty_slope import penalty_slope
from rail import OBSTACLES, WITHOUT, written
from random_samples import random_samples
from rich.console import Console

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.motion import sampled
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.size import Size
from dynsplines.solver.penalty import Contact, Sum, UnitMagnitude
from dynsplines.solver.penalty.curvature import Curvature
from dynsplines.solver.penalty.one_sided import OneSidedResiduals
from dynsplines.solver.surface import Capsule, Ellipsoid, Sphere
from dynsplines.solver.surface.cover import covering_points
from dynsplines.system.progress import Progress


def deepest(path: str) -> float:
    """Deepest penetration [m] of a clip's solved motion at 1 kHz."""
    solved = solving.solve(clip.load(path), Progress(Console(file=io.StringIO())))
    run = sampled(solved.clip.figure, solved.motion.timeline, 1000.0)
    return penetration(solved.clip.figure.model, run.time, run.qpos).deepest


@pytest.mark.slow
@pytest.mark.parametrize("obstacle", OBSTACLES)
def test_a_limb_goes_through_an_obstacle_without_the_penalty_and_at_most_two_millimetres_with_it(tmp_path, obstacle):
    assert deepest(written(tmp_path, obstacle, WITHOUT)) > 0.015
    assert deepest(written(tmp_path, obstacle)) <= 0.002


RAIL = Capsule("rail", np.array([0.1, -0.1, -0.1]), np.array([0.0, 0.6, 0.8]), 2.0, 0.3)
STONE = Sphere("stone", np.array([0.2, 0.1, -0.3]), 0.8)
EGG = Ellipsoid("egg", np.array([0.1, 0.2, 0.0]), np.eye(3), np.array([1.2, 0.7, 0.5]))


@pytest.mark.parametrize("surface", [RAIL, STONE, EGG], ids=lambda surface: surface.name)
def test_the_penalty_of_an_obstacle_has_taylor_slope_two_and_rows_that_are_gradients(figure, rng, surface):
    samples = random_samples(figure, rng, 8)
    samples.y[:, :3] *= 0.1
    contact = Contact(some_points(figure, rng), (surface,), margin=0.02)
    assert np.count_nonzero(contact.evaluate(samples)) >= 4
    assert penalty_slope(contact, samples, rng) > 1.9
    assert_gradients(contact, figure, rng)


def test_the_sides_of_a_rail_are_how_deep_spheres_are_even_before_they_touch(figure, rng):
    samples = random_samples(figure, rng, 30)
    samples.y[:, :3] *= 0.1
    points = some_points(figure, rng)
    contact = Contact(points, (RAIL,))
    sides = contact.one_sided_residuals(samples)
    assert sides is not None
    centres, _, _ = contact.centres(samples)
    radii = np.array([point.radius for point in points])
    near = 0.03 * Size.of(figure).length
    for s in range(samples.count):
        own = radii - RAIL.distance(centres[:, :, s])[0]
        np.testing.assert_allclose(np.sort(sides.value[sides.at == s]), np.sort(own[own > -near]), atol=1e-9)
    assert np.count_nonzero(sides.value < 0) > 3


def test_together_is_the_sum_of_its_parts(figure, rng):
    samples = random_samples(figure, rng, 8)
    samples.y[:, 2] = 0
    parts = (Contact(some_points(figure, rng), (FLOOR,)), Contact(some_points(figure, rng), (RAIL,), 0.05))
    both = Sum(parts, "both")
    np.testing.assert_allclose(both.evaluate(samples), sum(part.evaluate(samples) for part in parts))
    assert penalty_slope(both, samples, rng) > 1.9
    counts = [len(sides.at) for part in parts if (sides := part.one_sided_residuals(samples)) is not None]
    sides = both.one_sided_residuals(samples)
    assert isinstance(sides, OneSidedResiduals)
    assert len(sides.at) == sum(counts) > max(counts)
    assert Sum((UnitMagnitude(),), "unit").one_sided_residuals(samples) is None
    mine, its = Curvature(samples), Curvature(samples)
    Sum((UnitMagnitude(), UnitMagnitude()), "units").curvature(samples, mine, np.ones(8))
    UnitMagnitude().curvature(samples, its, np.full(8, 2.0))
    phi = rng.normal(size=(8, 3))
    np.testing.assert_allclose(mine.quadratic(phi, 0, 8), its.quadratic(phi, 0, 8))


def skin(model: mujoco.MjModel, geom: int, rng: np.random.Generator) -> Array:
    """Points (n, 3) of a geom's surface, in its own axes: where rays from outside meet it."""
    found = []
    while len(found) < 200:
        start, way = 3 * rng.normal(size=3), rng.normal(size=3)
        target = 0.5 * model.geom_rbound[geom] * rng.normal(size=3)
        way = (target - start) / np.linalg.norm(target - start)
        hit = mujoco.mju_rayGeom(
            np.zeros(3), np.eye(3).ravel(), model.geom_size[geom], start, way, model.geom_type[geom]
        )
        if hit > 0:
            found.append(start + hit * way)
    return np.array(found)


def test_a_cover_lies_within_the_geoms_and_leaves_a_rail_no_room_between_its_spheres(rng):
    model = mujoco.MjModel.from_xml_string(LEG.replace("<body", '<geom size=".3"/><body', 1))
    figure = Figure(model)
    points = covering_points(figure)
    state = figure.to_state(model.qpos0)[None]
    centres, _, _ = Contact(points, (FLOOR,)).centres(Samples(figure, state, 0 * state, 0 * state))
    centres, radii = centres[:, :, 0], np.array([point.radius for point in points])
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    moving = [g for g in range(model.ngeom) if model.geom_bodyid[g]]
    assert {point.link for point in points} == {1, 2}
    nearest = np.full(len(points), np.inf)
    for geom in moving:
        turn, place = data.geom_xmat[geom].reshape(3, 3), data.geom_xpos[geom]
        world = (place + skin(model, geom, rng) @ turn.T).T
        gaps = np.linalg.norm(world[:, :, None] - centres[:, None], axis=0) - radii
        if model.geom_type[geom] in (mujoco.mjtGeom.mjGEOM_SPHERE, mujoco.mjtGeom.mjGEOM_CAPSULE):
            assert gaps.min(axis=1).max() < 0.0015
        if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_ELLIPSOID:
            assert gaps.min(axis=1).max() < 0.003
    probe = mujoco.MjModel.from_xml_string(
        LEG.replace(
            "</worldbody>", '<body name="probe"><freejoint/><geom name="probe" size=".001"/></body></worldbody>'
        )
    )
    mujoco.mj_kinematics(probe, whole := mujoco.MjData(probe))
    for i in range(len(points)):
        whole.qpos[-7:-4] = centres[:, i]
        mujoco.mj_kinematics(probe, whole)
        own = [
            mujoco.mj_geomDistance(probe, whole, probe.geom("probe").id, g, 1, None) + 0.001
            for g in range(probe.ngeom - 1)
        ]
        nearest[i] = min(own) + radii[i]
    assert nearest.max() < 1e-3
