"""Truncated tables and arrays of robots: cleaning uses the samples that are complete, importing refuses the file."""

import pickle
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
import walking_biped as biped

from dynsplines.errors import UserError
from dynsplines.exchange import gaps
from dynsplines.exchange.formats import recording
from dynsplines.exchange.tables import table_text

COUNT = 12
QPOS = biped.walk(COUNT)
PLACE, TURN = biped.poses(QPOS)
TIME = np.arange(COUNT) / biped.FPS
NAMES = ["waist_yaw", *biped.JOINTS]
COLUMNS = ["time", *(f"root.{part}" for part in ("x", "y", "z", "qw", "qx", "qy", "qz")), *NAMES]
ROOT_XYZW = [0, 1, 2, 4, 5, 6, 3, *range(7, 14)]


def lenient(path, fps=None, kind=None):
    with gaps.allowed():
        return recording(path, kind, model=biped.model(), fps=fps)


def is_start(found, tolerance=1e-8):
    """Whether a recording is the first samples of the walk."""
    count = len(found.time)
    biped.assert_same(found.qpos, QPOS[:count], tolerance)
    np.testing.assert_allclose(found.time - found.time[0], TIME[:count], atol=1e-6)
    return count


def table(name: str, digits: Callable[[float], str] = repr) -> tuple[str, float | None]:
    """A table of the walk, and its rate unless it has times; the last column moves and crosses zero."""
    match name:
        case "heading":
            rows, head = np.column_stack([TIME, QPOS]), ",".join(COLUMNS) + "\n"
        case "bare":
            rows, head = QPOS, ""
        case _:
            rows, head = QPOS[:, ROOT_XYZW], ""
    text = head + "".join(",".join(map(digits, row)) + "\n" for row in rows.tolist())
    return text, None if head else biped.FPS


DIGITS: dict[str, Callable[[float], str]] = {
    "shortest": repr, "fixed": lambda x: f"{x:.9f}", "exponents": lambda x: f"{x:.12e}",
    "significant": lambda x: f"{x:.10g}",
}  # fmt: skip


@pytest.mark.parametrize(("name", "digits"), [("heading", "fixed"), *(("bare", each) for each in DIGITS)])
def test_a_table_cut_at_any_byte_is_refused_or_read_as_far_as_it_is_complete(name, digits, tmp_path):
    text, _ = table(name, DIGITS[digits])
    path = tmp_path / "a.csv"
    path.write_text(text)
    whole = table_text.table(path).numbers
    before, last = [i for i, letter in enumerate(text) if letter == "\n"][-3:-1]
    for cut in (*range(before + 1, last - 20, 29), *range(last - 5, last + 3), *range(len(text) - 25, len(text))):
        path.write_text(text[:cut])
        complete = text[:cut].count("\n") - (name == "heading")
        with gaps.allowed():
            found = table_text.table(path)
        assert complete <= len(found.numbers) <= complete + 1
        np.testing.assert_allclose(found.numbers, whole[: len(found.numbers)], atol=1e-8)
        is_partial = len(found.numbers) == complete and text[cut - 1] != "\n"
        assert any("cut short" in note for note in found.notes) == is_partial, (cut, found.notes)
        if is_partial:
            with pytest.raises(
                UserError, match=r"a\.csv: the file is cut short: row \d+, the last, .*dynsplines clean` uses"
            ):
                table_text.table(path)
        else:
            assert len(table_text.table(path).numbers) == len(found.numbers)


@pytest.mark.parametrize("name", ["heading", "bare", "xyzw"])
def test_every_reader_of_tables_uses_the_complete_rows(name, tmp_path):
    text, fps = table(name)
    path = tmp_path / ("a.mjlab.csv" if name == "xyzw" else "a.csv")
    path.write_text(text[:-40])
    kind = None if name == "xyzw" else "csv"
    found = lenient(path, fps, kind)
    assert is_start(found) == COUNT - 1
    assert any(f"{COUNT - 1} of {COUNT} rows are used" in note for note in found.notes)
    with pytest.raises(UserError, match=f"`dynsplines clean` uses the {COUNT - 1} rows"):
        recording(path, kind, model=biped.model(), fps=fps)


@pytest.mark.parametrize("digits", DIGITS)
@pytest.mark.parametrize("name", ["bare"])
def test_a_complete_table_needs_no_end_of_line(name, digits, tmp_path):
    (tmp_path / "a.csv").write_text(table(name, DIGITS[digits])[0].rstrip("\n"))
    found = table_text.table(tmp_path / "a.csv")
    assert len(found.numbers) == COUNT
    assert not found.notes


@pytest.mark.parametrize(
    ("last", "above", "is_cut"),
    [
        ("0.8", ["0.25", "0.5"], False),
        ("1", ["0.25", "0.5"], True),
        ("-0.", ["-0.25", "-0.5"], True),
        ("0.123456789012", ["0.1234567890123456", "0.12345678901234567"], False),  # right within 1e-12
        ("5.4321", ["0.0123", "0.0101", "0.0074"], True),  # of 5.4321e-05
        ("5.4321e-0", ["1.2345e-02", "1.1234e-03"], True),
        ("5.4321e-05", ["1.2345e-02", "1.1234e-03"], False),
        ("12", ["121", "122", "124"], True),
        ("125", ["121", "122", "124"], False),
    ],
)  # fmt: skip
def test_the_numbers_above_decide_whether_the_last_one_is_cut(last, above, is_cut, tmp_path):
    text = "".join(f"{i},0,0,0.8,1,0,0,0,0,0,0,0,0,0,{cell}\n" for i, cell in enumerate([*above, last])).rstrip("\n")
    (tmp_path / "a.csv").write_text(text)
    with gaps.allowed():
        assert len(table_text.table(tmp_path / "a.csv").numbers) == len(above) + (not is_cut)


