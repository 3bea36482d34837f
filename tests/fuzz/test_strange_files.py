"""Files of every kind that strangers send, changed at random: read, or refused in one line.

A few of each are part of the tests; DYNSPLINES_FUZZ=300 tries some 140,000 in processes of their own, in an hour
or two, and `python -m fuzz.driver KIND SEED`, in tests/, one alone.
"""

from __future__ import annotations

import os
import random
import sys
from pathlib import Path

import mujoco
import pytest
from fuzz import driver, grammar, strange
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dynsplines.clip import load as clips
from dynsplines.errors import UserError

SHARE = int(os.environ.get("DYNSPLINES_FUZZ", 0)) / 300  # of the long run
EXAMPLES = max(30, round(3000 * SHARE))
LINUX = pytest.mark.skipif(sys.platform != "linux", reason="limits of a process are another matter there")


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
    if not SHARE:
        ended = {driver.attempt(kind, seed, folder) for seed in range(kind.short)}
        assert ended <= {driver.READ, driver.REFUSED}
        return
    tally = driver.tried(name, round(kind.long * SHARE), folder)
    print(f"\n{name}: {tally.line}")
    assert not tally.bad, (tally.line, tally.bad)
    assert tally.ended[driver.READ] > 0.05 * tally.tried


@settings(
    max_examples=EXAMPLES,
    deadline=None,
    database=None,
    derandomize=not SHARE,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(draw=st.randoms(use_true_random=False))
def test_tables_of_any_shape_are_read_or_refused(draw: random.Random):
    text = grammar.table(draw)
    try:
        clips.from_text(text, name="drawn", spec=mujoco.MjSpec.from_string(grammar.tiny.FIGURE))
    except UserError as error:
        assert str(error) and "\n" not in str(error)


# what tries them

MISREAD = """
import os, sys, time
from fuzz import driver, strange
DEEDS = (lambda: 1 / 0, lambda: os.kill(os.getpid(), 11), lambda: time.sleep(100), lambda: bytearray(600_000_000))
def read(path):
    number = int(path.read_bytes())
    if number % 2:
        DEEDS[number // 2]()
strange.KINDS["odd"] = strange.Kind("odd", bytes, lambda rng: b"", read, 5, 5)
strange.seeded = lambda kind, seed: seed
object.__setattr__(strange.KINDS["odd"], "make", lambda seed: str(seed).encode())
driver.main()
"""


@pytest.mark.slow
@LINUX
def test_whatever_a_file_does_to_its_process_is_reported_and_the_others_are_tried(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    """Every second one raises, kills the process, hangs, or takes much memory."""
    monkeypatch.setattr(driver, "PROGRAM", ["-c", MISREAD])
    monkeypatch.setattr(driver, "MOST_SECONDS", 4.0)
    monkeypatch.setattr(driver, "MOST_MEGABYTES", 500.0)
    tally = driver.tried("odd", 9, tmp_path)
    told = ("ZeroDivisionError: division by zero", "the process ended with -11", "a hang: over 4 s", " MB")
    assert list(tally.bad) == [1, 3, 5, 7]
    assert all(words in tally.bad[number] for number, words in zip(tally.bad, told, strict=True)), tally.bad
    assert tally.ended[driver.READ] == 6  # those between, and the one that was read in spite of its size
    left = {path.read_bytes() for path in tmp_path.rglob("*odd") if path.is_file()}
    assert left >= {b"1", b"3", b"5"}
