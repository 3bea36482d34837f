"""The Taylor test of a gradient: |f(x + hd) − f(x) − h g·d| must fall as h²."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from dynsplines.solver.array import Array


def taylor_slope(fun: Callable[[Array], float], x: Array, gradient: Array, rng: np.random.Generator) -> float:
    """The slope of log remainder over log step between two steps, 2 for an exact gradient of a smooth function.

    A function that is linear along the direction leaves only rounding: its slope counts as 2. Where the smaller step
    leaves only rounding, both are ten times as long.
    """
    direction = rng.normal(size=x.shape)
    direction /= np.linalg.norm(direction)
    value, slope = fun(x), float(np.sum(gradient * direction))
    rounding = 1e-11 * max(abs(value), abs(slope), 1.0)

    def remainders_of(steps: Array) -> Array:
        return np.array([abs(fun(x + h * direction) - value - h * slope) for h in steps])

    steps = np.array([1e-3, 1e-4])
    remainders = remainders_of(steps)
    if np.all(remainders < rounding):
        return 2.0
    if remainders[1] < rounding:
        steps = 10 * steps
        remainders = remainders_of(steps)
    return float(np.diff(np.log(remainders + 1e-300))[0] / np.diff(np.log(steps))[0])
