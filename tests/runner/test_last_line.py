"""Whatever goes wrong, the command ends with one line that a person understands, and never with a traceback."""

import csv
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pytest
from problems import CLIP, changed, written
from processes import Command

from dynsplines import Keyframe, build, solving
from dynsplines.batch.inputs import sources
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.formats import csv_table

Ended = Callable[..., tuple[int, str]]


@pytest.fixture
def ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: Command) -> Ended:
    """Exit code and last line of the command, run in an empty folder with the tiny clip in it."""
    monkeypatch.setenv("MUJOCO_GL", "disable")
    monkeypatch.setenv("DYNSPLINES_DEBUG", "")  # so that it is put back
    monkeypatch.chdir(tmp_path)
    written(tmp_path)

    def ended(*words: str) -> tuple[int, str]:
        done = command(*words)
        assert done.code > 0
        assert "Traceback" not in done.err
        return done.code, done.last

    return ended


def broken(monkeypatch: pytest.MonkeyPatch, error: Exception) -> None:
    def starter(*_: object) -> str:
        raise error

    monkeypatch.setattr("dynsplines.clip.starter.starter", starter)


def test_a_mistake_of_the_program_is_one_line_that_asks_for_a_report(ended: Ended, monkeypatch: pytest.MonkeyPatch):
    broken(monkeypatch, ZeroDivisionError("by\nnought"))
    code, line = ended("new", "tiny.xml", "-o", "a.toml")
    assert code == 4
    assert re.fullmatch(
        r"dynsplines: internal error: ZeroDivisionError: by\\nnought \(test_last_line.py:\d+\); "
        r"please report it, with what the same command prints as `dynsplines --debug ...`",
        line,
    )


@pytest.mark.parametrize("asked", ["flag", "environment"])
def test_a_traceback_is_printed_on_request(asked: str, ended: Ended, monkeypatch: pytest.MonkeyPatch):
    broken(monkeypatch, ZeroDivisionError("by nought"))
    flag = ["--debug"] if asked == "flag" else []
    monkeypatch.setenv("DYNSPLINES_DEBUG", "" if flag else "1")
    with pytest.raises(ZeroDivisionError, match="by nought"):
        ended(*flag, "new", "tiny.xml", "-o", "a.toml")
    assert ended(*flag, "solve", "none.toml")[0] == 2  # what is no mistake of ours has no place in the program


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (MemoryError(), "not enough memory for this"),
        (mujoco.FatalError("Could not allocate memory"), "not enough memory for this, or to load what it needs"),
        (ImportError("a.so: failed to map segment"), "not enough memory for this, or to load what it needs"),
        (RuntimeError("can't start new thread"), "the system allows no more threads, or no more memory"),
        (OSError(24, "Too many open files", "a"), "'a': Too many open files"),
    ],
)
def test_too_little_of_anything_is_no_mistake_of_the_program(
    error: Exception, words: str, ended: Ended, monkeypatch: pytest.MonkeyPatch
):
    broken(monkeypatch, error)
    assert ended("new", "tiny.xml", "-o", "a.toml") == (2, f"dynsplines: {words}")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("fps = 20", f"fps = {'9' * 5000}", "not valid TOML: a number of thousands of digits"),
        ("time = 0.41", f"time = {'9' * 400}", ": time must be a number, not 999"),
        ("joints.left_knee", f"joints.{'x' * 20_000}", "no joint 'xxx"),
    ],
)
def test_numbers_and_names_of_any_length_are_reported_shortly(old: str, new: str, words: str, ended: Ended):
    Path("tiny.toml").write_text(changed(old, new), encoding="utf-8")
    code, line = ended("solve", "tiny.toml")
    assert code == 2
    assert words in line
    assert len(line) < 1000


def test_a_report_is_printed_in_terminals_of_few_letters():
    fit = "from dynsplines.system.exit_status import fit_terminal; fit_terminal(); "
    environment = os.environ | {"PYTHONIOENCODING": "ascii"}
    done = subprocess.run(
        [sys.executable, "-c", f"{fit} print('5°', end='')"], env=environment, capture_output=True, check=True
    )
    assert done.stdout == b"5\\xb0"


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have no such names")
def test_a_clip_whose_name_is_no_text_is_reported_before_a_batch_begins(tmp_path: Path):
    path = os.fsencode(tmp_path) + b"/caf\xe9.toml"
    with open(path, "w", encoding="utf-8") as stream:  # noqa: PTH123
        stream.write(CLIP)
    with pytest.raises(UserError, match=r"/caf\\udce9.toml': its name is not UTF-8 text; rename it"):
        sources([str(tmp_path)])


def test_names_in_a_table_are_no_formulas_and_come_back(tmp_path: Path):
    names = ["=cmd|' /C calc'!A0", "+1", "-1", "@SUM(1)", "'=quoted", "'plain", "plain"]
    hinges = "".join(f'<body><joint name="{name}"/><geom size=".1" mass="1"/>' for name in names)
    model = mujoco.MjSpec.from_string(f"<mujoco><worldbody>{hinges}{'</body>' * len(names)}</worldbody></mujoco>")
    qpos = np.arange(2.0 * len(names)).reshape(2, -1) / 100
    clip = build(model, [Keyframe(t, qpos=row) for t, row in enumerate(qpos)], fps=10)
    saved = solving.raw_spline(clip)
    target = formats.export(saved, "csv", tmp_path / "m.csv")
    with target.open(newline="", encoding="utf-8") as stream:
        heading = next(csv.reader(stream))
    assert heading[1:] == ["'" + name for name in names[:6]] + ["plain"]
    np.testing.assert_allclose(csv_table.read(target, clip.figure.model, None).qpos[[0, -1]], qpos, atol=1e-12)
