"""Posture: velocity of joints and roots, against overshoot in long segments.

Minimum acceleration swings a joint far out between keyframes a second apart, while people return to a posture in a
fraction of that time. Squared velocity and squared acceleration together define a spline in tension. Velocity dominates
over segments longer than 2π times `settling`, acceleration over shorter ones.

Hips and knees place a foot, so their velocity costs least. Trunk, arms and ankles keep their posture more closely in
captured motion, except next to an end at rest, where they would start or stop with a jerk. A root carries the whole
body, so its velocity costs most. Otherwise a person would lift a foot by leaning to one side, or lean back before a
step. The mean velocity between two keyframes is subtracted, as no motion through them avoids it. The joints of a leg
that takes a step are exempt: they have to leave their posture to lift the foot. If they were not, the other foot would
rise on its toes and the pelvis would tilt instead.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask, segments_at
from ...contacts.stances import Steps
from ...curve.frame import Timeline
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at, cross, vector_product
from ...figure.dynamics import Size
from ...figure.figure import Figure, JointKind, independent_joints
from ...figure.kinematics import Samples
from ...figure.wrenches import Wrenches, every_axis
from ..block import Block, Dense, every
from ..curvature import Curvature
from ..penalty import Normalization, Penalty

# cost of squared velocities, relative to those of a joint that places a foot: of other joints [1], of a root's angular
# velocity [1], and of its horizontal velocity [rad²/m²]; a person who takes a step leans by a few degrees
KEEP, TURN, SHIFT = 4.0, 12.0, 2.0


@dataclass(frozen=True, eq=False)
class Between:
    """What keyframes imply about the velocities between them.

    Attributes:
        times: The times of the keyframes, (K,) [s].
        turning: The mean angular velocities of r roots from one keyframe to the next, (3, r, K − 1) [rad/s].
        across: Their mean horizontal velocities, (2, r, K − 1) [m/s].
        steps: The legs that take a step.
        moving: Whether the figure also moves at both ends of each segment between keyframes, (K − 1,).
    """

    times: Array
    turning: Array
    across: Array
    steps: Steps
    moving: Mask

    @classmethod
    def of(cls, figure: Figure, keys: Timeline, steps: Steps) -> Between:
        """Return the mean velocities between the keyframes of a timeline, together with `steps`."""
        qpos, spans = figure.to_qpos(keys.states), np.diff(keys.times)
        first = [figure.links[root].qpos for root in _roots(figure)]
        rotations = np.array([qpos[:, k + 3 : k + 7] for k in first]).reshape(-1, len(qpos), 4)
        turns = quat.rotation_vector(quat.product(rotations[:, 1:], quat.inverse(rotations[:, :-1])))
        across = np.array([np.diff(qpos[:, k : k + 2], axis=0) for k in first]).reshape(-1, spans.size, 2)
        moving = np.ones(spans.size, bool)
        moving[[0, -1]] &= ~np.array(keys.at_rest)
        return cls(keys.times, turns.transpose(2, 0, 1) / spans, across.transpose(2, 0, 1) / spans, steps, moving)

    def at(self, t: Array) -> tuple[Array, Array]:
        """Return the mean velocities at times t (S,) [s], (3, r, S) and (2, r, S)."""
        span = segments_at(self.times, t)
        return self.turning[:, :, span], self.across[:, :, span]


@dataclass(frozen=True)
class Posture(Penalty):
    """Σ over ball joints of c |ω − ω_parent|², over hinges of c θ'², and over roots of 3 |ω|² + v²/2 [rad²/s²].

    ω is a link's angular velocity, θ' a hinge's, and v a root's horizontal velocity, in m/s on a figure of an adult's
    size. c is 1 for joints that do not place a foot, in segments between moving keyframes, and 1/4 otherwise. The
    velocities of roots are relative to their means between keyframes. Roots are links with a free joint that carry
    other links. Joints of legs that take a step are exempt.

    Attributes:
        settling: The time over which a joint's velocity costs as much as its acceleration [s].
        between: The mean velocities of roots and the steps of legs; None: means of zero, c = 1/4.
    """

    settling: float = 0.3
    between: Between | None = None

    name = "posture"

    @property
    def normalization(self) -> Normalization:
        return Normalization(self.settling**2, time_power=2, normalize_by="acceleration.angular", by_tension=0.5)

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        figure = samples.figure
        hinges = figure.tables.hinge_columns
        yield every(samples, hinges, 1, weight=self._costs(figure.tables.hinge_links, samples.t).T)
        yield from _of_roots(samples, self.between)
        child, parent = _joints(figure)
        if not child.size:
            return
        omega, share = samples.links.omega, np.sqrt(self._costs(child, samples.t))
        value = share * (omega[:, child] - omega[:, parent])

        def pulled_back(into: Cotangent, bar: Array) -> None:
            by_omega = share * bar.reshape(value.shape)
            buffer = into.buffer("omega")
            add_at(buffer, child, by_omega)
            add_at(buffer, parent, -by_omega)

        curved = partial(_add_curvature, samples, share) if figure.is_world else None
        yield Dense(value.reshape(-1, samples.count), pulled_back, curved)

    def _costs(self, links: Index, t: Array) -> Array:
        """Return the factors c of the squared velocities of links' joints (l,) at times t (S,) [s], (l, S)."""
        costs = np.full((links.size, t.size), 0.25)
        if self.between is not None:
            steps, moving = self.between.steps, self.between.moving[segments_at(self.between.times, t)]
            costs[np.ix_(~steps.placing[links], moving)] *= KEEP
            costs[steps.at(links, t)] = 0.0
        return costs


def _of_roots(samples: Samples, between: Between | None) -> Iterator[Block]:
    roots = _roots(samples.figure)
    if not roots.size:
        return
    position = np.array([samples.figure.links[root].qpos for root in roots])
    columns = (position + np.arange(2)[:, None]).ravel()
    turning, across = samples.links.omega[:, roots], samples.y_d[:, columns].T
    if between is not None:
        mean_turning, mean_across = between.at(samples.t)
        turning, across = turning - mean_turning, across - mean_across.reshape(across.shape)
    at, link, axis = every_axis(roots, samples.count)
    yield Block(at, turning.ravel(), (Wrenches(at, link, torque_d=axis),), weight=0.25 * TURN)
    yield every(samples, columns, 1, across.T, weight=0.25 * SHIFT / Size.of(samples.figure).length ** 2)


@lru_cache(maxsize=8)
def _roots(figure: Figure) -> Index:
    """Return the links with a free joint that carry other links, (r,)."""
    tables = figure.tables
    return tables.free_links[tables.children[tables.free_links] > 0]


def _add_curvature(samples: Samples, share: Array, into: Curvature, scale: Array) -> None:
    """Add the curvature of joints whose links' orientations are in the state: rows of eight columns each.

    Args:
        share: The factors of the joints' relative angular velocities, (joints, S).
    """
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
    rows *= share.T[:, :, None, None, None]
    for group, columns in independent_joints(figure, tuple(child.tolist())):
        into.add_blocks(columns, rows[:, group, ..., : columns.shape[1]], scale)


@lru_cache(maxsize=8)
def _joints(figure: Figure) -> tuple[Index, Index]:
    child = np.array([i for i, link in enumerate(figure.links) if i and link.kind is JointKind.BALL], np.intp)
    return child, figure.tables.parents[child]
