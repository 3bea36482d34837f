"""What the workers of a batch do in tests instead of solving; in a file of its own, which they can import."""

import os
import signal
import time
from contextlib import suppress
from pathlib import Path

import numpy as np

from dynsplines.batch.task import Result, Task
from dynsplines.errors import UserError

EXITS: list[int] = []


def perform(task: Task, folder: Path) -> Result:
    """As the clip's text says: "DEED VALUE"."""
    assert not list(folder.iterdir())
    (folder / "litter").write_text("here")
    deed, _, value = task.files[task.clip].decode().partition(" ")
    match deed:
        case "hang":
            while True:
                np.linalg.norm(np.ones(100))
                time.sleep(0.001)
        case "freeze":  # deaf to all but the end of the process, which a test pretends
            while not EXITS:
                with suppress(BaseException):
                    time.sleep(0.01)
            raise UserError("the process has ended")
        case "grab":  # far too much memory at once
            np.zeros(2**46)
        case "die":
            time.sleep(0.2)  # the result before has been sent
            os.kill(os.getpid(), signal.SIGKILL)
        case "complain":
            raise UserError(value)
        case "stumble":
            raise ZeroDivisionError("of nothing")
    return Result(files={task.output: f"{deed} {value}".encode()})
