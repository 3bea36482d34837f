"""A clip file (TOML, degrees, names) becomes a problem: figure, keyframes, soft constraints, settings.

Also accepted as a clip: an MJCF file with <keyframe> elements, and a figure with an .npz of times and configurations.
What a keyframe leaves out is free. A [[penalty]] entry changes or adds to the defaults; weight = 0 takes one away.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Sequence
from contextvars import ContextVar
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Any, TypeVar

import mujoco
import numpy as np
from pydantic import ValidationError

from dynsplines import models
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Frame, TimelineError
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.figure.figure import Figure, FigureError, JointKind, quaternion_columns
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Penalty, Placed, Support
from dynsplines.solver.posing import entries
from dynsplines.solver.problem import FEW, Problem, Settings
from dynsplines.solver.refine.subdivision import CRITERIA
from dynsplines.solver.search.descent import check_method
from dynsplines.solver.search.refinement import DENSE, copes
from dynsplines.solver.surface import static_surfaces

from ..errors import UserError, unknown
from ..motion import Saved, read_arrays
from ..motion import load as read_motion
from ..scene.assets import Scene, taken_along
from ..scene.compose import Step, compose, figure_spec, first_line, quietly, spec_joint_names
from ..scene.configuration import first_wrong
from .constraints import chosen, constraints, listed_flights, posing_bends, renewed, weight_factors
from .contacts import Contacts, rests
from .context import Context
from .follow.keeping import ground_of, rests_of, stances_in, stances_of
from .follow.recording import Followed, Moving, followed
from .holds import asked
from .obstacles import obstacles
from .posing.couplings import complaints, follow
from .posing.feet import sole_points
from .posing.places import Places
from .posing.placing import check_search, wanted, with_pose
from .posing.rooting import ambiguities, set_roots
from .posing.rotation import quaternion_of
from .posing.standing import Stander
from .posing.turns import lost_turns
from .table import (
    ROTATION,
    ClipTable,
    KeyframeTable,
    RecordingTable,
    RotationTable,
    SolveTable,
    Table,
    spoken,
)
from .text import written
from .things import lying

Tables = TypeVar("Tables", bound=Table)

LONGEST_PANEL = 0.05  # [s] of Gauss's rule
POINTS = 3  # of Gauss's rule in a panel: exact for fifth powers of time
TOLERANCE = 1e-3  # relative progress of E at which a search ends
FRAME_SECONDS = 0.1  # [s] a variable frame at least in the budget of a clip with long segments

AROUND = ("travel", "turn")  # what [solve] says of how a loop comes back
CLEANING = "dynsplines.clean.running"  # what makes a motion of another program's recording
NEXT = 1e-6  # [s] that a saved keyframe may be beside its time in the text
SHORTEST = 0.001  # [s] between neighbouring keyframes
UNEVEN = 10_000  # times that a distance between keyframes may be its neighbour: the spline overshoots by as much
LONGEST = 600.0  # [s] from the first keyframe to the last

_following_now: ContextVar[tuple[str, ...]] = ContextVar("following", default=())  # clips whose recordings are read


@dataclass(frozen=True, repr=False)
class Clip:
    """A problem ready to solve, and what the report looks at.

    text     the TOML text (empty for MJCF and NPZ clips)
    scene    the complete MJCF of figure and scene, with the files that it refers to
    problem  what is to be solved: figure, keyframes, soft constraints, settings, ends
    context  what the soft constraints were made of: soles, knees and elbows, contacts, holds, flights, a cycle
    notes    one line each on what was looked for and not found
    own      soft constraints of a program's own, which are among the problem's; no file holds them
    """

    name: str
    text: str
    scene: Scene
    fps: float
    problem: Problem
    context: Context
    notes: tuple[str, ...]
    own: tuple[tuple[Penalty, float], ...] = ()

    @property
    def figure(self) -> Figure:
        """Whose motion it is."""
        return self.problem.figure

    @property
    def keys(self) -> tuple[Frame, ...]:
        """The keyframes."""
        return tuple(self.problem.keys)

    @property
    def said(self) -> tuple[Frame, ...]:
        """The keyframes that somebody gave: of a clip that follows a recording, none of the recording's own frames."""
        return _edits(self.keys, table_of(self.text, self.context.where)) if self.follows else self.keys

    @property
    def follows(self) -> bool:
        """Whether it follows a recording, whose own instants are frames that nobody set."""
        return "recording" in self.text and table_of(self.text, self.context.where).recording is not None

    @property
    def stances(self) -> list[dict[str, Any]]:
        """What stands when, of a clip that follows a recording, in plain words; nothing of others."""
        return stances_of(self.context.contacts.given) if self.follows else []

    @property
    def penalties(self) -> tuple[tuple[Penalty, float], ...]:
        """The soft constraints with their weights."""
        return tuple(self.problem.penalties)

    @property
    def settings(self) -> Settings:
        """How the search goes."""
        return self.problem.settings

    @property
    def ends(self) -> str:
        """ "free", "clamped" or "periodic" """
        return self.problem.ends

    @property
    def mjcf(self) -> str:
        """The complete MJCF text."""
        return self.scene.mjcf

    def asking(self, **changes: Any) -> Clip:
        """The same clip with fields of its problem changed: penalties, settings, ends."""
        return replace(self, problem=replace(self.problem, **changes))

    def __repr__(self) -> str:
        """ "<Clip run_and_step: 2.20 s, 12 keyframes (3 partial), 15 penalties, 39 DOF>" """
        seconds, partial = self.keys[-1].time - self.keys[0].time, sum(not key.is_key for key in self.keys)
        some = f" ({partial} partial)" if partial else ""
        loop = ", loop" if self.ends == "periodic" else ""
        return (
            f"<Clip {self.name}: {seconds:.2f} s{loop}, {len(self.keys)} keyframes{some}, "
            f"{len(self.penalties)} penalties, {self.figure.model.nv} DOF>"
        )


