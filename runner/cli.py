"""The command `dynsplines`. Everything heavy is imported inside the command that needs it."""

from __future__ import annotations

import contextlib
import json
import os
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn, cast

import typer

from .system import stopping

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from .clip.load import Clip
    from .edit.files import Edit
    from .measure.problems import Flaw
    from .motion import Saved
    from .picture.graphics import Graphics
    from .picture.show import Look
    from .system.progress import Progress

UsageError = cast("type[typer.BadParameter]", typer.BadParameter.__mro__[1])  # typer's own, or click's

MOST_IMAGES = 100_000  # an hour of film at 30 a second
WRONG = 3  # the exit code of --strict
OURS = 4  # that of a mistake in the program
DEBUG = "DYNSPLINES_DEBUG"
HOW = "what the same command prints as `dynsplines --debug ...`"
NO_ROOM = (  # the linker's, MuJoCo's, and Python's where it has no memory for the error itself
    "failed to map segment",
    "annot allocate memory",
    "ould not allocate memory",
    "error return without exception set",
)
BEFORE_MUJOCO = ("scipy.sparse", "scipy.linalg", ".clip.table", ".system.progress")

app = typer.Typer(
    help="Sparse keyframes of an articulated figure into smooth motion that keeps its feet out of the floor.",
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)

Source = Annotated[
    str, typer.Argument(metavar="CLIP|MOTION.npz", help="a shipped clip, a .toml or .xml file, or a saved motion")
]
ClipSource = Annotated[str, typer.Argument(metavar="CLIP", help="a shipped clip, or a .toml or .xml file")]
Model = Annotated[str | None, typer.Option("--model", help="a figure, instead of a clip; with --keys")]
Keys = Annotated[str | None, typer.Option("--keys", help=".npz with time (K,) and qpos (K, nq); with --model")]
Output = Annotated[Path | None, typer.Option("-o", "--output", help="the file to write")]
Overwrite = Annotated[bool, typer.Option("--overwrite", help="let -o be the file that is edited")]
OverThere = Annotated[bool, typer.Option("--overwrite", help="let -o be a file that is there")]
Repeat = Annotated[int | None, typer.Option("--repeat", help="play a loop so many times, without a seam")]
Strict = Annotated[bool, typer.Option("--strict", help="exit with code 3 if anything is wrong with the motion")]
Fresh = Annotated[bool, typer.Option("--fresh", help="solve a clip again that was solved before, unchanged")]
SkipRest = Annotated[bool, typer.Option("--skip-rest", help="leave out the T-pose before the motion of a recording")]


def _let_outside(context: typer.Context, yes: bool) -> bool:
    """What --allow-outside does, until the command ends."""
    from .scene.outside import allowed

    context.with_resource(allowed(yes))
    return yes


Outside = Annotated[
    bool,
    typer.Option(
        "--allow-outside", callback=_let_outside, help="let a model read files that lie outside its own folder"
    ),
]
Kind = Annotated[str | None, typer.Option("--from", help="its format, if the ending is ambiguous")]
Fps = Annotated[float | None, typer.Option(help="frames per second, if the file does not specify it")]
Scale = Annotated[float | None, typer.Option(help="the file's unit of length in metres, where it is guessed")]
SceneFile = Annotated[Path | None, typer.Option(help="a TOML file with [scene]: steps and obstacles of it")]
ContactsFile = Annotated[Path | None, typer.Option(help="a TOML file with [[contact]]s, if not those found")]
Within = Annotated[str | None, typer.Option(help="how far hands, feet and pelvis may move, such as 3cm")]
SpeedLimit = Annotated[str | None, typer.Option(help="how fast joints may turn, such as 20rad/s or 1200deg/s")]
MapFile = Annotated[
    Path | None, typer.Option("--map", help="a bone map, TOML, or the name of a map that ships: g1, human")
]
WriteMap = Annotated[bool, typer.Option("--write-map", help="write the bone map that is used to --map")]
AsJson = Annotated[bool, typer.Option("--json", help="print JSON")]


def main() -> None:
    """The command `dynsplines`."""
    run(lambda: app(sys.argv[1:] or ["--help"], prog_name="dynsplines", standalone_mode=False))


def run(command: Callable[[], int | None]) -> NoReturn:
    """End with a command's exit code; bad input and internal errors are reported in one line."""
    from .system import mujoco_warnings
    from .system.terminal import fit
    from .system.threads import keep_to_one

    keep_to_one()
    fit()
    try:
        with mujoco_warnings.reported_to(mujoco_warnings.print_note):
            code = command()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or Python complains while it shuts down
        sys.exit(1)
    except SystemExit:
        raise
    except BaseException as error:
        code, line = _ending(error)
        if code == OURS and os.environ.get(DEBUG):
            raise
        _end(code, line)
    if code == 130:  # typer's own answer to Ctrl-C
        _end(stopping.code(130), "stopped")
    sys.exit(stopping.code(code or 0))


