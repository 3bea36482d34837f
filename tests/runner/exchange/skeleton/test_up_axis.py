"""Which axis is up: of recordings the one along which the person is upright; figures that lie are stood up."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.exchange.formats import bvh
from dynsplines.exchange.skeleton import bvh_file, retarget
from dynsplines.exchange.skeleton.bvh_file import Skeleton
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton, vertical
from dynsplines.motion import Sampled
from dynsplines.solver import quaternion as quat


def turned(skeleton: Skeleton, world: Rotation, rest: Rotation) -> Skeleton:
    """The same motion; offsets and joints' axes are turned by `rest`, places in the world by `world`."""
    w, r = (turn.as_quat(scalar_first=True) for turn in (world, rest))
    place, turn = (part.copy() for part in skeleton.local)
    root = quat.rotate(w, place[:, 0]), quat.product(quat.product(w, turn[:, 0]), quat.conjugate(r))
    place, turn = quat.rotate(r, place), quat.product(quat.product(r, turn), quat.conjugate(r))
    place[:, 0], turn[:, 0] = root
    joints = [
        replace(
            joint, offset=quat.rotate(r, joint.offset), end=None if joint.end is None else quat.rotate(r, joint.end)
        )
        for joint in skeleton.joints
    ]
    return bvh_file.skeleton(joints, place, turn, skeleton.fps)


HUMAN = mujoco.MjModel.from_xml_string(models.figure_text("human"))
NONE = Rotation.identity()
UPS = {  # how a file whose y is up is turned
    "z": Rotation.from_euler("x", 90, degrees=True), "x": Rotation.from_euler("z", -90, degrees=True),
    "-y": Rotation.from_euler("x", 180, degrees=True), "-z": Rotation.from_euler("x", -90, degrees=True),
    "-x": Rotation.from_euler("z", 90, degrees=True),
}  # fmt: skip


@pytest.fixture(scope="module")
def walk():
    """A person's walk in BVH's axes."""
    return bvh.skeleton(Sampled.of(shipped.unsolved("walk_loop"), 8.0))


def places(model, qpos):
    return np.array([kinematics(model, row).xpos for row in qpos])


def on_human(skeleton):
    """Distances (T, 12, 12) [m] between bodies and heights (T, 12) [m], by MuJoCo; notes."""
    captured = CapturedSkeleton.of(skeleton, 0.01)
    qpos, _ = retarget.onto(captured, HUMAN, "walk.bvh")
    place = places(HUMAN, qpos)[:, 1:]
    return np.linalg.norm(place[:, :, None] - place[:, None], axis=-1), place[..., 2], captured.notes


@pytest.mark.parametrize(
    ("up", "world", "rest"),
    [("z", True, True), ("x", True, False), ("-y", True, True), ("-z", True, False), ("-x", False, True)],
)
def test_a_walk_is_the_same_in_any_axes(walk, plain, up, world, rest):
    near, height, _ = plain
    found = on_human(turned(walk, UPS[up] if world else NONE, UPS[up] if rest else NONE))
    assert found[0] == pytest.approx(near, abs=1e-6)
    assert found[1] == pytest.approx(height, abs=1e-6)
    assert any(note.startswith(f"{up} is up in the file") for note in found[2]) == world


@pytest.fixture(scope="module")
def plain(walk):
    return on_human(walk)


def motion(direction, travel):
    """(20, 3, 3) [m] of head, pelvis and ankle along a direction, moved along another."""
    along = np.array([0.9, 0.0, -0.85])[:, None] * np.array(direction)
    return along + np.linspace(0, 1, 20)[:, None, None] * np.array(travel)


ROLES = {"head": 0, "pelvis": 1, "left_foot": 2, "right_foot": 2}


def test_a_person_that_swims_on_the_floor_leaves_the_usual_axis_up():
    """Level along y, while the feet go along z with the body."""
    assert vertical(motion([0, 0, 1], [0, 0, 2]), ROLES)[0] == "y"


def test_without_known_parts_the_usual_axis_is_up():
    assert vertical(motion([0, 0, 1], [1, 0, 0]), {}) == ("y", ())


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
def captured(walk):
    return CapturedSkeleton.of(walk, 0.01)


@pytest.fixture(scope="module")
def standing(captured):
    """Places of the bodies of the figure that stands."""
    model = person(Rotation.identity())
    return places(model, retarget.onto(captured, model, "walk")[0])[:, 1:]


@pytest.mark.slow
@pytest.mark.parametrize(("axis", "degrees", "up"), [("x", -90, "y"), ("xyz", (90, 90, 0), "?"), ("z", 90, "")])
def test_a_figure_built_in_other_axes_moves_as_the_one_that_stands(axis, degrees, up, captured, standing):
    other = person(Rotation.from_euler(axis, degrees, degrees=True))
    found, notes = retarget.onto(captured, other, "walk")
    apart = places(other, found)[:, 1:] - standing
    assert abs(apart[..., 2].mean()) < SKIN
    apart[..., 2] -= apart[..., 2].mean()
    np.testing.assert_allclose(apart, 0, atol=CLOSE)
    lying = [note for note in notes if "lies down in the model's world: stood up" in note]
    assert bool(lying) == bool(up)
    assert up in ("", "?") or f"rest pose has {up} up" in lying[0]


def test_a_figure_that_crouches_or_faces_aslant_is_left_as_it_is(captured):
    for degrees in (20, 40):
        _, notes = retarget.onto(captured, person(Rotation.from_euler("y", degrees, degrees=True)), "walk")
        assert not any("stood up" in note for note in notes)
