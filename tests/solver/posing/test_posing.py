"""Poses by position: round trips through MuJoCo's kinematics, what stays as it was, ranges, bends, misses."""

from __future__ import annotations

from collections.abc import Sequence

import figures
import mujoco
import numpy as np
import pytest
from figures import figure_of, link_named
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import SiteGoal, kinematics
from scipy.optimize import minimize

from dynsplines import models
from dynsplines.clip.kinds import Options, posing_limits
from dynsplines.clip.posing.places import sole_points
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.penalty.joints.bend import bent
from dynsplines.solver.posing import MET, STARTS, BodyGoal, Goal, PointGoal, bounds, posed
from dynsplines.solver.surface.points import Point, site_points

HUMAN = {c: Figure(mujoco.MjModel.from_xml_string(models.figure_text("human")), c) for c in ("world", "joint")}
BENDS, _ = posing_limits(HUMAN["world"], {"limits": Options(least_bend=2.0)})
SITES = [f"{side}_{part}" for side in ("left", "right") for part in ("heel", "toe", "hand", "wrist")]
ARM = """
<mujoco><compiler angle="degree"/><worldbody>
  <body name="one" pos="0 0 1"><joint name="one" type="hinge" axis="0 1 0"/><geom size=".05"/>
    <body name="two" pos="1 0 0"><joint name="two" type="hinge" axis="0 1 0" range="-150 150"/><geom size=".05"/>
      <body name="three" pos="1 0 0"><joint name="three" type="hinge" axis="0 1 0"/><geom size=".05"/>
        <body name="rod" pos="1 0 0"><joint name="rod" type="slide" axis="1 0 0" range="-.1 .2"/><geom size=".05"/>
          <site name="tip" pos="0 0 0"/></body></body></body></body>
</worldbody></mujoco>"""


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
            turn = rng.uniform(0, 0.6) * quat.normalised(rng.normal(size=3))
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
    flexion, sideways, twist = bent(figure, BENDS.joints, own)
    changed = np.any(own != figure.model.qpos0[7:11], axis=1)
    assert np.all(flexion[changed] >= BENDS.least)
    assert np.all(np.abs(sideways) <= BENDS.sideways)
    assert np.all(np.abs(twist) <= BENDS.twist)


def everything(figure: Figure) -> Mask:
    return np.ones(figure.width, bool)


@pytest.mark.slow
@settings(max_examples=4, deadline=None)
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
    found = posed(figure, home, free, [SiteGoal(name, target)], BENDS)
    np.testing.assert_array_equal(found.qpos[~free], home[~free])
    off = np.linalg.norm(seen(figure, found.qpos).site(name).xpos - target)
    assert found.missed[0] == pytest.approx(off, abs=1e-9)
    assert found.is_met == (off <= MET)
    before = np.linalg.norm(seen(figure, home).site(name).xpos - target)
    assert off <= before


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_pose_that_is_there_already_stays_to_the_bit(coordinates):
    figure = HUMAN[coordinates]
    home = human_pose(np.random.default_rng(3))
    goals = [SiteGoal(name, seen(figure, home).site(name).xpos.copy()) for name in SITES]
    found = posed(figure, home, everything(figure), goals, BENDS)
    np.testing.assert_array_equal(found.qpos, home)
    assert found.is_met


def test_the_joints_from_the_root_to_a_goal_are_what_it_fixes():
    figure = HUMAN["world"]
    target = seen(figure, figure.model.qpos0).site("left_heel").xpos + np.array([0, 0, 0.2])
    found = posed(figure, figure.model.qpos0, everything(figure), [SiteGoal("left_heel", target)], BENDS)
    fixed = [link.name for i, link in enumerate(figure.links) if i and found.fixed[figure.links[i].columns].all()]
    assert fixed == ["root", "left_hip", "left_knee", "left_ankle"]
    np.testing.assert_array_equal(found.qpos[~found.fixed], figure.model.qpos0[~found.fixed])


def test_a_straight_leg_shortens_forward_at_the_knee():
    figure = HUMAN["world"]
    target = seen(figure, figure.model.qpos0).site("right_heel").xpos + np.array([0.0, 0, 0.15])
    free = everything(figure)
    free[:7] = False
    found = posed(figure, figure.model.qpos0, free, [SiteGoal("right_heel", target), BodyGoal("right_foot")], BENDS)
    assert found.is_met
    knee = link_named(figure, "right_knee")
    assert knee is not None
    turn = np.degrees(quat.rotation_vector(found.qpos[figure.links[knee].columns]))
    assert turn[1] > 20
    np.testing.assert_allclose(turn[[0, 2]], 0, atol=1)
    assert_human(found.qpos)