def load(
    source: str,
    *,
    model: str | None = None,
    keys: str | None = None,
    figure_file: str | None = None,
    fps: float | None = None,
    unmet: list[str] | None = None,
) -> Clip:
    """A clip by the name of a shipped one, a TOML or MJCF file, or a figure and an .npz of keyframes.

    figure_file  where a TOML clip's figure is now, if not where the clip says
    unmet        gets a line for every place that no pose was found for, which is an error otherwise
    Raises UserError, in one line that names the file, the keyframe and the key.
    """
    if keys is not None or model is not None:
        if keys is None or model is None:
            raise UserError("--model and --keys go together")
        if source:
            raise UserError(f"give a clip or --model with --keys, not both ('{source}' and '{model}')")
        return _from_arrays(model, Path(keys), fps)
    if source in models.clips():
        return from_text(models.clip_text(source), name=source, fps=fps)
    path = Path(source)
    if path.is_dir():
        raise UserError(f"'{source}' is a folder, not a clip")
    if not path.is_file():
        if path.suffix:
            raise UserError(f"no file '{source}'; clips that ship: {', '.join(models.clips()) or 'none'}")
        raise UserError(unknown("clip", source, models.clips()))
    if path.suffix.lower() == ".xml":
        return _from_mjcf(path, fps)
    if path.suffix.lower() != ".toml":
        raise UserError(f"'{source}': a clip is a .toml file, an MJCF .xml with keyframes, or a shipped name")
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"{source}: not UTF-8 text (byte {error.start + 1})") from None
    except OSError as error:
        raise UserError(f"{source}: cannot be read: {error.strerror}") from None
    return from_text(
        text, name=path.stem, where=path.name, folder=path.parent, figure_file=figure_file, fps=fps, unmet=unmet
    )


def from_text(
    text: str,
    *,
    name: str,
    where: str | None = None,
    folder: Path | None = None,
    figure_file: str | None = None,
    fps: float | None = None,
    spec: mujoco.MjSpec | None = None,
    unmet: list[str] | None = None,
    like: Clip | None = None,
) -> Clip:
    """A clip from TOML text; `where` is how errors call it, `folder` where the figure's path starts.

    figure_file  where the figure is now, if not where the text says
    spec         the figure itself, whatever the text calls it
    like         the clip that this one was edited from: if its text has the same figure and scene, they are its own
    unmet        gets a line for every place that no pose was found for; the keyframe comes as near as it can
    """
    where = where or f"{name}.toml"
    table = table_of(text, where)
    _check_text(table, where)
    if like is not None and _has_ground(like, table):
        scene, figure = like.scene, like.figure
    else:
        scene, figure = _ground(table, where, folder, figure_file, spec)
    missed: list[str] = []
    sources = _Sources(table, figure_file or _place(table.figure, folder))
    recording = followed(table, figure, folder, where, sources)
    base = None if recording is None else recording.pose
    keys, placed = _keys(figure, lying(table), _stander(figure, table, where), where, missed, base)
    if missed and unmet is None:
        raise UserError(f"{where}: {'; '.join(missed)}")
    if unmet is not None:
        unmet += missed
    if recording is not None:
        return _following(recording, name, text, scene, keys, table, fps)
    clip = _clip(name, text, scene, figure, fps or table.fps, keys, table, where, placed)
    notes = (*ambiguities(figure, table.keyframe), *lost_turns(figure, table.keyframe, clip.problem.raw))
    return replace(clip, notes=(*clip.notes, *notes))


