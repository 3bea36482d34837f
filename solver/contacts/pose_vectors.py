"""Poses as vectors: what a figure's joints do about their mean, wherever it is and wherever it faces.

A rotation becomes its rotation vector from the mean of all, a hinge its angle, the root's height a length. The heading
is taken off as a polynomial of time, so that poses of a figure that turns are alike. Where left and right can be
exchanged, every pose comes twice: as it is, and mirrored.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index
from ..curve.frame import Timeline
from ..curve.mirror import Mirror
from ..curve.symmetry import MirrorError
from ..figure.figure import Figure, quaternion_columns
from .thresholds import Thresholds

LOPSIDED = 0.05  # of its size, how far from symmetric a measured body may be
STILL = 1e-6  # [rad] poses that differ by less than this carry no information
FEW = 8  # poses up to which an evenly changing heading is their only information
EVEN, BENT = 1, 3  # degrees of the heading's polynomial


@dataclass(frozen=True, eq=False)
class Heading:
    """The way that a figure faces, about z, as a polynomial of the time from `middle` [s]."""

    coefficients: Array
    middle: float

    @classmethod
    def of(cls, times: Array, rotations: Array) -> Heading:
        """Of the root's orientations (n, 4) at times (n,) [s]: where its x axis points."""
        ahead = quat.rotated(rotations, np.array([1.0, 0, 0]))
        angle, middle = np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0])), float(np.mean(times))
        degree = min(BENT if times.size > FEW else EVEN, times.size - 2)
        return cls(np.polyfit(times - middle, angle, max(degree, 0)), middle)

    def turn(self, times: Array, sign: int = 1) -> Array:
        """(n, 4) the rotation to the heading, or with sign −1 off it."""
        angle = sign * np.polyval(self.coefficients, times - self.middle)
        return quat.from_rotation_vector(angle[:, None] * np.array([0.0, 0, 1]))


@dataclass(frozen=True, eq=False)
class PoseMap:
    """Configurations as vectors of D entries, and back.

    links     (q,) with quaternions; their columns in qpos (4, q) and mean rotations (q, 4)
    root      which of them (f,) are free
    hinges    (h,) columns in qpos
    heights   (f,) columns of the free root's height, and its mean [m]
    up        [rad/m] turn of a joint that counts like a metre of height
    """

    heading: Heading
    links: Index
    root: Index
    columns: Index
    means: Array
    hinges: Index
    heights: Index
    mean_height: float
    up: float

    def off_heading(self, qpos: Array, times: Array) -> Array:
        """Configurations (T, nq) at times (T,) [s] with the heading taken off."""
        out = qpos.copy()
        for i in self.root:
            out[:, self.columns[:, i]] = quat.product(self.heading.turn(times, -1), qpos[:, self.columns[:, i]])
        return out

    def vectors(self, qpos: Array) -> Array:
        """(T, D) [rad] of configurations (T, nq) whose heading is off."""
        turned = quat.rotation_vector(quat.product(quat.inverse(self.means), qpos[:, self.columns.T]))
        up = self.up * (qpos[:, self.heights] - self.mean_height)
        return np.hstack([turned.reshape(len(qpos), -1), qpos[:, self.hinges], up])

    def rotations(self, vectors: Array, times: Array) -> Array:
        """(T, q, 4) the rotations of the links with quaternions, as in qpos, the heading on."""
        count = self.links.size
        out = quat.product(self.means, quat.from_rotation_vector(vectors[:, : 3 * count].reshape(-1, count, 3)))
        out[:, self.root] = quat.product(self.heading.turn(times)[:, None], out[:, self.root])
        return out

    def numbers(self, vectors: Array) -> tuple[Array, Array]:
        """The hinges' angles (T, h) [rad] and the root's height (T, f) [m]."""
        first = 3 * self.links.size
        last = first + self.hinges.size
        return vectors[:, first:last], vectors[:, last:] / self.up + self.mean_height


@dataclass(frozen=True, eq=False)
class PoseVectors:
    """The whole keyframes of a figure with one free joint, or none.

    times  (n,) [s]
    rows   (sides · n, D) [rad] all poses as they are, then, if sides is 2, all mirrored
    limits of the figure
    """

    map: PoseMap
    times: Array
    rows: Array
    sides: int
    limits: Thresholds = Thresholds()  # noqa: RUF009 - frozen

    @classmethod
    def of(cls, figure: Figure, keys: Timeline) -> PoseVectors | None:
        """None where there are less than three whole keyframes, all of one pose, or several free joints."""
        whole = [frame for frame in keys.frames if frame.is_key]
        tables = figure.tables
        if len(whole) < 3 or tables.free_links.size > 1:
            return None
        times = np.array([frame.time for frame in whole])
        qpos = figure.to_qpos(np.array([frame.state for frame in whole]))
        heading = Heading(np.zeros(1), 0.0)
        for column in tables.position_columns[0]:
            turn = slice(column + 3, column + 7)
            heading = Heading.of(times, qpos[:, turn])
            qpos[:, turn] = quat.product(heading.turn(times, -1), qpos[:, turn])
        try:
            poses = np.concatenate([qpos, Mirror.of(figure, LOPSIDED).configurations(qpos)])
        except MirrorError:
            poses = qpos
        quaternions = [quaternion_columns(figure.links[i]) for i in tables.quaternion_links]
        columns = np.array(
            [np.arange(figure.width)[block] for block in quaternions if block is not None], np.intp
        ).reshape(-1, 4)
        means = np.array([_mean(poses[:, block]) for block in columns]).reshape(-1, 4)
        heights = tables.position_columns[2]
        mean_height = float(poses[:, heights].mean()) if heights.size else 0.0
        root = np.flatnonzero(np.isin(tables.quaternion_links, tables.free_links))
        links, hinges, limits = tables.quaternion_links, tables.hinge_columns, Thresholds.of(figure)
        drawn = PoseMap(heading, links, root, columns.T, means, hinges, heights, mean_height, limits.height_turn)
        rows = drawn.vectors(poses)
        return None if np.ptp(rows, axis=0).max() < STILL else cls(drawn, times, rows, len(poses) // len(qpos), limits)


def _mean(rotations: Array) -> Array:
    """The mean of unit quaternions (n, 4), whatever their signs."""
    return np.linalg.eigh(rotations.T @ rotations)[1][:, -1]
