"""A clip file (TOML, degrees, names) becomes a problem: figure, keyframes, soft constraints, settings.

Also accepted as a clip: an MJCF file with <keyframe> elements, and a figure with an .npz of times and configurations.
What a keyframe leaves out is free. A [[penalty]] entry changes or adds to the defaults; weight = 0 takes one away.
"""

from __future__ import annotations

import tomllib
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal

import mujoco
import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

import models
from solver import quaternion as quat
from solver.figure import Figure, FigureError, JointKind, quaternion_columns
from solver.frame import Frame, Timeline, TimelineError
from solver.inbetween import Settings
from solver.optimiser import algorithm
from solver.penalty import (
    Bend,
    BendLimits,
    Contact,
    CovariantAcceleration,
    Penalty,
    Planted,
    Point,
    RootAcceleration,
    Torque,
    UnitMagnitude,
    body_points,
    site_points,
    stances,
)
from solver.quadrature import Quadrature
from solver.quaternion import Array
from solver.subdivision import CRITERIA
from solver.surface import Surface, static_surfaces
from solver.unknowns import raw_timeline

from .errors import UserError, unknown
from .scene import Step, compose, figure_spec

KINDS = ("covariant", "root", "unit", "contact", "clearance", "planted", "bend", "torque")
DEFAULT_WEIGHTS = {"covariant": 1.0, "root": 1.0, "unit": 1.0, "contact": 10.0, "bend": 10.0}
KNEES, ELBOWS = ("knee", "shin"), ("elbow", "forearm", "farm")
SOLES = ("heel", "toe")
LONGEST_PANEL = 0.05
BEND_BOUND = 8.0  # degrees; 10° with room for a soft constraint

Number = Annotated[float, Field(allow_inf_nan=False)]
Axis = Number | Literal["free"]


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=False)


class RotationTable(_Table):
    rotvec: tuple[Number, Number, Number] | None = None
    euler: list[Number] | None = None
    order: str = "xyz"
    quat: tuple[Number, Number, Number, Number] | None = None


class RootTable(_Table):
    position: tuple[Axis, Axis, Axis] | Literal["free"] = "free"
    rotation: RotationTable | Literal["free"] = "free"


class KeyframeTable(_Table):
    time: Number
    root: RootTable = RootTable()
    joints: dict[str, RotationTable | Number | Literal["free"]] = {}


class StepTable(_Table):
    x: Number
    height: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    length: Annotated[float, Field(gt=0, allow_inf_nan=False)] = 3.0
    width: Annotated[float, Field(gt=0, allow_inf_nan=False)] = 2.4
    y: Number = 0.0


class SceneTable(_Table):
    step: StepTable | None = None


class PenaltyTable(_Table):
    kind: str
    weight: Annotated[float, Field(ge=0, allow_inf_nan=False)] = 1.0
    form: str | None = None
    points: list[str] | None = None
    joints: list[str] | None = None
    margin: Annotated[float, Field(ge=0, le=0.1)] | None = None
    least: Number | None = None
    sideways: Annotated[float, Field(gt=0)] | None = None
    twist: Annotated[float, Field(gt=0)] | None = None


class SolveTable(_Table):
    coordinates: Literal["auto", "world", "joint"] = "auto"
    ends: Literal["free", "clamped", "periodic"] = "free"
    variable: Annotated[int, Field(ge=0, le=50)] | None = None
    frames: Annotated[int, Field(ge=0)] | None = None
    criterion: str | None = None
    threshold: Annotated[float, Field(ge=0)] | None = None
    optimiser: str | None = None
    evaluations: Annotated[int, Field(ge=1)] | None = None
    tolerance: Annotated[float, Field(gt=0)] | None = None
    quadrature: Literal["gauss", "uniform"] = "gauss"
    samples: Annotated[int, Field(ge=1)] | None = None


class ClipTable(_Table):
    figure: str
    fps: Annotated[float, Field(gt=0, le=1000, allow_inf_nan=False)] = 30.0
    scene: SceneTable = SceneTable()
    solve: SolveTable = SolveTable()
    penalty: list[PenaltyTable] = []
    keyframe: list[KeyframeTable]


