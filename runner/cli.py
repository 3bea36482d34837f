"""The command `dynsplines`: its subcommands and their options.

Modules are imported on first use. Annotations are objects, because typer evaluates annotations in text slowly.
"""

import json
import os
import sys
from collections.abc import Sequence
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from dynsplines import models

from . import cli_options as option
from .cli_options import flag, number, seconds, value
from .errors import UserError, unknown
from .picture import graphics
from .system import exit_status, signals
from .system import output as outputs
from .system.threads import without_tools


class _Lazy:
    """A module of this package, imported on first use."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        if not self._name.startswith(".system"):
            without_tools()  # before modules that import SciPy
        return getattr(import_module(self._name, __package__), attribute)


if TYPE_CHECKING:
    from . import batch as batches
    from . import inputs, motion, solving
    from .clean import command as clean_command
    from .clip import context, kinds, starter
    from .edit import files, thinning
    from .exchange import formats, motion_import, quantities
    from .exchange.skeleton import maps
    from .measure import chart, measurement, violation
    from .measure import report as reports
    from .picture import film, show
    from .studio import document, launch
    from .system import progress as terminal
else:

    def _lazy(package: str, names: str) -> list[_Lazy]:
        return [_Lazy(f"{package}.{name}") for name in names.split()]

    inputs, motion, solving, terminal = _lazy("", "inputs motion solving system.progress")
    batches, context, kinds, starter = _lazy("", "batch clip.context clip.kinds clip.starter")
    files, thinning = _lazy(".edit", "files thinning")
    (clean_command,) = _lazy(".clean", "command")
    formats, motion_import, quantities, maps = _lazy(".exchange", "formats motion_import quantities skeleton.maps")
    chart, measurement, violation, reports = _lazy(".measure", "chart measurement violation report")
    film, show = _lazy(".picture", "film show")
    document, launch = _lazy(".studio", "document launch")

VIOLATED = 3  # the exit code of --strict
BEFORE_MUJOCO = ("scipy.sparse", "scipy.linalg", "dynsplines.clip.table", "dynsplines.system.progress")


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
    "A clip is a file of keyframes. A motion (.npz) is a movement over time: a solved clip or an imported recording. "
    "A recording is a file with captured motion, or with motion from another program.\n\n"
    "To start, run `dynsplines render run_and_step`. `dynsplines COMMAND --help` lists the options of a command.",
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)


def main() -> None:
    """The command `dynsplines`."""
    exit_status.run(lambda: app(sys.argv[1:] or ["--help"], prog_name="dynsplines", standalone_mode=False))


@app.callback()
def _options(
    debug: Annotated[bool, flag("--debug", "Print the traceback of an internal error")] = False,
    version: option.Version = False,
) -> None:
    if debug:
        os.environ[exit_status.DEBUG] = "1"


@app.command("new", rich_help_panel="Create")
def new_clip(
    model: Annotated[str, typer.Argument(metavar="MODEL", help="MJCF or URDF file, or name of a shipped figure")],
    output: Annotated[Path | None, option.output("MODEL.toml")] = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Write a commented starter clip for a model.
    It contains the pose of the first <key> of the model. If there is none, it contains the rest pose.
    Comments in the file list joints, sites and the options of soft constraints."""
    target = _target(output, f"{Path(model).stem}.toml", "clip", overwrite)
    text = starter.starter(model, target, lambda note: print(f"note: {note}", file=sys.stderr))
    with outputs.Replacement(target) as temporary:
        temporary.write_text(text, encoding="utf-8")
    print(f"wrote {target}; see it: dynsplines render {target}{' --allow-outside' if allow_outside else ''}")


