"""The options of a batch of recordings."""

from __future__ import annotations

from pathlib import Path

from dynsplines import models

from ..clean.command import Source
from ..errors import UserError, unknown
from ..exchange.skeleton.maps import map_of


def cleaning_source(
    *,
    clean: bool,
    robot: str | None,
    figure: str | None,
    map_file: Path | None,
    kind: str | None,
    scene: Path | None,
    max_displacement: float | None,
) -> Source | None:
    """Return the recording to clean, but for its file; None for clips. Raises UserError for contradicting options."""
    if clean and robot is not None:
        raise UserError("--clean and --retarget: give one of them; --retarget also cleans")
    more = {
        "--figure": figure,
        "--map": map_file,
        "--from": kind,
        "--scene": scene,
        "--max-displacement": max_displacement,
    }
    options = [name for name, value in more.items() if value is not None]
    if not clean and robot is None:
        if options:
            raise UserError(f"{' and '.join(options)}: of recordings; give --clean or --retarget MODEL, too")
        return None
    if robot is not None and figure is not None:
        raise UserError(f"--figure {figure}: the figure is the one to --retarget to, '{robot}'")
    map_file = map_of(map_file)
    if clean and map_file is not None:
        raise UserError("--map: a bone map is used for retargeting only; add --retarget MODEL")
    model = robot if robot is not None else figure
    if model is not None and model not in models.figures() and not Path(model).is_file():
        raise UserError(f"no file '{model}'" if Path(model).suffix else unknown("figure", model, models.figures()))
    for word, place in (("--scene", scene), ("--map", map_file)):
        if place is not None and not place.is_file():
            raise UserError(f"{word}: no file '{place}'")
    return Source(Path(), model, kind, scene=scene, map=map_file, avoids_self_collision=robot is not None)
