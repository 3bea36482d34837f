"""Stances, footings, and the thresholds that decide them."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shipped
from figures import FLOOR, enlarged, figure_of, scaled
from motions import BIPED_FPS as FPS
from motions import TEXT
from motions import biped_walk as walk
from scipy.spatial import ConvexHull

from dynsplines import models
from dynsplines.clip import load
from dynsplines.clip.build import constraints
from dynsplines.clip.kinds import KINDS
from dynsplines.clip.load import Clip
from dynsplines.clip.parse import options_of
from dynsplines.clip.table import PenaltyTable
from dynsplines.scene.compose import compose
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact, footings, stances
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import Size
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.problem import Problem
from dynsplines.solver.surface.points import Point

# of the size of an adult
WALKER = """<mujoco><worldbody><body pos="0 0 1"><freejoint name="root"/><geom size=".1" mass="50"/>
  <body pos="0 .1 0"><joint name="left" type="slide" axis="0 0 1"/><geom size=".05" pos="0 0 -.95" mass="8"/></body>
  <body pos="0 -.1 0"><joint name="right" type="slide" axis="0 0 1"/><geom size=".05" pos="0 0 -.95" mass="8"/></body>
</body></worldbody></mujoco>"""


FIGURE = figure_of(WALKER)


# two feet on sliding legs; a foot is lifted on its toe by tilting the figure, so that heels are 0.1 m behind toes
SOLES = tuple(
    Point(f"{name}_{end}", link, np.array([x, 0, -1.0]))
    for link, name in ((2, "left"), (3, "right"))
    for end, x in (("heel", -0.1), ("toe", 0.0))
)


# what a figure does with its two feet in one keyframe: how much each leg is drawn in [m]
STAND, LEFT, RIGHT = (0.0, 0.0), (0.0, 0.3), (0.3, 0.0)


TILTED = (np.cos(0.15), 0.0, np.sin(0.15), 0.0)


def key(time: float, x: float, feet: tuple[float, float], *, z: float = 1.0) -> Frame:
    """A keyframe with the root at (x, 0, z)."""
    return Frame.key(time, [x, 0, z, 1, 0, 0, 0, *feet])


def on_toe(time: float, x: float, feet: tuple[float, float], *, z: float = 1.0) -> Frame:
    """A keyframe that is tilted forward, so that a foot that is drawn in by 1 - z stands on its toe."""
    return Frame.key(time, [x, 0, np.cos(0.3) * z, *TILTED, *feet])


def test_a_foot_pushes_with_the_corners_of_its_outline_and_none_of_the_points_inside(rng):
    angle = np.pi / 4 * np.arange(8) + rng.uniform(-0.1, 0.1, 8)
    sole = np.concatenate([0.1 * np.array([np.cos(angle), np.sin(angle)]).T, rng.uniform(-0.03, 0.03, (6, 2))])
    points = tuple(Point(f"p{i}", 2, np.array([x, y, -1.0])) for i, (x, y) in enumerate(sole))
    keys = raw_timeline(FIGURE, [key(0, 0, STAND), key(1, 0, STAND)])
    soles = KeyframePoints.of(FIGURE, keys, points, (FLOOR,))
    found = footings(soles, stances(soles))
    outline = {f"p{i}" for i in ConvexHull(sole).vertices}
    assert len(outline) == 8
    assert {footing.point.name for footing in found} == outline
    places = [points[int(footing.point.name[1:])].position for footing in found]
    np.testing.assert_allclose([footing.point.position for footing in found], places, atol=1e-12)


def timeline_of(*keys: Frame) -> Timeline:
    return raw_timeline(FIGURE, list(keys))


def footings_of(*keys: Frame, body: tuple[Point, ...] = ()) -> tuple[Contact, ...]:
    timeline = timeline_of(*keys)
    soles = KeyframePoints.of(FIGURE, timeline, SOLES, (FLOOR,))
    return footings(soles, stances(soles), body)


def test_a_foot_that_stands_may_push_with_all_that_touches_in_one_of_the_keyframes():
    found = footings_of(key(0, 0, LEFT), on_toe(0.1, 0.295, LEFT), key(0.3, 0.8, RIGHT))
    assert [(f.point.name, f.first, f.last) for f in found] == [("left_heel", 0.0, 0.1), ("left_toe", 0.0, 0.1)]
    for footing, x in zip(found, (-0.1, 0.0), strict=True):
        np.testing.assert_allclose(footing.normal, [0, 0, 1])
        np.testing.assert_allclose(footing.point.position, [x, 0, -1], atol=1e-12)
    later = footings_of(on_toe(0, 0.295, LEFT), on_toe(0.1, 0.295, LEFT), key(0.2, 0, LEFT))
    assert [(f.point.name, f.first) for f in later] == [("left_toe", 0.0), ("left_heel", 0.1), ("left_toe", 0.1)]


STRIDES = 7  # keyframes of run_and_step before the step


EVERY = 8  # samples of the walk between keyframes


INSTANTS = 101  # at which motions are compared


@cache
def keyframes(figure: str) -> tuple[str, Array, Array]:
    """Text of the model, times (K,) [s] and configurations (K, nq): a human that runs, a biped that walks."""
    if figure == "human":
        keys = shipped.loaded("run_and_step").keys[:STRIDES]
        times, poses = np.array([k.time for k in keys]), np.array([k.state for k in keys], np.float64)
        return models.figure_text("human"), times, poses
    poses = np.array(walk()[::EVERY], np.float64)
    times = np.array([EVERY / FPS * k for k in range(len(poses))])
    return TEXT, times, poses


def clip_of(figure: str, factor: float, *, gravity: bool) -> Clip:
    """The clip of a figure of another size: with gravity as much stronger, or else in dynamic similarity slower."""
    text, times, poses = keyframes(figure)
    spec = scaled(text, factor, gravity=gravity)
    bare = spec.compile()
    slower = 1.0 if gravity else np.sqrt(factor)
    return load.from_qpos(figure, compose(spec, bare=bare), slower * times, enlarged(bare, poses, factor), 30, figure)


def schedule(clip: Clip, slower: float) -> list[tuple[str, float, float]]:
    """Stances and footings by name, their times [s] divided by how much slower the clip is."""
    support = clip.context.support
    assert support is not None
    rows = [(kind, each.point.name, each.first, each.last) for kind, some in (
        ("stance", clip.context.schedule.stances), ("footing", support.footings)) for each in some]  # fmt: skip
    return [(f"{kind} {name}", round(first / slower, 6), round(last / slower, 6)) for kind, name, first, last in rows]


def summed(clip: Clip, slower: float) -> Problem:
    """A clip's problem, its integrals summed over panels as much longer as the clip is slower."""
    problem = clip.problem
    panels = replace(problem.settings.quadrature, longest=slower * problem.settings.quadrature.longest)
    return replace(problem, settings=replace(problem.settings, quadrature=panels))


