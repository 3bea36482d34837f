"""Pickles of plain data: dicts, lists, numbers, texts and numpy arrays; whatever else is in one is refused unread.

A pickle is a program, and one from elsewhere can do anything when it is loaded. This reader knows only the functions
that make an array, by name; every other one ends in an error before it is even imported.
"""

from __future__ import annotations

import pickle
from collections import OrderedDict
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import UserError
from .held import Held

ARRAY_MAKERS = {"multiarray": ("_reconstruct", "scalar"), "numeric": ("_frombuffer",)}


class Refused(pickle.UnpicklingError):
    """A pickle asks for something that is not data."""


class _Reader(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        """numpy's own, under its names before and since version 2; nothing else is looked up."""
        package, _, last = module.rpartition(".")
        if package in ("numpy.core", "numpy._core") and name in ARRAY_MAKERS.get(last, ()):
            return super().find_class(f"numpy._core.{last}", name)
        if module == "numpy" and name in ("ndarray", "dtype"):
            return getattr(np, name)
        if (module, name) == ("collections", "OrderedDict"):
            return OrderedDict
        if (module, name) == ("_codecs", "encode"):
            return _latin
        raise Refused(f"{module}.{name}")


def _latin(text: str, encoding: str) -> bytes:
    """How protocol 2 spells bytes."""
    if encoding not in ("latin1", "latin-1"):
        raise Refused(f"the encoding {encoding}")
    return text.encode("latin1")


def load(source: Path) -> Held:
    """The dict in a pickle; raises UserError for a damaged one, and for one that holds more than plain data."""
    try:
        with source.open("rb") as stream:
            found = _Reader(stream).load()
    except Refused as error:
        raise UserError(
            f"{source}: it holds '{error}'; only numbers, texts, lists and numpy arrays are loaded"
        ) from None
    except Exception as error:  # a damaged pickle raises nearly anything
        raise UserError(f"{source}: not a readable pickle: {' '.join(str(error).split())}") from None
    if not isinstance(found, dict):
        raise UserError(f"{source}: it holds a {type(found).__name__}, not a dict")
    return Held(source, found)


def dump(entries: dict[str, Any], target: Path) -> None:
    """Writes a dict so that any numpy reads it: version 2 moved what a pickle names, and keeps the old name as well."""
    target.write_bytes(pickle.dumps(entries, protocol=3).replace(b"cnumpy._core.", b"cnumpy.core."))
