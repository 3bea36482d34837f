"""The walking or running cycle of a clip's keyframes, as a Gaussian process of its poses.

The poses (see `pose_vectors`) have a periodic part, which is its left-right mirror image half a period later, and a
smooth part for the rest. Nothing is learned from other clips. The likelihood of the keyframes measures how well a
period explains them. Several periods may explain sparse keyframes about equally (aliasing).

Then the size of the body and the feet decide: in the true cycle, a low foot stands on the ground while the body
travels; in an alias it slides as fast as the body. Dynamically similar animals and people have strides of
2.3 Fr^0.3 hip heights, with the Froude number Fr = v²/(g h) (R. McN. Alexander 1976).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from .. import quaternion as quat
from ..array import Array
from ..curve.frame import Timeline
from ..curve.spline import natural_end_slopes, path_of
from ..figure.dynamics import STANDARD_GRAVITY
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from .keyframe_points import KeyframePoints
from .pose_vectors import PoseVectors
from .thresholds import Thresholds

QUARTER = 0.25  # least fraction of the spline's variance about the cycle that counts as the spline's error
SURE = 0.03  # [rad] negligible standard deviation
STRIDE, POWER = 2.3, 0.3  # factor and exponent of Alexander's relation
SHORTER, LONGER = 0.65, 1.6  # range of plausible periods, relative to Alexander's
FINENESS = 0.02  # initial spacing of the tried periods, relative to the period
LEFT_OUT = ((0, 0), (1, 0), (0, 1), (1, 1))  # numbers of first and last keyframes that are tried outside the cycle
OUTSIDE = 0.2  # least increase of the gain for each keyframe left out
FEWEST, MOST = 3, 100  # numbers of complete keyframes for which a cycle is inferred
CYCLES = 0.8  # least number of cycles in a clip
SLIP = 0.33  # largest slip of a cycle, see `GaitCycle`
TRUST = 0.4  # least mean trust of a gait cycle over the clip
LOWEST = 0.25  # fraction of the keyframes with the lowest soles, which stand


@dataclass(frozen=True, eq=False)
class GaitCycle:
    """A clip's cycle: its period, the confidence in it, and its poses between keyframes.

    period     [s]
    gain       log-likelihood minus that of the best smooth motion, per number given by the keyframes
    slip       mean speed of the slowest low sole point, relative to the travel speed; NaN if not computed
    times      (T,) [s] evenly spaced
    rotations  (T, q, 4) of links with quaternions, as in qpos, sign-continuous
    angles     (T, h) [rad] of the hinges
    heights    (T, f) [m] of the free root
    trust      (T,) ratio of the spline's variance about the cycle to the cycle's variance
    """

    poses: PoseVectors
    period: float
    gain: float
    slip: float
    times: Array
    rotations: Array
    angles: Array
    heights: Array
    trust: Array

    @classmethod
    def of(cls, poses: PoseVectors, period: float, times: Array, plain: Array) -> GaitCycle:
        """Return the cycle with a period [s] at times (T,) [s]; `plain` (T, nq) is the spline through the keyframes."""
        vectors, variance = poses.predict(period, times)
        rotations = quat.align_signs(poses.map.rotations(vectors, times))
        unlike = float(np.mean((poses.map.vectors(poses.map.off_heading(plain, times)) - vectors) ** 2))
        trust = max(unlike - float(variance.mean()), QUARTER * unlike) / (variance + SURE**2)
        gain = poses.gain(period)
        return cls(poses, period, gain, float("nan"), times, rotations, *poses.map.numbers(vectors), trust)

    def mean_trust(self, times: Array) -> Array:
        """Return the mean trust between K times, (K − 1,); 0 outside of the cycle."""
        at = np.linspace(times[:-1], times[1:], 9)[1:-1]
        return np.interp(at, self.times, self.trust, left=0, right=0).mean(axis=0)

    def qpos(self, width: int) -> Array:
        """Return configurations (T, width) with the root at the origin, except for its height."""
        out = np.zeros((self.times.size, width))
        columns = self.poses.map
        out[:, columns.columns.T] = self.rotations
        out[:, columns.hinges], out[:, columns.heights] = self.angles, self.heights
        return out


@dataclass(frozen=True, eq=False)
class Gait:
    """A figure that travels over surfaces, given by the points of its soles at keyframes."""

    soles: KeyframePoints

    @property
    def figure(self) -> Figure:
        return self.soles.figure

    @property
    def keys(self) -> Timeline:
        return self.soles.keys

    @property
    def limits(self) -> Thresholds:
        return self.soles.limits

    def infer(self) -> GaitCycle | None:
        """Return the cycle of the keyframes if it is unambiguous.

        The first and the last keyframe may be outside it, such as a standing pose before a walk, if the likelihood of
        the others is much higher without them.
        """
        if self.keys.ends == "periodic":
            return None
        best, gain = None, -np.inf
        for left_out in LEFT_OUT:
            outside = sum(left_out)
            if outside and len(self.keys.frames) - outside <= FEWEST:
                continue
            gait_cycle = self._without(*left_out)._cycle_of_all
            if gait_cycle is not None and gait_cycle.gain - OUTSIDE * outside > gain:
                best, gain = gait_cycle, gait_cycle.gain - OUTSIDE * outside
        return best

    @property
    def _periods(self) -> tuple[float, float]:
        """The bounds of the period of a cycle [s]."""
        return SHORTER * self.usual_period, LONGER * self.usual_period

    def _without(self, first: int, last: int) -> Gait:
        """Return the gait without some of the first and the last keyframes."""
        if not first + last:
            return self
        frames = self.keys.frames[first : len(self.keys.frames) - last]
        ends = natural_end_slopes(np.array([f.time for f in frames]), np.array([f.state for f in frames]))
        return Gait(KeyframePoints.of(self.figure, Timeline(frames, ends), self.soles.points, self.soles.surfaces))

    @property
    def _cycle_of_all(self) -> GaitCycle | None:
        if not (self._may_walk and self._is_level):
            return None
        poses = PoseVectors.of(self.figure, self.keys)
        if poses is None or not FEWEST <= poses.times.size <= MOST:
            return None
        shortest, longest = self._periods
        longest = min(longest, poses.sides / 2 * (poses.times[-1] - poses.times[0]) / CYCLES)
        cycles = self.candidates(poses, (shortest, longest))
        sure = [gait_cycle for gait_cycle in cycles if gait_cycle.slip <= SLIP]
        best = max(sure, key=lambda gait_cycle: gait_cycle.gain, default=None)
        return None if best is None or best.trust.mean() < TRUST else best

    def likeliest(self) -> GaitCycle | None:
        """Return the likeliest cycle of the keyframes, without a threshold; None for too few keyframes."""
        poses = PoseVectors.of(self.figure, self.keys)
        if poses is None:
            return None
        between = self._periods if self._may_walk else self.limits.any_period
        cycles = self.candidates(poses, between)
        return min(cycles, key=lambda gait_cycle: (gait_cycle.slip > SLIP, -gait_cycle.gain), default=None)

    def with_period(self, period: float) -> GaitCycle | None:
        """Return the cycle with a period [s]; None for too few complete keyframes."""
        poses = PoseVectors.of(self.figure, self.keys)
        return None if poses is None else self._rhythm(poses, period)

    def candidates(self, poses: PoseVectors, between: tuple[float, float]) -> list[GaitCycle]:
        """Return the cycles at periods `between` [s] where the gain peaks, the likeliest first."""
        if between[0] >= between[1]:
            return []
        count = max(3, int(np.ceil(np.log(between[1] / between[0]) / FINENESS)) + 1)
        tried = np.geomspace(*between, count)
        gain = np.array([poses.gain(float(period)) for period in tried])
        padded = np.concatenate([[-np.inf], gain, [-np.inf]])
        peaks = np.flatnonzero((gain >= padded[:-2]) & (gain > padded[2:]))
        return [self._rhythm(poses, _refine(poses, tried, gain, i)) for i in peaks[np.argsort(-gain[peaks])].tolist()]

    def _rhythm(self, poses: PoseVectors, period: float) -> GaitCycle:
        gait_cycle = GaitCycle.of(poses, period, *self._plain)
        return replace(gait_cycle, slip=self.slip(gait_cycle)) if self._may_walk else gait_cycle

    @cached_property
    def _plain(self) -> tuple[Array, Array]:
        """Times (T,) [s], and the configurations (T, nq) of the spline through the keyframes."""
        first, last = float(self.keys.times[0]), float(self.keys.times[-1])
        times = np.linspace(first, last, max(2, int(np.ceil((last - first) / self.limits.lift_off)) + 1))
        return times, self.figure.to_qpos(path_of(self.keys).at(times))

    @cached_property
    def _may_walk(self) -> bool:
        """Whether the figure has feet, ground and one root, and travels."""
        if not self.soles.points or not self.soles.surfaces or self.figure.tables.free_links.size != 1:
            return False
        return self._hips > 0 and self._travel > self.limits.fast

    @property
    def _is_level(self) -> bool:
        """Whether the ground below the lowest sole point has the same height at all keyframes; steps are no cycle."""
        heights = self.soles.heights
        lowest = heights.argmin(axis=0), np.arange(heights.shape[1])
        return float(np.ptp((self.soles.centres[2] - heights)[lowest])) < self.limits.same_spot

    @property
    def _root(self) -> Array:
        """Positions (K, 3) [m] of the root at keyframes."""
        return self.keys.states[:, self.figure.tables.position_columns[:, 0]]

    @cached_property
    def _travel(self) -> float:
        """Horizontal speed of the root [m/s]."""
        lengths = np.linalg.norm(np.diff(self._root[:, :2], axis=0), axis=1)
        return float(lengths.sum()) / float(self.keys.times[-1] - self.keys.times[0])

    @cached_property
    def _hips(self) -> float:
        """The height [m] of the root above the soles."""
        return float(np.median(self._root[:, 2] - self.soles.centres[2].min(axis=0)))

    @property
    def usual_period(self) -> float:
        """The period [s] of a body of this size at this speed, by dynamic similarity."""
        gravity = float(np.linalg.norm(self.figure.gravity)) or STANDARD_GRAVITY
        froude = self._travel**2 / (gravity * self._hips)
        return STRIDE * froude**POWER * self._hips / self._travel

    def slip(self, gait_cycle: GaitCycle) -> float:
        """Return the mean speed of the slowest low sole point, relative to the travel speed; inf if none is low."""
        times, qpos = gait_cycle.times, gait_cycle.qpos(self.figure.width)
        over = slice(*(self.figure.tables.position_columns[0, 0] + np.array([0, 2])))
        qpos[:, over] = self._plain[1][:, over]
        soles = replace(self.soles, samples=Samples.still(self.figure, self.figure.to_state(qpos)))
        speed = np.linalg.norm(np.gradient(soles.centres[:2], times, axis=2), axis=0)
        low = soles.heights < self.limits.hovers + np.quantile(self.soles.heights.min(axis=0), LOWEST)
        slowest = np.where(low, speed, np.inf).min(axis=0)
        down = np.isfinite(slowest)
        return float(slowest[down].mean() / self._travel) if down.any() else np.inf


def _refine(poses: PoseVectors, tried: Array, gain: Array, i: int) -> float:
    """Return the maximum of the parabola through the gains at a peak, over the logarithm of the period."""
    if i in (0, tried.size - 1):
        return float(tried[i])
    before, here, after = gain[i - 1 : i + 2]
    bend = before - 2 * here + after
    shift = 0.5 * (before - after) / bend if bend < 0 else 0.0
    return float(tried[i] * (tried[i + 1] / tried[i]) ** shift)