def _ending(error: BaseException) -> tuple[int, str]:
    """The exit code for an error, and its message."""
    from .errors import UserError, one_line

    match error:
        case UserError():
            return 2, one_line(error)
        case UsageError():
            command = error.ctx.command_path if error.ctx else "dynsplines"
            return 2, one_line(f"{error.format_message()} (see `{command} --help`)")
        case FileNotFoundError(filename=None) if _is_nowhere():
            return 2, "the folder that the command was started in is gone"
        case OSError():
            return 2, one_line(f"'{error.filename}': {error.strerror}" if error.filename else error.strerror or error)
        case MemoryError():
            return 2, "not enough memory for this"
    if isinstance(error, typer.Abort) or _interrupted(error):
        return stopping.code(130), "stopped"
    if any(words in str(error) for words in NO_ROOM):
        return 2, "not enough memory for this, or to load what it needs"
    if isinstance(error, RuntimeError) and "can't start new thread" in str(error):
        return 2, "the system allows no more threads, or no more memory"
    return OURS, one_line(f"a mistake of dynsplines, not of yours: {_place(error)}; please report it, with {HOW}")


def _place(error: BaseException) -> str:
    """What went wrong, and where in the program."""
    import traceback

    found = traceback.extract_tb(error.__traceback__)
    where = f" ({Path(found[-1].filename).name}:{found[-1].lineno})" if found else ""
    return f"{type(error).__name__}: {error}{where}"


def _is_nowhere() -> bool:
    """Whether the folder that the command was started in has been removed."""
    try:
        Path.cwd()
    except FileNotFoundError:
        return True
    return False


def _interrupted(error: BaseException | None) -> bool:
    """Whether Ctrl-C is behind it: pressed while an extension module is imported it comes out as an ImportError."""
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__cause__ or error.__context__
    return error is not None


def _end(code: int, line: str) -> NoReturn:
    print(f"dynsplines: {line}", file=sys.stderr)
    sys.exit(code)


def _tell_version(asked: bool) -> None:
    if asked:
        from importlib.metadata import version  # only here: it takes a moment

        from .solver import compiled

        by = "the compiled kernel" if compiled.kernel is not None else "NumPy alone (no compiled kernel)"
        print(f"dynsplines {version('dynamic-splines')}, MuJoCo {version('mujoco')}, solving with {by}")
        raise typer.Exit


@app.callback()
def _whatever(
    debug: Annotated[bool, typer.Option("--debug", help="show where in the program a mistake of its own is")] = False,
    version: Annotated[
        bool, typer.Option("--version", is_eager=True, callback=_tell_version, help="print the version")
    ] = False,
) -> None:
    if debug:
        os.environ[DEBUG] = "1"


