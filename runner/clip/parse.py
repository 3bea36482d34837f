"""First stage of loading: the text of a clip becomes checked tables, before its figure is read."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import TypeVar

import numpy as np
from pydantic import ValidationError

from dynsplines import models
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.refine.subdivision import CRITERIA, FEW
from dynsplines.solver.search.descent import check_method
from dynsplines.solver.tolerances import ROUNDING

from ..errors import UserError, import_first, unknown
from ..scene import file_access
from ..scene.file_access import is_there, lies_in
from .kinds import KINDS, Kind, Options
from .table import ClipTable, PenaltyTable, SolveTable, Table
from .table_errors import describe, describe_toml
from .tracking.problem import LONGEST_PANEL, POINTS

Tables = TypeVar("Tables", bound=Table)


TOLERANCE = 1e-3  # [1] default progress relative to E at which a search ends
FRAME_SECONDS = 0.1  # [s] of a clip per variable frame, the minimum of the default budget
SHORTEST = 0.001  # [s] minimum distance of neighbouring keyframes
UNEVEN = 10_000  # [1] maximum ratio of adjacent distances between keyframes; the spline overshoots in proportion
LONGEST = 600.0  # [s] maximum duration

EMPTY = "the clip is empty; it needs a figure and two [[keyframe]] tables"


@dataclass(frozen=True, eq=False)
class Parsed:
    """A clip's text and its tables, validated as far as possible without its figure.

    Attributes:
        text: The TOML text; empty for keyframes of an MJCF file or of arrays.
        where: The label of the clip in errors.
        options: The options of the listed kinds of soft constraint.
    """

    name: str
    text: str
    where: str
    table: ClipTable
    options: Mapping[str, Options]
    settings: Settings
    folder: Path | None = None

    @property
    def labels(self) -> list[str]:
        """The label of every keyframe in errors, without that of the clip."""
        return [keyframe_label(i, row.time) for i, row in enumerate(self.table.keyframe, start=1)]

    @classmethod
    def of(cls, text: str, name: str, where: str, folder: Path | None = None) -> Parsed:
        """Return a text with its tables, also of a saved motion. Without a text the tables are empty.

        Raises:
            UserError: For a text that does not fit the tables.
        """
        table = table_of(text, where) if text else ClipTable(figure="")
        settings = settings_of(table.solve, [row.time for row in table.keyframe], where)
        return cls(name, text, where, table, options_of(table.penalty, where), settings, folder)

    def with_solve(self, solve: SolveTable, times: Sequence[float]) -> Parsed:
        """Return the clip with another [solve] table, for keyframes at times (K,) [s]."""
        table = self.table.model_copy(update={"solve": solve})
        return replace(self, table=table, settings=settings_of(solve, times, self.where))

    def problem(self, figure: Figure, keys: Sequence[Frame]) -> Problem:
        """Return the problem of keyframes without soft constraints."""
        solve = self.table.solve
        turn = None if solve.turn is None else float(np.radians(solve.turn))
        return Problem(figure, tuple(keys), (), self.settings, solve.ends, None, solve.travel, turn)


def options_of(entries: Sequence[PenaltyTable], where: str) -> dict[str, Options]:
    """Return the options of every listed kind.

    Raises:
        UserError: For unknown kinds, parts and options, wrong values, and kinds that are listed twice.
    """
    numbers: dict[str, int] = {}
    options: dict[str, Options] = {}
    listed = [(entry.kind, entry.model_extra or {}) for entry in entries]
    raw = {"penalty": [{"kind": name, **values} for name, values in listed]}
    for i, (name, values) in enumerate(listed, 1):
        here = f"{where}: penalty {i}"
        if name not in KINDS:
            raise UserError(f"{here}: {unknown('penalty', name, KINDS)}")
        if name in numbers:
            raise UserError(f"{here}: kind '{name}' is given already by penalty {numbers[name]}")
        kind = KINDS[name]
        for option in sorted(values.keys() - {"weight", *kind.options}):
            raise UserError(f"{here}: {_unknown_option(kind, option)}")
        try:
            options[name] = Options.model_validate(values)
        except ValidationError as error:
            raise UserError(f"{where}: {describe(error, raw, Options, ('penalty', i - 1))}") from None
        _check_weight(kind, options[name], here)
        numbers[name] = i
    return options


def _unknown_option(kind: Kind, option: str) -> str:
    takes = ["weight", *sorted(kind.options)]
    if option in Options.model_fields:
        return f"'{option}' is not for kind '{kind.name}', which takes: {', '.join(takes)}"
    return unknown("key", option, takes)


def _check_weight(kind: Kind, options: Options, here: str) -> None:
    """Raise UserError for weights of parts that the kind does not have, or that are off."""
    if not isinstance(options.weight, dict):
        return
    parts = {part.name: part for part in kind.parts if part.name}
    if not parts:
        raise UserError(f"{here}: weight must be a number, not a table: '{kind.name}' is one term")
    for name in options.weight:
        if name not in parts:
            raise UserError(f"{here}: weight: {unknown('part', name, parts)}")
        option = parts[name].option
        if option is not None and not getattr(options, option):
            unit = kind.choices()[option]
            raise UserError(f"{here}: weight.{name} needs {option} = ... ({unit}); without it '{name}' is off")


def parse(text: str, name: str, where: str, folder: Path | None = None) -> Parsed:
    """Return a clip's text with its tables; raises UserError for tables that fit no figure."""
    if not text:
        raise UserError(f"{where}: {EMPTY}")
    source = Parsed.of(text, name, where, folder)
    follows = source.table.recording is not None
    check_times([row.time for row in source.table.keyframe], where, fewest=0 if follows else 2)
    for line in _recording_errors(source.table) if follows else ():
        raise UserError(f"{where}: {line}")
    return source


