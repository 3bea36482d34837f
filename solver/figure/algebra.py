"""Vectors, rotations and quaternions of many links at many samples, component first.

Arrays are (3, L, S) or (4, L, S), so that every formula is a few passes over contiguous memory. Sums of products use
einsum, which avoids temporary arrays.
"""

from __future__ import annotations

import numpy as np

from ..array import Array, Index


def axial(matrix: Array) -> Array:
    """Return the vector of M's antisymmetric part, a × b for M = a bᵀ: (3, 3, ...) -> (3, ...)."""
    out = np.empty(matrix.shape[1:])
    np.subtract(matrix[1, 2], matrix[2, 1], out=out[0])
    np.subtract(matrix[2, 0], matrix[0, 2], out=out[1])
    np.subtract(matrix[0, 1], matrix[1, 0], out=out[2])
    return out


def outer(a: Array, b: Array) -> Array:
    """Return a bᵀ: (3, ...) with (3, ...) -> (3, 3, ...)."""
    return np.einsum("i...,j...->ij...", a, b)


def cross(a: Array, b: Array) -> Array:
    """Return a × b, component first: (3, ...) with (3, ...)."""
    out = np.empty(b.shape if a.shape == b.shape else np.broadcast_shapes(a.shape, b.shape))
    _cross(a, b, out)
    return out


def perpendicular(v: Array) -> Array:
    """Return a unit vector across a vector (3,)."""
    across = np.cross(v, np.eye(3)[np.argmin(np.abs(v))])
    return across / np.linalg.norm(across)


def _cross(a: Array, b: Array, out: Array) -> None:
    (a0, a1, a2), (b0, b1, b2), (x, y, z) = a, b, out
    other = np.empty_like(x)
    np.multiply(a1, b2, out=x)
    np.subtract(x, np.multiply(a2, b1, out=other), out=x)
    np.multiply(a2, b0, out=y)
    np.subtract(y, np.multiply(a0, b2, out=other), out=y)
    np.multiply(a0, b1, out=z)
    np.subtract(z, np.multiply(a1, b0, out=other), out=z)


def cross_sum(a: Array, b: Array) -> Array:
    """Return Σ_k a_k × b_k: (k, 3, ...) with (k, 3, ...) -> (3, ...)."""
    total, other = np.empty(a.shape[1:]), np.empty(a.shape[1:])
    _cross(a[0], b[0], total)
    for i in range(1, a.shape[0]):
        _cross(a[i], b[i], other)
        total += other
    return total


def dot(a: Array, b: Array) -> Array:
    """Return a · b over the first axis."""
    return np.einsum("i...,i...->...", a, b)


def rotate_fixed(rotation: Array, vectors: Array) -> Array:
    """Return R c for constant local vectors: (3, 3, n, S) with (3, n) -> (3, n, S)."""
    return np.einsum("ijns,jn->ins", rotation, vectors)


def rotate(rotation: Array, vectors: Array) -> Array:
    """Return R v for moving vectors: (3, 3, n, S) with (3, n, S)."""
    return np.einsum("ij...,j...->i...", rotation, vectors)


def rotate_back(rotation: Array, vectors: Array) -> Array:
    """Return Rᵀ v: (3, 3, n, S) with (3, n, S)."""
    return np.einsum("ji...,j...->i...", rotation, vectors)


def combine(weights: Array, vectors: Array) -> Array:
    """Return linear combinations over the link axis: (m, n) with (3, n, S) -> (3, m, S)."""
    return np.matmul(weights, vectors)


def add_at(buffer: Array, links: Index, vectors: Array) -> None:
    """Add vectors (3, n, S) to buffer[:, links] (3, L, S), where links (n,) may repeat."""
    for i, link in enumerate(links):
        buffer[:, link] += vectors[:, i]


def hamilton(p: Array, q: Array) -> Array:
    """Return p ⊗ q, component first: (4, ...) with (4, ...)."""
    out = np.empty(np.broadcast_shapes(p.shape, q.shape))
    out[0] = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3]
    out[1] = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2]
    out[2] = p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1]
    out[3] = p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]
    return out


def conjugate(q: Array) -> Array:
    """Return the conjugate, component first."""
    return np.concatenate([q[:1], -q[1:]])


def vector_product(q: Array) -> Array:
    """Return G with (0, v) ⊗ q = Gᵀ v, and hence vec(p ⊗ conj(q)) = G p: (4, ...) -> (3, 4, ...)."""
    w, x, y, z = q
    out = np.empty((3, *q.shape))
    np.negative(q[1:], out=out[:, 0])
    out[0, 1], out[0, 3], out[1, 2], out[1, 1], out[2, 3], out[2, 2] = w, y, w, z, w, x
    for target, source in ((out[0, 2], z), (out[1, 3], x), (out[2, 1], y)):
        np.negative(source, out=target)
    return out


def rotation_matrix(q: Array, scale: Array) -> Array:
    """Return rotation matrices of quaternions of any length, scale = 2 / (q·q): (4, ...) with (...) -> (3, 3, ...)."""
    scaled = q[1:] * scale
    wx, wy, wz = q[0] * scaled
    xx, xy, xz = q[1] * scaled
    yy, yz = q[2] * scaled[1:]
    zz = q[3] * scaled[2]
    out = np.empty((3, *scaled.shape))
    for first, second, plus, minus in (((0, 1), (1, 0), xy, wz), ((2, 0), (0, 2), xz, wy), ((1, 2), (2, 1), yz, wx)):
        np.subtract(plus, minus, out=out[first])
        np.add(plus, minus, out=out[second])
    np.subtract(1, yy, out=out[0, 0])
    np.subtract(1, xx, out=out[1, 1])
    np.subtract(out[1, 1], yy, out=out[2, 2])
    out[0, 0] -= zz
    out[1, 1] -= zz
    return out


def swing_matrix(omega: Array, alpha: Array) -> Array:
    """Return A of s'' = A s for vectors s that turn at ω: A = [ω']× + [ω]×[ω]×, (3, ...) both -> (3, 3, ...)."""
    out = outer(omega, omega)
    diagonal = out.reshape(9, *omega.shape[1:])[::4]
    diagonal -= dot(omega, omega)
    for k, (i, j) in enumerate(((2, 1), (0, 2), (1, 0))):
        out[i, j] += alpha[k]
        out[j, i] -= alpha[k]
    return out


def swing_pulled_back(gradient: Array, omega: Array) -> tuple[Array, Array]:
    """Return gradients with respect to ω and ω' for the gradient with respect to A of `swing_matrix`."""
    trace = np.einsum("ii...->...", gradient)
    by_omega = rotate(gradient, omega)
    by_omega += rotate_back(gradient, omega)
    trace *= 2
    by_omega -= trace * omega
    by_alpha = axial(gradient)
    return by_omega, np.negative(by_alpha, out=by_alpha)