@dataclass(frozen=True)
class Clip:
    """A problem ready to solve, and what the report looks at.

    text    the TOML text (empty for MJCF and NPZ clips)
    mjcf    the complete MJCF text of figure and scene
    points  the sole points that stand on surfaces; bends: knees and elbows
    notes   one line each on what was looked for and not found
    """

    name: str
    text: str
    mjcf: str
    figure: Figure
    fps: float
    keys: tuple[Frame, ...]
    penalties: tuple[tuple[Penalty, float], ...]
    settings: Settings
    ends: str
    end_slope: Array | None
    surfaces: tuple[Surface, ...]
    points: tuple[Point, ...]
    bends: tuple[Bend, ...]
    notes: tuple[str, ...]


def load(source: str, *, model: str | None = None, keys: str | None = None, fps: float | None = None) -> Clip:
    """A clip by the name of a shipped one, a TOML or MJCF file, or a figure and an .npz of keyframes.

    Raises UserError, in one line that names the file, the keyframe and the key.
    """
    if keys is not None or model is not None:
        if keys is None or model is None:
            raise UserError("--model and --keys go together")
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
    if path.suffix == ".xml":
        return _from_mjcf(path, fps)
    if path.suffix != ".toml":
        raise UserError(f"'{source}': a clip is a .toml file, an MJCF .xml with keyframes, or a shipped name")
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UserError(f"{source}: cannot be read: {error}") from None
    return from_text(text, name=path.stem, place=path.name, folder=path.parent, fps=fps)


def from_text(
    text: str, *, name: str, place: str | None = None, folder: Path | None = None, fps: float | None = None
) -> Clip:
    """A clip from TOML text; `place` is how errors call it, `folder` where the figure's path starts."""
    place = place or f"{name}.toml"
    try:
        raw = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise UserError(f"{place}: not valid TOML: {error}") from None
    try:
        table = ClipTable.model_validate(raw)
    except ValidationError as error:
        raise UserError(f"{place}: {_spoken(error, raw)}") from None
    step = table.scene.step
    try:
        spec = figure_spec(table.figure, folder)
        mjcf = compose(spec, None if step is None else Step(**step.model_dump()))
    except UserError as error:
        raise UserError(f"{place}: {error}") from None
    figure = _figure(mjcf, table.solve.coordinates, place)
    keys = [_key(figure, row, f"{place}: keyframe {i} (t = {row.time:g} s)") for i, row in enumerate(table.keyframe, 1)]
    return _clip(name, text, mjcf, figure, fps or table.fps, keys, table.penalty, table.solve, place)


def with_keys(clip: Clip, keys: Sequence[Frame]) -> Clip:
    """The same clip through other keyframes; what was found from the old ones is found again."""
    table = ClipTable.model_validate(tomllib.loads(clip.text)) if clip.text else None
    entries, solve = ([], SolveTable()) if table is None else (table.penalty, table.solve)
    return _clip(clip.name, clip.text, clip.mjcf, clip.figure, clip.fps, list(keys), entries, solve, clip.name)


def _clip(
    name: str,
    text: str,
    mjcf: str,
    figure: Figure,
    fps: float,
    keys: list[Frame],
    entries: list[PenaltyTable],
    solve: SolveTable,
    place: str,
) -> Clip:
    try:
        timeline = raw_timeline(figure, keys, solve.ends, np.zeros((2, figure.width)))
        settings = _settings(solve)
    except (TimelineError, ValueError) as error:
        raise UserError(
            f"{place}: {str(error).replace('frame ', 'keyframe ', 1) if 'key' not in str(error) else error}"
        ) from None
    surfaces = static_surfaces(figure.model)
    notes: list[str] = []
    builder = _Penalties(figure, timeline, surfaces, notes, place)
    penalties = builder.all(entries)
    return Clip(
        name, text, mjcf, figure, fps, tuple(keys), penalties, settings, solve.ends,
        np.zeros((2, figure.width)) if solve.ends == "clamped" else None, surfaces,
        builder.points, builder.bends, tuple(notes),
    )  # fmt: skip


def _figure(mjcf: str, coordinates: str, place: str) -> Figure:
    try:
        return Figure(mujoco.MjModel.from_xml_string(mjcf), coordinates)
    except (FigureError, ValueError) as error:
        raise UserError(f"{place}: {error}") from None


