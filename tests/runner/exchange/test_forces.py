"""Exported forces are MuJoCo's `mj_inverse` of the motion, on models with every passive and constraint force."""

import csv

import mujoco
import numpy as np
import pytest
import wild
from inverse_oracle import oracle
from random_robots import motion_of

from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.trajectory import ExportOptions
from dynsplines.solver import quaternion as quat

ARM = """
<mujoco>
  <compiler angle="degree"/>
  <option {option}/>
  <default><joint {joint}/></default>
  <worldbody>
    <site name="hook" pos=".3 .1 1.2"/>
    <body name="upper" pos="0 0 1" {body}><joint name="shoulder" axis="0 1 0" range="-40 40"/>
      <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.4" mass="1.23456789"/>
      <body name="fore" pos="0 0 -.4" {body}><joint name="elbow" axis=".1 1 0"/>
        <geom type="capsule" size=".025" fromto="0 0 0 0 0 -.3" mass=".7"/><site name="hand" pos="0 0 -.3"/></body>
    </body>
  </worldbody>
  <tendon>
    <spatial name="rope" {tendon}><site site="hook"/><site site="hand"/></spatial>
    <fixed name="gear" {tendon}><joint joint="shoulder" coef=".7"/><joint joint="elbow" coef="-1.1"/></fixed>
  </tendon>
</mujoco>
"""
PASSIVE = {
    "nothing": {},
    "stiffness": {"joint": 'stiffness="40" springref="25"'},
    "damping": {"joint": 'damping="3"'},
    "friction loss": {"joint": 'frictionloss="2"'},
    "armature": {"joint": 'armature=".2"'},
    "gravity compensation": {"body": 'gravcomp=".7"'},
    "gravity compensation by actuators": {"body": 'gravcomp=".7"', "joint": 'actuatorgravcomp="true"'},
    "fluid": {"option": 'density="300" viscosity=".6" wind="1 -2 .5"'},
    "tendon springs": {"tendon": 'stiffness="90" springlength=".2"'},
    "tendon damping": {"tendon": 'damping="5"'},
    "tendon friction": {"tendon": 'frictionloss="3"'},
    "another gravity": {"option": 'gravity="1.2345678 -3 -4.5"'},
    "discrete inverse dynamics": {"joint": 'damping="3"', "option": "><flag invdiscrete='enable'/></option><option"},
}
WITHOUT_EFFECT = {"nothing", "gravity compensation by actuators"}  # on qfrc_inverse
ROBOT = """
<mujoco>
  <option density="200" wind=".5 0 1"/>
  <worldbody>
    <body name="base" pos="0 0 1"><joint name="root" type="free" damping="4" armature=".3"/>
      <geom type="box" size=".1 .2 .05" pos=".03 0 .02" mass="4"/>
      <body name="arm" gravcomp="1" pos="0 .2 0"><joint name="arm" axis="1 0 0" stiffness="12" damping="2"/>
        <geom type="capsule" size=".03" fromto="0 0 0 0 .3 0" mass="1"/></body></body>
  </worldbody>
</mujoco>
"""


def table(saved, path, columns):
    """The columns of an exported file by heading."""
    formats.export(saved, "csv", path, options=ExportOptions(columns=columns))
    with path.open(newline="") as stream:
        heading, *rows = csv.reader(stream)
    return dict(zip(heading, np.array(rows, float).T, strict=True))


def assert_equal(forces, expected):
    np.testing.assert_allclose(forces, expected, rtol=0, atol=1e-9 * np.abs(expected).max())


@pytest.mark.parametrize("name", PASSIVE)
def test_torques_include_every_passive_force_of_the_users_own_file(name, tmp_path):
    path = tmp_path / "arm.xml"
    path.write_text(ARM.format(**{"option": "", "joint": "", "body": "", "tendon": ""} | PASSIVE[name]))
    saved = motion_of(path, 3)
    expected = oracle(mujoco.MjModel.from_xml_path(str(path)), wild.samples(saved))
    columns = table(saved, tmp_path / "a.csv", ("torques",))
    assert_equal(np.array([columns["shoulder.t [N m]"], columns["elbow.t [N m]"]]).T, expected)
    if name not in WITHOUT_EFFECT:
        path.write_text(ARM.format(option="", joint="", body="", tendon=""))
        plain = oracle(mujoco.MjModel.from_xml_path(str(path)), wild.samples(saved))
        assert np.abs(plain - expected).max() > 0.01 * np.abs(plain).max()  # so much does the force matter


def test_the_wrench_is_mj_inverse_at_the_root_about_the_centre_of_mass(tmp_path):
    path = tmp_path / "robot.xml"
    path.write_text(ROBOT)
    saved = motion_of(path, 5)
    at, model = wild.samples(saved), mujoco.MjModel.from_xml_path(str(path))
    columns, data = table(saved, tmp_path / "a.csv", ("wrench",)), mujoco.MjData(model)
    force, moment, centre = (
        np.array([columns[f"{name}{axis} [{unit}]"] for axis in "xyz"]).T
        for name, unit in (("root.f", "N"), ("root.m", "N m"), ("com.", "m"))
    )
    expected = oracle(model, at)
    turned = quat.rotated(at.qpos[:, 3:7], expected[:, 3:6])
    for row, qpos in zip(centre, at.qpos, strict=True):
        data.qpos = qpos
        mujoco.mj_fwdPosition(model, data)
        np.testing.assert_allclose(row, data.subtree_com[1], atol=1e-12)
    assert_equal(force, expected[:, :3])
    assert_equal(moment, turned - np.cross(centre - at.qpos[:, :3], expected[:, :3]))


def test_a_figure_on_slides_has_no_wrench_though_a_box_next_to_it_moves_freely(tmp_path):
    path = tmp_path / "robot.xml"
    slide = '<joint name="x" type="slide" axis="1 0 0"/><joint name="z" type="slide" axis="0 0 1"/>'
    text = ROBOT.replace('<joint name="root" type="free" damping="4" armature=".3"/>', slide)
    path.write_text(text.replace("</worldbody>", '<body name="box"><freejoint/><geom size=".1"/></body></worldbody>'))
    with pytest.raises(UserError, match="the figure has no free root"):
        table(motion_of(path, 5), tmp_path / "a.csv", ("wrench",))


def test_large_forces_of_a_joint_limit_are_reported(tmp_path):
    path, lines = tmp_path / "arm.xml", []
    path.write_text(ARM.format(option="", joint="", body="", tendon=""))
    qpos = np.radians([[0, 0], [60, 10], [0, 0]])
    saved = wild.through(str(path), 0.3 * np.arange(3), qpos)
    formats.export(saved, "csv", tmp_path / "a.csv", options=ExportOptions(columns=("torques",)), report=lines.append)
    assert any("forces of joint limits" in line and "N m at shoulder" in line for line in lines)
