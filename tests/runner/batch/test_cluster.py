"""What a client of a Dask cluster prints, and that it is told of one that does not answer."""

from __future__ import annotations

import gc
import io

import pytest
from rich.console import Console

pytest.importorskip("distributed")

from distributed import LocalCluster

from dynsplines import UserError
from dynsplines.batch import cluster
from dynsplines.batch.child import Bounds
from dynsplines.batch.task import Files, Task
from dynsplines.system.progress import Progress


def quiet() -> Progress:
    return Progress(Console(file=io.StringIO()))


@pytest.mark.slow
def test_heavy_meshes_go_without_a_warning(recwarn: pytest.WarningsRecorder) -> None:
    task = Task(Files("a.toml", {"a.toml": b"", "mesh.obj": bytes(11_000_000)}))
    own = {"processes": False, "dashboard_address": None, "scheduler_kwargs": {"dashboard": False}}
    with (
        LocalCluster(n_workers=1, threads_per_worker=1, silence_logs=50, protocol="inproc", **own) as there,
        cluster.connected(there.scheduler_address, "batch", quiet()) as workers,
    ):
        outcome = workers.submit(None, task, Bounds()).result(timeout=60)  # which no process can do
        assert outcome.cause == "error"
        assert outcome.worker.startswith("inproc://")
    assert not [str(warning.message) for warning in recwarn if "large graph" in str(warning.message)]


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "tpc://127.0.0.1:9"])  # 9: "discard", where nothing listens
def test_a_scheduler_that_does_not_answer_is_named(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 0.2)
    message = f"no Dask scheduler answers at '{address}'"
    with pytest.raises(UserError, match=message), cluster.connected(address, "batch", quiet()):
        pytest.fail("there is one")
    gc.collect()  # pytest fails a test in which a finaliser does
