"""Pickles of plain data: dicts, lists, numbers, texts and NumPy arrays; any other content is refused.

A pickle calls functions by name, so that loading it in Python can execute anything. Here `Unpickler.find_class` offers
only safe constructors. NumPy's constructors trust a pickle's description of a type, which may claim that text is
references, or that items are longer than the data. Those here take only the number of items and one of a few fixed
types from the pickle. Instructions that set attributes or need extensions are not supported.
"""

from __future__ import annotations

import io
import pickle
import pickletools
import re
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ..errors import UserError, words_of
from ..system import size_limit
from .array_reader import ArrayReader

ADVICE = {  # by the first word of a name
    "torch": ": save its tensors as arrays in Python, with .numpy(), and dump it again",
    "joblib": ": load it in Python with joblib, and dump it again with pickle",
}
STEP_BYTES = 100  # most memory of an instruction without data: an empty dict and its entry
LARGEST_INTEGER = 64  # [bits]
INSTRUCTIONS = """
    MARK STOP POP POP_MARK NONE NEWTRUE NEWFALSE INT BININT BININT1 BININT2 LONG LONG1 LONG4 FLOAT BINFLOAT
    STRING BINSTRING SHORT_BINSTRING UNICODE BINUNICODE SHORT_BINUNICODE BINUNICODE8 BINBYTES SHORT_BINBYTES BINBYTES8
    BYTEARRAY8 EMPTY_LIST LIST APPEND APPENDS EMPTY_DICT DICT SETITEM SETITEMS EMPTY_TUPLE TUPLE TUPLE1 TUPLE2 TUPLE3
    PUT BINPUT LONG_BINPUT MEMOIZE GET BINGET LONG_BINGET PROTO FRAME GLOBAL STACK_GLOBAL REDUCE NEWOBJ BUILD
"""
COMPRESSED = (b"\x78", b"\x1f\x8b", b"BZh", b"\xfd7z")  # first bytes of zlib, gzip, bz2 and xz
FIXED = re.compile(r"b1|[iu][1248]|f[248]|[SU][1-9][0-9]{0,5}|O8?")
ORDERS: dict[str, Literal["<", ">", "|"]] = {"<": "<", ">": ">", "|": "|"}


class Refused(Exception):
    """The error for a pickle with anything but plain data."""


class _Type:
    """Replaces numpy.dtype(text, align, copy); of its state only the byte order is used, and `dtype` is None before."""

    dtype: np.dtype[Any] | None = None

    def __init__(self, text: Any = None, *_: Any) -> None:
        if not isinstance(text, str) or not FIXED.fullmatch(text):
            raise Refused(f"numpy.dtype {text}" if isinstance(text, str) else "numpy.dtype")
        self.text = text

    def __setstate__(self, state: Any) -> None:
        if type(state) is not tuple or len(state) < 5 or any(part is not None for part in state[2:5]):
            raise Refused("numpy.dtype of several parts")
        order = ORDERS.get(state[1]) if isinstance(state[1], str) else None
        if order is None:
            raise Refused("numpy.dtype in no order of bytes")
        self.dtype = np.dtype(self.text).newbyteorder(order)


class _Array(np.ndarray[Any, Any]):
    """An array that takes its content from a pickle's state after a check."""

    def __setstate__(self, state: Any) -> None:
        if type(state) is not tuple or len(state) != 5:
            raise Refused("an array without its state")
        _, shape, kind, fortran, data = state
        array = _items(kind, data, shape, "F" if fortran is True or fortran == 1 else "C")
        items = array.ravel().tolist() if array.dtype.kind == "O" else array.tobytes()
        numpy_state: Any = (1, array.shape, array.dtype, False, items)
        super().__setstate__(numpy_state)


def _array(*_: Any) -> _Array:
    """Replace numpy._reconstruct(ndarray, (0,), b"b"); the state contains the array."""
    return _Array((0,), object)


def _items(kind: Any, data: Any, shape: Any, order: Any = "C") -> Any:
    """Return an array; raises Refused or ValueError unless the data are exactly its items."""
    kind = kind.dtype if isinstance(kind, _Type) else None
    if kind is None:
        raise Refused("an array without its type")
    if kind.kind == "O" and isinstance(data, list):
        items = np.empty(len(data), object)
        for place, item in enumerate(data):
            items[place] = item
        return items.reshape(shape)  # references are in C order, whatever that of the array
    if not isinstance(data, bytes | bytearray) or kind.kind == "O":
        raise Refused("an array without its items")
    array = np.ndarray(shape, "u1" if kind.kind == "b" else kind, data, order=order)
    if array.nbytes != len(data):
        raise Refused(f"an array of {array.size} {kind} that are not there")
    if kind.kind == "U" and np.any(np.frombuffer(data, kind.byteorder.replace("|", "=") + "u4") > sys.maxunicode):
        raise Refused("a text of invalid characters")
    return array != 0 if kind.kind == "b" else array


