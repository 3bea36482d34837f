"""Unknowns: the decision vector x of a timeline, and the affine map from x to the rows that the spline runs through.

x holds the entries that nobody fixed, and nothing else, so the keyframes are met for *every* x (§2 of the paper). A
fixed joint of a partial keyframe is a relative rotation: in world coordinates its row is Q_parent ⊗ q, linear in the
unknown Q_parent. A loop's last frame repeats the first. All of this is Y = constant + A x with a sparse A.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy import sparse

from . import quaternion as quat
from .figure import Figure, JointKind, Link, quaternion_columns
from .frame import Frame, Mask, Timeline, TimelineError
from .quaternion import Array, Index
from .spline import Spline, natural_spline

FARTHEST = 0.5


@dataclass(frozen=True)
class Unknowns:
    """The map x -> rows (M + 2, N), and back for gradients.

    constant  (M + 2, N) rows for x = 0
    matrix    ((M + 2) N, n) sparse
    start     (n,) the x of the timeline itself
    whole     (r,) rows of which every entry is an unknown of its own: variable frames and free end slopes
    blocks    (r, N) where these rows' entries stand in x
    row_of    (n,) a row that each unknown belongs to
    place     (n,) the entry of the flat rows that each unknown is
    """

    constant: Array
    matrix: sparse.csr_matrix
    transposed: sparse.csr_matrix
    start: Array
    whole: Index
    blocks: Index
    row_of: Index
    place: Index

    @property
    def size(self) -> int:
        """n"""
        return self.start.size

    def rows(self, x: Array) -> Array:
        """(M + 2, N)"""
        return self.constant + (self.matrix @ x).reshape(self.constant.shape)

    def pulled_back(self, gradient: Array) -> Array:
        """dE/dx (n,) from dE/dY (M + 2, N)."""
        return self.transposed @ gradient.ravel()

    @classmethod
    def of(cls, figure: Figure, timeline: Timeline) -> Unknowns:
        width, rows = figure.width, timeline.rows
        builder = _Builder(rows)
        whole: list[int] = []
        first: list[int] = []
        last = len(timeline.frames) - 1
        for i, frame in enumerate(timeline.frames):
            if timeline.ends == "periodic" and i == last:
                signs = _sameness(figure, rows[0], rows[last])
                builder.repeat(0, last, signs)
                builder.close(np.flatnonzero(signs < 0), Spline(timeline.times, "periodic").opposite_jumps)
            elif frame.is_variable:
                whole.append(i)
                first.append(builder.free(i, np.arange(width)))
            elif not frame.is_key:
                _partial(figure, frame, i, builder)
        if timeline.ends == "free":
            for i in (last + 1, last + 2):
                whole.append(i)
                first.append(builder.free(i, np.arange(width)))
        constant, matrix, start = builder.finished()
        blocks = np.array(first, np.intp)[:, None] + np.arange(width)
        row_of = np.array(builder.row_of, np.intp)
        place = row_of * width + np.array(builder.column_of, np.intp)
        return cls(constant, matrix, matrix.T.tocsr(), start, np.array(whole, np.intp), blocks, row_of, place)


class _Builder:
    """Collects the sparse entries row by row; entries nobody speaks of stay constant."""

    def __init__(self, rows: Array) -> None:
        self.constant = np.array(rows)
        self.width = rows.shape[1]
        self.start: list[float] = []
        self.row_of: list[int] = []
        self.column_of: list[int] = []
        self.of_row: dict[int, list[tuple[int, int, float]]] = {}

    def _put(self, row: int, column: int, unknown: int, value: float) -> None:
        self.of_row.setdefault(row, []).append((column, unknown, value))

    def free(self, row: int, columns: Index) -> int:
        """Makes entries of a row unknowns; the first one's place in x."""
        first = len(self.start)
        for column in columns:
            self._put(row, int(column), len(self.start), 1.0)
            self.start.append(float(self.constant[row, column]))
            self.row_of.append(row)
            self.column_of.append(int(column))
            self.constant[row, column] = 0.0
        return first

    def turned(self, row: int, parent: slice, child: slice, relative: Array) -> None:
        """child = parent ⊗ relative, if the parent's entries are unknowns."""
        own = [e for e in self.of_row.get(row, []) if parent.start <= e[0] < parent.stop]
        if not own:
            return
        matrix = quat.right_matrix(relative)
        for column, unknown, value in own:
            for i in range(4):
                self._put(row, child.start + i, unknown, matrix[i, column - parent.start] * value)
        self.constant[row, child] = matrix @ self.constant[row, parent]

    def repeat(self, source: int, row: int, signs: Array) -> None:
        """Makes a row equal to an earlier one, up to the columns' signs."""
        self.constant[row] = self.constant[source] * signs
        for column, unknown, value in self.of_row.get(source, []):
            self._put(row, column, unknown, value * signs[column])

    def close(self, columns: Index, opposite_jumps: Callable[[], Array]) -> None:
        """Lays the seam's jumps for the columns that come back with the other sign."""
        if not columns.size:
            return
        jumps = opposite_jumps()
        count = jumps.shape[1]
        self.constant[np.ix_([count, count + 1], columns)] = jumps @ self.constant[:count, columns]
        for row in range(count):
            for column, unknown, value in self.of_row.get(row, []):
                if column in columns:
                    self._put(count, column, unknown, value * jumps[0, row])
                    self._put(count + 1, column, unknown, value * jumps[1, row])

    def finished(self) -> tuple[Array, sparse.csr_matrix, Array]:
        triples = [(row * self.width + c, u, v) for row, entries in self.of_row.items() for c, u, v in entries]
        i, j, v = (np.array(part) for part in zip(*triples, strict=True)) if triples else (np.zeros(0, int),) * 3
        shape = (self.constant.size, len(self.start))
        return self.constant, sparse.csr_matrix((np.asarray(v, float), (i, j)), shape=shape), np.array(self.start)


