"""Floor and step: contact points stay above the surfaces (eq. 12), squared so that the gradient is smooth."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from ...array import Array, Index, count_off
from ...curve.frame import Timeline
from ...figure.algebra import rotate
from ...figure.dynamics import Size
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import of_point
from ...surface import Box, Plane, Surface
from ...surface.points import Point, arrays_of, sets_depths
from ...tolerances import ROUNDING
from ..block import Block
from ..penalty import NEAR_LENGTH, Allowance, Normalization, Penalty, Role

MOST_TOGETHER = 64  # most points in a bounding sphere; a limb of capsules has 10-30
_Near = tuple[Index, Array, Array, Array]


@dataclass(frozen=True)
class Collision(Penalty):
    """Σ over points and surfaces of depth² [m²], every point enlarged by `margin` [m].

    allowed  (n, K) [m] reductions of the points' radii, for depths fixed by keyframes
    carrier  index of the link in whose axes the surfaces are fixed; 0: the static world
    """

    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    margin: float = 0.0
    allowed: Allowance | None = None
    name: str = "collision.soles"
    carrier: int = 0

    is_sharp = True
    normalization = Normalization(1e-4, length_power=2)

    def allowing(self, figure: Figure, keys: Timeline, holding: Sequence[tuple[int, float, float]] = ()) -> Collision:
        """Return the penalty without the depth that keyframes fix, including the margin.

        holding  (link, first, last [s]) of links that hold the surfaces, with their limbs. If a keyframe leaves a link
        of such a limb free, the whole link may be as deep as its deepest point in the next keyframe that fixes it.
        """
        if not self.points or not self.surfaces:
            return self
        samples = Samples.still(figure, keys.states)
        centres = self.relative_to_carrier(samples, self.centres(samples)[0])
        deep = np.max([surface.depth(centres, self._arrays[2])[0] for surface in self.surfaces], axis=0)
        is_set = sets_depths(figure, keys.fixed, self.points, self.surfaces)
        excess, path = deep * is_set, figure.tables.path > 0
        for link, first, last in holding:
            limb = np.flatnonzero((path[:, link] | path[link])[self._arrays[0]])
            during = np.flatnonzero((keys.times >= first - ROUNDING) & (keys.times <= last + ROUNDING))
            for before, k in [*pairwise(during), *pairwise(during[::-1])]:
                free = limb[~is_set[limb, k] & is_set[limb, before]]
                for part in np.unique(self._arrays[0][free]):
                    points = free[self._arrays[0][free] == part]
                    excess[points, k] = excess[points, before].max()
                is_set[free, k] = True
        return replace(self, allowed=Allowance.in_keys(keys, excess, is_set))

    @property
    def role(self) -> Role:
        is_ground = all(isinstance(s, Plane) or (isinstance(s, Box) and s.buried) for s in self.surfaces)
        return Role.COLLISION if is_ground else Role.OBSTACLE

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array]:
        """Links (n,), positions (3, n) and radii (n,) of the points, margin included."""
        links, positions, radius = arrays_of(self.points)
        return links, positions, radius + self.margin

    @cached_property
    def _groups(self) -> tuple[Index, Index]:
        """Links (m,) of the groups of points that are evaluated together, and every point's group (n,). A group is the
        points of a link or, for many points, of a part of it."""
        links, positions, _ = self._arrays
        groups = [part for link in np.unique(links) for part in neighbours(positions, np.flatnonzero(links == link))]
        owner = np.empty(links.size, np.intp)
        for k, part in enumerate(groups):
            owner[part] = k
        return np.array([links[part[0]] for part in groups]), owner

    @cached_property
    def _bounds(self) -> tuple[Index, Array, Array]:
        """Bounding spheres of the groups: links (m,), centres (3, m), radii (m,)."""
        _, positions, radius = self._arrays
        carriers, owner = self._groups
        middles = np.array([positions[:, owner == k].mean(axis=1) for k in range(carriers.size)]).T
        far = np.linalg.norm(positions - middles[:, owner], axis=0) + radius
        return carriers, middles, np.array([far[owner == k].max() for k in range(carriers.size)])

    @cached_property
    def _places(self) -> tuple[Index, Index]:
        """Index of every point in `_by_group`: its rank in its group (n,) and its group (n,)."""
        _, owner = self._groups
        rank = np.empty_like(owner)
        _, rank[np.argsort(owner, kind="stable")] = count_off(np.bincount(owner))
        return rank, owner

    @cached_property
    def _by_group(self) -> tuple[Array, Array]:
        """Positions (3, p, m) and radii (p, m) of every group's points; smaller groups are padded with radii −∞."""
        _, positions, radius = self._arrays
        rank, owner = self._places
        padded = np.zeros((3, rank.max() + 1, owner.max() + 1))
        radii = np.full(padded.shape[1:], -np.inf)
        padded[:, rank, owner], radii[rank, owner] = positions, radius
        return padded, radii

    @cached_property
    def _allowed_by_group(self) -> Allowance | None:
        """The allowances (p, m, K) in the layout of `_by_group`, None without any."""
        if self.allowed is None:
            return None
        rank, owner = self._places
        padded = np.zeros((rank.max() + 1, owner.max() + 1, self.allowed.times.size))
        padded[rank, owner] = self.allowed.excess
        return Allowance(self.allowed.times, padded)

    def centres(self, samples: Samples) -> tuple[Array, Array, Index]:
        """Return centres of the points (3, n, S) [m], their offsets from the links' origins, and the links (n,)."""
        links, positions, _ = self._arrays
        return *samples.links.points(links, positions), links

    def relative_to_carrier(self, samples: Samples, points: Array) -> Array:
        """Return points (3, n, S) of the world in the axes of the surfaces' carrier."""
        if not self.carrier:
            return points
        away = points - samples.links.x[:, self.carrier, None]
        return np.einsum("ijs,ins->jns", samples.links.rotation[:, :, self.carrier], away)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        if not self.points or not self.surfaces:
            return
        margin = NEAR_LENGTH * Size.of(samples.figure).length
        carriers, middles, reach = self._bounds
        around = self.relative_to_carrier(samples, samples.links.points(carriers, middles)[0])
        touching = [surface.near(around, reach[:, None] + margin) for surface in self.surfaces]
        near = np.flatnonzero(np.logical_or.reduce(touching))
        block = self._near(samples, near) if near.size else None
        parts = []
        for surface, touched in zip(self.surfaces, touching, strict=True):
            if block is not None and touched.any():
                parts.append(self._in(surface, samples, block, margin))
        yield Block.join(parts)

    def _in(self, surface: Surface, samples: Samples, candidates: _Near, margin: float) -> Block:
        flat, arms, centres, radii = candidates
        depth, direction = surface.depth(centres, radii, margin)
        near = np.flatnonzero(depth > -np.inf)
        depth, direction = depth.ravel()[near], direction.reshape(3, -1)[:, near]
        link, at = np.divmod(flat[near % flat.size], samples.count)
        direction, leg = self._in_world(samples, at, direction, centres[:, near, 0])
        changes = [of_point(at, link, arms[:, near], direction)]
        if self.carrier:
            changes.append(of_point(at, np.full(at.size, self.carrier), leg, -direction))
        return Block(at, depth, tuple(changes), one_sided=True)

    def _in_world(self, samples: Samples, at: Index, force: Array, place: Array) -> tuple[Array, Array]:
        """Return a vector and a position (3, P) in the carrier's axes in those of the world, at samples `at` (P,)."""
        if not self.carrier:
            return force, place
        rotation = samples.links.rotation[:, :, self.carrier, at]
        return rotate(rotation, force), rotate(rotation, place)

    def _near(self, samples: Samples, near: Index) -> _Near:
        """Return all points of k pairs of a group and a sample.

        These are link · S + sample (k,), arms (3, p k), centres (3, p k, 1) in the axes of the surfaces, and radii (p
        k,).

        near  (k,) group · S + sample
        """
        positions, radii = self._by_group
        carrier, at = np.divmod(near, samples.count)
        flat = self._bounds[0].take(carrier) * samples.count + at
        x, rotation = samples.links.poses(flat)
        arms = np.einsum("ijk,jpk->ipk", rotation, positions.take(carrier, axis=2))
        centres = arms + x[:, None]
        if self.carrier:
            origin, turn = samples.links.poses(self.carrier * samples.count + at)
            centres = np.einsum("ijk,ipk->jpk", turn, centres - origin[:, None])
        centres = centres.reshape(3, -1, 1)
        radii = radii.take(carrier, axis=1)
        if self._allowed_by_group is not None:
            radii = radii - self._allowed_by_group.of(carrier, samples.t.take(at))
        return flat, arms.reshape(3, -1), centres, radii.ravel()


def neighbours(positions: Array, indices: Index) -> list[Index]:
    """Return some of points (3, n) in groups of at most MOST_TOGETHER, split across their largest extent."""
    if indices.size <= MOST_TOGETHER:
        return [indices]
    axis = int(np.argmax(np.ptp(positions[:, indices], axis=1)))
    order = indices[np.argsort(positions[axis, indices], kind="stable")]
    half = order.size // 2
    return [*neighbours(positions, order[:half]), *neighbours(positions, order[half:])]
