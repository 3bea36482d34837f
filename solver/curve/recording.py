"""A recording as a curve to track: smoothed according to its noise, and interpolated in gaps.

A sample is the motion plus white noise, whose size for every joint follows from differences of samples. The motion has
accelerations like those of people. The most likely curve is then a smoothing spline (G. Wahba 1978), which minimises
Σ trust (d − z)² / σ² + ∫ z''² / A. For any other curve this cost exceeds the minimum by the same expression of its
difference from the spline. So the penalty is on the difference and its acceleration, and the recording's detail costs
nothing. Outliers have less weight.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure
from ..tolerances import ROUNDING, TINY
from . import banded
from .spline import Path, natural_spline

LIVELINESS = np.geomspace(0.03, 300, 9)  # tried values of A: 10 is 20 rad/s² of a joint, or 10 m/s², up to 5 Hz
ORDER, GAIN = 4, np.sqrt(70.0)  # order of differences that contain little motion, and their gain for white noise
NORMAL = 1.4826  # ratio of a standard deviation to the median of absolute values
FAINT, FINE = np.radians(0.5), 0.002  # [rad], [m] least noise of samples at 120 Hz
ROBUST = 2.5  # deviation of a sample, in standard deviations, from which it has less weight
UNLIKE = 8.0  # deviation from the mean of the neighbours, in medians, from which the first curve omits a sample
ROUNDS = 4  # most updates of the weights


def groups(figure: Figure) -> list[Index]:
    """Return the columns of a state, or of qpos, recorded together: positions of roots, quaternions, single joints."""
    tables = figure.tables
    whole = [*tables.position_columns.T, *tables.quaternion_columns.T]
    single = np.setdiff1d(np.arange(figure.width), np.concatenate([*whole, np.zeros(0, np.intp)]))
    return [*whole, *single[:, None]]


def places(figure: Figure) -> Mask:
    """Return the mask (N,) of the columns of a state, or of qpos, in metres: positions of roots, and slides."""
    out = np.zeros(figure.width, bool)
    out[np.concatenate([figure.tables.position_columns.ravel(), figure.tables.slide_columns])] = True
    return out


def between(figure: Figure, first: Array, last: Array, known: Mask) -> Array:
    """Return displacements (K, N) between states (K, N), zero for entries that are not known (K, N).

    They are rotation vectors in the links' axes, in the first three columns of quaternions, and differences otherwise.
    """
    offset = np.where(known, last - first, 0.0)
    for columns in figure.tables.quaternion_columns.T:
        turn = quat.rotation_vector(quat.product(quat.inverse(first[:, columns]), last[:, columns]))
        whole = np.all(known[:, columns], axis=1, keepdims=True)
        offset[:, columns] = np.pad(np.where(whole, turn, 0.0), ((0, 0), (0, 1)))
    return offset


@dataclass(frozen=True, eq=False)
class Track:
    """Samples of a figure's motion, some of them unknown.

    times  (T,) [s], rising
    states (T, N) as recorded, quaternions unit and sign-continuous; arbitrary in gaps
    known  (T, N) 1 for samples, 0 in gaps
    exact  whether the samples are of a computed motion, so that the curve interpolates them
    """

    figure: Figure
    times: Array
    states: Array
    known: Array
    exact: bool = False

    @classmethod
    def of(cls, figure: Figure, times: Array, qpos: Array, known: Array | None = None, *, exact: bool = False) -> Track:
        """Return the track of qpos (T, nq) at times (T,) [s]; known (T, N) or (T, 1), everything by default."""
        states = np.array(figure.to_state(qpos))
        every = np.ones(states.shape) if known is None else np.ones(states.shape) * known
        for columns in figure.tables.quaternion_columns.T:
            samples = np.flatnonzero((every[:, columns] > 0).all(axis=1))  # values in gaps must not affect signs
            states[samples[:, None], columns] = quat.align_signs(states[samples[:, None], columns])
        return cls(figure, np.asarray(times, float), states, every, exact)

    def move(self, shift: ArrayLike) -> Track:
        """Return the recording with all free roots translated by (3,) [m]."""
        states = np.array(self.states)
        for columns in self.figure.tables.position_columns.T:
            states[:, columns] += np.asarray(shift, float)
        return replace(self, states=states)

    def turn(self, columns: slice, turn: Array) -> Track:
        """Return the recording with the link of a quaternion rotated by (4,) in its axes, at all times."""
        states = np.array(self.states)
        states[:, columns] = quat.product(states[:, columns], turn)
        return replace(self, states=states)

    def displace(self, displacements: Array) -> Track:
        """Return the recording with every sample displaced by (T, N) as in `between`."""
        states = self.states + displacements
        for columns in self.figure.tables.quaternion_columns.T:
            turn = quat.from_rotation_vector(displacements[:, columns[:3]])
            states[:, columns] = quat.product(self.states[:, columns], turn)
        return replace(self, states=states)

    @cached_property
    def groups(self) -> list[Index]:
        return groups(self.figure)

    @cached_property
    def is_place(self) -> Mask:
        """(N,) whether a column is in metres."""
        return places(self.figure)

    @cached_property
    def is_half(self) -> Mask:
        """(N,) whether a column is of a quaternion, which changes by half an angle."""
        out = np.zeros(self.figure.width, bool)
        out[self.figure.tables.quaternion_columns.ravel()] = True
        return out

    @cached_property
    def noise(self) -> Array:
        """(N,) standard deviation of the noise of a sample, the same for all columns of a group."""
        out = np.where(self.is_place, FINE, np.where(self.is_half, FAINT / 2, FAINT)) * np.sqrt(self.rate / 120)
        if self.times.size <= ORDER:
            return out
        differences = np.abs(np.diff(self.states, ORDER, axis=0)) / GAIN
        windows = np.lib.stride_tricks.sliding_window_view(self.known, ORDER + 1, axis=0).min(axis=-1) > 0
        for columns in self.groups:
            differences_seen = differences[:, columns][windows[:, columns]]
            if differences_seen.size:
                out[columns] = np.maximum(out[columns], NORMAL * np.median(differences_seen))
        return out

    @cached_property
    def rate(self) -> float:
        """The sampling rate [1/s]."""
        return float(1 / np.median(np.diff(self.times)))

    @cached_property
    def path(self) -> Path:
        return natural_spline(self.times, self._smoothing[0])

    @property
    def bridged(self) -> Array:
        """(T, N) the most likely curve at the samples."""
        return self._smoothing[0]

    @cached_property
    def trust(self) -> Array:
        """(T, N) weight of every sample, 0 in gaps."""
        return self._smoothing[1]

    @cached_property
    def liveliness(self) -> Array:
        """(N,) A, the power spectral density of accelerations: [1/s³] of a quaternion's entries, or [m²/s³]."""
        return self._smoothing[2]

    @cached_property
    def _smoothing(self) -> tuple[Array, Array, Array]:
        """The curve at the samples (T, N), their weights (T, N), and the liveliness (N,)."""
        smooth, trust, lively = np.array(self.states), np.array(self.known), np.ones(self.figure.width)
        if self.exact:
            return smooth, trust, lively
        for columns in self.groups:
            noise = float(self.noise[columns[0]])
            trust[:, columns] *= self._unlike(columns, noise)[:, None]
            for _ in range(ROUNDS):
                smooth[:, columns], lively[columns] = self._likeliest(columns, trust[:, columns[0]] / noise**2)
                off = np.linalg.norm(self.states[:, columns] - smooth[:, columns], axis=1) / noise
                bound = ROBUST * np.sqrt(columns.size)
                believed = np.minimum(1.0, bound / np.maximum(off, TINY)) ** 2
                trust[:, columns] = self.known[:, columns] * believed[:, None]
                if believed.min() == 1:
                    break
        return smooth, trust, lively

    def _unlike(self, columns: Index, noise: float) -> Array:
        """Return the first weights (T,): zero for samples exceptionally far from their neighbours' mean, else one."""
        out, values = np.ones(self.times.size), self.states[:, columns]
        off = np.linalg.norm(values[1:-1] - 0.5 * (values[:-2] + values[2:]), axis=1)
        if off.size < ORDER:
            return out
        beside = np.maximum(np.append(off[1:], 0), np.append(0, off[:-1]))
        usual = max(float(np.median(off)), noise)
        out[1:-1] = (off <= UNLIKE * usual) | (off < beside)
        return out

    def _likeliest(self, columns: Index, weight: Array) -> tuple[Array, float]:
        """Return the most likely curve (T, k), and its liveliness A."""
        fitted = [(*self._fit(columns, weight, float(prior)), float(prior)) for prior in LIVELINESS]
        smooth, _, prior = max(fitted, key=lambda found: found[1])
        return smooth, prior

    def _fit(self, columns: Index, weight: Array, prior: float) -> tuple[Array, float]:
        """Return the curve (T, k) that minimises Σ weight (d − z)² + ∫ z''² / A, and the log-likelihood of A."""
        count = self.times.size
        if count < 3:
            return self.states[:, columns], 0.0
        h = np.diff(self.times)
        inner = 0.5 * (h[1:] + h[:-1])
        rows = np.stack([1 / h[:-1], -1 / h[:-1] - 1 / h[1:], 1 / h[1:]]) / np.sqrt(inner * prior)
        band = np.zeros((count, 3))
        band[:, 0] = weight + ROUNDING * max(float(weight.max()), 1.0)  # in gaps, by acceleration alone
        for a in range(3):
            for b in range(a, 3):
                band[a : count - 2 + a, b - a] += rows[a] * rows[b]
        samples = np.where(self.known[:, columns] > 0, self.states[:, columns], 0.0)
        right = weight[:, None] * samples
        factor = banded.cholesky(band)
        if factor is None:
            raise ValueError("a recording without two samples of a joint")
        smooth = banded.solve(factor, right)
        least = float(np.sum(right * (samples - smooth)))
        size = 2 * float(np.sum(np.log(factor[:, 0]))) + (count - 2) * np.log(prior)
        return smooth, -0.5 * (least + columns.size * size)
