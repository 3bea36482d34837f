"""Layout of a robot's arrays: the documented one, which body poses in the same file must confirm.

Body poses beside joint angles are redundant, because forward kinematics must reproduce them.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.root import root_of

from ..errors import UserError
from ..scene.configuration import kinematics_of
from ..scene.framing import spread
from .array_reader import ArrayReader
from .recording import Recording

CLOSE, ALIGNED = 0.02, np.radians(2)  # [m], [rad] allowed difference between forward kinematics and recorded bodies
FALLEN = np.radians(60)  # [rad] tilt of the root that casts doubt on its layout
OFTEN = 0.1  # fraction of samples that are no outliers


@dataclass(frozen=True)
class BodyPoses:
    """Body poses that a file stores in addition to joint angles.

    position (T, b, 3) [m]; rotation (T, b, 4) wxyz or None; names (b,) or None
    is_local  whether positions are relative to the root, as if it were unrotated at the origin
    """

    position: Array
    rotation: Array | None = None
    names: tuple[str, ...] | None = None
    is_local: bool = False


def body_poses(reader: ArrayReader) -> BodyPoses | None:
    """Return the body poses that a file stores with qpos, under the names of MuJoCo and mjlab; None without any."""
    place = next((name for name in ("xpos", "body_pos_w", "body_pos") if name in reader), None)
    if place is None or np.ndim(reader.of(place)) != 3:
        return None
    position = reader.numbers(place, "samples", "bodies", 3)
    rotation = reader.quaternions("xquat", "samples", "bodies", 4) if "xquat" in reader else None
    names = tuple(reader.texts("body_names")) if "body_names" in reader else None
    return BodyPoses(position, rotation, names)


def recording(
    model: mujoco.MjModel,
    where: object,
    time: Array,
    qpos: Array,
    bodies: BodyPoses | None,
    *,
    scalar_last: bool,
    fps: float | None = None,
) -> Recording:
    """Return a recording whose configurations qpos (T, nq) reproduce the body poses of its file.

    Args:
        where: Label of the file in errors.
        scalar_last: Whether quaternions are documented as xyzw, for errors.

    Raises:
        UserError: The body poses differ from those of the figure.
    """
    order = "xyzw" if scalar_last else "wxyz"
    if bodies is not None:
        distance, angle = disagreement(model, qpos, bodies)
        if distance > CLOSE or angle > ALIGNED:
            raise UserError(
                f"{where}: its body poses differ from the figure's at its joint angles [rad], by up to "
                f"{100 * distance:.1f} cm and {np.degrees(angle):.1f}°; name the model that it was recorded with, or "
                f"convert the file: quaternions {order}, the root as the first body, and joints by name or in the "
                "model's order"
            )
    is_assumed = bodies is None or bodies.is_local
    return Recording(time, qpos, fps=fps, assumed_layout=f"quaternions {order} and z up" if is_assumed else None)


def check_radians(model: mujoco.MjModel, qpos: Array, where: object) -> None:
    """Raise UserError if a hinge is often more than a turn beyond its range, as are angles in degrees."""
    low, high = model.jnt_range.T
    hinges = np.flatnonzero((model.jnt_type == JointKind.HINGE) & (model.jnt_limited == 1) & (high - low < 2 * np.pi))
    values = qpos[:, model.jnt_qposadr[hinges]]
    is_beyond = (values < low[hinges] - 2 * np.pi) | (values > high[hinges] + 2 * np.pi)
    for column, joint in enumerate(hinges.tolist()):
        if is_beyond[:, column].mean() > OFTEN:
            name, most = model.joint(joint).name, np.abs(values[:, column]).max()
            raise UserError(
                f"{where}: '{name}' goes to {most:.0f} rad, more than a turn beyond its range; convert degrees to "
                f"radians, or give the unit in the heading of a table, '{name} [deg]'"
            )


def doubtful_tilt(model: mujoco.MjModel | None, recorded: Recording, form: str) -> str | None:
    """Return a line if only the documentation of a format states which axis is up or the order of the root's
    quaternions, and the root is far from upright in most samples; None otherwise."""
    if recorded.assumed_layout is None:
        return None
    if model is None:
        assert recorded.scene is not None, "a reader returns a figure or requires one"
        model = recorded.scene.model()
    root = root_of(model)
    if root is None:
        return None
    start = int(model.jnt_qposadr[root.joint]) + 3
    turned = quat.product(recorded.qpos[:, start : start + 4], quat.conjugate(model.qpos0[start : start + 4]))
    tilt = float(np.median(np.arccos(np.clip(quat.rotate(turned, np.array([0, 0, 1.0]))[:, 2], -1, 1))))
    if tilt <= FALLEN:
        return None
    return f"the root is tilted by {np.degrees(tilt):.0f}° with {recorded.assumed_layout}, as the format {form} has it"


def disagreement(model: mujoco.MjModel, qpos: Array, bodies: BodyPoses) -> tuple[float, float]:
    """Return the largest distance [m] and angle [rad] of recorded body poses from those of the figure at qpos (T, nq).

    Recorded bodies are compared with those of their names. If the figure lacks half of the names, or there are none,
    each recorded body is compared with the figure's body that is nearest to it over all samples. So the order of the
    bodies does not matter, nor whether the world is among them. If the figure has fewer bodies, each of them is
    compared with its nearest recorded body instead.
    """
    rows = spread(len(qpos))
    poses = ((data.xpos.copy(), data.xquat.copy()) for data in kinematics_of(model, qpos[rows]))
    position, rotation = (np.array(part) for part in zip(*poses, strict=True))
    root = root_of(model)
    if bodies.is_local and root is not None:
        back = quat.inverse(rotation[:, root.body])[:, None]
        position = quat.rotate(back, position - position[:, [root.body]])
        rotation = quat.product(back, rotation)
    recorded, turned = bodies.position[rows], None if bodies.rotation is None else bodies.rotation[rows]
    ids = {model.body(body).name: body for body in range(model.nbody)}
    pairs = [(column, ids[name]) for column, name in enumerate(bodies.names or ()) if name in ids]
    if len(bodies.names or ()) == recorded.shape[1] < 2 * len(pairs):
        columns, numbers = np.array(pairs).T
        distance = np.linalg.norm(recorded[:, columns] - position[:, numbers], axis=-1)
        angle = np.zeros(1) if turned is None else quat.angle_between(turned[:, columns], rotation[:, numbers])
        return float(distance.max()), float(angle.max())
    away = np.linalg.norm(recorded[:, :, None] - position[:, None], axis=-1).max(axis=0)
    angle = np.zeros_like(away)
    if turned is not None:
        angle = quat.angle_between(turned[:, :, None], rotation[:, None]).max(axis=0)
    if away.shape[0] > away.shape[1]:
        away, angle = away.T, angle.T
    nearest = np.arange(len(away)), np.argmin(np.maximum(away / CLOSE, angle / ALIGNED), axis=1)
    return float(away[nearest].max()), float(angle[nearest].max())
