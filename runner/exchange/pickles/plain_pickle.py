"""Pickles of plain data: dicts, lists, numbers, texts and numpy arrays; whatever else is in one is refused unread.

A pickle is a program, and one from elsewhere can do anything when Python loads it. It is run by `pickle_program`
instead, which has no functions but those of `pickled_arrays`.
"""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

from ...errors import UserError
from ..held import Held
from .pickle_program import Machine, Refused
from .pickled_arrays import MAKERS


def load(source: Path) -> Held:
    """The dict in a pickle; raises UserError for a damaged one, and for one that holds more than plain data."""
    try:
        found = Machine(MAKERS).run(source.read_bytes(), source)
    except (UserError, OSError, MemoryError):
        raise
    except Refused as error:
        raise UserError(
            f"{source}: it holds '{error}'; only numbers, texts, lists and numpy arrays are loaded"
        ) from None
    except Exception as error:  # a damaged pickle raises nearly anything
        raise UserError(f"{source}: not a readable pickle: {' '.join(str(error).split())}") from None
    if not isinstance(found, dict):
        raise UserError(f"{source}: it holds a {type(found).__name__}, not a dict")
    foreign = next((key for key in found if not isinstance(key, str)), None)
    if foreign is not None:
        raise UserError(f"{source}: a key in it is a {type(foreign).__name__}, not a text")
    return Held(source, found)


def dump(entries: dict[str, Any], target: Path) -> None:
    """Writes a dict so that any numpy reads it: version 2 moved what a pickle names, and keeps the old name as well."""
    target.write_bytes(pickle.dumps(entries, protocol=3).replace(b"cnumpy._core.", b"cnumpy.core."))
