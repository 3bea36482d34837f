"""Figures of equal scenes are built once in a process, so that a pose which several clips have is searched once."""

from __future__ import annotations

from dynsplines.clip import load
from dynsplines.scene.assets import Scene
from dynsplines.solver.cache import Cache
from dynsplines.solver.figure.figure import Figure

MOST = 50  # [1] figures that are kept
BUILT = load.figure_of
_figures: Cache[Figure] = Cache(MOST)


def figure_of(scene: Scene, where: str, coordinates: str = "auto") -> Figure:
    key = scene.mjcf, tuple(sorted(scene.assets.items())), coordinates
    return _figures.get(key, lambda: BUILT(scene, where, coordinates))


def share() -> None:
    """From here on, in whatever is loaded."""
    load.figure_of = figure_of
