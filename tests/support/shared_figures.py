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
COMPOSED = load.scene_and_figure
_figures: Cache[Figure] = Cache(MOST)
_staged: Cache[tuple[Scene, Figure]] = Cache(MOST)


def figure_of(scene: Scene, where: str, coordinates: str = "auto") -> Figure:
    return _figures.get(_key(scene, coordinates), lambda: BUILT(scene, where, coordinates))


def scene_and_figure(
    source: Parsed, figure_file: str | None = None, spec: mujoco.MjSpec | None = None
) -> tuple[Scene, Figure]:
    text = None if spec is not None else _self_contained(figure_file or source.table.figure, source.folder)
    coordinates = source.table.solve.coordinates
    if text is None:
        return _shared(*COMPOSED(source, figure_file, spec), coordinates)
    key = text, repr(source.table.scene), frozenset(row.others for row in source.table.keyframe), coordinates
    return _staged.get(key, lambda: _shared(*COMPOSED(source, figure_file), coordinates))


def _shared(scene: Scene, figure: Figure, coordinates: str) -> tuple[Scene, Figure]:
    return scene, _figures.get(_key(scene, coordinates), lambda: figure)


def _key(scene: Scene, coordinates: str) -> tuple[object, ...]:
    return scene.mjcf, tuple(sorted(scene.assets.items())), coordinates


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
    load.figure_of, load.scene_and_figure = figure_of, scene_and_figure