@app.command()
def render(
    source: Source = "",
    output: Output = None,
    only: Annotated[str, typer.Option(help="before, after or keys (the keyframes, without solving)")] = "",
    ghosts: Annotated[bool, typer.Option("--ghosts", help="the paper's figure 6: keyframes darkest")] = False,
    size: Annotated[str, typer.Option(help="of the whole picture, pixels")] = "1280x720",
    fps: Annotated[float | None, typer.Option(help="images a second [default: the clip's, 30]")] = None,
    camera: Annotated[
        str, typer.Option(help="side, left, front, three_quarter, back, or a camera of the model")
    ] = "side",
    slow: Annotated[float, typer.Option(help="how many times slower than life")] = 1.0,
    at: Annotated[float | None, typer.Option(help="only the image at this time, seconds")] = None,
    workers: Annotated[
        int | None, typer.Option(help="processes that draw [default: one a core for rays, else 1]")
    ] = None,
    repeat: Repeat = None,
    strict: Strict = False,
    fresh: Fresh = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Solve a clip (or take a saved motion) and render before | after; .mp4 .webm .gif .png by the ending."""
    from .errors import UserError

    width, height = _size(size)
    if only not in ("", "before", "after", "keys"):
        raise UserError(f"--only {only}: not one of before, after, keys")
    if fps is not None and not 0.01 <= fps <= 1000:
        raise UserError(f"--fps {fps:g}: give a number of images a second, 0.01 to 1000")
    if not 0.01 <= slow <= 1000:
        raise UserError(f"--slow {slow:g}: give how many times slower, 0.01 to 1000, such as 4")
    from .system.workers import MOST_WORKERS

    if workers is not None and not 1 <= workers <= MOST_WORKERS:
        raise UserError(f"--workers {workers}: give a number of processes, 1 to {MOST_WORKERS}")
    name = _name(source, model, keys)
    target = output or Path(f"{name}.png" if ghosts or at is not None else f"{name}.mp4")
    _film_target(target, width, height, halves=not only and not (ghosts and target.suffix.lower() == ".png"))
    graphics = _graphics()
    from .picture.rendering import draw
    from .picture.show import Look
    from .system.progress import Progress

    with Progress() as progress:
        unmet: list[str] | None = [] if only == "keys" else None
        found = _found(source, model, keys, unmet=unmet)
        for line in unmet or ():
            progress.say(f"note: {line}; drawn as near as it comes")
        _check_repeat(found, repeat)
        _check_camera(found, camera)
        _check_at(found, at, repeat)
        look = Look(width, height, fps or found.fps, only, ghosts, camera, slow, at)
        _check_length(found, look, repeat)
        progress.say(graphics.line)
        result = _result(found, progress, repeat, solve=only not in ("keys", "before"), fresh=fresh)
        draw(result.saved, look, graphics, target, workers, progress)
        _tell(progress, target, result.problems, source)
    _judge(result.problems, strict)


@app.command()
def solve(
    source: ClipSource = "",
    output: Output = None,
    fps: Annotated[float | None, typer.Option(help="samples a second in the file [default: the clip's, 30]")] = None,
    repeat: Repeat = None,
    strict: Strict = False,
    as_json: AsJson = False,
    fresh: Fresh = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Solve a clip and save the motion as arrays (.npz)."""
    _without_graphics()
    from . import motion
    from .errors import UserError
    from .system.output import check_target
    from .system.progress import Progress

    target = output or Path(f"{_name(source, model, keys)}.npz")
    if target.suffix != ".npz":
        raise UserError(f"{target}: a motion file's name ends in .npz")
    if fps is not None and not 0.01 <= fps <= 100_000:
        raise UserError(f"--fps {fps:g}: give a number of samples a second, 0.01 to 100000")
    check_target(target)
    with Progress() as progress:
        found = _found(source, model, keys, fps)
        if isinstance(found, motion.Saved):
            raise UserError(f"{source}: a motion is solved already; report, plot and render take it")
        _check_repeat(found, repeat)
        motion.sample_count((found.keys[-1].time - found.keys[0].time) * (repeat or 1), found.fps)
        result = _result(found, progress, repeat, fresh=fresh)
        motion.save(result.saved, target)
        _tell(progress, target, result.problems, target)
    if as_json:
        from .measure.summary import summary

        print(json.dumps(summary(result.saved, result.problems), indent=2))
    _judge(result.problems, strict)


@app.command()
def report(
    source: Source = "",
    strict: Strict = False,
    as_json: AsJson = False,
    fresh: Fresh = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Measure before and after on a 1 kHz grid: penetration, knees, skate, torques, what is left to gain."""
    _without_graphics()
    from rich.console import Console

    from .measure.report import tables
    from .system.progress import Progress

    _name(source, model, keys)
    with Progress() as progress:
        measured = _measured(_found(source, model, keys), progress, fresh=fresh).report
    if as_json:
        print(json.dumps(_plain(measured), indent=2))
    else:
        with _whole(source):
            shown = tables(measured)
        Console(highlight=False).print(shown, markup=False)
    _judge(measured["problems"], strict)


@app.command()
def plot(
    source: Source = "",
    output: Output = None,
    fresh: Fresh = False,
    model: Model = None,
    keys: Keys = None,
    allow_outside: Outside = False,
) -> None:
    """Charts: foot height, unit magnitude, Euler-Lagrange deviation, penalties per evaluation (.png .svg .pdf)."""
    _without_graphics()
    import numpy as np

    from .measure import chart
    from .system.output import check_target
    from .system.progress import Progress

    target = output or Path(f"{_name(source, model, keys)}.png")
    chart.check_target(target)
    check_target(target)
    with Progress() as progress:
        saved = _measured(_found(source, model, keys), progress, fresh=fresh)
        with _whole(source):
            chart.draw(saved.name, saved.report, saved.trace, np.array([key.time for key in saved.keys]), target)
        progress.say(f"wrote {target}")


@app.command(name="new")
def new_clip(
    model: Annotated[str, typer.Argument(metavar="MODEL", help="an MJCF file, or a shipped figure")],
    output: Output = None,
    overwrite: OverThere = False,
    allow_outside: Outside = False,
) -> None:
    """Write a clip to begin with, for any model: its keyframes, or a pose and a move; comments name all its parts."""
    _without_graphics()
    from .clip.starter import starter
    from .errors import UserError
    from .system.output import Replacement, check_new, check_target

    target = output or Path(f"{Path(model).stem}.toml")
    if target.suffix != ".toml":
        raise UserError(f"{target}: a clip file's name ends in .toml")
    check_target(target)
    check_new(target, overwrite=overwrite)
    notes: list[str] = []
    text = starter(model, target, notes.append)
    with Replacement(target) as temporary:
        temporary.write_text(text, encoding="utf-8")
    for note in notes:
        print(f"note: {note}", file=sys.stderr)
    print(f"wrote {target}; see it: dynsplines render {target}{' --allow-outside' if allow_outside else ''}")


@app.command()
def mirror(
    source: Source,
    output: Output = None,
    overwrite: Overwrite = False,
    fresh: Fresh = False,
    allow_outside: Outside = False,
) -> None:
    """Exchange left and right of a motion (.npz) or a clip (.toml), in the x-z plane."""
    _without_graphics()
    from .edit import files as edit_files

    _edited([source], edit_files.mirrored(), output, overwrite=overwrite, fresh=fresh)


@app.command()
def retime(
    source: Source,
    output: Output = None,
    speed: Annotated[float | None, typer.Option(help="how many times as fast")] = None,
    duration: Annotated[float | None, typer.Option(help="how long it shall last, seconds")] = None,
    overwrite: Overwrite = False,
    fresh: Fresh = False,
    allow_outside: Outside = False,
) -> None:
    """Play a motion (.npz) or a clip (.toml) faster or slower."""
    _without_graphics()
    from .edit import files as edit_files

    _edited([source], edit_files.retimed(speed, duration), output, overwrite=overwrite, fresh=fresh)


@app.command()
def trim(
    source: Source,
    output: Output = None,
    first: Annotated[float | None, typer.Option("--from", help="seconds of the clip")] = None,
    last: Annotated[float | None, typer.Option("--to", help="seconds of the clip")] = None,
    overwrite: Overwrite = False,
    fresh: Fresh = False,
    allow_outside: Outside = False,
) -> None:
    """Cut a motion to an interval; inside it stays the same."""
    _without_graphics()
    from .edit import files as edit_files

    _edited([source], edit_files.trimmed(first, last), output, overwrite=overwrite, fresh=fresh)


@app.command()
def join(
    first: Source,
    second: Source,
    output: Output = None,
    transition: Annotated[
        float, typer.Option(help="seconds from the end of the first to the start of the second")
    ] = 0.4,
    overwrite: Overwrite = False,
    fresh: Fresh = False,
    allow_outside: Outside = False,
) -> None:
    """Append a second motion to a first: moved to its end, with a transition in between."""
    _without_graphics()
    from .edit import files as edit_files

    _edited([first, second], edit_files.joined(transition), output, overwrite=overwrite, fresh=fresh)


@app.command()
def thin(
    source: Annotated[
        str, typer.Argument(metavar="MOTION", help="a motion (.npz), a recording of another program, or a clip")
    ],
    max_error: Annotated[str, typer.Option(help="how far any body or site may be off, such as 2cm")] = "2cm",
    max_angle: Annotated[float, typer.Option(help="how far any body may be turned off, degrees")] = 5.0,
    output: Output = None,
    solve: Annotated[
        bool, typer.Option("--solve", help="let the solved motion keep the bound, and not only the spline")
    ] = False,
    exact: Annotated[
        bool, typer.Option("--exact", help="write settings that leave the spline as it is, also after an edit")
    ] = False,
    skip_rest: SkipRest = False,
    figure: Annotated[str | None, typer.Option(help="of a recording: a shipped figure or MJCF")] = None,
    kind: Annotated[
        str | None, typer.Option("--from", help="the recording's format, if its ending is not enough")
    ] = None,
    fps: Annotated[float | None, typer.Option(help="the recording's frames per second, if missing in it")] = None,
    overwrite: OverThere = False,
    fresh: Fresh = False,
    allow_outside: Outside = False,
) -> None:
    """The fewest keyframes that keep a motion within a bound, as a clip (.toml) or a motion (.npz)."""
    _without_graphics()
    from .edit import thin_files
    from .system.progress import Progress

    recording = thin_files.ToThin(source, figure, kind, fps, fresh, skip_rest)
    bound = thin_files.bound(max_error, max_angle)
    with Progress() as progress:
        thin_files.run(recording, bound, output, solve=solve, exact=exact, overwrite=overwrite, progress=progress)


@app.command()
def export(
    source: Source,
    to: Annotated[
        str | None, typer.Option("--to", help="the format, if -o's ending is not enough; see `dynsplines formats`")
    ] = None,
    output: Output = None,
    fps: Annotated[float | None, typer.Option(help="samples a second [default: the motion's]")] = None,
    columns: Annotated[
        str,
        typer.Option("--with", help="of csv: more columns, of velocities,torques,wrench,ground (with commas), or all"),
    ] = "",
    simulate: Annotated[
        bool,
        typer.Option(
            "--simulate",
            help="of mjcf: a scene to simulate with actuators and their targets; also chosen by -o X.simulate.xml",
        ),
    ] = False,
    repeat: Repeat = None,
    overwrite: OverThere = False,
    fresh: Fresh = False,
    allow_outside: Outside = False,
) -> None:
    """Write a motion in the format of another program."""
    _without_graphics()
    from .errors import UserError
    from .exchange import formats, quantities
    from .exchange.take import Wishes
    from .system.output import check_new, check_target
    from .system.progress import Progress

    form = formats.chosen(to, output)
    wishes = Wishes(simulate, quantities.named(columns))
    formats.check_wishes(form, wishes)
    if fps is not None and not 0.01 <= fps <= 100_000:
        raise UserError(f"--fps {fps:g}: give a number of samples a second, 0.01 to 100000")
    target = output or formats.target_of(_exported_name(source), form, wishes)
    check_target(target)
    check_new(target, overwrite=overwrite)
    with Progress() as progress:
        found = _found(source, None, None)
        _check_repeat(found, repeat)
        result = _result(found, progress, repeat, fresh=fresh)
        formats.export(result.saved, form.name, target, fps=fps, wishes=wishes, overwrite=overwrite, tell=progress.say)
        _tell(progress, target, result.problems, source)


@app.command(name="import")
def import_motion(
    source: Annotated[Path, typer.Argument(metavar="FILE", help="a recorded motion of another program")],
    figure: Annotated[str | None, typer.Option(help="the figure it is for: a shipped one or MJCF")] = None,
    kind: Kind = None,
    fps: Fps = None,
    scale: Scale = None,
    skip_rest: SkipRest = False,
    output: Output = None,
    strict: Strict = False,
    overwrite: OverThere = False,
    allow_outside: Outside = False,
) -> None:
    """Read a recorded motion and report its violations; every sample becomes a keyframe, nothing is solved."""
    _without_graphics()
    from . import motion
    from .edit import lead_in
    from .errors import UserError
    from .exchange.formats import stem
    from .exchange.imported import imported
    from .measure import problems
    from .system.output import check_new, check_target
    from .system.progress import Progress

    if fps is not None and not 0.01 <= fps <= 1000:
        raise UserError(f"--fps {fps:g}: give a number of images a second, 0.01 to 1000")
    if scale is not None and not 1e-6 <= scale <= 1e6:
        raise UserError(f"--scale {scale:g}: give the file's unit in metres, 0.01 for centimetres")
    target = output or Path(f"{stem(source)}.npz")
    if target.suffix != ".npz":
        raise UserError(f"{target}: a motion file's name ends in .npz")
    check_target(target)
    if target.exists() and source.exists() and target.samefile(source):
        raise UserError(f"'{target}' is what is read; give another -o")
    check_new(target, overwrite=overwrite)
    with Progress() as progress:
        found = imported(source, kind, figure=figure, fps=fps, scale=scale, progress=progress)
        saved = lead_in.told(found, progress, skip=skip_rest)
        motion.save(saved, target)
        violations = problems.of_motion(saved)
        _tell(progress, target, problems.by_name(violations), target)
    _judge(violations, strict)


def _bone_map(path: Path | None, writes: bool) -> Path | None:
    """Return the file of --map; raises UserError for --write-map without one."""
    from .errors import UserError
    from .exchange.skeleton.maps import map_of

    if writes and path is None:
        raise UserError("--write-map: name the file, --map FILE")
    return path if writes else map_of(path)


@app.command()
def clean(
    source: Annotated[Path, typer.Argument(metavar="RECORDING", help="a motion, or a file that `import` reads")],
    output: Output = None,
    figure: Annotated[str | None, typer.Option(help="the figure it is for: a shipped one or MJCF")] = None,
    map_file: MapFile = None,
    write_map: WriteMap = False,
    kind: Kind = None,
    fps: Fps = None,
    scale: Scale = None,
    scene: SceneFile = None,
    contacts: ContactsFile = None,
    within: Within = None,
    speed_limit: SpeedLimit = None,
    overwrite: OverThere = False,
    allow_outside: Outside = False,
) -> None:
    """A recording made physical: feet stay where they stand, nothing sinks, jumps or floats; the motion is kept."""
    _without_graphics()
    from .clean import running
    from .system.progress import Progress
    from .system.quantity import length, speed

    map_file = _bone_map(map_file, write_map)
    bound = None if within is None else length(within, "--within")
    fastest = None if speed_limit is None else speed(speed_limit, "--speed-limit")
    with Progress() as progress:
        found = running.Source(source, figure, kind, fps, scale, scene, contacts, map_file, write_map, speed=fastest)
        running.run(found, output, within=bound, overwrite=overwrite, progress=progress)


@app.command()
def retarget(
    source: Annotated[Path, typer.Argument(metavar="RECORDING", help="a skeleton's motion: BVH")],
    to: Annotated[str, typer.Option("--to", help="the figure or robot: a shipped one or MJCF")],
    output: Output = None,
    map_file: MapFile = None,
    write_map: WriteMap = False,
    kind: Kind = None,
    fps: Fps = None,
    scale: Scale = None,
    scene: SceneFile = None,
    contacts: ContactsFile = None,
    within: Within = None,
    speed_limit: SpeedLimit = None,
    overwrite: OverThere = False,
    allow_outside: Outside = False,
) -> None:
    """A skeleton's motion on another figure, cleaned there: its stances, its ranges, its limbs out of each other."""
    _without_graphics()
    from .clean import running
    from .exchange.formats import stem
    from .system.progress import Progress
    from .system.quantity import length, speed

    map_file = _bone_map(map_file, write_map)
    bound = None if within is None else length(within, "--within")
    fastest = None if speed_limit is None else speed(speed_limit, "--speed-limit")
    with Progress() as progress:
        found = running.Source(source, to, kind, fps, scale, scene, contacts, map_file, write_map, True, fastest)
        target = output or Path(f"{stem(source)}.{Path(to).stem}.npz")
        running.run(found, target, within=bound, overwrite=overwrite, progress=progress)


@app.command(name="formats")
def list_formats() -> None:
    """The formats of other programs that export writes and import reads."""
    from .exchange.formats import FORMATS

    for each in FORMATS:
        ways = " and ".join(word for word, yes in (("reads", each.reads), ("writes", each.writes)) if yes)
        print(f"{each.name:12} {each.ending:15} {ways:16} {each.says}")


@app.command()
def batch(
    sources: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="CLIPS...",
            help="shipped clips, .toml or .xml files, folders (every .toml below), patterns; or recordings",
        ),
    ] = None,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="DIR", help="the folder of results and manifest")
    ] = Path("batch"),
    listed: Annotated[
        str | None, typer.Option("--list", metavar="FILE", help="more clips, one a line; - is stdin")
    ] = None,
    workers: Annotated[int | None, typer.Option(help="processes on this machine [default: one a core]")] = None,
    scheduler: Annotated[str | None, typer.Option(help="tcp://host:8786, a Dask cluster to use instead")] = None,
    to: Annotated[str, typer.Option("--to", help="npz, or one of `dynsplines formats`")] = "npz",
    fps: Annotated[float | None, typer.Option(help="samples a second [default: the clip's]")] = None,
    limit_time: Annotated[float, typer.Option(help="seconds that a clip may take")] = 3600.0,
    limit_memory: Annotated[
        float | None, typer.Option(help="MB that a clip's process may use [default: its worker's share]")
    ] = None,
    measure: Annotated[
        bool,
        typer.Option(
            "--report/--no-report", help="measure every motion at 1 kHz, too, which takes longer than to solve it"
        ),
    ] = False,
    retry_failed: Annotated[bool, typer.Option("--retry-failed", help="also what failed and has not changed")] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="exit with code 3 if anything is wrong with a motion")
    ] = False,
    clean_all: Annotated[bool, typer.Option("--clean", help="they are recordings: clean each")] = False,
    onto: Annotated[
        str | None, typer.Option("--retarget", metavar="MODEL", help="they are recordings: bring each on to a figure")
    ] = None,
    figure: Annotated[str | None, typer.Option(help="with --clean: the figure they are for")] = None,
    map_file: Annotated[Path | None, typer.Option("--map", help="with --retarget: the bone map")] = None,
    kind: Kind = None,
    scene: SceneFile = None,
    within: Within = None,
    allow_outside: Outside = False,
) -> None:
    """Solve many clips, on every core or on a Dask cluster; repeating the command resumes an interrupted run."""
    _without_graphics()
    from . import batch as batches
    from .batch import recordings
    from .system.progress import Progress

    cleaning = recordings.asked(
        clean=clean_all, onto=onto, figure=figure, map_file=map_file, kind=kind, scene=scene, within=within
    )

    with Progress() as progress:
        tally = batches.run(
            sources or [],
            output,
            progress,
            listed=listed,
            workers=workers,
            scheduler=scheduler,
            to=to,
            fps=fps,
            seconds=limit_time,
            megabytes=limit_memory,
            report=measure,
            retry_failed=retry_failed,
            cleaning=cleaning,
        )
        if cleaning is not None:
            recordings.tell(tally, progress)
        for line in [*([] if cleaning is not None else tally.problems), *tally.failures()]:
            progress.say(line)
        progress.say(f"{output}: {tally.line}")
    if tally.failed:
        raise typer.Exit(1)
    _judge(tally.wrong, strict)


