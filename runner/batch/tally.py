"""The results of a batch at its end, as lines, and for recordings a table of measurements before and after cleaning."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from rich.table import Table
from rich.text import Text

from ..system.progress import Progress
from .manifest import Entry

MOST_FAILURES, MOST_VIOLATIONS = 50, 10  # listed clips


@dataclass(frozen=True)
class Tally:
    """The entries of all clips of a batch at its end, and the number of clips that this run has solved."""

    entries: tuple[Entry, ...]
    solved: int

    @property
    def failed(self) -> list[Entry]:
        return sorted((entry for entry in self.entries if entry.state == "failed"), key=lambda entry: entry.clip)

    @property
    def good(self) -> list[Entry]:
        return [entry for entry in self.entries if entry.state == "done"]

    @property
    def wrong(self) -> list[Entry]:
        """Solved clips with violations, worst first, by the ratio of the worst violation to its bound."""

        def severity(entry: Entry) -> tuple[float, str]:
            return entry.violations[0]["amount"] / entry.violations[0]["bound"], entry.clip

        return sorted((entry for entry in self.good if entry.violations), key=severity, reverse=True)

    @property
    def line(self) -> str:
        unchanged = len(self.entries) - self.solved - len(self.failed)
        return f"{self.solved} solved{f', {unchanged} already there' if unchanged else ''}, {len(self.failed)} failed"

    def report(self, progress: Progress, *, are_recordings: bool) -> None:
        """Report violations and failures: the worst clip, or a table of measurements and the worst ten recordings."""
        good, wrong = self.good, self.wrong
        if are_recordings:
            if measured := [entry for entry in good if entry.figures]:
                progress.console.print(_table(measured))
            texts = [f"{entry.clip}: {'; '.join(each['text'] for each in entry.violations)}" for entry in wrong]
            lines = _first(texts, MOST_VIOLATIONS, " with violations")
        else:
            share = f"{len(wrong)} of {len(good)} clips {'has' if len(wrong) == 1 else 'have'} violations"
            lines = [f"{share}; worst: {entry.clip}: {entry.violations[0]['text']}" for entry in wrong[:1]]
        lines += _first([f"failed: {entry.clip}: {entry.error}" for entry in self.failed], MOST_FAILURES, "")
        for line in lines:
            progress.report(line)


def _first(lines: list[str], most: int, of: str) -> list[str]:
    """Return the first lines, and the number of the others."""
    more = len(lines) - most
    return [*lines[:most], *([f"... and {more} more{of}; the manifest has them all"] if more > 0 else [])]


def _table(measured: list[Entry]) -> Table:
    """Return a table of all measurements, before and after, of the median recording and the worst."""
    out = Table(box=None, pad_edge=False)
    for heading in (f"{len(measured)} recordings", "median before", "after", "worst before", "after"):
        out.add_column(heading, justify="right" if out.columns else "left")
    for name in dict.fromkeys(name for entry in measured for name in entry.figures):
        pairs = np.array([entry.figures[name] for entry in measured if name in entry.figures], float)
        out.add_row(Text(name), *(f"{value:.3g}" for value in (*np.median(pairs, axis=0), *pairs.max(axis=0))))
    return out
