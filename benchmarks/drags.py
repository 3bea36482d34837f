"""Random drags of a standing figure, and the violations of the resulting poses, by MuJoCo's geometry alone."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter

import mujoco
import numpy as np
from scipy.spatial import ConvexHull, QhullError

from dynsplines import models
from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.posing import PointGoal
from dynsplines.solver.surface.points import body_points
from dynsplines.studio.posing import Poser

SOLE_MISS, SOLE_TILT = 1e-3, np.radians(2)  # [m], [rad] permitted of a foot on the ground
RANGE_SHARE, ROUNDING = 0.8, np.radians(0.1)  # permitted share of the ranges of ankles and wrists; [rad]
OUTSIDE = 1e-3  # [m] permitted distance of the centre of mass from the support polygon
PLACED = 0.03  # [m] height below which a foot counts as placed
NEAREST, FARTHEST = 0.05, 0.5  # [m] length of a pull
MOVES, RESTING = 10, 3  # positions of the mouse on the way, and at its end
KINDS = ("soles", "joints", "balance")


@dataclass(frozen=True, eq=False)
class Pull:
    """A point of a body, offset (3,) [m] in its axes, pulled by a vector (3,) [m]."""

    body: int
    offset: Array
    by: Array


@dataclass(frozen=True, eq=False)
class Result:
    """The pose (nq,) after a pull, its violations by kind, the distance [m] to the mouse, and the seconds of every
    call."""

    qpos: Array
    violations: dict[str, str]
    miss: float
    seconds: list[float]


def human_model() -> mujoco.MjModel:
    """Return the shipped human on a floor."""
    return with_floor(mujoco.MjSpec.from_string(models.figure_text("human")))


def with_floor(spec: mujoco.MjSpec) -> mujoco.MjModel:
    """Return a figure's model with a plane at z = 0."""
    spec.worldbody.add_geom(name="pulls_floor", type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 1])
    return spec.compile()


