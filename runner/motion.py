"""MOTION.npz: a solved clip as plain arrays, without pickles, with everything that `report`, `plot` and `render` need.

fps, time (T,)                      time[i] = t0 + i / fps
qpos (T, nq), qvel, qacc (T, nv)    MuJoCo's conventions; unit quaternions of continuous sign
raw_qpos, raw_qvel, raw_qacc        the same of the raw spline
key_time (K,), key_qpos (K, nq), key_fixed and key_posed (K, nq)
frame_time (M,), frame_state (M, N), frame_fixed (M, N), end_slope (2, N), and raw_* of the same
asset_names (A,), asset_0 … (B,) uint8  the files to which the model refers, by name, if any
joint_names, body_names, mjcf, clip, trace, search, report, name, coordinates, ends, format_version

report is {} until the motion is measured. search contains data that cannot be computed later, such as the stop reason.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import SAMPLES_AT_ONCE, Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import Path as Curve
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import velocities
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.tolerances import ROUNDING, SINGLE

from .errors import UserError, import_first, words_of
from .scene.assets import Scene
from .system import size_limit
from .system.output import Replacement
from .system.quantity import LARGEST

FORMAT_VERSION = 2  # 1: without assets
RATE = 240.0  # [1/s] of the samples at which motions are measured: a foot at 4 m/s moves 17 mm between two
RESAMPLED = 120.0  # [1/s] least rate of samples that stand for a motion: as a recording, for thinning, in curves
MOST_SAMPLES = 1_000_000  # maximum number of samples of a motion
PLACES = ("qpos", "frame_state", "time")  # endings of names of arrays that `LARGEST` limits
NEEDED = (
    "format_version", "fps", "time", "qpos", "qvel", "qacc", "raw_qpos", "raw_qvel", "raw_qacc", "key_time", "key_qpos",
    "key_fixed", "frame_time", "frame_state", "frame_fixed", "end_slope", "raw_frame_time", "raw_frame_state",
    "raw_frame_fixed", "raw_end_slope", "mjcf", "clip", "trace", "report", "name", "coordinates", "ends",
)  # fmt: skip
Arrays = dict[str, np.ndarray]  # by name
TEXTS = ("mjcf", "clip", "trace", "report", "name", "coordinates", "ends")


@dataclass(frozen=True)
class Saved:
    """A solved clip: both timelines, the figure, and its measurements.

    Attributes:
        text: The clip's text, or "".
        fps: Samples per second [1/s].
        trace: The evaluations that lowered E.
        report: The measurements; empty before they are made.
        search: Data of the search that cannot be measured later: "evaluations", "seconds", "stop" and "stopped
            because", the reason by name and in words, "stances", "custom penalties". Without a search, it is empty or
            has "stopped because" alone.
    """

    name: str
    text: str
    scene: Scene
    figure: Figure
    fps: float
    keys: tuple[Frame, ...]
    timeline: Timeline
    raw: Timeline
    trace: list[Any]
    report: dict[str, Any]
    search: dict[str, Any] = field(default_factory=dict)

    @property
    def mjcf(self) -> str:
        """The complete MJCF text."""
        return self.scene.mjcf

    @property
    def path(self) -> Curve:
        """The spline through all frames."""
        return path_of(self.timeline)

    @property
    def before(self) -> Saved:
        """The raw spline through the same keyframes."""
        return replace(self, timeline=self.raw, trace=[], report={}, search={})

    @property
    def stop(self) -> Stop:
        """Why the search ended."""
        return Stop.__members__.get(str(self.search.get("stop")), Stop.CONVERGED)

    @property
    def evaluations(self) -> int:
        """The number of evaluations of the search."""
        return int(self.search.get("evaluations", 0))

    @property
    def is_raw(self) -> bool:
        """Whether no search took place and the timeline is the raw spline, as for a recording."""
        pairs = [(line.times, line.states, line.end_slope) for line in (self.raw, self.timeline)]
        return not self.evaluations and all(map(np.array_equal, *pairs))

    def at(self, times: ArrayLike) -> Array:
        """Return configurations (S, nq) at times (S,) [s], with unit quaternions."""
        return self.figure.to_qpos(self.path.at(np.atleast_1d(np.asarray(times, float))))


@dataclass(frozen=True)
class Sampled:
    """A motion at equal time steps or given times, in MuJoCo's order, units and axes.

    Attributes:
        motion: The motion.
        fps: Samples per second [1/s]; nan at given times.
        time: Times (T,) [s].
        qpos: Configurations (T, nq), with unit quaternions wxyz of continuous sign.
        qvel: Velocities (T, nv).
        qacc: Accelerations (T, nv).
    """

    motion: Saved
    fps: float
    time: Array
    qpos: Array
    qvel: Array
    qacc: Array

    @classmethod
    def of(cls, motion: Saved, fps: float | None = None) -> Sampled:
        """Return a motion at t0 + i / fps, i = 0 … floor(duration · fps), by default at its own rate."""
        rate, (first, last) = motion.fps if fps is None else fps, motion.path.span
        return cls.at(motion, first + np.arange(sample_count(last - first, rate)) / rate, rate)

    @classmethod
    def at(cls, motion: Saved, time: Array, fps: float = np.nan) -> Sampled:
        """Return a motion at times (T,) [s]."""
        figure, chunks = motion.figure, [_configurations(s) for s in sample_runs(motion.figure, motion.path, time)]
        qpos, qvel, qacc = (np.concatenate(rows) for rows in zip(*chunks, strict=True))
        return cls(motion, fps, time, continuous(figure, qpos), qvel, qacc)

    @property
    def phase(self) -> Array:
        """The share (T,) of the motion, or of a loop's period, that has passed, from 0 to 1."""
        first, last = self.motion.path.span
        return (self.time - first) / (last - first)

    @property
    def figure(self) -> Figure:
        """The figure: a MuJoCo model as a tree of links."""
        return self.motion.figure

    @property
    def model(self) -> mujoco.MjModel:
        """The figure in its scene, as a compiled model."""
        return self.motion.figure.model

    @property
    def name(self) -> str:
        """The name of the motion."""
        return self.motion.name

    @cached_property
    def bodies(self) -> Bodies:
        """Positions, orientations and velocities of all bodies."""
        return Bodies.of(self.model, self.qpos, self.qvel)


