"""Derivatives by small rotations of joints, converted to the coordinates of the state.

Let a residual change by M₀ · φ + M₁ · φ' + M₂ · φ'' when a joint rotates by a small φ(t). For a hinge, φ = θ w with its
axis w, and w' = ω × w if the axis turns with a link of angular velocity ω. For a quaternion, φ = E η for its change η.
This φ is in world axes if the quaternion is the link's orientation in the world, otherwise in the parent's axes.

A change of an orientation in the world rotates the links up to the next ones whose orientation is in the state. Links
from there on only shift, with the anchors of these.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from ..array import Array, Index, Mask
from .algebra import cross, dot, hamilton, rotate_back, rotation_matrix, vector_product
from .figure import Figure
from .kinematics import LinkMotion, Samples

Orders = list[Array | None]  # the coefficients of φ, φ', φ'' or of y, y', y'', component first; None is zero


def on_moving_axes(moments: Orders, omega: Array, alpha: Array | None) -> Orders:
    """Return the coefficients of coordinates along moving axes for moments M₀, M₁, M₂.

    Args:
        moments: M₀, M₁, M₂.
        omega: The angular velocity with which the axes turn, (3, ...) [rad/s].
        alpha: The angular acceleration, (3, ...) [rad/s²]; required if M₂ is not None.
    """
    first, second, third = moments
    if second is not None:
        first = add_terms(first, cross(second, omega))
    if third is not None and alpha is not None:
        through = cross(third, omega)
        first = add_terms(first, cross(third, alpha) + cross(through, omega))
        second = add_terms(second, 2 * through)
    return [first, second, third]


def on_quaternions(moments: Orders, turns: Array) -> Orders:
    """Return the coefficients (4, ...) of quaternions by φ = E η, φ' = E' η + E η', φ'' = E'' η + 2 E' η' + E η''.

    Args:
        moments: M₀, M₁, M₂, (3, ...).
        turns: The `quaternion_factors` of the quaternions, (3, 4, ...).
    """
    totals: Orders = [None, None, None]
    products = [vector_product(turn) for turn in turns]
    for order, factors in enumerate(((1,), (1, 1), (1, 2, 1))):
        moment = moments[order]
        if moment is not None:
            for derivative, factor in enumerate(factors):
                part, total = rotate_back(products[derivative], moment), totals[order - derivative]
                if factor != 1:
                    part *= factor
                if total is None:
                    totals[order - derivative] = part
                else:
                    total += part
    return totals


def add_terms(one: Array | None, other: Array) -> Array:
    """Return the sum of two terms, of which the first may be None for zero."""
    return other if one is None else one + other


def quaternion_factors(links: LinkMotion) -> Array:
    """Return the quaternions p of E η = vec(η ⊗ conj(p)), and two derivatives, (3, 4, n, S)."""
    (q, q_d, q_dd), dots = links.states.quaternions[:, :, 1:], links.states.dots[:, 1:]
    scale = 2 / dots[0]
    stretch = dots[1] * scale
    stretch_d = (dot(q_d, q_d) + dots[2]) * scale - stretch**2
    return np.array([q, q_d - stretch * q, q_dd - 2 * stretch * q_d + (stretch**2 - stretch_d) * q]) * scale


@lru_cache(maxsize=8)
def places(figure: Figure) -> tuple[Index, Index]:
    """Return two indices of each link, (L,) each.

    The first is its index among the links of its kind: slides, hinges or quaternions. The second is its index among the
    links of `relatives`.
    """
    tables = figure.tables
    index, base = np.zeros((2, len(figure.links)), np.intp)
    for links in (tables.slide_links, tables.hinge_links, tables.quaternion_links):
        index[links] = np.arange(links.size)
    base[relatives(figure)] = np.arange(relatives(figure).size)
    return index, base


def relatives(figure: Figure) -> Index:
    """Return the links whose quaternions are relative to their parents."""
    tables = figure.tables
    return tables.quaternion_links[~tables.in_world[tables.quaternion_links]]


def bases(links: LinkMotion) -> Array:
    """Return the axes of the relative quaternions, which turn with the parents, (3, 3, n, S)."""
    tables, chosen = links.figure.tables, relatives(links.figure)
    base = hamilton(links.Q[:, tables.parents[chosen]], tables.turn[:, chosen, None])
    return rotation_matrix(base, 2 / dot(base, base))


@lru_cache(maxsize=8)
def turning(figure: Figure) -> Array:
    """Return 1 for the links (columns) that the joint of a link (row) rotates, else 0, (L, L)."""
    return figure.tables.beyond - following(figure) @ figure.tables.beyond


@lru_cache(maxsize=8)
def following(figure: Figure) -> Array:
    """Return 1 for the next links (columns) after a link (row) if the orientations of both are in the state, (L, L)."""
    tables = figure.tables
    out = np.zeros((len(figure.links), len(figure.links)))
    inner = [i for i in tables.quaternion_links if tables.in_world[i] and tables.parents[i]]
    out[tables.parents[inner], inner] = 1.0
    return out


@lru_cache(maxsize=8)
def followers(figure: Figure) -> Index:
    """Return, for link i (row), the next link after j (column) on its chain with orientation in the state, or 0."""
    path, tables = figure.tables.path > 0, figure.tables
    out = np.zeros(path.shape, np.intp)
    for link in range(len(path)):
        chain = [i for i in tables.quaternion_links if path[link, i] and tables.in_world[i]]
        out[link, chain[:-1]] = chain[1:]
    return out


def add_rows_of_turns(samples: Samples, links: Index, changes: Array, row: Index, out: Array) -> None:
    """Set the entries of rows that depend on φ, φ', φ'' of n links' joints, small rotations about the world's axes.

    Args:
        links: The links, (n,).
        changes: The coefficients, by order and component of φ, (3, 3, C, n, S).
        row: The row of `out` of each coefficient, (C, n).
        out: The rows, (N, R, 3, S).
    """
    tables, motion, (place, base) = samples.figure.tables, samples.links, places(samples.figure)

    def rates(frames: Index) -> tuple[Array, Array]:
        return motion.omega[:, None, frames], motion.alpha[:, None, frames]

    is_hinge = np.isin(links, tables.hinge_links)
    for run in indices_of(is_hinge):
        joints = links[run]
        axes = motion.hinge_axis[:, None, place[joints]]
        for order, moment in enumerate(on_moving_axes(list(changes[:, :, :, run]), *rates(joints))):
            if moment is not None:
                out[tables.hinge_columns[place[joints]], row[:, run], order] = dot(axes, moment)
    for kind, is_world in ((tables.in_world, True), (~tables.in_world, False)):
        for run in indices_of(~is_hinge & kind[links]):
            joints = links[run]
            moments: Orders = list(changes[:, :, :, run])
            if not is_world:
                axes = samples.cache(bases)[:, :, None, base[joints]]
                moments = on_moving_axes(moments, *rates(tables.parents[joints]))
                moments = [rotate_back(axes, part) for part in moments if part is not None]
            totals = on_quaternions(moments, samples.cache(quaternion_factors)[:, :, None, place[joints]])
            for order, total in enumerate(totals):
                out[tables.quaternion_columns[:, None, place[joints]], row[:, run], order] = total


def add_rows_of_shifts(samples: Samples, links: Index, changes: Array, row: Index, out: Array) -> None:
    """Do the same for translations along the world's axes, of slides and free joints."""
    tables, motion, (place, _) = samples.figure.tables, samples.links, places(samples.figure)
    for free, columns in zip(tables.free_links, tables.position_columns.T, strict=True):
        for run in indices_of(links == free):
            for order in range(3):
                out[columns[:, None, None], row[:, run], order] = changes[order][:, :, run]
    for run in indices_of(np.isin(links, tables.slide_links)):
        joints = links[run]
        axes, frames = motion.slide_axis[:, None, place[joints]], joints[None]
        forces = on_moving_axes(list(changes[:, :, :, run]), motion.omega[:, frames], motion.alpha[:, frames])
        for order, force in enumerate(forces):
            if force is not None:
                out[tables.slide_columns[place[joints]], row[:, run], order] = dot(axes, force)


def indices_of(mask: Mask) -> Iterator[Index | slice]:
    """Yield the indices where a mask is true, if any; all indices as a slice, which avoids a copy."""
    if mask.all() and mask.size:
        yield slice(None)
    elif mask.any():
        yield np.flatnonzero(mask)
