"""Whether a model's lights light its figure everywhere, by the sum of light on the ground around it.

Many robot models have a single light right above them, a narrow cone that they leave when they walk, or none.
"""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.array import Array

from .framing import rest_box
from .mujoco_versions import Lamp
from .mujoco_versions import lamp as kind_of

ABOUT = 2.0  # [1] distance to which the ground should be lit, relative to the figure's size; half for a fixed figure
LEAST = 0.7  # [1] minimum brightness of the ground, relative to full light
SIDEWAYS = (
    0.5  # [1] share of the headlight, which shines along the camera's axis, on the ground and on a figure's sides
)


def is_well_lit(model: mujoco.MjModel) -> bool:
    """Return whether a model has active lights, and enough light at its figure and on all sides of it."""
    return bool(np.any(model.light_active)) and float(brightness(model).min()) >= LEAST


def brightness(model: mujoco.MjModel) -> Array:
    """Return the light on level ground under a figure at rest and on four sides of it, (5,), 1 for full light."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    mujoco.mj_camlight(model, data)
    low, high = rest_box(model)
    reach = ABOUT * float((high - low).max())
    if not np.any(model.jnt_type == int(mujoco.mjtJoint.mjJNT_FREE)):
        reach *= 0.5
    sides = np.array([[0.0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
    ground = np.append((low + high)[:2] / 2, low[2]) + reach * sides
    head = model.vis.headlight
    light = np.full(len(ground), float(bool(head.active)) * float((head.ambient + SIDEWAYS * head.diffuse).mean()))
    for lamp in np.flatnonzero(model.light_active).tolist():
        light += model.light_ambient[lamp].mean() + model.light_diffuse[lamp].mean() * _reaching(
            model, data, lamp, ground
        )
    return light


def _reaching(model: mujoco.MjModel, data: mujoco.MjData, lamp: int, ground: Array) -> Array:
    """Return the share of a light on level ground points (n, 3), with OpenGL's model of a spot's cone, (n,)."""
    ahead = data.light_xdir[lamp] / np.linalg.norm(data.light_xdir[lamp])
    if kind_of(model, lamp) is Lamp.DIRECTIONAL:
        return np.full(len(ground), max(-float(ahead[2]), 0.0))
    ray = ground - data.light_xpos[lamp]
    ray /= np.maximum(np.linalg.norm(ray, axis=1, keepdims=True), 1e-9)
    along = ray @ ahead
    inside = along >= np.cos(np.radians(model.light_cutoff[lamp]))
    cone = inside * np.maximum(along, 0) ** model.light_exponent[lamp] if model.light_cutoff[lamp] < 90 else 1.0
    return np.maximum(-ray[:, 2], 0) * cone
