"""results.json and results.md from the sections' figures."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np


def write(results: Mapping[str, Any], folder: Path) -> None:
    """Both files, whole."""
    text = json.dumps(_plain(results), indent=1, allow_nan=False)
    (folder / "results.json").write_text(text + "\n", encoding="utf-8")
    head = (
        "# Benchmarks\n\nWritten by `python benchmarks/run.py`; the rules of every comparison are in its first lines.\n"
    )
    parts = [section_text(name, result) for name, result in results.items()]
    (folder / "results.md").write_text("\n".join([head, *parts]), encoding="utf-8")


def section_text(name: str, result: Mapping[str, Any]) -> str:
    """One section as markdown: table, targets, notes."""
    lines = [f"## {name}", "", result["title"] + (" **Quick run: not to be quoted.**" if result["quick"] else ""), ""]
    lines += table(result["columns"], result["rows"])
    if result["targets"]:
        lines += ["", *table(("target", "here", "asked", "met"), [_target_cells(t) for t in result["targets"]])]
    lines += ["", *(f"- {note}" for note in result["notes"])]
    packages = ", ".join(f"{package} {version}" for package, version in result["versions"].items())
    lines += [f"- {result['date']}, {result['seconds']:.0f} s in all; {result['machine']}; {packages}", ""]
    return "\n".join(lines)


def table(columns: Any, rows: Any) -> list[str]:
    """A markdown table's lines."""
    lines = [f"| {' | '.join(cell(column) for column in columns)} |", "|" + "---|" * len(columns)]
    return lines + [f"| {' | '.join(cell(value) for value in row)} |" for row in rows]


def cell(value: Any) -> str:
    """A number with four digits; a text as it is, but for bars, which would split it in two."""
    if value is None:
        return "–"
    if isinstance(value, (bool, np.bool_)):
        return "yes" if value else "no"
    if isinstance(value, (float, np.floating)):
        return "–" if math.isnan(value) else f"{value:.4g}"
    return str(value).replace("|", r"\|")


def _target_cells(target: Mapping[str, Any]) -> tuple[str, str, str, str]:
    met = {True: "yes", False: "no", None: "not measured"}[target["met"]]
    unit = f" {target['unit']}" if target["unit"] else ""
    digits = f"{target['limit']:.10g}"
    places = max(4, len(digits.replace(".", "").lstrip("0")) + 1)
    value = "–" if target["value"] is None else f"{float(target['value']):.{places}g}{unit}"
    return target["what"], value, f"{'≥' if target['least'] else '≤'} {digits}{unit}", met


def _plain(value: Any) -> Any:
    """NumPy's numbers and arrays as Python's, and what is no finite number as a text: JSON has none."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, (np.ndarray, np.generic)):
        return _plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
