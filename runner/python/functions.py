"""The functions of the API: `build`, `load`, `inbetween`, `load_motion`, `import_motion`, and `Keyframe`."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import mujoco
import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure

from .. import motion as files
from .. import recordings, solving
from ..clip.build import Clip, CustomPenalties, with_custom_penalties
from ..clip.text import TomlTable, keyframe_tables, tables, text_of
from ..errors import UserError, words_of
from ..scene import file_access
from ..scene.compose import is_text, spec_of
from ..scene.configuration import first_wrong
from ..system.mujoco_warnings import as_python_warnings, quietly
from ..system.progress import Progress, silent
from ..system.quantity import positive
from .motion import Motion

Turn = Mapping[str, Any] | Rotation
Table = Mapping[str, Any]


@dataclass(frozen=True)
class Keyframe:
    """A keyframe, complete or partial. The arguments have the names of the clip file's keys.

    A rotation is {"rotvec": [x, y, z]} in degrees, {"euler": [...], "order": "xyz"} in degrees, {"quat": [w, x, y, z]},
    or a scipy Rotation. Euler angles are intrinsic, as in MuJoCo: "xyz" is SciPy's "XYZ". In the world, {"heading": 90}
    rotates the rest pose about the vertical axis, in degrees; with another key, it is applied last. The solver chooses
    values that are "free".

    Args:
        time: Time [s].
        root: {"position": [x, y, z], "rotation": ...} in the world, metres; each of x, y and z
            may be "free".
        joints: By name: a rotation relative to the parent (ball joint), degrees (hinge) or metres (slide), or "free".
        sites: By name of a site, geom, body or foot (`dynsplines new FIGURE` lists the feet): its target position
            [x, y, z] in the world, metres. Inverse kinematics computes one pose that meets all targets.
        bodies: By name: {"flat": True} (as level as in the rest pose, with any heading), a rotation in the world, or
            {"position": [x, y, z]} of the body's origin. With "at": [x, y, z], a point in the body's axes [m], it
            is the position of this point instead.
        roots: As `root`, for other free bodies, by the name of their free joint or body. This includes objects that
            `scene` adds.
        others: Unspecified joints and root: "free", "rest" (as in qpos0), "previous" (as in the keyframe before), or
            "key:NAME" (a <key> of the model). Limbs with a target in `sites` or `bodies` are still
            moved by inverse kinematics.
        qpos: (nq,) complete configuration in MuJoCo's order. Joints, roots, sites and bodies that are also specified
            replace its values; `others` then has no effect.

    Examples:
        >>> from dynsplines import Keyframe, build
        >>> rest = Keyframe(0.0, others="rest")
        >>> arm_forward = Keyframe(0.5, joints={"left_shoulder": {"rotvec": [0, -90, 0]}}, others="previous")
        >>> squat = Keyframe(1.0, root={"position": [0, 0, 0.7]})  # the solver chooses the joints
        >>> build("human", [rest, arm_forward, squat], name="exercise")
        <Clip exercise: 1.00 s, 3 keyframes (1 partial), 14 penalties, 39 DOF>
    """

    time: float
    root: Table = field(default_factory=dict)
    joints: Mapping[str, Turn | float | Literal["free"]] = field(default_factory=dict)
    sites: Mapping[str, ArrayLike | Table] = field(default_factory=dict)
    bodies: Mapping[str, Turn] = field(default_factory=dict)
    roots: Mapping[str, Table] = field(default_factory=dict)
    others: Literal["free", "rest", "previous"] | str = "free"
    qpos: ArrayLike | None = None


@as_python_warnings()
def build(
    figure: str | os.PathLike[str] | mujoco.MjSpec,
    keyframes: Sequence[Keyframe],
    *,
    name: str = "clip",
    fps: float = 30.0,
    scene: Table | None = None,
    contacts: Sequence[Table] = (),
    grasps: Sequence[Table] = (),
    penalties: Mapping[str, float | Table] | None = None,
    solve: Table | None = None,
    recording: Table | None = None,
    mirror: Table | None = None,
    custom_penalties: CustomPenalties = (),
    allow_outside: bool = False,
) -> Clip:
    """Build a clip from keyframes.

    Args:
        figure: Name of a shipped figure (see `figures()`), path of an MJCF or URDF file, MJCF text, or an
            MjSpec.
        keyframes: Two or more, in order of time.
        name: Name of the clip and of output files.
        fps: Samples per second [1/s] of outputs.
        scene: The clip file's [scene]: {"step": {"x": 0.3, "height": 0.27}, "box": [{...}, ...]}.
        contacts: The clip file's [[contact]] tables: {"point": "right_heel", "from": 0.0, "to": 0.8}, times in s.
        grasps: The clip file's [[grasp]] tables: {"hand": "left_hand", "body": "crate", "from": 1.2, "to": 2.8}, times
            in s.
        penalties: Changes of the default soft constraints: {"torque": 0.1, "collision": {"weight": 100, "margin":
            0.002}}.
        solve: The clip file's [solve] table: {"ends": "clamped"} starts and ends the motion at rest, {"ends":
            "periodic"} makes it a loop, {"ends": "mirrored"} completes half a gait cycle.
        recording: The clip file's [recording] table: {"file": "walk.npz"}. The path is relative to the
            current folder. The motion then follows the recording, except near keyframes.
        mirror: The clip file's [mirror] table: {"pairs": [["joint1", "joint4"]]}, for joints without left and right in
            their names.
        custom_penalties: Custom soft constraints with their weights, [(Calm(), 0.1)]; files do not store them.
        allow_outside: Let the figure's model read files outside its folder.

    Returns:
        The clip, for `inbetween`.

    Raises:
        UserError: Entries do not fit the figure. The message is one line that names the keyframe and the argument.

    Examples:
        >>> from dynsplines import Keyframe, build, inbetween
        >>> pendulum = '''
        ... <mujoco><worldbody><body name="rod" pos="0 0 1"><joint name="hinge" axis="0 1 0"/>
        ...   <geom type="capsule" size=".02" fromto="0 0 0 0 0 -.5"/></body></worldbody></mujoco>'''
        >>> keys = [Keyframe(0.0, joints={"hinge": -40}), Keyframe(0.5, joints={"hinge": 40})]  # degrees
        >>> clip = build(pendulum, keys, name="swing", penalties={"torque": 0.1}, solve={"ends": "free"})
        >>> print(clip)
        <Clip swing: 0.50 s, 2 keyframes, 5 penalties, 1 DOF>
        >>> inbetween(clip).at([0.0, 0.5]).round(3).tolist()  # radians
        [[-0.698], [0.698]]
    """
    with file_access.allow(allow_outside):
        spec, called = spec_of(figure)
        posed = _figure(spec, called) if any(key.qpos is not None for key in keyframes) else None
        raw: TomlTable = {"figure": called, "fps": float(fps)}
        rows = [_penalty(*entry) for entry in (penalties or {}).items()]
        more = {"scene": scene, "solve": solve, "recording": recording, "mirror": mirror}
        more |= {"contact": list(contacts), "grasp": list(grasps), "penalty": rows}
        raw |= {key: _plain(value) for key, value in more.items() if value}
        raw |= {"keyframe": [_table(key, posed) for key in keyframes]}
        return with_custom_penalties(
            recordings.from_text(text_of(raw), name=name, where=name, spec=spec), custom_penalties
        )


@as_python_warnings()
def load(
    source: str | os.PathLike[str],
    *,
    fps: float | None = None,
    custom_penalties: CustomPenalties = (),
    allow_outside: bool = False,
) -> Clip:
    """Load a clip.

    Args:
        source: Name of a shipped clip (see `clips()`), path of a .toml file, or TOML text. A string with a line
            break is taken as text, not as a path.
        fps: Samples per second [1/s] of outputs, instead of the clip's.
        custom_penalties: Custom soft constraints with their weights, [(Calm(), 0.1)]; files do not store them.
        allow_outside: Let the model read files outside its folder.

    Returns:
        The clip, for `inbetween`.

    Raises:
        UserError: For an invalid clip. The message is one line that names the file, the keyframe and the key.

    Examples:
        >>> from dynsplines import load
        >>> load("tumble")
        <Clip tumble: 3.00 s, 7 keyframes, 5 penalties, 6 DOF>
        >>> load('''
        ... figure = "spinner"
        ... keyframe = [{time = 0, others = "rest"}, {time = 1, others = "rest", root.position = [0.5, 0, 1]}]
        ... ''')
        <Clip clip: 1.00 s, 2 keyframes, 5 penalties, 6 DOF>
    """
    if not isinstance(source, str | os.PathLike):
        raise UserError(
            f"a clip is a name, a path or text, not of type {type(source).__name__}; build makes one of a model"
        )
    source = str(os.fspath(source))
    fps = None if fps is None else positive(fps, "fps =")
    if files.is_motion(source) and "\n" not in source:
        raise UserError(f"'{source}' is a motion, solved already; load_motion opens it")
    with file_access.allow(allow_outside):
        if is_text(source):
            raise UserError("MJCF text is a figure, not a clip; build makes a clip of it and keyframes")
        if "\n" in source:
            clip = recordings.from_text(source, name="clip", where="clip", fps=fps)
        else:
            clip = recordings.load(source, fps=fps)
        return with_custom_penalties(clip, custom_penalties)


@as_python_warnings()
def inbetween(clip: Clip | str | os.PathLike[str], *, progress: bool = False) -> Motion:
    """Compute smooth motion through a clip's keyframes that minimises the violation of its soft constraints.

    Ctrl-C, or a notebook's interrupt, stops the search and returns the best motion so far; every iterate meets the
    keyframes.

    Args:
        clip: A clip, or an argument of `load`: a shipped name, a path, or TOML text.
        progress: Print progress on stderr.

    Returns:
        The motion.

    Raises:
        UserError: For an invalid clip.

    Examples:
        >>> from dynsplines import inbetween, load
        >>> inbetween(load("tumble"))
        <Motion tumble: 3.00 s, 7 keyframes, 15 variable frames, 6 DOF>
    """
    heard = Progress() if progress else silent()
    problem = clip if isinstance(clip, Clip) else load(clip)
    return Motion(solving.solve(problem, heard), problem)


@as_python_warnings()
def load_motion(source: str | os.PathLike[str]) -> Motion:
    """Load a motion.

    Args:
        source: A motion file (.npz) of `Motion.save` or `dynsplines solve`.

    Returns:
        The motion.

    Raises:
        UserError: For any other file.

    Examples:
        >>> from dynsplines import inbetween, load_motion
        >>> load_motion(inbetween("tumble").save("tumble.npz"))
        <Motion tumble: 3.00 s, 7 keyframes, 15 variable frames, 6 DOF>
    """
    if not files.is_motion(os.fspath(source)):
        raise UserError(f"'{source}': a motion is an .npz file; load opens a clip, import_motion a recording")
    return Motion(files.load(Path(source)))


@as_python_warnings()
def import_motion(
    source: str | os.PathLike[str],
    figure: str | os.PathLike[str] | None = None,
    *,
    format: str | None = None,
    fps: float | None = None,
    scale: float | None = None,
    allow_outside: bool = False,
) -> Motion:
    """Import a recording of another program. Every sample becomes a keyframe; there is no search.

    Args:
        source: The recording.
        figure: Name of a shipped figure, or path of an MJCF file, if the recording contains no figure.
        format: Name of the format (see `dynsplines formats`), if the file's extension is ambiguous.
        fps: Samples per second [1/s], if the file has no rate.
        scale: Unit of length of the file [m], instead of the inferred one.
        allow_outside: Let the figure's model read files outside its folder.

    Returns:
        The motion.

    Raises:
        UserError: For an invalid file, or one that does not fit the figure. The message is one line.

    Examples:
        >>> from dynsplines import import_motion, inbetween
        >>> table = inbetween("tumble").export("table.csv", fps=60)
        >>> import_motion(table, figure="spinner")
        <Motion table: 3.00 s, 181 keyframes, 6 DOF>
    """
    from ..exchange.motion_import import import_recording

    if figure is not None and not isinstance(figure, str | os.PathLike):
        raise UserError(f"figure is a name or a path to MJCF, not of type {type(figure).__name__}")
    figure = None if figure is None else str(os.fspath(figure))
    with file_access.allow(allow_outside):
        return Motion(import_recording(Path(source), format, figure=figure, fps=fps, scale=scale))


def _figure(spec: mujoco.MjSpec, name: str) -> Figure:
    try:
        with quietly():
            return Figure(spec.copy().compile())
    except ValueError as error:
        raise UserError(f"{name}: {words_of(error)}") from None


def _table(key: Keyframe, figure: Figure | None) -> TomlTable:
    """Return a keyframe as a table of a clip's file; `figure` is needed for qpos."""
    entries = {"root": key.root, "joints": key.joints, "sites": key.sites, "bodies": key.bodies, "roots": key.roots}
    out: TomlTable = {"time": _plain(key.time)}
    out |= {name: _plain(value) for name, value in entries.items() if value}
    if key.others != "free":
        out["others"] = key.others
    if key.qpos is None or figure is None:
        return out
    qpos = np.asarray(key.qpos, float)
    where = f"keyframe (t = {key.time} s): qpos"
    if qpos.shape != (figure.width,):
        raise UserError(f"{where} is ({figure.width},) of finite numbers; it is {qpos.shape}")
    if wrong := first_wrong(figure.model, np.zeros(1), qpos[None]):
        raise UserError(f"{where}: {wrong[1]}; give finite numbers, and quaternions as w, x, y, z")
    whole = tables(keyframe_tables(figure, [Frame.key(0.0, qpos)])[0])
    return (
        whole
        | out
        | {name: whole.get(name, {}) | out.get(name, {}) for name in ("root", "joints")}
        | _roots(whole, out)
    )


def _roots(entries: TomlTable, table: TomlTable) -> TomlTable:
    """Return the configuration's entries for further free bodies, overridden by those of the table."""
    mine, theirs = entries.get("roots", {}), table.get("roots", {})
    names = list(dict.fromkeys([*mine, *theirs]))
    return {"roots": {name: mine.get(name, {}) | theirs.get(name, {}) for name in names}} if names else {}


def _penalty(kind: str, table: float | Table) -> TomlTable:
    return {"kind": kind} | (dict(table) if isinstance(table, Mapping) else {"weight": float(table)})


def _plain(value: Any) -> Any:
    """Return arrays, NumPy's numbers and SciPy's rotations as values of TOML."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, Rotation):
        return {"quat": value.as_quat(scalar_first=True).tolist()}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value
