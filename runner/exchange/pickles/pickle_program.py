"""The program that a pickle is, run here step by step on plain data, with no way out to anything else.

Python's own unpickler calls what a pickle names, sets the state of whatever it made, and makes room for what a file
only claims to hold. This one knows dicts, lists, tuples, numbers, texts and bytes, and asks `Makers` for the rest: what
a name calls, and with that what may be made. The steps are told apart by `pickletools`.
"""

from __future__ import annotations

import io
import pickletools
from collections.abc import Callable, Mapping
from typing import Any, BinaryIO

from ...system import largest

STEP_BYTES = 100  # the most that a step other than of bytes or text leaves in memory: an empty dict and its place
LARGEST_INTEGER = 64  # [bits]; longer ones are no numbers of a motion


class Refused(Exception):
    """A pickle asks for something that is not plain data."""


class Trailing:
    """An array whose bytes follow in the stream right after it was named, as joblib writes them."""

    def __init__(self, read: Callable[[BinaryIO, Callable[[BinaryIO], Any]], Any]) -> None:
        self.read = read


class Unfinished:
    """What a call has made and a state will complete, as numpy's arrays and types are; then `value` is it."""

    def __init__(self, complete: Callable[[Any], Any]) -> None:
        self._complete = complete
        self.value: Any = None

    def build(self, state: Any) -> Any:
        """The finished thing; raises Refused the second time."""
        if self.value is not None:
            raise Refused("a state that is set twice")
        self.value = self._complete(state)
        return self.value


Make = Callable[..., Any]
Makers = Mapping[tuple[str, str], Make]

CONSTANTS = {"NONE": None, "NEWTRUE": True, "NEWFALSE": False}
GIVEN = {
    "INT", "BININT", "BININT1", "BININT2", "LONG", "LONG1", "LONG4", "FLOAT", "BINFLOAT",
    "STRING", "BINSTRING", "SHORT_BINSTRING", "UNICODE", "BINUNICODE", "SHORT_BINUNICODE", "BINUNICODE8",
    "BINBYTES", "SHORT_BINBYTES", "BINBYTES8", "BYTEARRAY8",
}  # fmt: skip
EMPTY: dict[str, Callable[[], Any]] = {"EMPTY_LIST": list, "EMPTY_DICT": dict, "EMPTY_TUPLE": tuple}
TUPLES = {"TUPLE1": 1, "TUPLE2": 2, "TUPLE3": 3}
KEPT = {"PUT", "BINPUT", "LONG_BINPUT"}
FETCHED = {"GET", "BINGET", "LONG_BINGET"}
NOTHING = {"PROTO", "FRAME"}


