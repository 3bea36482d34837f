"""Motions without any symmetry, for tests of formats: a root that travels and turns about all axes, joints anywhere."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from dynsplines import motion, solving
from dynsplines.clip import load as clip
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import read_recording
from dynsplines.motion import Sampled, Saved
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solver import quaternion as quat
from dynsplines.system.progress import Progress

FPS = 50.0
ROBOT = """
<mujoco model="robot">
  <compiler angle="radian"/>
  <worldbody>
    <body name="base" pos="0 0 .8"><freejoint name="floating"/>
      <geom type="box" size=".1 .15 .1" pos=".02 0 0" mass="5"/>
      <body name="left_leg" pos="0 .1 -.1" quat=".9 .1 -.2 .3">
        <joint name="left_hip_pitch" type="hinge" axis="0 1 0"/>
        <joint name="left_hip_roll" type="hinge" axis="1 0 0"/>
        <joint name="left_hip_yaw" type="hinge" axis="0 0 1"/>
        <geom type="capsule" size=".04" fromto="0 0 0 .03 0 -.3" mass="1"/>
        <body name="left_shin" pos=".03 0 -.3"><joint name="left_knee" type="hinge" axis="0 1 .1"/>
          <geom type="capsule" size=".03" fromto="0 0 0 0 .02 -.3" mass=".5"/>
          <site name="left_toe" pos=".1 0 -.3"/></body>
      </body>
      <body name="arm" pos="0 -.2 .2"><joint name="arm_pitch" type="hinge" axis="0 1 0"/>
        <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3" mass=".5"/></body>
    </body>
  </worldbody>
</mujoco>
"""


def motion_of(figure: str, *, seed: int = 3, spread: float = 0.9, start: float = 0.25) -> Saved:
    """The spline through five random keyframes, 0.3 s apart, of a figure as a clip file names it; spread [rad]."""
    model = figure_spec(figure).compile()
    rng = np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (5, 1))
    qpos[:, :3] += np.cumsum(rng.uniform(-0.2, 0.5, (5, 3)), axis=0)
    qpos[:, 3:7] = quat.from_rotation_vector(rng.uniform(-1.2, 1.2, (5, 3)))
    for joint in range(1, model.njnt):
        at = model.jnt_qposadr[joint]
        turn = spread * rng.uniform(-1, 1, (5, 3))
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_BALL:
            qpos[:, at : at + 4] = quat.from_rotation_vector(turn)
        else:
            qpos[:, at] = turn[:, 0]
    return through(figure, start + 0.3 * np.arange(5), qpos)


def through(figure: str, time: np.ndarray, qpos: np.ndarray) -> Saved:
    """The spline through keyframes."""
    found = clip.from_qpos("wild", compose(figure_spec(figure)), time, qpos, FPS, "wild")
    return solving.unsolved(found).saved(Progress(), with_report=False)


def samples(saved: Saved, fps: float | None = None) -> Sampled:
    return motion.sampled(saved.figure, saved.timeline, fps or saved.fps)


def poses(model: mujoco.MjModel, qpos: np.ndarray, qvel: np.ndarray | None = None) -> dict[str, np.ndarray]:
    """MuJoCo's own positions, rotations (matrices) and velocities (spin, then the origin's; world) of every body."""
    data = mujoco.MjData(model)
    out = {"xpos": [], "xmat": [], "velocity": []}
    for i, row in enumerate(qpos):
        data.qpos = row
        data.qvel = 0 if qvel is None else qvel[i]
        mujoco.mj_forward(model, data)
        both = np.zeros((model.nbody, 6))
        for body in range(model.nbody):
            mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY, body, both[body], 0)
        for name, value in (("xpos", data.xpos), ("xmat", data.xmat), ("velocity", both)):
            out[name].append(np.array(value))
    return {name: np.array(rows) for name, rows in out.items()}


def same_poses(model: mujoco.MjModel, first: np.ndarray, second: np.ndarray, tolerance: float = 1e-9) -> None:
    """Bodies stand in the same places, whatever the signs of quaternions."""
    a, b = poses(model, first), poses(model, second)
    assert a["xpos"].shape == b["xpos"].shape
    np.testing.assert_allclose(a["xpos"], b["xpos"], atol=tolerance)
    np.testing.assert_allclose(a["xmat"], b["xmat"], atol=tolerance)


def exported(saved: Saved, kind: str, folder: Path, **more: Any) -> tuple[Path, list[str]]:
    """The file of a motion in a format, and the lines that are reported."""
    notes: list[str] = []
    target = formats.export(saved, kind, folder / f"out{formats.writer(kind).ending}", report=notes.append, **more)
    return target, notes


def came_back(saved: Saved, target: Path, figure: str | None = "human", tolerance: float = 1e-9, **more: Any) -> None:
    """A file read again brings every body to where it was, at the same times from 0 on."""
    back, before = read_recording(target, figure=figure, **more), samples(saved)
    assert abs(back.fps - saved.fps) < 1e-6
    np.testing.assert_allclose(back.time - back.time[0], before.time - before.time[0], atol=1e-9)
    same_poses(saved.figure.model, before.qpos, back.qpos, tolerance)
