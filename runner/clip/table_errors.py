"""Errors of a clip's tables in terms of its file: the place, the problem, and the expected value."""

from __future__ import annotations

from collections.abc import Mapping

from pydantic import ValidationError

from ..errors import unknown
from ..system.quantity import LARGEST
from .table import (
    ROTATION,
    BarTable,
    BodyTable,
    BoxTable,
    ClipTable,
    ContactTable,
    GraspTable,
    KeyframeTable,
    PenaltyTable,
    RecordingTable,
    RootTable,
    RotationTable,
    SceneTable,
    SiteTable,
    SolveTable,
    SphereTable,
    StepTable,
    Table,
)


def describe(
    error: ValidationError,
    raw: Mapping[str, object],
    inside: tuple[int | str, ...] = (),
    root: type[Table] = ClipTable,
) -> str:
    """Return a line on the first error of a validation: its place in the file and the expected value.

    Args:
        inside: The location in `raw` of the table that was validated.
        root: The type of the whole file's table.
    """
    complaints = error.errors()
    telling = ("finite_number", "extra_forbidden")
    first = next((c for kind in telling for c in complaints if c["type"] == kind), complaints[0])
    names, words, actual = _walked((*inside, *first["loc"]), raw)
    where = "".join(f"{word}: " for word in words)
    key = ".".join(names)
    kind = first["type"]
    if kind == "extra_forbidden":
        if key in _RENAMED:
            return f"[[{key}]] is named [[{_RENAMED[key]}]] now"
        above = f"{'.'.join(names[:-1])}: " if names[:-1] else ""
        fields = _schema(words, names[:-1], root).model_fields
        return where + above + unknown("key", names[-1], [field.alias or name for name, field in fields.items()])
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
    expected = _EXPECTED.get(_role(words, names), plain)
    return f"{where}{key + ' ' if key else ''}must be {expected}, not {_shown(actual)}"


def _walked(location: tuple[int | str, ...], raw: object) -> tuple[list[str], list[str], object]:
    """Return the keys of an error's location in the file, the labels of numbered tables around it, and the value there.
    pydantic's names of alternatives are omitted."""
    names: list[str] = []
    words: list[str] = []
    here = raw
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
        elif isinstance(here, dict) and part in here:
            names.append(str(part))
            here = here[part]
        elif isinstance(here, dict) and i == len(location) - 1:
            names.append(str(part))
    return names, words, here


def _role(words: list[str], names: list[str]) -> str:
    """Return the kind of an entry by its key; joints are entries by name."""
    if words and words[0].startswith("penalty") and names and names[0] in _OF_PENALTIES:
        return _OF_PENALTIES[names[0]]
    if len(names) == 2 and names[0] in _NAMED:
        return _NAMED[names[0]][0]
    if words and words[0].startswith(("contact", "grasp")) and names:
        return {"from": "time", "to": "time", "position": "obstacle's position", "body": "body's name"}.get(
            names[-1], names[-1]
        )
    if words and words[0].startswith("scene.") and names[-1:] in (["position"], ["rotation"]):
        return f"obstacle's {names[-1]}"
    if words and words[0].startswith("scene.") and names[-1:] == ["body"]:
        return "body's name"
    return names[-1] if names else ""


def _schema(words: list[str], names: list[str], root: type[Table]) -> type[Table]:
    if len(names) == 2 and names[0] in _NAMED:
        return _NAMED[names[0]][1]
    if names:
        return _TABLES[names[-1]]
    return _TABLES[words[0].split()[0]] if words else root


def _shown(value: object) -> str:
    if isinstance(value, dict):
        return "a table"
    if isinstance(value, bool):
        return str(value).lower()
    text = repr(value) if isinstance(value, str | int | float | list) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."


_RENAMED = {"hold": "grasp"}  # tables of a clip
_OF_PENALTIES = {"weight": "weight", "bodies": "bodies of a penalty", "axis": "axis of a penalty"}
_NAMED: dict[str, tuple[str, type[Table]]] = {
    "joints": ("joint", RotationTable),
    "roots": ("root", RootTable),
    "sites": ("site", SiteTable),
    "bodies": ("body", BodyTable),
}
_TABLES: dict[str, type[Table]] = {
    "keyframe": KeyframeTable,
    "penalty": PenaltyTable,
    "contact": ContactTable,
    "grasp": GraspTable,
    "scene": SceneTable,
    "step": StepTable,
    "scene.box": BoxTable,
    "scene.sphere": SphereTable,
    "scene.capsule": BarTable,
    "scene.cylinder": BarTable,
    "solve": SolveTable,
    "recording": RecordingTable,
    "root": RootTable,
    "rotation": RotationTable,
}

_NUMBERS = ("time", "fps", "x", "y", "height", "length", "width", "weight", "margin", "least_bend", "sideways", "twist")
_OF_OTHERS = ("angular", "friction", "heading", "mass", "period", "radius", "reach", "speed", "turn")
_WHOLE = ("variable", "frames", "evaluations", "samples")
_EXPECTED = {
    **dict.fromkeys((*_NUMBERS, *_OF_OTHERS, "threshold", "tolerance"), "a number"),
    **dict.fromkeys(_WHOLE, "a whole number"),
    **dict.fromkeys(("kind", "criterion", "optimiser", "order", "point", "hand"), "a word in quotes"),
    **dict.fromkeys(("points", "bend_joints", "bodies of a penalty"), "a list of names"),
    "intervals": "a list of [from, to] in seconds",
    "others": "'free', 'rest', 'previous' or 'key:NAME', a <key> of the model",
    "figure": "the name of a figure or a path in quotes",
    "keyframe": "[[keyframe]] tables",
    "penalty": "[[penalty]] tables",
    "contact": "[[contact]] tables",
    "grasp": "[[grasp]] tables",
    **{kind: f"[[scene.{kind}]] tables" for kind in ("box", "sphere", "capsule", "cylinder")},
    **dict.fromkeys(("obstacle's position", "from", "to"), "[x, y, z] in metres"),
    "root": "a table: position and rotation of a free joint",
    "obstacle's rotation": ROTATION,
    "size": "[length, width, height] in metres",
    "color": "[red, green, blue, opacity], each from 0 to 1",
    **dict.fromkeys(("name", "body's name"), "a name in quotes"),
    "position": '[x, y, z] in metres, each a number or "free"',
    "rotation": f'{ROTATION} or "free"',
    "joint": f'{ROTATION}, a number or "free"',
    "site": '[x, y, z] in metres, each a number or "free", or {position = [x, y, z], by = "pose" or "search"}',
    "body": f"{{flat = true}} or a rotation, {ROTATION}, or {{position = [x, y, z]}}",
    "at": "[x, y, z] in metres, in the body's own axes",
    "axis of a penalty": "[x, y, z] in the body's own axes",
    "by": "'pose' or 'search'",
    "flat": "true",
    "self": "true or false",
    "rotvec": "three angles [x, y, z] in degrees",
    "euler": "a list of angles in degrees",
    "quat": "four numbers [w, x, y, z]",
    "coordinates": "'auto', 'world' or 'joint'",
    "ends": "'free', 'clamped', 'clamped start', 'clamped end' or 'periodic'",
    "travel": "[x, y, z] in metres",
    "quadrature": "'gauss' or 'uniform'",
}
