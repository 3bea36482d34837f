"""Claim: something a paper says, beside what was measured here and the criterion that decides between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from rich.table import Table


@dataclass(frozen=True)
class Claim:
    """One claim of the paper beside what was measured.

    place      where the paper makes it
    here       the measurement, median and worst over the sets
    criterion  what has to hold for "reproduced"
    numbers    every measurement of every set, by name
    """

    place: str
    text: str
    paper: str
    here: str
    criterion: str
    reproduced: bool
    numbers: dict[str, list[float]]
    note: str = ""

    @property
    def verdict(self) -> str:
        return "reproduced" if self.reproduced else "not reproduced"


def table(claims: Sequence[Claim]) -> Table:
    """Claims as a table for a terminal."""
    out = Table(title="The paper's claims", show_lines=True, caption="median, worst in brackets, over the sets")
    for title in ("where", "claim", "paper", "here", "verdict"):
        out.add_column(title, ratio={"claim": 3, "paper": 2, "here": 4}.get(title))
    for claim in claims:
        style = "green" if claim.reproduced else "red"
        words = f"{claim.text}\n[dim]{claim.note}[/dim]" if claim.note else claim.text
        verdict = f"[{style}]{claim.verdict}[/{style}]"
        out.add_row(claim.place, words, claim.paper, f"{claim.here}\n[dim]if {claim.criterion}[/dim]", verdict)
    return out


def as_json(claims: Sequence[Claim]) -> list[dict[str, Any]]:
    """Claims with every number of every set, ready for JSON."""
    return [{**asdict(claim), "verdict": claim.verdict} for claim in claims]
