"""Stances and the ground in recordings."""

import numpy as np
import pytest
import shipped
from figures import FLOOR, figure_of
from motions import Take, kneeling
from scipy.stats import multivariate_normal

from dynsplines.clip.context import Context
from dynsplines.clip.posing.places import sole_points
from dynsplines.clip.tracking.problem import tracking_context
from dynsplines.motion import samples_at
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.ground_alignment import LOWEST, align_to_ground, move_to_ground
from dynsplines.solver.contacts.recorded_stances import infer_stances, position_noise, surprisal
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import Point, places_of

FPS = 60.0


@pytest.fixture(scope="module")
def take() -> Take:
    return Take.of(shipped.solved("run_and_step"), FPS)


def ground_of(take: Take) -> Context:
    context = tracking_context(take.figure, take.time, take.figure.to_state(take.qpos), "take")
    return context.with_schedule(points=sole_points(take.figure, take.qpos[::10]))


def resting(take: Take, ground: Context) -> np.ndarray:
    """(p, T) which points are low and slow."""
    recorded = Track.of(take.figure, take.time, take.qpos)
    samples = samples_at(take.figure, recorded.path, take.time)
    places, _ = places_of(ground.points, samples)
    height, _ = height_over(ground.surfaces, places, np.array([point.radius for point in ground.points]))
    return (np.linalg.norm(np.gradient(places, take.time, axis=2), axis=0) < 0.15) & (height < 0.03)


def marked(stances: tuple[Contact, ...], take: Take, ground: Context) -> np.ndarray:
    """(p, T) which points stand by stances."""
    out = np.zeros((len(ground.points), take.time.size), bool)
    for one in stances:
        row = ground.points.index(one.point)
        out[row] |= (take.time >= one.first) & (take.time <= one.last)
    return out


@pytest.mark.slow
def test_of_a_run_that_ships_they_are_where_soles_rest(take):
    ground = ground_of(take)
    stances, _ = infer_stances(Track.of(take.figure, take.time, take.qpos), ground.points, ground.surfaces)
    found, true = marked(stances, take, ground), resting(take, ground)
    assert (found & true).sum() >= 0.9 * true.sum()
    assert (found & ~true).sum() <= 0.15 * found.sum()


# of the size of an adult
SLED = figure_of("""<mujoco><worldbody><body><joint type="slide" axis="1 0 0"/><geom size=".527"/>
        <body><joint type="slide" axis="0 0 1"/><geom size=".527"/></body></body></worldbody></mujoco>""")


RUNNER = Point("runner", 2, np.array([0.0, 0, -0.1]), 0.05)


def stances_of(times: np.ndarray, x: np.ndarray, over: np.ndarray) -> tuple[Contact, ...]:
    """Of a sphere at places along a line, its lowest spot so high over the floor."""
    return infer_stances(Track.of(SLED, times, np.column_stack([x, over + 0.15]), exact=True), [RUNNER], [FLOOR])[0]


def spans(stances: tuple[Contact, ...]) -> list[tuple[float, float]]:
    return [(one.first, one.last) for one in stances]


@pytest.mark.parametrize("seconds", [0.5, 0.7, 1.4])
def test_a_slow_step_is_no_stance(seconds):
    """A foot at rest is lifted by 8 cm, moved by 26 cm and put down again; it is slow all along, or when it lifts."""
    times = np.arange(0.0, 1.0 + seconds + 0.8, 1 / FPS)
    share = np.clip((times - 1.0) / seconds, 0, 1)
    x, over = 0.26 * share**2 * (3 - 2 * share), 0.08 * np.sin(np.pi * share) ** 2
    (first, lifted), (landed, last) = spans(stances_of(times, x, over))
    assert (first, last) == (times[0], times[-1])
    assert abs(over[times <= lifted].max()) <= 0.02 and abs(over[times >= landed].max()) <= 0.02
    assert 1.0 <= lifted <= 1.0 + 0.25 * seconds and 1.0 + 0.75 * seconds <= landed <= 1.0 + seconds


@pytest.mark.parametrize("before", [12, 30])
def test_a_stance_lasts_from_when_the_point_has_come_to_rest_until_it_leaves(before):
    """It slides in and on at 0.4 m/s, slowly enough to be of the run, too fast to stand."""
    k = np.arange(before + 80)
    found = stances_of(k / FPS, 0.4 / FPS * (k - np.clip(k - before, 0, 40)), 0 * k)
    assert len(found) == 1
    assert found[0].first == pytest.approx(before / FPS, abs=1.01 / FPS)
    assert found[0].last == pytest.approx((before + 40) / FPS, abs=1.01 / FPS)


def test_noise_is_that_of_the_known_samples():
    rng, known = np.random.default_rng(3), np.ones(900)
    places = rng.normal(size=(3, 2, 900)) * [[0.001], [0.004]]
    known[100:600] = 0
    places[..., 100:600] = 0
    np.testing.assert_allclose(position_noise(places, known), [0.001, 0.004], rtol=0.2)
    np.testing.assert_array_equal(position_noise(places, 0 * known), [0, 0])


