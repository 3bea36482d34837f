"""Small figures as MJCF, and figures of them."""

from __future__ import annotations

from copy import copy
from functools import cache

import mujoco
import numpy as np

from dynsplines import models
from dynsplines.solver.figure.figure import Figure

BALL_TREE = """
<mujoco><option gravity="0 0 -9.81"/>
<worldbody><body name="trunk" pos="0 0 1"><freejoint name="root"/>
  <geom type="capsule" size=".1" fromto="0 0 0 .05 0 .4"/>
  <body name="arm" pos="0.02 .2 .4" quat=".9 .1 -.2 .3"><joint name="shoulder" type="ball"/>
    <geom type="box" size=".05 .06 .2" pos="0 .03 -.2" euler="10 20 30"/>
    <body name="forearm" pos="0 .01 -.4"><joint name="elbow" type="ball"/>
      <geom type="capsule" size=".04" fromto="0 0 0 .02 0 -.3"/></body></body>
  <body name="leg" pos="0 -.1 -.1"><joint name="hip" type="ball" pos=".01 .02 .03"/>
    <geom type="capsule" size=".06" fromto="0 0 0 0 0 -.5"/>
    <body name="pack" pos=".1 0 -.2"><geom type="sphere" size=".07"/></body></body>
</body></worldbody></mujoco>"""

ONE_BALL = '<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>'

EVERY_JOINT = """
<mujoco><compiler autolimits="true"/><option gravity="0 0 -9.81"/>
<worldbody><body name="trunk" pos="0 0 1"><freejoint name="root"/>
  <geom type="capsule" size=".1" fromto="0 0 0 .05 0 .4"/>
  <body name="arm" pos="0 .2 .4" quat=".9 .1 -.2 .3">
    <joint name="yaw" type="hinge" axis="0 0 1" pos=".02 0 .01"/>
    <joint name="pitch" type="hinge" axis="0 1 .2" ref="20"/>
    <geom type="box" size=".05 .06 .2" pos="0 .03 -.2"/>
    <body name="piston" pos="0 0 -.4"><joint name="reach" type="slide" axis="0 .3 -1" ref=".02"/>
      <geom type="capsule" size=".04" fromto="0 0 0 .02 0 -.3"/>
      <body name="wrist" pos="0 0 -.3"><joint name="wrist" type="ball" armature=".02"/>
        <geom type="box" size=".03 .05 .06" pos="0 0 -.06"/></body></body></body>
</body>
<body name="post" pos="1 0 0" quat=".8 .1 .5 0"><joint name="swing" type="ball" pos="0 0 .1"/>
  <geom type="capsule" size=".04" fromto="0 0 0 .02 0 -.3"/>
  <body name="tip" pos="0 0 -.3"><joint name="turn" type="hinge" axis="1 0 0" armature=".01"/>
    <geom type="box" size=".03 .05 .06" pos="0 .02 -.06"/></body></body>
</worldbody></mujoco>"""

MIXED = """
<mujoco><compiler angle="degree" autolimits="true"/><option gravity="0.5 0 -9.81"/>
<worldbody><body name="trunk" pos="0 1 1"><joint name="root" type="free"/>
  <geom type="capsule" size=".1" fromto="0 0 0 .05 0 .4"/>
  <body name="neck" pos="0 0 .4" euler="5 10 0"><joint name="neck" type="ball"/>
    <geom type="capsule" size=".04" fromto="0 0 0 0 0 .1"/>
    <body name="head" pos="0 .01 .1" euler="20 0 0"><joint name="head" type="ball" armature=".01" pos="0 0 .01"/>
      <geom type="ellipsoid" size=".1 .08 .12" pos="0 0 .12"/>
      <body name="jaw" pos=".05 0 0"><joint name="jaw" type="hinge" axis="0 1 0" ref="10"/>
        <geom type="box" size=".05 .04 .01"/></body></body></body>
  <body name="thigh" pos="0 .1 -.1"><joint name="hip" type="hinge" axis="0 1 0"/>
    <geom type="capsule" size=".05" fromto="0 0 0 0 0 -.4"/>
    <body name="shin" pos="0 0 -.4"><joint name="ankle" type="ball"/>
      <geom type="capsule" size=".04" fromto="0 0 0 .1 0 -.3"/></body></body>
</body>
</worldbody></mujoco>"""

FIGURES = {
    "ball tree, world": (BALL_TREE, "world"),
    "ball tree, joint": (BALL_TREE, "joint"),
    "every joint": (EVERY_JOINT, "joint"),
    "every joint, world where it can be": (EVERY_JOINT, "auto"),
    "mixed": (MIXED, "auto"),
}

BALL = '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>'
TINY = """
<mujoco><option gravity="0 0 -9.81"/><worldbody><body pos="0 0 1"><freejoint name="root"/><geom size=".1" mass="3"/>
  <body name="shin" pos="0 0 -.2" quat=".9 .1 -.2 .3"><joint name="knee" type="ball"/>
    <geom type="capsule" size=".04" fromto="0 0 0 .01 0 -.3" mass="1"/></body></body></worldbody></mujoco>"""


LEG = """
<mujoco><worldbody>
  <body name="thigh" pos="0 0 1"><freejoint/><geom type="capsule" size=".1" fromto="0 0 0 0 0 -.4"/>
    <body name="foot" pos="0 0 -.5" quat=".9 .1 .2 .3"><geom type="box" size=".05 .1 .2" pos="0 .1 0"/>
      <site name="heel" pos="0.1 0.2 0.3"/></body>
    <body name="shin" pos="0 0 -.4"><joint type="ball"/><geom type="sphere" size=".2" pos="0 0 .1"/>
      <site name="toe" pos="0 0 -.1"/><geom type="ellipsoid" size=".1 .2 .3"/>
      <geom type="cylinder" size=".1 .3"/></body></body>
</worldbody></mujoco>"""
CHAIN = (
    '<mujoco><worldbody><body><joint type="ball"/><geom size=".1" pos="0 0 .2"/><body pos="0 0 .4"><joint type="{}"/>'
    '<geom size=".1" pos="0 0 .2"/></body></body></worldbody></mujoco>'
)
HUMAN_AND_CHAINS = [
    (models.figure_text("human"), "world"),
    (models.figure_text("human"), "joint"),
    (CHAIN.format("ball"), "world"),
    (CHAIN.format("hinge"), "joint"),
]


def figure_of(text: str, coordinates: str = "auto") -> Figure:
    return Figure(mujoco.MjModel.from_xml_string(text), coordinates)


@cache
def figure_named(name: str) -> Figure:
    """One of FIGURES, built once in a process; not to be changed."""
    return figure_of(*FIGURES[name])


def with_armature(figure: Figure, rng: np.random.Generator) -> Figure:
    """The same figure with rotor inertia on every joint, one value a joint."""
    model = copy(figure.model)
    model.dof_armature[:] = rng.uniform(0.1, 1, model.njnt)[model.dof_jntid]
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return Figure(model, figure.coordinates)


def link_named(figure: Figure, name: str) -> int | None:
    """The index of the link that a joint or a body of this name moves, or None."""
    by_joint = next((i for i, link in enumerate(figure.links) if i and link.name == name), None)
    body = mujoco.mj_name2id(figure.model, mujoco.mjtObj.mjOBJ_BODY, name)
    return int(figure.body_link[body]) if by_joint is None and body > 0 else by_joint
