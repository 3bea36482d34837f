"""Jacobian rows of inverse dynamics in closed form: joint efforts, and the wrench at a free root.

Let a coordinate rotate a set of links by a small rotation vector φ(t) about a fixed origin. J is their inertia about
the origin, H their angular momentum, and P = Σ m r. The force F and the moment N of these links (eqs. 18-21) change by

    δF = (φ × P)''        δN = J φ'' + (J' φ' − H × φ') + φ × N + P × (φ × g)

The last term exists because gravity does not rotate with the links. A shift ψ(t) of the links changes F and N by δF = M
ψ'' and δN = P × ψ'' + ψ × F. A rotation about an anchor a is a rotation about the origin and a shift by −φ × a. A link
whose orientation is in the state does not rotate with its ancestors: φ shifts it, with all links beyond it, by φ × (its
anchor − a).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from ..array import IN_CACHE, Array, Index, Mask
from .adjoint import Cotangent
from .algebra import cross, dot, rotate
from .dynamics import InverseDynamics, RootWrench
from .kinematics import LinkMotion, Samples
from .turns import add_rows_of_shifts, add_rows_of_turns, followers, following, indices_of, places, turning
from .wrenches import Wrenches, every_axis, of_point

PRODUCT = (1, 2, 1)  # binomial coefficients of the second derivative of a product


@dataclass(frozen=True)
class Pushes:
    """External forces on points of the figure.

    Attributes:
        at: Samples, (P,).
        link: Links, (P,).
        offset: The points relative to the links' origins, (3, P) [m].
        force: The forces, (3, P) [N].
    """

    at: Index
    link: Index
    offset: Array
    force: Array

    def by_link(self, vectors: Array, like: Array) -> Array:
        """Return vectors (3, P) of the pushes, summed by link and sample, in the shape of `like` (3, L, S)."""
        flat, size = self.link * like.shape[2] + self.at, like[0].size
        return np.array([np.bincount(flat, part, size) for part in vectors], float).reshape(like.shape)

    def pull_back(self, wrench: RootWrench, into: Cotangent, force_bar: Array, moment_bar: Array) -> None:
        """Add the gradient of a scalar of force and moment, where the moment excludes that of these constant forces."""
        pull = cross(moment_bar[:, self.at], self.force)
        into.add_wrenches(of_point(self.at, self.link, self.offset, pull))
        by_centre = np.array([np.bincount(self.at, -part, into.samples.count) for part in pull], float)
        wrench.pull_back(into, force_bar, moment_bar, by_centre)


def wrench_rows(wrench: RootWrench, pushes: Pushes | None = None, *, moment: bool = True) -> Array:
    """Return the gradients of a free root's force and moment, in world axes, with respect to y, y', y'', (S, 6, 3, N).

    Args:
        pushes: External forces, constant; their moments (p − c) × f about the centre of mass c are subtracted.
        moment: Whether to include the moment; otherwise the result is (S, 3, 3, N).
    """
    samples, root, tables = wrench.samples, wrench.root, wrench.samples.figure.tables
    in_tree = tables.path[:, root]
    links = _Links(samples, in_tree, pushes, moment)
    out = np.zeros((samples.y.shape[1], links.rows, 3, samples.count))
    for moves in (_Turns(links), _Shifts(links)):
        joints = moves.joints[in_tree[moves.joints] > 0]
        if joints.size:
            change = moves.of(joints)
            if moment:
                centre, net_force = wrench.centre - links.origin, links.internal_force.sum(axis=1) / wrench.mass
                links.to_place(change, centre[:, None])
                change[0, :, 3:] += _crosses(net_force[:, None], change[2, :, :3])  # the centre also moves
            moves.add(joints, change, np.tile(np.arange(links.rows)[:, None], joints.size), out)
    return out.transpose(3, 1, 2, 0)


def joint_rows(samples: Samples) -> Array:
    """Return the gradients of the joint efforts with respect to y, y', y'', (S, R, 3, N), including armature.

    The R efforts are the moments at b ball joints in world axes (x of all, then y, then z), the moments about the axes
    of hinges, and the forces along the axes of slides.
    """
    tables, motion, inverse = samples.figure.tables, samples.links, samples.cache(InverseDynamics)
    links, (place, _) = _Links(samples, np.ones(len(samples.figure.links))), places(samples.figure)
    balls, hinges, slides = tables.ball_links, tables.hinge_links, tables.slide_links
    edges = 3 * balls.size, 3 * balls.size + hinges.size
    out = np.zeros((samples.y.shape[1], edges[1] + slides.size, 3, samples.count))
    along = (
        (hinges, motion.hinge_axis, inverse.moment, slice(3, 6), edges[0]),
        (slides, motion.slide_axis, inverse.force, slice(0, 3), edges[1]),
    )
    for moves in (_Turns(links), _Shifts(links)):
        for joint, moved, change in _pairs(links, moves):
            for run in indices_of(np.isin(joint, balls)):
                rows = np.searchsorted(balls, joint[run]) + balls.size * np.arange(3)[:, None]
                moves.add(moved[run], change[:, :, 3:, run], rows, out)
            for kind, axes, effort, part, first in along:
                for run in indices_of(np.isin(joint, kind)):
                    joints_of_run = joint[run]
                    axis = axes[:, place[joints_of_run]]
                    felt = np.einsum("okcns,cns->okns", change[:, :, part, run], axis)
                    felt[0] += moves.turned(joints_of_run, moved[run])[:, None] * cross(axis, effort[:, joints_of_run])
                    moves.add(moved[run], felt[:, :, None], first + place[joints_of_run][None], out)
    _add_armature(samples, out)
    return out.transpose(3, 1, 2, 0)


def _add_armature(samples: Samples, out: Array) -> None:
    """Add the effect of armature: of hinges and slides in proportion to y'', of ball joints by their links' rates."""
    tables, omega = samples.figure.tables, samples.links.omega
    motors, balls = np.concatenate([tables.hinge_links, tables.slide_links]), tables.ball_links
    columns = np.concatenate([tables.hinge_columns, tables.slide_columns])
    out[columns, 3 * balls.size + np.arange(motors.size), 2] += tables.armature[motors][:, None]
    heavy = np.flatnonzero(tables.armature[balls])
    if heavy.size:
        at, link, axis = every_axis(balls[heavy], samples.count)
        parent, axis = tables.parents[link], axis * tables.armature[link]
        # of axis · (α − α_p − ω × (ω − ω_p))
        child = Wrenches(at, link, torque_d=cross(omega[:, parent, at], axis), torque_dd=axis)
        other = Wrenches(at, parent, torque_d=cross(axis, omega[:, link, at]), torque_dd=-axis)
        rows = (child.rows(samples) + other.rows(samples)).reshape(3, heavy.size, samples.count, 3, -1)
        out[:, heavy + balls.size * np.arange(3)[:, None]] += rows.transpose(4, 0, 1, 3, 2)


