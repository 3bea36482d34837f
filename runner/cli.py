"""The command `dynsplines`: its subcommands and their options.

Modules are imported on first use. Annotations are objects, because typer evaluates annotations in text slowly.
"""

import json
import math
import os
import sys
from collections.abc import Callable, Sequence
from enum import StrEnum
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn, cast

import typer
from typer.core import TyperGroup

from .errors import UserError, unknown
from .system import exit_status


class _Lazy:
    """A module of this package, imported on first use."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        return getattr(import_module(self._name, __package__), attribute)


if TYPE_CHECKING:
    from . import batch as batches
    from . import inputs, models, motion
    from .batch import recordings
    from .clean import command as clean_command
    from .clean import rest_pose_trim
    from .clip import kinds, load, starter
    from .edit import files, thin_files
    from .exchange import formats, motion_import, quantities, trajectory
    from .exchange.skeleton import maps
    from .measure import chart, summary, violation
    from .measure import report as reports
    from .picture import film, graphics, rendering, show
    from .scene import file_access
    from .studio import launch as studio_start
    from .studio import sources as studio_sources
    from .system import output as outputs
    from .system import progress as terminal
    from .system import quantity
else:

    def _lazy(package: str, names: str) -> list[_Lazy]:
        return [_Lazy(f"{package}.{name}") for name in names.split()]

    batches, inputs, models, motion = _lazy("", "batch inputs models motion")
    kinds, load, starter = _lazy(".clip", "kinds load starter")
    files, thin_files = _lazy(".edit", "files thin_files")
    formats, motion_import, quantities, trajectory, maps = _lazy(
        ".exchange", "formats motion_import quantities trajectory skeleton.maps"
    )
    chart, summary, violation, reports = _lazy(".measure", "chart summary violation report")
    film, graphics, rendering, show = _lazy(".picture", "film graphics rendering show")
    studio_sources, studio_start = _lazy(".studio", "sources launch")
    outputs, terminal, quantity = _lazy(".system", "output progress quantity")
    recordings, clean_command, rest_pose_trim, file_access = _lazy(
        "", "batch.recordings clean.command clean.rest_pose_trim scene.file_access"
    )

UsageError = cast("type[typer.BadParameter]", typer.BadParameter.__mro__[1])  # typer's own, or click's

VIOLATED = 3  # the exit code of --strict
BEFORE_MUJOCO = ("scipy.sparse", "scipy.linalg", ".clip.table", ".system.progress")


class _Panels(TyperGroup):
    """Commands listed under their `rich_help_panel`; rich itself would double the time that --help takes."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        panels: dict[str, list[tuple[str, str]]] = {}
        for name, command in self.commands.items():
            summary = (command.help or "").partition("\n")[0].rstrip(".")
            panels.setdefault(getattr(command, "rich_help_panel", ""), []).append((f"{name:10}", summary))
        for panel, rows in panels.items():
            with formatter.section(panel):
                formatter.write_dl(rows)


app = typer.Typer(
    cls=_Panels,
    help="Compute smooth motion of an articulated figure through sparse keyframes.\n\n"
    "A clip is a file of keyframes; a motion (.npz) is its solution.\n\n"
    "Start with `dynsplines render run_and_step`. `dynsplines COMMAND --help` lists a command's options.",
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)


def _flag(*words: str, **more: Any) -> Any:
    """Return an option without a value; the last of `words` is its help, the others are its names."""
    return typer.Option(*words[:-1], help=words[-1], **more)


def _value(metavar: str, help: str, default: str | bool = True, *names: str, **more: Any) -> Any:
    """Return an option; `default` is the text that describes a computed default."""
    return typer.Option(*names, metavar=metavar, help=help, show_default=default, **more)


def _number(
    metavar: str, help: str, least: float, most: float, default: str | bool = True, *names: str, kind: type = float
) -> Any:
    """Return an option of a finite number from `least` to `most`; the ranges of click accept nan."""
    span = f"{least:g} to {most}" if most < math.inf else f"{least:g} or more" if least > -math.inf else ""

    def number(text: object) -> float:
        try:
            value = kind(text)
        except (ValueError, OverflowError):
            value = math.nan
        if not (least <= value <= most and math.isfinite(value)):
            raise typer.BadParameter(f"{text}: give a {'whole ' * (kind is int)}number{span and f', {span}'}")
        return value

    return _value(metavar, f"{help}{span and f', {span}'}", default, *names, parser=number)


