"""The part of vectors outside cones of edges, by non-negative least squares for many vectors and cones at once.

    E(w, G) = min over λ ≥ 0 of |w − G λ|² + ε |λ|²

With r = w − G λ, the optimality conditions are λ = max(0, Gᵀ r) / ε. Hence r minimises the convex, piecewise quadratic
function ½ |r|² + |max(0, Gᵀ r)|² / 2ε − w · r. Its dimension is that of w, whatever the number of edges. Newton steps
on the active set, shortened where they overshoot, reach the minimum after a few iterations.

By the envelope theorem, dE = 2 r · (dw − dG λ). `projection` gives the second derivatives for a constant active set.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .array import Array, Mask
from .tolerances import LAST_STEP, NEWTON_STEPS, SMALLEST

FAR = 0.5  # [1] positive slope at a step's end, relative to the negative one at its start, above which it overshoots
SECANTS = 8  # steps after which overshooting steps are shortened by exact line search instead of by the secant rule


class Unsupplied(NamedTuple):
    """The part of vectors w (n, S) outside their cones.

    Attributes:
        rest: The residual r = w − G λ, (n, S).
        shares: The multipliers λ of the edges, (K, S).
        value: E, (S,).
    """

    rest: Array
    shares: Array
    value: Array


def split_off_cone(w: Array, edges: Array, softness: float) -> Unsupplied:
    """Return the part of vectors outside their cones.

    Args:
        w: The vectors, (n, S).
        edges: The edges of the cones G, (n, K, S). Edges may be zero.
        softness: The regularisation ε.
    """
    w, edges = np.ascontiguousarray(w.T), np.ascontiguousarray(edges.transpose(2, 1, 0))
    rest, pull = w.copy(), np.matmul(edges, w[:, :, None])[:, :, 0]
    todo = np.flatnonzero((pull > 0).any(axis=1))
    w_left, g, r, p = w[todo], edges[todo], w[todo], pull[todo]
    size, identity = np.einsum("sn,sn->s", w_left, w_left), np.eye(w.shape[1])
    for number in range(NEWTON_STEPS):
        if not todo.size:
            break
        pulls = p > 0
        slope = r - w_left + np.matmul((p * pulls)[:, None], g)[:, 0] / softness
        step = -np.linalg.solve(identity + _squares(g, pulls) / softness, slope[:, :, None])[:, :, 0]
        change = np.matmul(g, step[:, :, None])[:, :, 0]
        there = p + change
        pulling = there > 0
        promised = -np.einsum("sn,sn->s", slope, step)
        # with an unchanged active set, the step ends at the minimum
        done = (pulling == pulls).all(axis=1) | (promised <= LAST_STEP * size)
        rise = _rise(w_left, r, step, there, change, softness)
        far = np.flatnonzero(~done & (rise > FAR * promised))
        if far.size:
            share = promised[far] / (promised[far] + rise[far])
            if number > SECANTS:
                share = _line_search(step[far], slope[far], p[far], change[far], softness)
            step[far] *= share[:, None]
            there[far] = p[far] + share[:, None] * change[far]
        r += step
        rest[todo[done]], pull[todo[done]] = r[done], there[done]
        go = np.flatnonzero(~done)
        todo, w_left, g, r, p, size = todo[go], w_left[go], g[go], r[go], there[go], size[go]
    rest[todo], pull[todo] = r, p
    shares = np.maximum(pull, 0) / softness
    return Unsupplied(rest.T, shares.T, np.einsum("sn,sn->s", w, rest))


def projection(left: Unsupplied, edges: Array, softness: float) -> Array:
    """Return ½ ∂²E/∂w² for a constant active set, (S, n, n).

    Args:
        edges: The edges of the cones, (n, K, S).
        softness: The regularisation ε.
    """
    edges = np.ascontiguousarray(edges.transpose(2, 1, 0))
    return np.asarray(np.linalg.inv(np.eye(edges.shape[2]) + _squares(edges, left.shares.T > 0) / softness), float)


def _squares(edges: Array, active: Mask) -> Array:
    """Σ g gᵀ over the active edges, (S, n, n)."""
    return np.matmul((edges * active[:, :, None]).swapaxes(1, 2), edges)


def _rise(w: Array, rest: Array, step: Array, there: Array, change: Array, softness: float) -> Array:
    """Return the slope (S,) of the convex function at the end of a step from r (S, n); `there` is Gᵀ r at that end."""
    pulled = np.einsum("sk,sk->s", np.maximum(there, 0), change)
    return np.einsum("sn,sn->s", rest + step - w, step) + pulled / softness


def _line_search(step: Array, slope: Array, pull: Array, change: Array, softness: float) -> Array:
    """Return the share of the step at which the convex function is smallest, (S,). The slope along the step is
    piecewise linear and increasing. It starts at slope · step, and its own rate grows by change²/ε where an edge
    becomes active and falls by as much where one becomes inactive."""
    straight = np.einsum("sn,sn->s", step, step)
    here = np.einsum("sn,sn->s", slope, step)
    squares = change * change / softness
    with np.errstate(divide="ignore", invalid="ignore"):
        turns = -pull / change
    ahead = (turns > 0) & np.isfinite(turns)
    order = np.argsort(np.where(ahead, turns, np.inf), axis=1)
    count = np.arange(len(order))[:, None]
    turns = np.where(ahead, turns, 0.0)[count, order]
    turns = np.maximum.accumulate(turns, axis=1)  # edges without a turn repeat the last turn
    jumps = np.where(ahead, np.sign(change) * squares, 0.0)[count, order]
    pulls = (pull > 0) | ((pull == 0) & (change > 0))
    first = straight + np.einsum("sk,sk->s", squares, pulls)
    rises = first[:, None] + np.cumsum(jumps, axis=1) - jumps  # of the derivative, before each turn
    gaps = np.diff(turns, axis=1, prepend=0.0)
    at_turns = here[:, None] + np.cumsum(rises * gaps, axis=1)
    past = (at_turns >= 0) & (turns > 0)
    which = np.where(past.any(axis=1), past.argmax(axis=1), past.shape[1] - 1)
    row = np.arange(len(order))
    last = ~past.any(axis=1)
    rise = np.where(last, rises[row, which] + jumps[row, which], rises[row, which])
    low = np.where(last, turns[row, which], turns[row, which] - gaps[row, which])
    value = np.where(last, at_turns[row, which], at_turns[row, which] - rises[row, which] * gaps[row, which])
    return np.where(straight > 0, low - value / np.maximum(rise, SMALLEST), 1.0)