def test_the_surprisal_of_positions_is_that_of_a_twice_integrated_wiener_process(rng):
    """By SciPy's density of all samples at once, given the first one."""
    limits, known = Thresholds(), np.array([True, False, True, True, True, False, True])
    times, places, variance = np.cumsum(rng.uniform(0.01, 0.1, 7)), rng.normal(size=(3, 2, 7)), np.array([1e-4, 4e-3])
    found, t = surprisal(times, places, variance, known, limits), (times - times[0])[known][1:]
    least, apart = np.minimum(t[:, None], t), np.abs(t[:, None] - t)
    moved = limits.lively * limits.moment * np.outer(t, t) + limits.lively * (least**3 / 3 + apart * least**2 / 2)
    for i in range(2):
        away = (places[:, i] - places[:, i, :1])[:, known][:, 1:]
        density = multivariate_normal(np.zeros(t.size), moved + variance[i] * (1 + np.eye(t.size)))
        assert found[i].sum() == pytest.approx(-density.logpdf(away).sum())
    assert not found[:, ~known].any()


def heights(take: Take, ground: Context) -> np.ndarray:
    """(4, T) of the lowest points of heel and toe, left and right."""
    assert [point.name for point in ground.points] == ["left_heel", "left_toe", "right_heel", "right_toe"]
    places, _ = places_of(ground.points, Samples.of_qpos(take.figure, take.qpos))
    return height_over(ground.surfaces, places, np.array([point.radius for point in ground.points]))[0]


@pytest.mark.parametrize(
    ("pitch", "metres", "degrees"), [(50, 0.004, 1.0), (36, 0.0, 0.0), (36, 0.004, 1.0), (25, 0.002, 0.4)]
)
def test_who_kneels_stands_on_the_toe_alone(pitch, metres, degrees):
    """A heel at rest 9 to 18 cm over the ground, or slower than its noise on its way there, is none of a stance."""
    take = kneeling(FPS, np.radians(pitch))
    ground = ground_of(take)
    qpos = take.shaking(take.qpos, np.random.default_rng(1), metres, np.radians(degrees))
    stances, raised = infer_stances(Track.of(take.figure, take.time, qpos), ground.points, ground.surfaces)
    height, found, resting_high = heights(take, ground), marked(stances, take, ground), marked(raised, take, ground)
    assert height[2, found[2]].max() < 0.07
    assert found[2, height[2] < 0.005].mean() > 0.9
    assert found[[0, 1, 3]].mean() > 0.9
    assert not resting_high[[0, 1, 3]].any()
    assert height[2, resting_high[2]].min(initial=1.0) > 0.04
    if pitch < 40:  # in the end it rests below half of the heights in the air
        assert resting_high[2, (take.time > 2.4) & (take.time < 3)].mean() > 0.9


def test_a_stance_on_an_edge_is_on_what_ends_there():
    """A box's top ends 4 cm before the point, which stands as high as it, and the floor is half a metre down."""
    box = Box("box", np.array([-1.04, 0.0, 0.25]), np.eye(3), np.array([1.0, 1.0, 0.25]))
    times = np.arange(40) / FPS
    recorded = Track.of(SLED, times, np.column_stack([0 * times, np.full(40, 0.65)]), exact=True)
    (one,) = infer_stances(recorded, [RUNNER], [FLOOR, box])[0]
    assert one.surface is not None
    assert one.surface.height(np.array([0.0, 0.0, 0.5])) == pytest.approx(0, abs=1e-12)
    assert infer_stances(recorded, [RUNNER], [FLOOR])[0] == ()


FIGURE = figure_of("""<mujoco><worldbody><body name="trunk"><freejoint/><geom size=".1"/>
        <body name="foot" pos="0 0 -.5"><joint type="ball"/><geom size=".05"/></body></body></worldbody></mujoco>""")


FOOT = 2


TIMES = np.linspace(0, 1, 31)


CORNERS = np.array([[-0.05, -0.04, -0.1], [-0.05, 0.04, -0.1], [0.15, -0.05, -0.1], [0.15, 0.05, -0.1]])


def sole(*radii: float) -> tuple[Point, ...]:
    """Spheres at corners of a sole that is flat, if they all are as large."""
    return tuple(Point(f"{i}", FOOT, CORNERS[i], radius) for i, radius in enumerate(radii))


def recorded(height: float, turn: Array) -> Track:
    """Walking along a line, the trunk turned about the vertical, the foot turned (3,) [rad] all the time."""
    qpos = np.zeros((TIMES.size, 11))
    qpos[:, 0], qpos[:, 1], qpos[:, 2] = TIMES, 0.3, height
    qpos[:, 3:7] = quat.from_rotation_vector([0, 0, 0.7])
    qpos[:, 7:] = quat.from_rotation_vector(turn)
    return Track.of(FIGURE, TIMES, qpos, exact=True)


def bottoms(found: Track, points: tuple[Point, ...]) -> Array:
    """(p, T) [m] how high the lowest spots of points are."""
    samples = Samples(FIGURE, found.states, 0 * found.states, 0 * found.states)
    return places_of(points, samples)[0][2] - np.array([[point.radius] for point in points])


def standing(points: tuple[Point, ...]) -> list[Contact]:
    return [Contact(point, TIMES[0], TIMES[-1]) for point in points]


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


@pytest.mark.parametrize(("over", "moves"), [(-6, True), (1.2, True), (0.8, False)])
def test_a_recording_of_another_floor_comes_down_or_up_to_this_one_straight_and_one_that_is_near_stays(
    over: float, moves: bool
) -> None:
    points, over = sole(0.02, 0.02, 0.04, 0.04), over * Thresholds.of(FIGURE).same_spot
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