@pytest.mark.slow
def test_legs_that_home_has_turned_far_round_stand_all_the_same():
    """As where a path is gone on with, beyond its last keyframe: two homes of three at least, as such are hard."""
    figure = HUMAN["world"]
    turns = {
        "left": ([0.731, -0.312, 0.303, -0.526], [0.996, 0, 0.087, 0], [0.966, 0, 0.259, 0]),
        "right": ([0.54, -0.549, 0.615, -0.17], [0.995, 0, 0.105, 0], [0.966, 0, 0.259, 0]),
    }
    goals: list[Goal] = []
    for side, heel, heading in (("left", [-0.02, 0.09, 0], -8), ("right", [-0.09, -0.09, 0], -40)):
        goals.append(SiteGoal(f"{side}_heel", np.array(heel)))
        goals.append(BodyGoal(f"{side}_foot", quat.from_rotation_vector([0, 0, np.radians(heading)])))
    met = 0
    for seed in (0, 5, 15):
        rng = np.random.default_rng(seed)
        home, free = np.array(figure.model.qpos0), np.zeros(figure.width, bool)
        home[:7] = [0, 0, 0.915, *quat.from_rotation_vector([0, 0, np.radians(-20)])]
        for side, own in turns.items():
            for name, turn in zip(("hip", "knee", "ankle"), own, strict=True):
                columns = figure.links[link_named(figure, f"{side}_{name}") or 0].columns
                home[columns] = quat.normalised(turn + 0.01 * rng.normal(size=4))
                free[columns] = True
        found = posed(figure, home, free, goals, posing_limits(figure, {"limits": Options(least_bend=4.0)})[0])
        met += found.is_met
    assert met >= 2


@pytest.mark.parametrize("rest", [[1.0, 0, 0, 0], [0.9, 0.1, -0.2, 0.3]])
def test_flat_is_upright_as_at_rest_with_the_heading_free(rest):
    turn = " ".join(map(str, rest))
    figure = figure_of(
        f'<mujoco><worldbody><body name="sole" quat="{turn}"><joint name="j" type="ball"/><geom size=".1"/></body>'
        "</worldbody></mujoco>"
    )
    home = quat.from_rotation_vector(np.array([2.0, -1.0, 0.7]))
    found = posed(figure, home, np.ones(4, bool), [BodyGoal("sole")])
    up = quat.rotated(quat.product(seen(figure, found.qpos).body("sole").xquat, quat.inverse(rest)), [0.0, 0, 1])
    np.testing.assert_allclose(up, [0, 0, 1], atol=1e-6)
    assert found.is_met
    turned = quat.angle_between(home, found.qpos)
    tilt = quat.rotated(quat.product(quat.product(rest, home), quat.inverse(rest)), [0.0, 0, 1])
    assert turned == pytest.approx(np.arccos(tilt[2]), abs=1e-6)  # the shortest way up, no turn about the vertical


@pytest.mark.parametrize("reach", [2.6, 2.8])
@pytest.mark.parametrize("side", [-1, 1])
def test_with_joints_at_their_ranges_it_is_as_near_as_scipys(reach, side):
    figure = figure_of(ARM.replace("-150 150", "-10 10").replace("-.1 .2", "-.02 .01"))
    home, weights = np.array([0.3 * side, 0, 0.1, 0]), np.array([1.0, 1, 1, 5])
    target = np.array([0.0, 0, 1]) + reach * np.array([np.cos(0.3), 0, -side * np.sin(0.3)])

    def cost(qpos: Array) -> float:
        return float(np.sum((weights * (qpos - home)) ** 2))

    found = posed(figure, home, np.ones(4, bool), [SiteGoal("tip", target)])
    assert found.is_met
    hinge, low, high = np.radians(10) - bounds.INSIDE, -0.02 + bounds.INSIDE, 0.01 - bounds.INSIDE
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


HOLDING = """
<mujoco><worldbody>
  <body name="box" pos="1 .2 .3" quat=".9 .1 .2 -.1"><freejoint/><geom size=".1"/><site name="grip" pos=".1 -.2 .05"/></body>
  <body name="arm" pos="0 0 1" quat=".8 .1 -.3 .2"><joint type="ball"/><geom size=".1" pos=".2 0 0"/>
    <body name="hand" pos=".5 0 0"><joint type="hinge" axis="0 1 1"/><geom size=".1"/><site name="palm" pos=".1 .02 0"/>
    </body></body>
</worldbody></mujoco>"""  # noqa: E501


