"""Pickles of plain data: dicts, lists, numbers, texts and NumPy arrays; any other content is refused.

A pickle calls functions by name, so that loading it in Python can execute anything. Here `Unpickler.find_class` offers
only the safe constructors of `pickled_arrays`. Instructions that set attributes or need extensions are not supported.
"""

from __future__ import annotations

import bz2
import io
import lzma
import pickle
import pickletools
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from ...errors import UserError
from ...system import size_limit
from ..array_reader import ArrayReader
from .pickled_arrays import CONSTRUCTORS, Refused, Trailing, Unfinished

TENSORS = ": save its tensors as arrays in Python, with .numpy(), and dump it again"
STEP_BYTES = 100  # most memory of an instruction without data: an empty dict and its entry
LARGEST_INTEGER = 64  # [bits]
INSTRUCTIONS = """
    MARK STOP POP POP_MARK NONE NEWTRUE NEWFALSE INT BININT BININT1 BININT2 LONG LONG1 LONG4 FLOAT BINFLOAT
    STRING BINSTRING SHORT_BINSTRING UNICODE BINUNICODE SHORT_BINUNICODE BINUNICODE8 BINBYTES SHORT_BINBYTES BINBYTES8
    BYTEARRAY8 EMPTY_LIST LIST APPEND APPENDS EMPTY_DICT DICT SETITEM SETITEMS EMPTY_TUPLE TUPLE TUPLE1 TUPLE2 TUPLE3
    PUT BINPUT LONG_BINPUT MEMOIZE GET BINGET LONG_BINGET PROTO FRAME GLOBAL STACK_GLOBAL REDUCE NEWOBJ BUILD
"""
COMPRESSED: dict[bytes, Callable[[], Any]] = {
    b"\x78\x01": zlib.decompressobj, b"\x78\x5e": zlib.decompressobj, b"\x78\x9c": zlib.decompressobj,
    b"\x78\xda": zlib.decompressobj, b"\x1f\x8b": lambda: zlib.decompressobj(wbits=31), b"BZh": bz2.BZ2Decompressor,
    b"\xfd7zXZ": lzma.LZMADecompressor, b"\x5d\x00\x00": lzma.LZMADecompressor,
}  # fmt: skip


def content(source: Path) -> bytes:
    """Return a pickle's bytes, decompressed if joblib compressed them; raises UserError above the size limit."""
    data = source.read_bytes()
    opened = next((opened for mark, opened in COMPRESSED.items() if data.startswith(mark)), None)
    if opened is None:
        return data
    most = size_limit.bound()
    stream = opened()
    try:
        out = stream.decompress(data, most + 1)
    except (OSError, EOFError, ValueError, lzma.LZMAError, zlib.error) as error:
        raise UserError(f"{source}: damaged compressed file: {error}") from None
    size_limit.check(source, len(out), "it, decompressed,")
    if not stream.eof:
        raise UserError(f"{source}: damaged compressed file: cut short")
    return out


InPython: Any = pickle._Unpickler  # the one joblib uses, as it can pause where an array's bytes follow