@app.command()
def studio(
    source: Annotated[
        str, typer.Argument(metavar="CLIP|MOTION|RECORDING|MODEL.xml", help="what to open; see `dynsplines clips`")
    ] = "run_and_step",
    figure: Annotated[str | None, typer.Option(help="of a recording: a shipped figure or MJCF")] = None,
    port: Annotated[int, typer.Option(help="0 takes a free one", min=0, max=65535)] = 0,
    host: Annotated[
        str, typer.Option(help="another address than this machine's own needs --allow-remote")
    ] = "127.0.0.1",
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="open the page, or only print where")] = True,
    allow_remote: Annotated[
        bool, typer.Option("--allow-remote", help="let other machines edit the clip and write files next to it")
    ] = False,
    allow_outside: Outside = False,
) -> None:
    """See, edit and optimise a motion live on a page in the browser."""
    _without_graphics()
    from .errors import UserError

    for name in ("starlette", "uvicorn", "websockets", "tomlkit"):
        if not _is_there(name):
            raise UserError(f"the studio needs {name}: pip install 'dynamic-splines[studio]'")
    from .studio import sources, start

    start.check_host(host, allow_remote=allow_remote)
    document = sources.opened(source, figure=figure)
    start.run(
        document,
        host=host,
        port=port,
        browser=browser,
        allow_remote=allow_remote,
        say=lambda line: print(line, flush=True),
    )