def read(source: str) -> Parsed:
    """Return a shipped clip or a TOML file, parsed.

    Raises:
        UserError: For other names, and for a file that cannot be read.
    """
    if source in models.clips():
        return parse(models.clip_text(source), source, f"{source}.toml")
    path = Path(source)
    if path.is_dir():
        raise UserError(f"'{source}' is a folder, not a clip")
    if not path.is_file():
        if path.suffix:
            raise UserError(f"no file '{source}'; clips that ship: {', '.join(models.clips()) or 'none'}")
        raise UserError(unknown("clip", source, models.clips()))
    if path.suffix.lower() != ".toml":
        advice = f"`dynsplines new {source}` writes one" if path.suffix.lower() == ".xml" else import_first(source)
        raise UserError(f"'{source}': a clip is a .toml file, or a shipped name; {advice}")
    try:
        text = _text_of(path)
    except OSError as error:
        raise UserError(f"{source}: cannot be read: {error.strerror}") from None
    return parse(text, path.stem, path.name, path.parent)


def _text_of(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"{file}: not UTF-8 text (byte {error.start + 1})") from None


@lru_cache(maxsize=4)
def table_of(text: str, where: str) -> ClipTable:
    """Return the tables of a clip's TOML text. They are cached and shared, so callers must not change them.

    Raises:
        UserError: For a text that does not fit the tables.
    """
    return _tables(text, where, ClipTable)


def file_of(source: Path, kind: type[Tables]) -> Tables:
    """Return the tables of another TOML file: scene and contacts of a recording, or a bone map.

    Raises:
        UserError: For a file that does not fit the tables.
    """
    return _tables(_text_of(source), source.name, kind)


def _tables(text: str, where: str, kind: type[Tables]) -> Tables:
    try:
        raw = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise UserError(f"{where}: {describe_toml(error, text, kind)}") from None
    except RecursionError:
        raise UserError(f"{where}: not valid TOML: nested too deeply") from None
    except ValueError:  # Python's limit of digits in an integer
        raise UserError(f"{where}: not valid TOML: a number of thousands of digits") from None
    if kind is ClipTable and not raw:
        raise UserError(f"{where}: {EMPTY}")
    if kind is ClipTable and raw.get("keyframe", []) == [] and "recording" not in raw:
        raise UserError(f"{where}: no keyframes; a clip needs at least two [[keyframe]] tables")
    try:
        return kind.model_validate(raw)
    except ValidationError as error:
        raise UserError(f"{where}: {describe(error, raw, kind)}") from None


def references(text: str) -> tuple[str | None, str | None]:
    """Return the figure and the recording that a clip's TOML text names, or None for each."""
    try:
        raw = tomllib.loads(text)
    except (ValueError, RecursionError):
        return None, None
    figure, recording = raw.get("figure"), raw.get("recording")
    file = recording.get("file") if isinstance(recording, dict) else None
    return figure if isinstance(figure, str) else None, file if isinstance(file, str) else None


def files_read(
    path: Path, model_files: Callable[[Path], dict[Path, bytes]], before: tuple[Path, ...] = ()
) -> tuple[dict[Path, bytes], Path | None]:
    """Return the contents of a clip's file, of its figure's, and of the recording or clip that it follows.

    Missing files are omitted. The second value is the figure if its path is absolute. Raises OSError.

    Args:
        model_files: Returns the contents of all files of a model.
        before: The clips that follow this one.
    """
    files, absolute = {path: path.read_bytes()}, None
    named, recording = references(files[path].decode("utf-8", errors="replace"))
    if named is not None and named not in models.figures():
        figure = Path(os.path.normpath(path.parent / named))
        if is_there(figure):
            files |= model_files(figure)
            absolute = figure if Path(named).is_absolute() else None
    if recording is not None and recording not in models.clips():
        file = Path(os.path.normpath(path.parent / recording))
        if is_there(file) and file not in (path, *before) and (file_access.is_allowed() or lies_in(file, path.parent)):
            is_clip = file.suffix == ".toml"
            files |= files_read(file, model_files, (path, *before))[0] if is_clip else {file: file.read_bytes()}
    return files, absolute


