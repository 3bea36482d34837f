"""What every section shares: alternating clocks, optional peers, and a section's table with its targets."""

from __future__ import annotations

import gc
import importlib
import math
import statistics
import sys
import time
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pinned as pinned

from dynsplines import models

NOT_INSTALLED = "not installed (pip install '.[bench]')"
CLIP = "run_and_step"
COMMAND = "import sys; from dynsplines.cli import main; sys.argv = ['dynsplines', *sys.argv[1:]]; main()"
REPEATS = 5
QUICK_REPEATS = 2


def people() -> list[str]:
    """The clips that ship whose figure is the human, but for those that edit others."""
    return [name for name in models.clips() if _is_keyed(tomllib.loads(models.clip_text(name)))]


def _is_keyed(clip: dict[str, Any]) -> bool:
    return clip["figure"] == "human" and "recording" not in clip


@dataclass(frozen=True)
class Effort:
    """Amount of a section to run, and the receiver of progress.

    quick    a small share of the sets and repeats: shows that everything runs, gives no figures to quote
    report   receives a line on the present measurement
    """

    quick: bool = False
    report: Callable[[str], None] = print

    def count(self, full: int, quick: int) -> int:
        """The number of key sets, or of other items to measure."""
        return quick if self.quick else full

    @property
    def repeats(self) -> int:
        """Repeats of every timing."""
        return QUICK_REPEATS if self.quick else REPEATS


@dataclass(frozen=True)
class Target:
    """A target: `value` is to be at most (or at least) `limit`; None: it could not be measured."""

    what: str
    value: float | None
    limit: float
    least: bool = False
    unit: str = ""

    @property
    def met(self) -> bool | None:
        if self.value is None or not math.isfinite(self.value):
            return None if self.value is None else False
        return self.value >= self.limit if self.least else self.value <= self.limit


@dataclass
class Section:
    """One comparison: a table, the targets it is held to, notes on what differs, and every raw figure.

    rows   cells by column; numbers are written with four digits, texts as they are
    data   what the table was made from, for results.json
    """

    title: str
    columns: tuple[str, ...]
    rows: list[tuple[Any, ...]] = field(default_factory=list)
    targets: list[Target] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    data: dict[str, Any] = field(default_factory=dict)

    def add(self, *cells: Any) -> None:
        """One row."""
        self.rows.append(cells)


def peer(name: str) -> Any | None:
    """An optional package's module, or None if it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def dynsplines(*arguments: str) -> list[str]:
    """The installed command, or its function where it is not next to this Python."""
    script = Path(sys.executable).parent / "dynsplines"
    return [str(script), *arguments] if script.exists() else [sys.executable, "-c", COMMAND, *arguments]


def seconds(work: Callable[[], Any]) -> tuple[float, Any]:
    """The duration of a call [s], and its result."""
    begin = time.perf_counter()
    result = work()
    return time.perf_counter() - begin, result


def alternated(
    works: Mapping[str, Callable[[], Any]], repeats: int, *, warm: bool = True
) -> tuple[dict[str, list[float]], dict[str, Any]]:
    """Times [s] of several pieces of work in turn, A B A B …, and what each gave last.

    warm  run each once before, off the clock
    """
    results = {name: work() for name, work in works.items()} if warm else {}
    times: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(repeats):
        for name, work in works.items():
            gc.collect()
            spent, results[name] = seconds(work)
            times[name].append(spent)
    return times, results


def median(values: Sequence[float]) -> float:
    """The median; NaN of nothing."""
    return statistics.median(values) if len(values) else math.nan


def worst(values: Sequence[float]) -> float:
    """The largest; NaN of nothing."""
    return max(values, default=math.nan)
