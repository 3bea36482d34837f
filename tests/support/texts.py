"""Models, clips and recordings that tests read as texts."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parents[1] / "data"


def read_data(name: str) -> str:
    """Return the text of a file of tests/data."""
    return (FOLDER / name).read_text(encoding="utf-8")
