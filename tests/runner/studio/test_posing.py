"""The pose that follows a drag: limbs bend, soles stay flat on the ground, ankles in range, balance is kept."""

import time

import mujoco
import numpy as np
import pytest
from drags import Pull, Pulls, human_model, with_floor
from oracles import kinematics

from dynsplines import models, recordings
from dynsplines.clip.kinds import posing_limits
from dynsplines.errors import UserError
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.studio.posing import Poser


@pytest.fixture(scope="module")
def clip():
    return recordings.load("run_and_step")


@pytest.fixture(scope="module")
def poser(clip):
    whole = np.array([key.state for key in clip.keys if key.is_key])
    return Poser(clip.figure, [], whole)


def test_a_hand_within_reach_moves_its_arm_alone(clip, poser):
    model, home = clip.figure.model, np.array(clip.keys[-1].state)
    body = model.body("left_forearm").id
    goal = kinematics(model, home).site("left_hand").xpos + np.array([0.25, 0.05, 0.2])
    grip = poser.grip(home, body, model.site("left_hand").pos)
    found = poser.pull(grip, goal, home)
    for _ in range(4):
        found = poser.pull(grip, goal, found.qpos)
    np.testing.assert_allclose(kinematics(model, found.qpos).site("left_hand").xpos, goal, atol=2e-3)
    arm = np.zeros(model.nq, bool)
    for link in clip.figure.limb(body):
        arm[clip.figure.links[link].columns] = True
    np.testing.assert_array_equal(found.qpos[~arm], home[~arm])
    assert set(poser.keyframe_entries(found.qpos, home)["joints"]) <= {"left_shoulder", "left_elbow"}


def test_a_target_out_of_reach_is_approached_in_bounded_time_by_the_limb_alone_if_requested(clip, poser):
    model, home = clip.figure.model, np.array(clip.keys[-1].state)
    begin = time.perf_counter()
    found = poser.pull(poser.grip(home, model.body("right_foot").id, np.zeros(3)), np.array([0.0, 0, 30.0]), home)
    assert time.perf_counter() - begin < 2.0
    assert np.isfinite(found.qpos).all()
    assert found.worst > 1
    for link in clip.figure.links[1:]:
        if model.jnt_limited[link.joint] and link.kind.name == "BALL":
            turn = 2 * np.arccos(np.clip(abs(found.qpos[link.qpos]), 0, 1))
            assert turn <= model.jnt_range[link.joint, 1] + 0.1
    grip = poser.grip(home, model.body("left_forearm").id, np.zeros(3), alone=True)
    alone = poser.pull(grip, np.array([9.0, 0, 1.0]), home).qpos
    assert set(poser.keyframe_entries(alone, home)["joints"]) == {"left_shoulder"}


SOLES = ("left_heel", "left_toe", "right_heel", "right_toe")


def test_feet_on_the_ground_stay_where_a_moved_root_lets_them(clip, poser):
    model, home = clip.figure.model, np.array(clip.keys[-1].state)
    start = clip.figure.links[clip.figure.root.link].qpos
    place = home[start : start + 3]

    def soles(qpos):
        return kinematics(model, qpos).site_xpos[[model.site(name).id for name in SOLES]]

    def kept(**root):
        return poser.keep(home, poser.with_entries(home, {"root": root})[0], ())

    lower = kept(position=[place[0] + 0.03, "free", place[2] - 0.08])
    assert lower[start : start + 3] == pytest.approx(place + np.array([0.03, 0, -0.08]))
    assert lower[start + 3 : start + 7] == pytest.approx(home[start + 3 : start + 7])
    np.testing.assert_allclose(soles(lower), soles(home), atol=3e-3)
    assert set(poser.keyframe_entries(lower, home)["joints"]) <= {
        f"{side}_{joint}" for side in ("left", "right") for joint in ("hip", "knee", "ankle")
    }
    higher = kept(position=[*place[:2], place[2] + 0.5])
    np.testing.assert_allclose(soles(higher), soles(home) + np.array([0, 0, 0.5]), atol=1e-6)
    np.testing.assert_allclose(soles(kept(rotation={"rotvec": [0, 0, 10]})), soles(home), atol=3e-3)


