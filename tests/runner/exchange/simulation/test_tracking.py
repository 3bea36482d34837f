"""Exported scenes by themselves: mj_step plays them, and what an export reports of one that leaves its motion."""

import motions
import numpy as np
import pytest
import shipped
from motions import between, clip_file, played
from motions import exported_scene as exported
from processes import quiet

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.exchange.format.simulate import note, tracked
from dynsplines.exchange.simulation import Simulation
from dynsplines.exchange.trajectory import SampledTrajectory

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
BOX = """<mujoco><worldbody><geom type="plane" size="0 0 1" name="floor"/>
  <body name="base" pos="0 0 {z}"><freejoint name="root"/><geom type="box" size=".2 .2 .1" mass="4"/>
    <body name="lever" pos="0 0 .1"><joint name="lever" axis="0 1 0" damping="1"/>
      <geom type="capsule" size=".02" fromto="0 0 .1 0 0 .4" mass=".2"/></body></body></worldbody></mujoco>"""
SLIDER = """<mujoco><worldbody><geom type="plane" size="0 0 1"/>
  <body name="base" pos="0 0 .1"><joint name="rootx" type="slide" axis="1 0 0"/>
    <joint name="rootz" type="slide" axis="0 0 1"/><joint name="rooty" axis="0 1 0"/>
    <geom type="box" size=".2 .2 .1" mass="4"/><body pos="0 0 .15"><joint name="lever" axis="0 1 0"/>
      <geom type="capsule" size=".02" fromto="0 0 0 0 0 .3"/></body></body></worldbody></mujoco>"""
LIMB = """<mujoco><worldbody><body name="thigh" pos="0 0 1"><joint name="hip" axis="0 1 0" {joint}/>
  <geom type="capsule" size=".05" fromto="0 0 0 0 0 -.3" mass="1"/>
  <body name="knee" pos="0 0 -.3"><joint name="knee" axis="0 1 0"/><geom size=".02" mass=".1"/>
    <body name="shank"><joint name="twist" axis="0 0 1"/>
      <geom type="capsule" size=".05" fromto="0 0 {top} 0 0 -.3" mass="1"/></body></body></body></worldbody></mujoco>"""

HAND = """<mujoco><option gravity="0 0 0"/><worldbody><body pos="0 0 1"><joint name="arm" axis="0 1 0" {arm}/>
  <geom type="capsule" size=".03" fromto="0 0 0 .3 0 0" mass="1"/>
  <body pos=".3 0 0"><joint name="hand" {hand}/><geom size=".02" mass=".05"/></body></body></worldbody></mujoco>"""
ARMS = """<mujoco><worldbody><body name="trunk"><joint name="turn" axis="0 0 1"/><geom size=".05"/>
  <body name="left" pos="0 .2 1"><joint name="left" axis="1 0 0"/>
    <geom type="capsule" size=".05" fromto="0 0 0 0 0 -.4" mass="1"/></body>
  <body name="right" pos="0 -.2 1"><joint name="right" axis="1 0 0"/>
    <geom type="capsule" size=".05" fromto="0 0 0 0 0 -.4" mass="1"/></body></body></worldbody></mujoco>"""


def simulated(tmp_path, text, qpos, step=0.5):
    """The scene of the motion through poses some time apart [s], how it follows it, and the line on that."""
    (tmp_path / "model.xml").write_text(text)
    take = SampledTrajectory.of(
        motions.through(str(tmp_path / "model.xml"), step * np.arange(len(qpos)), np.array(qpos, float))
    )
    simulation = Simulation.of(take)
    tracking = tracked(simulation, take)
    return simulation, tracking, note(tracking, simulation.model)


def posed(z, lever):
    return [0, 0, z, 1, 0, 0, 0, lever]


