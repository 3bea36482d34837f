"""Batches: thousands of clips, solved by Dask workers of this machine or of a cluster.

inputs      the clips that a command names, and the files that each needs
task        a clip as it is sent to a worker, the options of the batch, and the outcome
manifest    the results of the clips, in a file that survives the end of the program
solving     the work on a clip: its files in, the files of its motion out
dispatch    the assignment of clips to Dask workers
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import missing_package
from .task import BatchOptions

if TYPE_CHECKING:
    from ..system.progress import Progress
    from .manifest import Tally

__all__ = ["BatchOptions", "run"]


def run(words: list[str], folder: Path, progress: Progress, options: BatchOptions) -> Tally:
    """Solve every clip that the words name into a folder. Raises UserError if Dask is not installed."""
    try:
        from . import dispatch
    except ModuleNotFoundError as error:
        if error.name not in ("cryptography", "distributed", "dask"):
            raise
        raise missing_package("dynsplines batch", error.name, "batch") from None
    tally = dispatch.run(words, folder, options, progress)
    tally.report(progress)
    progress.report(f"{folder}: {tally.line}")
    return tally
