"""Small problems, clips and drags."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

import mujoco
import numpy as np
from figures import ONE_BALL, TINY, figure_of
from gradients import clip, every_penalty, taylor_slope, tiny_clip
from random_models import evenly, mask_without
from scipy.spatial import ConvexHull, QhullError

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Discretised, Evaluation, Objective
from dynsplines.solver.penalty import (
    CovariantAcceleration,
    Penalty,
    RootAcceleration,
    Torque,
    UnitMagnitude,
)
from dynsplines.solver.posing import PointGoal
from dynsplines.solver.refine.subdivision import split
from dynsplines.solver.search.minimum import Minimum
from dynsplines.solver.search.nlopt_methods import minimise
from dynsplines.solver.surface.points import body_points
from dynsplines.studio.posing import Poser

# Small problems as the search sees them: discretised, in unknowns.


def turning(turns: list[float], variable: int) -> tuple[Objective, Timeline]:
    """One ball joint turned about a slanted axis by so many degrees from keyframe to keyframe."""
    figure = figure_of(ONE_BALL)
    axis = np.array([0.6, 0, 0.8])
    poses = [quat.from_rotation_vector(np.radians(angle) * axis) for angle in np.cumsum([0, *turns])]
    raw = raw_timeline(figure, [Frame.key(float(i), pose) for i, pose in enumerate(poses)])
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 10.0)])
    return objective.renormalised(path_of(raw)), evenly(raw, variable)


TERMS: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (UnitMagnitude(), 0.5),
    (RootAcceleration(), 1.0),
    (Torque(), 0.5),
]


def problem_of(rng: np.random.Generator, ends: str = "free", coordinates: str = "world", terms=TERMS) -> Discretised:
    raw = tiny_clip(rng, ends, coordinates, partial=True)
    objective = Objective.of(figure_of(TINY, coordinates), terms).renormalised(path_of(raw))
    return objective.on(evenly(raw, 1))


def discretised(figure: Figure, rng: np.random.Generator, ends: str):
    timeline = clip(figure, rng, ends)
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0)])
    return objective.renormalised(path_of(timeline)).on(evenly(timeline, 2))


def slider(times: np.ndarray, variable: int):
    """One slide under its acceleration energy, the flat case."""
    figure = figure_of('<mujoco><worldbody><body><joint type="slide"/><geom size=".1"/></body></worldbody></mujoco>')
    keys = [Frame.key(t, [np.sin(3 * t)]) for t in times]
    raw = raw_timeline(figure, keys)
    return Objective.of(figure, [(RootAcceleration(), 1.0)]).renormalised(path_of(raw)).on(evenly(raw, variable))


class Watched(Discretised):
    """Counts its evaluations; `spoil` may change what the k-th gives, or raise."""

    def __init__(self, problem: Discretised, spoil: Callable[[int, Evaluation], Evaluation] | None = None) -> None:
        super().__init__(problem.objective, problem.timeline)
        self.values: list[float] = []
        self.points: list[Array] = []
        self.spoil = spoil

    def __call__(self, x: Array) -> Evaluation:
        evaluation = super().__call__(x)
        if self.spoil is not None:
            evaluation = self.spoil(len(self.values) + 1, evaluation)
        self.values.append(evaluation.value)
        self.points.append(x.copy())
        return evaluation


def by_nlopt(
    problem: Discretised, *, method: str = "lbfgs", max_evaluations: int = 5000, tolerance: float = 1e-13
) -> Minimum:
    """By E and its gradient in the unknowns, without any model."""

    def fun(x: Array) -> tuple[float, Array]:
        evaluation = problem(x)
        return evaluation.value, evaluation.gradient

    start = problem.unknowns.start
    return minimise(fun, start, method=method, max_evaluations=max_evaluations, tolerance=tolerance)


# A figure of two bodies and a clip of three keyframes, solved in a moment, for tests of what surrounds the solver.

FIGURE = """
<mujoco model="tiny">
  <compiler angle="degree"/>
  <worldbody>
    <camera name="high" pos="0 -4 1" xyaxes="1 0 0 0 0 1"/>
    <body name="pelvis" pos="0 0 1"><freejoint name="root"/>
      <geom name="trunk" type="sphere" size=".1" mass="4"/>
      <site name="left_toe" pos="0 0 -.1"/>
      <body name="left_shin" pos="0 0 -.2" euler="0 0 30"><joint name="left_knee" type="ball"/>
        <geom name="shin" type="capsule" size=".04" fromto="0 0 0 0 0 -.3" mass="1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""

CLIP = """# Three keyframes, the second of them partial.
figure = "tiny.xml"
fps = 20

[solve]
evaluations = 8
frames = 2

[[keyframe]]
time = 0
root.position = [0, 0, 1]
root.rotation = {rotvec = [0, 0, 0]}
joints.left_knee = {rotvec = [0, 0, 0]}

[[keyframe]]
time = 0.2
root.position = [0.1, 0, "free"]
joints.left_knee = {rotvec = [0, 40, 0]}

[[keyframe]]
time = 0.41
root.position = [0.3, 0, 1]
root.rotation = {rotvec = [0, 10, 170]}
joints.left_knee = {rotvec = [0, 0, 0]}
"""

HINGE = """
<mujoco>
  <compiler angle="degree"/>
  <worldbody>
    <body name="rail" pos="0 0 1"><joint name="slide" type="slide" axis="1 0 0"/><geom name="rail" size=".1" mass="1"/>
      <body name="arm" pos="0 0 -.2"><joint name="swing" type="hinge" axis="0 1 0"/>
        <geom name="arm" type="capsule" size=".04" fromto="0 0 0 0 0 -.3" mass="1"/>
      </body>
    </body>
  </worldbody>
  {keys}
</mujoco>
"""


