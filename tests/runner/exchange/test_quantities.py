"""Columns of velocities and forces: named, with units, and what MuJoCo's inverse dynamics says of the same motion."""

import csv
import re

import motions
import mujoco
import numpy as np
import pytest
import shipped
from oracles import inverse_dynamics
from random_models import motion_of
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines import inbetween, load, models, recordings, solving
from dynsplines.errors import UserError
from dynsplines.exchange import formats, quantities
from dynsplines.exchange.motion_import import import_recording
from dynsplines.measure.forces import Forces, motor_torques
from dynsplines.motion import Sampled

ALL = tuple(quantities.GROUPS)
NAMES = (
    "root.vx [m/s]", "root.wz [rad/s]", "left_knee.wy [rad/s]", "left_knee.ty [N m]", "root.fz [N]", "com.x [m]",
    "left_foot.fz [N]", "left_foot.cop.x [m]", "left_foot.mz [N m]", "unsupplied.my [N m]",
)  # fmt: skip


@pytest.fixture(scope="module")
def walk():
    return shipped.unsolved("walk_loop")


@pytest.fixture(scope="module")
def table(walk, tmp_path_factory):
    """The file, and its columns by heading."""
    path = formats.export(walk, "csv", tmp_path_factory.mktemp("walk") / "a.csv", columns=ALL)
    with path.open(newline="") as stream:
        heading, *rows = csv.reader(stream)
    return path, dict(zip(heading, np.array(rows, float).T, strict=True))


def vector(columns, name, unit):
    return np.array([columns[f"{name}{axis} [{unit}]"] for axis in "xyz"]).T


@pytest.mark.slow
def test_columns_have_names_and_units_and_the_table_is_read_as_before(walk, table):
    path, columns = table
    assert list(columns)[:3] == ["time", "root.x", "root.y"]
    assert set(NAMES) <= columns.keys()
    assert not any(name.startswith("root.t") for name in columns)
    back = import_recording(path, figure="human")
    np.testing.assert_allclose(motions.samples(back).qpos, motions.samples(walk).qpos, atol=1e-12)


@pytest.mark.slow
def test_angles_are_those_of_keyframes_in_degrees(walk, table):
    columns = table[1]
    for joint, first in (("root", 3), ("left_knee", walk.figure.model.joint("left_knee").qposadr[0])):
        quats = motions.samples(walk).qpos[:, first : first + 4]
        expected = Rotation.from_quat(quats, scalar_first=True).as_rotvec(degrees=True)
        np.testing.assert_allclose(vector(columns, f"{joint}.r", "deg"), expected, atol=1e-9)


@pytest.mark.slow
def test_feet_and_what_is_left_make_up_the_wrench_about_the_centre_of_mass(table):
    columns = table[1]
    force, moment = vector(columns, "unsupplied.f", "N"), vector(columns, "unsupplied.m", "N m")
    for foot in ("left_foot", "right_foot"):
        push = vector(columns, f"{foot}.f", "N")
        arm = np.nan_to_num(vector(columns, f"{foot}.cop.", "m") - vector(columns, "com.", "m"))
        force, moment = force + push, moment + np.cross(arm, push) + np.nan_to_num(vector(columns, f"{foot}.m", "N m"))
    np.testing.assert_allclose(force, vector(columns, "root.f", "N"), atol=1e-3)
    np.testing.assert_allclose(moment, vector(columns, "root.m", "N m"), atol=1e-3)
    loaded = columns["left_foot.fz [N]"] > 50
    assert 0.3 < loaded.mean() < 0.9
    assert np.median(np.abs(columns["left_foot.cop.z [m]"][loaded])) < 0.01  # the sole, which a raw walk puts deep
    assert np.abs(columns["left_foot.cop.x [m]"] - columns["root.x"])[loaded].max() < 0.6


