"""A recording set down: soles level and on the ground as far as they stood, and nothing else of it touched."""

import numpy as np
import pytest
from figures import figure_of

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts.ground_alignment import ENOUGH, LOWEST, align_to_ground, move_to_ground
from dynsplines.solver.contacts.recorded_stances import RecordedStance
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.recording import RecordedMotion
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point, places_of

FIGURE = figure_of("""<mujoco><worldbody><body name="trunk"><freejoint/><geom size=".1"/>
        <body name="foot" pos="0 0 -.5"><joint type="ball"/><geom size=".05"/></body></body></worldbody></mujoco>""")
FOOT = 2
FLOOR = Plane("floor", np.zeros(3), np.array([0.0, 0, 1]))
TIMES = np.linspace(0, 1, 31)
CORNERS = np.array([[-0.05, -0.04, -0.1], [-0.05, 0.04, -0.1], [0.15, -0.05, -0.1], [0.15, 0.05, -0.1]])


def sole(*radii: float) -> tuple[Point, ...]:
    """Spheres at corners of a sole that is flat, if they all are as large."""
    return tuple(Point(f"{i}", FOOT, CORNERS[i], radius) for i, radius in enumerate(radii))


def recorded(height: float, turn: Array) -> RecordedMotion:
    """Walking along a line, the trunk turned about the vertical, the foot turned (3,) [rad] all the time."""
    qpos = np.zeros((TIMES.size, 11))
    qpos[:, 0], qpos[:, 1], qpos[:, 2] = TIMES, 0.3, height
    qpos[:, 3:7] = quat.from_rotation_vector([0, 0, 0.7])
    qpos[:, 7:] = quat.from_rotation_vector(turn)
    return RecordedMotion.of(FIGURE, TIMES, qpos, exact=True)


def bottoms(found: RecordedMotion, points: tuple[Point, ...]) -> Array:
    """(p, T) [m] how high the lowest spots of points are."""
    samples = Samples(FIGURE, found.states, 0 * found.states, 0 * found.states)
    return places_of(points, samples)[0][2] - np.array([[point.radius] for point in points])


def standing(points: tuple[Point, ...]) -> list[RecordedStance]:
    return [RecordedStance(point, TIMES[0], TIMES[-1]) for point in points]


@pytest.mark.parametrize(
    ("radii", "degrees", "within"),
    [
        ((0.02, 0.02, 0.02, 0.02), [0, 12, 0], 1e-9),
        ((0.02, 0.02, 0.02, 0.02), [-9, 0, 0], 1e-9),
        ((0.0, 0.0, 0.0, 0.0), [8, -14, 5], 1e-9),
        ((0.03, 0.03), [7, 0, 0], 1e-9),
        ((0.02, 0.02, 0.04, 0.04), [4, 5, 0], 2e-4),  # what a sphere of 2 cm more gains by a turn of 6 degrees
        ((0.02, 0.04), [4, 5, 0], 2e-4),
    ],
)
def test_a_sole_that_stood_tilted_is_level_and_on_the_ground_and_nothing_else_moves(
    radii: tuple[float, ...], degrees: list[float], within: float
) -> None:
    points, before = sole(*radii), recorded(0.64, np.radians(degrees))
    assert np.ptp(bottoms(before, points)[:, 0]) > 0.005
    found = align_to_ground(before, standing(points), [FLOOR])
    np.testing.assert_allclose(bottoms(found, points), 0, atol=within)
    np.testing.assert_array_equal(found.states[:, [0, 1, *range(3, 7)]], before.states[:, [0, 1, *range(3, 7)]])


def test_a_sole_that_stood_on_its_toes_is_set_down_as_it_is_in_the_middle_of_its_heights() -> None:
    points, before = sole(0.02, 0.02, 0.02, 0.02), recorded(0.9, np.radians([0, 40, 0]))
    found = align_to_ground(before, standing(points), [FLOOR])
    np.testing.assert_array_equal(found.states[:, 7:], before.states[:, 7:])
    assert np.median(bottoms(found, points)) == pytest.approx(0, abs=1e-9)
    np.testing.assert_array_equal(found.states[:, :2], before.states[:, :2])


