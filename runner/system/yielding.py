"""Work that others go before, for a while: somebody waits for them, and for this only later."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

LATER = 10  # how nice it is: of two who want one processor it gets a tenth


def yielding(pieces: Sequence[Callable[[], object]], patience: float) -> None:
    """Does pieces of work in turn, others first; those that are left after so long [s] like anything else.

    Only Linux lets one thread be nicer than others, and none of them can ever take it back: so this is one that ends.
    What a piece raises is raised as well by whoever needs it afterwards; here it only ends the yielding.
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