def _place(figure: str, folder: Path | None) -> str:
    """A figure as it is called from anywhere: its name, or its path from a clip's folder."""
    return figure if figure in models.figures() or folder is None else str(folder / figure)


@dataclass(frozen=True)
class _Sources:
    """What a clip may follow beside a motion file: other clips, and files of other programs.

    figure  its name, or where its MJCF is
    """

    table: ClipTable
    figure: str

    def solved(self, name: str, where: str) -> Moving:
        """Raises UserError, also for a clip that follows itself."""
        before = _following_now.get()
        own = name if name in models.clips() else str(Path(name).resolve())
        if own in before:
            raise UserError(f"{where}: '{name}' follows itself")
        token = _following_now.set((*before, own))
        try:
            return _shipped(name) if name in models.clips() else _moved(load(name))
        except UserError as error:
            raise UserError(f"{where}: {error}") from None
        finally:
            _following_now.reset(token)

    def cleaned(self, file: Path, where: str) -> Moving:
        cleaning = import_module(CLEANING)  # by its name: it stands on clips, and not under them
        try:
            return cleaning.moving(file, self.figure, self.table.scene)
        except UserError as error:
            raise UserError(f"{where}: {error}") from None


@lru_cache(maxsize=4)
def _shipped(name: str) -> Moving:
    return _moved(load(name))


def _moved(clip: Clip) -> Moving:
    return Moving(clip.figure, inbetween(clip.problem).timeline, clip.fps)


def _ground(
    table: ClipTable, where: str, folder: Path | None, figure_file: str | None, spec: mujoco.MjSpec | None
) -> tuple[Scene, Figure]:
    """A clip's figure in its scene."""
    step = table.scene.step
    try:
        spec = figure_spec(figure_file or table.figure, folder) if spec is None else spec
    except UserError as error:
        raise UserError(f"{where}: {error}") from None
    _check_joints(table.keyframe, spec, where)
    keys = _model_keys(table.keyframe, spec, where)
    try:
        scene = compose(spec, None if step is None else Step(**step.model_dump()), obstacles(table.scene), keys=keys)
    except UserError as error:
        raise UserError(f"{where}: {error}") from None
    return scene, figure_of(scene, where, table.solve.coordinates)


def _has_ground(clip: Clip, table: ClipTable) -> bool:
    """Whether a clip's text has the same figure in the same scene."""
    old_table = table_of(clip.text, clip.context.where) if clip.text else None
    named = {row.model_key for row in table.keyframe} - {None}
    if old_table is not None and not named <= {row.model_key for row in old_table.keyframe}:
        return False
    return old_table is not None and (old_table.figure, old_table.scene, old_table.solve.coordinates) == (
        table.figure,
        table.scene,
        table.solve.coordinates,
    )


@lru_cache(maxsize=4)
def table_of(text: str, where: str) -> ClipTable:
    """The tables of a clip's TOML text, not to be changed; raises UserError for what they cannot hold.

    The last few are remembered: whoever edits a clip asks for the same one several times.
    """
    return _tables(text, where, ClipTable)


def file_of(source: Path, kind: type[Tables]) -> Tables:
    """A TOML file that is no clip: a recording's scene and contacts, a map. Raises UserError for what it cannot be."""
    try:
        text = source.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise UserError(f"{source}: not UTF-8 text (byte {error.start + 1})") from None
    return _tables(text, source.name, kind)


def _tables(text: str, where: str, kind: type[Tables]) -> Tables:
    try:
        raw = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise UserError(f"{where}: not valid TOML: {error}") from None
    except RecursionError:
        raise UserError(f"{where}: not valid TOML: nested too deeply") from None
    except ValueError:  # what Python calls too many digits for an integer
        raise UserError(f"{where}: not valid TOML: a number of thousands of digits") from None
    if kind is ClipTable:
        _check_filled(raw, where)
    try:
        return kind.model_validate(raw)
    except ValidationError as error:
        raise UserError(f"{where}: {spoken(error, raw, root=kind)}") from None


def named(text: str) -> tuple[str | None, str | None]:
    """What a clip's TOML text calls its figure, and the recording that it follows; None where it does not say."""
    try:
        said = tomllib.loads(text)
    except (ValueError, RecursionError):
        return None, None
    figure, recording = said.get("figure"), said.get("recording")
    file = recording.get("file") if isinstance(recording, dict) else None
    return figure if isinstance(figure, str) else None, file if isinstance(file, str) else None


