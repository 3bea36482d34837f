"""Bounds of joints in inverse kinematics: joint ranges, and the bending of knees and elbows on ball joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure, JointKind
from ..penalty.joints.bend import ANGLE, SIGN, BendLimits, bend_angles
from ..tolerances import ROUNDING
from .least_squares import Part

STRAIGHT = 3.0  # [1] weight of sideways and twist angles of knees and elbows, relative to rotations of a limb joint
ONE_SIDED = 0.25  # [1] a hinge bends one way if its rest value is within this share of its range from an end
INSIDE = 1e-7  # [rad, m] margin of joints from the ends of their ranges; goals there are still met


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

    def narrow(self, shares: Mapping[int, float], home: Array) -> Ranges:
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
        balls, rows = len(self.balls), self._rows.copy()
        over = np.empty(len(rows))
        if balls:
            turn = quat.rotation_vector(qpos[self.balls])
            angle = np.sqrt(np.einsum("bi,bi->b", turn, turn))
            over[:balls] = angle - self.most
            rows[np.arange(balls)[:, None], self.turns] = turn / np.maximum(angle, ROUNDING)[:, None]
        at = qpos[self.simple]
        over[balls:] = np.concatenate([at - self.limits[:, 1], self.limits[:, 0] - at])
        return over, rows

    @cached_property
    def _rows(self) -> Array:
        """The Jacobian, (k, n), zero for ball joints."""
        unit = np.eye(self.count)[self.places]
        return np.concatenate([np.zeros((len(self.balls), self.count)), unit, -unit])


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
        for columns, axis, angle in zip(self.columns, self._child[0], self._angles(qpos)[0][0], strict=True):
            if angle < least:
                more = quat.from_rotation_vector((least - angle) * axis)
                out[columns] = quat.product(quat.normalise(out[columns]), more)
        return out

    @cached_property
    def _rest(self) -> Array:
        """The rotations of the joints at rest, (k, 3, 3)."""
        return quat.matrices(np.array([self.figure.links[joint.link].turn for joint in self.limits.joints]))

    @cached_property
    def _child(self) -> Array:
        """The lateral and long axes of the children in their frames, (2, k, 3)."""
        return np.einsum("nij,bin->bnj", self._rest, self.limits.axes[1][:0:-1])

    def _angles(self, qpos: Array) -> tuple[Array, Array]:
        """Return the angles of the joints (3, k), and their derivatives by their degrees of freedom (3, k, 3)."""
        turn = self._rest @ quat.matrices(qpos[self.columns])
        angles, axes = bend_angles(self.limits.axes[1], np.einsum("nij,bnj->bin", turn, self._child))
        return angles, np.einsum("nij,ian->anj", turn, axes)

    def linearise(self, qpos: Array, nv: int) -> tuple[Part, Part]:
        """Return the weighted sideways and twist angles (2 k,) and the excess over bounds (5 k,), with Jacobians."""
        angles, slopes = self._angles(qpos)
        by = np.zeros((*angles.shape, nv))
        by[:, np.arange(len(self.dofs))[:, None], self.dofs] = slopes
        crooked = STRAIGHT * angles[1:].ravel(), STRAIGHT * by[1:].reshape(-1, nv)
        over = self.limits.excess(angles).ravel() + INSIDE
        return crooked, (over, (SIGN[:, None, None] * by[ANGLE]).reshape(-1, nv))
