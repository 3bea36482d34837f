"""The options of the commands: each with its unit, range and default.

Annotations are objects, because typer evaluates annotations in text slowly. Modules are imported on first use.
"""

import math
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .errors import UserError, unknown
from .picture import graphics
from .scene import file_access

if TYPE_CHECKING:
    from .clean.command import Source as Cleaning


def flag(*words: str, **more: Any) -> Any:
    """Return an option without a value; the last of `words` is its help, the others are its names."""
    return typer.Option(*words[:-1], help=words[-1], **more)


def value(metavar: str, help: str, default: str | bool = True, *names: str, **more: Any) -> Any:
    """Return an option; `default` is the text that describes a computed default."""
    return typer.Option(*names, metavar=metavar, help=help, show_default=default, **more)


def number(
    metavar: str,
    help: str,
    least: float = -math.inf,
    most: float = math.inf,
    default: str | bool = True,
    *names: str,
    kind: type = float,
) -> Any:
    """Return an option of a finite number from `least` to `most`; the ranges of click accept nan."""
    span = f"{least:g} to {most}" if most < math.inf else f"{least:g} or more" if least > -math.inf else ""

    def parsed(text: object) -> float:
        try:
            value = kind(text)
        except (ValueError, OverflowError):
            value = math.nan
        if not (least <= value <= most and math.isfinite(value)):
            raise typer.BadParameter(f"{text}: give a {'whole ' * (kind is int)}number{span and f', {span}'}")
        return value

    return value(metavar, f"{help}{span and f' ({span})'}", default, *names, parser=parsed)


def seconds(help: str, default: str | bool = True, *names: str) -> Any:
    """Return an option of a time or a duration."""
    return number("SECONDS", help, -math.inf, math.inf, default, *names)


def output(default: str) -> Any:
    """Return the option of the output file."""
    return value("FILE", "Write to this file", default, "-o", "--output")


def size(text: str) -> tuple[int, int]:
    """Return width and height [pixels] from text such as "1280x720"."""
    sides = text.lower().split("x")
    if len(sides) != 2 or not all(side.isascii() and side.isdigit() and len(side) < 10 for side in sides):
        raise typer.BadParameter(f"{text}: give WIDTHxHEIGHT in pixels, such as 1280x720")
    width, height = map(int, sides)
    if not (16 <= width <= 3840 and 16 <= height <= 2160):
        raise typer.BadParameter(f"{text}: give 16x16 to 3840x2160")
    return width, height


def parsed_speed(text: str) -> float:
    """Return a speed [rad/s] from text such as "1200deg/s"."""
    from .system.quantity import speed  # on first use

    return speed(text, "--speed-limit")


def _print_version(is_requested: bool) -> None:
    if is_requested:
        from importlib.metadata import version  # only here: it takes a moment

        by = "the compiled kernel" if _has_kernel() else "NumPy alone (no compiled kernel)"
        print(f"dynsplines {version('dynamic-splines')}, MuJoCo {version('mujoco')}, solving with {by}")
        raise typer.Exit


def _has_kernel() -> bool:
    """Return whether there is a compiled kernel that loads, without an import of the solver and its libraries."""
    from importlib import machinery, util

    solver = util.find_spec("dynsplines.solver")
    assert solver is not None
    kernel = machinery.PathFinder.find_spec("dynsplines.solver.kernel", solver.submodule_search_locations)
    try:
        return kernel is not None and util.module_from_spec(kernel) is not None
    except ImportError:
        return False


def _prepare(context: typer.Context, allow: bool) -> bool:
    """Apply --allow-outside until the command ends, and import MuJoCo without graphics unless the command draws."""
    context.with_resource(file_access.allow(allow))
    if context.command.name != "render":
        graphics.do_without()
    return allow


def cleaning_source(
    *,
    clean: bool,
    robot: str | None,
    figure: str | None,
    map_file: Path | None,
    kind: str | None,
    scene: Path | None,
) -> "Cleaning | None":
    """Return the recording to clean, but for its file; None for clips. Raises UserError for contradicting options."""
    from dynsplines import models

    from .clean.command import Source  # on first use, as above
    from .exchange.skeleton.maps import map_of

    if clean and robot is not None:
        raise UserError("--clean and --retarget: give one of them; --retarget also cleans")
    files = {"--scene": scene, "--map": map_file}
    more = {"--figure": figure, "--map": map_file, "--from": kind, "--scene": scene}
    options = [name for name, value in more.items() if value is not None]
    if not clean and robot is None:
        if options:
            raise UserError(f"{' and '.join(options)}: of recordings; give --clean or --retarget MODEL, too")
        return None
    if robot is not None and figure is not None:
        raise UserError(f"--figure {figure}: the figure is the one to --retarget to, '{robot}'")
    files["--map"] = map_of(map_file)
    if clean and map_file is not None:
        raise UserError("--map: a bone map is used for retargeting only; add --retarget MODEL")
    model = robot if robot is not None else figure
    if model is not None and model not in models.figures() and not Path(model).is_file():
        raise UserError(f"no file '{model}'" if Path(model).suffix else unknown("figure", model, models.figures()))
    for word, place in files.items():
        if place is not None and not place.is_file():
            raise UserError(f"{word}: no file '{place}'")
    is_retargeted = robot is not None
    return Source(Path(), model, kind, scene=scene, map=files["--map"], avoids_self_collision=is_retargeted)