class Machine:
    """One run of a pickle's steps.

    makers  by module and name, what may be called
    """

    def __init__(self, makers: Makers) -> None:
        self._makers = makers
        self._stack: list[Any] = []
        self._below: list[list[Any]] = []  # stacks that a mark has put aside
        self._memo: dict[int, Any] = {}
        self._stream: BinaryIO = io.BytesIO()
        self._inner: Callable[[BinaryIO], Any] = lambda _: None

    def run(self, data: bytes, where: object) -> Any:
        """What the pickle holds. Raises Refused, UserError for too much of it, or nearly anything for a damaged one."""
        return self._run(io.BytesIO(data), len(data), where)

    def _run(self, stream: BinaryIO, size: int, where: object) -> Any:
        """The same of a stream, to the pickle's end."""
        self._stream, self._inner = stream, lambda rest: Machine(self._makers)._run(rest, size, where)
        most = largest.bound()
        for step, argument, _ in pickletools.genops(stream):
            if step.name == "STOP":
                break
            size += STEP_BYTES
            if size > most:
                largest.check(where, size, "what it holds")
            self._do(step.name, argument)
        return self._stack.pop()

    def _do(self, name: str, argument: Any) -> None:
        if name in GIVEN:
            self._stack.append(_given(argument))
        elif name in KEPT:
            self._memo[argument] = self._stack[-1]
        elif name == "MEMOIZE":
            self._memo[len(self._memo)] = self._stack[-1]
        elif name in FETCHED:
            found = self._memo[argument]
            done = isinstance(found, Unfinished) and found.value is not None
            self._stack.append(found.value if done else found)
        elif name in CONSTANTS:
            self._stack.append(CONSTANTS[name])
        elif name in EMPTY:
            self._stack.append(EMPTY[name]())
        elif name in TUPLES:
            count = TUPLES[name]
            self._stack[-count:] = [tuple(self._stack[-count:])]
        elif name not in NOTHING:
            step = STEPS.get(name)
            if step is None:
                raise Refused(name)
            step(self, argument)

    def _mark(self, _: Any) -> None:
        self._below.append(self._stack)
        self._stack = []

    def _marked(self) -> list[Any]:
        """What has come since the last mark."""
        found, self._stack = self._stack, self._below.pop()
        return found

    def _pop(self, _: Any) -> None:
        if self._stack:
            self._stack.pop()
        else:
            self._marked()

    def _list(self, _: Any) -> None:
        found = self._marked()
        self._stack.append(found)

    def _tuple(self, _: Any) -> None:
        found = tuple(self._marked())
        self._stack.append(found)

    def _dict(self, _: Any) -> None:
        found = self._marked()
        self._stack.append({})
        self._set(found)

    def _append(self, _: Any) -> None:
        self._extend([self._stack.pop()])

    def _extend(self, found: list[Any]) -> None:
        onto = self._stack[-1]
        if type(onto) is not list:
            raise Refused("an item of what is no list")
        onto.extend(found)

    def _set(self, found: list[Any]) -> None:
        into = self._stack[-1]
        if type(into) is not dict or len(found) % 2:
            raise Refused("an entry of what is no dict")
        into.update(zip(found[::2], found[1::2], strict=True))

    def _set_one(self, _: Any) -> None:
        value = self._stack.pop()
        self._set([self._stack.pop(), value])

    def _global(self, argument: Any) -> None:
        module, _, name = argument.partition(" ")
        self._look_up(module, name)

    def _stack_global(self, _: Any) -> None:
        name = self._stack.pop()
        self._look_up(self._stack.pop(), name)

    def _look_up(self, module: Any, name: Any) -> None:
        make = self._makers.get((module, name))
        if make is None:
            raise Refused(f"{module}.{name}" if isinstance(module, str) and isinstance(name, str) else "no name")
        self._stack.append(make)

    def _reduce(self, _: Any) -> None:
        arguments = self._stack.pop()
        make = self._stack.pop()
        if not callable(make) or type(arguments) is not tuple:  # all that can be called came from `makers`
            raise Refused("a call of what is no function")
        self._stack.append(make(*arguments))

    def _build(self, _: Any) -> None:
        state = self._stack.pop()
        made = self._stack.pop()
        if not isinstance(made, Unfinished):
            raise Refused("a state of what has none")
        value = made.build(state)
        if isinstance(value, Trailing):
            value = made.value = value.read(self._stream, self._inner)
        self._stack.append(value)


STEPS: dict[str, Callable[[Machine, Any], None]] = {
    "MARK": Machine._mark,
    "POP": Machine._pop,
    "POP_MARK": lambda machine, _: machine._marked().clear(),
    "LIST": Machine._list,
    "TUPLE": Machine._tuple,
    "DICT": Machine._dict,
    "APPEND": Machine._append,
    "APPENDS": lambda machine, _: machine._extend(machine._marked()),
    "SETITEM": Machine._set_one,
    "SETITEMS": lambda machine, _: machine._set(machine._marked()),
    "GLOBAL": Machine._global,
    "STACK_GLOBAL": Machine._stack_global,
    "REDUCE": Machine._reduce,
    "NEWOBJ": Machine._reduce,  # the maker is a class
    "BUILD": Machine._build,
}


def _given(value: Any) -> Any:
    if isinstance(value, int) and value.bit_length() > LARGEST_INTEGER:
        raise Refused(f"an integer of {value.bit_length()} bits")
    return value
