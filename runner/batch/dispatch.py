"""The verb: every clip is solved once, few are under way at a time, and what becomes of each is written down."""

from __future__ import annotations

import queue
import time
import uuid
from asyncio import CancelledError
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path, PurePosixPath

from distributed import Client, Future, KilledWorker
from distributed.comm.core import CommClosedError

from ..errors import UserError, one_line
from ..exchange import formats
from ..scene.outside import is_allowed, lies_in
from ..system.output import Replacement, clear_below
from ..system.progress import Progress
from .bounded import Bounds, Outcome
from .cluster import opened, threads
from .crew import work
from .inputs import files_of, sources
from .lock import Lock
from .manifest import Entry, Manifest, check_below, digest_of
from .plan import Clip, Options, Plan, planned
from .solving import solved
from .task import NPZ, Product, Task, program

Do = Callable[[Task, Path], Product]

TRIES = 3  # of a clip whose process or worker goes away, in one run
AHEAD = 2  # clips handed over for every thread there is
TICK_SECONDS = 0.5
GONE = "the Dask scheduler is gone; the same command goes on where it stopped"
GATHER_SECONDS = 60  # [s] that a result which is there may take to come over


@dataclass(frozen=True)
class Tally:
    """How a batch ended: clips solved now, clips that were already, and those that failed, now or before.

    wrong  those of the solved ones, now or before, with problems, the worst first
    good   all solved ones, now or before
    """

    solved: int
    kept: int
    failed: tuple[Entry, ...]
    wrong: tuple[Entry, ...] = ()
    good: tuple[Entry, ...] = ()

    @property
    def line(self) -> str:
        before = f", {self.kept} already there" if self.kept else ""
        return f"{self.solved} solved{before}, {len(self.failed)} failed"

    @property
    def problems(self) -> list[str]:
        """ "3 of 200 clips have problems; worst: walk: left_heel is 196 mm in the floor at 1.00 s", or no line."""
        if not self.wrong:
            return []
        many, worst = len(self.wrong), self.wrong[0]
        have = "has" if many == 1 else "have"
        text = worst.problems[0]["text"]
        return [f"{many} of {self.solved + self.kept} clips {have} problems; worst: {worst.clip}: {text}"]

    def failures(self, most: int = 50) -> list[str]:
        """A line each, of so many."""
        lines = [f"failed: {entry.clip}: {entry.error}" for entry in self.failed[:most]]
        more = len(self.failed) - most
        return [*lines, f"... and {more} more; the manifest has them all"] if more > 0 else lines


def run(
    words: list[str], folder: Path, options: Options, bounds: Bounds, progress: Progress, *, do: Do = solved
) -> Tally:
    """Solves every clip that the words name, one file each in the folder, and goes on where it once stopped.

    A clip that fails is written down and stops nothing. Ctrl-C stops; nothing is half done. Raises UserError for words
    that name no clip, and for a folder in which another batch is at work.
    """
    if options.to != NPZ:
        formats.writer(options.to)
    found = sources(words, options.listed, recordings=options.cleaning is not None)
    if options.cleaning is not None:  # what was made of recordings is none
        found = [source for source in found if source.path is None or not lies_in(source.path, folder)]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UserError(f"cannot write to '{folder}': {error.strerror}") from None
    folder = folder.resolve()
    with Lock(folder):
        clear_below(folder)
        manifest = Manifest.of(folder)
        plan = planned(found, manifest, options, bounds, progress)
        names = {clip.name for clip in plan.all}
        try:
            if plan.left:
                batch = f"dynsplines-{uuid.uuid4().hex[:12]}"
                with opened(batch, options.workers, options.scheduler, progress) as client:
                    _Dispatch(client, batch, manifest, plan, options, bounds, progress, do).all()
        finally:
            stopped = [entry for entry in manifest.entries.values() if entry.state == "running"]
            manifest.entries |= {entry.clip: replace(entry, state="queued") for entry in stopped}
            if manifest.path.exists():  # the folder may have been removed meanwhile, which is told
                manifest.rewrite()
        failed = tuple(manifest.entries[name] for name in names if manifest.entries[name].state == "failed")
        done = sum(manifest.entries[clip.name].state == "done" for clip in plan.left)
        good = [manifest.entries[name] for name in names if manifest.entries[name].state == "done"]
        wrong = sorted((entry for entry in good if entry.problems), key=_severity, reverse=True)
        failed = tuple(sorted(failed, key=lambda entry: entry.clip))
        return Tally(done, len(names) - len(failed) - done, failed, tuple(wrong), tuple(good))


