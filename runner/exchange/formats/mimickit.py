"""Pickle of MimicKit: a dict of frames, each a row of numbers for the root and every joint of a character.

fps        [1/s]
loop_mode  0 for clamp, 1 for wrap, where the last frame is the first again, translated; loops are written as wrap
frames     T rows: root position (3) [m], root rotation (3) as rotation vector [rad], then the bodies depth first: a
           ball joint as rotation vector (3) relative to the parent at rest, a hinge as its angle from rest (1); z up

Source: MimicKit, mimickit/anim/motion.py, motion_lib.extract_pose_data, kin_char_model.dof_to_rot and
mjcf_char_model._parse_sphere_joint. Three hinges on one body, in any order, are a ball joint there; slides and pairs of
hinges are refused. The last frame of a loop is its end, and the rate is the nearest for which this holds.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.tolerances import ROUNDING

from ...errors import UserError
from ...motion import Sampled
from .. import plain_pickle
from ..array_reader import times
from ..recording import Recording
from ..robot import body_name, needs_figure
from ..skeleton.hierarchy import euler_angles

WRAP = 1  # loop_mode of a motion that repeats; 0 of others


@dataclass(frozen=True)
class MimicPart:
    """The joint of one body: its columns in qpos (an angle, a quaternion, or three angles in `order`).

    rest  angles in qpos at rest (`ref` of MJCF), where MimicKit's are zero
    """

    columns: list[int]
    order: str | None = None
    rest: tuple[float, ...] = ()

    @property
    def width(self) -> int:
        return 1 if len(self.columns) == 1 else 3

    def numbers(self, qpos: Array) -> Array:
        """Return the entries (T, width) of frames for configurations (T, nq)."""
        values = qpos[:, self.columns] - (self.rest or 0.0)
        if len(self.columns) == 1:
            return values
        return quat.rotation_vector(values if self.order is None else quat.from_euler(values, self.order))

    def configuration(self, numbers: Array) -> Array:
        """Return the columns of qpos for entries (T, width) of frames."""
        if self.width == 1:
            return numbers + self.rest
        rotation = quat.align_signs(quat.from_rotation_vector(numbers))
        return rotation if self.order is None else euler_angles(rotation[:, None], self.order)[:, 0] + self.rest


def parts(model: mujoco.MjModel) -> tuple[int, list[MimicPart]]:
    """Return the root's first column and the joints of the other bodies; raises UserError for joints MimicKit lacks."""
    kinds = model.jnt_type.tolist()
    if kinds.count(JointKind.FREE) != 1:
        raise UserError("the format 'mimickit' is for a figure with one free joint, its root")
    root = int(model.jnt_bodyid[kinds.index(JointKind.FREE)])
    out = []
    for body in range(model.nbody):
        joints = [j for j in range(model.njnt) if int(model.jnt_bodyid[j]) == body and kinds[j] != JointKind.FREE]
        if not joints:
            continue
        name = body_name(model, body)
        if int(model.body_rootid[body]) != root or body == root:
            raise UserError(f"the format 'mimickit' has no place for the joints of the body '{name}'")
        out.append(_part(model, joints, name))
    return int(model.jnt_qposadr[kinds.index(JointKind.FREE)]), out


def _part(model: mujoco.MjModel, joints: list[int], name: str) -> MimicPart:
    types = [int(model.jnt_type[joint]) for joint in joints]
    columns = [int(model.jnt_qposadr[joint]) for joint in joints]
    if types == [JointKind.BALL]:
        return MimicPart([columns[0] + n for n in range(4)])
    rest = tuple(model.qpos0[columns].tolist())
    if types == [JointKind.HINGE]:
        return MimicPart(columns, rest=rest)
    if types == [JointKind.HINGE] * 3:
        axes = [model.jnt_axis[joint] for joint in joints]
        order = "".join("xyz"[int(np.argmax(axis))] for axis in axes)
        if sorted(order) == list("xyz") and all(axis.max() > 1 - ROUNDING for axis in axes):
            return MimicPart(columns, order, rest)
    raise UserError(
        f"the format 'mimickit' has one ball joint, one hinge, or three about x, y and z a body; '{name}' has others"
    )


def write(sampled: Sampled, path: Path) -> list[str]:
    """Write plain numbers in lists, as MimicKit does; return notes."""
    is_loop = sampled.motion.timeline.ends == "periodic"
    turns = is_loop and bool(Seam.of(sampled.figure, sampled.motion.timeline).turns)
    whole = _period(sampled) if is_loop and not turns else sampled
    root, joints = parts(sampled.model)
    at, turn = whole.qpos[:, root : root + 3], quat.rotation_vector(whole.qpos[:, root + 3 : root + 7])
    frames = np.concatenate([at, turn, *(part.numbers(whole.qpos) for part in joints)], axis=1)
    entries = {"loop_mode": WRAP * (is_loop and not turns), "fps": whole.fps, "frames": frames.tolist()}
    plain_pickle.dump(entries, path)
    if turns:
        return ["the format has no loops that rotate: one period is written, without a loop"]
    if abs(whole.fps - sampled.fps) > ROUNDING:
        return [f"{whole.fps:.6g} samples a second, so that the last is the end of the loop"]
    return []


def _period(sampled: Sampled) -> Sampled:
    """Return one period of a loop at the nearest rate for which its end is a sample."""
    times = sampled.motion.timeline.times
    lasts = float(times[-1] - times[0])
    return Sampled.of(sampled.motion, max(1, round(lasts * sampled.fps)) / lasts)


def recognises(path: Path) -> bool:
    """Return whether a pickle is of this format."""
    return b"loop_mode" in path.read_bytes()


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the figure's joints in its order: the file has as many numbers, but no names."""
    figure = needs_figure(model, path)
    root, joints = parts(figure)
    content = plain_pickle.load(path)
    rate = content.rate("fps", fps)
    frames = content.numbers("frames", "T", "numbers")
    width = 6 + sum(part.width for part in joints)
    if frames.shape[1] != width:
        raise UserError(
            f"{path}: {frames.shape[1]} numbers a frame; the figure has {width}: root 6, "
            f"{sum(part.width == 3 for part in joints)} ball joints 3 each, hinges 1 each"
        )
    qpos = np.tile(figure.qpos0, (len(frames), 1))
    qpos[:, root : root + 3] = frames[:, :3]
    qpos[:, root + 3 : root + 7] = quat.align_signs(quat.from_rotation_vector(frames[:, 3:6]))
    start = 6
    for part in joints:
        qpos[:, part.columns] = part.configuration(frames[:, start : start + part.width])
        start += part.width
    is_loop = "loop_mode" in content and content.number("loop_mode", -np.inf, np.inf, "a number") == WRAP
    notes = ("a loop, of which one period is read",) if is_loop else ()
    return Recording(times(len(frames), rate), qpos, fps=rate, notes=notes)
