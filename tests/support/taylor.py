"""The Taylor test of a gradient: |f(x + hd) − f(x) − h g·d| must fall as h²."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from dynsplines.solver.array import Array


def taylor_slope(fun: Callable[[Array], float], x: Array, gradient: Array, rng: np.random.Generator) -> float:
    """The slope of log remainder over log step between two steps, 2 for an exact gradient of a smooth function.

    A function that is linear along the direction leaves only rounding: its slope counts as 2.
    """
    direction = rng.normal(size=x.shape)
    direction /= np.linalg.norm(direction)
    value, slope = fun(x), float(np.sum(gradient * direction))
    steps = np.array([1e-3, 1e-4])
    remainders = np.array([abs(fun(x + h * direction) - value - h * slope) for h in steps])
    scale = max(abs(value), abs(slope), 1.0)
    if np.all(remainders < 1e-11 * scale):
        return 2.0
    return float(np.diff(np.log(remainders + 1e-300))[0] / np.diff(np.log(steps))[0])
