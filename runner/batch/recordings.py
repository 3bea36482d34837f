"""A batch of recordings: its options, and its measurements before and after, with the worst recordings first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from rich.table import Table
from rich.text import Text

from dynsplines import models

from ..errors import UserError, unknown
from ..exchange.skeleton.maps import map_of
from ..system.progress import Progress
from ..system.quantity import length
from .manifest import Entry
from .task import Cleaning

if TYPE_CHECKING:
    from .dispatch import Tally

WORST = 10  # maximum number of listed recordings


def asked(
    *,
    clean: bool,
    onto: str | None,
    figure: str | None,
    map_file: Path | None,
    kind: str | None,
    scene: Path | None,
    within: str | float | None,
) -> Cleaning | None:
    """Return the cleaning options of the command; None for clips. Raises UserError for contradicting options."""
    if clean and onto is not None:
        raise UserError("--clean and --retarget: give one of them; --retarget also cleans")
    more = {"--figure": figure, "--map": map_file, "--from": kind, "--scene": scene, "--max-displacement": within}
    options = [name for name, value in more.items() if value is not None]
    if not clean and onto is None:
        if options:
            raise UserError(f"{' and '.join(options)}: of recordings; give --clean or --retarget MODEL, too")
        return None
    if onto is not None and figure is not None:
        raise UserError(f"--figure {figure}: the figure is the one to --retarget to, '{onto}'")
    map_file = map_of(map_file)
    if clean and map_file is not None:
        raise UserError("--map: a bone map is used for retargeting only; add --retarget MODEL")
    model = onto if onto is not None else figure
    if model is not None and model not in models.figures() and not Path(model).is_file():
        raise UserError(f"no file '{model}'" if Path(model).suffix else unknown("figure", model, models.figures()))
    for word, place in (("--scene", scene), ("--map", map_file)):
        if place is not None and not place.is_file():
            raise UserError(f"{word}: no file '{place}'")
    bound = None if within is None else length(within, "--max-displacement")
    of_scene, of_map = (None if place is None else str(place) for place in (scene, map_file))
    return Cleaning(model, of_scene, of_map, kind, bound, onto is not None)


def tell(tally: Tally, progress: Progress) -> None:
    """Report the results of all recordings, and the worst ten."""
    if any(entry.figures for entry in tally.good):
        progress.console.print(table(tally.good))
    for line in worst(tally.wrong):
        progress.say(line)


def table(good: Iterable[Entry]) -> Table:
    """Return a table of all measurements, before and after, of the median recording and the worst."""
    measured = [entry for entry in good if entry.figures]
    out = Table(box=None, pad_edge=False)
    for heading in (f"{len(measured)} recordings", "median before", "after", "worst before", "after"):
        out.add_column(heading, justify="right" if out.columns else "left")
    for says in dict.fromkeys(name for entry in measured for name in entry.figures):
        pairs = np.array([entry.figures[says] for entry in measured if says in entry.figures], float)
        shown = [*np.median(pairs, axis=0), *pairs.max(axis=0)]
        out.add_row(Text(says), *(f"{value:.3g}" for value in shown))
    return out


def worst(wrong: Iterable[Entry]) -> Iterator[str]:
    """Yield a line for each recording with violations, up to ten, in the order of `wrong`."""
    wrong = list(wrong)
    for entry in wrong[:WORST]:
        yield f"{entry.clip}: {'; '.join(violation['text'] for violation in entry.violations)}"
    if len(wrong) > WORST:
        yield f"... and {len(wrong) - WORST} more with violations; the manifest has them all"
