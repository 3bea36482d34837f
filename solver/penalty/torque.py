"""Joint torques by inverse dynamics (appendix A): without contact forces those of a stance leg are a regulariser."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..algebra import add_at, cross, dot
from ..dynamics import InverseDynamics
from ..kinematics import Cotangent, Samples
from ..quaternion import Array, Index
from .penalty import Scale


@dataclass(frozen=True)
class Torque:
    """Σ of squared torques of ball joints and hinges and forces of slides [N² m²]; not of the free roots' wrench."""

    name: str = "torque"

    @property
    def scale(self) -> Scale:
        return Scale(1.0)

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        tables, links = samples.figure.tables, samples.links
        inverse = InverseDynamics(samples)
        balls = tables.ball_links
        is_ball = np.zeros((len(samples.figure.links), 1))
        is_ball[balls] = 1
        moment = inverse.moment * is_ball
        motors = [(tables.hinge_links, tables.hinge_columns, inverse.moment)]
        motors += [(tables.slide_links, tables.slide_columns, inverse.force)]
        armature = tables.armature[balls][:, None]
        parents, spin = tables.parents[balls], None
        if armature.any():
            spin = links.omega[:, balls] - links.omega[:, parents]
            reflected = links.alpha[:, balls] - links.alpha[:, parents] - cross(links.omega[:, balls], spin)
            moment[:, balls] += armature * reflected
        values = np.einsum("ils,ils->s", moment, moment)
        moment_bar = np.multiply(moment, 2 * scale, out=moment)
        force_bar = np.zeros_like(inverse.force) if tables.slide_links.size else None
        for (indices, columns, source), target in zip(motors, (moment_bar, force_bar), strict=True):
            if not indices.size or target is None:
                continue
            axis = (links.rotation[:, :, indices] * tables.axis[None, :, indices, None]).sum(axis=1)
            own = tables.armature[indices]
            effort = dot(axis, source[:, indices]) + own[:, None] * samples.columns(columns, 2)
            values = values + np.sum(effort**2, axis=0)
            target[:, indices] = 2 * scale * effort * axis
            if into is not None:
                into.room("y_dd")[:, columns] += (2 * scale * effort * own[:, None]).T
                into.room("turn")[:, indices] += cross(axis, 2 * scale * effort * source[:, indices])
        if into is not None:
            inverse.pull_back(into, moment_bar, force_bar)
            if spin is not None:
                _reflected_pulled_back(into, balls, parents, armature * moment_bar[:, balls], spin)
        return values


def _reflected_pulled_back(into: Cotangent, own: Index, parents: Index, gradient: Array, spin: Array) -> None:
    """Gradient of α_c − α_p − ω_c × (ω_c − ω_p)."""
    omega = into.samples.links.omega[:, own]
    by_spin = cross(omega, gradient)
    into.room("alpha")[:, own] += gradient
    into.room("omega")[:, own] += by_spin - cross(spin, gradient)
    add_at(into.room("alpha"), parents, -gradient)
    add_at(into.room("omega"), parents, -by_spin)
