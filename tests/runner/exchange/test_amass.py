"""AMASS: vertical axis, unit, widths of arrays, and SMPL's mean shape as a figure and on robots."""

import mujoco
import numpy as np
import pytest
from figures import ANDROID
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording

HUMAN = mujoco.MjModel.from_xml_string(models.figure_text("human"))
ROBOT = mujoco.MjModel.from_xml_string(ANDROID)
RATE, SAMPLES = 50.0, 25
SMPL = {  # every joint's parent
    "pelvis": None, "left_hip": "pelvis", "right_hip": "pelvis", "spine1": "pelvis", "left_knee": "left_hip",
    "right_knee": "right_hip", "spine2": "spine1", "left_ankle": "left_knee", "right_ankle": "right_knee",
    "spine3": "spine2", "left_foot": "left_ankle", "right_foot": "right_ankle", "neck": "spine3",
    "left_collar": "spine3", "right_collar": "spine3", "head": "neck", "left_shoulder": "left_collar",
    "right_shoulder": "right_collar", "left_elbow": "left_shoulder", "right_elbow": "right_shoulder",
    "left_wrist": "left_elbow", "right_wrist": "right_elbow",
}  # fmt: skip
LEG = 0.78  # [m] hip to ankle of the mean shape
Y_UP = Rotation.from_euler("x", -90, degrees=True)  # from z up


def walk(joints=52):
    """(T, joints, 3) and (T, 3) [m]: a walk along -y with z up; the foot that carries stands still."""
    time = np.arange(SAMPLES) / RATE
    phase = 2 * np.pi * time
    poses = np.zeros((SAMPLES, joints, 3))
    poses[:, 0, 0] = np.pi / 2
    for side, sign in (("left", 1), ("right", -1)):
        forward, bend = 0.4 * sign * np.sin(phase), 0.7 * np.clip(sign * np.cos(phase), 0, None)
        for joint, angle in (("hip", -forward), ("knee", bend), ("ankle", forward - bend)):
            poses[:, _index(f"{side}_{joint}"), 0] = angle
        poses[:, _index(f"{side}_shoulder"), 2] = -1.3 * sign
    far = np.append(0, np.cumsum(np.abs(np.diff(LEG * np.sin(0.4 * np.sin(phase))))))
    return poses, np.stack([0.2 + 0 * far, -far, 0.87 + 0 * far], axis=1)


def _index(joint):
    return list(SMPL).index(joint)


def turned(by, poses, trans):
    """A recording in another world."""
    poses = poses.copy()
    poses[:, 0] = (by * Rotation.from_rotvec(poses[:, 0])).as_rotvec()
    return poses, by.apply(trans)


def written(folder, name="a.npz", **arrays):
    np.savez(folder / name, **arrays)
    return folder / name


def read(folder, poses, trans, model=HUMAN, kind=None, **more):
    path = written(
        folder, poses=poses.reshape(len(poses), 3 * poses.shape[1]), trans=trans, mocap_framerate=RATE, **more
    )
    return formats.recording(path, kind, model=model)


@pytest.mark.parametrize("back", [Y_UP, Y_UP.inv()], ids=["y", "-y"])
@pytest.mark.parametrize("model", [HUMAN, ROBOT, None], ids=["human", "robot", "mean shape"])
def test_files_with_y_up_need_a_format(tmp_path, back, model):
    poses, trans = walk()
    assert read(tmp_path, poses, trans, model).qpos.shape[0] == SAMPLES
    turned_motion = turned(back, poses[:3], trans[:3])
    with pytest.raises(UserError, match=r"the root is tilted by 90° with z up, as the format amass has it"):
        read(tmp_path, *turned_motion, model)
    lies = read(tmp_path, *turned_motion, HUMAN, "amass")
    data = kinematics(HUMAN, lies.qpos[0])
    assert abs(data.body("chest").xpos - data.body("pelvis").xpos)[2] < 0.1


@pytest.mark.parametrize("factor", [100, 1000])
@pytest.mark.parametrize(("still", "centred"), [(False, False), (True, False), (False, True)])
def test_positions_in_other_units_are_refused(tmp_path, factor, still, centred):
    poses, trans = walk()
    trans = trans - [0, 0, 0.87] if centred else trans
    trans = trans[:1].repeat(SAMPLES, axis=0) if still else trans
    read(tmp_path, poses, trans)
    with pytest.raises(UserError, match=r"'trans' is not in metres, as the pelvis is \d+ m high and moves at \d+ m/s"):
        read(tmp_path, poses, factor * trans)


