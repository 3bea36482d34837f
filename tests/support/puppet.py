"""A lopsided figure of every joint and every kind of geom, and a motion of it that turns about no axis of the world."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.motion import Saved
from dynsplines.scene.compose import compose
from dynsplines.solver import quaternion as quat
from dynsplines.system.progress import Progress

FIGURE = """
<mujoco model="puppet">
  <compiler angle="degree"/>
  <asset>
    <mesh name="wedge" vertex="0 0 0  .3 0 0  0 .2 0  0 0 .4" inertia="convex"/>
    <hfield name="hills" nrow="3" ncol="4" size="1 .8 .3 .1" elevation="0 1 2 3 1 4 2 0 3 1 0 2"/>
    <material name="glass" rgba=".2 .4 .9 .5" shininess=".9"/>
    <material name="red" rgba=".8 .1 .1 1"/>
  </asset>
  <worldbody>
    <geom name="hills" type="hfield" hfield="hills" pos="2 1 0"/>
    <geom name="pillar" type="cylinder" size=".1 .5" pos="-1 .3 .5" euler="20 0 10" material="red"/>
    <body name="hips" pos=".1 -.2 .9" euler="10 20 30"><freejoint name="root"/>
      <geom name="trunk" type="capsule" size=".1" fromto="0 0 0 .05 0 .4" mass="8"/>
      <geom name="bag" type="mesh" mesh="wedge" pos=".1 0 .2" euler="0 40 0" material="red" mass="1"/>
      <geom name="ghost" size=".3" group="3" mass="0"/>
      <body name="left_upper_arm" pos="0.02 .2 .4" quat=".9 .1 -.2 .3"><joint name="shoulder" type="ball"/>
        <geom name="sleeve" type="box" size=".05 .06 .2" pos="0 .03 -.2" euler="10 20 30" mass="1"/>
        <body name="left_forearm" pos="0 .01 -.4" euler="0 30 0">
          <joint name="elbow" type="hinge" axis="0 1 .2"/>
          <geom name="wrist" type="ellipsoid" size=".04 .05 .15" pos="0 0 -.15" material="glass" mass="1"/>
          <site name="left_hand" pos=".02 0 -.3"/></body></body>
      <body name="right_thigh" pos="0 -.1 -.1"><joint name="hip" type="ball" pos=".01 .02 .03"/>
        <geom name="thigh" type="cylinder" size=".06 .2" pos="0 0 -.25" mass="3"/>
        <body pos="0 0 -.5"><joint name="piston" type="slide" axis="0 .3 -1"/>
          <joint name="twist" type="hinge" axis="0 0 1" pos=".02 0 .01"/>
          <geom name="boot" type="sphere" size=".07" mass="1"/>
          <site name="right_toe" pos=".1 0 -.05"/></body></body>
    </body>
    <body name="swing" pos="1 0 1"><joint name="swing" axis="0 1 0"/>
      <geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3" mass="1"/></body>
  </worldbody>
</mujoco>
"""


def moved(fps: float = 24.0, text: str = FIGURE, name: str = "puppet", count: int = 12) -> Saved:
    """Its motion through random configurations, the same at every call; the root turns by more than half a turn."""
    rng = np.random.default_rng(3)
    model = mujoco.MjModel.from_xml_string(text)
    qpos = np.tile(model.qpos0, (count, 1))
    for i in range(model.njnt):
        at, free = int(model.jnt_qposadr[i]), int(model.jnt_type[i]) == int(mujoco.mjtJoint.mjJNT_FREE)
        if free or int(model.jnt_type[i]) == int(mujoco.mjtJoint.mjJNT_BALL):
            turn = np.cumsum(rng.normal([0.25, -0.2, 0.35], 0.2, (count, 3)), axis=0)
            columns = slice(at + 3 * free, at + 3 * free + 4)
            qpos[:, columns] = quat.product(qpos[:, columns], quat.from_rotation_vector(turn))
            if free:
                qpos[:, at : at + 3] += np.cumsum(rng.normal(0.05, 0.1, (count, 3)), axis=0)
        else:
            qpos[:, at] += np.cumsum(rng.normal(0.05, 0.1, count))
    assert np.all(np.ptp(qpos, axis=0) > 0.01)
    spec = mujoco.MjSpec.from_string(text)
    found = clip.from_qpos(name, compose(spec), np.arange(count) / 12.0, qpos, fps, name)
    return solving.unsolved(found).saved(Progress(), with_report=False)
