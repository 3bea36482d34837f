"""Stances of a recording: intervals in which points of the soles are low and stay in one place.

Every sample has a likelihood under two models. A resting point is scattered about its position by noise and the
rolling of the foot; a moving point moves like a limb. The result is the likeliest segmentation of the recording into
stances and other intervals (B. Jackson et al. 2005). The height of a stance counts once, because an offset from the
ground lasts for the whole stance. A long rest thus outweighs any height, so that a point must also be near a surface
throughout its stance, and near the height of the lowest point of its foot: the heel of a kneeling or crouching person
hardly moves, but only the toe is planted.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from .. import array
from ..array import Array, Mask
from ..curve.recording import GAIN, NORMAL, ORDER, Track
from ..figure.algebra import cross
from ..figure.kinematics import Samples
from ..surface import Surface
from ..surface.heights import ground_at, heights_nearby
from ..surface.points import Point, arrays_of, places_of
from .contact import Contact
from .thresholds import Thresholds

DEAR = 6.0  # minus the log prior of a stance: one sample in e³ begins or ends one
SURE = 3.0  # largest difference between the means of two parts of one stance, in standard errors of the noise
LOOSE = 2.0  # largest speed at the ends of stances, in medians of the speeds during all stances of the recording
REMAINS = 0.2  # share of the noise of speeds that remains in a smoothed recording
FLATTEST = 0.1  # quantile of the heights in its stances at which a point of a sole is planted: soles may not be level
UP = np.array([0.0, 0, 1])  # normal of the ground on which points roll


def infer_stances(
    recorded: Track,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    smoothed: float = 0.0,
    *,
    aligned: bool = True,
) -> tuple[tuple[Contact, ...], tuple[Contact, ...]]:
    """Return the stances of points on surfaces, and the intervals in which they rest too high for a stance.

    Both are in the order of the points, and of time.

    smoothed  noise [m] of positions that an earlier search has smoothed. A point that rests only briefly then seems to
              move, so that a stance includes at least half of the samples that look like one.
    aligned   whether the recording is aligned with the ground. If not, the height of a point is measured from the
              lowest point of the soles, and from its own lowest stance.
    """
    if not points or not surfaces or recorded.times.size < ORDER:
        return (), ()
    limits, tracks = Thresholds.of(recorded.figure), _tracks(recorded, points)
    times, places, _, noises = tracks
    speeds, heights = _smooth(recorded, points, surfaces, times)
    near, high = _resting_runs(tracks, heights, points, surfaces, limits, aligned=aligned)
    largest = _largest_speed(speeds, near, limits) + REMAINS * smoothed / limits.lift_off
    largest = np.minimum(largest, limits.fast + noises / limits.lift_off)
    stances, raised = list[Contact](), list[Contact]()
    for i, point in enumerate(points):
        for contacts, run in [*((stances, run) for run in near[i]), *((raised, run) for run in high[i])]:
            usual = float(np.median(speeds[i, slice(*run)])) if smoothed else 0.0
            a, b = _trim(speeds[i] <= max(largest[i], min(usual, limits.fast)), *run)
            if b - a > 1:
                ground = ground_at(surfaces, places[:, i, a:b].mean(axis=1), point.radius, limits.same_spot)
                first, last = float(times[a]), float(times[b - 1])
                contacts.append(Contact(point, first, last, surface=ground, rolls=True))
    return tuple(stances), tuple(raised)


Runs = list[list[tuple[int, int]]]


def _resting_runs(
    tracks: tuple[Array, Array, Mask, Array],
    heights: Array,
    points: Sequence[Point],
    surfaces: Sequence[Surface],
    limits: Thresholds,
    *,
    aligned: bool,
) -> tuple[Runs, Runs]:
    """Return the runs of samples in which each point rests near surfaces, and those in which it rests above them.

    heights  (p, T) [m] of the smoothed motion
    """
    times, centres, is_known, noise = tracks
    height, _ = heights_nearby(surfaces, centres, np.array([point.radius for point in points]), limits.same_spot)
    moving = surprisal(times, centres, noise**2 + limits.rolls**2, is_known, limits)
    lowest = heights.min(axis=0)  # of the soles at each time, which a recording that drifts raises or lowers
    above = heights - (np.clip(lowest, 0, limits.same_spot) if aligned else lowest)
    links = np.array([point.link for point in points])
    tilt = heights - np.array([heights[links == link].min(axis=0) for link in links])
    near, high = Runs(), Runs()
    for i, point_noise in enumerate(noise.tolist()):
        cuts = _cut(times, centres[:, i], height[i], moving[i], is_known, point_noise, limits)
        runs = _join(times, cuts, centres[:, i], point_noise, limits)
        planted_height = 0.0 if aligned else min((float(above[i, a:b].mean()) for a, b in runs), default=0.0)
        flat = np.quantile(np.concatenate([tilt[i, a:b] for a, b in runs]), FLATTEST) if runs else 0.0
        unsure = SURE * REMAINS * point_noise
        is_near = (above[i] <= planted_height + limits.clear + unsure) & (tilt[i] <= flat + limits.moved + unsure)
        near.append([part for run in runs for part in _parts(is_near, *run)])
        high.append([part for run in runs for part in _parts(~is_near, *run)])
    return near, high


def largest_noise(recorded: Track, points: Sequence[Point]) -> float:
    """Return the largest noise [m] of the positions of any point."""
    if not points or recorded.times.size < ORDER:
        return 0.0
    return float(_tracks(recorded, points)[3].max())


def _tracks(recorded: Track, points: Sequence[Point]) -> tuple[Array, Array, Mask, Array]:
    """Return times (T,), positions (3, p, T) [m], which times are known (T,), and noise of the positions (p,) [m]."""
    step = max(1, round(recorded.rate * Thresholds.of(recorded.figure).lift_off))
    states = np.where(recorded.known > 0, recorded.states, recorded.bridged)[::step]
    centres, _ = places_of(points, Samples.still(recorded.figure, states))
    is_known = recorded.known.min(axis=1)[::step]
    return recorded.times[::step], centres, is_known > 0, position_noise(centres, is_known)


def _smooth(recorded: Track, points: Sequence[Point], surfaces: Sequence[Surface], times: Array) -> tuple[Array, Array]:
    """Return speeds [m/s] of the lowest material of round points, and heights [m], of the smoothed motion at times
    (T,), (p, T) each."""
    links, positions, radii = arrays_of(points)
    samples = Samples(recorded.figure, *recorded.path.motion(np.clip(times, *recorded.path.span)), t=times)
    motion = samples.links
    offset = np.einsum("ijpt,jp->ipt", motion.rotation[:, :, links], positions) - (radii * UP[:, None])[:, :, None]
    speeds = np.linalg.norm(motion.x_d[:, links] + cross(motion.omega[:, links], offset), axis=0)
    reach = Thresholds.of(recorded.figure).same_spot
    return speeds, heights_nearby(surfaces, places_of(points, samples)[0], radii, reach)[0]


def _largest_speed(speeds: Array, runs: Sequence[Sequence[tuple[int, int]]], limits: Thresholds) -> float:
    """Return the largest speed [m/s] of planted points, from speeds (p, T) and the runs of all points. It is higher in
    a recording with noise, or whose feet skate."""
    planted = [row[a:b] for row, cuts in zip(speeds, runs, strict=True) for a, b in cuts]
    still = limits.tiny / limits.lift_off
    return max(still, LOOSE * float(np.median(np.concatenate(planted)))) if any(map(len, runs)) else still


def position_noise(places: Array, known: Array) -> Array:
    """Return the noise (p,) [m] of positions (3, p, T) in every direction, from samples known at times (T,)."""
    if places.shape[-1] <= ORDER:
        return np.zeros(places.shape[1])
    windows = np.lib.stride_tricks.sliding_window_view(known, ORDER + 1).min(axis=-1) > 0
    if not windows.any():  # too few consecutive samples
        return np.zeros(places.shape[1])
    differences = np.abs(np.diff(places, ORDER, axis=-1))[..., windows] / GAIN
    return NORMAL * np.median(differences.swapaxes(0, 1).reshape(places.shape[1], -1), axis=1)


def _cut(
    times: Array, place: Array, height: Array, moving: Array, known: Mask, noise: float, limits: Thresholds
) -> list[tuple[int, int]]:
    """Return runs [a, b) of samples in which a point stands, from positions (3, T) [m] and heights (T,) [m].

    moving  (T,) minus the log density of its positions if it moves;  known  (T,) mask of samples
    """
    count, size = times.size, noise**2 + limits.rolls**2
    middle = place - place[:, known].mean(axis=1, keepdims=True)
    rows = (*middle, np.sum(middle**2, axis=0), height, np.ones(count), moving)
    sums = [np.concatenate([[0.0], np.cumsum(np.where(known, row, 0.0))]) for row in rows]
    longest = max(2, int(np.searchsorted(times, times[0] + limits.longest)))
    best, came = np.zeros(count + 1), np.full(count + 1, -1)
    for j in range(1, count + 1):
        best[j] = best[j - 1]
        a = np.arange(max(0, j - longest), j - 1)
        a = a[known[a]] if known[j - 1] else a[:0]
        if not a.size:
            continue
        x, y, z, squares, high, n, moved = (row[j] - row[a] for row in sums)
        scatter = (squares - (x**2 + y**2 + z**2) / n) / size + 3 * (n - 1) * np.log(2 * np.pi * size) + 3 * np.log(n)
        spread = limits.hovers**2 + noise**2 / n
        hover = (high / n) ** 2 / spread + np.log(2 * np.pi * spread / limits.away**2)
        total = best[a] + DEAR + 0.5 * (scatter + hover) - (moved - moving[a])
        total[np.abs(high / n) > limits.away / 2] = np.inf
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


def _join(
    times: Array, runs: list[tuple[int, int]], place: Array, noise: float, limits: Thresholds
) -> list[tuple[int, int]]:
    """Merge consecutive runs with the same mean position."""
    out: list[tuple[int, int]] = []
    for a, b in runs:
        if out and times[a] - times[out[-1][1] - 1] <= limits.moment:
            first, last = out[-1]
            apart = place[:, first:last].mean(axis=1) - place[:, a:b].mean(axis=1)
            if np.linalg.norm(apart) < limits.moved + SURE * noise / np.sqrt(min(last - first, b - a)):
                out[-1] = (first, b)
                continue
        out.append((a, b))
    return out


def _trim(still: Mask, first: int, last: int) -> tuple[int, int]:
    """Remove samples at both ends of a run at which the point is not still (T,)."""
    rests = first + np.flatnonzero(still[first:last])
    return (int(rests[0]), int(rests[-1]) + 1) if rests.size else (first, first)


def _parts(mask: Mask, first: int, last: int) -> list[tuple[int, int]]:
    """Return the intervals [a, b) within a run in which a mask (T,) holds."""
    return [(first + start, first + end) for start, end in array.runs(mask[first:last])]


def surprisal(times: Array, places: Array, variance: Array, known: Mask, limits: Thresholds) -> Array:
    """Return minus the log density [m⁻³] of positions (3, p, T) after the previous ones, (p, T); 0 where unknown.

    A point moves like a limb, in any direction. Its acceleration is white noise, so that its position is a twice
    integrated Wiener process, and a sample is the position plus noise. Kalman's filter (1960) gives the likelihood.

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
    variance_of_place, both, speed = np.array(variance), np.zeros(size), np.full(size, limits.lively * limits.moment)
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
