"""Samples without numbers: refused by `import`, left out and bridged where a recording is cleaned."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
import shipped
from rich.console import Console

from dynsplines import UserError
from dynsplines.exchange import formats, gaps
from dynsplines.exchange.motion_import import import_recording, read_recording
from dynsplines.system.progress import Progress


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A walk of 30 images a second, the third to fifth of which hold no numbers, in several formats."""
    folder = tmp_path_factory.mktemp("gaps")
    walk = shipped.solved("walk_loop").saved(Progress(), with_report=False)
    formats.export(walk, "bvh", folder / "whole.bvh", fps=30)
    head, rows = (folder / "whole.bvh").read_text(encoding="utf-8").split("Frame Time")
    lines = rows.splitlines()
    for i in (3, 4, 5):
        words = lines[i].split()
        lines[i] = " ".join(["nan", *words[1:4], "inf", *words[5:]])
    (folder / "torn.bvh").write_text(f"{head}Frame Time{chr(10).join(lines)}\n", encoding="utf-8")
    formats.export(walk, "csv", folder / "whole.csv", fps=30)
    table = (folder / "whole.csv").read_text(encoding="utf-8").splitlines()
    for i in (3, 4, 5):
        words = table[i].split(",")
        table[i] = ",".join([words[0], "nan", *words[2:]])
    (folder / "torn.csv").write_text("\n".join(table) + "\n", encoding="utf-8")
    formats.export(walk, "npz", folder / "whole.qpos.npz", fps=30)
    with np.load(folder / "whole.qpos.npz") as file:
        arrays = dict(file)
    arrays["qpos"][2:5, 7] = np.nan
    np.savez(folder / "torn.qpos.npz", **arrays)
    return folder


FILES = ["bvh", "qpos.npz"]


@pytest.mark.parametrize("ending", [*FILES, "csv"])
def test_import_refuses_them(folder: Path, ending: str) -> None:
    with pytest.raises(UserError, match=r"finite"):
        import_recording(folder / f"torn.{ending}", figure="human")


@pytest.mark.parametrize("ending", FILES)
def test_they_are_left_out_with_a_note_and_the_others_are_as_they_were(folder: Path, ending: str) -> None:
    whole, text = read_recording(folder / f"whole.{ending}", figure="human"), io.StringIO()
    with gaps.allowed():
        progress = Progress(Console(file=text, width=200))
        torn = read_recording(folder / f"torn.{ending}", figure="human", progress=progress)
    assert "note: 3 samples lack some or all numbers, first at 0.067 s: left out as a whole" in text.getvalue()
    kept = np.delete(np.arange(whole.time.size), [2, 3, 4])
    np.testing.assert_allclose(torn.time, whole.time[kept], atol=1e-9)
    np.testing.assert_allclose(np.abs(torn.qpos), np.abs(whole.qpos[kept]), atol=1e-6)


def test_a_file_of_nothing_else_is_refused_all_the_same(folder: Path, tmp_path: Path) -> None:
    with np.load(folder / "whole.qpos.npz") as file:
        arrays = dict(file)
    arrays["qpos"][:, 7] = np.nan
    np.savez(tmp_path / "none.qpos.npz", **arrays)
    with gaps.allowed(), pytest.raises(UserError, match="'qpos': an entry is not a finite number"):
        read_recording(tmp_path / "none.qpos.npz")


def test_the_rate_is_that_of_samples_at_different_times(folder: Path, tmp_path: Path) -> None:
    head, *rows = (folder / "whole.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    (tmp_path / "twice.csv").write_text(head + "".join(2 * row for row in rows), encoding="utf-8")
    assert read_recording(tmp_path / "twice.csv", figure="human").fps == pytest.approx(30)


def test_import_keeps_repeated_samples_and_reports_them(folder: Path, tmp_path: Path) -> None:
    with np.load(folder / "whole.qpos.npz") as file:
        arrays = dict(file)
    arrays["qpos"][10:15] = arrays["qpos"][9]
    np.savez(tmp_path / "frozen.qpos.npz", **arrays)
    text = io.StringIO()
    saved = import_recording(tmp_path / "frozen.qpos.npz", figure="human", progress=Progress(Console(file=text)))
    assert len(saved.keys) == len(arrays["qpos"])
    printed = " ".join(text.getvalue().split())
    assert "note: 5 samples repeat the one before until a jump, first at 0.333 s: kept" in printed
