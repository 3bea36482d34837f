"""Numbers that no motion has, in models, keyframes and motions: refused in a line that says where they are."""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import pytest
import tiny

from runner import clip, motion
from runner.errors import UserError
from runner.motion import Saved
from runner.starter import starter
from solver.figure import Figure
from solver.penalty import body_points
from solver.penalty.contact import MOST_BETWEEN

KEYS = '<keyframe><key qpos="{}"/><key time="1" qpos="{}"/></keyframe></mujoco>'
GOOD = "0 0 1 1 0 0 0 1 0 0 0"


@pytest.mark.parametrize(
    ("other", "said"),
    [
        ("0 0 1 0 0 0 0 1 0 0 0", "the quaternion of 'root' is zero"),
        ("0 0 1 1 0 0 0 0 1e-320 0 0", "the quaternion of 'left_knee' is zero"),
        ("0 0 1 1 -1e308 0 0 1 0 0 0", "an entry is too large"),
        ("0 0 1e308 1 0 0 0 1 0 0 0", "an entry is too large"),
    ],
)
def test_keyframes_of_a_model_are_told_alike_by_new_and_as_a_clip(other: str, said: str, tmp_path: Path):
    path = tmp_path / "m.xml"
    path.write_text(tiny.FIGURE.replace("</mujoco>", KEYS.format(GOOD, other)), encoding="utf-8")
    with pytest.raises(UserError, match=f"m.xml: keyframe 2: {said}"):
        starter(str(path), tmp_path / "a.toml")
    with pytest.raises(UserError, match=rf"m.xml: keyframe 2 \(t = 1 s\): {said}"):
        clip.load(str(path))


@pytest.mark.parametrize("length", ["1e4", "1e9", "1e50"])
def test_a_capsule_of_any_length_is_covered_by_so_many_spheres(length: str):
    text = tiny.FIGURE.replace('fromto="0 0 0 0 0 -.3"', f'fromto="0 0 0 0 0 -{length}"')
    found = body_points(Figure(mujoco.MjModel.from_xml_string(text)))
    assert sum(point.name == "shin" for point in found) == MOST_BETWEEN + 1


@pytest.mark.parametrize("name", ["frame_state", "raw_frame_state", "qpos", "key_qpos"])
def test_a_motion_of_numbers_too_large_to_reckon_with_is_refused(name: str, saved: Saved, tmp_path: Path):
    motion.save(saved, tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as data:
        arrays = {each: data[each] for each in data.files}
    arrays[name][0, -4] = 1e308
    np.savez(tmp_path / "b.npz", **arrays)
    with pytest.raises(UserError, match=f"b.npz: its arrays do not fit together: '{name}' holds an entry that is too"):
        motion.load(tmp_path / "b.npz")
