"""Figures and keyframes that many tests share, small enough to read."""

from __future__ import annotations

# isort: off
import one_thread  # noqa: F401 - before NumPy
# isort: on

import io
import os
from pathlib import Path

import drawing
import mujoco
import numpy as np
import pytest
import shipped
import tiny
from rich.console import Console

from dynsplines import motion, work
from dynsplines.clip import load as clip
from dynsplines.motion import Saved
from dynsplines.picture.graphics import Graphics
from dynsplines.solver.figure.figure import Figure
from dynsplines.system.progress import Teller
from dynsplines.work import Solved

os.environ["DYNSPLINES_CACHE"] = "off"  # a test solves what it asks for, and leaves nothing in a user's folder
shipped.open_folder()


def pytest_unconfigure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):
        shipped.remove_folder()


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


@pytest.fixture(params=FIGURES)
def figure(request: pytest.FixtureRequest) -> Figure:
    text, coordinates = FIGURES[request.param]
    return Figure(mujoco.MjModel.from_xml_string(text), coordinates)


@pytest.fixture(scope="session")
def graphics() -> Graphics:
    """What this machine draws with."""
    return drawing.GRAPHICS


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(7)


@pytest.fixture(scope="session")
def solved(tmp_path_factory: pytest.TempPathFactory) -> Solved:
    """The tiny clip, solved."""
    path = tiny.written(tmp_path_factory.mktemp("tiny"))
    return work.solve(clip.load(str(path)), Teller(Console(file=io.StringIO())))


@pytest.fixture(scope="session")
def saved(solved: Solved) -> Saved:
    """What goes into a motion file of it, report and all."""
    return solved.saved(Teller(Console(file=io.StringIO())))


@pytest.fixture(scope="session")
def motion_file(saved: Saved, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Its motion file; to be read only."""
    path = tmp_path_factory.mktemp("motion") / "tiny.npz"
    motion.save(saved, path)
    return path
