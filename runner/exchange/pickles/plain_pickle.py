"""Pickles of plain data: dicts, lists, numbers, texts and numpy arrays; whatever else is in one is refused unread.

A pickle is a program, and one from elsewhere can do anything when Python loads it. It is run by `pickle_program`
instead, which has no functions but those of `pickled_arrays`.
"""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import pickle
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ...errors import UserError
from ...system import largest
from ..held import Held
from .pickle_program import Machine, Refused
from .pickled_arrays import MAKERS


def content(source: Path) -> bytes:
    """Return a pickle's bytes, decompressed if joblib has compressed them; raises UserError for too many of them."""
    data = source.read_bytes()
    for mark, opened in COMPRESSED.items():
        if data.startswith(mark):
            try:
                most = largest.bound()
                with opened(io.BytesIO(data)) as stream:
                    out = stream.read(most + 1)
            except (OSError, EOFError, ValueError, lzma.LZMAError, zlib.error) as error:
                raise UserError(f"{source}: damaged compressed file: {error}") from None
            largest.check(source, len(out), "it, decompressed,")
            return out
    return data


class _Inflated:
    """A zlib stream, as a file that is read once."""

    def __init__(self, stream: io.BytesIO) -> None:
        self._data = stream.read()

    def __enter__(self) -> _Inflated:
        return self

    def __exit__(self, *_: object) -> None:
        self._data = b""

    def read(self, most: int) -> bytes:
        """At most so many bytes; raises EOFError if the stream is cut short."""
        machine = zlib.decompressobj()
        out = machine.decompress(self._data, most)
        if not machine.eof and len(out) < most:
            raise EOFError("cut short")
        return out


TENSORS = ": save its tensors as arrays in Python, with .numpy(), and dump it again"
COMPRESSED: dict[bytes, Callable[[io.BytesIO], Any]] = {
    b"\x78\x01": _Inflated, b"\x78\x5e": _Inflated, b"\x78\x9c": _Inflated, b"\x78\xda": _Inflated,
    b"\x1f\x8b": lambda stream: gzip.GzipFile(fileobj=stream), b"BZh": bz2.BZ2File, b"\xfd7zXZ": lzma.LZMAFile,
    b"\x5d\x00\x00": lzma.LZMAFile,
}  # fmt: skip


def load(source: Path) -> Held:
    """The dict in a pickle; raises UserError for a damaged one, and for one that holds more than plain data."""
    try:
        entries = Machine(MAKERS).run(content(source), source)
    except (UserError, OSError, MemoryError):
        raise
    except Refused as error:
        raise UserError(
            f"{source}: it holds '{error}'; only numbers, texts, lists and numpy arrays are loaded"
            + (TENSORS if str(error).startswith("torch") else "")
        ) from None
    except Exception as error:  # a damaged pickle raises nearly anything
        raise UserError(f"{source}: not a readable pickle: {' '.join(str(error).split())}") from None
    if not isinstance(entries, dict):
        raise UserError(f"{source}: it holds a {type(entries).__name__}, not a dict")
    foreign = next((key for key in entries if not isinstance(key, str)), None)
    if foreign is not None:
        raise UserError(f"{source}: a key in it is a {type(foreign).__name__}, not a text")
    return Held(source, entries)


def one_motion(found: Held) -> Held:
    """The one motion of a file that has it under its name, as PHC and ASAP write it; raises UserError for several."""
    entries = found.entries
    if not entries or not all(isinstance(entry, dict) for entry in entries.values()):
        return found
    if len(entries) > 1:
        names = ", ".join(list(entries)[:5]) + (", ..." if len(entries) > 5 else "")
        raise UserError(f"{found.where}: it holds {len(entries)} motions: {names}; save one of them alone")
    return Held(found.where, {str(key): value for key, value in next(iter(entries.values())).items()})


def dump(entries: dict[str, Any], target: Path) -> None:
    """Writes a dict so that any numpy reads it: version 2 moved what a pickle names, and keeps the old name as well."""
    target.write_bytes(pickle.dumps(entries, protocol=3).replace(b"cnumpy._core.", b"cnumpy.core."))
