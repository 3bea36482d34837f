"""Variations of a clip: every joint turned by up to 5°, another step height, keyframes lifted until they touch."""

from __future__ import annotations

import re
from dataclasses import replace

import mujoco
import numpy as np
from oracles import kinematics
from rekeyed import with_keys

from dynsplines import recordings
from dynsplines.clip import load as clips
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.surface.touch import movers, solids

TOUCH = 0.005
REACH = 0.05


def nearest(model: mujoco.MjModel, qpos: Array) -> float:
    """Signed distance [m] of the figure's nearest geom to the scene, at most `REACH`."""
    data = kinematics(model, qpos)
    least, moving = REACH, np.array(movers(model))
    for solid in solids(model):
        away = np.maximum(np.abs(data.geom_xpos[moving] - data.geom_xpos[solid]) - model.geom_size[solid], 0)
        if model.geom_type[solid] == mujoco.mjtGeom.mjGEOM_PLANE:
            away = away[:, 2:]
        for geom in moving[np.linalg.norm(away, axis=1) < model.geom_rbound[moving] + REACH].tolist():
            least = min(least, mujoco.mj_geomDistance(model, data, geom, solid, REACH, None))
    return least


def lifted(model: mujoco.MjModel, qpos: Array, *, drop: bool) -> Array:
    """The configuration raised until nothing penetrates; with `drop`, also lowered until something touches."""
    out = np.array(qpos)
    while nearest(model, out) < 0:
        out[2] += 0.02
    while drop and nearest(model, out) >= REACH:
        out[2] -= 0.02
    low, high = out[2] - 0.08, out[2]
    if not drop and nearest(model, out - 0.02 * np.eye(out.size)[2]) >= 0:
        return out
    for _ in range(16):
        out[2] = (low + high) / 2
        low, high = (low, out[2]) if nearest(model, out) >= 0 else (out[2], high)
    out[2] = high
    return out


def perturbed(text: str, seed: int, degrees: float = 5.0, heights: tuple[float, float] = (0.25, 0.40)) -> clips.Clip:
    """The clip of a TOML text, varied by the seed."""
    rng = np.random.default_rng(seed)
    height = rng.uniform(*heights)
    plain = recordings.from_text(text, name="plain")
    other = recordings.from_text(re.sub(r"height = [\d.]+", f"height = {height:.4f}", text), name=f"perturbed {seed}")
    model, keys = other.figure.model, []
    grounded = [nearest(plain.figure.model, np.array(key.state)) < TOUCH for key in plain.keys]
    for key, touching in zip(other.keys, grounded, strict=True):
        qpos = np.array(key.state)
        for link in other.figure.links[1:]:
            if link.kind is JointKind.BALL:
                columns = slice(link.qpos, link.qpos + 4)
                turn = quat.from_rotation_vector(np.radians(rng.uniform(-degrees, degrees, 3)))
                qpos[columns] = quat.product(qpos[columns], turn)
        keys.append(replace(key, state=lifted(model, qpos, drop=touching)))
    return with_keys(other, keys)
