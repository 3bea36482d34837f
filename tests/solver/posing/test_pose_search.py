"""The search of poses by least squares."""

from __future__ import annotations

from collections.abc import Callable

import mujoco
import numpy as np
import pytest
from figures import EVERY_JOINT, LEG, MIXED, figure_of
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import SiteGoal, kinematics
from scipy.optimize import least_squares, lsq_linear
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.penalty import Bend, BendLimits
from dynsplines.solver.posing import MET, BodyGoal, Goal, LeastSquares, PointGoal, PoseSearch, Residuals, posed
from dynsplines.solver.surface.points import Point, site_points

RANGED = """
<mujoco><compiler angle="radian"/><worldbody><body name="trunk" pos="0 0 1"><freejoint/><geom size=".1"/>
  <body name="arm" pos="0 .2 .4" quat=".9 .1 -.2 .3"><joint name="shoulder" type="ball" range="0 1.2"/>
    <geom size=".1" pos=".3 0 0"/>
    <body name="fore" pos=".3 0 0"><joint name="elbow" type="hinge" axis="0 1 0" range="-.1 2"/><geom size=".1"/>
      <body name="rod" pos=".3 0 0"><joint name="reach" type="slide" axis="1 0 0" range="-.4 .1"/><geom size=".05"/>
        <site name="tip" pos=".1 .02 .03"/></body></body></body>
  <body name="leg" pos="0 -.2 0"><joint name="hip" type="hinge" axis="0 1 0" range="-2 .2"/><geom size=".1"/>
    <body name="shin" pos="0 0 -.4" quat=".7 .1 .2 -.1"><joint name="knee" type="ball"/><geom size=".1" pos="0 0 -.2"/>
      <body name="foot" pos="0 0 -.4"><joint name="free" type="hinge" axis="1 0 0"/><geom size=".1"/>
        <site name="toe" pos=".1 0 0"/></body></body></body>
</body></worldbody></mujoco>"""


def somewhere(model: mujoco.MjModel, rng: np.random.Generator, size: float = 1.0) -> Array:
    qpos = np.array(model.qpos0)
    mujoco.mj_integratePos(model, qpos, size * rng.normal(size=model.nv), 1.0)
    return qpos


def differences(model: mujoco.MjModel, qpos: Array, values: Callable[[Array], Array], h: float = 1e-6) -> Array:
    """(k, nv): how values of a pose change along every velocity."""
    columns = []
    for direction in np.eye(model.nv):
        ends = np.array(qpos), np.array(qpos)
        for end, way in zip(ends, (h, -h), strict=True):
            mujoco.mj_integratePos(model, end, direction, way)
        columns.append((values(ends[0]) - values(ends[1])) / (2 * h))
    return np.array(columns).T


def assert_rows(goal: Goal, model: mujoco.MjModel, qpos: Array, atol: float = 1e-7) -> None:
    expected = differences(model, qpos, lambda at: np.array(goal.missed(model, kinematics(model, at))))
    np.testing.assert_allclose(goal.rows(model, kinematics(model, qpos)), expected, atol=atol)


@pytest.mark.parametrize("free", [(), (0,), (2,), (0, 1)])
def test_points_and_sites_miss_what_mujoco_has_between_them_and_their_place_along_the_axes_that_are_given(free, rng):
    figure = figure_of(LEG)
    model, position = figure.model, rng.normal(size=3)
    position[list(free)] = np.nan
    given = np.delete(np.arange(3), free)
    for name in ("heel", "toe"):  # a heel on a body that is welded on, and turned
        qpos = somewhere(model, rng)
        data, (point,) = kinematics(model, qpos), site_points(figure, [name])
        expected = (data.site(name).xpos - position)[given]
        for goal in (SiteGoal(name, position), PointGoal.of(figure, point, position)):
            np.testing.assert_allclose(goal.missed(model, data), expected, atol=1e-12)
            assert_rows(goal, model, qpos)
        plain = PointGoal.of(figure, point)
        np.testing.assert_allclose(plain.missed(model, data), data.site(name).xpos, atol=1e-12)
        np.testing.assert_allclose(plain.places(data)[0], data.site(name).xpos, atol=1e-12)
        assert plain.bodies(model) == [figure.links[point.link].body]


