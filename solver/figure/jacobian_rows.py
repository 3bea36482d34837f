"""Jacobian rows in closed form of the moments at ball joints and of the wrench at a free root.

They are what `curvature.jacobian` finds by one adjoint sweep a row, many times faster, for figures in world coordinates
whose joints sit at their bodies' origins. A moment takes from the links beyond its joint what inverse dynamics says
(eqs. 18-21), and hands it on to the links before it through the accelerations of their origins (eq. 13).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array, Index
from .adjoint import Cotangent
from .algebra import applied, cross, dot, gathered, pure_product
from .dynamics import InverseDynamics
from .figure import Figure, JointKind
from .kinematics import LinkMotion, Samples
from .wrench import RootWrench


def has_moment_rows(figure: Figure) -> bool:
    """Whether `moment_rows` and `wrench_rows` know the figure."""
    balls = np.array([link.kind == JointKind.BALL for link in figure.links])
    tables = figure.tables
    return figure.is_world and not tables.has_anchors and not np.any(tables.armature[balls])


@dataclass(frozen=True)
class _Relations:
    """Which links a ball joint's moment depends on: pairs of a link and one of J joints, by index.

    beyond       (2, D) links beyond the joint, itself included
    related      (2, R) the same and the links before it
    from_beyond  (R, D) 1 where a pair's link lies before the other's, on the way to it, of the same joint
    to_parent    (R, R) 1 where a pair (row) has the parent of the other's link
    placed       (R, D) 1 where both are the same pair
    joint        (R,) index of the pair of the joint itself, for each of J joints
    """

    joints: Index
    beyond: Index
    related: Index
    from_beyond: Array
    to_parent: Array
    placed: Array
    joint: Index

    @classmethod
    def of(cls, figure: Figure) -> _Relations:
        path = figure.tables.path > 0
        joints = np.array([i for i, link in enumerate(figure.links) if i and link.kind is JointKind.BALL], np.intp)
        beyond = np.array([(i, n) for n, j in enumerate(joints) for i in np.flatnonzero(path[:, j])], np.intp).T
        before = [(i, n) for n, j in enumerate(joints) for i in np.flatnonzero(path[j]) if i != j]
        related = np.concatenate([beyond, np.array(before, np.intp).reshape(-1, 2).T], axis=1)
        same = related[1][:, None] == related[1]
        parents = figure.tables.parents
        of_beyond = same[:, : beyond.shape[1]]
        return cls(
            joints,
            beyond,
            related,
            (of_beyond & path[beyond[0]][:, related[0]].T).astype(float),
            (same & (related[0][:, None] == parents[related[0]])).astype(float),
            np.eye(related.shape[1], beyond.shape[1]),
            np.array([np.flatnonzero((beyond[0] == j) & (beyond[1] == n))[0] for n, j in enumerate(joints)], np.intp),
        )


def moment_rows(samples: Samples) -> Array:
    """(S, 3 J, 3, N): gradients of the J ball joints' moments, their world components, with respect to y, y', y''."""
    figure, links = samples.figure, samples.links
    tables, relations = figure.tables, _Relations.of(figure)
    inverse = samples.once(InverseDynamics)
    turn, omega, alpha, root = _link_gradients(links, inverse, relations)
    gradients = _quaternion_gradients(_Chosen(links, relations.related[0]), turn, omega, alpha)
    out = np.zeros((samples.count, relations.joints.size, 3, 3, samples.y.shape[1]))
    block = np.zeros(len(figure.links), np.intp)
    block[tables.quaternion_links] = np.arange(tables.quaternion_links.size)
    columns = tables.quaternion_columns[:, block[relations.related[0]]]
    joint = relations.related[1]
    for order, gradient in enumerate(gradients):
        for axis in range(3):
            # advanced indices around slices: (pairs, S) and the component
            out[:, joint[:, None], axis, order, columns.T] = gradient[:, :, axis].transpose(2, 1, 0)
    for free, position in zip(tables.free_links, tables.position_columns.T, strict=True):
        at_root = np.flatnonzero(relations.related[0] == free)
        x_dd = root[:, at_root]
        for k, column in enumerate(position):
            out[:, joint[at_root], :, 2, column] = x_dd[k].transpose(0, 2, 1)
    return out.reshape(samples.count, -1, 3, samples.y.shape[1])


@dataclass(frozen=True)
class Pushes:
    """Forces that points of the figure get from outside: at samples `at` (P,), on links `link` (P,), at `offset` (3, P)
    from the links' origins [m], force (3, P) [N]."""

    at: Index
    link: Index
    offset: Array
    force: Array

    def by_link(self, vectors: Array, like: Array) -> Array:
        """Vectors (3, P) of the pushes, summed over those of one link and sample: (3, L, S), the shape of `like`."""
        flat, size = self.link * like.shape[2] + self.at, like[0].size
        return np.array([np.bincount(flat, part, size) for part in vectors], float).reshape(like.shape)

    def pull_back(self, wrench: RootWrench, into: Cotangent, force_bar: Array, moment_bar: Array) -> None:
        """Adds the gradient of a scalar of force and moment, the moments of these pushes, which are held, taken off."""
        pull = cross(moment_bar[:, self.at], self.force)
        into.add_forces(self.link * into.samples.count + self.at, self.offset, pull)
        by_centre = np.array([np.bincount(self.at, -part, into.samples.count) for part in pull], float)
        wrench.pull_back(into, force_bar, moment_bar, by_centre)


