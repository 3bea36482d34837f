"""Errors of a clip's tables in terms of its file: the place, the problem, and the expected value."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import ValidationError

from ..errors import unknown
from ..system.quantity import LARGEST
from .table import Table

LONGEST_LINE = 60  # maximum number of letters of a line of TOML in an error

# How to correct invalid TOML: the start of the parser's message, a pattern of the text at its place, and what to do.
TOML_REMEDIES = (
    ("Invalid value", r"true\b|false\b", "true and false are lower case"),
    ("Invalid value", "[“”„‘’]", "put texts in straight quotes"),
    ("Invalid value", r"([a-z_]([^,\]}#=]*[^,\]}#=\s])?)", 'texts need quotes: "{}"'),
    ("Invalid value", r"\(", "lists have square brackets: [1, 2, 3]"),
    ("Invalid value", r"[+-]?(\.\d+)", "numbers have a digit before the point: 0{}"),
    ("Invalid value", r"$|#", "write a value after ="),
    ("Expected newline", r",\s*$", "remove the last comma"),
    ("Expected newline", r",\d", "numbers have a point, not a comma"),
    ("Expected '='", r"", "write key = value; a key with spaces needs quotes"),
    ("Illegal character '\\n'", r"", 'close the text with a quote: "'),
    ("Unclosed array", r"", "put commas between the values of a list, and ] after the last"),
    ("Invalid initial character for a key part", r"$|}", "write {} tables in one line, without a comma before the }"),
    ("Invalid hex value", r"", "write paths with /"),
    ("Unescaped", r"", "write paths with /"),
    ("Cannot overwrite", r"", "give each key once"),
)
TWICE = ("Cannot declare", "Cannot overwrite", "Cannot mutate")  # messages on a table that is given twice


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
    kind = first["type"]
    location = (*inside, *first["loc"])
    names, words, actual, around, expected = _walk(location, raw, schema, len(inside), has_key=kind != "missing")
    where = "".join(f"{word}: " for word in words)
    key = ".".join(names)
    if kind == "extra_forbidden":
        above = f"{'.'.join(names[:-1])}: " if names[:-1] else ""
        return where + above + unknown("key", names[-1], _keys(around))
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
    return f"{where}{key + ' ' if key else ''}must be {expected or plain}, not {_show(actual)}"


def describe_toml(error: ValueError, text: str, schema: type[Table]) -> str:
    """Return a line on invalid TOML: the number and the text of the line, what is wrong, and what to do.

    Args:
        schema: The type of the table that the text describes.
    """
    words, _, place = str(error).rpartition(" (at ")
    match = re.fullmatch(r"line (\d+), column (\d+)\)", place)
    lines = text.replace("\r\n", "\n").split("\n")
    number, column = (int(match[1]), int(match[2])) if match else (len(lines), 1)
    if words.startswith(TWICE) and (header := re.fullmatch(r"\s*\[+\s*([\w.]+)\s*\]+\s*(#.*)?", lines[number - 1])):
        return _twice(lines, number, header[1], schema)
    line, at = lines[number - 1].strip(), lines[number - 1][column - 1 :].strip()
    shown = line if len(line) <= LONGEST_LINE else f"{line[: LONGEST_LINE - 3]}..."
    remedy = ""
    for start, pattern, advice in TOML_REMEDIES:
        match = re.match(pattern, at, re.IGNORECASE) if words.startswith(start) else None
        if match:
            remedy = f"; {advice.replace('{}', match[1]) if match.groups() else advice}"
            break
    return f"line {number}: '{shown}' is not valid TOML: {words[:1].lower()}{words[1:]}{remedy}"


def _twice(lines: list[str], number: int, name: str, schema: type[Table]) -> str:
    """Return a line on a table that is given twice, the second time in line `number`."""
    kind: Any = schema
    for part in name.split("."):
        kind = _entry(kind, part)
    if not any(get_origin(option) is list for option in _alternatives(kind)):
        return f"line {number}: a second table [{name}]; write its keys into the first one"
    single = (i for i, line in enumerate(lines, 1) if re.match(rf"\s*\[\s*{re.escape(name)}\s*\]", line))
    return f"line {next(single, number)}: [{name}] is a single table, and there are several; write [[{name}]]"


def _walk(
    location: tuple[int | str, ...], raw: object, schema: type[Table], start: int, *, has_key: bool
) -> tuple[list[str], list[str], object, Any, str]:
    """Return the keys of an error's location in the file, the labels of numbered tables around it, the value there,
    the type of the last table, and the expected value. pydantic's names of alternatives are omitted.

    start  number of parts of the location above the validated table
    has_key  whether the file has the key at the end of the location
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
        elif isinstance(here, dict) and (part in here or (i == len(location) - 1 and not has_key)):
            names.append(str(part))
            here = here.get(part, here)
            if i >= start:
                around, kind = kind, _entry(kind, part)
                expected = _expectation(kind)
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


def _expectation(kind: Any) -> str:
    """Return the value that a type expects, in words; "" if they are pydantic's."""
    if get_origin(kind) is Annotated:
        expected = [entry for entry in kind.__metadata__ if isinstance(entry, str)]
        return expected[-1] if expected else _expectation(get_args(kind)[0])
    options = get_args(kind) if get_origin(kind) in (Union, UnionType) else ()
    return next(filter(None, map(_expectation, options)), "")


def _show(value: object) -> str:
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, bool):
        return str(value).lower()
    text = repr(value) if isinstance(value, str | int | float | list) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."
