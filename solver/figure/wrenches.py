"""Wrenches on links, and the Jacobian rows of residuals that they represent.

A residual of positions, directions, velocities or angular velocities changes with a wrench on a link:

    δr = f · δx + τ · δφ  +  f₁ · δx' + τ₁ · δω  +  τ₂ · δω'

x is the link's origin, and δφ its small rotation in the world. A coordinate that grows by φ(t) rotates a link about an
axis w through an anchor a: δx = φ w × d with d = x − a, and δω = φ' w + φ (w' + w × ω). The coefficients of its row are

    of φ:  w · M₀ + w' · M₁ + w'' · M₂        of φ':  w · M₁ + 2 w' · M₂        of φ'':  w · M₂

with the wrench's moments about the anchor: M₀ = d × f + τ + d' × f₁ + ω × τ₁ + ω' × τ₂, M₁ = d × f₁ + τ₁ + ω × τ₂ and
M₂ = τ₂. For a slide, w is its axis, and the forces replace the moments. `turns` describes the coefficients of
quaternions. If a link shifts with the anchor of a later link, that anchor replaces x.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .. import compiled
from ..array import IN_CACHE, Array, Index, Mask
from .algebra import cross, dot, rotate_back
from .figure import Figure
from .kinematics import Samples
from .turns import (
    Orders,
    add_terms,
    bases,
    followers,
    on_moving_axes,
    on_quaternions,
    places,
    quaternion_factors,
    relatives,
)

VECTORS = ("force", "torque", "force_d", "torque_d", "torque_dd")
NONE = np.zeros(0)  # the kernel's argument for kinds of joints that the figure does not have


@dataclass(frozen=True, eq=False)
class Wrenches:
    """Derivatives of P residuals with respect to the motion of links, as wrenches in world axes. None means zero.

    Attributes:
        at: Samples (P,).
        link: Links (P,).
        force: Derivatives (3, P) by the position of the link's origin.
        torque: Derivatives (3, P) by a small rotation of the link.
        force_d: Derivatives (3, P) by the velocity of the origin.
        torque_d: Derivatives (3, P) by the angular velocity.
        torque_dd: Derivatives (3, P) by the angular acceleration.
    """

    at: Index
    link: Index
    force: Array | None = None
    torque: Array | None = None
    force_d: Array | None = None
    torque_d: Array | None = None
    torque_dd: Array | None = None

    @property
    def orders(self) -> int:
        """1 if the residuals depend only on the state y, 2 if also on y', and 3 if also on y''."""
        if self.torque_dd is not None:
            return 3
        return 1 if self.force_d is None and self.torque_d is None else 2

    def select(self, indices: Index | slice) -> Wrenches:
        """Return the wrenches of some indices."""
        vectors = {name: part[:, indices] for name, part in self.vectors.items()}
        return Wrenches(self.at[indices], self.link[indices], **vectors)

    @property
    def vectors(self) -> dict[str, Array]:
        return {name: part for name in VECTORS if (part := getattr(self, name)) is not None}

    def scale(self, factor: Array) -> Wrenches:
        """Return each wrench times a factor (P,)."""
        return Wrenches(self.at, self.link, **{name: part * factor for name, part in self.vectors.items()})

    @classmethod
    def join(cls, parts: Sequence[Wrenches]) -> Wrenches:
        """Return several sets of wrenches, concatenated."""
        if len(parts) == 1:
            return parts[0]
        at, link = (np.concatenate([getattr(part, name) for part in parts]) for name in ("at", "link"))
        vectors_by_name: dict[str, Array] = {}
        for name in VECTORS:
            all_vectors = [getattr(part, name) for part in parts]
            if any(vectors is not None for vectors in all_vectors):
                filled = [np.zeros((3, p.at.size)) if v is None else v for p, v in zip(parts, all_vectors, strict=True)]
                vectors_by_name[name] = np.concatenate(filled, axis=1)
        return cls(at, link, **vectors_by_name)

    def rows(self, samples: Samples) -> Array:
        """Return the gradients of the residuals with respect to y, y' and y'', (P, `orders`, N)."""
        if compiled.kernel is not None:
            return _compiled_rows(samples, self)
        out = np.zeros((self.at.size, self.orders, samples.y.shape[1]))
        for first in range(0, self.at.size, IN_CACHE):
            run = slice(first, first + IN_CACHE)
            _Sweep(samples, self.select(run)).add_to(out[run])
        return out


