"""Thousands of clips, on the processes of this machine or on a Dask cluster elsewhere.

inputs.py     what is named on the command line becomes clips, and a clip the files that go to a worker
manifest.py   what became of every clip, in a file that survives whatever ends the program
lock.py       one program at a time in a folder
solving.py    the work itself: files of a clip in, the file of its motion out
child.py      the process that does it, warm from clip to clip
bounded.py    the other end of that process: it is ended when it takes too long or too much
crew.py       such processes at every Dask worker
cluster.py    the Dask workers, here or elsewhere
plan.py       what a command asks for, and what of it is left to do
recordings.py  a batch of recordings: what is asked of it, and what it came to
dispatch.py   the verb: few clips under way at a time, each done once
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import UserError
from ..system.workers import cores

if TYPE_CHECKING:
    from ..system.progress import Progress
    from .dispatch import Tally
    from .task import Cleaning

NEEDS = ("distributed", "dask", "psutil")
MOST_WORKERS = 1000  # more would only be a slip of the keyboard
MOST_SECONDS = 1e6  # [s] a clip, eleven days
LEAST_MEGABYTES, MOST_MEGABYTES = 256, 10**7  # [MB] a worker


def run(
    words: list[str],
    folder: Path,
    progress: Progress,
    *,
    listed: str | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    to: str = "npz",
    fps: float | None = None,
    seconds: float = 3600.0,
    megabytes: float | None = None,
    report: bool = False,
    retry_failed: bool = False,
    cleaning: Cleaning | None = None,
) -> Tally:
    """Solves every clip that the words name into a folder; plan.Options says what the rest means.

    seconds, megabytes  that a clip may take. Raises UserError for what cannot be meant, or if Dask is not there.
    """
    if workers is not None and scheduler is not None:
        raise UserError("--workers are of this machine and --scheduler is elsewhere; give one of them")
    if workers is not None and not 1 <= workers <= MOST_WORKERS:
        raise UserError(f"--workers {workers}: give a number of processes, 1 to {MOST_WORKERS}")
    if not 0.1 <= seconds <= MOST_SECONDS:
        raise UserError(f"--limit-time {seconds:g}: give seconds, 0.1 to {MOST_SECONDS:g}")
    if megabytes is not None and not LEAST_MEGABYTES <= megabytes <= MOST_MEGABYTES:
        raise UserError(
            f"--limit-memory {megabytes:g}: give MB, {LEAST_MEGABYTES} to {MOST_MEGABYTES}; an idle process has 200"
        )
    if report and cleaning is not None:
        raise UserError("--report is for clips; a recording is measured before and after as it is")
    if fps is not None and not 0.01 <= fps <= 100_000:
        raise UserError(f"--fps {fps:g}: give a number of samples a second, 0.01 to 100000")
    try:
        from . import dispatch
    except ModuleNotFoundError as error:
        if error.name not in NEEDS:
            raise
        raise UserError(
            f"dynsplines batch needs '{error.name}'; install it: pip install 'dynamic-splines[batch]'"
        ) from None
    options = dispatch.Options(listed, workers or cores(), scheduler, to, fps, report, retry_failed, cleaning)
    return dispatch.run(words, folder, options, dispatch.Bounds(seconds, megabytes), progress)