def _seconds(help: str, default: str | bool = True, *names: str) -> Any:
    return _number("SECONDS", help, -math.inf, math.inf, default, *names)


def _output(default: str) -> Any:
    return _value("FILE", "Write to this file", default, "-o", "--output")


def _size(text: str) -> tuple[int, int]:
    """Return width and height [pixels] from text such as "1280x720"."""
    sides = text.lower().split("x")
    if len(sides) != 2 or not all(side.isascii() and side.isdigit() and len(side) < 10 for side in sides):
        raise typer.BadParameter(f"{text}: give WIDTHxHEIGHT in pixels, such as 1280x720")
    width, height = map(int, sides)
    if not (16 <= width <= 3840 and 16 <= height <= 2160):
        raise typer.BadParameter(f"{text}: give 16x16 to 3840x2160")
    return width, height


def _quantity(kind: str, help: str, *names: str) -> Any:
    """Return an option of a length or a speed with its unit."""
    return _value(kind.upper(), help, "none", *names, parser=lambda text: getattr(quantity, kind)(text, names[0]))


Only = StrEnum("Only", ["before", "after", "keys"])


def _prepare(context: typer.Context, allow: bool) -> bool:
    """Apply --allow-outside until the command ends, and import MuJoCo without graphics unless the command draws."""
    context.with_resource(file_access.allowed(allow))
    if context.command.name != "render":
        graphics.do_without()
    return allow


Anything = "Name of a shipped clip, or a file: clip (.toml), model (.xml) or motion"
Source = Annotated[str, typer.Argument(metavar="CLIP|MOTION.npz", help=Anything)]
Clip = Annotated[str, typer.Argument(metavar="CLIP", help="Name of a shipped clip, or a .toml or .xml file")]
Recording = Annotated[
    Path, typer.Argument(metavar="RECORDING", help="Motion, or a recording in a format that `import` reads")
]
Overwrite = Annotated[bool, _flag("--overwrite", "Overwrite an existing output file")]
Strict = Annotated[bool, _flag("--strict", "Exit with code 3 if the motion has violations")]
NoCache = Annotated[bool, _flag("--no-cache", "--fresh", "Solve again instead of using the cached solution")]
Outside = Annotated[bool, _flag("--allow-outside", "Allow a model to read files outside its folder", callback=_prepare)]
AsJson = Annotated[bool, _flag("--json", "Print JSON")]
SkipRest = Annotated[bool, _flag("--skip-rest", "Remove a T-pose before the motion")]
Repeat = Annotated[int | None, _number("N", "Repeat a loop N times without a seam", 1, math.inf, "once", kind=int)]
Rate = Annotated[float | None, _number("HZ", "Samples per second", 0.01, 100_000, "the clip's, or 30")]
Figure = Annotated[
    str | None, _value("MODEL", "Figure of the recording: name of a shipped figure, or MJCF file", "the file's")
]
Format = Annotated[str | None, _value("FORMAT", "Format of the recording", "by the file's extension", "--from")]
Fps = Annotated[float | None, _number("HZ", "Frames per second of the recording", 0.01, 1000, "the file's")]
Scale = Annotated[float | None, _number("METRES", "Length unit of the file, e.g. 0.01 for cm", 1e-6, 10**6, "inferred")]
Scene = Annotated[Path | None, _value("FILE", "TOML file with the [scene] of the recording", "a flat floor")]
Within = Annotated[
    float | None,
    _quantity(
        "length", "Largest distance limbs may move from the recording, e.g. 3cm", "--max-displacement", "--within"
    ),
]
Speed = Annotated[float | None, _quantity("speed", "Largest joint speed, e.g. 20rad/s or 1200deg/s", "--speed-limit")]
Contacts = Annotated[Path | None, _value("FILE", "TOML file with [[contact]] tables", "inferred")]
WriteMap = Annotated[bool, _flag("--write-map", "Write the inferred bone map to the file given by --map")]
Model = Annotated[str | None, _value("MODEL", "Figure of --keys: name of a shipped figure, or MJCF file", "the clip's")]
Keys = Annotated[str | None, _value("FILE", ".npz with time (K,) and qpos (K, nq) of --model", "the clip's")]
Edited = Annotated[Path | None, _output("SOURCE_EDIT.npz, or .toml of a clip")]
OverSource = Annotated[bool, _flag("--overwrite", "Allow -o to overwrite the input file")]
Map = Annotated[Path | None, _value("FILE", "Bone map: TOML file, or the shipped g1 or human", "inferred", "--map")]