def wrench_rows(wrench: RootWrench, pushes: Pushes | None = None) -> Array:
    """(S, 6, 3, N): gradients of a free root's force and moment, world components, with respect to y, y', y''.

    With pushes, their moments (p − c) × f about the centre of mass are taken off the moment; the forces are held.
    """
    samples, root, inverse = wrench.samples, wrench.root, wrench.inverse
    links, tables, count = samples.links, samples.figure.tables, samples.count
    mass = wrench.mass * wrench.share
    # what holds a link's centre of mass in the moment: N = Σ m d × c'' + L'_own, d = c − centre
    hold = inverse.net_force * tables.path[:, root, None] - wrench.share[:, None] * wrench.force[:, None]
    away = mass[:, None] * (inverse.centre - wrench.centre[:, None])
    beyond_hold = hold
    if pushes is not None:
        pushed = pushes.by_link(pushes.force, hold)
        hold = hold + wrench.share[:, None] * pushed.sum(axis=1)[:, None]
        beyond_hold = hold - pushed
    shape = (3, mass.size, 6, count)
    arms = _attached_wrench((links.omega, links.alpha), inverse.offset, mass, hold, away)
    beyond = (tables.beyond @ mass, gathered(tables.beyond, beyond_hold), gathered(tables.beyond, away))
    parents = tables.parents
    steps = _attached_wrench((links.omega[:, parents], links.alpha[:, parents]), links.step, *beyond)
    to_parent = (parents[None, :] == np.arange(mass.size)[:, None]) * tables.path[:, root]
    turn, omega, alpha = (
        own + gathered(to_parent, part.reshape(3, mass.size, -1)).reshape(shape)
        for own, part in zip(arms, steps, strict=True)
    )
    for axis, e in enumerate(np.eye(3)):
        own = tables.path[:, root, None] * np.ones(count)
        direction = e[:, None, None] * own
        tilt = cross(direction, links.omega)
        turned, tilted = applied(inverse.inertia, direction), applied(inverse.inertia, tilt)
        spin, spin_rate = inverse.momenta
        turn[:, :, 3 + axis] += cross(spin_rate, direction) + cross(turned, links.alpha)
        turn[:, :, 3 + axis] += cross(spin, tilt) + cross(tilted, links.omega)
        omega[:, :, 3 + axis] += cross(spin, direction) + tilted
        alpha[:, :, 3 + axis] += turned
        if pushes is not None:
            pull = cross(pushes.offset, cross(e[:, None], pushes.force))
            turn[:, :, 3 + axis] += pushes.by_link(pull, hold)
    gradients = _quaternion_gradients(_Chosen(links, np.arange(mass.size)), turn, omega, alpha)
    out = np.zeros((count, 6, 3, samples.y.shape[1]))
    for order, gradient in enumerate(gradients):
        blocks = gradient[:, tables.quaternion_links]
        for k, columns in enumerate(tables.quaternion_columns):
            out[:, :, order, columns] = blocks[k].transpose(2, 1, 0)
    position = tables.position_columns[:, tables.free_links == root][:, 0]
    out[:, np.arange(3), 2, position] = wrench.mass
    return out


def _attached_wrench(
    rates: tuple[Array, Array], s: Array, mass: Array, hold: Array, away: Array
) -> tuple[Array, Array, Array]:
    """Gradients of (turn, ω, ω'), (3, n, 6, S) each, of the force Σ m s'' and the moment Σ s × hold + away × s'' of
    vectors s (3, n, S) that turn at rates (ω, ω')."""
    g, g_dd = np.zeros((2, 3, *s.shape[1:2], 6, s.shape[2]))
    for axis, e in enumerate(np.eye(3)):
        g_dd[axis, :, axis] = mass[:, None]
        g[:, :, 3 + axis] = cross(hold, e[:, None, None])
        g_dd[:, :, 3 + axis] = cross(e[:, None, None], away)
    omega, alpha = (rate[:, :, None] for rate in rates)
    return _attached((omega, alpha), s[:, :, None], g, g_dd)


