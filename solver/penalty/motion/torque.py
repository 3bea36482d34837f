"""Joint torques by inverse dynamics (appendix A). They omit contact forces, so in stance legs they are only a
regulariser.

Included are inertia, Coriolis and centrifugal forces, gravity and armature. Not included are the model's passive forces
(stiffness, damping, friction loss, gravity compensation, fluid drag, tendons), constraint forces and contact forces.
`inverse_dynamics` includes all but contact forces.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at, cross, dot
from ...figure.dynamics import InverseDynamics
from ...figure.effort_rows import joint_rows
from ...figure.kinematics import Samples
from ..block import Dense
from ..curvature import Curvature
from ..penalty import Normalization, Penalty


@dataclass(frozen=True)
class Torque(Penalty):
    """Σ of squared torques of ball joints and hinges and forces of slides [N² m²], without the wrench of free roots."""

    name = "torque"
    normalization = Normalization(1.0)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        tables, links = samples.figure.tables, samples.links
        inverse, balls = samples.cache(InverseDynamics), tables.ball_links
        moment, spin = inverse.moment[:, balls], None
        armature, parents = tables.armature[balls][:, None], tables.parents[balls]
        if armature.any():
            spin = links.omega[:, balls] - links.omega[:, parents]
            reflected = links.alpha[:, balls] - links.alpha[:, parents] - cross(links.omega[:, balls], spin)
            moment = moment + armature * reflected
        motors = [
            _Motors.of(samples, tables.hinge_links, tables.hinge_columns, inverse.moment),
            _Motors.of(samples, tables.slide_links, tables.slide_columns, inverse.force),
        ]
        efforts = [moment.reshape(-1, samples.count), *(motor.effort for motor in motors)]

        def pulled_back(into: Cotangent, bar: Array) -> None:
            edges = np.cumsum([len(part) for part in efforts])
            of_balls, of_hinges, of_slides = np.split(bar, edges[:2])
            moment_bar, force_bar = np.zeros_like(inverse.moment), np.zeros_like(inverse.force)
            moment_bar[:, balls] = of_balls.reshape(3, -1, samples.count)
            for motor, part, target in zip(motors, (of_hinges, of_slides), (moment_bar, force_bar), strict=True):
                motor.pull_back(into, part, target)
            inverse.pull_back(into, moment_bar, force_bar if tables.slide_links.size else None)
            if spin is not None:
                _reflected_pulled_back(into, balls, parents, armature * moment_bar[:, balls], spin)

        def curved(into: Curvature, scale: Array) -> None:
            rows = joint_rows(samples)
            at = np.repeat(np.arange(samples.count), rows.shape[1])
            into.add_rows(at, scale[at], rows.reshape(at.size, 3, -1))

        yield Dense(np.concatenate(efforts), pulled_back, curved)


@dataclass(frozen=True, eq=False)
class _Motors:
    """Efforts of hinges or slides.

    Attributes:
        links: The links, (h,).
        columns: The state's columns, (h,).
        armature: The armatures, (h, 1).
        axis: The axes, (3, h, S).
        source: The moments or forces, (3, h, S).
        effort: Their components along the axes, plus the effect of armature, (h, S).
    """

    links: Index
    columns: Index
    armature: Array
    axis: Array
    source: Array
    effort: Array

    @classmethod
    def of(cls, samples: Samples, links: Index, columns: Index, source: Array) -> _Motors:
        tables = samples.figure.tables
        axis = (samples.links.rotation[:, :, links] * tables.axis[None, :, links, None]).sum(axis=1)
        armature = tables.armature[links][:, None]
        effort = dot(axis, source[:, links]) + armature * samples.columns(columns, 2)
        return cls(links, columns, armature, axis, source[:, links], effort)

    def pull_back(self, into: Cotangent, bar: Array, target: Array) -> None:
        """Add the gradient of Σ bar · effort, bar (h, S), to `target`, the gradient by moments or forces, and to
        `into`."""
        target[:, self.links] = bar * self.axis
        into.buffer("y_dd")[:, self.columns] += (bar * self.armature).T
        into.buffer("turn")[:, self.links] += cross(self.axis, bar * self.source)


def _reflected_pulled_back(into: Cotangent, links: Index, parents: Index, gradient: Array, spin: Array) -> None:
    """Pull back the gradient of α_c − α_p − ω_c × (ω_c − ω_p)."""
    omega = into.samples.links.omega[:, links]
    by_spin = cross(omega, gradient)
    into.buffer("alpha")[:, links] += gradient
    into.buffer("omega")[:, links] += by_spin - cross(spin, gradient)
    add_at(into.buffer("alpha"), parents, -gradient)
    add_at(into.buffer("omega"), parents, -by_spin)