@dataclass(frozen=True)
class Bodies:
    """The motion of all body frames in world axes; the first body is the world.

    Attributes:
        position: Positions (T, nbody, 3) [m].
        rotation: Orientations (T, nbody, 4), wxyz and sign-continuous.
        velocity: Velocities (T, nbody, 3) of the origins [m/s].
        spin: Angular velocities (T, nbody, 3) [rad/s].
    """

    position: Array
    rotation: Array
    velocity: Array
    spin: Array

    @classmethod
    def of(cls, model: mujoco.MjModel, qpos: Array, qvel: Array) -> Bodies:
        """Return the motion of the bodies, by MuJoCo's kinematics of every sample."""
        data = mujoco.MjData(model)
        position, rotation, velocity, spin = (np.zeros((len(qpos), model.nbody, width)) for width in (3, 4, 3, 3))
        for i in range(len(qpos)):
            data.qpos, data.qvel = qpos[i], qvel[i]
            mujoco.mj_fwdPosition(model, data)
            mujoco.mj_fwdVelocity(model, data)
            position[i], rotation[i], spin[i] = data.xpos, data.xquat, data.cvel[:, :3]
            offset = data.xpos - data.subtree_com[model.body_rootid]  # from the point that cvel refers to
            velocity[i] = data.cvel[:, 3:] + np.cross(spin[i], offset)
        return cls(position, quat.align_signs(rotation), velocity, spin)


def _configurations(samples: Samples) -> tuple[Array, Array, Array]:
    """Return qpos, qvel and qacc of a chunk of samples."""
    return samples.figure.to_qpos(samples.y), *velocities(samples)