@pytest.mark.parametrize("text", [MIXED, EVERY_JOINT, LEG])
def test_a_body_misses_its_rotation_by_scipys_rotation_vector_which_changes_as_its_rows_say(text, rng):
    model = figure_of(text).model
    qpos, body = somewhere(model, rng), model.nbody - 1
    data, turn = kinematics(model, qpos), Rotation.random(None, np.random.default_rng(3))
    x, y, z, w = turn.as_quat()
    goal = BodyGoal(model.body(body).name, np.array([w, x, y, z]))
    here = Rotation.from_matrix(data.xmat[body].reshape(3, 3))
    np.testing.assert_allclose(goal.missed(model, data), (here * turn.inv()).as_rotvec(), atol=1e-9)
    there = BodyGoal("by number", np.array(data.xquat[body]), body)
    assert there.bodies(model) == goal.bodies(model) == [body]
    np.testing.assert_allclose(there.missed(model, data), 0, atol=1e-9)
    assert_rows(there, model, qpos)


def test_a_body_that_leans_misses_upright_by_its_lean_about_the_axis_that_it_leans_about(rng):
    figure = figure_of(LEG)
    model, heading, lean = figure.model, Rotation.from_rotvec([0, 0, 0.8]), np.array([0.3, -0.5, 0.0])
    qpos = np.array(model.qpos0)
    x, y, z, w = (Rotation.from_rotvec(lean) * heading).as_quat()
    qpos[3:7] = w, x, y, z
    goal = BodyGoal("foot")  # turned at rest already
    np.testing.assert_allclose(goal.missed(model, kinematics(model, qpos)), lean[:2], atol=1e-12)
    x, y, z, w = heading.as_quat()
    qpos[3:7] = w, x, y, z
    np.testing.assert_allclose(goal.missed(model, kinematics(model, qpos)), [0, 0], atol=1e-12)
    for angle in range(9):  # upside down, with rounding of the cosine on either side of -1
        over = np.array(qpos)
        over[3:7] = 0, np.cos(angle), np.sin(angle), 0
        assert np.linalg.norm(goal.missed(model, kinematics(model, over))) == pytest.approx(np.pi)
    nearly = np.array(qpos)
    mujoco.mj_integratePos(model, nearly, np.eye(model.nv)[3], 1e-5)
    assert_rows(goal, model, nearly, atol=2e-5)


def test_what_a_search_adds_up_changes_as_its_rows_say(rng):
    """Away from home, from the goals and over the bounds, along every free velocity."""
    figure = figure_of(RANGED)
    home = somewhere(figure.model, rng, 0.2)
    knee = next(i for i, link in enumerate(figure.links) if link.name == "knee")
    bends = BendLimits((Bend("knee", knee, np.array([0.0, 1, 0]), np.array([0.0, 0, -1])),), 0.1, 0.2, 0.3)
    goals = (SiteGoal("tip", np.ones(3)), PointGoal.of(figure, Point("foot", len(figure.links) - 1, np.ones(3))))
    preferred = ((0.3, SiteGoal("toe", np.zeros(3))),)
    search = PoseSearch(figure, home, np.ones(figure.model.nq, bool), goals, bends, preferred=preferred)
    near = search.moved(home, 1e-3 * rng.normal(size=search.dofs.size))
    rows = np.concatenate([rows for _, rows in search.linearised(near)])
    expected = differences(
        figure.model, near, lambda at: np.concatenate([values for values, _ in search.linearised(at)])
    )
    np.testing.assert_allclose(rows, expected[:, search.dofs], atol=2e-2)
    np.testing.assert_allclose(rows[search.dofs.size :], expected[search.dofs.size :, search.dofs], atol=1e-5)


@pytest.mark.parametrize(("flexion", "added"), [(0.0, 0.4), (0.3, 0.1), (0.5, 0.0)])
def test_a_start_bends_knees_that_are_straighter_and_no_others(flexion, added):
    figure = figure_of(RANGED)
    knee = next(i for i, link in enumerate(figure.links) if link.name == "knee")
    bends = BendLimits((Bend("knee", knee, np.array([0.0, 1, 0]), np.array([0.0, 0, -1])),))
    free, goals = np.ones(figure.model.nq, bool), (SiteGoal("toe", np.zeros(3)),)
    search = PoseSearch(figure, np.array(figure.model.qpos0), free, goals, bends)
    qpos, columns = np.array(figure.model.qpos0), figure.links[knee].qpos + np.arange(4)
    lateral = quat.rotated(quat.inverse(figure.links[knee].turn), np.array([0.0, 1, 0]))
    qpos[columns] = quat.from_rotation_vector(flexion * lateral)
    start = search.begun(qpos, 0.4)
    np.testing.assert_allclose(start[columns], quat.from_rotation_vector((flexion + added) * lateral), atol=1e-12)


