"""Allowances: straight lines between keyframes, and what bends and depths make of them."""

from dataclasses import replace

import numpy as np
import pytest
from bends import limits_of
from figures import BALL, BALL_TREE, figure_of
from random_samples import at_times, random_samples

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Bend, BendLimits, Contact, CovariantAcceleration, RootAcceleration, UnitMagnitude
from dynsplines.solver.penalty.allowance import Allowance
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point

UP = np.array([0.0, 0, 1])


def test_it_goes_in_straight_lines_and_stays_beyond_the_ends():
    allowance = Allowance(np.array([1.0, 2, 4]), np.array([[0.0, 1, 3], [2, 0, 0]]))
    found = allowance.at(np.array([0.0, 1, 1.5, 2, 3, 4, 9]))
    np.testing.assert_allclose(found, [[0, 0, 0.5, 1, 2, 3, 3], [2, 2, 1, 0, 0, 0, 0]])


FLOOR = Plane("floor", np.zeros(3), UP)


def deepest(heights: list[float], *, allowing: bool) -> tuple[float, float]:
    """How deep a ball gets between keyframes at these heights a second apart, and its largest acceleration upward."""
    figure = figure_of(BALL)
    keys = [Frame.key(float(i), [0, 0, z + 0.1, 1, 0, 0, 0]) for i, z in enumerate(heights)]
    contact = Contact((Point("ball", 1, np.zeros(3), 0.1),), (FLOOR,))
    if allowing:
        contact = contact.allowing(figure, raw_timeline(figure, keys))
    penalties = [(CovariantAcceleration(), 1.0), (RootAcceleration(), 1.0), (UnitMagnitude(), 1.0), (contact, 30.0)]
    motion = inbetween(Problem(figure, keys, penalties, Settings(tolerance=1e-4, frames=30)))
    height = motion.path.at(t := np.linspace(0, len(heights) - 1, 2001))[:, 2] - 0.1
    return float(-height.min()), float(np.abs(np.gradient(np.gradient(height, t), t)).max())


@pytest.mark.slow
def test_between_two_keyframes_in_the_floor_a_point_stays_as_deep_and_does_not_whip():
    depth, pull = deepest([-0.03, -0.03, -0.03, -0.03], allowing=True)
    assert depth == pytest.approx(0.03, abs=1e-3)
    assert pull < 0.1
    _, whipped = deepest([-0.03, -0.03, -0.03, -0.03], allowing=False)
    assert whipped > 1.0


def test_a_knee_that_a_keyframe_bends_backward_may_do_so_near_it_and_nowhere_else():
    figure = figure_of(models.figure_text("human"))
    knee = next(link for link in figure.links if link.name == "left_knee")
    keys = []
    for i, angle in enumerate([20.0, -6.0, 20.0]):
        qpos = np.array(figure.model.qpos0)
        qpos[knee.qpos : knee.qpos + 4] = quat.from_rotation_vector(np.radians([0, angle, 0]))
        keys.append(Frame.key(float(i), qpos))
    timeline = raw_timeline(figure, keys)
    link = figure.links.index(knee)
    bend = Bend("left_knee", link, np.array([0.0, 1, 0]), np.array([0.0, 0, -1]))
    limits = BendLimits((bend,)).allowing(figure, timeline)
    assert limits.allowed is not None
    np.testing.assert_allclose(np.degrees(limits.allowed.excess[0]), [[0, 6, 0]], atol=1e-9)
    np.testing.assert_allclose(np.degrees(limits.allowed.at(np.array([0.5, 1.5]))[0]), [[3, 3]], atol=1e-9)
    fixed = np.ones(figure.width, bool)
    fixed[knee.qpos : knee.qpos + 4] = False
    partial = [keys[0], Frame(keys[1].time, keys[1].state, fixed), keys[2]]
    free = BendLimits((bend,)).allowing(figure, raw_timeline(figure, partial)).allowed
    assert free is not None
    assert not free.excess.any()


def test_bends_are_tolerated_beyond_each_of_their_five_bounds_as_far_as_specified(rng):
    figure = figure_of(BALL_TREE)
    samples = at_times(random_samples(figure, rng, 40), np.linspace(0, 1, 40))
    limits = limits_of(figure)
    allowed = Allowance(np.array([0.0, 0.4, 1]), rng.uniform(0.1, 0.9, (5, len(limits.joints), 3)))
    term = replace(limits, allowed=allowed)
    flexion, sideways, twist = limits.angles(samples)
    least, aside, turned = limits.least, limits.sideways, limits.twist
    over = np.array([least - flexion, sideways - aside, -sideways - aside, twist - turned, -twist - turned])
    over = np.maximum(over - allowed.at(samples.t), 0)
    assert over.any(axis=(1, 2)).all()
    np.testing.assert_allclose(term.evaluate(samples), np.sum(over**2, axis=(0, 1)), rtol=1e-12)
    sides = term.one_sided_residuals(samples)
    assert sides is not None
    counted = np.bincount(sides.at, np.maximum(sides.value, 0) ** 2, samples.count)
    np.testing.assert_allclose(counted, term.evaluate(samples), rtol=1e-12)
