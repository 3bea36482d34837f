"""Poses by position: least squares, round trips through MuJoCo's kinematics, what stays, ranges, bends, misses."""

from collections.abc import Sequence

import figures
import mujoco
import numpy as np
import pytest
from figures import EVERY_JOINT, LEG, MIXED, figure_of, link_named
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import SiteGoal, differences, kinematics
from scipy.optimize import lsq_linear, minimize
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines import models
from dynsplines.clip.kinds import Options, posing_limits
from dynsplines.clip.posing.places import sole_points
from dynsplines.solver import posing
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.points import Point, site_points


def somewhere(model: mujoco.MjModel, rng: np.random.Generator, size: float = 1.0) -> Array:
    qpos = np.array(model.qpos0)
    mujoco.mj_integratePos(model, qpos, size * rng.normal(size=model.nv), 1.0)
    return qpos


def assert_rows(goal: posing.Goal, model: mujoco.MjModel, qpos: Array, atol: float = 1e-7) -> None:
    expected = differences(model, qpos, lambda at: np.array(goal.residual(model, kinematics(model, at))))
    np.testing.assert_allclose(goal.linearise(model, kinematics(model, qpos))[1], expected, atol=atol)


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
        for goal in (SiteGoal(name, position), posing.PointGoal.of(figure, point, position)):
            np.testing.assert_allclose(goal.residual(model, data), expected, atol=1e-12)
            assert_rows(goal, model, qpos)
        plain = posing.PointGoal.of(figure, point)
        np.testing.assert_allclose(plain.residual(model, data), data.site(name).xpos, atol=1e-12)
        np.testing.assert_allclose(plain.places(data)[0], data.site(name).xpos, atol=1e-12)
        assert plain.bodies(model) == [figure.links[point.link].body]


@pytest.mark.parametrize("text", [MIXED, EVERY_JOINT, LEG])
def test_a_body_misses_its_rotation_by_scipys_rotation_vector_which_changes_as_its_rows_say(text, rng):
    model = figure_of(text).model
    qpos, body = somewhere(model, rng), model.nbody - 1
    data, turn = kinematics(model, qpos), Rotation.random(None, np.random.default_rng(3))
    x, y, z, w = turn.as_quat()
    goal = posing.BodyGoal(model.body(body).name, np.array([w, x, y, z]))
    here = Rotation.from_matrix(data.xmat[body].reshape(3, 3))
    np.testing.assert_allclose(goal.residual(model, data), (here * turn.inv()).as_rotvec(), atol=1e-9)
    there = posing.BodyGoal("by number", np.array(data.xquat[body]), body)
    assert there.bodies(model) == goal.bodies(model) == [body]
    np.testing.assert_allclose(there.residual(model, data), 0, atol=1e-9)
    assert_rows(there, model, qpos)


def test_a_body_that_leans_misses_upright_by_its_lean_about_the_axis_that_it_leans_about(rng):
    figure = figure_of(LEG)
    model, heading, lean = figure.model, Rotation.from_rotvec([0, 0, 0.8]), np.array([0.3, -0.5, 0.0])
    qpos = np.array(model.qpos0)
    x, y, z, w = (Rotation.from_rotvec(lean) * heading).as_quat()
    qpos[3:7] = w, x, y, z
    goal = posing.BodyGoal("foot")  # turned at rest already
    np.testing.assert_allclose(goal.residual(model, kinematics(model, qpos)), lean[:2], atol=1e-12)
    x, y, z, w = heading.as_quat()
    qpos[3:7] = w, x, y, z
    np.testing.assert_allclose(goal.residual(model, kinematics(model, qpos)), [0, 0], atol=1e-12)
    for angle in range(9):  # upside down, with rounding of the cosine on either side of -1
        over = np.array(qpos)
        over[3:7] = 0, np.cos(angle), np.sin(angle), 0
        assert np.linalg.norm(goal.residual(model, kinematics(model, over))) == pytest.approx(np.pi)
    nearly = np.array(qpos)
    mujoco.mj_integratePos(model, nearly, np.eye(model.nv)[3], 1e-5)
    assert_rows(goal, model, nearly, atol=2e-5)


def moved(pose, step):
    return pose + step


def linear(rows, wanted, two_sided, steps=200):
    """|rows x - wanted|², of which all after the first `two_sided` residuals are one-sided."""

    def residuals(pose):
        return posing.Residuals(rows @ pose - wanted, rows, two_sided)

    return lambda start: posing.minimise(residuals, moved, np.ones(rows.shape[1]), start, steps)