def _settings(solve: SolveTable) -> Settings:
    settings = Settings(quadrature=Quadrature("gauss", 5, LONGEST_PANEL))
    if solve.quadrature == "uniform":
        settings = replace(settings, quadrature=Quadrature("uniform", solve.samples or 100))
    elif solve.samples is not None:
        settings = replace(settings, quadrature=Quadrature("gauss", solve.samples, LONGEST_PANEL))
    if solve.criterion is not None and solve.criterion not in CRITERIA:
        raise ValueError(unknown("criterion", solve.criterion, CRITERIA).replace("Criterions", "Criteria"))
    if solve.optimiser is not None:
        algorithm(solve.optimiser)
    chosen = {
        "variable": solve.variable,
        "frames": solve.frames,
        "criterion": solve.criterion,
        "threshold": solve.threshold,
        "method": solve.optimiser,
        "max_evaluations": solve.evaluations,
        "tolerance": solve.tolerance,
    }
    return replace(settings, **{key: value for key, value in chosen.items() if value is not None})


def _key(figure: Figure, row: KeyframeTable, place: str) -> Frame:
    """A keyframe's qpos and mask."""
    qpos = np.array(figure.model.qpos0)
    fixed = np.zeros(figure.width, bool)
    roots = [link for link in figure.links[1:] if link.kind is JointKind.FREE]
    named = {link.name: link for link in figure.links[1:]}
    if row.root != RootTable():
        if not roots:
            raise UserError(f"{place}: the figure has no free joint, so no root to place")
        start = roots[0].qpos
        if row.root.position != "free":
            for i, value in enumerate(row.root.position):
                if value != "free":
                    qpos[start + i], fixed[start + i] = float(value), True
        if row.root.rotation != "free":
            qpos[start + 3 : start + 7] = _rotation(row.root.rotation, f"{place}: root.rotation")
            fixed[start + 3 : start + 7] = True
    for name, value in row.joints.items():
        if name not in named:
            raise UserError(f"{place}: {unknown('joint', name, named)}")
        if value != "free":
            _set_joint(qpos, fixed, named[name], value, f"{place}: joints.{name}")
    return Frame.key(row.time, qpos, fixed)


def _set_joint(qpos: Array, fixed: Array, link: Any, value: RotationTable | float, place: str) -> None:
    columns = quaternion_columns(link)
    if columns is None:
        if isinstance(value, RotationTable):
            raise UserError(f"{place}: a {link.kind.name.lower()} joint takes a number, not a rotation")
        qpos[link.qpos] = np.radians(value) if link.kind is JointKind.HINGE else value
        fixed[link.qpos] = True
        return
    if not isinstance(value, RotationTable):
        raise UserError(f"{place}: a {link.kind.name.lower()} joint takes a rotation {{rotvec|euler|quat = ...}}")
    if link.kind is JointKind.FREE:
        raise UserError(f"{place}: a free joint is placed by root.position and root.rotation")
    qpos[columns] = _rotation(value, place)
    fixed[columns] = True


def _rotation(table: RotationTable, place: str) -> Array:
    """The unit quaternion wxyz of a rotation given in degrees."""
    given = [name for name in ("rotvec", "euler", "quat") if getattr(table, name) is not None]
    if len(given) != 1:
        raise UserError(f"{place}: give exactly one of rotvec, euler, quat, not {' and '.join(given) or 'none'}")
    if table.rotvec is not None:
        return quat.from_rotation_vector(np.radians(table.rotvec))
    if table.quat is not None:
        if np.linalg.norm(table.quat) < 1e-6:
            raise UserError(f"{place}: the quaternion is zero")
        return quat.normalised(table.quat)
    order, angles = table.order.lower(), table.euler or []
    if not order or set(order) - set("xyz") or len(order) != len(angles):
        raise UserError(f"{place}: order = '{table.order}' must name one of x, y, z for each of {len(angles)} angles")
    out = np.array([1.0, 0, 0, 0])
    for letter, angle in zip(order, np.radians(angles), strict=True):
        out = quat.product(out, quat.from_rotation_vector(angle * np.eye(3)["xyz".index(letter)]))
    return out


