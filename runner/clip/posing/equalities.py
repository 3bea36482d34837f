"""Poses moved onto a model's equality constraints: loops (connect, weld), couplings of joints and tendons.

Residuals and derivatives are `efc_pos` and `efc_J` of MuJoCo's equality rows. Each step is the shortest one that closes
them, damped (K. Levenberg 1944; D. W. Marquardt 1963), within the joints' ranges.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask

CLOSED = 1e-9  # [m, rad] largest residual of a closed constraint
STEPS, STARTS = 200, 12
LONGEST = 0.3  # [rad, m] longest step
FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 1e-6, 1e-12, 1e6
OPEN = {"m": 1e-3, "degrees": 0.1}  # least violation of a constraint that is reported


@dataclass(frozen=True)
class Opening:
    """The violation of one equality constraint by a pose: `amount` in `unit`, "m" or "degrees"."""

    name: str
    amount: float
    unit: str

    def __str__(self) -> str:
        size = f"{1000 * self.amount:.3g} mm" if self.unit == "m" else f"{self.amount:.3g}°"
        return f"equality constraint '{self.name}' open by {size}"


class Equalities:
    """The active equality constraints of a model, at any pose."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self.model = _bare(model)
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
        """Return the pose near qpos (nq,) that closes all constraints, within the joints' ranges; None without one.

        Free joints are constant unless nothing else closes them.
        """
        free = np.isin(self.model.dof_jntid, np.flatnonzero(self.model.jnt_type == int(mujoco.mjtJoint.mjJNT_FREE)))
        for moves in (~free, np.ones(self.model.nv, bool)):
            for begin in self._starts(qpos, moves):
                pose = self._descend(begin, moves)
                if pose is not None:
                    return pose
            if not free.any():
                return None
        return None

    @property
    def _rows(self) -> Mask:
        return np.array(self.data.efc_type) == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)

    def _starts(self, qpos: Array, moves: Mask) -> Iterator[Array]:
        """Yield initial poses: the given one, then others at increasing distances."""
        yield qpos
        _, rows = self.residuals(qpos)
        involved = moves & np.any(rows != 0, axis=0)
        chance = np.random.default_rng(0)
        for number in range(1, STARTS):
            yield self._stepped(qpos, involved * chance.uniform(-1.5, 1.5, self.model.nv) * number / STARTS)

    def _descend(self, qpos: Array, moves: Mask) -> Array | None:
        qpos, damping = self._stepped(qpos, np.zeros(self.model.nv)), FIRST_DAMPING
        residual, rows = self.residuals(qpos)
        for _ in range(STEPS):
            if np.abs(residual).max(initial=0.0) < CLOSED:
                return qpos
            step = self._step(qpos, residual, rows, moves, damping)
            there = self._stepped(qpos, step)
            after, rows_after = self.residuals(there)
            if np.linalg.norm(after) < np.linalg.norm(residual):
                qpos, residual, rows, damping = there, after, rows_after, max(damping / 5, LEAST_DAMPING)
            else:
                damping *= 8
            if damping > MOST_DAMPING:
                break
        return None

    def _step(self, qpos: Array, residual: Array, rows: Array, moves: Mask, damping: float) -> Array:
        """Return the shortest step (nv,) that closes the residuals, without joints at an end of their range."""
        moves, step = np.array(moves), np.zeros(self.model.nv)
        for _ in range(self.model.nv):
            moving_rows = rows[:, moves]
            step[:] = 0.0
            normal = moving_rows @ moving_rows.T + damping * np.eye(len(moving_rows))
            step[moves] = -moving_rows.T @ np.linalg.lstsq(normal, residual, rcond=None)[0]
            step *= min(1.0, LONGEST / max(float(np.abs(step).max(initial=0.0)), LONGEST))
            blocked = moves & self._leaves(qpos, step)
            if not blocked.any():
                return step
            moves &= ~blocked
        return step

    def _leaves(self, qpos: Array, step: Array) -> Mask:
        """Return the degrees of freedom (nv,) at an end of their range that a step moves beyond it."""
        model, out = self.model, np.zeros(self.model.nv, bool)
        for joint in self._limited:
            dof, at = model.jnt_dofadr[joint], qpos[model.jnt_qposadr[joint]]
            low, high = model.jnt_range[joint]
            out[dof] = (at <= low and step[dof] < 0) or (at >= high and step[dof] > 0)
        return out

    def _stepped(self, qpos: Array, step: Array) -> Array:
        there, model = np.array(qpos), self.model
        mujoco.mj_integratePos(model, there, step, 1.0)
        for joint in self._limited:
            column = model.jnt_qposadr[joint]
            there[column] = np.clip(there[column], *model.jnt_range[joint])
        return there

    @property
    def _limited(self) -> list[int]:
        simple = (int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE))
        return np.flatnonzero(self.model.jnt_limited.astype(bool) & np.isin(self.model.jnt_type, simple)).tolist()


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
        hinge = int(model.jnt_type[model.eq_obj1id[number]]) == int(mujoco.mjtJoint.mjJNT_HINGE)
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
