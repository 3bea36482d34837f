"""Errors of a clip's tables in terms of its file: the place, the problem, and the expected value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import ValidationError

from ..errors import unknown
from ..system.quantity import LARGEST
from .table import Expected, Table

RENAMED = {"hold": "grasp"}  # tables of a clip


def describe(
    error: ValidationError, raw: Mapping[str, object], schema: type[Table], inside: tuple[int | str, ...] = ()
) -> str:
    """Return a line on the first error of a validation: its place in the file and the expected value.

    Args:
        schema: The type of the table that was validated.
        inside: The location of this table in `raw`.
    """
    complaints = error.errors()
    telling = ("finite_number", "extra_forbidden")
    first = next((c for kind in telling for c in complaints if c["type"] == kind), complaints[0])
    names, words, actual, around, expected = _walked((*inside, *first["loc"]), raw, schema, len(inside))
    where = "".join(f"{word}: " for word in words)
    key = ".".join(names)
    kind = first["type"]
    if kind == "extra_forbidden":
        if key in RENAMED:
            return f"[[{key}]] is named [[{RENAMED[key]}]] now"
        above = f"{'.'.join(names[:-1])}: " if names[:-1] else ""
        return where + above + unknown("key", names[-1], _keys(around))
    if names[-1:] == ["others"] and actual == "hold":
        return f"{where}others = 'hold' is named others = 'previous' now"
    if kind == "missing" and isinstance(first["loc"][-1], str):
        return f"{where}'{key}' is missing"
    if kind == "value_error":
        return f"{where}{key + ': ' if key else ''}{first.get('ctx', {}).get('error')}"
    if kind == "finite_number":
        return f"{where}{key or 'number'} must be a finite number, not {actual}"
    for start, bound in (("greater_than_equal", "at least"), ("greater_than", "above"), ("less_than", "at most")):
        if kind.startswith(start):
            limit = next(iter(first.get("ctx", {}).values()))
            return f"{where}{key} must be {bound} {limit:g}, not {actual}"
    plain = "a table" if kind.endswith(("model_type", "dict_type")) else first["msg"].removeprefix("Input should be ")
    return f"{where}{key + ' ' if key else ''}must be {expected or plain}, not {_shown(actual)}"


def _walked(
    location: tuple[int | str, ...], raw: object, schema: type[Table], start: int
) -> tuple[list[str], list[str], object, Any, str]:
    """Return the keys of an error's location in the file, the labels of numbered tables around it, the value there,
    the type of the last table, and the expected value. pydantic's names of alternatives are omitted.

    start  number of parts of the location above the validated table
    """
    names: list[str] = []
    words: list[str] = []
    here, kind, around, expected = raw, schema, schema, ""
    for i, part in enumerate(location):
        if isinstance(here, list) and isinstance(part, int) and part < len(here):
            here = here[part]
            if i == 2 and names[0] == "scene":
                name = here.get("name") if isinstance(here, dict) else None
                words.append(f"{'.'.join(names)} {part + 1}" + (f" ('{name}')" if isinstance(name, str) else ""))
                names.clear()
            if i == 1:
                time = here.get("time") if isinstance(here, dict) else None
                is_time = isinstance(time, int | float) and not isinstance(time, bool) and abs(time) <= LARGEST
                words.append(f"{names.pop()} {part + 1}" + (f" (t = {time:g} s)" if is_time else ""))
            if not names:
                kind, expected = (_entry(kind, part) if i >= start else kind), ""
        elif isinstance(here, dict) and (part in here or i == len(location) - 1):
            names.append(str(part))
            here = here.get(part, here)
            if i >= start:
                around, kind = kind, _entry(kind, part)
                expected = _expected(kind)
    return names, words, here, around, expected


def _alternatives(kind: Any) -> Iterator[Any]:
    """Yield the types of which a value may be."""
    if get_origin(kind) is Annotated:
        yield from _alternatives(get_args(kind)[0])
    elif get_origin(kind) in (Union, UnionType):
        for option in get_args(kind):
            yield from _alternatives(option)
    else:
        yield kind


def _entry(kind: Any, key: int | str) -> Any:
    """Return the type of an entry of a table or list; None for an unknown one."""
    for option in _alternatives(kind):
        if isinstance(option, type) and issubclass(option, Table):
            for name, field in option.model_fields.items():
                if key == (field.alias or name):
                    annotation: Any = field.annotation
                    return Annotated[annotation, *field.metadata, None]
        elif get_origin(option) in (dict, list):
            return get_args(option)[-1]
    return None


def _keys(kind: Any) -> list[str]:
    tables = (option for option in _alternatives(kind) if isinstance(option, type) and issubclass(option, Table))
    return [field.alias or name for table in tables for name, field in table.model_fields.items()]


def _expected(kind: Any) -> str:
    """Return the value that a type expects, in words; "" if they are pydantic's."""
    if get_origin(kind) is Annotated:
        given = [entry.words for entry in kind.__metadata__ if isinstance(entry, Expected)]
        return given[-1] if given else _expected(get_args(kind)[0])
    options = get_args(kind) if get_origin(kind) in (Union, UnionType) else ()
    return next(filter(None, map(_expected, options)), "")


def _shown(value: object) -> str:
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, bool):
        return str(value).lower()
    text = repr(value) if isinstance(value, str | int | float | list) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."
