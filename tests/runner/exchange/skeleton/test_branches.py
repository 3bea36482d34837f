"""The bone map of a robot whose names are no help: its limbs by the tree and by where they are."""

from __future__ import annotations

import re

import mujoco
import numpy as np
import pytest
from android import ANDROID

from dynsplines.exchange.skeleton import branches, hierarchy
from dynsplines.exchange.skeleton.limbs import Limb, bend

BODIES = re.findall(r'body name="(\w+)"', ANDROID)


def nameless(keep: str = "") -> str:
    """The robot with numbers for names, but for those bodies that one keeps."""
    text = re.sub(r'joint name="\w+"', "joint", ANDROID)
    for number, body in enumerate(BODIES):
        if body != keep:
            text = text.replace(f'body name="{body}"', f'body name="{number}"')
    return text


def found(text: str) -> dict[str, str]:
    """Bodies by role, called as the robot with names calls them."""
    model = mujoco.MjModel.from_xml_string(text)
    rest = hierarchy.rest(model)
    told = branches.completed(model, {}, rest.position[0], rest.rotation[0])
    return {role: BODIES[body - 1] for role, body in told.items()}


@pytest.mark.parametrize("text", [ANDROID, nameless()])
def test_limbs_are_found_by_the_tree_alone(text):
    assert found(text) == {
        "pelvis": "pelvis",
        "chest": "torso_link",
        **{
            f"{side}_{role}": f"{side}_{body}"
            for side in ("left", "right")
            for role, body in {
                "thigh": "hip_yaw_link",
                "shin": "knee_link",
                "foot": "ankle_roll_link",
                "upper_arm": "shoulder_yaw_link",
                "forearm": "elbow_link",
                "hand": "wrist_roll_link",
            }.items()
        },
    }


def test_a_single_name_tells_the_sides():
    """A robot that looks along -x: its left is where ours is right."""
    turned = re.sub(
        r'pos="0 (\S+) (-.05|.25)"', lambda m: f'pos="0 {-float(m[1])} {m[2]}"', nameless("left_elbow_link")
    )
    assert found(turned)["left_upper_arm"] == "left_shoulder_yaw_link"
    assert found(turned)["left_thigh"] == "right_hip_yaw_link"  # nothing tells these


def test_arms_of_a_t_pose_are_found():
    """Hinges about an arm's own line lie along y there."""
    text = nameless()
    for way, side in ((1, "left"), (-1, "right")):
        number = BODIES.index(f"{side}_shoulder_pitch_link")
        text = text.replace(f'body name="{number}" pos', f'body name="{number}" euler="{90 * way} 0 0" pos')
    assert found(text) == found(ANDROID)


def test_names_come_first_and_the_tree_tells_the_rest():
    model = mujoco.MjModel.from_xml_string(ANDROID)
    rest, legs = hierarchy.rest(model), {"left_thigh": 2, "left_shin": 3, "right_thigh": 8, "right_shin": 9}
    told = branches.completed(model, legs | {"head": 1}, rest.position[0], rest.rotation[0])
    assert legs.items() <= told.items() and told["head"] == 1
    assert model.body(told["left_forearm"]).name == "left_elbow_link"


def test_what_stands_on_four_legs_has_no_limbs_of_a_person():
    shank = '<body pos="0 0 -.2"><joint axis="0 1 0"/><geom size=".02" pos="0 0 -.2"/></body>'
    thigh = f'<body pos="0 0 -.05"><joint axis="0 1 0"/><geom size=".02"/>{shank}</body>'
    leg = f'<body pos="{{}} {{}} 0"><joint axis="1 0 0"/><geom size=".02"/>{thigh}</body>'
    legs = "".join(leg.format(x, y) for x in (-0.2, 0.2) for y in (-0.1, 0.1))
    text = f'<mujoco><worldbody><body><freejoint/><geom size=".1"/>{legs}</body></worldbody></mujoco>'
    assert found(text) == {}
    assert found('<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>') == {}


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