VARIANTS = {
    "SMPL": lambda p: {"poses": p[:, :24].reshape(SAMPLES, 72), "mocap_framerate": RATE},
    "SMPL-H": lambda p: {"poses": p.reshape(SAMPLES, 156).astype(np.float32), "mocap_frame_rate": np.array([RATE])},
    "SMPL-X": lambda p: {"poses": np.pad(p.reshape(SAMPLES, 156), [(0, 0), (0, 9)])},
    "parts": lambda p: {"root_orient": p[:, 0], "pose_body": p[:, 1:22].reshape(SAMPLES, 63)},
}


@pytest.mark.parametrize("variant", VARIANTS)
def test_arrays_have_the_widths_of_smpls_bodies(tmp_path, variant):
    poses, trans = walk()
    found = formats.recording(
        written(tmp_path, "b.npz", **VARIANTS[variant](poses), trans=trans), model=HUMAN, fps=RATE
    )
    plain = read(tmp_path, poses, trans)
    np.testing.assert_allclose(found.qpos, plain.qpos, atol=1e-6)
    assert found.fps == RATE
    assert found.notes == plain.notes


def test_a_file_of_no_or_one_sample_is_refused_or_read(tmp_path):
    poses, trans = walk()
    with pytest.raises(UserError, match="it has no samples"):
        read(tmp_path, poses[:0], trans[:0])
    assert read(tmp_path, poses[:1], trans[:1]).qpos.shape == (1, HUMAN.nq)


def test_without_a_figure_the_mean_shape_is_one(tmp_path):
    rng = np.random.default_rng(2)
    poses, trans = walk()
    poses[:, 1:22] += rng.uniform(-0.3, 0.3, (SAMPLES, 21, 3))
    path = written(tmp_path, poses=poses.reshape(SAMPLES, -1), trans=trans, mocap_framerate=RATE, betas=np.ones(16))
    saved = import_recording(path)
    model = saved.figure.model
    recording = formats.recording(path)
    names = {name: name.replace("foot", "toe") for name in SMPL}
    offset = {name: model.body(names[name]).pos for name in SMPL}  # x forward, y left, z up; SMPL's are y, z, x
    assert offset["left_knee"] == pytest.approx([-0.007, 0.036, -0.379])
    assert offset["right_elbow"] == pytest.approx([-0.024, -0.257, -0.013])
    for name in ("spine1", "neck"):
        bones = np.flatnonzero(model.geom_bodyid == model.body(name).parentid)
        ends = 2 * model.geom_pos[bones]  # of capsules that begin at the joint
        assert np.linalg.norm(ends - model.body(name).pos, axis=1).min() < 1e-6
    chest = np.flatnonzero(model.geom_bodyid == model.body("spine3").id)
    bar = 0.6 * np.linalg.norm(offset["left_collar"] - offset["right_collar"])  # from one arm to the other
    assert np.isclose(2 * model.geom_size[chest, 1], bar, rtol=1e-4).any()
    assert (model.geom_size[1:, 0] <= 1.02 * model.geom_size[1:, 1]).all()  # no bone is thicker than long
    for row in (0, 20):
        data = kinematics(model, recording.qpos[row])
        turn, place = {}, {}
        for joint, parent in SMPL.items():
            local = Rotation.from_rotvec(poses[row, _index(joint)])
            turn[joint] = local if parent is None else turn[parent] * local
            step = np.roll(offset[joint], -1)
            place[joint] = np.zeros(3) if parent is None else place[parent] + turn[parent].apply(step)
        for joint in SMPL:
            away = data.body(names[joint]).xpos - data.body("pelvis").xpos
            np.testing.assert_allclose(away, place[joint], atol=1e-6, err_msg=joint)
    np.testing.assert_allclose(recording.qpos[:, :2], trans[:, :2], atol=1e-9)
    assert any("'betas' are not used" in note for note in recording.notes)


def test_a_file_of_arrays_is_a_motion_of_another_program_by_its_arrays(tmp_path):
    poses, trans = walk()
    assert formats.is_foreign(written(tmp_path, poses=poses, trans=trans, mocap_framerate=RATE))
    assert formats.is_foreign(tmp_path / "missing.amass.npz")
    assert not formats.is_foreign(written(tmp_path, "motion.npz", format_version=1, qpos=trans))
    assert not formats.is_foreign(written(tmp_path, "other.npz", numbers=trans))
    assert not formats.is_foreign(tmp_path / "missing.npz")


def test_bad_files_are_reported(tmp_path):
    with pytest.raises(
        UserError,
        match="'poses' have 60 numbers a sample; rotation vectors of SMPL's joints are 66, 72, 156, 165 numbers",
    ):
        read(tmp_path, np.zeros((3, 20, 3)), np.zeros((3, 3)))
    path = written(tmp_path, poses=np.zeros((3, 156)), trans=np.zeros((3, 3)))
    with pytest.raises(UserError, match="no 'mocap_framerate'"):
        formats.recording(path, model=HUMAN)
