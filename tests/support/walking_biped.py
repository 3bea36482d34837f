"""A biped of hinges that walks on the spot of the floor it stands on, with feet that rest while they stand."""

from __future__ import annotations

import mujoco
import numpy as np
from oracles import kinematics
from scipy.spatial.transform import Rotation

BIPED = """
<mujoco model="biped"><compiler angle="radian"/><worldbody>
  <body name="pelvis" pos="0 0 .8"><freejoint name="root"/><geom type="box" size=".08 .12 .08" mass="8"/>
    <body name="waist" pos="0 0 .1"><joint name="waist_yaw" axis="0 0 1" range="-1 1"/>
      <geom type="box" size=".08 .15 .15" pos="0 0 .2" mass="8"/></body>
    {left}{right}
  </body>
</worldbody></mujoco>
"""
LEG = """
<body name="{side}_thigh" pos="0 {y} -.05"><joint name="{side}_hip" axis="0 1 0" range="-1.5 1"/>
  <geom type="capsule" fromto="0 0 0 0 0 -.33" size=".05" mass="3"/>
  <body name="{side}_shin" pos="0 0 -.35"><joint name="{side}_knee" axis="0 1 0" range="0 2.2"/>
    <geom type="capsule" fromto="0 0 0 0 0 -.32" size=".04" mass="2"/>
    <body name="{side}_foot" pos="0 0 -.36"><joint name="{side}_ankle" axis="0 1 0" range="-.9 .8"/>
      <geom type="box" size=".1 .04 .02" pos=".04 0 -.02" mass="1"/></body></body></body>
"""
TEXT = BIPED.format(left=LEG.format(side="left", y=0.1), right=LEG.format(side="right", y=-0.1))
JOINTS = [f"{side}_{part}" for side in ("left", "right") for part in ("hip", "knee", "ankle")]
FPS = 50.0
SPEED = 0.6  # [m/s]


def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(TEXT)


def walk(count: int = 100, heading: float = 0.6) -> np.ndarray:
    """qpos (T, 14): steps of half a second in the direction of a heading [rad]; a foot rests while it stands."""
    time = np.arange(count) / FPS
    out = np.zeros((count, 14))
    along = SPEED * time
    out[:, 0], out[:, 1], out[:, 2] = along * np.cos(heading), along * np.sin(heading), 0.74
    out[:, 3], out[:, 6] = np.cos(heading / 2), np.sin(heading / 2)
    out[:, 7] = 0.3 * np.sin(2 * np.pi * time)
    for leg, start in enumerate((8, 11)):
        phase = (time + 0.5 * leg) % 1.0
        stands = phase < 0.5
        swing = (phase - 0.5) / 0.5
        x = np.where(stands, SPEED * (0.25 - phase), SPEED * (-0.25 + 0.5 * swing))
        lift = np.where(stands, 0.0, 0.05 * np.sin(np.pi * np.clip(swing, 0, 1)))
        out[:, start : start + 3] = _leg(x, 0.04 - (0.74 - 0.05) + lift)
    return out


def _leg(x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """(T, 3) hip, knee and ankle, so that the ankle is at (x, z) [m] from the hip and the foot is level."""
    reach = np.hypot(x, z)
    knee = np.pi - np.arccos((0.35**2 + 0.36**2 - reach**2) / (2 * 0.35 * 0.36))
    toward = np.arctan2(-x, -z)
    hip = toward - np.arcsin(0.36 * np.sin(knee) / reach)
    return np.stack([hip, knee, -(hip + knee)], axis=1)


def assert_same(found: np.ndarray, qpos: np.ndarray, tolerance: float = 1e-9) -> None:
    """That configurations are equal up to the sign of the root's quaternion."""
    sign = np.sign(np.sum(found[:, 3:7] * qpos[:, 3:7], axis=1, keepdims=True))
    np.testing.assert_allclose(np.hstack([found[:, :3], sign * found[:, 3:7], found[:, 7:]]), qpos, atol=tolerance)


def y_up(qpos: np.ndarray, *, with_frame: bool) -> np.ndarray:
    """As programs with y up have it, the root's own axes turned with the world or not, by SciPy."""
    turn = Rotation.from_euler("x", -90, degrees=True)
    rotation = turn * Rotation.from_quat(qpos[:, 3:7], scalar_first=True)
    rotation = rotation * turn.inv() if with_frame else rotation
    return np.hstack([turn.apply(qpos[:, :3]), rotation.as_quat(scalar_first=True), qpos[:, 7:]])


def poses(qpos: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """MuJoCo's xpos (T, 9, 3) and xquat (T, 9, 4), the world first."""
    figure = model()
    seen = [kinematics(figure, row) for row in qpos]
    return np.array([data.xpos for data in seen]), np.array([data.xquat for data in seen])
