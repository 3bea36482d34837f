"""JSON of DeepMimic (and its data/motions/*.txt): the frames of its humanoid, y up.

Loop    "none", "wrap" (the last frame is the first again, translated) or "mirror"; loops are written as "wrap"
Frames  [[duration to the next frame [s], root position (3) [m], root rotation wxyz (4), chest (4), neck (4),
        right_hip (4), right_knee (1), right_ankle (4), right_shoulder (4), right_elbow (1), the left likewise], ...]:
        rotations wxyz relative to the parent, angles [rad] about z

In DeepMimic x is forward, y up and z to the right. Its (x, y, z) is (x, -z, y) in MuJoCo's figures, for vectors and
the vector parts of quaternions alike. At rest its humanoid stands with hanging arms, like the shipped human; knees bend
about -z, elbows about z. Source: xbpeng/DeepMimic, data/characters/humanoid3d.txt, DeepMimicCore/anim/Motion.cpp
(PostProcessFrames: the time of a frame is the sum of the durations before it; the last duration is unused).

Lengths are scaled by the height of the hips above the soles, as DeepMimic's humanoid is smaller; so feet stay on the
ground. Its neck has no counterpart: it is written without rotation and not read. Ball joints at knee and elbow are
written as their rotation about the bending axis; the format cannot represent twist and swing about other axes.
"""

from __future__ import annotations

import json
from pathlib import Path

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import UserError, words_of
from ..array_reader import ArrayReader, unit_quaternions
from ..robot import needs_figure
from ..skeleton.humanoid import Humanoid
from ..trajectory import Recording, SampledTrajectory

NAME = "deepmimic"
LIMB = (("hip", 4), ("knee", 1), ("ankle", 4), ("shoulder", 4), ("elbow", 1))  # numbers per joint: quaternion or angle
# in the order of its frames
JOINTS = (("chest", 4), ("neck", 4), *((f"{side}_{part}", n) for side in ("right", "left") for part, n in LIMB))
OURS = {"chest": "spine"}
WIDTH = 8 + sum(width for _, width in JOINTS)  # numbers per frame: duration, root position and rotation, joints
HIPS = 0.421546 + 0.409870 + 0.0225 + 0.0275  # [m] height of the hips above the soles: thigh, shin, box of the foot
LOST = np.radians(1)  # [rad] least rotation off the axis of a knee or elbow whose loss is reported


def ours(vector: Array) -> Array:
    """Return vectors (..., 3) in MuJoCo's axes, from DeepMimic's."""
    return np.stack([vector[..., 0], -vector[..., 2], vector[..., 1]], -1)


def theirs(vector: Array) -> Array:
    """Return vectors (..., 3) in DeepMimic's axes, from MuJoCo's."""
    return np.stack([vector[..., 0], vector[..., 2], -vector[..., 1]], -1)


def write(trajectory: SampledTrajectory, path: Path) -> None:
    """Write the motion of a person; the last frame of a loop is its end."""
    person = Humanoid.of(trajectory.model, NAME)
    whole = trajectory.period
    steps = np.append(np.full(len(whole.time) - 1, 1 / whole.fps), 0.0)
    position = whole.qpos[:, person.root : person.root + 3] * (HIPS / person.height)
    columns = [steps[:, None], theirs(position), _their_rotation(person.rotation(whole.qpos))]
    lost = {}
    for name, width in JOINTS:
        if name == "neck":
            columns.append(np.tile([1.0, 0, 0, 0], (len(steps), 1)))
            continue
        rotations = person.rotation(whole.qpos, OURS.get(name, name))
        if width == 4:
            columns.append(_their_rotation(rotations))
            continue
        angle = 2 * np.arctan2(rotations[:, 2], rotations[:, 0])
        bent = quat.from_rotation_vector(angle[:, None] * np.array([0, 1.0, 0]))
        lost[name] = float(quat.angle_between(bent, rotations).max())
        columns.append(-np.unwrap(angle)[:, None])
    worst = max(lost, key=lambda name: lost[name])
    if lost[worst] > LOST:
        trajectory.notes.append(
            f"'{worst}' is a hinge there: up to {np.degrees(lost[worst]):.1f}° of twist and swing are left out"
        )
    rows = ",\n".join(json.dumps(row) for row in np.concatenate(columns, 1).tolist())
    loop = "wrap" if trajectory.is_wrapped else "none"
    path.write_text(f'{{\n"Loop": "{loop}",\n"Frames":\n[\n{rows}\n]\n}}\n', encoding="utf-8")


def _their_rotation(rotation: Array) -> Array:
    return np.concatenate([rotation[..., :1], theirs(rotation[..., 1:])], -1)


def recognises(path: Path) -> bool:
    """Return whether a text is of this format."""
    return b'"Frames"' in path.read_bytes()


def read(path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
    """Read the humanoid's motion on a person; raises UserError for skeletons with other numbers per frame."""
    person = Humanoid.of(needs_figure(model, path), NAME)
    content = ArrayReader(path, _parsed(path))
    frames = content.numbers("Frames", "frames", "numbers")
    if frames.shape[1] != WIDTH:
        names = ", ".join(name for name, _ in JOINTS)
        raise UserError(f"{path}: {frames.shape[1]} numbers a frame, not the humanoid's {WIDTH}: time, root, {names}")
    if len(frames) > 1 and frames[:-1, 0].min() <= 0:
        raise UserError(f"{path}: frame {int(np.argmin(frames[:-1, 0])) + 1} lasts {frames[:-1, 0].min():g} s")
    joints, start = {}, 8
    for name, width in JOINTS:
        part = frames[:, start : start + width]
        start += width
        if name == "neck":
            continue
        if width == 1:
            rotation = quat.from_rotation_vector(-part * np.array([0, 1.0, 0]))
        else:
            rotation = _our_rotation(part, name, path)
        joints[OURS.get(name, name)] = rotation
    position = ours(frames[:, 1:4]) * (person.height / HIPS)
    qpos = person.posed(position, _our_rotation(frames[:, 4:8], "root", path), joints)
    steps = frames[:-1, 0]
    rate = float(1 / steps.mean()) if steps.size and np.ptp(steps) < 1e-9 else None
    return Recording(
        np.concatenate([[0.0], np.cumsum(steps)]), qpos, fps=rate, loops=content.entries.get("Loop") == "wrap"
    )


def _our_rotation(part: Array, name: str, path: Path) -> Array:
    rotation = unit_quaternions(part, f"Frames, the rotation of {name}", path)
    return np.concatenate([rotation[:, :1], ours(rotation[:, 1:])], 1)


def _parsed(path: Path) -> dict[str, object]:
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError) as error:
        raise UserError(f"{path}: not JSON: {words_of(error)}") from None
    if not isinstance(content, dict):
        raise UserError(f"{path}: a list, not an object with 'Loop' and 'Frames'")
    return content
