"""The main function of the solver: its inputs, its results, and what every callback guarantees."""

from functools import cache
from itertools import cycle, pairwise

import numpy as np
import pytest
from exact_path import ExactPath, exact_path
from figures import ONE_BALL, PENALTIES, figure_of, hinge_keys, hinged
from random_models import TIMES, closed, distance_from_key, partial_keys, random_keys
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature, gauss_nodes
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Collision, CovariantAcceleration, RootAcceleration, UnitMagnitude
from dynsplines.solver.problem import SPACING, Improvement, Problem, Settings, Solution
from dynsplines.solver.refine.subdivision import CRITERIA
from dynsplines.solver.search.minimum import Stop, StopSearch
from dynsplines.solver.search.nlopt_methods import METHODS
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.points import Point
from dynsplines.solver.tolerances import ROUNDING

LEAST = [("variable", 0, -1), ("frames", 0, -1), ("max_evaluations", 1, 0)]
LEAST += [("tolerance", 1e-300, 0.0), ("batch", 1e-300, 0.0), ("threshold", 0.0, -1e-300)]
BRIEF = Settings(variable=1, max_evaluations=40)


def solved(motion: Solution) -> float:
    """E of what came out, by a sum finer than the search's."""
    return Objective(motion.figure, motion.objective.terms, FINE).value(motion.path)


def raw(motion: Solution) -> float:
    return Objective(motion.figure, motion.objective.terms, FINE).value(path_of(motion.raw))


FINE = Quadrature(points=12)


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_e_falls_strictly_and_every_callback_meets_the_keyframes(figure, rng, ends):
    keys = partial_keys(figure, rng)
    keys = closed(keys) if ends == "periodic" else keys
    slope = np.zeros((2, figure.width)) if ends == "clamped" else None
    seen: list[Improvement] = []
    motion = inbetween(Problem(figure, keys, PENALTIES, BRIEF, ends=ends, end_slope=slope), improved=seen.append)
    values = [each.value for each in seen]
    assert len(values) > 2
    assert np.all(np.diff(values) < 0)
    assert np.all(np.diff([each.evaluation for each in seen]) > 0)
    for each in seen:
        np.testing.assert_allclose(sum(each.parts.values()), each.value)
        for key, state in zip(keys, each.path.at(TIMES), strict=True):
            assert distance_from_key(figure, state, key) < 1e-11
    assert motion.trace == tuple((s.evaluation, s.round, s.value, s.parts) for s in seen)
    assert seen[-1].round >= 1
    assert seen[0].evaluation == 1 and seen[-1].evaluation <= motion.evaluations
    assert solved(motion) < 0.9 * raw(motion)
    qpos = motion.at(np.linspace(0, 1.3, 7))
    np.testing.assert_allclose(figure.to_qpos(figure.to_state(qpos)), qpos, atol=1e-12)
    assert motion.at(0.3).shape == (1, figure.width)


@pytest.mark.parametrize(
    ("error", "method", "evaluations"),
    [(StopSearch, "none", 1), (KeyboardInterrupt, "none", 3), (StopSearch, "lbfgs", 7)],
)
def test_a_stop_after_any_number_of_evaluations_gives_a_path_no_worse_than_the_raw_one(
    figure, rng, error, method, evaluations
):
    keys, told = partial_keys(figure, rng), []

    def stop(each: Improvement) -> None:
        told.append(each)
        if each.evaluation >= evaluations:
            raise error

    motion = inbetween(Problem(figure, keys, PENALTIES, Settings(optimiser=method)), improved=stop)
    assert motion.stop is Stop.INTERRUPTED and "interrupted" in repr(motion) and len(repr(motion)) < 100
    assert motion.evaluations == told[-1].evaluation >= evaluations
    assert solved(motion) <= raw(motion) * (1 + 1e-9)
    np.testing.assert_array_equal(motion.timeline.rows, told[-1].path.rows)
    for key, state in zip(keys, motion.path.at(TIMES), strict=True):
        assert distance_from_key(figure, state, key) < 1e-11


@pytest.mark.parametrize("frames", [3, 8])
def test_the_budget_of_variable_frames_is_respected(figure, rng, frames):
    settings = Settings(variable=1, frames=frames, threshold=0.0, batch=1.0, max_evaluations=15)
    motion = inbetween(Problem(figure, random_keys(figure, rng), PENALTIES, settings))
    assert motion.timeline.variable_count == frames
    assert motion.raw.variable_count == 0