@pytest.mark.parametrize("size", [1.0, 1e5])  # the larger by an orthogonal factorisation
def test_a_linear_problem_is_solved_as_scipy_solves_it(size, rng):
    rows, wanted = rng.normal(size=(9, 5)), rng.normal(size=9)
    rows[:4] *= size
    wanted[:4] *= size
    pose, cost = linear(rows, wanted, 9)(np.zeros(5))
    expected = lsq_linear(rows, wanted)
    np.testing.assert_allclose(pose, expected.x, rtol=1e-6, atol=1e-9)
    assert cost == pytest.approx(2 * expected.cost)


def test_stiff_one_sided_residuals_are_bounds(rng):
    """The solution is SciPy's with the same bounds, but for the little by which a spring yields."""
    for _ in range(20):
        rows, wanted = rng.normal(size=(8, 4)), 3 * rng.normal(size=8)
        stiff = 1e4 * np.concatenate([np.eye(4), -np.eye(4)])
        both = np.concatenate([rows, stiff]), np.append(wanted, 0.3e4 * np.ones(8))
        pose, _ = linear(*both, 8)(np.zeros(4))
        np.testing.assert_allclose(pose, lsq_linear(rows, wanted, bounds=(-0.3, 0.3)).x, atol=1e-5)


HUMAN = {c: Figure(mujoco.MjModel.from_xml_string(models.figure_text("human")), c) for c in ("world", "joint")}
BENDS = posing_limits(HUMAN["world"], {"limits": Options(least_bend=2.0)})
SITES = [f"{side}_{part}" for side in ("left", "right") for part in ("heel", "toe", "hand", "wrist")]
ARM = read_data("arm_with_rod.xml")


def seen(figure: Figure, qpos: Array) -> mujoco.MjData:
    return kinematics(figure.model, qpos)


def human_pose(rng: np.random.Generator) -> Array:
    """Limbs turned within what people can do, knees and elbows bent forward only, the root anywhere."""
    figure = HUMAN["world"]
    assert BENDS is not None
    bends = {joint.link: joint for joint in BENDS.joints}
    qpos = np.array(figure.model.qpos0)
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind is JointKind.FREE:
            qpos[:3] += rng.uniform(-0.3, 0.3, 3)
        columns = quaternion_columns(link)
        assert columns is not None
        if i in bends:
            turn = rng.uniform(np.radians(5), np.radians(110)) * bends[i].lateral
        else:
            turn = rng.uniform(0, 0.6) * quat.normalise(rng.normal(size=3))
        qpos[columns] = quat.from_rotation_vector(turn)
    return qpos


def assert_human(qpos: Array) -> None:
    """Within all joints' ranges, and no knee or elbow bent backward, sideways or twisted beyond its bound."""
    figure = HUMAN["world"]
    assert BENDS is not None
    for link in figure.links[2:]:
        angle = np.linalg.norm(quat.rotation_vector(qpos[link.qpos : link.qpos + 4]))
        assert angle <= figure.model.jnt_range[link.joint, 1]
    own = np.array([qpos[figure.links[joint.link].columns] for joint in BENDS.joints])
    flexion, sideways, twist = BENDS.angles(Samples.of_qpos(figure, qpos))[..., 0]
    changed = np.any(own != figure.model.qpos0[7:11], axis=1)
    assert np.all(flexion[changed] >= BENDS.least)
    assert np.all(np.abs(sideways) <= BENDS.sideways)
    assert np.all(np.abs(twist) <= BENDS.twist)


def everything(figure: Figure) -> Mask:
    return np.ones(figure.width, bool)


@pytest.mark.slow
@settings(max_examples=2, deadline=None)
@given(seed=st.integers(0, 10**6), side=st.sampled_from(["left", "right"]), limb=st.sampled_from(["heel", "hand"]))
def test_only_what_is_free_moves_and_what_is_missed_is_told(seed, side, limb):
    figure, rng = HUMAN["world"], np.random.default_rng(seed)
    home = human_pose(rng)
    free = np.zeros(figure.width, bool)
    for joint in ("knee", "hip", "ankle") if limb == "heel" else ("shoulder", "elbow"):
        link = link_named(figure, f"{side}_{joint}")
        assert link is not None
        free[figure.links[link].columns] = True
    name = f"{side}_{limb}"
    target = seen(figure, home).site(name).xpos + rng.uniform(-0.4, 0.4, 3)
    found = posing.find_pose(figure, home, free, [SiteGoal(name, target)], BENDS)
    np.testing.assert_array_equal(found.qpos[~free], home[~free])
    off = np.linalg.norm(seen(figure, found.qpos).site(name).xpos - target)
    assert found.missed[0] == pytest.approx(off, abs=1e-9)
    assert found.is_met == (off <= posing.MET)
    before = np.linalg.norm(seen(figure, home).site(name).xpos - target)
    assert off <= before


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_pose_that_is_there_already_stays_to_the_bit(coordinates):
    figure = HUMAN[coordinates]
    home = human_pose(np.random.default_rng(3))
    goals = [SiteGoal(name, seen(figure, home).site(name).xpos.copy()) for name in SITES]
    found = posing.find_pose(figure, home, everything(figure), goals, BENDS)
    np.testing.assert_array_equal(found.qpos, home)
    assert found.is_met


