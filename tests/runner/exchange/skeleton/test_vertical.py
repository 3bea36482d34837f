"""The vertical of recordings is the axis along which the person is upright, whatever the file's axes are."""

from __future__ import annotations

from dataclasses import replace

import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.exchange.format import bvh
from dynsplines.exchange.skeleton import bvh_file, retarget
from dynsplines.exchange.skeleton.bvh_file import Skeleton
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton
from dynsplines.exchange.skeleton.up_axis import vertical
from dynsplines.exchange.trajectory import SampledTrajectory
from dynsplines.solver import quaternion as quat


def turned(skeleton: Skeleton, world: Rotation, rest: Rotation) -> Skeleton:
    """The same motion; offsets and joints' axes are turned by `rest`, places in the world by `world`."""
    w, r = (turn.as_quat(scalar_first=True) for turn in (world, rest))
    place, turn = (part.copy() for part in skeleton.local)
    root = quat.rotated(w, place[:, 0]), quat.product(quat.product(w, turn[:, 0]), quat.conjugate(r))
    place, turn = quat.rotated(r, place), quat.product(quat.product(r, turn), quat.conjugate(r))
    place[:, 0], turn[:, 0] = root
    joints = [
        replace(
            joint,
            offset=quat.rotated(r, joint.offset),
            end=None if joint.end is None else quat.rotated(r, joint.end),
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
    return bvh.skeleton(SampledTrajectory.of(shipped.unsolved("walk_loop"), 15.0))


def on_human(skeleton):
    """Distances (T, 12, 12) [m] between bodies and heights (T, 12) [m], by MuJoCo; notes."""
    captured = CapturedSkeleton.of(skeleton, 0.01)
    qpos, _ = retarget.onto(captured, HUMAN, "walk.bvh")
    place = np.array([kinematics(HUMAN, row).xpos[1:] for row in qpos])
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


def test_a_person_that_lies_down_for_most_of_the_time_does_not_turn_the_world():
    stands, lies = motion([0, 1, 0], [0, 0, 0])[:5], motion([1, 0, 0], [0, 0, 1])
    assert vertical(np.concatenate([stands, lies]), ROLES) == ("y", ())


def test_a_person_that_swims_on_the_floor_leaves_the_usual_axis_up():
    """Level along y, while the feet go along z with the body."""
    assert vertical(motion([0, 0, 1], [0, 0, 2]), ROLES)[0] == "y"


def test_without_known_parts_the_usual_axis_is_up():
    assert vertical(motion([0, 0, 1], [1, 0, 0]), {}) == ("y", ())