class _Links:
    """Inertial quantities of links about a fixed origin, (..., L, S) each.

    Changes are arrays (3, 3, R, n, S): order and component of φ or ψ, and R = 3 rows of force and 3 of moment.

    Attributes:
        origin: A point in the middle of the figure, (3, S).
        anchors: The joints' anchors relative to the origin, and two derivatives, (3, 3, L, S).
        mass: The masses, (L, 1).
        first: The first moments m r, m r', m r'', (3, 3, L, S).
        internal_force: The force on each link minus the external forces, (3, L, S).
    """

    def __init__(self, samples: Samples, is_in_set: Array, pushes: Pushes | None = None, moment: bool = True) -> None:
        """Compute the quantities.

        Args:
            is_in_set: 1 for the links of the set, else 0, (L,).
            moment: Whether changes include the 3 rows of the moment.
        """
        self.samples, self.figure, self.has_moment = samples, samples.figure, moment
        self.rows = 6 if moment else 3
        inverse, motion, tables = samples.cache(InverseDynamics), samples.links, samples.figure.tables
        self.origin = motion.x[:, 1:].mean(axis=1)
        self.anchors = _anchors(motion)
        self.anchors[0] -= self.origin[:, None]
        self.gravity = samples.figure.gravity[:, None, None]
        is_in_set = is_in_set[:, None]
        self.mass = tables.mass[:, None] * is_in_set
        self.internal_force = inverse.net_force * is_in_set
        r, v = inverse.centre - self.origin[:, None], motion.x_d + cross(motion.omega, inverse.offset)
        self.first = np.array([self.mass * r, self.mass * v, self.internal_force + self.mass * self.gravity])
        if not moment:
            return
        half = is_in_set * cross(motion.omega[:, None], inverse.inertia) + _across(r, self.first[1])
        self._inertia = is_in_set * inverse.inertia + _across(r, self.first[0])
        self._inertia_d = half + half.swapaxes(0, 1)
        self._spin = cross(r, self.first[1]) + is_in_set * inverse.momenta[0]
        self._moment, self._pushed = cross(r, self.internal_force) + is_in_set * inverse.net_torque, None
        if pushes is not None:
            place = motion.x[:, pushes.link, pushes.at] + pushes.offset - self.origin[:, pushes.at]
            self._pushed = np.array([pushes.by_link(part, r) for part in _across(pushes.force, place)])
            self.internal_force = self.internal_force - pushes.by_link(pushes.force, r)

    def by_turns(self, sets: Array) -> Array:
        """Return the changes of sets of links (n, L) by rotations φ about the origin."""
        out = self._empty(len(sets))
        first = _sum(sets, self.first)
        _add_force(out, first)
        if self.has_moment:
            out[0, :, 3:] = _cross(_sum(sets, self._moment)) + _across(first[0], self.gravity)
            if self._pushed is not None:
                out[0, :, 3:] += _sum(sets, self._pushed)
            out[1, :, 3:] = _sum(sets, self._inertia_d) + _cross(_sum(sets, self._spin))
            out[2, :, 3:] = _sum(sets, self._inertia)
        return out

    def by_turned_shifts(self, sets: Array, s: Array) -> Array:
        """Return the changes of sets of links (n, L) by shifts φ × s, with s and two derivatives (3, 3, n, S)."""
        out = self._empty(len(sets))
        mass, first, force = sets @ self.mass, _sum(sets, self.first[0]), _sum(sets, self.internal_force)
        _add_force(out, mass * s)
        if self.has_moment:
            for order, factor in enumerate(PRODUCT):
                out[order, :, 3:] = factor * _across(first, s[2 - order])
            out[0, :, 3:] -= _across(force, s[0])
        return out

    def by_shifts(self, sets: Array) -> Array:
        """Return the changes of sets of links (n, L) by shifts ψ."""
        out = self._empty(len(sets))
        out[2, range(3), range(3)] = sets @ self.mass
        if self.has_moment:
            out[0, :, 3:] = _cross(_sum(sets, self.internal_force))
            out[2, :, 3:] = -_cross(_sum(sets, self.first[0]))
        return out

    def to_place(self, change: Array, place: Array) -> None:
        """Refer the moments of changes to a place (3, n, S) relative to the origin, instead of to the origin."""
        change[:, :, 3:] -= _crosses(place, change[:, :, :3])

    def carry(self, joint: Index, s: Array) -> Array:
        """Return the changes of all links beyond joints (P,), about their anchors, by shifts φ × s, s (3, 3, P, S)."""
        change, mass, lever = self._empty(joint.size), *self._levers(joint)
        _add_force(change, mass * s)
        for order, factor in enumerate(PRODUCT):
            change[order, :, 3:] = factor * _across(lever, s[2 - order])
        return change

    def shift(self, joint: Index) -> Array:
        """Return the same for shifts ψ."""
        change, mass, lever = self._empty(joint.size), *self._levers(joint)
        change[2, range(3), range(3)] = mass
        change[2, :, 3:] = -_cross(lever)
        return change

    def _levers(self, joint: Index) -> tuple[Array, Array]:
        """Return the masses beyond joints (P, 1), and their first moments about the anchors (3, P, S)."""
        return self._mass_beyond[joint], self._lever[:, joint]

    @cached_property
    def _mass_beyond(self) -> Array:
        return self.figure.tables.beyond @ self.mass

    @cached_property
    def _lever(self) -> Array:
        return np.matmul(self.figure.tables.beyond, self.first[0]) - self._mass_beyond * self.anchors[0]

    @cached_property
    def turned(self) -> Array:
        """The changes of all links beyond each joint, about its anchor, by their rotation about it as one body."""
        sets = self.figure.tables.beyond
        change = self.by_turns(sets) + self.by_turned_shifts(sets, -self.anchors)
        self.to_place(change, self.anchors[0])
        return change

    def _empty(self, count: int) -> Array:
        return np.zeros((3, 3, self.rows, count, self.samples.count))


