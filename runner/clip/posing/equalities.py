"""Poses moved onto a model's equality constraints: loops (connect, weld), couplings of joints and tendons.

Residuals and derivatives are `efc_pos` and `efc_J` of MuJoCo's equality rows: a goal of inverse kinematics.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.posing import posed

OPEN = {"m": 1e-3, "degrees": 0.1}  # least violation of a constraint or of a range that is reported


@dataclass(frozen=True)
class Opening:
    """The violation of one equality constraint by a pose: `amount` in `unit`, "m" or "degrees"."""

    name: str
    amount: float
    unit: str

    def __str__(self) -> str:
        return f"equality constraint '{self.name}' open by {in_words(self.amount, self.unit)}"


def in_words(amount: float, unit: str) -> str:
    """Return an amount in "m" or "degrees" in the notation of messages."""
    return f"{1000 * amount:.3g} mm" if unit == "m" else f"{amount:.3g}°"


class Equalities:
    """The active equality constraints of a model, at any pose; with `is_inner`, only those within trees of bodies."""

    def __init__(self, figure: Figure, *, is_inner: bool = False) -> None:
        self.figure, self.model = figure, _bare(figure.model)
        if is_inner:
            for number in range(self.model.neq):
                self.model.eq_active0[number] &= _is_inner(self.model, number)
        self.data = mujoco.MjData(self.model)

    def residuals(self, qpos: Array) -> tuple[Array, Array]:
        """Return the residuals (r,) [m, rad] and their derivatives by the degrees of freedom (r, nv)."""
        self.data.qpos[:] = qpos
        mujoco.mj_fwdPosition(self.model, self.data)
        rows = self._rows
        matrix = (
            np.array(self.data.efc_J).reshape(-1, self.model.nv) if self.data.nefc else np.zeros((0, self.model.nv))
        )
        return np.array(self.data.efc_pos)[rows], matrix[rows]

    def open(self, qpos: Array) -> list[Opening]:
        """Return the constraints that a pose (nq,) leaves open, the widest first."""
        residual, _ = self.residuals(qpos)
        owner = np.array(self.data.efc_id)[self._rows]
        openings: list[Opening] = []
        for number in dict.fromkeys(owner.tolist()):
            openings += _openings(self.model, int(number), residual[owner == number])
        return sorted(
            (opening for opening in openings if opening.amount > OPEN[opening.unit]),
            key=lambda opening: -opening.amount,
        )

    def closed(self, qpos: Array) -> Array | None:
        """Return the pose nearest to qpos (nq,) that closes all constraints, within the joints' ranges; None if no such
        pose is found.

        Free joints are constant unless nothing else closes the constraints.
        """
        figure = self.figure
        rigid, free = np.ones(figure.width, bool), np.ones(figure.width, bool)
        for link in figure.links[1:]:
            rigid[link.columns] = link.kind is not JointKind.FREE
        for movable in (rigid, free) if not rigid.all() else (free,):
            pose = posed(figure, qpos, movable, (self,))
            if pose.is_met:
                return pose.qpos
        return None

    def coupled(self, qpos: Array, free: Mask) -> Mask:
        """Return a mask (nq,) with the entries of the joints that move with those of another mask at a pose (nq,)."""
        model, joints = self.model, self.figure.links[1:]
        rows = self.residuals(qpos)[1] != 0
        pairs = np.zeros((model.neq, model.nv), bool)
        for number in np.flatnonzero(np.array(self.data.eq_active) * (model.eq_type == int(mujoco.mjtEq.mjEQ_JOINT))):
            ids = [i for i in (model.eq_obj1id[number], model.eq_obj2id[number]) if i >= 0]
            pairs[number, model.jnt_dofadr[ids]] = True
        rows, out = np.concatenate([rows, pairs]), np.array(free, bool)
        for _ in joints:
            moving = np.zeros(model.nv, bool)
            for link in joints:
                moving[link.dofs] = out[link.columns].all() and link.kind is not JointKind.FREE
            reached: Mask = np.any(rows[rows[:, moving].any(axis=1)], axis=0)
            before = out.copy()
            for link in joints:
                out[link.columns] |= reached[link.dofs].any() and link.kind is not JointKind.FREE
            if np.array_equal(out, before):
                break
        return out

    # a goal of inverse kinematics

    name = "equality constraints"

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return np.flatnonzero(model.body_dofnum).tolist()

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return self.residuals(data.qpos)[0]

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return self.residuals(data.qpos)[1]

    @property
    def _rows(self) -> Mask:
        return np.array(self.data.efc_type) == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)


def _is_inner(model: mujoco.MjModel, number: int) -> bool:
    """Return whether an equality constraint is between joints, or between bodies of one tree."""
    if int(model.eq_type[number]) not in (int(mujoco.mjtEq.mjEQ_CONNECT), int(mujoco.mjtEq.mjEQ_WELD)):
        return True
    bodies = [int(model.eq_obj1id[number]), int(model.eq_obj2id[number])]
    if int(model.eq_objtype[number]) == int(mujoco.mjtObj.mjOBJ_SITE):
        bodies = [int(model.site_bodyid[site]) for site in bodies]
    return bool(model.body_weldid[bodies].all() and np.ptp(model.body_rootid[bodies]) == 0)


def _bare(model: mujoco.MjModel) -> mujoco.MjModel:
    """Return a copy with equality constraints only, and dense derivatives."""
    out, bits = copy.copy(model), mujoco.mjtDisableBit
    others = (bits.mjDSBL_CONTACT, bits.mjDSBL_LIMIT, bits.mjDSBL_FRICTIONLOSS)
    out.opt.disableflags &= ~(int(bits.mjDSBL_EQUALITY) | int(bits.mjDSBL_CONSTRAINT))
    for bit in others:
        out.opt.disableflags |= int(bit)
    out.opt.jacobian = int(mujoco.mjtJacobian.mjJAC_DENSE)
    return out


def _openings(model: mujoco.MjModel, number: int, residual: Array) -> list[Opening]:
    """Return the violations of one constraint, in metres and degrees."""
    kinds, kind = mujoco.mjtEq, int(model.eq_type[number])
    name = model.equality(number).name or _between(model, number)
    if kind == int(kinds.mjEQ_WELD):
        scale = float(model.eq_data[number, 10]) or 1.0
        turned = 2 * np.degrees(np.linalg.norm(residual[3:]) / scale)
        return [Opening(name, float(np.linalg.norm(residual[:3])), "m"), Opening(name, float(turned), "degrees")]
    if kind == int(kinds.mjEQ_JOINT):
        hinge = int(model.jnt_type[model.eq_obj1id[number]]) == JointKind.HINGE
        amount = float(np.abs(residual).max(initial=0.0))
        return [Opening(name, float(np.degrees(amount)), "degrees") if hinge else Opening(name, amount, "m")]
    return [Opening(name, float(np.linalg.norm(residual)), "m")]


def _between(model: mujoco.MjModel, number: int) -> str:
    """Return a name for an unnamed constraint: those of the two elements that it connects."""
    kind = mujoco.mjtObj(int(model.eq_objtype[number]))
    if int(model.eq_type[number]) == int(mujoco.mjtEq.mjEQ_JOINT):
        kind = mujoco.mjtObj.mjOBJ_JOINT
    if int(model.eq_type[number]) == int(mujoco.mjtEq.mjEQ_TENDON):
        kind = mujoco.mjtObj.mjOBJ_TENDON
    ids = [int(i) for i in (model.eq_obj1id[number], model.eq_obj2id[number]) if i >= 0]
    return " and ".join(mujoco.mj_id2name(model, kind, i) or str(i) for i in ids)
