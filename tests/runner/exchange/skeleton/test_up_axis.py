"""A figure that lies down in its model's own pose gets the same motion as one that stands in it."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines.exchange import formats
from dynsplines.exchange.skeleton import retarget
from dynsplines.exchange.skeleton.bvh_file import read
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton

CLOSE = 1e-3  # [m]
SKIN = 0.01  # [m] by which the boxes round a foot's capsules differ, on which it is put down
BONES = {  # parent, and offset [m] from it at rest; x ahead, y to the left, z up; where the bone of it ends
    "chest": ("pelvis", (0.0, 0.0, 0.12), (0.0, 0.0, 0.3)),
    "head": ("chest", (0.0, 0.0, 0.45), (0.0, 0.0, 0.1)),
    **{
        name.format(side=side): (parent.format(side=side), (x, sign * y, z), (ex, sign * ey, ez))
        for side, sign in (("left", 1), ("right", -1))
        for name, parent, (x, y, z), (ex, ey, ez) in (
            ("{side}_upper_arm", "chest", (0.0, 0.18, 0.33), (0.0, 0.27, 0.0)),
            ("{side}_forearm", "{side}_upper_arm", (0.0, 0.28, 0.0), (0.0, 0.24, 0.0)),
            ("{side}_thigh", "pelvis", (0.0, 0.09, -0.05), (0.0, 0.0, -0.38)),
            ("{side}_shin", "{side}_thigh", (0.0, 0.0, -0.4), (0.0, 0.0, -0.36)),
            ("{side}_foot", "{side}_shin", (0.0, 0.0, -0.4), (0.15, 0.0, -0.03)),
        )
    },
}


def person(turn):
    """A person of hinges whose every body is built in axes turned by `turn`; the world's axes stay."""

    def row(vector):
        return " ".join(f"{x:.9g}" for x in turn.apply(vector))

    def body(name, at, end):
        hinges = "".join(
            f'<joint name="{name}_{axis}" axis="{row(unit)}" range="-150 150"/>'
            for axis, unit in zip("xyz", np.eye(3), strict=True)
        )
        joints = '<freejoint name="root"/>' if name == "pelvis" else hinges
        below = "".join(body(child, *each[1:]) for child, each in BONES.items() if each[0] == name)
        place = "0 0 0.9" if name == "pelvis" else row(at)
        geom = f'<geom type="capsule" size=".04" fromto="0 0 0 {row(end)}"/>'
        return f'<body name="{name}" pos="{place}">{joints}{geom}{below}</body>'

    return mujoco.MjModel.from_xml_string(
        f"<mujoco><worldbody>{body('pelvis', None, (0.0, 0.0, 0.1))}</worldbody></mujoco>"
    )


@pytest.fixture(scope="module")
def walk(tmp_path_factory):
    moved = shipped.unsolved("walk_loop")
    skeleton = read(formats.export(moved, "bvh", tmp_path_factory.mktemp("walk") / "walk.bvh", fps=15))
    return CapturedSkeleton.of(skeleton, 0.01)


def places(model, qpos):
    return np.array([kinematics(model, row).xpos for row in qpos])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("axis", "degrees", "up"),
    [("x", -90, "y"), ("xyz", (90, 90, 0), "?"), ("z", 90, "")],
)
def test_a_figure_built_in_other_axes_moves_as_the_one_that_stands(axis, degrees, up, walk):
    standing, other = person(Rotation.identity()), person(Rotation.from_euler(axis, degrees, degrees=True))
    wanted, _ = retarget.onto(walk, standing, "walk")
    found, notes = retarget.onto(walk, other, "walk")
    apart = places(other, found)[:, 1:] - places(standing, wanted)[:, 1:]
    assert abs(apart[..., 2].mean()) < SKIN
    apart[..., 2] -= apart[..., 2].mean()
    np.testing.assert_allclose(apart, 0, atol=CLOSE)
    lying = [note for note in notes if "lies down in the model's world: stood up" in note]
    assert bool(lying) == bool(up)
    assert up in ("", "?") or f"rest pose has {up} up" in lying[0]


def test_a_figure_that_crouches_or_faces_aslant_is_left_as_it_is(walk):
    for degrees in (0, 20, 40):
        _, notes = retarget.onto(walk, person(Rotation.from_euler("y", degrees, degrees=True)), "walk")
        assert not any("stood up" in note for note in notes)
