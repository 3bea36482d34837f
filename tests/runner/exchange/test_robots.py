"""Formats of robots: what is written, read by numpy and held against MuJoCo; what others write; bad files."""

import pickle

import mujoco
import numpy as np
import pytest
import wild
from scipy.spatial.transform import Rotation

from dynsplines import motion
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording

JOINTS = ["left_hip_pitch", "left_hip_roll", "left_hip_yaw", "left_knee", "arm_pitch"]


@pytest.fixture(scope="module")
def robot_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("robot") / "robot.xml"
    path.write_text(wild.ROBOT)
    return path


@pytest.fixture(scope="module")
def robot(robot_file):
    return wild.motion_of(str(robot_file))


def hinge_model(target):
    return mujoco.MjModel.from_xml_path(str(target.with_suffix(".hinges.xml")))


def test_mjlab_holds_what_mujoco_makes_of_the_motion(human, tmp_path):
    target, notes = wild.exported(human, "mjlab", tmp_path)
    file, model, before = np.load(target), hinge_model(target), wild.samples(human)
    truth = wild.poses(human.figure.model, before.qpos, before.qvel)
    names = [human.figure.model.body(i).name for i in range(human.figure.model.nbody)]
    rows = [names.index(name) for name in file["body_names"]]
    assert list(file["body_names"]) == names[1:] and file["body_names"][0] == "pelvis"
    assert file["fps"].shape == (1,) and file["fps"][0] == wild.FPS
    np.testing.assert_allclose(file["body_pos_w"], truth["xpos"][:, rows], atol=1e-9)
    turned = Rotation.from_quat(file["body_quat_w"].reshape(-1, 4), scalar_first=True).as_matrix()
    np.testing.assert_allclose(turned, truth["xmat"][:, rows].reshape(-1, 3, 3), atol=1e-9)
    np.testing.assert_allclose(file["body_ang_vel_w"], truth["velocity"][:, rows, :3], atol=1e-7)
    np.testing.assert_allclose(file["body_lin_vel_w"], truth["velocity"][:, rows, 3:], atol=1e-7)
    assert list(file["joint_names"]) == [model.joint(i).name for i in range(1, model.njnt)]
    qpos = np.concatenate([file["body_pos_w"][:, 0], file["body_quat_w"][:, 0], file["joint_pos"]], axis=1)
    again = wild.poses(model, qpos, np.concatenate([before.qvel[:, :6], file["joint_vel"]], axis=1))
    for name, tolerance in (("xpos", 1e-9), ("velocity", 1e-7)):
        np.testing.assert_allclose(again[name][:, rows], truth[name][:, rows], atol=tolerance)
    assert notes == [f"wrote {target.with_suffix('.hinges.xml')}"]


@pytest.mark.slow
def test_the_csv_of_mjlab_has_root_quaternion_xyzw_and_hinges(human, tmp_path):
    target, notes = wild.exported(human, "mjlab-csv", tmp_path)
    table, model, before = np.loadtxt(target, delimiter=","), hinge_model(target), wild.samples(human)
    assert any("50 samples a second" in note for note in notes)
    np.testing.assert_array_equal(table[:, :3], before.qpos[:, :3])
    np.testing.assert_array_equal(table[:, [6, 3, 4, 5]], before.qpos[:, 3:7])
    qpos = table[:, [0, 1, 2, 6, 3, 4, 5, *range(7, table.shape[1])]]
    truth = wild.poses(human.figure.model, before.qpos)
    np.testing.assert_allclose(wild.poses(model, qpos)["xpos"], truth["xpos"], atol=1e-9)
    wild.came_back(human, target, fps=wild.FPS)
    with pytest.raises(UserError, match="the format contains no rate; give the rate: --fps, or fps= in Python"):
        import_recording(target, figure="human")


