"""Knees and elbows: bounds on backward, sideways and twist angles (§5 of the paper).

u is the child's long axis and v its hinge axis, both in parent coordinates (Rᵀ_parent R_child e). Flexion is the angle
of u in the parent's sagittal plane, sideways bend the angle of u out of this plane, and twist the angle of v about u.
The twist is too large by 1/cos of the sideways bend.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...curve.frame import Timeline
from ...figure.algebra import cross, dot, rotation_matrix
from ...figure.figure import Figure, on_links, sets_joints
from ...figure.kinematics import Samples
from ...figure.wrenches import of_turn
from ...tolerances import ROUNDING
from ..block import Block
from ..penalty import NEAR_ANGLE, Allowance, Normalization, Penalty, Role

RARE = 2.0  # [%] share of samples beyond extended limits
ANGLE, SIGN = np.array([0, 1, 1, 2, 2]), np.array([-1.0, 1, -1, 1, -1])  # of the five bounds, as in `excess`
EVERY = np.eye(3)[:, :, None]  # the three angles


@dataclass(frozen=True)
class Bend:
    """One knee or elbow.

    Attributes:
        link: The index of the child's link.
        lateral: The unit axis of positive flexion in the parent at rest, (3,): +y for knees, −y for elbows of a figure
            that faces x.
        long_axis: The unit axis of the child at rest, from the joint along the limb, (3,).
    """

    name: str
    link: int
    lateral: Array
    long_axis: Array


@dataclass(frozen=True)
class BendLimits(Penalty):
    """Σ over joints of squared excess angles [rad²]: flexion below `least`, and |sideways| and |twist| above their
    bounds.

    Attributes:
        least: The bound of flexion [rad].
        sideways: The bound of the sideways angle [rad].
        twist: The bound of the twist angle [rad].
        allowed: The tolerance of the five bounds, (5, n, K).
    """

    joints: tuple[Bend, ...]
    least: float = 0.0
    sideways: float = np.radians(10)
    twist: float = np.radians(10)
    allowed: Allowance | None = None

    name = "limits.bend"
    role = Role.LIMIT
    is_sharp = True
    normalization = Normalization(float(np.radians(1) ** 2))

    def allowing(self, figure: Figure, keys: Timeline) -> BendLimits:
        """Return the penalty with tolerances for joints that keyframes fix beyond their bounds."""
        if not self.joints:
            return self
        excess = self.excess(self.angles(Samples.still(figure, keys.states)))
        return replace(self, allowed=Allowance.in_keys(keys, excess, sets_joints(figure, keys.fixed, self.axes[0])))

    def extend(self, samples: Samples) -> BendLimits:
        """Return the limits, extended to nearly all samples."""
        flexion, *aside = self.angles(samples)
        sideways, twist = (float(np.percentile(np.abs(angle), 100 - RARE)) for angle in aside)
        return replace(
            self,
            least=min(self.least, float(np.percentile(flexion, RARE))),
            sideways=max(self.sideways, sideways),
            twist=max(self.twist, twist),
        )

    def excess(self, angles: Array) -> Array:
        """Return the excess of angles (3, n, S) over each bound, negative within it, (5, n, S)."""
        flexion, sideways, twist = angles
        return np.array(
            [
                self.least - flexion,
                sideways - self.sideways,
                -sideways - self.sideways,
                twist - self.twist,
                -twist - self.twist,
            ]
        )

    def angles(self, samples: Samples) -> Array:
        """Return flexion, sideways bend and twist of every joint, (3, n, S) [rad]."""
        return self._angles_and_frames(samples)[0]

    @cached_property
    def axes(self) -> tuple[Index, Array]:
        """Links (n,), and the joints' axes in the parent: forward, along the limb, lateral, (3, 3, n)."""
        lateral = np.array([joint.lateral for joint in self.joints]).T
        down = np.array([joint.long_axis for joint in self.joints]).T
        forward = np.cross(lateral.T, down.T).T
        return np.array([joint.link for joint in self.joints], np.intp), np.array([forward, down, lateral])

    def _angles_and_frames(self, samples: Samples) -> tuple[Array, tuple[Array, ...]]:
        joints, axes = self.axes
        tables = samples.figure.tables
        carried = axes[:0:-1]  # the child's hinge axis v and long axis u, at rest aligned with the parent's
        if tables.has_turns:
            turn = tables.turn[:, joints]
            carried = np.einsum("jin,kjn->kin", rotation_matrix(turn, 2 / dot(turn, turn)), carried)
        fixed = np.concatenate([*carried, *axes], axis=1)
        owners = np.concatenate([joints, joints, *[tables.parents[joints]] * 3])
        rotated = samples.links.sum_fixed(on_links(fixed, owners, len(samples.figure.links)))
        rotated = rotated.reshape(3, 5, joints.size, samples.count).swapaxes(0, 1)
        world, frame = rotated[:2], rotated[2:]
        v, u = np.einsum("bins,kins->kbns", frame, world)
        angles, planar, p = _angles(u, v)
        return angles, (world, frame, u, v, planar, p)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        if not self.joints:
            return
        angles, rotated = self._angles_and_frames(samples)
        excess = self.excess(angles)
        if self.allowed is not None:
            excess -= self.allowed.at(samples.t)
        side, joint, at = np.nonzero(excess > -NEAR_ANGLE)
        chosen = tuple(part[..., joint, at] for part in rotated)
        axis = SIGN[side] * _turning_axes(chosen, np.eye(3)[:, ANGLE[side]])
        link = self.axes[0][joint]
        changes = of_turn(at, link, axis), of_turn(at, samples.figure.tables.parents[link], -axis)
        yield Block(at, excess[side, joint, at], changes, one_sided=True)


