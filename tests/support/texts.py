"""Models, clips and recordings that tests read as texts."""

import tomllib
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parents[1] / "data"


def read_data(name: str) -> str:
    """Return the text of a file of tests/data."""
    return (FOLDER / name).read_text(encoding="utf-8")


def read_cases(name: str) -> list[Any]:
    """Return the rows of a table of inputs and messages in tests/data."""
    return tomllib.loads(read_data(name))["cases"]