class _Chosen:
    """A LinkMotion's quaternions and rates for some links: (c, n, 1, S), to meet several vectors each."""

    def __init__(self, links: LinkMotion, chosen: Index) -> None:
        self.Q, self.Q_d, self.Q_dd = links.quaternions[:, :, chosen, None]
        self.omega, self.alpha = links.spins[:, :, chosen, None]
        self.length_squared, self.stretch_rate = (
            part[chosen, None] for part in (links.length_squared, links.stretch_rate)
        )


def _link_gradients(
    links: LinkMotion, inverse: InverseDynamics, relations: _Relations
) -> tuple[Array, Array, Array, Array]:
    """Each moment component's gradient with respect to (turn, ω, ω') and x'' of the related links: (3, R, 3, S)."""
    tables = links.figure.tables
    link, joint = relations.beyond
    axes = np.eye(3)[:, None, :, None]

    def each(array: Array) -> Array:
        """Links' vectors (3, L, S) for pairs: (3, D, 1, S)."""
        return array[:, link, None]

    def inertia_times(vectors: Array) -> Array:
        return np.einsum("ijps,jpas->ipas", inverse.inertia[:, :, link], vectors)

    omega, alpha, force = each(links.omega), each(links.alpha), each(inverse.net_force)
    spin, spin_rate = (each(part) for part in inverse.momenta)
    lever = each(inverse.centre) - links.anchor[:, relations.joints[joint], None]
    acceleration = cross(axes, lever) * tables.mass[link][:, None, None]
    centre = cross(force, axes)
    tilt = cross(axes, omega)
    turned, tilted = inverse.inertia[:, :, link].swapaxes(1, 2), inertia_times(tilt)
    turn = cross(spin_rate, axes) + cross(turned, alpha) + cross(spin, tilt) + cross(tilted, omega)
    offset = _attached((omega, alpha), each(inverse.offset), centre, acceleration)
    own = (turn + offset[0], cross(spin, axes) + tilted + offset[1], turned + offset[2])
    at_anchor = cross(axes, inverse.force[:, relations.joints, None])
    x = _joined(relations.from_beyond, centre)
    x += _joined(_before(relations), at_anchor)
    x_dd = _joined(relations.from_beyond, acceleration)
    related = relations.related[0]
    parent = tables.parents[related]
    rates = (links.omega[:, parent, None], links.alpha[:, parent, None])
    handed = _attached(rates, links.step[:, related, None], x, x_dd)
    gradients = [
        _joined(relations.placed, part) + _joined(relations.to_parent, more)
        for part, more in zip(own, handed, strict=True)
    ]
    return gradients[0], gradients[1], gradients[2], x_dd


def _attached(rates: tuple[Array, Array], s: Array, g: Array, g_dd: Array) -> tuple[Array, Array, Array]:
    """Gradients of vectors s and s'' that turn with links at rates (ω, ω') as gradients of (turn, ω, ω')."""
    omega, alpha = rates
    through = cross(g_dd, omega)
    pull = g + cross(g_dd, alpha) + cross(through, omega)
    return cross(s, pull), cross(cross(omega, s), g_dd) + cross(s, through), cross(s, g_dd)


def _quaternion_gradients(links: _Chosen, turn: Array, omega: Array, alpha: Array) -> tuple[Array, Array, Array]:
    """Gradients of (turn, ω, ω') as gradients of Q, Q', Q''; the reasons are in the kinematics."""
    b = links.length_squared
    rate = 2 * links.stretch_rate
    v = links.Q * (2 / b)
    v_d = links.Q_d * (2 / b) - v * rate
    b_dd = 2 * (dot(links.Q, links.Q_dd) + dot(links.Q_d, links.Q_d)) / b
    v_dd = (links.Q_dd - 2 * rate * links.Q_d) * (2 / b) + v * (2 * rate**2 - b_dd)
    p1 = omega + cross(links.omega, alpha)
    p0 = turn + cross(links.omega, omega) + cross(links.alpha, alpha)
    first = pure_product(p0, v) + pure_product(p1, v_d) + pure_product(alpha, v_dd)
    return first, pure_product(p1, v) + 2 * pure_product(alpha, v_d), pure_product(alpha, v)


def _before(relations: _Relations) -> Array:
    """(R, J): 1 where a joint lies on a pair's link or beyond, for the pair's own joint."""
    return relations.from_beyond[:, relations.joint]


def _joined(weights: Array, vectors: Array) -> Array:
    """Sums over pairs: (m, n) with (3, n, 3, S) -> (3, m, 3, S)."""
    _, n, several, count = vectors.shape
    return gathered(weights, vectors.reshape(3, n, -1)).reshape(3, -1, several, count)
