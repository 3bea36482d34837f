"""All the paper's figures that show a result, drawn into a folder, each with its caption in words of our own.

Figures 6, 11 and 12 are of the clip `run_and_step`; 7, 9 and 10 of `tumble`, one run through seven orientations as in
the paper. All numbers in captions are measured on the figure's motion.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from PIL import Image

from dynsplines import solving
from dynsplines.errors import UserError
from dynsplines.motion import Saved
from dynsplines.picture.graphics import Graphics
from dynsplines.solver.curve.frame import Frame
from dynsplines.system import signals
from dynsplines.system.output import Replacement
from dynsplines.system.progress import Progress

from ..clips import loaded
from . import charts, scenes
from .captioned import Picture, captioned
from .scenes import Dip

RUNNER, TUMBLER = "run_and_step", "tumble"
MILLIMETRES = 1000.0  # a metre


@dataclass(frozen=True)
class Drawn:
    """A figure as drawn: its number, the file, and its caption."""

    number: int
    file: Path
    caption: str

    @property
    def as_json(self) -> dict[str, Any]:
        return {"figure": self.number, "file": str(self.file), "caption": self.caption}


def check_folder(folder: Path) -> None:
    """Raises UserError unless figures can be put into a folder, which need not be there yet."""
    if folder.exists() and not folder.is_dir():
        raise UserError(f"--figures {folder}: it is a file; name a folder")
    there = next(parent for parent in (folder, *folder.absolute().parents) if parent.is_dir())
    if not os.access(there, os.W_OK | os.X_OK):
        raise UserError(f"--figures {folder}: the folder '{there}' is not writable")


def draw(folder: Path, graphics: Graphics, progress: Progress) -> list[Drawn]:
    """figure_6.png to figure_12.png in a folder, which is made if it is not there."""
    check_folder(folder)
    folder.mkdir(parents=True, exist_ok=True)
    results, done = Results(graphics, progress), []
    for i, (number, figure) in enumerate(FIGURES.items()):
        progress.step("drawing", i / len(FIGURES), f"figure {number}", force=True)
        picture, caption = figure(results)
        target = folder / f"figure_{number}.png"
        with Replacement(target) as temporary:
            Image.fromarray(captioned(picture, f"Figure {number}", caption)).save(
                temporary, format="PNG", optimize=True
            )
        done.append(Drawn(number, target, caption))
    progress.step("drawing", 1.0, f"{len(done)} figures", force=True)
    return done


class Results:
    """The two clips, solved once each, and data shared by several figures."""

    def __init__(self, graphics: Graphics, progress: Progress) -> None:
        self.graphics, self.progress = graphics, progress

    @cached_property
    def runner(self) -> Saved:
        return self._solved(RUNNER)

    @cached_property
    def tumbler(self) -> Saved:
        return self._solved(TUMBLER)

    @cached_property
    def orientations(self) -> list[Frame]:
        """The tumbling body's keyframes, without positions: the translation is for clarity only."""
        saved = self.tumbler
        (columns,) = saved.figure.tables.quaternion_columns.T
        return [Frame.key(key.time, key.state[columns]) for key in saved.keys]

    @cached_property
    def dip(self) -> Dip:
        """The deepest point of the raw spline in the step."""
        return Dip.of(self.runner, self.runner.raw)

    def _solved(self, name: str) -> Saved:
        motion = solving.solve(loaded(name), self.progress)
        if signals.was_received():  # a search that is cut short is no result
            raise KeyboardInterrupt
        return motion


Figure = tuple[Picture, str]


def _figure_6(results: Results) -> Figure:
    saved = results.runner
    return scenes.path_of_frames(saved, results.graphics), (
        f"A figure of {saved.figure.model.nv} degrees of freedom runs and jumps on to a step. Its {len(saved.keys)} "
        f"keyframes are drawn darkest, the {saved.timeline.variable_count} variable frames that the search has put "
        "between them less dark, and the in-betweens of the spline through both lightest."
    )


def _figure_7(results: Results) -> Figure:
    saved = results.tumbler
    return scenes.turning_body(saved, results.graphics), (
        f"A path of least covariant acceleration through {len(saved.keys)} orientations of one body. Bright: the "
        "keyframes; faint: the variable frames and in-betweens. The body travels from left to right only so that "
        "each orientation can be seen beside the one before."
    )


def _figure_9(results: Results) -> Figure:
    lengths = charts.Lengths.of(results.orientations)
    return charts.draw_lengths(lengths, results.orientations), lengths.caption


def _figure_10(results: Results) -> Figure:
    deviations = charts.Deviations.of(results.orientations)
    return charts.draw_deviations(deviations), deviations.caption


def _figure_11(results: Results) -> Figure:
    saved, dip = results.runner, results.dip
    picture = scenes.keyframes_and_sample(saved, saved.raw, dip, results.graphics)
    return picture, (
        f"Before: the keyframes of figure 6, faint, and the raw spline through them {dip.time:.2f} s into the clip, "
        f"solid. A foot passes through the step, {MILLIMETRES * dip.depth:.0f} mm deep; in the corner from nearby, "
        "and from where it can be seen."
    )


def _figure_12(results: Results) -> Figure:
    saved, dip = results.runner, results.dip
    picture = scenes.keyframes_and_sample(saved, saved.timeline, dip, results.graphics)
    deepest = scenes.looked_at(saved, saved.timeline).deepest
    return picture, (
        f"After: the same keyframes and the same time, {dip.time:.2f} s, once the path between is optimised. The soft "
        f"constraints have lifted the foot out of the step; nothing is more than {MILLIMETRES * deepest:.1f} mm in it "
        "or in the floor, all the way."
    )


FIGURES: dict[int, Callable[[Results], Figure]] = {
    6: _figure_6,
    7: _figure_7,
    9: _figure_9,
    10: _figure_10,
    11: _figure_11,
    12: _figure_12,
}
