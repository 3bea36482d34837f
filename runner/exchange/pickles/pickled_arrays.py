"""The names that a pickle of plain data calls, each with a safe constructor.

NumPy's constructors trust a pickle's description of a type, which may claim that text is references, or that items are
longer than the data. These constructors take only the number of items and one of a few fixed types from the pickle.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from typing import Any, BinaryIO, Literal

import numpy as np

FIXED = re.compile(r"b1|[iu][1248]|f[248]|[SU][1-9][0-9]{0,5}|O8?")
ORDERS: dict[str, Literal["<", ">", "|"]] = {"<": "<", ">": ">", "|": "|"}
LAST_CHARACTER = 0x10FFFF  # of Unicode


class Refused(Exception):
    """The error for a pickle with anything but plain data."""


class Trailing:
    """An array whose bytes follow its description in the stream, as joblib writes it.

    read  returns the array from the stream and a function that loads a nested pickle
    """

    def __init__(self, read: Callable[[BinaryIO, Callable[[], Any]], Any]) -> None:
        self.read = read


class Unfinished:
    """The result of a call that a later state completes, such as NumPy's arrays and types; `value` when completed."""

    def __init__(self, complete: Callable[[Any], Any]) -> None:
        self.complete = complete
        self.value: Any = None


def _type(text: Any = None, *_: Any) -> Unfinished:
    """Replace numpy.dtype(text, align, copy); of its state only the byte order is used."""
    if not isinstance(text, str) or not FIXED.fullmatch(text):
        raise Refused(f"numpy.dtype {text}" if isinstance(text, str) else "numpy.dtype")

    def complete(state: Any) -> np.dtype[Any]:
        if type(state) is not tuple or len(state) < 5 or any(part is not None for part in state[2:5]):
            raise Refused("numpy.dtype of several parts")
        order = ORDERS.get(state[1]) if isinstance(state[1], str) else None
        if order is None:
            raise Refused("numpy.dtype in no order of bytes")
        return np.dtype(text).newbyteorder(order)

    return Unfinished(complete)


def _items(kind: Any, data: Any, shape: Any, order: Any = "C") -> Any:
    """Return an array; raises Refused or ValueError unless the data are exactly its items."""
    if not isinstance(kind, np.dtype):
        raise Refused("an array without its type")
    if kind.kind == "O" and isinstance(data, list):
        items = np.empty(len(data), object)
        for place, item in enumerate(data):
            items[place] = item
        return items.reshape(shape, order=order)
    if not isinstance(data, bytes | bytearray) or kind.kind == "O":
        raise Refused("an array without its items")
    array = np.ndarray(shape, "u1" if kind.kind == "b" else kind, data, order=order)
    if array.nbytes != len(data):
        raise Refused(f"an array of {array.size} {kind} that are not there")
    if kind.kind == "U" and np.any(np.frombuffer(data, kind.byteorder.replace("|", "=") + "u4") > LAST_CHARACTER):
        raise Refused("a text of invalid characters")
    return array != 0 if kind.kind == "b" else array


def _array(*_: Any) -> Unfinished:
    """Replace numpy._reconstruct(ndarray, (0,), b"b"); the state contains the array."""

    def complete(state: Any) -> Any:
        if type(state) is not tuple or len(state) != 5:
            raise Refused("an array without its state")
        _, shape, kind, fortran, data = state
        return _items(kind, data, shape, "F" if fortran is True or fortran == 1 else "C")

    return Unfinished(complete)


def _joblib_array() -> Unfinished:
    """Replace joblib.numpy_pickle.NumpyArrayWrapper: its state has type and shape; the bytes follow in the stream."""

    def complete(state: Any) -> Trailing:
        if type(state) is not dict or not isinstance(state.get("dtype"), np.dtype):
            raise Refused("an array of joblib without its state")
        return Trailing(lambda stream, inner: _after(stream, inner, state))

    return Unfinished(complete)


def _after(stream: BinaryIO, inner: Callable[[], Any], state: dict[str, Any]) -> Any:
    """Return the array at the current position of a joblib file: a nested pickle for objects, else padded bytes."""
    kind, shape = state["dtype"], state.get("shape")
    if kind.kind == "O":
        return inner()
    if type(state.get("numpy_array_alignment_bytes")) is int:
        stream.read(stream.read(1)[0])
    if type(shape) is not tuple or not all(type(n) is int and n >= 0 for n in shape):
        raise Refused("an array without its shape")
    data = stream.read(math.prod(shape) * kind.itemsize)
    return _items(kind, data, shape, "F" if state.get("order") == "F" else "C")


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


def _no_bytes() -> bytes:
    """Return empty bytes, as protocol 2 writes them."""
    return b""


def _ordered() -> dict[Any, Any]:
    """Replace an OrderedDict, whose entries follow."""
    return {}


CONSTRUCTORS: Mapping[tuple[str, str], Callable[..., Any]] = {
    ("numpy", "dtype"): _type,
    ("numpy", "ndarray"): _class,
    ("joblib.numpy_pickle", "NumpyArrayWrapper"): _joblib_array,
    ("_codecs", "encode"): _latin,
    ("__builtin__", "bytes"): _no_bytes,
    ("builtins", "bytes"): _no_bytes,
    ("collections", "OrderedDict"): _ordered,
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
