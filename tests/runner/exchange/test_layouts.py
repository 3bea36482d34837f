"""Arrays have the layout of their names, which body poses confirm, and files without names need a format."""

import pickle
from typing import Any

import motions
import numpy as np
import pytest
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.formats import recording

QPOS = motions.biped_walk()
NAMES = ["waist_yaw", *motions.JOINTS]


def assert_same(found: np.ndarray, qpos: np.ndarray, tolerance: float = 1e-9) -> None:
    """That configurations are equal up to the sign of the root's quaternion."""
    sign = np.sign(np.sum(found[:, 3:7] * qpos[:, 3:7], axis=1, keepdims=True))
    np.testing.assert_allclose(np.hstack([found[:, :3], sign * found[:, 3:7], found[:, 7:]]), qpos, atol=tolerance)


def y_up(qpos: np.ndarray, *, with_frame: bool) -> np.ndarray:
    """As programs with y up have it, the root's own axes turned with the world or not, by SciPy."""
    turn = Rotation.from_euler("x", -90, degrees=True)
    rotation = turn * Rotation.from_quat(qpos[:, 3:7], scalar_first=True)
    rotation = rotation * turn.inv() if with_frame else rotation
    return np.hstack([turn.apply(qpos[:, :3]), rotation.as_quat(scalar_first=True), qpos[:, 7:]])


