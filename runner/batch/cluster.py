"""The Dask workers: one within this process, or those of a scheduler elsewhere.

Whoever can talk to a Dask scheduler can run any code. So the one that is started here listens to nobody: scheduler,
worker and client are in this process and pass each other objects, and what solves clips are child processes of it, at
the other end of a pipe. How to protect a scheduler elsewhere is for whoever runs it to say, in Dask's own settings.
"""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Iterator
from concurrent.futures import Future
from contextlib import ExitStack, contextmanager, suppress
from threading import Thread
from typing import cast

import dask.config
from distributed import Client, Scheduler, SpecCluster, Worker
from distributed.system import MEMORY_LIMIT
from distributed.utils import silence_logging_cmgr
from tornado.ioloop import IOLoop

from ..errors import UserError, one_line
from ..system.progress import Progress
from ..system.scratch import scratch
from ..system.workers import ctrl_c_blocked
from .crew import Crew

WITHIN = "inproc://"
CONNECT_SECONDS = 10  # [s] until a cluster that is named is told to be missing
CLOSE_SECONDS = 10  # [s] that workers have to end by themselves
BEGIN_SECONDS = 120  # [s] that a thread may need to begin, on a machine that has much else to do
CALM = {  # what Dask watches of itself every few milliseconds would cost a tenth of a small clip
    "distributed.worker.profile.enabled": False,
    "distributed.admin.tick.interval": "1s",
    "distributed.admin.system-monitor.interval": "5s",
    "distributed.admin.system-monitor.gil.enabled": False,
    "distributed.admin.low-level-log-length": 50,  # nobody reads them, and of a thousand clips they take megabytes
    "distributed.admin.large-graph-warning-threshold": "1TB",  # a clip's meshes are tens of megabytes, and have to go
}


@contextmanager
def opened(batch: str, workers: int, scheduler: str | None, progress: Progress) -> Iterator[Client]:
    """A client whose workers have a crew for the batch.

    workers    clips at a time here
    scheduler  the address of one that runs already, "tcp://host:8786"; then none are started
    """
    with ExitStack() as stack:
        with ctrl_c_blocked():  # for their threads and processes: Ctrl-C is ours alone
            stack.enter_context(dask.config.set(CALM))
            stack.enter_context(silence_logging_cmgr(logging.CRITICAL))  # what matters is told otherwise
            loop = stack.enter_context(_looping())
            address = scheduler or _local(workers, loop, stack)
            client = _connected(address, loop)
            stack.callback(client.close, timeout=CLOSE_SECONDS)
        if scheduler is not None:
            progress.say(f"Dask: {address}, {len(threads(client))} workers{_dashboard(client)}")
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


@contextmanager
def _looping() -> Iterator[IOLoop]:
    """An event loop in a thread of its own, for all parts of Dask alike.

    Dask would begin one for each, with ten seconds to do so, and leave that of a client which reaches nobody.
    """
    begun: Future[tuple[IOLoop, asyncio.Event]] = Future()

    async def life() -> None:
        over = asyncio.Event()
        begun.set_result((IOLoop.current(), over))
        await over.wait()
        asyncio.get_running_loop().set_exception_handler(lambda *_: None)  # what Dask leaves behind matters no more

    def run() -> None:
        try:
            asyncio.run(life())
        except BaseException as error:
            if begun.done():
                raise
            begun.set_exception(error)

    thread = Thread(target=run, name="Dask's event loop", daemon=True)
    thread.start()
    loop, over = begun.result(BEGIN_SECONDS)
    try:
        yield loop
    finally:
        loop.add_callback(over.set)
        thread.join(CLOSE_SECONDS)


class _Unheard:
    """What keeps a part of Dask from answering HTTP, which it does at every address of the machine."""

    def start_http_server(self, *_: object, **__: object) -> None:
        """None."""


class _Scheduler(_Unheard, Scheduler):
    """A scheduler that nobody outside this process can reach, given the transport within it."""


class _Worker(_Unheard, Worker):
    """A worker alike."""


def _local(workers: int, loop: IOLoop, stack: ExitStack) -> str:
    """The address of a scheduler in this process, with a worker of so many threads; all goes with the stack."""
    stack.enter_context(dask.config.set({"temporary-directory": str(stack.enter_context(scratch()))}))
    ours: dict[str, object] = {"protocol": WITHIN, "dashboard": False}
    worker = {"nthreads": workers, "memory_limit": MEMORY_LIMIT, **ours}
    cluster = SpecCluster(
        workers={0: {"cls": _Worker, "options": worker}},
        scheduler={"cls": _Scheduler, "options": ours},
        loop=loop,
        silence_logs=logging.CRITICAL,  # type: ignore[arg-type]
    )
    stack.callback(cluster.close, timeout=CLOSE_SECONDS)
    return str(cluster.scheduler_address)


class _Client(Client):
    """A client that closes where it cannot begin. Dask's would do so when it is collected, be its loop gone or not."""

    def __init__(self, address: str, loop: IOLoop) -> None:
        try:
            super().__init__(address, loop=loop, timeout=CONNECT_SECONDS, set_as_default=False, direct_to_workers=False)
        except BaseException:
            self.close(timeout=CLOSE_SECONDS)
            raise


def _connected(address: str, loop: IOLoop) -> Client:
    try:
        return _Client(address, loop)
    except (OSError, ValueError) as error:
        raise UserError(f"no Dask scheduler answers at '{address}': {one_line(error)}") from None


def threads(client: Client) -> dict[str, int]:
    """Of every worker."""
    return cast("dict[str, int]", client.nthreads())


def _dashboard(client: Client) -> str:
    """Where its dashboard is, if it has one."""
    services = client.scheduler_info(n_workers=0).get("services", {})
    return f", dashboard {client.dashboard_link}" if "dashboard" in services else ""
