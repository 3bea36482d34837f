"""The work on one clip, in a worker process: its files in, the files of its motion out."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import UserError
from ..system import mujoco_warnings
from .task import NPZ, Outcome, Task, program

if TYPE_CHECKING:
    from ..clean.command import Source
    from ..motion import Saved


def solved(task: Task, folder: Path) -> Outcome:
    """Return the files of the motion, and its violations, with MuJoCo's warnings among the notes.

    `folder` is an empty one for the clip's files. Raises UserError for an invalid clip.
    """
    if task.program != program():
        raise UserError(f"the worker has dynamic-splines {program()}, not {task.program}; install the same")
    for name, data in task.files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    from ..scene import file_access

    warned: list[str] = []
    with mujoco_warnings.reported_to(warned.append), file_access.allowed(task.allow_outside):
        cleaning = task.options.cleaning
        outcome = _solved(task, folder) if cleaning is None else _cleaned(task, cleaning, folder)
    return replace(outcome, notes=(*outcome.notes, *warned))


def _solved(task: Task, folder: Path) -> Outcome:
    from .. import recordings, solving
    from ..measure.violation import plain
    from ..system.progress import silent

    source, figure = task.clip, task.others.get("figure")
    where = str(folder / source) if Path(source).suffix else source
    problem = recordings.load(where, figure_file=figure and str(folder / figure), fps=task.options.fps)
    result = solving.solve(problem, silent())
    saved = result.saved(silent(), with_report=task.options.report)
    return replace(_written(saved, task, folder, task.options.fps), violations=tuple(plain(result.violations)))


def _cleaned(task: Task, cleaning: Source, folder: Path) -> Outcome:
    from ..clean import command
    from ..measure import violation
    from ..solving import Solved
    from ..system.progress import silent

    options, others = task.options, {word: folder / path for word, path in task.others.items()}
    figure = str(others["figure"]) if "figure" in others else cleaning.figure
    files = {"file": folder / task.clip, "scene": others.get("scene"), "map": others.get("map")}
    source = replace(cleaning, figure=figure, fps=options.fps, **files)
    saved = command.clean_recording(source, options.max_displacement, silent())[1]
    violations = violation.plain(violation.by_name(Solved.of(saved).violations))
    return replace(_written(saved, task, folder, None), violations=tuple(violations))


def _written(saved: Saved, task: Task, folder: Path, fps: float | None) -> Outcome:
    """Write a motion in the requested format, and read back all files."""
    from .. import motion
    from ..exchange import formats

    staging = folder / ".made"  # a folder that no clip's file is in
    staging.mkdir()
    target = staging / task.output
    notes: list[str] = []
    if task.options.to == NPZ:
        motion.save(saved, target)
    else:
        formats.export(saved, task.options.to, target, fps=fps, report=notes.append)
    files = {path.name: path.read_bytes() for path in [target, *sorted(staging.iterdir())]}
    return Outcome(files=files, notes=tuple(note for note in notes if not note.startswith(f"wrote {staging}{os.sep}")))
