"""The results of a batch at its end, as lines."""

from __future__ import annotations

from dataclasses import dataclass

from ..system.progress import Progress
from .manifest import Entry

MOST_FAILURES = 50  # listed clips


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

    def report(self, progress: Progress) -> None:
        """Report the worst violation, and failures."""
        good, wrong, failed = self.good, self.wrong, self.failed
        share = f"{len(wrong)} of {len(good)} clips {'has' if len(wrong) == 1 else 'have'} violations"
        for entry in wrong[:1]:
            progress.report(f"{share}; worst: {entry.clip}: {entry.violations[0]['text']}")
        for entry in failed[:MOST_FAILURES]:
            progress.report(f"failed: {entry.clip}: {entry.error}")
        if len(failed) > MOST_FAILURES:
            progress.report(f"... and {len(failed) - MOST_FAILURES} more; the manifest has them all")
