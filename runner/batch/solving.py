"""The work itself, by a process that may be anywhere: the files of a clip in, the file of its motion out."""

from __future__ import annotations

import os
from pathlib import Path

from ..errors import UserError
from .task import NPZ, Product, Task, program


def prepared() -> None:
    """Imports what the work takes, which is off the clock."""
    from .. import motion, work  # noqa: F401


def solved(task: Task, folder: Path) -> Product:
    """The file of the motion, and what is wrong with it.

    folder  an empty one. Raises UserError for a clip that is wrong.
    """
    from rich.console import Console

    from .. import motion, work
    from ..clip import load as clip
    from ..exchange import formats
    from ..measure.problems import plain
    from ..scene import outside
    from ..system.progress import Teller

    if task.program != program():
        raise UserError(f"the worker has dynamic-splines {program()}, not {task.program}; install the same")
    for name, data in task.files.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    source, figure = task.files.clip, task.files.figure
    where = str(folder / source) if Path(source).suffix else source
    with outside.allowed(task.allow_outside):
        problem = clip.load(where, figure_file=figure and str(folder / figure), fps=task.fps)
    with Path(os.devnull).open("w") as nowhere:
        teller = Teller(Console(file=nowhere))
        result = work.solve(problem, teller)
        saved = result.saved(teller, with_report=task.report)
    target = folder / f".result{'.npz' if task.to == NPZ else formats.writer(task.to).ending}"
    if task.to == NPZ:
        motion.save(saved, target)
    else:
        formats.export(saved, task.to, target, fps=task.fps)
    return Product(target.read_bytes(), tuple(plain(result.problems)))
