"""Numbers that no motion has, in models, keyframes and motions: refused in a line that says where they are."""

import re
from pathlib import Path

import motions
import numpy as np
import problems
import pytest

from dynsplines import motion, recordings
from dynsplines.clip.starter import starter
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording
from dynsplines.motion import Saved
from dynsplines.scene.compose import compose, figure_spec


@pytest.mark.parametrize(
    ("qpos", "said"),
    [
        ("0 0 1 0 0 0 0 1 0 0 0", "the quaternion of 'root' is zero"),
        ("0 0 1 1 0 0 0 0 1e-320 0 0", "the quaternion of 'left_knee' is zero"),
        ("0 0 1 1 -1e308 0 0 1 0 0 0", "an entry is too large"),
        ("0 0 nan 1 0 0 0 1 0 0 0", "an entry is not a finite number"),
    ],
)
def test_the_first_key_of_a_model_is_reported(qpos: str, said: str, tmp_path: Path):
    path = tmp_path / "m.xml"
    path.write_text(problems.FIGURE.replace("</mujoco>", f'<keyframe><key qpos="{qpos}"/></keyframe></mujoco>'))
    with pytest.raises(UserError, match=f"m.xml: its first key: {said}"):
        starter(str(path), tmp_path / "a.toml")


@pytest.mark.parametrize("name", ["frame_state", "raw_frame_state", "qpos", "key_qpos"])
def test_a_motion_of_numbers_too_large_to_reckon_with_is_refused(name: str, saved: Saved, tmp_path: Path):
    motion.save(saved, tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as data:
        arrays = {each: data[each] for each in data.files}
    arrays[name][0, -4] = 1e308
    np.savez(tmp_path / "b.npz", **arrays)
    with pytest.raises(UserError, match=f"b.npz: its arrays do not fit together: '{name}' holds an entry that is too"):
        motion.load(tmp_path / "b.npz")


def test_a_skeleton_whose_joints_are_all_in_one_place_is_refused(tmp_path: Path):
    formats.export(motions.motion_of("human"), "bvh", tmp_path / "a.bvh", fps=10.0)
    text = (tmp_path / "a.bvh").read_text(encoding="utf-8")
    (tmp_path / "a.bvh").write_text(re.sub(r"OFFSET .*", "OFFSET 0 0 0", text), encoding="utf-8")
    with pytest.raises(UserError, match=r"a.bvh: its legs have no length"):
        import_recording(tmp_path / "a.bvh", figure="human")


@pytest.mark.parametrize("name", ["x" * 400, "x/" * 3000, "a\0b"])
def test_names_that_no_disk_has_are_those_of_files_that_are_not_there(name: str, tmp_path: Path):
    quoted = name.replace("\0", "\\u0000")
    text = problems.changed('"tiny.xml"', f'"{quoted}.xml"')
    with pytest.raises(UserError, match="no file '"):
        recordings.load(str(problems.written(tmp_path, text)))
    if "\0" not in name:
        for element in (f'<include file="{name}"/>', f'<asset><mesh name="a" file="{name}.stl"/></asset>'):
            (tmp_path / "m.xml").write_text(
                problems.FIGURE.replace("<worldbody>", f"{element}<worldbody>"), encoding="utf-8"
            )
            with pytest.raises(UserError):
                compose(figure_spec(str(tmp_path / "m.xml")))
