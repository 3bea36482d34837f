"""Forces from outside: in flight only gravity, else contact forces below the feet, by pressure and friction.

The penalised wrench is that at the root (eqs. 18 and 21) minus the best that forces in the friction cones of the points
in contact can supply. In flight these supply nothing: the centre of mass is in free fall, and the angular momentum
about it is constant. This goes beyond the paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...array import Array, Index, Mask
from ...cone import Unsupplied, projection, split_off_cone
from ...contacts import Contact, Interval, within
from ...figure.adjoint import Cotangent
from ...figure.algebra import cross, perpendicular, rotate
from ...figure.dynamics import RootWrench, height, weight
from ...figure.effort_rows import Pushes, wrench_rows
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ..block import Dense
from ..curvature import Curvature
from ..penalty import Normalization, Penalty, Role

EDGES = 4  # of the pyramid that approximates a friction cone
FRICTION = 0.8  # default coefficient of friction
STIFF = 1e-7  # [1] ε for measurements


class _Evaluation(NamedTuple):
    """A wrench, its unsupplied part, the contact forces [N] that supply the rest, and the cones' edges."""

    wrench: RootWrench
    unsupplied: Unsupplied
    pushes: Pushes
    edges: Array


class Reactions(NamedTuple):
    """Ground reactions at samples `at` (P,) on points of footings (P,), with place [m] and force [N] (3, P) in the
    world."""

    at: Index
    footing: Index
    place: Array
    force: Array


