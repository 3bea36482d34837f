"""The seam of a loop: where its last frame stands beside its first, and how smoothly the curve goes on across it.

    last = A first + shift        y' and y'' of the end = A times those of the start

A walk cycle repeats itself, moved on; one on a circle, turned as well. A turns every free root, and what hangs from it,
by a heading angle φ about the vertical. So A is linear: the pair (x, y) of a root's position turns by φ; a quaternion
that is a root's own, or a link's in the world, is multiplied from the left, which turns its pairs (w, z) and (x, y) by
φ/2; and −1 stands where a quaternion comes back as −q, after a full turn. What is constant, the shift, does not show in
y' and y''.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from .. import quaternion as quat
from ..array import Array, Index
from ..figure.figure import Figure, JointKind, quaternion_columns
from .frame import Timeline
from .spline import Complex, Path, Spline

LEVEL = 1e-9  # of a turn's quaternion x and y, up to which it is about the vertical; and z, up to which it is none


@dataclass(frozen=True, eq=False)
class Seam:
    """How a state (N,) comes back.

    signs     (N,) ±1
    angles    (N,) [rad] A y = signs · (cos(angles) y + sin(angles) y[partners])
    partners  (N,) the other column of a pair that turns; of columns that do not, themselves
    headings  (f,) [rad] by how much each free root is turned, from −π to π
    travel    (N,) [m] last − first, zero but for the positions of free roots
    shift     (N,) [m] last − A first of these
    """

    signs: Array
    angles: Array
    partners: Index
    headings: Array
    travel: Array
    shift: Array

    @classmethod
    def between(cls, figure: Figure, first: Array, last: Array) -> Seam:
        """The seam of a loop that begins and ends with these states (N,)."""
        about = _root_quaternions(figure)
        return cls.turned(figure, first, last, heading_between(first[about], last[about]))

    @classmethod
    def turned(cls, figure: Figure, first: Array, last: Array, headings: Array, coordinates: str | None = None) -> Seam:
        """The seam between states (N,) whose free roots turn by headings (f,) [rad], whatever their quaternions say.

        coordinates  "joint" for configurations qpos, where no link but the roots is turned
        """
        angles, partners = np.zeros(first.size), np.arange(first.size)
        roots = dict(zip(figure.tables.free_links.tolist(), headings.tolist(), strict=True))
        for column, angle in zip(figure.tables.position_columns[0], headings, strict=True):
            _pair(angles, partners, column, column + 1, angle)
        in_world = (coordinates or figure.coordinates) == "world"
        for i, (w, x, y, z) in zip(figure.tables.quaternion_links, figure.tables.quaternion_columns.T, strict=True):
            angle = roots.get(_root_of(figure, int(i), in_world=in_world), 0.0)
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
        """The seam of a periodic timeline."""
        return cls.between(figure, timeline.states[0], timeline.states[-1])

    @property
    def turns(self) -> bool:
        """Whether it comes back turned."""
        return bool(self.headings.any())

    def linear(self, values: Array, periods: ArrayLike = 1) -> Array:
        """Aᵏ y of values (..., N), for whole numbers k of periods (...)."""
        k = np.asarray(periods)[..., None]
        return self.signs**k * self._rotated(values, k * self.angles)

    def moved(self, states: Array, periods: ArrayLike = 1) -> Array:
        """States (..., N) some periods (...) later: Aᵏ y + (1 + A + … + Aᵏ⁻¹) shift."""
        k = np.asarray(periods)[..., None]
        half = self.angles / 2
        steep = half != 0
        length = np.where(steep, np.sin(k * half) / np.where(steep, np.sin(half), 1.0), k)
        return self.linear(states, periods) + length * self._rotated(self.shift, (k - 1) * half)

    def _rotated(self, values: Array, angles: Array) -> Array:
        return np.cos(angles) * values + np.sin(angles) * values[..., self.partners]

    def matrix(self) -> Array:
        """A, (N, N)"""
        return self.linear(np.eye(self.signs.size)).T

    def carried(self, figure: Figure, points: Array, periods: ArrayLike = 1) -> Array:
        """Points (..., 3) [m] of the world that go with the first free root, some periods later; without one, as they
        are."""
        roots = figure.tables.position_columns
        if not roots.size:
            return points
        state = np.zeros((*points.shape[:-1], self.signs.size))
        state[..., roots[:, 0]] = points
        return self.moved(state, periods)[..., roots[:, 0]]

    def turn(self, periods: int = 1) -> Array:
        """(4,) by how much the first free root, and what hangs from it, is turned some periods later."""
        angle = self.headings[0] if self.headings.size else 0.0
        return quat.from_rotation_vector(periods * angle * np.array([0.0, 0.0, 1.0]))

    def jumps(self, spline: Spline, states: Array) -> Array:
        """(2, N): the jumps of y' and y'' from end to start of a periodic `Spline` through states (M, N)."""
        out = np.zeros((2, self.signs.size))
        for columns, shares in self.shares(spline):
            out[:, columns] += (shares.real @ states)[:, columns] + (shares.imag @ states)[:, self.partners[columns]]
        return out

    def shares(self, spline: Spline) -> list[tuple[Index, Complex]]:
        """Columns with a jump, and as which shares (2, M) of states it comes: real ones of their own, imaginary ones of
        their partners."""
        ways = np.stack([self.signs, self.angles], axis=1)
        found = []
        for sign, angle in np.unique(ways, axis=0):
            if sign < 0 or angle:
                factor = complex(sign * np.cos(angle), sign * np.sin(angle))
                columns = np.flatnonzero((self.signs == sign) & (self.angles == angle))
                found.append((columns, spline.jumps_of(factor)))
        return found

    def apart(self, path: Path) -> Array:
        """(3,) the largest entry by which y, y' and y'' at the end of a loop miss those at the start, moved on."""
        start, end = (path.motion(np.array([t]))[:, 0] for t in path.span)
        wanted = self.linear(start)
        wanted[0] += self.shift
        return np.abs(end - wanted).max(axis=1)