def _severity(entry: Entry) -> tuple[float, str]:
    """How many times its bound the worst problem of a clip is."""
    worst = entry.problems[0]
    return worst["amount"] / worst["bound"], entry.clip


def _files(entry: Entry) -> dict[str, str]:
    """What is there of a clip that is done, by name, with its digests."""
    return {entry.output: entry.sha256, **entry.beside} if entry.state == "done" else {}


def _holds(path: Path, content: bytes) -> bool:
    """Whether a file is just this: figures' files are many motions'."""
    return path.is_file() and path.stat().st_size == len(content) and path.read_bytes() == content


class _Dispatch:
    """Hands clips to the workers and takes what comes back.

    Two kinds of events arrive from Dask's threads: a clip has been begun at a worker, and a future has finished.
    """

    def __init__(
        self,
        client: Client,
        batch: str,
        manifest: Manifest,
        plan: Plan,
        options: Options,
        bounds: Bounds,
        progress: Progress,
        do: Do,
    ) -> None:
        self.client, self.batch, self.manifest, self.plan = client, batch, manifest, plan
        self.options, self.bounds, self.progress, self.do = options, bounds, progress, do
        self.folder = manifest.path.parent
        self.waiting = deque(plan.left)
        self.flying: dict[str, tuple[Clip, Future]] = {}
        self.running: set[str] = set()
        self.tries: dict[str, int] = {}
        self.events: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self.written = {name: digest for e in manifest.entries.values() for name, digest in _files(e).items()}
        self.solved = self.failed = 0
        self.begin = time.monotonic()
        self._threads, self._asked, self._submitted = 0, -1e9, 0

    def all(self) -> None:
        """Until every clip is done or has failed; raises UserError if the scheduler goes away."""
        try:
            self.client.subscribe_topic(self.batch, self._heard)
            while self.waiting or self.flying:
                self._check_folder()
                while self.waiting and len(self.flying) < AHEAD * max(self._threads_there(), 1):
                    self._submit(self.waiting.popleft())
                self._tell()
                try:
                    self.events.get(timeout=TICK_SECONDS)()
                except queue.Empty:
                    self._check_connected()
            self._tell(force=True)
        except CommClosedError:
            raise UserError(GONE) from None
        finally:
            if self.flying and self.client.status == "running":
                self.client.cancel([future for _, future in self.flying.values()], force=True)

    def _submit(self, clip: Clip) -> None:
        try:
            check_below(self.folder, f"{clip.name}{self.options.ending}")
            files = files_of(clip.source, self.plan.figures, self.options.cleaning)
        except UserError as error:
            self._failed(clip, Outcome(0.0, cause="error", error=one_line(error)))
            return
        except OSError as error:
            words = f"'{error.filename}': {error.strerror}" if error.filename else str(error.strerror or error)
            self._failed(clip, Outcome(0.0, cause="error", error=one_line(words)))
            return
        options = self.options
        entry = self.manifest.entries[clip.name]
        digest = options.digest(files)
        self.manifest.entries[clip.name] = replace(entry, input=digest)  # it may have changed since it was queued
        task = Task(files, options.to, options.fps, options.report, program(), is_allowed(), options.cleaning)
        self.tries[clip.name] = self.tries.get(clip.name, 0) + 1
        key = f"{self.batch}-{clip.name}-{self.tries[clip.name]}"
        self._submitted += 1
        future = self.client.submit(
            work, self.batch, clip.name, self.do, task, self.bounds, key=key, pure=False, priority=-self._submitted
        )
        self.flying[clip.name] = (clip, future)
        self._listen(clip)

    def _listen(self, clip: Clip) -> None:
        self.flying[clip.name][1].add_done_callback(lambda _: self.events.put(partial(self._finished, clip)))

    def _heard(self, event: tuple[float, dict[str, str]]) -> None:
        self.events.put(partial(self._begun, event[1]["clip"], event[1]["worker"]))

    def _begun(self, name: str, worker: str) -> None:
        if name not in self.flying:
            return
        entry = self.manifest.entries[name]
        begun = replace(entry, state="running", attempts=entry.attempts + 1, worker=worker)
        self.manifest.record([begun], firmly=False)
        self.running.add(name)

    def _finished(self, clip: Clip) -> None:
        future = self.flying[clip.name][1]
        try:
            outcome: Outcome = future.result(timeout=GATHER_SECONDS)
        except TimeoutError:  # the worker that had the result has gone, and it is solved again
            self._listen(clip)
            return
        except KilledWorker as error:
            words = f"the worker went away {error.allowed_failures + 1} times, lastly {error.last_worker.address}"
            outcome = Outcome(0.0, cause="lost", error=words)
        except CommClosedError:
            raise
        except (Exception, CancelledError) as error:
            self._check_connected()
            cause = "lost" if future.cancelled() else "error"
            outcome = Outcome(0.0, cause=cause, error=f"{type(error).__name__}: {one_line(error)}")
        del self.flying[clip.name]
        self.running.discard(clip.name)
        future.release()
        if outcome.product is not None:
            self._done(clip, outcome.product, outcome)
        elif outcome.cause == "lost" and self.tries[clip.name] < TRIES:
            self.waiting.append(clip)
        else:
            self._failed(clip, outcome)

    def _done(self, clip: Clip, product: Product, outcome: Outcome) -> None:
        """What the files will be, the files, and that they are there: a manifest that says so is right.

        Whatever ends the program between the last two, the next one finds the files to be those that were meant.
        """
        output, data = f"{clip.name}{self.options.ending}", product.data
        above = PurePosixPath(clip.name).parent
        beside = {
            f"{clip.name}{name}" if name.startswith(".") else (above / name).as_posix(): content
            for name, content in product.beside.items()
        }
        try:
            self._check_beside(output, beside)
        except UserError as error:
            self._failed(clip, replace(outcome, product=None, cause="error", error=one_line(error)))
            return
        meant = replace(
            self.manifest.entries[clip.name],
            seconds=round(outcome.seconds, 3),
            output=output,
            size=len(data),
            sha256=digest_of(data),
            beside={name: digest_of(content) for name, content in beside.items()},
            problems=product.problems,
            notes=product.notes,
            figures=product.figures,
        )
        self.manifest.record([meant], firmly=False)
        for name, content in {**beside, output: data}.items():
            target = self.folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if name == output or not _holds(target, content):
                with Replacement(target) as temporary:
                    temporary.write_bytes(content)
        done = replace(meant, state="done")
        self.manifest.record([done])
        self.written |= _files(done)
        self.solved += 1

    def _check_beside(self, output: str, beside: Mapping[str, bytes]) -> None:
        """Raises UserError for a file of the figure where another clip has one of that name, or a link leads out."""
        for name, content in beside.items():
            check_below(self.folder, name)
            if self.written.get(name, digest_of(content)) != digest_of(content) or name == output:
                raise UserError(f"'{name}' is there already, and a file of this motion's figure goes there")

    def _failed(self, clip: Clip, outcome: Outcome) -> None:
        entry = self.manifest.entries[clip.name]
        failed = replace(
            entry,
            state="failed",
            seconds=round(outcome.seconds, 3),
            cause=outcome.cause,
            bound=outcome.bound,
            error=outcome.error,
        )
        self.manifest.record([failed])
        self.failed += 1

    def _threads_there(self) -> int:
        """Of all workers, asked for once in a while: they come and go."""
        if time.monotonic() - self._asked > 2 * TICK_SECONDS:
            self._threads = sum(threads(self.client).values())
            self._asked = time.monotonic()
        return self._threads

    def _check_folder(self) -> None:
        """Raises UserError if what has been done is gone."""
        if not self.manifest.path.exists():
            raise UserError(f"'{self.folder}' or its manifest has been removed; the same command begins anew")

    def _check_connected(self) -> None:
        if self.client.status != "running":
            raise UserError(GONE)

    def _tell(self, *, force: bool = False) -> None:
        over, spent = self.solved + self.failed, time.monotonic() - self.begin
        total = len(self.plan.left)
        note = f"{self.solved} done, {self.failed} failed, {len(self.running)} running of {total}"
        if over:
            left = round((total - over) * spent / over)
            rate = over / spent
            pace = f"{rate:.1f} clips/s" if rate >= 1 else f"{1 / rate:.1f} s a clip"
            note += f", {pace}, {left // 3600}:{left // 60 % 60:02}:{left % 60:02} left"
        elif not self._threads:
            note += ", no workers yet"
        self.progress.step("batch", over / total, note, force=force)
