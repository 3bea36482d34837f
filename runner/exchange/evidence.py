"""Evidence for how to read a file: agreement with its body poses, and plausibility of the motion."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.forward import boxes, set_qpos
from dynsplines.solver.figure.root import root_of

from ..scene.configuration import posed
from ..scene.framing import spread
from .trajectory import BodyPoses, Recording

CLOSE, ALIGNED = 0.02, np.radians(2)  # [m], [rad] allowed difference between forward kinematics and recorded bodies
LOOKED_AT = 60  # samples of a file that are evaluated, evenly spread
SLACK = np.radians(5)  # [rad] that a joint may exceed its range
MOVING = 0.05  # largest angle, in degrees or radians, up to which a joint is no evidence of the unit
FAST = 50.0  # [rad/s] implausible joint speed of robots and people
SLIDING = 1.0  # [m/s] typical sliding speed of the lowest point in a wrong reading; in most motions it is at rest
LYING = 0.35  # height over length below which a rest pose lies down and so does not show which way is up
LEANING, UPRIGHT, FALLEN = np.radians(25), np.radians(45), np.radians(60)  # [rad] tilts of the root
AT_FLOOR, SUNK = 0.08, 0.2  # fractions of the figure's size: height of the lowest point at the floor, depth below it
ON_FLOOR = 0.04  # [m] median distance of the lowest point from the floor, for a figure that evidently stands on it
FLYING = 2.5  # [m] height of the lowest point that no jump reaches
NONE_OUTSIDE, LITTLE_OUTSIDE, MUCH_OUTSIDE = 0.01, 0.03, 0.1  # fractions of joint angles beyond their ranges
FAR_OUTSIDE = 0.15  # fraction of joint angles beyond their ranges when degrees are read as radians
DOUBTED, REFUTED = 0.5, 0.9  # differences of scores at which the documented layout is doubted, and replaced
ENOUGH = 20  # least number of samples for sliding to be evidence
JUMP = np.radians(45)  # [rad] implausible rotation of the root from sample to sample


@dataclass(frozen=True)
class Disagreement:
    """The largest distance [m] and angle [rad] between recorded body poses and those of the figure."""

    distance: float
    angle: float

    @property
    def share(self) -> float:
        """Ratio of the disagreement to the allowed value."""
        return max(self.distance / CLOSE, self.angle / ALIGNED)

    def __str__(self) -> str:
        return f"{100 * self.distance:.1f} cm and {np.degrees(self.angle):.1f}°"


def disagreement(model: mujoco.MjModel, recording: Recording) -> Disagreement:
    """Return how far the body poses of a recording are from those of the figure at the recorded qpos.

    Each recorded body is compared with the figure's body that is nearest to it over all samples. So the order of the
    bodies does not matter, nor whether the world is among them. If the figure has fewer bodies, each of them is
    compared with its nearest recorded body instead.
    """
    assert recording.bodies is not None, "a recording with body poses"
    rows = spread(len(recording.qpos), LOOKED_AT)
    poses = ((data.xpos.copy(), data.xquat.copy()) for data in posed(model, recording.qpos[rows]))
    position, rotation = (np.array(part) for part in zip(*poses, strict=True))
    root = root_of(model)
    if recording.bodies.is_local and root is not None:
        back = quat.inverse(rotation[:, root.body])[:, None]
        position = quat.rotated(back, position - position[:, [root.body]])
        rotation = quat.product(back, rotation)
    columns = _matching_bodies(model, recording.bodies)
    away = np.linalg.norm(recording.bodies.position[rows][:, columns, None] - position[:, None], axis=-1).max(axis=0)
    angles = [np.zeros_like(away)]
    if recording.bodies.rotation is not None:
        shifts = (0,) if recording.bodies.is_wxyz else (0, 1)
        recorded = recording.bodies.rotation[rows][:, columns, None]
        angles = [quat.angle_between(np.roll(recorded, n, -1), rotation[:, None]).max(axis=0) for n in shifts]
    return min((_nearest(away, angle) for angle in angles), key=lambda each: each.share)


def _matching_bodies(model: mujoco.MjModel, bodies: BodyPoses) -> Index:
    """Return the recorded bodies whose names the figure has, or all of them if these are less than half."""
    everything = np.arange(bodies.position.shape[1])
    if bodies.names is None or len(bodies.names) != everything.size:
        return everything
    names = {model.body(body).name for body in range(model.nbody)}
    matching = np.flatnonzero([name in names for name in bodies.names])
    return matching if 2 * matching.size > everything.size else everything


def _nearest(distance: Array, angle: Array) -> Disagreement:
    """Return the largest distance and angle (b, nbody) after assigning each body of the smaller set to its nearest."""
    if distance.shape[0] > distance.shape[1]:
        distance, angle = distance.T, angle.T
    partner = np.argmin(np.maximum(distance / CLOSE, angle / ALIGNED), axis=1)
    rows = np.arange(len(partner))
    return Disagreement(float(distance[rows, partner].max()), float(angle[rows, partner].max()))


@dataclass(frozen=True)
class Plausibility:
    """Measures of how plausible a figure's motion is.

    tilt     [rad] mean tilt of the root from upright
    height   [m] median distance of the lowest point from z = 0
    sliding  [m/s] mean horizontal speed of the lowest point
    outside  fraction of joint angles beyond their ranges, without the joint that exceeds its range most often
    jumps    fraction of steps between samples in which the root or a joint turns implausibly fast
    upright  fraction of samples with an upright root and the figure neither in the floor nor metres above it
    fallen   fraction of samples with the root far from upright, or the figure in the floor or metres above it
    standing fraction of samples with the root within `LEANING` of upright and the lowest point at the floor
    samples  number of samples
    """

    tilt: float
    height: float
    sliding: float
    outside: float
    jumps: float
    upright: float
    fallen: float
    standing: float
    samples: int

    @classmethod
    def of(cls, model: mujoco.MjModel, recording: Recording) -> Plausibility:
        """Return the plausibility of a recording; samples with entries that are not finite are ignored."""
        finite = np.isfinite(recording.qpos).all(axis=1)
        qpos, time = recording.qpos[finite], recording.time[finite]
        outside, jumps = _mostly_outside(model, qpos), _fast(model, qpos, time)
        root = root_of(model)
        if root is None or not len(qpos):
            return cls(0.0, 0.0, 0.0, outside, jumps, 1.0, 0.0, 1.0, len(qpos))
        if root.is_free:
            start = int(model.jnt_qposadr[root.joints[0]])
            rotation = quat.normalised(qpos[:, start + 3 : start + 7])
            turned = quat.angle_between(rotation[1:], rotation[:-1])
            jumps += float(np.mean(turned > JUMP)) if turned.size else 0.0
        tilts, heights, speeds, size = _posture(model, root.body, qpos, time)
        is_off = (heights < -SUNK * size) | (heights > FLYING)
        at_floor = np.abs(heights) < AT_FLOOR * size
        return cls(
            tilt=float(tilts.mean()),
            height=float(np.median(np.abs(heights))),
            sliding=float(np.minimum(speeds, 3 * SLIDING).mean()),
            outside=outside,
            jumps=jumps,
            upright=float(np.mean((tilts < UPRIGHT) & ~is_off)),
            fallen=float(np.mean((tilts > FALLEN) | is_off)),
            standing=float(np.mean((tilts < LEANING) & at_floor)),
            samples=len(qpos),
        )

    @property
    def score(self) -> float:
        """Dimensionless plausibility, at most 2; greater is more plausible. Sliding does not contribute."""
        return self.upright - self.fallen + self.standing - self.tilt / np.pi - 8 * self.outside - 3 * self.jumps

    @property
    def is_fallen(self) -> bool:
        """Whether the figure is fallen in most samples, or upright in few of them."""
        return self.fallen > 0.5 or self.upright < 0.2

    @property
    def is_evident(self) -> bool:
        """Whether in most samples the root is upright on the floor, with joints within their ranges."""
        return self.standing > 0.5 and self.outside < LITTLE_OUTSIDE

    def is_doubted_by(self, other: Plausibility) -> bool:
        """Whether another reading is clearly more plausible than this one, which is the documented one.

        One of these must hold: this one is fallen; only the other has its joints within their ranges; or the other is
        upright on the floor, while this one is off the floor or leans.
        """
        if self.is_evident or other.is_fallen or other.outside > MUCH_OUTSIDE or other.score - self.score < DOUBTED:
            return False
        falls = self.is_fallen and other.score - self.score > REFUTED
        nearer = self._is_off_floor(other) and other.standing > 0.5 and other.height < ON_FLOOR
        straighter = other.standing > 0.9 and other.tilt < LEANING / 4 and self.tilt > LEANING
        return falls or nearer or straighter or self._exceeds(other, LITTLE_OUTSIDE)

    def is_refuted_by(self, other: Plausibility) -> bool:
        """Whether another reading is so much more plausible that it replaces this one, the documented one.

        One of these must hold: this one is fallen; many of its joints exceed their ranges and the other's do not; or
        this one leans where the other stands upright and nearer to the floor.
        """
        if not self.is_doubted_by(other) or other.score - self.score < REFUTED:
            return False
        leans = self.tilt > LEANING and other.tilt < LEANING / 2 and other.standing > 0.9 and self._is_off_floor(other)
        return self.is_fallen or self._exceeds(other, MUCH_OUTSIDE) or leans

    def _is_off_floor(self, other: Plausibility) -> bool:
        return self.height > max(ON_FLOOR, 2 * other.height)

    def _exceeds(self, other: Plausibility, share: float) -> bool:
        return self.outside > share and other.outside < NONE_OUTSIDE

    def slides_less_than(self, other: Plausibility) -> bool:
        """Whether the feet slide evidently less than in another reading, over enough samples."""
        is_less = self.sliding < other.sliding / 2 and other.sliding - self.sliding > 0.3 * SLIDING
        return is_less and self.samples >= ENOUGH and self.standing > 0.5

    def __str__(self) -> str:
        parts = [f"tilt {np.degrees(self.tilt):.0f}°, lowest point at {100 * self.height:.0f} cm"]
        parts.append(f"sliding at {self.sliding:.1f} m/s")
        if self.outside >= 0.005:
            parts.append(f"{self.outside:.0%} of joint angles out of range")
        if self.jumps >= 0.005:
            parts.append(f"jumps in {self.jumps:.0%} of the steps")
        return ", ".join(parts)


def in_degrees(model: mujoco.MjModel, qpos: Array, time: Array) -> bool:
    """Whether hinge angles are evidently in degrees.

    Read as degrees, they must be within their ranges. Read as radians, half of the hinges must exceed a turn, or one
    must and many angles must be out of range. For figures without ranges, the speeds decide: too fast as radians, and
    not as degrees.
    """
    hinges = model.jnt_type == JointKind.HINGE
    limited = hinges & (model.jnt_limited == 1)
    values = qpos[np.isfinite(qpos).all(axis=1)]
    scaled = values.copy()
    scaled[:, model.jnt_qposadr[hinges]] = np.radians(values[:, model.jnt_qposadr[hinges]])
    if not len(values):
        return False
    if not limited.any():
        clock = time[np.isfinite(qpos).all(axis=1)]
        return _fast(model, values, clock) > 0.5 and _fast(model, scaled, clock) == 0
    most = np.abs(values[:, model.jnt_qposadr[limited]]).max(axis=0)
    moving = most[most > MOVING]
    if not moving.size or _outside(model, scaled) > 0.05:
        return False
    is_beyond = moving > 2 * np.pi
    return bool(is_beyond.mean() >= 0.5 or (is_beyond.any() and _outside(model, values) > FAR_OUTSIDE))


def _beyond(model: mujoco.MjModel, qpos: Array) -> Array:
    """Return the fraction of samples (n,) in which each limited hinge or slide exceeds its range."""
    limited = (model.jnt_limited == 1) & (model.jnt_type >= JointKind.SLIDE)
    values, bounds = qpos[:, model.jnt_qposadr[limited]], model.jnt_range[limited]
    if not len(values):
        return np.zeros(0)
    return np.mean((values < bounds[:, 0] - SLACK) | (values > bounds[:, 1] + SLACK), axis=0)


def _outside(model: mujoco.MjModel, qpos: Array) -> float:
    shares = _beyond(model, qpos)
    return float(shares.mean()) if shares.size else 0.0


def _mostly_outside(model: mujoco.MjModel, qpos: Array) -> float:
    """Return `_outside` without the joint that exceeds its range most often: its range may be wrong."""
    shares = _beyond(model, qpos)
    return float((shares.sum() - shares.max()) / shares.size) if shares.size else 0.0


def _fast(model: mujoco.MjModel, qpos: Array, time: Array) -> float:
    hinges = model.jnt_qposadr[model.jnt_type == JointKind.HINGE]
    if len(qpos) < 2 or not hinges.size:
        return 0.0
    step = np.diff(qpos[:, hinges], axis=0)
    step -= 2 * np.pi * np.round(step / (2 * np.pi)) * (np.abs(step) < 7)  # a wrapped angle is no rotation
    is_fast = np.abs(step) > FAST * np.maximum(np.diff(time), 1e-3)[:, None]
    return float(np.median(is_fast.mean(axis=0)))  # the median ignores single rotors, which may be as fast


def _posture(model: mujoco.MjModel, body: int, qpos: Array, time: Array) -> tuple[Array, Array, Array, float]:
    """Return the figure's posture in n samples.

    tilt (n,) [rad] of its body from rest, height (n,) [m] and speed (n,) [m/s] of its lowest point, and its size [m]
    """
    bodies = np.flatnonzero(model.body_rootid == model.body_rootid[body])
    geoms = np.flatnonzero(np.isin(model.geom_bodyid, bodies))
    data = mujoco.MjData(model)

    def points(row: Array) -> tuple[Array, Array]:
        """Return centres (n, 3) of the bodies and the bounding boxes of geoms, and the least height (n,) of each."""
        set_qpos(model, data, row)
        centre, reach = boxes(model, data, geoms)
        low = (centre - reach)[:, 2]
        return np.concatenate([centre, data.xpos[bodies]]), np.concatenate([low, data.xpos[bodies, 2]])

    rest, low = points(model.qpos0)
    size = float(max(np.ptp(rest, axis=0).max(), rest[:, 2].max() - low.min(), 1e-3))
    lies = rest[:, 2].max() - low.min() < LYING * np.ptp(rest, axis=0)[:2].max()
    up = data.xmat[body].reshape(3, 3)[2].copy()
    rows = spread(len(qpos) - 1, LOOKED_AT) if len(qpos) > 1 else np.zeros(1, int)
    tilts, heights, speeds = np.zeros(rows.size), np.zeros(rows.size), np.zeros(rows.size)
    for n, i in enumerate(rows):
        here, low = points(qpos[i])
        first = int(np.argmin(low))
        tilts[n] = np.arccos(np.clip(data.xmat[body].reshape(3, 3)[2] @ up, -1, 1))
        heights[n] = low[first]
        if i + 1 < len(qpos):
            there, _ = points(qpos[i + 1])
            speeds[n] = np.linalg.norm((there - here)[first, :2]) / max(time[i + 1] - time[i], 1e-3)
    return np.zeros_like(tilts) if lies else tilts, heights, speeds, size
