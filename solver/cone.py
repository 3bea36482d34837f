"""The part of vectors that a cone cannot supply, for many vectors and cones at once: non-negative least squares.

    E(w, G) = min over λ ≥ 0 of |w − G λ|² + ε |λ|²

With r = w − G λ the conditions are λ = max(0, Gᵀ r) / ε, so r minimises the convex, piecewise quadratic
½ |r|² + |max(0, Gᵀ r)|² / 2ε − w · r: Newton steps with an exact line search end there after a few, as in the model of
a step of the search. Its dimension is that of w, however many edges the cones have. By the envelope theorem
dE = 2 r · (dw − dG λ); and its second derivatives, edges that pull nothing left out, are twice those of a projection.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .quaternion import Array

MOST_STEPS = 60
SETTLED = 1e-14  # promised decrease beside |w|² at which a step is the last one


class Unsupplied(NamedTuple):
    """What is left of w (n, S): rest r (n, S), the edges' shares λ (K, S), value E (S,) and ½ ∂²E/∂w² (S, n, n)."""

    rest: Array
    shares: Array
    value: Array
    projection: Array


def unsupplied(w: Array, edges: Array, softness: float) -> Unsupplied:
    """E for vectors w (n, S) and cones of K edges (n, K, S), of which some may be zero; softness ε."""
    w, edges = np.ascontiguousarray(w.T), np.ascontiguousarray(edges.transpose(2, 1, 0))
    count, size = w.shape
    rest, identity = w.copy(), np.eye(size)
    todo = np.arange(count)
    for _ in range(MOST_STEPS):
        g = edges[todo]
        pull = np.einsum("skn,sn->sk", g, rest[todo])
        slope = rest[todo] - w[todo] + np.einsum("skn,sk->sn", g, np.maximum(pull, 0)) / softness
        curvature = identity + _squares(g, pull > 0) / softness
        step = -np.linalg.solve(curvature, slope[:, :, None])[:, :, 0]
        share = _line_search(step, slope, pull, np.einsum("skn,sn->sk", g, step), softness)
        rest[todo] += share[:, None] * step
        promised = -np.einsum("sn,sn->s", slope, step)
        todo = todo[promised > SETTLED * np.einsum("sn,sn->s", w[todo], w[todo])]
        if not todo.size:
            break
    pull = np.einsum("skn,sn->sk", edges, rest)
    shares = np.maximum(pull, 0) / softness
    projection = np.linalg.inv(identity + _squares(edges, pull > 0) / softness)
    projection = np.asarray(projection, float)
    return Unsupplied(rest.T, shares.T, np.einsum("sn,sn->s", w, rest), projection)


def _squares(edges: Array, active: Array) -> Array:
    """Σ g gᵀ over the active edges, (S, n, n)."""
    chosen = edges * active[:, :, None]
    return np.matmul(chosen.swapaxes(1, 2), chosen)


def _line_search(step: Array, slope: Array, pull: Array, change: Array, softness: float) -> Array:
    """(S,) how far along the step the convex function is least: its derivative is piecewise linear and rises."""
    straight = np.einsum("sn,sn->s", step, step)
    here = np.einsum("sn,sn->s", slope, step)
    base = here - np.einsum("sk,sk->s", np.maximum(pull, 0), change) / softness

    def derivative(t: Array) -> Array:
        """(S, m) at t (S, m)."""
        along = np.maximum(pull[:, None] + t[:, :, None] * change[:, None], 0)
        return base[:, None] + straight[:, None] * t + np.einsum("smk,sk->sm", along, change) / softness

    with np.errstate(divide="ignore", invalid="ignore"):
        turns = np.where(change != 0, -pull / change, 0.0)
    turns = np.where((turns > 0) & np.isfinite(turns), turns, 0.0)
    rises = derivative(turns)
    low = np.max(np.where(rises <= 0, turns, 0.0), axis=1, initial=0.0)
    high = np.min(np.where((rises > 0) & (turns > low[:, None]), turns, np.inf), axis=1, initial=np.inf)
    middle = np.where(np.isfinite(high), (low + np.minimum(high, 1e300)) / 2, low + 1)
    active = pull + middle[:, None] * change > 0
    bent = straight + np.einsum("sk,sk->s", active * change, change) / softness
    found = low - derivative(low[:, None])[:, 0] / np.maximum(bent, 1e-300)
    return np.where(straight > 0, np.minimum(found, high), 1.0)