def _recording_errors(table: ClipTable) -> Iterator[str]:
    """Yield a line for every table or key that only a clip without a recording can have."""
    if table.grasp:
        yield "[[grasp]] is for clips of keyframes; one that follows a recording has none"
    if table.solve.model_fields_set:
        yield f"solve.{sorted(table.solve.model_fields_set)[0]} is for clips of keyframes, not for one with [recording]"
    parts = [(kind, part) for kind in KINDS.values() for part in kind.parts]
    tracked = [kind.term(part) for kind, part in parts if part.tracking is not None and part.option is None]
    for entry in table.penalty:
        weight = entry.options.get("weight")
        terms = [f"{entry.kind}.{part}" for part in weight] if isinstance(weight, dict) else []
        unfit = [term for term in terms if term not in tracked]
        kinds = {term.split(".")[0] for term in tracked}
        if entry.kind not in kinds or unfit or entry.options.keys() - {"weight"}:
            yield f"penalty '{entry.kind}': beside a recording only weights count, of: {', '.join(tracked)}"


def keyframe_label(number: int, time: float) -> str:
    """Return the label of a keyframe in errors, for its number from 1 on and its time [s]."""
    return f"keyframe {number} (t = {time:g} s)"


def is_too_near(a: float, b: float) -> bool:
    """Return whether neighbouring keyframes at two times [s] are too near each other."""
    return abs(b - a) < SHORTEST - ROUNDING


def check_times(times: Sequence[float], where: str, fewest: int = 2) -> None:
    """Check that the times (K,) [s] of keyframes rise, by steps that are neither too short nor too uneven.

    Raises:
        UserError: If they do not, or there are fewer than `fewest`, or the clip is too long.
    """
    if len(times) < fewest:
        raise UserError(f"{where}: {len(times) or 'no'} keyframe{'s' if not times else ''}; a clip needs at least two")
    for i, (a, b) in enumerate(pairwise(times), 1):
        if not b > a:
            raise UserError(f"{where}: {keyframe_label(i + 1, b)} is not after {keyframe_label(i, a)}; times must rise")
        if is_too_near(a, b):
            raise UserError(f"{where}: {keyframe_label(i + 1, b)} is less than {SHORTEST:g} s after keyframe {i}")
    for i, (a, b, c) in enumerate(zip(times, times[1:], times[2:], strict=False), 1):
        short, long = sorted((b - a, c - b))
        if long > UNEVEN * short * (1 + 1e-9):
            raise UserError(
                f"{where}: keyframes {i}, {i + 1} and {i + 2} are {b - a:g} s and {c - b:g} s apart, which is over "
                f"{UNEVEN:,} : 1; insert keyframes into the long interval, with shorter intervals near the short one"
            )
    if len(times) > 1 and times[-1] - times[0] > LONGEST:
        raise UserError(
            f"{where}: from the first to the last keyframe are {times[-1] - times[0]:g} s, over {LONGEST:g} s"
        )


def settings_of(solve: SolveTable, times: Sequence[float], where: str) -> Settings:
    """Return the settings of the search for keyframes at times (K,) [s].

    The default budget of variable frames is 3 per segment, or one per 0.1 s if that is more.

    Raises:
        UserError: For an unknown criterion or optimiser, or too many samples.
    """
    try:
        return _settings(solve, times)
    except ValueError as error:
        raise UserError(f"{where}: {error}") from None


def _settings(solve: SolveTable, times: Sequence[float]) -> Settings:
    if solve.quadrature == "gauss" and (solve.samples or 0) > 64:
        raise ValueError(f"solve: samples must be at most 64 a panel with quadrature = 'gauss', not {solve.samples}")
    if solve.criterion is not None and solve.criterion not in CRITERIA:
        raise ValueError(f"solve: {unknown('criterion', solve.criterion, CRITERIA)}")
    if solve.optimiser is not None:
        check_method(solve.optimiser)
    segments, default = max(len(times) - 1, 1), Settings()
    budget = max(3 * segments, round((times[-1] - times[0]) / FRAME_SECONDS)) if times else None
    begin = solve.variable
    if begin is None and solve.frames is not None:
        begin = min(FEW, solve.frames // segments)
    if solve.quadrature == "uniform":
        quadrature = Quadrature("uniform", solve.samples or 100)
    else:
        quadrature = Quadrature("gauss", solve.samples or POINTS, LONGEST_PANEL)
    return Settings(
        variable=begin,
        frames=budget if solve.frames is None else solve.frames,
        criterion=default.criterion if solve.criterion is None else solve.criterion,
        threshold=default.threshold if solve.threshold is None else solve.threshold,
        optimiser=default.optimiser if solve.optimiser is None else solve.optimiser,
        max_evaluations=solve.evaluations or default.max_evaluations,
        tolerance=solve.tolerance or TOLERANCE,
        quadrature=quadrature,
    )
