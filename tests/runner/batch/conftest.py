"""A Dask worker in the process of the tests, in place of processes that start in seconds."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import nullcontext
from typing import Any

import pytest


@pytest.fixture(scope="session")
def dask_cluster() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None, silence_logs=50
    ) as cluster:
        yield cluster


@pytest.fixture
def in_process(dask_cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every batch of a test use the one worker of this process."""
    from dynsplines.batch import cluster

    monkeypatch.setattr(cluster, "_local", lambda _: nullcontext(dask_cluster))
