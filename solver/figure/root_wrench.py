"""The wrench at a free root: the external force and moment that the figure's motion requires.

The force is F = Σ m (c'' − g) = M (a − g), with the acceleration a of the centre of mass. The moment is N = L', with
the angular momentum L about the centre of mass. They are the sums of eqs. 18 and 21 over a tree of links. In flight
both are zero; in stance the ground supplies them.
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

STANDARD_GRAVITY = 9.81  # [m/s²] used for weights if a model has no gravity
MASSLESS = 1e-12  # [kg] smallest divisor, against division by zero


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
        self.inverse = samples.cached(InverseDynamics)
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
    return total, masses / max(total, MASSLESS)


def weight(figure: Figure, root: int) -> float:
    """Return the weight [N] of a free link with all links beyond it, at 9.81 m/s² if the model has no gravity."""
    g = float(np.linalg.norm(figure.gravity))
    return tree_mass(figure, root)[0] * (g or STANDARD_GRAVITY)


def height(figure: Figure, root: int) -> float:
    """Return the length [m] of a slender rod with the same radius of gyration as a free link with all links beyond it
    at rest.

    This length is √12 times the radius. It converts moments to forces.
    """
    rest = figure.to_state(np.array(mujoco.MjData(figure.model).qpos))[None]
    inverse = Samples.still(figure, rest).cached(InverseDynamics)
    mass, share = tree_mass(figure, root)
    away = inverse.centre[:, :, 0] - (inverse.centre[:, :, 0] @ share)[:, None]
    inertia = np.einsum("iil,l->", inverse.inertia[..., 0], figure.tables.path[:, root]) / 2
    return float(np.sqrt(12 * (np.sum(share * np.sum(away**2, axis=0)) + inertia / max(mass, MASSLESS))))