@app.command(rich_help_panel="Create")
def solve(
    source: option.Clip,
    output: Annotated[Path | None, option.output("CLIP.npz")] = None,
    fps: option.Rate = None,
    repeat: option.Repeat = None,
    strict: option.Strict = False,
    as_json: option.AsJson = False,
    allow_outside: option.Outside = False,
) -> None:
    """Solve a clip and save the motion as arrays (.npz).
    An existing file is overwritten. At the end, the violations of the motion are listed, the worst one first.
    Ctrl-C stops solving and saves the best motion so far."""
    target = _target(output, f"{Path(source).stem}.npz", "motion")
    with terminal.Progress() as progress:
        clip = inputs.load(source, fps=fps)
        if isinstance(clip, motion.Saved):
            raise UserError(f"{source}: a motion is solved already; report, plot and render take it")
        first, last = inputs.span(clip, repeat)
        motion.sample_count(last - first, clip.fps)
        saved, violations = inputs.solution_of(clip, progress, repeat)
        motion.save(saved, target)
        _conclude(progress, target, violations, target)
    if as_json:
        print(json.dumps(violation.summary(saved, violations), indent=2))
    _judge(violations, strict)


@app.command(rich_help_panel="Create")
def render(
    source: option.Source,
    output: Annotated[Path | None, option.output("CLIP.mp4; CLIP.png with --at or --ghosts")] = None,
    only: option.Only = None,
    ghosts: option.Ghosts = False,
    size: option.Size = "1280x720",
    fps: Annotated[float | None, number("HZ", "Frames per second", 0.01, 1000, "the clip's, or 30")] = None,
    camera: option.Camera = "side",
    slow: option.SlowMotion = 1.0,
    at: Annotated[
        float | None, seconds("Render only the frame at this time", "a video shows all frames, a picture twelve")
    ] = None,
    workers: option.RenderWorkers = None,
    repeat: option.Repeat = None,
    strict: option.Strict = False,
    allow_outside: option.Outside = False,
) -> None:
    """Render a clip or a motion as a video or a picture.
    The extension of -o selects a video (.mp4, .webm, .gif) or a picture (.png). A clip is solved first.
    An existing file is overwritten."""
    target = output or Path(f"{Path(source).stem}.{'png' if ghosts or at is not None else 'mp4'}")
    width, height = size
    film.check_target(target, width, height)
    if at is not None and only == "keys":
        raise UserError("--at and --only keys: give one of them; --only keys draws all keyframes")
    if at is not None and ghosts and target.suffix.lower() == ".png":
        raise UserError("--at and --ghosts: give one of them for a picture; --ghosts draws many times in it")
    if width % 2 and not only and not (ghosts and target.suffix.lower() == ".png"):
        raise UserError(f"--size {width}x{height}: two halves side by side need an even width")
    renderer = graphics.choose_while_importing(BEFORE_MUJOCO)
    with terminal.Progress() as progress:
        unmet: list[str] | None = [] if only == "keys" else None
        clip = inputs.load(source, unmet=unmet)
        for line in unmet or ():
            progress.report(f"note: {line}; drawn as near as it comes")
        look = show.Look(width, height, fps or clip.fps, only or "", ghosts, camera, slow, at)
        look.check(clip.figure.model, *inputs.span(clip, repeat), flags="--")
        progress.report(renderer.line)
        is_solved = only not in ("keys", "before")
        saved, violations = inputs.solution_of(clip, progress, repeat, solve=is_solved)
        if signals.code(0):  # the sender of a signal other than Ctrl-C expects the end, and a video takes long
            progress.report("nothing is drawn after this signal")
            raise KeyboardInterrupt
        show.draw(saved, look, renderer, target, workers, progress)
        _conclude(progress, target, violations, source)
    _judge(violations, strict)


@app.command(rich_help_panel="Create")
def studio(
    source: option.StudioSource = "run_and_step",
    port: Annotated[int, number("PORT", "TCP port; 0 selects a free one", 0, 65535, kind=int)] = 0,
    browser: Annotated[bool, flag("--browser/--no-browser", "Open the page in a browser")] = True,
    allow_outside: option.Outside = False,
) -> None:
    """Edit a clip in the browser; it is solved after every edit."""
    launch.check_packages()
    launch.run(document.open_document(source), port=port, browser=browser)


