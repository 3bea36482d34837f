"""The wrench at a free root: what must push the figure from outside for it to move as it does.

Force F = Σ m (c'' − g) = M (a − g), a the acceleration of the centre of mass, and moment N = L', L the angular momentum
about it. The sums of eqs. 18 and 21 over a tree of links, N taken about the tree's centre of mass. Nothing pushes in
flight, where both are zero; in stance the ground supplies them.
"""

from __future__ import annotations

import mujoco
import numpy as np

from ..array import Array
from .adjoint import Cotangent
from .algebra import cross
from .dynamics import InverseDynamics
from .figure import Figure
from .kinematics import Samples

STANDARD_GRAVITY = 9.81  # [m/s²] where a model has none
MASSLESS = 1e-12  # [kg]


class RootWrench:
    """Force and moment on the tree of one free root, at every sample.

    root    index of the free link
    mass    [kg] of its tree
    share   (L,) each link's share of it
    centre  (3, S) [m] the tree's centre of mass
    force   (3, S) [N], world axes
    moment  (3, S) [N m] about the centre of mass, world axes
    """

    def __init__(self, samples: Samples, root: int) -> None:
        self.samples, self.root = samples, root
        self.inverse = samples.once(InverseDynamics)
        self.mass, self.share = tree_mass(samples.figure, root)
        self.centre = np.einsum("l,ils->is", self.share, self.inverse.centre)
        self.force = self.inverse.force[:, root]
        self._lever = self.centre - samples.links.anchor[:, root]
        self.moment = self.inverse.moment[:, root] - cross(self._lever, self.force)

    def pull_back(self, into: Cotangent, force_bar: Array, moment_bar: Array, centre_bar: Array | None = None) -> None:
        """Add the gradient of a scalar with given gradients with respect to force, moment and centre, (3, S)."""
        moments, forces = np.zeros_like(self.inverse.force), np.zeros_like(self.inverse.force)
        moments[:, self.root] = moment_bar
        forces[:, self.root] = force_bar + cross(self._lever, moment_bar)
        through_lever = cross(self.force, moment_bar)
        into.buffer("x")[:, self.root] += through_lever
        by_centre = -through_lever if centre_bar is None else centre_bar - through_lever
        self.inverse.pull_back(into, moments, forces, self.share[:, None] * by_centre[:, None])


def tree_mass(figure: Figure, root: int) -> tuple[float, Array]:
    """The mass [kg] of a free link with all beyond it, and each link's share of it (L,)."""
    masses = figure.tables.mass * figure.tables.path[:, root]
    total = float(masses.sum())
    return total, masses / max(total, MASSLESS)


def weight(figure: Figure, root: int) -> float:
    """[N] what a free link with all beyond it weighs; at 9.81 m/s² where the model has no gravity."""
    g = float(np.linalg.norm(figure.gravity))
    return tree_mass(figure, root)[0] * (g or STANDARD_GRAVITY)


def height(figure: Figure, root: int) -> float:
    """[m] how tall a slender rod would be that turns like a free link with all beyond it at rest: √12 times the radius
    of gyration. The length that makes moments forces."""
    rest = figure.to_state(np.array(mujoco.MjData(figure.model).qpos))[None]
    inverse = Samples.still(figure, rest).once(InverseDynamics)
    mass, share = tree_mass(figure, root)
    away = inverse.centre[:, :, 0] - (inverse.centre[:, :, 0] @ share)[:, None]
    inertia = np.einsum("iil,l->", inverse.inertia[..., 0], figure.tables.path[:, root]) / 2
    return float(np.sqrt(12 * (np.sum(share * np.sum(away**2, axis=0)) + inertia / max(mass, MASSLESS))))