@pytest.mark.slow
def test_torques_are_inverse_dynamics_under_the_grounds_forces(walk, table):
    columns, at, model = table[1], motions.samples(walk), walk.figure.model
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    data = mujoco.MjData(model)
    for t in range(0, len(at.time), 6):
        data.qpos[:], data.qvel[:], data.qacc[:] = at.qpos[t], at.qvel[t], at.qacc[t]
        mujoco.mj_inverse(model, data)
        pushed = np.zeros(model.nv)
        for foot in ("left_foot", "right_foot"):
            push, place = vector(columns, f"{foot}.f", "N")[t], vector(columns, f"{foot}.cop.", "m")[t]
            if np.isfinite(place).all():
                twist = vector(columns, f"{foot}.m", "N m")[t]
                mujoco.mj_applyFT(model, data, push, twist, place, model.body(foot).id, pushed)
        expected = data.qfrc_inverse - pushed
        for joint in ("left_knee", "right_ankle", "spine", "left_elbow"):
            dof = int(model.joint(joint).dofadr[0])
            found = vector(columns, f"{joint}.t", "N m")[t]
            np.testing.assert_allclose(found, expected[dof : dof + 3], atol=1e-6)
    assert np.abs(vector(columns, "left_ankle.t", "N m")).max() > 20  # a foot that nothing pushes needs less than 1


def test_what_is_unknown_is_not_a_number_and_is_reported(tmp_path):
    """A figure that stands for 0.3 s, and is elsewhere after a second: nobody says how it got there."""
    text = 'figure = "human"\n'
    for time, x in ((0, 0), (0.3, 0), (1.3, 0.8)):
        text += f'[[keyframe]]\ntime = {time}\nroot.position = [{x}, 0, 0.93]\nothers = "rest"\n'
    saved, said = solving.raw_spline(recordings.from_text(text, name="away")), []
    path = formats.export(saved, "csv", tmp_path / "a.csv", columns=("ground",), report=said.append)
    forces = Forces.of(Sampled.of(saved))
    assert 0.1 < forces.has_known_support.mean() < 0.5
    assert any("the support of the figure is unknown" in line for line in said)
    with path.open(newline="") as stream:
        heading, *rows = csv.reader(stream)
    column = np.array(rows, float)[:, heading.index("left_foot.fz [N]")]
    np.testing.assert_array_equal(np.isnan(column), ~forces.has_known_support)


def test_forces_of_a_figure_on_a_seat_are_unknown():
    """The feet would otherwise carry the whole weight, and a moment would be missing."""
    forces = Forces.of(Sampled.of(shipped.unsolved("sit_down")))
    seated, standing = forces.sampled.time > 1.2, forces.sampled.time < 0.5
    assert np.isnan(forces.torques[seated]).all() and not any(foot.has_contact[seated].any() for foot in forces.feet)
    assert np.isfinite(forces.torques[standing]).all() and all(foot.has_contact[standing].all() for foot in forces.feet)
    _, (note, *_) = quantities.table(forces.sampled, ("ground",))
    assert re.search(r"first at 1\.\d\d s, where 'left_thigh', 'right_thigh' touch something", note)


@pytest.mark.slow
def test_contacts_of_the_thighs_make_the_forces_of_a_seat_known(tmp_path):
    """Seat and feet then share the weight, and nothing is missing. The pelvis is above the seat until the end."""
    parts = ("pelvis", "left_shorts_back", "right_shorts_back")
    seats = "".join(f'[[contact]]\npoint = "{part}"\nfrom = 1.15\nto = 1.9\n' for part in parts)
    (tmp_path / "seat.toml").write_text(models.clip_text("sit_down") + seats)
    forces = inbetween(load(tmp_path / "seat.toml")).forces(times=np.linspace(1.3, 1.8, 11))
    assert forces.has_known_support.all()
    carried = {foot.name: foot.force[:, 2] for foot in forces.feet}
    assert (carried["left_thigh"] > 100).all() and (carried["left_foot"] > 0).all()
    assert (carried["pelvis"] == 0).all()
    assert forces.wrench is not None
    total = sum(foot.force for foot in forces.feet) + forces.rest[:, :3]
    np.testing.assert_allclose(total, forces.wrench.force.T, atol=1e-3)
    assert np.abs(forces.rest[:, :3]).max() < 1