@dataclass(frozen=True)
class Support(Penalty):
    """|w − G λ|², minimised over λ ≥ 0, with w the root's wrench.

    The columns of G are the edges of friction pyramids at the points in contact. Forces are in units of the weight,
    moments about the centre of mass in units of weight times height. Instants outside footings and flights do not
    contribute.

    root      index of the tree's free link
    footings  contacts that can push along the normal of their plane, level without one, and by friction
    flights   intervals in which nothing does, regardless of footings
    unit, length  weight [N] and height [m]
    friction  coefficient μ
    softness  ε in the added term ε |λ|², which makes the forces unique, relative to the squared edges of the cones
    """

    root: int
    footings: tuple[Contact, ...]
    flights: tuple[Interval, ...]
    unit: float
    length: float
    friction: float = FRICTION
    softness: float = 1e-4

    name = "support"
    role = Role.PHYSICS
    is_sharp = True
    normalization = Normalization(0.01)  # the square of a tenth of the weight

    @classmethod
    def of(
        cls,
        figure: Figure,
        root: int,
        footings: Sequence[Contact],
        flights: Sequence[Interval],
        friction: float = FRICTION,
    ) -> Support:
        return cls(root, tuple(footings), tuple(flights), weight(figure, root), height(figure, root), friction)

    @property
    def has_intervals(self) -> bool:
        """Whether there is any footing or flight."""
        return bool(self.footings or self.flights)

    @property
    def stiff(self) -> Support:
        """The same with so little softness that `rest` is only what contacts cannot supply."""
        return replace(self, softness=STIFF)

    def is_known(self, t: Array) -> Mask:
        """Return whether it is known what carries the figure at times t (S,), (S,)."""
        return within(self.flights, t) | self._active(t).any(axis=0)

    def rest(self, samples: Samples, wrench: RootWrench | None = None) -> Array:
        """Return the unsupplied force and moment (6, S) in units of weight and weight times height; wrench: at the
        root."""
        out, at = np.zeros((6, samples.count)), np.flatnonzero(self.is_known(samples.t))
        out[:, at] = self._evaluate(samples, at, wrench).unsupplied.rest
        return out

    def reactions(self, samples: Samples, wrench: RootWrench | None = None) -> Reactions:
        """Return the contact forces that supply as much as possible, at samples with known support; wrench: at the
        root."""
        supported = np.flatnonzero(self.is_known(samples.t))
        which, _, _ = self._pairs(samples.t[supported])
        pushes = self._evaluate(samples, supported, wrench).pushes
        x, _ = samples.links.poses(pushes.link * samples.count + pushes.at)
        return Reactions(pushes.at, which, x + pushes.offset, pushes.force)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        at = np.flatnonzero(self.is_known(samples.t))
        if not at.size:
            return
        solution = self._evaluate(samples, at)
        value, more = np.zeros((6, samples.count)), np.zeros(samples.count)
        value[:, at] = solution.unsupplied.rest
        more[at] = solution.unsupplied.value - np.sum(solution.unsupplied.rest**2, axis=0)
        share = np.repeat([1.0, 1 / self.length], 3)[:, None] / self.unit

        def pulled_back(into: Cotangent, bar: Array) -> None:
            force_bar, moment_bar = (share * bar).reshape(2, 3, -1)
            solution.pushes.pull_back(solution.wrench, into, force_bar, moment_bar)

        def curved(into: Curvature, scale: Array) -> None:
            pushes = replace(solution.pushes, at=np.searchsorted(at, solution.pushes.at))
            rows = wrench_rows(RootWrench(samples.select(at), self.root), pushes).reshape(at.size, 6, -1)
            root = share * np.linalg.cholesky(projection(solution.unsupplied, solution.edges, self.softness))
            rows = np.matmul(root.swapaxes(1, 2), rows)
            each = np.repeat(at, 6)
            into.add_rows(each, scale[each], rows.reshape(each.size, 3, -1))

        yield Dense(value, pulled_back, curved, more)

    def _evaluate(self, samples: Samples, known: Index, wrench: RootWrench | None = None) -> _Evaluation:
        """Evaluate the samples `known` (P,)."""
        wrench = RootWrench(samples, self.root) if wrench is None else wrench
        w = np.concatenate([wrench.force[:, known], wrench.moment[:, known] / self.length]) / self.unit
        which, at, slot = self._pairs(samples.t[known])
        links, positions, edges = self._arrays
        link, sample = links[which], known[at]
        x, rotation = samples.links.poses(link * samples.count + sample)
        offset = rotate(rotation, positions[:, which])
        edges_at = edges[:, which]
        lever = (x + offset - wrench.centre[:, sample]) / self.length
        pyramid = np.zeros((6, int(slot.max(initial=0)) + 1, EDGES, known.size))
        pyramid[:3, slot, :, at] = edges_at.transpose(1, 0, 2)
        pyramid[3:, slot, :, at] = cross(lever[:, :, None], edges_at).transpose(1, 0, 2)
        pyramid = pyramid.reshape(6, pyramid.shape[1] * EDGES, known.size)
        unsupplied_part = split_off_cone(w, pyramid, self.softness)
        shares = unsupplied_part.shares.reshape(pyramid.shape[1] // EDGES, EDGES, known.size)[slot, :, at]
        force = self.unit * np.einsum("ipe,pe->ip", edges_at, shares)
        return _Evaluation(wrench, unsupplied_part, Pushes(sample, link, offset, force), pyramid)

    def _active(self, t: Array) -> Mask:
        """Return whether footings apply at times t (S,), (n, S)."""
        first, last = (np.array([getattr(f, name) for f in self.footings])[:, None] for name in ("first", "last"))
        return (first <= t) & (t <= last) & ~within(self.flights, t)

    def _pairs(self, t: Array) -> tuple[Index, Index, Index]:
        """Return pairs of a footing and a sample within it, by sample, and the rank of each pair in its sample."""
        at, which = np.nonzero(self._active(t).T)
        begin = np.searchsorted(at, np.arange(t.size))
        return which, at, np.arange(at.size) - begin[at]

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) of the points, and the edges of their friction pyramids (3, n, 4)."""
        links = np.array([f.point.link for f in self.footings], np.intp)
        positions = np.array([f.point.position for f in self.footings]).reshape(-1, 3).T
        normals = np.array([f.normal for f in self.footings]).reshape(-1, 3)
        unlike, which = np.unique(normals, axis=0, return_inverse=True)
        edges = np.array([friction_edges(normal, self.friction) for normal in unlike]).reshape(-1, 3, EDGES)
        return links, positions, edges[which.ravel()].transpose(1, 0, 2)


def friction_edges(normal: Array, friction: float) -> Array:
    """Return the edges (3, 4), with unit normal parts, of the pyramid in the friction cone about a normal (3,)."""
    across = perpendicular(normal)
    along = np.cross(across, normal)
    tangents = np.array([across + along, along - across, -across - along, across - along]) / np.sqrt(2)
    return (normal + friction * tangents).T


@dataclass(frozen=True)
class Flight(Penalty):
    """|F|² + angular · |N|² of a tree in flight.

    The force F is in units of the weight, so that |F|² is |a − g|²/g² of the centre of mass. The moment N about the
    centre of mass is in units of weight times height.

    root       index of the tree's free link
    intervals  (first, last) [s] of every flight
    unit       weight [N];  length  height [m], see `height`
    angular    weight of the moment
    """

    root: int
    intervals: tuple[tuple[float, float], ...]
    unit: float
    length: float
    angular: float = 0.0

    name = "flight"
    role = Role.PHYSICS
    is_sharp = True
    normalization = Normalization(0.01)  # the square of a tenth of the weight

    @classmethod
    def of(cls, figure: Figure, root: int, intervals: tuple[tuple[float, float], ...], angular: float = 0.0) -> Flight:
        return cls(root, intervals, weight(figure, root), height(figure, root), angular)

    def residuals(self, samples: Samples) -> Iterator[Dense]:
        aloft = within(self.intervals, samples.t)
        at = np.flatnonzero(aloft)
        if not at.size:
            return
        wrench = RootWrench(samples, self.root)
        share = np.repeat([1.0, np.sqrt(self.angular) / self.length], 3)[: 6 if self.angular else 3] / self.unit
        value = share[:, None] * (np.concatenate([wrench.force, wrench.moment])[: share.size] * aloft)

        def pulled_back(into: Cotangent, bar: Array) -> None:
            felt = np.zeros((6, samples.count))
            felt[: share.size] = share[:, None] * bar * aloft
            wrench.pull_back(into, felt[:3], felt[3:])

        def curved(into: Curvature, scale: Array) -> None:
            wrench = RootWrench(samples.select(at), self.root)
            rows = share[:, None, None] * wrench_rows(wrench, moment=bool(self.angular))
            each = np.repeat(at, share.size)
            into.add_rows(each, scale[each], rows.reshape(each.size, 3, -1))

        yield Dense(value, pulled_back, curved)