@pytest.mark.parametrize("frames", [4, 6])
def test_the_segments_that_need_it_most_are_split_first(monkeypatch, frames):
    needs = np.array([0.1, 0.6, 0.3, 0.5, 0.2, 0.4])  # of the halves of three segments
    monkeypatch.setitem(CRITERIA, "needs", lambda objective, timeline: needs)
    settings = Settings(variable=1, frames=frames, criterion="needs", threshold=0.0)
    motion = inbetween(Problem(hinged(), hinge_keys(), [(CovariantAcceleration(), 1.0)], settings))
    halves = np.array([0.0, 0.25, 0.5, 0.95, 1.4, 1.7, 2.0])
    middles = (halves[1:] + halves[:-1]) / 2
    expected = np.sort(np.append(halves, middles[np.argsort(-needs)[: frames - 3]]))
    np.testing.assert_allclose(motion.timeline.times, expected)


@pytest.mark.parametrize(("criterion", "method"), list(zip(cycle(("weak", "residual")), METHODS[:4], strict=False)))
def test_hinges_are_solved_in_joint_coordinates_to_the_natural_spline(criterion, method):
    figure = hinged()
    assert figure.coordinates == "joint"
    settings = Settings(criterion=criterion, optimiser=method, tolerance=1e-10)
    motion = inbetween(Problem(figure, hinge_keys(), [(CovariantAcceleration(), 1.0)], settings))
    t = np.linspace(0, 2, 30)
    np.testing.assert_allclose(motion.at(t), path_of(motion.raw).at(t), atol=1e-3)
    np.testing.assert_allclose(motion.at(TIMES_OF_HINGES), [key.state for key in hinge_keys()], atol=1e-12)


TIMES_OF_HINGES = np.array([0.0, 0.5, 1.4, 2.0])


def test_an_unknown_criterion_or_method_is_refused_and_the_known_ones_named(figure, rng):
    keys = random_keys(figure, rng)
    with pytest.raises(ValueError, match="'hunch'; there are: weak, residual"):
        inbetween(Problem(figure, keys, PENALTIES, Settings(criterion="hunch")))
    with pytest.raises(ValueError, match="no optimiser 'magic'; there are: lbfgs, slsqp"):
        inbetween(Problem(figure, keys, PENALTIES, Settings(optimiser="magic")))


def test_the_clock_does_not_matter(rng):
    figure = figure_of(ONE_BALL)
    turns = [[0.0, 0, 0], [0.7, 0.2, 0], [0.9, -0.8, 0.4], [0.1, -1.2, 1.0]]
    penalties = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 1.0)]
    paths = []
    for pace in (0.02, 1000.0):
        keys = [Frame.key(pace * i, quat.from_rotation_vector(v)) for i, v in enumerate(turns)]
        motion = inbetween(Problem(figure, keys, penalties, Settings(variable=1, frames=0)))
        paths.append(motion.at(pace * np.linspace(0, 3, 40)))
    assert np.degrees(quat.angle_between(*paths)).max() < 0.1