def sample_count(duration: float, fps: float) -> int:
    """Return floor(duration · fps) + 1. Raises UserError for too many samples."""
    count = int(np.floor(duration * fps + ROUNDING)) + 1
    if count > MOST_SAMPLES:
        raise UserError(f"{duration:g} s at {fps:g} samples a second are over {MOST_SAMPLES:,}; lower the rate")
    return count


def even_times(span: tuple[float, float], rate: float) -> Array:
    """Return equally spaced times (T,) [s] from the first to the last of a span, at about a rate [1/s]."""
    first, last = span
    return np.linspace(first, last, max(2, round((last - first) * rate) + 1))


def samples_at(figure: Figure, path: Curve, time: Array) -> Samples:
    """Return the figure's motion along a path."""
    return Samples(figure, *path.motion(time), t=time)


def sample_runs(figure: Figure, path: Curve, time: Array) -> Iterator[Samples]:
    """Yield the same in runs of consecutive times (T,) [s]."""
    for first in range(0, time.size, SAMPLES_AT_ONCE):
        yield samples_at(figure, path, time[first : first + SAMPLES_AT_ONCE])


def continuous(figure: Figure, qpos: Array) -> Array:
    """Return qpos (T, nq) with every quaternion on its predecessor's hemisphere."""
    out = qpos.copy()
    for columns in figure.tables.quaternion_columns.T:
        out[:, columns] = quat.align_signs(out[:, columns])
    return out


def save(saved: Saved, target: Path) -> None:
    """Write MOTION.npz atomically."""
    figure, model = saved.figure, saved.figure.model
    after, raw = Sampled.of(saved), Sampled.of(saved.before)
    key_time = np.array([key.time for key in saved.keys])
    arrays = {
        "format_version": FORMAT_VERSION,
        "fps": saved.fps,
        "time": after.time,
        "qpos": after.qpos,
        "qvel": after.qvel,
        "qacc": after.qacc,
        "raw_qpos": raw.qpos,
        "raw_qvel": raw.qvel,
        "raw_qacc": raw.qacc,
        "key_time": key_time,
        "key_qpos": saved.at(key_time),
        "key_fixed": np.array([key.fixed for key in saved.keys]),
        "key_posed": np.array([key.known & ~key.fixed for key in saved.keys]),
        "joint_names": np.array([model.joint(i).name for i in range(model.njnt)]),
        "body_names": np.array([model.body(i).name for i in range(model.nbody)]),
        "mjcf": saved.mjcf,
        "clip": saved.text,
        "trace": json.dumps(saved.trace),
        "search": json.dumps(_timeless(saved.search)),
        "report": json.dumps(_timeless(saved.report)),
        "name": saved.name,
        "coordinates": figure.coordinates,
        "ends": saved.timeline.ends,
    }
    for prefix, timeline in (("", saved.timeline), ("raw_", saved.raw)):
        arrays[f"{prefix}frame_time"] = timeline.times
        arrays[f"{prefix}frame_state"] = timeline.states
        arrays[f"{prefix}frame_fixed"] = timeline.fixed
        arrays[f"{prefix}end_slope"] = timeline.end_slope
    arrays.update(asset_arrays(saved.scene))
    with Replacement(target) as temporary:
        write_arrays(temporary, arrays)


def _timeless(entries: Mapping[str, object]) -> dict[str, object]:
    """Return the entries without the duration of the search, so that the same command writes the same bytes."""
    return {name: value for name, value in entries.items() if name != "seconds"}


def write_arrays(target: Path, arrays: Mapping[str, Any]) -> None:
    """Write an .npz of plain arrays by name. Raises TypeError for objects, which would be pickled.

    It does not use `allow_pickle`, which exists since NumPy 2.1; older versions would store it as an array.
    """
    plain: dict[str, Any] = {name: np.asarray(array) for name, array in arrays.items()}
    pickled = [name for name, array in plain.items() if array.dtype.hasobject]
    if pickled:
        raise TypeError(f"'{pickled[0]}' holds objects")
    with target.open("wb") as stream:
        np.savez_compressed(stream, **plain)


