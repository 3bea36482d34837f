"""Bodies in the convention of animation: unique names, poses in the parent's axes, Euler angles, worlds with y up."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.tolerances import SINGLE

from ...motion import Bodies
from ...scene.roles import unique

LISTED = 12  # most names of joints or bodies in a message
# Figures here face x, with y to their left and z up; in animation they face z, with x to their left and y up
Y_UP = np.array([0.5, -0.5, -0.5, -0.5])  # wxyz rotation of x to z, y to x, z to y


def names(model: mujoco.MjModel) -> list[str]:
    """Return a unique name for every body, the world's first."""
    return unique(["world", *(model.body(body).name or f"body{body}" for body in range(1, model.nbody))])


def local(model: mujoco.MjModel, bodies: Bodies) -> tuple[Array, Array]:
    """Return continuous positions (T, nbody, 3) and rotations (T, nbody, 4) in the parent's axes; the world at 0."""
    parent = model.body_parentid
    turn = quat.conjugate(quat.normalise(bodies.rotation[:, parent]))
    position = quat.rotate(turn, bodies.position - bodies.position[:, parent])
    rotation = quat.align_signs(quat.normalise(quat.product(turn, bodies.rotation)))
    return position, rotation


def rest(model: mujoco.MjModel) -> Bodies:
    """Return the poses of the bodies in qpos0, as one sample."""
    return Bodies.of(model, model.qpos0[None], np.zeros((1, model.nv)))


def xyzw(q: Array) -> Array:
    """Return quaternions (..., 4) with the scalar last."""
    return np.roll(q, -1, axis=-1)


def euler_angles(q: Array, order: str) -> Array:
    """Return intrinsic angles (T, n, 3) [rad] about axes in an order, continuous in time, of quaternions (T, n, 4).

    Angles exceed ±180° where the motion does. A motion through gimbal lock passes it without a jump.
    """
    shape = (*q.shape[:-1], 3)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # in gimbal lock, the last angle is 0
        solved = Rotation.from_quat(q.reshape(-1, 4), scalar_first=True).as_euler(order.upper()).reshape(shape)
    is_locked = np.abs(np.cos(solved[..., 1])) < SINGLE
    parity = 1 if order in "xyzxy" else -1
    side = parity * np.sign(solved[..., 1])  # in gimbal lock, a + side * c determines the rotation
    out, before = np.zeros(shape), np.zeros(shape[1:])
    for t in range(len(out)):
        a, b, c = solved[t].T
        first = np.where(is_locked[t], before[:, 0], a)
        one = np.stack([first, b, np.where(is_locked[t], c + side[t] * (a - first), c)], -1)
        both = [_near(angle, before) for angle in (one, one * [1, -1, 1] + np.pi)]
        far = [np.abs(candidate - before).sum(-1) for candidate in both]
        before = out[t] = np.where((far[0] <= far[1])[:, None], *both)
    return out


def _near(angle: Array, other: Array) -> Array:
    """Shift an angle by whole turns to within half a turn of another."""
    return angle - 2 * np.pi * np.round((angle - other) / (2 * np.pi))


def above(model: mujoco.MjModel, body: int, *, itself: bool = False) -> list[int]:
    """Return the ancestors of a body, the root first, and with `itself` the body."""
    chain = [body] if itself else []
    while body := int(model.body_parentid[body]):
        chain.insert(0, body)
    return chain


def joints(model: mujoco.MjModel, bodies: Iterable[int]) -> list[int]:
    """Return the joints of bodies, in order."""
    return [int(model.body_jntadr[body]) + i for body in bodies for i in range(model.body_jntnum[body])]


def end(model: mujoco.MjModel, body: int) -> Array:
    """Return the end (3,) [m] of a body in its axes: its farthest site, or the centre of its farthest geom."""
    sites = model.site_pos[model.site_bodyid == body]
    points = sites if len(sites) else model.geom_pos[model.geom_bodyid == body]
    return points[np.argmax(np.linalg.norm(points, axis=1))] if len(points) else np.zeros(3)
