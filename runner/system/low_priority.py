"""Low-priority work: other threads go first for a while, because a user is waiting for them."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

LATER = 10  # niceness: of two threads on one processor it gets a tenth of the time


def yielding(pieces: Sequence[Callable[[], object]], patience: float) -> None:
    """Run tasks in turn with low priority; after a time [s] the remaining ones have normal priority.

    On Linux alone a thread can lower its own priority, and it cannot raise it again: so this thread ends afterwards.
    An exception of a task is raised again by the code that needs its result; here it only ends the thread.
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
