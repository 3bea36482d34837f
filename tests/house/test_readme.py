"""The README's own example, clip and pictures."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shipped

from dynsplines import inbetween, recordings

ROOT = Path(__file__).parents[2]
README, REFERENCE, FORMATS_PAGE, COMMANDS = (
    (ROOT / name).read_text(encoding="utf-8")
    for name in ("README.md", "docs/clip.md", "docs/exchange.md", "docs/commands.md")
)


def blocks(language: str, page: str = README) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", page, flags=re.S)


@pytest.mark.slow
def test_the_python_example_runs_and_equals_the_toml_example(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shipped.share(monkeypatch)
    (example,) = blocks("python")
    names: dict[str, Any] = {}
    exec(compile(example, "README.md", "exec"), names)
    assert capsys.readouterr().out.startswith("(25, 51) <Motion clip: 0.80 s, 2 keyframes")
    assert {path.name for path in tmp_path.iterdir()} == {"step.png", "mirrored.csv"}
    twin = inbetween(recordings.from_text(blocks("toml")[0], name="readme"))
    np.testing.assert_array_equal(names["run"].qpos, twin.sampled(30).qpos)
    assert not twin.violations


def test_every_format_of_the_table_exists_and_none_is_left_out() -> None:
    from dynsplines.exchange.formats import FORMATS

    table = FORMATS_PAGE.split("# To and from other programs")[1].split("##")[0]
    ways = {"both": (True, True), "writes": (True, False), "reads": (False, True)}
    said = {
        name: ways[way.strip()]
        for names, way in re.findall(r"^\| ([^|]+) \| (both|writes|reads) \|", table, flags=re.MULTILINE)
        for name in re.findall(r"`([\w-]+)`", names)
    }
    assert said == {each.name: (each.writes, each.reads) for each in FORMATS}


@pytest.mark.slow
def test_the_example_clips_pasted_one_below_the_other_solve_and_nothing_is_wrong_with_them() -> None:
    parts = blocks("toml", REFERENCE)
    assert len(parts) == 4 and len(parts[0].splitlines()) <= 12
    assert blocks("toml") == parts[:1]
    motion = inbetween(recordings.from_text("".join(parts), name="readme"))
    assert not motion.violations


def test_every_command_of_the_table_exists() -> None:
    from typer.main import get_command

    from dynsplines.cli import app

    names = set(get_command(app).commands)  # type: ignore[attr-defined]
    for command in re.findall(r"`dynsplines ([a-z]+)", README + COMMANDS):
        assert command in names, command
