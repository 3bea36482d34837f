"""Files in other layouts than the documented one: verified by body poses in them, or decided by plausibility."""

from typing import Any

import mujoco
import numpy as np
import pytest
import walking_biped as biped
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.formats import recording

QPOS = biped.walk()
PLACE, TURN = biped.poses(QPOS)
NAMES = ["waist_yaw", *biped.JOINTS]
BODIES = [
    "world",
    "pelvis",
    "waist",
    *(f"{side}_{part}" for side in ("left", "right") for part in ("thigh", "shin", "foot")),
]
BREADTH = [0, 1, 4, 2, 5, 3, 6]  # of the joints: waist and hips, knees, ankles
MIXED = [3, 0, 6, 2, 5, 1, 4]


def read(path, kind=None, fps=None):
    found = recording(path, kind, model=biped.model(), fps=fps)
    return found, " ".join(found.notes)


def mjlab(**changes) -> dict[str, Any]:
    entries = {"fps": [50], "joint_pos": QPOS[:, 7:], "joint_vel": np.zeros((100, 7)), "body_pos_w": PLACE[:, 1:],
               "body_quat_w": TURN[:, 1:], "joint_names": NAMES, "body_names": BODIES[1:]} | changes  # fmt: skip
    return {name: np.asarray(value) for name, value in entries.items() if value is not None}


OTHER = {
    "as documented": ({}, ""),
    "without names": ({"joint_names": None, "body_names": None}, ""),
    "single precision": ({"joint_pos": QPOS[:, 7:].astype(np.float32), "body_pos_w": PLACE[:, 1:].astype("f4")}, ""),
    "names in another order": ({"joint_pos": QPOS[:, 7:][:, MIXED], "joint_names": np.array(NAMES)[MIXED]}, ""),
    "bodies in another order": ({"body_pos_w": PLACE[:, ::-1], "body_quat_w": TURN[:, ::-1],
                                 "body_names": BODIES[::-1]},
                                ""),
    "the world first, and qpos": ({"joint_pos": QPOS, "body_pos_w": PLACE, "body_quat_w": TURN, "body_names": BODIES},
                                  "qpos in joint_pos"),
    "qpos, with the root's name": ({"joint_pos": QPOS, "joint_names": ["root", *NAMES]}, "qpos in joint_pos"),
    "qpos, xyzw": ({"joint_pos": QPOS[:, [0, 1, 2, 4, 5, 6, 3, *range(7, 14)]],
                    "body_quat_w": np.roll(TURN[:, 1:], -1, -1)},
                   "qpos in joint_pos and quaternions xyzw"),
    "qpos without names": ({"joint_pos": QPOS, "joint_names": None, "body_names": None}, "qpos in joint_pos"),
    "names that lie": ({"joint_names": np.array(NAMES)[MIXED]}, "not that of joint_names"),
    "xyzw, breadth first, the world first": (
        {"joint_pos": QPOS[:, 7:][:, BREADTH], "joint_names": None, "body_names": None, "body_pos_w": PLACE,
         "body_quat_w": np.roll(TURN, -1, -1)},
        "the world first and quaternions xyzw and joints breadth first"),
    "few bodies": ({"body_pos_w": PLACE[:, [1, 5, 8]], "body_quat_w": TURN[:, [1, 5, 8]], "body_names": None}, ""),
    "degrees": ({"joint_pos": np.degrees(QPOS[:, 7:])}, "read as degrees"),
}  # fmt: skip


@pytest.mark.parametrize(("change", "note"), OTHER.values(), ids=OTHER)
def test_body_poses_decide_how_a_file_is_laid_out(change, note, tmp_path):
    np.savez(tmp_path / "a.npz", **mjlab(**change))
    found, notes = read(tmp_path / "a.npz")
    biped.assert_same(found.qpos, QPOS, 1e-6)
    assert note in notes and bool(note) == bool(notes)