@pytest.mark.parametrize(("figure", "factor", "gravity"), [("human", 3.0, False), ("biped", 0.3, True)])
def test_a_doll_and_a_giant_stand_when_an_adult_does(figure, factor, gravity):
    slower = 1.0 if gravity else float(np.sqrt(factor))
    adult, other = (clip_of(figure, each, gravity=gravity) for each in (1.0, factor))
    expected = schedule(adult, 1.0)
    assert schedule(other, slower) == expected
    assert {row[0].split()[0] for row in expected} >= {"stance", "footing"}


@pytest.mark.parametrize(("figure", "gravity"), [("human", False), ("biped", True)])
def test_every_soft_constraint_costs_a_giant_what_it_costs_an_adult(figure, gravity, rng):
    """On splines through poses that violate most constraints, relative to the raw splines."""
    poses, costs = np.array(keyframes(figure)[2]), []
    poses += 0.1 * rng.normal(size=poses.shape)
    for factor in (1.0, 3.0):
        clip = clip_of(figure, factor, gravity=gravity)
        problem = summed(clip, 1.0 if gravity else float(np.sqrt(factor)))
        trunk = clip.figure.body_name(int(clip.figure.tables.free_links[0]))
        options = {"upright": {"bodies": [trunk]}}
        kinds = [PenaltyTable.of(kind, weight=1.0, **options.get(kind, {})) for kind in KINDS]
        _, penalties, _ = constraints(clip.context, options_of(kinds, "every kind"))
        objective = Objective.of(clip.figure, penalties, quadrature=problem.settings.quadrature)
        violating = enlarged(clip.figure.model, poses, factor)
        keys = [Frame.key(key.time, pose) for key, pose in zip(clip.keys, violating, strict=True)]
        discretised = objective.renormalise(path_of(problem.raw)).on(raw_timeline(clip.figure, keys))
        costs.append(discretised(discretised.unknowns.start).parts)
    assert costs[1] == pytest.approx(costs[0], rel=1e-5)
    assert sum(cost > 0 for cost in costs[0].values()) >= 13


@pytest.mark.slow
def test_a_giant_moves_as_an_adult_does():
    factor, slower = 3.0, float(np.sqrt(3.0))
    adult, other = (clip_of("biped", each, gravity=False) for each in (1.0, factor))
    motions = [inbetween(summed(clip, each)) for clip, each in ((adult, 1.0), (other, slower))]
    poses = []
    for clip, motion, each in zip((adult, other), motions, (1.0, factor), strict=True):
        times = np.linspace(clip.keys[0].time, clip.keys[-1].time, INSTANTS)
        poses.append(enlarged(clip.figure.model, motion.at(times), 1 / each))
    # spheres are at fixed distances along limbs
    np.testing.assert_allclose(poses[1], poses[0], atol=0.02)
    assert motions[1].trace[-1][2] == pytest.approx(motions[0].trace[-1][2], rel=0.02)


def test_lengths_times_and_speeds_grow_with_the_figure():
    text = models.figure_text("human")
    for factor in (0.25, 4.0):
        figure = load.figure_of(compose(scaled(text, factor), bare=scaled(text, factor).compile()), "scaled")
        size, found = Size.of(figure), Thresholds.of(figure)
        assert size.length == pytest.approx(factor, rel=1e-6)
        assert size.time == pytest.approx(np.sqrt(factor), rel=1e-6)
        speeds = ("travels", "fast")
        powers = {"near_surface": 1, "lift_off": 0.5, "lively": 0.5}
        for name, power in (powers | dict.fromkeys(speeds, 0.5)).items():
            assert getattr(found, name) == pytest.approx(factor**power * getattr(Thresholds(), name), rel=1e-6)
