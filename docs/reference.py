"""Generated parts of the pages; `python docs/reference.py` writes them.

The tables of keys and soft constraints are generated from the schema of clips, measured figures from
benchmarks/results/results.json.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from dynsplines import models
from dynsplines.clip import table
from dynsplines.clip.kinds import KINDS
from dynsplines.clip.tracking.problem import LONGEST_PANEL, POINTS

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
PART = re.compile(r"(<!-- (\w+): written by docs/reference.py -->\n).*?(<!-- end -->\n)", re.DOTALL)
HEADINGS = {"the clip": "The top level", "a rotation": "A rotation"}  # of tables without a name in the file
ROTATION = {
    "rotvec": "axis times angle, in degrees",
    "euler": "intrinsic angles about the axes of `order`, in degrees",
    "order": 'the axes of `euler`; default "xyz"',
    "quat": "a quaternion w, x, y, z",
    "heading": "an angle about the vertical axis, in degrees, applied last; only for rotations in the world",
}
OBSTACLE = {
    "name": "the name in messages",
    "body": "the movable object that this obstacle is a part of; positions are then in the axes of the object",
    "mass": "the mass of this part of an object, in kg",
    "color": "red, green, blue and opacity, each from 0 to 1",
    "position": "the centre, in metres; required without `body`",
    "rotation": "a rotation",
}
BAR = {
    "radius": "the radius, in metres",
    "length": "the length along z, in metres, with `position` as the centre",
    "from": "one end, in metres; use `from` and `to`, or `position` and `length`",
    "to": "the other end, in metres",
} | OBSTACLE
TABLES: dict[str, tuple[type[table.Table], dict[str, str]]] = {
    "the clip": (
        table.ClipTable,
        {
            "figure": "the name of a shipped figure, or the path of an MJCF or URDF file, relative to the clip's "
            "folder",
            "fps": "samples per second of the output",
            "keyframe": "the keyframes in order of time: at least two, or any number with a recording",
            "scene": "obstacles and movable objects",
            "contact": "points that stay at rest for an interval",
            "grasp": "hands that hold a body for an interval",
            "recording": "a recorded motion that the clip follows",
            "penalty": "changes to soft constraints, by [these keys](soft_constraints.md#all-kinds)",
            "solve": "settings of the solver",
            "mirror": "names of left and right parts, for mirror images",
        },
    ),
    "[[keyframe]]": (
        table.KeyframeTable,
        {
            "time": "in seconds",
            "root": "the pose of the root, see [joints and roots](keyframes.md#joints-and-roots)",
            "roots": "the poses of other free bodies and robots, by the name of their joint or body",
            "joints": "joints by name: a rotation for a ball joint, degrees for a hinge, metres for a slide",
            "sites": "target positions of sites, sole points, bodies, geoms and joints, by name, in metres in the "
            "world",
            "bodies": "target orientations or positions of bodies, by name",
            "others": "[unspecified joints and root](keyframes.md#unspecified-degrees-of-freedom), "
            'by "key:NAME" or one of these',
        },
    ),
    "root, roots.NAME": (
        table.RootTable,
        {
            "position": "in the world, in metres; default: as `others` specifies",
            "rotation": "a rotation in the world; default: as `others` specifies",
        },
    ),
    "a rotation": (table.RotationTable, ROTATION),
    "bodies.NAME": (
        table.BodyTable,
        {
            "flat": "`true` makes the body as level as in the rest pose; of all rotations, only `heading` may be added",
            "position": "in the world, in metres, for the origin of the body or the point `at`",
            "at": "a point in the axes of the body, in metres",
        }
        | ROTATION,
    ),
    "[[contact]]": (
        table.ContactTable,
        {
            "point": "a site, sole point, geom or body",
            "from": "the start, in seconds",
            "to": "the end, in seconds",
            "position": "in the world, in metres; default: the position in the keyframes of this interval, if there is "
            "one",
        },
    ),
    "[[grasp]]": (
        table.GraspTable,
        {
            "hand": "a site, sole point, geom or body",
            "body": "the held body",
            "from": "the start, in seconds",
            "to": "the end, in seconds",
            "position": "in the axes of the held body, in metres; default: the position in the keyframes",
            "rotation": '`"free"` lets the body rotate about the site; default: a single hand holds its rotation, too',
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
            "speed": "the speed factor: 2 halves the duration",
            "times": "pairs of a time in the recording and a time in the clip, instead of `at` and `speed`",
            "weight": "a factor of the weights that keep the motion near the recording",
        },
    ),
    "[mirror]": (
        table.MirrorTable,
        {"pairs": "pairs of joints, bodies, sites or geoms of the two sides, if left and right are not in their names"},
    ),
    "[solve]": (
        table.SolveTable,
        {
            "ends": "the ends of the motion; default: see [ends](keyframes.md#ends)",
            "travel": "the displacement of the root in one cycle of a loop, in metres; default: x and y as in the "
            "keyframes",
            "turn": "the rotation of the root in one cycle of a loop, in degrees; default: as in the keyframes",
            "variable": "variable frames between two keyframes at the start of the search; default 2 (3 in a "
            "long clip), and more between distant keyframes",
            "frames": "the maximum total of variable frames; default: 3 per interval between keyframes, or 10 per "
            "second if that is more",
            "criterion": 'how the solver finds the intervals into which it inserts frames: "weak" (the default) by '
            'the predicted decrease of the objective, "residual" by the Euler-Lagrange residual; see '
            "[the paper](paper.md)",
            "threshold": "the value of the criterion below which no frame is inserted; default 0.001",
            "optimiser": 'the NLopt algorithm that refines the result of the Gauss-Newton steps: "lbfgs" (the '
            'default), "slsqp", "ccsaq", "tnewton", "var2", or "none"',
            "evaluations": "the maximum number of evaluations of the objective after each insertion of frames; "
            "default 250",
            "tolerance": "the search ends when a step is predicted to decrease the objective by less than this share; "
            "default 0.001",
            "quadrature": "the quadrature rule of the objective",
            "samples": f"samples in each piece (at most {LONGEST_PANEL:g} s) of the spline; default {POINTS}, more "
            'where a collision would be missed. With "uniform": samples in the whole clip; default 100',
        },
    ),
}


SHARED = {"[a rotation](#a-rotation)": ROTATION, "[every obstacle](#every-obstacle)": OBSTACLE}


def choices(field: FieldInfo) -> list[str]:
    """The texts that a key may have."""
    parts = get_args(field.annotation)
    within = [
        choice for part in parts for choice in ((part, *get_args(part)) if get_origin(part) is Literal else (part,))
    ]
    return list(dict.fromkeys(choice for choice in within if isinstance(choice, str)))


def default(field: FieldInfo) -> str:
    """The default of a key, as the end of the text on it."""
    if field.is_required():
        return "; required"
    value = field.default
    if value is None or value in ([], {}) or isinstance(value, table.Table):
        return ""
    return f'; default "{value}"' if isinstance(value, str) else f"; default {value:g}"


def meaning(text: str, field: FieldInfo) -> str:
    """The text on a key, and its choices if there are several."""
    several, (text, mark, end) = [f'"{choice}"' for choice in choices(field)], text.partition("; default: ")
    return f"{text}: {', '.join(several)}{mark}{end}" if len(several) > 1 else text + mark + end


def keys() -> Iterator[str]:
    """A table of every table's keys. Raises ValueError where the schema and the texts here have different ones."""
    for name, (schema, texts) in TABLES.items():
        fields = {field.alias or key: field for key, field in schema.model_fields.items()}
        if fields.keys() != texts.keys():
            raise ValueError(f"{name}: {sorted(fields.keys() ^ texts.keys())}")
        shared = [group for group, common in SHARED.items() if common.items() < texts.items()]
        if schema is table.BoxTable:
            yield from keys_table("Every obstacle", fields, OBSTACLE)
        rows = {key: text for key, text in texts.items() if not any(key in SHARED[group] for group in shared)}
        yield from keys_table(HEADINGS.get(name) or ", ".join(f"`{part}`" for part in name.split(", ")), fields, rows)
        if shared:
            yield f"Other keys: those of {' and '.join(shared)}."
            yield ""


