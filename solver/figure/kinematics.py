"""Motion of the figure's links at all samples of a path; `adjoint` is the reverse sweep.

The forward sweep computes Q, Q', Q'' of every link in the world from the state, then rotation, ω, ω', and the origin
with its derivatives. Arrays are component first and sample last, (3, L, S) for L links (the world is link 0) and S
samples, so that every formula is one pass over contiguous memory.

Positions follow eq. 13 with MuJoCo's body origins. ω and ω' are eqs. 19 and 20, exact for quaternions of any length. A
rotation of the link by a small world vector δφ changes δω = δφ' + δφ × ω and δω' = δφ'' + δφ' × ω + δφ × ω'. With
δφ = 2 vec(δQ Q⁻¹), these define the quaternion gradients. A vector s that turns with its link has s'' = A s with the
link's swing A = [ω']× + [ω]×[ω]×.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from ..array import Array, Index
from .algebra import (
    combine,
    cross,
    hamilton,
    rotate,
    rotate_fixed,
    rotation_matrix,
    swing_matrix,
    vector_product,
)
from .figure import Figure, on_links

Derived = TypeVar("Derived")


class States:
    """y, y', y'' of a figure at S times, by columns."""

    def __init__(self, figure: Figure, y: Array, y_d: Array, y_dd: Array) -> None:
        self.figure = figure
        self.y, self.y_d, self.y_dd = y, y_d, y_dd

    @property
    def count(self) -> int:
        return self.y.shape[0]

    def columns(self, indices: Index, order: int = 0) -> Array:
        """Return columns of y, y' or y'', component first: indices (...) -> (..., S)."""
        return self._component_first[order][indices]

    @cached_property
    def _component_first(self) -> tuple[Array, Array, Array]:
        y, y_d, y_dd = (np.ascontiguousarray(part.T) for part in (self.y, self.y_d, self.y_dd))
        return y, y_d, y_dd

    @cached_property
    def quaternions(self) -> Array:
        columns, block = self.figure.tables.quaternion_columns, self.figure.tables.quaternion_slice
        n = columns.shape[1]
        out = np.empty((3, 4, 1 + n, self.count))
        out[:, :, 0] = 0
        out[0, 0, 0] = 1
        for order, part in enumerate((self.y, self.y_d, self.y_dd)):
            if block is None:
                out[order, :, 1:] = self.columns(columns, order)
            else:
                out[order, :, 1:] = part[:, block].reshape(self.count, n, 4).T
        return out

    @cached_property
    def dots(self) -> Array:
        """q·q, q·q', q·q'' of `quaternions`, (3, 1 + n, S)."""
        return np.einsum("cns,kcns->kns", self.quaternions[0], self.quaternions)


