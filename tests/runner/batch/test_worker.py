"""A process that solves clips is kept from clip to clip, and ended when one takes too long or too much."""

from __future__ import annotations

import multiprocessing
import os
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import deeds
import pytest

pytest.importorskip("psutil")

import psutil

from dynsplines.batch.worker import Pool

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX limits")

AMPLE = 60.0


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Pool]:
    """One process for all tests that do not end it."""
    pool = Pool(tmp_path_factory.mktemp("pool"))
    yield pool
    pool.stop()


def number(pool: Pool) -> int:
    """Of the process that works next."""
    return int(pool.run(deeds.lasts, 0.0, AMPLE).files["output"])


def gone(number: int) -> bool:
    return not psutil.pid_exists(number) or psutil.Process(number).status() == psutil.STATUS_ZOMBIE


def test_a_process_works_on_one_clip_after_another(kept: Pool):
    first, second = kept.run(deeds.lasts, 0.1, AMPLE), kept.run(deeds.lasts, 0.0, AMPLE)
    assert first.files == second.files != {"output": str(os.getpid()).encode()}
    assert 0.1 <= first.seconds < 1
    assert second.seconds < 0.1


def test_errors_are_reported_in_a_line_and_the_process_stays(kept: Pool):
    before = number(kept)
    wrong = kept.run(deeds.complains, "a.toml: no\nkeyframes", AMPLE)
    assert (wrong.files, wrong.cause, wrong.error) == ({}, "error", r"a.toml: no\nkeyframes")
    odd = kept.run(deeds.stumbles, None, AMPLE)
    assert odd.cause == "error"
    assert odd.error.startswith("ZeroDivisionError: of nothing (deeds.py:")
    assert number(kept) == before


def test_every_clip_finds_its_folder_empty(kept: Pool):
    assert [kept.run(deeds.litters, None, AMPLE).files["output"] for _ in range(2)] == [b"", b""]


def test_what_takes_too_much_memory_little_by_little_is_ended(kept: Pool):
    process = number(kept)
    outcome = kept.run(deeds.grows, None, 60.0, 300.0)
    assert (outcome.cause, outcome.error) == ("memory", "it took more memory than 300 MB")
    assert gone(process)


def test_what_never_ends_is_ended(kept: Pool):
    process = number(kept)
    begin = time.monotonic()
    outcome = kept.run(deeds.hangs, None, 0.5)
    assert (outcome.cause, outcome.error, outcome.bound) == ("time", "it took longer than 0.5 s", 0.5)
    assert 0.5 <= time.monotonic() - begin < 2
    assert gone(process)


def test_a_process_that_ends_by_itself_is_reported(kept: Pool):
    outcome = kept.run(deeds.leaves, 3, AMPLE)
    assert (outcome.cause, outcome.error) == ("lost", "its process ended with code 3")


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have other allocators")
def test_what_a_clip_took_is_given_back_before_the_next(kept: Pool):
    process = psutil.Process(number(kept))
    before = process.memory_info().rss
    assert not kept.run(deeds.pins, None, 60.0).cause
    assert number(kept) == process.pid
    assert process.memory_info().rss < before + 50e6


@pytest.mark.parametrize("after", [0.0, 0.1, 0.5])
def test_a_pool_that_is_stopped_at_any_moment_leaves_no_process_and_no_file(after: float, tmp_path: Path):
    pool, outcomes = Pool(tmp_path), []
    before = set(multiprocessing.active_children())
    thread = threading.Thread(target=lambda: outcomes.append(pool.run(deeds.hangs, None, AMPLE)))
    thread.start()
    time.sleep(after)
    pool.stop()
    thread.join(20)
    assert [outcome.cause for outcome in outcomes] == ["lost"]
    assert set(multiprocessing.active_children()) <= before
    assert list(tmp_path.iterdir()) == []
