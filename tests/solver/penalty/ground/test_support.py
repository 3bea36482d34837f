"""Support and flight: values against MuJoCo and SciPy, and motions that obey them."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import WOOD, contact_on, figure_of, support_of
from gradients import assembled, curvature_of, shifted
from oracles import mujoco_forces
from random_models import at_times, random_samples
from scipy.optimize import nnls

from dynsplines.solver import quaternion as quat
from dynsplines.solver.cone import projection
from dynsplines.solver.figure.dynamics import RootWrench, weight
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Flight, Support
from dynsplines.solver.penalty.ground.support import friction_edges
from dynsplines.solver.surface.points import Point

UP = np.array([0.0, 0, 1])


TABLE = """<mujoco><option gravity="0 0 -10"/><worldbody><body pos="0 0 1"><freejoint/>
<inertial mass="3" pos="0 0 0" diaginertia=".2 .3 .4"/></body></worldbody></mujoco>"""


def test_it_is_what_the_best_forces_in_the_friction_pyramids_leave(figure, rng):
    samples = at_times(random_samples(figure, rng, 5), np.array([0.2, 0.64, 0.8, 1.4, 1.8]))
    support = support_of(figure, rng)
    wrench, expected = RootWrench(samples, 1), []
    for s, names in enumerate(["a", "abc", "", "b", None]):
        columns = []
        for footing in support.footings:
            link = footing.point.link
            if names is not None and footing.point.name in names:
                offset = samples.links.rotation[:, :, link, s] @ footing.point.position
                lever = samples.links.x[:, link, s] + offset - wrench.centre[:, s]
                for edge in friction_edges(footing.normal, 0.8).T:
                    columns.append(np.append(edge, np.cross(lever, edge) / support.length))
        w = np.append(wrench.force[:, s], wrench.moment[:, s] / support.length) / support.unit
        matrix = np.array(columns).reshape(-1, 6).T
        k = matrix.shape[1]
        soft = np.vstack([matrix, np.sqrt(support.softness) * np.eye(k)])
        left = nnls(soft, np.append(w, np.zeros(k)))[1] ** 2 if k else w @ w
        expected.append(0 if names is None else left)
    np.testing.assert_allclose(support.evaluate(samples), expected, rtol=1e-8)
    assert expected[0] > 0 < expected[2]


@pytest.mark.parametrize("wood", [False, True])
def test_the_curvature_is_the_second_derivative_the_wrench_itself_taken_as_linear(figure, rng, wood):
    """Against E of w + (∂w/∂y) δ − δ(G λ) with the forces held, which is quadratic while its edges stay."""
    if wood:
        figure = figure_of(WOOD)
    root = int(figure.tables.free_links[0])
    samples = at_times(random_samples(figure, rng, 3), np.array([0.1, 0.4, 1.0]))
    inside = np.flatnonzero(figure.tables.path[:, root])
    feet = (contact_on(Point("a", int(inside[-1]), rng.normal(size=3)), 0.0, 0.2, UP),)
    support = Support.of(figure, root, feet, ((0.3, 0.5), (0.9, 1.1)))
    scale, h = rng.uniform(0.5, 2, 3), 1e-5
    phi = rng.normal(size=(3, 3, 1))
    found = assembled(curvature_of(support, samples, scale), phi)
    shares = support._evaluate(samples, np.arange(samples.count))
    direction = rng.normal(size=figure.width)
    by = np.einsum("so,n->osn", phi[:, :, 0], direction)

    def residual(seen: Samples) -> np.ndarray:
        """w − G λ with the forces at the points held, (6, S)."""
        wrench = RootWrench(seen, root)
        x, rotation = seen.links.poses(shares.pushes.link * seen.count + shares.pushes.at)
        position = np.array([feet[0].point.position] * shares.pushes.at.size).reshape(-1, 3).T
        lever = x + np.einsum("ijp,jp->ip", rotation, position) - wrench.centre[:, shares.pushes.at]
        both = np.concatenate([wrench.force, wrench.moment / support.length])
        pushed = np.concatenate([shares.pushes.force, np.cross(lever, shares.pushes.force, axis=0) / support.length])
        both -= np.array([np.bincount(shares.pushes.at, part, seen.count) for part in pushed], float)
        return both / support.unit

    slope = (residual(shifted(samples, h * by)) - residual(shifted(samples, -h * by))) / (2 * h)
    expected = (
        2
        * scale
        * np.einsum("is,sij,js->s", slope, projection(shares.unsupplied, shares.edges, support.softness), slope)
    )
    np.testing.assert_allclose(np.einsum("n,snm,m->s", direction, found, direction), expected, rtol=1e-5)


def table(x: float, count: int = 3) -> tuple[Figure, Support, Samples]:
    """A body that is `x` m before the middle of two feet, at rest, at times at which both or one of them hold."""
    figure = figure_of(TABLE)
    feet = [
        contact_on(Point(f"foot {side}", 1, np.array([side - x, 0, -1])), 0, last, UP)
        for side, last in ((-0.2, 9.0), (0.2, 1.5))
    ]
    support = replace(Support.of(figure, 1, feet, ((7.0, 8.0),)), softness=1e-9)
    y = np.tile([0, 0, 1, 1, 0, 0, 0.0], (count, 1))
    return figure, support, Samples(figure, y, 0 * y, 0 * y, t=np.arange(count))


@pytest.mark.parametrize("x", [0.0, 0.1, -0.15])
def test_the_forces_on_feet_carry_the_weight_by_the_law_of_the_lever(x):
    _, support, samples = table(x)
    found = support.reactions(samples)
    np.testing.assert_array_equal(found.at, [0, 0, 1, 1, 2])
    np.testing.assert_array_equal(found.footing, [0, 1, 0, 1, 0])
    np.testing.assert_allclose(found.place[:, :2], [[-0.2 - x, 0.2 - x], [0, 0], [0, 0]], atol=1e-12)
    both = found.force[:, :2]
    np.testing.assert_allclose(both.sum(axis=1), [0, 0, 30], atol=1e-4)
    np.testing.assert_allclose(both[2], [30 * (0.2 - x) / 0.4, 30 * (0.2 + x) / 0.4], atol=1e-3)
    np.testing.assert_allclose(both, found.force[:, 2:4], atol=1e-9)
    left = support.rest(samples)
    np.testing.assert_allclose(left[:, :2], 0, atol=1e-4)
    assert np.abs(left[:, 2]).max() > 0.01  # one foot beside the middle cannot carry it at rest


G = 9.81


BRICK = f"""<mujoco><option gravity="0 0 -{G}"/><worldbody><body><freejoint/>
<inertial mass="3" pos=".1 .2 .3" diaginertia=".2 .3 .4"/></body></worldbody></mujoco>"""


ALL = ((-1.0, 9.0),)


def test_it_is_the_root_force_of_mj_inverse_in_weights_while_a_flight_lasts(figure, rng):
    samples = at_times(random_samples(figure, rng, 6), np.array([0.0, 0.1, 0.2, 0.3, 0.6, 0.7]))
    expected = np.sum(mujoco_forces(samples)[:, :3] ** 2, axis=1) / weight(figure, 1) ** 2
    expected[[0, 4]] = 0
    found = Flight.of(figure, 1, ((0.05, 0.4), (0.7, 0.8))).evaluate(samples)
    np.testing.assert_allclose(found, expected, rtol=1e-9)
    assert np.count_nonzero(expected) == 4


def thrown() -> Samples:
    """A body of three different moments of inertia that tumbles freely, by MuJoCo's own simulation."""
    figure = figure_of(BRICK)
    model, data = figure.model, mujoco.MjData(figure.model)
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    data.qvel[:] = 1, -0.5, 3, 2, -3, 1
    y, y_d, y_dd = np.zeros((3, 20, 7))
    model.opt.timestep = 0.02
    for i in range(20):
        mujoco.mj_forward(model, data)
        spin, spin_rate = data.qvel[3:], data.qacc[3:]
        q = data.qpos[3:].copy()
        q_d = 0.5 * quat.product(q, np.append(0, spin))
        y[i], y_d[i] = data.qpos, np.append(data.qvel[:3], q_d)
        y_dd[i, :3] = data.qacc[:3]
        y_dd[i, 3:] = 0.5 * (quat.product(q_d, np.append(0, spin)) + quat.product(q, np.append(0, spin_rate)))
        mujoco.mj_step(model, data)
    return Samples(figure, y, y_d, y_dd)


def test_a_body_that_tumbles_freely_costs_nothing_and_one_that_hovers_one():
    samples = thrown()
    flight = Flight.of(samples.figure, 1, ALL, 1.0)
    assert flight.evaluate(samples).max() < 1e-20
    still = Samples(samples.figure, samples.y, 0 * samples.y, 0 * samples.y)
    np.testing.assert_allclose(flight.evaluate(still), 1.0, rtol=1e-12)