@pytest.mark.slow
def test_gmr_holds_root_xyzw_hinges_and_bodies_about_an_unturned_root(human, tmp_path):
    target, _ = wild.exported(human, "gmr", tmp_path)
    with target.open("rb") as stream:
        held = pickle.load(stream)
    model, before = hinge_model(target), wild.samples(human)
    assert set(held) == {"fps", "root_pos", "root_rot", "dof_pos", "local_body_pos", "link_body_list"}
    assert held["fps"] == wild.FPS and held["link_body_list"][0] == "pelvis"
    np.testing.assert_array_equal(held["root_rot"][:, [3, 0, 1, 2]], before.qpos[:, 3:7])
    qpos = np.concatenate([held["root_pos"], held["root_rot"][:, [3, 0, 1, 2]], held["dof_pos"]], axis=1)
    np.testing.assert_allclose(
        wild.poses(model, qpos)["xpos"], wild.poses(human.figure.model, before.qpos)["xpos"], atol=1e-9
    )
    qpos[:, :7] = [0, 0, 0, 1, 0, 0, 0]
    rows = [model.body(name).id for name in held["link_body_list"]]
    np.testing.assert_allclose(wild.poses(model, qpos)["xpos"][:, rows], held["local_body_pos"], atol=1e-9)
    wild.came_back(human, target)
    assert b"numpy._core" not in target.read_bytes()  # numpy before 2 has no such module


@pytest.mark.slow
def test_locomujoco_holds_every_array_that_its_trajectory_has(human, tmp_path):
    target, _ = wild.exported(human, "locomujoco", tmp_path)
    file, model, before = dict(np.load(target)), hinge_model(target), wild.samples(human)
    count = len(before.time)
    assert file["frequency"] == wild.FPS and file["split_points"].tolist() == [0, count]
    for kind, number in (("joint", model.njnt), ("body", model.nbody), ("site", model.nsite)):
        assert file[f"{kind}_names"].tolist() == [getattr(model, kind)(i).name for i in range(number)]
    of_model = ("njnt", "jnt_type", "nbody", "body_rootid", "body_weldid", "body_mocapid", "body_pos", "body_quat")
    for name in (*of_model, "body_ipos", "body_iquat", "nsite", "site_bodyid", "site_pos", "site_quat"):
        np.testing.assert_array_equal(file.pop(name), getattr(model, name), err_msg=name)
    data, ball = mujoco.MjData(model), mujoco.MjData(human.figure.model)
    for t in range(0, count, 7):
        data.qpos, data.qvel = file["qpos"][t], file["qvel"][t]
        ball.qpos, ball.qvel = before.qpos[t], before.qvel[t]
        for m, d in ((model, data), (human.figure.model, ball)):
            mujoco.mj_forward(m, d)
        for name in ("xpos", "xquat", "cvel", "subtree_com", "site_xpos", "site_xmat"):
            np.testing.assert_allclose(file[name][t], getattr(data, name), atol=1e-12, err_msg=name)
            if name != "xquat":  # of either sign
                np.testing.assert_allclose(file[name][t], getattr(ball, name), atol=1e-7, err_msg=name)
    # its `load` refuses names that are not fields of TrajectoryInfo, TrajectoryModel and TrajectoryData
    known = {"qpos", "qvel", "xpos", "xquat", "cvel", "subtree_com", "site_xpos", "site_xmat", "split_points"}
    assert set(file) == known | {"joint_names", "body_names", "site_names", "frequency"}
    wild.came_back(human, target)


def test_locomujoco_reads_files_of_its_own_tool_and_refuses_several_motions(robot, robot_file, tmp_path):
    before = wild.samples(robot)
    order = [3, 0, 1, 2, 4]  # of the hinges, as another tool may have them
    entries = {
        "joint_names": np.array([JOINTS[i] for i in order] + ["root_free"]),
        "jnt_type": np.array([3] * 5 + [0], np.int32),
        "qpos": np.concatenate([before.qpos[:, 7:][:, order], before.qpos[:, :7]], axis=1).astype(np.float32),
        "qvel": before.qvel,
        "frequency": np.array(wild.FPS),
        "split_points": np.array([0, len(before.time)], np.int32),
        "metadata": np.array(None, dtype=object),  # None is a pickle, which nobody loads
    }
    np.savez(tmp_path / "theirs.npz", **entries)
    wild.came_back(robot, tmp_path / "theirs.npz", str(robot_file), tolerance=1e-5)
    entries["split_points"] = np.array([0, 10, len(before.time)])
    np.savez(tmp_path / "two.npz", **entries)
    with pytest.raises(UserError, match="holds 2 motions"):
        import_recording(tmp_path / "two.npz", figure=str(robot_file))


