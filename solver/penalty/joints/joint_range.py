"""Joint ranges of the model: hinges and slides between their bounds, ball joints up to a maximum angle; and speeds.

As in MuJoCo, a ball joint's angle is that of D = Q_child (Q_parent turn)⁻¹: θ = 2 atan2(|vec D|, |D_w|). A small
rotation δφ of the child relative to the parent changes it by axis · δφ. At half a turn the axis changes sign. There π −
θ is replaced by √((π − θ)² + ε²), so that the penalty is smooth.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, Mask
from ...curve.frame import Timeline
from ...figure.algebra import cross, dot, hamilton, vector_product
from ...figure.figure import Figure, JointKind, sets_joints
from ...figure.kinematics import Samples
from ...figure.wrenches import Wrenches, of_turn
from ...tolerances import SMALLEST
from ..block import Block, Entries
from ..penalty import NEAR_ANGLE, NEAR_LENGTH, Allowance, Normalization, Penalty, Role

NEAR_HOME = np.radians(12)  # [rad] distance that a step may cover to a bound of rotations that are kept near one value
BLEND = np.radians(0.5)  # [rad] ε


@dataclass(frozen=True)
class Range:
    """The bounds of one joint.

    Attributes:
        kind: The kind of bounded coordinate.
        low: The lower bound of the coordinate [rad, m].
        high: The upper bound of the coordinate, or of a ball joint's angle [rad, m].
        column: For the position of a free joint, the bounded axis, 0 to 2.
        home: The rotation from which a ball joint's angle is measured, wxyz as in qpos; None: the identity.
        first: The beginning of the interval in which the bounds apply [s].
        last: The end of this interval [s].
    """

    name: str
    link: int
    kind: JointKind
    low: float
    high: float
    column: int = 0
    home: tuple[float, ...] | None = None
    first: float = -np.inf
    last: float = np.inf


@dataclass(frozen=True)
class JointRange(Penalty):
    """Σ over joints of their squared excess over the range [rad² or m²].

    Attributes:
        allowed: The tolerance below and above the ranges, (2, n, K).
    """

    joints: tuple[Range, ...]
    allowed: Allowance | None = None
    name: str = "limits.range"

    role = Role.LIMIT
    is_sharp = True
    normalization = Normalization(float(np.radians(1)) ** 2)

    def allowing(self, figure: Figure, keys: Timeline) -> JointRange:
        """Return the penalty with tolerances for joints that keyframes fix beyond their ranges."""
        if not self.joints:
            return self
        samples = Samples.still(figure, keys.states, t=np.asarray(keys.times))
        excess = np.zeros((2, len(self.joints), keys.times.size))
        plain, balls = self._which
        low, high = self._bounds
        if plain.size:
            value = samples.columns(self._columns(samples))
            excess[:, plain] = low[plain, None] - value, value - high[plain, None]
        if balls.size:
            excess[1, balls] = self._rotations(samples)[0] - high[balls, None]
        links = [joint.link for joint in self.joints]
        return replace(self, allowed=Allowance.in_keys(keys, excess, sets_joints(figure, keys.fixed, links)))

    def beyond(self, samples: Samples) -> Array:
        """Return the excess of every joint over its range, negative within it, (n, S) [rad or m]."""
        local, which = self._during(samples.t)
        if local is not self:
            out = np.full((len(self.joints), samples.count), -np.inf)
            out[which] = local.beyond(samples)
            return out
        out = np.empty((len(self.joints), samples.count))
        plain, balls = self._which
        if plain.size:
            value = samples.columns(self._columns(samples))
            low, high = self._limits(samples.t, plain)
            out[plain] = np.maximum(low - value, value - high)
        if balls.size:
            out[balls] = self._rotations(samples)[0] - self._limits(samples.t, balls)[1]
        return out

    def residuals(self, samples: Samples) -> Iterator[Block]:
        local, _ = self._during(samples.t)
        if local is not self:
            yield from local.residuals(samples)
            return
        plain, balls = self._which
        if plain.size:
            columns, (low, high) = self._columns(samples), self._limits(samples.t, plain)
            value = samples.columns(columns)
            is_slide = np.array([self.joints[i].kind is JointKind.SLIDE for i in plain])[:, None]
            least = -np.where(is_slide, NEAR_LENGTH, NEAR_ANGLE)
            for sign, over in ((-1.0, low - value), (1.0, value - high)):
                joint, at = np.nonzero(over > least)
                yield Block(at, over[joint, at], (Entries(at, 0, columns[joint], sign),), one_sided=True)
        if balls.size:
            _, angle, rate, axis = self._rotations(samples)
            most = self._limits(samples.t, balls)[1]
            least = np.where(self._is_home, NEAR_HOME, NEAR_ANGLE)[:, None]
            over, axes = (angle - most)[None], (rate * axis)[:, None]
            if np.any(most < least):
                over, axes = _with_other_axes(over, axes, angle, most)
            side, joint, at = np.nonzero(over > -least)
            direction, link = axes[:, side, joint, at], self._links[joint]
            changes = of_turn(at, link, direction), of_turn(at, samples.figure.tables.parents[link], -direction)
            yield Block(at, over[side, joint, at], changes, one_sided=True)

    @cached_property
    def _which(self) -> tuple[Index, Index]:
        """The indices of hinges or slides, and of ball joints."""
        is_ball = np.array([joint.kind is JointKind.BALL for joint in self.joints], bool)
        return np.flatnonzero(~is_ball), np.flatnonzero(is_ball)

    @cached_property
    def _bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds of all joints, (n,) each."""
        return np.array([joint.low for joint in self.joints]), np.array([joint.high for joint in self.joints])

    @cached_property
    def _intervals(self) -> Array:
        """The intervals in which the bounds apply, (2, n) [s]."""
        return np.array([(joint.first, joint.last) for joint in self.joints]).reshape(-1, 2).T

    @cached_property
    def _is_timed(self) -> bool:
        """Whether any bounds apply to an interval only."""
        return bool(np.isfinite(self._intervals).any())

    def _during(self, t: Array) -> tuple[JointRange, Index]:
        """Return the penalty of the joints whose bounds apply somewhere between times t (S,), and their indices."""
        first, last = self._intervals
        which = np.flatnonzero((first <= t.max(initial=-np.inf)) & (last >= t.min(initial=np.inf)))
        if which.size == len(self.joints):
            return self, which
        allowed = None if self.allowed is None else replace(self.allowed, excess=self.allowed.excess[:, which])
        return JointRange(tuple(self.joints[i] for i in which), allowed, self.name), which

    @cached_property
    def _links(self) -> Index:
        return np.array([self.joints[i].link for i in self._which[1]], np.intp)

    def _columns(self, samples: Samples) -> Index:
        """Return the state's columns of the hinges and slides."""
        joints = [self.joints[i] for i in self._which[0]]
        return np.array([samples.figure.links[joint.link].qpos + joint.column for joint in joints], np.intp)

    def _limits(self, t: Array, joints: Index) -> tuple[Array, Array]:
        """Return lower and upper bounds of joints (n,) at times t (S,), (n, S), or (n, 1) if they are constant."""
        low, high = (bound[joints, None] for bound in self._bounds)
        if self._is_timed:
            first, last = self._intervals[:, joints, None]
            holds = (first <= t) & (t <= last)
            low, high = np.where(holds, low, -np.inf), np.where(holds, high, np.inf)
        if self.allowed is None:
            return low, high
        below, above = self.allowed.at(t)[:, joints]
        return low - below, high + above

    def _rotations(self, samples: Samples) -> tuple[Array, Array, Array, Array]:
        """Return quantities of the ball joints, (b, S) each: angle [rad], smoothed angle [rad], derivative of the
        second by the first; and the axes in the world (3, b, S)."""
        links, tables, children = samples.links, samples.figure.tables, self._links
        base = links.Q[:, tables.parents[children]]
        if tables.has_turns or self._is_home.any():
            base = hamilton(base, self._rest(samples.figure)[:, :, None])
        child = links.Q[:, children]
        along = np.einsum("jcns,cns->jns", vector_product(base), child)
        w, sine = dot(base, child), np.sqrt(dot(along, along))
        angle = 2 * np.arctan2(sine, np.abs(w))
        angle_ = 2 * np.arctan2(np.abs(w), sine)
        rounded = np.hypot(angle_, BLEND)
        axis = along * np.where(w < 0, -1.0, 1.0) / np.maximum(sine, SMALLEST)
        return angle, np.pi - rounded, angle_ / rounded, axis

    @cached_property
    def _is_home(self) -> Mask:
        """Which of the ball joints have a `home`, (b,)."""
        return np.array([self.joints[i].home is not None for i in self._which[1]], bool)

    def _rest(self, figure: Figure) -> Array:
        """Return the rotations in the parent from which the ball joints' angles are measured, (4, b)."""
        out = np.array(figure.tables.turn[:, self._links])
        for k, i in enumerate(self._which[1]):
            joint = self.joints[i]
            if joint.home is not None:
                is_free = figure.links[joint.link].kind is JointKind.FREE
                out[:, k] = joint.home if is_free else quat.product(out[:, k], np.array(joint.home))
        return out


