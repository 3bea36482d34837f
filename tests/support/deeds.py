"""What the workers of a batch do in tests instead of solving; in a file of its own, which they can import."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import numpy as np

from dynsplines.batch import solving
from dynsplines.batch.task import Outcome, Task
from dynsplines.errors import UserError


def perform(task: Task, folder: Path) -> Outcome:
    """As the clip's text says: "DEED VALUE"."""
    assert not list(folder.iterdir())
    (folder / "litter").write_text("here")
    deed, _, value = task.files[task.clip].decode().partition(" ")
    match deed:
        case "hang":
            while True:
                np.linalg.norm(np.ones(100))
                time.sleep(0.001)
        case "freeze":  # deaf to all but the end of the process
            solving.GRACE_SECONDS = 1.0
            time.sleep(600)
        case "grab":  # far too much memory at once
            np.zeros(2**46)
        case "grow":  # too much, little by little
            taken = []
            while True:
                taken.append(np.ones(2**21))
                time.sleep(0.005)
        case "die":
            os.kill(os.getpid(), signal.SIGKILL)
        case "once":  # dies the first time
            mark = Path(value)
            if not mark.exists():
                mark.write_text("was here")
                os.kill(os.getpid(), signal.SIGKILL)
        case "complain":
            raise UserError(value)
        case "stumble":
            raise ZeroDivisionError("of nothing")
    return Outcome(files={task.output: f"{deed} {value}".encode()})
