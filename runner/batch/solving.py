"""The work itself, by a process that may be anywhere: the files of a clip in, the file of its motion out."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import UserError
from ..system import mujoco_warnings
from .task import NPZ, Cleaning, Product, Task, program

if TYPE_CHECKING:
    from ..motion import Saved

RESULT = ".result"  # how the output is called while it is made: no figure's file is called so


def prepared() -> None:
    """Imports what the work takes, which is off the clock."""
    from .. import motion, work  # noqa: F401


def solved(task: Task, folder: Path) -> Product:
    """The file of the motion, and what is wrong with it; MuJoCo's warnings are among its notes.

    folder  an empty one. Raises UserError for a clip that is wrong.
    """
    warned: list[str] = []
    with mujoco_warnings.reported_to(warned.append):
        product = _solved(task, folder)
    return replace(product, notes=(*product.notes, *warned))


def _solved(task: Task, folder: Path) -> Product:
    from rich.console import Console

    from .. import recordings, work
    from ..measure.problems import plain
    from ..scene import outside
    from ..system.progress import Progress

    if task.program != program():
        raise UserError(f"the worker has dynamic-splines {program()}, not {task.program}; install the same")
    for name, data in task.files.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    if task.cleaning is not None:
        return _cleaned(task, task.cleaning, folder)
    source, figure = task.files.clip, task.files.figure
    where = str(folder / source) if Path(source).suffix else source
    with outside.allowed(task.allow_outside):
        problem = recordings.load(where, figure_file=figure and str(folder / figure), fps=task.fps)
    with Path(os.devnull).open("w") as nowhere:
        progress = Progress(Console(file=nowhere))
        result = work.solve(problem, progress)
        saved = result.saved(progress, with_report=task.report)
    return replace(_written(saved, task, folder, task.fps), problems=tuple(plain(result.problems)))


def _cleaned(task: Task, cleaning: Cleaning, folder: Path) -> Product:
    """The file of a recording's clean motion, what is wrong with it, and what was measured before and after."""
    from rich.console import Console

    from ..clean import running
    from ..clean.comparing import Comparison
    from ..scene import outside
    from ..system.progress import Progress

    there = {word: folder / place for word, place in task.files.others.items()}
    figure = str(there["figure"]) if "figure" in there else cleaning.figure
    source = running.Source(
        folder / task.files.clip,
        figure,
        cleaning.kind,
        task.fps,
        scene=there.get("scene"),
        map=there.get("map"),
        apart=cleaning.apart,
    )
    with Path(os.devnull).open("w") as nowhere, outside.allowed(task.allow_outside):
        result, saved = running.made(source, cleaning.within, Progress(Console(file=nowhere)))
    found = Comparison(result)
    return replace(_written(saved, task, folder, None), problems=tuple(found.problems), figures=found.figures)


def _written(saved: Saved, task: Task, folder: Path, fps: float | None) -> Product:
    """A motion as a file of the kind that is asked for, with what lies beside it."""
    from .. import motion
    from ..exchange import formats

    made = folder / ".made"
    made.mkdir()
    target = made / f"{RESULT}{'.npz' if task.to == NPZ else formats.writer(task.to).ending}"
    notes: list[str] = []
    if task.to == NPZ:
        motion.save(saved, target)
    else:
        formats.export(saved, task.to, target, fps=fps, tell=notes.append)
    others = [path for path in sorted(made.iterdir()) if path != target]
    beside = {path.name.removeprefix(RESULT): path.read_bytes() for path in others}
    said = tuple(note for note in notes if note not in {f"wrote {path}" for path in others})
    return Product(target.read_bytes(), beside=beside, notes=said)
