"""HTML: a page that plays the motion without other files or network access.

The page is `player/page.html` with its style and program inserted, and the motion as JSON: poses of every body at equal
time steps, float32 in base64. The program is built from `pages/src/player` and three.js (MIT; see the head of
`player/player.js`).
"""

from __future__ import annotations

import html
import json
import re
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from dynsplines.solver.tolerances import SINGLE

from ...motion import Bodies, Sampled
from ...scene.triangles import is_still, pieces
from ..model_json import pack, visible_parts
from ..skeleton import hierarchy


def write(sampled: Sampled, path: Path) -> None:
    """Write the page as a single file."""
    path.write_text(page(sampled), encoding="utf-8")


def page(sampled: Sampled) -> str:
    """Return the complete HTML text."""
    folder = files("dynsplines.exchange") / "player"
    parts = {
        "title": html.escape(sampled.name),
        "data": json.dumps(content(sampled), separators=(",", ":")).replace("<", "\\u003c"),
        **{
            name: (folder / file).read_text(encoding="utf-8")
            for name, file in (("style", "style.css"), ("player", "player.js"))
        },
    }
    frame = (folder / "page.html").read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], frame)


def content(sampled: Sampled) -> dict[str, Any]:
    """Return the page's data; lengths in metres, z up, quaternions xyzw, times from 0."""
    model, start = sampled.model, float(sampled.time[0])
    before = Sampled.of(sampled.motion.before, sampled.fps).bodies
    changed = any(
        np.abs(getattr(before, part) - getattr(sampled.bodies, part)).max() > SINGLE
        for part in ("position", "rotation")
    )
    visible = pieces(model)
    moving = sorted({piece.body for piece in visible if not is_still(model, piece)}) or list(range(1, model.nbody))
    places = sampled.bodies.position[:, moving]
    extent = float(np.ptp(places, axis=(0, 1))[:2].max())
    return {
        "name": sampled.name,
        "fps": sampled.fps,
        "count": len(sampled.time),
        "keys": [{"time": key.time - start, "partial": not bool(np.all(key.fixed))} for key in sampled.motion.keys],
        "bodies": hierarchy.names(model),
        "after": _track(sampled.bodies),
        "before": _track(before) if changed else None,
        **visible_parts(model, 30.0 + 2 * float(np.abs(places).max())),
        "extent": extent,
        "size": float(np.linalg.norm(np.ptp(places, axis=1), axis=-1).max()) if len(moving) > 1 else 1.0,
    }


def _track(bodies: Bodies) -> dict[str, str]:
    return {"position": pack(bodies.position), "rotation": pack(hierarchy.xyzw(bodies.rotation))}
