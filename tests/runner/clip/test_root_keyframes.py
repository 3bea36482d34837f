"""Keyframes that place a root, wherever the model lists it, by MuJoCo and SciPy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from oracles import kinematics
from scipy.spatial.transform import Rotation

from dynsplines import recordings
from dynsplines.clip.build import Clip
from dynsplines.errors import UserError
from dynsplines.scene.framing import middles
from dynsplines.solver.array import Array
from tests.support.biped import BALL, BOX, CART, biped, joints, scene


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


def test_a_figure_on_slides_has_no_root_and_the_error_names_its_joints(tmp_path: Path) -> None:
    model, rest = scene(BOX, biped(joints(("tx", "tz", "ry")))), 'others = "rest"'
    for key in ("root.position = [0, 0, 1]", "root.rotation = {heading = 90}"):
        with pytest.raises(UserError, match=r"no root to place; specify joints\.tx, joints\.tz, joints\.ry"):
            read(model, tmp_path, key, rest)
    problem = read(model, tmp_path, f"{rest}\njoints = {{tx = 1, tz = -0.05, ry = 350}}", rest)
    assert placed(problem, 0, "pelvis")[0] == pytest.approx([1, 0, 0.75])
    assert not problem.context.points and not problem.context.schedule.flights
    assert read(model, tmp_path, f"{rest}\nroots.box.position = [1, 2, 3]", rest)


def test_a_keyframe_of_no_height_is_put_down_on_the_ground(tmp_path: Path) -> None:
    rest, parts = 'others = "rest"', {"hip": -40, "knee": 80, "ankle": -40}
    legs = ", ".join(f"{side}_{part} = {angle}" for side in ("left", "right") for part, angle in parts.items())
    crouched = f'{rest}\nroot.position = [0, 0, "free"]\njoints = {{{legs}}}'
    assert 0.5 < placed(read(scene(biped()), tmp_path, rest, crouched, rest), 1, "pelvis")[0][2] < 0.75


TILTED = """<mujoco><compiler angle="degree"/><worldbody><geom type="plane" size="5 5 .1"/>
  <body name="trunk" pos="0 0 1" euler="{trunk}"><freejoint name="root"/><geom type="box" size=".2 .1 .1"/>
    <body name="head" pos=".3 0 0" euler="-10 25 40"><joint name="neck" type="ball"/><geom size=".1"/></body>
  </body></worldbody></mujoco>"""


@pytest.mark.parametrize("trunk", ["90 0 0", "20 0 30", "0 0 -50"])
def test_a_heading_alone_rotates_the_rest_pose(tmp_path: Path, trunk: str) -> None:
    model, rest = TILTED.format(trunk=trunk), 'others = "rest"'
    rows = f"{rest}\nroot.rotation = {{heading = 60}}", f"{rest}\nbodies.head = {{heading = 70}}"
    problem = read(model, tmp_path, rest, *rows, f"{rest}\nbodies.head = {{flat = true, heading = -20}}")
    for k, body, heading in ((1, "trunk", 60), (2, "head", 70), (3, "head", -20)):
        wanted = Rotation.from_euler("z", heading, degrees=True).as_matrix() @ placed(problem, 0, body)[1]
        assert placed(problem, k, body)[1] == pytest.approx(wanted, abs=1e-6)