def place_of(model, qpos, name):
    """[m] Of an arm, the place of its hand."""
    data = kinematics(model, qpos)
    body = data.body(name)
    return data.site("left_hand").xpos if "arm" in name else np.concatenate([body.xpos, 0.3 * body.xmat])


@pytest.mark.parametrize("name", ["left_forearm", "left_foot", "pelvis"])
def test_a_locked_body_stays_while_others_are_dragged_turned_or_typed(clip, poser, name):
    model, home = clip.figure.model, np.array(clip.keys[-1].state)
    here, locks = place_of(model, home, name), (model.body(name).id,)
    with pytest.raises(UserError, match=f"'{name}': locked"):
        poser.grip(home, model.body(name).id, np.zeros(3), locked=locks)
    offset = np.array([0.02, 0.03, -0.12])
    for pulled in ("chest", "right_foot", "left_upper_arm", "left_shin"):
        body = kinematics(model, home).body(pulled)
        grip = poser.grip(home, body.id, offset, plant=False, locked=locks)
        target = body.xpos + body.xmat.reshape(3, 3) @ offset + [0.1, 0.05, 0.06]
        found = poser.pull(grip, target, poser.pull(grip, target, home).qpos).qpos
        np.testing.assert_allclose(place_of(model, found, name), here, atol=3e-3)
        assert np.abs(found - home).max() > 0.01
    for joint in ("left_hip", "left_shoulder"):
        typed = poser.with_entries(home, {"joints": {joint: {"rotvec": [4, -12, 2]}}})[0]
        after = poser.keep(home, typed, locks)
        np.testing.assert_allclose(place_of(model, after, name), here, atol=3e-3)
        link = next(link for link in clip.figure.links if link.name == joint)
        np.testing.assert_allclose(after[link.columns], typed[link.columns])


def test_a_change_that_a_locked_body_cannot_follow_is_rejected(clip, poser):
    home = np.array(clip.keys[-1].state)
    place = home[clip.figure.links[clip.figure.root.link].qpos :][:3]
    higher = poser.with_entries(home, {"root": {"position": [*place[:2], place[2] + 0.5]}})[0]
    with pytest.raises(UserError, match="'left_foot': locked, and cannot stay"):
        poser.keep(home, higher, [clip.figure.model.body("left_foot").id])


def test_a_joint_turns_about_an_axis_of_the_world(clip, poser):
    model, home = clip.figure.model, np.array(clip.keys[0].state)
    half = np.radians(20) / 2
    turned = poser.turn(home, "left_shoulder", [np.cos(half), 0, np.sin(half), 0])
    before, after = (kinematics(model, each).body("left_upper_arm").xmat.reshape(3, 3) for each in (home, turned))
    about = np.array([[np.cos(2 * half), 0, np.sin(2 * half)], [0, 1, 0], [-np.sin(2 * half), 0, np.cos(2 * half)]])
    np.testing.assert_allclose(after, about @ before, atol=1e-9)
    with pytest.raises(UserError, match="left_knee"):
        poser.turn(home, "left_kne", [1, 0, 0, 0])


@pytest.fixture(scope="module")
def human() -> Pulls:
    return Pulls(human_model(), "_sole")


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 3])
def test_random_drags_keep_soles_joints_and_balance(human, seed):
    result = human.result(human.drawn(np.random.default_rng(seed)), moves=4)
    assert result.violations == {}


def flexion(pulls: Pulls, qpos) -> dict[str, float]:
    """Return the flexion of knees and elbows [degrees]."""
    bends = posing_limits(pulls.figure, {})
    assert bends is not None
    angles = bends.angles(Samples.of_qpos(pulls.figure, qpos))
    return {joint.name: float(np.degrees(angle)) for joint, angle in zip(bends.joints, angles[0, :, 0], strict=True)}