@pytest.mark.slow
def test_plain_arrays_bring_motion_and_figure(human, tmp_path):
    target, _ = wild.exported(human, "npz", tmp_path)
    file, before = np.load(target), wild.samples(human)
    for name in ("time", "qpos", "qvel", "qacc"):
        np.testing.assert_array_equal(file[name], getattr(before, name))
    model = mujoco.MjModel.from_xml_string(str(file["mjcf"]))
    assert [model.joint(i).name for i in range(model.njnt)] == list(file["joint_names"])
    wild.came_back(human, target, None)
    np.savez(tmp_path / "bare.npz", qpos=before.qpos)
    wild.came_back(human, tmp_path / "bare.npz", fps=50.0)
    with pytest.raises(UserError, match="neither 'time' nor 'fps'"):
        import_recording(tmp_path / "bare.npz", figure="human")
    with pytest.raises(UserError, match="no 'mjcf', the figure; name the figure: --figure"):
        import_recording(tmp_path / "bare.npz", fps=50.0)


BAD = {
    "mjlab": (
        ({"body_pos_w": None}, r"no 'body_pos_w'; it holds: fps, joint_pos"),
        ({"joint_pos": np.zeros((4, 5))}, r"'joint_pos' \(4, 5\), 'body_pos_w' \(61, 4, 3\); `dynsplines clean` uses"),
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
    ),
    "gmr": (
        ({"root_rot": None}, "no 'root_rot'"),
        ({"dof_pos": np.zeros((61, 4))}, "4 joints; the figure has 5: left_hip_pitch"),
        ({"dof_pos": [[1, 2], [3]]}, "rows of different lengths"),
        ({"root_pos": np.full((61, 3), np.inf)}, "not a finite number"),
    ),
}  # fmt: skip


@pytest.mark.parametrize(("kind", "change", "says"), [(kind, *case) for kind, cases in BAD.items() for case in cases])
def test_bad_files_are_reported_in_one_line_that_names_file_and_fault(kind, change, says, robot, robot_file, tmp_path):
    target, _ = wild.exported(robot, kind, tmp_path)
    if kind == "gmr":
        with target.open("rb") as stream:
            entries = pickle.load(stream)
    else:
        entries = dict(np.load(target))
    entries = {name: value for name, value in (entries | change).items() if value is not None}
    if kind == "gmr":
        target.write_bytes(pickle.dumps(entries))
    else:
        np.savez(target, **entries)
    with pytest.raises(UserError, match=says) as error:
        import_recording(target, kind, figure=str(robot_file))
    assert str(target) in str(error.value) and "\n" not in str(error.value)


def test_figures_that_a_format_cannot_hold_are_refused(tmp_path):
    (tmp_path / "post.xml").write_text(
        wild.ROBOT.replace('<freejoint name="floating"/>', '<joint name="swing" axis="0 1 0"/>')
    )
    fixed = wild.through(str(tmp_path / "post.xml"), np.array([0, 0.5]), np.zeros((2, 6)))
    for kind in ("mjlab", "mjlab-csv", "gmr", "locomujoco"):
        with pytest.raises(
            UserError, match=f"'{kind}' is for a figure with one free joint, its root; this one has none"
        ):
            formats.export(fixed, kind, tmp_path / f"out{formats.writer(kind).ending}")
    assert not list(tmp_path.glob("out*"))
    with pytest.raises(UserError, match="name the figure: --figure, or figure= in Python"):
        formats.recording(_written(tmp_path, b"x,y\n1,2\n", "some.mjlab.csv"), fps=1.0)


def _written(folder, content, name):
    (folder / name).write_bytes(content)
    return folder / name


@pytest.mark.slow
def test_what_is_in_a_file_tells_its_format_where_the_ending_does_not(human, robot, tmp_path):
    for kind in ("mjlab", "locomujoco", "npz", "gmr", "mimickit", "mjcf"):
        target, _ = wild.exported(robot, kind, tmp_path)
        plain = target.rename(tmp_path / f"plain_{kind}{target.suffix}")
        assert formats.recording(plain, model=robot.figure.model).qpos.shape == wild.samples(robot).qpos.shape
    motion.save(human, tmp_path / "ours.npz")
    assert len(import_recording(tmp_path / "ours.npz").keys) == len(wild.samples(human).time)
    np.savez(tmp_path / "other.npz", a=1)
    with pytest.raises(
        UserError, match="its ending is of no known format; give --from, or format= in Python, one of: npz, mjlab"
    ):
        import_recording(tmp_path / "other.npz", figure="human")
    with pytest.raises(UserError, match="no file"):
        import_recording(tmp_path / "absent.npz", figure="human")
    with pytest.raises(UserError, match="'amass' is read only; written are: csv"):
        formats.export(human, "amass", tmp_path / "out")