def _compiled_rows(samples: Samples, wrenches: Wrenches) -> Array:
    out = np.empty((wrenches.at.size, wrenches.orders, samples.y.shape[1]))
    links, orders, tables = samples.links, wrenches.orders, samples.figure.tables
    # rows by y alone multiply the rates by zero, so any computed array may replace them
    x_d, anchor_d, omega = (links.x_d, links.anchor_velocity, links.omega) if orders > 1 else (links.x,) * 3
    alpha = links.alpha if orders > 2 else links.x
    slides = links.slide_axis if tables.slide_links.size else NONE
    hinges = links.hinge_axis if tables.hinge_links.size else NONE
    motion = (links.x, x_d, links.anchor, anchor_d, omega, alpha, slides, hinges)
    quaternions = (
        (samples.cache(quaternion_factors), samples.cache(bases)) if tables.quaternion_links.size else (NONE, NONE)
    )
    vectors = [getattr(wrenches, name) for name in VECTORS]
    figure = _facts(samples.figure)
    size = samples.count, out.shape[2], orders
    compiled.call("wrench_rows", out, wrenches.at, wrenches.link, *vectors, *figure, *motion, *quaternions, *size)
    return out


@lru_cache(maxsize=8)
def _facts(figure: Figure) -> tuple[Index, Index]:
    """Return the kernel's data of links (L, 9), and `followers`. The columns, −1 where they do not apply: parent,
    column of a position; index among the slides, and column; the same for hinges and for quaternions; index among the
    relative quaternions."""
    tables, (place, base), apart = figure.tables, places(figure), relatives(figure)
    facts = np.full((len(tables.parents), 9), -1, np.int64)
    facts[:, 0] = tables.parents
    facts[0, 0] = 0
    facts[tables.free_links, 1] = tables.position_columns[0]
    for first, links, columns in (
        (2, tables.slide_links, tables.slide_columns),
        (4, tables.hinge_links, tables.hinge_columns),
        (6, tables.quaternion_links, tables.quaternion_columns[0]),
    ):
        facts[links, first], facts[links, first + 1] = place[links], columns
    facts[apart, 8] = base[apart]
    return facts, np.ascontiguousarray(followers(figure).astype(np.int64))


def of_point(at: Index, link: Index, offset: Array, direction: Array) -> Wrenches:
    """Return the derivatives of direction · p by the motion of links, for points p fixed to them.

    Args:
        at: Samples (P,).
        link: Links (P,).
        offset: Offsets (3, P) of the points from the links' origins, in world axes [m].
        direction: Directions (3, P).

    Returns:
        P wrenches.
    """
    return Wrenches(at, link, direction, cross(offset, direction))


def of_velocity(
    samples: Samples, at: Index, link: Index, offset: Array, direction: Array, turning: Array | None = None
) -> Wrenches:
    """Return the derivatives of direction · p' by the motion of links, for velocities p' of points on them.

    Args:
        samples: The samples.
        at: Samples (P,).
        link: Links (P,).
        offset: Offsets (3, P) of the points from the links' origins, in world axes [m].
        direction: Directions (3, P).
        turning: The part (3, P) of each offset that rotates with its link; default: the whole offset. For the lowest
            point of a sphere, it is the offset of the sphere's centre, as the lowest point is always below the centre.

    Returns:
        P wrenches.
    """
    beside = cross(offset if turning is None else turning, cross(direction, samples.links.omega[:, link, at]))
    return Wrenches(at, link, None, beside, direction, cross(offset, direction))


def of_turn(at: Index, link: Index, axis: Array) -> Wrenches:
    """Return the derivatives of the angles by which links turn about axes, by the motion of the links.

    Args:
        at: Samples (P,).
        link: Links (P,).
        axis: Axes (3, P) in the world.

    Returns:
        P wrenches.
    """
    return Wrenches(at, link, None, axis)


