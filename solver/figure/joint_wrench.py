"""Jacobian rows of a free root's wrench, in closed form, for figures of any joints in any coordinates.

Let a coordinate grow by φ(t), which moves the links beyond it as the twist φ S does: S = (w, s), a turn w about the
origin and a shift s. The momentum of these links, linear and angular about the origin, h = I v with I their inertia,
changes by

    δh  = φ (S ×* h + I S') + φ' I S
    δh' = φ (S' ×* h + S ×* h' + I' S' + I S'') + φ' (S ×* h + 2 I S' + I' S) + φ'' I S

with S ×* (f, n) = (w × f, w × n + s × f). The origin is where the centre of mass c is now, and moves as fast as c does
now, so that h = 0 for the whole; there the moment N about c changes by δh' − δc × M c''.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..array import Array
from .algebra import applied, cross, dot, gathered
from .axes import Axes, axes_of
from .jacobian_rows import Pushes
from .wrench import RootWrench


def any_wrench_rows(wrench: RootWrench, pushes: Pushes | None = None) -> Array:
    """(S, 6, 3, N), as `jacobian_rows.wrench_rows`."""
    samples = wrench.samples
    out = np.zeros((samples.count, 6, 3, samples.y.shape[1]))
    links = samples.links
    velocity = np.einsum("l,ils->is", wrench.share, links.x_d + cross(links.omega, wrench.inverse.offset))
    parts = _Parts.of_links(wrench, velocity, pushes)
    whole = parts.of(np.ones((1, len(samples.figure.links))))
    origin = np.zeros((3, 3, 1, samples.count))
    origin[0, :, 0], origin[1, :, 0] = wrench.centre, velocity
    for axes in axes_of(links):
        turn, shift = _twists(axes, origin)
        axes.add(_changes(parts.of(axes.moved), turn, shift, whole), out)
    return out


def _twists(axes: Axes, origin: Array) -> tuple[Array | None, Array]:
    """w, w', w'' and s, s', s'' at the origin, (3, 3, n, S) each."""
    if axes.turn is None:
        return None, axes.place
    (w, w_d, w_dd), (a, a_d, a_dd) = axes.turn, axes.place - origin
    shift = (cross(a, w), cross(a_d, w) + cross(a, w_d), cross(a_dd, w) + 2 * cross(a_d, w_d) + cross(a, w_dd))
    return axes.turn, np.array(shift)


@dataclass(frozen=True)
class _Parts:
    """Sums over links of what their motion is made of, about the origin.

    mass       (n, 1) [kg]
    first      (3, n, S) Σ m r;  momentum, force  its derivatives
    spin       (3, n, S) angular momentum;  moment  its derivative
    inertia    (3, 3, n, S);  inertia_d  its derivative
    pushed     (3, n, S) Σ f of the pushes;  lever  (3, 3, n, S) Σ p fᵀ
    """

    mass: Array
    first: Array
    momentum: Array
    force: Array
    spin: Array
    moment: Array
    inertia: Array
    inertia_d: Array
    pushed: Array
    lever: Array

    @classmethod
    def of_links(cls, wrench: RootWrench, velocity: Array, pushes: Pushes | None) -> _Parts:
        """Each link of the root's tree by itself; all zero for the others. velocity (3, S): of the whole's centre."""
        inverse, links, figure = wrench.inverse, wrench.samples.links, wrench.samples.figure
        tree = figure.tables.path[:, wrench.root, None]
        mass = (wrench.mass * wrench.share)[:, None]
        r = inverse.centre - wrench.centre[:, None]
        v = links.x_d + cross(links.omega, inverse.offset) - velocity[:, None]
        force = (inverse.net_force + figure.gravity[:, None, None] * mass) * tree
        spun = cross(links.omega[:, None], inverse.inertia)
        pushed, lever = np.zeros((3, *r.shape[1:])), np.zeros((3, 3, *r.shape[1:]))
        if pushes is not None:
            place = links.x[:, pushes.link, pushes.at] + pushes.offset - wrench.centre[:, pushes.at]
            pushed = pushes.by_link(pushes.force, r)
            lever = np.array([pushes.by_link(part * pushes.force, r) for part in place])
        return cls(
            mass=mass,
            first=mass * r,
            momentum=mass * v,
            force=force,
            spin=mass * cross(r, v) + tree * inverse.momenta[0],
            moment=cross(r, force) + tree * inverse.net_torque,
            inertia=tree * inverse.inertia + mass * _square(r, r),
            inertia_d=tree * (spun + spun.swapaxes(0, 1)) + mass * (_square(r, v) + _square(v, r)),
            pushed=pushed,
            lever=lever,
        )

    def of(self, weights: Array) -> _Parts:
        """Sums over links, weights (n, L)."""
        return _Parts(**{name: gathered(weights, part) for name, part in vars(self).items()})


def _square(a: Array, b: Array) -> Array:
    """a·b 1 − a bᵀ, (3, 3, n, S)."""
    return np.eye(3)[:, :, None, None] * dot(a, b) - a[:, None] * b[None]


def _changes(parts: _Parts, turn: Array | None, shift: Array, whole: _Parts) -> Array:
    """By φ, φ', φ'' (3,): force and moment (6,), of n twists, (3, 6, n, S)."""
    s, s_d, s_dd = shift
    mass, first, momentum = parts.mass, parts.first, parts.momentum
    moved = mass * s
    force = [mass * s_dd, 2 * mass * s_d, moved]
    moment = [cross(first, s_dd) + cross(s, parts.force), 2 * cross(first, s_d), cross(first, s)]
    if turn is not None:
        w, w_d, w_dd = turn
        moved = moved + cross(w, first)
        force[0] += cross(w_dd, first) + 2 * cross(w_d, momentum) + cross(w, parts.force)
        force[1] += 2 * (cross(w_d, first) + cross(w, momentum))
        force[2] = moved
        moment[0] += applied(parts.inertia, w_dd) + applied(parts.inertia_d, w_d)
        moment[0] += cross(w_d, parts.spin) + cross(w, parts.moment)
        moment[1] += 2 * applied(parts.inertia, w_d) + applied(parts.inertia_d, w) + cross(w, parts.spin)
        moment[2] += applied(parts.inertia, w)
        moment[0] += w * np.einsum("iins->ns", parts.lever) - applied(parts.lever, w)
    moment[0] += cross(moved / whole.mass, whole.pushed - whole.force) - cross(s, parts.pushed)
    return np.array([np.concatenate(pair) for pair in zip(force, moment, strict=True)])