@app.command()
def clips(
    shown: Annotated[
        str | None, typer.Option("--show", metavar="NAME", help="print one's text, to change: > my.toml")
    ] = None,
) -> None:
    """The clips that ship."""
    from dynsplines import models

    if shown is not None:
        from .errors import UserError, unknown

        if shown not in models.clips():
            raise UserError(f"--show: {unknown('clip', shown, models.clips())}")
        print(models.clip_text(shown), end="")
        return
    for name, line in models.clips().items():
        print(f"{name:16} {line}")


@app.command(name="penalties")
def list_penalties(as_json: AsJson = False) -> None:
    """The soft constraints of a clip's [[penalty]] tables: default weights, what they keep small, options."""
    from .clip.kinds import KINDS

    if as_json:
        print(json.dumps([kind.described() for kind in KINDS.values()], indent=2))
        return
    for kind in KINDS.values():
        if kind.parts[0].name:
            print(kind.name)
        for part in kind.parts:
            on = f"; on with {part.option}" if part.option else "" if kind.is_default else "; on where listed"
            print(f"{f'  {part.name}' if part.name else kind.name:13} {part.weight:4g}  {part.keeps_small}{on}")
        for name, values in kind.choices().items():
            print(f"{'':20}{name} ({values})")


@app.command(name="models")
def list_models() -> None:
    """The figures that ship."""
    from dynsplines import models

    for name, line in models.figures().items():
        print(f"{name:16} {line}")


