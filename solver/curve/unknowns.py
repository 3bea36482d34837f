"""Unknowns: the decision vector x of a timeline, and the affine map from x to the rows that the spline runs through.

x holds the entries that nobody fixed, and nothing else, so the keyframes are met for *every* x (§2 of the paper). A
fixed joint of a partial keyframe is a relative rotation: in world coordinates its row is Q_parent ⊗ q, linear in the
unknown Q_parent. A loop's last frame repeats the first, moved on by its travel and turned. Held ends take the two
frames beside them along. All of this is Y = constant + A x with a sparse A.
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
from .closing import closed
from .frame import Frame, Timeline, TimelineError
from .seam import Seam, sameness
from .spline import Sampling, Spline, natural_end_slopes, spline_of
from .winding import signs

NOUGHT = 1e-9  # length of a quaternion that says nothing
SURELY_MORE = 1e-17  # a square that is far enough above that length's for a quick look at all keyframes


@dataclass(frozen=True, eq=False)
class Unknowns:
    """The map x -> rows (M + 2, N), and back for gradients.

    constant  (M + 2, N) rows for x = 0
    start     (n,) the x of the timeline itself
    whole     (r,) rows of which every entry is an unknown of its own: variable frames and free end slopes
    blocks    (r, N) where these rows' entries stand in x
    place     (n,) the entry of the flat rows that each unknown is, rising
    ties      ((M + 2) N, n) sparse, what other entries of the rows follow the unknowns; None if none do
    """

    constant: Array
    start: Array
    whole: Index
    blocks: Index
    place: Index
    ties: sparse.csr_matrix | None

    @property
    def size(self) -> int:
        """n"""
        return self.start.size

    @property
    def row_of(self) -> Index:
        """(n,) the row that each unknown stands in."""
        return self.place // self.constant.shape[1]

    @cached_property
    def matrix(self) -> sparse.csr_matrix:
        """((M + 2) N, n) sparse, all of the map but its constant."""
        own = (np.ones(self.size), (self.place, np.arange(self.size)))
        matrix = sparse.csr_matrix(own, shape=(self.constant.size, self.size))
        return matrix if self.ties is None else sparse.csr_matrix(matrix + self.ties)

    @cached_property
    def transposed(self) -> sparse.csr_matrix:
        return self.matrix.T.tocsr()

    def rows(self, x: Array) -> Array:
        """(M + 2, N)"""
        if self.ties is not None:
            return self.constant + (self.matrix @ x).reshape(self.constant.shape)
        rows = self.constant.copy()
        rows.reshape(-1)[self.place] = x
        return rows

    def pulled_back(self, gradient: Array) -> Array:
        """dE/dx (n,) from dE/dY (M + 2, N)."""
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
            beside = np.array([1, last - 1])
            shares = spline_of(timeline).held_shares()
            every = np.arange(width)
            constant[beside] = rows[beside] - shares @ rows
            ties.follow(beside, shares, every, every)
        whole = np.flatnonzero(loose.all(axis=1))
        blocks = np.searchsorted(place, whole * width)[:, None] + np.arange(width)
        return cls(constant, start, whole, blocks, place, ties.matrix())


def _loose(figure: Figure, timeline: Timeline) -> Mask:
    """(M + 2, N): which entries of the rows are unknowns, quaternions whole.

    A loop's last frame repeats the first; of held ends the frames beside them follow the others.
    """
    loose = np.empty((len(timeline.frames) + 2, figure.width), bool)
    np.logical_not(timeline.fixed, out=loose[:-2])
    for columns in figure.tables.quaternion_columns.T:
        loose[:-2, columns] = loose[:-2, columns].any(axis=1, keepdims=True)
    loose[-2:] = timeline.ends == "free"
    if timeline.ends == "periodic":
        loose[-3] = False
    if timeline.ends == "held":
        loose[[0, 1, -4, -3]] = False
    return loose


class _Ties:
    """Collects what entries of the rows follow which unknowns, as (entry of the flat rows, unknown, factor).

    Entries nobody speaks of stay constant.
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
        """All that is said of rows first ... last − 1, the unknowns themselves included."""
        own = np.arange(*np.searchsorted(self.place, [first * self.width, last * self.width]))
        tied = np.flatnonzero((self.entries >= first * self.width) & (self.entries < last * self.width))
        entries = np.append(self.place[own], self.entries[tied])
        return entries, np.append(own, self.unknowns[tied]), np.append(np.ones(own.size), self.factors[tied])

    def turn(self, figure: Figure, frame: Frame, row: int) -> None:
        """child = parent ⊗ relative for the fixed joints of a partial keyframe, parents before children."""
        for joint in figure.tables.ball_links[figure.tables.in_world[figure.tables.ball_links]]:
            link = figure.links[joint]
            columns, parent = quaternion_columns(link), quaternion_columns(figure.links[link.parent])
            if columns is None or parent is None or not frame.fixed[columns].all():
                continue
            entries, unknowns, factors = self._of(row, row + 1)
            above = entries % self.width - parent.start
            seen = np.flatnonzero((above >= 0) & (above < 4))
            if not seen.size:
                continue
            own = quat.product(quat.inverse(frame.state[parent]), frame.state[columns])
            matrix = quat.right_matrix(own)
            child = row * self.width + columns.start + np.arange(4)
            self._put(
                np.tile(child, seen.size),
                np.repeat(unknowns[seen], 4),
                (matrix[:, above[seen]] * factors[seen]).T.ravel(),
            )
            self.constant[row, columns] = matrix @ self.constant[row, parent]

    def repeat(self, source: int, row: int, seam: Seam) -> None:
        """Makes a row equal to an earlier one, as it comes back after a period."""
        self.constant[row] = seam.moved(self.constant[source])
        entries, unknowns, factors = self._of(source, source + 1)
        column = entries % self.width
        own, beside = (seam.signs * wave(seam.angles) for wave in (np.cos, np.sin))
        self._put(row * self.width + column, unknowns, factors * own[column])
        other = seam.partners[column]
        turned = np.flatnonzero(other != column)
        self._put((row * self.width + other)[turned], unknowns[turned], (factors * beside[other])[turned])

    def jump(self, followers: Index, spline: Spline, seam: Seam) -> None:
        """Makes the rows of a loop's jumps what its seam wants of the states."""
        self.constant[followers] = 0
        for columns, shares in seam.shares(spline):
            self.follow(followers, shares.real, columns, columns)
            if (seam.partners[columns] != columns).any():
                self.follow(followers, shares.imag, columns, seam.partners[columns])

    def follow(self, followers: Index, shares: Array, columns: Index, sources: Index) -> None:
        """Adds to rows (F,), in some columns (C,), the first R rows' columns of `sources` (C,), with shares (F, R)."""
        count = shares.shape[1]
        self.constant[np.ix_(followers, columns)] += shares @ self.constant[:count, sources]
        goal = np.full(self.width, -1, np.intp)
        goal[sources] = columns
        entries, unknowns, factors = self._of(0, count)
        row, column = np.divmod(entries, self.width)
        some = np.flatnonzero(goal[column] >= 0)
        for follower, share in zip(followers, shares, strict=True):
            self._put(follower * self.width + goal[column[some]], unknowns[some], factors[some] * share[row[some]])

    def matrix(self) -> sparse.csr_matrix | None:
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
    """The keyframes' timeline in the figure's coordinates, and the natural spline's end slopes (method of §2).

    keys hold *qpos* and the fixed mask. Signs of quaternions are such that joints turn by the shortest arcs. An entry
    that a partial keyframe leaves out starts where it was posed, else on the natural spline of its neighbours; one left
    out everywhere at the rest pose. The first and the last keyframe of a loop are one: what either fixes is fixed in
    both.

    travel  (3,) [m] how far the root of a loop comes in one period; None: as far in x and y as the keyframes say
    turn    [rad] by how much the root of a loop is turned about the vertical by then; None: as the keyframes say
    """
    _check(figure, keys)
    seam = None
    if ends == "periodic" and len(keys) > 1:
        keys, seam = closed(figure, keys, travel, turn)
    elif travel is not None or turn is not None:
        name = "travel" if travel is not None else "turn"
        raise TimelineError(f"{name} is for ends = 'periodic', not '{ends}'")
    plain = Timeline(tuple(keys), np.zeros((2, figure.width)))
    states = np.array(plain.states)
    rest = np.array(figure.model.qpos0)
    told, gaps = plain.known, _Gaps(plain.times)
    for link in figure.links[1:]:
        if link.kind is JointKind.FREE:
            for column in range(link.qpos, link.qpos + 3):
                gaps.fill(states, told, slice(column, column + 1), rest)
        columns = quaternion_columns(link)
        if columns is None:
            gaps.fill(states, told, slice(link.qpos, link.qpos + 1), rest)
            continue
        known = told[:, columns].all(axis=1)
        base = bases(figure, states, link)
        states[known, columns] = quat.product(base[known], quat.normalised(states[known, columns]))
        if not known.all():
            states[~known, columns] = quat.product(base[~known], rest[columns])
            if known.any():
                states[known, columns] = _laid_along(link, plain.times[known], base[known], states[known, columns])
                gaps.fill(states, told, columns, states[0])
                states[:, columns] = quat.normalised(states[:, columns])
        if seam is not None and link.kind is JointKind.FREE:
            states[-1, columns] = seam.linear(states[0])[columns]
        elif seam is not None:  # it comes back as it began, in its parent's axes
            states[-1, columns] = quat.product(base[-1], quat.product(quat.inverse(base[0]), states[0, columns]))
        states[:, columns] = _laid_along(link, plain.times, base, states[:, columns])
    if seam is not None:
        lifted = Seam.turned(figure, states[0], states[-1], seam.headings)
        states[-1] = lifted.linear(states[0]) + seam.shift
    frames = tuple(Frame.many(plain.times, states, plain.fixed, [key.posed for key in keys]))
    return Timeline(frames, _end_slope(figure, keys, states, ends, end_slope), ends)


