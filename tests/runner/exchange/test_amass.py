"""AMASS: vertical axis, unit, names of arrays, cut files, and SMPL's mean shape as a figure and on robots."""

import pickle
import zlib

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
RATE, SAMPLES = 50.0, 75
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
    """A file of arrays; None leaves one out."""
    path = folder / name
    arrays = {key: value for key, value in arrays.items() if value is not None}
    if path.suffix == ".joblib":
        path.write_bytes(zlib.compress(pickle.dumps(arrays)))
    elif path.suffix == ".pkl":
        path.write_bytes(pickle.dumps(arrays))
    else:
        np.savez(path, **arrays)
    return path


def read(folder, poses, trans, model=HUMAN, **more):
    path = written(
        folder, poses=poses.reshape(len(poses), 3 * poses.shape[1]), trans=trans, mocap_framerate=RATE, **more
    )
    return formats.recording(path, model=model)


@pytest.mark.parametrize(("back", "axis"), [(Y_UP, "y"), (Y_UP.inv(), "-y")])
@pytest.mark.parametrize("model", [HUMAN, ROBOT], ids=["human", "robot"])
def test_files_with_y_up_are_turned(tmp_path, back, axis, model):
    poses, trans = walk()
    upright = read(tmp_path, poses, trans, model)
    found = read(tmp_path, *turned(back, poses, trans), model)
    np.testing.assert_allclose(found.qpos, upright.qpos, atol=1e-6)
    assert any(note.startswith(f"{axis} is up in the file") for note in found.notes)
    assert not any("is up" in note for note in upright.notes)


@pytest.mark.parametrize(
    ("back", "head"),
    [(None, (0, -1, 0)), (None, (1, 0, 0)), (Y_UP, (0, 1, 0))],
)
@pytest.mark.parametrize("crawls", [False, True])
def test_a_body_that_lies_on_the_floor_stays_there(tmp_path, head, back, crawls):
    poses, trans = np.zeros((20, 52, 3)), np.tile([0.3, -0.4, 0.12], (20, 1))
    side = np.cross(head, [0, 0, 1])  # it lies on its back
    poses[:, 0] = Rotation.from_matrix(np.stack([side, head, [0, 0, 1]], axis=1)).as_rotvec()
    if crawls:
        trans = trans + np.linspace(-1, 1, 20)[:, None] * head
    if back is not None:
        poses, trans = turned(back, poses, trans)
    found = read(tmp_path, poses, trans)
    assert any("on the floor" in note or "z is taken as up" in note for note in found.notes)
    data = kinematics(HUMAN, found.qpos[0])
    assert abs(data.body("chest").xpos - data.body("pelvis").xpos)[2] < 0.1


@pytest.mark.parametrize(("factor", "name"), [(100, "centimetres"), (1000, "millimetres")])
@pytest.mark.parametrize(("still", "centred"), [(False, False), (True, False), (False, True)])
def test_positions_in_other_units_are_converted(tmp_path, factor, name, still, centred):
    poses, trans = walk()
    poses = poses[:1].repeat(SAMPLES, axis=0) if still else poses
    trans = trans - [0, 0, 0.87] if centred else trans
    metres = read(tmp_path, poses, trans)
    found = read(tmp_path, poses, factor * trans)
    np.testing.assert_allclose(found.qpos, metres.qpos, atol=1e-9)
    assert any(name in note for note in found.notes)
    assert not metres.notes


VARIANTS = {
    "SMPL": lambda p, t: {"poses": p[:, :24].reshape(SAMPLES, 72), "trans": t},
    "SMPL-H": lambda p, t: {"poses": p.reshape(SAMPLES, 156), "trans": t},
    "SMPL-X": lambda p, t: {"poses": np.zeros((SAMPLES, 165)) + np.pad(p.reshape(SAMPLES, 156), [(0, 0), (0, 9)]),
                            "trans": t},
    "24 joints": lambda p, t: {"poses": p[:, :24], "trans": t},
    "52 joints": lambda p, t: {"poses": p.astype(np.float32), "trans": t},
    "parts": lambda p, t: {"root_orient": p[:, 0], "pose_body": p[:, 1:22].reshape(SAMPLES, 63), "trans": t},
    "nested parts": lambda p, t: {"global_orient": p[:, :1], "body_pose": p[:, 1:24], "transl": t},
    "AIST++": lambda p, t: {"smpl_poses": p[:, :24].reshape(SAMPLES, 72), "smpl_trans": 93.5 * t,
                            "smpl_scaling": np.array([93.5]), "smpl_loss": 0.1},
    "PHC": lambda p, t: {"walk": {"pose_aa": p[:, :24].reshape(SAMPLES, 72), "trans_orig": t, "beta": np.zeros(10),
                                  "fps": 50}},
}  # fmt: skip


