"""A Dask cluster solves clips, large ones without a warning; one that does not answer is reported."""

from __future__ import annotations

from collections.abc import Iterator

import deeds
import pytest
from quiet import quiet

pytest.importorskip("distributed")

from distributed import LocalCluster

from dynsplines.batch import cluster


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Of a scheduler in this process, with a worker of two threads."""
    with LocalCluster(
        n_workers=1,
        threads_per_worker=2,
        processes=False,
        protocol="tcp://",
        host="127.0.0.1",
        dashboard_address=None,
        scheduler_kwargs={"dashboard": False},
        worker_dashboard_address=None,
        local_directory=str(tmp_path_factory.mktemp("dask")),
        silence_logs=50,
    ) as there:
        yield there.scheduler_address


def test_clips_are_solved_at_the_workers_and_heavy_meshes_go_without_a_warning(
    address: str, recwarn: pytest.WarningsRecorder
) -> None:
    with cluster.connected(address, quiet()) as workers:
        assert workers.count() == 4
        outcome = workers.submit(deeds.lasts, 0.1, 60.0).result(60)
        assert not workers.submit(deeds.litters, bytes(11_000_000), 60.0).result(60).cause
    assert not outcome.cause
    assert outcome.worker.startswith("tcp://127.0.0.1:")
    assert not [str(warning.message) for warning in recwarn if "large graph" in str(warning.message)]
