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
from numpy.typing import ArrayLike
from scipy import sparse

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure, JointKind, Link, quaternion_columns
from ..tolerances import ROUNDING
from .frame import Frame, Timeline, TimelineError
from .loop_keys import close_loop
from .seam import Seam, sameness
from .spline import Sampling, Spline, natural_end_slopes, spline_of
from .winding import signs

SURELY_MORE = 1e-17  # [1] squared norm of quaternions above which keyframes need no further checks


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
        width, rows = figure.width, timeline.rows
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
        if timeline.ends == "held":
            adjacent = np.array([1, last - 1])
            shares = spline_of(timeline).end_shares()
            columns = np.arange(width)
            constant[adjacent] = rows[adjacent] - shares @ rows
            ties.follow(adjacent, shares, columns, columns)
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
    if timeline.ends == "held":
        loose[[1, -4]] = False
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
        self.constant[row] = seam.moved(self.constant[source])
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


def raw_timeline(
    figure: Figure,
    keys: list[Frame],
    ends: str = "free",
    end_slope: Array | None = None,
    travel: ArrayLike | None = None,
    turn: float | None = None,
) -> Timeline:
    """Return the keyframes' timeline in the figure's coordinates, with the natural spline's end slopes (method of §2).

    Signs of quaternions are chosen so that joints turn by the shortest arcs. Unspecified degrees of freedom start where
    they were posed, otherwise on the natural spline through the other keyframes (of rotations relative to the parent),
    or at the rest pose if no keyframe specifies them. In a loop, entries that the first or the last keyframe fixes are
    fixed in both.

    Args:
        keys: Keyframes that hold *qpos* and the fixed mask, in order of time.
        ends: "free", "clamped", "clamped start", "clamped end" or "periodic", see `Timeline`.
        end_slope: The slopes of clamped ends, (2, N); the row of a free end is ignored.
        travel: Displacement of a loop's root over one period, (3,) [m]; None: x and y from the keyframes.
        turn: Rotation of a loop's root about the vertical over one period [rad]; None: from the keyframes.

    Raises:
        TimelineError: The keyframes are invalid, or end_slope, travel or turn do not match the ends.
    """
    _check(figure, keys)
    seam = None
    if ends == "periodic" and len(keys) > 1:
        keys, seam = close_loop(figure, keys, travel, turn)
    elif travel is not None or turn is not None:
        name = "travel" if travel is not None else "turn"
        raise TimelineError(f"{name} is for ends = 'periodic', not '{ends}'")
    plain = Timeline(tuple(keys), np.zeros((2, figure.width)))
    states = np.array(plain.states)
    rest = np.array(figure.model.qpos0)
    specified, samplings = plain.known, dict[bytes, Sampling]()
    for link in figure.links[1:]:
        if link.kind is JointKind.FREE:
            for column in range(link.qpos, link.qpos + 3):
                _fill(plain.times, states, specified, slice(column, column + 1), rest, samplings)
        columns = quaternion_columns(link)
        if columns is None:
            _fill(plain.times, states, specified, slice(link.qpos, link.qpos + 1), rest, samplings)
            continue
        fixed = specified[:, columns].all(axis=1)
        base = bases(figure, states, link)
        states[fixed, columns] = quat.product(base[fixed], quat.normalised(states[fixed, columns]))
        if not fixed.all():
            relative = quat.product(quat.inverse(base), states[:, columns])
            relative[fixed] *= signs(plain.times[fixed], relative[fixed], spins=link.kind is JointKind.FREE)[:, None]
            states[:, columns] = relative
            _fill(plain.times, states, specified, columns, rest, samplings)
            states[:, columns] = quat.product(base, quat.normalised(states[:, columns]))
        if seam is not None and link.kind is JointKind.FREE:
            states[-1, columns] = seam.linear(states[0])[columns]
        elif seam is not None:  # relative to its parent, the last rotation is the first
            states[-1, columns] = quat.product(base[-1], quat.product(quat.inverse(base[0]), states[0, columns]))
        states[:, columns] = _signed_track(link, plain.times, base, states[:, columns])
    if seam is not None:
        lifted = Seam.turned(figure, states[0], states[-1], seam.headings)
        states[-1] = lifted.linear(states[0]) + seam.shift
    frames = tuple(Frame.many(plain.times, states, plain.fixed, [key.posed for key in keys]))
    return Timeline(frames, _end_slope(figure, keys, states, ends, end_slope), ends)