@pytest.mark.parametrize(("variant", "ending"), list(zip(VARIANTS, 3 * (".npz", ".pkl", ".joblib"), strict=True)))
def test_arrays_have_several_names_and_shapes(tmp_path, variant, ending):
    poses, trans = walk()
    path = written(tmp_path, f"b{ending}", **VARIANTS[variant](poses, trans))
    found = formats.recording(path, model=HUMAN, fps=RATE)
    np.testing.assert_allclose(found.qpos, read(tmp_path, poses, trans).qpos, atol=1e-6)
    assert found.fps == RATE
    assert not found.notes


@pytest.mark.parametrize("name", ["mocap_framerate", "mocap_frame_rate", "mocap_fps", "framerate", "frame_rate", "fps"])
def test_the_rate_has_several_names(tmp_path, name):
    poses, trans = walk()
    rate = np.array([24]) if name == "fps" else 24.0
    path = written(tmp_path, poses=poses.reshape(SAMPLES, -1), trans=trans, **{name: rate})
    assert formats.recording(path, model=HUMAN).fps == 24


def test_a_file_of_no_or_one_sample_is_refused_or_read(tmp_path):
    poses, trans = walk()
    with pytest.raises(UserError, match="it has no samples"):
        read(tmp_path, poses[:0], trans[:0])
    assert read(tmp_path, poses[:1], trans[:1]).qpos.shape == (1, HUMAN.nq)


def test_without_a_figure_the_mean_shape_is_one(tmp_path):
    rng = np.random.default_rng(2)
    poses, trans = walk()
    poses[:, 1:22] += rng.uniform(-0.3, 0.3, (SAMPLES, 21, 3))
    path = written(tmp_path, poses=poses, trans=trans, mocap_framerate=RATE, betas=np.ones(16))
    saved = import_recording(path)
    model = saved.figure.model
    recording = formats.recording(path)
    names = {name: name.replace("foot", "toe") for name in SMPL}
    offset = {name: model.body(names[name]).pos for name in SMPL}  # x forward, y left, z up; SMPL's are y, z, x
    assert offset["left_knee"] == pytest.approx([-0.007, 0.036, -0.379])
    assert offset["right_elbow"] == pytest.approx([-0.024, -0.257, -0.013])
    for row in (0, 40):
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


def test_rotations_are_those_of_smpl_in_the_world(tmp_path):
    """Rotation vectors in axes x left, y up, z forward."""
    poses, trans = np.zeros((3, 52, 3)), np.array([[0, 0, 1.0], [0.1, -0.2, 1.1], [0.2, -0.4, 1.3]])
    poses[:, :20] = np.random.default_rng(4).uniform(-0.8, 0.8, (20, 3))
    data, world = kinematics(HUMAN, read(tmp_path, poses, trans).qpos[0]), {}
    for joint, parent in SMPL.items():
        turn = Rotation.from_rotvec(poses[0, _index(joint)])
        world[joint] = turn if parent is None else world[parent] * turn
    bodies = {"left_hip": "left_thigh", "left_ankle": "left_foot", "spine3": "chest", "right_elbow": "right_forearm"}
    for joint, body in bodies.items():
        axes = data.body(body).xmat.reshape(3, 3)
        forward = [0, 0, 1]  # stays forward in our arms as well: they are raised about it
        np.testing.assert_allclose(axes[:, 0], world[joint].apply(forward), atol=1e-9, err_msg=joint)
        along = [-1, 0, 0] if joint == "right_elbow" else [0, -1, 0]
        np.testing.assert_allclose(-axes[:, 2], world[joint].apply(along), atol=1e-9, err_msg=joint)


def test_bad_files_are_reported(tmp_path):
    with pytest.raises(
        UserError,
        match="'poses' has 60 numbers a sample; rotation vectors of SMPL's joints are 66, 72, 156, 165 numbers",
    ):
        read(tmp_path, np.zeros((3, 20, 3)), np.zeros((3, 3)))
    path = written(tmp_path, poses=np.zeros((3, 156)), trans=np.zeros((3, 3)))
    with pytest.raises(UserError, match="no 'mocap_framerate'"):
        formats.recording(path, model=HUMAN)
