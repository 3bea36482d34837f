"""The older method that the paper compares itself with: Barr, Currin, Gabriel & Hughes, SIGGRAPH 1992.

Unknown quaternions at many equal steps, covariant acceleration by differences, *hard* unit length at every step and
hard keyframes: a constrained problem, solved here by a dense and by a sparse sequential quadratic programming.
"""

from __future__ import annotations

import numpy as np
from scipy import optimize, sparse
from scipy.sparse.linalg import splu

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import Path, natural_spline, path_of


class Discrete:
    """Unknown quaternions at equal steps: hard unit length and keyframes, covariant acceleration by differences."""

    def __init__(self, track: Array, steps: int) -> None:
        count = (len(track) - 1) * steps + 1
        self.h = 1 / steps
        self.t = np.linspace(0, len(track) - 1, count)
        self.start = quat.normalise(natural_spline(np.arange(len(track)), track).at(self.t))
        self.start[::steps] = track
        self.free = np.flatnonzero(np.arange(count) % steps)

    def all_samples(self, x: Array) -> Array:
        """All samples (n, 4) from the unknown ones, flat."""
        samples = self.start.copy()
        samples[self.free] = x.reshape(-1, 4)
        return samples

    def parts(self, q: Array) -> tuple[Array, Array, Array]:
        """q, q'' and T at the inner samples."""
        middle, rate = q[1:-1], (q[2:] - 2 * q[1:-1] + q[:-2]) / self.h**2
        dots = np.sum(middle * rate, axis=1, keepdims=True) / np.sum(middle * middle, axis=1, keepdims=True)
        return middle, rate, dots

    def __call__(self, x: Array) -> tuple[float, Array]:
        """The summed |q'' − T q|² and its gradient in x."""
        q = self.all_samples(x)
        middle, rate, along = self.parts(q)
        w = rate - along * middle
        into_rate, into_middle = 2 * w / self.h, 2 * self.h * along * (along * middle - rate)
        gradient = np.zeros_like(q)
        gradient[2:] += into_rate
        gradient[:-2] += into_rate
        gradient[1:-1] += into_middle - 2 * into_rate
        return self.h * float(np.sum(w * w)), gradient[self.free].ravel()

    def length(self, x: Array) -> Array:
        """The hard constraints, zero where samples are unit."""
        return np.sum(x.reshape(-1, 4) ** 2, axis=1) - 1

    def length_jacobian(self, x: Array) -> sparse.csr_matrix:
        i = np.arange(x.size)
        return sparse.csr_matrix((2 * x, (i // 4, i)), shape=(x.size // 4, x.size))

    def hessian(self, x: Array) -> sparse.csr_matrix:
        """The exact second derivatives of the sum, (n, n)."""
        middle, rate, along = self.parts(self.all_samples(x))
        b, along = np.sum(middle * middle, axis=1)[:, None, None], along[:, :, None]
        slope = (rate - 2 * along[:, 0] * middle)[:, :, None] / b
        eye, column, row = np.eye(4), middle[:, :, None], slope.transpose(0, 2, 1)
        mixed = -2 * (along * eye + column @ row)
        blocks = np.block(
            [
                [2 * along**2 * eye - 2 * b * slope @ row, mixed.transpose(0, 2, 1)],
                [mixed, 2 * (eye - column @ column.transpose(0, 2, 1) / b)],
            ]
        )
        stencil = np.kron(np.array([[0, 1, 0], np.array([1, -2, 1]) / self.h**2]), eye)
        blocks = self.h * stencil.T @ blocks @ stencil
        place = 4 * np.arange(len(blocks))[:, None] + np.arange(12)
        i, j = np.repeat(place, 12, axis=1).ravel(), np.tile(place, (1, 12)).ravel()
        keep = (4 * self.free[:, None] + np.arange(4)).ravel()
        whole = sparse.csr_matrix((blocks.ravel(), (i, j)), shape=(self.start.size,) * 2)
        return sparse.csr_matrix(whole[np.ix_(keep, keep)])

    def by_slsqp(self) -> Array:
        """Dense sequential quadratic programming with exact derivatives, of the kind that the paper's peer had."""
        x = self.start[self.free].ravel()
        constraint = {"type": "eq", "fun": self.length, "jac": lambda x: self.length_jacobian(x).toarray()}
        options = {"maxiter": 1000, "ftol": 1e-5 * self(x)[0]}
        return optimize.minimize(self, x, jac=True, method="SLSQP", constraints=[constraint], options=options).x

    def by_newton(self) -> Array:
        """The same by Newton's method with exact sparse second derivatives, as a present-day implementation."""
        x = self.start[self.free].ravel()
        multiplier = np.zeros(x.size // 4)
        for _ in range(30):
            jacobian = self.length_jacobian(x)
            curvature = self.hessian(x) + sparse.diags_array(np.repeat(2 * multiplier, 4))
            system = sparse.block_array([[curvature, jacobian.T], [jacobian, None]], format="csc")
            step = splu(sparse.csc_matrix(system)).solve(-np.concatenate([self(x)[1], self.length(x)]))
            x, multiplier = x + step[: x.size], step[x.size :]
            if np.abs(step[: x.size]).max() < 1e-6:
                break
        return x

    def path(self, x: Array) -> Path:
        """The natural spline through the samples."""
        keys = [Frame.key(t, q) for t, q in zip(self.t, self.all_samples(x), strict=True)]
        slopes = natural_spline(self.t, self.all_samples(x)).at(self.t[[0, -1]], 1)
        return path_of(Timeline(tuple(keys), slopes))