def _sameness(figure: Figure, first: Array, last: Array) -> Array:
    """+1, or −1 in the columns of quaternions that come back on the other hemisphere."""
    signs = np.ones(first.size)
    for columns in figure.tables.quaternion_columns.T:
        if first[columns] @ last[columns] < 0:
            signs[columns] = -1.0
    return signs


def _partial(figure: Figure, frame: Frame, row: int, builder: _Builder) -> None:
    """The unknowns of a partial keyframe, parents before children."""
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is None:
            if not frame.fixed[link.qpos]:
                builder.free(row, np.array([link.qpos]))
            continue
        if link.kind is JointKind.FREE:
            position = np.arange(link.qpos, link.qpos + 3)
            builder.free(row, position[~frame.fixed[position]])
        if not frame.fixed[columns].all():
            builder.free(row, np.arange(columns.start, columns.stop))
        elif figure.is_world and link.kind is JointKind.BALL:
            parent = quaternion_columns(figure.links[link.parent])
            if parent is not None:
                own = quat.product(quat.inverse(frame.state[parent]), frame.state[columns])
                builder.turned(row, parent, columns, own)


def raw_timeline(figure: Figure, keys: list[Frame], ends: str = "free", end_slope: Array | None = None) -> Timeline:
    """The keyframes' timeline in the figure's coordinates, and the natural spline's end slopes (method of §2).

    keys hold *qpos* and the fixed mask. Signs of quaternions are such that joints turn by the shortest arcs. An entry
    that a partial keyframe leaves out starts on the natural spline of its neighbours, one left out everywhere at the
    rest pose. The first and the last keyframe of a loop are one: what either fixes is fixed in both.
    """
    for number, frame in enumerate(keys, start=1):
        _check_masks(figure, frame, number)
    if ends == "periodic" and len(keys) > 1:
        keys = _closed(figure, keys)
    plain = Timeline(tuple(keys), np.zeros((2, figure.width)))
    states = np.array(plain.states)
    rest = np.array(figure.model.qpos0)
    fixed = plain.fixed
    for link in figure.links[1:]:
        if link.kind is JointKind.FREE:
            for column in range(link.qpos, link.qpos + 3):
                _filled(plain.times, states, fixed, slice(column, column + 1), rest)
        columns = quaternion_columns(link)
        if columns is None:
            _filled(plain.times, states, fixed, slice(link.qpos, link.qpos + 1), rest)
            continue
        known = fixed[:, columns].all(axis=1)
        base = _bases(figure, states, link)
        states[known, columns] = quat.product(base[known], quat.normalised(states[known, columns]))
        states[~known, columns] = quat.product(base[~known], rest[columns])
        if known.any():
            states[known, columns] = _laid_along(base[known], states[known, columns])
            _filled(plain.times, states, fixed, columns, states[0])
            states[:, columns] = quat.normalised(states[:, columns])
        states[:, columns] = _laid_along(base, states[:, columns])
    if ends == "periodic":
        states[-1] = states[0] * _sameness(figure, states[0], states[-2])
    frames = tuple(replace(frame, state=state) for frame, state in zip(keys, states, strict=True))
    return Timeline(frames, _end_slope(figure, keys, states, ends, end_slope), ends)


