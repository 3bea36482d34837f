"""Posture: angular velocity of joints, against overshoot in long segments.

Minimum acceleration swings a joint far out between keyframes a second apart, while people return to a posture in a
fraction of that time. Squared velocity and squared acceleration together define a spline in tension. Velocity dominates
over segments longer than 2π times `settling`, acceleration over shorter ones.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from ...array import Array, Index
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at, cross, vector_product
from ...figure.figure import Figure, JointKind
from ...figure.kinematics import Samples
from ..block import Block, Dense, every
from ..curvature import Curvature
from ..penalty import Normalization, Penalty, Role

SETTLING = 0.3  # [s] default of `settling`


@dataclass(frozen=True)
class Posture(Penalty):
    """Σ over ball joints of |ω − ω_parent|²/4 and over hinges of θ'²/4 [rad²/s²/4].

    Attributes:
        settling: The time over which a joint's velocity costs as much as its acceleration [s].
    """

    settling: float = SETTLING

    name = "posture"
    role = Role.SMOOTHNESS

    @property
    def normalization(self) -> Normalization:
        return Normalization(self.settling**2, time_power=2, normalize_by="acceleration.angular", by_tension=0.5)

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        figure = samples.figure
        yield every(samples, figure.tables.hinge_columns, 1, weight=0.25)
        child, parent = _joints(figure)
        if not child.size:
            return
        omega = samples.links.omega
        value = 0.5 * (omega[:, child] - omega[:, parent])

        def pulled_back(into: Cotangent, bar: Array) -> None:
            by_omega = 0.5 * bar.reshape(value.shape)
            buffer = into.buffer("omega")
            add_at(buffer, child, by_omega)
            add_at(buffer, parent, -by_omega)

        curved = partial(_curved, samples) if figure.is_world else None
        yield Dense(value.reshape(-1, samples.count), pulled_back, curved)


def _curved(samples: Samples, into: Curvature, scale: Array) -> None:
    """Add the curvature of joints whose links' orientations are in the state: rows of eight columns each."""
    figure, links = samples.figure, samples.links
    child, parent = _joints(figure)
    by_rate = vector_product(links.Q) * links.scale
    by_q = vector_product(links.Q_d) * links.scale - links.rates[0] * by_rate
    for k in range(4):
        by_q[:, k] -= cross(links.omega, by_rate[:, k])
    rows = np.zeros((samples.count, child.size, 3, 3, 8))
    for order, part in enumerate((by_q, by_rate)):
        rows[:, :, :, order, :4] = part[:, :, child].transpose(3, 2, 0, 1)
        rows[:, :, :, order, 4:] = -part[:, :, parent].transpose(3, 2, 0, 1)
    for group, columns in independent_joints(figure, tuple(child.tolist())):
        into.add_blocks(columns, rows[:, group, ..., : columns.shape[1]], 0.25 * scale)


@lru_cache(maxsize=8)
def _joints(figure: Figure) -> tuple[Index, Index]:
    child = np.array([i for i, link in enumerate(figure.links) if i and link.kind is JointKind.BALL], np.intp)
    return child, figure.tables.parents[child]


@lru_cache(maxsize=8)
def independent_joints(figure: Figure, child: tuple[int, ...]) -> list[tuple[Index, Index]]:
    """Return joints in groups that share no link, each with its columns (g, 8): those of the children and of the
    parents.

    Joints without a parent in the state form separate groups with the columns of the children only, (g, 4).
    """
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
    return [(np.array(members), np.array([columns[i] for i in members])) for members, _ in groups]
