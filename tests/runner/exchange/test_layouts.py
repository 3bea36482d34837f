"""The documented layout of a file has precedence; others are verified by body poses, or decided by plausibility."""

import pickle
from typing import Any

import mujoco
import numpy as np
import pytest
import walking_biped as biped
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.formats import recording
from dynsplines.solver.array import Array

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


XYZW, WXYZ = [4, 5, 6, 3], [3, 4, 5, 6]
KINDS = ("mjlab-csv", "gmr", "mimickit", "npz", "npy")


def saved(kind: str, qpos: Array, folder, *, swapped: bool = False):
    """A file without names and body poses; swapped: with quaternions in the order that the format does not have."""
    root, joints = qpos[:, :3], qpos[:, 7:]
    if kind in ("npz", "npy"):
        rows = np.hstack([root, qpos[:, XYZW if swapped else WXYZ], joints])
        path = folder / f"a.{kind}"
        np.savez(path, qpos=rows, fps=50.0) if kind == "npz" else np.save(path, rows)
        return path
    rotation = qpos[:, WXYZ if swapped else XYZW]
    if kind == "mjlab-csv":
        path = folder / "a.mjlab.csv"
        np.savetxt(path, np.hstack([root, rotation, joints]), delimiter=",", fmt="%.9f")
        return path
    entries = {"fps": 50, "root_pos": root, "root_rot": rotation, "dof_pos": joints}
    if kind == "mimickit":
        vector = Rotation.from_quat(qpos[:, WXYZ], scalar_first=True).as_rotvec()
        entries = {"fps": 50, "loop_mode": 0, "frames": np.hstack([root, vector, joints]).tolist()}
    path = folder / f"a.{kind}.pkl"
    path.write_bytes(pickle.dumps(entries))
    return path


def check(qpos: Array, path, kind: str | None = None) -> str:
    """The file is read as qpos; returns its notes."""
    found, notes = read(path, kind, 50.0)
    biped.assert_same(found.qpos, qpos, 1e-7)
    return notes


def turned(qpos: Array, angles: Array, axis: tuple[float, float, float], height: Array | float = 0.0) -> Array:
    """The same turned by angles (T,) [rad] about an axis of the root, and raised by a height [m]."""
    rotation = Rotation.from_quat(qpos[:, WXYZ], scalar_first=True) * Rotation.from_rotvec(angles[:, None] * axis)
    out = qpos.copy()
    out[:, 3:7] = rotation.as_quat(scalar_first=True)
    out[:, 2] += height
    return out


def motions() -> dict[str, Array]:
    """What robots do besides walking upright on the floor."""
    walk, phase = biped.walk(heading=0.1), np.linspace(0, 1, 100)
    bump = np.clip(np.sin(np.pi * (phase - 0.3) / 0.4), 0, 1) * (abs(phase - 0.5) < 0.2)
    none, lies = np.zeros(100), np.where(phase < 0.4, np.pi / 2, 0.0)
    return {
        "hover at 0.5 m": turned(walk, none, (0, 0, 1), 0.5),
        "hover at 2 m": turned(walk, none, (0, 0, 1), 2.0),
        "jump": turned(walk, none, (0, 0, 1), 0.6 * bump),
        "fly with tilts": turned(walk, np.radians(50) * np.sin(2 * np.pi * phase), (1, 0, 0), 1.0),
        "pitch by 60 degrees": turned(walk, np.radians(60) * bump, (0, 1, 0)),
        "lie on a side": turned(walk, lies, (1, 0, 0), np.where(phase < 0.4, -0.6, 0.0)),
        "turn three times": turned(walk, 6 * np.pi * phase, (0, 0, 1)),
        "slide aside": biped.walk(heading=np.pi),
        "slide backwards": biped.walk(heading=np.pi) * np.array([-1, -1, *[1] * 12]),
        "hover, short": turned(walk, none, (0, 0, 1), 0.3)[:8],
        "slide, short": turned(walk, none + np.pi, (0, 0, 1))[::-1][:8] * np.array([-1, 1, 1, *[1] * 11]),
    }


@pytest.mark.parametrize(("kind", "name"), [*zip(2 * KINDS + KINDS[:1], motions(), strict=True), ("npy", "jump")])
def test_plausible_motions_in_the_documented_layout_are_read_without_question(kind: str, name: str, tmp_path) -> None:
    qpos = motions()[name]
    assert not check(qpos, saved(kind, qpos, tmp_path))


@pytest.mark.parametrize("name", ["jump", "pitch by 60 degrees", "lie on a side", "hover at 0.5 m"])
@pytest.mark.parametrize("kind", ["gmr"])
def test_the_other_order_of_quaternions_is_read_where_the_documented_one_falls(kind: str, name: str, tmp_path) -> None:
    qpos = motions()[name]
    notes = check(qpos, saved(kind, qpos, tmp_path, swapped=True))
    assert notes.startswith(f"read as {kind} with quaternions wxyz: tilt") and f"as {kind} it would be: tilt" in notes


@pytest.mark.parametrize("name", ["jump"])
@pytest.mark.parametrize("kind", KINDS)
def test_y_up_is_read_where_the_documented_layout_lies_down(kind: str, name: str, tmp_path) -> None:
    qpos = motions()[name]
    assert "with y up" in check(qpos, saved(kind, biped.y_up(qpos, with_frame=False), tmp_path))


def test_an_implausible_documented_layout_with_two_plausible_others_needs_a_format(tmp_path) -> None:
    qpos = np.tile(biped.walk(heading=0.0)[25], (40, 1))
    rows = biped.y_up(qpos, with_frame=True)
    path = saved("gmr", rows, tmp_path)
    with pytest.raises(
        UserError, match=r"as gmr it is implausible .*y up in .* and gmr with y up and z forward"
    ) as error:
        read(path, fps=50.0)
    assert "are equally plausible" in str(error.value) and "--from" in str(error.value)
    notes = check(rows, path, "gmr")
    assert notes.startswith("read as gmr: tilt 0°") and "with y up in the world" in notes


def test_a_robot_that_flies_where_another_layout_stands_on_the_floor_needs_a_format(tmp_path) -> None:
    walk = biped.walk(heading=0.0)
    walk[:, 1] -= 1.6
    rows = biped.y_up(walk, with_frame=True)  # as documented it is 0.8 m above the floor, upright
    path = saved("npz", rows, tmp_path)
    with pytest.raises(UserError, match=r"as npz it is doubtful .* as npz with y up .* give --from"):
        read(path, fps=50.0)
    assert "read as npz" in check(rows, path, "npz")


@pytest.mark.parametrize("kind", ["csv", "mjlab-csv"])
def test_sliding_decides_between_tables_over_enough_samples_alone(kind: str, tmp_path) -> None:
    qpos = biped.walk(heading=0.0 if kind == "mjlab-csv" else np.pi)
    rows = np.hstack([qpos[:, :3], qpos[:, WXYZ if kind == "csv" else XYZW], qpos[:, 7:]])
    np.savetxt(tmp_path / "a.csv", rows, delimiter=",", fmt="%.9f")
    assert check(qpos, tmp_path / "a.csv").startswith(f"read as {kind}: tilt")
    np.savetxt(tmp_path / "a.csv", rows[:12], delimiter=",", fmt="%.9f")
    with pytest.raises(UserError, match=r"csv and (mjlab-)?csv are equally plausible .* one of: "):
        read(tmp_path / "a.csv", fps=50.0)
    check(qpos[:12], tmp_path / "a.csv", kind)