Part = StrEnum("Part", ["before", "after", "keys"])
Only = Annotated[
    Part | None,
    value(
        "before|after|keys",
        "Render only the spline through the keyframes (before), the solved motion (after), or the keyframes (keys)",
        "before and after, side by side",
    ),
]
Source = Annotated[
    str,
    typer.Argument(
        metavar="CLIP|MOTION.npz",
        help="Name of a shipped clip, or a file: clip (.toml) or motion (.npz)",
    ),
]
Clip = Annotated[
    str,
    typer.Argument(metavar="CLIP", help="Name of a shipped clip, or a clip's file (.toml)"),
]
Recording = Annotated[
    Path, typer.Argument(metavar="RECORDING", help="Motion (.npz), or a file in a format that `import` reads")
]
Version = Annotated[bool, flag("--version", "Print the version", is_eager=True, callback=_print_version)]
Overwrite = Annotated[bool, flag("--overwrite", "Overwrite an existing output file")]
Strict = Annotated[bool, flag("--strict", "Exit with code 3 if a motion has violations")]
Outside = Annotated[bool, flag("--allow-outside", "Allow a model to read files outside its folder", callback=_prepare)]
Ghosts = Annotated[
    bool,
    flag(
        "--ghosts",
        "In a picture, draw the figure at keyframes (darkest), inserted frames and between; in a video, keyframes, too",
    ),
]
AsJson = Annotated[bool, flag("--json", "Print numbers and violations as JSON")]
Repeat = Annotated[int | None, number("N", "If the clip is a loop, repeat it N times", 1, default="1", kind=int)]
Rate = Annotated[float | None, number("HZ", "Samples per second of the output", 0.01, 100_000, "the clip's, or 30")]
Figure = Annotated[
    str | None,
    value(
        "MODEL",
        "Figure of the recording: name of a shipped figure, or MJCF file",
        "the one in the recording",
    ),
]
Format = Annotated[
    str | None, value("FORMAT", "Format of the recording, see `dynsplines formats`", "by its extension", "--from")
]
Fps = Annotated[float | None, number("HZ", "Frames per second of the recording", 0.01, 1000, "that of the file")]
Scale = Annotated[
    float | None, number("METRES", "Length unit of the recording in metres, e.g. 0.01 for cm", 1e-6, 10**6, "inferred")
]
Scene = Annotated[
    Path | None,
    value(
        "FILE",
        "TOML file with a [scene] table, obstacles in the recording, or [[contact]] tables, when feet or hands rest",
        "a flat floor, detected contacts",
    ),
]
Speed = Annotated[
    float | None,
    value("SPEED", "Largest joint speed, e.g. 20rad/s or 1200deg/s", "none", "--speed-limit", parser=parsed_speed),
]
Edited = Annotated[Path | None, output("name of the input with the suffix _mirrored, _retimed or _trimmed")]
Map = Annotated[
    Path | None,
    value(
        "FILE",
        "Names of pelvis, hands, feet etc. in recording and figure: a TOML file, or a shipped map (g1, human)",
        "inferred",
        "--map",
    ),
]
Size = Annotated[Any, value("WIDTHxHEIGHT", "Width and height of the picture in pixels", parser=size)]
Camera = Annotated[
    str, value("NAME", "Camera: side (the figure's right), left, front, three_quarter, back, or a camera of the model")
]
SlowMotion = Annotated[float, number("FACTOR", "Slow motion: 2 plays at half speed, 0.5 at double speed", 0.01, 1000)]
RenderWorkers = Annotated[
    int | None,
    number("N", "Number of rendering processes", 1, 60, "1; one per core if there is no OpenGL driver", kind=int),
]
PenaltyFigure = Annotated[
    str | None,
    value("MODEL", "Figure to which they apply: name of a shipped figure, or MJCF file", "any", "--figure"),
]
StudioSource = Annotated[
    str,
    typer.Argument(
        metavar="CLIP",
        help="Clip (.toml), or name of a shipped clip",
    ),
]
ThinSolve = Annotated[
    bool, flag("--solve", "Also solve the thinned clip, and keep its solution within the error bound")
]
ExportFormat = Annotated[
    str | None, value("FORMAT", "Format of the output, see `dynsplines formats`", "from the extension of -o")
]
Columns = Annotated[
    str,
    value(
        "COLUMNS",
        "Columns to add to csv, separated by commas: angles, velocities, torques, wrench (at the root), ground; or all",
        "none",
        "--with",
    ),
]
ImportSource = Annotated[
    Path, typer.Argument(metavar="FILE", help="Recording in a format that `dynsplines formats` lists")
]
BatchSources = Annotated[
    list[str] | None, typer.Argument(help="Clips, or recordings with --clean or --retarget; folders or glob patterns")
]
BatchFolder = Annotated[
    Path,
    value("DIR", "Folder of the results and of manifest.jsonl, which lists every clip", True, "-o", "--output"),
]
List = Annotated[str | None, value("FILE", "File with more clips, one per line; - reads stdin", "none", "--list")]
BatchWorkers = Annotated[
    int | None, number("N", "Number of processes on this machine", 1, 1000, "one per core", kind=int)
]
MeasureAll = Annotated[
    bool, flag("--report/--no-report", "Also measure every motion, which more than doubles the time")
]
