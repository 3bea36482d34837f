"""The seam of a loop: the map from its first frame to its last, across which the curve is C².

    last = A first + shift        y' and y'' of the end = A times those of the start

A walk cycle repeats itself after a travel, and on a circle after a turn as well. A turns every free root, with its
descendants, by a heading angle φ about the vertical, so A is linear. The pair (x, y) of a root's position turns by φ.
The quaternion of a root, or of a link in world coordinates, is multiplied from the left, which turns its pairs (w, z)
and (x, y) by φ/2. Its sign is −1 if the quaternion returns as −q, after a full turn. The shift is constant, so it does
not affect y' and y''.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array, Index
from ..figure.figure import Figure, JointKind, quaternion_columns
from ..tolerances import ROUNDING
from .frame import Frame, Timeline, TimelineError
from .spline import Complex, Path, Spline


@dataclass(frozen=True, eq=False)
class Seam:
    """The map of a state (N,) after one period.

    Attributes:
        signs: ±1, (N,).
        angles: (N,) [rad]; A y = signs · (cos(angles) y + sin(angles) y[partners]).
        partners: The other column of a pair that turns, (N,); the column itself if it does not turn.
        headings: The rotation of each free root, from −π to π, (f,) [rad].
        travel: last − first for the positions of free roots, zero elsewhere, (N,) [m].
        shift: last − A first for the same, (N,) [m].
    """

    signs: Array
    angles: Array
    partners: Index
    headings: Array
    travel: Array
    shift: Array

    @classmethod
    def between(cls, figure: Figure, first: Array, last: Array) -> Seam:
        """Return the seam of a loop that begins and ends with these states (N,)."""
        about = figure.tables.position_columns[0][:, None] + np.arange(3, 7)  # of the roots' quaternions
        return cls.with_headings(figure, first, last, heading_between(first[about], last[about]))

    @classmethod
    def with_headings(
        cls, figure: Figure, first: Array, last: Array, headings: Array, coordinates: str | None = None
    ) -> Seam:
        """Return the seam between states for known headings.

        Args:
            first: The first state, (N,).
            last: The last state, (N,).
            headings: The rotation of each free root, (f,) [rad]; used instead of that between the states.
            coordinates: "joint" for configurations qpos, where only the roots turn; None: those of the figure.
        """
        angles, partners = np.zeros(first.size), np.arange(first.size)
        roots = dict(zip(figure.tables.free_links.tolist(), headings.tolist(), strict=True))
        for column, angle in zip(figure.tables.position_columns[0], headings, strict=True):
            _pair(angles, partners, column, column + 1, angle)
        in_world = (coordinates or figure.coordinates) == "world"
        for i, (w, x, y, z) in zip(figure.tables.quaternion_links, figure.tables.quaternion_columns.T, strict=True):
            angle = roots.get(turning_root(figure, int(i), in_world=in_world), 0.0)
            _pair(angles, partners, w, z, angle / 2)
            _pair(angles, partners, x, y, angle / 2)
        unsigned = np.cos(angles) * first + np.sin(angles) * first[partners]
        signs = sameness(figure, unsigned, last)
        travel, shift = np.zeros(first.size), np.zeros(first.size)
        moving = figure.tables.position_columns.ravel()
        travel[moving] = last[moving] - first[moving]
        shift[moving] = last[moving] - unsigned[moving]
        return cls(signs, angles, partners, headings, travel, shift)

    @classmethod
    def of(cls, figure: Figure, timeline: Timeline) -> Seam:
        return cls.between(figure, timeline.states[0], timeline.states[-1])

    @property
    def turns(self) -> bool:
        """Whether a root is turned after one period."""
        return bool(self.headings.any())

    def linear(self, values: Array, periods: ArrayLike = 1) -> Array:
        """Return Aᵏ y for values y (..., N) and whole numbers k of periods (...)."""
        k = np.asarray(periods)[..., None]
        return self.signs**k * self._rotate(values, k * self.angles)

    def move(self, states: Array, periods: ArrayLike = 1) -> Array:
        """Return states (..., N) after k periods (...): Aᵏ y + (1 + A + … + Aᵏ⁻¹) shift."""
        k = np.asarray(periods)[..., None]
        half = self.angles / 2
        steep = half != 0
        length = np.where(steep, np.sin(k * half) / np.where(steep, np.sin(half), 1.0), k)
        return self.linear(states, periods) + length * self._rotate(self.shift, (k - 1) * half)

    def _rotate(self, values: Array, angles: Array) -> Array:
        return np.cos(angles) * values + np.sin(angles) * values[..., self.partners]

    def matrix(self) -> Array:
        """Return A, (N, N)."""
        return self.linear(np.eye(self.signs.size)).T

    def moved_points(self, figure: Figure, points: Array, periods: ArrayLike = 1) -> Array:
        """Return points (..., 3) [m] of the world moved with the first free root by a number of periods.

        Without a free root they are unchanged.
        """
        roots = figure.tables.position_columns
        if not roots.size:
            return points
        state = np.zeros((*points.shape[:-1], self.signs.size))
        state[..., roots[:, 0]] = points
        return self.move(state, periods)[..., roots[:, 0]]

    def turn(self, periods: int = 1) -> Array:
        """Return the rotation (4,) of the first free root, with its descendants, after a number of periods."""
        angle = self.headings[0] if self.headings.size else 0.0
        return quat.from_rotation_vector(periods * angle * np.array([0.0, 0.0, 1.0]))

    def jumps(self, spline: Spline, states: Array) -> Array:
        """Return the jumps (2, N) of y' and y'' from end to start of a periodic `Spline` through states (M, N)."""
        out = np.zeros((2, self.signs.size))
        for columns, shares in self.shares(spline):
            out[:, columns] += (shares.real @ states)[:, columns] + (shares.imag @ states)[:, self.partners[columns]]
        return out

    def shares(self, spline: Spline) -> list[tuple[Index, Complex]]:
        """Return the columns with a jump, and the jumps as linear maps (2, M) of the states.

        The real part applies to the states of the column itself, the imaginary part to those of its partner.
        """
        factors = np.stack([self.signs, self.angles], axis=1)
        shares = []
        for sign, angle in np.unique(factors, axis=0):
            if sign < 0 or angle:
                factor = complex(sign * np.cos(angle), sign * np.sin(angle))
                columns = np.flatnonzero((self.signs == sign) & (self.angles == angle))
                shares.append((columns, spline.jumps_of(factor)))
        return shares

    def discontinuity(self, path: Path) -> Array:
        """Return the largest mismatch (3,) of y, y' and y'' at the end of a loop with those mapped from its start."""
        start, end = (path.motion(np.array([t]))[:, 0] for t in path.span)
        expected = self.linear(start)
        expected[0] += self.shift
        return np.abs(end - expected).max(axis=1)


