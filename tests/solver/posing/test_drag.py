"""The pose that follows a pulled point: the least of its cost, soles and balance first, derivatives as they are."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import figure_of
from oracles import differences, kinematics
from random_models import random_qpos
from scipy.optimize import minimize, nnls
from scipy.spatial import ConvexHull, Delaunay
from scipy.spatial.transform import Rotation
from texts import read_data

from dynsplines import models
from dynsplines.solver import posing
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.posing.bounds import Ranges
from dynsplines.solver.posing.drag import MAX_MISS, TARGET_WEIGHT

ARM = read_data("dragged_arm.xml")
STEP = 1e-6  # [rad, m] of differences
TIP = np.array([1.0, 0, 0])


@pytest.fixture(scope="module")
def human() -> Figure:
    return figure_of(models.figure_text("human"))


@pytest.fixture
def arm() -> Figure:
    return figure_of(ARM)


def hand(figure: Figure, place) -> posing.PointGoal:
    return posing.PointGoal("hand", figure.model.body("lower").id, TIP[None], np.array([place], float))


def tip(figure: Figure, qpos) -> np.ndarray:
    return hand(figure, np.zeros(3)).places(kinematics(figure.model, qpos))[0]


@pytest.mark.parametrize("far", [0.05, 2.0])
def test_the_pose_is_the_least_of_its_cost(arm, far):
    """SciPy finds no less: a squared distance from home, and a pull that grows no stronger where it misses by much."""
    home, begin = np.array([0.1, 0.4, 0.6]), np.array([0.2, 0.3, 0.8])
    place = tip(arm, home) * (1 + far)

    def cost(qpos):
        missed = np.linalg.norm(tip(arm, qpos) - place)
        pull = missed**2 if missed < MAX_MISS else 2 * MAX_MISS * missed - MAX_MISS**2
        search = posing.PoseSearch(arm, home, np.ones(3, bool), (hand(arm, place),), None)
        return float(np.sum((search.weights * (qpos - home)) ** 2) + TARGET_WEIGHT**2 * pull)

    last = begin
    for _ in range(4):
        last = posing.drag_pose(arm, home, np.ones(3, bool), hand(arm, place), begin=last).qpos
    assert cost(last) <= 1.002 * minimize(cost, last, method="BFGS").fun


@pytest.mark.parametrize(("home", "share", "end"), [(0.0, 1.0, 1.0), (0.0, 0.5, 0.5), (0.7, 0.5, 0.7)])
def test_a_joint_uses_only_its_share_of_its_range_unless_home_is_beyond_it(home, share, end):
    arm, start = figure_of(ARM.replace('type="hinge"', 'type="hinge" range="-1 1"')), np.array([0.0, 0.2, home])
    free, goal = np.array([False, False, True]), hand(arm, tip(arm, [0.0, 0.2, 1.6]))
    shares = dict.fromkeys((1, 2, 3), share)
    found = posing.drag_pose(arm, start, free, goal, begin=start, range_shares=shares).qpos
    np.testing.assert_allclose(found, [0, 0.2, end], atol=0.02)


def test_derivatives_are_differences(human, rng):
    model, foot = human.model, human.model.body("left_foot").id
    qpos = np.array(model.qpos0)
    mujoco.mj_integratePos(model, qpos, 0.2 * rng.normal(size=model.nv), 1.0)
    places = rng.normal(size=(3, 3))
    places[1, 0] = np.nan
    pins = posing.PointGoal("foot", foot, 0.1 * rng.normal(size=(3, 3)), places)
    polygon = rng.normal(size=(6, 3))
    balance = posing.SupportPolygon.of(1, polygon)
    assert balance is not None
    chest, offsets = model.body("chest").id, 0.1 * rng.normal(size=(4, 3))
    above = posing.FloorClearance(
        np.array([chest, chest, foot, foot]), offsets, np.full(4, 0.1), np.zeros(4), np.eye(3)[2], 3.0
    )
    feet = tuple(posing.PointGoal("foot", 0, place[None], np.zeros((1, 3))) for place in polygon + 5.0)
    over = [posing.Balance("feet", 1, feet, share) for share in (0.0, 0.5, 1.0)]
    depths, _ = above.linearise(model, kinematics(model, qpos))
    beside = replace(above, level=above.level - depths.max() - 0.04)  # the foot is less than 5 cm above
    terms = [
        *(
            (lambda data, goal=goal: goal.residual(model, data), lambda data, goal=goal: goal.linearise(model, data)[1])
            for goal in over
        ),
        (lambda data: pins.residual(model, data), lambda data: pins.linearise(model, data)[1]),
        (lambda data: balance.linearise(model, data)[0], lambda data: balance.linearise(model, data)[1]),
        (lambda data: above.linearise(model, data)[0], lambda data: above.linearise(model, data)[1]),
        (lambda data: beside.linearise(model, data)[0][1:], lambda data: beside.linearise(model, data)[1][1:]),
    ]
    for value, rows in terms:
        expected = differences(model, qpos, lambda end, value=value: value(kinematics(model, end)))
        np.testing.assert_allclose(rows(kinematics(model, qpos)), expected, atol=1e-7)
    data, corners = kinematics(model, qpos), polygon[:, :2] + 5.0
    stiff = np.vstack([corners.T, np.full(len(corners), 1e4)])  # convex combinations
    _, distance = nnls(stiff, [*data.subtree_com[1, :2], 1e4])
    assert np.linalg.norm(over[2].residual(model, data)) == pytest.approx(distance, rel=1e-6)


def test_excesses_over_ranges_are_signed_and_their_derivatives_are_differences(rng):
    """Of a ball joint, three hinges and a slide in a tree with two joints without ranges."""
    figure = figure_of(read_data("ranged.xml"))
    ranges = Ranges.of(figure, range(2, len(figure.links)), np.arange(figure.model.nv))
    qpos = random_qpos(figure, rng)
    excess, rows = ranges.linearise(qpos)
    angle = Rotation.from_quat(qpos[7:11], scalar_first=True).magnitude() - 1.2
    joints = [(qpos[11], -0.1, 2), (qpos[12], -0.4, 0.1), (qpos[13], -2, 0.2)]
    expected = [angle, *(q - high for q, _, high in joints), *(low - q for q, low, _ in joints)]
    np.testing.assert_allclose(np.sort(excess), np.sort(expected), atol=2e-7)
    np.testing.assert_allclose(rows, differences(figure.model, qpos, lambda end: ranges.linearise(end)[0]), atol=1e-7)


def test_a_support_polygon_is_the_convex_hull_made_smaller(rng):
    for count, digits in [(3, 9), (8, 9), (30, 9), (30, 1)]:  # with one digit, many are equal or in line
        points = (0.2 * rng.normal(size=(count, 3))).round(digits)
        polygon, hull = posing.SupportPolygon.of(1, points, share=0.7), ConvexHull(points[:, :2])
        assert polygon is not None
        corners = points[hull.vertices, :2]
        triangles = corners[Delaunay(corners).simplices]
        areas = np.abs(np.linalg.det(triangles[:, 1:] - triangles[:, :1]))
        centroid = areas @ triangles.mean(axis=1) / areas.sum()
        np.testing.assert_allclose(polygon.corners, centroid + 0.7 * (corners - centroid), atol=1e-12)
    line = np.linspace(0, 1, 5)[:, None] * [1, 2, 0]
    assert posing.SupportPolygon.of(1, line) is None and posing.SupportPolygon.of(1, points[:2]) is None


def test_a_restart_that_gains_little_leaves_the_pose_where_it_is(arm, rng):
    """Out of reach, restarts of the limb end in the same minimum, so the arm must not jump to another of its poses."""
    home, free, everything = 0.5 * rng.normal(size=3), np.ones(3, bool), np.ones(3, bool)
    begin, goal = 0.5 * rng.normal(size=3), hand(arm, 2.5 * tip(arm, home))
    without, restarted = (
        posing.drag_pose(arm, home, free, goal, begin=begin, limb=limb).qpos for limb in (None, everything)
    )
    np.testing.assert_array_equal(restarted, without)


@pytest.mark.parametrize(("begin", "there"), [([0, 1.8, 0.4], [1.3, -0.6, 1.1]), ([-1.7, 1.9, 1.4], [0.8, 0.1, 1.5])])
def test_a_pull_out_of_a_corner_of_the_ranges_restarts_the_limb_from_home(begin, there):
    ranges = {"a": "-2 2", "b": "-2 2", "c": "0 2.6"}
    text = ARM
    for name, limits in ranges.items():
        text = text.replace(f'name="{name}" type="hinge"', f'name="{name}" type="hinge" range="{limits}"')
    arm, home, free = figure_of(text), np.array([0, 0, 0.3]), np.ones(3, bool)
    goal, start = hand(arm, tip(arm, there)), np.array(begin, float)
    assert posing.drag_pose(arm, home, free, goal, begin=start).missed[0] > 0.5
    assert posing.drag_pose(arm, home, free, goal, begin=start, limb=free).missed[0] < 0.01