class _Turns:
    """Small rotations φ of links by their joints, about the joints' anchors."""

    def __init__(self, links: _Links) -> None:
        tables = links.figure.tables
        self.links, self.add = links, partial(add_rows_of_turns, links.samples)
        self.joints = np.concatenate([tables.quaternion_links, tables.hinge_links])

    def of(self, joints: Index) -> Array:
        """Return the changes of all links that n joints move."""
        links, beyond, after = self.links, self.links.figure.tables.beyond, following(self.links.figure)[joints]
        near = np.union1d(joints, np.flatnonzero(after.any(axis=0)))
        shares = after[:, near] - (joints[:, None] == near)
        change = links.by_turns(turning(links.figure)[joints])
        shifted = links.by_turned_shifts(beyond[near], links.anchors[:, :, near])
        change += np.matmul(shares, shifted)
        return change

    def before(self, joint: Index, moved: Index) -> Array:
        """Return the changes of all links beyond joints (P,), about their anchors, by rotations of earlier joints (P,).
        The joints shift. They also rotate, unless there is a link in between whose orientation is in the state."""
        links, anchors = self.links, self.links.anchors
        between = followers(links.figure)[joint, moved]
        nearest = np.where(between > 0, between, joint)
        change = links.carry(joint, anchors[:, :, nearest] - anchors[:, :, moved])
        for run in indices_of(between == 0):
            change[:, :, :, run] += links.turned[:, :, :, joint[run]]
        return change

    def turned(self, joint: Index, moved: Index) -> Array:
        return turning(self.links.figure)[moved, joint]


