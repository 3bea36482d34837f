"""At every Dask worker: processes that solve clips, as many as it has threads. The worker itself only waits."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, cast

from distributed import Worker, WorkerPlugin, get_worker

from .bounded import Bounded, Bounds, Outcome
from .solving import prepared

if TYPE_CHECKING:
    from .bounded import Do


class Crew(WorkerPlugin):
    """A worker's processes, for one batch; they go when the batch is over or the worker closes."""

    def __init__(self, name: str) -> None:
        self.name = name

    def setup(self, worker: Worker) -> None:
        self._lock = threading.Lock()
        self._busy: list[Bounded] = []
        self._idle: list[Bounded] = []
        self._over = False
        self._folder = Path(worker.local_directory)
        memory = worker.memory_manager.memory_limit
        self._share = None if not memory else memory / worker.state.nthreads / 2**20

    def teardown(self, worker: Worker) -> None:
        with self._lock:
            self._over = True
            for each in self._idle:
                each.stop()
            for each in self._busy:
                each.interrupt()

    def run(self, do: Do, task: object, bounds: Bounds) -> Outcome:
        """By a process that has nothing else to do."""
        if bounds.megabytes is None:
            bounds = replace(bounds, megabytes=self._share)
        with self._lock:
            if self._over:
                return Outcome(0.0, cause="lost", error="the batch is over")
            one = self._idle.pop() if self._idle else Bounded(self._folder, prepared)
            self._busy.append(one)
        try:
            return one.run(do, task, bounds)
        finally:
            with self._lock:
                self._busy.remove(one)
                if self._over:
                    one.stop()
                else:
                    self._idle.append(one)


def work(batch: str, clip: str, do: Do, task: object, bounds: Bounds) -> Outcome:
    """What Dask calls: tells that the clip has begun, and has it done by the worker's crew of that batch."""
    worker = get_worker()
    worker.log_event(batch, {"clip": clip, "worker": worker.address})
    return cast(Crew, worker.plugins[batch]).run(do, task, bounds)