def _pair(angles: Array, partners: Index, u: int, v: int, angle: float) -> None:
    """Set the columns (u, v) to turn by an angle [rad]: u' = cos u − sin v, v' = cos v + sin u."""
    if angle:
        angles[[u, v]] = -angle, angle
        partners[[u, v]] = v, u


def turning_root(figure: Figure, link: int, *, in_world: bool) -> int:
    """Return the free link whose rotation turns a link's quaternion, or 0. It is the link itself, or its free ancestor
    if the quaternion is its orientation in the world."""
    while link and figure.links[link].kind is not JointKind.FREE:
        link = figure.links[link].parent if in_world and figure.tables.in_world[link] else 0
    return link


def heading_between(first: Array, last: Array) -> Array:
    """Return the rotation (...) [rad] about the vertical between quaternions (..., 4); 0 for other axes."""
    w, x, y, z = np.moveaxis(quat.normalise(quat.product(last, quat.inverse(first))), -1, 0)
    upright = (np.abs(x) <= ROUNDING) & (np.abs(y) <= ROUNDING) & (np.abs(z) > ROUNDING)
    return np.where(upright, 2 * np.arctan2(np.copysign(1.0, w) * z, np.abs(w)), 0.0)


def sameness(figure: Figure, first: Array, last: Array) -> Array:
    """Return +1, or −1 in the columns of quaternions whose last value is on the opposite hemisphere, (N,)."""
    signs = np.ones(first.size)
    for columns in figure.tables.quaternion_columns.T:
        if first[columns] @ last[columns] < 0:
            signs[columns] = -1.0
    return signs


def close_loop(
    figure: Figure, keys: list[Frame], travel: ArrayLike | None, turn: float | None
) -> tuple[list[Frame], Seam]:
    """Close the keyframes of a loop.

    Args:
        keys: Keyframes that hold qpos.
        travel: Displacement (3,) [m] of the first free root over one period; None: x and y from the keyframes.
        turn: Rotation [rad] of the first free root about the vertical; None: from the keyframes.

    Returns:
        The keyframes, with entries that the first or the last fixes fixed in both; and their seam, of qpos.

    Raises:
        TimelineError: The first and the last keyframe contradict each other, or travel or turn do not apply.
    """
    first, last = (_unit(figure, frame) for frame in (keys[0], keys[-1]))
    headings = _headings(figure, first, last, turn)
    seam = Seam.with_headings(figure, first.state, last.state, headings, "joint")
    seam = replace(seam, shift=_shift(figure, first, last, seam, _travel(figure, first, last, travel)))
    fixed, is_known = first.fixed | last.fixed, first.known | last.known
    from_first = first.fixed | (first.known & ~last.fixed)
    for x, heading in zip(figure.tables.position_columns[0], headings, strict=True):
        if heading:
            from_first[x : x + 2] = _has_place(first, x)
    state = np.where(from_first, first.state, seam.move(last.state, -1))
    begin, end = state, seam.move(state)
    difference = np.maximum(np.abs(end - last.state) * last.fixed, np.abs(begin - first.state) * first.fixed)
    if difference.max() > ROUNDING:
        raise TimelineError(
            f"periodic ends: the last keyframe (t = {last.time:g} s) differs from the first at "
            f"{_where(figure, int(np.argmax(difference)), seam)} by {difference.max():.3g}; "
            "they must agree, or leave it free in one of them. Only a root with a free joint can travel in a loop, "
            "and objects that it carries equally far"
        )
    posed = is_known & ~fixed
    ends = [replace(frame, state=at, fixed=fixed, posed=posed) for frame, at in ((first, begin), (last, end))]
    return [ends[0], *keys[1:-1], ends[1]], seam