TWO_SLIDES = """<mujoco><worldbody><body><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/>
<geom size=".02"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("seed", range(3))
def test_a_fast_point_does_not_pass_through_a_thin_wall_between_two_samples(seed):
    """A ball moves to and fro by 1 m within 0.3 to 0.7 s, across walls of 4 to 20 mm that are 2 to 10 cm too high."""
    rng, figure, radius = np.random.default_rng(seed), figure_of(TWO_SLIDES), 0.02
    seconds, x, top, half = rng.uniform((0.15, 0.3, 0.02, 0.002), (0.35, 0.7, 0.1, 0.01))
    keys = [Frame.key(t, np.array([far, 0.0])) for t, far in ((0.0, 0.0), (seconds, 1.0), (2 * seconds, 0.0))]
    wall = Box("wall", np.array([x, top - 1, 0]), np.eye(3), np.array([half, 1.0, 1.0]))
    ball = Point("ball", len(figure.links) - 1, np.zeros(3), radius)
    settings = Settings(quadrature=Quadrature(points=3, longest=0.05))
    motion = inbetween(
        Problem(figure, keys, [(RootAcceleration(), 1.0), (Collision((ball,), (wall,)), 100.0)], settings)
    )
    away = np.abs(motion.path.at(np.linspace(0, 2 * seconds, 4000)) - [x, 0]) - [half, top]
    assert np.linalg.norm(np.maximum(away, 0), axis=1).min() > radius - 0.001
    samples = motion.objective.nodes(motion.timeline.times)[0].size
    assert samples < 10 * Quadrature(points=3, longest=0.05).nodes(motion.timeline.times)[0].size


@pytest.mark.parametrize(
    ("chosen", "spacings", "in_windows", "expected"),
    [
        ({}, (3, 2.9, 0.5), False, [2, 2, 2]),
        ({}, (3.01, 4, 4.01), False, [3, 3, 4]),
        ({}, (9.5, 1), False, [9, 2]),
        ({}, (9.5, 1), True, [9, 3]),
        ({"frames": 11}, (9.5, 1), False, [9, 2]),
        ({"frames": 10}, (9.5, 1), False, [2, 2]),
        ({"frames": 8}, (1, 1, 1), True, [2, 2, 2]),
        ({"frames": 9}, (1, 1, 1), True, [3, 3, 3]),
        ({"frames": 30}, (1, 1, 1), True, [3, 3, 3]),
        ({"frames": 30}, (1, 1, 1), False, [2, 2, 2]),
        ({"variable": 0}, (20, 0.01, 1), False, [0, 0, 0]),
        ({"variable": 5, "frames": 2}, (20, 0.01, 1), False, [5, 5, 5]),
        ({}, (2, 0.033), False, [2, 0]),  # shorter than a twentieth of the spacing of frames next to it
        ({}, (0.033, 2), False, [0, 2]),
        ({}, (0.034, 2), False, [2, 2]),
    ],
)
def test_segments_begin_with_frames_by_their_length_and_by_the_budget(chosen, spacings, in_windows, expected):
    times = 3.0 + SPACING * np.cumsum([0.0, *spacings])
    found = Settings(**chosen).beginning(times, in_windows=in_windows)
    even = [a + (b - a) * np.arange(1, n + 1) / (n + 1) for (a, b), n in zip(pairwise(times), expected, strict=True)]
    np.testing.assert_allclose(found, np.concatenate(even))


@pytest.mark.parametrize(("name", "least", "less"), LEAST)
def test_the_least_that_may_be_requested_is_taken_and_less_is_refused(name, least, less):
    assert getattr(Settings(**{name: least}), name) == least
    with pytest.raises(ValueError, match="settings: "):
        Settings(**{name: less})


def solution() -> Solution:
    figure = hinged()
    raw = raw_timeline(figure, hinge_keys())
    return Solution(figure, Objective.of(figure, PENALTIES), raw, raw)


def test_a_motion_is_seen_from_its_first_keyframe_to_its_last_and_a_rounding_beyond():
    found = solution()
    t = np.array([0.0, 0.7, 2.0])
    np.testing.assert_allclose(found.at(t), path_of(found.timeline).at(t))
    assert found.at(0.7).shape == (1, 2)
    np.testing.assert_allclose(found.at([-ROUNDING, 2 + 0.9 * ROUNDING]), found.at([0.0, 2.0]), atol=1e-7)
    for outside in (-1.1 * ROUNDING, 2 + 1.1 * ROUNDING):
        with pytest.raises(ValueError, match="from 0 to 2 s; give times within"):
            found.at([0.5, outside])


EVEN = np.arange(7.0)
UNEVEN = np.cumsum([0, 1.0, 0.6, 1.5, 0.8, 1.2, 0.7])
INTRINSIC = ((CovariantAcceleration(), 5 / 7), (UnitMagnitude(), 2 / 7))


def orientations(seed: int) -> Array:
    """Seven unit quaternions, steps of 20-90° about random axes, (7, 4)."""
    rng = np.random.default_rng(seed)
    turn, out = Rotation.identity(), []
    for _ in range(7):
        out.append(turn.as_quat()[[3, 0, 1, 2]])
        axis = rng.normal(size=3)
        turn = turn * Rotation.from_rotvec(axis / np.linalg.norm(axis) * np.radians(rng.uniform(20, 90)))
    return np.array(out)


@cache
def exact(seed: int, even: bool = True) -> ExactPath:
    return exact_path(EVEN if even else UNEVEN, orientations(seed))


@cache
def motion(seed: int, variable: int, even: bool = True) -> Solution:
    times = EVEN if even else UNEVEN
    keys = [Frame.key(float(t), q) for t, q in zip(times, orientations(seed), strict=True)]
    settings = Settings(variable=variable, frames=0, tolerance=1e-10, max_evaluations=600)
    return inbetween(Problem(figure_of(ONE_BALL), keys, INTRINSIC, settings))


def energy(path: Path) -> float:
    """¼∫|ω'|² of the normalised path, its quaternion differentiated here: independent of the penalty."""
    t, w = gauss_nodes(np.unique(np.concatenate([path.spline.times, np.linspace(*path.span, 301)])), 5)
    q, q_d, q_dd = (path.at(t, order) for order in range(3))
    b, s = np.sum(q * q, axis=1, keepdims=True), np.sum(q * q_d, axis=1, keepdims=True)
    unit = q / np.sqrt(b)
    rate = q_dd / np.sqrt(b) - 2 * s * q_d / b**1.5
    rate -= np.sum(rate * unit, axis=1, keepdims=True) * unit
    return float(w @ np.sum(rate**2, axis=1))


@pytest.mark.parametrize(
    ("seed", "variable", "even", "excess"), [(0, 3, True, 5e-4), (0, 15, True, 1e-6), (1, 3, False, 5e-4)]
)
def test_few_variable_frames_come_close_to_the_exact_energy_and_many_closer(seed, variable, even, excess) -> None:
    ratio = energy(motion(seed, variable, even=even).path) / exact(seed, even).energy
    assert 1 - 1e-9 <= ratio <= 1 + excess