def _edited(sources: list[str], edit: Edit, output: Path | None, *, overwrite: bool, fresh: bool) -> None:
    """An edit of files, told as it goes."""
    from .edit.files import run
    from .system.progress import Progress

    with Progress() as progress:
        target, found = run(sources, edit, output, overwrite=overwrite, fresh=fresh, progress=progress)
        _tell(progress, target, found, target)


def _name(source: str, model: str | None, keys: str | None) -> str:
    """What a command's output is called after."""
    from .errors import UserError

    if not source and keys is None and model is None:
        raise UserError("name a clip (see `dynsplines clips`), a file, or --model with --keys")
    return Path(source if keys is None else keys).stem or "motion"


def _exported_name(source: str) -> str:
    """What an exported file is called after: what it came from."""
    from .exchange.formats import stem

    _name(source, None, None)
    return stem(Path(source))


@contextlib.contextmanager
def _whole(source: str) -> Iterator[None]:
    """A motion file from elsewhere can hold a report that is none."""
    from .errors import UserError

    try:
        yield
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        raise UserError(f"{source}: its report is not complete: {type(error).__name__} {error}") from None


def _size(text: str) -> tuple[int, int]:
    from .errors import UserError

    parts = text.lower().split("x")
    if len(parts) != 2 or not all(part.isascii() and part.isdigit() and len(part) < 10 for part in parts):
        raise UserError(f"--size {text}: give WIDTHxHEIGHT in pixels, such as 1280x720")
    width, height = int(parts[0]), int(parts[1])
    if not (16 <= width <= 3840 and 16 <= height <= 2160):
        raise UserError(f"--size {text}: from 16x16 to 3840x2160")
    return width, height


