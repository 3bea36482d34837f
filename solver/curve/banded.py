"""Banded matrices, by LAPACK: the Cholesky factor of symmetric matrices and solves with it; tridiagonal matrices.

Symmetric matrices use LAPACK's lower band storage, transposed to C order: row i of `band` (n, width) holds the entries
of column i from the diagonal down.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import get_blas_funcs, get_lapack_funcs

from ..array import Array

_PBTRF, _PBTRS, _TBTRS = get_lapack_funcs(("pbtrf", "pbtrs", "tbtrs"))
_GTTRF, _GTTRS = get_lapack_funcs(("gttrf", "gttrs"))
(_SYRK,) = get_blas_funcs(("syrk",))


def cholesky(band: Array) -> Array | None:
    """Return L of L Lᵀ = A, overwriting `band` (n, width); None if A is not positive definite."""
    factor, info = _PBTRF(np.ascontiguousarray(band).T, lower=1, overwrite_ab=1)
    return factor.T if info == 0 else None


def solve(factor: Array, right: Array) -> Array:
    """Return A⁻¹ b for right-hand sides (n, m)."""
    return _PBTRS(factor.T, right, lower=1)[0]


def half_solved(factor: Array, right: Array) -> Array:
    """Return L⁻¹ b for right-hand sides (n, m)."""
    return _TBTRS(factor.T, right, uplo=b"L")[0]


def other_half_solved(factor: Array, right: Array) -> Array:
    """Return L⁻ᵀ b for right-hand sides (n, m)."""
    return _TBTRS(factor.T, right, uplo=b"L", trans=b"T")[0]


def square(rows: Array, factor: float = 1.0) -> Array:
    """Return the upper triangle of factor · RᵀR for R (k, n); zeros below."""
    return _SYRK(factor, rows.T, lower=1).T


class Tridiagonal:
    """The factor of a tridiagonal matrix: lower (n − 1,), diagonal (n,), upper (n − 1,), n > 2."""

    def __init__(self, lower: Array, diagonal: Array, upper: Array) -> None:
        *self.factor, info = _GTTRF(lower, diagonal, upper)
        if info != 0:
            raise ArithmeticError("the tridiagonal matrix is singular")

    def solve(self, right: Array, *, transposed: bool = False) -> Array:
        """Return A⁻¹ b, or A⁻ᵀ b, for right-hand sides (n, m)."""
        return np.ascontiguousarray(_GTTRS(*self.factor, right, trans="T" if transposed else "N")[0])
