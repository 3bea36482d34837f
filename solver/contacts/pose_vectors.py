"""Poses as vectors: the deviation of joints from their mean, without position and heading.

A rotation becomes its rotation vector from the mean rotation, a hinge its angle, and the root's height a length. The
heading is removed as a polynomial of time, so that poses of a turning figure are comparable. If left and right can be
exchanged, every pose occurs twice: unchanged and mirrored.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import Polynomial

from .. import quaternion as quat
from ..array import Array, Index
from ..curve.frame import Timeline
from ..curve.mirror import Mirror
from ..curve.symmetry import UNEVEN
from ..figure.figure import Figure
from ..tolerances import SINGLE
from .thresholds import Thresholds

FEW = 8  # most poses for which the heading is only a linear function of time
LENGTH = 0.9  # [rad] length scale of the periodic kernel, of phase at half amplitude
DECAY = 4.0  # [periods] correlation length of successive cycles
PERIODIC, REST = 0.85, 0.15  # fractions of the variance of the two parts
NOISE = 1e-3  # noise as a fraction of the variance
EVEN, BENT = 1, 3  # degrees of the heading's polynomial for few and for more poses


@dataclass(frozen=True, eq=False)
class PoseMap:
    """A map from configurations to vectors of D entries, and back.

    heading   the angle [rad] of the root's x axis about z over time [s]
    links     (q,) with quaternions; their columns in qpos (4, q) and mean rotations (q, 4)
    root      (f,) indices of the free ones among them
    hinges    (h,) columns in qpos
    heights   (f,) columns of the free root's height, and its mean [m]
    up        [rad/m] rotation of a joint that corresponds to a metre of height
    """

    heading: Polynomial
    links: Index
    root: Index
    columns: Index
    means: Array
    hinges: Index
    heights: Index
    mean_height: float
    up: float

    def off_heading(self, qpos: Array, times: Array) -> Array:
        """Return configurations (T, nq) at times (T,) [s] without the heading."""
        out = qpos.copy()
        for i in self.root:
            columns = self.columns[:, i]
            out[:, columns] = quat.product(_about_z(-self.heading, times), qpos[:, columns])
        return out

    def vectors(self, qpos: Array) -> Array:
        """Return vectors (T, D) [rad] of configurations (T, nq) without heading."""
        turned = quat.rotation_vector(quat.product(quat.inverse(self.means), qpos[:, self.columns.T]))
        up = self.up * (qpos[:, self.heights] - self.mean_height)
        return np.hstack([turned.reshape(len(qpos), -1), qpos[:, self.hinges], up])

    def rotations(self, vectors: Array, times: Array) -> Array:
        """Return rotations (T, q, 4) of the links with quaternions, as in qpos, with the heading."""
        count = self.links.size
        out = quat.product(self.means, quat.from_rotation_vector(vectors[:, : 3 * count].reshape(-1, count, 3)))
        out[:, self.root] = quat.product(_about_z(self.heading, times)[:, None], out[:, self.root])
        return out

    def numbers(self, vectors: Array) -> tuple[Array, Array]:
        """Return the hinges' angles (T, h) [rad] and the root's height (T, f) [m]."""
        first = 3 * self.links.size
        last = first + self.hinges.size
        return vectors[:, first:last], vectors[:, last:] / self.up + self.mean_height


@dataclass(frozen=True, eq=False)
class PoseVectors:
    """The complete keyframes of a figure with at most one free joint.

    times  (n,) [s]
    rows   (sides · n, D) [rad] all poses, and with `sides` 2 also all mirrored ones
    """

    map: PoseMap
    times: Array
    rows: Array
    sides: int
    limits: Thresholds = Thresholds()  # noqa: RUF009 - frozen

    @classmethod
    def of(cls, figure: Figure, keys: Timeline) -> PoseVectors | None:
        """Return the vectors; None for fewer than three complete keyframes, equal poses, or several free joints."""
        whole = [frame for frame in keys.frames if frame.is_key]
        tables = figure.tables
        if len(whole) < 3 or tables.free_links.size > 1:
            return None
        times = np.array([frame.time for frame in whole])
        qpos = figure.to_qpos(np.array([frame.state for frame in whole]))
        heading = Polynomial([0.0])
        for column in tables.position_columns[0]:
            turn = slice(column + 3, column + 7)
            heading = heading_of(times, qpos[:, turn])
            qpos[:, turn] = quat.product(_about_z(-heading, times), qpos[:, turn])
        try:
            poses = np.concatenate([qpos, Mirror.of(figure, middle=UNEVEN).configurations(qpos)])
        except ValueError:
            poses = qpos
        columns = tables.quaternion_columns
        means = np.array([_mean(poses[:, block]) for block in columns.T]).reshape(-1, 4)
        heights = tables.position_columns[2]
        mean_height = float(poses[:, heights].mean()) if heights.size else 0.0
        root = np.flatnonzero(np.isin(tables.quaternion_links, tables.free_links))
        links, hinges, limits = tables.quaternion_links, tables.hinge_columns, Thresholds.of(figure)
        drawn = PoseMap(heading, links, root, columns, means, hinges, heights, mean_height, limits.height_turn)
        rows = drawn.vectors(poses)
        return None if np.ptp(rows, axis=0).max() < SINGLE else cls(drawn, times, rows, len(poses) // len(qpos), limits)

    def gain(self, period: float) -> float:
        """Return the log-likelihood of a period minus that of the best smooth motion, per given number."""
        return self._likelihood(self._across(period)) - self._smooth_likelihood

    @cached_property
    def _smooth_likelihood(self) -> float:
        blocks = np.kron(np.eye(self.sides), np.ones((self.times.size,) * 2))
        times = np.tile(self.times, self.sides)
        return max(self._likelihood(blocks * _smooth(times, times, length)) for length in self.limits.smooth)

    def _likelihood(self, covariance: Array) -> float:
        """Return the log-likelihood of all rows with their likeliest common variance, per entry, without constants."""
        rows = self.rows
        covariance[np.diag_indices_from(covariance)] += NOISE
        root = np.linalg.cholesky(covariance)
        white = np.linalg.solve(root, rows)
        return float(-0.5 * np.log(np.mean(white**2)) - np.log(np.diag(root)).mean())

    def _across(self, period: float, at: Array | None = None) -> Array:
        """Return covariances of the rows (sides · n) with each other, or with the poses at times `at` (T,) [s]."""
        times, sides = self.times, self.sides
        shifted = np.concatenate([times + side * period / 2 for side in range(sides)])
        out = PERIODIC * _periodic(shifted if at is None else at, shifted, period)
        if at is not None:
            out[:, : times.size] += REST * _smooth(at, times, self.limits.smooth[0])
            return out
        return out + self._rest

    @cached_property
    def _rest(self) -> Array:
        """Covariances of the part of the rows that does not repeat."""
        smooth = _smooth(self.times, self.times, self.limits.smooth[0])
        return np.asarray(REST * np.kron(np.eye(self.sides), smooth), dtype=np.float64)

    def predict(self, period: float, at: Array) -> tuple[Array, Array]:
        """Return the poses' vectors (T, D) at times (T,) [s], and the variance of each (T,) [rad²]."""
        rows = self.rows
        covariance = self._across(period)
        covariance[np.diag_indices_from(covariance)] += NOISE
        across = self._across(period, at)
        root = np.linalg.cholesky(covariance)
        white, projected = np.linalg.solve(root, rows), np.linalg.solve(root, across.T)
        unexplained = np.maximum(PERIODIC + REST - np.sum(projected**2, axis=0), 0.0)
        return projected.T @ white, unexplained * float(np.mean(white**2))


def heading_of(times: Array, rotations: Array) -> Polynomial:
    """Return the angle [rad] of the x axis about z over time, for orientations (n, 4) at times (n,) [s]."""
    ahead = quat.rotate(rotations, np.array([1.0, 0, 0]))
    angle = np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0]))
    return Polynomial.fit(times, angle, BENT if times.size > FEW else EVEN)


def _about_z(angle: Polynomial, times: Array) -> Array:
    """Return the rotations (T, 4) about z by an angle [rad] at times (T,) [s]."""
    return quat.from_rotation_vector(angle(times)[:, None] * np.array([0.0, 0, 1]))


def _mean(rotations: Array) -> Array:
    """Return the mean of unit quaternions (n, 4), independent of their signs."""
    return np.linalg.eigh(rotations.T @ rotations)[1][:, -1]


def _smooth(a: Array, b: Array, length: float) -> Array:
    return np.exp(-0.5 * ((a[:, None] - b) / length) ** 2)


def _periodic(a: Array, b: Array, period: float) -> Array:
    apart = (a[:, None] - b) / period
    return np.exp(-2 * (np.sin(np.pi * apart) / LENGTH) ** 2 - 0.5 * (apart / DECAY) ** 2)