class _Penalties:
    """The table of soft constraints by kind."""

    def __init__(
        self, figure: Figure, keys: Timeline, surfaces: tuple[Surface, ...], notes: list[str], place: str
    ) -> None:
        self.figure, self.keys, self.surfaces, self.notes, self.place = figure, keys, surfaces, notes, place
        model = figure.model
        self.sites = [model.site(i).name for i in range(model.nsite)]
        self.points = site_points(figure, [s for s in self.sites if any(word in s.lower() for word in SOLES)])
        self.bends = tuple(_bends(figure))
        if not surfaces:
            notes.append("no static plane or box found: nothing to stay above")
        if not self.points:
            notes.append("no site named heel or toe found: no contact points")
        if not self.bends:
            notes.append("no knee, shin, elbow or forearm on a ball joint found: no limits on bending")

    def all(self, entries: list[PenaltyTable]) -> tuple[tuple[Penalty, float], ...]:
        chosen = {kind: PenaltyTable(kind=kind, weight=weight) for kind, weight in DEFAULT_WEIGHTS.items()}
        for entry in entries:
            if entry.kind not in KINDS:
                raise UserError(
                    f"{self.place}: {unknown('penalty', entry.kind, KINDS).replace('Penaltys', 'Penalties')}"
                )
            chosen[entry.kind] = entry
        return tuple((self.one(entry), entry.weight) for entry in chosen.values() if entry.weight > 0)

    def one(self, entry: PenaltyTable) -> Penalty:
        try:
            if entry.kind == "covariant":
                return CovariantAcceleration(entry.form or "intrinsic")
            if entry.kind == "unit":
                return UnitMagnitude(entry.form or "square")
        except ValueError as error:
            raise UserError(f"{self.place}: penalty '{entry.kind}': {error}") from None
        if entry.kind == "root":
            return RootAcceleration()
        if entry.kind == "torque":
            return Torque()
        if entry.kind == "clearance":
            return Contact(body_points(self.figure), self.surfaces, entry.margin or 0.0, name="clearance")
        if entry.kind == "planted":
            return Planted(stances(self.figure, self.keys, self.points, self.surfaces))
        if entry.kind == "contact":
            if entry.points is not None:
                self.points = self._sites(entry.points)
            return Contact(self.points, self.surfaces, entry.margin or 0.0)
        return self._bend(entry)

    def _sites(self, names: list[str]) -> tuple[Point, ...]:
        for name in names:
            if name not in self.sites:
                raise UserError(f"{self.place}: penalty 'contact': {unknown('site', name, self.sites)}")
        return site_points(self.figure, names)

    def _bend(self, entry: PenaltyTable) -> Penalty:
        if entry.joints is not None:
            known = {bend.name: bend for bend in self.bends}
            for name in entry.joints:
                if name not in known:
                    raise UserError(f"{self.place}: penalty 'bend': {unknown('joint', name, known)}")
            self.bends = tuple(known[name] for name in entry.joints)
        sideways, twist = entry.sideways or BEND_BOUND, entry.twist or BEND_BOUND
        least, sideways, twist = np.radians([entry.least or 0.0, sideways, twist])
        return BendLimits(self.bends, float(least), float(sideways), float(twist))


def _bends(figure: Figure) -> list[Bend]:
    """Ball joints that are knees or elbows by their own name or their body's, of a figure that faces x."""
    found = []
    for i, link in enumerate(figure.links[1:], start=1):
        names = f"{link.name} {figure.model.body(link.body).name}".lower()
        lateral = 1.0 if any(w in names for w in KNEES) else -1.0 if any(w in names for w in ELBOWS) else 0.0
        if lateral and link.kind is JointKind.BALL:
            long_axis = link.centre - link.anchor
            down = quat.rotated(link.turn, long_axis)
            down[1] = 0.0
            if np.linalg.norm(down) > 1e-6:
                axis = np.array([0.0, lateral, 0.0])
                found.append(Bend(link.name, i, axis, _principal(down)))
    return found


def _principal(direction: Array) -> Array:
    """The coordinate axis nearest to a direction: limbs hang along one at rest."""
    axis = np.zeros(3)
    axis[np.argmax(np.abs(direction))] = np.sign(direction[np.argmax(np.abs(direction))])
    return axis


def _from_mjcf(path: Path, fps: float | None) -> Clip:
    """An MJCF file whose <keyframe> elements, with their times, are the keyframes."""
    mjcf = _composed(str(path), path.name)
    model = mujoco.MjModel.from_xml_string(mjcf)
    if model.nkey == 0:
        raise UserError(f"{path.name}: the model has no <keyframe> elements to go through")
    return _plain(path.stem, mjcf, np.array(model.key_time), np.array(model.key_qpos), fps, path.name)


