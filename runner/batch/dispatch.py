"""The assignment of clips to workers: each is solved once, few at a time, and its state is recorded in the manifest."""

from __future__ import annotations

import time
from asyncio import CancelledError
from collections import Counter, deque
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import fields, replace
from pathlib import Path, PurePosixPath

from ..errors import UserError, one_line
from ..scene.file_access import is_allowed, lies_in
from ..system.lock import locked
from ..system.output import Replacement, clear_below
from ..system.progress import Progress
from ..system.workers import cores
from .inputs import Contents, Source, sources, task_of, with_unique_names
from .manifest import Entry, Manifest, check_below, digest_of
from .solving import solved
from .tally import Tally
from .task import Options, Outcome, Result
from .worker import SolveTask, Workers, local

TRIES = 3  # attempts per run for a clip whose process or Dask worker ends
TICK_SECONDS = 0.5  # [s] interval of checks of the folder and the workers
READING_EVERY = 500  # clips per line of progress


def run(
    words: list[str], folder: Path, options: Options, progress: Progress, *, solve_task: SolveTask = solved
) -> Tally:
    """Solve every clip that the words name into a folder, or resume a batch there.

    A clip that fails is recorded, and the batch continues. Ctrl-C stops the batch and leaves no incomplete file. Raises
    UserError for words that name no clip, and for a folder that another batch uses.
    """
    clips = sources(words, options.listed, recordings=options.cleaning is not None)
    if options.cleaning is not None:  # outputs are recordings too
        clips = [source for source in clips if source.path is None or not lies_in(source.path, folder)]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UserError(f"cannot write to '{folder}': {error.strerror}") from None
    folder = folder.resolve()
    with locked(folder):
        clear_below(folder)
        batch = Batch(Manifest.of(folder), options, progress, solve_task)
        try:
            names = batch.plan(clips)
            if batch.waiting and options.scheduler is not None:
                from .cluster import connected

                with connected(options.scheduler, progress) as workers:
                    batch.solve(workers)
            elif batch.waiting:
                with local(options.workers or cores()) as workers:
                    batch.solve(workers)
        finally:
            batch.manifest.close()
        return Tally(tuple(batch.manifest.entries[name] for name in names), batch.ended["done"])