def main() -> None:
    """The command `dynsplines`."""
    run(lambda: app(sys.argv[1:] or ["--help"], prog_name="dynsplines", standalone_mode=False))


def run(command: Callable[[], int | None]) -> NoReturn:
    """Run a typer app and exit with its code; print a one-line message for an error."""

    def translated() -> int | None:
        try:
            return command()
        except typer.Abort:
            raise KeyboardInterrupt from None
        except UsageError as error:
            if type(error) is typer.BadParameter and (option := getattr(error, "param", None)) is not None:
                raise UserError(f"{option.opts[0]} {error.message.removeprefix('Value error, ')}") from None
            path = error.ctx.command_path if error.ctx else "dynsplines"
            raise UserError(f"{error.format_message()} (see `{path} --help`)") from None

    exit_status.run(translated)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version  # only here: it takes a moment

        from .solver import compiled

        by = "the compiled kernel" if compiled.kernel is not None else "NumPy alone (no compiled kernel)"
        print(f"dynsplines {version('dynamic-splines')}, MuJoCo {version('mujoco')}, solving with {by}")
        raise typer.Exit


@app.callback()
def _options(
    debug: Annotated[bool, _flag("--debug", "Print a traceback on an internal error")] = False,
    version: Annotated[bool, _flag("--version", "Print the version", is_eager=True, callback=_print_version)] = False,
) -> None:
    if debug:
        os.environ[exit_status.DEBUG] = "1"


@app.command("new", rich_help_panel="Create")
def new_clip(
    model: Annotated[str, typer.Argument(metavar="MODEL", help="MJCF file, or name of a shipped figure")],
    output: Annotated[Path | None, _output("MODEL.toml")] = None,
    overwrite: Overwrite = False,
    allow_outside: Outside = False,
) -> None:
    """Write a commented starting clip for a model.
    It contains the model's keyframes; without any, a pose and a movement. Comments list joints, sites and options."""
    target = _target(output, f"{Path(model).stem}.toml", "clip", overwrite)
    notes: list[str] = []
    text = starter.starter(model, target, notes.append)
    with outputs.Replacement(target) as temporary:
        temporary.write_text(text, encoding="utf-8")
    for note in notes:
        print(f"note: {note}", file=sys.stderr)
    print(f"wrote {target}; see it: dynsplines render {target}{' --allow-outside' if allow_outside else ''}")


