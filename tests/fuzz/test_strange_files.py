"""Files of every kind that strangers send, changed at random: read, or refused in one line.

A few of each; `python benchmarks/strange_files.py` tries more, in processes of their own.
"""

from __future__ import annotations

import os
import random
from pathlib import Path

import mujoco
import pytest
from fuzz import grammar, strange
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dynsplines import recordings
from dynsplines.errors import UserError

EXAMPLES = max(30, 10 * int(os.environ.get("DYNSPLINES_FUZZ", 0)))


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


@settings(
    max_examples=EXAMPLES,
    deadline=None,
    database=None,
    derandomize=EXAMPLES == 30,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(draw=st.randoms(use_true_random=False))
def test_tables_of_any_shape_are_read_or_refused(draw: random.Random):
    text = grammar.table(draw)
    try:
        recordings.from_text(text, name="drawn", spec=mujoco.MjSpec.from_string(grammar.problems.FIGURE))
    except UserError as error:
        assert str(error) and "\n" not in str(error)
