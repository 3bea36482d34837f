"""Dask's parts here: what they begin ends with them."""

from __future__ import annotations

import gc
import io
import threading

import pytest
from rich.console import Console

pytest.importorskip("distributed")

from dynsplines import UserError
from dynsplines.batch import cluster
from dynsplines.system.progress import Progress


def quiet() -> Progress:
    return Progress(Console(file=io.StringIO()))


def loops() -> list[str]:
    """The threads in which an event loop runs."""
    return [thread.name for thread in threading.enumerate() if "loop" in thread.name.lower()]


def test_scheduler_worker_and_client_share_one_loop_which_ends_with_them() -> None:
    before = loops()
    with cluster.opened("batch", 1, None, quiet()) as client:
        assert len(loops()) == len(before) + 1
        assert client.submit(sum, [1, 2]).result(timeout=60) == 3
    assert loops() == before


def test_heavy_meshes_go_without_a_word(recwarn: pytest.WarningsRecorder) -> None:
    with cluster.opened("batch", 1, None, quiet()) as client:
        assert client.submit(len, bytes(11_000_000)).result(timeout=60) == 11_000_000
    assert not [str(warning.message) for warning in recwarn if "large graph" in str(warning.message)]


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "tpc://127.0.0.1:9"])  # 9: "discard", where nobody listens
def test_a_scheduler_that_does_not_answer_leaves_nothing_behind(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 0.2)
    before = loops()
    told = f"no Dask scheduler answers at '{address}'"
    with pytest.raises(UserError, match=told), cluster.opened("batch", 1, address, quiet()):
        pytest.fail("there is one")
    assert loops() == before
    gc.collect()  # pytest fails a test in which a finaliser does


def test_a_loop_that_cannot_begin_tells_why(monkeypatch: pytest.MonkeyPatch) -> None:
    def run(coroutine: object) -> None:
        coroutine.close()  # type: ignore[attr-defined]
        raise OSError("no more files")

    monkeypatch.setattr(cluster.asyncio, "run", run)
    with pytest.raises(OSError, match="no more files"), cluster.opened("batch", 1, None, quiet()):
        pytest.fail("there is one")
