"""The part of vectors that a cone cannot supply, for many vectors and cones at once: non-negative least squares.

    E(w, G) = min over λ ≥ 0 of |w − G λ|² + ε |λ|²

With r = w − G λ the conditions are λ = max(0, Gᵀ r) / ε, so r minimises the convex, piecewise quadratic
½ |r|² + |max(0, Gᵀ r)|² / 2ε − w · r: Newton steps, shortened where they go too far, end there after a few, as in the
model of a step of the search. Its dimension is that of w, however many edges the cones have. By the envelope theorem
dE = 2 r · (dw − dG λ); and its second derivatives, edges that pull nothing left out, are twice those of a projection.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .array import Array, Mask

MOST_STEPS = 60  # of the active set
SETTLED = 1e-14  # promised decrease beside |w|² at which a step is the last one
FAR = 0.5  # of the slope at a step's start, with the other sign, at its end: too far
SECANTS = 8  # steps after which one that goes too far is shortened by the exact line search
TINY = 1e-300  # a slope that does not rise


class Unsupplied(NamedTuple):
    """The unsupplied part of w (n, S): residual r (n, S), the edges' shares λ (K, S) and value E (S,)."""

    rest: Array
    shares: Array
    value: Array


def unsupplied(w: Array, edges: Array, softness: float) -> Unsupplied:
    """E for vectors w (n, S) and cones of K edges (n, K, S), some of which may be zero; softness ε."""
    w, edges = np.ascontiguousarray(w.T), np.ascontiguousarray(edges.transpose(2, 1, 0))
    rest, pull = w.copy(), np.matmul(edges, w[:, :, None])[:, :, 0]
    todo = np.flatnonzero((pull > 0).any(axis=1))
    w_left, g, r, p = w[todo], edges[todo], w[todo], pull[todo]
    size, identity = np.einsum("sn,sn->s", w_left, w_left), np.eye(w.shape[1])
    for number in range(MOST_STEPS):
        if not todo.size:
            break
        pulls = p > 0
        slope = r - w_left + np.matmul((p * pulls)[:, None], g)[:, 0] / softness
        step = -np.linalg.solve(identity + _squares(g, pulls) / softness, slope[:, :, None])[:, :, 0]
        change = np.matmul(g, step[:, :, None])[:, :, 0]
        there = p + change
        pulling = there > 0
        promised = -np.einsum("sn,sn->s", slope, step)
        # where the same edges go on pulling, the step ends at the least value
        done = (pulling == pulls).all(axis=1) | (promised <= SETTLED * size)
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
    """½ ∂²E/∂w², (S, n, n), of what is left of vectors when cones of edges (n, K, S) supply what they can."""
    edges = np.ascontiguousarray(edges.transpose(2, 1, 0))
    return np.asarray(np.linalg.inv(np.eye(edges.shape[2]) + _squares(edges, left.shares.T > 0) / softness), float)


def _squares(edges: Array, active: Mask) -> Array:
    """Σ g gᵀ over the active edges, (S, n, n)."""
    return np.matmul((edges * active[:, :, None]).swapaxes(1, 2), edges)


def _rise(w: Array, rest: Array, step: Array, there: Array, change: Array, softness: float) -> Array:
    """(S,) the derivative along a step from rests r (S, n) at its end, where the edges' Gᵀ r are `there`."""
    pulled = np.einsum("sk,sk->s", np.maximum(there, 0), change)
    return np.einsum("sn,sn->s", rest + step - w, step) + pulled / softness


def _line_search(step: Array, slope: Array, pull: Array, change: Array, softness: float) -> Array:
    """(S,) how far along the step the convex function is least: its derivative is piecewise linear and rises.

    It begins at slope · step; its own slope grows by change²/ε where an edge begins to pull, and
    shrinks where one ends.
    """
    straight = np.einsum("sn,sn->s", step, step)
    here = np.einsum("sn,sn->s", slope, step)
    squares = change * change / softness
    with np.errstate(divide="ignore", invalid="ignore"):
        turns = -pull / change
    ahead = (turns > 0) & np.isfinite(turns)
    order = np.argsort(np.where(ahead, turns, np.inf), axis=1)
    count = np.arange(len(order))[:, None]
    turns = np.where(ahead, turns, 0.0)[count, order]
    turns = np.maximum.accumulate(turns, axis=1)  # those that never come, as the last that does
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
    return np.where(straight > 0, low - value / np.maximum(rise, TINY), 1.0)
