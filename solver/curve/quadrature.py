"""Sample times and weights of the integral E (eq. 1).

"uniform" is the rule of the paper: equal cells over the whole clip, sampled at their middles. "gauss" uses a few
Gauss-Legendre points in every knot span. Spans of very different lengths are thus all resolved, and E does not depend
on where samples happen to fall.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from ..array import Array, count_off
from ..tolerances import NEGLIGIBLE, ROUNDING

LEAST_PER_SPAN = 4  # minimum number of uniform samples in the shortest span between frames
MOST_SAMPLES = 100_000  # maximum number of uniform samples, a limit of memory


@dataclass(frozen=True)
class Quadrature:
    """The quadrature rule of integrals over a clip.

    Attributes:
        kind: "gauss" or "uniform".
        points: gauss: points per panel; uniform: samples in the whole clip, at least 4 in the shortest knot span.
        longest: gauss: spans longer than this [s] are cut into equal panels.
        cuts: gauss: times [s] at which panels are cut again, where the integrand has narrow peaks.
    """

    kind: str = "gauss"
    points: int = 5
    longest: float = np.inf
    cuts: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if self.kind not in ("gauss", "uniform"):
            raise ValueError(f"quadrature: kind = {self.kind!r} is not one of 'gauss', 'uniform'")
        if self.points < 1 or not self.longest > 0:
            raise ValueError("quadrature: points and longest must be positive")

    def nodes(self, times: Array) -> tuple[Array, Array]:
        """Return sample times (S,) [s] and weights (S,) [s] for a spline with knots at `times` (M,) [s].

        Raises:
            ValueError: Uniform quadrature would take too many samples.
        """
        if self.kind == "uniform":
            length = times[-1] - times[0]
            count = max(self.points, int(np.ceil(LEAST_PER_SPAN * length / np.diff(times).min() - ROUNDING)))
            if count > MOST_SAMPLES:
                raise ValueError(f"uniform quadrature would take {count} samples; use 'gauss' for uneven times")
            return times[0] + length * (np.arange(count) + 0.5) / count, np.full(count, length / count)
        return gauss_nodes(self.panels(times), self.points)

    def panels(self, times: Array) -> Array:
        """Return the edges [s] of the panels: the knots, equal cuts of spans that are too long, and `cuts`."""
        counts = np.maximum(np.ceil(np.diff(times) / self.longest - ROUNDING), 1).astype(int)
        edges = np.asarray(times, float)
        if np.any(counts > 1):
            span, number = count_off(counts)
            inner = times[:-1][span] + number * (np.diff(times) / counts)[span]
            edges = np.append(inner, times[-1])
        if not self.cuts:
            return edges
        cuts = np.array(self.cuts)
        is_inside = (cuts > edges[0]) & (cuts < edges[-1])
        return np.union1d(edges, cuts[is_inside & (np.abs(cuts[:, None] - edges).min(axis=1) > NEGLIGIBLE)])


def gauss_nodes(edges: Array, points: int = 4) -> tuple[Array, Array]:
    """Return Gauss-Legendre nodes and weights [s] in every panel between neighbouring edges [s], flattened."""
    x, w = _legendre(points)
    half = np.diff(edges)[:, None] / 2
    middle = (edges[1:] + edges[:-1])[:, None] / 2
    return (middle + half * x).ravel(), (half * w).ravel()


@cache
def _legendre(points: int) -> tuple[Array, Array]:
    return np.polynomial.legendre.leggauss(points)