def keys_table(heading: str, fields: dict[str, FieldInfo], texts: dict[str, str]) -> Iterator[str]:
    """A table of keys below its heading."""
    yield f"### {heading}"
    yield ""
    yield "| key | value |"
    yield "|---|---|"
    for key, text in texts.items():
        suffix = "" if "; default: " in text else default(fields[key])
        yield f"| `{key}` | {meaning(text, fields[key])}{suffix} |"
    yield ""


def kinds() -> Iterator[str]:
    """The soft constraints."""
    yield "| term | weight | penalised quantity | violations | options of the kind |"
    yield "|---|---|---|---|---|"
    for kind in KINDS.values():
        options = ", ".join(f"`{name}` ({text})" for name, text in kind.choices().items())
        for part in kind.parts:
            small = re.sub(r'(<\w+>|\[\[\w+\]\]|by = "\w+")', r"`\1`", part.quantity)
            weight = f"{part.weight:g}" + (
                f" with `{part.option}`" if not part.is_default else "" if kind.is_default else ", if listed"
            )
            violations = ", ".join(f"`{violation}`" for violation in part.violations)
            yield f"| `{kind.term(part)}` | {weight} | {small} | {violations} | {options} |"
            options = ""


@cache
def results() -> dict[str, Any]:
    """The measured figures, by section of the benchmarks."""
    return json.loads((ROOT / "benchmarks" / "results" / "results.json").read_text(encoding="utf-8"))


