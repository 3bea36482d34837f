"""What formats hold, read by numpy, pickle and MuJoCo by their own conventions, and what bad files and figures get."""

import pickle
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import motions
import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.formats import mimickit
from dynsplines.exchange.motion_import import import_recording, read_recording
from dynsplines.motion import Sampled, Saved
from dynsplines.solver.array import Array

JOINTS = ["left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "arm_pitch"]
XYZW = [3, 0, 1, 2]  # columns of a quaternion xyzw, in MuJoCo's order


@pytest.fixture(scope="module")
def robot_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("robot") / "robot.xml"
    path.write_text(motions.ROBOT)
    return path


@pytest.fixture(scope="module")
def robot(robot_file: Path) -> Saved:
    return motions.motion_of(str(robot_file))


@pytest.fixture(scope="module")
def human() -> Saved:
    """A motion without any symmetry."""
    return motions.motion_of("human")


@pytest.fixture(scope="module")
def at(robot: Saved) -> Sampled:
    return motions.samples(robot)


@pytest.fixture(scope="module")
def truth(robot: Saved, at: Sampled) -> Mapping[str, Array]:
    """What MuJoCo makes of the robot's motion: of all bodies but the world."""
    return {name: rows[:, 1:] for name, rows in motions.poses(robot.figure.model, at.qpos, at.qvel).items()}


def test_mjlab_holds_hinges_and_bodies_in_the_world(robot, at, truth, tmp_path):
    target, notes = motions.exported(robot, "mjlab", tmp_path)
    file = np.load(target)
    assert notes == [] and file["fps"].shape == (1,) and file["fps"][0] == motions.FPS
    assert file["body_names"].tolist() == [robot.figure.model.body(i).name for i in range(1, robot.figure.model.nbody)]
    assert file["joint_names"].tolist() == JOINTS
    np.testing.assert_array_equal(file["joint_pos"], at.qpos[:, 7:])
    np.testing.assert_array_equal(file["joint_vel"], at.qvel[:, 6:])
    np.testing.assert_allclose(file["body_pos_w"], truth["xpos"], atol=1e-9)
    turned = Rotation.from_quat(file["body_quat_w"].reshape(-1, 4), scalar_first=True).as_matrix()
    np.testing.assert_allclose(turned, truth["xmat"].reshape(-1, 3, 3), atol=1e-9)
    velocity = np.concatenate([file["body_ang_vel_w"], file["body_lin_vel_w"]], axis=-1)
    np.testing.assert_allclose(velocity, truth["velocity"], atol=1e-7)


def test_the_csv_of_mjlab_has_root_quaternion_xyzw_and_hinges(robot, robot_file, at, tmp_path):
    target, notes = motions.exported(robot, "mjlab-csv", tmp_path)
    table = np.loadtxt(target, delimiter=",")
    assert any("50 samples a second" in note for note in notes)
    np.testing.assert_array_equal(table[:, [0, 1, 2, 6, 3, 4, 5, *range(7, 12)]], at.qpos)
    with pytest.raises(UserError, match="the format contains no rate; give the rate: --fps, or fps= in Python"):
        import_recording(target, figure=str(robot_file))
    np.savetxt(target, np.column_stack([at.time, table]), delimiter=",")
    np.testing.assert_allclose(import_recording(target, figure=str(robot_file)).fps, motions.FPS)


def test_gmr_holds_root_xyzw_hinges_and_bodies_about_an_unturned_root(robot, at, tmp_path):
    target, _ = motions.exported(robot, "gmr", tmp_path)
    held, model = pickle.loads(target.read_bytes()), robot.figure.model
    assert set(held) == {"fps", "root_pos", "root_rot", "dof_pos", "local_body_pos", "link_body_list"}
    assert held["fps"] == motions.FPS and held["link_body_list"] == [model.body(i).name for i in range(1, model.nbody)]
    qpos = np.concatenate([held["root_pos"], held["root_rot"][:, XYZW], held["dof_pos"]], axis=1)
    np.testing.assert_array_equal(qpos, at.qpos)
    qpos[:, :7] = [0, 0, 0, 1, 0, 0, 0]
    np.testing.assert_allclose(motions.poses(model, qpos)["xpos"][:, 1:], held["local_body_pos"], atol=1e-9)
    assert b"numpy._core" not in target.read_bytes()  # numpy before 2 has no such module


def test_locomujoco_holds_every_array_that_its_trajectory_has(robot, at, tmp_path):
    target, _ = motions.exported(robot, "locomujoco", tmp_path)
    file, model = dict(np.load(target)), robot.figure.model
    assert file["frequency"] == motions.FPS and file["split_points"].tolist() == [0, len(at.time)]
    for kind, number in (("joint", model.njnt), ("body", model.nbody), ("site", model.nsite)):
        assert file[f"{kind}_names"].tolist() == [getattr(model, kind)(i).name for i in range(number)]
    of_model = ("njnt", "jnt_type", "nbody", "body_rootid", "body_weldid", "body_mocapid", "body_pos", "body_quat")
    for name in (*of_model, "body_ipos", "body_iquat", "nsite", "site_bodyid", "site_pos", "site_quat"):
        np.testing.assert_array_equal(file.pop(name), getattr(model, name), err_msg=name)
    data = mujoco.MjData(model)
    for t in range(0, len(at.time), 7):
        data.qpos, data.qvel = at.qpos[t], at.qvel[t]
        mujoco.mj_forward(model, data)
        for name in ("qpos", "qvel", "xpos", "xquat", "cvel", "subtree_com", "site_xpos", "site_xmat"):
            np.testing.assert_allclose(file[name][t], getattr(data, name), atol=1e-12, err_msg=name)
    # its `load` refuses names that are not fields of TrajectoryInfo, TrajectoryModel and TrajectoryData
    known = {"qpos", "qvel", "xpos", "xquat", "cvel", "subtree_com", "site_xpos", "site_xmat", "split_points"}
    assert set(file) == known | {"joint_names", "body_names", "site_names", "frequency"}


def test_mimickit_frames_are_root_and_joints_as_rotation_vectors(human, tmp_path):
    target, _ = motions.exported(human, "mimickit", tmp_path)
    held, model = pickle.loads(target.read_bytes()), human.figure.model
    assert (held["fps"], held["loop_mode"]) == (motions.FPS, 0)
    frames, truth = np.array(held["frames"]), motions.poses(model, motions.samples(human).qpos)
    bodies = [i for i in range(1, model.nbody) if model.body_jntnum[i]]
    for t in (0, 17, 60):  # forward_kinematics of kin_char_model.py: parent, then the body's rest, then the joint
        position, rotation = {bodies[0]: frames[t, :3]}, {bodies[0]: Rotation.from_rotvec(frames[t, 3:6])}
        for n, body in enumerate(bodies[1:], 1):
            above = int(model.body_parentid[body])
            rest = Rotation.from_quat(model.body_quat[body], scalar_first=True)
            position[body] = position[above] + rotation[above].apply(model.body_pos[body])
            rotation[body] = rotation[above] * rest * Rotation.from_rotvec(frames[t, 3 + 3 * n : 6 + 3 * n])
        np.testing.assert_allclose(list(position.values()), truth["xpos"][t, bodies], atol=1e-9)
        own = np.array([each.as_matrix() for each in rotation.values()])
        np.testing.assert_allclose(own, truth["xmat"][t, bodies].reshape(-1, 3, 3), atol=1e-9)


def test_mimickit_takes_three_hinges_on_a_body_for_a_ball_joint_whose_angles_are_zero_at_rest(tmp_path):
    text = motions.ROBOT.replace('name="left_knee"', 'name="left_knee" ref="0.5"')
    (tmp_path / "robot.xml").write_text(text.replace('name="left_hip_roll"', 'name="left_hip_roll" ref="-0.3"'))
    robot = motions.motion_of(str(tmp_path / "robot.xml"))
    target, notes = motions.exported(robot, "mimickit", tmp_path)
    frames = np.array(pickle.loads(target.read_bytes())["frames"])
    assert frames.shape[1] == 6 + 3 + 1 + 1 and notes == []
    turned = motions.samples(robot).qpos[:, 7:] - robot.figure.model.qpos0[7:]
    leg = Rotation.from_euler("YXZ", turned[:, :3])
    np.testing.assert_allclose(Rotation.from_rotvec(frames[:, 6:9]).as_matrix(), leg.as_matrix(), atol=1e-12)
    np.testing.assert_allclose(frames[:, 9:], turned[:, 3:], atol=1e-12)
    slides = motions.ROBOT.replace('name="arm_pitch" type="hinge"', 'name="arm" type="slide"')
    with pytest.raises(UserError, match="a body; 'arm' has others"):
        mimickit.parts(mujoco.MjModel.from_xml_string(slides))


def test_plain_arrays_and_keys_hold_every_digit_and_the_figure(human, tmp_path):
    before, model = motions.samples(human), human.figure.model
    file = np.load(motions.exported(human, "npz", tmp_path)[0])
    for name in ("time", "qpos", "qvel", "qacc"):
        np.testing.assert_array_equal(file[name], getattr(before, name))
    keyed = mujoco.MjModel.from_xml_path(str(motions.exported(human, "mjcf", tmp_path)[0]))
    np.testing.assert_array_equal(keyed.key_time, before.time)
    np.testing.assert_allclose(keyed.key_qpos, before.qpos, atol=1e-15)  # quaternions are made unit once more
    np.testing.assert_array_equal(keyed.key_qvel, before.qvel)
    assert [keyed.key(i).name for i in (0, 60)] == ["wild_0", "wild_60"]
    for other in (mujoco.MjModel.from_xml_string(str(file["mjcf"])), keyed):
        assert [other.joint(i).name for i in range(other.njnt)] == file["joint_names"].tolist()
        for name in ("body_pos", "body_mass", "geom_size", "site_pos", "jnt_range"):
            np.testing.assert_array_equal(getattr(other, name), getattr(model, name))


BAD = {
    "mjlab": (
        ({"body_pos_w": None}, r"no 'body_pos_w'; it holds: fps, joint_pos"),
        ({"joint_pos": np.zeros((4, 5))}, r"'joint_pos' \(4, 5\), 'body_pos_w' \(61, 4, 3\)$"),
        ({"body_quat_w": np.zeros((61, 4, 4))}, "quaternion of length 0"),
        ({"joint_names": np.array(["a", *JOINTS[1:]])}, "no joint 'left_hip_pitch'; it has: a, left_hip_roll"),
        ({"fps": np.array([0.0])}, "'fps' is not a number of samples a second"),
    ),
    "locomujoco": (
        ({"frequency": None}, "no 'frequency'"),
        ({"jnt_type": np.array([0, 1, 3, 3, 3, 3])}, "'jnt_type' must list one free joint and one hinge"),
        ({"qpos": np.full((61, 12), np.nan)}, "'qpos': an entry is not a finite number"),
    ),
    "npz": (
        ({"qpos": np.zeros((61, 3))}, r"'qpos' has the shape \(61, 3\), not \(61, 12\)|not \(samples, 12\)"),
        ({"joint_names": np.array(["one"])}, "its joints are one; the figure's floating, .*; to transfer it"),
        ({"qpos": np.array("text")}, "holds str"),
        ({"time": None, "fps": None}, "neither 'time' nor 'fps'"),
    ),
    "gmr": (
        ({"root_rot": None}, "no 'root_rot'"),
        ({"dof_pos": np.zeros((61, 4))}, "4 joints; the figure has 5: left_hip_pitch"),
        ({"dof_pos": [[1, 2], [3]]}, "rows of different lengths"),
        ({"root_pos": np.full((61, 3), np.inf)}, "not a finite number"),
    ),
}  # fmt: skip


@pytest.mark.parametrize(("kind", "change", "says"), [(kind, *case) for kind, cases in BAD.items() for case in cases])
def test_bad_files_are_reported_in_one_line_that_names_file_and_fault(
    kind: str, change: dict[str, Any], says: str, robot: Saved, robot_file: Path, tmp_path: Path
):
    target, _ = motions.exported(robot, kind, tmp_path)
    entries = pickle.loads(target.read_bytes()) if kind == "gmr" else dict(np.load(target))
    entries = {name: value for name, value in (entries | change).items() if value is not None}
    if kind == "gmr":
        target.write_bytes(pickle.dumps(entries))
    else:
        np.savez(target, **entries)
    with pytest.raises(UserError, match=says) as error:
        import_recording(target, kind, figure=str(robot_file))
    assert str(target) in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("name", "content", "figure", "says"),
    [
        ("own.keys.xml", "", None, "the format 'mjcf' is only written; read are: csv"),
        ("own.xml", "<mujoco/>", None, "its ending is of no known format"),
        ("some.mjlab.csv", "x,y\n1,2\n", None, "name the figure: --figure, or figure= in Python"),
        ("bare.npz", {"qpos": np.zeros((9, 51))}, None, "no 'mjcf', the figure; name the figure: --figure"),
        ("other.npz", {"a": 1}, "human", "of no known format, with the arrays a; give --from"),
        ("absent.npz", None, "human", "no file"),
    ],
)
def test_files_that_lack_something_are_refused(name: str, content: Any, figure: str | None, says: str, tmp_path: Path):
    if isinstance(content, dict):
        np.savez(tmp_path / name, **content)
    elif content is not None:
        (tmp_path / name).write_text(content)
    with pytest.raises(UserError, match=says):
        import_recording(tmp_path / name, figure=figure)


