"""Recordings of robots on figures with objects beside them, and on roots of slides and hinges, by MuJoCo."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines.errors import UserError
from dynsplines.exchange.robot import configurations
from dynsplines.solver.array import Array
from tests.support.biped import BALL, BOX, CART, biped, joints, nested, scene

T = 50
FIGURES = {
    "cart first, ball last": scene(CART, biped(), BALL),
    "hinges first": scene(BOX, biped(joints(("rx", "ry", "rz", "ty", "tx", "tz")))),
    "nested": scene(nested(("tx", "ty", "tz", "rz", "rx", "ry"))),
    "ball": scene(biped(joints(("tx", "ty", "tz")) + '<joint name="turn" type="ball"/>')),
}


def recorded() -> tuple[Array, Array, Array]:
    """Places (T, 3), quaternions (T, 4) and six hinges (T, 6) of a robot that turns once round and leans."""
    t = np.linspace(0, 1, T)
    position = np.stack([t, 0.3 * np.sin(t), 0.8 - 0.1 * t], axis=1)
    angles = np.stack([2 * np.pi * t, 0.2 * np.sin(5 * t), 0.3 * t], axis=1)
    rotation = Rotation.from_euler("ZYX", angles).as_quat(scalar_first=True)
    return position, rotation, 0.3 * np.sin(t[:, None] + np.arange(6))


def poses(xml: str, qpos: Array) -> tuple[Array, Array]:
    """(T, 3, 3) [m] and (T, 3, 9) of pelvis and feet."""
    model = mujoco.MjModel.from_xml_string(xml)
    bodies = [model.body(name).id for name in ("pelvis", "left_foot", "right_foot")]
    seen = [kinematics(model, row) for row in qpos]
    return np.array([data.xpos[bodies] for data in seen]), np.array([data.xmat[bodies] for data in seen])


@pytest.mark.parametrize("kind", FIGURES)
def test_a_recording_moves_the_robot_alone(kind: str) -> None:
    plain, model = scene(biped()), mujoco.MjModel.from_xml_string(FIGURES[kind])
    expected = poses(plain, configurations(mujoco.MjModel.from_xml_string(plain), "gmr", "f", *recorded()))
    qpos = configurations(model, "gmr", "f", *recorded())
    for one, other in zip(poses(FIGURES[kind], qpos), expected, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-6)
    for name in ("box_free", "cart_free"):
        if f'"{name}"' in FIGURES[kind]:
            at = model.joint(name).qposadr[0]
            np.testing.assert_array_equal(qpos[:, at : at + 7], np.tile(model.qpos0[at : at + 7], (T, 1)))
    if kind == "nested":
        assert qpos[-1, model.joint("rz").qposadr[0]] == pytest.approx(2 * np.pi, abs=0.3)  # a whole turn


def test_a_planar_root_refuses_what_it_cannot_follow() -> None:
    model = mujoco.MjModel.from_xml_string(scene(biped(joints(("tx", "tz", "ry")))))
    with pytest.raises(UserError, match=r"f: the figure's root moves on 'tx', 'tz', 'ry' alone; .* degrees beyond"):
        configurations(model, "gmr", "f", *recorded())
    position, _, hinges = recorded()
    pitch = Rotation.from_euler("Y", np.linspace(0, 1, T)[:, None]).as_quat(scalar_first=True)
    qpos = configurations(model, "gmr", "f", position * [1, 0, 1], pitch, hinges)
    assert qpos[:, 2] == pytest.approx(np.linspace(0, 1, T), abs=1e-6)
