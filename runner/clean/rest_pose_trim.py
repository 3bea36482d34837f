"""The lead-in of a recording: the calibration pose of cameras or skeleton before the motion.

There are two signs of it, neither of which a standing person shows. One is a T-pose: both arms straight to the sides,
legs and trunk upright. The other is the figure's rest pose, every joint at zero, left faster than a person can move.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.forward import kinematics
from dynsplines.solver.figure.root import root_of

from ..exchange.skeleton import hierarchy
from ..exchange.skeleton.roles import roles
from ..measure.violation import is_recording
from ..motion import Saved
from ..scene.framing import root_places
from ..system.progress import Progress

OUT = 0.94  # least cosine (20°) between the arms of a T-pose and the lateral direction
UPRIGHT = 0.8  # least cosine (37°) between its trunk and legs, which may be spread, and the vertical
AT_REST = np.radians(0.5)  # [rad] largest angle of a joint at rest
JUMP = 20.0  # [rad/s] least speed of a joint from the rest pose; people approach it only in throws and kicks,
SUDDEN = 4.0  # which do not end within a sample: least ratio of this speed to the next one
HELD = 0.1  # [s] shortest T-pose without a jump, to exclude arms that swing through it
SLOW = 0.2  # [m/s] largest speed of the hips in a T-pose, to exclude walking with spread arms
LEAST = 2  # least number of samples that remain
REST = "the figure's rest pose"


@dataclass(frozen=True)
class RestPose:
    """The samples before or after the motion: number, times [s], what they show, and "begins" or "ends"."""

    count: int
    first: float
    last: float
    what: str
    where: str

    @property
    def line(self) -> str:
        """ "the recording begins with a T-pose (1 image, 0.000 s), no motion" """
        span = f"{self.first:.3f} s" if self.count == 1 else f"{self.first:.3f} to {self.last:.3f} s"
        images = f"{self.count} image{'s' * (self.count > 1)}"
        return f"the recording {self.where} with {self.what} ({images}, {span}), no motion"


def find_rest_pose(model: mujoco.MjModel, times: Array, qpos: Array, *, at_end: bool = False) -> RestPose | None:
    """Return the lead-in of qpos (T, nq) at times (T,) [s], or that of the motion played backward; None without one, or
    if nothing else would remain."""
    limbs = _limbs(model)
    times, qpos = (-times[::-1], qpos[::-1]) if at_end else (times, qpos)
    for what, shows in (("a T-pose", partial(_is_spread, model, limbs)), (REST, partial(_is_at_rest, model))):
        if what != REST and not limbs:
            continue
        count = next((i for i, row in enumerate(qpos) if not shows(row)), len(qpos))
        if not 0 < count <= len(qpos) - LEAST:
            continue
        is_still = times[count - 1] - times[0] >= HELD and _travel(model, times[:count], qpos[:count]) <= SLOW
        if _jumps(model, times, qpos, count) or (is_still and what != REST):
            first, last = sorted(((-1 if at_end else 1) * times[[0, count - 1]]).tolist())
            return RestPose(count, first, last, what, "ends" if at_end else "begins")
    return None


def of_motion(saved: Saved) -> RestPose | None:
    """Return the lead-in of a recording; None for any other motion."""
    if not is_recording(saved) or saved.text:
        return None
    times = np.array([key.time for key in saved.keys])
    return find_rest_pose(saved.figure.model, times, np.array([key.state for key in saved.keys]))


def without(saved: Saved) -> Saved:
    """Return a recording without its lead-in, at unchanged times: the spline through the remaining samples."""
    pose = of_motion(saved)
    if pose is None:
        return saved
    keys = saved.keys[pose.count :]
    raw = raw_timeline(saved.figure, list(keys))
    return replace(saved, keys=keys, timeline=raw, raw=raw, trace=[], report={})


def trim(saved: Saved, progress: Progress, *, skip: bool) -> Saved:
    """Report the rest pose before a recorded motion, and remove it with `skip`; return any other motion unchanged."""
    rest_pose = of_motion(saved)
    if rest_pose is not None:
        progress.report(f"note: {rest_pose.line}: {'left out' if skip else '--skip-rest leaves it out'}")
    elif skip:
        progress.report("note: --skip-rest: no T-pose or rest pose stands before the motion; nothing is left out")
    return without(saved) if skip else saved


def _is_at_rest(model: mujoco.MjModel, qpos: Array) -> bool:
    """Return whether every joint is at zero; a person may stand so, thus it is no sign by itself."""
    move = _moved(model, model.qpos0, qpos)
    return bool(move.size) and float(np.abs(move).max()) < AT_REST


def _limbs(model: mujoco.MjModel) -> dict[str, int]:
    """Return bodies by role, none unless both arms and legs are known by name."""
    bodies = roles(hierarchy.names(model)[1:], [int(p) - 1 for p in model.body_parentid[1:]])
    parts = ("upper_arm", "forearm", "thigh", "shin")
    if any(f"{side}_{part}" not in bodies for side in ("left", "right") for part in parts):
        return {}
    return {role: 1 + body for role, body in bodies.items()}


def _is_spread(model: mujoco.MjModel, bodies: dict[str, int], qpos: Array) -> bool:
    """Return whether a figure is in a T-pose."""
    data = kinematics(model, qpos)
    at = {role: data.xpos[body] for role, body in bodies.items()}
    leftward = at["left_thigh"] - at["right_thigh"]
    hips, shoulders = (0.5 * (at[f"left_{part}"] + at[f"right_{part}"]) for part in ("thigh", "upper_arm"))
    up = np.array([0.0, 0, 1])
    pairs = [(shoulders - hips, up, UPRIGHT)]
    for side, sign in (("left", 1.0), ("right", -1.0)):
        elbow, forearm = at[f"{side}_forearm"], bodies[f"{side}_forearm"]
        end = data.xmat[forearm].reshape(3, 3) @ hierarchy.end(model, forearm)
        pairs.append((elbow - at[f"{side}_upper_arm"], sign * leftward, OUT))
        pairs.append((at[f"{side}_hand"] - elbow if f"{side}_hand" in at else end, sign * leftward, OUT))
        pairs.append((at[f"{side}_shin"] - at[f"{side}_thigh"], -up, UPRIGHT))
    return all(_cosine(limb, direction) > least for limb, direction, least in pairs)


def _cosine(one: Array, other: Array) -> float:
    sizes = float(np.linalg.norm(one) * np.linalg.norm(other))
    return float(one @ other) / sizes if sizes > 0 else 0.0


def _moved(model: mujoco.MjModel, one: Array, other: Array) -> Array:
    """Return angles [rad] of all ball joints and hinges between two configurations."""
    move = np.zeros(model.nv)
    mujoco.mj_differentiatePos(model, move, 1.0, one, other)
    joints = zip(map(JointKind, model.jnt_type), model.jnt_dofadr, strict=True)
    turning = [(kind, dof) for kind, dof in joints if kind in (JointKind.BALL, JointKind.HINGE)]
    return np.array([np.linalg.norm(move[dof : dof + kind.freedom]) for kind, dof in turning], float)


def _jumps(model: mujoco.MjModel, times: Array, qpos: Array, at: int) -> bool:
    """Return whether a joint rotates impossibly fast to sample `at`, and normally after it."""
    into, after = (
        _moved(model, qpos[i - 1], qpos[i]).max(initial=0.0) / (times[i] - times[i - 1]) for i in (at, at + 1)
    )
    return bool(into > max(JUMP, SUDDEN * after))


def _travel(model: mujoco.MjModel, times: Array, qpos: Array) -> float:
    """Return the mean speed [m/s] of the root from the first sample to the last; zero without a root."""
    root = root_of(model)
    if root is None:
        return 0.0
    first, last = root_places(model, root, qpos[[0, -1]])
    return float(np.linalg.norm(last - first) / (times[-1] - times[0]))
