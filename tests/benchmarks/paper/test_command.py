"""The command `python -m benchmarks.paper`: what it prints, and one line for bad input."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command import Command, commanded
from paper import __main__ as command
from paper.figures import drawing

from dynsplines.picture import graphics


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    monkeypatch.setattr(graphics, "_imported_backend", lambda: "off")  # software, whatever mujoco was imported with
    monkeypatch.setenv("MUJOCO_GL", "disable")  # so that it is put back
    monkeypatch.chdir(tmp_path)
    return commanded(monkeypatch, capsys, command.main)


def test_figures_are_listed_one_by_one_and_as_json(run: Command, monkeypatch: pytest.MonkeyPatch):
    drawn = [drawing.Drawn(7, Path("figures/figure_7.png"), "seven orientations")]
    monkeypatch.setattr(drawing, "draw", lambda folder, *_: drawn if folder == Path("figures") else [])
    done = run("--figures", "figures")
    assert (done.code, done.out) == (0, "")
    assert "wrote figures/figure_7.png" in done.err
    done = run("--figures", "figures", "--json")
    assert json.loads(done.out) == [{"figure": 7, "file": "figures/figure_7.png", "caption": "seven orientations"}]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--figures", "figures", "--seeds", "3"], "leave it out"),
        (["--figures", "a_file"], "it is a file"),
        (["--seeds", "0"], "--seeds"),
        (["--seeds", "many"], "--seeds"),
    ],
)
def test_bad_input_is_refused_in_one_line(run: Command, tmp_path: Path, words: list[str], message: str):
    (tmp_path / "a_file").touch()
    done = run(*words)
    assert (done.code, done.out, len(done.err.splitlines())) == (2, "", 1)
    assert message in done.err