def _from_arrays(model: str, keys: Path, fps: float | None) -> Clip:
    """A figure and an .npz with time (K,) and qpos (K, nq), or key_time and key_qpos, which win."""
    try:
        with np.load(keys, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
    except FileNotFoundError:
        raise UserError(f"no file '{keys}'") from None
    except (OSError, ValueError, zipfile.BadZipFile, EOFError) as error:
        raise UserError(f"{keys.name}: not a readable .npz of arrays: {error}") from None
    names = ("key_time", "key_qpos") if {"key_time", "key_qpos"} <= arrays.keys() else ("time", "qpos")
    for name in names:
        if name not in arrays:
            raise UserError(f"{keys.name}: no array '{name}'; it holds: {', '.join(arrays) or 'nothing'}")
    time, qpos = (np.asarray(arrays[name], float) for name in names)
    return _plain(keys.stem, _composed(model, model), time, qpos, fps, keys.name)


def _composed(figure: str, place: str) -> str:
    try:
        return compose(figure_spec(figure))
    except UserError as error:
        raise UserError(str(error) if str(error).startswith(place) else f"{place}: {error}") from None


def _plain(name: str, mjcf: str, time: Array, qpos: Array, fps: float | None, place: str) -> Clip:
    """Whole keyframes from arrays, everything else by default."""
    figure = _figure(mjcf, "auto", place)
    if time.ndim != 1 or qpos.shape != (time.size, figure.width):
        raise UserError(
            f"{place}: time {time.shape} and qpos {qpos.shape} do not fit the figure: "
            f"they should be (K,) and (K, {figure.width})"
        )
    try:
        keys = [Frame.key(t, q) for t, q in zip(time, qpos, strict=True)]
    except TimelineError as error:
        raise UserError(f"{place}: {error}") from None
    return _clip(name, "", mjcf, figure, fps or 30.0, keys, [], SolveTable(), place)


def _spoken(error: ValidationError, raw: dict[str, Any]) -> str:
    """The first complaint of a validation, in the clip file's own words."""
    first = error.errors()[0]
    place, fields = _located(first["loc"], raw)
    where = f"{place}: " if place else ""
    key = _last_name(first["loc"])
    if first["type"] == "extra_forbidden":
        return where + unknown("key", key, fields)
    if first["type"] == "missing":
        return f"{where}'{key}' is missing"
    given = first.get("input")
    shown = f" (given: {given!r})" if not isinstance(given, dict) else ""
    return f"{where}{key}: {first['msg'][:1].lower()}{first['msg'][1:]}{shown}"


def _last_name(location: tuple[int | str, ...]) -> str:
    """The key of a location that a user would know: no type names of alternatives, no indices."""
    names = [str(part) for part in location if isinstance(part, str) and part.islower() and "[" not in part]
    plain = [name for name in names if name not in ("float", "free", "literal", "tuple")]
    return plain[-1] if plain else str(location[-1] if location else "clip")


def _located(location: tuple[int | str, ...], raw: dict[str, Any]) -> tuple[str, list[str]]:
    """Where in the clip file a complaint is, and which keys exist there."""
    schema: Any = ClipTable
    words: list[str] = []
    for i, part in enumerate(location[:-1]):
        if isinstance(part, int) and i and location[i - 1] in ("keyframe", "penalty"):
            entry = raw.get(str(location[i - 1]), [])[part]
            time = entry.get("time") if isinstance(entry, dict) else None
            words[-1] += f" {part + 1}" + (f" (t = {time:g} s)" if isinstance(time, int | float) else "")
        elif isinstance(part, str) and part in _TABLES:
            schema = _TABLES[part]
            words.append(part)
        elif isinstance(part, str) and part in ("RotationTable",):
            schema = RotationTable
        elif isinstance(part, str) and part.islower() and "[" not in part and part not in ("float", "free"):
            words.append(part)
    return ": ".join(words), list(schema.model_fields)


_TABLES: dict[str, type[_Table]] = {
    "keyframe": KeyframeTable,
    "penalty": PenaltyTable,
    "scene": SceneTable,
    "step": StepTable,
    "solve": SolveTable,
    "root": RootTable,
    "rotation": RotationTable,
}
