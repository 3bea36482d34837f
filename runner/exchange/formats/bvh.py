"""BVH: centimetres, y up, the figure faces z; a joint per body, with rotations relative to the model's pose qpos0.

In the model a body's axes at rest may be rotated; in BVH those of a joint never are. So all angles are zero in qpos0.
Roots rotate in the order Y X Z and other joints in Z Y X, so that for a turn or a bent knee the middle angle is far
from ±90°. A body whose position in its parent changes (a slide, or a joint away from the body's origin) has position
channels, too.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.tolerances import SINGLE

from ...motion import Sampled
from ...scene.assets import Scene
from ..array_reader import times
from ..recording import Recording
from ..skeleton import bvh_file, captured_figure, hierarchy, maps, retarget
from ..skeleton.bvh_file import Joint, Skeleton, text_of
from ..skeleton.captured_skeleton import CapturedSkeleton

CENTIMETRES = 100.0  # per metre
PLACES = ("Xposition", "Yposition", "Zposition")


def write(sampled: Sampled, path: Path) -> None:
    """Write the skeleton and its motion as .bvh."""
    path.write_text(text_of(skeleton(sampled)), encoding="utf-8", newline="\n")


def read(path: Path, model: mujoco.MjModel | None, fps: float | None, *, scale: float | None = None) -> Recording:
    """Read the file's skeleton, or its motion on a figure with similar body names.

    fps is unused: the files contain their rate. scale [m]: the file's unit of length; None infers it.
    """
    skeleton = bvh_file.read(path)
    captured = CapturedSkeleton.of(skeleton, scale, maps.current()[0].recording)
    return of_captured(captured, skeleton.fps, path, model)


def of_captured(
    captured: CapturedSkeleton, rate: float, path: Path, model: mujoco.MjModel | None, notes: tuple[str, ...] = ()
) -> Recording:
    """Read a captured motion as a new figure or on a figure; rate [1/s], path is the label in errors."""
    time = times(len(captured.position), rate)
    if model is not None:
        qpos, more = retarget.onto(captured, model, str(path))
        return Recording(time, qpos, fps=rate, notes=(*notes, *captured.notes, *more))
    lift = -captured.ground
    mjcf, qpos = captured_figure.figure(replace(captured, position=np.add(captured.position, [0, 0, lift])))
    return Recording(time, qpos, Scene(mjcf), rate, (*notes, *captured.notes, *retarget.notes_on_lift(lift)))


def skeleton(sampled: Sampled) -> Skeleton:
    """Return the moving bodies as joints, under a fixed root at the origin if they form several trees."""
    model, names = sampled.model, hierarchy.names(sampled.model)
    bodies = [body for body in range(1, model.nbody) if model.body_weldid[body] != 0]
    tops = [body for body in bodies if model.body_weldid[model.body_parentid[body]] == 0]
    at_rest = hierarchy.rest(model)
    place = y_up(sampled.bodies.position)
    turn = _turn(quat.product(sampled.bodies.rotation, quat.conjugate(at_rest.rotation)))
    place_at_rest = y_up(at_rest.position[0])
    rows = ([0] if len(tops) > 1 else []) + bodies
    joints, columns = [], []
    for body in rows:
        above = int(model.body_parentid[body]) if body not in tops or len(tops) > 1 else 0
        above = 0 if body in tops else above
        is_root = body == rows[0]
        relative = quat.product(quat.conjugate(turn[:, above]), turn[:, body])
        moved = quat.rotate(quat.conjugate(turn[:, above]), place[:, body] - place[:, above])
        moves = is_root or float(np.ptp(moved, axis=0).max()) > SINGLE
        order = "YXZ" if is_root or body in tops else "ZYX"
        end = CENTIMETRES * y_up(quat.rotate(at_rest.rotation[0, body], hierarchy.end(model, body)))
        joints.append(
            Joint(
                "_".join(names[body].split()),
                -1 if is_root else rows.index(above),
                np.zeros(3) if moves else CENTIMETRES * (place_at_rest[body] - place_at_rest[above]),
                (*(PLACES if moves else ()), *(f"{axis}rotation" for axis in order)),
                None if body in model.body_parentid[bodies] else end,
            )
        )
        columns += [CENTIMETRES * moved] if moves else []
        columns.append(np.degrees(hierarchy.euler_angles(relative[:, None], order.lower())[:, 0]))
    return Skeleton(tuple(joints), sampled.fps, np.concatenate(columns, axis=1))


def y_up(vector: Array) -> Array:
    """Return (..., 3) converted from z up to y up."""
    return np.roll(vector, -1, axis=-1)


def _turn(q: Array) -> Array:
    """Return rotations (..., 4) converted from z up to y up."""
    return np.concatenate([q[..., :1], y_up(q[..., 1:])], axis=-1)
