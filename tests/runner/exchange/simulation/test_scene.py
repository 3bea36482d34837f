"""Exported scenes stand by themselves: mj_step plays them, with the motion as the actuators' targets."""

import io

import mujoco
import numpy as np
import pytest
import shipped
from rich.console import Console
from simulated import between, clip_file, exported, played

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.trajectory import ExportOptions
from dynsplines.system.progress import Progress

LASTS = 1.0  # [s] of simulation
FALLEN = 0.03  # [m]
WITHIN = {"sit_down": (0.03, 4.0), "walk_loop": (0.2, 16.0)}  # root off [m], turned off [degrees], after a second
RIG = """
<mujoco>
  <worldbody>
    <geom name="floor" type="plane" size="0 0 1" contype="0" conaffinity="0"/>
    <geom name="sign" type="sphere" size=".05" pos="9 0 3" contype="4" conaffinity="0"/>
    <body name="base" pos="0 0 .5"><freejoint name="root"/>
      <geom name="hull" type="box" size=".2 .2 .05" mass="5" contype="2" conaffinity="2"/>
      <geom name="badge" type="box" size=".3 .3 .01" mass="0" contype="0" conaffinity="0"/>
      <body name="lift" pos="0 0 .05"><joint name="lift" type="slide" axis="0 0 1" range="0 .3"/>
        <geom size=".05" mass="1"/>
        <body name="lid" pos="0 0 .1"><joint type="hinge" axis="0 1 0"/>
          <geom type="box" size=".1 .1 .01" mass=".5"/></body></body>
    </body>
  </worldbody>
  <actuator><motor joint="lift" name="old"/></actuator>
  <sensor><actuatorpos actuator="old"/><jointpos joint="lift"/></sensor>
</mujoco>
"""
KEYS = ('time = 0\nothers = "rest"', 'time = 1\njoints.lift = 0.2\nothers = "rest"')


def quiet():
    return Progress(Console(file=io.StringIO()))


@pytest.fixture(scope="module", params=WITHIN)
def person(request, tmp_path_factory):
    """A shipped clip, solved and exported to be simulated, and without."""
    saved = shipped.solved(request.param).saved(quiet(), with_report=False)
    folder = tmp_path_factory.mktemp("person")
    formats.export(saved, "mjcf", folder / "stands.xml", options=ExportOptions(simulate=True))
    formats.export(saved, "mjcf", folder / "falls.xml")
    return request.param, folder


@pytest.mark.slow
def test_the_human_follows_its_motion_and_falls_through_nothing(person):
    name, folder = person
    model = mujoco.MjModel.from_xml_path(str(folder / "stands.xml"))
    end = played(model, LASTS)
    assert np.linalg.norm(end.last[:3]) < WITHIN[name][0]
    assert np.degrees(np.linalg.norm(end.last[3:6])) < WITHIN[name][1]
    assert np.degrees(np.abs(end.last[6:]).max()) < 5
    assert end.deepest < FALLEN
    assert end.data.xpos[1, 2] == pytest.approx(between(model, model.key_qpos, end.data.time)[2], abs=FALLEN)


@pytest.mark.slow
def test_without_it_the_human_falls_through_the_floor(person):
    _, folder = person
    model = mujoco.MjModel.from_xml_path(str(folder / "falls.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_step(model, data, round(LASTS / model.opt.timestep))
    assert data.qpos[2] < -1
    assert model.nu == 0


@pytest.mark.slow
def test_every_joint_has_actuators_with_gains_that_hold_it(person):
    _, folder = person
    model = mujoco.MjModel.from_xml_path(str(folder / "stands.xml"))
    assert model.nu == model.nv - 6
    named = {model.actuator(i).name: model.actuator_gainprm[i, 0] for i in range(model.nu)}
    assert {"left_ankle_x", "left_ankle_y", "left_ankle_z", "spine_x"} <= named.keys()
    weight = 9.81 * float(model.body_mass.sum())
    assert named["left_ankle_y"] > weight * 0.93 / 2  # both ankles hold the body above them
    ratio = -model.actuator_biasprm[:, 2] / model.actuator_gainprm[:, 0]
    np.testing.assert_allclose(ratio, 0.04, rtol=0.02)


@pytest.fixture(scope="module")
def rig(tmp_path_factory):
    folder = tmp_path_factory.mktemp("rig")
    (folder / "rig.xml").write_text(RIG)
    problem = clip.load(str(clip_file(folder, folder / "rig.xml", *KEYS)))
    saved = solving.unsolved(problem).saved(quiet(), with_report=False)
    return saved, exported(saved, folder)[0]


@pytest.mark.slow
def test_what_a_model_lets_collide_stays_so_and_meets_the_floor(rig):
    _, model = rig
    data = played(model, 0.9).data
    assert data.qpos[2] == pytest.approx(0.05, abs=0.01)  # it has dropped on to the floor and lies there
    assert data.joint("lift").qpos[0] == pytest.approx(0.18, abs=0.01)
    bits = {
        name: (int(model.geom(name).contype[0]), int(model.geom(name).conaffinity[0])) for name in ("hull", "badge")
    }
    assert bits == {"hull": (2, 2), "badge": (0, 0)}


def test_actuators_of_the_model_are_replaced_and_what_has_no_name_gets_one(rig):
    model = rig[1]
    assert [model.actuator(i).name for i in range(model.nu)] == ["lift", "joint2"]
    assert model.nsensor == 1


def test_only_mjcf_can_be_simulated(rig, tmp_path):
    with pytest.raises(UserError, match="the format 'csv' cannot hold a scene to simulate; those that can: mjcf"):
        formats.export(rig[0], "csv", tmp_path / "a.csv", options=ExportOptions(simulate=True))
