"""Cycle: deviation of joints from the clip's gait cycle, weighted by the certainty of the cycle.

Keyframes half a period apart contain little information on the motion between them, but together they determine it (see
`gait`). The certainty is lowest at phases without a keyframe.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...array import Array, Index
from ...contacts.gait import GaitCycle
from ...curve.frame import Frame, Timeline
from ...curve.spline import path_of
from ...figure.adjoint import Cotangent
from ...figure.algebra import add_at, conjugate, cross, dot, hamilton, rotate, vector_product
from ...figure.figure import Figure, independent_joints
from ...figure.kinematics import Samples
from ...tolerances import ROUNDING
from ..block import Block, Dense, every
from ..curvature import Curvature
from ..penalty import Guide, Normalization, Role

FRAMES = 8  # variable frames per period that a path needs to follow a cycle
LITTLE = np.radians(5)  # [rad] small deviation of one joint, for the normalization


@dataclass(frozen=True, eq=False)
class Cycle(Guide):
    """The squared deviation from the gait cycle [rad²], times its certainty `trust`.

    It is the sum of 4 sin²(θ/2) over ball joints and the root, with the angle θ to the cycle's rotation, of squared
    angles over hinges, and of (5 rad/m · deviation of the root's height)².
    """

    figure: Figure
    gait_cycle: GaitCycle

    name = "cycle"
    role = Role.TARGET
    normalization = Normalization(LITTLE**2)

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        figure = samples.figure
        target, trust = self._at(samples.t)
        columns, rates = self._columns
        straight = samples.y[:, columns] - target[:, self._turns :]
        yield every(samples, columns, 0, straight, trust[:, None] * rates**2)
        child = figure.tables.quaternion_links
        parent = figure.tables.parents[child]
        if not child.size:
            return
        (w, v), root = self._deviations(samples, target), np.sqrt(trust)
        rotation = samples.links.rotation[:, :, child]

        def pulled_back(into: Cotangent, bar: Array) -> None:
            bar = root * bar.reshape(v.shape)
            turn = rotate(rotation, w * bar + cross(bar, v))
            buffer = into.buffer("turn")
            add_at(buffer, child, turn)
            add_at(buffer, parent, -turn)

        def curved(into: Curvature, scale: Array) -> None:
            links = samples.links
            moved = _derivative(w, v, rotation)
            by_q = vector_product(links.Q) * links.scale
            rows = np.zeros((samples.count, child.size, 3, 3, 8))
            rows[:, :, :, 0, :4] = np.einsum("ijns,jkns->snik", moved, by_q[:, :, child])
            rows[:, :, :, 0, 4:] = -np.einsum("ijns,jkns->snik", moved, by_q[:, :, parent])
            for group, blocks in independent_joints(figure, tuple(child.tolist())):
                into.add_blocks(blocks, rows[:, group, ..., : blocks.shape[1]], scale * trust)

        yield Dense((2 * root * v).reshape(-1, samples.count), pulled_back, curved if figure.is_world else None)

    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """Return the timeline with variable frames on the cycle, eight per period if `most` permits it."""
        ends = timeline.times[[0, -1]]
        fixed = [frame for frame in timeline.frames if not frame.is_variable or frame.time in ends]
        edges, spacing = np.array([frame.time for frame in fixed]), self.gait_cycle.period / FRAMES
        counts = np.ceil(np.diff(edges) / spacing - ROUNDING).astype(int) - 1
        present = np.histogram(timeline.times, edges)[0] - 1
        present[-1] -= 1  # the last bin includes both its edges
        counts = np.maximum(counts, present)
        if most is not None and counts.sum() > most:
            counts = present
        segments = zip(edges[:-1], edges[1:], counts, strict=True)
        times = np.concatenate([np.linspace(first, last, count + 2)[1:-1] for first, last, count in segments])
        states = self._states(path_of(timeline).at(times), times)
        frames = [*fixed, *(Frame.variable(t, state) for t, state in zip(times, states, strict=True))]
        return Timeline(tuple(sorted(frames, key=lambda frame: frame.time)), timeline.end_slope, timeline.ends)

    def _states(self, plain: Array, times: Array) -> Array:
        """Return the cycle's states at times (T,) [s], with unknown entries as in `plain` (T, N)."""
        pose_map, qpos = self.gait_cycle.poses.map, self.figure.to_qpos(plain)
        target = self._at(times)[0]
        qpos[:, pose_map.columns.T] = target[:, : self._turns].reshape(times.size, pose_map.links.size, 4)
        qpos[:, self._columns[0]] = target[:, self._turns :]
        states = self.figure.to_state_near(qpos, plain)
        return np.where(self._covers(times)[:, None], states, plain)

    @property
    def _turns(self) -> int:
        return 4 * self.gait_cycle.rotations.shape[1]

    @cached_property
    def _columns(self) -> tuple[Index, Array]:
        """The state's columns of hinges and the root's height, and their weights [1, rad/m]."""
        pose_map = self.gait_cycle.poses.map
        columns = np.concatenate([pose_map.hinges, pose_map.heights])
        return columns, np.repeat([1.0, pose_map.up], [pose_map.hinges.size, pose_map.heights.size])

    @cached_property
    def _table(self) -> Array:
        """The gait cycle at its times: quaternions, angles, heights, trust, (T, 4 q + h + f + 1)."""
        gait_cycle = self.gait_cycle
        turns = gait_cycle.rotations.reshape(gait_cycle.times.size, -1)
        return np.hstack([turns, gait_cycle.angles, gait_cycle.heights, gait_cycle.trust[:, None]])

    def _at(self, t: Array) -> tuple[Array, Array]:
        """Return the target (S, 4 q + h + f), quaternions not normalised, and its trust (S,), 0 outside the cycle."""
        times = self.gait_cycle.times
        place = (np.clip(t, times[0], times[-1]) - times[0]) / (times[1] - times[0])
        before = np.minimum(place.astype(np.intp), times.size - 2)
        share = (place - before)[:, None]
        rows = (1 - share) * self._table[before] + share * self._table[before + 1]
        return rows[:, :-1], np.where(self._covers(t), rows[:, -1], 0.0)

    def _covers(self, t: Array) -> NDArray[np.bool_]:
        """Return whether the gait cycle covers times t [s], (S,)."""
        return (t >= self.gait_cycle.times[0]) & (t <= self.gait_cycle.times[-1])

    def _deviations(self, samples: Samples, target: Array) -> tuple[Array, Array]:
        """Return the unit quaternions from the target to the joints' rotations: w (n, S) and v (3, n, S)."""
        links, tables = samples.links, samples.figure.tables
        child = tables.quaternion_links
        parent = tables.parents[child]
        wanted = target[:, : self._turns].reshape(samples.count, -1, 4).T
        base = links.Q[:, parent]
        if tables.has_turns:  # the rotation of a free joint is in the world, whatever its orientation at rest
            turn = tables.turn.copy()
            turn[:, tables.free_links] = [[1.0], [0], [0], [0]]
            base = hamilton(base, turn[:, child][:, :, None])
        q = hamilton(conjugate(hamilton(base, wanted)), links.Q[:, child])
        q /= np.sqrt(dot(q, q))
        return q[0], q[1:]


def _derivative(w: Array, v: Array, rotation: Array) -> Array:
    """Return the derivative of 2 v by a small rotation of the link in the world, (w + [v]×) Rᵀ, (3, 3, n, S)."""
    rows = rotation.swapaxes(0, 1)
    out = w * rows
    for k in range(3):
        out[:, k] += cross(v, rows[:, k])
    return out
