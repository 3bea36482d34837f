"""Which points of the soles stood when, read off a recording: those that were low and stayed where they were.

A stance is a run of samples whose places scatter by no more than the recording's noise and a foot that rolls explain;
of all ways to cut a recording into stances and what is none, the likeliest is taken (B. Jackson et al. 2005). A sample
of a stance speaks for it, one that is off its middle or over the ground against it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..array import Array
from ..figure.kinematics import Samples
from ..surface import Surface
from ..surface.heights import height_over
from ..surface.points import Point, places_of
from .recorded import GAIN, NORMAL, ORDER, Recorded

ROLLS = 0.015  # [m] that a point which stands may be off its middle, by and large
LOW, NEAR = 0.06, 0.03  # [m] over the ground: so high is a point that may as well stand as not; once it is set down
LONGEST = 1.0  # [s] of a stance that is looked at at once
FINEST = 60.0  # [1/s] samples that are told apart
ONE, NOISY = 1.0, 8.0  # what a stance costs beside what its samples speak for it: of a clean recording, of a noisy one
SUNK = 0.6  # of a height over the ground, as much a depth below it says against a stance
FAST = 0.35  # [m/s] from which on a point does not stand
SURE = 3.0  # noises that two samples may be apart
INTERRUPTED = 0.1  # [s] between runs that may be one stance
SAME = 0.03  # [m] between the middles of neighbouring runs that are one stance


class Stood(NamedTuple):
    """A point that stood from `first` to `last` [s]."""

    point: Point
    first: float
    last: float


def stood(
    recorded: Recorded, points: Sequence[Point], surfaces: Sequence[Surface], low: float = LOW
) -> tuple[Stood, ...]:
    """The stances of points on surfaces, point after point, in order of time.

    low  [m] how high a point is, in the mean of a stance, that may as well be none; more where samples are noisy
    """
    if not points or not surfaces or recorded.times.size < ORDER:
        return ()
    times, centres, noise = _seen(recorded, points)
    height, _ = height_over(surfaces, centres, np.array([point.radius for point in points]))
    found = []
    for i, point in enumerate(points):
        place, own = centres[:, i], float(noise[i])
        over = height[i] * np.where(height[i] < 0, SUNK, 1.0) / np.hypot(low, own)
        joined = _joined(times, _cut(times, place, over, own), place, own)
        runs = [_trimmed(times, place, *run, own) for run in joined]
        found += [Stood(point, float(times[a]), float(times[b - 1])) for a, b in runs if b - a > 1]
    return tuple(found)


def unsure(recorded: Recorded, points: Sequence[Point]) -> float:
    """[m] the noise of the place of the point that is known worst."""
    if not points or recorded.times.size < ORDER:
        return 0.0
    return float(_seen(recorded, points)[2].max())


def _seen(recorded: Recorded, points: Sequence[Point]) -> tuple[Array, Array, Array]:
    """Times (T,) that are told apart, places (3, p, T) [m] and the noise of these (p,)."""
    step = max(1, round(recorded.rate / FINEST))
    states = np.where(recorded.known > 0, recorded.states, recorded.bridged)[::step]
    centres, _, _ = places_of(points, Samples.still(recorded.figure, states))
    return recorded.times[::step], centres, white(centres, recorded.known.min(axis=1)[::step])


def white(places: Array, known: Array) -> Array:
    """(p,) [m] the noise of places (3, p, T), in every direction, where samples are known (T,)."""
    if places.shape[-1] <= ORDER:
        return np.zeros(places.shape[1])
    windows = np.lib.stride_tricks.sliding_window_view(known, ORDER + 1).min(axis=-1) > 0
    differences = np.abs(np.diff(places, ORDER, axis=-1))[..., windows] / GAIN
    return NORMAL * np.median(differences.swapaxes(0, 1).reshape(places.shape[1], -1), axis=1)


def _cut(times: Array, place: Array, height: Array, noise: float) -> list[tuple[int, int]]:
    """The runs [a, b) of samples of a point that stands, at places (3, T) [m], heights (T,) in such as count."""
    count, size = times.size, noise**2 + ROLLS**2
    dear = ONE + NOISY * noise**2 / size
    middle = place - place.mean(axis=1, keepdims=True)
    sums = [np.concatenate([[0.0], np.cumsum(row)]) for row in (*middle, np.sum(middle**2, axis=0), height)]
    longest = max(2, int(np.searchsorted(times, times[0] + LONGEST)))
    best, came = np.zeros(count + 1), np.full(count + 1, -1)
    for j in range(1, count + 1):
        a = np.arange(max(0, j - longest), j - 1)
        best[j] = best[j - 1]
        if not a.size:
            continue
        n = j - a
        x, y, z, squares, high = (row[j] - row[a] for row in sums)
        scatter = squares - (x**2 + y**2 + z**2) / n - 3 * (n - 1) * noise**2
        cost = dear + scatter / size + n * ((high / n) ** 2 - 1)
        total = best[a] + cost
        k = int(total.argmin())
        if total[k] < best[j]:
            best[j], came[j] = total[k], a[k]
    runs, j = [], count
    while j:
        if came[j] >= 0:
            runs.append((int(came[j]), j))
            j = int(came[j])
        else:
            j -= 1
    return runs[::-1]


def _joined(times: Array, runs: list[tuple[int, int]], place: Array, noise: float) -> list[tuple[int, int]]:
    """Runs that follow each other at once, with the same middle, as one."""
    out: list[tuple[int, int]] = []
    for a, b in runs:
        if out and times[a] - times[out[-1][1] - 1] <= INTERRUPTED:
            first, last = out[-1]
            apart = place[:, first:last].mean(axis=1) - place[:, a:b].mean(axis=1)
            if np.linalg.norm(apart) < SAME + SURE * noise / np.sqrt(min(last - first, b - a)):
                out[-1] = (first, b)
                continue
        out.append((a, b))
    return out


def _trimmed(times: Array, place: Array, first: int, last: int, noise: float) -> tuple[int, int]:
    """A run without the samples at its ends at which the point is faster than what stands."""
    way = np.linalg.norm(np.diff(place[:, first:last], axis=1), axis=0)
    slow = np.flatnonzero(way <= FAST * np.diff(times[first:last]) + SURE * noise)
    return (first + int(slow[0]), first + int(slow[-1]) + 2) if slow.size else (first, first)