def test_a_hold_misses_what_mujoco_has_between_its_places_and_changes_as_both_bodies_move(rng):
    figure = figure_of(HOLDING)
    palm, grip = site_points(figure, ["palm", "grip"])
    goal = PointGoal.of(figure, palm, grip.position, grip.link)
    qpos = np.array(figure.model.qpos0)
    mujoco.mj_integratePos(figure.model, qpos, rng.normal(size=figure.model.nv), 1.0)

    def missed(qpos: Array) -> Array:
        data = seen(figure, qpos)
        return data.site("palm").xpos - data.site("grip").xpos

    data = seen(figure, qpos)
    mujoco.mj_comPos(figure.model, data)
    np.testing.assert_allclose(goal.missed(figure.model, data), missed(qpos), atol=1e-12)
    rows, h = np.empty((3, figure.model.nv)), 1e-6
    for k, direction in enumerate(np.eye(figure.model.nv)):
        ends = np.array(qpos), np.array(qpos)
        for end, side in zip(ends, (h, -h), strict=True):
            mujoco.mj_integratePos(figure.model, end, direction, side)
        rows[:, k] = (missed(ends[0]) - missed(ends[1])) / (2 * h)
    np.testing.assert_allclose(goal.rows(figure.model, data), rows, atol=1e-8)
    found = posed(figure, qpos, everything(figure), [goal])
    assert found.is_met
    np.testing.assert_allclose(missed(found.qpos), 0, atol=MET)


def test_what_is_out_of_reach_is_missed_by_the_gap():
    figure = figure_of(ARM)
    found = posed(figure, np.array([0.5, 0.5, 0.5, 0]), np.ones(4, bool), [SiteGoal("tip", np.array([4.0, 0, 1]))])
    assert not found.is_met
    assert found.missed[0] == pytest.approx(4 - 3.2, abs=1e-3)
    np.testing.assert_allclose(found.qpos, [0, 0, 0, 0.2], atol=1e-2)


DRAWS = 10
ENDS = ("left_hand", "right_hand")


def drawn(figure: Figure, rng: np.random.Generator) -> Array:
    """Every hinge somewhere in its range, the root turned and moved a little."""
    qpos = np.array(figure.model.qpos0)
    qpos[:3] += rng.uniform(-0.3, 0.3, 3)
    qpos[3:7] = quat.from_rotation_vector(0.3 * rng.normal(size=3) / np.sqrt(3))
    for link in figure.links[2:]:
        qpos[link.qpos] = rng.uniform(*figure.model.jnt_range[link.joint])
    return qpos


def asked_again(figure: Figure, points: Sequence[Point], wanted: Array, rng: np.random.Generator) -> list[Goal]:
    """One or two of some points, where they are in a pose."""
    data = seen(figure, wanted)
    some = [points[i] for i in rng.choice(len(points), rng.integers(1, 3), replace=False)]
    return [PointGoal.of(figure, point, PointGoal.of(figure, point).places(data)[0]) for point in some]


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
        found = posed(figure, figure.model.qpos0, free, asked_again(figure, points, wanted, rng), bends)
        assert found.is_met, number
        np.testing.assert_array_equal(found.qpos[~free], figure.model.qpos0[~free])
        if human:
            assert_human(found.qpos)
        else:
            limits = figure.model.jnt_range[1:].T
            assert np.all((found.qpos[7:] >= limits[0]) & (found.qpos[7:] <= limits[1]))


@pytest.mark.slow
def test_what_a_goal_apart_misses_does_not_move_the_others():
    figure = HUMAN["world"]
    free = everything(figure)
    free[:11] = False
    near = SiteGoal("left_hand", np.array([0.3, 0.2, 1.2]))
    far = SiteGoal("right_hand", np.array([3.0, 0, 1.0]))
    alone, both = (posed(figure, figure.model.qpos0, free, goals, BENDS) for goals in ([near], [near, far]))
    assert alone.is_met and both.missed[0] <= MET < both.missed[1]
    assert both.starts == STARTS
    np.testing.assert_allclose(both.qpos[alone.fixed], alone.qpos[alone.fixed], atol=1e-12)
