"""Layout of a robot's arrays: the documented one, unless body poses in the same file decide for another.

Body poses beside joint angles are redundant, because forward kinematics must reproduce them. So they decide between the
layouts that occur in such files: the order of the components of quaternions, the order of the joints, and those that
the reader adds. A file without body poses has the documented layout.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.root import root_of

from ..errors import UserError
from ..scene.configuration import posed, quaternions
from ..scene.framing import spread
from .array_reader import ArrayReader
from .skeleton import hierarchy
from .trajectory import Recording

CLOSE, ALIGNED = 0.02, np.radians(2)  # [m], [rad] allowed difference between forward kinematics and recorded bodies
EQUAL = 0.05  # difference in `Disagreement.share` up to which layouts agree equally well with body poses
LOOKED_AT = 60  # samples of a file that are compared, evenly spread
FALLEN = np.radians(60)  # [rad] tilt of the root that casts doubt on the order of its quaternions
OFTEN = 0.1  # fraction of samples that are no outliers
TURN = 2 * np.pi  # [rad]
Reading = Callable[[], Array]
Layout = tuple[str, ...]  # deviations from the documented layout


@dataclass(frozen=True)
class BodyPoses:
    """Body poses that a file stores in addition to joint angles.

    position (T, b, 3) [m]; rotation (T, b, 4) or None; names (b,) or None
    is_wxyz   whether rotations are certainly wxyz, else they may be xyzw
    is_local  whether positions are relative to the root, as if it were unrotated at the origin
    """

    position: Array
    rotation: Array | None = None
    is_wxyz: bool = False
    names: tuple[str, ...] | None = None
    is_local: bool = False


def body_poses(reader: ArrayReader) -> BodyPoses | None:
    """Return the body poses that a file stores with qpos, under the names of MuJoCo and mjlab; None without any."""
    place = next((name for name in ("xpos", "body_pos_w", "body_pos") if name in reader), None)
    if place is None or np.ndim(reader.of(place)) != 3:
        return None
    position = reader.numbers(place, "samples", "bodies", 3)
    turn = next((name for name in ("xquat", "body_quat_w", "body_quat", "body_rot") if name in reader), None)
    rotation = None if turn is None else reader.quaternions(turn, "samples", "bodies", 4)
    names = tuple(reader.texts("body_names")) if "body_names" in reader else None
    return BodyPoses(position, rotation, turn == "xquat", names)


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


def recording(
    model: mujoco.MjModel,
    where: object,
    time: Array,
    readings: Mapping[Layout, Reading],
    bodies: BodyPoses | None,
    *,
    scalar_last: bool,
    has_names: bool,
    fps: float | None = None,
) -> Recording:
    """Return a recording in the layout that reproduces the body poses, with a note if it is not the documented one.

    Args:
        where: Label of the file in errors.
        time: (T,) [s].
        readings: Functions that return qpos (T, nq), wxyz, by their deviations from the documented layout, which is
            first. A function that raises UserError does not fit the file.
        bodies: The body poses; None for the documented layout.
        scalar_last: Whether quaternions are documented as xyzw.
        has_names: Whether the file names its joints, so that their order is certain.

    Raises:
        UserError: No layout fits, or none reproduces the body poses.
    """
    assumed = ("xyzw" if scalar_last else "wxyz") if bodies is None or bodies.is_local else None
    if bodies is None:
        return Recording(time, next(iter(readings.values()))(), fps=fps, assumed_quaternions=assumed)
    candidates: dict[Layout, Array] = {}
    failure: UserError | None = None
    for layout, read in readings.items():
        try:
            qpos = read()
        except UserError as error:
            failure = failure or error
        else:
            candidates |= {(*layout, *more): other for more, other in _variants(model, qpos, scalar_last, has_names)}
    if not candidates:
        assert failure is not None, "a file has a documented layout"
        raise failure
    off = {layout: disagreement(model, qpos, bodies) for layout, qpos in candidates.items()}
    best = min(off.values(), key=lambda each: each.share)
    if best.share > 1:
        raise UserError(
            f"{where}: its body poses differ from the figure's at its joint angles [rad], by up to {best} at best; "
            "name the model that it was recorded with"
        )
    layout = min((one for one, each in off.items() if each.share <= best.share + EQUAL), key=len)
    note = f"read with {' and '.join(layout)}: its body poses differ from the figure's by up to {off[layout]}"
    notes = (note + (f"; as documented by {off[()]}" if () in off else ""),) if layout else ()
    return Recording(time, candidates[layout], fps=fps, notes=notes, assumed_quaternions=assumed)


def check_radians(model: mujoco.MjModel, qpos: Array, where: object) -> None:
    """Raise UserError if a hinge is often more than a turn beyond its range, as are angles in degrees."""
    low, high = model.jnt_range.T
    hinges = np.flatnonzero((model.jnt_type == JointKind.HINGE) & (model.jnt_limited == 1) & (high - low < TURN))
    values = qpos[:, model.jnt_qposadr[hinges]]
    is_beyond = (values < low[hinges] - TURN) | (values > high[hinges] + TURN)
    for column, joint in enumerate(hinges.tolist()):
        if is_beyond[:, column].mean() > OFTEN:
            name, most = model.joint(joint).name, np.abs(values[:, column]).max()
            raise UserError(
                f"{where}: '{name}' goes to {most:.0f} rad, more than a turn beyond its range; convert degrees to "
                f"radians, or give the unit in the heading of a table, '{name} [deg]'"
            )


def check_upright(model: mujoco.MjModel, recorded: Recording, form: str, where: object) -> None:
    """Raise UserError if only the documentation of a format states the order of the root's quaternions, and the root
    is far from upright in most samples."""
    root = root_of(model)
    if recorded.assumed_quaternions is None or root is None:
        return
    start = int(model.jnt_qposadr[root.joint]) + 3
    turned = quat.product(recorded.qpos[:, start : start + 4], quat.conjugate(model.qpos0[start : start + 4]))
    tilt = float(np.median(np.arccos(np.clip(quat.rotated(turned, np.array([0, 0, 1.0]))[:, 2], -1, 1))))
    if tilt > FALLEN:
        raise UserError(
            f"{where}: the root is tilted by {np.degrees(tilt):.0f}° with quaternions {recorded.assumed_quaternions} "
            f"and z up, as the format {form} has them; convert the file, or give --from {form} if that is right"
        )


def disagreement(model: mujoco.MjModel, qpos: Array, bodies: BodyPoses) -> Disagreement:
    """Return how far recorded body poses are from those of the figure at configurations (T, nq).

    Each recorded body is compared with the figure's body that is nearest to it over all samples. So the order of the
    bodies does not matter, nor whether the world is among them. If the figure has fewer bodies, each of them is
    compared with its nearest recorded body instead.
    """
    rows = spread(len(qpos), LOOKED_AT)
    poses = ((data.xpos.copy(), data.xquat.copy()) for data in posed(model, qpos[rows]))
    position, rotation = (np.array(part) for part in zip(*poses, strict=True))
    root = root_of(model)
    if bodies.is_local and root is not None:
        back = quat.inverse(rotation[:, root.body])[:, None]
        position = quat.rotated(back, position - position[:, [root.body]])
        rotation = quat.product(back, rotation)
    columns = _matching_bodies(model, bodies)
    away = np.linalg.norm(bodies.position[rows][:, columns, None] - position[:, None], axis=-1).max(axis=0)
    angles = [np.zeros_like(away)]
    if bodies.rotation is not None:
        shifts = (0,) if bodies.is_wxyz else (0, 1)
        recorded = bodies.rotation[rows][:, columns, None]
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


def _variants(model: mujoco.MjModel, qpos: Array, scalar_last: bool, has_names: bool) -> Iterator[tuple[Layout, Array]]:
    """Yield configurations as they are, and with other orders of quaternions and joints, by their deviations."""
    changes: list[tuple[str, Index, Index]] = []
    if turned := list(quaternions(model).values()):
        columns = np.concatenate([np.arange(model.nq)[each] for each in turned])
        rolled = np.roll(columns.reshape(-1, 4), -1 if scalar_last else 1, axis=1).ravel()
        changes.append((f"quaternions {'wxyz' if scalar_last else 'xyzw'}", columns, rolled))
    if not has_names and (order := breadth_first(model)) is not None:
        changes.append(("joints breadth first", model.jnt_qposadr[order], model.jnt_qposadr[np.sort(order)]))
    for count in range(len(changes) + 1):
        for combination in combinations(changes, count):
            out = qpos.copy()
            for _, target, source in combination:
                out[:, target] = out[:, source]
            yield tuple(words for words, _, _ in combination), out


def breadth_first(model: mujoco.MjModel) -> Index | None:
    """Return hinges and slides in breadth-first order from the root, as Isaac has them.

    None if that is MuJoCo's order, and for figures with ball joints, which no program with that order has.
    """
    if JointKind.BALL in model.jnt_type:
        return None
    joints = np.flatnonzero(model.jnt_type != JointKind.FREE)
    above = []
    for joint in joints:
        body = int(model.jnt_bodyid[joint])
        carriers = hierarchy.above(model, body)
        above.append(int(joint - model.body_jntadr[body]) + int(model.body_jntnum[carriers].sum()))
    order = np.argsort(above, kind="stable")
    return None if np.array_equal(order, np.arange(joints.size)) else joints[order]
