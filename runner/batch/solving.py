"""The work on one clip, in a Dask worker: its files in, the files of its motion out."""

from __future__ import annotations

import ctypes
import os
import tempfile
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from distributed import get_worker

from ..errors import UserError, locate, one_line
from ..picture.graphics import do_without
from ..system import mujoco_warnings
from .task import NPZ, Result, Task, program

if TYPE_CHECKING:
    from ..clean.command import Source
    from ..motion import Saved

SolveTask = Callable[[Any, Path], Result]

GRACE_SECONDS = 10.0  # [s] time after the limit in which the work should end
ONE_AT_A_TIME = threading.Lock()  # MuJoCo's handler of warnings is one of the process


class _TimeLimit(BaseException):
    """The time limit of a clip is exceeded."""


def outcome_of(solve_task: SolveTask, task: Any, seconds: float) -> Result:
    """Return the outcome of solve_task(task, empty folder), also if it raises an error or takes longer than `seconds`.

    If native code does not respond to the time limit, the process ends, and Dask replaces it.
    """
    do_without()
    from .. import motion, recordings, solving  # noqa: F401  imported before the time of the clip begins

    folders = tempfile.TemporaryDirectory(dir=get_worker().local_directory, ignore_cleanup_errors=True)
    with ONE_AT_A_TIME, folders as folder:
        begin, ended = time.monotonic(), threading.Event()
        watch = threading.Thread(target=_watch, args=(threading.get_ident(), ended, seconds), daemon=True)
        watch.start()
        try:
            try:
                outcome = solve_task(task, Path(folder))
            finally:
                ended.set()
                watch.join()
        except _TimeLimit:
            ended.set()
            outcome = Result(f"it took longer than {seconds:g} s")
        except MemoryError as error:
            outcome = Result(f"it took more memory than there is ({one_line(error)})")
        except UserError as error:
            outcome = Result(one_line(error))
        except Exception as error:
            outcome = Result(locate(error))
    return replace(outcome, seconds=round(time.monotonic() - begin, 3))


def _watch(thread: int, ended: threading.Event, seconds: float) -> None:
    """Raise _TimeLimit in a thread at the time limit; end the process if that has no effect."""
    if not ended.wait(seconds):
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), ctypes.py_object(_TimeLimit))
        if not ended.wait(GRACE_SECONDS):
            os._exit(1)


def solve(task: Task, folder: Path) -> Result:
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
    with mujoco_warnings.reported_to(warned.append), file_access.allow(task.allow_outside):
        cleaning = task.options.cleaning
        outcome = _solve(task, folder) if cleaning is None else _clean(task, cleaning, folder)
    return replace(outcome, notes=(*outcome.notes, *warned))


def _solve(task: Task, folder: Path) -> Result:
    from .. import recordings, solving
    from ..measure.violation import plain, violations
    from ..system.progress import silent

    source, figure = task.clip, task.others.get("figure")
    where = str(folder / source) if Path(source).suffix else source
    problem = recordings.load(where, figure_file=figure and str(folder / figure), fps=task.options.fps)
    saved = solving.solve(problem, silent(), with_report=task.options.report)
    listed = tuple(plain(violations(problem, saved)))
    return replace(_write(saved, task, folder, task.options.fps), violations=listed)


def _clean(task: Task, cleaning: Source, folder: Path) -> Result:
    from ..clean import command
    from ..clip.load import clip_from_motion
    from ..measure import violation
    from ..system.progress import silent

    options, others = task.options, {word: folder / path for word, path in task.others.items()}
    figure = str(others["figure"]) if "figure" in others else cleaning.figure
    files = {"file": folder / task.clip, "scene": others.get("scene"), "map": others.get("map")}
    source = replace(cleaning, figure=figure, fps=options.fps, **files)
    saved = command.clean_recording(source, silent())
    violations = violation.violations(clip_from_motion(saved), saved)
    listed = tuple(violation.plain(violation.by_name(violations)))
    return replace(_write(saved, task, folder, None), violations=listed)


def _write(saved: Saved, task: Task, folder: Path, fps: float | None) -> Result:
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
    return Result(files=files, notes=tuple(note for note in notes if not note.startswith(f"wrote {staging}{os.sep}")))