class Pulls:
    """Pulls of a standing figure in its rest pose, with its lowest point on the floor.

    soles  part of the names of the capsules under its feet
    """

    def __init__(self, model: mujoco.MjModel, soles: str) -> None:
        self.model, self.figure = model, Figure(model)
        self.poser = Poser(self.figure, [], np.zeros((0, model.nq)))
        self.data = mujoco.MjData(model)
        capsule = mujoco.mjtGeom.mjGEOM_CAPSULE
        geoms = [g for g in range(model.ngeom) if soles in model.geom(g).name and model.geom_type[g] == capsule]
        self.geoms, self.radius = np.array(geoms), model.geom_size[geoms, 0].repeat(2)
        self.feet = model.geom_bodyid[self.geoms].repeat(2)
        self.ends = [j for j in range(model.njnt) if any(word in model.joint(j).name for word in ("ankle", "wrist"))]
        self.home = np.array(model.qpos0)
        self.home[2] -= float((self._contacts(self.home)[:, 2] - self.radius).min())
        self.points = body_points(self.figure)

    def drawn(self, rng: np.random.Generator) -> Pull:
        """Return a random pull: a body, a point of its surface, a direction and a length, each uniform."""
        bodies = sorted({self.figure.links[point.link].body for point in self.points})
        body = int(rng.choice(bodies))
        candidates = [point for point in self.points if self.figure.links[point.link].body == body]
        offset = PointGoal.of(self.figure, candidates[rng.integers(len(candidates))]).offsets[0]
        direction = rng.normal(size=3)
        return Pull(body, offset, rng.uniform(NEAREST, FARTHEST) * direction / np.linalg.norm(direction))

    def result(self, pull: Pull, moves: int = MOVES) -> Result:
        """Return the pose after a pull in so many moves of the mouse."""
        self._contacts(self.home)
        start, last, seconds = self._place(pull), self.home, []
        grip = self.poser.grip(self.home, pull.body, pull.offset)
        for share in [*np.arange(1, moves + 1) / moves, *[1.0] * RESTING]:
            begin = perf_counter()
            last = self.poser.pull(grip, start + share * pull.by, last).qpos
            seconds.append(perf_counter() - begin)
        self._contacts(last)
        missed = float(np.linalg.norm(self._place(pull) - start - pull.by))
        return Result(last, self.violations(last, pull.body), missed, seconds)

    def violations(self, qpos: Array, body: int) -> dict[str, str]:
        """Return the violations of a pose of a figure that is dragged by a body, by kind."""
        out = dict[str, str]()
        before, places = self._contacts(self.home), self._contacts(qpos)
        height = places[:, 2] - self.radius
        feet = [text for foot in np.unique(self.feet) if (text := self._foot(foot, body, before, places))]
        far = [self.model.joint(j).name for j in self.ends if self._beyond(qpos, j) > ROUNDING]
        outside = _outside(places[height < 2 * SOLE_MISS, :2], self.data.subtree_com[1][:2])
        if feet:
            out["soles"] = "; ".join(feet)
        if far:
            out["joints"] = ", ".join(far)
        if outside > OUTSIDE:
            out["balance"] = f"centre of mass {1e3 * outside:.0f} mm outside"
        return out

    def _foot(self, foot: int, body: int, before: Array, places: Array) -> str:
        """Return the violation of a foot: one that stands keeps its place, one that was moved is level or aloft."""
        of_foot = self.feet == foot
        height, moved = (places[:, 2] - self.radius)[of_foot], float(np.abs(places[of_foot] - before[of_foot]).max())
        tilt = np.arccos(np.clip(self.data.xmat[foot].reshape(3, 3)[2, 2], -1, 1))
        is_moved = self._same_leg(body, foot) and moved > SOLE_MISS
        off = float(np.abs(height).max()) if is_moved else moved
        is_wrong = (not is_moved or height.min() < PLACED) and (off > SOLE_MISS or tilt > SOLE_TILT)
        return f"{self.model.body(foot).name} {1e3 * off:.1f} mm, {np.degrees(tilt):.1f} degrees" if is_wrong else ""

    def _place(self, pull: Pull) -> Array:
        return np.array(self.data.xpos[pull.body] + self.data.xmat[pull.body].reshape(3, 3) @ pull.offset)

    def _beyond(self, qpos: Array, joint: int) -> float:
        """Return the angle [rad] by which a joint exceeds its permitted share of the range."""
        at, (low, high) = self.model.jnt_qposadr[joint], self.model.jnt_range[joint]
        if self.model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_BALL:
            return float(2 * np.arccos(np.clip(abs(qpos[at]), 0, 1)) - RANGE_SHARE * high)
        return float(abs(qpos[at] - (low + high) / 2) - RANGE_SHARE * (high - low) / 2)

    def _same_leg(self, body: int, foot: int) -> bool:
        """Return whether a body belongs to the leg of a foot, below the pelvis."""
        chain, parent = [], int(foot)
        while parent:
            chain.append(parent)
            parent = int(self.model.body_parentid[parent])
        return body in chain[:-1]

    def _contacts(self, qpos: Array) -> Array:
        """Return the centres (n, 3) [m] of the capsules' ends."""
        self.data.qpos[:] = qpos
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        along = self.data.geom_xmat[self.geoms][:, [2, 5, 8]] * self.model.geom_size[self.geoms, 1:2]
        centre = self.data.geom_xpos[self.geoms]
        return np.stack([centre - along, centre + along], axis=1).reshape(-1, 3)


def _outside(places: Array, point: Array) -> float:
    """Return the distance [m] of a point (2,) from the convex hull of places (n, 2), infinite if that has no area."""
    try:
        return float((ConvexHull(places).equations @ [*point, 1.0]).max()) if len(places) > 2 else np.inf
    except QhullError:
        return np.inf