def _film_target(target: Path, width: int, height: int, *, halves: bool) -> None:
    from .errors import UserError
    from .picture.film import FilmError, check_target

    try:
        check_target(target, width, height)
    except FilmError as error:
        raise UserError(str(error)) from None
    if halves and width % 2:
        raise UserError(f"--size {width}x{height}: two halves side by side need an even width")


def _is_there(package: str) -> bool:
    """Whether it is installed; it is not imported."""
    from importlib.util import find_spec

    try:
        return find_spec(package) is not None
    except ValueError:  # of one that was taken away in this process
        return False


def _without_graphics() -> None:
    from .picture.graphics import do_without

    do_without()


def _graphics() -> Graphics:
    """The renderer to use; what does not need mujoco is imported while another process tries it."""
    from concurrent.futures import ThreadPoolExecutor
    from importlib import import_module

    from .errors import UserError
    from .picture.graphics import GraphicsError, choose

    with ThreadPoolExecutor(1) as aside:
        found = aside.submit(choose)
        for name in BEFORE_MUJOCO:
            import_module(name, __package__)
        try:
            return found.result()
        except GraphicsError as error:
            raise UserError(str(error)) from None


def _found(
    source: str, model: str | None, keys: str | None, fps: float | None = None, unmet: list[str] | None = None
) -> Clip | Saved:
    """What a command is about: a saved motion, or a clip to solve; `unmet` as for `clip.load`."""
    from . import motion
    from .clip import load as clip

    if motion.is_motion(source) and keys is None and model is None:
        return clip.load_motion(Path(source))
    return clip.load(source, model=model, keys=keys, fps=fps, unmet=unmet)