class Batch:
    """The clips that are waiting and those that are running."""

    def __init__(self, manifest: Manifest, options: Options, progress: Progress, solve_task: SolveTask) -> None:
        self.manifest, self.options, self.progress, self.solve_task = manifest, options, progress, solve_task
        self.folder = manifest.path.parent
        self.figures: dict[Path, Contents] = {}
        self.waiting: deque[tuple[str, Source]] = deque()
        self.running: dict[Future[Outcome], tuple[str, Source]] = {}
        self.ended: Counter[str] = Counter()  # the number of clips of this run by their state
        self.written: dict[str, str] = {}  # hashes of files by name
        self.total, self.begin = 0, time.monotonic()

    def plan(self, sources: list[Source]) -> list[str]:
        """Queue every clip that is new, changed, not done, or whose output is missing; return all names."""
        entries, names = self.manifest.entries, []
        clip_of = {entry.source: entry.clip for entry in entries.values()}
        new_sources = [source for source in sources if source.place(self.folder) not in clip_of]
        named = with_unique_names(new_sources, entries.keys())
        clip_of |= {source.place(self.folder): str(source.name) for source in named}
        queued = []
        for number, source in enumerate(sources, 1):
            if number % READING_EVERY == 0:
                self.progress.step("reading", number / len(sources), f"{number} of {len(sources)} clips")
            place = source.place(self.folder)
            names.append(name := clip_of[place])
            try:
                digest = task_of(source, self.figures, self.options).digest
            except (OSError, UserError):  # reported when it is the clip's turn
                digest = ""
            before = entries.get(name)
            if before is not None and before.input != digest:
                before = None
            if before is None or not self._is_final(before):
                queued.append(Entry(clip=name, source=place, input=digest))
                self.waiting.append((name, source))
        if queued:
            self.manifest.record(queued)
        self.total = len(self.waiting)
        done = (entry for entry in entries.values() if entry.state == "done")
        self.written = {name: value for entry in done for name, value in entry.files.items()}
        return names

    def _is_final(self, before: Entry) -> bool:
        """Return whether a clip is done, or would fail again: not if its process was lost, or its limit has changed."""
        if before.state != "failed":
            return before.state == "done" and before.is_intact(self.folder)
        if before.cause == "lost" or self.options.retry_failed:
            return False
        if before.cause == "time":
            return before.bound == self.options.limit_time
        return before.cause == "error" or self.options.limit_memory in (None, before.bound)

    def solve(self, workers: Workers) -> None:
        """Solve all clips that are waiting. Raises UserError if the workers or the folder no longer exist."""
        while self.waiting or self.running:
            if not self.manifest.path.exists():
                raise UserError(
                    f"'{self.folder}' or its manifest has been removed; run the same command again to restart the batch"
                )
            count = workers.count()
            while self.waiting and len(self.running) < max(count, 1):
                self._submit(*self.waiting.popleft(), workers)
            self._report_progress("" if count else ", no workers yet")
            for future in wait(self.running, TICK_SECONDS, FIRST_COMPLETED).done:
                try:
                    outcome = future.result()
                except (Exception, CancelledError) as error:  # a worker or the scheduler of Dask has ended
                    workers.count()
                    outcome = Outcome("lost", f"{type(error).__name__}: {one_line(error)}")
                name, source = self.running.pop(future)
                if outcome.cause == "lost" and self.manifest.entries[name].attempts < TRIES:
                    self.waiting.append((name, source))
                else:
                    self._finish(name, outcome)
        self._report_progress(force=True)

    def _submit(self, name: str, source: Source, workers: Workers) -> None:
        options, entry = self.options, self.manifest.entries[name]
        try:
            output = f"{name}{options.suffix}"
            check_below(self.folder, output)
            task = task_of(source, self.figures, options)
        except (UserError, OSError) as error:
            where = f"'{error.filename}': " if isinstance(error, OSError) and error.filename else ""
            text = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
            self._finish(name, Outcome("error", one_line(f"{where}{text}")))
            return
        task = replace(task, output=PurePosixPath(output).name, allow_outside=is_allowed())
        limits = options.limit_time, options.limit_memory
        self.running[workers.submit(self.solve_task, task, *limits)] = name, source
        begun = replace(entry, input=task.digest, state="running", attempts=entry.attempts + 1)  # it may have changed
        self.manifest.record([begun])

    def _finish(self, name: str, outcome: Outcome) -> None:
        """Write the files of a solved clip, and record its state."""
        above = PurePosixPath(name).parent
        files = {(above / name).as_posix(): content for name, content in outcome.files.items()}
        hashes = {path: digest_of(content) for path, content in files.items()}
        try:
            self._check(list(hashes.items())[1:])
        except UserError as error:
            files, hashes, outcome = {}, {}, replace(outcome, cause="error", error=one_line(error))
        for path, content in reversed(files.items()):
            _write(self.folder / path, content)
        self.written |= hashes
        result = {member.name: getattr(outcome, member.name) for member in fields(Result)}
        state = "failed" if outcome.cause else "done"
        done = replace(self.manifest.entries[name], state=state, files=hashes, **result)
        self.manifest.record([done])
        self.ended[done.state] += 1

    def _check(self, hashes: list[tuple[str, str]]) -> None:
        """Raise UserError if a file differs from another clip's file of its name, or a link leaves the folder."""
        for name, value in hashes:
            check_below(self.folder, name)
            if self.written.get(name, value) != value:
                raise UserError(f"'{name}' already exists, where a file of this motion's figure would be written")

    def _report_progress(self, note: str = "", *, force: bool = False) -> None:
        over, spent = self.ended.total(), time.monotonic() - self.begin
        counts = f"{self.ended['done']} done, {self.ended['failed']} failed, {len(self.running)} running"
        if over:
            remaining = round((self.total - over) * spent / over)
            pace = f"{over / spent:.1f} clips/s" if over >= spent else f"{spent / over:.1f} s a clip"
            note = f", {pace}, {remaining // 3600}:{remaining // 60 % 60:02}:{remaining % 60:02} left"
        self.progress.step("batch", over / self.total, f"{counts} of {self.total}{note}", force=force)


def _write(target: Path, content: bytes) -> None:
    """Write a file, unless it exists with this content: clips may share the files of a figure."""
    if target.is_file() and target.stat().st_size == len(content) and target.read_bytes() == content:
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    with Replacement(target) as temporary:
        temporary.write_bytes(content)
