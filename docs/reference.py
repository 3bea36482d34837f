"""Tables of keys in docs/clip.md, generated from the clip schema by `python docs/reference.py`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from dynsplines.clip import table
from dynsplines.clip.kinds import KINDS

PAGE = Path(__file__).parent / "clip.md"
MARKS = "<!-- {}: written by docs/reference.py -->\n\n", "\n<!-- end -->\n"
HEADINGS = {"the clip": "The top level", "a rotation": "A rotation"}  # of tables without a name in the file
ROTATION = {
    "rotvec": "axis times angle, in degrees",
    "euler": "angles about the axes of `order`, in degrees, each about an axis rotated by those before",
    "order": 'the axes of `euler`; default "xyz"',
    "quat": "a quaternion w, x, y, z",
    "heading": "an angle about the vertical axis, in degrees, applied last; only for rotations in the world",
}
OBSTACLE = {
    "name": "the name in messages",
    "body": "the movable object that this obstacle is a part of; positions are then in the axes of the object",
    "mass": "the mass of this part of an object, in kg",
    "color": "red, green, blue and opacity, each from 0 to 1",
    "position": "the centre, in metres",
    "rotation": "a rotation",
}
BAR = {
    "radius": "the radius, in metres",
    "length": "the length, in metres, with `position` as the centre",
    "from": "one end, in metres; use `from` and `to`, or `position` and `length`",
    "to": "the other end, in metres",
} | OBSTACLE
TABLES: dict[str, tuple[type[table.Table], dict[str, str]]] = {
    "the clip": (
        table.ClipTable,
        {
            "figure": "the name of a shipped figure, or the path of an MJCF or URDF file",
            "fps": "samples per second of the output",
            "keyframe": "the keyframes, at least two, in order of time",
            "scene": "obstacles and movable objects",
            "contact": "points that stay at rest for an interval",
            "grasp": "hands that hold a body for an interval",
            "recording": "a recorded motion that the clip follows",
            "penalty": "changes to soft constraints",
            "solve": "settings of the solver",
            "mirror": "left and right of the figure, for `dynsplines mirror`",
        },
    ),
    "[[keyframe]]": (
        table.KeyframeTable,
        {
            "time": "in seconds",
            "root": "the pose of the root, see [the root](#the-root)",
            "roots": "the poses of other free bodies and robots, by the name of their joint or body",
            "joints": "joints by name: a rotation for a ball joint, degrees for a hinge, metres for a slide",
            "sites": "target positions of sites, feet, geoms and bodies, by name",
            "bodies": "target orientations or positions of bodies, by name",
            "others": '[joints that are not named](#unspecified-degrees-of-freedom), by "key:NAME" or one of these',
        },
    ),
    "root, roots.NAME": (
        table.RootTable,
        {"position": "in the world, in metres", "rotation": "a rotation in the world"},
    ),
    "a rotation": (table.RotationTable, ROTATION),
    "sites.NAME": (
        table.SiteTable,
        {
            "position": "in the world, in metres; short form: `sites.NAME = [x, y, z]`",
            "by": "how the target is reached, by inverse kinematics or by the search",
        },
    ),
    "bodies.NAME": (
        table.BodyTable,
        {
            "flat": "`true` makes the sole parallel to the ground; of the rotations below, only `heading` may be added",
            "position": "in the world, in metres, for the origin of the body or the point `at`",
            "at": "a point in the axes of the body, in metres",
        }
        | ROTATION,
    ),
    "[[contact]]": (
        table.ContactTable,
        {
            "point": "a site, foot, geom or body",
            "from": "the start, in seconds",
            "to": "the end, in seconds",
            "position": "in the world, in metres; default: the position in the keyframes of this interval",
        },
    ),
    "[[grasp]]": (
        table.GraspTable,
        {
            "hand": "a site, foot, geom or body",
            "body": "the held body",
            "from": "the start, in seconds",
            "to": "the end, in seconds",
            "position": "in the axes of the held body, in metres; default: the position in the keyframes",
            "rotation": '`"free"` lets the body rotate about the site; default: its rotation in the hand is held, too',
        },
    ),
    "[scene] step": (
        table.StepTable,
        {
            "x": "the front face, in metres",
            "height": "in metres",
            "length": "along x, in metres",
            "width": "along y, in metres",
            "y": "the centre, in metres",
        },
    ),
    "[[scene.box]]": (table.BoxTable, {"size": "the full edge lengths along x, y and z, in metres"} | OBSTACLE),
    "[[scene.sphere]]": (table.SphereTable, {"radius": "the radius, in metres"} | OBSTACLE),
    "[[scene.capsule]], [[scene.cylinder]]": (table.BarTable, BAR),
    "[recording]": (
        table.RecordingTable,
        {
            "file": "a motion (.npz), a recording (.bvh, ...) or a clip, relative to this clip; or a shipped clip",
            "repeat": "how many times a loop is repeated",
            "from": "the start of the used part, in seconds of the recording",
            "to": "the end of the used part, in seconds of the recording",
            "at": "the start of the used part, in seconds of the clip; default: as in the recording",
            "speed": "the speed factor",
            "times": "pairs of a time in the recording and a time in the clip, instead of `at` and `speed`",
            "weight": "a factor of the weights that keep the motion near the recording",
            "blend": "how long before and after a keyframe the motion may leave the recording, in seconds, at least "
            "0.01; default: 0.4, but contacts and collisions may change other times",
        },
    ),
    "[mirror]": (
        table.MirrorTable,
        {"pairs": "pairs of joints, bodies, sites or geoms of the two sides, if left and right are not in their names"},
    ),
    "[solve]": (
        table.SolveTable,
        {
            "coordinates": 'what rotations of the spline are relative to, the world or the parent joint; "auto" is '
            '"world" for a figure with ball joints',
            "ends": 'the ends of the motion; if not set, "free" with the exceptions in [ends](#ends)',
            "travel": "the displacement of the root in one cycle of a loop, in metres; default: as in the keyframes",
            "turn": "the rotation of the root in one cycle of a loop, in degrees; default: as in the keyframes",
            "variable": "variable frames between two keyframes at the start of the search; default 2; in a long clip 3",
            "frames": "the maximum number of variable frames; default: 3 between two keyframes, or 10 per second if "
            "that is more",
            "criterion": 'how the solver finds the intervals into which it inserts frames: "weak" (the default) by '
            'the predicted decrease of the objective, "residual" by the Euler-Lagrange residual; see '
            "[the method](method.md)",
            "threshold": "the value of the criterion below which no frame is inserted; default 0.001",
            "optimiser": 'the NLopt algorithm that refines the motion at the end: "lbfgs" (the default), "slsqp", '
            '"ccsaq", "tnewton", "var2", or "none"',
            "evaluations": "the maximum number of evaluations of the objective after an insertion of frames; "
            "default 250",
            "tolerance": "the relative decrease of the objective at which the search ends; default 0.001",
            "quadrature": "the quadrature rule of the objective",
            "samples": "samples between two neighbouring frames, default 3, and more where these would miss a "
            'collision; with "uniform": samples in the whole clip, default 100',
        },
    ),
}


def choices(field: FieldInfo) -> list[str]:
    """The texts that a key may have."""
    parts = get_args(field.annotation)
    within = [
        choice for part in parts for choice in ((part, *get_args(part)) if get_origin(part) is Literal else (part,))
    ]
    return list(dict.fromkeys(choice for choice in within if isinstance(choice, str)))


def default(field: FieldInfo) -> str:
    """The default of a key, as text."""
    if field.is_required():
        return "required"
    value = field.default
    if value is None or value in ([], {}) or isinstance(value, table.Table):
        return ""
    return f'"{value}"' if isinstance(value, str) else f"{value:g}"


def meaning(text: str, field: FieldInfo) -> str:
    """The text on a key, and its choices if there are several."""
    several = [f'"{choice}"' for choice in choices(field)]
    return f"{text}: {', '.join(several)}" if len(several) > 1 else text


def keys() -> Iterator[str]:
    """A table of every table's keys. Raises ValueError where the schema and the texts here have different ones."""
    for name, (schema, texts) in TABLES.items():
        fields = {field.alias or key: field for key, field in schema.model_fields.items()}
        if fields.keys() != texts.keys():
            raise ValueError(f"{name}: {sorted(fields.keys() ^ texts.keys())}")
        yield f"### {HEADINGS.get(name) or ', '.join(f'`{part}`' for part in name.split(', '))}"
        yield ""
        yield "| key | value | default |"
        yield "|---|---|---|"
        yield from (
            f"| `{key}` | {meaning(text, fields[key])} | {default(fields[key])} |" for key, text in texts.items()
        )
        yield ""


def kinds() -> Iterator[str]:
    """The soft constraints."""
    yield "| `kind` | part | weight | penalised quantity | options |"
    yield "|---|---|---|---|---|"
    for kind in KINDS.values():
        options = ", ".join(f"`{name}` ({text})" for name, text in kind.choices().items())
        for i, part in enumerate(kind.parts):
            small = re.sub(r'(<\w+>|\[\[\w+\]\]|by = "\w+")', r"`\1`", part.quantity)
            weight = f"{part.weight:g}" + (
                f" with `{part.option}`" if not part.is_default else "" if kind.is_default else ", if listed"
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
