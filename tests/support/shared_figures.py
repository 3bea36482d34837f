"""Equal scenes and figures are built once in a process, so that a pose which several clips have is searched once."""

from __future__ import annotations

from pathlib import Path

import mujoco

from dynsplines import models
from dynsplines.clip import load
from dynsplines.clip.parse import Parsed
from dynsplines.scene.assets import Scene
from dynsplines.solver.cache import Cache
from dynsplines.solver.figure.figure import Figure

MOST = 50  # [1] scenes, and figures, that are kept
BUILT = load.figure_of
COMPOSED = load.scene_of
_figures: Cache[Figure] = Cache(MOST)
_scenes: Cache[Scene] = Cache(MOST)


def figure_of(scene: Scene, where: str, coordinates: str = "auto") -> Figure:
    key = scene.mjcf, tuple(sorted(scene.assets.items())), coordinates
    return _figures.get(key, lambda: BUILT(scene, where, coordinates))


def scene_of(source: Parsed, figure_file: str | None = None, spec: mujoco.MjSpec | None = None) -> Scene:
    text = None if spec is not None else _self_contained(figure_file or source.table.figure, source.folder)
    if text is None:
        return COMPOSED(source, figure_file, spec)
    key = text, repr(source.table.scene), frozenset(row.model_key for row in source.table.keyframe)
    return _scenes.get(key, lambda: COMPOSED(source, figure_file))


def _self_contained(figure: str, folder: Path | None) -> str | None:
    """Return the text of a figure; None if it refers to other files, or cannot be read."""
    if figure in models.figures():
        return models.figure_text(figure)
    try:
        text = ((folder or Path()) / figure).read_text(encoding="utf-8")
    except (OSError, ValueError):
        return None
    return None if "file" in text else text


def share() -> None:
    """From here on, in whatever is loaded."""
    load.figure_of, load.scene_of = figure_of, scene_of