def written(folder: Path, text: str = CLIP, name: str = "tiny.toml") -> Path:
    """A clip file, and beside it the figures that clips of this file ask for."""
    (folder / "tiny.xml").write_text(FIGURE, encoding="utf-8")
    (folder / "hinge.xml").write_text(HINGE.format(keys=""), encoding="utf-8")
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def changed(old: str, new: str, text: str = CLIP) -> str:
    """The clip with the first occurrence of a piece of it replaced."""
    assert old in text, f"{old!r} is not in the clip"
    return text.replace(old, new, 1)


def names(folder: Path) -> list[str]:
    """What lies in a folder."""
    return sorted(path.name for path in folder.iterdir())


# Random drags of a standing figure, and the violations of the resulting poses, by MuJoCo's geometry alone.

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
    """Pulls of a figure that stands in its rest pose, with its lowest point on the floor.

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
        own = [point for point in self.points if self.figure.links[point.link].body == body]
        offset = PointGoal.of(self.figure, own[rng.integers(len(own))]).offsets[0]
        way = rng.normal(size=3)
        return Pull(body, offset, rng.uniform(NEAREST, FARTHEST) * way / np.linalg.norm(way))

    def result(self, pull: Pull, moves: int = MOVES) -> Result:
        """Return the pose after a pull in so many moves of the mouse."""
        self._contacts(self.home)
        start, last, seconds = self._place(pull), self.home, []
        grip = self.poser.gripped(self.home, pull.body, pull.offset)
        for share in [*np.arange(1, moves + 1) / moves, *[1.0] * RESTING]:
            begin = perf_counter()
            last = self.poser.pulled(grip, start + share * pull.by, last).qpos
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
        own = self.feet == foot
        height, moved = (places[:, 2] - self.radius)[own], float(np.abs(places[own] - before[own]).max())
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


# A loop that hops on, and turns while it does.

PERIOD, STRIDE = 0.8, 0.6
TIMES = [0.0, 0.3, 0.5, PERIOD]
TURN = np.radians(50)  # a period of the circle
CENTRE, UP = np.array([0.1, 0.7, 0.0]), np.array([0.0, 0.0, 1.0])
HOP_TERMS: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (RootAcceleration(), 1.0),
    (UnitMagnitude(), 1.0),
    (Torque(), 0.5),
]


def turned(qpos: Array, angle: float) -> Array:
    """A configuration turned about the vertical through the centre of the circle."""
    turn = quat.from_rotation_vector(angle * UP)
    place = CENTRE + quat.rotated(turn, qpos[:3] - CENTRE)
    return np.concatenate([place, quat.product(turn, qpos[3:7]), qpos[7:]])


def pose(time: float, way: str = "straight") -> Array:
    """qpos of a body that hops while its shin swings: straight along x, also turning about a slanted axis, or round a
    circle."""
    a = 2 * np.pi * time / PERIOD
    far = 0 if way == "circle" else STRIDE * time / PERIOD
    root = [far + 0.1 * np.sin(a), 0.05 * np.sin(a), 1 + 0.03 * np.cos(2 * a)]
    sway = quat.from_rotation_vector([0.2 * np.sin(a), 0.1 * np.cos(a), 0.3 * np.sin(a + 1)])
    turn = quat.product(quat.from_rotation_vector((way == "spinning") * a * np.array([0.6, 0, 0.8])), sway)
    qpos = np.concatenate([root, turn, quat.from_rotation_vector([0, 0.6 + 0.5 * np.sin(a), 0.1 * np.cos(a)])])
    return turned(qpos, TURN * time / PERIOD) if way == "circle" else qpos


def hop(periods: int = 1, way: str = "straight") -> list[Frame]:
    """Keyframes of some periods."""
    times = [0.0] + [t + PERIOD * k for k in range(periods) for t in TIMES[1:]]
    return [Frame.key(t, pose(t, way)) for t in times]


def loop(figure: Figure, way: str, *, partial: bool = False) -> Timeline:
    keys = hop(way=way)
    if partial:
        free = "knee" if way == "spinning" else "root turn"  # without its turn at a third, a full turn would be none
        keys[1] = Frame.key(TIMES[1], keys[1].state, mask_without(figure, free, "root x"))
        keys[-1] = Frame.key(PERIOD, keys[-1].state, mask_without(figure, "root z", "knee"))
    return raw_timeline(figure, keys, "periodic")


def assert_exact_gradient(raw: Timeline, figure: Figure, rng: np.random.Generator) -> None:
    """Of all penalties together on a loop, by Taylor's slope; and that unknowns pull back what they push forward."""
    objective = Objective.of(figure, every_penalty(figure)).renormalised(path_of(raw))
    problem = objective.on(evenly(raw, 1))
    x = problem.unknowns.start + 0.02 * rng.normal(size=problem.unknowns.size)
    assert taylor_slope(lambda z: problem(z).value, x, problem(x).gradient, rng) > 1.9
    g = rng.normal(size=(problem.spline.size, figure.width))
    linear = problem.unknowns.rows(x) - problem.unknowns.rows(0 * x)
    np.testing.assert_allclose(np.sum(g * linear), problem.unknowns.pulled_back(g) @ x, rtol=1e-11, atol=1e-11)


def assert_splits_keep_the_curve(timeline: Timeline) -> Timeline:
    """With its derivatives; the loop with frames put in."""
    finer = split(timeline, np.array([0.02, 0.41, 0.79]))
    t = np.linspace(0, PERIOD, 101)
    for order in range(3):
        np.testing.assert_allclose(path_of(finer).at(t, order), path_of(timeline).at(t, order), atol=1e-9)
    return finer