def test_a_row_that_lacks_cells_in_the_middle_is_refused_everywhere(tmp_path):
    lines = table("bare")[0].splitlines()
    few = [lines[3].rpartition(",")[0]]
    (tmp_path / "a.csv").write_text("\n".join([*lines[:3], *few, *lines[4:]]) + "\n")
    (tmp_path / "b.csv").write_text("\n".join([*lines[:3], *few * 3]) + "\n")
    for name, more in (("a", ""), ("b", " and 1 more such")):
        message = f"{name}.csv: row 4 does not hold 14 numbers, separated by commas; complete or delete it{more}$"
        with gaps.allowed(), pytest.raises(UserError, match=message):
            table_text.table(tmp_path / f"{name}.csv")


@pytest.mark.parametrize("end", ["", "\n0.1,0"])
def test_a_table_of_one_complete_row_or_less_is_too_short(end, tmp_path):
    (tmp_path / "a.csv").write_text(table("bare")[0].splitlines()[0] + end)
    with gaps.allowed(), pytest.raises(UserError, match=r"a\.csv: the file is cut short.*at least 2 complete rows"):
        table_text.table(tmp_path / "a.csv")


ARRAYS: dict[str, dict[str, Any]] = {
    "a.mjlab.npz": {"fps": 50, "joint_pos": QPOS[:, 7:], "joint_vel": QPOS[1:, 7:], "body_pos_w": PLACE[:, 1:],
                    "body_quat_w": TURN[:, 1:], "joint_names": NAMES},
    "a.qpos.npz": {"fps": 50, "qpos": QPOS, "qvel": QPOS[1:, :13], "xpos": PLACE},
    "b.qpos.npz": {"time": TIME, "qpos": QPOS},
    "a.loco.npz": {"frequency": 50, "qpos": QPOS, "split_points": [0, COUNT], "joint_names": ["root", *NAMES],
                   "jnt_type": [0, *[3] * 7], "xpos": PLACE},
    "a.gmr.pkl": {"fps": 50, "root_pos": QPOS[:, :3], "root_rot": QPOS[:, [4, 5, 6, 3]], "dof_pos": QPOS[:, 7:]},
}  # fmt: skip
OF_SAMPLES = {"joint_pos", "body_pos_w", "body_quat_w", "qpos", "xpos", "time", "root_pos", "root_rot", "dof_pos"}
CUT = [(file, name) for file, arrays in ARRAYS.items() for name in arrays if name in OF_SAMPLES]


def written(path, entries):
    if path.suffix == ".pkl":
        path.write_bytes(pickle.dumps(entries))
    else:
        arrays: dict[str, Any] = {name: np.asarray(value) for name, value in entries.items()}
        np.savez(path, **arrays)
    return path


@pytest.mark.parametrize(("file", "name"), CUT)
def test_the_samples_that_all_arrays_have_are_used(file, name, tmp_path):
    path = written(tmp_path / file, ARRAYS[file] | {name: ARRAYS[file][name][:9]})
    found = lenient(path)
    assert is_start(found, 1e-6) == 9
    assert any("cut short" in note and f"'{name}' 9" in note and " 12" in note for note in found.notes)
    with pytest.raises(UserError, match=rf"{file}: .*'{name}' \(9,.*`dynsplines clean` uses the first 9") as error:
        recording(path, model=biped.model())
    assert "12," in str(error.value)


@pytest.mark.parametrize("file", ARRAYS)
def test_velocities_of_one_sample_less_and_constants_cost_no_sample(file, tmp_path):
    found = lenient(written(tmp_path / file, ARRAYS[file] | {"gains": np.ones(3)}))
    assert is_start(found, 1e-6) == COUNT
    assert not any("cut short" in note for note in found.notes)


@pytest.mark.parametrize("count", [0, 1])
@pytest.mark.parametrize(("file", "name"), CUT)
def test_fewer_than_two_samples_are_refused(file, name, count, tmp_path):
    path = written(tmp_path / file, ARRAYS[file] | {name: ARRAYS[file][name][:count]})
    with gaps.allowed(), pytest.raises(UserError, match="a motion has at least 2"):
        recording(path, model=biped.model())


def test_samples_that_a_file_of_locomujoco_declares_and_lacks_are_reported(tmp_path):
    arrays = ARRAYS["a.loco.npz"]
    path = written(tmp_path / "a.loco.npz", arrays | {"qpos": QPOS[:8], "xpos": PLACE[:8]})
    found = lenient(path)
    assert is_start(found, 1e-6) == 8
    assert any("'qpos' 8, 'split_points' 12" in note for note in found.notes)
    with pytest.raises(UserError, match="`dynsplines clean` uses the first 8"):
        recording(path, model=biped.model())


def test_a_transposed_array_is_refused_with_its_shape(tmp_path):
    arrays: dict[str, Sequence[Any]] = ARRAYS["a.mjlab.npz"]
    path = written(tmp_path / "a.mjlab.npz", arrays | {"joint_pos": QPOS[:, 7:].T})
    with pytest.raises(UserError, match=r"'joint_pos' \(7, 12\), 'body_pos_w' \(12, 8, 3\)"):
        recording(path, model=biped.model())
    with gaps.allowed(), pytest.raises(UserError, match="12 columns of joints with 7 names"):
        recording(path, model=biped.model())
