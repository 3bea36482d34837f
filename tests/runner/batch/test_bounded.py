"""A process that solves clips is kept from clip to clip, and ended when one takes too long or too much."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import deeds
import pytest

pytest.importorskip("psutil")

import psutil

from dynsplines.batch.bounded import Bounded, Bounds

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX limits")

AMPLE = Bounds(60.0)


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Bounded]:
    """One process for all tests that do not end it."""
    bounded = Bounded(tmp_path_factory.mktemp("bounded"), deeds.ready)
    yield bounded
    bounded.stop()


def gone(number: int) -> bool:
    return not psutil.pid_exists(number) or psutil.Process(number).status() == psutil.STATUS_ZOMBIE


def test_a_process_works_on_one_clip_after_another(kept: Bounded):
    first, second = kept.run(deeds.lasts, 0.1, AMPLE), kept.run(deeds.lasts, 0.0, AMPLE)
    assert first.data == second.data == str(kept.process).encode()
    assert 0.1 <= first.seconds < 1
    assert second.seconds < 0.1


def test_errors_are_told_in_a_line_and_the_process_stays(kept: Bounded):
    before = kept.run(deeds.lasts, 0.0, AMPLE).data
    wrong = kept.run(deeds.complains, "a.toml: no\nkeyframes", AMPLE)
    assert (wrong.data, wrong.cause, wrong.error) == (None, "error", r"a.toml: no\nkeyframes")
    odd = kept.run(deeds.stumbles, None, AMPLE)
    assert odd.cause == "error"
    assert odd.error.startswith("ZeroDivisionError: of nothing (deeds.py:")
    assert kept.run(deeds.lasts, 0.0, AMPLE).data == before


def test_every_clip_finds_its_folder_empty(kept: Bounded):
    assert [kept.run(deeds.litters, None, AMPLE).data for _ in range(2)] == [b"", b""]


def test_what_asks_for_far_too_much_memory_is_refused(kept: Bounded):
    outcome = kept.run(deeds.grabs, None, Bounds(60.0, 400.0))
    assert outcome.cause == "memory"
    assert outcome.bound == 400.0
    assert outcome.error.startswith("it took more memory than 400 MB (Unable to allocate")
    assert kept.run(deeds.litters, None, AMPLE).data == b""


def test_what_takes_too_much_memory_little_by_little_is_ended(kept: Bounded):
    kept.run(deeds.lasts, 0.0, AMPLE)
    number = kept.process
    assert number is not None
    outcome = kept.run(deeds.grows, None, Bounds(60.0, 300.0))
    assert (outcome.cause, outcome.error) == ("memory", "it took more memory than 300 MB")
    assert gone(number)


def test_what_never_ends_is_ended(kept: Bounded):
    kept.run(deeds.lasts, 0.0, AMPLE)
    number = kept.process
    assert number is not None
    begin = time.monotonic()
    outcome = kept.run(deeds.hangs, None, Bounds(0.5))
    assert (outcome.cause, outcome.error, outcome.bound) == ("time", "it took longer than 0.5 s", 0.5)
    assert 0.5 <= time.monotonic() - begin < 2
    assert gone(number)


@pytest.mark.parametrize(
    ("deed", "value", "words"),
    [
        (deeds.dies, signal.SIGKILL, "its process was ended by signal 9 (Killed; too little memory?)"),
        (deeds.leaves, 3, "its process ended with code 3"),
    ],
)
def test_a_process_that_goes_by_itself_is_told(kept: Bounded, deed, value, words: str):
    outcome = kept.run(deed, value, AMPLE)
    assert (outcome.cause, outcome.error) == ("lost", words)


def test_nothing_is_left_when_it_stops(tmp_path: Path):
    bounded = Bounded(tmp_path, deeds.ready)
    bounded.run(deeds.litters, None, AMPLE)
    number = bounded.process
    assert number is not None
    bounded.stop()
    assert gone(number)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(sys.platform != "linux", reason="other systems have other allocators")
def test_what_a_clip_took_is_given_back_before_the_next(kept: Bounded):
    kept.run(deeds.lasts, 0.0, Bounds())
    assert kept.process is not None
    before = psutil.Process(kept.process).memory_info().rss
    assert kept.run(deeds.pins, None, Bounds()).data == b""
    assert psutil.Process(kept.process).memory_info().rss < before + 50e6


@pytest.mark.parametrize("after", [0.0, 0.02, 0.1, 0.3, 1.0])
def test_what_is_interrupted_at_any_moment_ends_soon_and_starts_no_other(after: float, tmp_path: Path):
    bounded, own = Bounded(tmp_path, deeds.ready), psutil.Process()
    before, found = set(own.children()), []
    thread = threading.Thread(target=lambda: found.append(bounded.run(deeds.hangs, None, AMPLE)))
    thread.start()
    time.sleep(after)
    bounded.interrupt()
    thread.join(20)
    assert [(outcome.data, outcome.cause) for outcome in found] == [(None, "lost")]
    bounded.stop()
    assert set(own.children()) <= before
    assert list(tmp_path.iterdir()) == []
