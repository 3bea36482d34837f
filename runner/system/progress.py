"""Live progress of long work: a bar on a terminal, plain lines elsewhere, always on stderr."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Self, TypeVar

from rich.console import Console

if TYPE_CHECKING:
    from rich.progress import Progress as Bars

Item = TypeVar("Item")
QUIET_SECONDS = 5.0  # [s] interval of lines if there is no terminal for a bar


class Progress:
    """Reports the progress of work.

    with Progress() as progress:
        progress.report("renderer: EGL")
        progress.step("solving", 0.3, "E 2.41")
        for frame in progress.over(frames, "rendering", 80): ...
    """

    def __init__(self, console: Console | None = None) -> None:
        self.console = console or Console(stderr=True, highlight=False)
        self._bars: Bars | None = None
        self._tasks: dict[str, object] = {}
        self._last = 0.0

    def __enter__(self) -> Self:
        if self.console.is_terminal:
            from rich.progress import BarColumn, TextColumn, TimeElapsedColumn  # only here: for bars
            from rich.progress import Progress as Bars

            columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[note]}"))
            self._bars = Bars(*columns, TimeElapsedColumn(), console=self.console)
            self._bars.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bars is not None:
            self._bars.stop()

    def report(self, line: str) -> None:
        self.console.print(line, markup=False, soft_wrap=True)

    def step(self, work: str, share: float | None, note: str = "", *, force: bool = False) -> None:
        """Set the progress of `work` to `share` (0 to 1, None: unknown)."""
        if self._bars is not None:
            if work not in self._tasks:
                self._tasks[work] = self._bars.add_task(work, total=None if share is None else 1.0, note="")
            self._bars.update(self._tasks[work], completed=share, note=note)  # type: ignore[arg-type]
        elif force or time.monotonic() - self._last > QUIET_SECONDS:
            self._last = time.monotonic()
            done = "" if share is None else f" {share:4.0%}"
            self.report(f"{work}{done} {note}".rstrip())

    def over(self, items: Iterable[Item], work: str, count: int) -> Iterator[Item]:
        for i, item in enumerate(items):
            yield item
            self.step(work, (i + 1) / max(count, 1), f"{i + 1} of {count}", force=i + 1 == count)


def silent() -> Progress:
    """Return a progress that prints nothing."""
    return Progress(Console(quiet=True))
