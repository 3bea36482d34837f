"""A cache of the last few results, by the arguments that they depend on."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import fields, is_dataclass
from threading import Lock
from typing import Any, Generic, TypeVar

import numpy as np

Answer = TypeVar("Answer")


class Cache(Generic[Answer]):
    """The last results, up to a maximum number. They are shared: callers must not change them."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._answers: OrderedDict[Hashable, Answer] = OrderedDict()
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._answers)

    def get(self, key: Hashable, compute: Callable[[], Answer]) -> Answer:
        """The answer to what is asked, found if it is not known; an exception is no answer."""
        with self._lock:
            if key in self._answers:
                self._answers.move_to_end(key)
                return self._answers[key]
        answer = compute()
        with self._lock:
            self._answers[key] = answer
            if len(self._answers) > self._most:
                self._answers.popitem(last=False)
        return answer


def cache_key(value: Any) -> Hashable:
    """What two values have in common if they are the same to the bit: arrays, dataclasses and sequences by what is in
    them, all else by itself."""
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if isinstance(value, list | tuple):
        return type(value), *(cache_key(item) for item in value)
    if is_dataclass(value) and not isinstance(value, type):
        return type(value), *(cache_key(getattr(value, item.name)) for item in fields(value))
    return value
