"""Inverse dynamics of all samples at once, and its adjoint (eqs. 18-21 and appendix A of the paper).

Each link needs a force f = m (a − g) at its centre of mass and a moment n = ω × Iω + I ω' about it (eq. 21). Summed
over the links beyond a joint, these are the force and moment of the joint. The result equals MuJoCo's `mj_inverse`
without contacts, limits and passive forces. `inverse_dynamics` calls `mj_inverse` itself, without contacts only.

The wrench at a free root is the external force and moment that the figure's motion requires. The force is F = Σ m (c''
− g) = M (a − g), with the acceleration a of the centre of mass. The moment is N = L', with the angular momentum L about
the centre of mass. They are the sums of eqs. 18 and 21 over a tree of links. In flight both are zero; in stance the
ground supplies them.

Bodies of one shape that move under gravity are dynamically similar if lengths grow by λ and times by √(λ/g)
(R. McN. Alexander 1976). A threshold that holds for an adult then holds for a doll, a robot or a giant, see `Size`.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from functools import lru_cache

import mujoco
import numpy as np

from ..array import Array
from ..tolerances import TINY
from .adjoint import Cotangent, attached_pulled_back
from .algebra import combine, cross, cross_sum, rotate, rotate_back
from .figure import Figure
from .kinematics import LinkMotion, Samples

STANDARD_GRAVITY = 9.81  # [m/s²] used for weights if a model has no gravity
ADULT = 1.41223671  # [m] `height` of the shipped human, 1.7 m tall
DIGITS = 6  # of the ratio of lengths: the shipped human has the size of an adult exactly


class InverseDynamics:
    """Joint forces and moments at every sample, in world axes.

    Attributes:
        moment: The moment of everything beyond the joint, about the joint's anchor, (3, L, S) [N m].
        force: The force of everything beyond the joint, (3, L, S) [N].
    """

    def __init__(self, links: LinkMotion) -> None:
        self.links = links
        tables = links.figure.tables
        self.offset = links.sum_fixed(tables.centre_offsets)
        self.centre = links.x + self.offset
        self.net_force = rotate(links.swing, self.offset)
        self.net_force += links.x_dd
        self.net_force -= links.figure.gravity[:, None, None]
        self.net_force *= tables.mass[:, None]
        self.inertia = self._world_inertia()
        # I ω and I ω', (2, 3, L, S)
        self.momenta = np.einsum("ijls,kjls->kils", self.inertia, links.spins)
        self.net_torque = cross(links.omega, self.momenta[0])
        self.net_torque += self.momenta[1]
        self.force = combine(tables.beyond, self.net_force)
        about_origin = cross(self.centre, self.net_force)
        about_origin += self.net_torque
        self.moment = combine(tables.beyond, about_origin)
        self.moment -= cross(links.anchor, self.force)

    def _world_inertia(self) -> Array:
        """Return I = R I_body Rᵀ (eq. 18), (3, 3, L, S)."""
        rotation, inertia = self.links.rotation, self.links.figure.tables.inertia
        # one small product per link and axis: (3, L, 3, S)
        half = np.matmul(inertia.transpose(2, 1, 0), rotation.transpose(0, 2, 1, 3))
        return np.einsum("ilks,jkls->ijls", half, rotation)

    def pull_back(
        self, into: Cotangent, moment_bar: Array, force_bar: Array | None = None, centre_bar: Array | None = None
    ) -> None:
        """Add the gradient of a scalar with gradients (3, L, S) with respect to `moment`, `force` and `centre`.

        The backward sweep runs once for all contributions, when the cotangent's gradients are requested.
        """
        buffer = into.defer(self.flush, 3)
        buffer[0] += moment_bar
        for target, part in zip(buffer[1:], (force_bar, centre_bar), strict=True):
            if part is not None:
                target += part

    def flush(self, into: Cotangent, buffer: Array) -> None:
        """Run the backward sweep of all deferred contributions, (3, 3, L, S), and add the gradients to `into`.
        The contents of `buffer` become undefined."""
        tables, links = self.links.figure.tables, self.links
        moment_bar, force_bar, centre_bar = buffer
        anchor_bar = cross(moment_bar, self.force)
        force_bar += cross(links.anchor, moment_bar)
        m, f_bar = np.matmul(tables.path, buffer[:2])
        f_bar += cross(m, self.centre)
        centre_bar += cross(self.net_force, m)
        pair = np.array([cross(m, links.omega), m])  # the factors of ω and ω'
        inertia_pair = np.einsum("ijls,kjls->kils", self.inertia, pair)
        into.accumulate("omega", cross(self.momenta[0], m), donate=True)
        into.accumulate("omega", inertia_pair[0], donate=True)
        into.accumulate("alpha", inertia_pair[1], donate=True)
        into.accumulate("turn", cross_sum(self.momenta, pair), donate=True)
        into.accumulate("turn", cross_sum(inertia_pair, links.spins), donate=True)
        f_bar *= tables.mass[:, None]
        attached_pulled_back(into, self.offset, (centre_bar, None, f_bar))
        if links.hang is not None:
            into.accumulate("turn", cross(links.hang, anchor_bar), donate=True)
        anchor_bar += centre_bar
        into.accumulate("x", anchor_bar, donate=True)
        into.accumulate("x_dd", f_bar, donate=True)


def inverse_dynamics(model: mujoco.MjModel, qpos: Array, qvel: Array, qacc: Array, *, disabled: int = 0) -> Array:
    """Return MuJoCo's qfrc_inverse without contact forces.

    Joint forces = M(q) q'' + bias − passive − constraint forces, by `mj_inverse`. The passive forces are springs,
    dampers, gravity compensation and fluid drag. The constraint forces are friction loss, joint and tendon limits and
    equality constraints. Options and flags of the model apply, except `contact` and `invdiscrete`: accelerations are
    those of continuous time.

    Args:
        qpos: Configurations (T, nq), [m] and [rad], unit quaternions wxyz.
        qvel: Velocities (T, nv), [m/s] and [rad/s].
        qacc: Accelerations (T, nv), [m/s²] and [rad/s²].
        disabled: Further forces to omit, bits of mjtDisableBit.

    Returns:
        Forces [N] and torques [N m] (T, nv), in the axes of qvel.
    """
    free = copy.copy(model)
    free.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | disabled
    free.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_INVDISCRETE)
    data = mujoco.MjData(free)
    out = np.zeros((len(qpos), model.nv))
    for row, *state in zip(out, qpos, qvel, qacc, strict=True):
        data.qpos, data.qvel, data.qacc = state
        mujoco.mj_inverse(free, data)
        row[:] = data.qfrc_inverse
    return out


def velocities(samples: Samples) -> tuple[Array, Array]:
    """Return MuJoCo's (qvel, qacc), each (S, nv), of samples in any coordinates (method of §6)."""
    figure, links = samples.figure, samples.links
    parents = figure.tables.parents
    omega_p = links.omega[:, parents]
    spin = links.omega - omega_p
    local = rotate_back(links.rotation, spin)
    local_d = rotate_back(links.rotation, links.alpha - links.alpha[:, parents] - cross(links.omega, spin))
    root, root_d = rotate_back(links.rotation, links.omega), rotate_back(links.rotation, links.alpha)
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


