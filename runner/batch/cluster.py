"""The Dask workers of a batch, as processes of this machine or as a cluster.

Anyone who can reach a Dask scheduler can run code on its workers. On this machine, it requires a certificate
that only this program and its workers have. Dask's settings must protect a cluster.
"""

from __future__ import annotations

import asyncio
import atexit
import logging
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, suppress
from tempfile import TemporaryDirectory

import cryptography  # noqa: F401  Dask needs it for certificates
import dask.config
from distributed import Client, LocalCluster
from distributed.deploy.spec import close_clusters

from ..errors import UserError, one_line
from ..system.progress import Progress
from ..system.workers import cores, ctrl_c_blocked
from .task import BatchOptions

PATIENCE_SECONDS = 10  # [s] time limit of connecting and of closing a client
CLOSING_SECONDS = 1  # [s] time limit of the end of a worker, which is then killed
SETTINGS = {
    "distributed.admin.large-graph-warning-threshold": "1TB",  # no warnings about the size of meshes
    "distributed.deploy.lost-worker-timeout": "1 day",  # after the usual 15 s, a worker is no longer restarted
    "distributed.scheduler.http.routes": [],
    "distributed.scheduler.worker-saturation": 1.0,  # a clip whose worker dies is the only one there
    "distributed.worker.http.routes": [],
    "distributed.worker.profile.enabled": False,  # its history would grow all the time
}

atexit.unregister(close_clusters)  # after Ctrl-C it would print errors of workers that are still starting


@contextmanager
def connect(options: BatchOptions, progress: Progress) -> Iterator[Client]:
    """Yield a client of the workers. Raises UserError if there are none."""
    address = options.cluster
    with (
        dask.config.set(SETTINGS),
        _local(options.workers or cores()) if address is None else nullcontext(address) as cluster,
    ):
        try:
            client = Client(cluster, timeout=PATIENCE_SECONDS, set_as_default=False, direct_to_workers=False)
        except (OSError, ValueError) as error:
            raise UserError(f"no Dask scheduler answers at '{address}': {one_line(error)}; check the address") from None
        try:
            if address is not None:
                services = client.scheduler_info(n_workers=0).get("services", {})
                dashboard = f", dashboard {client.dashboard_link}" if "dashboard" in services else ""
                threads = client.nthreads().values()
                progress.report(f"Dask: {address}, {len(threads)} workers{dashboard}")
                if max(threads, default=1) > 1:
                    raise UserError("the Dask workers have several threads; start them with --nthreads 1")
            yield client
        finally:
            client.close(timeout=PATIENCE_SECONDS)


@contextmanager
def _local(count: int) -> Iterator[LocalCluster]:
    """Start `count` worker processes, which end with the block or with this process."""
    folders = TemporaryDirectory(prefix="dynsplines-", ignore_cleanup_errors=True)
    with folders as folder, dask.config.set({"temporary-directory": folder}):
        try:
            with ctrl_c_blocked():
                cluster = LocalCluster(
                    n_workers=count,
                    threads_per_worker=1,
                    security=True,
                    dashboard_address="127.0.0.1:0",
                    scheduler_kwargs={"dashboard": False},
                    silence_logs=logging.CRITICAL,
                )
        except (OSError, RuntimeError) as error:
            raise UserError(f"the worker processes cannot be started: {one_line(error)}") from None
        try:
            yield cluster
        finally:
            with suppress(AssertionError):  # of Dask, for workers that are still starting; they end with this process
                cluster.sync(_close_workers, cluster)
                cluster.close()


async def _close_workers(cluster: LocalCluster) -> None:
    """End the workers. After Ctrl-C, each is solving a clip, and Dask would wait for it for seconds."""
    nannies = cluster.workers.values()
    await asyncio.gather(*(nanny.close(timeout=CLOSING_SECONDS) for nanny in nannies), return_exceptions=True)