class _Shifts:
    """Shifts ψ of links by slides and free joints."""

    def __init__(self, links: _Links) -> None:
        tables = links.figure.tables
        self.links, self.add = links, partial(add_rows_of_shifts, links.samples)
        self.joints = np.concatenate([tables.free_links, tables.slide_links])

    def of(self, joints: Index) -> Array:
        return self.links.by_shifts(self.links.figure.tables.beyond[joints])

    def before(self, joint: Index, moved: Index) -> Array:
        return self.links.shift(joint)

    def turned(self, joint: Index, moved: Index) -> Array:
        return np.zeros(joint.size)


def _pairs(links: _Links, moves: _Turns | _Shifts) -> Iterator[tuple[Index, Index, Array]]:
    """Yield joints (P,), other joints (P,) on which their efforts depend, and the changes about the former anchors."""
    path, most = links.figure.tables.path > 0, max(1, 10 * IN_CACHE // links.samples.count)
    has_effort = ~np.isin(np.arange(len(path)), [0, *links.figure.tables.free_links])
    change = moves.of(moves.joints)
    for moved, joint in _runs(path[moves.joints] & has_effort, most):
        part = change[:, :, :, moved]
        links.to_place(part, links.anchors[0][:, joint])
        yield joint, moves.joints[moved], part
    is_before = path[:, moves.joints] & has_effort[:, None] & (np.arange(len(path))[:, None] != moves.joints)
    for joint, moved in _runs(is_before, most):
        yield joint, moves.joints[moved], moves.before(joint, moves.joints[moved])


def _runs(mask: Mask, most: int) -> Iterator[tuple[Index, Index]]:
    row, column = np.nonzero(mask)
    for first in range(0, row.size, most):
        yield row[first : first + most], column[first : first + most]


def _anchors(motion: LinkMotion) -> Array:
    places = np.array([motion.x, motion.x_d, motion.x_dd])
    if motion.hang is not None:
        places += np.array([motion.hang, cross(motion.omega, motion.hang), rotate(motion.swing, motion.hang)])
    return places


def _sum(sets: Array, part: Array) -> Array:
    """Return sums over sets of links (n, L): (..., L, S) -> (..., n, S)."""
    if np.all(sets.sum(axis=1) == 1):
        return part[..., np.argmax(sets, axis=1), :]
    return np.matmul(sets, part)


def _add_force(change: Array, first: Array) -> None:
    """Add δF = (φ × p)'' to changes, with p and two derivatives (3, 3, n, S)."""
    for order, factor in enumerate(PRODUCT):
        change[order, :, :3] += factor * _cross(first[2 - order])


def _cross(v: Array) -> Array:
    """Return φ × v by components of φ and of the product: (3, n, S) -> (3, 3, n, S)."""
    out, (x, y, z) = np.zeros((3, *v.shape)), v
    out[1, 0], out[2, 1], out[0, 2] = z, x, y
    for target, source in ((out[2, 0], y), (out[0, 1], z), (out[1, 2], x)):
        np.negative(source, out=target)
    return out


def _across(p: Array, v: Array) -> Array:
    """Return p × (φ × v) by the same components: (3, n, S) with (3, n, S)."""
    out = np.negative(p)[:, None] * v
    diagonal = dot(p, v)
    for i in range(3):
        out[i, i] += diagonal
    return out


def _crosses(v: Array, rows: Array) -> Array:
    """Return v × each of several vectors: (3, n, S) with (..., 3, n, S)."""
    (x, y, z), out = v, np.empty(np.broadcast_shapes(v.shape, rows.shape))
    a, b, c = (rows[..., i, :, :] for i in range(3))
    out[..., 0, :, :] = y * c - z * b
    out[..., 1, :, :] = z * a - x * c
    out[..., 2, :, :] = x * b - y * a
    return out