@pytest.mark.parametrize("starts", [1, 3, 5])
def test_a_pose_out_of_reach_tells_how_many_were_begun_with_and_one_in_reach_none(starts):
    figure = figure_of(RANGED)
    free = np.ones(figure.model.nq, bool)
    free[:7] = False
    home = np.array(figure.model.qpos0)
    mid = somewhere(figure.model, np.random.default_rng(3), 0.0)
    for name, by in (("elbow", 0.8), ("reach", -0.1)):
        mid[figure.model.joint(name).qposadr[0]] = by
    near = kinematics(figure.model, mid).site("tip").xpos
    found = posed(figure, home, free, [SiteGoal("tip", near)], starts=starts)
    assert found.is_met
    assert found.starts == 0
    assert found.worst <= MET
    far = posed(figure, home, free, [SiteGoal("tip", near + 5.0)], starts=starts)
    assert not far.is_met
    assert far.starts == starts
    assert far.worst == pytest.approx(far.missed[0])
    seen = kinematics(figure.model, far.qpos).site("tip").xpos
    assert far.missed[0] == pytest.approx(np.linalg.norm(seen - near - 5.0))
    np.testing.assert_array_equal(far.qpos[:7], home[:7])


def moved(poses, step):
    return poses + step


def linear(rows, wanted, two_sided, steps=200):
    """|rows x - wanted|², of which all after the first `two_sided` residuals are one-sided."""

    def residuals(poses, which):
        return Residuals(poses @ rows.T - wanted, np.broadcast_to(rows, (len(poses), *rows.shape)), two_sided)

    return LeastSquares(residuals, moved, np.ones(rows.shape[1]), steps)


@pytest.mark.parametrize("size", [1.0, 1e5])  # the larger by an orthogonal factorisation
def test_a_linear_problem_is_solved_as_scipy_solves_it(size, rng):
    rows, wanted = rng.normal(size=(9, 5)), rng.normal(size=9)
    rows[:4] *= size
    wanted[:4] *= size
    poses, costs = linear(rows, wanted, 9).descended(np.zeros((1, 5)))
    expected = lsq_linear(rows, wanted)
    np.testing.assert_allclose(poses[0], expected.x, rtol=1e-6, atol=1e-9)
    assert costs[0] == pytest.approx(2 * expected.cost)


def test_stiff_one_sided_residuals_are_bounds(rng):
    """The solution is SciPy's with the same bounds, but for the little by which a spring yields."""
    for _ in range(20):
        rows, wanted = rng.normal(size=(8, 4)), 3 * rng.normal(size=8)
        stiff = 1e4 * np.concatenate([np.eye(4), -np.eye(4)])
        both = np.concatenate([rows, stiff]), np.append(wanted, 0.3e4 * np.ones(8))
        poses, _ = linear(*both, 8).descended(np.zeros((1, 4)))
        np.testing.assert_allclose(poses[0], lsq_linear(rows, wanted, bounds=(-0.3, 0.3)).x, atol=1e-5)


@given(st.integers(0, 10_000))
@settings(max_examples=30, deadline=None)
def test_curved_residuals_are_minimised_as_by_scipy(seed):
    """Rosenbrock's valley and its mirror images, from random poses, all at once; each costs no more than alone."""
    begin = np.random.default_rng(seed).uniform(-2, 2, (5, 2))

    def values(x, scale):
        return np.stack([scale * (x[..., 1] - x[..., 0] ** 2), 1 - x[..., 0]], axis=-1)

    scales = np.array([1.0, 10, -10, 3, 30])

    def residuals(poses, which):
        rows = np.zeros((len(poses), 2, 2))
        rows[:, 0, 0], rows[:, 0, 1], rows[:, 1, 0] = -2 * scales[which] * poses[:, 0], scales[which], -1
        return Residuals(values(poses, scales[which]), rows, 2)

    poses, costs = LeastSquares(residuals, moved, np.ones(2), 300, longest=0.5).descended(begin)
    for start, pose, cost, scale in zip(begin, poses, costs, scales, strict=True):
        expected = least_squares(values, start, args=(scale,))
        assert cost <= 2 * expected.cost + 1e-12
        np.testing.assert_allclose(pose, expected.x, atol=1e-5)


def test_nothing_to_move_stays(rng):
    poses, costs = LeastSquares(
        lambda poses, which: Residuals(np.ones((len(poses), 1)), np.zeros((len(poses), 1, 3)), 1),
        moved, np.ones(3), 10,
    ).descended(np.ones((4, 3)))  # fmt: skip
    np.testing.assert_array_equal(poses, np.ones((4, 3)))
    np.testing.assert_array_equal(costs, 1)
