"""numpy's arrays as pickles spell them, made from bytes whose count is checked, of a few fixed types.

numpy's own functions take the file's word for how a type is laid out: for texts that are references, for items longer
than the bytes there are. So nothing of what a pickle says reaches them but the number of items and one of these types.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, BinaryIO, Literal

import numpy as np

from ...system import largest
from .pickle_program import Makers, Refused, Trailing, Unfinished

FIXED = re.compile(r"b1|[iu][1248]|f[248]|[SU][1-9][0-9]{0,5}|O8?")
ORDERS: dict[str, Literal["<", ">", "|"]] = {"<": "<", ">": ">", "|": "|"}
MOST_AXES = 32  # of NumPy's arrays
LAST_CHARACTER = 0x10FFFF  # of Unicode


@dataclass(frozen=True)
class Type:
    """A type of items: booleans, whole numbers, floating point, bytes, texts; `numpy` None: any plain data."""

    numpy: np.dtype[Any] | None

    def of(self, data: object, shape: object, order: str) -> Any:
        """An array; raises Refused unless the data are just its items."""
        axes = _axes(shape)
        count = math.prod(axes)
        if self.numpy is None:
            if type(data) is not list or len(data) != count:
                raise Refused("an array without its items")
            items = np.empty(count, object)
            for place, item in enumerate(data):
                items[place] = item
        else:
            if not isinstance(data, bytes | bytearray) or len(data) != count * self.numpy.itemsize:
                raise Refused(f"an array of {count} {self.numpy} that are not there")
            items = self._read(data)
        return items.reshape(axes, order="F" if order == "F" else "C")

    def _read(self, data: bytes | bytearray) -> Any:
        assert self.numpy is not None
        if self.numpy.kind == "b":
            return np.frombuffer(data, "u1") != 0
        if self.numpy.kind == "U":
            letters = np.frombuffer(data, self.numpy.byteorder.replace("|", "=") + "u4")
            if np.any(letters > LAST_CHARACTER):
                raise Refused("a text of no letters")
        return np.frombuffer(data, self.numpy)


def _axes(shape: object) -> tuple[int, ...]:
    """A shape; raises Refused for what is none."""
    if type(shape) is not tuple or len(shape) > MOST_AXES or not all(type(n) is int and n >= 0 for n in shape):
        raise Refused("an array of no shape")
    return shape


def _type(text: Any = None, *_: Any) -> Unfinished:
    """numpy.dtype(text, align, copy); its state tells the order of bytes, and what else it tells is not believed."""
    if not isinstance(text, str) or not FIXED.fullmatch(text):
        raise Refused(f"numpy.dtype {text}" if isinstance(text, str) else "numpy.dtype")

    def complete(state: Any) -> Type:
        if type(state) is not tuple or len(state) < 5 or any(part is not None for part in state[2:5]):
            raise Refused("numpy.dtype of several parts")
        if text.startswith("O"):
            return Type(None)
        order = ORDERS.get(state[1]) if isinstance(state[1], str) else None
        if order is None:
            raise Refused("numpy.dtype in no order of bytes")
        return Type(np.dtype(text).newbyteorder(order))

    return Unfinished(complete)


def _array_to_be(*_: Any) -> Unfinished:
    """numpy._reconstruct(ndarray, (0,), b"b"): all of the array is in its state."""

    def complete(state: Any) -> Any:
        if type(state) is not tuple or len(state) != 5 or not isinstance(state[2], Type):
            raise Refused("an array without its state")
        _, shape, kind, fortran, data = state
        return kind.of(data, shape, "F" if fortran is True or fortran == 1 else "C")

    return Unfinished(complete)


def _joblib_array(*arguments: Any) -> Unfinished:
    """joblib.numpy_pickle.NumpyArrayWrapper: its state has type and shape, and the bytes follow in the stream."""
    if arguments:
        raise Refused("an array of joblib with arguments")

    def complete(state: Any) -> Trailing:
        if type(state) is not dict or not isinstance(state.get("dtype"), Type):
            raise Refused("an array of joblib without its state")
        return Trailing(lambda stream, inner: _after(stream, inner, state))

    return Unfinished(complete)


def _after(stream: BinaryIO, inner: Callable[[BinaryIO], Any], state: dict[str, Any]) -> Any:
    """The array that joblib has written there: a pickle of its own for texts and lists, else padding and bytes."""
    kind, shape = state["dtype"], _axes(state.get("shape"))
    if kind.numpy is None:
        return inner(stream)
    if type(state.get("numpy_array_alignment_bytes")) is int:
        stream.read(stream.read(1)[0])
    count = math.prod(shape) * kind.numpy.itemsize
    items = stream.read(count if count <= largest.bound() else 0)
    return kind.of(items, shape, "F" if state.get("order") == "F" else "C")


def _array_of_bytes(data: Any = None, kind: Any = None, shape: Any = None, order: Any = "C", axes: Any = None) -> Any:
    """numpy._frombuffer."""
    if not isinstance(kind, Type) or kind.numpy is None:
        raise Refused("an array of no type")
    if order == "K" and axes is not None:
        if type(axes) is not tuple or type(shape) is not tuple or sorted(axes) != list(range(len(shape))):
            raise Refused("an array of no order")
        return kind.of(data, shape, "C").transpose(axes)
    return kind.of(data, shape, "F" if order == "F" else "C")


def _scalar(kind: Any = None, data: Any = None) -> Any:
    """One item."""
    if not isinstance(kind, Type) or kind.numpy is None:
        raise Refused("a number of no type")
    return kind.of(data, (), "C")[()]


def _class(*_: Any) -> Any:
    """numpy.ndarray, which is only ever named."""
    raise Refused("a call of numpy.ndarray")


def _latin(text: Any = None, encoding: Any = None) -> bytes:
    """How protocol 2 spells bytes."""
    if not isinstance(text, str) or encoding not in ("latin1", "latin-1"):
        raise Refused("bytes in another encoding")
    return text.encode("latin1")


def _no_bytes(*arguments: Any) -> bytes:
    """How protocol 2 spells none."""
    if arguments:
        raise Refused("bytes of something")
    return b""


def _ordered(*arguments: Any) -> dict[Any, Any]:
    """An OrderedDict, whose entries follow; every dict keeps its order."""
    if arguments:
        raise Refused("an OrderedDict of something")
    return {}


MAKERS: Makers = {
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
            ("multiarray", "_reconstruct", _array_to_be),
            ("multiarray", "scalar", _scalar),
            ("numeric", "_frombuffer", _array_of_bytes),
        )
    },
}
