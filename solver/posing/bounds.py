"""Bounds of joints in inverse kinematics: joint ranges, and the bending of knees and elbows on ball joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure, JointKind
from ..penalty.joints.bend import BendLimits, bent
from ..tolerances import ROUNDING

STRAIGHT = 3.0  # [1] weight of sideways and twist angles of knees and elbows, relative to rotations of a limb joint
ONE_SIDED = 0.25  # [1] a hinge bends one way if its rest value is within this share of its range from an end
INSIDE = 1e-7  # [rad, m] margin of joints from the ends of their ranges; goals there are still met
Part = tuple[Array, Array]  # residuals (k,) and their Jacobian (k, n)


def joined(parts: Sequence[Part]) -> Part:
    """Return the concatenated residuals and Jacobians of several parts."""
    return np.concatenate([values for values, _ in parts]), np.concatenate([rows for _, rows in parts])


@dataclass(frozen=True, eq=False)
class Ranges:
    """The ranges of free joints.

    Attributes:
        balls: The columns of ball joints in qpos, (b, 4).
        turns: The indices of their degrees of freedom among the unknowns, (b, 3).
        most: Their largest rotation angles, (b,) [rad].
        simple: The columns of hinges and slides in qpos, (s,).
        places: The indices of their degrees of freedom among the unknowns, (s,).
        limits: Their lower and upper limits, (s, 2) [rad or m].
        ways: The signs of the bending direction of hinges that bend one way, otherwise 0, (s,).
        count: The number of unknowns, n.
    """

    balls: Index
    turns: Index
    most: Array
    simple: Index
    places: Index
    limits: Array
    ways: Array
    count: int

    @classmethod
    def of(cls, figure: Figure, joints: Sequence[int], dofs: Index) -> Ranges:
        model = figure.model
        links = [link for i in joints if model.jnt_limited[(link := figure.links[i]).joint]]
        balls = [link for link in links if link.kind is JointKind.BALL]
        simple = [link for link in links if link.kind is not JointKind.BALL]
        limits = model.jnt_range[[link.joint for link in simple]].reshape(-1, 2)
        columns = np.array([link.qpos for link in simple], np.intp)
        share = (model.qpos0[columns] - limits[:, 0]) / np.maximum(np.ptp(limits, axis=1), ROUNDING)
        hinges = np.array([link.kind is JointKind.HINGE for link in simple], bool)
        directions = hinges * (1.0 * (share < ONE_SIDED) - (share > 1 - ONE_SIDED))
        margin = np.minimum(INSIDE, np.ptp(limits, axis=1) / 4)
        return cls(
            np.array([link.qpos for link in balls], np.intp)[:, None] + np.arange(4),
            np.searchsorted(dofs, np.array([link.dof for link in balls], np.intp))[:, None] + np.arange(3),
            model.jnt_range[[link.joint for link in balls], 1] - INSIDE,
            columns,
            np.searchsorted(dofs, np.array([link.dof for link in simple], np.intp)),
            limits + np.array([1, -1]) * margin[:, None],
            directions,
            dofs.size,
        )

    def narrowed(self, shares: Mapping[int, float], home: Array) -> Ranges:
        """Return narrower ranges, which still contain the values at home (nq,).

        Args:
            shares: The permitted share of a range, by the first column of the joint in qpos. Ranges of hinges and
                slides are narrowed towards their middle, those of ball joints towards the rest pose.
            home: The pose, (nq,).
        """
        shares_kept = np.array([shares.get(int(columns[0]), 1.0) for columns in self.balls])
        there = np.linalg.norm(quat.rotation_vector(home[self.balls]), axis=-1)
        most = np.minimum(self.most, np.maximum(shares_kept * self.most, there))
        spare = np.array([1 - shares.get(int(column), 1.0) for column in self.simple])
        margin = np.outer(spare / 2 * np.ptp(self.limits, axis=1), [1, -1])
        low, high = (self.limits + margin).T
        at = np.clip(home[self.simple], *self.limits.T)
        narrow = np.stack([np.minimum(low, at), np.maximum(high, at)], axis=1)
        return replace(self, most=most, limits=np.where(spare[:, None] > 0, narrow, self.limits))

    def bend(self, qpos: Array, least: float) -> Array:
        """Return qpos (nq,) clipped to the ranges, with one-way hinges bent by at least `least` [rad]."""
        out = np.array(qpos)
        low, high = self.limits.T
        at = out[self.simple]
        at = np.where(self.ways > 0, np.maximum(at, low + least), at)
        at = np.where(self.ways < 0, np.minimum(at, high - least), at)
        out[self.simple] = np.clip(at, low, high)
        return out

    def linearise(self, qpos: Array) -> Part:
        """Return the signed excess of joints over the ends of their ranges (k,) [rad or m], and its Jacobian (k, n)."""
        balls, simple = len(self.balls), self.simple.size
        over, rows = np.empty(balls + 2 * simple), np.zeros((balls + 2 * simple, self.count))
        if balls:
            turn = quat.rotation_vector(qpos[self.balls])
            angle = np.sqrt(np.einsum("bi,bi->b", turn, turn))
            over[:balls] = angle - self.most
            rows[np.arange(balls)[:, None], self.turns] = turn / np.maximum(angle, ROUNDING)[:, None]
        at, upper = qpos[self.simple], balls + np.arange(simple)
        over[upper], over[upper + simple] = at - self.limits[:, 1], self.limits[:, 0] - at
        rows[upper, self.places], rows[upper + simple, self.places] = 1.0, -1.0
        return over, rows


@dataclass(frozen=True, eq=False)
class Bends:
    """The knees and elbows among the free joints.

    Attributes:
        limits: The k joints with their bounds.
        columns: The columns of their quaternions in qpos, (k, 4).
        dofs: Their degrees of freedom, (k, 3).
    """

    figure: Figure
    limits: BendLimits
    columns: Index
    dofs: Index

    @classmethod
    def of(cls, figure: Figure, limits: BendLimits, free: Mask) -> Bends | None:
        joints = tuple(joint for joint in limits.joints if free[figure.links[joint.link].columns].all())
        if not joints:
            return None
        links = [figure.links[joint.link] for joint in joints]
        limits = BendLimits(joints, limits.least, limits.sideways, limits.twist)
        columns = np.array([link.qpos for link in links])[:, None] + np.arange(4)
        return cls(figure, limits, columns, np.array([link.dof for link in links])[:, None] + np.arange(3))

    def bend(self, qpos: Array, least: float) -> Array:
        """Return qpos (nq,) with a flexion of every joint of at least `least` [rad]."""
        out = np.array(qpos)
        flexion = self._angles(qpos[self.columns])[0]
        for joint, columns, angle in zip(self.limits.joints, self.columns, flexion, strict=True):
            if angle < least:
                turn = self.figure.links[joint.link].turn
                axis = quat.rotated(quat.inverse(turn), joint.lateral)
                more = quat.from_rotation_vector((least - angle) * axis)
                out[columns] = quat.product(quat.normalised(out[columns]), more)
        return out

    @cached_property
    def _axes(self) -> tuple[Array, Array]:
        """The axes of parent and child in the frames of the joints.

        Returns:
            The forward, long and lateral axes of the parents (k, 3, 3); the long and lateral axes of the children
            (2, k, 3).
        """
        joints = self.limits.joints
        lateral, down = (np.array([getattr(joint, name) for joint in joints]) for name in ("lateral", "long_axis"))
        back = quat.inverse(np.array([self.figure.links[joint.link].turn for joint in joints]))
        forward, down, lateral = (quat.rotated(back, axis) for axis in (np.cross(lateral, down), down, lateral))
        return np.stack([forward, down, lateral], axis=1), np.array([down, lateral])

    def linearise(self, qpos: Array, nv: int) -> tuple[Part, Part]:
        """Return the weighted sideways and twist angles (2 k,) and the excess over bounds (5 k,), with Jacobians."""
        parent, child = self._axes
        turned = np.einsum("nij,nbi->bnj", quat.matrices(qpos[self.columns]), parent)  # in the child's frame
        (x, z, y), (a, b, q) = np.einsum("bnj,cnj->cbn", turned, child)
        # derivatives with respect to rotations about the child's axes, (6, k, 3): dx, dz, dy, da, db, dq
        slopes = _cross(child[:, None], turned).reshape(6, x.size, 3)
        planar = np.maximum(np.hypot(x, z), ROUNDING)
        p = (x * b - z * a) / planar
        both = np.maximum(p**2 + q**2, ROUNDING**2)
        flexion, sideways, twist = np.arctan2(x, z), np.arctan2(y, planar), np.arctan2(p, q)
        by_six, square, of_p = np.zeros((3, 6, x.size)), planar**2, q / both / planar
        by_six[0, :2] = z / square, -x / square
        by_six[1, :3] = -y * x / planar, -y * z / planar, planar
        by_six[2, 0], by_six[2, 1] = of_p * (b - p * x / planar), -of_p * (a + p * z / planar)
        by_six[2, 3:] = -of_p * z, of_p * x, -p / both
        by = np.zeros((3, x.size, nv))
        by[:, np.arange(x.size)[:, None], self.dofs] = np.einsum("ksn,snj->knj", by_six, slopes)
        limits = self.limits
        over = [limits.least - flexion]
        for value, bound in ((sideways, limits.sideways), (twist, limits.twist)):
            over += [value - bound, -value - bound]
        crooked = STRAIGHT * np.concatenate([sideways, twist]), STRAIGHT * np.concatenate([by[1], by[2]])
        return crooked, (np.concatenate(over) + INSIDE, np.concatenate([-by[0], by[1], -by[1], by[2], -by[2]]))

    def _angles(self, q: Array) -> Array:
        return bent(self.figure, self.limits.joints, q)


def _cross(a: Array, b: Array) -> Array:
    """Return a × b, (..., 3)."""
    return a[..., [1, 2, 0]] * b[..., [2, 0, 1]] - a[..., [2, 0, 1]] * b[..., [1, 2, 0]]
