"""The poses of a figure that follow a recording: rotations of bodies, and positions of hands and feet.

Limb directions alone do not give these positions if the figure's limbs have other proportions than the skeleton's: a
robot's leg begins with a bracket that offsets it from the hip. Every pose is found by inverse kinematics, from the one
before it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.posing import PoseSearch, Residuals, joined

PLACE = 0.01  # [m] position error of a hand or foot that counts as a residual of 1
TURN, TURN_OF_END, TURN_OF_TRUNK = np.radians((15, 4, 1))  # [rad] errors of a limb's parts, its end, and other bodies
RANGE = 1e3  # [1/rad] weight of joint ranges
STEPS, LONGEST = 30, 0.3  # most iterations of least squares; [rad] largest change of a joint in one
STILL = 1e-3  # [rad] step below which a pose has converged
STARTS = 12  # starting poses of the first sample
FAR = 4.0  # [1] increase of the cost between two samples after which the rest pose is another start


@dataclass
class RecordedPoses:
    """Targets in every sample, as one goal of inverse kinematics for the current sample.

    turns  target orientations in the world {body: (T, 4)}
    limbs  bodies from the first one of a limb to hand or foot, and the target (T, 3) [m] of the last one relative to
           the first
    """

    turns: Mapping[int, Array]
    limbs: Sequence[tuple[Sequence[int], Array]]
    sample: int = 0
    name: str = "recording"
    inverse: Array = field(init=False)  # (T, b, 4) inverse rotations of the targets
    spread: Array = field(init=False)  # (b, 1) [rad]

    def __post_init__(self) -> None:
        of_limb = {body: TURN for bodies, _ in self.limbs for body in bodies}
        of_limb |= {bodies[-1]: TURN_OF_END for bodies, _ in self.limbs}
        self.inverse = quat.inverse(np.stack(list(self.turns.values()), axis=1))
        self.spread = np.array([[of_limb.get(body, TURN_OF_TRUNK)] for body in self.turns])

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return [*self.turns, *(body for bodies, _ in self.limbs for body in bodies)]

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        away = quat.rotation_vector(quat.product(data.xquat[list(self.turns)], self.inverse[self.sample]))
        off = [data.xpos[b[-1]] - data.xpos[b[0]] - about[self.sample] for b, about in self.limbs]
        return np.concatenate([(away / self.spread).ravel(), *(part / PLACE for part in off)])

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        turned, moved = np.zeros((len(self.turns), 3, model.nv)), np.zeros((len(self.limbs), 2, 3, model.nv))
        for row, body in zip(turned, self.turns, strict=True):
            mujoco.mj_jacBody(model, data, None, row, body)
        for pair, (bodies, _) in zip(moved, self.limbs, strict=True):
            for row, body in zip(pair, (bodies[-1], bodies[0]), strict=True):
                mujoco.mj_jacBody(model, data, row, None, body)
        by_end = (moved[:, 0] - moved[:, 1]) / PLACE
        return np.concatenate([turned / self.spread[:, :, None], by_end]).reshape(-1, model.nv)


def followed(model: mujoco.MjModel, qpos: Array, poses: RecordedPoses, root: slice) -> Array:
    """Return qpos (T, nq) that follow the targets, with all joints in their ranges; root: the columns that stay."""
    figure, out = Figure(model), np.array(qpos)
    free = np.ones(figure.width, bool)
    free[root] = False
    search = PoseSearch(figure, model.qpos0, free, (poses,), None)

    def residuals(pose: Array) -> Residuals:
        _, (off, by_off), (over, by_over) = search.linearised(pose)
        return Residuals.of_one(*joined([(off, by_off), (RANGE * over, RANGE * by_over)]), off.size)

    def descended(start: Array) -> tuple[Array, float]:
        return search.descended(residuals, start, STEPS, longest=LONGEST, smallest=STILL)

    last = 0.0
    for i, row in enumerate(out if search.dofs.size else ()):
        poses.sample = i
        starts = [search.clipped(row), *search.starts_around(STARTS)] if i == 0 else [np.where(free, out[i - 1], row)]
        found = [descended(np.where(free, start, row)) for start in starts]
        if i and found[0][1] > FAR * max(last, 1.0):
            found.append(descended(search.clipped(row)))
        pose, last = min(found, key=lambda each: each[1])
        out[i] = search.clipped(pose)
    return out