@app.command(rich_help_panel="Create")
def solve(
    source: Clip = "",
    output: Annotated[Path | None, _output("CLIP.npz")] = None,
    fps: Rate = None,
    repeat: Repeat = None,
    strict: Strict = False,
    as_json: AsJson = False,
    fresh: NoCache = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Solve a clip and save the motion as arrays (.npz).
    Violations are printed last, worst first. Ctrl-C stops solving and saves the best motion so far."""
    target = _target(output, f"{_name(source, model, keys)}.npz", "motion")
    with terminal.Progress() as progress:
        clip = inputs.load(source, model=model, keys=keys, fps=fps)
        if isinstance(clip, motion.Saved):
            raise UserError(f"{source}: a motion is solved already; report, plot and render take it")
        first, last = inputs.span(clip, repeat)
        motion.sample_count(last - first, clip.fps)
        saved, violations = inputs.solved(clip, progress, repeat, fresh=fresh)
        motion.save(saved, target)
        _conclude(progress, target, violations, target)
    if as_json:
        print(json.dumps(summary.summary(saved, violations), indent=2))
    _judge(violations, strict)


@app.command(rich_help_panel="Create")
def render(
    source: Source = "",
    output: Annotated[Path | None, _output("CLIP.mp4; CLIP.png with --at or --ghosts")] = None,
    only: Annotated[
        Only | None,
        _value("before|after|keys", "Render only the motion before or after solving, or the keyframes", "both"),
    ] = None,
    ghosts: Annotated[bool, _flag("--ghosts", "Draw all frames in one picture, with keyframes darkest")] = False,
    size: Annotated[Any, _value("WIDTHxHEIGHT", "Width and height in pixels", parser=_size)] = "1280x720",
    fps: Annotated[float | None, _number("HZ", "Frames per second", 0.01, 1000, "the clip's, or 30")] = None,
    camera: Annotated[
        str, _value("NAME", "Camera: side, left, front, three_quarter, back, or a camera of the model")
    ] = "side",
    slow: Annotated[float, _number("FACTOR", "Slow-motion factor", 0.01, 1000)] = 1.0,
    at: Annotated[float | None, _seconds("Render a single frame at this time", "all")] = None,
    workers: Annotated[
        int | None, _number("N", "Number of rendering processes", 1, 60, "1; without OpenGL one per core", kind=int)
    ] = None,
    repeat: Repeat = None,
    strict: Strict = False,
    fresh: NoCache = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Render a clip or a motion as a video or a picture.
    The extension of -o selects .mp4, .webm or .gif, or .png for a contact sheet. A clip is solved first."""
    target = output or Path(f"{_name(source, model, keys)}.{'png' if ghosts or at is not None else 'mp4'}")
    width, height = size
    film.check_target(target, width, height)
    if width % 2 and not only and not (ghosts and target.suffix.lower() == ".png"):
        raise UserError(f"--size {width}x{height}: two halves side by side need an even width")
    renderer = _renderer()
    with terminal.Progress() as progress:
        unmet: list[str] | None = [] if only == "keys" else None
        clip = inputs.load(source, model=model, keys=keys, unmet=unmet)
        for line in unmet or ():
            progress.say(f"note: {line}; drawn as near as it comes")
        look = show.Look(width, height, fps or clip.fps, only or "", ghosts, camera, slow, at)
        look.check(clip.figure.model, *inputs.span(clip, repeat), flags="--")
        progress.say(renderer.line)
        is_solved = only not in ("keys", "before")
        saved, violations = inputs.solved(clip, progress, repeat, solve=is_solved, fresh=fresh)
        rendering.draw(saved, look, renderer, target, workers, progress)
        _conclude(progress, target, violations, source)
    _judge(violations, strict)


@app.command(rich_help_panel="Create")
def studio(
    source: Annotated[str, typer.Argument(metavar="CLIP|MOTION|RECORDING|MODEL.xml", help=Anything)] = "run_and_step",
    figure: Figure = None,
    port: Annotated[int, _number("PORT", "TCP port, 0 for a free one", 0, 65535, kind=int)] = 0,
    host: Annotated[
        str, _value("ADDRESS", "Address to listen on; --allow-remote permits non-local addresses")
    ] = "127.0.0.1",
    browser: Annotated[bool, _flag("--browser/--no-browser", "Open the page in a browser")] = True,
    allow_remote: Annotated[bool, _flag("--allow-remote", "Let other machines edit the clip and write files")] = False,
    allow_outside: Outside = False,
) -> None:
    """Edit and solve a clip live in the browser."""
    from importlib.util import find_spec

    for name in ("starlette", "uvicorn", "websockets", "tomlkit"):
        if sys.modules.get(name) is None and (name in sys.modules or find_spec(name) is None):
            raise UserError(f"the studio needs {name}: pip install 'dynamic-splines[studio]'")
    studio_start.check_host(host, allow_remote=allow_remote)
    more = {"host": host, "port": port, "browser": browser, "allow_remote": allow_remote}
    studio_start.run(studio_sources.opened(source, figure=figure), say=partial(print, flush=True), **more)


@app.command(rich_help_panel="Create")
def clips(show: Annotated[str | None, _value("NAME", "Print the text of this clip", "none")] = None) -> None:
    """List the shipped clips, or print the text of one."""
    if show is None:
        print(*(f"{name:16} {line}" for name, line in models.clips().items()), sep="\n")
    elif show in models.clips():
        print(models.clip_text(show), end="")
    else:
        raise UserError(f"--show: {unknown('clip', show, models.clips())}")


@app.command("models", rich_help_panel="Create")
def list_models() -> None:
    """List the shipped figures."""
    print(*(f"{name:16} {line}" for name, line in models.figures().items()), sep="\n")


@app.command("penalties", rich_help_panel="Create")
def list_penalties(as_json: AsJson = False) -> None:
    """List the soft constraints, their weights and options.
    A clip configures them in [[penalty]] tables. Weights are the defaults; options are listed with their units."""
    if as_json:
        print(json.dumps([kind.described() for kind in kinds.KINDS.values()], indent=2))
        return
    for kind in kinds.KINDS.values():
        if kind.parts[0].name:
            print(kind.name)
        for part in kind.parts:
            on = f"; on with {part.option}" if part.option else "" if kind.is_default else "; on where listed"
            print(f"{f'  {part.name}' if part.name else kind.name:13} {part.weight:4g}  {part.quantity}{on}")
        for name, values in kind.choices().items():
            print(f"{'':20}{name} ({values})")


@app.command(rich_help_panel="Edit")
def mirror(
    source: Source,
    output: Edited = None,
    overwrite: OverSource = False,
    fresh: NoCache = False,
    allow_outside: Outside = False,
) -> None:
    """Swap left and right in a motion or a clip."""
    _edit(files.mirrored(), output, overwrite, fresh, source)


@app.command(rich_help_panel="Edit")
def retime(
    source: Source,
    output: Edited = None,
    speed: Annotated[float | None, _number("FACTOR", "Speed factor, e.g. 1.5", -math.inf, math.inf, "none")] = None,
    duration: Annotated[float | None, _seconds("New duration", "none")] = None,
    overwrite: OverSource = False,
    fresh: NoCache = False,
    allow_outside: Outside = False,
) -> None:
    """Change the speed of a motion or a clip."""
    _edit(files.retimed(speed, duration), output, overwrite, fresh, source)


@app.command(rich_help_panel="Edit")
def trim(
    source: Source,
    output: Edited = None,
    first: Annotated[float | None, _seconds("Start of the interval", "the start", "--from")] = None,
    last: Annotated[float | None, _seconds("End of the interval", "the end", "--to")] = None,
    overwrite: OverSource = False,
    fresh: NoCache = False,
    allow_outside: Outside = False,
) -> None:
    """Keep only a time interval of a motion, without altering it."""
    _edit(files.trimmed(first, last), output, overwrite, fresh, source)


@app.command(rich_help_panel="Edit")
def join(
    first: Source,
    second: Source,
    output: Edited = None,
    transition: Annotated[float, _seconds("Duration of the transition")] = 0.4,
    overwrite: OverSource = False,
    fresh: NoCache = False,
    allow_outside: Outside = False,
) -> None:
    """Append one motion to another, with a transition.
    The second motion is translated and rotated to continue from the end of the first."""
    _edit(files.joined(transition), output, overwrite, fresh, first, second)


@app.command(rich_help_panel="Edit")
def thin(
    source: Annotated[str, typer.Argument(metavar="MOTION", help="Motion (.npz), recording, or clip")],
    output: Annotated[Path | None, _output("SOURCE_thin.toml")] = None,
    max_error: Annotated[str, _value("LENGTH", "Largest position error of any body or site")] = "2cm",
    max_angle: Annotated[float, _number("DEGREES", "Largest rotation error of any body", 0, 180)] = 5.0,
    solve: Annotated[
        bool, _flag("--solve", "Bound the error of the solved motion instead of the spline through the keyframes")
    ] = False,
    exact: Annotated[bool, _flag("--exact", "Write a clip whose solution is the spline through its keyframes")] = False,
    skip_rest: SkipRest = False,
    figure: Figure = None,
    kind: Format = None,
    fps: Fps = None,
    overwrite: Overwrite = False,
    fresh: NoCache = False,
    allow_outside: Outside = False,
) -> None:
    """Reduce a motion to few keyframes within an error bound.
    The extension of -o selects a clip (.toml) or a motion (.npz)."""
    recording = thin_files.ToThin(source, figure, kind, fps, fresh, skip_rest)
    bound = thin_files.bound(max_error, max_angle)
    with terminal.Progress() as progress:
        thin_files.run(recording, bound, output, solve=solve, exact=exact, overwrite=overwrite, progress=progress)


@app.command(rich_help_panel="Analyse")
def report(
    source: Source = "",
    strict: Strict = False,
    as_json: AsJson = False,
    fresh: NoCache = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Measure a motion before and after solving.
    Measures penetration, joint ranges, foot skate, torques and distance from the optimum, sampled at 1 kHz."""
    from rich.console import Console

    measured = _measured(source, model, keys, fresh).report
    if as_json:
        print(json.dumps({key: value for key, value in measured.items() if key != "curves"}, indent=2))
    else:
        with inputs.complete_report(source):
            text = reports.tables(measured)
        Console(highlight=False).print(text, markup=False)
    _judge(measured["violations"], strict)


@app.command(rich_help_panel="Analyse")
def plot(
    source: Source = "",
    output: Annotated[Path | None, _output("CLIP.png")] = None,
    fresh: NoCache = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Plot charts of a motion and of its optimization.
    Charts: foot height, unit magnitude, Euler-Lagrange deviation, and penalties per evaluation.
    The extension of -o selects .png, .svg or .pdf."""
    target = output or Path(f"{_name(source, model, keys)}.png")
    chart.check_target(target)
    outputs.check_target(target)
    saved = _measured(source, model, keys, fresh)
    with inputs.complete_report(source):
        chart.draw(saved.name, saved.report, saved.trace, [key.time for key in saved.keys], target)
    print(f"wrote {target}", file=sys.stderr)


@app.command(rich_help_panel="Exchange")
def export(
    source: Source,
    to: Annotated[str | None, _value("FORMAT", "Format, see `dynsplines formats`", "by the extension of -o")] = None,
    output: Annotated[Path | None, _output("SOURCE with the format's extension")] = None,
    fps: Rate = None,
    columns: Annotated[
        str, _value("COLUMNS", "Extra columns of csv: velocities,torques,wrench,ground or all", "none", "--with")
    ] = "",
    simulate: Annotated[bool, _flag("--simulate", "With mjcf: write a scene with actuators, for simulation")] = False,
    repeat: Repeat = None,
    overwrite: Overwrite = False,
    fresh: NoCache = False,
    allow_outside: Outside = False,
) -> None:
    """Export a motion to a format that other programs read."""
    form, options = formats.chosen(to, output), trajectory.ExportOptions(simulate, quantities.named(columns))
    formats.check_options(form, options)
    target = output or formats.target_of(formats.stem(Path(source)), form, options)
    outputs.check_target(target)
    outputs.check_new(target, overwrite=overwrite)
    with terminal.Progress() as progress:
        clip = inputs.load(source)
        inputs.span(clip, repeat)
        saved, violations = inputs.solved(clip, progress, repeat, fresh=fresh)
        formats.export(saved, form.name, target, fps=fps, options=options, overwrite=overwrite, tell=progress.say)
        _conclude(progress, target, violations, source)


@app.command("import", rich_help_panel="Exchange")
def import_motion(
    source: Annotated[
        Path, typer.Argument(metavar="FILE", help="Recorded motion, in a format of `dynsplines formats`")
    ],
    figure: Figure = None,
    kind: Format = None,
    fps: Fps = None,
    scale: Scale = None,
    skip_rest: SkipRest = False,
    output: Annotated[Path | None, _output("FILE.npz")] = None,
    strict: Strict = False,
    overwrite: Overwrite = False,
    allow_outside: Outside = False,
) -> None:
    """Import a recorded motion and report its violations.
    Every sample becomes a keyframe. The motion is not solved."""
    target = _target(output, f"{formats.stem(source)}.npz", "motion")
    if target.exists() and source.exists() and target.samefile(source):
        raise UserError(f"'{target}' is the input file; give another -o")
    outputs.check_new(target, overwrite=overwrite)
    with terminal.Progress() as progress:
        recording = motion_import.import_recording(source, kind, figure=figure, fps=fps, scale=scale, progress=progress)
        saved = rest_pose_trim.told(recording, progress, skip=skip_rest)
        motion.save(saved, target)
        violations = violation.of_motion(saved)
        _conclude(progress, target, violation.by_name(violations), target)
    _judge(violations, strict)


@app.command("formats", rich_help_panel="Exchange")
def list_formats() -> None:
    """List the formats that export writes and import reads."""
    for form in formats.FORMATS:
        uses = " and ".join(word for word, can in (("reads", form.reads), ("writes", form.writes)) if can)
        print(f"{form.name:12} {form.ending:15} {uses:16} {form.description}")


@app.command(rich_help_panel="Recordings")
def clean(
    source: Recording,
    output: Annotated[Path | None, _output("RECORDING.clean with the extension of RECORDING")] = None,
    figure: Figure = None,
    map_file: Map = None,
    write_map: WriteMap = False,
    kind: Format = None,
    fps: Fps = None,
    scale: Scale = None,
    scene: Scene = None,
    contacts: Contacts = None,
    within: Within = None,
    speed_limit: Speed = None,
    overwrite: Overwrite = False,
    allow_outside: Outside = False,
) -> None:
    """Make a recording physically plausible.
    Removes foot skate, penetration, floating and jumps, and stays close to the recording."""
    place = _map(map_file, write_map)
    recording = clean_command.Source(
        source, figure, kind, fps, scale, scene, contacts, place, write_map, False, speed_limit
    )
    _clean(recording, output, within, overwrite)


@app.command(rich_help_panel="Recordings")
def retarget(
    source: Annotated[Path, typer.Argument(metavar="RECORDING", help="Motion of a skeleton, e.g. a BVH file")],
    to: Annotated[str, _value("MODEL", "Target figure: name of a shipped figure, or MJCF file")],
    output: Annotated[Path | None, _output("RECORDING.MODEL.npz")] = None,
    map_file: Map = None,
    write_map: WriteMap = False,
    kind: Format = None,
    fps: Fps = None,
    scale: Scale = None,
    scene: Scene = None,
    contacts: Contacts = None,
    within: Within = None,
    speed_limit: Speed = None,
    overwrite: Overwrite = False,
    allow_outside: Outside = False,
) -> None:
    """Transfer a skeleton's motion to a figure, and clean it.
    Joints stay within the figure's ranges, and its limbs do not collide."""
    target = output or Path(f"{formats.stem(source)}.{Path(to).stem}.npz")
    place = _map(map_file, write_map)
    recording = clean_command.Source(source, to, kind, fps, scale, scene, contacts, place, write_map, True, speed_limit)
    _clean(recording, target, within, overwrite)


@app.command(rich_help_panel="Batch")
def batch(
    clips: Annotated[list[str] | None, typer.Argument(help="Clips, recordings, folders or glob patterns")] = None,
    output: Annotated[Path, _value("DIR", "Folder for results and manifest", True, "-o", "--output")] = Path("batch"),
    listed: Annotated[str | None, _value("FILE", "More clips, one per line; - is stdin", "none", "--list")] = None,
    workers: Annotated[
        int | None, _number("N", "Number of processes on this machine", 1, 1000, "one per core", kind=int)
    ] = None,
    scheduler: Annotated[str | None, _value("tcp://HOST:PORT", "Address of a Dask cluster to run on", "none")] = None,
    to: Annotated[str, _value("FORMAT", "npz, or one of `dynsplines formats`")] = "npz",
    fps: Rate = None,
    limit_time: Annotated[float, _number("SECONDS", "Time limit for solving each clip", 0.1, 10**6)] = 3600.0,
    limit_memory: Annotated[
        float | None, _number("MB", "Memory limit for solving each clip", 256, 10**7, "an equal share")
    ] = None,
    measure: Annotated[
        bool, _flag("--report/--no-report", "Measure every motion at 1 kHz, which takes longer than solving")
    ] = False,
    retry_failed: Annotated[bool, _flag("--retry-failed", "Retry clips that failed in an earlier run")] = False,
    strict: Strict = False,
    clean_all: Annotated[bool, _flag("--clean", "Clean recordings, see `dynsplines clean`")] = False,
    onto: Annotated[str | None, _value("MODEL", "Retarget recordings to this figure", "none", "--retarget")] = None,
    figure: Figure = None,
    map_file: Map = None,
    kind: Format = None,
    scene: Scene = None,
    within: Within = None,
    allow_outside: Outside = False,
) -> None:
    """Solve many clips in parallel.
    Uses all cores, or a Dask cluster. Repeat the command to resume an interrupted run."""
    cleaning = recordings.asked(
        clean=clean_all, onto=onto, figure=figure, map_file=map_file, kind=kind, scene=scene, within=within
    )
    options = batches.Options(
        listed, workers, scheduler, to, fps, batches.Limits(limit_time, limit_memory), measure, retry_failed, cleaning
    )
    with terminal.Progress() as progress:
        tally = batches.run(clips or [], output, progress, options)
        if cleaning is not None:
            recordings.tell(tally, progress)
        for line in [*([] if cleaning is not None else tally.violations), *tally.failures()]:
            progress.say(line)
        progress.say(f"{output}: {tally.line}")
    if tally.failed:
        raise typer.Exit(1)
    _judge(tally.wrong, strict)


def _name(source: str, model: str | None, keys: str | None) -> str:
    """Return the stem of the output's file name; raises UserError without a source."""
    if not source and keys is None and model is None:
        raise UserError("name a clip (see `dynsplines clips`), a file, or --model with --keys")
    return Path(source if keys is None else keys).stem or "motion"


def _measured(source: str, model: str | None, keys: str | None, fresh: bool) -> "motion.Saved":
    """Return the motion of a source with its report."""
    _name(source, model, keys)
    with terminal.Progress() as progress:
        return inputs.measured(inputs.load(source, model=model, keys=keys), progress, fresh=fresh)


def _edit(edit: "files.Edit", output: Path | None, overwrite: bool, fresh: bool, *edited: str) -> None:
    """Apply an edit to files, and print the name of the written file."""
    with terminal.Progress() as progress:
        target, violations = files.run(list(edited), edit, output, overwrite=overwrite, fresh=fresh, progress=progress)
        _conclude(progress, target, violations, target)


def _map(place: Path | None, writes: bool) -> Path | None:
    """Return the file of --map; raises UserError for --write-map without one."""
    if writes and place is None:
        raise UserError("--write-map: name the file, --map FILE")
    return place if writes else maps.map_of(place)


def _clean(recording: "clean_command.Source", target: Path | None, within: float | None, overwrite: bool) -> None:
    with terminal.Progress() as progress:
        clean_command.run(recording, target, within=within, overwrite=overwrite, progress=progress)


def _target(output: Path | None, name: str, kind: str, overwrite: bool = True) -> Path:
    """Return the file to write, with the extension of `name`; raises UserError if it cannot be written."""
    target = output or Path(name)
    if target.suffix != Path(name).suffix:
        raise UserError(f"{target}: a {kind} file's name ends in {Path(name).suffix}")
    outputs.check_target(target)
    outputs.check_new(target, overwrite=overwrite)
    return target


def _renderer() -> "graphics.Graphics":
    """Return the renderer to use; while a process tries it, import modules that do not load MuJoCo."""
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(1) as aside:
        trial = aside.submit(graphics.choose)
        for name in BEFORE_MUJOCO:
            import_module(name, __package__)
        return trial.result()


def _conclude(progress: Any, target: Path, violations: "Sequence[violation.Violation]", file: object) -> None:
    """Print the name of the written file and its violations; `file` is the argument of the suggested `report`."""
    for line in (f"wrote {target}", *violation.lines(violations, file)):
        progress.say(line)


def _judge(violations: Sequence[object], strict: bool) -> None:
    """End with code 3 if there are violations and `strict` is set."""
    if strict and violations:
        raise typer.Exit(VIOLATED)
