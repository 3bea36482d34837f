"""Bodies as animators have them: names without doubles, every body in its parent's axes, and y-up worlds."""

from __future__ import annotations

from collections.abc import Iterable

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ..trajectory import Bodies
from .roles import unique

# A figure of ours looks along x and has y to its left and z up; one of animators looks along z, has x to its left, y up
Y_UP = np.array([0.5, -0.5, -0.5, -0.5])  # wxyz: turns our x to z, y to x, z to y


def names(model: mujoco.MjModel) -> list[str]:
    """A name for every body, no two alike; the world's first."""
    return unique(["world", *(model.body(body).name or f"body{body}" for body in range(1, model.nbody))])


def local(model: mujoco.MjModel, bodies: Bodies) -> tuple[Array, Array]:
    """(T, nbody, 3) and (T, nbody, 4) of every body in its parent's axes, unit and sign-continuous; the world at 0."""
    parent = model.body_parentid
    turn = quat.conjugate(quat.normalised(bodies.rotation[:, parent]))
    position = quat.rotated(turn, bodies.position - bodies.position[:, parent])
    rotation = quat.aligned(quat.normalised(quat.product(turn, bodies.rotation)))
    return position, rotation


def rest(model: mujoco.MjModel) -> Bodies:
    """Where the bodies are in the model's own pose, qpos0; one instant."""
    return Bodies.of(model, model.qpos0[None], np.zeros((1, model.nv)))


def xyzw(q: Array) -> Array:
    """Quaternions (..., 4) with the scalar last."""
    return np.roll(q, -1, axis=-1)


def above(model: mujoco.MjModel, body: int, *, itself: bool = False) -> list[int]:
    """The bodies that carry a body, the root first."""
    chain = [body] if itself else []
    while body := int(model.body_parentid[body]):
        chain.insert(0, body)
    return chain


def joints(model: mujoco.MjModel, bodies: Iterable[int]) -> list[int]:
    """The joints of bodies, in order."""
    return [int(model.body_jntadr[body]) + i for body in bodies for i in range(model.body_jntnum[body])]
