"""The start of the solver process. Nothing is imported before it is known that this is not the server."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from importlib import import_module
from typing import Any

HEAVY = (  # slow imports, in parts of a few tenths of a second
    "scipy.sparse",
    "scipy.linalg",
    "mujoco",
    "dynsplines.solver.inbetween",
    "dynsplines.clip.table",
    "dynsplines.clip.load",
    "dynsplines.studio.solving.loop",
)
LATER = 10  # niceness at which a thread gets a tenth of the time of a processor that it shares
PATIENCE = 2.5  # [s] duration of low priority of imports, while the page draws its first view


def entry(line: Any, outside: bool, shows_view: bool) -> None:
    """Run the solver process.

    With `outside`, models may refer to files anywhere. `shows_view` is whether pages show a view before this process
    reports.
    """
    from ...picture.graphics import do_without
    from ...system import mujoco_warnings
    from ...system.threads import use_one_thread, without_tools

    use_one_thread()
    do_without()
    yielding([without_tools, *(partial(import_module, name) for name in HEAVY)], PATIENCE if shows_view else 0.0)
    from .loop import serve

    with mujoco_warnings.reported_to(mujoco_warnings.print_note):
        serve(line, outside)


def yielding(pieces: Sequence[Callable[[], object]], patience: float) -> None:
    """Run tasks in turn with low priority. After a time [s] the remaining ones have normal priority.

    Only Linux supports priorities of threads, and a thread cannot raise its own again, so a separate thread runs the
    tasks. An exception of a task only ends this thread; the code that needs the task's result raises it again.
    """
    waiting = list(pieces)
    end = time.monotonic() + patience

    def nicely() -> None:
        with suppress(Exception):
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), LATER)
            while waiting and time.monotonic() < end:
                waiting.pop(0)()

    if sys.platform == "linux":
        thread = threading.Thread(target=nicely, daemon=True)
        thread.start()
        thread.join()
    for piece in waiting:
        piece()
