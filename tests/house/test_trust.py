"""Every promise of docs/trust.md names the file whose tests hold it, and that file is there and has tests."""

from __future__ import annotations

import re
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "trust.md"
LINK = re.compile(r"\[([\w/]+)\]\((\.\./tests/[\w/]+\.py)\)")


def rows() -> list[list[str]]:
    """The cells of every row of the page's tables, without their heads."""
    lines = [line.strip("|").split("|") for line in PAGE.read_text(encoding="utf-8").splitlines() if line[:1] == "|"]
    return [[cell.strip() for cell in cells] for cells in lines if "held by" not in cells[-1] and "---" not in cells[0]]


def test_every_promise_and_every_fault_has_its_tests():
    found = rows()
    assert len(found) > 35
    for promise, *holding in found:
        assert len(holding) == 1, promise
        links = LINK.findall(holding[0])
        assert links, promise
        for name, place in links:
            file = (PAGE.parent / place).resolve()
            assert place == f"../tests/{name}.py"
            assert re.search(r"^def test_", file.read_text(encoding="utf-8"), re.MULTILINE), place


def test_at_least_twenty_kinds_of_fault_are_named():
    text = PAGE.read_text(encoding="utf-8").partition("## When something breaks")[2].partition("\n## ")[0]
    faults = [cells[0] for cells in rows() if f"| {cells[0]} |" in text]
    kinds = [kind for fault in faults for kind in re.split(r"[,;] | or | and ", fault)]
    assert len(faults) >= 15
    assert len(kinds) >= 20