class _Unpickler(InPython):
    """Loads plain data from a stream; size [bytes]: of the file, to which those of its instructions are added."""

    def __init__(self, stream: io.BytesIO, size: int, where: object) -> None:
        super().__init__(stream, encoding="latin1")
        self.stream, self.size, self.where, self.most = stream, size, where, size_limit.bound()

    def find_class(self, module: str, name: str) -> Any:
        constructor = CONSTRUCTORS.get((module, name))
        if constructor is None:
            raise Refused(f"{module}.{name}")
        return constructor

    def count(self) -> None:
        """Count an instruction; raises UserError if the instructions exceed the memory limit."""
        self.size += STEP_BYTES
        if self.size > self.most:
            size_limit.check(self.where, self.size, "what it holds")

    def check_top(self) -> None:
        """Complete the top of the stack if its state is known; raises Refused for long integers."""
        top = self.stack[-1] if self.stack else None
        if isinstance(top, Unfinished) and top.value is not None:
            self.stack[-1] = top.value
        elif isinstance(top, int) and top.bit_length() > LARGEST_INTEGER:
            raise Refused(f"an integer of {top.bit_length()} bits")

    def load_build(self) -> None:
        """Complete an array or a type by its state; no other object has one."""
        state = self.stack.pop()
        unfinished = self.stack[-1]
        if not isinstance(unfinished, Unfinished):
            raise Refused("a state of an object without one")
        unfinished.value = unfinished.complete(state)
        if isinstance(unfinished.value, Trailing):
            unfinished.value = unfinished.value.read(self.stream, _Unpickler(self.stream, self.size, self.where).load)

    def load_bytearray8(self) -> None:
        """Load as in Python, but allocate no memory for missing bytes."""
        self.append(bytearray(self.read(int.from_bytes(self.read(8), "little"))))


def _checked(name: str) -> tuple[int, Callable[[_Unpickler], None]]:
    code = getattr(pickle, name)[0]
    overrides = {"BUILD": _Unpickler.load_build, "BYTEARRAY8": _Unpickler.load_bytearray8}
    run = overrides.get(name) or InPython.dispatch[pickle.REDUCE[0] if name == "NEWOBJ" else code]

    def checked(unpickler: _Unpickler) -> None:
        unpickler.count()
        run(unpickler)
        unpickler.check_top()

    return code, checked


class _Instructions(dict[int, Callable[[_Unpickler], None]]):
    """The instructions of plain data."""

    def __missing__(self, code: int) -> Any:
        name = next((opcode.name for opcode in pickletools.opcodes if opcode.code == chr(code)), None)
        if name is None:
            raise ValueError(f"no instruction {code}")
        raise Refused(name)


_Unpickler.dispatch = _Instructions(map(_checked, INSTRUCTIONS.split()))


def load(source: Path) -> ArrayReader:
    """Return the dict in a pickle; raises UserError if it is damaged or contains more than plain data."""
    try:
        data = content(source)
        entries = _Unpickler(io.BytesIO(data), len(data), source).load()
    except (UserError, OSError, MemoryError):
        raise
    except Refused as error:
        raise UserError(
            f"{source}: it holds '{error}'; only numbers, texts, lists and numpy arrays are loaded"
            + (TENSORS if str(error).startswith("torch") else "")
        ) from None
    except Exception as error:  # a damaged pickle raises nearly anything
        raise UserError(f"{source}: not a readable pickle: {' '.join(str(error).split()) or 'cut short'}") from None
    if not isinstance(entries, dict):
        raise UserError(f"{source}: it holds a {type(entries).__name__}, not a dict")
    foreign = next((key for key in entries if not isinstance(key, str)), None)
    if foreign is not None:
        raise UserError(f"{source}: a key in it is a {type(foreign).__name__}, not a text")
    return ArrayReader(source, entries)


def one_motion(reader: ArrayReader) -> ArrayReader:
    """Return the one motion of a file that stores motions by name, as PHC and ASAP do; raises UserError for several."""
    entries = reader.entries
    if not entries or not all(isinstance(entry, dict) for entry in entries.values()):
        return reader
    if len(entries) > 1:
        names = ", ".join(list(entries)[:5]) + (", ..." if len(entries) > 5 else "")
        raise UserError(f"{reader.where}: it holds {len(entries)} motions: {names}; save one of them alone")
    return ArrayReader(reader.where, {str(key): value for key, value in next(iter(entries.values())).items()})


def dump(entries: Mapping[str, object], target: Path) -> None:
    """Write a dict for all versions of NumPy: version 2 renamed a module in pickles, and still reads the old name."""
    target.write_bytes(pickle.dumps(entries, protocol=3).replace(b"cnumpy._core.", b"cnumpy.core."))
