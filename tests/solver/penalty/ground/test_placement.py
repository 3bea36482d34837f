"""Placements: the value by hand, gradient and curvature, and that E holds them at their instants and nowhere else."""

import numpy as np
import pytest
from even_frames import evenly
from every_penalty import clip
from figures import figure_of
from oracles import kinematics
from random_keys import TIMES
from random_samples import at_times, random_samples
from taylor import taylor_slope

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Attachment, CovariantAcceleration, Placed, UnitMagnitude
from dynsplines.solver.problem import Problem
from dynsplines.solver.refine.subdivision import by_weak_form
from dynsplines.solver.surface.points import Point

TARGET = np.array([0.3, -0.2, 0.8])


def placed(link: int, time: float, target: Array = TARGET) -> Placed:
    return Placed(Point("p", link, np.array([0.1, 0.2, -0.3])), time, target)


def placement_of(figure: Figure, *times: float) -> Attachment:
    """Points of the first and the last link at every time, one of them with a free axis."""
    last = len(figure.links) - 1
    loose = np.array([0.4, np.nan, 0.2])
    return Attachment.at_instants(tuple(point for t in times for point in (placed(1, t, loose), placed(last, t))))


def some(figure: Figure, rng: np.random.Generator) -> Samples:
    return at_times(random_samples(figure, rng, 6), np.array([0.0, 0.5, 0.5, 0.7, 1.0, 1.3]))


def test_it_is_the_squared_distance_along_the_given_axes_at_its_time(figure, rng):
    samples = some(figure, rng)
    last = len(figure.links) - 1
    values = placement_of(figure, 0.5, 1.3).evaluate(samples)
    for i in (1, 2, 5):
        data = kinematics(figure.model, figure.to_qpos(samples.y[i]))
        expected = 0.0
        for link, target in ((1, [0.4, np.nan, 0.2]), (last, TARGET)):
            body = data.body(figure.links[link].body)
            at = body.xpos + body.xmat.reshape(3, 3) @ [0.1, 0.2, -0.3]
            expected += np.nansum((at - target) ** 2)
        assert values[i] == pytest.approx(expected, rel=1e-9)
    assert not values[[0, 3, 4]].any()


QUADRATURES = [Quadrature(), Quadrature("gauss", 4, 0.05), Quadrature("uniform", 37)]


@pytest.mark.parametrize("quadrature", QUADRATURES, ids=["gauss", "panels", "uniform"])
def test_the_objective_holds_it_once_at_its_time_and_leaves_the_others_as_they_were(figure, rng, quadrature):
    path = path_of(clip(figure, rng))
    instants = (float(TIMES[1]), float(TIMES[-1]))
    placement = placement_of(figure, *instants)
    others = [(CovariantAcceleration(), 2.0), (UnitMagnitude(), 1.0)]
    plain = Objective.of(figure, others, quadrature=quadrature).integrals(path)
    found = Objective.of(figure, [*others, (placement, 3.0)], quadrature=quadrature).integrals(path)
    np.testing.assert_allclose(found[:2], plain, rtol=1e-12)
    at = Samples(figure, *path.motion(np.array(instants)), t=np.array(instants))
    assert found[2] == pytest.approx(placement.evaluate(at).sum(), rel=1e-12)


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_the_objectives_gradient_has_taylor_slope_two(figure, rng, ends):
    timeline = evenly(clip(figure, rng, ends), 1)
    placement = placement_of(figure, float(TIMES[0]), float(TIMES[1]), float(TIMES[2]))
    problem = Objective.of(figure, [(placement, 2.0)]).on(timeline)
    x = problem.unknowns.start + 0.1 * rng.normal(size=problem.unknowns.size)
    found = problem(x)
    assert found.parts["attach.placement"] > 0
    assert taylor_slope(lambda z: problem(z).value, x, found.gradient, rng) > 1.95


def test_frames_between_keyframes_promise_nothing_of_it(figure, rng):
    """A frame's cardinal function is zero at all other frames, and so at the keyframe's time."""
    timeline = clip(figure, rng)
    others = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 5.0)]
    plain = by_weak_form(Objective.of(figure, others), timeline)
    with_it = by_weak_form(Objective.of(figure, [*others, (placement_of(figure, float(TIMES[1])), 9.0)]), timeline)
    np.testing.assert_allclose(with_it, plain, rtol=1e-12)


BALL = '<mujoco><worldbody><body><freejoint/><geom size=".1"/><site pos=".1 .2 -.3"/></body></worldbody></mujoco>'


@pytest.mark.parametrize("coordinates", ["world", "joint"])
@pytest.mark.parametrize("which", [0, 1])
def test_a_reachable_place_is_reached_within_a_millimetre(coordinates, which):
    figure = figure_of(BALL, coordinates)
    free = np.zeros(7, bool)
    keys = [Frame.key(float(i), [0.1 * i, 0, 1, 1, 0, 0, 0]) for i in range(3)]
    keys[which] = Frame.key(float(which), keys[which].state, free)
    placement = Attachment.at_instants((placed(1, float(which)),))
    penalties = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 1.0), (placement, 30.0)]
    motion = inbetween(Problem(figure, keys, penalties))
    data = kinematics(figure.model, motion.at(float(which))[0])
    assert np.linalg.norm(data.site_xpos[0] - TARGET) < 1e-3
