"""Bending of limbs, so that hands and feet have the scaled positions of a captured skeleton relative to shoulder and
hip.

Limb directions alone do not give these positions if the figure's limbs have other proportions than the skeleton's: a
robot's leg begins with a bracket that offsets it from the hip. All samples are bent at once, each from the pose that
has the directions, by damped least squares on the limb's hinges and ball joints.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.posing import LeastSquares, Residuals

from .hierarchy import joints

PLACE = 0.01  # [m] position error of a hand or foot that counts as a residual of 1
TURN, TURN_OF_END = np.radians(15), np.radians(4)  # [rad] rotation errors of a limb's parts and its end that count as 1
RANGE = 1e3  # [1/rad] weight of joint ranges
STEPS, LONGEST = 30, 0.3  # most iterations of least squares; [rad] largest change of a joint in one
STILL = 1e-4  # [rad] step below which a sample has converged
RUN = 2000  # most samples bent at once, which bounds the memory
TURNING = [JointKind.HINGE, JointKind.BALL]


@dataclass(frozen=True)
class Limb:
    """bodies, from the first one of the limb to hand or foot; about (T, 3) [m] target of its end relative to the first
    body, or None for any position; turns {body: (T, 4)} target orientations in the world"""

    bodies: Sequence[int]
    about: Array | None
    turns: Mapping[int, Array]

    def during(self, run: slice) -> Limb:
        about = None if self.about is None else self.about[run]
        return Limb(self.bodies, about, {body: turn[run] for body, turn in self.turns.items()})


@dataclass(frozen=True, eq=False)
class Chain:
    """Bodies in all samples: position [m] of the last (T, 3) relative to the first, and rotations {body: (T, 4)}.

    Its D degrees of freedom have axes (T, D, 3) and anchors (T, D, 3) in the world.
    """

    end: Array
    turn: dict[int, Array]
    axes: Array
    anchors: Array


def bend(model: mujoco.MjModel, qpos: Array, limb: Limb, carried: Array) -> Array:
    """Return qpos (T, nq) with a limb's joints set within their ranges; carried: (T, 4) orientation of its parent."""
    if not np.isin(model.jnt_type[joints(model, limb.bodies)], TURNING).any():
        return qpos  # a robot with rigid arms
    runs = [slice(first, first + RUN) for first in range(0, len(qpos), RUN)]
    return np.concatenate([_bend(model, qpos[run], limb.during(run), carried[run]) for run in runs])


def _bend(model: mujoco.MjModel, qpos: Array, limb: Limb, carried: Array) -> Array:
    """Bend the samples of one run."""
    turning = [joint for joint in joints(model, limb.bodies) if model.jnt_type[joint] in TURNING]
    freedom = [JointKind(model.jnt_type[joint]).freedom for joint in turning]
    owner = np.repeat(turning, freedom)  # (D,) the joint of each degree of freedom
    below = np.searchsorted(limb.bodies, model.jnt_bodyid[owner])  # (D,) index of the body that it moves
    bounded = np.flatnonzero((model.jnt_type[owner] == JointKind.HINGE) & (model.jnt_limited[owner] == 1))
    columns, (low, high) = model.jnt_qposadr[owner[bounded]], model.jnt_range[owner[bounded]].T
    spread = {body: TURN_OF_END if body == limb.bodies[-1] else TURN for body in limb.turns}
    by_range = RANGE * np.concatenate([np.eye(owner.size)[bounded], -np.eye(owner.size)[bounded]])

    def residuals(now: Array, which: Index) -> Residuals:
        state = chain_of(model, now, limb.bodies, carried[which])
        off, rows = list[Array](), list[Array]()
        if limb.about is not None:
            off.append((state.end - limb.about[which]) / PLACE)
            rows.append(np.cross(state.axes, state.end[:, None] - state.anchors) / PLACE)
        for body, target in limb.turns.items():
            away = quat.product(state.turn[body], quat.conjugate(target[which]))
            off.append(quat.rotation_vector(away) / spread[body])
            is_moved = below <= limb.bodies.index(body)
            rows.append(np.where(is_moved[:, None], state.axes, 0.0) / spread[body])
        two_sided = sum(part.shape[1] for part in off)
        off += [RANGE * (now[:, columns] - high), RANGE * (low - now[:, columns])]
        goal_rows = np.swapaxes(np.concatenate(rows, axis=2), 1, 2)
        range_rows = np.broadcast_to(by_range, (len(now), *by_range.shape))
        return Residuals(np.concatenate(off, axis=1), np.concatenate([goal_rows, range_rows], axis=1), two_sided)

    def moved(before: Array, step: Array) -> Array:
        after = before.copy()
        for joint in turning:
            at, of_joint = model.jnt_qposadr[joint], step[:, owner == joint]
            if model.jnt_type[joint] == JointKind.BALL:  # about its own axes
                turned = quat.product(after[:, at : at + 4], quat.from_rotation_vector(of_joint))
                after[:, at : at + 4] = quat.normalised(turned)
            else:
                after[:, at] += of_joint[:, 0]
        after[:, columns] = np.clip(after[:, columns], low, high)
        return after

    problem = LeastSquares(residuals, moved, np.ones(owner.size), STEPS, LONGEST, smallest=STILL)
    return problem.descended(qpos)[0]


def chain_of(model: mujoco.MjModel, qpos: Array, bodies: Sequence[int], carried: Array) -> Chain:
    """Return the forward kinematics of a chain of bodies; carried: (T, 4) orientation of its parent."""
    count, place, turn = len(qpos), np.zeros((len(qpos), 3)), carried
    turns, rows, spots = dict[int, Array](), list[Array](), list[Array]()
    first = np.zeros((count, 3))
    for body in bodies:
        place = place + quat.rotated(turn, model.body_pos[body])
        turn = quat.product(turn, model.body_quat[body])
        for joint in joints(model, [body]):
            at, anchor = model.jnt_qposadr[joint], place + quat.rotated(turn, model.jnt_pos[joint])
            match model.jnt_type[joint]:
                case JointKind.FREE:
                    anchor, turn = qpos[:, at : at + 3], qpos[:, at + 3 : at + 7]
                case JointKind.HINGE:
                    rows.append(quat.rotated(turn, model.jnt_axis[joint]))
                    angle = qpos[:, at] - model.qpos0[at]
                    turn = quat.product(turn, quat.from_rotation_vector(angle[:, None] * model.jnt_axis[joint]))
                    spots.append(anchor)
                case JointKind.BALL:
                    turn = quat.product(turn, qpos[:, at : at + 4])
                    rows += [quat.rotated(turn, axis) for axis in np.eye(3)]
                    spots += [anchor] * 3
                case JointKind.SLIDE:
                    along = quat.rotated(turn, model.jnt_axis[joint])
                    anchor = anchor + (qpos[:, at] - model.qpos0[at])[:, None] * along
            place = anchor - quat.rotated(turn, model.jnt_pos[joint])
        turns[body] = turn
        first = place if body == bodies[0] else first
    axes, anchors = (np.reshape(part, (-1, count, 3)).swapaxes(0, 1) for part in (rows, spots))
    return Chain(place - first, turns, axes, anchors - first[:, None])