@dataclass(frozen=True)
class _Result:
    """A motion, and what is wrong with it."""

    saved: Saved
    problems: tuple[Flaw, ...]


def _result(
    found: Clip | Saved, progress: Progress, repeat: int | None = None, *, solve: bool = True, fresh: bool = False
) -> _Result:
    """A saved motion as it is, or a clip solved, played so many times; nothing is wrong with what is not solved.

    fresh  a clip is solved now, and not as it may have been before
    """
    from . import kept, motion, work
    from .measure import problems

    if not solve:
        saved = found if isinstance(found, motion.Saved) else work.unsolved(found).saved(progress, with_report=False)
        return _Result(_repeated(saved, repeat), ())
    if isinstance(found, motion.Saved):
        saved = _repeated(found, repeat)
        return _Result(saved, () if problems.is_recording(saved) else problems.of_motion(saved))
    solved = kept.solved(found, progress, fresh=fresh)
    saved = solved.saved(progress, with_report=False)
    if repeat is None:
        return _Result(saved, solved.problems)
    saved = _repeated(saved, repeat)
    return _Result(saved, problems.of_motion(saved))


def _measured(found: Clip | Saved, progress: Progress, *, fresh: bool) -> Saved:
    """A motion with its report, made now unless its file has one; `fresh` as for `_result`."""
    from . import kept, motion
    from .edit.edits import measured
    from .measure import problems

    if not isinstance(found, motion.Saved):
        return kept.solved(found, progress, fresh=fresh).saved(progress)
    if not found.report:
        return measured(found, progress, "not searched: imported")
    if "problems" in found.report:
        return found
    return replace(found, report={"problems": problems.plain(problems.of_motion(found)), **found.report})


def _tell(progress: Progress, target: Path, found: Sequence[Flaw], file: object) -> None:
    """What was written, and what is wrong with it; `file` is what a report of all of it takes."""
    from .measure.problems import lines

    progress.say(f"wrote {target}")
    for line in lines(found, file):
        progress.say(line)


def _judge(found: Sequence[object], strict: bool) -> None:
    """End with code 3 if there are violations and `strict` is set."""
    if strict and found:
        raise typer.Exit(WRONG)


def _check_repeat(found: Clip | Saved, repeat: int | None) -> None:
    """Raises UserError unless what is to be repeated is a loop, and not for hours."""
    from . import motion
    from .clip import load as clip
    from .errors import UserError

    ends = found.timeline.ends if isinstance(found, motion.Saved) else found.ends
    period = found.keys[-1].time - found.keys[0].time
    if repeat is None:
        return
    if ends != "periodic":
        raise UserError(f"--repeat: '{found.name}' is no loop; its ends are '{ends}', not 'periodic'")
    if repeat < 1 or repeat * period > clip.LONGEST:
        raise UserError(f"--repeat {repeat}: give a number of periods from 1 on that last {clip.LONGEST:g} s at most")


def _repeated(saved: Saved, repeat: int | None) -> Saved:
    from .edit.edits import repeated

    if repeat is None:
        return saved
    words = f"one period was solved and is played {repeat} times"
    return replace(repeated(saved, repeat), search=saved.search | {"stopped because": words})


def _check_camera(found: Clip | Saved, camera: str) -> None:
    """Raises UserError for a camera that is not there, before anything long begins."""
    from .errors import UserError, unknown
    from .picture.camera import ANGLES

    model = found.figure.model
    known = [*ANGLES, *(name for i in range(model.ncam) if (name := model.camera(i).name))]
    if camera not in known:
        raise UserError(f"--camera: {unknown('camera', camera, known)}")


def _span(found: Clip | Saved, repeat: int | None) -> tuple[float, float]:
    """First and last time of what is shown [s]."""
    first, last = found.keys[0].time, found.keys[-1].time
    return first, first + (last - first) * (repeat or 1)


def _check_at(found: Clip | Saved, at: float | None, repeat: int | None) -> None:
    """Raises UserError for a time outside the clip."""
    from .errors import UserError

    first, last = _span(found, repeat)
    if at is not None and not first <= at <= last:
        raise UserError(f"--at {at:g}: the clip goes from {first:g} to {last:g} s")


def _check_length(found: Clip | Saved, look: Look, repeat: int | None) -> None:
    """Raises UserError for too many images, or one at a time that the clip does not have."""
    from .errors import UserError

    first, last = _span(found, repeat)
    if look.at is not None and not first <= look.at <= last:
        raise UserError(f"--at {look.at:g}: the clip runs from {first:g} to {last:g} s")
    count = (last - first) * look.fps * look.slow
    if count > MOST_IMAGES:
        raise UserError(f"{count:.0f} images; over {MOST_IMAGES}: lower --fps or --slow")


def _plain(report: dict) -> dict:
    """The report without the charts' long curves."""
    return {key: value for key, value in report.items() if key != "curves"}
