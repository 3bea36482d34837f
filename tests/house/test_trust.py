"""Every guarantee of docs/trust.md links to a file with tests."""

from __future__ import annotations

import re
from pathlib import Path

PAGE = Path(__file__).parents[2] / "docs" / "trust.md"
LINK = re.compile(r"\[([\w/]+)\]\((\.\./tests/[\w/]+\.py)\)")


def rows() -> list[list[str]]:
    """The cells of every row of the page's tables, without their heads."""
    lines = [line.strip("|").split("|") for line in PAGE.read_text(encoding="utf-8").splitlines() if line[:1] == "|"]
    return [
        [cell.strip() for cell in cells] for cells in lines if cells[-1].strip() != "tests" and "---" not in cells[0]
    ]


def test_every_guarantee_and_every_fault_has_tests():
    guarantees = rows()
    assert len(guarantees) > 35
    for guarantee, *links_cell in guarantees:
        assert len(links_cell) == 1, guarantee
        links = LINK.findall(links_cell[0])
        assert links, guarantee
        for name, place in links:
            file = (PAGE.parent / place).resolve()
            assert place == f"../tests/{name}.py"
            assert re.search(r"^def test_", file.read_text(encoding="utf-8"), re.MULTILINE), place