def _end_slope(figure: Figure, keys: list[Frame], states: Array, ends: str, given: Array | None) -> Array:
    """(2, N): the rows below the frames' states, for any ends."""
    times = np.array([frame.time for frame in keys])
    if ends == "periodic":
        return Seam.between(figure, states[0], states[-1]).jumps(Spline(times, ends), states)
    if ends != "clamped":
        return natural_end_slopes(times, states)
    shape = None if given is None else np.shape(given)
    if given is None or shape != (2, figure.width):
        raise TimelineError(f"clamped ends need end_slope of shape (2, {figure.width}), not {shape}")
    # a quaternion that was laid on the other hemisphere takes its slope along
    rest = np.array(figure.model.qpos0)
    as_given = [figure.to_state(np.where(keys[i].known, keys[i].state, rest)) for i in (0, -1)]
    signs = [sameness(figure, a, b) for a, b in zip(as_given, states[[0, -1]], strict=True)]
    return np.asarray(given, float) * signs


def bases(figure: Figure, states: Array, link: Link) -> Array:
    """(K, 4): what a joint's relative rotation is multiplied onto from the left in the figure's coordinates."""
    identity = np.tile([1.0, 0, 0, 0], (len(states), 1))
    if link.kind is JointKind.FREE or not figure.tables.in_world[link.joint + 1]:
        return identity
    parent = quaternion_columns(figure.links[link.parent])
    return quat.product(identity if parent is None else states[:, parent], link.turn)


