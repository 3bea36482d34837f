"""Keyframes that place roots, turn by whole turns, and hold joints."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
from figures import BOX, CART, biped, joints, scene
from figures import OBJECT_BALL as BALL
from oracles import kinematics, tracks
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines import inbetween, recordings
from dynsplines.clip.build import Clip
from dynsplines.errors import UserError
from dynsplines.scene.framing import middles
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of


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
    assert not any("several" in note for note in read(scene(BOX, biped(), BALL), tmp_path, keys[1], keys[1]).notes)


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


ARM = """<mujoco><worldbody><body pos="0 0 1"><joint name="turn" axis="0 0 1"/>
<geom type="capsule" fromto="0 0 0 .4 0 0" size=".03"/><body pos=".4 0 0"><joint name="bend" axis="0 0 1"/>
<geom type="capsule" fromto="0 0 0 .4 0 0" size=".03"/><site name="tip" pos=".4 0 0"/></body></body>
</worldbody></mujoco>"""


def read_human(*keys: str, figure: str = "human", folder: Path | None = None) -> Clip:
    """Keyframes a second apart."""
    rows = "".join(f'[[keyframe]]\ntime = {i}\nothers = "rest"\n{key}\n' for i, key in enumerate(keys))
    return recordings.from_text(f'figure = "{figure}"\n[solve]\nends = "free"\n{rows}', name="c", folder=folder)


def turned(problem: Clip) -> float:
    """[degrees] about the vertical, by SciPy, from the first to the last keyframe of the raw spline."""
    raw = problem.problem.raw
    qpos = problem.figure.to_qpos(path_of(raw).at(np.linspace(raw.times[0], raw.times[-1], 500)))
    heading = Rotation.from_quat(qpos[:, 3:7], scalar_first=True).as_euler("ZYX")[:, 0]
    return float(np.degrees(np.unwrap(heading)[-1] - heading[0]))


@pytest.mark.parametrize(("last", "way"), [(360, 0), (-200, 160)])
def test_a_heading_more_than_a_half_turn_on_is_reported(last: int, way: int) -> None:
    problem = read_human("root.rotation = {heading = 0}", f"root.rotation = {{heading = {last}}}")
    (note,) = problem.notes
    assert note.startswith("keyframe 2 (t = 1 s): root.rotation: ")
    assert f"heading {last} is {abs(last)} degrees from keyframe 1" in note
    assert ("nothing turns" if way == 0 else f"the shorter way, {abs(way)} degrees") in note
    assert turned(problem) == pytest.approx(way, abs=1)


def test_keyframes_between_as_the_note_advises_make_turns_of_any_angle() -> None:
    (note,) = read_human("root.rotation = {heading = 0}", "root.rotation = {heading = 360}").notes
    between = note.rpartition("such as ")[2].split(", ")
    problem = read_human(*(f"root.rotation = {{heading = {angle}}}" for angle in ("0", *between, "360")))
    assert problem.notes == ()
    assert turned(problem) == pytest.approx(360, abs=1)
    spin = read_human(*(f"root.rotation = {{heading = {angle}}}" for angle in (0, 160, 350, 540)))
    assert spin.notes == ()
    assert turned(spin) == pytest.approx(540, abs=1)


@pytest.mark.parametrize(
    ("headings", "way", "is_noted"), [((-100, 70), -290, True), ((-100, -290), -290, False), ((-100, 0, 70), 70, False)]
)
def test_a_turn_the_longer_way_is_reported_unless_it_is_written(headings, way: int, is_noted: bool) -> None:
    problem = read_human(*(f"root.rotation = {{heading = {angle}}}" for angle in (0, *headings)))
    assert [note[:68] for note in problem.notes] == is_noted * [
        "keyframe 3 (t = 2 s): 'root' turns by 190 degrees from keyframe 2, b"
    ]
    assert turned(problem) == pytest.approx(way, abs=1)


def test_rotations_of_joints_and_bodies_and_turns_from_rest_are_reported_too() -> None:
    assert "euler [0, -200, 0]" in read_human("", "joints.right_shoulder = {euler = [0, -200, 0]}").notes[0]
    assert "rotvec [0, 0, 270]" in read_human("", "joints.spine = {rotvec = [0, 0, 270]}").notes[0]
    (note,) = read_human(*(f"bodies.chest = {{rotvec = [0, 0, {angle}]}}" for angle in (10, 300))).notes
    assert "bodies.chest: rotvec [0, 0, 300] is 290 degrees from keyframe 1" in note
    assert any("nothing turns" in note for note in read_human("", "", "root.rotation = {euler = [0, 5, 360]}").notes)
    assert read_human("", "root.rotation = {euler = [0, 5, 170]}", "root.rotation = {euler = [0, 5, 340]}").notes == ()
    assert read_human("", "root.rotation = {euler = [120, 60, 150]}").notes == ()  # each by less than a half turn


@pytest.mark.parametrize("place", [(0.6, -0.3), (-0.3, -0.6)])
def test_hinges_are_posed_in_the_winding_of_the_keyframe_before(tmp_path: Path, place: tuple[float, float]) -> None:
    (tmp_path / "arm.xml").write_text(ARM, encoding="utf-8")
    keys = ["joints = {turn = 350, bend = 20}", f"sites.tip = [{place[0]}, {place[1]}, 1]"]
    problem = read_human(*keys, "joints = {turn = 700, bend = 20}", figure="arm.xml", folder=tmp_path)
    states = np.degrees([key.state for key in problem.keys])
    assert states[[0, 2]] == pytest.approx(np.array([[350, 20], [700, 20]]))
    assert np.all(np.abs(states[1] - states[0]) <= 180)
    data = mujoco.MjData(problem.figure.model)
    data.qpos[:] = problem.keys[1].state
    mujoco.mj_forward(problem.figure.model, data)
    assert data.site("tip").xpos == pytest.approx([*place, 1], abs=1e-6)


LURCH = read_data("lurch.toml")


@pytest.mark.slow
def test_a_person_does_not_lurch_back_before_a_step() -> None:
    """By 18 cm if nothing keeps the root near its way."""
    motion = inbetween(recordings.from_text(LURCH, name="c"))
    assert motion.sampled(100).qpos[:, 0].min() > -0.1
    assert motion.violations == []


AHEAD = read_data("step_ahead.toml")


@pytest.mark.slow
def test_the_other_foot_stays_flat_in_a_step() -> None:
    """It rose by up to 8 cm on its toes, while the pelvis tilted by 6 degrees, if the stepping leg kept its posture."""
    motion = inbetween(recordings.from_text(AHEAD, name="c"))
    qpos = motion.sampled(100).qpos
    heights = tracks(motion.model, qpos, ["right_heel", "right_toe", "left_heel", "left_toe"])[..., 2]
    assert heights[:, :2].max() < 0.005
    assert heights[:, 2:].min(axis=1).max() > 0.07
    upright = Rotation.from_quat(qpos[:, 3:7], scalar_first=True).as_matrix()[:, 2, 2]
    assert np.degrees(np.arccos(upright.min())) < 2
    assert [violation for violation in motion.violations if violation.kind != "self"] == []


@pytest.mark.parametrize(
    ("relation", "driver"),
    [("0 .5 0 0 0", 0.6), (".1 .5 0 0 0", 0.4), (".1 -2 0 0 0", -0.1), (".1 0 .5 0 0", None), ("0 .5 .5 0 0", None)],
)
def test_a_joint_that_a_linear_relation_moves_places_the_joint_that_drives_it(tmp_path: Path, relation, driver) -> None:
    """Unless the keyframe names both, or only the driver, which places its follower by any relation."""
    rail = '<body><joint name="{}" type="slide" axis="1 0 0"/><geom size=".1"/></body>'
    tie = f'<equality><joint joint1="b" joint2="a" polycoef="{relation}"/></equality>'
    model = f"<mujoco><worldbody>{rail.format('a')}{rail.format('b')}</worldbody>{tie}</mujoco>"
    clip = read(model, tmp_path, "joints.b = 0.3", "joints = {a = 0.2, b = 0.3}", "joints.a = 0.2")
    assert clip.keys[0].fixed.tolist() == [driver is not None, True]
    assert driver is None or clip.keys[0].state == pytest.approx([driver, 0.3])
    assert clip.keys[1].state == pytest.approx([0.2, 0.3])
    relation = np.polynomial.Polynomial(list(map(float, relation.split())))
    assert clip.keys[2].state == pytest.approx([0.2, relation(0.2)])
    assert clip.keys[2].fixed.all()
