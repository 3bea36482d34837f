"""Quaternion algebra on arrays (..., 4): wxyz, of any length > 0, without implicit normalisation.

The logarithm and exponential are as in J. Solà, "Quaternion kinematics for the error-state Kalman filter" (2017), §2.
"""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from .array import Array
from .tolerances import ROUNDING, SINGLE

# Hamilton's table: the coefficient of p_i q_j, in row 4 i + j, in each component of p ⊗ q
_PRODUCT = np.zeros((16, 4))
_PRODUCT[[0, 1, 4, 2, 8, 3, 12, 11, 13, 6], [0, 1, 1, 2, 2, 3, 3, 1, 2, 3]] = 1
_PRODUCT[[5, 10, 15, 14, 7, 9], [0, 0, 0, 1, 2, 3]] = -1


def product(p: ArrayLike, q: ArrayLike) -> Array:
    """Return the Hamilton product p ⊗ q, (..., 4) with (..., 4)."""
    p, q = np.asarray(p, float), np.asarray(q, float)
    pairs = p[..., :, None] * q[..., None, :]
    return pairs.reshape(*pairs.shape[:-2], 16) @ _PRODUCT


def conjugate(q: ArrayLike) -> Array:
    """Return the conjugate, with the vector part negated, (..., 4)."""
    return np.asarray(q, float) * np.array([1.0, -1.0, -1.0, -1.0])


def inverse(q: ArrayLike) -> Array:
    """Return q⁻¹ = conjugate / (q·q) for q (..., 4) of any length > 0 (eq. 14)."""
    q = np.asarray(q, float)
    return conjugate(q) / np.sum(q * q, axis=-1, keepdims=True)


def normalise(q: ArrayLike) -> Array:
    """Return q / |q|, (..., 4); NaN for a zero quaternion."""
    q = np.asarray(q, float)
    return q / np.linalg.norm(q, axis=-1, keepdims=True)


def rotate(q: ArrayLike, v: ArrayLike) -> Array:
    """Return v (..., 3) rotated by q (..., 4) of any length: the vector part of q ⊗ v ⊗ q⁻¹."""
    q, v = np.asarray(q, float), np.asarray(v, float)
    if q.ndim == v.ndim == 1 and q @ q > 0:
        return np.array(_turn(*q.tolist(), *v.tolist()))  # for a single vector, numbers are faster than arrays
    return np.stack(_turn(*(q[..., i] for i in range(4)), *(v[..., i] for i in range(3))), axis=-1)


def _turn(w: Any, x: Any, y: Any, z: Any, a: Any, b: Any, c: Any) -> tuple[Any, Any, Any]:
    """Return v + w t + u × t with t = 2 u × v / |q|², component by component, for q = (w, u)."""
    twice = 2 / (w * w + x * x + y * y + z * z)
    i, j, k = twice * (y * c - z * b), twice * (z * a - x * c), twice * (x * b - y * a)
    return a + w * i + y * k - z * j, b + w * j + z * i - x * k, c + w * k + x * j - y * i


def from_rotation_vector(v: ArrayLike) -> Array:
    """Return exp(v/2), the unit quaternion (..., 4) of the rotation vector v (..., 3) [rad]."""
    v = np.asarray(v, float)
    if v.ndim == 1:
        x, y, z = v.tolist()
        half = 0.5 * math.hypot(x, y, z)
        share = 0.5 * math.sin(half) / half if half else 0.5
        return np.array([math.cos(half), share * x, share * y, share * z])
    half = 0.5 * np.linalg.norm(v, axis=-1, keepdims=True)
    return np.concatenate([np.cos(half), 0.5 * np.sinc(half / np.pi) * v], axis=-1)


def rotation_vector(q: ArrayLike) -> Array:
    """Return the rotation vector 2 log(q / |q|) (..., 3) [rad] of q (..., 4), of length at most π."""
    if isinstance(q, np.ndarray) and q.ndim == 1 and q.any():
        w, x, y, z = q.tolist() if q[0] >= 0 else (-q).tolist()
        vector = math.hypot(x, y, z)
        size = math.hypot(w, vector)
        share = 2 * math.atan2(vector, w) / vector if vector >= ROUNDING * size else 2 / size
        return np.array([share * x, share * y, share * z])
    q = normalise(q)
    q = np.where(q[..., :1] < 0, -q, q)
    vector = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(vector, q[..., :1])
    tiny = vector < ROUNDING
    return q[..., 1:] * np.where(tiny, 2.0, angle / np.where(tiny, 1.0, vector))


def angle_between(p: ArrayLike, q: ArrayLike) -> Array:
    """Return the angle [rad] of the rotation from p to q, in [0, π]; p and q (..., 4) of any length."""
    return np.linalg.norm(rotation_vector(product(inverse(p), q)), axis=-1)


def swing(start: Array, end: Array, otherwise: Array) -> Array:
    """Return the shortest rotation (4,) of one direction (3,) to another; about `otherwise` if they are opposite."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    cosine = float(start @ end)
    if cosine < SINGLE - 1:
        across = otherwise - (otherwise @ start) * start
        return from_rotation_vector(np.pi * across / np.linalg.norm(across))
    return normalise(np.append(1 + cosine, np.cross(start, end)))


def align_signs(track: ArrayLike) -> Array:
    """Return a track (T, ..., 4) with signs such that every quaternion is on the hemisphere of its predecessor."""
    q = np.array(track, float)
    dots = np.sum(q[1:] * q[:-1], axis=-1, keepdims=True)
    q[1:] *= np.cumprod(np.where(dots < 0, -1.0, 1.0), axis=0)
    return q


def matrices(q: ArrayLike) -> Array:
    """Return the rotation matrices (..., 3, 3) of quaternions (..., 4) of any length."""
    q = np.asarray(q, float)
    unit = np.asarray(q / np.sqrt(np.einsum("...i,...i->...", q, q))[..., None], float)
    w, x, y, z = (unit[..., i] for i in range(4))
    out = np.empty((*w.shape, 3, 3))
    out[..., 0, 0], out[..., 0, 1], out[..., 0, 2] = 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)
    out[..., 1, 0], out[..., 1, 1], out[..., 1, 2] = 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)
    out[..., 2, 0], out[..., 2, 1], out[..., 2, 2] = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
    return out


def from_matrix(matrix: ArrayLike) -> Array:
    """Return the unit quaternion (4,) of a rotation matrix (3, 3)."""
    out = np.zeros(4)
    mujoco.mju_mat2Quat(out, np.ascontiguousarray(matrix, float).ravel())
    return out


def from_euler(angles: ArrayLike, order: str) -> Array:
    """Return quaternions (..., 4) of intrinsic angles (..., n) [rad] about axes in an order, such as "xyz"."""
    angles, out = np.asarray(angles, float), np.array([1.0, 0.0, 0.0, 0.0])
    for i, letter in enumerate(order):
        out = product(out, from_rotation_vector(angles[..., i, None] * np.eye(3)["xyz".index(letter)]))
    return out


def right_matrix(q: ArrayLike) -> Array:
    """Return the matrix (4, 4) of p -> p ⊗ q for a quaternion q (4,)."""
    return product(np.eye(4), np.asarray(q, float)).T
