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
    """A cache of the last results, up to a maximum number. The results are shared, so callers must not change them."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._answers: OrderedDict[Hashable, Answer] = OrderedDict()
        self._lock = Lock()

    def __len__(self) -> int:
        return len(self._answers)

    def get(self, key: Hashable, compute: Callable[[], Answer]) -> Answer:
        """Return the cached result of a key; compute and cache it first if it is missing. Exceptions are not cached."""
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
    """Return a key that is equal for values with identical contents.

    Arrays, dataclasses and sequences are compared by their contents, other values by their own equality.
    """
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if isinstance(value, list | tuple):
        return type(value), *(cache_key(item) for item in value)
    if is_dataclass(value) and not isinstance(value, type):
        return type(value), *(cache_key(getattr(value, item.name)) for item in fields(value))
    return value