def _with_other_axes(over: Array, axes: Array, angle: Array, most: Array) -> tuple[Array, Array]:
    """Add residuals of rotations about other axes: opposite and perpendicular to those of the present rotations.

    A range that is smaller than a step of the search may be left in any direction, although the angle itself changes
    only by rotations about the present axis. The rotation vector has to stay between six planes instead.

    Args:
        over: The residuals, (1, b, S).
        axes: Their axes, (3, 1, b, S).
        angle: The angles of the joints, (b, S) [rad].
        most: Their upper bounds, (b, S) or (b, 1) [rad].

    Returns:
        Residuals (6, b, S) and axes (3, 6, b, S).
    """
    first = np.where(np.abs(axes[:, 0]).sum(axis=0) > 0, axes[:, 0], np.eye(3)[:, :1, None])
    second = cross(first, np.eye(3)[np.abs(first).argmin(axis=0)].transpose(2, 0, 1))
    second /= np.sqrt(dot(second, second))
    third = cross(first, second)
    beside = np.broadcast_to(-most, angle.shape)
    all_axes = np.stack([axes[:, 0], -first, second, -second, third, -third], axis=1)
    return np.stack([over[0], -angle - most, *[beside] * 4]), all_axes


def joint_ranges(figure: Figure) -> tuple[Range, ...]:
    """Return the ranges of a model's limited joints that can be exceeded."""
    model, result = figure.model, []
    for i, link in enumerate(figure.links[1:], start=1):
        if link.kind is JointKind.FREE or not model.jnt_limited[link.joint]:
            continue
        low, high = (float(bound) for bound in model.jnt_range[link.joint])
        if link.kind is JointKind.BALL:
            low, high = 0.0, max(low, high)
            if high >= np.pi:
                continue
        result.append(Range(link.name, i, link.kind, low, high))
    return tuple(result)