def load_motion(path: Path) -> Saved:
    """A motion from its file. Kinds of penalty in its clip's text that an older version wrote are those of today."""
    saved = read_motion(path)
    try:
        clip = tomllib.loads(saved.text)
        rows = clip.get("penalty", [])
        now = renewed(rows)
    except (ValueError, TypeError, RecursionError):  # a damaged text is reported where it is read
        return saved
    return saved if now is rows else replace(saved, text=written(clip | {"penalty": now}))


def of_motion(saved: Saved, *, contacts: bool = False) -> Clip:
    """The problem that a saved motion answers, its keyframes and ends those of the motion itself.

    contacts  whether those of its text hold for it still, and the places that it leaves to the search
    """
    table = table_of(saved.text, saved.name) if saved.text else None
    solve = SolveTable() if table is None else table.solve
    ends = saved.timeline.ends
    solve = solve.model_copy(update={"ends": ends, **dict.fromkeys(AROUND), **around(saved)})
    placed: tuple[Placed, ...] = ()
    if table is not None and contacts:
        whole = [key.state for key in saved.keys if key.is_key]
        places = Places(saved.figure, sole_points(saved.figure, np.reshape(whole, (-1, saved.figure.width))))
        placed = tuple(point for row in table.keyframe for point in wanted(places, row, saved.name).placed)
    elif table is not None:  # which are those of the clip that it was
        table = table.model_copy(update={"contact": [], "hold": []})
    return _clip(
        saved.name, saved.text, saved.scene, saved.figure, saved.fps, list(saved.keys), table, saved.name, placed, solve
    )


def around(saved: Saved) -> dict[str, Any]:
    """What [solve] says of how a saved loop comes back: travel [m] and, if it turns, turn [degrees]."""
    roots = saved.figure.tables.position_columns
    if saved.timeline.ends != "periodic" or not roots.size:
        return {}
    seam = Seam.of(saved.figure, saved.timeline)
    turn = {"turn": float(np.degrees(seam.headings[0]))} if seam.headings[0] else {}
    return {"travel": seam.travel[roots[:, 0]].tolist(), **turn}


def radians(degrees: float | None) -> float | None:
    """An angle, if there is one."""
    return None if degrees is None else float(np.radians(degrees))


def answered(saved: Saved) -> Clip:
    """The problem that a saved motion answers, with the contacts and the places that its text asks for.

    A motion that breaks its contacts so much that no clip could have them is looked at for them all the same.
    """
    if saved.text:
        table = table_of(saved.text, saved.name)
        if table.recording is not None:
            return _followed_again(saved, table, table.recording)
    try:
        return of_motion(saved, contacts=True)
    except UserError:
        clip, table = of_motion(saved), table_of(saved.text, saved.name)
        points = clip.context.points
        given = Contacts(given=rests(saved.figure, table.contact, points))
        held = asked(saved.figure, table.hold, points)
        return replace(clip, context=replace(clip.context, contacts=given, holds=held))


def _followed_again(saved: Saved, table: ClipTable, said: RecordingTable) -> Clip:
    """The problem of a motion that follows a recording, which need not be there any more."""
    edits = _edits(saved.keys, table)
    recording = Followed.of_motion(saved.figure, saved.raw, said, saved.name)
    known = saved.search.get("stances")
    clip = _following(recording, saved.name, saved.text, saved.scene, list(edits), table, saved.fps, known)
    return replace(clip, problem=replace(clip.problem, keys=saved.keys))


def _edits(keys: Sequence[Frame], table: ClipTable) -> tuple[Frame, ...]:
    """Those of the keys that a text gives."""
    given = [row.time for row in table.keyframe]
    return tuple(key for key in keys if np.isclose(key.time, given, rtol=0, atol=NEXT).any())


def with_keys(clip: Clip, keys: Sequence[Frame]) -> Clip:
    """The same clip through other keyframes; what was found from the old ones is found again, poses too."""
    table = ClipTable.model_validate(tomllib.loads(clip.text)) if clip.text else None
    times = {key.time for key in keys}
    placed = tuple(point for point in clip.context.placed if point.time in times)
    keys = [replace(key, posed=None) for key in keys]
    if table is not None:
        keys = _stander(clip.figure, table, clip.name).stood(keys, placed)
    found = _clip(clip.name, clip.text, clip.scene, clip.figure, clip.fps, keys, table, clip.name, placed)
    return replace(found.asking(penalties=(*found.penalties, *clip.own)), own=clip.own)


def _stander(figure: Figure, table: ClipTable, where: str) -> Stander:
    bends, surfaces = posing_bends(figure, table.penalty), static_surfaces(figure.model)
    aloft = listed_flights(table.penalty)
    return Stander(figure, surfaces, table.contact, bends, table.solve, where, held=table.hold, aloft=aloft)


