"""Exported scenes to simulate: written from a motion, and played by `mj_step` with `ctrl` interpolated between keys."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.exchange import formats
from dynsplines.motion import Saved
from dynsplines.solver.array import Array


@dataclass(frozen=True)
class Played:
    """A simulated scene.

    data     the state at the end
    last     (nv,) [m, rad] from the keys to the state at the end; quaternions of keys are interpolated linearly
    worst    (nv,) [m, rad] the largest size of that on the way
    deepest  [m] of a contact on the way
    """

    data: mujoco.MjData
    last: Array
    worst: Array
    deepest: float


def clip_file(folder: Path, figure: Path, *keyframes: str) -> Path:
    """A clip of a figure, of the lines of its keyframes."""
    blocks = "".join(f"[[keyframe]]\n{lines}\n" for lines in keyframes)
    (folder / "clip.toml").write_text(f'figure = "{figure}"\n{blocks}')
    return folder / "clip.toml"


def exported(saved: Saved, folder: Path) -> tuple[mujoco.MjModel, list[str]]:
    """The scene of a motion, as folder/out.simulate.xml has it, and the notes of its export."""
    notes: list[str] = []
    path = folder / "out.simulate.xml"
    formats.export(saved, formats.chosen(None, path).name, path, report=notes.append)
    return mujoco.MjModel.from_xml_path(str(path)), notes


def between(model: mujoco.MjModel, rows: Array, time: float) -> Array:
    """Rows of a model's keys at a time between them."""
    return np.array([np.interp(time, model.key_time, column) for column in rows.T])


def played(model: mujoco.MjModel, duration: float = np.inf) -> Played:
    """The scene after some time [s] from its first key, or at its last; without numbers if MuJoCo gives up."""
    data, away, worst, deepest = mujoco.MjData(model), np.zeros(model.nv), np.zeros(model.nv), 0.0
    mujoco.mj_resetDataKeyframe(model, data, 0)
    end = min(model.key_time[-1], model.key_time[0] + duration)
    while data.time < end:
        before = data.time
        data.ctrl = between(model, model.key_ctrl, before)
        mujoco.mj_step(model, data)
        if data.time <= before:
            return Played(data, np.full(model.nv, np.inf), np.full(model.nv, np.inf), deepest)
        qpos = between(model, model.key_qpos, data.time)
        mujoco.mj_normalizeQuat(model, qpos)
        mujoco.mj_differentiatePos(model, away, 1, qpos, data.qpos)
        worst = np.maximum(worst, np.abs(away))
        deepest = max([deepest, *(-contact.dist for contact in data.contact)])
    return Played(data, away, worst, deepest)