def test_only_what_stands_says_how_high_the_ground_is() -> None:
    """The heel stands in the first half, 3 cm up; what it does later, and the toes, say nothing."""
    points, before = sole(0.02, 0.02, 0.02, 0.02), recorded(0.65, np.zeros(3))
    before.states[TIMES > 0.5, 2] += 0.2
    found = align_to_ground(before, [RecordedStance(point, 0.0, 0.5) for point in points[:2]], [FLOOR])
    np.testing.assert_allclose(bottoms(found, points)[:, TIMES <= 0.5], 0, atol=1e-9)
    np.testing.assert_allclose(found.states[:, 2] - before.states[:, 2], -0.03, atol=1e-9)


@pytest.mark.parametrize(("over", "moves"), [(-6, True), (1.2, True), (0.8, False)])
def test_a_recording_of_another_floor_comes_down_or_up_to_this_one_straight_and_one_that_is_near_stays(
    over: float, moves: bool
) -> None:
    points, over = sole(0.02, 0.02, 0.04, 0.04), over * Thresholds.of(FIGURE).floor_off
    before = recorded(0.64 + over, np.zeros(3))
    found = move_to_ground(before, points, [FLOOR])
    way = np.zeros(FIGURE.width)
    way[2] = -over if moves else 0
    np.testing.assert_allclose(found.states, before.states + way, atol=1e-9)


@pytest.mark.parametrize("degrees", [[0, 20, 0], [15, 0, 0], [-10, -25, 5]])
def test_it_is_the_lowest_spot_of_a_sole_whatever_its_radius_over_the_highest_ground_that_comes_down(degrees) -> None:
    points, stairs = sole(0.01, 0.03, 0.05, 0.02), Plane("stairs", np.array([0.0, 0, 0.1]), FLOOR.normal)
    before = recorded(1.6, np.radians(degrees))
    before.states[:, 2] += 0.1 * np.sin(3 * TIMES)
    for surfaces, ground in (([FLOOR], 0.0), ([FLOOR, stairs], 0.1), ([stairs, FLOOR], 0.1)):
        found = move_to_ground(before, points, surfaces)
        lowest = bottoms(before, points).min(axis=0) - ground
        np.testing.assert_allclose(found.states[:, 2] - before.states[:, 2], -np.percentile(lowest, LOWEST), atol=1e-9)


def test_without_points_stances_or_ground_a_recording_stays_what_it_is() -> None:
    points, before = sole(0.02, 0.02), recorded(1.5, np.radians([0, 12, 0]))
    assert move_to_ground(before, (), [FLOOR]) is before
    assert move_to_ground(before, points, []) is before
    assert align_to_ground(before, [], [FLOOR]) is before
    assert align_to_ground(before, standing(points), []) is before


@pytest.mark.parametrize(("samples", "level"), [(ENOUGH - 1, False), (ENOUGH, True)])
def test_a_sole_is_level_if_all_of_it_stands_in_enough_samples(samples: int, level: bool) -> None:
    points, before = sole(0.02, 0.02, 0.02, 0.02), recorded(0.64, np.radians([0, 12, 0]))
    heel = [RecordedStance(point, TIMES[0], TIMES[20]) for point in points[:2]]
    toes = [RecordedStance(point, TIMES[21 - samples], TIMES[-1]) for point in points[2:]]
    found = align_to_ground(before, [*heel, *toes], [FLOOR])
    assert (np.ptp(bottoms(found, points)[:, 0]) < 1e-9) == level


def test_what_is_next_to_nothing_off_is_left_there() -> None:
    points = sole(0.02, 0.02, 0.02, 0.02)
    for share, moves in ((0.8, False), (-0.8, False), (1.2, True), (-1.2, True)):
        over = share * Thresholds.of(FIGURE).level
        before = recorded(0.62 + over, np.zeros(3))
        found = align_to_ground(before, standing(points), [FLOOR])
        np.testing.assert_allclose(found.states[:, 2] - before.states[:, 2], -over * moves, atol=1e-9)
