"""MimicKit and DeepMimic: their kinematics written out by hand from their own conventions, against MuJoCo's."""

import json
import pickle

import mujoco
import numpy as np
import pytest
import shipped
import wild
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.format import mimickit
from dynsplines.exchange.motion_import import import_recording

HUMAN = mujoco.MjModel.from_xml_string(models.figure_text("human"))
Y_UP = Rotation.from_matrix([[1, 0, 0], [0, 0, 1], [0, -1, 0]])  # from our axes to DeepMimic's: x, up, right


@pytest.fixture(scope="module")
def hinged_knees():
    """Knees and elbows turn about their axis alone, as DeepMimic's do."""
    return wild.with_hinges(wild.motion_of("human", spread=1.2), "knee", "elbow")


@pytest.mark.slow
def test_mimickit_frames_are_root_and_joints_as_rotation_vectors(human, tmp_path):
    target, notes = wild.exported(human, "mimickit", tmp_path)
    with target.open("rb") as stream:
        held = pickle.load(stream)
    assert (held["fps"], held["loop_mode"]) == (wild.FPS, 0)
    frames, before = np.array(held["frames"]), wild.samples(human)
    model = mujoco.MjModel.from_xml_path(str(target.with_suffix(".character.xml")))
    assert notes == [f"wrote {target.with_suffix('.character.xml')}"]
    truth = wild.poses(human.figure.model, before.qpos)
    # forward_kinematics of kin_char_model.py: parent, then the body's rest, then the joint
    for t in (0, 17, 60):
        position, rotation = {0: frames[t, :3]}, {0: Rotation.from_rotvec(frames[t, 3:6])}
        bodies = [i for i in range(1, model.nbody) if model.body_jntnum[i]]
        place = {body: n for n, body in enumerate(bodies)}
        for n, body in enumerate(bodies[1:], 1):
            joints = [model.joint(model.body_jntadr[body] + i).name for i in range(3)]
            assert [name[-2:] for name in joints] == ["_x", "_y", "_z"]  # which makes it a ball joint there
            above = place[int(model.body_parentid[body])]
            rest = Rotation.from_quat(model.body_quat[body], scalar_first=True)
            position[n] = position[above] + rotation[above].apply(model.body_pos[body])
            rotation[n] = rotation[above] * rest * Rotation.from_rotvec(frames[t, 3 + 3 * n : 6 + 3 * n])
        np.testing.assert_allclose([position[n] for n in place.values()], truth["xpos"][t, bodies], atol=1e-9)
        own = np.array([rotation[n].as_matrix() for n in place.values()])
        np.testing.assert_allclose(own, truth["xmat"][t, bodies].reshape(-1, 3, 3), atol=1e-9)
    wild.came_back(human, target)


def test_mimickit_takes_three_hinges_on_a_body_for_a_ball_joint_whose_angles_are_zero_at_rest(tmp_path):
    text = wild.ROBOT.replace('name="left_knee"', 'name="left_knee" ref="0.5"')
    (tmp_path / "robot.xml").write_text(text.replace('name="left_hip_roll"', 'name="left_hip_roll" ref="-0.3"'))
    robot = wild.motion_of(str(tmp_path / "robot.xml"))
    target, notes = wild.exported(robot, "mimickit", tmp_path)
    with target.open("rb") as stream:
        frames = np.array(pickle.load(stream)["frames"])
    assert frames.shape[1] == 6 + 3 + 1 + 1 and notes == []
    turned = wild.samples(robot).qpos[:, 7:] - robot.figure.model.qpos0[7:]
    leg = Rotation.from_euler("YXZ", turned[:, :3])
    np.testing.assert_allclose(Rotation.from_rotvec(frames[:, 6:9]).as_matrix(), leg.as_matrix(), atol=1e-12)
    np.testing.assert_allclose(frames[:, 9:], turned[:, 3:], atol=1e-12)
    wild.came_back(robot, target, str(tmp_path / "robot.xml"))
    slides = mujoco.MjModel.from_xml_string(
        wild.ROBOT.replace('name="arm_pitch" type="hinge"', 'name="arm" type="slide"')
    )
    with pytest.raises(UserError, match="a body; 'arm' has others"):
        mimickit.parts(slides)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["mimickit", "deepmimic"])
def test_a_loop_wraps_and_its_last_frame_is_the_first_moved_on(kind, tmp_path):
    walk = shipped.unsolved("walk_loop")  # of a period that is not a whole number of samples
    period = walk.timeline.times[-1] - walk.timeline.times[0]
    target, _ = wild.exported(walk, kind, tmp_path)
    if kind == "mimickit":
        held = pickle.loads(target.read_bytes())
        frames = np.array(held["frames"])
        assert held["loop_mode"] == 1 and (len(frames) - 1) / held["fps"] == pytest.approx(period, abs=1e-12)
        first, last = frames[0], frames[-1]
    else:
        held = json.loads(target.read_text())
        frames = np.array(held["Frames"])
        assert held["Loop"] == "wrap" and frames[:-1, 0].sum() == pytest.approx(period, abs=1e-12)
        assert frames[-1, 0] == 0
        first, last = frames[0, 1:], frames[-1, 1:]
    assert last[0] - first[0] > 0.5
    np.testing.assert_allclose(last[3:], first[3:], atol=1e-9)
    back = import_recording(target, figure="human")
    assert back.timeline.times[-1] - back.timeline.times[0] == pytest.approx(period, abs=1e-9)
    assert back.timeline.ends == "periodic" and len(wild.samples(back).time) == len(frames)
    if kind == "mimickit":
        before = wild.samples(walk, held["fps"])
        wild.same_poses(walk.figure.model, before.qpos, wild.samples(back).qpos, 1e-4)