def biped_poses(qpos: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """MuJoCo's xpos (T, 9, 3) and xquat (T, 9, 4), the world first."""
    figure = motions.model()
    seen = [kinematics(figure, row) for row in qpos]
    return np.array([data.xpos for data in seen]), np.array([data.xquat for data in seen])


PLACE, TURN = biped_poses(QPOS)
BODIES = [
    "world",
    "pelvis",
    "waist",
    *(f"{side}_{part}" for side in ("left", "right") for part in ("thigh", "shin", "foot")),
]
BREADTH = [0, 1, 4, 2, 5, 3, 6]  # of the joints: waist and hips, knees, ankles
MIXED = [3, 0, 6, 2, 5, 1, 4]
XYZW = [0, 1, 2, 4, 5, 6, 3, *range(7, 14)]
DEGREES = np.hstack([QPOS[:, :7], np.degrees(QPOS[:, 7:])])


def read(path, kind=None, fps=50.0):
    found = recording(path, kind, model=motions.model(), fps=fps)
    return found, " ".join(found.notes)


def arrays(path, **entries):
    held: dict[str, Any] = {name: np.asarray(value) for name, value in entries.items() if value is not None}
    np.savez(path, **held)
    return path


def mjlab(path, **changes):
    entries: dict[str, Any] = {
        "fps": [50], "joint_pos": QPOS[:, 7:], "joint_vel": np.zeros((100, 7)), "body_pos_w": PLACE[:, 1:],
        "body_quat_w": TURN[:, 1:], "joint_names": NAMES, "body_names": BODIES[1:],
    }  # fmt: skip
    return arrays(path, **entries | changes)


SAME = {
    "as documented": {},
    "without names": {"joint_names": None, "body_names": None},
    "single precision": {"joint_pos": QPOS[:, 7:].astype(np.float32), "body_pos_w": PLACE[:, 1:].astype("f4")},
    "names in another order": {"joint_pos": QPOS[:, 7:][:, MIXED], "joint_names": np.array(NAMES)[MIXED]},
    "bodies in another order": {"body_pos_w": PLACE[:, ::-1], "body_quat_w": TURN[:, ::-1], "body_names": BODIES[::-1]},
    "the world first": {"body_pos_w": PLACE, "body_quat_w": TURN, "body_names": BODIES},
    "few bodies": {"body_pos_w": PLACE[:, [1, 5, 8]], "body_quat_w": TURN[:, [1, 5, 8]], "body_names": None},
}
DIFFERENT = {
    "longer steps": {"joint_pos": QPOS[:, 7:] * 1.2},
    "larger": {"body_pos_w": PLACE[:, 1:] * 1.1},
    "wrong names": {"joint_names": np.array(NAMES)[MIXED]},
    "degrees": {"joint_pos": DEGREES[:, 7:]},
    "xyzw": {"body_quat_w": np.roll(TURN[:, 1:], -1, -1)},
    "breadth first": {"joint_pos": QPOS[:, 7:][:, BREADTH], "joint_names": None},
    "names of the other side": {"body_names": [*BODIES[1:3], *BODIES[6:], *BODIES[3:6]]},
    "the world first, without names": {"body_pos_w": PLACE, "body_quat_w": TURN, "body_names": None},
}


@pytest.mark.parametrize("change", SAME.values(), ids=SAME)
def test_a_file_that_its_body_poses_confirm_is_read(change, tmp_path):
    found, notes = read(mjlab(tmp_path / "a.npz", **change))
    assert_same(found.qpos, QPOS, 1e-6)
    assert not notes


@pytest.mark.parametrize("change", DIFFERENT.values(), ids=DIFFERENT)
def test_body_poses_that_differ_are_refused_with_distance_and_angle(change, tmp_path):
    with pytest.raises(UserError, match=r"a\.npz: its body poses differ .* by up to \d+\.\d cm and \d+\.\d°; .* wxyz"):
        read(mjlab(tmp_path / "a.npz", **change))


def test_qpos_in_another_layout_is_refused(tmp_path):
    with pytest.raises(UserError, match="14 columns of joints with 7 names"):
        read(mjlab(tmp_path / "a.npz", joint_pos=QPOS))
    with pytest.raises(UserError, match=r"its body poses differ"):
        read(arrays(tmp_path / "b.npz", qpos=QPOS[:, XYZW], xpos=PLACE, fps=50))


def table(path, rows):
    np.savetxt(path, rows, delimiter=",", fmt="%.9f")
    return path


@pytest.mark.parametrize("names", [BODIES, [*BODIES[:3], *BODIES[6:], *BODIES[3:6]], None])
def test_bodies_of_gmr_are_those_of_their_names(names, tmp_path):
    """Those of the other side are refused."""
    local = Rotation.from_quat(QPOS[:, 3:7].repeat(9, axis=0), scalar_first=True).inv()
    entries = {"fps": 50, "root_pos": QPOS[:, :3], "root_rot": QPOS[:, [4, 5, 6, 3]], "dof_pos": QPOS[:, 7:]}
    entries |= {"local_body_pos": local.apply((PLACE - PLACE[:, [1]]).reshape(-1, 3)).reshape(PLACE.shape)}
    (tmp_path / "a.pkl").write_bytes(pickle.dumps(entries | ({} if names is None else {"link_body_list": names})))
    if names is None or names == BODIES:
        assert_same(read(tmp_path / "a.pkl")[0].qpos, QPOS)
        return
    with pytest.raises(UserError, match="its body poses differ"):
        read(tmp_path / "a.pkl")


@pytest.mark.parametrize("name", ["a.csv", "a.txt", "a.tsv"])
def test_tables_without_names_need_a_format(name, tmp_path):
    path = table(tmp_path / name, QPOS)
    with pytest.raises(UserError, match=r"a\.\w+: a table without a heading;.*--from"):
        read(path)
    assert_same(read(path, "csv")[0].qpos, QPOS, 1e-8)
    assert_same(read(table(path, QPOS[:, XYZW]), "mjlab-csv")[0].qpos, QPOS, 1e-8)


def gmr(path, rows):
    entries = {"fps": 50, "root_pos": rows[:, :3], "root_rot": rows[:, 3:7], "dof_pos": rows[:, 7:]}
    path.write_bytes(pickle.dumps(entries))
    return path


def qpos_alone(path, rows):
    return arrays(path, qpos=rows, fps=50)


def on_head(rows):
    """The same, turned by half a turn about the axis to the front."""
    turn = Rotation.from_quat(rows[:, 3:7], scalar_first=True) * Rotation.from_euler("x", 180, degrees=True)
    return np.hstack([rows[:, :3], turn.as_quat(scalar_first=True), rows[:, 7:]])


@pytest.mark.parametrize(
    ("write", "name", "kind", "rows"),
    [
        (gmr, "a.pkl", "gmr", motions.biped_walk(heading=0.1)),  # wxyz for xyzw
        (gmr, "a.pkl", "gmr", on_head(QPOS)[:, XYZW]),
        (qpos_alone, "a.npz", "npz", motions.biped_walk(heading=2.0)[:, XYZW]),
        (qpos_alone, "a.npz", "npz", y_up(QPOS, with_frame=False)),
    ],
)
def test_a_root_that_lies_or_stands_on_its_head_needs_a_format(write, name, kind, rows, tmp_path):
    path = write(tmp_path / name, rows)
    with pytest.raises(
        UserError, match=rf"the root is tilted by \d+°.*(xyzw|wxyz) and z up.*convert the file, or give --from {kind}"
    ):
        read(path)
    order = [0, 1, 2, 6, 3, 4, 5, *range(7, 14)] if kind == "gmr" else range(14)
    found, notes = read(path, kind)
    assert_same(found.qpos, rows[:, order], 1e-9)
    assert "convert the file unless that is right" in notes


@pytest.mark.parametrize("write", [gmr, qpos_alone])
@pytest.mark.parametrize("tilt", [0, 50])
def test_other_motions_are_read_as_documented(write, tilt, tmp_path):
    rows = QPOS.copy()
    rows[:, 2] += 1.0
    turn = Rotation.from_quat(rows[:, 3:7], scalar_first=True) * Rotation.from_euler("y", tilt, degrees=True)
    rows[:, 3:7] = turn.as_quat(scalar_first=True)
    found, notes = read(
        write(tmp_path / f"a.{'pkl' if write is gmr else 'npz'}", rows[:, XYZW] if write is gmr else rows)
    )
    assert_same(found.qpos, rows, 1e-9)
    assert not notes


@pytest.mark.parametrize(("write", "name"), [(gmr, "a.pkl"), (qpos_alone, "a.npz"), (table, "a.mjlab.csv")])
def test_angles_far_beyond_their_ranges_are_refused(write, name, tmp_path):
    rows = DEGREES if write is qpos_alone else DEGREES[:, XYZW]
    with pytest.raises(UserError, match=r"'\w+' goes to \d+ rad, more than a turn beyond its range; convert degrees"):
        read(write(tmp_path / name, rows))


def test_a_file_of_two_formats_needs_one(tmp_path):
    path = mjlab(tmp_path / "a.npz", qpos=QPOS)
    with pytest.raises(UserError, match=r"may be of several formats; give --from, .* one of: npz, mjlab"):
        read(path)
    assert_same(read(path, "mjlab")[0].qpos, QPOS, 1e-6)


UNEQUAL = {
    "a.mjlab.npz": {"fps": 50, "joint_pos": QPOS[:, 7:], "joint_vel": QPOS[1:, 7:], "body_pos_w": PLACE[:, 1:],
                    "body_quat_w": TURN[:, 1:], "joint_names": NAMES},
    "a.qpos.npz": {"fps": 50, "qpos": QPOS, "qvel": QPOS[1:, :13], "xpos": PLACE},
    "b.qpos.npz": {"time": np.arange(100) / 50, "qpos": QPOS},
    "a.loco.npz": {"frequency": 50, "qpos": QPOS, "split_points": [0, 100], "joint_names": ["root", *NAMES],
                   "jnt_type": [0, *[3] * 7], "xpos": PLACE},
    "a.gmr.pkl": {"fps": 50, "root_pos": QPOS[:, :3], "root_rot": QPOS[:, [4, 5, 6, 3]], "dof_pos": QPOS[:, 7:]},
}  # fmt: skip
OF_SAMPLES = {"joint_pos", "body_pos_w", "body_quat_w", "qpos", "xpos", "time", "root_pos", "root_rot", "dof_pos"}


def stored(path, entries):
    if path.suffix == ".pkl":
        path.write_bytes(pickle.dumps(entries))
        return path
    return arrays(path, **entries)


@pytest.mark.parametrize("file", UNEQUAL)
def test_arrays_of_samples_must_be_equally_long(file, tmp_path):
    entries: dict[str, Any] = UNEQUAL[file]
    found, _ = read(stored(tmp_path / file, entries | {"gains": np.ones(3)}))
    assert_same(found.qpos, QPOS, 1e-6)
    for name in OF_SAMPLES.intersection(entries):
        path = stored(tmp_path / file, entries | {name: entries[name][:90]})
        with pytest.raises(
            UserError, match=rf"{file}: its arrays differ in their number of samples.*'{name}' \(90,"
        ) as error:
            read(path)
        assert "100," in str(error.value)