def _array_of_bytes(data: Any, kind: Any, shape: Any, order: Any = "C", axes: Any = None) -> Any:
    """Replace numpy._frombuffer(data, dtype, shape, order, axis order)."""
    if order == "K" and axes is not None:
        return _items(kind, data, shape).transpose(axes)
    return _items(kind, data, shape, "F" if order == "F" else "C")


def _scalar(kind: Any, data: Any) -> Any:
    return _items(kind, data, ())[()]


def _class(*_: Any) -> Any:
    """Replace numpy.ndarray, which occurs only as an argument of other calls."""
    raise Refused("a call of numpy.ndarray")


def _latin(text: Any, encoding: Any) -> bytes:
    """Return bytes, as protocol 2 writes them."""
    if not isinstance(text, str) or encoding not in ("latin1", "latin-1"):
        raise Refused("bytes in another encoding")
    return text.encode("latin1")


CONSTRUCTORS: Mapping[tuple[str, str], Callable[..., Any]] = {
    ("numpy", "dtype"): _Type,
    ("numpy", "ndarray"): _class,
    ("_codecs", "encode"): _latin,
    ("__builtin__", "bytes"): lambda: b"",  # as protocol 2 writes empty bytes
    ("builtins", "bytes"): lambda: b"",
    ("collections", "OrderedDict"): dict,  # whose entries follow
    **{
        (f"numpy.{core}.{module}", name): make
        for core in ("core", "_core")  # before and since numpy 2
        for module, name, make in (
            ("multiarray", "_reconstruct", _array),
            ("multiarray", "scalar", _scalar),
            ("numeric", "_frombuffer", _array_of_bytes),
        )
    },
}


InPython: Any = pickle._Unpickler  # whose instructions can be replaced


class _Unpickler(InPython):
    """Loads plain data from a stream; size [bytes]: of the file, to which those of its instructions are added."""

    def __init__(self, stream: io.BytesIO, size: int, where: object) -> None:
        super().__init__(stream, encoding="latin1")
        self.size, self.where, self.most = size, where, size_limit.bound()

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
        """Raise Refused for a long integer at the top of the stack."""
        top = self.stack[-1] if self.stack else None
        if isinstance(top, int) and top.bit_length() > LARGEST_INTEGER:
            raise Refused(f"an integer of {top.bit_length()} bits")

    def load_build(self) -> None:
        """Complete an array or a type by its state; no other object has one."""
        state = self.stack.pop()
        blank = self.stack[-1]
        if not isinstance(blank, _Type | _Array):
            raise Refused("a state of an object without one")
        blank.__setstate__(state)

    def load_bytearray8(self) -> None:
        """Load as in Python, but allocate no memory for missing bytes."""
        self.append(bytearray(self.read(int.from_bytes(self.read(8), "little"))))


def _check(name: str) -> tuple[int, Callable[[_Unpickler], None]]:
    code = getattr(pickle, name)[0]
    overrides = {"BUILD": _Unpickler.load_build, "BYTEARRAY8": _Unpickler.load_bytearray8}
    run = overrides.get(name) or InPython.dispatch[pickle.REDUCE[0] if name == "NEWOBJ" else code]

    def checked(unpickler: _Unpickler) -> None:
        unpickler.count()
        run(unpickler)
        unpickler.check_top()

    return code, checked


def _refuse(name: str) -> Callable[[_Unpickler], None]:
    def refuse(unpickler: _Unpickler) -> None:
        raise Refused(name)

    return refuse


_Unpickler.dispatch = {ord(opcode.code): _refuse(opcode.name) for opcode in pickletools.opcodes}
_Unpickler.dispatch |= map(_check, INSTRUCTIONS.split())


def load(source: Path) -> ArrayReader:
    """Return the dict in a pickle; raises UserError if it is damaged or contains more than plain data."""
    try:
        data = source.read_bytes()
        if data.startswith(COMPRESSED):
            raise UserError(f"{source}: a compressed file; load it in Python and dump it again with pickle")
        entries = _Unpickler(io.BytesIO(data), len(data), source).load()
    except (UserError, OSError, MemoryError):
        raise
    except Refused as error:
        raise UserError(
            f"{source}: it holds '{error}'; only numbers, texts, lists and numpy arrays are loaded"
            + next((advice for name, advice in ADVICE.items() if str(error).startswith(name)), "")
        ) from None
    except Exception as error:  # a damaged pickle raises nearly anything
        raise UserError(f"{source}: not a readable pickle: {words_of(error) or 'cut short'}") from None
    if not isinstance(entries, dict):
        raise UserError(f"{source}: it holds a {type(entries).__name__}, not a dict")
    foreign = next((key for key in entries if not isinstance(key, str)), None)
    if foreign is not None:
        raise UserError(f"{source}: a key in it is a {type(foreign).__name__}, not a text")
    return ArrayReader(source, entries)


def dump(entries: Mapping[str, object], target: Path) -> None:
    """Write a dict for all versions of NumPy: version 2 renamed a module in pickles, and still reads the old name."""
    target.write_bytes(pickle.dumps(entries, protocol=3).replace(b"cnumpy._core.", b"cnumpy.core."))