def test_a_straight_leg_shortens_forward_at_the_knee():
    figure = HUMAN["world"]
    target = seen(figure, figure.model.qpos0).site("right_heel").xpos + np.array([0.0, 0, 0.15])
    free = everything(figure)
    free[:7] = False
    found = posing.find_pose(
        figure, figure.model.qpos0, free, [SiteGoal("right_heel", target), posing.BodyGoal("right_foot")], BENDS
    )
    assert found.is_met
    knee = link_named(figure, "right_knee")
    assert knee is not None
    turn = np.degrees(quat.rotation_vector(found.qpos[figure.links[knee].columns]))
    assert turn[1] > 20
    np.testing.assert_allclose(turn[[0, 2]], 0, atol=1)
    assert_human(found.qpos)


@pytest.mark.parametrize("rest", [[1.0, 0, 0, 0], [0.9, 0.1, -0.2, 0.3]])
def test_flat_is_upright_as_at_rest_with_the_heading_free(rest):
    turn = " ".join(map(str, rest))
    figure = figure_of(
        f'<mujoco><worldbody><body name="sole" quat="{turn}"><joint name="j" type="ball"/><geom size=".1"/></body>'
        "</worldbody></mujoco>"
    )
    home = quat.from_rotation_vector(np.array([2.0, -1.0, 0.7]))
    found = posing.find_pose(figure, home, np.ones(4, bool), [posing.BodyGoal("sole")])
    up = quat.rotate(quat.product(seen(figure, found.qpos).body("sole").xquat, quat.inverse(rest)), [0.0, 0, 1])
    np.testing.assert_allclose(up, [0, 0, 1], atol=1e-6)
    assert found.is_met
    turned = quat.angle_between(home, found.qpos)
    tilt = quat.rotate(quat.product(quat.product(rest, home), quat.inverse(rest)), [0.0, 0, 1])
    assert turned == pytest.approx(np.arccos(tilt[2]), abs=1e-6)  # the shortest way up, no turn about the vertical


SHOULDER = """<mujoco><compiler angle="degree"/><worldbody>
<body pos="0 0 1"><joint axis="0 1 0" range="-90 90"/><geom size=".02" pos=".1 0 0"/>
  <body pos=".3 0 0"><joint axis="0 1 0" range="0 120"/><geom size=".02" pos=".1 0 0"/>
    <body pos=".3 0 0"><joint axis="0 0 1" range="-60 60"/><geom size=".02" pos=".1 0 0"/>
      <site name="tip" pos=".2 0 0"/>
</body></body></body></worldbody></mujoco>"""


def test_places_that_need_joints_at_the_very_ends_of_their_ranges_are_met(rng):
    figure = figure_of(SHOULDER)
    ends = figure.model.jnt_range
    for _ in range(8):
        qpos = np.where(rng.random(3) < 0.6, ends[np.arange(3), rng.integers(2, size=3)], rng.uniform(*ends.T))
        target = seen(figure, qpos).site("tip").xpos.copy()
        assert posing.find_pose(figure, np.radians([0, 30, 0]), np.ones(3, bool), [SiteGoal("tip", target)]).is_met


@pytest.mark.parametrize("reach", [2.6, 2.8])
@pytest.mark.parametrize("side", [-1, 1])
def test_with_joints_at_their_ranges_it_is_as_near_as_scipys(reach, side):
    figure = figure_of(ARM.replace("-150 150", "-10 10").replace("-.1 .2", "-.02 .01"))
    home, weights = np.array([0.3 * side, 0, 0.1, 0]), np.array([1.0, 1, 1, 5])
    target = np.array([0.0, 0, 1]) + reach * np.array([np.cos(0.3), 0, -side * np.sin(0.3)])

    def cost(qpos: Array) -> float:
        return float(np.sum((weights * (qpos - home)) ** 2))

    found = posing.find_pose(figure, home, np.ones(4, bool), [SiteGoal("tip", target)])
    assert found.is_met
    hinge, low, high = np.radians(10) - posing.bounds.INSIDE, -0.02 + posing.bounds.INSIDE, 0.01 - posing.bounds.INSIDE
    np.testing.assert_allclose([abs(found.qpos[1]), found.qpos[3]], [hinge, low], atol=1e-8)
    best = minimize(
        cost,
        found.qpos,
        method="SLSQP",
        bounds=[(None, None), (-hinge, hinge), (None, None), (low, high)],
        constraints={"type": "eq", "fun": lambda qpos: (seen(figure, qpos).site("tip").xpos - target)[[0, 2]]},
        options={"ftol": 1e-14},
    )
    assert cost(found.qpos) == pytest.approx(best.fun, rel=1e-6)


