"""NPZ of plain arrays for MuJoCo, sufficient for playback.

fps (), time (T,) [s]            time[i] = time[0] + i / fps
qpos (T, nq), qvel, qacc (T, nv) MuJoCo's order and units; quaternions wxyz, unit and sign-continuous
joint_names (njnt,), body_names (nbody,)
mjcf ()                          the whole scene: mujoco.MjModel.from_xml_string(str(numpy.load(FILE)["mjcf"]))

On import, `qpos` and `time` or `fps` are read, and `mjcf` where the user names no figure. `joint_names` must be the
figure's if present. Body poses `xpos`, `xquat` verify qpos.
"""

from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np

from ...errors import EXPORT_SKELETON, GIVE_FIGURE, GIVE_RATE, UserError
from ...motion import Sampled, asset_arrays, assets_in, write_arrays
from ...scene.assets import Scene
from ...scene.compose import compile_model
from ...scene.configuration import unlike_joints
from .. import layouts
from ..array_reader import names_in, read_npz, times
from ..recording import Recording
from ..robot import needs_figure


def write(sampled: Sampled, path: Path) -> None:
    """Write all arrays in double precision."""
    model = sampled.model
    arrays = {
        "fps": sampled.fps,
        "time": sampled.time,
        "qpos": sampled.qpos,
        "qvel": sampled.qvel,
        "qacc": sampled.qacc,
        "joint_names": np.array([model.joint(i).name for i in range(model.njnt)]),
        "body_names": np.array([model.body(i).name for i in range(model.nbody)]),
        "mjcf": np.array(sampled.motion.mjcf),
        **asset_arrays(sampled.motion.scene),
    }
    write_arrays(path, arrays)


def recognises(path: Path) -> bool:
    """Return whether an .npz is of this format."""
    return "qpos" in names_in(path) and "split_points" not in names_in(path)


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the arrays; raises UserError for missing ones, other shapes, or another figure."""
    arrays = read_npz(path)
    if model is None and "mjcf" not in arrays:
        raise UserError(f"{path}: it has no 'mjcf', the figure; {GIVE_FIGURE}")
    try:
        assets = assets_in(arrays.entries)
        scene = Scene.receive(str(arrays.of("mjcf")), assets) if model is None else None
    except (ValueError, KeyError) as error:
        raise UserError(f"{path}: the files of its figure: {error}") from None
    figure = compile_model(scene, path) if scene is not None else needs_figure(model, path)
    if "joint_names" in arrays and (differ := unlike_joints(figure, arrays.texts("joint_names"))):
        raise UserError(f"{path}: {differ}; {EXPORT_SKELETON}")
    qpos = arrays.numbers("qpos", "samples", figure.nq)
    rate = arrays.rate("fps") if "fps" in arrays else fps
    if rate is None and "time" not in arrays:
        raise UserError(f"{path}: it has neither 'time' nor 'fps'; {GIVE_RATE}")
    time = arrays.numbers("time", "samples") if rate is None or "time" in arrays else times(len(qpos), rate)
    if "mjcf" in arrays:  # written by this program
        return Recording(time, qpos, scene, rate)
    return layouts.recording(figure, path, time, qpos, layouts.body_poses(arrays), scalar_last=False, fps=rate)