def along_axes(at: Index, link: Index) -> tuple[Index, Index, Array]:
    """Return the sample, the link and the world axis of each component of P vectors: x of all, then y, then z.

    Args:
        at: The samples of the vectors, (P,).
        link: The links of the vectors, (P,).

    Returns:
        Samples (3 P,), links (3 P,) and axes (3, 3 P).
    """
    return np.tile(at, 3), np.tile(link, 3), np.repeat(np.eye(3), at.size, axis=1)


def every_axis(links: Index, count: int) -> tuple[Index, Index, Array]:
    """Return the sample, the link and the world axis to which each component of an array (3, n, S) belongs.

    The array contains a vector for each of n links at each of S samples.

    Args:
        links: Links (n,).
        count: Number S of samples.

    Returns:
        Samples (3 n S,), links (3 n S,) and axes (3, 3 n S), in the order of the raveled vectors.
    """
    return along_axes(np.tile(np.arange(count), links.size), np.repeat(links, count))


@dataclass(frozen=True, eq=False)
class _Chains:
    """The joints on the chain to every link, by kind: links (depth, L), 0 in unused entries.

    Attributes:
        after: For each link of `world`, the next such link on the chain, or 0, (depth, L).
    """

    free: Index
    slides: Index
    hinges: Index
    world: Index
    after: Index
    relative: Index


@lru_cache(maxsize=8)
def _chains(figure: Figure) -> _Chains:
    tables, path = figure.tables, figure.tables.path > 0
    in_world = tables.quaternion_links[tables.in_world[tables.quaternion_links]]
    kinds = tables.free_links, tables.slide_links, tables.hinge_links, in_world, relatives(figure)
    free, slides, hinges, world, relative = (_pad(path, links) for links in kinds)
    after = followers(figure)[np.arange(len(path)), world]
    return _Chains(free, slides, hinges, world, after, relative)


def _pad(path: Mask, links: Index) -> Index:
    """Return those of some links that are on the chain to every link, (depth, L)."""
    chains = [links[path[link, links]] for link in range(len(path))]
    out = np.zeros((max(chain.size for chain in chains), len(path)), np.intp)
    for link, chain in enumerate(chains):
        out[: chain.size, link] = chain
    return out


@dataclass(frozen=True, eq=False)
class _Pairs:
    """Q pairs of a wrench and a joint on the chain to its link: indices of wrench, sample, and the joint's link."""

    wrench: Index
    at: Index
    joint: Index