@pytest.mark.parametrize("change", [{"joint_pos": QPOS[:, 7:] * 1.2}, {"body_pos_w": PLACE[:, 1:] * 1.1}])
def test_body_poses_that_no_layout_reproduces_are_refused_with_distance_and_angle(change, tmp_path):
    np.savez(tmp_path / "a.npz", **mjlab(**change))
    with pytest.raises(UserError, match=r"a\.npz: its body poses differ .* by up to \d+\.\d cm and \d+\.\d°"):
        read(tmp_path / "a.npz")


@pytest.mark.parametrize("order", [[3, 4, 5, 6], [4, 5, 6, 3]])
def test_arrays_with_y_up_in_world_and_frames_are_turned(order, tmp_path):
    rows = biped.y_up(QPOS, with_frame=True)[:, [0, 1, 2, *order, *range(7, 14)]]
    np.savez(tmp_path / "a.npz", qpos=rows, fps=50.0)
    found, notes = read(tmp_path / "a.npz")
    biped.assert_same(found.qpos, QPOS, 1e-9)
    assert "y up" in notes


def test_body_poses_with_y_up_are_turned_with_the_root(tmp_path):
    turn = Rotation.from_euler("x", -90, degrees=True)
    place = turn.apply(PLACE.reshape(-1, 3)).reshape(PLACE.shape)
    rotation = (turn * Rotation.from_quat(TURN.reshape(-1, 4), scalar_first=True)).as_quat(scalar_first=True)
    np.savez(tmp_path / "a.npz", **mjlab(body_pos_w=place[:, 1:], body_quat_w=rotation.reshape(TURN.shape)[:, 1:]))
    found, notes = read(tmp_path / "a.npz")
    biped.assert_same(found.qpos, QPOS, 1e-6)
    assert "y up" in notes


def test_an_array_alone_is_qpos(tmp_path):
    np.save(tmp_path / "a.npy", QPOS)
    biped.assert_same(read(tmp_path / "a.npy", fps=50.0)[0].qpos, QPOS)
    with pytest.raises(UserError, match="give the rate"):
        read(tmp_path / "a.npy")
    np.save(tmp_path / "b.npy", QPOS[:, :-1])
    with pytest.raises(UserError, match=r"'qpos' has the shape \(100, 13\), not \(samples, 14\)"):
        read(tmp_path / "b.npy", fps=50.0)
    np.save(tmp_path / "c.npy", np.array([{}, 1], object))
    with pytest.raises(UserError, match=r"c\.npy: it holds pickled objects; an \.npy file of qpos"):
        read(tmp_path / "c.npy", fps=50.0)
    (tmp_path / "d.npy").write_bytes((tmp_path / "a.npy").read_bytes()[:3000])
    with pytest.raises(UserError, match="half of one"):
        read(tmp_path / "d.npy", fps=50.0)


def test_a_motion_that_is_implausible_in_every_layout_is_read_as_documented(tmp_path):
    rng = np.random.default_rng(4)
    qpos = QPOS.copy()
    qpos[:, :3] += np.cumsum(rng.normal(0, 0.2, (100, 3)), axis=0)
    turn = rng.normal(0, 1, (100, 4))
    qpos[:, 3:7] = turn / np.linalg.norm(turn, axis=1, keepdims=True)
    np.savez(tmp_path / "a.npz", qpos=qpos, fps=50.0)
    found, notes = read(tmp_path / "a.npz")
    biped.assert_same(found.qpos, qpos, 1e-12)
    assert not notes


@pytest.mark.parametrize("turn", [1, -1])
def test_a_figure_whose_rest_pose_lies_down_is_not_turned(turn, tmp_path):
    lying = biped.TEXT.replace('pos="0 0 .8"', f'pos="0 0 .2" quat=".70710678 {turn * 0.70710678} 0 0"')
    qpos = biped.walk(heading=0.0)
    np.savez(tmp_path / "a.npz", qpos=qpos, fps=50.0)
    found = recording(tmp_path / "a.npz", model=mujoco.MjModel.from_xml_string(lying))
    biped.assert_same(found.qpos, qpos, 1e-9)
    assert not found.notes
