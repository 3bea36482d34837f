"""The Taylor test of a gradient: |f(x + hd) − f(x) − h g·d| must fall as h²."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from dynsplines.solver.array import Array


def taylor_slope(fun: Callable[[Array], float], x: Array, gradient: Array, rng: np.random.Generator) -> float:
    """The slope of log remainder over log step between two steps, 2 for an exact gradient of a smooth function.

    A function that is linear along the direction leaves only rounding: its slope counts as 2. Where rounding dominates
    at the smaller step, steps ten times as long are tried too, and the greater slope counts.
    """
    direction = rng.normal(size=x.shape)
    direction /= np.linalg.norm(direction)
    value, slope = fun(x), float(np.sum(gradient * direction))
    rounding = 1e-11 * max(abs(value), abs(slope), 1.0)

    def remainders_of(steps: Array) -> Array:
        return np.array([abs(fun(x + h * direction) - value - h * slope) for h in steps])

    def slope_of(remainders: Array) -> float:
        return float(np.log10((remainders[0] + 1e-300) / (remainders[1] + 1e-300)))

    steps = np.array([1e-3, 1e-4])
    remainders = remainders_of(steps)
    if np.all(remainders < rounding):
        return 2.0
    order = slope_of(remainders)
    return order if remainders[1] >= rounding else max(order, slope_of(remainders_of(10 * steps)))