def test_a_scene_that_follows_is_reported_with_its_largest_error(tmp_path):
    _, tracking, line = simulated(tmp_path, BOX.format(z=0.1), [posed(0.1, 0), posed(0.1, 0.3), posed(0.1, 0)])
    assert tracking.is_within and tracking.time[-1] == pytest.approx(1, abs=0.003)
    assert line.startswith("mj_step of the scene stays within 0.0") and line.endswith("of the motion for 1 s")


def test_a_figure_that_begins_in_the_air_falls_as_far_as_the_note_reports(tmp_path):
    _, tracking, line = simulated(tmp_path, BOX.format(z=0.1), [posed(0.6, 0), posed(0.6, 0.3), posed(0.6, 0)])
    fallen = 9.81 * tracking.time**2 / 2
    free = fallen < 0.4
    np.testing.assert_allclose(tracking.deviation[free, 2], fallen[free], atol=0.01)
    assert "leaves the motion: 'root' by 5 cm after 0.10 s" in line


def test_joints_of_a_root_have_actuators_and_that_is_noted(tmp_path):
    qpos = [[0, 0, 0, 0], [0.1, 0.05, 0.1, 0.3], [0, 0, 0, 0]]
    simulation, tracking, _ = simulated(tmp_path, SLIDER, qpos)
    assert tracking.is_within
    assert any("which carry it: rootx, rootz, rooty" in line for line in simulation.notes)


@pytest.mark.parametrize("top", [0.0, 0.02])
def test_limbs_that_the_model_has_in_each_other_do_not_collide(top, tmp_path):
    """The thigh and what is beyond the knee are in each other at rest."""
    qpos = [[0, 0, 0], [0.2, 0.4, 0.1], [0, 0, 0]]
    simulation, tracking, _ = simulated(tmp_path, LIMB.format(top=top, joint=""), qpos)
    assert tracking.is_within
    assert any("do not collide in the scene to simulate: thigh-shank" in line for line in simulation.notes)
    assert simulation.model.nexclude == 1


def test_siblings_that_only_the_motion_puts_in_each_other_still_collide(tmp_path):
    simulation, tracking, _ = simulated(tmp_path, ARMS, [[0, 0, 0], [0, -0.6, 0.6], [0, 0, 0]])
    assert simulation.model.nexclude == 0 and not tracking.is_within


def test_the_base_of_an_arm_collides_as_the_model_has_it(tmp_path):
    """The base is around the first link, which its geoms are not to meet; a table that nothing hangs on is solid."""
    text = """<mujoco><worldbody><body name="base" pos="0 0 1"><geom size=".2" contype="2" conaffinity="4"/>
      <body name="link" pos="0 0 .1"><joint name="turn" axis="0 1 0"/><geom size=".05" mass="1" pos="0 0 .02"/>
        <body name="tip" pos="0 0 .05"><joint name="bend" axis="0 1 0"/><geom size=".05" mass="1" pos="0 0 .02"/></body>
      </body></body><body name="table" pos="1 0 1"><geom name="table" size=".1"/></body></worldbody>
      <contact><exclude body1="base" body2="tip"/></contact></mujoco>"""
    simulation, tracking, _ = simulated(tmp_path, text, [[0, 0], [0.2, 0.4], [0, 0]])
    assert tracking.is_within
    assert simulation.model.nexclude >= 1
    assert (simulation.model.geom_contype[simulation.model.geom("table").id] & 1) == 1


def test_a_light_ball_joint_with_a_strong_spring_has_targets_within_half_a_turn(tmp_path):
    """MuJoCo wraps the error of a position actuator on a ball joint at half a turn, in newer versions."""
    text = HAND.format(arm="", hand='type="ball" stiffness="2"')
    qpos = [[0, 1, 0, 0, 0], [0.3, 0.9, 0.3, -0.3, 0.1], [0, 1, 0, 0, 0]]
    simulation, tracking, _ = simulated(tmp_path, text, qpos, 0.25)
    assert np.abs(simulation.control).max() < np.pi
    assert tracking.is_within


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