def asset_arrays(scene: Scene) -> Arrays:
    """Return the files to which a scene refers, as arrays by name."""
    if not scene.assets:
        return {}
    files = {f"asset_{i}": np.frombuffer(data, np.uint8) for i, data in enumerate(scene.assets.values())}
    return {"asset_names": np.array(list(scene.assets)), **files}


def assets_in(data: Mapping[str, np.ndarray]) -> dict[str, bytes]:
    """Return the files by name. Raises ValueError."""
    names = data.get("asset_names", np.array([], str))
    if names.ndim != 1 or names.dtype.kind != "U":
        raise ValueError("'asset_names' is not a list of names")
    files = [data[f"asset_{i}"] for i in range(names.size)]
    if any(file.dtype != np.uint8 for file in files):
        raise ValueError("an asset is not of bytes")
    return {str(name): file.tobytes() for name, file in zip(names, files, strict=True)}


def is_motion(source: str) -> bool:
    """Return whether a command's argument names a motion file, not a clip."""
    return Path(source).suffix.lower() == ".npz"


def load(source: Path) -> Saved:
    """Return a motion from MOTION.npz. Raises UserError if it is missing, damaged, or another kind of file."""
    data = read_arrays(source)
    missing = [name for name in NEEDED if name not in data]
    if missing:
        raise UserError(f"{source}: not a motion of dynsplines: it has no '{missing[0]}'; {import_first(source)}")
    for name in NEEDED:
        if data[name].dtype.kind not in ("U" if name in TEXTS else "fiub"):
            raise UserError(f"{source}: not a motion of dynsplines: '{name}' holds {data[name].dtype.name}")
    version = data["format_version"]
    if version.shape != () or version.dtype.kind not in "iu" or data["fps"].shape != ():
        raise UserError(f"{source}: not a motion of dynsplines: its format_version or fps is not a single number")
    if not 1 <= int(version) <= FORMAT_VERSION:
        raise UserError(f"{source}: format {int(version)} is not this program's {FORMAT_VERSION}; is it newer?")
    try:
        saved = _restore(data)
        _check(saved, data)
        # free entries of keyframes are as before the search, because the places of grasps depend on them
        before = saved.figure.to_qpos(path_of(saved.raw).at(data["key_time"]))
        keys = tuple(replace(key, state=qpos) for key, qpos in zip(saved.keys, before, strict=True))
        saved = replace(saved, keys=keys)
    except (ValueError, KeyError, IndexError, TypeError, RecursionError) as error:
        raise UserError(f"{source}: its arrays do not fit together: {words_of(error)}") from None
    return saved


def read_arrays(source: Path) -> Arrays:
    """Return the arrays of an .npz by name. Raises UserError if it is missing, damaged, or contains anything else."""
    arrays: Arrays = {}
    for name, entry in read_entries(source).items():
        if entry is None:
            raise UserError(f"{source}: it holds pickled objects, which are never loaded")
        if not isinstance(entry, np.ndarray):
            raise UserError(f"{source}: '{name}' in it is not an array")
        arrays[name] = entry
    return arrays


def read_entries(source: Path) -> dict[str, np.ndarray | bytes | None]:
    """Return the entries of an .npz by name: arrays, other data, and None for pickled objects, which are never loaded.

    Raises UserError if the file is missing or damaged.
    """
    size_limit.check_file(source)
    with source.open("rb") as stream:
        if not zipfile.is_zipfile(stream):
            raise UserError(f"{source}: not an .npz file, or cut short")
        stream.seek(0)
        try:
            size_limit.check_archive(stream, source)
            with np.load(stream, allow_pickle=False) as archive:
                return {name: _read_entry(archive, name) for name in archive.files}
        except UserError:
            raise
        except Exception as error:  # a damaged zip may raise any exception
            raise UserError(f"{source}: not a readable .npz file: {words_of(error)}") from None


