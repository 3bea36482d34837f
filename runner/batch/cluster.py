"""The workers of a Dask cluster that runs already. They only wait: processes of theirs solve the clips.

Anyone who can reach a Dask scheduler can run any code on its workers; its protection is up to Dask's own settings.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import cast

import dask.config
from distributed import Client, Worker, WorkerPlugin, get_worker

from ..errors import UserError, one_line
from ..system.progress import Progress
from .child import Bounds, Crew, Do, Outcome
from .workers import Workers

CONNECT_SECONDS = 10  # [s] until a cluster is reported as missing
CLOSE_SECONDS = 10  # [s] that a client has to end
AHEAD = 2  # clips handed over for every thread there is: its next one is there when one is done
GONE = "the Dask scheduler is gone; the same command goes on where it stopped"
HEAVY = {"distributed.admin.large-graph-warning-threshold": "1TB"}  # a clip's meshes have to go along


class _Processes(WorkerPlugin):
    """Those of one worker, as many as it has threads; they end with the batch or the worker."""

    def __init__(self, name: str) -> None:
        self.name = name

    def setup(self, worker: Worker) -> None:
        memory = worker.memory_manager.memory_limit
        share = None if not memory else memory / worker.state.nthreads / 2**20
        self.crew = Crew(Path(worker.local_directory), share)

    def teardown(self, worker: Worker) -> None:
        self.crew.stop()


def _run(batch: str, do: Do, task: object, bounds: Bounds) -> Outcome:
    """At a worker: a clip by the processes of its batch."""
    worker = get_worker()
    outcome = cast(_Processes, worker.plugins[batch]).crew.run(do, task, bounds)
    return replace(outcome, worker=worker.address)


@contextmanager
def connected(address: str, batch: str, progress: Progress) -> Iterator[Workers]:
    """The workers of the scheduler at an address; raises UserError if there is none, or its workers cannot help."""
    with dask.config.set(HEAVY):
        try:
            client = Client(address, timeout=CONNECT_SECONDS, set_as_default=False, direct_to_workers=False)
        except (OSError, ValueError) as error:
            raise UserError(f"no Dask scheduler answers at '{address}': {one_line(error)}") from None
        try:
            progress.say(f"Dask: {address}, {len(client.nthreads())} workers{_dashboard(client)}")
            try:
                client.register_plugin(_Processes(batch))
            except Exception as error:
                words = f"{type(error).__name__}: {one_line(error)}"
                raise UserError(f"a worker of {address} cannot help ({words}); is dynamic-splines installed?") from None
            executor = client.get_executor(pure=False)
            try:
                yield Workers(
                    partial(executor.submit, _run, batch),
                    lambda: AHEAD * sum(client.nthreads().values()),
                    partial(_check, client),
                )
            finally:
                with suppress(Exception):  # it may be what has just ended
                    executor.shutdown(wait=False)
                    client.unregister_worker_plugin(batch)
        finally:
            client.close(timeout=CLOSE_SECONDS)


def _check(client: Client) -> None:
    if client.status != "running":
        raise UserError(GONE)


def _dashboard(client: Client) -> str:
    """Where its dashboard is, if it has one."""
    services = client.scheduler_info(n_workers=0).get("services", {})
    return f", dashboard {client.dashboard_link}" if "dashboard" in services else ""