def _end_slope(figure: Figure, keys: list[Frame], states: Array, ends: str, given: Array | None) -> Array:
    """(2, N): the rows below the frames' states, for any ends."""
    times = np.array([frame.time for frame in keys])
    if ends == "periodic":
        back = np.flatnonzero(_sameness(figure, states[0], states[-1]) < 0)
        jumps = np.zeros((2, figure.width))
        if back.size:
            jumps[:, back] = Spline(times, ends).opposite_jumps() @ states[:, back]
        return jumps
    if ends != "clamped":
        return natural_spline(times, states)(times[[0, -1]], 1)
    shape = None if given is None else np.shape(given)
    if given is None or shape != (2, figure.width):
        raise TimelineError(f"clamped ends need end_slope of shape (2, {figure.width}), not {shape}")
    # a quaternion that was laid on the other hemisphere takes its slope along
    rest = np.array(figure.model.qpos0)
    as_given = [figure.to_state(np.where(keys[i].fixed, keys[i].state, rest)) for i in (0, -1)]
    signs = [_sameness(figure, a, b) for a, b in zip(as_given, states[[0, -1]], strict=True)]
    return np.asarray(given, float) * signs


def _closed(figure: Figure, keys: list[Frame]) -> list[Frame]:
    """The keyframes of a loop: the first and the last with the entries that either fixes."""
    first, last = keys[0], keys[-1]
    a, b = (np.array(frame.state) for frame in (first, last))
    both = first.fixed & last.fixed
    for columns in figure.tables.quaternion_columns.T:
        if both[columns].all():
            a[columns], b[columns] = quat.normalised(a[columns]), quat.normalised(b[columns])
    apart = np.abs(a * _sameness(figure, a, b) - b) * both
    if apart.max() > 1e-9:
        link = next(link for link in reversed(figure.links) if link.qpos <= np.argmax(apart))
        raise TimelineError(
            f"periodic ends: the last keyframe (t = {last.time:g} s) differs from the first at '{link.name}' by "
            f"{apart.max():.3g}; they must agree, or leave it free in one of them"
        )
    state = np.where(first.fixed, a, b)
    fixed = first.fixed | last.fixed
    return [replace(first, state=state, fixed=fixed), *keys[1:-1], replace(last, state=state, fixed=fixed)]


def _bases(figure: Figure, states: Array, link: Link) -> Array:
    """(K, 4): what a joint's relative rotation is multiplied onto from the left in the figure's coordinates."""
    identity = np.tile([1.0, 0, 0, 0], (len(states), 1))
    if not figure.is_world or link.kind is JointKind.FREE:
        return identity
    parent = quaternion_columns(figure.links[link.parent])
    return quat.product(identity if parent is None else states[:, parent], link.turn)


def _laid_along(base: Array, track: Array) -> Array:
    """A track (K, 4) with signs such that the joint, base⁻¹ ⊗ track, turns by the shortest arcs.

    Near a half turn of the whole figure a joint's arc can be short one way and the body's in the world the other way;
    the joint decides, or the limb would come off, unless its body would turn by more than 240°.
    """
    out = track.copy()
    relative = quat.product(quat.inverse(base), track)
    for k in range(1, len(out)):
        if relative[k] @ relative[k - 1] < 0:
            relative[k], out[k] = -relative[k], -out[k]
        if out[k] @ out[k - 1] < -FARTHEST * np.linalg.norm(out[k]) * np.linalg.norm(out[k - 1]):
            relative[k], out[k] = -relative[k], -out[k]
    return out


def _filled(times: Array, states: Array, fixed: Mask, columns: slice, rest: Array) -> None:
    """Fills the columns at frames that leave them out, from the natural spline of the others, held beyond its ends."""
    known = fixed[:, columns].all(axis=1)
    if known.all():
        return
    if not known.any():
        states[:, columns] = rest[columns]
    elif known.sum() == 1:
        states[~known, columns] = states[known, columns]
    else:
        t = times[known]
        curve = natural_spline(t, states[known, columns])
        states[~known, columns] = curve(np.clip(times[~known], t[0], t[-1]))


def _check_masks(figure: Figure, frame: Frame, number: int) -> None:
    place = f"keyframe {number} (t = {frame.time:g} s)"
    if frame.state.size != figure.width:
        raise TimelineError(f"{place}: {frame.state.size} entries, the figure's qpos has {figure.width}")
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is None:
            continue
        mask = frame.fixed[columns]
        if mask.any() and not mask.all():
            raise TimelineError(f"{place}: the quaternion of '{link.name}' is fixed whole or not at all")
        if mask.all() and not np.linalg.norm(frame.state[columns]) > 1e-9:
            raise TimelineError(f"{place}: the quaternion of '{link.name}' is zero")