def _clip(
    name: str,
    text: str,
    scene: Scene,
    figure: Figure,
    fps: float,
    keys: list[Frame],
    table: ClipTable | None,
    where: str,
    placed: tuple[Placed, ...] = (),
    solve: SolveTable | None = None,
) -> Clip:
    solve = solve or (SolveTable() if table is None else table.solve)
    try:
        problem = _problem(figure, keys, solve)
        timeline = problem.raw
    except (TimelineError, ValueError) as error:
        raise UserError(f"{where}: {error}") from None
    surfaces = static_surfaces(figure.model)
    complained = complaints(figure, timeline, keys)
    contact, held, penalty = ([], [], []) if table is None else (table.contact, table.hold, table.penalty)
    found = constraints(Context.of(figure, timeline, surfaces, where, placed, contact, held), penalty)
    problem = replace(problem, penalties=found.penalties)
    notes = (*complained, *found.notes, *_too_many(problem))
    return Clip(name, text, scene, fps, problem, found.context, notes)


def _following(
    recording: Followed,
    name: str,
    text: str,
    scene: Scene,
    edits: list[Frame],
    table: ClipTable,
    fps: float | None,
    known: object = None,
) -> Clip:
    """A clip whose keyframes edit a recording.

    known  the stances that it was found to have before, as `Clip.stances` tells them
    """
    figure, where = recording.recorded.figure, recording.where
    ground = ground_of(figure, figure.to_qpos(recording.recorded.states))
    given = rests_of(ground, table.contact, recording.recorded.path.span, where)
    kept = recording.stances(ground, edits, given) if known is None else stances_in(known, ground, where)
    problem = recording.problem(ground, edits, kept)
    factors = weight_factors(table.penalty, where)
    weighted = tuple((p, w * factors.get(p.name, 1.0)) for p, w in problem.penalties)
    problem = replace(problem, penalties=weighted)
    try:
        timeline = problem.raw
    except (TimelineError, ValueError) as error:
        raise UserError(f"{where}: {error}") from None
    contacts = Contacts(rests=kept, given=kept)
    bends = () if ground.bends is None else ground.bends.joints
    support = next((penalty for penalty, _ in problem.penalties if isinstance(penalty, Support)), None)
    context = Context(figure, timeline, ground.surfaces, where, ground.points, bends, contacts, support=support)
    return Clip(name, text, scene, fps or table.fps, problem, context, ())


def _too_many(problem: Problem) -> Iterator[str]:
    """A line on an optimiser that does nothing with so many unknowns."""
    settings = problem.settings
    about = (
        settings.beginning(np.array([key.time for key in problem.keys]), in_windows=False).size * problem.figure.width
    )
    if isinstance(settings.optimiser, str) and not copes(settings.optimiser, about):
        most = DENSE[settings.optimiser.lower()]
        yield (
            f"optimiser '{settings.optimiser}' is dense: with some {about} unknowns, over {most}, "
            "all steps are Gauss-Newton's and nothing refines them"
        )


def _problem(figure: Figure, keys: Sequence[Frame], solve: SolveTable) -> Problem:
    """What [solve] says of the keyframes, without soft constraints yet."""
    settings = _settings(solve, [key.time for key in keys])
    slope = np.zeros((2, figure.width)) if solve.ends == "clamped" else None
    return Problem(figure, tuple(keys), (), settings, solve.ends, slope, solve.travel, radians(solve.turn))


def figure_of(scene: Scene, where: str, coordinates: str = "auto") -> Figure:
    """The figure of a scene; raises UserError, where first, for one that the solver cannot move."""
    try:
        return Figure(scene.model(), coordinates)
    except (FigureError, ValueError) as error:
        raise UserError(f"{where}: {error}") from None


def _check_filled(raw: dict[str, Any], where: str) -> None:
    """An empty clip is told as one, not by the first key that it lacks."""
    if not raw:
        raise UserError(f"{where}: the clip is empty; it needs a figure and two [[keyframe]] tables")
    if raw.get("keyframe", []) == [] and "recording" not in raw:
        raise UserError(f"{where}: no keyframes; a clip needs at least two [[keyframe]] tables")