@pytest.mark.parametrize("kind", ["mjlab", "mjlab-csv", "gmr", "locomujoco"])
def test_figures_without_a_free_root_are_refused(kind: str, tmp_path: Path):
    (tmp_path / "post.xml").write_text(
        motions.ROBOT.replace('<freejoint name="floating"/>', '<joint name="swing" axis="0 1 0"/>')
    )
    fixed = motions.through(str(tmp_path / "post.xml"), np.array([0, 0.5]), np.zeros((2, 6)))
    with pytest.raises(UserError, match=f"'{kind}' is for a figure with one free joint, its root; this one has none"):
        formats.export(fixed, kind, tmp_path / f"out{formats.writer(kind).ending}")
    assert not list(tmp_path.glob("out*"))


@pytest.mark.parametrize("kind", ["mjlab", "mjlab-csv", "gmr"])
def test_carried_objects_are_left_out_with_a_note(kind: str, tmp_path: Path):
    crate = '<body name="crate"><freejoint/><geom size=".1" mass="1"/></body></worldbody>'
    for name, model in (("alone", motions.ROBOT), ("carries", motions.ROBOT.replace("</worldbody>", crate))):
        (tmp_path / f"{name}.xml").write_text(model)
    saved, alone = (motions.motion_of(str(tmp_path / f"{name}.xml")) for name in ("carries", "alone"))
    target, notes = motions.exported(saved, kind, tmp_path)
    assert "the format has no objects: crate left out" in notes
    back = read_recording(target, figure=str(tmp_path / "alone.xml"), kind=kind, fps=saved.fps)
    wanted = motions.samples(saved).qpos[:, : alone.figure.model.nq]
    motions.same_poses(alone.figure.model, wanted, back.qpos)
    read_recording(target, figure=str(tmp_path / "carries.xml"), kind=kind, fps=saved.fps)
    with pytest.raises(UserError, match="for one figure, not for 'crate'; export mjlab"):
        motions.exported(saved, "locomujoco", tmp_path)


@pytest.mark.parametrize("kind", ["mjlab", "mjlab-csv", "gmr", "locomujoco"])
def test_figures_with_ball_joints_are_refused(kind: str, human: Saved, robot: Saved, tmp_path: Path):
    words = f"the format '{kind}' contains hinges and slides only; 'spine' is a ball joint: use a figure of hinges, or"
    with pytest.raises(UserError, match=words):
        motions.exported(human, kind, tmp_path)
    target, _ = motions.exported(robot, kind, tmp_path)
    with pytest.raises(UserError, match=words):
        formats.recording(target, kind, model=human.figure.model, fps=motions.FPS)