@pytest.mark.parametrize("offset", [[0, 0.14, 0], [-0.1, 0, 0.02]])
def test_a_pelvis_that_is_pulled_down_squats_whatever_point_is_held(human, offset):
    pelvis = human.model.body("pelvis").id
    result = human.result(Pull(pelvis, np.array(offset, float), np.array([0, 0, -0.25])), moves=6)
    assert result.violations == {}
    assert result.miss < 0.02
    angles = flexion(human, result.qpos)
    assert angles["left_knee"] > 40
    assert angles["right_knee"] > 40


@pytest.mark.parametrize(("by", "most"), [([0.2, 0.1, 1.1], 0.02), ([-0.4, 0, 0.3], 5e-3), ([0.2, 0, 0.5], 5e-3)])
def test_a_hand_that_is_pulled_up_or_back_bends_the_elbow_forward(human, by, most):
    """Overhead, back and to the shoulder; what a straight arm reaches moves nothing else."""
    model = human.model
    forearm, hand = model.body("left_forearm").id, model.site("left_hand").pos
    result = human.result(Pull(forearm, np.array(hand), np.array(by, float)))
    assert result.violations == {}
    assert result.miss < most
    angles = flexion(human, result.qpos)
    assert -1 < angles["left_elbow"] < 151
    assert angles["left_knee"] > -1


@pytest.mark.parametrize("by", [[0.25, 0.05, -0.1], [0, 0.2, 0.01], [-0.2, 0, 0.0]])
def test_a_foot_that_is_put_down_lands_flat_on_the_ground(human, by):
    foot = human.model.body("left_foot").id
    result = human.result(Pull(foot, np.zeros(3), np.array(by)), moves=5)
    assert result.violations == {}
    data = kinematics(human.model, result.qpos)
    assert data.site("left_heel").xpos[2] == pytest.approx(0, abs=1e-3)
    assert data.site("left_toe").xpos[2] == pytest.approx(0, abs=1e-3)
    before = human.home[:2] + human.model.body("left_thigh").pos[:2]
    np.testing.assert_allclose(data.xpos[foot][:2], before + by[:2], atol=5e-3)


@pytest.fixture(scope="module")
def before_box() -> Pulls:
    spec = mujoco.MjSpec.from_string(models.figure_text("human"))
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=[0.8, 0, 0.1], size=[0.2, 0.2, 0.1])
    return Pulls(with_floor(spec), "_sole")


def test_a_pose_is_put_on_top_of_what_the_figure_stands_on(before_box):
    model, poser = before_box.model, before_box.poser
    pose, home = before_box.home.copy(), before_box.home.copy()
    home[:3] += [0.72, 0.05, 0.15]  # bent, as it were
    placed = poser.place(pose, home)
    data = kinematics(model, placed)
    assert data.site("left_heel").xpos == pytest.approx([0.665, 0.14, 0.2], abs=1e-3)
    home[0] = 0.2
    np.testing.assert_allclose(poser.place(pose, home)[[0, 2]], [0.2, pose[2]], atol=1e-9)


@pytest.mark.parametrize("place", [[0.78, 0.28], [0.78, 0.22], [0.62, 0.26]])
def test_a_foot_that_is_dragged_through_the_edge_of_a_box_lands_flat_on_the_box(before_box, place):
    model = before_box.model
    foot = model.body("left_foot").id
    ankle = kinematics(model, before_box.home).xpos[foot]
    by = np.array([place[0] - ankle[0], 0, place[1] - ankle[2]])
    data = kinematics(model, before_box.result(Pull(foot, np.zeros(3), by)).qpos)
    assert [data.site(f"left_{end}").xpos[2] for end in ("heel", "toe")] == pytest.approx([0.2, 0.2], abs=1e-3)
    assert data.xpos[foot][0] == pytest.approx(place[0], abs=5e-3)
