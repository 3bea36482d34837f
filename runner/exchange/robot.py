"""A figure in the convention of robotics: one tree of bodies on a free root, with a list of hinges and slides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.root import root_of, subtree

from ..errors import EXPORT_SKELETON, GIVE_FIGURE, UserError


def joint_name(model: mujoco.MjModel, joint: int) -> str:
    """Return the name of a joint in files, with its number if the model has none."""
    return model.joint(joint).name or f"joint{joint}"


def body_name(model: mujoco.MjModel, body: int) -> str:
    """Return the name of a body in files, likewise."""
    return model.body(body).name or f"body{body}"


@dataclass(frozen=True, eq=False)
class Robot:
    """The tree of a model's root, with hinges and slides otherwise.

    bodies  the root first; joints  hinges and slides; root  first column of the root in qpos
    objects  names of free objects, which are not part of it
    """

    model: mujoco.MjModel
    bodies: list[int]
    joints: list[int]
    root: int
    objects: list[str]

    @classmethod
    def of(cls, model: mujoco.MjModel, form: str) -> Robot:
        """Return the robot of a model without ball joints; raises UserError that names the format for other models."""
        root = root_of(model)
        if root is None or root.rivals:
            many = "none" if root is None else len(root.rivals) + 1
            raise UserError(f"the format '{form}' is for a figure with one free joint, its root; this one has {many}")
        bodies = [body for body in range(model.nbody) if model.body_rootid[body] == root.body]
        free = np.flatnonzero(model.jnt_type == JointKind.FREE).tolist()
        joints = [joint for joint in range(model.njnt) if joint not in free]
        refuse_balls(model, joints, form)
        outside = next((joint for joint in joints if int(model.jnt_bodyid[joint]) not in bodies), None)
        if outside is not None:
            name = model.joint(outside).name
            raise UserError(
                f"the format '{form}' holds one figure on a free root; the joint '{name}' is of another body"
            )
        objects = [body_name(model, int(model.jnt_bodyid[joint])) for joint in free if joint != root.joint]
        return cls(model, bodies, joints, int(model.jnt_qposadr[root.joint]), objects)

    @property
    def notes(self) -> list[str]:
        """A note on the objects, if there are any."""
        return [f"the format has no objects: {', '.join(self.objects)} left out"] if self.objects else []

    @property
    def joint_names(self) -> list[str]:
        return [joint_name(self.model, joint) for joint in self.joints]

    @property
    def body_names(self) -> list[str]:
        return [body_name(self.model, body) for body in self.bodies]

    @property
    def columns(self) -> list[int]:
        """The columns of the joints in qpos."""
        return [int(self.model.jnt_qposadr[joint]) for joint in self.joints]

    @property
    def dofs(self) -> list[int]:
        """The columns of the joints in qvel."""
        return [int(self.model.jnt_dofadr[joint]) for joint in self.joints]


def configurations(
    model: mujoco.MjModel,
    form: str,
    where: object,
    position: Array,
    rotation: Array,
    joints: Array,
    names: Sequence[str] | None = None,
) -> Array:
    """Return qpos (T, nq) of a figure without ball joints, from a root pose and scalar joints.

    position (T, 3), rotation (T, 4) wxyz of the root; joints (T, n) [rad, m], named by `names` or in the figure's
    order. where: label of the file in errors.
    """
    root = root_of(model)
    if root is None or root.is_ambiguous:
        raise UserError(f"{where}: the format '{form}' is for one figure with a free joint")
    figure_joints = robot_joints(model)
    refuse_balls(model, figure_joints, form)
    expected = [joint_name(model, joint) for joint in figure_joints]
    if names is None and joints.shape[1] != len(expected):
        raise UserError(f"{where}: {joints.shape[1]} joints; the figure has {len(expected)}: {', '.join(expected)}")
    if names is not None and joints.shape[1] != len(names):
        raise UserError(f"{where}: {joints.shape[1]} columns of joints with {len(names)} names")
    order = list(range(len(expected))) if names is None else _order(list(names), expected, where)
    qpos, start = np.tile(model.qpos0, (len(joints), 1)), int(model.jnt_qposadr[root.joint])
    qpos[:, start : start + 7] = np.concatenate([position, rotation], axis=1)
    qpos[:, model.jnt_qposadr[figure_joints]] = joints[:, order]
    return qpos


def refuse_balls(model: mujoco.MjModel, joints: Sequence[int], form: str) -> None:
    """Raise UserError if one of the joints is a ball joint."""
    ball = next((joint for joint in joints if model.jnt_type[joint] == JointKind.BALL), None)
    if ball is not None:
        raise UserError(
            f"the format '{form}' contains hinges and slides only; '{joint_name(model, ball)}' is a "
            "ball joint: use a figure of hinges, or one of the formats csv, npz, mjcf, mimickit and bvh"
        )


def robot_joints(model: mujoco.MjModel) -> list[int]:
    """Return MuJoCo's ids of the figure's joints, without those of its root and of free objects."""
    root = root_of(model)
    if root is None:
        return list(range(model.njnt))
    is_part = subtree(model, root.body)[model.jnt_bodyid]
    return [joint for joint in np.flatnonzero(is_part).tolist() if joint != root.joint]


def _order(names: list[str], joints: list[str], where: object) -> list[int]:
    """Return the indices of the figure's joints in the file; raises UserError unless both have the same joints."""
    missing = [name for name in joints if name not in names]
    if missing:
        raise UserError(
            f"{where}: no joint '{missing[0]}'; it has: {', '.join(names)}; the figure: {', '.join(joints)}; "
            f"{EXPORT_SKELETON}"
        )
    foreign = [name for name in names if name not in joints]
    if foreign:
        raise UserError(f"{where}: the figure has no joint '{foreign[0]}'; it has: {', '.join(joints)}")
    return [names.index(name) for name in joints]


def needs_figure(model: mujoco.MjModel | None, where: object) -> mujoco.MjModel:
    """Return the figure for a file; raises UserError if there is none."""
    if model is None:
        raise UserError(f"{where}: it is for a figure, which it does not hold; {GIVE_FIGURE}")
    return model
