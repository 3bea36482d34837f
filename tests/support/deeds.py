"""What the processes of a batch do in tests instead of solving; in a file of its own, which they can import."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import numpy as np

from dynsplines.batch.task import Product, Task
from dynsplines.errors import UserError


def ready() -> None:
    """Nothing to prepare."""


def lasts(seconds: float, folder: Path) -> Product:
    time.sleep(seconds)
    return Product(str(os.getpid()).encode())


def hangs(_: object, folder: Path) -> Product:
    """Deaf to everything but the kernel."""
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    while True:
        np.linalg.norm(np.ones(100))


def grows(_: object, folder: Path) -> Product:
    """Takes memory little by little, and uses it."""
    taken = []
    while True:
        taken.append(np.ones(2**20))
        time.sleep(0.005)


def grabs(_: object, folder: Path) -> Product:
    """Asks for far too much at once."""
    return Product(np.zeros(2**36).tobytes())


PINNED = []


def pins(_: object, folder: Path) -> Product:
    """Takes 200 MB in small pieces and keeps the last of them, above all that is free again."""
    taken = [np.ones(12_000) for _ in range(2000)]
    PINNED.append(taken[-1])
    return Product(b"")


def dies(number: int, folder: Path) -> Product:
    os.kill(os.getpid(), number)
    return Product(b"")


def leaves(code: int, folder: Path) -> Product:
    os._exit(code)


def complains(words: str, folder: Path) -> Product:
    raise UserError(words)


def stumbles(_: object, folder: Path) -> Product:
    raise ZeroDivisionError("of nothing")


def litters(_: object, folder: Path) -> Product:
    """What lies in its folder, and then one thing more."""
    found = " ".join(sorted(path.name for path in folder.iterdir()))
    (folder / "litter").write_text("here")
    return Product(found.encode())


def told(task: Task, folder: Path) -> Product:
    """As the clip's text says: "DEED VALUE"."""
    deed, _, value = task.files.files[task.files.clip].decode().partition(" ")
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
            return Product(b"at last")
        case "complain":
            return complains(value, folder)
        case _:
            return Product(f"{deed} {value}".encode())
