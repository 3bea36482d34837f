"""The likelihood of the recorded positions of a point that moves like a limb, in any direction.

The acceleration is white noise, so that the position is a twice integrated Wiener process, and a sample is the position
plus noise. Kalman's filter (1960) gives the likelihood of every sample after the previous ones.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ..array import Array, Mask
from .thresholds import Thresholds


def surprisal(times: Array, places: Array, variance: Array, known: Mask, limits: Thresholds) -> Array:
    """Return minus the log density [m⁻³] of positions (3, p, T) after the previous ones, (p, T); 0 where unknown.

    times     (T,) [s], rising
    variance  (p,) [m²] of a sample, in every direction
    known     (T,) mask of samples; the first sample has no density
    limits    thresholds of the figure
    """
    count, size = times.size, variance.size
    out = np.zeros((size, count))
    samples = np.flatnonzero(known)
    if not samples.size:
        return out
    place, velocity = places[:, :, samples[0]], np.zeros((3, size))
    variance_of_place, both, speed = np.array(variance), np.zeros(size), np.full(size, limits.fastest**2)
    for before, now in pairwise(samples.tolist()):
        h = float(times[now] - times[before])
        place = place + h * velocity
        variance_of_place, both = (
            variance_of_place + h * (2 * both + h * speed) + limits.lively * h**3 / 3,
            both + h * speed + limits.lively * h**2 / 2,
        )
        speed = speed + limits.lively * h
        expected, off = variance_of_place + variance, places[:, :, now] - place
        out[:, now] = 0.5 * np.sum(off**2, axis=0) / expected + 1.5 * np.log(2 * np.pi * expected)
        place, velocity = place + variance_of_place / expected * off, velocity + both / expected * off
        variance_of_place, both, speed = (
            variance_of_place - variance_of_place**2 / expected,
            both - variance_of_place * both / expected,
            speed - both**2 / expected,
        )
    return out
