"""What the processes of a batch do in tests instead of solving; in a file of its own, which they can import."""

from __future__ import annotations

import os
import signal
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from dynsplines.batch.task import Outcome, Task
from dynsplines.errors import UserError


def output(data: bytes) -> Outcome:
    return Outcome(files={"output": data})


def lasts(seconds: float, folder: Path) -> Outcome:
    time.sleep(seconds)
    return output(str(os.getpid()).encode())


def hangs(_: object, folder: Path) -> Outcome:
    """Deaf to everything but the kernel."""
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    while True:
        np.linalg.norm(np.ones(100))


def grows(_: object, folder: Path) -> Outcome:
    """Takes memory little by little, and uses it."""
    taken = []
    while True:
        taken.append(np.ones(2**20))
        time.sleep(0.005)


def grabs(_: object, folder: Path) -> Outcome:
    """Asks for far too much at once."""
    return output(np.zeros(2**36).tobytes())


PINNED = []


def pins(_: object, folder: Path) -> Outcome:
    """Takes 200 MB in small pieces and keeps the last of them, above all that is free again."""
    taken = [np.ones(12_000) for _ in range(2000)]
    PINNED.append(taken[-1])
    return Outcome()


def dies(number: int, folder: Path) -> Outcome:
    os.kill(os.getpid(), number)
    return Outcome()


def leaves(code: int, folder: Path) -> Outcome:
    os._exit(code)


def complains(words: str, folder: Path) -> Outcome:
    raise UserError(words)


def stumbles(_: object, folder: Path) -> Outcome:
    raise ZeroDivisionError("of nothing")


def litters(_: object, folder: Path) -> Outcome:
    """What lies in its folder, and then one thing more."""
    found = " ".join(sorted(path.name for path in folder.iterdir()))
    (folder / "litter").write_text("here")
    return output(found.encode())


def perform(task: Task, folder: Path) -> Outcome:
    """As the clip's text says: "DEED VALUE"."""
    outcome = done(task, folder)
    return replace(outcome, files=dict.fromkeys([task.output], outcome.files["output"]))


def done(task: Task, folder: Path) -> Outcome:
    deed, _, value = task.files[task.clip].decode().partition(" ")
    match deed:
        case "hang":
            return hangs(None, folder)
        case "grab":
            return grabs(None, folder)
        case "die":
            return dies(signal.SIGKILL, folder)
        case "once":  # dies the first time
            mark = Path(value)
            if not mark.exists():
                mark.write_text("was here")
                return dies(signal.SIGKILL, folder)
            return output(b"at last")
        case "complain":
            return complains(value, folder)
        case _:
            return output(f"{deed} {value}".encode())
