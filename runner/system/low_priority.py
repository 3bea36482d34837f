"""Low-priority work: other threads go first for a while, because a user is waiting for them."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

LATER = 10  # niceness at which a thread gets a tenth of the time of a processor that it shares


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