def bend_angles(parent: Array, child: Array) -> tuple[Array, Array]:
    """Return the angles of n joints, and their derivatives by rotations of the children.

    Args:
        parent: The parents' axes: forward, along the limb, lateral, (3, 3, n).
        child: The children's lateral axes and long axes in the same coordinates, (2, 3, n).

    Returns:
        Flexion, sideways bend and twist, (3, n) [rad]; and for each the axis, about which a small rotation of the child
        changes it as much, (3, 3, n): by component and angle.
    """
    v, u = np.einsum("bin,kin->kbn", parent, child)
    angles, planar, p = _angles(u, v)
    return angles, _turning_axes((child[:, :, None], parent, u, v, planar, p), EVERY)


def _turning_axes(frames: tuple[Array, ...], which: Array) -> Array:
    """Return the derivatives (3, ...) of joints' angles by a small rotation of the child in the parent.

    Args:
        which: 1 for the angle and 0 for the other two, (3, ...).
    """
    world, frame, (x, z, _), v, planar, p = frames
    flexes, leans, twists = which
    q = v[2]
    both = np.maximum(p**2 + q**2, ROUNDING**2)
    # derivatives by v and u along the parent's axes
    by_p = twists * q / (both * planar)
    # the normal turns in the sagittal plane as the limb flexes: d normal / d flexion = (z d + x f) / |(x, z)|
    flexes = (flexes + by_p * (z * v[1] + x * v[0])) / planar**2
    bars = np.empty((2, 3, *flexes.shape))
    bars[0] = -by_p * z, by_p * x, -twists * p / both
    bars[1] = flexes * z, -flexes * x, leans / planar
    return np.add.reduce(cross(world.swapaxes(0, 1), np.einsum("kb...p,bip->ik...p", bars, frame)), axis=1)


def _angles(u: Array, v: Array) -> tuple[Array, Array, Array]:
    """Return the three angles of axes u and v in parent coordinates (3, ...), |(x, z)|, and the normal's part p."""
    x, z, y = u
    planar = np.maximum(np.hypot(x, z), ROUNDING)
    p = (x * v[1] - z * v[0]) / planar
    angles = np.empty(u.shape)
    np.arctan2(x, z, out=angles[0])
    np.arctan2(y, planar, out=angles[1])
    np.arctan2(p, v[2], out=angles[2])
    return angles, planar, p
