"""A real notebook: its kernel runs the API, and a cell that ends in a motion shows the player."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_motion_plays_in_a_notebook(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    book = nbformat.v4.new_notebook()
    book.cells = [
        nbformat.v4.new_code_cell(
            "from dynsplines import Keyframe, build, inbetween\n"
            "clip = build('spinner', [Keyframe(0, others='rest'), Keyframe(1, others='previous')])\n"
            "clip"
        ),
        nbformat.v4.new_code_cell("motion = inbetween(clip)\nmotion"),
        nbformat.v4.new_code_cell("motion.report()"),
    ]
    NotebookClient(book, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    clip, motion, report = (cell.outputs[-1].data for cell in book.cells)
    assert clip["text/plain"].startswith("<Clip clip: 1.00 s, 2 keyframes")
    assert motion["text/plain"].startswith("<Motion clip: 1.00 s, 2 keyframes")
    assert motion["text/html"].startswith("<iframe")
    assert "srcdoc=" in motion["text/html"]
    assert report["text/html"].startswith("<pre>")
