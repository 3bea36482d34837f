"""Joint torques by inverse dynamics (appendix A): without contact forces those of a stance leg are a regulariser.

Included are inertia, Coriolis and centrifugal forces, gravity and armature. Not included are the model's passive forces
(stiffness, damping, friction loss, gravity compensation, fluid drag, tendons), constraint forces and contact forces;
`inverse_dynamics` has the first two.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at, cross, dot
from ...figure.dynamics import InverseDynamics
from ...figure.jacobian_rows import has_moment_rows, moment_rows
from ...figure.kinematics import Samples
from ..curvature import Curvature, jacobian
from ..penalty import Penalty, Scale


@dataclass(frozen=True)
class Torque(Penalty):
    """Σ of squared torques of ball joints and hinges and forces of slides [N² m²]; not of the free roots' wrench."""

    @property
    def name(self) -> str:
        return "torque"

    @property
    def scale(self) -> Scale:
        return Scale(1.0)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        tables, links = samples.figure.tables, samples.links
        inverse = samples.once(InverseDynamics)
        balls = tables.ball_links
        is_ball = np.zeros((len(samples.figure.links), 1))
        is_ball[balls] = 1
        moment = inverse.moment * is_ball
        armature = tables.armature[balls][:, None]
        parents, spin = tables.parents[balls], None
        if armature.any():
            spin = links.omega[:, balls] - links.omega[:, parents]
            reflected = links.alpha[:, balls] - links.alpha[:, parents] - cross(links.omega[:, balls], spin)
            moment[:, balls] += armature * reflected
        values = np.einsum("ils,ils->s", moment, moment)
        moment_bar = np.multiply(moment, 2 * scale, out=moment)
        force_bar = np.zeros_like(inverse.force) if tables.slide_links.size else None
        motors = [(tables.hinge_links, tables.hinge_columns, inverse.moment, moment_bar)]
        if force_bar is not None:
            motors.append((tables.slide_links, tables.slide_columns, inverse.force, force_bar))
        for indices, columns, source, target in motors:
            axis = (links.rotation[:, :, indices] * tables.axis[None, :, indices, None]).sum(axis=1)
            own = tables.armature[indices]
            effort = dot(axis, source[:, indices]) + own[:, None] * samples.columns(columns, 2)
            values = values + np.sum(effort**2, axis=0)
            target[:, indices] = 2 * scale * effort * axis
            if into is not None:
                into.buffer("y_dd")[:, columns] += (2 * scale * effort * own[:, None]).T
                into.buffer("turn")[:, indices] += cross(axis, 2 * scale * effort * source[:, indices])
        if into is not None:
            inverse.pull_back(into, moment_bar, force_bar)
            if spin is not None:
                _reflected_pulled_back(into, balls, parents, armature * moment_bar[:, balls], spin)
        return values

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        figure, tables = samples.figure, samples.figure.tables
        motors = np.concatenate([tables.hinge_links, tables.slide_links])
        if has_moment_rows(figure) and not motors.size:
            rows = moment_rows(samples)
            at = np.repeat(np.arange(samples.count), rows.shape[1])
            into.add_rows(at, scale[at], rows.reshape(at.size, 3, -1))
            return
        link = np.concatenate([np.repeat(tables.ball_links, 3), motors])
        axis = np.concatenate([np.tile(np.arange(3), tables.ball_links.size), np.full(motors.size, -1)])
        at = np.repeat(np.arange(samples.count), link.size)

        def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
            _one_effort(copies, cotangent, link[rows % link.size], axis[rows % link.size])

        into.add_rows(at, scale[at], jacobian(samples, at, seeded))


def _one_effort(samples: Samples, into: Cotangent, link: Index, axis: Index) -> None:
    """The gradient of one effort a sample, at the joint of link (S,); of a ball joint component `axis` (S,)."""
    tables, links = samples.figure.tables, samples.links
    inverse = samples.once(InverseDynamics)
    moment_bar, force_bar = np.zeros_like(inverse.moment), np.zeros_like(inverse.force)
    ball = np.flatnonzero(np.isin(link, tables.ball_links))
    moment_bar[axis[ball], link[ball], ball] = 1.0
    every = tables.ball_links
    if np.any(tables.armature[every]):
        spin = links.omega[:, every] - links.omega[:, tables.parents[every]]
        reflected = tables.armature[every][:, None] * moment_bar[:, every]
        _reflected_pulled_back(into, every, tables.parents[every], reflected, spin)
    motors = ((tables.hinge_links, inverse.moment, moment_bar), (tables.slide_links, inverse.force, force_bar))
    for chosen, source, target in motors:
        at = np.flatnonzero(np.isin(link, chosen))
        if not at.size:
            continue
        own = link[at]
        direction = (links.rotation[:, :, own, at] * tables.axis[None, :, own]).sum(axis=1)
        target[:, own, at] = direction
        into.buffer("y_dd")[at, [samples.figure.links[i].qpos for i in own]] += tables.armature[own]
        into.buffer("turn")[:, own, at] += cross(direction, source[:, own, at])
    inverse.pull_back(into, moment_bar, force_bar if tables.slide_links.size else None)


def _reflected_pulled_back(into: Cotangent, own: Index, parents: Index, gradient: Array, spin: Array) -> None:
    """Gradient of α_c − α_p − ω_c × (ω_c − ω_p)."""
    omega = into.samples.links.omega[:, own]
    by_spin = cross(omega, gradient)
    into.buffer("alpha")[:, own] += gradient
    into.buffer("omega")[:, own] += by_spin - cross(spin, gradient)
    add_at(into.buffer("alpha"), parents, -gradient)
    add_at(into.buffer("omega"), parents, -by_spin)