def _check_text(table: ClipTable, where: str) -> None:
    """Raises UserError for what is wrong whatever the figure is, before its meshes are read."""
    times = [row.time for row in table.keyframe]
    check_times(times, where, fewest=2 if table.recording is None else 0)
    if table.recording is None:
        try:
            _settings(table.solve, times)
        except ValueError as error:
            raise UserError(f"{where}: {error}") from None
    chosen(table.penalty, where)
    for number, row in enumerate(table.keyframe, start=1):
        here = f"{where}: {_called(number, row.time)}"
        if isinstance(row.root.rotation, RotationTable):
            quaternion_of(row.root.rotation, f"{here}: root.rotation")
        for name, value in row.joints.items():
            if isinstance(value, RotationTable):
                quaternion_of(value, f"{here}: joints.{name}")


def _check_joints(rows: Sequence[KeyframeTable], spec: mujoco.MjSpec, where: str) -> None:
    """Raises UserError for a joint that the figure does not have, before its meshes are read, if it has any."""
    if not (spec.meshes or spec.hfields or spec.skins):
        return  # it is compiled in a moment
    names = spec_joint_names(spec)
    for number, row in enumerate(rows, start=1):
        for name in row.joints:
            if name not in names:
                raise UserError(f"{where}: {_called(number, row.time)}: {unknown('joint', name, names)}")


def _model_keys(rows: Sequence[KeyframeTable], spec: mujoco.MjSpec, where: str) -> list[str]:
    """The names of the model's <key> elements that keyframes refer to; raises UserError for one that it lacks."""
    names, references = [key.name for key in spec.keys], dict[str, None]()
    for number, row in enumerate(rows, start=1):
        name = row.model_key
        if name is not None and name not in names:
            raise UserError(
                f"{where}: {_called(number, row.time)}: others: {unknown('key', name, filter(None, names))}"
            )
        if name is not None:
            references[name] = None
    return list(references)


def _called(number: int, time: float) -> str:
    return f"keyframe {number} (t = {time:g} s)"


def check_times(times: Sequence[float], where: str, fewest: int = 2) -> None:
    """Two keyframes or more, in order, apart but not too unevenly, in a time that a report can look through."""
    if len(times) < fewest:
        raise UserError(f"{where}: {len(times) or 'no'} keyframe{'s' if not times else ''}; a clip needs at least two")
    for i, (a, b) in enumerate(pairwise(times), 1):
        if not b > a:
            raise UserError(f"{where}: {_called(i + 1, b)} is not after {_called(i, a)}; times must rise")
        if b - a < SHORTEST:
            raise UserError(f"{where}: {_called(i + 1, b)} is less than {SHORTEST:g} s after keyframe {i}")
    for i, (a, b, c) in enumerate(zip(times, times[1:], times[2:], strict=False), 1):
        short, long = sorted((b - a, c - b))
        if long > UNEVEN * short * (1 + 1e-9):
            raise UserError(
                f"{where}: keyframes {i}, {i + 1} and {i + 2} are {b - a:g} s and {c - b:g} s apart, which is over "
                f"{UNEVEN:,} : 1; put keyframes in between, the nearer to the short one the closer"
            )
    if len(times) > 1 and times[-1] - times[0] > LONGEST:
        raise UserError(
            f"{where}: from the first to the last keyframe are {times[-1] - times[0]:g} s, over {LONGEST:g} s"
        )