def row(section: str, *first: object) -> list[Any]:
    """The row of a section that begins with these cells."""
    (only,) = [cells for cells in results()[section]["rows"] if cells[: len(first)] == list(first)]
    return only


def seconds(time: float) -> str:
    """A time [s] with two digits."""
    return f"{1000 * time:.2g} ms" if time < 0.01 else f"{float(f'{time:.2g}'):g} s"


def factor(ratio: float) -> str:
    """A ratio with two digits."""
    return f"{float(f'{ratio:.2g}'):g}"


def cores() -> str:
    """The machine of the benchmarks."""
    return "Measured without a GPU on " + ", ".join(results()["clip"]["machine"].split(", ")[:2])


def duration(name: str) -> str:
    """The duration of a shipped clip."""
    times = [key["time"] for key in tomllib.loads(models.clip_text(name))["keyframe"]]
    return f"{times[-1] - times[0]:.2g} s"


def speed() -> Iterator[str]:
    """The figures of the README."""
    solve, runner = row("clip", "solve, subdivision included"), row("runner39", "ours")
    ipopt = row("runner39", "CasADi + IPOPT, compiled by gcc -O3")
    yield f"{cores()}:"
    yield ""
    time, length = seconds(solve[1]), duration("run_and_step")
    yield f"- The clip `run_and_step`, {length} of motion, is solved in {time}."
    yield (
        f"- A runner with a simplified objective is solved to within 0.5 % of the optimum in {seconds(runner[1])}. "
        f"CasADi with IPOPT takes {factor(ipopt[2])} times as long."
    )
    dense = factor(row("barr", DENSE)[2])
    yield (
        f"- For a body that rotates through keyframes (Barr et al. 1992), the method is {dense} times as fast as dense "
        f"SQP, and {sparse()} times as fast as sparse Newton SQP and IPOPT."
    )


DENSE, SPARSE = "SLSQP of SciPy, dense", ("sparse Newton SQP", "IPOPT, exact Hessian")


def sparse() -> str:
    """How many times as fast as sparse solvers the method is."""
    ratios = sorted(row("barr", solver)[2] for solver in SPARSE)
    return " to ".join(dict.fromkeys(map(factor, ratios)))


def times() -> Iterator[str]:
    """Times of solving."""
    yield "| task | time |"
    yield "|---|---|"
    solve = row("clip", "solve, subdivision included")
    yield f"| solve `run_and_step` | {seconds(solve[1])} |"
    first = row("clip", "`dynsplines solve`: start to its first line about a path")
    yield f"| from the start of `dynsplines solve` to the first line of its progress | {seconds(first[1])} |"
    for count in (480, 1000):
        _, plays, took, _, _, peak, *_ = row("length", count)
        yield (f"| solve {plays:.0f} s of running with {count} keyframes | {seconds(took)}, {peak:.0f} MB of memory |")
    two = row("batch", "two")
    yield (
        f"| solve {two[1]} clips with two processes | {two[2]:.0f} s, {two[4]:.1f} times as fast as with one process |"
    )
    opengl, rays = results()["rendering"]["rows"]
    yield (
        f"| render at {opengl[1]} pixels | {opengl[3]:.1f} frames per second with OpenGL in software, "
        f"{rays[3]:.1f} without OpenGL |"
    )


def solvers() -> Iterator[str]:
    """Comparisons with other solvers."""
    yield "| task | time | other solver | factor |"
    yield "|---|---|---|---|"
    task = "a runner with a simplified objective, to 0.5 % of the optimum"
    ours = seconds(row("runner39", "ours")[1])
    for name, solver in (
        ("CasADi + IPOPT, compiled by gcc -O3", "CasADi with IPOPT, compiled"),
        ("mujoco.minimize, its own differences", "`mujoco.minimize` with finite differences"),
        ("mujoco.minimize, coloured Jacobian", "`mujoco.minimize` with a Jacobian written for the task"),
    ):
        yield f"| {task} | {ours} | {solver} | {factor(row('runner39', name)[2])} |"
        task = ours = ""
    for count in (7, 1000):
        cells = row("shooting", count, "moderate", "ours, 3 a segment")
        task = f"a rotating body with {count} keyframes, to 0.01 % of the optimum"
        yield f"| {task} | {seconds(cells[3] / 1000)} | InterpolatePy, C++ shooting | {factor(1 / cells[4])} |"
    task, ours = (
        "the rotating body of Barr et al. 1992, to 0.1 % of the optimum",
        seconds(row("barr", "ours")[1] / 1000),
    )
    for solver in (*SPARSE, DENSE):
        yield f"| {task} | {ours} | {solver} | {factor(row('barr', solver)[2])} |"
        task = ours = ""
    yield ""
    sets = results()["uneven"]["rows"]
    count, failed = sum(cells[2] for cells in sets), sum(cells[3] for cells in sets)
    reached = sum(cells[2] - cells[4] for cells in sets)
    every = f"all {count}" if reached == count else str(reached)
    yield "InterpolatePy solves only rotations of one body. If times between keyframes differ by a factor of up to 50,"
    yield f"it fails on {failed} of {count} sets. dynamic-splines reaches a minimum on {every}."


