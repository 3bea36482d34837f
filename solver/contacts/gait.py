"""The walking or running cycle of a clip's keyframes, as a Gaussian process of its poses.

The poses (see `pose_vectors`) have a periodic part, which is its left-right mirror image half a period later, and a
smooth part for the rest. Nothing is learned from other clips. The likelihood of the keyframes measures how well a
period explains them. Several periods may explain sparse keyframes about equally (aliasing).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .. import quaternion as quat
from ..array import Array
from .pose_vectors import PoseVectors

LENGTH = 0.9  # [rad] length scale of the periodic kernel, of phase at half amplitude
DECAY = 4.0  # [periods] correlation length of successive cycles
PERIODIC, REST = 0.85, 0.15  # fractions of the variance of the two parts
NOISE = 1e-3  # noise as a fraction of the variance
QUARTER = 0.25  # least fraction of the spline's variance about the cycle that counts as the spline's error
SURE = 0.03  # [rad] negligible standard deviation


@dataclass(frozen=True, eq=False)
class PoseProcess:
    """A Gaussian process of keyframes' poses, before a period is chosen."""

    poses: PoseVectors

    def gain(self, period: float) -> float:
        """Return the log-likelihood of a period minus that of the best smooth motion, per given number."""
        return self._likelihood(self._across(period)) - self._smooth_likelihood

    @cached_property
    def _smooth_likelihood(self) -> float:
        blocks = np.kron(np.eye(self.poses.sides), np.ones((self.poses.times.size,) * 2))
        times = np.tile(self.poses.times, self.poses.sides)
        return max(self._likelihood(blocks * _smooth(times, times, length)) for length in self.poses.limits.alike)

    def _likelihood(self, covariance: Array) -> float:
        """Return the log-likelihood of all rows with their likeliest common variance, per entry, without constants."""
        rows = self.poses.rows
        covariance[np.diag_indices_from(covariance)] += NOISE
        root = np.linalg.cholesky(covariance)
        white = np.linalg.solve(root, rows)
        return float(-0.5 * np.log(np.mean(white**2)) - np.log(np.diag(root)).mean())

    def _across(self, period: float, at: Array | None = None) -> Array:
        """Return covariances of the rows (sides · n) with each other, or with the poses at times `at` (T,) [s]."""
        times, sides = self.poses.times, self.poses.sides
        shifted = np.concatenate([times + side * period / 2 for side in range(sides)])
        out = PERIODIC * _periodic(shifted if at is None else at, shifted, period)
        if at is not None:
            out[:, : times.size] += REST * _smooth(at, times, self.poses.limits.smooth)
            return out
        return out + self._rest

    @cached_property
    def _rest(self) -> Array:
        """Covariances of the part of the rows that does not repeat."""
        smooth = _smooth(self.poses.times, self.poses.times, self.poses.limits.smooth)
        return np.asarray(REST * np.kron(np.eye(self.poses.sides), smooth), dtype=np.float64)

    def predict(self, period: float, at: Array) -> tuple[Array, Array]:
        """Return the poses' vectors (T, D) at times (T,) [s], and the variance of each (T,) [rad²]."""
        rows = self.poses.rows
        covariance = self._across(period)
        covariance[np.diag_indices_from(covariance)] += NOISE
        across = self._across(period, at)
        root = np.linalg.cholesky(covariance)
        white, projected = np.linalg.solve(root, rows), np.linalg.solve(root, across.T)
        unexplained = np.maximum(PERIODIC + REST - np.sum(projected**2, axis=0), 0.0)
        return projected.T @ white, unexplained * float(np.mean(white**2))


def _smooth(a: Array, b: Array, length: float) -> Array:
    return np.exp(-0.5 * ((a[:, None] - b) / length) ** 2)


def _periodic(a: Array, b: Array, period: float) -> Array:
    apart = (a[:, None] - b) / period
    return np.exp(-2 * (np.sin(np.pi * apart) / LENGTH) ** 2 - 0.5 * (apart / DECAY) ** 2)


@dataclass(frozen=True, eq=False)
class GaitCycle:
    """A clip's cycle: its period, the confidence in it, and its poses between keyframes.

    period     [s]
    gain       log-likelihood minus that of the best smooth motion, per number given by the keyframes
    slip       mean speed of the slowest low sole point, relative to the travel speed; NaN if not computed
    times      (T,) [s] evenly spaced
    rotations  (T, q, 4) of links with quaternions, as in qpos, sign-continuous
    angles     (T, h) [rad] of the hinges
    heights    (T, f) [m] of the free root
    trust      (T,) ratio of the spline's variance about the cycle to the cycle's variance
    """

    poses: PoseVectors
    period: float
    gain: float
    slip: float
    times: Array
    rotations: Array
    angles: Array
    heights: Array
    trust: Array

    @classmethod
    def of(cls, process: PoseProcess, period: float, times: Array, plain: Array) -> GaitCycle:
        """Return the cycle with a period [s] at times (T,) [s]; `plain` (T, nq) is the spline through the keyframes."""
        poses = process.poses
        vectors, variance = process.predict(period, times)
        rotations = quat.align_signs(poses.map.rotations(vectors, times))
        unlike = float(np.mean((poses.map.vectors(poses.map.off_heading(plain, times)) - vectors) ** 2))
        trust = max(unlike - float(variance.mean()), QUARTER * unlike) / (variance + SURE**2)
        gain = process.gain(period)
        return cls(poses, period, gain, float("nan"), times, rotations, *poses.map.numbers(vectors), trust)

    def mean_trust(self, times: Array) -> Array:
        """Return the mean trust between K times, (K − 1,); 0 outside of the cycle."""
        at = np.linspace(times[:-1], times[1:], 9)[1:-1]
        return np.interp(at, self.times, self.trust, left=0, right=0).mean(axis=0)

    def qpos(self, width: int) -> Array:
        """Return configurations (T, width) with the root at the origin, except for its height."""
        out = np.zeros((self.times.size, width))
        columns = self.poses.map
        out[:, columns.columns.T] = self.rotations
        out[:, columns.hinges], out[:, columns.heights] = self.angles, self.heights
        return out