def _laid_along(link: Link, times: Array, base: Array, track: Array) -> Array:
    """A track (K, 4) with signs such that the joint, base⁻¹ ⊗ track, turns as `winding` says."""
    relative = quat.product(quat.inverse(base), track)
    return track * signs(times, relative, spins=link.kind is JointKind.FREE)[:, None]


class _Gaps:
    """Frames that leave something out: of all columns that the same ones do, the spline is made once."""

    def __init__(self, times: Array) -> None:
        self.times = times
        self._made: dict[bytes, tuple[Mask, Sampling]] = {}

    def fill(self, states: Array, told: Mask, columns: slice, rest: Array) -> None:
        """Fills columns at the frames that leave them out, from the natural spline of the others, held beyond its
        ends."""
        known: Mask = np.asarray(told[:, columns].all(axis=1))
        if known.all():
            return
        if not known.any():
            states[:, columns] = rest[columns]
        elif known.sum() == 1:
            states[~known, columns] = states[known, columns]
        else:
            own, (between, sampling) = states[known, columns], self._between(known)
            t = sampling.spline.times
            states[between, columns] = sampling.samples(np.concatenate([own, natural_end_slopes(t, own)]))[0]
            states[self.times < t[0], columns], states[self.times > t[-1], columns] = own[0], own[-1]

    def _between(self, known: Mask) -> tuple[Mask, Sampling]:
        """The frames between those that are known, and a spline through these, seen at them."""
        key = known.tobytes()
        if key not in self._made:
            t = self.times[known]
            between = ~known & (self.times > t[0]) & (self.times < t[-1])
            self._made[key] = between, Sampling.of(Spline(t), self.times[between])
        return self._made[key]


def _check(figure: Figure, keys: list[Frame]) -> None:
    """Raises TimelineError for keyframes that are not the figure's."""
    columns = figure.tables.quaternion_columns
    if all(frame.state.size == figure.width for frame in keys):
        fixed = np.array([frame.fixed for frame in keys], bool).reshape(-1, figure.width)[:, columns]
        told = np.array([frame.known for frame in keys], bool).reshape(-1, figure.width)[:, columns]
        q = np.array([frame.state for frame in keys]).reshape(-1, figure.width)[:, columns]
        known = told.all(axis=1)
        whole = all(np.array_equal(mask.all(axis=1), mask.any(axis=1)) for mask in (fixed, told))
        if whole and np.all(np.einsum("kin,kin->kn", q, q)[known] > SURELY_MORE):
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
        if any(some[columns].any() and not some[columns].all() for some in (frame.fixed, frame.known)):
            raise TimelineError(f"{place}: the quaternion of '{link.name}' is fixed whole or not at all")
        if mask.all() and not np.linalg.norm(frame.state[columns]) > NOUGHT:
            raise TimelineError(f"{place}: the quaternion of '{link.name}' is zero")