def _pair(angles: Array, partners: Index, u: int, v: int, angle: float) -> None:
    """Makes the columns (u, v) turn by an angle: u' = cos u − sin v, v' = cos v + sin u."""
    if angle:
        angles[[u, v]] = -angle, angle
        partners[[u, v]] = v, u


def _root_of(figure: Figure, link: int, *, in_world: bool) -> int:
    """The free link that turns a link's quaternion with it, or 0: itself, or the one that it hangs from if the
    quaternion is its orientation in the world."""
    while link and figure.links[link].kind is not JointKind.FREE:
        link = figure.links[link].parent if in_world and figure.tables.in_world[link] else 0
    return link


def _root_quaternions(figure: Figure) -> Index:
    """(f, 4) the columns of the free roots' quaternions."""
    found = [quaternion_columns(figure.links[i]) for i in figure.tables.free_links]
    return np.array([np.arange(figure.width)[some] for some in found if some is not None], np.intp).reshape(-1, 4)


def heading_between(first: Array, last: Array) -> Array:
    """(...) [rad] by how much quaternions (..., 4) turn about the vertical, −π to π; 0 where it is another turn."""
    w, x, y, z = np.moveaxis(quat.normalised(quat.product(last, quat.inverse(first))), -1, 0)
    upright = (np.abs(x) <= LEVEL) & (np.abs(y) <= LEVEL) & (np.abs(z) > LEVEL)
    return np.where(upright, 2 * np.arctan2(np.copysign(1.0, w) * z, np.abs(w)), 0.0)


def sameness(figure: Figure, first: Array, last: Array) -> Array:
    """(N,): +1, or −1 in the columns of quaternions that come back on the other hemisphere."""
    signs = np.ones(first.size)
    for columns in figure.tables.quaternion_columns.T:
        if first[columns] @ last[columns] < 0:
            signs[columns] = -1.0
    return signs
