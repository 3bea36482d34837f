"""Small problems and clips."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from figures import ONE_BALL, SMOOTHNESS, TINY, figure_of
from gradients import clip, every_penalty, taylor_slope, tiny_clip
from random_models import evenly, mask_without
from texts import read_data

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Discretised, Evaluation, Objective
from dynsplines.solver.penalty import CovariantAcceleration, Penalty, RootAcceleration, Torque, UnitMagnitude
from dynsplines.solver.refine.subdivision import split
from dynsplines.solver.search.minimum import Minimum
from dynsplines.solver.search.nlopt_methods import minimise

# Small problems as the search sees them: discretised, in unknowns.


def turning(turns: list[float], variable: int) -> tuple[Objective, Timeline]:
    """One ball joint turned about a slanted axis by so many degrees from keyframe to keyframe."""
    figure = figure_of(ONE_BALL)
    axis = np.array([0.6, 0, 0.8])
    poses = [quat.from_rotation_vector(np.radians(angle) * axis) for angle in np.cumsum([0, *turns])]
    raw = raw_timeline(figure, [Frame.key(float(i), pose) for i, pose in enumerate(poses)])
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 10.0)])
    return objective.renormalise(path_of(raw)), evenly(raw, variable)


TERMS: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (UnitMagnitude(), 0.5),
    (RootAcceleration(), 1.0),
    (Torque(), 0.5),
]


def problem_of(rng: np.random.Generator, ends: str = "free", coordinates: str = "world", terms=TERMS) -> Discretised:
    raw = tiny_clip(rng, ends, coordinates, partial=True)
    objective = Objective.of(figure_of(TINY, coordinates), terms).renormalise(path_of(raw))
    return objective.on(evenly(raw, 1))


def discretised(figure: Figure, rng: np.random.Generator, ends: str):
    timeline = clip(figure, rng, ends)
    objective = Objective.of(figure, [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0)])
    return objective.renormalise(path_of(timeline)).on(evenly(timeline, 2))


def slider(times: np.ndarray, variable: int):
    """One slide under its acceleration energy, the flat case."""
    figure = figure_of('<mujoco><worldbody><body><joint type="slide"/><geom size=".1"/></body></worldbody></mujoco>')
    keys = [Frame.key(t, [np.sin(3 * t)]) for t in times]
    raw = raw_timeline(figure, keys)
    return Objective.of(figure, [(RootAcceleration(), 1.0)]).renormalise(path_of(raw)).on(evenly(raw, variable))


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

FIGURE = read_data("tiny.xml")

CLIP = read_data("tiny.toml")

HINGE = read_data("hinge.xml")


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


LOOP = changed("frames = 2", 'frames = 2\nends = "periodic"').replace(
    "root.position = [0.3, 0, 1]\nroot.rotation = {rotvec = [0, 10, 170]}", "root.position = [0.3, 0, 1]"
)
ENDLESS = changed("evaluations = 8\nframes = 2", "evaluations = 100000\nframes = 400\ntolerance = 1e-15\nthreshold = 0")


# A loop that hops on, and turns while it does.

PERIOD, STRIDE = 0.8, 0.6
TIMES = [0.0, 0.3, 0.5, PERIOD]
TURN = np.radians(50)  # a period of the circle
CENTRE, UP = np.array([0.1, 0.7, 0.0]), np.array([0.0, 0.0, 1.0])
HOP_TERMS = [*SMOOTHNESS, (Torque(), 0.5)]


def turned(qpos: Array, angle: float) -> Array:
    """A configuration turned about the vertical through the centre of the circle."""
    turn = quat.from_rotation_vector(angle * UP)
    place = CENTRE + quat.rotate(turn, qpos[:3] - CENTRE)
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
    objective = Objective.of(figure, every_penalty(figure)).renormalise(path_of(raw))
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