class Samples:
    """y, y', y'' of a figure at S times, and derived quantities for penalties, each computed on first use.

    Attributes:
        y: The states, (S, N); y_d and y_dd are their derivatives [1/s, 1/s²].
        t: Times for penalties of a part of the clip, (S,) [s]; zeros by default.
        q: The states' quaternion blocks, (4, n, S); q_d and q_dd are their derivatives.
    """

    def __init__(
        self, figure: Figure, y: ArrayLike, y_d: ArrayLike, y_dd: ArrayLike, t: ArrayLike | None = None
    ) -> None:
        self.figure = figure
        self.y, self.y_d, self.y_dd = np.asarray(y, float), np.asarray(y_d, float), np.asarray(y_dd, float)
        self.t = np.zeros(len(self.y)) if t is None else np.asarray(t, float)
        # `links` refers to the states, not to the samples: a reference cycle would delay the release of their arrays
        self._states = States(figure, self.y, self.y_d, self.y_dd)
        self._cache: dict[Callable[[LinkMotion], Any], Any] = {}

    @classmethod
    def still(cls, figure: Figure, y: ArrayLike, t: ArrayLike | None = None) -> Samples:
        """Return samples of poses: states y (S, N) that do not move."""
        at_rest = np.zeros(np.shape(y))
        return cls(figure, y, at_rest, at_rest, t)

    @classmethod
    def of_qpos(cls, figure: Figure, qpos: ArrayLike | None = None) -> Samples:
        """Return samples of configurations qpos (S, nq), or of one (nq,), by default the rest pose."""
        qpos = figure.model.qpos0 if qpos is None else qpos
        return cls.still(figure, figure.to_state(np.atleast_2d(qpos)))

    @property
    def count(self) -> int:
        """S, the number of samples."""
        return self.y.shape[0]

    def select(self, at: Index) -> Samples:
        """Return the samples of indices (R,), with possible repetitions; the same object if these are all, in order."""
        if at.size == self.count and np.array_equal(at, np.arange(self.count)):
            return self
        return Samples(self.figure, self.y[at], self.y_d[at], self.y_dd[at], t=self.t[at])

    def parts(self, longest: int) -> list[Samples]:
        """Return the samples in runs of at most `longest`, small enough that derived quantities stay in cache."""
        if self.count <= longest:
            return [self]
        edges = np.linspace(0, self.count, -(-self.count // longest) + 1).astype(int)
        runs = [slice(a, b) for a, b in pairwise(edges)]
        return [Samples(self.figure, self.y[r], self.y_d[r], self.y_dd[r], self.t[r]) for r in runs]

    def columns(self, indices: Index, order: int = 0) -> Array:
        """Return columns of y, y' or y'', component first: indices (...) -> (..., S)."""
        return self._states.columns(indices, order)

    @property
    def q(self) -> Array:
        return self._states.quaternions[0, :, 1:]

    @property
    def q_d(self) -> Array:
        return self._states.quaternions[1, :, 1:]

    @property
    def q_dd(self) -> Array:
        return self._states.quaternions[2, :, 1:]

    @property
    def q_dots(self) -> Array:
        """q·q, q·q', q·q'' of the blocks, (3, n, S)."""
        return self._states.dots[:, 1:]

    @cached_property
    def links(self) -> LinkMotion:
        return LinkMotion(self._states)

    def cache(self, make: Callable[[LinkMotion], Derived]) -> Derived:
        """Return a quantity derived from the links' motion, computed once; it must not refer to the samples."""
        if make not in self._cache:
            self._cache[make] = make(self.links)
        return self._cache[make]


class LinkMotion:
    """The links' motion in the world.

    Attributes:
        Q: Orientations as quaternions of any length, (4, L, S); Q_d and Q_dd are their derivatives.
        rotation: Rotation matrices, (3, 3, L, S).
        omega: Angular velocities in world axes, (3, L, S) [rad/s].
        alpha: Angular accelerations in world axes, (3, L, S) [rad/s²].
        x: The links' origins, (3, L, S) [m]; x_d and x_dd are their derivatives.
    """

    def __init__(self, states: States) -> None:
        self.states = states
        self.figure = states.figure
        self._same = self.figure.is_world  # the state's quaternions are the links' orientations
        self.quaternions = states.quaternions if self._same else _world_quaternions(states)
        self.Q, self.Q_d, self.Q_dd = self.quaternions

    @cached_property
    def _dots(self) -> Array:
        return self.states.dots if self._same else np.einsum("cls,kcls->kls", self.Q, self.quaternions)

    @property
    def length_squared(self) -> Array:
        """b = Q·Q, (L, S)."""
        return self._dots[0]

    @cached_property
    def scale(self) -> Array:
        return 2 / self.length_squared

    @cached_property
    def rotation(self) -> Array:
        return rotation_matrix(self.Q, self.scale)

    @cached_property
    def rates(self) -> Array:
        """2 (Q·Q')/b and 2 (Q·Q'')/b, (2, L, S) [1/s, 1/s²]; the first is b'/b."""
        return self._dots[1:] * self.scale

    @cached_property
    def vector_product(self) -> Array:
        """G of Q, (3, 4, L, S), see `algebra.vector_product`."""
        return vector_product(self.Q)

    @cached_property
    def spins(self) -> Array:
        """(ω, ω'), (2, 3, L, S)."""
        out = np.einsum("jcls,kcls->kjls", self.vector_product, self.quaternions[1:])
        out *= self.scale
        out[1] -= self.rates[0] * out[0]
        return out

    @property
    def omega(self) -> Array:
        return self.spins[0]

    @property
    def alpha(self) -> Array:
        return self.spins[1]

    @cached_property
    def swing(self) -> Array:
        """A of s'' = A s for vectors s that turn with the link, (3, 3, L, S) [1/s²]."""
        return swing_matrix(self.omega, self.alpha)

    @cached_property
    def parent_swing(self) -> Array:
        return np.take(self.swing, self.figure.tables.parents, axis=2)

    def points(self, links: Index, positions: Array) -> tuple[Array, Array]:
        """Return points at `positions` (3, n) on links (n,), and their offsets from the origins, (3, n, S) each."""
        offset = self.sum_fixed(on_links(positions, links, len(self.figure.links)))
        return self.x.take(links, axis=1) + offset, offset

    def poses(self, flat: Index) -> tuple[Array, Array]:
        """Return origins (3, p) and rotations (3, 3, p) for pairs of a link and a sample, flat = link · S + sample."""
        rotation = self.rotation.reshape(9, -1).take(flat, axis=1).reshape(3, 3, -1)
        return self.x.reshape(3, -1).take(flat, axis=1), rotation

    def sum_fixed(self, weights: Array) -> Array:
        """Return sums Σ_l R_l c_l of vectors fixed on links: weights (m, 3 L), all c_x first, -> (3, m, S)."""
        return np.matmul(weights, self.rotation.reshape(3, weights.shape[1], -1))

    @cached_property
    def step(self) -> Array:
        """R_parent · offset, the vector from the parent's origin to the joint's anchor, (3, L, S)."""
        return self.sum_fixed(self.figure.tables.steps)

    @cached_property
    def hang(self) -> Array | None:
        """R · anchor, from the link's origin to its joint's anchor; None if all joints are at bodies' origins."""
        tables = self.figure.tables
        return rotate_fixed(self.rotation, tables.anchor) if tables.has_anchors else None

    @cached_property
    def anchor(self) -> Array:
        return self.x if self.hang is None else self.x + self.hang

    @cached_property
    def anchor_velocity(self) -> Array:
        return self.x_d if self.hang is None else self.x_d + cross(self.omega, self.hang)

    @cached_property
    def slide_axis(self) -> Array:
        """R · axis of the slides, (3, s, S)."""
        tables = self.figure.tables
        return rotate_fixed(self.rotation[:, :, tables.slide_links], tables.axis[:, tables.slide_links])

    @cached_property
    def hinge_axis(self) -> Array:
        """R · axis of the hinges, (3, h, S)."""
        tables = self.figure.tables
        return rotate_fixed(self.rotation[:, :, tables.hinge_links], tables.axis[:, tables.hinge_links])

    def slide(self, order: int) -> Array:
        """Return the slides' displacements from their reference, or the derivatives of these, (s, S)."""
        tables = self.figure.tables
        value = self.states.columns(tables.slide_columns, order)
        return value - tables.reference[tables.slide_links][:, None] if order == 0 else value

    def _sum(self, steps: Array, order: int) -> Array:
        """Return sums along the chains from the root, including the free roots' positions."""
        tables = self.figure.tables
        if tables.free_links.size:
            steps[:, tables.free_links] = self.states.columns(tables.position_columns, order)
        return combine(tables.path, steps)

    @cached_property
    def x(self) -> Array:
        steps = self.step.copy() if self.hang is None else self.step - self.hang
        slides = self.figure.tables.slide_links
        if slides.size:
            steps[:, slides] += self.slide(0) * self.slide_axis
        return self._sum(steps, 0)

    @cached_property
    def x_d(self) -> Array:
        parents, slides = self.figure.tables.parents, self.figure.tables.slide_links
        steps = cross(self.omega[:, parents], self.step)
        if self.hang is not None:
            steps -= cross(self.omega, self.hang)
        if slides.size:
            e = self.slide_axis
            steps[:, slides] += self.slide(1) * e + self.slide(0) * cross(self.omega[:, slides], e)
        return self._sum(steps, 1)

    @cached_property
    def x_dd(self) -> Array:
        slides = self.figure.tables.slide_links
        steps = rotate(self.parent_swing, self.step)
        if self.hang is not None:
            steps -= rotate(self.swing, self.hang)
        if slides.size:
            e, omega, swing = self.slide_axis, self.omega[:, slides], self.swing[:, :, slides]
            steps[:, slides] += (
                self.slide(2) * e + 2 * self.slide(1) * cross(omega, e) + self.slide(0) * rotate(swing, e)
            )
        return self._sum(steps, 2)


# C = A ⊗ c and two derivatives are sums of products of these derivatives of A and of c
_OF_BASE, _OF_OWN = np.array([0, 1, 0, 2, 1, 0]), np.array([0, 0, 1, 0, 1, 2])


def _world_quaternions(states: States) -> Array:
    """Return the world quaternions of all links and two derivatives from joint coordinates, (3, 4, L, S)."""
    tables = states.figure.tables
    out = from_parents(states).swapaxes(0, 1)
    for level in tables.levels:
        a, c = out[:, :, tables.parents[level]][:, _OF_BASE], out[:, :, level][:, _OF_OWN]
        parts = hamilton(a, c)
        out[:, 0, level] = parts[:, 0]
        out[:, 1, level] = parts[:, 1] + parts[:, 2]
        out[:, 2, level] = parts[:, 3] + 2 * parts[:, 4] + parts[:, 5]
    return out.swapaxes(0, 1)


def from_parents(states: States) -> Array:
    """Return rotations c, c', c'' (3, 4, L, S) of links relative to the parent, or to the world if the state is."""
    tables, out = states.figure.tables, _local_quaternions(states)
    if tables.has_turns and tables.levels:
        order = np.concatenate(tables.levels)
        out[:, :, order] = hamilton(tables.turn[:, None, order, None], out[:, :, order].swapaxes(0, 1)).swapaxes(0, 1)
    return out


def hinge_quaternions(states: States) -> tuple[Array, Array, Array]:
    """Return (cos θ/2, axis sin θ/2) of the hinges and two derivatives, (4, h, S) each."""
    tables = states.figure.tables
    theta, theta_d, theta_dd = (states.columns(tables.hinge_columns, k) for k in range(3))
    half = 0.5 * (theta - tables.reference[tables.hinge_links][:, None])
    axis = tables.axis[:, tables.hinge_links][:, :, None]
    q = np.concatenate([np.cos(half)[None], axis * np.sin(half)])
    normal = np.concatenate([-np.sin(half)[None], axis * np.cos(half)])
    return q, 0.5 * theta_d * normal, 0.5 * theta_dd * normal - 0.25 * theta_d**2 * q


def _local_quaternions(states: States) -> Array:
    """Return each joint's rotation c, c', c'', (3, 4, L, S); the identity for slides."""
    tables = states.figure.tables
    out = np.zeros((3, 4, len(states.figure.links), states.count))
    out[0, 0] = 1.0
    out[:, :, tables.quaternion_links] = states.quaternions[:, :, 1:]
    if tables.hinge_links.size:
        out[:, :, tables.hinge_links] = hinge_quaternions(states)
    return out