HOLDING = read_data("holding.xml")


def test_a_hold_misses_what_mujoco_has_between_its_places_and_changes_as_both_bodies_move(rng):
    figure = figure_of(HOLDING)
    palm, grip = site_points(figure, ["palm", "grip"])
    goal = posing.PointGoal.of(figure, palm, grip.position, grip.link)
    qpos = np.array(figure.model.qpos0)
    mujoco.mj_integratePos(figure.model, qpos, rng.normal(size=figure.model.nv), 1.0)

    def missed(qpos: Array) -> Array:
        data = seen(figure, qpos)
        return data.site("palm").xpos - data.site("grip").xpos

    data = seen(figure, qpos)
    mujoco.mj_comPos(figure.model, data)
    np.testing.assert_allclose(goal.residual(figure.model, data), missed(qpos), atol=1e-12)
    assert_rows(goal, figure.model, qpos)
    found = posing.find_pose(figure, qpos, everything(figure), [goal])
    assert found.is_met
    np.testing.assert_allclose(missed(found.qpos), 0, atol=posing.MET)


def test_what_is_out_of_reach_is_missed_by_the_gap():
    figure = figure_of(ARM)
    found = posing.find_pose(
        figure, np.array([0.5, 0.5, 0.5, 0]), np.ones(4, bool), [SiteGoal("tip", np.array([4.0, 0, 1]))]
    )
    assert not found.is_met
    assert found.missed[0] == pytest.approx(4 - 3.2, abs=1e-3)
    np.testing.assert_allclose(found.qpos, [0, 0, 0, 0.2], atol=1e-2)


DRAWS = 6
ENDS = ("left_hand", "right_hand")


def drawn(figure: Figure, rng: np.random.Generator) -> Array:
    """Every hinge somewhere in its range, the root turned and moved a little."""
    qpos = np.array(figure.model.qpos0)
    qpos[:3] += rng.uniform(-0.3, 0.3, 3)
    qpos[3:7] = quat.from_rotation_vector(0.3 * rng.normal(size=3) / np.sqrt(3))
    for link in figure.links[2:]:
        qpos[link.qpos] = rng.uniform(*figure.model.jnt_range[link.joint])
    return qpos


def asked_again(figure: Figure, points: Sequence[Point], wanted: Array, rng: np.random.Generator) -> list[posing.Goal]:
    """One or two of some points, where they are in a pose."""
    data = seen(figure, wanted)
    some = [points[i] for i in rng.choice(len(points), rng.integers(1, 3), replace=False)]
    return [posing.PointGoal.of(figure, point, posing.PointGoal.of(figure, point).places(data)[0]) for point in some]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["human", "biped", "quadruped"])
def test_hands_and_feet_of_poses_inside_the_ranges_are_found_from_the_rest_pose(name):
    rng = np.random.default_rng(4)
    human = name == "human"
    figure = HUMAN["joint"] if human else figure_of(getattr(figures, name.upper()))
    points = (
        *site_points(figure, () if name == "quadruped" else ENDS),
        *sole_points(figure, np.zeros((0, figure.width))),
    )
    bends = BENDS if human else None
    for number in range(DRAWS):
        wanted, free = human_pose(rng) if human else drawn(figure, rng), everything(figure)
        if number % 2:  # with the limbs alone
            free[:7] = False
            wanted[:7] = figure.model.qpos0[:7]
        found = posing.find_pose(figure, figure.model.qpos0, free, asked_again(figure, points, wanted, rng), bends)
        assert found.is_met, number
        np.testing.assert_array_equal(found.qpos[~free], figure.model.qpos0[~free])
        if human:
            assert_human(found.qpos)
        else:
            limits = figure.model.jnt_range[1:].T
            assert np.all((found.qpos[7:] >= limits[0]) & (found.qpos[7:] <= limits[1]))
