"""MJCF with <keyframe>: figure and scene, and a <key> with time, qpos and qvel for every sample.

`mujoco.MjModel.from_xml_path` reads it; `model.key_time`, `key_qpos` and `key_qvel` are the motion, and MuJoCo's
viewer shows one key after another. A key is named after the motion and its index, as keys need unique names. Every
number has the digits that reproduce it exactly, unlike those of MuJoCo's writer.
"""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

from dynsplines.solver.array import Array

from ...motion import Sampled


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
