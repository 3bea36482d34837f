"""Tracking of a recorded motion. Not in the paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...array import Array, Index
from ...curve.frame import Frame, Timeline
from ...curve.quadrature import gauss_nodes
from ...curve.recording import Track
from ...curve.spline import Path, natural_spline
from ...figure.figure import Figure, JointKind, quaternion_columns
from ...figure.kinematics import Samples
from ...figure.wrenches import every_axis, of_point
from ..block import Block, every
from ..penalty import Guide, Normalization, Role

AWAY, FOR = 0.03, 0.3  # deviation [m] of a limb's end by one joint, and its duration [s], that together cost 1
STRAYS, BACK = 0.01, 0.1  # standard deviation [m] and correlation time [s] of a recording's position errors
MENDED = 3.0  # [1/s³], [m²/s³] minimum liveliness, which permits corrections of calm recordings
EASED = 0.01  # [1] factor on the weight of poses at a keyframe that edits the recording
COARSE, FINEST = 0.2, 1 / 60  # [s] maximum and minimum spacing of frames that track a recording
REMEMBERED = 20_000  # cached samples, each 3 kB for a human figure; a search evaluates the same times repeatedly
SHORTEST = 0.05  # [m] minimum length of a limb


class _Target(NamedTuple):
    """The recording at times t, with weights.

    Attributes:
        t: The times, (S,) [s].
        motion: y, y', y'', (3, S, N).
        weights: The weights of their squared differences, (3, S, N).
        ends: The positions of limbs' ends, (3, n, S) [m].
        end_weight: The weights of their squared distances, (S,).
    """

    t: Array
    motion: Array
    weights: Array
    ends: Array
    end_weight: Array


@dataclass(frozen=True, eq=False)
class TrackingPenalty(Guide):
    """Squared differences from a recorded motion ŷ.

    The sum is Σ over the state's entries of w₀ (y − ŷ)² + w₁ (y' − ŷ')² + w₂ (y'' − ŷ'')², and squared distances of
    limbs' ends from their recorded positions.

    Attributes:
        edits: (time, width) [s] of edits. Near these times poses have less weight, velocities and accelerations do not.
    """

    recorded: Track
    edits: tuple[tuple[float, float], ...] = ()
    _targets: dict[tuple[float, float, int], _Target] = field(default_factory=dict)

    name = "near"
    role = Role.TARGET
    normalization = Normalization(1.0)

    @property
    def expected(self) -> Path:
        return self.recorded.path

    def residuals(self, samples: Samples) -> Iterator[Block]:
        off, weights = self._deviations(samples)
        columns = np.arange(samples.y.shape[1])
        for order in range(3):
            yield every(samples, columns, order, off[order], weights[order])
        links, positions = self.ends
        places, arms = samples.links.points(links, positions)
        target = self._at(samples.t)
        at, link, axes = every_axis(links, samples.count)
        moved = of_point(at, link, np.tile(arms.reshape(3, -1), 3), axes)
        yield Block(at, (places - target.ends).ravel(), (moved,), target.end_weight[at])

    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """Return the timeline with variable frames at the recorded states."""
        states = self.recorded.path.at(timeline.times)
        same = self._same(timeline.states, states)
        frames = [
            Frame.variable(f.time, np.where(is_free, s, -s)) if f.is_variable else f
            for f, s, is_free in zip(timeline.frames, states, same, strict=True)
        ]
        return Timeline(tuple(frames), timeline.end_slope, timeline.ends)

    def times(self, detail: float = 30.0) -> Array:
        """Return the times of few frames (M,) [s] whose spline contains the detail of the recording.

        Args:
            detail: The cost f of a segment up to which its lost detail is acceptable [1].
        """
        rec = self.recorded
        first, last = rec.path.span
        times = np.linspace(first, last, max(2, round((last - first) / COARSE) + 1))
        times = np.sort(np.append(times, [first + FINEST, last - FINEST])) if last - first > 4 * FINEST else times
        while True:
            path = natural_spline(times, rec.path.at(times))
            t, w = gauss_nodes(times)
            lost = w * self.evaluate(Samples(rec.figure, *path.motion(t), t=t))
            split = (lost.reshape(times.size - 1, -1).sum(axis=1) > detail) & (np.diff(times) > 2 * FINEST)
            if not split.any():
                return times
            times = np.sort(np.append(times, 0.5 * (times[:-1] + times[1:])[split]))

    def _same(self, y: Array, states: Array) -> Array:
        """Return False for entries of quaternions on opposite hemispheres, else True, (S, N)."""
        same = np.ones(y.shape, bool)
        for columns in self.recorded.figure.tables.quaternion_columns.T:
            same[:, columns] = np.sum(y[:, columns] * states[:, columns], axis=1, keepdims=True) >= 0
        return same

    def _deviations(self, samples: Samples) -> tuple[Array, Array]:
        """Return the differences of y, y', y'' from the recording, and the weights of their squares, (3, S, N) each."""
        target = self._at(samples.t)
        motion = np.where(self._same(samples.y, target.motion[0]), target.motion, -target.motion)
        return np.stack([samples.y, samples.y_d, samples.y_dd]) - motion, target.weights

    @cached_property
    def ends(self) -> tuple[Index, Array]:
        """The links that end limbs (n,), and their centres of mass (3, n)."""
        figure = self.recorded.figure
        ends = np.array([limb[0] for limb in figure.limbs], np.intp)
        return ends, figure.tables.centre[:, ends]

    @cached_property
    def _pose(self) -> Array:
        """The weights of squared pose differences (N,), from the noise and from differences between the skeletons."""
        rec = self.recorded
        off = np.full(rec.figure.width, AWAY**2 * FOR)
        for lever, link in zip(levers(rec.figure), rec.figure.links[1:], strict=True):
            columns = quaternion_columns(link)
            if columns is not None:
                off[columns] *= 0.25 / lever**2
            elif link.kind is JointKind.HINGE:
                off[link.qpos] /= lever**2
        pose = 1 / (rec.noise**2 / rec.rate + off)
        pose[rec.figure.tables.position_columns] = 1 / (2 * STRAYS**2 * BACK)
        return pose

    def _pose_factors(self, t: Array) -> Array:
        """Return the factors on the weights of poses at times t, less near edits, (S,)."""
        out = np.ones(t.size)
        for time, width in self.edits:
            away = np.minimum(np.abs(t - time) / width, 1)
            out = np.minimum(out, EASED + (1 - EASED) * away**2 * (3 - 2 * away))
        return out

    def _at(self, t: Array) -> _Target:
        """Return the recording at times t (S,), cached."""
        key = (float(t[0]), float(t[-1]), t.size)
        cached = self._targets.get(key)
        if cached is not None and np.array_equal(cached.t, t):
            return cached
        rec, weight = self.recorded, self._pose_factors(t)
        trust = np.stack([np.interp(t, rec.times, column) for column in rec.trust.T], axis=1)
        weights = np.empty((3, t.size, rec.figure.width))
        weights[0] = self._pose * trust * weight[:, None]
        weights[1] = np.where(rec.is_place, trust * BACK / (2 * STRAYS**2), 0)
        weights[2] = 1 / np.maximum(rec.liveliness, MENDED)
        motion = rec.path.motion(np.clip(t, *rec.path.span))
        ends, _ = Samples(rec.figure, *motion).links.points(*self.ends)
        whole = np.interp(t, rec.times, rec.trust.min(axis=1))
        if sum(target.t.size for target in self._targets.values()) > REMEMBERED:
            self._targets.clear()
        self._targets[key] = _Target(t, motion, weights, ends, whole * weight / (2 * STRAYS**2 * BACK))
        return self._targets[key]


def levers(figure: Figure) -> Array:
    """Return the distance of every joint from the farthest end of a limb beyond it, at rest, (L − 1,) [m]."""
    rest = figure.to_state(np.asarray(figure.model.qpos0))[None]
    motion, links = Samples.still(figure, rest).links, figure.links
    anchors = np.array([link.anchor for link in links]).T
    ends = 2 * np.array([link.centre for link in links]).T - anchors
    joints, tips = (motion.points(np.arange(len(links)), part)[0][:, :, 0] for part in (anchors, ends))
    apart = np.linalg.norm(tips[:, :, None] - joints[:, None, :], axis=0)
    beyond = np.asarray(figure.tables.path, bool)
    return np.maximum(np.where(beyond, apart, 0).max(axis=0)[1:], SHORTEST)