@dataclass(frozen=True)
class Speed(Penalty):
    """Σ over hinges and ball joints of max(0, |ω − ω_parent| − limit)² [rad²/s²].

    Attributes:
        limit: The maximum speed [rad/s].
    """

    limit: float

    name = "limits.speed"
    role = Role.LIMIT
    is_sharp = True
    normalization = Normalization(1.0, time_power=2)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        relative = _relative(samples)
        size = np.linalg.norm(relative, axis=0)
        at, joint = np.nonzero((size > self.limit).T)
        fast, link = size[joint, at], samples.figure.tables.rotary_links[joint]
        axis = relative[:, joint, at] / np.maximum(fast, SMALLEST)
        parent = samples.figure.tables.parents[link]
        changes = Wrenches(at, link, torque_d=axis), Wrenches(at, parent, torque_d=-axis)
        yield Block(at, fast - self.limit, changes)

    def excess(self, samples: Samples) -> Array:
        """Return the excess of every joint over the limit, negative below it, (J, S) [rad/s]."""
        return np.linalg.norm(_relative(samples), axis=0) - self.limit


def _relative(samples: Samples) -> Array:
    """Return the angular velocities of hinges and ball joints, (3, J, S) [rad/s]."""
    links, parents = samples.figure.tables.rotary_links, samples.figure.tables.parents
    return samples.links.omega[:, links] - samples.links.omega[:, parents[links]]
