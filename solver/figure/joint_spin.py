"""Jacobian rows of joints' angular accelerations, in closed form, for figures of any joints in any coordinates.

A coordinate that grows by φ(t) turns the links beyond it by φ w, which changes their angular velocities ω by
φ (w' + w × ω) + φ' w and their angular accelerations ω' by φ (w'' + w' × ω + w × ω') + φ' (2 w' + w × ω) + φ'' w.
"""

from __future__ import annotations

import numpy as np

from ..array import Array, Index
from .algebra import cross, dot
from .axes import Axes, axes_of
from .kinematics import Samples

AT_ONCE = 100_000  # pairs of a joint and an axis: few enough that their vectors stay in cache


def any_relative_spin_rows(samples: Samples, at: Index, link: Index, direction: Array) -> Array:
    """(P, 3, N): gradients of direction · (ω' − ω'_parent), as `rows.relative_spin_rows`."""
    out = np.zeros((at.size, 3, samples.y.shape[1]))
    every = [axes for axes in axes_of(samples.links) if axes.turn is not None]
    few = max(1, AT_ONCE // max(1, sum(axes.column.size for axes in every)))
    for first in range(0, at.size, few):
        some = slice(first, first + few)
        for axes in every:
            _add(axes.taken(at[some]), samples, at[some], link[some], direction[:, some], out[some])
    return out


def _add(axes: Axes, samples: Samples, at: Index, link: Index, direction: Array, out: Array) -> None:
    """Adds what some axes do, each as it is at the samples `at`."""
    assert axes.turn is not None
    links, parent = samples.links, samples.figure.tables.parents[link]
    turns, turns_parent = axes.moved[:, link], axes.moved[:, parent]  # (n, P)
    omega, alpha = (
        turns * vectors[:, link, at][:, None] - turns_parent * vectors[:, parent, at][:, None]
        for vectors in (links.omega, links.alpha)
    )
    w, w_d, w_dd = axes.turn
    apart, direction = turns - turns_parent, direction[:, None]
    rows = (
        dot(direction, w_dd) * apart + dot(direction, cross(w_d, omega) + cross(w, alpha)),
        2 * dot(direction, w_d) * apart + dot(direction, cross(w, omega)),
        dot(direction, w) * apart,
    )
    axes.add(np.array(rows)[:, None], out[:, None])
