"""The content of a clip's text on the page: keyframes and their entries, contacts, grasps, weights, obstacles."""

from __future__ import annotations

from typing import Any

from ..clip.build import weight_factors
from ..clip.kinds import KINDS
from ..clip.parse import chosen, table_of
from ..clip.table import ClipTable
from ..clip.text import tables


def outline(text: str, where: str) -> dict[str, Any]:
    """Return the content of a clip's text for the page. Raises UserError for an invalid clip."""
    table = table_of(text, where)
    content = tables(table)
    scene = content.get("scene", {})
    return {
        "figure": table.figure,
        "fps": table.fps,
        "keys": [{"others": "free", **row} for row in content.get("keyframe", [])],
        "contacts": content.get("contact", []),
        "grasps": content.get("grasp", []),
        "weights": weights(table, where),
        "options": {entry["kind"]: entry for entry in content.get("penalty", [])},
        "obstacles": [
            {"kind": kind, "index": index, **obstacle}
            for kind, rows in scene.items()
            for index, obstacle in enumerate([rows] if kind == "step" else rows)
        ],
        "solve": content.get("solve", {}),
        "recording": content.get("recording"),
    }


def weights(table: ClipTable, where: str) -> dict[str, float]:
    """Return the weights in the clip's text by term; for a clip with a recording, the factors."""
    if table.recording is not None:
        return weight_factors(chosen(table.penalty, where))
    listed: dict[str, float] = {}
    for name, options in chosen(table.penalty, where).items():
        kind, weight = KINDS[name], options.weight
        weights = {} if weight is None else kind.weights(options)
        for part in kind.parts:
            if part.name in weights and (not isinstance(weight, dict) or part.name in weight):
                listed[kind.term(part)] = weights[part.name]
    return listed


def kinds() -> list[dict[str, object]]:
    """Return the terms of soft constraints, one per row."""
    return [
        {"kind": kind["kind"], **part}
        for kind in (kind.described() for kind in KINDS.values())
        for part in kind["parts"]
    ]
