"""Limbs bent to places: MuJoCo says where ends are, hinges stay in their ranges, parts turn as little as it takes."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from dynsplines.exchange.skeleton.limbs import Limb, bend
from dynsplines.solver import quaternion as quat

# An arm that hangs on a trunk by brackets, as a robot's: three hinges apart from each other, an elbow, a ball
ARM = """
<mujoco><compiler angle="degree"/><worldbody><body name="trunk"><freejoint/><geom size=".1"/>
 <body name="pitch" pos="0 .1 .2" euler="10 0 0"><joint name="pitch" axis="0 1 0"/><geom size=".02"/>
  <body name="roll" pos=".01 .05 -.01"><joint name="roll" axis="1 0 0" range="-80 80" limited="true"/><geom size=".02"/>
   <body name="yaw" pos="0 .01 -.1"><joint name="yaw" axis="0 0 1" ref="15"/><geom size=".02"/>
    <body name="elbow" pos=".02 0 -.1"><joint name="elbow" axis="0 1 0" range="-120 5" limited="true" pos="0 0 .01"/>
     <geom size=".02"/>
     <body name="wrist" pos=".2 0 -.01"><joint name="wrist" type="ball"/><geom size=".02"/></body>
 </body></body></body></body></body></worldbody></mujoco>"""
CHAIN = ("pitch", "roll", "yaw", "elbow", "wrist")


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(ARM)


def poses(model: mujoco.MjModel, count: int, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (count, 1))
    qpos[:, :3] = rng.normal(size=(count, 3))
    qpos[:, 3:7] = quat.normalised(rng.normal(size=(count, 4)))
    qpos[:, 7:11] = model.qpos0[7:11] + rng.uniform(-0.8, 0.05, (count, 4))
    qpos[:, 11:] = quat.from_rotation_vector(rng.uniform(-0.7, 0.7, (count, 3)))
    return qpos


def seen(model: mujoco.MjModel, qpos: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places and rotations of all bodies."""
    data, places, turns = mujoco.MjData(model), [], []
    for row in qpos:
        data.qpos = row
        mujoco.mj_kinematics(model, data)
        places.append(data.xpos.copy())
        turns.append(data.xquat.copy())
    return np.array(places), np.array(turns)


def bodies(model: mujoco.MjModel) -> list[int]:
    return [model.body(name).id for name in CHAIN]


def test_a_hand_comes_where_another_pose_has_it(model):
    """From poses some tenths of a radian off, what can be reached is reached, turned as it was."""
    wanted, start = poses(model, 20, 1), poses(model, 20, 1)
    start[:, 7:11] += np.random.default_rng(2).uniform(-0.3, 0.3, (20, 4))
    start[:, 8] = np.clip(start[:, 8], *model.joint("roll").range)
    start[:, 10] = np.clip(start[:, 10], *model.joint("elbow").range)
    places, turns = seen(model, wanted)
    chain = bodies(model)
    about = places[:, chain[-1]] - places[:, chain[0]]
    limb = Limb(chain, about, {chain[-1]: turns[:, chain[-1]]})
    found, after = seen(model, bend(model, start, limb, turns[:, model.body("trunk").id]))
    np.testing.assert_allclose(found[:, chain[-1]] - found[:, chain[0]], about, atol=2e-4)
    assert np.degrees(quat.angle_between(after, turns)[:, chain[-1]]).max() < 0.1


def test_what_is_there_already_stays(model):
    qpos = poses(model, 5, 3)
    places, turns = seen(model, qpos)
    chain = bodies(model)
    about = places[:, chain[-1]] - places[:, chain[0]]
    limb = Limb(chain, about, {body: turns[:, body] for body in chain})
    back = bend(model, qpos, limb, turns[:, model.body("trunk").id])
    np.testing.assert_allclose(back, qpos, atol=1e-6)


def test_out_of_reach_the_arm_is_stretched_towards_it_in_its_ranges(model):
    qpos = poses(model, 12, 4)
    places, turns = seen(model, qpos)
    chain = bodies(model)
    way = quat.rotated(turns[:, 1], np.array([0.1, 0.2, -1.0]))
    bent = bend(model, qpos, Limb(chain, 2 * way, {}), turns[:, 1])
    for name, column in (("roll", 8), ("elbow", 10)):
        low, high = model.joint(name).range
        assert np.all((bent[:, column] >= low) & (bent[:, column] <= high)), name
    found, _ = seen(model, bent)
    before, after = (np.linalg.norm(at[:, chain[-1]] - at[:, chain[0]] - 2 * way, axis=1) for at in (places, found))
    assert np.all(after < before - 0.005) or np.all(after <= before)
    assert after.max() < before.max()
    np.testing.assert_array_equal(bent[:, :7], qpos[:, :7])


def test_parts_turn_no_more_than_the_place_asks_for(model):
    """A place a centimetre off moves the arm by about that, not into another of its many ways to be there."""
    qpos = poses(model, 10, 5)
    places, turns = seen(model, qpos)
    chain = bodies(model)
    about = places[:, chain[-1]] - places[:, chain[0]] + [0.0, 0.0, 0.01]
    bent = bend(model, qpos, Limb(chain, about, {body: turns[:, body] for body in chain}), turns[:, 1])
    _, after = seen(model, bent)
    assert np.degrees(quat.angle_between(after, turns)).max() < 15


def test_an_arm_that_is_welded_on_stays_as_it_is():
    welded = mujoco.MjModel.from_xml_string(
        """<mujoco><worldbody><body name="trunk"><freejoint/><geom size=".1"/><body name="upper" pos="0 .1 .2">
        <geom size=".02"/><body name="hand" pos="0 0 -.3"><geom size=".02"/></body></body></body>
        </worldbody></mujoco>"""
    )
    qpos = np.tile(welded.qpos0, (4, 1))
    chain = [welded.body(name).id for name in ("upper", "hand")]
    limb = Limb(chain, np.tile([0.1, 0, 0], (4, 1)), {chain[-1]: np.tile([0, 1.0, 0, 0], (4, 1))})
    np.testing.assert_array_equal(bend(welded, qpos, limb, qpos[:, 3:7]), qpos)
