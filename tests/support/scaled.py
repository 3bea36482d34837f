"""A model times a factor, by its MjSpec: lengths, masses, inertias, and gravity on demand."""

from __future__ import annotations

import mujoco
import numpy as np

SLIDE = mujoco.mjtJoint.mjJNT_SLIDE


def scaled(text: str, factor: float, *, gravity: bool = False) -> mujoco.MjSpec:
    """The model in MJCF text with all lengths times a factor, of the same density."""
    spec = mujoco.MjSpec.from_string(text)
    for body in spec.bodies:
        body.pos = factor * np.array(body.pos)
        body.ipos = factor * np.array(body.ipos)
        body.mass *= factor**3
        body.inertia = factor**5 * np.array(body.inertia)
        body.fullinertia = factor**5 * np.array(body.fullinertia)
        for geom in body.geoms:
            geom.pos, geom.size = factor * np.array(geom.pos), factor * np.array(geom.size)
            geom.fromto = factor * np.array(geom.fromto)
            geom.mass *= factor**3
        for site in body.sites:
            site.pos, site.size = factor * np.array(site.pos), factor * np.array(site.size)
            site.fromto = factor * np.array(site.fromto)
        for joint in body.joints:
            joint.pos = factor * np.array(joint.pos)
            if joint.type == SLIDE:
                joint.range = factor * np.array(joint.range)
    for camera in spec.cameras:
        camera.pos = factor * np.array(camera.pos)
    if gravity:
        spec.option.gravity = factor * np.array(spec.option.gravity)
    return spec


def enlarged(model: mujoco.MjModel, qpos: np.ndarray, factor: float) -> np.ndarray:
    """Configurations (K, nq) of the scaled model that are those of a model."""
    out = np.array(qpos, float)
    for kind, start in zip(model.jnt_type, model.jnt_qposadr, strict=True):
        if kind == mujoco.mjtJoint.mjJNT_FREE:
            out[:, start : start + 3] *= factor
        elif kind == SLIDE:
            out[:, start] *= factor
    return out
