"""The workers of a Dask cluster. Each of its threads waits for a process that solves the clips.

Anyone who can reach a Dask scheduler can run code on its workers. Dask's settings must protect it.
"""

from __future__ import annotations

import uuid
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from multiprocessing import current_process
from pathlib import Path
from typing import cast

import dask.config
from distributed import Client, Worker, WorkerPlugin, get_worker

from ..errors import UserError, one_line
from ..system.progress import Progress
from .task import Outcome
from .worker import Pool, SolveTask, Workers

CONNECT_SECONDS = 10  # [s] time limit of the connection to a cluster
CLOSE_SECONDS = 10  # [s] time limit of closing a client
AHEAD = 2  # clips submitted per thread, so that the next one is available when one is done
LARGE = {"distributed.admin.large-graph-warning-threshold": "1TB"}  # no warnings about the size of meshes


class _Processes(WorkerPlugin):
    """The processes of one Dask worker, as many as it has threads. They end with the batch or the worker."""

    def __init__(self, name: str) -> None:
        self.name = name

    def setup(self, worker: Worker) -> None:
        current_process().daemon = False  # a Dask worker is a daemon, which may not start processes
        memory = worker.memory_manager.memory_limit
        share = memory / worker.state.nthreads / 2**20 if memory else None
        self.pool = Pool(Path(worker.local_directory), share)

    def teardown(self, worker: Worker) -> None:
        self.pool.stop()


def _run(batch: str, solve_task: SolveTask, task: object, seconds: float, megabytes: float | None = None) -> Outcome:
    """Run a clip at a Dask worker, in the processes for this batch."""
    worker = get_worker()
    outcome = cast(_Processes, worker.plugins[batch]).pool.run(solve_task, task, seconds, megabytes)
    return replace(outcome, worker=worker.address)


@contextmanager
def connected(address: str, progress: Progress) -> Iterator[Workers]:
    """Yield the workers of a scheduler. Raises UserError if it does not answer, or the workers lack this package."""
    batch = f"dynsplines-{uuid.uuid4().hex[:12]}"
    with dask.config.set(LARGE):
        try:
            client = Client(address, timeout=CONNECT_SECONDS, set_as_default=False, direct_to_workers=False)
        except (OSError, ValueError) as error:
            raise UserError(f"no Dask scheduler answers at '{address}': {one_line(error)}; check the address") from None
        try:
            services = client.scheduler_info(n_workers=0).get("services", {})
            dashboard = f", dashboard {client.dashboard_link}" if "dashboard" in services else ""
            progress.report(f"Dask: {address}, {len(client.nthreads())} workers{dashboard}")
            try:
                client.register_plugin(_Processes(batch))
            except Exception as error:
                text = f"{type(error).__name__}: {one_line(error)}"
                raise UserError(f"a worker of {address} cannot solve ({text}); install dynamic-splines there") from None
            executor = client.get_executor(pure=False)
            try:
                yield Workers(partial(executor.submit, _run, batch), partial(_count, client))
            finally:
                with suppress(Exception):  # the scheduler may have ended
                    executor.shutdown(wait=False)
                    client.unregister_worker_plugin(batch)
        finally:
            client.close(timeout=CLOSE_SECONDS)


def _count(client: Client) -> int:
    with suppress(OSError):  # Dask reports a lost connection in several ways
        if client.status == "running":
            return AHEAD * sum(client.nthreads().values())
    raise UserError("the Dask scheduler is gone; run the same command again to resume")