@pytest.mark.slow
def test_a_file_that_only_says_that_it_loops_is_read_as_it_is(hinged_knees, tmp_path):
    target, _ = wild.exported(hinged_knees, "deepmimic", tmp_path)
    target.write_text(target.read_text().replace('"none"', '"wrap"'))
    assert import_recording(target, figure="human").timeline.ends == "free"
    wild.came_back(hinged_knees, target)


def deepmimic_bodies(frame):
    """The root's place in a frame, and world rotations of their humanoid's bodies, in our axes, by their names."""
    assert len(frame) == 44
    root = Rotation.from_quat(frame[4:8], scalar_first=True)
    world, start = {"root": root}, 8
    above = {"chest": "root", "neck": "chest", "shoulder": "chest", "elbow": "shoulder", "hip": "root", "knee": "hip"}
    above["ankle"] = "knee"
    limbs = [f"{side}_{part}" for side in ("right", "left") for part in ("hip", "knee", "ankle", "shoulder", "elbow")]
    for name in ("chest", "neck", *limbs):
        part = name.split("_")[-1]
        if part in ("knee", "elbow"):
            own, width = Rotation.from_rotvec([0, 0, frame[start]]), 1
        else:
            own, width = Rotation.from_quat(frame[start : start + 4], scalar_first=True), 4
        parent = above[part] if above[part] in ("root", "chest") else name.replace(part, above[part])
        world[name] = world[parent] * own
        start += width
    return frame[1:4], {name: (Y_UP.inv() * own * Y_UP).as_matrix() for name, own in world.items()}


@pytest.mark.slow
def test_deepmimic_has_y_up_and_angles_about_z_at_knees_and_elbows(hinged_knees, tmp_path):
    target, notes = wild.exported(hinged_knees, "deepmimic", tmp_path)
    held, before = json.loads(target.read_text()), wild.samples(hinged_knees)
    model = hinged_knees.figure.model
    truth = wild.poses(model, before.qpos)
    assert held["Loop"] == "none" and len(held["Frames"]) == len(before.time)
    np.testing.assert_allclose(np.array(held["Frames"])[:-1, 0], 1 / wild.FPS, atol=1e-15)
    sole = 0.421546 + 0.409870 + 0.05  # of their legs and feet; ours stands with its hips at 0.93
    for t in (0, 23, 60):
        at, world = deepmimic_bodies(held["Frames"][t])
        np.testing.assert_allclose(np.array([at[0], -at[2], at[1]]) * 0.93 / sole, before.qpos[t, :3], atol=1e-9)
        for name, rotation in world.items():
            if name == "neck":
                continue
            body = model.body("pelvis").id if name == "root" else None
            joint = {"chest": "spine"}.get(name, name)
            body = int(model.jnt_bodyid[model.joint(joint).id]) if body is None else body
            np.testing.assert_allclose(rotation, truth["xmat"][t, body].reshape(3, 3), atol=1e-9, err_msg=name)
    assert notes == []
    wild.came_back(hinged_knees, target)


def _read(content, folder):
    (folder / "out.deepmimic.json").write_text(json.dumps(content))
    return formats.recording(folder / "out.deepmimic.json", model=HUMAN).qpos


def test_what_a_deepmimic_hinge_cannot_hold_is_reported(human, tmp_path):
    _, notes = wild.exported(human, "deepmimic", tmp_path)
    assert len(notes) == 1 and "of twist and swing are left out" in notes[0]


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ({"Loop": "wrap"}, "no 'Frames'; it holds: Loop"),
        ({"Frames": [[0.1] * 43] * 2}, "43 numbers a frame, not the humanoid's 44: time, root, chest, neck"),
        ({"Frames": [[0.1] * 44, [0.1]]}, "rows of different lengths"),
        ({"Frames": [[0.1] * 44] * 2}, "the rotation of chest': a quaternion of length 0.2"),
        ({"Frames": [[0.0] * 44] * 2}, "frame 1 lasts 0 s"),
        ([1], "a list, not an object"),
    ],
)
def test_bad_deepmimic_files_are_reported(content, says, tmp_path):
    with pytest.raises(UserError, match=says) as error:
        _read(content, tmp_path)
    assert "out.deepmimic.json" in str(error.value) and "\n" not in str(error.value)


def test_other_figures_than_people_are_refused_with_their_joints(tmp_path):
    (tmp_path / "robot.xml").write_text(wild.ROBOT)
    robot = wild.motion_of(str(tmp_path / "robot.xml"))
    says = "'deepmimic' is for a person .* no ball joint 'spine', only: floating, left_hip_pitch"
    with pytest.raises(UserError, match=says):
        formats.export(robot, "deepmimic", tmp_path / "out.json")