def _end_slope(figure: Figure, keys: list[Frame], states: Array, ends: str, clamped: Array | None) -> Array:
    """Return the rows (2, N) below the frames' states, for any ends."""
    times = np.array([frame.time for frame in keys])
    if ends == "periodic":
        return Seam.between(figure, states[0], states[-1]).jumps(Spline(times, ends), states)
    natural = natural_end_slopes(times, states)
    if not ends.startswith("clamped"):
        return natural
    shape = None if clamped is None else np.shape(clamped)
    if clamped is None or shape != (2, figure.width):
        raise TimelineError(f"clamped ends need end_slope of shape (2, {figure.width}), not {shape}")
    # the slope of a quaternion changes sign with it
    rest = np.array(figure.model.qpos0)
    as_given = [figure.to_state(np.where(keys[i].known, keys[i].state, rest)) for i in (0, -1)]
    signs = [sameness(figure, a, b) for a, b in zip(as_given, states[[0, -1]], strict=True)]
    slopes = np.asarray(clamped, float) * signs
    free = Timeline(tuple(keys), slopes, ends).free_slopes
    return np.where(np.array(free)[:, None], natural, slopes)


def bases(figure: Figure, states: Array, link: Link) -> Array:
    """Return the left factor (K, 4) of a joint's relative rotation in the figure's coordinates, for states (K, N)."""
    identity = np.tile([1.0, 0, 0, 0], (len(states), 1))
    if link.kind is JointKind.FREE or not figure.tables.in_world[link.joint + 1]:
        return identity
    parent = quaternion_columns(figure.links[link.parent])
    return quat.product(identity if parent is None else states[:, parent], link.turn)


def _signed_track(link: Link, times: Array, base: Array, track: Array) -> Array:
    """Return a track (K, 4) with the signs that `winding` determines for the joint, base⁻¹ ⊗ track."""
    relative = quat.product(quat.inverse(base), track)
    return track * signs(times, relative, spins=link.kind is JointKind.FREE)[:, None]


def _fill(
    times: Array, states: Array, specified: Mask, columns: slice, rest: Array, samplings: dict[bytes, Sampling]
) -> None:
    """Fill columns at the frames that do not specify them, from the natural spline through the others. Beyond the
    ends of that spline the values are constant.

    Args:
        samplings: The samplings of such splines by the frames that specify them, extended if one is missing.
    """
    known: Mask = np.asarray(specified[:, columns].all(axis=1))
    if known.all():
        return
    if known.sum() < 2:
        states[~known, columns] = states[known, columns] if known.any() else rest[columns]
        return
    t, values, key = times[known], states[known, columns], known.tobytes()
    between = ~known & (times > t[0]) & (times < t[-1])
    if key not in samplings:
        samplings[key] = Sampling.of(Spline(t), times[between])
    states[between, columns] = samplings[key].samples(np.concatenate([values, natural_end_slopes(t, values)]))[0]
    states[times < t[0], columns], states[times > t[-1], columns] = values[0], values[-1]


def _check(figure: Figure, keys: list[Frame]) -> None:
    """Raise TimelineError for keyframes that do not match the figure."""
    columns = figure.tables.quaternion_columns
    if all(frame.state.size == figure.width for frame in keys):
        fixed = np.array([frame.fixed for frame in keys], bool).reshape(-1, figure.width)[:, columns]
        specified = np.array([frame.known for frame in keys], bool).reshape(-1, figure.width)[:, columns]
        q = np.array([frame.state for frame in keys]).reshape(-1, figure.width)[:, columns]
        is_specified = specified.all(axis=1)
        whole = all(np.array_equal(mask.all(axis=1), mask.any(axis=1)) for mask in (fixed, specified))
        if whole and np.all(np.einsum("kin,kin->kn", q, q)[is_specified] > SURELY_MORE):
            return
    for number, frame in enumerate(keys, start=1):
        _check_masks(figure, frame, number)


def _check_masks(figure: Figure, frame: Frame, number: int) -> None:
    place = f"keyframe {number} (t = {frame.time:g} s)"
    if frame.state.size != figure.width:
        raise TimelineError(f"{place}: {frame.state.size} entries, the figure's qpos has {figure.width}")
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is None:
            continue
        mask = frame.known[columns]
        if any(entries[columns].any() and not entries[columns].all() for entries in (frame.fixed, frame.known)):
            raise TimelineError(
                f"{place}: the quaternion of '{link.name}' is fixed in part; fix all four of its components or none"
            )
        if mask.all() and not np.linalg.norm(frame.state[columns]) > ROUNDING:
            raise TimelineError(f"{place}: the quaternion of '{link.name}' is zero")
