"""The verb: every clip is solved once, few are under way at a time, and what becomes of each is written down."""

from __future__ import annotations

import time
import uuid
from collections import deque
from collections.abc import Mapping
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath

from ..errors import UserError, one_line
from ..exchange import formats
from ..scene.outside import is_allowed, lies_in
from ..system.output import Replacement, clear_below
from ..system.progress import Progress
from .child import Bounds, Do, Outcome
from .inputs import files_of, sources
from .lock import Lock
from .manifest import Entry, Manifest, check_below, digest_of
from .plan import Clip, Options, Plan, planned
from .solving import solved
from .task import NPZ, Product, Task, program
from .workers import Workers, opened

TRIES = 3  # of a clip whose process or worker goes away, in one run

TICK_SECONDS = 0.5  # [s] between looks at the folder and the workers


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
                with opened(options.workers, options.scheduler, batch, progress) as workers:
                    _Dispatch(workers, manifest, plan, options, bounds, progress, do).all()
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
    """Hands clips to the workers and takes what comes back."""

    def __init__(
        self,
        workers: Workers,
        manifest: Manifest,
        plan: Plan,
        options: Options,
        bounds: Bounds,
        progress: Progress,
        do: Do,
    ) -> None:
        self.workers, self.manifest, self.plan = workers, manifest, plan
        self.options, self.bounds, self.progress, self.do = options, bounds, progress, do
        self.folder = manifest.path.parent
        self.waiting = deque(plan.left)
        self.flying: dict[Future[Outcome], Clip] = {}
        self.tries: dict[str, int] = {}
        self.written = {name: digest for e in manifest.entries.values() for name, digest in _files(e).items()}
        self.solved = self.failed = 0
        self.begin = time.monotonic()

    def all(self) -> None:
        """Until every clip is done or has failed; raises UserError if the workers go away."""
        while self.waiting or self.flying:
            if not self.manifest.path.exists():
                raise UserError(f"'{self.folder}' or its manifest has been removed; the same command begins anew")
            self.workers.check()
            places = self.workers.count()
            while self.waiting and len(self.flying) < max(places, 1):
                self._submit(self.waiting.popleft())
            self._tell(places)
            done, _ = wait(self.flying, TICK_SECONDS, FIRST_COMPLETED)
            for future in done:
                self._finished(self.flying.pop(future), future)
        self._tell(1, force=True)

    def _submit(self, clip: Clip) -> None:
        try:
            check_below(self.folder, f"{clip.name}{self.options.ending}")
            files = files_of(clip.source, self.plan.figures, self.options.cleaning)
        except UserError as error:
            self._failed(clip, Outcome(cause="error", error=one_line(error)))
            return
        except OSError as error:
            words = f"'{error.filename}': {error.strerror}" if error.filename else str(error.strerror or error)
            self._failed(clip, Outcome(cause="error", error=one_line(words)))
            return
        options, entry = self.options, self.manifest.entries[clip.name]
        task = Task(files, options.to, options.fps, options.report, program(), is_allowed(), options.cleaning)
        self.tries[clip.name] = self.tries.get(clip.name, 0) + 1
        future = self.workers.submit(self.do, task, self.bounds)
        self.flying[future] = clip
        digest = options.digest(files)  # it may have changed since it was queued
        begun = replace(entry, input=digest, state="running", attempts=entry.attempts + 1)
        self.manifest.record([begun], firmly=False)

    def _finished(self, clip: Clip, future: Future[Outcome]) -> None:
        try:
            outcome = future.result()
        except (Exception, CancelledError) as error:  # of Dask's: its workers, or the scheduler, ended
            self.workers.check()
            outcome = Outcome(cause="lost", error=f"{type(error).__name__}: {one_line(error)}")
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
            worker=outcome.worker,
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

    def _tell(self, places: int, *, force: bool = False) -> None:
        over, spent = self.solved + self.failed, time.monotonic() - self.begin
        total = len(self.plan.left)
        note = f"{self.solved} done, {self.failed} failed, {len(self.flying)} running of {total}"
        if over:
            left = round((total - over) * spent / over)
            rate = over / spent
            pace = f"{rate:.1f} clips/s" if rate >= 1 else f"{1 / rate:.1f} s a clip"
            note += f", {pace}, {left // 3600}:{left // 60 % 60:02}:{left % 60:02} left"
        elif not places:
            note += ", no workers yet"
        self.progress.step("batch", over / total, note, force=force)
