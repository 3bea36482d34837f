"""Jacobian rows of points fixed on links, in closed form, for figures of any joints in any coordinates.

A point p beyond a hinge of axis e through a moves by e × (p − a), beyond a slide by its axis. A quaternion that is its
link's orientation in the world turns what lies between its anchor and that of the next such link on the way to the
point, and all of it if there is none; one relative to its parent turns all that is beyond, in the parent's axes. What
`rows.point_rows` knows of figures whose orientations are all in the state this knows of the others.
"""

from __future__ import annotations

import numpy as np

from ..array import Array, Index
from .algebra import cross, dot, hamilton, rotation_matrix, turned, turned_back, vector_product
from .axes import followers
from .kinematics import Samples

AT_ONCE = 150_000  # pairs of a point and a link


def any_point_rows(samples: Samples, at: Index, link: Index, offset: Array, direction: Array) -> Array:
    """(P, N): the gradient of direction · p with respect to y. Arguments as in `rows.point_rows`."""
    return _in_parts(samples, at, link, offset, direction, rates=False)[:, 0]


def any_velocity_rows(samples: Samples, at: Index, link: Index, offset: Array, direction: Array) -> Array:
    """(P, 2, N): the gradients of direction · v with respect to y and y', as in `rows.velocity_rows`."""
    return _in_parts(samples, at, link, offset, direction, rates=True)[:, ::-1]


def _in_parts(samples: Samples, at: Index, link: Index, offset: Array, direction: Array, *, rates: bool) -> Array:
    """(P, 1 or 2, N): rows, and with `rates` how fast they change, direction held."""
    out = np.zeros((at.size, 2 if rates else 1, samples.y.shape[1]))
    few = max(1, AT_ONCE // len(samples.figure.links))
    for first in range(0, at.size, few):
        some = slice(first, first + few)
        _Points(samples, at[some], link[some], offset[:, some], direction[:, some]).add_to(out[some], rates=rates)
    return out


class _Points:
    """Points of links at samples, with what their rows are made of."""

    def __init__(self, samples: Samples, at: Index, link: Index, offset: Array, direction: Array) -> None:
        self.samples, self.figure, self.tables = samples, samples.figure, samples.figure.tables
        self.motion, self.at, self.link, self.offset, self.direction = samples.links, at, link, offset, direction
        self.place = self.motion.x[:, link, at] + offset
        self.on = self.tables.path[link].T > 0  # (L, P)

    def add_to(self, out: Array, *, rates: bool) -> None:
        """Adds rows (P, 1 or 2, N)."""
        self._free(out)
        self._axes(out, rates=rates)
        self._quaternions(out, rates=rates)

    def _free(self, out: Array) -> None:
        for free, columns in zip(self.tables.free_links, self.tables.position_columns.T, strict=True):
            out[:, 0, columns] = (self.direction * self.on[free]).T

    def _axes(self, out: Array, *, rates: bool) -> None:
        """Hinges and slides: a row is the screw of an axis on the wrench that `direction` makes at the point."""
        wrench = np.concatenate([cross(self.place, self.direction), self.direction])
        turning = cross(self._velocity, self.direction) if rates else None
        for links, columns, first in (
            (self.tables.hinge_links, self.tables.hinge_columns, 0),
            (self.tables.slide_links, self.tables.slide_columns, 3),  # of whose screws the first half is nought
        ):
            if not links.size:
                continue
            screw, screw_d = self._screws(links, is_hinge=first == 0, rates=rates)
            for link in np.unique(self.link):
                some, own = np.flatnonzero(self.link == link), np.flatnonzero(self.tables.path[link, links] > 0)
                there, at = np.ix_(some, columns[own]), self.at[some]
                seen = screw[:, own][:, :, at]
                out[:, 0][there] = _on(seen, wrench[first:, some])
                if rates:
                    assert screw_d is not None and turning is not None
                    out[:, 1][there] = _on(screw_d[:, own][:, :, at], wrench[first:, some])
                    if first == 0:
                        out[:, 1][there] += _on(seen[:3], turning[:, some])

    def _screws(self, links: Index, *, is_hinge: bool, rates: bool) -> tuple[Array, Array | None]:
        """The screws (6, n, S) of axes e through anchors a, e and a × e, of slides e alone (3, n, S); and how fast they
        change."""
        motion = self.motion
        e = turned(motion.rotation[:, :, links], self.tables.axis[:, links])
        e_d = cross(motion.omega[:, links], e) if rates else None
        if not is_hinge:
            return e, e_d
        a = motion.anchor[:, links]
        screw = np.concatenate([e, cross(a, e)])
        if e_d is None:
            return screw, None
        return screw, np.concatenate([e_d, cross(self._anchor_velocities[:, links], e) + cross(a, e_d)])

    def _quaternions(self, out: Array, *, rates: bool) -> None:
        tables, motion, at = self.tables, self.motion, self.at
        links = tables.quaternion_links
        if not links.size:
            return
        after = followers(self.figure)[self.link][:, links].T  # (n, P)
        ends = np.where(after > 0, motion.anchor[:, after, at], self.place[:, None])
        direction, on = self.direction[:, None], self.on[links]
        torque = cross(ends - motion.anchor[:, links][:, :, at], direction) * on
        torque_d = torque
        if rates:
            fast = np.where(after > 0, self._anchor_velocities[:, after, at], self._velocity[:, None])
            torque_d = cross(fast - self._anchor_velocity(links), direction) * on
        loose = np.flatnonzero(~tables.in_world[links])
        if loose.size:
            base, parents = self._base(links[loose]), tables.parents[links[loose]]
            if rates:
                spin = motion.omega[:, parents][:, :, at]
                torque_d[:, loose] = turned_back(base, torque_d[:, loose] - cross(spin, torque[:, loose]))
            torque[:, loose] = turned_back(base, torque[:, loose])
        q, scale = self.samples.q, 2 / self.samples.q_dots[0]
        product = vector_product(q * scale)[:, :, :, at]
        columns = tables.quaternion_columns
        out[:, 0, columns] = turned_back(product, torque).transpose(2, 0, 1)
        if rates:
            stretch = self.samples.q_dots[1] * scale
            product_d = vector_product((self.samples.q_d - stretch * q) * scale)[:, :, :, at]
            rate = turned_back(product_d, torque) + turned_back(product, torque_d)
            out[:, 1, columns] = rate.transpose(2, 0, 1)

    def _base(self, links: Index) -> Array:
        """(3, 3, n, P) the axes that relative rotations of links are in."""
        base = hamilton(self.motion.Q[:, self.tables.parents[links]], self.tables.turn[:, links, None])
        return rotation_matrix(base, 2 / dot(base, base))[:, :, :, self.at]

    @property
    def _velocity(self) -> Array:
        """(3, P) of the points."""
        motion = self.motion
        return motion.x_d[:, self.link, self.at] + cross(motion.omega[:, self.link, self.at], self.offset)

    @property
    def _anchor_velocities(self) -> Array:
        """(3, L, S) of all anchors."""
        motion = self.motion
        return motion.x_d if motion.hang is None else motion.x_d + cross(motion.omega, motion.hang)

    def _anchor_velocity(self, links: Index) -> Array:
        """(3, n, P) of some links' anchors."""
        return self._anchor_velocities[:, links][:, :, self.at]


def _on(screws: Array, wrenches: Array) -> Array:
    """(P, n): screws (k, n, P), each on its point's wrench (k, P)."""
    return np.einsum("knp,kp->pn", screws, wrenches)
