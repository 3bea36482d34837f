"""Files of every kind that strangers send, changed at random: read, or refused in one line.

A few of each; `python benchmarks/strange_files.py` tries more, in processes of their own.
"""

from pathlib import Path

import pytest
from fuzz import strange


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """With the figures that files refer to, to be worked in."""
    monkeypatch.chdir(tmp_path)
    for name, text in strange.FIGURES:
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
@pytest.mark.parametrize("name", strange.KINDS)
def test_a_file_that_is_whole_is_read_and_one_that_was_changed_is_read_or_refused(name: str, folder: Path):
    kind = strange.KINDS[name]
    (folder / name).write_bytes(kind.good())
    kind.read(folder / name)
    assert {strange.attempt(kind, seed, folder) for seed in range(kind.short)} <= {strange.READ, strange.REFUSED}