def _settings(solve: SolveTable, times: Sequence[float]) -> Settings:
    """The clip's settings; the budget of variable frames is three a segment, or one a tenth of a second if more."""
    if solve.quadrature == "gauss" and (solve.samples or 0) > 64:
        raise ValueError(f"solve: samples must be at most 64 a panel with quadrature = 'gauss', not {solve.samples}")
    budget = max(3 * (len(times) - 1), round((times[-1] - times[0]) / FRAME_SECONDS))
    settings = Settings(frames=budget, tolerance=TOLERANCE, quadrature=Quadrature("gauss", POINTS, LONGEST_PANEL))
    if solve.quadrature == "uniform":
        settings = replace(settings, quadrature=Quadrature("uniform", solve.samples or 100))
    elif solve.samples is not None:
        settings = replace(settings, quadrature=Quadrature("gauss", solve.samples, LONGEST_PANEL))
    if solve.criterion is not None and solve.criterion not in CRITERIA:
        raise ValueError(f"solve: {unknown('criterion', solve.criterion, CRITERIA)}")
    if solve.optimiser is not None:
        check_method(solve.optimiser)
    begin = solve.variable
    if begin is None and solve.frames is not None:
        begin = min(FEW, solve.frames // (len(times) - 1))
    chosen: dict[str, Any] = {
        "variable": begin,
        "frames": solve.frames,
        "criterion": solve.criterion,
        "threshold": solve.threshold,
        "optimiser": solve.optimiser,
        "max_evaluations": solve.evaluations,
        "tolerance": solve.tolerance,
    }
    return replace(settings, **{key: value for key, value in chosen.items() if value is not None})


def _keys(
    figure: Figure,
    rows: list[KeyframeTable],
    stander: Stander,
    where: str,
    missed: list[str],
    base: Callable[[float], Array] | None = None,
) -> tuple[list[Frame], tuple[Placed, ...]]:
    """The keyframes, each of which may hold what the one before it says, what they leave free posed where that is
    beyond doubt; and the points that the search is to place.

    missed  gets a line for every place that no pose was found for
    base    what a keyframe leaves out is as qpos (nq,) at its time [s], and may be moved
    """
    places = [f"{where}: {_called(number, row.time)}" for number, row in enumerate(rows, start=1)]
    known = _named(figure, rows, places)
    wants = [wanted(known, row, here) for row, here in zip(rows, places, strict=True)]
    loose = [want.loose(figure, row) for want, row in zip(wants, rows, strict=True)]
    keys: list[Frame] = []
    for row, here, free in zip(rows, places, loose, strict=True):
        if row.others == "hold" and not keys:
            raise UserError(f"{here}: others = 'hold' has no keyframe before it to hold")
        keys.append(_based(_key(figure, row, keys[-1] if keys else None, free, here), base))
    if any(want.goals for want in wants):
        for k, (row, want, here) in enumerate(zip(rows, wants, places, strict=True)):
            held = _key(figure, row, keys[k - 1] if k else None, loose[k], here)  # holds what is solved by now
            keys[k] = _based(held, base)
            if want.goals:
                among, own = (keys, k) if base is None else ([_later(keys[k], base, by) for by in (-1, 0, 1)], 1)
                keys[k], lines = with_pose(figure, among, own, want.goals, stander, here)
                missed += [f"{_called(k + 1, row.time)}: {line}" for line in lines]
                keys[k] = _based(keys[k], base)
    for key, want, here in zip(keys, wants, places, strict=True):
        check_search(figure, key, want.placed, here)
    left = tuple(point for want in wants for point in want.placed)
    if base is not None:
        return keys, left
    return stander.stood(keys, left), left


def _based(key: Frame, base: Callable[[float], Array] | None) -> Frame:
    """A keyframe with what it leaves out as it is in what it edits."""
    if base is None:
        return key
    return Frame(key.time, np.where(key.fixed, key.state, base(key.time)), key.fixed, ~key.fixed)


def _later(key: Frame, base: Callable[[float], Array], by: int) -> Frame:
    """A keyframe, or a second later or earlier what it edits."""
    return key if not by else Frame.key(key.time + by, base(key.time))


def _named(figure: Figure, rows: Sequence[KeyframeTable], places: Sequence[str]) -> Places:
    """What keyframes can place: feet are found from those that say every joint, whatever else they place."""
    if not any(row.sites or row.bodies for row in rows):
        return Places(figure)
    keys: list[Frame] = []
    for row, where in zip(rows, places, strict=True):
        keys.append(_key(figure, row, keys[-1] if keys else None, (), where))
    whole = [key.state for key in keys if key.is_key]
    return Places(figure, sole_points(figure, np.reshape(whole, (-1, figure.width))))


def _key(figure: Figure, row: KeyframeTable, before: Frame | None, loose: Sequence[int], where: str) -> Frame:
    """A keyframe's qpos and mask; what it leaves out is free, at rest, or as in the keyframe before.

    loose  links whose joints are free whatever `others` says
    """
    qpos = np.array(figure.model.qpos0)
    fixed = np.full(figure.width, row.others == "rest" or row.model_key is not None)
    if row.model_key is not None:
        qpos = figure.to_qpos(figure.to_state(figure.model.key(row.model_key).qpos))  # unit quaternions
    if row.others == "hold" and before is not None:
        qpos, fixed = np.array(before.state), np.array(before.fixed)
    for i in loose:
        fixed[entries(figure, i)] = False
    named = {link.name: link for link in figure.links[1:]}
    for name, value in row.joints.items():
        if name not in named:
            raise UserError(f"{where}: {unknown('joint', name, named)}")
        if value == "free":
            fixed[quaternion_columns(named[name]) or named[name].qpos] = False
        else:
            _set_joint(qpos, fixed, named[name], value, f"{where}: joints.{name}")
    set_roots(figure, qpos, fixed, row, where, None if before is None else before.state)
    follow(figure, qpos, fixed, lambda name: name in row.joints)
    return Frame.key(row.time, qpos, fixed)


def _set_joint(qpos: Array, fixed: Mask, link: Any, value: RotationTable | float, where: str) -> None:
    columns = quaternion_columns(link)
    if columns is None:
        if isinstance(value, RotationTable):
            unit = "degrees" if link.kind is JointKind.HINGE else "metres"
            raise UserError(f"{where}: a {link.kind.name.lower()} joint takes a number ({unit}), not a rotation")
        qpos[link.qpos] = np.radians(value) if link.kind is JointKind.HINGE else value
        fixed[link.qpos] = True
        return
    if link.kind is JointKind.FREE:
        raise UserError(f"{where}: a free joint is placed by root.position and root.rotation, or by roots.{link.name}")
    if not isinstance(value, RotationTable):
        raise UserError(f"{where}: a ball joint takes a rotation, {ROTATION}, not a number")
    if value.heading is not None:
        raise UserError(f"{where}: a heading is of the root, of bodies and of obstacles; a joint turns in its parent")
    qpos[columns] = quaternion_of(value, where)
    fixed[columns] = True


def _from_mjcf(path: Path, fps: float | None) -> Clip:
    """An MJCF file whose <keyframe> elements, with their times, are the keyframes."""
    try:
        spec = figure_spec(str(path))
    except UserError as error:
        raise UserError(_placed(error, path.name)) from None
    return from_spec(path.stem, spec, fps, path.name)


def from_spec(name: str, spec: mujoco.MjSpec, fps: float | None, where: str) -> Clip:
    """A model whose <keyframe> elements, with their times, are the keyframes; `where` is how errors call it."""
    try:
        spec.assets = dict(taken_along(spec))  # MuJoCo 3.2.7 keeps meshes of such names
    except UserError as error:
        raise UserError(_placed(error, where)) from None
    written = [np.array(key.qpos) for key in spec.keys]
    try:
        with quietly():
            model = spec.compile()
    except ValueError as error:
        raise UserError(f"{where}: MuJoCo cannot compile it: {first_line(error)}") from None
    if not written:
        raise UserError(f"{where}: the model has no <keyframe> elements to go through")
    time, qpos = np.array(model.key_time)[: len(written)], np.array(model.key_qpos)[: len(written)]
    for i, own in enumerate(written):
        if own.size not in (0, model.nq):
            at = _called(i + 1, time[i])
            raise UserError(f"{where}: {at}: qpos has {own.size} numbers, not the figure's {model.nq}")
        if own.size:
            qpos[i] = own  # as written: MuJoCo turns a zero quaternion into no rotation
    try:
        scene = compose(spec, bare=model)
    except UserError as error:
        raise UserError(_placed(error, where)) from None
    return from_qpos(name, scene, time, qpos, fps, where)


def _from_arrays(model: str, keys: Path, fps: float | None) -> Clip:
    """A figure and an .npz with time (K,) and qpos (K, nq), or key_time and key_qpos, which win."""
    arrays = read_arrays(keys)
    names = ("key_time", "key_qpos") if {"key_time", "key_qpos"} <= arrays.keys() else ("time", "qpos")
    for name in names:
        if name not in arrays:
            raise UserError(f"{keys.name}: no array '{name}'; it holds: {', '.join(arrays) or 'nothing'}")
        if arrays[name].dtype.kind not in "fiu":
            raise UserError(f"{keys.name}: '{name}' holds {arrays[name].dtype.name}, not numbers")
    time, qpos = (np.asarray(arrays[name], float) for name in names)
    return from_qpos(keys.stem, _composed(model, model), time, qpos, fps, keys.name)


def _composed(figure: str, where: str) -> Scene:
    try:
        return compose(figure_spec(figure))
    except UserError as error:
        raise UserError(_placed(error, where)) from None


def _placed(error: UserError, where: str) -> str:
    """An error that names its place, once."""
    return str(error) if where in str(error) else f"{where}: {error}"


def from_qpos(name: str, scene: Scene, time: Array, qpos: Array, fps: float | None, where: str) -> Clip:
    """Whole keyframes from arrays, time (K,) [s] and qpos (K, nq), everything else by default.

    scene  figure and stage, complete; where is how errors call it. Raises UserError for what does not fit.
    """
    figure = figure_of(scene, where)
    if time.ndim != 1 or qpos.shape != (time.size, figure.width):
        raise UserError(
            f"{where}: time {time.shape} and qpos {qpos.shape} do not fit the figure: "
            f"they should be (K,) and (K, {figure.width})"
        )
    if wrong := first_wrong(figure.model, time, qpos):
        raise UserError(f"{where}: {_called(wrong[0] + 1, time[wrong[0]])}: {wrong[1]}")
    check_times(time.tolist(), where)
    keys = [Frame.key(t, q) for t, q in zip(time, qpos, strict=True)]
    return _clip(name, "", scene, figure, fps or 30.0, keys, None, where)