def _unit(figure: Figure, frame: Frame) -> Frame:
    state = np.array(frame.state)
    for columns in figure.tables.quaternion_columns.T:
        if frame.known[columns].all():
            state[columns] = quat.normalise(state[columns])
    return replace(frame, state=state)


def _headings(figure: Figure, first: Frame, last: Frame, turn: float | None) -> Array:
    """Return the heading (f,) [rad] of each free root, 0 where either end leaves its orientation free."""
    headings = np.zeros(figure.tables.free_links.size)
    for i, link in enumerate(figure.tables.free_links):
        columns = quaternion_columns(figure.links[link])
        if (first.fixed & last.fixed)[columns].all():
            headings[i] = heading_between(first.state[columns], last.state[columns])
    if turn is None:
        return headings
    if not np.isfinite(turn):
        raise TimelineError(f"turn must be a finite angle, not {turn}")
    if not headings.size:
        raise TimelineError("the figure has no free joint, so no root to turn")
    angle = float(np.arctan2(np.sin(turn), np.cos(turn)))
    headings[0] = angle if abs(angle) > ROUNDING else 0.0
    return headings


def _travel(figure: Figure, first: Frame, last: Frame, travel: ArrayLike | None) -> Array:
    """Return the displacement (3, f) [m] of each root from its first position to its last. Roots after the first have
    that of the first, as carried objects do, if their positions in both keyframes are closer to it than to none."""
    roots = figure.tables.position_columns
    out = np.zeros(roots.shape)
    difference = np.where(first.fixed & last.fixed, last.state - first.state, 0.0)[roots]
    if travel is None:
        out[:2, :1] = np.where(np.abs(difference) > ROUNDING, difference, 0.0)[:2, :1]
    else:
        travel = np.asarray(travel, float)
        if travel.shape != (3,) or not np.all(np.isfinite(travel)):
            raise TimelineError(f"travel must be three finite numbers [x, y, z] in metres, not {travel.tolist()}")
        if not roots.size:
            raise TimelineError("the figure has no free joint, so no root to travel")
        out[:, 0] = travel
    is_carried = np.linalg.norm(difference - out[:, :1], axis=0) < np.linalg.norm(difference, axis=0)
    return np.where(is_carried, out[:, :1], out)


def _shift(figure: Figure, first: Frame, last: Frame, seam: Seam, travel: Array) -> Array:
    """Return the seam's shift (N,) [m] with which roots travel (3, f) from the position that either end fixes."""
    shift = np.zeros(figure.width)
    for (x, y, z), travelled, heading in zip(figure.tables.position_columns.T, travel.T, seam.headings, strict=True):
        shift[[x, y, z]] = travelled
        if not heading:
            continue
        if _has_place(first, x):
            begin = first.state[[x, y]]
        elif _has_place(last, x):
            begin = last.state[[x, y]] - travelled[:2]
        else:
            name = next(link.name for link in reversed(figure.links) if link.qpos <= x)
            raise TimelineError(f"a loop that turns needs x and y of '{name}' in its first or its last keyframe")
        state = np.zeros(figure.width)
        state[[x, y]] = begin
        shift[[x, y]] += begin - seam.linear(state)[[x, y]]
    return shift


def _has_place(frame: Frame, x: int) -> bool:
    """Return whether a keyframe fixes x and y of a root, the columns x and x + 1."""
    return bool(frame.fixed[x : x + 2].all())


def _where(figure: Figure, column: int, seam: Seam) -> str:
    """Return the name of a joint for an error about a loop's ends, for a root with the permitted differences."""
    number = next(i for i in reversed(range(len(figure.links))) if figure.links[i].qpos <= column)
    link = figure.links[number]
    if link.kind is not JointKind.FREE:
        return f"'{link.name}'"
    heading = seam.headings[figure.tables.free_links.tolist().index(number)]
    if column >= link.qpos + 3:
        here = f", here by {np.degrees(heading):g} degrees" if heading else ""
        return f"'{link.name}' (a loop may travel, and turn about the vertical{here})"
    travel = ", ".join(f"{metres:g}" for metres in seam.shift[link.qpos : link.qpos + 3])
    transform = f"turned by {np.degrees(heading):g} degrees" if heading else f"with travel = [{travel}]"
    return f"'{link.name}' along {'xyz'[column - link.qpos]} ({transform})"