def _read_entry(archive: Any, name: str) -> Any:
    try:
        return archive[name]
    except ValueError as error:
        if "allow_pickle" in str(error):
            return None
        raise


def _check(saved: Saved, data: Arrays) -> None:
    """Raise ValueError if a motion's parts contradict each other, as in a file from elsewhere or edited by hand."""
    model, times, keys = saved.figure.model, data["time"].size, data["key_time"].size
    shapes = {"time": (times,), "key_time": (keys,)}
    shapes |= {f"{prefix}qpos": (times, model.nq) for prefix in ("", "raw_")}
    shapes |= {f"{prefix}{part}": (times, model.nv) for prefix in ("", "raw_") for part in ("qvel", "qacc")}
    optional = {"key_qpos", "key_fixed", "key_posed"} & data.keys()  # older files have no "key_posed"
    shapes |= dict.fromkeys(sorted(optional), (keys, model.nq))
    _check_arrays(data, shapes)
    if not saved.fps > 0:
        raise ValueError(f"fps is {saved.fps:g}")
    for timeline in (saved.timeline, saved.raw):
        _check_timeline(saved.figure, timeline)
        if not all(np.any(np.abs(timeline.times - key.time) < ROUNDING) for key in saved.keys):
            raise ValueError("a keyframe has no frame")
    if not (isinstance(saved.trace, list) and isinstance(saved.report, dict) and isinstance(saved.search, dict)):
        raise ValueError("trace, report and search are not a list and two tables")


def _check_timeline(figure: Figure, timeline: Timeline) -> None:
    """Raise ValueError for frames of another figure, and for quaternions of length zero."""
    if timeline.width != figure.width:
        raise ValueError(f"frames of {timeline.width} entries, the model has {figure.width}")
    for columns in figure.tables.quaternion_columns.T:
        if np.any(np.linalg.norm(timeline.states[:, columns], axis=1) < SINGLE):
            raise ValueError("a frame has a quaternion that is zero")


def _check_arrays(data: Arrays, shapes: Mapping[str, tuple[int, ...]]) -> None:
    """Raise ValueError for arrays of other shapes, and for entries that are not finite or too large."""
    for name, shape in shapes.items():
        if data[name].shape != shape:
            raise ValueError(f"'{name}' is {data[name].shape}, not {shape}")
    for name, array in data.items():
        if array.dtype.kind == "f" and not np.all(np.isfinite(array)):
            raise ValueError(f"'{name}' holds entries that are not finite numbers")
        if name.endswith(PLACES) and not np.all(np.abs(array) <= LARGEST):
            raise ValueError(f"'{name}' holds an entry that is too large")


def _restore(data: Arrays) -> Saved:
    scene = Scene.receive(str(data["mjcf"]), assets_in(data))
    figure = Figure(scene.model(), str(data["coordinates"]))
    ends = str(data["ends"])
    timelines = []
    for prefix in ("", "raw_"):
        rows = zip(*(data[f"{prefix}frame_{part}"] for part in ("time", "state", "fixed")), strict=True)
        timelines.append(Timeline(tuple(Frame(*row) for row in rows), data[f"{prefix}end_slope"], ends))
    posed = data.get("key_posed", np.zeros_like(data["key_fixed"]))
    key_rows = zip(data["key_time"], data["key_qpos"], data["key_fixed"], posed, strict=True)
    keys = tuple(Frame(*row) for row in key_rows)
    return Saved(
        name=str(data["name"]),
        text=str(data["clip"]),
        scene=scene,
        figure=figure,
        fps=float(data["fps"]),
        keys=keys,
        timeline=timelines[0],
        raw=timelines[1],
        trace=json.loads(str(data["trace"])),
        report=_current(json.loads(str(data["report"]))),
        search=json.loads(str(data.get("search", "{}"))),
    )


def _current(report: Any) -> Any:
    """Return a stored report, empty if it is of an older version, so that the motion is measured again."""
    after = report.get("after") if isinstance(report, dict) else None
    return {} if isinstance(report, dict) and not (isinstance(after, dict) and "largest" in after) else report
