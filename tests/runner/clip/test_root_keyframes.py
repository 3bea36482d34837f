"""Keyframes that place a root: the robot's wherever it is listed, and roots of slides and hinges, by MuJoCo, SciPy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines import inbetween, recordings
from dynsplines.clip.build import Clip
from dynsplines.clip.posing.places import sole_points
from dynsplines.errors import UserError
from dynsplines.scene.framing import middles
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import stances
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from tests.support.biped import BALL, BOX, CART, biped, joints, nested, scene

PLANAR = ("tx", "tz", "ry")
ROOTS = {
    "slides first": biped(joints(("tz", "ty", "tx", "rz", "rx", "ry"))),
    "hinges first": biped(joints(("rx", "ry", "rz", "ty", "tx", "tz"))),
    "mixed": biped(joints(("rz", "ty", "rx", "tx", "ry", "tz"))),
    "nested": nested(("tx", "ty", "tz", "rz", "rx", "ry")),
    "ball": biped(joints(("tz", "ty", "tx")) + '<joint name="ball" type="ball"/>'),
}


def read(model: str, folder: Path, *keys: str) -> Clip:
    """A clip of keyframes half a second apart."""
    (folder / "model.xml").write_text(model, encoding="utf-8")
    rows = "".join(f"[[keyframe]]\ntime = {i / 2}\n{key}\n" for i, key in enumerate(keys))
    return recordings.from_text(f'figure = "model.xml"\n{rows}', name="c", folder=folder)


def placed(problem: Clip, k: int, body: str) -> tuple[Array, Array]:
    """Where a body is in a keyframe (3,) [m], and its rotation (3, 3)."""
    data = kinematics(problem.figure.model, problem.keys[k].state)
    return data.body(body).xpos, data.body(body).xmat.reshape(3, 3)


@pytest.mark.parametrize("bodies", [(BOX, biped()), (CART, biped(), BALL)])
def test_root_position_moves_the_robot_and_no_object(tmp_path: Path, bodies: tuple[str, ...]) -> None:
    problem = read(scene(*bodies), tmp_path, 'others = "rest"\nroot.position = [0, 0.1, 0.7]', 'others = "rest"')
    assert placed(problem, 0, "pelvis")[0] == pytest.approx([0, 0.1, 0.7])
    for name in ("box", "cart", "ball"):
        if f'body name="{name}"' in str(bodies):
            assert placed(problem, 0, name)[0] == pytest.approx(placed(problem, 1, name)[0])
    qpos = np.array([key.state for key in problem.keys])
    assert middles(problem.figure, qpos)[0] == pytest.approx([0, 0.1, 0.7])


def test_an_object_is_placed_by_its_joint_or_its_body(tmp_path: Path) -> None:
    rest = 'others = "rest"'
    for name in ("box_free", "box"):
        problem = read(scene(BOX, biped()), tmp_path, f"{rest}\nroots.{name}.position = [1, 2, 3]", rest)
        assert placed(problem, 0, "box")[0] == pytest.approx([1, 2, 3])
    with pytest.raises(UserError, match=r"roots: no free joint 'bix'"):
        read(scene(BOX, biped()), tmp_path, f"{rest}\nroots.bix.position = [1, 2, 3]", rest)


def test_several_robots_are_placed_by_name_only(tmp_path: Path) -> None:
    model = scene(biped(), biped(prefix="b_", x=1.0, root='<freejoint name="b_root"/>'))
    with pytest.raises(
        UserError, match=r"keyframe 1 .*: root: .* several figures; specify which: roots.root, roots.b_"
    ):
        read(model, tmp_path, "root.position = [0, 0, 1]", "")
    problem = read(model, tmp_path, 'others = "rest"\nroots.b_root.position = [0, 0, 1]', 'others = "rest"')
    assert placed(problem, 0, "b_pelvis")[0] == pytest.approx([0, 0, 1])
    assert "several figures of one size: the camera and flights are of 'root', not of 'b_root'" in problem.notes


def test_which_of_several_free_bodies_is_the_root_is_noted(tmp_path: Path) -> None:
    keys = "root = {position = [0, 0, 1], rotation = {heading = 0}}", 'others = "rest"'
    said = "several free bodies: root is 'box_free', the first in the model, not 'ball'"
    assert said in read(scene(BOX, BALL), tmp_path, *keys).notes
    assert said not in read(scene(BOX, BALL), tmp_path, keys[1], keys[1]).notes
    assert not any("several" in note for note in read(scene(BOX, biped(), BALL), tmp_path, *keys).notes)


def test_an_object_whose_joint_is_named_root_is_not_taken_for_the_figure(tmp_path: Path) -> None:
    model = scene(BOX.replace("box_free", "root"), biped('<freejoint name="base"/>'))
    with pytest.raises(UserError, match=r"the joint 'root' carries 'box'.*specify roots.root or roots.base"):
        read(model, tmp_path, "root.position = [0, 0, 1]", "")


@pytest.mark.parametrize("kind", ROOTS)
def test_a_root_of_slides_and_hinges_is_placed_as_a_free_one(tmp_path: Path, kind: str) -> None:
    turn = "{euler = [10, -20, 15], heading = 70}"
    key = f'others = "rest"\nroot.position = [0.2, -0.3, 0.9]\nroot.rotation = {turn}'
    problem = read(scene(ROOTS[kind]), tmp_path, key, 'others = "rest"\nroot.rotation = {heading = 40}')
    place, rotation = placed(problem, 0, "pelvis")
    wanted = Rotation.from_euler("z", 70, degrees=True) * Rotation.from_euler("XYZ", [10, -20, 15], degrees=True)
    assert place == pytest.approx([0.2, -0.3, 0.9], abs=1e-6)
    assert rotation == pytest.approx(wanted.as_matrix(), abs=1e-6)
    place, rotation = placed(problem, 1, "pelvis")
    assert place == pytest.approx([0, 0, 0.8], abs=1e-6)
    assert rotation == pytest.approx(Rotation.from_euler("z", 40, degrees=True).as_matrix(), abs=1e-6)


@pytest.mark.parametrize("kind", ["hinges first", "nested", "ball"])
def test_a_height_alone_leaves_the_rest_of_the_root_to_the_search(tmp_path: Path, kind: str) -> None:
    rest = 'others = "rest"'
    problem = read(scene(ROOTS[kind]), tmp_path, rest, 'root.position = ["free", "free", 0.7]', rest)
    key = problem.keys[1]
    assert placed(problem, 1, "pelvis")[0][2] == pytest.approx(0.7, abs=1e-4)
    knee = problem.figure.links[-5].qpos
    assert not key.fixed[knee]
    assert key.known[knee] and key.state[knee] > np.radians(20)  # feet stay, as in a squat


def test_planar_roots_reach_their_plane_and_refuse_the_rest(tmp_path: Path) -> None:
    model = scene(biped(joints(PLANAR)))
    key = 'others = "rest"\nroot = {position = [1, 0, 0.75], rotation = {euler = [0, 350, 0]}}'
    problem = read(model, tmp_path, key, 'others = "rest"')
    assert problem.keys[0].state[:3] == pytest.approx([1, -0.05, np.radians(350)])
    with pytest.raises(UserError, match=r"root.position: 'pelvis' moves on 'tx', 'tz' alone and stays at y = 0 m"):
        read(model, tmp_path, "root.position = [0, 0.5, 0.8]", "")
    with pytest.raises(UserError, match=r"root.rotation: 'pelvis' turns on 'ry' alone, .* 90 degrees"):
        read(model, tmp_path, "root.rotation = {heading = 90}", "")


def test_a_full_turn_can_be_keyed_on_a_hinge(tmp_path: Path) -> None:
    model = scene(ROOTS["slides first"])
    keys = [f'others = "rest"\nroot.rotation = {{heading = {angle}}}' for angle in (0, 180, 360)]
    problem = read(model, tmp_path, *keys)
    column = problem.figure.model.joint("rz").qposadr[0]
    assert [key.state[column] for key in problem.keys] == pytest.approx([0, np.pi, 2 * np.pi])


@pytest.mark.parametrize("kind", ["nested", "planar"])
def test_feet_are_found_and_stand(tmp_path: Path, kind: str) -> None:
    root = biped(joints(PLANAR)) if kind == "planar" else ROOTS[kind]
    rest = 'others = "rest"'
    problem = read(scene(BOX, root), tmp_path, rest, rest)
    soles = sole_points(problem.figure, problem.figure.model.qpos0[None])
    assert {point.name.rpartition(" ")[0] for point in soles} == {"left_foot", "right_foot"}
    assert len(stances(KeyframePoints.of(problem.figure, problem.context.keys, soles, problem.context.surfaces))) == 8


@pytest.mark.parametrize("names", [("tz", "tx", "ry"), ("tz", "ty", "tx", "rz", "rx", "ry")])
def test_a_keyframe_of_no_height_is_put_down_on_the_ground(tmp_path: Path, names: tuple[str, ...]) -> None:
    rest, parts = 'others = "rest"', {"hip": -40, "knee": 80, "ankle": -40}
    legs = ", ".join(f"{side}_{part} = {angle}" for side in ("left", "right") for part, angle in parts.items())
    crouched = f'{rest}\nroot.position = [0, 0, "free"]\njoints = {{{legs}}}'
    expected = read(scene(biped()), tmp_path, rest, crouched, rest)
    problem = read(scene(biped(joints(names))), tmp_path, rest, crouched, rest)
    height = placed(problem, 1, "pelvis")[0][2]
    assert height == pytest.approx(placed(expected, 1, "pelvis")[0][2], abs=1e-6)
    assert 0.5 < height < 0.75


@pytest.mark.slow
def test_the_trunk_stays_upright_in_a_squat_on_slides(tmp_path: Path) -> None:
    rest = 'others = "rest"'
    motion = inbetween(read(scene(biped(joints(PLANAR))), tmp_path, rest, "root.position = [0, 0, 0.7]", rest))
    data = kinematics(motion.model, motion.at(0.5))
    assert data.body("pelvis").xpos == pytest.approx([0, 0, 0.7], abs=1e-6)
    assert data.body("pelvis").xmat[8] > np.cos(np.radians(10))


TILTED = """<mujoco><compiler angle="degree"/><worldbody><geom type="plane" size="5 5 .1"/>
  <body name="trunk" pos="0 0 1" euler="{trunk}">{root}<geom type="box" size=".2 .1 .1"/>
    <body name="head" pos=".3 0 0" euler="-10 25 40"><joint name="neck" type="ball"/><geom size=".1"/></body>
  </body></worldbody></mujoco>"""


@pytest.mark.parametrize("root", ['<freejoint name="root"/>', joints(("tx", "ty", "tz", "rx", "ry", "rz"))])
@pytest.mark.parametrize("trunk", ["90 0 0", "20 0 30", "0 0 -50"])
def test_a_heading_alone_rotates_the_rest_pose(tmp_path: Path, root: str, trunk: str) -> None:
    model, rest = TILTED.format(trunk=trunk, root=root), 'others = "rest"'
    rows = f"{rest}\nroot.rotation = {{heading = 60}}", f"{rest}\nbodies.head = {{heading = 70}}"
    problem = read(model, tmp_path, rest, *rows, f"{rest}\nbodies.head = {{flat = true, heading = -20}}")
    for k, body, heading in ((1, "trunk", 60), (2, "head", 70), (3, "head", -20)):
        wanted = Rotation.from_euler("z", heading, degrees=True).as_matrix() @ placed(problem, 0, body)[1]
        assert placed(problem, k, body)[1] == pytest.approx(wanted, abs=1e-6)
