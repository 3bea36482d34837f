"""A recording on robots whose root is listed behind objects: the same motion, by MuJoCo."""

import mujoco
import numpy as np
import pytest
from figures import CART, biped, joints, scene
from figures import OBJECT_BALL as BALL
from oracles import kinematics
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines import inbetween, load
from dynsplines.errors import UserError
from dynsplines.exchange.robot import configurations
from dynsplines.exchange.skeleton import bvh_file, retarget
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton
from dynsplines.solver.array import Array

CLIP = read_data("two_roots.toml")


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> CapturedSkeleton:
    """A person that goes aside and turns to its left, as BVH."""
    folder = tmp_path_factory.mktemp("recording")
    (folder / "c.toml").write_text(CLIP, encoding="utf-8")
    inbetween(load(folder / "c.toml")).export(folder / "walk.bvh")
    return CapturedSkeleton.of(bvh_file.read(folder / "walk.bvh"))


def bodies(xml: str, recording: CapturedSkeleton) -> tuple[Array, Array]:
    """(T, 7, 3) [m] and (T, 7, 9) of the biped's bodies on a recording."""
    model = mujoco.MjModel.from_xml_string(xml)
    qpos, _ = retarget.onto(recording, model, "walk.bvh")
    names = ["pelvis", *(f"{side}_{part}" for side in ("left", "right") for part in ("thigh", "shin", "foot"))]
    seen = [[data.body(name) for name in names] for data in (kinematics(model, row) for row in qpos)]
    places, turns = ([[getattr(body, part) for body in bodies] for bodies in seen] for part in ("xpos", "xmat"))
    return np.array(places), np.array(turns)


def test_the_motion_is_that_of_a_robot_alone(recording: CapturedSkeleton) -> None:
    places, turns = bodies(scene(biped()), recording)
    assert np.linalg.norm(places[-1, 0] - places[0, 0]) > 0.3
    seen = bodies(scene(CART, biped(), BALL), recording)
    assert seen[0] == pytest.approx(places, abs=1e-4)
    assert seen[1] == pytest.approx(turns, abs=1e-3)


@pytest.mark.parametrize("names", [("tx", "tz", "ry"), ("rx", "ry", "rz")])
def test_a_figure_without_a_free_joint_is_refused(recording: CapturedSkeleton, names: tuple[str, ...]) -> None:
    model = mujoco.MjModel.from_xml_string(scene(biped(joints(names))))
    with pytest.raises(UserError, match="the figure's root, 'pelvis', needs a free joint; in URDF"):
        retarget.onto(recording, model, "walk.bvh")


T = 50
FIGURE = scene(CART, biped(), BALL)


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


def test_a_recording_moves_the_robot_alone() -> None:
    plain, model = scene(biped()), mujoco.MjModel.from_xml_string(FIGURE)
    expected = poses(plain, configurations(mujoco.MjModel.from_xml_string(plain), "gmr", "f", *recorded()))
    qpos = configurations(model, "gmr", "f", *recorded())
    for one, other in zip(poses(FIGURE, qpos), expected, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-6)
    at = model.joint("cart_free").qposadr[0]
    np.testing.assert_array_equal(qpos[:, at : at + 7], np.tile(model.qpos0[at : at + 7], (T, 1)))
