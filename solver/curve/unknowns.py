"""Unknowns: the decision vector x of a timeline, and the affine map from x to the rows that the spline interpolates.

x consists of the entries that are not fixed, so the keyframes are met for *every* x (§2 of the paper). A fixed joint of
a partial keyframe is a relative rotation. In world coordinates its row is Q_parent ⊗ q, linear in the unknown Q_parent.
A loop's last frame is the first, moved by its travel and turned. With held ends, the two adjacent frames depend on the
other rows. All of this is Y = constant + A x with a sparse A.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy import sparse

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure, quaternion_columns
from .frame import Frame, Timeline
from .seam import Seam
from .spline import Spline, spline_of


@dataclass(frozen=True, eq=False)
class Unknowns:
    """The map x -> rows (M + 2, N), and its transpose for gradients.

    Attributes:
        constant: The rows for x = 0, (M + 2, N).
        start: The x of the timeline itself, (n,).
        place: The index in the flattened rows of each unknown, rising, (n,).
        ties: The dependence of other entries of the rows on x, sparse ((M + 2) N, n); None without any.
    """

    constant: Array
    start: Array
    place: Index
    ties: sparse.csr_matrix | None

    @property
    def size(self) -> int:
        return self.start.size

    @cached_property
    def matrix(self) -> sparse.csr_matrix:
        """The linear part A of the map, sparse ((M + 2) N, n)."""
        ones = (np.ones(self.size), (self.place, np.arange(self.size)))
        matrix = sparse.csr_matrix(ones, shape=(self.constant.size, self.size))
        return matrix if self.ties is None else sparse.csr_matrix(matrix + self.ties)

    @cached_property
    def transposed(self) -> sparse.csr_matrix:
        """Aᵀ, sparse (n, (M + 2) N)."""
        return self.matrix.T.tocsr()

    def rows(self, x: Array) -> Array:
        """Return the rows (M + 2, N) for x (n,)."""
        if self.ties is not None:
            return self.constant + (self.matrix @ x).reshape(self.constant.shape)
        rows = self.constant.copy()
        rows.reshape(-1)[self.place] = x
        return rows

    def pulled_back(self, gradient: Array) -> Array:
        """Return dE/dx (n,) for dE/dY (M + 2, N)."""
        return gradient.reshape(-1)[self.place] if self.ties is None else self.transposed @ gradient.ravel()

    @classmethod
    def of(cls, figure: Figure, timeline: Timeline) -> Unknowns:
        rows = timeline.rows
        last = len(timeline.frames) - 1
        loose = _loose(figure, timeline)
        place = np.flatnonzero(loose)
        start = rows.reshape(-1)[place]
        constant = np.where(loose, 0.0, rows)
        ties = _Ties(constant, place)
        if figure.tables.in_world[figure.tables.ball_links].any():
            for i in np.flatnonzero(loose.any(axis=1) & ~loose.all(axis=1)):
                ties.turn(figure, timeline.frames[i], int(i))
        if timeline.ends == "periodic":
            seam = Seam.of(figure, timeline)
            ties.repeat(0, last, seam)
            ties.jump(np.array([last + 1, last + 2]), spline_of(timeline), seam)
        return cls(constant, start, place, ties.matrix())


def _loose(figure: Figure, timeline: Timeline) -> Mask:
    """Return which entries of the rows are unknowns, (M + 2, N); a quaternion is one as a whole."""
    loose = np.empty((len(timeline.frames) + 2, figure.width), bool)
    np.logical_not(timeline.fixed, out=loose[:-2])
    for columns in figure.tables.quaternion_columns.T:
        loose[:-2, columns] = loose[:-2, columns].any(axis=1, keepdims=True)
    loose[-2:] = np.array(timeline.free_slopes)[:, None]
    if timeline.ends == "periodic":
        loose[-3] = False
    return loose


class _Ties:
    """Collects dependences of row entries on unknowns, as (entry of the flattened rows, unknown, factor).

    Entries without a dependence are constant.
    """

    def __init__(self, constant: Array, place: Index) -> None:
        self.constant, self.place = constant, place
        self.width = constant.shape[1]
        self.entries = np.zeros(0, np.intp)
        self.unknowns = np.zeros(0, np.intp)
        self.factors = np.zeros(0)

    def _put(self, entries: Index, unknowns: Index, factors: Array) -> None:
        self.entries = np.append(self.entries, entries)
        self.unknowns = np.append(self.unknowns, unknowns)
        self.factors = np.append(self.factors, factors)

    def _of(self, first: int, last: int) -> tuple[Index, Index, Array]:
        """Return the dependences of rows first ... last − 1, the unknowns themselves included."""
        free = np.arange(*np.searchsorted(self.place, [first * self.width, last * self.width]))
        tied = np.flatnonzero((self.entries >= first * self.width) & (self.entries < last * self.width))
        entries = np.append(self.place[free], self.entries[tied])
        return entries, np.append(free, self.unknowns[tied]), np.append(np.ones(free.size), self.factors[tied])

    def turn(self, figure: Figure, frame: Frame, row: int) -> None:
        """Add child = parent ⊗ relative for the fixed joints of a partial keyframe, parents before children."""
        for joint in figure.tables.ball_links[figure.tables.in_world[figure.tables.ball_links]]:
            link = figure.links[joint]
            columns, parent = quaternion_columns(link), quaternion_columns(figure.links[link.parent])
            if columns is None or parent is None or not frame.fixed[columns].all():
                continue
            entries, unknowns, factors = self._of(row, row + 1)
            above = entries % self.width - parent.start
            in_parent = np.flatnonzero((above >= 0) & (above < 4))
            if not in_parent.size:
                continue
            relative = quat.product(quat.inverse(frame.state[parent]), frame.state[columns])
            matrix = quat.right_matrix(relative)
            child = row * self.width + columns.start + np.arange(4)
            self._put(
                np.tile(child, in_parent.size),
                np.repeat(unknowns[in_parent], 4),
                (matrix[:, above[in_parent]] * factors[in_parent]).T.ravel(),
            )
            self.constant[row, columns] = matrix @ self.constant[row, parent]

    def repeat(self, source: int, row: int, seam: Seam) -> None:
        """Make a row equal to an earlier one, mapped by the seam after one period."""
        self.constant[row] = seam.move(self.constant[source])
        entries, unknowns, factors = self._of(source, source + 1)
        column = entries % self.width
        cosine, sine = (seam.signs * wave(seam.angles) for wave in (np.cos, np.sin))
        self._put(row * self.width + column, unknowns, factors * cosine[column])
        other = seam.partners[column]
        turned = np.flatnonzero(other != column)
        self._put((row * self.width + other)[turned], unknowns[turned], (factors * sine[other])[turned])

    def jump(self, followers: Index, spline: Spline, seam: Seam) -> None:
        """Make the jump rows of a loop the linear map of the states that its seam requires."""
        self.constant[followers] = 0
        for columns, shares in seam.shares(spline):
            self.follow(followers, shares.real, columns, columns)
            if (seam.partners[columns] != columns).any():
                self.follow(followers, shares.imag, columns, seam.partners[columns])

    def follow(self, followers: Index, shares: Array, columns: Index, sources: Index) -> None:
        """Add a linear combination of the first R rows to other rows.

        Args:
            followers: The rows to add to, (F,).
            shares: The weights, (F, R).
            columns: The columns to add to, (C,).
            sources: The corresponding columns of the first R rows, (C,).
        """
        count = shares.shape[1]
        self.constant[np.ix_(followers, columns)] += shares @ self.constant[:count, sources]
        target = np.full(self.width, -1, np.intp)
        target[sources] = columns
        entries, unknowns, factors = self._of(0, count)
        row, column = np.divmod(entries, self.width)
        matching = np.flatnonzero(target[column] >= 0)
        for follower, share in zip(followers, shares, strict=True):
            self._put(
                follower * self.width + target[column[matching]],
                unknowns[matching],
                factors[matching] * share[row[matching]],
            )

    def matrix(self) -> sparse.csr_matrix | None:
        """Return the dependences as a sparse matrix ((M + 2) N, n); None without any."""
        if not self.entries.size:
            return None
        shape = (self.constant.size, self.place.size)
        return sparse.csr_matrix((self.factors, (self.entries, self.unknowns)), shape=shape)
