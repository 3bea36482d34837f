"""Tables of keys in docs/clip.md, generated from the clip schema by `python docs/reference.py`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

from pydantic.fields import FieldInfo

from dynsplines.clip import table
from dynsplines.clip.kinds import KINDS

PAGE = Path(__file__).parent / "clip.md"
MARKS = "<!-- {}: written by docs/reference.py -->\n\n", "\n<!-- end -->\n"
ROTATION = {
    "rotvec": "axis times angle, degrees",
    "euler": "intrinsic angles about the axes of `order`, degrees",
    "order": 'axes of `euler`, default "xyz"',
    "quat": "w, x, y, z",
    "heading": "degrees about the vertical, applied last; only for rotations in the world",
}
OBSTACLE = {
    "name": "its name in messages",
    "body": "the free body that it belongs to; positions are then in that body's axes",
    "mass": "kg, of a part of a free body",
    "color": "red, green, blue, opacity, each from 0 to 1",
    "position": "m, of its centre",
    "rotation": "a rotation",
}
BAR = {"radius": "m", "length": "m, about `position`", "from": "m, one end", "to": "m, the other"} | OBSTACLE
TABLES: dict[str, tuple[type[table.Table], dict[str, str]]] = {
    "the clip": (
        table.ClipTable,
        {
            "figure": "name of a shipped figure, or path to MJCF",
            "fps": "samples per second of outputs",
            "keyframe": "two or more, in order of time",
            "scene": "obstacles and objects",
            "contact": "points at rest for an interval",
            "hold": "hands that hold a body for an interval",
            "recording": "a motion to follow; keyframes edit it",
            "penalty": "soft constraints that differ from the defaults",
            "solve": "settings of the search",
        },
    ),
    "[[keyframe]]": (
        table.KeyframeTable,
        {
            "time": "s",
            "root": "the articulated tree on legs, or else the first free body",
            "roots": "other free bodies and robots, by the name of their joint or body",
            "joints": "by name: a rotation for a ball joint, degrees for a hinge, metres for a slide",
            "sites": "target positions of sites, feet, geoms and bodies by name",
            "bodies": "target orientations or positions by name",
            "others": "unspecified joints and root: free, at rest, as in the keyframe before, or as in a `<key>` of "
            'the model, "key:NAME"',
        },
    ),
    "root, roots.NAME": (table.RootTable, {"position": "m, in the world", "rotation": "a rotation in the world"}),
    "a rotation": (table.RotationTable, ROTATION),
    "sites.NAME": (
        table.SiteTable,
        {"position": "m, in the world; short form: `[x, y, z]`", "by": "solved as a pose, or left to the search"},
    ),
    "bodies.NAME": (
        table.BodyTable,
        {
            "flat": "whether its sole is parallel to the ground",
            "position": "m, in the world: of its origin, or of the point `at`",
            "at": "m, in the body's axes",
        }
        | ROTATION,
    ),
    "[[contact]]": (
        table.ContactTable,
        {
            "point": "a site, foot, geom or body",
            "from": "s",
            "to": "s",
            "position": "m, default: that of the keyframes in between",
        },
    ),
    "[[hold]]": (
        table.HoldTable,
        {
            "hand": "a site, foot, geom or body",
            "body": "the held body",
            "from": "s",
            "to": "s",
            "position": "m, in that body's axes, default: that of the keyframes",
        },
    ),
    "[scene] step": (
        table.StepTable,
        {"x": "m, of its front face", "height": "m", "length": "m, along x", "width": "m, along y", "y": "m"},
    ),
    "[[scene.box]]": (table.BoxTable, {"size": "m, full edge lengths along x, y and z"} | OBSTACLE),
    "[[scene.sphere]]": (table.SphereTable, {"radius": "m"} | OBSTACLE),
    "[[scene.capsule]], [[scene.cylinder]]": (table.BarTable, BAR),
    "[recording]": (
        table.RecordingTable,
        {
            "file": "a motion (.npz), a recording (.bvh, ...) or a clip, relative to the clip; or a shipped clip",
            "repeat": "number of repetitions of a loop",
            "from": "s of the recording, start of the used part",
            "to": "s",
            "at": "s of the clip, start of the used part; default: as in the recording",
            "speed": "speed factor",
            "times": "pairs of times, s of the recording and of the clip, instead of `at` and `speed`",
            "weight": "weight of the recording",
            "blend": "s before and after every keyframe; the recording is unchanged elsewhere",
        },
    ),
    "[solve]": (
        table.SolveTable,
        {
            "coordinates": "of the spline: quaternions of bodies in the world, or of joints",
            "ends": "of the spline: free; at rest at both ends or at one, the default where the figure stands on all "
            "feet or repeats the neighbouring keyframe; or a loop's",
            "travel": "m, displacement of a loop's root per period; default: that of the keyframes",
            "turn": "degrees, rotation of a loop's root per period; default: that of the keyframes",
            "variable": "initial number of variable frames between two keyframes",
            "frames": "maximum number of variable frames",
            "criterion": 'of inserting frames: "weak", "residual", "objective", "resolution"',
            "threshold": "of the criterion",
            "optimiser": 'of NLopt, for the last stage: "lbfgs", "slsqp", "ccsaq", "tnewton", "var2"; or "none"',
            "evaluations": "maximum number of evaluations of the objective in a round",
            "tolerance": "relative decrease at which the search ends",
            "quadrature": "of the objective's integral",
            "samples": 'per panel, or in total with "uniform"',
        },
    ),
}


def default(field: FieldInfo) -> str:
    """The default of a key, as text."""
    if field.is_required():
        return "required"
    value = field.default
    if value is None or value in ([], {}) or isinstance(value, table.Table):
        return ""
    words = f'"{value}"' if isinstance(value, str) else f"{value:g}"
    within = [choice for part in get_args(field.annotation) if part is not float for choice in (part, *get_args(part))]
    choices = [choice for choice in within if isinstance(choice, str)]
    others = [f'"{choice}"' for choice in choices if choice != value]
    return words + (f"; or {', '.join(others)}" if others else "")


def keys() -> Iterator[str]:
    """A table of every table's keys. Raises ValueError where the schema and the texts here have different ones."""
    for name, (schema, texts) in TABLES.items():
        fields = {field.alias or key: field for key, field in schema.model_fields.items()}
        if fields.keys() != texts.keys():
            raise ValueError(f"{name}: {sorted(fields.keys() ^ texts.keys())}")
        yield f"| `{name}` | | |" if name not in ("the clip", "a rotation") else f"| {name} | | |"
        yield "|---|---|---|"
        yield from (f"| `{key}` | {text} | {default(fields[key])} |" for key, text in texts.items())
        yield ""


def kinds() -> Iterator[str]:
    """The soft constraints."""
    yield "| `kind` | part | default weight | penalised quantity | options |"
    yield "|---|---|---|---|---|"
    for kind in KINDS.values():
        options = ", ".join(f"`{name}` ({text})" for name, text in kind.choices().items())
        for i, part in enumerate(kind.parts):
            small = re.sub(r'(<\w+>|\[\[\w+\]\]|by = "\w+")', r"`\1`", part.quantity)
            weight = f"{part.weight:g}" + (
                f" with `{part.option}`" if part.option else "" if kind.is_default else ", if listed"
            )
            first = (f"`{kind.name}`", options) if i == 0 else ("", "")
            yield f"| {first[0]} | {f'`{part.name}`' if part.name else ''} | {weight} | {small} | {first[1]} |"


def written(page: str) -> str:
    """The page with updated tables."""
    for name, lines in (("keys", keys()), ("kinds", kinds())):
        begin, end = MARKS[0].format(name), MARKS[1]
        text = begin + "\n".join(lines).rstrip() + "\n" + end
        page = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _, text=text: text, page, flags=re.DOTALL)
    return page


if __name__ == "__main__":
    PAGE.write_text(written(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
