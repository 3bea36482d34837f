"""The assignment of clips to Dask workers: each is solved once, and its result is recorded in the manifest.

Anyone who can reach a Dask scheduler can run code on its workers. On this machine, it requires a certificate
that only this program and its workers have. Dask's settings must protect a cluster.
"""

from __future__ import annotations

import asyncio
import atexit
import logging
import time
from asyncio import CancelledError
from collections import Counter, deque
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import fields, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

import cryptography  # noqa: F401  Dask needs it for certificates
import dask.config
from distributed import Client, KilledWorker, LocalCluster, as_completed
from distributed.deploy.spec import close_clusters

from ..errors import UserError, one_line
from ..scene.file_access import is_allowed, lies_in
from ..system.output import Replacement, clear_below
from ..system.progress import Progress
from ..system.workers import AHEAD, cores, ctrl_c_blocked
from . import solving
from .inputs import Contents, InputSource, sources, task_of
from .manifest import Entry, Manifest, Tally, check_below, digest_of
from .solving import SolveTask
from .task import BatchOptions, Result

READING_EVERY = 500  # clips per line of progress
ENDED = "each worker that tried to solve it ended: a crash, or too little memory"
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


def run(
    words: list[str], folder: Path, options: BatchOptions, progress: Progress, *, solve_task: SolveTask = solving.solve
) -> Tally:
    """Solve every clip that the words name into a folder, or resume a batch there.

    A clip that fails is recorded, and the batch continues. Ctrl-C stops the batch and leaves no incomplete file. Raises
    UserError for words that name no clip, and for clips with equal output names.
    """
    clips = sources(words, options.listed, recordings=options.cleaning is not None)
    if options.cleaning is not None:  # outputs are recordings too
        clips = [source for source in clips if source.path is None or not lies_in(source.path, folder)]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UserError(f"cannot write to '{folder}': {error.strerror}") from None
    folder = folder.resolve()
    clear_below(folder)
    batch = Batch(Manifest.of(folder), options, progress, solve_task)
    batch.plan(clips)
    if batch.waiting:
        with connect(options, progress) as client:
            batch.solve(client)
    entries = batch.manifest.entries
    return Tally(tuple(entries[str(source.name)] for source in clips), batch.ended["done"])


