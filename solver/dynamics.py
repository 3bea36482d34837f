"""Inverse dynamics of all samples at once, and its adjoint; eqs. 18-21 and appendix A of the paper.

Per link: force f = m (a − g) at the centre of mass, moment n = ω × Iω + I ω' about it (eq. 21). Summed over the links
beyond a joint they are what the joint must supply. Equals MuJoCo's `mj_inverse` with contacts, limits and passive
forces off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .kinematics import (
    Cotangent,
    Samples,
    applied,
    attached_acceleration,
    attached_pulled_back,
    cross,
    dot,
    gathered,
    turned,
    turned_back,
)
from .quaternion import Array


@dataclass(frozen=True)
class BodyForces:
    """What keeps each link moving as it does: force [N] and torque [N m] about its centre of mass (appendix A).

    force   (3, L, S) m (a − g), all that acts on the link but its weight; world axes
    torque  (3, L, S) L' = ω × Iω + I ω'; world axes
    centre  (3, L, S) [m] centre of mass, where both apply
    """

    force: Array
    torque: Array
    centre: Array


class InverseDynamics:
    """Joint forces and moments at every sample.

    moment  (3, L, S) [N m] about the joint's anchor, world axes, of everything beyond the joint
    force   (3, L, S) [N]
    """

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        tables, links = samples.figure.tables, samples.links
        self.arm = turned(links.rotation, tables.centre)
        self.centre = links.x + self.arm
        acceleration = links.x_dd + attached_acceleration(links.omega, links.alpha, self.arm)
        gravity = samples.figure.gravity[:, None, None]
        self.net_force = tables.mass[:, None] * (acceleration - gravity)
        self.spin = self.inertia_times(links.omega)
        self.spin_rate = self.inertia_times(links.alpha)
        self.net_torque = self.spin_rate + cross(links.omega, self.spin)
        beyond = np.ascontiguousarray(tables.path.T)
        self.force = gathered(beyond, self.net_force)
        self.moment = gathered(beyond, self.net_torque + cross(self.centre, self.net_force))
        self.moment -= cross(links.anchor, self.force)

    def inertia_times(self, vectors: Array) -> Array:
        """I v with I = R I_body Rᵀ (eq. 18), (3, L, S)."""
        rotation, inertia = self.samples.links.rotation, self.samples.figure.tables.inertia
        local = turned_back(rotation, vectors)
        return applied(rotation, np.einsum("ijl,jls->ils", inertia, local))

    def pull_back(self, into: Cotangent, moment_bar: Array, force_bar: Array | None = None) -> None:
        """Adds the gradient of a scalar whose gradients with respect to `moment` and `force` are given, (3, L, S)."""
        tables, links = self.samples.figure.tables, self.samples.links
        omega, alpha = links.omega, links.alpha
        anchor_bar = cross(moment_bar, self.force)
        force_total = cross(links.anchor, moment_bar)
        if force_bar is not None:
            force_total = force_total + force_bar
        m = gathered(tables.path, moment_bar)
        f_bar = gathered(tables.path, force_total) + cross(m, self.centre)
        centre_bar = cross(self.net_force, m)
        inertia_m = self.inertia_times(m)
        tilt = cross(m, omega)
        inertia_tilt = self.inertia_times(tilt)
        into.add("alpha", inertia_m)
        into.add("omega", cross(self.spin, m) + inertia_tilt)
        turn = cross(self.spin_rate, m) + cross(inertia_m, alpha) + cross(self.spin, tilt) + cross(inertia_tilt, omega)
        acceleration_bar = tables.mass[:, None] * f_bar
        arm = attached_pulled_back((omega, alpha), self.arm, (centre_bar, None, acceleration_bar))
        for name, part in zip(("turn", "omega", "alpha"), arm, strict=True):
            assert part is not None
            into.add(name, part)
        into.add("turn", turn)
        into.add("x", centre_bar + anchor_bar)
        into.add("x_dd", acceleration_bar)
        if links.hang is not None:
            into.add("turn", cross(links.hang, anchor_bar))


def body_forces(samples: Samples) -> BodyForces:
    """Force and torque on each link; summed, with the arms of the forces, they are the wrench at the root."""
    inverse = InverseDynamics(samples)
    return BodyForces(inverse.net_force, inverse.net_torque, inverse.centre)


def generalised_forces(samples: Samples) -> Array:
    """(S, nv): MuJoCo's qfrc_inverse without contacts, limits and passive forces.

    Free joints: force in the world, moment in the body's axes; ball joints: body axes; hinges and slides: along the
    axis.
    """
    figure, links = samples.figure, samples.links
    inverse = InverseDynamics(samples)
    local = turned_back(links.rotation, inverse.moment)
    qacc = None
    if np.any(figure.tables.armature):
        qacc = velocities(samples)[1]
    out = np.zeros((samples.count, figure.model.nv))
    for i, link in enumerate(figure.links[1:], start=1):
        axis = link.axis[:, None]
        if link.kind == link.kind.FREE:
            out[:, link.dof : link.dof + 3] = inverse.force[:, i].T
            out[:, link.dof + 3 : link.dof + 6] = local[:, i].T
        elif link.kind == link.kind.BALL:
            out[:, link.dof : link.dof + 3] = local[:, i].T
        elif link.kind == link.kind.HINGE:
            out[:, link.dof] = dot(axis, local[:, i])
        else:
            out[:, link.dof] = dot(axis, turned_back(links.rotation, inverse.force)[:, i])
    if qacc is not None:
        out += figure.model.dof_armature * qacc
    return out


def velocities(samples: Samples) -> tuple[Array, Array]:
    """MuJoCo's (qvel, qacc), each (S, nv), of samples in any coordinates (method of §6)."""
    figure, links = samples.figure, samples.links
    parents = figure.tables.parents
    omega_p = links.omega[:, parents]
    spin = links.omega - omega_p
    local = turned_back(links.rotation, spin)
    local_d = turned_back(links.rotation, links.alpha - links.alpha[:, parents] - cross(links.omega, spin))
    root, root_d = turned_back(links.rotation, links.omega), turned_back(links.rotation, links.alpha)
    qvel, qacc = np.zeros((2, samples.count, figure.model.nv))
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind == link.kind.FREE:
            columns = slice(link.qpos, link.qpos + 3)
            qvel[:, link.dof : link.dof + 3] = samples.y_d[:, columns]
            qacc[:, link.dof : link.dof + 3] = samples.y_dd[:, columns]
            qvel[:, link.dof + 3 : link.dof + 6] = root[:, i].T
            qacc[:, link.dof + 3 : link.dof + 6] = root_d[:, i].T
        elif link.kind == link.kind.BALL:
            qvel[:, link.dof : link.dof + 3] = local[:, i].T
            qacc[:, link.dof : link.dof + 3] = local_d[:, i].T
        else:
            qvel[:, link.dof] = samples.y_d[:, link.qpos]
            qacc[:, link.dof] = samples.y_dd[:, link.qpos]
    return qvel, qacc