def test_a_figure_without_a_root_has_torques_but_no_wrench(tmp_path):
    (tmp_path / "arm.xml").write_text(
        '<mujoco><worldbody><body><joint name="turn"/><geom size=".1" pos=".3 0 0"/>'
        '<body pos=".5 0 0"><joint name="reach" type="slide"/><geom size=".1"/></body></body></worldbody></mujoco>'
    )
    text = f'figure = "{tmp_path}/arm.xml"\n' + "".join(
        f"[[keyframe]]\ntime = {t}\njoints.turn = {90 * t}\njoints.reach = 0\n" for t in (0, 1)
    )
    saved = solving.raw_spline(recordings.from_text(text, name="arm"))
    columns, _ = quantities.table(Sampled.of(saved), ("angles", "velocities", "torques"))
    assert list(columns) == ["turn.r [deg]", "turn.v [rad/s]", "reach.v [m/s]", "turn.t [N m]", "reach.f [N]"]
    np.testing.assert_allclose(columns["turn.r [deg]"][[0, -1]], [0, 90], atol=1e-9)
    assert all(np.isfinite(column).all() for column in columns.values())
    with pytest.raises(UserError, match="no free root"):
        quantities.table(Sampled.of(saved), ("wrench",))
    with pytest.raises(UserError, match="no stance is known"):
        quantities.table(Sampled.of(saved), ("ground",))
    every, notes = quantities.table(Sampled.of(saved), quantities.groups_of("all"))
    assert list(every) == list(columns)
    assert [note.partition(":")[0] for note in notes[:2]] == ["no columns `wrench`", "no columns `ground`"]


ARM = read_data("arm_of_three.xml")


def test_torques_include_every_passive_force_of_the_users_own_file_and_large_ones_of_limits_are_reported(tmp_path):
    path, lines = tmp_path / "arm.xml", []
    path.write_text(ARM)
    saved = motion_of(path, 3)
    expected = inverse_dynamics(mujoco.MjModel.from_xml_path(str(path)), motions.samples(saved))
    columns, _ = quantities.table(Sampled.of(saved), ("torques",))
    torques = np.array([columns["shoulder.t [N m]"], columns["elbow.t [N m]"]]).T
    np.testing.assert_allclose(torques, expected, rtol=0, atol=1e-9 * np.abs(expected).max())
    beyond = motions.through(str(path), 0.3 * np.arange(3), np.radians([[0, 0], [60, 10], [0, 0]]))
    formats.export(beyond, "csv", tmp_path / "a.csv", columns=("torques",), report=lines.append)
    assert any("forces of joint limits" in line and "N m at shoulder" in line for line in lines)


@pytest.mark.parametrize(("kind", "unit"), [("slide", "N"), ("hinge", "N m")])
def test_forces_of_limits_are_in_newtons_for_slides_and_named_by_number_for_joints_without_names(tmp_path, kind, unit):
    """Only a joint that is beyond its range has them, and only if they are more than a part of the torques."""
    joint = '<joint type="{}" axis="1 0 0" range="-.1 .1"/><geom size=".1" mass="{}"/>'
    text = f'<body>{joint.format("hinge", 1e9)}</body><body pos="0 3 0">{joint.format(kind, 4)}</body>'
    compiler = '<compiler angle="radian" autolimits="true"/>'
    (tmp_path / "a.xml").write_text(f"<mujoco>{compiler}<worldbody>{text}</worldbody></mujoco>")
    for heavy, far, count in ((0, 0.3, 1), (0, 0.05, 0), (0.05, 0.3, 0)):
        saved = motions.through(str(tmp_path / "a.xml"), 0.3 * np.arange(3), np.array([[0, 0], [heavy, far], [0, 0]]))
        _, notes = quantities.table(Sampled.of(saved), ("torques",))
        assert sum(f" {unit} at joint1," in note for note in notes) == count, notes


def test_groups_are_named_with_commas():
    assert quantities.groups_of(" torques, ground,torques") == ("torques", "ground")
    assert quantities.groups_of("torques,all") == (quantities.ALL,) and quantities.groups_of("") == ()
    with pytest.raises(UserError, match="no column group 'forces'"):
        quantities.groups_of("velocities,forces")


LINKAGE = read_data("linkage.xml")


def test_a_motor_supplies_the_torques_of_a_linkage_that_it_moves():
    """Of a parallelogram, by the principle of virtual work: its rod translates, and the rocker turns as the crank."""
    model = mujoco.MjModel.from_xml_string(LINKAGE)
    angles = np.linspace(-0.8, 0.8, 7)
    qpos = np.column_stack([angles, -angles, angles])
    needed = np.random.default_rng(3).normal(size=(7, 3))
    torques = motor_torques(model, qpos, needed)
    np.testing.assert_allclose(torques[:, 0], needed @ [1, -1, 1], atol=1e-5)
    np.testing.assert_allclose(torques[:, 1:], 0, atol=1e-5)
    model.actuator_trntype[:] = int(mujoco.mjtTrn.mjTRN_TENDON)
    np.testing.assert_array_equal(motor_torques(model, qpos, needed), needed)