class RootWrench:
    """Force and moment on the tree of one free root at every sample, in world axes.

    Attributes:
        root: The index of the free link.
        mass: The mass of its tree [kg].
        share: Each link's share of this mass, (L,) [1].
        centre: The tree's centre of mass, (3, S) [m].
        force: The force, (3, S) [N].
        moment: The moment about the centre of mass, (3, S) [N m].
    """

    def __init__(self, samples: Samples, root: int) -> None:
        self.samples, self.root = samples, root
        self.inverse = samples.cache(InverseDynamics)
        self.mass, self.share = tree_mass(samples.figure, root)
        self.centre = np.einsum("l,ils->is", self.share, self.inverse.centre)
        self.force = self.inverse.force[:, root]
        self._lever = self.centre - samples.links.anchor[:, root]
        self.moment = self.inverse.moment[:, root] - cross(self._lever, self.force)

    def pull_back(self, into: Cotangent, force_bar: Array, moment_bar: Array, centre_bar: Array | None = None) -> None:
        """Add the gradient of a scalar with gradients (3, S) with respect to force, moment and centre."""
        moments, forces = np.zeros_like(self.inverse.force), np.zeros_like(self.inverse.force)
        moments[:, self.root] = moment_bar
        forces[:, self.root] = force_bar + cross(self._lever, moment_bar)
        through_lever = cross(self.force, moment_bar)
        into.buffer("x")[:, self.root] += through_lever
        by_centre = -through_lever if centre_bar is None else centre_bar - through_lever
        self.inverse.pull_back(into, moments, forces, self.share[:, None] * by_centre[:, None])


def tree_mass(figure: Figure, root: int) -> tuple[float, Array]:
    """Return the mass [kg] of a free link with all links beyond it, and each link's share of it (L,)."""
    masses = figure.tables.mass * figure.tables.path[:, root]
    total = float(masses.sum())
    return total, masses / max(total, TINY)


def weight(figure: Figure, root: int) -> float:
    """Return the weight [N] of a free link with all links beyond it, at 9.81 m/s² if the model has no gravity."""
    g = float(np.linalg.norm(figure.gravity))
    return tree_mass(figure, root)[0] * (g or STANDARD_GRAVITY)


@lru_cache(16)  # thresholds need it at every load
def height(figure: Figure, root: int) -> float:
    """Return the length [m] of a slender rod with the same radius of gyration as a free link with all links beyond it
    at rest.

    This length is √12 times the radius. It converts moments to forces.
    """
    rest = figure.to_state(np.array(figure.model.qpos0))[None]
    inverse = Samples.still(figure, rest).cache(InverseDynamics)
    mass, share = tree_mass(figure, root)
    away = inverse.centre[:, :, 0] - (inverse.centre[:, :, 0] @ share)[:, None]
    inertia = np.einsum("iil,l->", inverse.inertia[..., 0], figure.tables.path[:, root]) / 2
    return float(np.sqrt(12 * (np.sum(share * np.sum(away**2, axis=0)) + inertia / max(mass, TINY))))


@dataclass(frozen=True)
class Size:
    """The ratios of a figure's lengths and times to those of an adult on earth."""

    length: float = 1.0
    time: float = 1.0

    @property
    def enlargement(self) -> float:
        """How many times the figure is larger than an adult; 1 for smaller ones."""
        return max(1.0, self.length)

    @classmethod
    def of(cls, figure: Figure) -> Size:
        """Return the size of a figure's tree.

        Rigid objects, machines with a fixed base and trees without mass have the size of an adult, because they have no
        legs whose length could be measured.
        """
        root, gravity = figure.root, float(np.linalg.norm(figure.gravity)) or STANDARD_GRAVITY
        tall = height(figure, root.link) if root is not None and root.limbs else 0.0
        length = round(tall / ADULT, DIGITS) or 1.0
        return cls(length, float(np.sqrt(length * STANDARD_GRAVITY / gravity)))
