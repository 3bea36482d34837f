"""The Dask workers: processes of this machine, or those of a scheduler elsewhere."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from typing import cast

import dask.config
from distributed import Client, LocalCluster
from distributed.utils import silence_logging_cmgr

from ..errors import UserError, one_line
from ..progress import Teller
from ..workers import ctrl_c_blocked
from .crew import Crew

CONNECT_SECONDS = 10
CLOSE_SECONDS = 10
CALM = {  # what Dask watches of itself every few milliseconds would cost a tenth of a small clip
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "1s",
    "distributed.admin.system-monitor.interval": "5s",
    "distributed.admin.system-monitor.gil.enabled": False,
}


@contextmanager
def opened(batch: str, workers: int, scheduler: str | None, teller: Teller) -> Iterator[Client]:
    """A client whose workers have a crew for the batch.

    workers    processes to start here, each with one thread
    scheduler  the address of one that runs already, "tcp://host:8786"; then none are started
    """
    with ExitStack() as stack:
        with ctrl_c_blocked():  # for their threads and processes: Ctrl-C is ours alone
            stack.enter_context(dask.config.set(CALM))
            stack.enter_context(silence_logging_cmgr(logging.CRITICAL))  # what matters is told otherwise
            address = scheduler or _local(workers, stack)
            client = _connected(address)
            stack.callback(client.close, timeout=CLOSE_SECONDS)
        if scheduler is not None:
            teller.say(f"Dask: {address}, {len(threads(client))} workers{_dashboard(client)}")
        try:
            client.register_plugin(Crew(batch))
        except Exception as error:
            words = f"{type(error).__name__}: {one_line(error)}"
            raise UserError(f"a worker of {address} cannot help ({words}); is dynamic-splines installed?") from None
        try:
            yield client
        finally:
            if scheduler is not None:
                with suppress(Exception):  # it may be what has just gone
                    client.unregister_worker_plugin(batch)


def _local(workers: int, stack: ExitStack) -> str:
    """The address of a scheduler in this process, which listens to this machine alone; it goes with the stack."""
    cluster = LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
        scheduler_kwargs={"dashboard": False},
        silence_logs=logging.CRITICAL,
    )
    stack.callback(cluster.close, timeout=CLOSE_SECONDS)
    return str(cluster.scheduler.address)  # type: ignore[union-attr]


def _connected(address: str) -> Client:
    try:
        return Client(address, timeout=CONNECT_SECONDS, set_as_default=False, direct_to_workers=False)
    except (OSError, ValueError) as error:
        raise UserError(f"no Dask scheduler answers at '{address}': {one_line(error)}") from None


def threads(client: Client) -> dict[str, int]:
    """Of every worker."""
    return cast("dict[str, int]", client.nthreads())


def _dashboard(client: Client) -> str:
    """Where its dashboard is, if it has one."""
    services = client.scheduler_info(n_workers=0).get("services", {})
    return f", dashboard {client.dashboard_link}" if "dashboard" in services else ""