class _Sweep:
    """Wrenches, and their Jacobian rows with respect to every joint on the chains to their links."""

    def __init__(self, samples: Samples, wrenches: Wrenches) -> None:
        self.samples, self.tables, self.motion = samples, samples.figure.tables, samples.links
        self.chains, (self.place, self.base) = _chains(samples.figure), places(samples.figure)
        self.at, self.link = wrenches.at, wrenches.link
        self.forces: Orders = [wrenches.force, wrenches.force_d, None]
        self.torques = self._on_turns(wrenches)

    def add_to(self, out: Array) -> None:
        self._free(out)
        self._slides(out)
        self._hinges(out)
        self._world_quaternions(out)
        self._relative_quaternions(out)

    def _pairs(self, chain: Index) -> _Pairs:
        joints = chain[:, self.link]
        level, wrench = np.nonzero(joints)
        return _Pairs(wrench, self.at[wrench], joints[level, wrench])

    def _moments(self, pairs: _Pairs, after: Index | None = None) -> Orders:
        """Return M₀, M₁, M₂ about the joints' anchors; the anchors of `after` (Q,) replace the wrenches' points."""
        motion, there = self.motion, (slice(None), pairs.joint, pairs.at)
        moments: Orders = [None, None, None]
        force, force_d, _ = self._of_pairs(self.forces, pairs)
        if force is not None or force_d is not None:
            d = self._ends(motion.x, motion.anchor, pairs, after) - motion.anchor[there]
            if force is not None:
                moments[0] = cross(d, force)
            if force_d is not None:
                d_d = self._ends(motion.x_d, motion.anchor_velocity, pairs, after) - motion.anchor_velocity[there]
                moments[0] = add_terms(moments[0], cross(d_d, force_d))
                moments[1] = cross(d, force_d)
        for order, torque in enumerate(self._of_pairs(self.torques, pairs)):
            if torque is not None:
                moments[order] = add_terms(moments[order], torque if after is None else torque * (after == 0))
        return moments

    def _of_pairs(self, vectors: Orders, pairs: _Pairs) -> Orders:
        return [None if part is None else part[:, pairs.wrench] for part in vectors]

    def _ends(self, places: Array, anchors: Array, pairs: _Pairs, after: Index | None) -> Array:
        """Return the next links' anchors if there are any, else the wrenches' points, or their velocities, (3, Q)."""
        points = places[:, self.link[pairs.wrench], pairs.at]
        return points if after is None else np.where(after > 0, anchors[:, after, pairs.at], points)

    def _on_turns(self, wrenches: Wrenches) -> Orders:
        """Return the coefficients of δφ, δφ' and δφ'': τ + ω × τ₁ + ω' × τ₂, τ₁ + ω × τ₂ and τ₂."""
        torque, torque_d, torque_dd = wrenches.torque, wrenches.torque_d, wrenches.torque_dd
        omega, alpha = self.motion.omega, self.motion.alpha
        there = (slice(None), self.link, self.at)
        if torque_d is not None:
            torque = add_terms(torque, cross(omega[there], torque_d))
        if torque_dd is not None:
            torque = add_terms(torque, cross(alpha[there], torque_dd))
            torque_d = add_terms(torque_d, cross(omega[there], torque_dd))
        return [torque, torque_d, torque_dd]

    def _on_axes(self, moments: Orders, frame: Index, at: Index) -> Orders:
        """Return the coefficients of axes that rotate with links `frame` (Q,)."""
        if moments[1] is None:  # nor is there then a moment of angular acceleration
            return moments
        alpha = None if moments[2] is None else self.motion.alpha[:, frame, at]
        return on_moving_axes(moments, self.motion.omega[:, frame, at], alpha)

    def _free(self, out: Array) -> None:
        columns = np.zeros((3, len(self.tables.parents)), np.intp)
        columns[:, self.tables.free_links] = self.tables.position_columns
        pairs = self._pairs(self.chains.free)
        for order, force in enumerate(self._of_pairs(self.forces, pairs)):
            if force is not None:
                out[pairs.wrench, order, columns[:, pairs.joint]] = force

    def _slides(self, out: Array) -> None:
        if self.tables.slide_links.size:
            pairs = self._pairs(self.chains.slides)
            forces = self._of_pairs(self.forces, pairs)
            self._add_axes(out, pairs, self.motion.slide_axis, self.tables.slide_columns, forces)

    def _hinges(self, out: Array) -> None:
        if self.tables.hinge_links.size:
            pairs = self._pairs(self.chains.hinges)
            self._add_axes(out, pairs, self.motion.hinge_axis, self.tables.hinge_columns, self._moments(pairs))

    def _add_axes(self, out: Array, pairs: _Pairs, axes: Array, columns: Index, moments: Orders) -> None:
        """Add the coefficients of axes (3, n, S) of hinges or slides."""
        place = self.place[pairs.joint]
        axis = axes[:, place, pairs.at]
        for order, moment in enumerate(self._on_axes(moments, pairs.joint, pairs.at)):
            if moment is not None:
                out[pairs.wrench, order, columns[place]] = dot(axis, moment)

    def _world_quaternions(self, out: Array) -> None:
        pairs = self._pairs(self.chains.world)
        after = self.chains.after[:, self.link][self.chains.world[:, self.link] > 0]
        self._add_quaternions(out, pairs, self._moments(pairs, after))

    def _relative_quaternions(self, out: Array) -> None:
        pairs = self._pairs(self.chains.relative)
        if not pairs.joint.size:
            return
        parents = self.tables.parents[pairs.joint]
        moments = self._on_axes(self._moments(pairs), parents, pairs.at)
        axes = self.samples.cache(bases)[:, :, self.base[pairs.joint], pairs.at]
        self._add_quaternions(out, pairs, [None if part is None else rotate_back(axes, part) for part in moments])

    def _add_quaternions(self, out: Array, pairs: _Pairs, moments: Orders) -> None:
        place = self.place[pairs.joint]
        columns = self.tables.quaternion_columns[:, place]
        turns = self.samples.cache(quaternion_factors)[: out.shape[1], :, place, pairs.at]
        for order, total in enumerate(on_quaternions(moments, turns)):
            if total is not None:
                out[pairs.wrench, order, columns] = total
