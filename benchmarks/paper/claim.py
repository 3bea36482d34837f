"""Claim: a statement of the paper, with the measurement here and the criterion that decides between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from rich.console import Group
from rich.table import Table
from rich.text import Text


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


def table(claims: Sequence[Claim]) -> Group:
    """Claims for a terminal of 80 columns or more: the verdict, then the claim, and below it what it rests on."""
    reproduced = sum(claim.reproduced for claim in claims)
    out = Table(box=None, show_header=False, padding=(0, 2, 1, 0))
    out.add_column("verdict", no_wrap=True)
    out.add_column("claim", ratio=1)
    for claim in claims:
        verdict = Text(claim.verdict, style="green" if claim.reproduced else "red")
        out.add_row(verdict, Group(Text(claim.text, style="bold"), _details(claim)))
    title = Text(f"The paper's claims: {reproduced} of {len(claims)} reproduced", style="bold")
    return Group(title, Text("median, worst in brackets, over the sets", style="dim"), Text(), out)


def _details(claim: Claim) -> Table:
    """A line each, or several where they are long, of what stands behind a verdict."""
    out = Table.grid(padding=(0, 2, 0, 0))
    out.add_column("what", no_wrap=True, style="dim")
    out.add_column("is")
    for what, text in (
        ("paper", f"{claim.paper} ({claim.place})"),
        ("here", claim.here),
        ("if", claim.criterion),
        ("note", claim.note),
    ):
        if text:
            out.add_row(what, Text(text, style="dim" if what in ("if", "note") else ""))
    return out


def as_json(claims: Sequence[Claim]) -> list[dict[str, Any]]:
    """Claims with every number of every set, ready for JSON."""
    return [{**asdict(claim), "verdict": claim.verdict} for claim in claims]