def quality() -> Iterator[str]:
    """Comparisons of results."""
    yield "| measurement | dynamic-splines | RotationSpline | SQUAD or SLERP |"
    yield "|---|---|---|---|"
    energies = [row("quaternions", name) for name in ("ours, 3 variable frames a segment", "RotationSpline", "SQUAD")]
    for column, sets in ((1, "steps of 20 to 90°"), (3, "random rotations")):
        values = " | ".join(f"{float(cells[column]):.5g}" for cells in energies)
        yield f"| objective of a rotating body / optimum, {sets} | {values} |"
    rebuilt = [row("inbetweening", 10, name) for name in ("ours", "RotationSpline", "SLERP")]
    for column, what, unit in ((4, "error of hands and ankles", "cm"), (6, "sliding of feet on the ground", "cm/s")):
        values = " | ".join(f"{cells[column]:.2g} {unit}" for cells in rebuilt)
        yield f"| shipped clips rebuilt from every 10th sample: {what} | {values} |"


CLAIMS = (  # verdict, claim, measurement of the benchmarks
    ("reproduced", "Every iterate meets the keyframes.", ""),
    (
        "reproduced",
        "A path that is stopped early is no worse than the raw spline ([figure 9](#figure-9)).",
        "",
    ),
    (
        "not reproduced",
        "With the weights 2 : 5 of the unit and acceleration terms and 1 variable frame between keyframes, quaternions "
        "keep unit length to 0.2 % ([figure 9](#figure-9)).",
        "",
    ),
    (
        "reproduced",
        "The same with the weights 10 : 1 and 3 variable frames, at a nearly minimal objective.",
        "",
    ),
    (
        "in part",
        "The method is about 100 times as fast as dense SQP on the discretisation of Barr et al. 1992.",
        "{dense} times",
    ),
    ("not reproduced", "The same for sparse solvers.", "{sparse} times"),
    (
        "not reproduced",
        "The Euler-Lagrange residual in its strong form decreases with 0, 1 and 3 variable frames between keyframes "
        "([figure 10](#figure-10)).",
        "",
    ),
    ("reproduced", "The same in its weak form, with the intrinsic acceleration term.", ""),
    (
        "reproduced",
        "This residual locates missing frames better than the size of the objective or a "
        "comparison of two resolutions.",
        "",
    ),
    ("reproduced", "The estimate δ · EL (appendix C) shows how much the objective can still decrease.", ""),
    (
        "reproduced",
        "A runner with 39 degrees of freedom takes a few minutes at most ([figure 6](#figure-6)).",
        "{runner}",
    ),
    (
        "reproduced",
        "A foot of the runner passes through the step in the raw spline, but not in the solution "
        "([figures 11 and 12](#figures-11-and-12)).",
        "",
    ),
)


def claims() -> Iterator[str]:
    """The claims of the paper."""
    runner = seconds(row("clip", "solve, subdivision included")[1])
    yield "| result | claim of the paper, or variant | measured |"
    yield "|---|---|---|"
    for verdict, claim, measured in CLAIMS:
        text = measured.format(dense=factor(row("barr", DENSE)[2]), sparse=sparse(), runner=runner)
        yield f"| {verdict} | {claim} | {text} |"


PARTS: dict[str, Callable[[], Iterator[str]]] = {
    part.__name__: part for part in (keys, kinds, speed, times, solvers, quality, claims)
}


def written(page: str) -> str:
    """The page with updated parts."""

    def part(match: re.Match[str]) -> str:
        return match[1] + "\n" + "\n".join(PARTS[match[2]]()).rstrip() + "\n\n" + match[3]

    return PART.sub(part, page)


if __name__ == "__main__":
    for page in PAGES:
        page.write_text(written(page.read_text(encoding="utf-8")), encoding="utf-8")