@app.command(rich_help_panel="Create")
def clips(show: Annotated[str | None, value("NAME", "Print the text of this clip", "none")] = None) -> None:
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
def list_penalties(figure: option.PenaltyFigure = None, as_json: option.AsJson = False) -> None:
    """List the soft constraints, their weights and options.
    A clip configures them in [[penalty]] tables. The list shows default weights, and the units of options."""
    notes = {} if figure is None else {"prior": context.note_on(figure)}
    if as_json:
        print(json.dumps([kind.describe() for kind in kinds.KINDS.values()], indent=2))
        return
    for kind in kinds.KINDS.values():
        if kind.parts[0].name:
            print(kind.name)
        for part in kind.parts:
            on = f"; on with {part.option}" if not part.is_default else "" if kind.is_default else "; on if listed"
            on = notes.get(kind.name, on)
            print(f"{f'  {part.name}' if part.name else kind.name:13} {part.weight:4g}  {part.quantity}{on}")
        for name, values in kind.choices().items():
            print(f"{'':20}{name} ({values})")


@app.command(rich_help_panel="Edit")
def mirror(
    source: option.Source,
    output: option.Edited = None,
    append: Annotated[bool, flag("--append", "Append the mirror image of half a gait cycle")] = False,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Swap left and right in a motion or a clip.
    If the input is a clip (.toml), the output is a clip too, unless -o names a
    motion (.npz). In a clip, step and obstacles are mirrored; in a motion, the
    scene is unchanged. A mirrored motion has no clip."""
    _edit(partial(files.mirror, append=append), source, output=output, overwrite=overwrite)


@app.command(rich_help_panel="Edit")
def retime(
    source: option.Source,
    output: option.Edited = None,
    speed: Annotated[float | None, number("FACTOR", "Speed factor, e.g. 1.5", default="none")] = None,
    duration: Annotated[float | None, seconds("New duration", "none")] = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Change the speed of a motion or a clip.
    Specify either --speed or --duration. If the input is a clip (.toml), the output is a clip too, unless -o names a
    motion (.npz)."""
    _edit(files.retime, source, speed, duration, output=output, overwrite=overwrite)


@app.command(rich_help_panel="Edit")
def trim(
    source: option.Source,
    output: option.Edited = None,
    first: Annotated[float | None, seconds("Start of the interval", "the start", "--from")] = None,
    last: Annotated[float | None, seconds("End of the interval", "the end", "--to")] = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Cut a motion to a time interval.
    Specify --from or --to, or both. A clip is solved first."""
    _edit(files.trim, source, first, last, output=output, overwrite=overwrite)


@app.command(rich_help_panel="Edit")
def thin(
    source: Annotated[str, typer.Argument(metavar="MOTION", help="Motion (.npz), recording, or clip")],
    output: Annotated[Path | None, option.output("MOTION_thin.toml")] = None,
    max_error: Annotated[str, value("LENGTH", "Largest position error of any body, site or limb tip")] = "2cm",
    max_angle: Annotated[float, number("DEGREES", "Largest rotation error of any body", 0, 180)] = 5.0,
    solve: option.ThinSolve = False,
    figure: option.Figure = None,
    kind: option.Format = None,
    fps: option.Fps = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Reduce a motion to a few keyframes within an error bound.
    The extension of -o selects a clip (.toml) or a motion (.npz)."""
    bound = thinning.bound_of(max_error, max_angle, ("--max-error", "--max-angle"))
    with terminal.Progress() as progress:
        thinning.run(
            source,
            bound,
            output,
            figure=figure,
            kind=kind,
            fps=fps,
            solve=solve,
            overwrite=overwrite,
            progress=progress,
        )


@app.command(rich_help_panel="Analyse")
def report(
    source: option.Source,
    strict: option.Strict = False,
    as_json: option.AsJson = False,
    allow_outside: option.Outside = False,
) -> None:
    """Measure a motion and the spline through its keyframes.
    The report lists penetration, joint-limit violations and foot skate.
    It also estimates how far the cost is above the local optimum."""
    from rich.console import Console

    with terminal.Progress() as progress:
        measured = inputs.with_report(inputs.load(source), progress).report
    if as_json:
        print(json.dumps(measured, indent=2))
    else:
        try:
            text = reports.tables(measured)
        except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
            raise UserError(f"{source}: its report is not complete: {type(error).__name__} {error}") from None
        Console(highlight=False).print(text, markup=False)
    _judge(measured["violations"], strict)


@app.command(rich_help_panel="Analyse")
def plot(
    source: option.Source,
    output: Annotated[Path | None, option.output("CLIP.png")] = None,
    allow_outside: option.Outside = False,
) -> None:
    """Plot the measured faults of a motion over time.
    The chart shows the amount of every kind of violation, divided by its bound, before and after solving.
    The extension of -o selects .png, .svg or .pdf. An existing file is overwritten."""
    target = output or Path(f"{Path(source).stem}.png")
    outputs.check_target(target, endings=chart.ENDINGS)
    with terminal.Progress() as progress:
        one = inputs.load(source)
        saved = solving.saved_motion(one, progress)
        chart.draw(saved.name, *measurement.Measurement.sides(inputs.clip_of(one), saved), target)
    print(f"wrote {target}", file=sys.stderr)


@app.command(rich_help_panel="Exchange")
def export(
    source: option.Source,
    to: option.ExportFormat = None,
    output: Annotated[Path | None, option.output("name of the input with the extension of the format")] = None,
    fps: option.Rate = None,
    columns: option.Columns = "",
    repeat: option.Repeat = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Write a motion in the format of another program.
    A clip is solved first."""
    groups = quantities.groups_of(columns)
    form = formats.choose(to, output, groups)
    target = output or formats.target_of(formats.stem(Path(source)), form)
    outputs.check_target(target, overwrite=overwrite)
    with terminal.Progress() as progress:
        clip = inputs.load(source)
        inputs.span(clip, repeat)
        saved, violations = inputs.solution_of(clip, progress, repeat)
        formats.export(saved, form.name, target, fps=fps, columns=groups, overwrite=overwrite, report=progress.report)
        _conclude(progress, target, violations, source)


@app.command("import", rich_help_panel="Exchange")
def import_motion(
    source: option.ImportSource,
    figure: option.Figure = None,
    kind: option.Format = None,
    fps: option.Fps = None,
    scale: option.Scale = None,
    output: Annotated[Path | None, option.output("FILE.npz")] = None,
    strict: option.Strict = False,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Convert a recording to a motion and list its violations.
    Violations are penetration, joints beyond their ranges, sliding feet and others.
    Every sample becomes a keyframe. The motion is not changed."""
    target = _target(output, f"{formats.stem(source)}.npz", "motion")
    if target.exists() and source.exists() and target.samefile(source):
        raise UserError(f"'{target}' is the input file; give another -o")
    outputs.check_target(target, overwrite=overwrite)
    with terminal.Progress() as progress:
        saved = motion_import.import_recording(source, kind, figure=figure, fps=fps, scale=scale, progress=progress)
        motion.save(saved, target)
        violations = violation.violations(inputs.clip_of(saved), saved)
        _conclude(progress, target, violation.by_name(violations), target)
    _judge(violations, strict)


@app.command("formats", rich_help_panel="Exchange")
def list_formats() -> None:
    """List the formats of export and import."""
    for form in formats.FORMATS:
        uses = " and ".join(word for word, can in (("reads", form.reads), ("writes", form.writes)) if can)
        print(f"{form.name:12} {form.ending:15} {uses:16} {form.description}")


@app.command(rich_help_panel="Recordings")
def clean(
    source: option.Recording,
    output: Annotated[Path | None, option.output("NAME.clean.EXT, if the recording is NAME.EXT")] = None,
    figure: option.Figure = None,
    map_file: option.Map = None,
    kind: option.Format = None,
    fps: option.Fps = None,
    scale: option.Scale = None,
    scene: option.Scene = None,
    speed_limit: option.Speed = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Remove foot skate, penetration and jitter from a recording.
    The result stays close to the recording."""
    place = maps.map_of(map_file)
    recording = clean_command.Source(source, figure, kind, fps, scale, scene, place, False, speed_limit)
    _clean(recording, output, overwrite)


@app.command(rich_help_panel="Recordings")
def retarget(
    source: Annotated[Path, typer.Argument(metavar="RECORDING", help="Recording of a skeleton, e.g. a BVH file")],
    to: Annotated[str, value("MODEL", "Target figure: name of a shipped figure, or MJCF file")],
    output: Annotated[Path | None, option.output("RECORDING.MODEL.npz")] = None,
    map_file: option.Map = None,
    kind: option.Format = None,
    fps: option.Fps = None,
    scale: option.Scale = None,
    scene: option.Scene = None,
    speed_limit: option.Speed = None,
    overwrite: option.Overwrite = False,
    allow_outside: option.Outside = False,
) -> None:
    """Transfer the motion of a skeleton to a figure, and clean it.
    The result respects joint ranges, and its limbs do not penetrate each other."""
    target = output or Path(f"{formats.stem(source)}.{Path(to).stem}.npz")
    place = maps.map_of(map_file)
    recording = clean_command.Source(source, to, kind, fps, scale, scene, place, True, speed_limit)
    _clean(recording, target, overwrite)


@app.command(rich_help_panel="Batch")
def batch(
    clips: option.BatchSources = None,
    output: option.BatchFolder = Path("batch"),
    listed: option.List = None,
    workers: option.BatchWorkers = None,
    cluster: Annotated[str | None, value("tcp://HOST:PORT", "Address of a Dask cluster to run on", "none")] = None,
    to: Annotated[str, value("FORMAT", "Format of the results: npz, or one of `dynsplines formats`")] = "npz",
    fps: option.Rate = None,
    limit_time: Annotated[float, number("SECONDS", "Time limit for solving each clip", 0.1, 10**6)] = 3600.0,
    measure: option.MeasureAll = False,
    retry_failed: Annotated[bool, flag("--retry-failed", "Retry clips that failed in an earlier run")] = False,
    strict: option.Strict = False,
    clean_all: Annotated[bool, flag("--clean", "Clean recordings, as `dynsplines clean` does")] = False,
    onto: Annotated[str | None, value("MODEL", "Retarget recordings to this figure", "none", "--retarget")] = None,
    figure: option.Figure = None,
    map_file: option.Map = None,
    kind: option.Format = None,
    scene: option.Scene = None,
    allow_outside: option.Outside = False,
) -> None:
    """Solve many clips in parallel.
    It uses all cores or a Dask cluster. To resume an interrupted batch, repeat the command."""
    cleaning = option.cleaning_source(
        clean=clean_all, robot=onto, figure=figure, map_file=map_file, kind=kind, scene=scene
    )
    options = batches.BatchOptions(listed, workers, cluster, to, fps, limit_time, measure, retry_failed, cleaning)
    with terminal.Progress() as progress:
        tally = batches.run(clips or [], output, progress, options)
    if tally.failed:
        raise typer.Exit(1)
    _judge(tally.wrong, strict)


def _edit(edit: Any, *arguments: object, output: Path | None, overwrite: bool) -> None:
    """Apply an edit of files, and print the name of the written file."""
    with terminal.Progress() as progress:
        target, violations = edit(*arguments, output, overwrite=overwrite, progress=progress)
        _conclude(progress, target, violations, target)


def _clean(recording: "clean_command.Source", target: Path | None, overwrite: bool) -> None:
    with terminal.Progress() as progress:
        clean_command.run(recording, target, overwrite=overwrite, progress=progress)


def _target(output: Path | None, name: str, kind: str, overwrite: bool = True) -> Path:
    """Return the file to write, with the extension of `name`; raises UserError if it cannot be written."""
    target = output or Path(name)
    if target.suffix != Path(name).suffix:
        raise UserError(f"{target}: a {kind} file's name ends in {Path(name).suffix}")
    outputs.check_target(target, overwrite=overwrite)
    return target


def _conclude(progress: Any, target: Path, violations: "Sequence[violation.Violation]", file: object) -> None:
    """Print the name of the written file and its violations; `file` is the argument of the suggested `report`."""
    for line in (f"wrote {target}", *violation.lines(violations, file)):
        progress.report(line)


def _judge(violations: Sequence[object], strict: bool) -> None:
    """End with code 3 if there are violations and `strict` is set."""
    if strict and violations:
        raise typer.Exit(VIOLATED)
