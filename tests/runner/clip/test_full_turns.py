"""Turns over 180 degrees between keyframes are reported, and hinges are posed in the winding that they are in."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dynsplines import recordings
from dynsplines.clip.build import Clip
from dynsplines.solver.curve.spline import path_of

ARM = """<mujoco><worldbody><body pos="0 0 1"><joint name="turn" axis="0 0 1"/>
<geom type="capsule" fromto="0 0 0 .4 0 0" size=".03"/><body pos=".4 0 0"><joint name="bend" axis="0 0 1"/>
<geom type="capsule" fromto="0 0 0 .4 0 0" size=".03"/><site name="tip" pos=".4 0 0"/></body></body>
</worldbody></mujoco>"""


def read(*keys: str, figure: str = "human", folder: Path | None = None) -> Clip:
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
    problem = read("root.rotation = {heading = 0}", f"root.rotation = {{heading = {last}}}")
    (note,) = problem.notes
    assert note.startswith("keyframe 2 (t = 1 s): root.rotation: ")
    assert f"heading {last} is {abs(last)} degrees from keyframe 1" in note
    assert ("nothing turns" if way == 0 else f"the shorter way, {abs(way)} degrees") in note
    assert turned(problem) == pytest.approx(way, abs=1)


def test_keyframes_between_as_the_note_advises_make_turns_of_any_angle() -> None:
    (note,) = read("root.rotation = {heading = 0}", "root.rotation = {heading = 360}").notes
    between = note.rpartition("such as ")[2].split(", ")
    problem = read(*(f"root.rotation = {{heading = {angle}}}" for angle in ("0", *between, "360")))
    assert problem.notes == ()
    assert turned(problem) == pytest.approx(360, abs=1)
    spin = read(*(f"root.rotation = {{heading = {angle}}}" for angle in (0, 160, 350, 540)))
    assert spin.notes == ()
    assert turned(spin) == pytest.approx(540, abs=1)


def test_rotations_of_joints_and_bodies_and_turns_from_rest_are_reported_too() -> None:
    assert "euler [0, -200, 0]" in read("", "joints.right_shoulder = {euler = [0, -200, 0]}").notes[0]
    assert "rotvec [0, 0, 270]" in read("", "joints.spine = {rotvec = [0, 0, 270]}").notes[0]
    assert any("nothing turns" in note for note in read("", "", "root.rotation = {euler = [0, 5, 360]}").notes)
    assert read("", "root.rotation = {euler = [0, 5, 170]}", "root.rotation = {euler = [0, 5, 340]}").notes == ()


@pytest.mark.parametrize("place", [(0.6, -0.3), (-0.3, -0.6)])
def test_hinges_are_posed_in_the_winding_of_the_keyframe_before(tmp_path: Path, place: tuple[float, float]) -> None:
    (tmp_path / "arm.xml").write_text(ARM, encoding="utf-8")
    keys = ["joints = {turn = 350, bend = 20}", f"sites.tip = [{place[0]}, {place[1]}, 1]"]
    problem = read(*keys, "joints = {turn = 700, bend = 20}", figure="arm.xml", folder=tmp_path)
    states = np.degrees([key.state for key in problem.keys])
    assert states[[0, 2]] == pytest.approx(np.array([[350, 20], [700, 20]]))
    assert np.all(np.abs(states[1] - states[0]) <= 180)
    data = mujoco.MjData(problem.figure.model)
    data.qpos[:] = problem.keys[1].state
    mujoco.mj_forward(problem.figure.model, data)
    assert data.site("tip").xpos == pytest.approx([*place, 1], abs=1e-6)
