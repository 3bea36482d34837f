"""Several processes give what one gives, in order, and however it ends none of them is left."""

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import crew
import pytest
from crew import Bench

from dynsplines.errors import UserError
from dynsplines.system.workers import in_order


@pytest.fixture(autouse=True)
def _nobody_is_left() -> Iterator[None]:
    before = multiprocessing.active_children()
    yield
    assert multiprocessing.active_children() == before


def test_one_worker_is_this_process_and_its_tool_is_closed():
    bench = Bench()
    found = list(in_order(lambda: bench, crew.squared, range(3)))
    assert [(result, owner) for result, owner, _ in found] == [(n**2, os.getpid()) for n in range(3)]
    assert not bench.is_open


def test_results_come_in_order_from_processes_that_open_one_tool_each_and_keep_it():
    found = list(in_order(Bench, crew.squared, range(9), 2))  # of which the first take longest
    assert [result for result, *_ in found] == [n**2 for n in range(9)]
    owners = {owner for _, owner, _ in found}
    assert len(owners) == 2
    assert os.getpid() not in owners
    for owner in owners:
        uses = [count for _, by, count in found if by == owner]
        assert uses == list(range(1, len(uses) + 1))


def test_no_items_give_no_results():
    assert list(in_order(Bench, crew.squared, [], 2)) == []


NEEDS_PROC = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="needs /proc")
ENDED = r"a worker process ended.* --workers 1 does without"


@pytest.mark.parametrize(
    ("make", "work", "workers", "error", "words"),
    [
        (Bench, crew.fails_at_three, 1, ValueError, r"^three is too many$"),
        (Bench, crew.fails_at_three, 2, ValueError, r"^three is too many$"),
        (crew.locked, crew.squared, 2, ValueError, "the bench is locked"),
        (Bench, crew.leaves, 2, UserError, ENDED),
    ],
)
def test_an_error_of_a_tool_or_of_its_work_is_raised_in_its_words(make, work, workers, error, words):
    with pytest.raises(error, match=words):
        list(in_order(make, work, range(100), workers))


def test_an_error_of_the_items_ends_the_workers():
    def items() -> Iterator[int]:
        yield from range(3)
        raise KeyError("no more")

    with pytest.raises(KeyError, match="no more"):
        list(in_order(Bench, crew.squared, items(), 2))


def test_a_process_that_cannot_be_started_is_reported(monkeypatch: pytest.MonkeyPatch):
    def full(*_: object) -> None:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr("multiprocessing.context.SpawnProcess.start", full)
    with pytest.raises(UserError, match="cannot be started: Resource temporarily unavailable; --workers 1"):
        list(in_order(Bench, crew.squared, range(3), 2))


def test_a_loop_that_is_left_ends_workers_in_the_middle_of_their_work():
    results = in_order(Bench, crew.squared, range(1000), 2)
    assert next(results)[0] == 0
    begin = time.monotonic()
    results.close()
    assert time.monotonic() - begin < 4


SCRIPT = """
import crew, multiprocessing, threading
from dynsplines.system.workers import in_order
def tell():
    while len(found := multiprocessing.active_children()) < 2: pass
    print(*[child.pid for child in found], flush=True)
if __name__ == "__main__":
    threading.Thread(target=tell, daemon=True).start()
    list(in_order(crew.Bench, crew.{work}, range(100), 2))
"""


@pytest.fixture
def at_work(tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[tuple[subprocess.Popen[str], list[int]]]:
    """A process with two workers, in a group of its own, and the workers' numbers."""
    path = tmp_path / "script.py"
    path.write_text(SCRIPT.format(work=request.param), encoding="utf-8")
    paths = os.pathsep.join([str(Path(crew.__file__).parent), *sys.path])
    process = subprocess.Popen(
        [sys.executable, str(path)],
        env={**os.environ, "PYTHONPATH": paths},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stdout is not None
    yield process, [int(word) for word in process.stdout.readline().split()]
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)  # workers that are left would keep its streams open, for ever
    process.communicate()


def gone(number: int) -> bool:
    """Whether a process is no more, or is waited for by nobody."""
    try:
        os.kill(number, 0)
        return Path(f"/proc/{number}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0] == "Z"
    except (ProcessLookupError, FileNotFoundError):
        return True


def assert_gone(numbers: list[int]) -> None:
    end = time.monotonic() + 20
    while not all(gone(number) for number in numbers):
        assert time.monotonic() < end, "a worker is left"
        time.sleep(0.05)


@NEEDS_PROC
@pytest.mark.parametrize("at_work", ["squared"], indirect=True)
def test_workers_go_when_their_parent_is_killed(at_work):
    process, numbers = at_work
    assert len(numbers) == 2
    process.kill()
    assert_gone(numbers)


@NEEDS_PROC
@pytest.mark.parametrize("at_work", ["lasts"], indirect=True)
def test_ctrl_c_ends_the_workers_and_only_the_parent_speaks(at_work):
    process, numbers = at_work
    os.killpg(process.pid, signal.SIGINT)
    _, said = process.communicate(timeout=20)
    assert process.returncode != 0
    assert said.count("Traceback") == 1
    assert said.splitlines()[-1] == "KeyboardInterrupt"
    assert_gone(numbers)
