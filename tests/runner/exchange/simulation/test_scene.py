"""Exported scenes stand by themselves: mj_step plays them, with the motion as the actuators' targets."""

import numpy as np
import pytest
import shipped
from quiet import quiet
from simulated import between, clip_file, exported, played

from dynsplines import solving
from dynsplines.clip import load as clip

LASTS = 1.0  # [s] of simulation
FALLEN = 0.03  # [m]
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


@pytest.mark.slow
def test_the_human_follows_its_motion_and_falls_through_nothing(tmp_path):
    saved = shipped.solved("walk_loop").saved(quiet(), with_report=False)
    model, _ = exported(saved, tmp_path)
    end = played(model, LASTS)
    assert np.linalg.norm(end.last[:3]) < 0.2
    assert np.degrees(np.linalg.norm(end.last[3:6])) < 16
    assert np.degrees(np.abs(end.last[6:]).max()) < 5
    assert end.deepest < FALLEN
    assert end.data.xpos[1, 2] == pytest.approx(between(model, model.key_qpos, end.data.time)[2], abs=FALLEN)


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
