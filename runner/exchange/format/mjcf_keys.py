"""MJCF with <keyframe>: figure and scene, and a <key> with time, qpos and qvel for every sample.

`mujoco.MjModel.from_xml_path` reads it; `model.key_time`, `key_qpos` and `key_qvel` are the motion, and MuJoCo's
viewer shows one key after another. A key is named after the motion and its index, as keys need unique names. Every
number has the digits that reproduce it exactly, unlike those of MuJoCo's writer. On import, the motion is the model's
keys with their times; keys without times are single poses and no motion.
"""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import mujoco
import numpy as np

from dynsplines.solver.array import Array

from ...errors import UserError
from ...motion import Sampled
from ...scene.assets import Scene, taken_along
from ...scene.compose import compile_model, figure_spec
from ...scene.mujoco_versions import portable_text, remove
from ..array_reader import ArrayReader
from ..recording import Recording


def write(sampled: Sampled, path: Path) -> None:
    """Append keys to the model."""
    write_keys(ElementTree.fromstring(sampled.motion.mjcf), sampled, path)


def write_keys(root: ElementTree.Element, sampled: Sampled, path: Path, control: Array | None = None) -> None:
    """Write a model with keys in place of its own; control (T, nu) of the model's actuators."""
    for keyframes in root.findall("keyframe"):
        root.remove(keyframes)
    keyframes = ElementTree.SubElement(root, "keyframe")
    stem = re.sub(r"\W+", "_", sampled.name) or "key"
    for i, time in enumerate(sampled.time.tolist()):
        qpos, qvel = _text(sampled.qpos[i]), _text(sampled.qvel[i])
        key = ElementTree.SubElement(keyframes, "key", name=f"{stem}_{i}", time=repr(time), qpos=qpos, qvel=qvel)
        if control is not None:
            key.set("ctrl", _text(control[i]))
    ElementTree.indent(root)
    ElementTree.ElementTree(root).write(path, encoding="unicode")


def _text(row: Array) -> str:
    return " ".join(map(repr, row.tolist()))


def recognises(path: Path) -> bool:
    """Return whether an .xml is MJCF."""
    return b"<mujoco" in path.read_bytes()


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the model's keys on its figure, or on the figure `model` if its qpos has the same length."""
    spec = figure_spec(str(path))
    written = [np.array(key.qpos) for key in spec.keys]
    figure = compile_model(spec, path)
    if figure.nkey < 2:
        raise UserError(f"{path}: the model has {figure.nkey or 'no'} <key> elements; a motion needs two or more")
    qpos = np.array(figure.key_qpos)
    for i, row in enumerate(written):
        if row.size not in (0, figure.nq):
            raise UserError(f"{path}: qpos of key {i + 1} has {row.size} numbers, not the figure's {figure.nq}")
        if row.size:
            qpos[i] = row  # as written: MuJoCo normalises quaternions
    keys = ArrayReader(path, {"time": np.array(figure.key_time), "qpos": qpos})
    time = keys.numbers("time", "keys")
    if not np.any(time != time[0]):
        raise UserError(f"{path}: all its keys are of the time {time[0]:g}; a motion's times rise")
    wanted = figure.nq if model is None else model.nq
    if wanted != figure.nq:
        raise UserError(f"{path}: its qpos has {figure.nq} numbers; the figure's {wanted}")
    for key in list(spec.keys):
        remove(spec, key)
    values = keys.numbers("qpos", "keys", wanted)
    if model is not None:
        return Recording(time, values)
    assets = taken_along(spec)
    spec.assets = dict(assets)
    spec.compile()
    return Recording(time, values, Scene(portable_text(spec), assets))
