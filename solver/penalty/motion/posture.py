"""Posture: joints turn no more than they need to, against the overshoot of long segments.

Acceleration alone swings a joint far out between keyframes that are a second apart; people come back to a posture in a
fraction of that. Squared angular velocity beside squared acceleration is a spline in tension: it feels like the former
over segments longer than 2π times the ratio of the two, and like the latter over shorter ones.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at, cross, vector_product
from ...figure.figure import Figure, JointKind
from ...figure.kinematics import Samples
from ..curvature import Curvature, jacobian
from ..penalty import Penalty, Scale

SETTLING = 0.3  # [s] unless told


@dataclass(frozen=True)
class Posture(Penalty):
    """Σ over ball joints of |ω − ω_parent|²/4 and over hinges of θ'²/4 [rad²/s²/4].

    settling  [s] a joint's acceleration and its velocity over so long count alike
    """

    settling: float = SETTLING

    @property
    def name(self) -> str:
        return "posture"

    @property
    def scale(self) -> Scale:
        return Scale(self.settling**2, time_power=2, beside="covariant")

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        child, parent = _joints(samples.figure)
        hinges = samples.figure.tables.hinge_columns
        values = 0.25 * np.sum(samples.y_d[:, hinges] ** 2, axis=1)
        omega = samples.links.omega
        relative = omega[:, child] - omega[:, parent]
        if into is not None:
            by_omega = (0.5 * scale) * relative
            buffer = into.buffer("omega")
            add_at(buffer, child, by_omega)
            add_at(buffer, parent, -by_omega)
            into.buffer("y_d")[:, hinges] += 0.5 * np.reshape(scale, (-1, 1)) * samples.y_d[:, hinges]
        return values + 0.25 * np.einsum("kns,kns->s", relative, relative)

    def curvature(self, samples: Samples, into: Curvature, scale: Array) -> None:
        figure = samples.figure
        into.add_squares(figure.tables.hinge_columns, 1, 0.25 * scale)
        child, parent = _joints(figure)
        if not child.size:
            return
        if not figure.is_world:
            _add_by_adjoint(samples, into, 0.25 * scale)
            return
        links = samples.links
        by_rate = vector_product(links.Q) * links.scale
        by_q = vector_product(links.Q_d) * links.scale - links.rates[0] * by_rate
        for k in range(4):
            by_q[:, k] -= cross(links.omega, by_rate[:, k])
        rows = np.zeros((samples.count, child.size, 3, 3, 8))
        for order, part in enumerate((by_q, by_rate)):
            rows[:, :, :, order, :4] = part[:, :, child].transpose(3, 2, 0, 1)
            rows[:, :, :, order, 4:] = -part[:, :, parent].transpose(3, 2, 0, 1)
        for some, columns in apart(figure, tuple(child.tolist())):
            into.add_blocks(columns, rows[:, some, ..., : columns.shape[1]], 0.25 * scale)


@lru_cache(maxsize=8)
def _joints(figure: Figure) -> tuple[Index, Index]:
    """The links of the ball joints and those they hang on, (n,) each."""
    child = np.array([i for i, link in enumerate(figure.links) if i and link.kind is JointKind.BALL], np.intp)
    return child, figure.tables.parents[child]


@lru_cache(maxsize=8)
def apart(figure: Figure, child: tuple[int, ...]) -> list[tuple[Index, Index]]:
    """Joints of these links in groups that share no link, each with the columns of its children and parents, (g, 8);
    of those that hang on the world, of its children alone, (g, 4)."""
    tables = figure.tables
    place = {int(link): tables.quaternion_columns[:, i] for i, link in enumerate(tables.quaternion_links)}
    parents = [int(tables.parents[c]) for c in child]
    pairs = [[c, p] if p in place else [c] for c, p in zip(child, parents, strict=True)]
    groups: list[tuple[list[int], set[int]]] = []
    for i, pair in enumerate(pairs):
        fitting = (g for g in groups if not g[1] & set(pair) and len(pairs[g[0][0]]) == len(pair))
        group = next(fitting, None)
        if group is None:
            groups.append(group := ([], set()))
        group[0].append(i)
        group[1].update(pair)
    columns = [np.concatenate([place[link] for link in pair]) for pair in pairs]
    return [(np.array(some), np.array([columns[i] for i in some])) for some, _ in groups]


def _add_by_adjoint(samples: Samples, into: Curvature, scale: Array) -> None:
    """The rows of joint coordinates, by the adjoint sweep."""
    child, parent = _joints(samples.figure)
    at = np.repeat(np.arange(samples.count), 3 * child.size)
    joint, direction = np.tile(np.repeat(np.arange(child.size), 3), samples.count), np.tile(np.arange(3), at.size // 3)

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        buffer, here = cotangent.buffer("omega"), np.arange(rows.size)
        buffer[direction[rows], child[joint[rows]], here] += 1
        buffer[direction[rows], parent[joint[rows]], here] -= 1

    into.add_rows(at, scale[at], jacobian(samples, at, seeded)[:, :2], (0, 1))
