"""A motion drawn into a file, with every failure raised as a UserError."""

from __future__ import annotations

import contextlib
from pathlib import Path

from ..errors import UserError
from ..motion import Saved
from ..system.progress import Progress
from ..system.workers import MOST_WORKERS, cores
from . import film, show
from .graphics import Graphics
from .show import Look


def draw(
    saved: Saved, look: Look, graphics: Graphics, target: Path, max_workers: int | None, progress: Progress
) -> None:
    """Write .mp4, .webm, .gif or .png by up to `max_workers` processes; None: one, or without OpenGL one per core."""
    still = target.suffix.lower() == ".png"
    workers = max_workers or (min(cores(), MOST_WORKERS) if graphics.kind == "software" else 1)
    try:
        if look.ghosts and still:
            film.write(target, [show.figure_six(saved, look, graphics)], look.fps)
            return
        count, picks = show.image_count(saved, look, still_keys=still), None
        if still:
            picks = film.sheet_picks(count)
            count = len(picks)
        if still and count > 1:
            look = show.for_tiles(look, film.SHEET_TILE, graphics)
        drawn = show.images(saved, look, graphics, still_keys=still, workers=workers, picks=picks)
        with contextlib.closing(drawn) as images:
            film.write(target, progress.over(images, "rendering", count), look.fps)
    except ValueError as error:
        raise UserError(str(error)) from None
    except OSError as error:
        raise UserError(f"cannot write '{target}': {error.strerror or error}") from None
