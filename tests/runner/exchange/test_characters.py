"""MimicKit: its kinematics written out by hand from its own conventions, against MuJoCo's."""

import pickle

import mujoco
import numpy as np
import pytest
import shipped
import wild
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.format import mimickit
from dynsplines.exchange.motion_import import import_recording


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
def test_a_loop_wraps_and_its_last_frame_is_the_first_moved_on(tmp_path):
    walk = shipped.unsolved("walk_loop")  # of a period that is not a whole number of samples
    period = walk.timeline.times[-1] - walk.timeline.times[0]
    target, _ = wild.exported(walk, "mimickit", tmp_path)
    held = pickle.loads(target.read_bytes())
    frames = np.array(held["frames"])
    assert held["loop_mode"] == 1 and (len(frames) - 1) / held["fps"] == pytest.approx(period, abs=1e-12)
    assert frames[-1, 0] - frames[0, 0] > 0.5
    np.testing.assert_allclose(frames[-1, 3:], frames[0, 3:], atol=1e-9)
    back = import_recording(target, figure="human")
    assert back.timeline.times[-1] - back.timeline.times[0] == pytest.approx(period, abs=1e-9)
    assert back.timeline.ends == "periodic" and len(wild.samples(back).time) == len(frames)
    wild.same_poses(walk.figure.model, wild.samples(walk, held["fps"]).qpos, wild.samples(back).qpos, 1e-4)


@pytest.mark.slow
def test_a_file_that_only_says_that_it_loops_is_read_as_it_is(human, tmp_path):
    target, _ = wild.exported(human, "mimickit", tmp_path)
    held = pickle.loads(target.read_bytes())
    target.write_bytes(pickle.dumps(held | {"loop_mode": 1}))
    assert import_recording(target, figure="human").timeline.ends == "free"
    wild.came_back(human, target)