class Batch:
    """The clips that are waiting and those that are running."""

    def __init__(self, manifest: Manifest, options: BatchOptions, progress: Progress, solve_task: SolveTask) -> None:
        self.manifest, self.options, self.progress, self.solve_task = manifest, options, progress, solve_task
        self.folder = manifest.path.parent
        self.figures: dict[Path, Contents] = {}
        self.waiting: deque[InputSource] = deque()
        self.running: dict[Any, tuple[InputSource, str]] = {}  # clips and the hashes of their inputs, by Dask's futures
        self.ended: Counter[str] = Counter()  # the number of clips of this run by their state
        done = (entry for entry in manifest.entries.values() if entry.state == "done")
        self.written = {name: value for entry in done for name, value in entry.files.items()}  # hashes of files
        self.total, self.begin = 0, time.monotonic()

    def plan(self, clips: list[InputSource]) -> None:
        """Queue every clip that is new, changed, not done, or whose output is missing.

        Raises UserError if the outputs of two clips have the same name, except for case, which some disks ignore.
        """
        recorded = {name.casefold(): entry for name, entry in self.manifest.entries.items()}
        places: dict[str, str] = {}
        for number, source in enumerate(clips, 1):
            if number % READING_EVERY == 0:
                self.progress.step("reading", number / len(clips), f"{number} of {len(clips)} clips")
            name, place = str(source.name), source.place(self.folder)
            try:
                digest = task_of(source, self.figures, self.options).digest
            except (OSError, UserError):  # reported when it is the clip's turn
                digest = ""
            other, before = places.setdefault(name.casefold(), place), recorded.get(name.casefold())
            if other == place and before is not None and before.input != digest:
                other = before.source
            if other != place:
                raise UserError(
                    f"'{other}' and '{place}' have the same output, '{name}{self.options.suffix}'; rename one of them, "
                    "name a folder that contains both, or give another -o"
                )
            if before is None or before.input != digest or not self._is_final(before):
                self.waiting.append(source)
        self.total = len(self.waiting)

    def _is_final(self, before: Entry) -> bool:
        return not self.options.retry_failed if before.state == "failed" else before.is_intact(self.folder)

    def solve(self, client: Client) -> None:
        """Solve all clips that are waiting. Raises UserError if the workers no longer exist."""
        completed = as_completed(self._submit(client), loop=client.loop)
        for future in completed:
            source, digest = self.running.pop(future)
            outcome = _outcome(future, client)
            self._finish(source, "" if outcome is None else digest, outcome or Result(ENDED))
            completed.update(self._submit(client))
            self._report_progress()
        self._report_progress(force=True)

    def _submit(self, client: Client) -> list[Any]:
        """Submit the next clips and return Dask's futures of them."""
        futures = []
        while self.waiting and len(self.running) < max(AHEAD * _worker_count(client), 1):
            source = self.waiting.popleft()
            try:
                check_below(self.folder, f"{source.name}{self.options.suffix}")
                task = task_of(source, self.figures, self.options)
            except (UserError, OSError) as error:
                where = f"'{error.filename}': " if isinstance(error, OSError) and error.filename else ""
                text = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
                self._finish(source, "", Result(one_line(f"{where}{text}")))
                continue
            digest = task.digest  # it may have changed
            task = replace(task, output=f"{source.name.name}{self.options.suffix}", allow_outside=is_allowed())
            future = client.submit(solving.outcome_of, self.solve_task, task, self.options.limit_time, pure=False)
            self.running[future] = source, digest
            futures.append(future)
        return futures

    def _finish(self, source: InputSource, digest: str, outcome: Result) -> None:
        """Write the files of a solved clip, and record its result."""
        files = {(source.name.parent / name).as_posix(): content for name, content in outcome.files.items()}
        hashes = {path: digest_of(content) for path, content in files.items()}
        try:
            self._check(list(hashes.items())[1:])
        except UserError as error:
            files, hashes, outcome = {}, {}, replace(outcome, error=one_line(error))
        for path, content in reversed(files.items()):
            _write(self.folder / path, content)
        self.written |= hashes
        result = {member.name: getattr(outcome, member.name) for member in fields(Result) if member.name != "files"}
        state: Literal["done", "failed"] = "failed" if outcome.error else "done"
        about: dict[str, Any] = {"clip": str(source.name), "source": source.place(self.folder), "input": digest}
        self.manifest.record(Entry(state=state, files=hashes, **about, **result))
        self.ended[state] += 1

    def _check(self, hashes: list[tuple[str, str]]) -> None:
        """Raise UserError if a file differs from another clip's file of its name, or a link leaves the folder."""
        for name, value in hashes:
            check_below(self.folder, name)
            if self.written.get(name, value) != value:
                raise UserError(f"'{name}' already exists, where a file of this motion's figure would be written")

    def _report_progress(self, *, force: bool = False) -> None:
        over, spent, note = self.ended.total(), time.monotonic() - self.begin, ""
        counts = f"{self.ended['done']} done, {self.ended['failed']} failed, {len(self.running)} running"
        if over:
            remaining = round((self.total - over) * spent / over)
            pace = f"{over / spent:.1f} clips/s" if over >= spent else f"{spent / over:.1f} s a clip"
            note = f", {pace}, {remaining // 3600}:{remaining // 60 % 60:02}:{remaining % 60:02} left"
        self.progress.step("batch", over / self.total, f"{counts} of {self.total}{note}", force=force)


def _outcome(future: Any, client: Client) -> Result | None:
    """Return the outcome of a clip; None if its workers ended. Raises UserError if the workers no longer exist."""
    try:
        return future.result()
    except KilledWorker:
        return None
    except (Exception, CancelledError) as error:
        _worker_count(client)
        text = f"{type(error).__name__}: {one_line(error)}"
        raise UserError(f"the Dask workers cannot solve ({text}); install dynamic-splines there") from None


def _worker_count(client: Client) -> int:
    with suppress(OSError):  # Dask reports a lost connection in several ways
        if client.status == "running":
            return len(client.nthreads())
    raise UserError("the Dask scheduler is gone; run the same command again to resume")


def _write(target: Path, content: bytes) -> None:
    """Write a file, unless it exists with this content: clips may share the files of a figure."""
    if target.is_file() and target.stat().st_size == len(content) and target.read_bytes() == content:
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    with Replacement(target) as temporary:
        temporary.write_bytes(content)


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
