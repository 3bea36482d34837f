"""The tables of keys in docs/clip.md, from the schema that reads clips: `python docs/reference.py` writes them anew."""

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
    "euler": "angles about the axes of `order`, each as it is turned by then, degrees",
    "order": 'axes of `euler`, "xyz" if not said',
    "quat": "w, x, y, z",
    "heading": "degrees about the vertical, over the rest; of what is given in the world",
}
OBSTACLE = {
    "name": "how messages call it",
    "body": "the free body that it is a part of; then places are in that body's axes",
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
            "figure": "a name that ships, or a path to MJCF",
            "fps": "samples a second of what is written",
            "keyframe": "two or more, in order of time",
            "scene": "what stands about",
            "contact": "points that rest",
            "hold": "hands that hold on",
            "recording": "a motion that is followed; keyframes edit it",
            "penalty": "soft constraints that differ from the defaults",
            "solve": "how the search goes",
        },
    ),
    "[[keyframe]]": (
        table.KeyframeTable,
        {
            "time": "s",
            "root": "the articulated tree on legs, or else the first free body",
            "roots": "other free bodies and robots, by the name of their joint or body",
            "joints": "by name: a rotation for a ball joint, degrees for a hinge, metres for a slide",
            "sites": "sites, feet, geoms and bodies by name: where they are",
            "bodies": "by name: how they are turned, or where they are",
            "others": "the rest: for the search to fill in, at rest, as in the keyframe before, or as in a `<key>` of "
            'the model, "key:NAME"',
        },
    ),
    "root, roots.NAME": (table.RootTable, {"position": "m, in the world", "rotation": "a rotation in the world"}),
    "a rotation": (table.RotationTable, ROTATION),
    "sites.NAME": (
        table.SiteTable,
        {"position": "m, in the world; short for it: `[x, y, z]` alone", "by": "a pose beforehand, or the search"},
    ),
    "bodies.NAME": (
        table.BodyTable,
        {
            "flat": "whether its sole lies on the ground",
            "position": "m, in the world: where its origin is, or the point `at`",
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
            "position": "m, where it rests, if no keyframe in between tells it",
        },
    ),
    "[[hold]]": (
        table.HoldTable,
        {
            "hand": "a site, foot, geom or body",
            "body": "what it holds",
            "from": "s",
            "to": "s",
            "position": "m, in that body's axes, if no keyframe tells it",
        },
    ),
    "[scene] step": (
        table.StepTable,
        {"x": "m, of its front face", "height": "m", "length": "m, along x", "width": "m, along y", "y": "m"},
    ),
    "[[scene.box]]": (table.BoxTable, {"size": "m, all of it, along x, y and z"} | OBSTACLE),
    "[[scene.sphere]]": (table.SphereTable, {"radius": "m"} | OBSTACLE),
    "[[scene.capsule]], [[scene.cylinder]]": (table.BarTable, BAR),
    "[recording]": (
        table.RecordingTable,
        {
            "file": "a motion (.npz), a recording (.bvh, ...) or a clip beside the clip, or the name of one that ships",
            "repeat": "how often a loop comes",
            "from": "s of the recording, what is used of it",
            "to": "s",
            "at": "s of the clip, when that begins; else as in the recording",
            "speed": "times as fast",
            "times": "pairs of moments, s of the recording and of the clip, instead of `at` and `speed`",
            "weight": "how much the recording counts",
            "blend": "s before and after every keyframe, beyond which nothing changes",
        },
    ),
    "[solve]": (
        table.SolveTable,
        {
            "coordinates": "of the spline: quaternions of bodies in the world, or of joints",
            "ends": "of the spline: free, clamped at rest, or a loop's",
            "travel": "m, how far a loop's root comes in a period; else as the keyframes say",
            "turn": "degrees, by which a loop's root turns in a period; else as the keyframes say",
            "variable": "variable frames between two keyframes to begin with",
            "frames": "variable frames in all, at most",
            "criterion": 'where frames are inserted: "weak", "residual", "objective", "resolution"',
            "threshold": "of the criterion, from which on",
            "optimiser": 'of NLopt, for the last stage: "lbfgs", "slsqp", "ccsaq", "tnewton", "var2"; or "none"',
            "evaluations": "of the objective in a round, at most",
            "tolerance": "relative progress at which it ends",
            "quadrature": "how the objective is summed",
            "samples": 'in a panel, or in all with "uniform"',
        },
    ),
}


def default(field: FieldInfo) -> str:
    """What holds where a clip does not say."""
    if field.is_required():
        return "needed"
    value = field.default
    if value is None or value in ([], {}) or isinstance(value, table.Table):
        return ""
    words = f'"{value}"' if isinstance(value, str) else f"{value:g}"
    within = [choice for part in get_args(field.annotation) if part is not float for choice in (part, *get_args(part))]
    choices = [choice for choice in within if isinstance(choice, str)]
    others = [f'"{choice}"' for choice in choices if choice != value]
    return words + (f"; or {', '.join(others)}" if others else "")


def keys() -> Iterator[str]:
    """A table of every table's keys. Raises ValueError where the schema and the texts here know different ones."""
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
    yield "| `kind` | part | default weight | what it keeps small | options |"
    yield "|---|---|---|---|---|"
    for kind in KINDS.values():
        options = ", ".join(f"`{name}` ({text})" for name, text in kind.choices().items())
        for i, part in enumerate(kind.parts):
            small = re.sub(r'(<\w+>|\[\[\w+\]\]|by = "\w+")', r"`\1`", part.keeps_small)
            weight = f"{part.weight:g}" + (
                f" with `{part.option}`" if part.option else "" if kind.is_default else ", if listed"
            )
            first = (f"`{kind.name}`", options) if i == 0 else ("", "")
            yield f"| {first[0]} | {f'`{part.name}`' if part.name else ''} | {weight} | {small} | {first[1]} |"


def written(page: str) -> str:
    """The page with its tables anew."""
    for name, lines in (("keys", keys()), ("kinds", kinds())):
        begin, end = MARKS[0].format(name), MARKS[1]
        text = begin + "\n".join(lines).rstrip() + "\n" + end
        page = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _, text=text: text, page, flags=re.DOTALL)
    return page


if __name__ == "__main__":
    PAGE.write_text(written(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
