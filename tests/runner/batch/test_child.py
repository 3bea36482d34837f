"""Each clip has a process of its own, which is ended when it takes too long or too much."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import deeds
import pytest

pytest.importorskip("psutil")

import psutil

from dynsplines.batch.child import Bounds, Crew, Outcome

pytestmark = pytest.mark.skipif(os.name == "nt", reason="needs POSIX limits")

AMPLE = Bounds(60.0)


@pytest.fixture(scope="module")
def crew(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Crew]:
    crew = Crew(tmp_path_factory.mktemp("crew"), None)
    yield crew
    crew.stop()


def data(outcome: Outcome) -> bytes:
    assert outcome.product is not None, outcome
    return outcome.product.data


def gone(number: int) -> bool:
    return not psutil.pid_exists(number) or psutil.Process(number).status() == psutil.STATUS_ZOMBIE


def test_each_clip_has_a_process_that_ends_with_it_and_starts_at_once(crew: Crew):
    first, second = crew.run(deeds.lasts, 0.1, AMPLE), crew.run(deeds.lasts, 0.0, AMPLE)
    assert data(first) != data(second)
    assert gone(int(data(first))) and gone(int(data(second)))
    assert 0.1 <= first.seconds < 1
    assert second.seconds < 0.1


def test_errors_are_reported_in_a_line(crew: Crew):
    wrong = crew.run(deeds.complains, "a.toml: no\nkeyframes", AMPLE)
    assert (wrong.product, wrong.cause, wrong.error) == (None, "error", r"a.toml: no\nkeyframes")
    odd = crew.run(deeds.stumbles, None, AMPLE)
    assert odd.cause == "error"
    assert odd.error.startswith("ZeroDivisionError: of nothing (deeds.py:")
    assert data(crew.run(deeds.lasts, 0.0, AMPLE))


def test_every_clip_finds_its_folder_empty(crew: Crew):
    assert [data(crew.run(deeds.litters, None, AMPLE)) for _ in range(2)] == [b"", b""]


def test_what_asks_for_far_too_much_memory_is_refused(crew: Crew):
    outcome = crew.run(deeds.grabs, None, Bounds(60.0, 400.0))
    assert outcome.cause == "memory"
    assert outcome.bound == 400.0
    assert outcome.error.startswith("it took more memory than 400 MB (Unable to allocate")
    assert data(crew.run(deeds.litters, None, AMPLE)) == b""


def test_what_takes_too_much_memory_little_by_little_is_ended(crew: Crew):
    outcome = crew.run(deeds.grows, None, Bounds(60.0, 300.0))
    assert (outcome.cause, outcome.error) == ("memory", "it took more memory than 300 MB")
    assert data(crew.run(deeds.litters, None, AMPLE)) == b""


def test_what_never_ends_is_ended(crew: Crew):
    crew.run(deeds.lasts, 0.0, AMPLE)
    before = set(psutil.Process().children(recursive=True))
    begin = time.monotonic()
    outcome = crew.run(deeds.hangs, None, Bounds(0.5))
    assert (outcome.cause, outcome.error, outcome.bound) == ("time", "it took longer than 0.5 s", 0.5)
    assert 0.5 <= time.monotonic() - begin < 2
    assert set(psutil.Process().children(recursive=True)) == before


@pytest.mark.parametrize(
    ("deed", "value", "words"),
    [
        (deeds.dies, signal.SIGKILL, "its process was ended by signal 9 (Killed; too little memory?)"),
        (deeds.leaves, 3, "its process ended with code 3"),
        (deeds.leaves_with_words, 3, "its process ended with code 3: farewell"),
    ],
)
def test_a_process_that_ends_by_itself_is_reported(crew: Crew, deed, value, words: str):
    outcome = crew.run(deed, value, AMPLE)
    assert (outcome.cause, outcome.error) == ("lost", words)


def test_a_server_that_is_killed_takes_its_clip_along_and_the_next_clip_has_another(tmp_path: Path):
    crew, own, outcomes = Crew(tmp_path, None), psutil.Process(), list[Outcome]()
    before = set(own.children())
    thread = threading.Thread(target=lambda: outcomes.append(crew.run(deeds.hangs, None, AMPLE)))
    thread.start()
    while not (family := [each for each in own.children() if each not in before and each.children()]):
        time.sleep(0.01)
    (server,), (child,) = family, family[0].children()
    server.kill()
    thread.join(20)
    assert [outcome.cause for outcome in outcomes] == ["lost"]
    psutil.wait_procs([child], 5)
    assert gone(child.pid)
    assert data(crew.run(deeds.litters, None, AMPLE)) == b""
    crew.stop()


def test_nothing_is_left_when_it_stops(tmp_path: Path):
    crew, before = Crew(tmp_path, None), set(psutil.Process().children())
    crew.run(deeds.litters, None, AMPLE)
    crew.stop()
    assert set(psutil.Process().children()) <= before
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("after", [0.0, 0.02, 0.1, 0.3, 1.0])
def test_what_is_stopped_at_any_moment_ends_soon_and_starts_no_other(after: float, tmp_path: Path):
    crew, own = Crew(tmp_path, None), psutil.Process()
    before, outcomes = set(own.children()), list[Outcome]()
    thread = threading.Thread(target=lambda: outcomes.append(crew.run(deeds.hangs, None, AMPLE)))
    thread.start()
    time.sleep(after)
    crew.stop()
    thread.join(20)
    assert [(outcome.product, outcome.cause) for outcome in outcomes] == [(None, "lost")]
    assert set(own.children()) <= before
    assert list(tmp_path.iterdir()) == []
