"""Stances read off a recording: of a shipped run they are where soles rest; noise and a slow swing make none."""

import mujoco
import numpy as np
import pytest
import shipped
from faulted import Take

from dynsplines.clip.follow.keeping import Ground
from dynsplines.clip.posing.feet import sole_points
from dynsplines.motion import samples_at
from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.reading.recorded import ORDER, Recorded
from dynsplines.solver.reading.settled import settled
from dynsplines.solver.reading.stances import LOW, NOISY, ONE, ROLLS, SUNK, Stood, _cut, _joined, stood, unsure, white
from dynsplines.solver.surface import Plane, static_surfaces
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import Point, places_of

FPS = 60.0


@pytest.fixture(scope="module")
def take() -> Take:
    return Take.of(shipped.solved("run_and_step"), FPS)


def ground_of(take: Take) -> Ground:
    return Ground(take.figure, sole_points(take.figure, take.qpos[::10]), tuple(static_surfaces(take.figure.model)))


def resting(take: Take, ground: Ground) -> np.ndarray:
    """(p, T) which points are low and slow."""
    recorded = Recorded.of(take.figure, take.time, take.qpos)
    samples = samples_at(take.figure, recorded.path, take.time)
    places, _, _ = places_of(ground.points, samples)
    height, _ = height_over(ground.surfaces, places, np.array([point.radius for point in ground.points]))
    return (np.linalg.norm(np.gradient(places, take.time, axis=2), axis=0) < 0.2) & (height < 0.03)


def marked(stances: tuple[Stood, ...], take: Take, ground: Ground) -> np.ndarray:
    """(p, T) which points stand by stances."""
    out = np.zeros((len(ground.points), take.time.size), bool)
    for one in stances:
        row = ground.points.index(one.point)
        out[row] |= (take.time >= one.first) & (take.time <= one.last)
    return out


@pytest.mark.slow
def test_of_a_run_that_ships_they_are_where_soles_rest(take):
    ground = ground_of(take)
    stances = stood(Recorded.of(take.figure, take.time, take.qpos), ground.points, ground.surfaces)
    found, true = marked(stances, take, ground), resting(take, ground)
    assert (found & true).sum() >= 0.9 * true.sum()
    assert (found & ~true).sum() <= 0.15 * found.sum()


@pytest.mark.slow
def test_what_shakes_slides_and_sinks_keeps_most_of_them(take, rng):
    ground, true = ground_of(take), resting(take, ground_of(take))
    qpos = take.shaking(take.sliding(rng), rng, 0.003, np.radians(0.5))
    found = marked(stood(Recorded.of(take.figure, take.time, qpos), ground.points, ground.surfaces), take, ground)
    assert (found & true).sum() >= 0.7 * true.sum()
    assert (found & ~true).sum() <= 0.25 * found.sum()


@pytest.mark.slow
def test_what_is_set_down_is_as_high_and_as_level_as_its_stances_say(take):
    ground, figure = ground_of(take), take.figure
    stances = stood(Recorded.of(figure, take.time, take.qpos), ground.points, ground.surfaces)
    qpos = take.qpos.copy()
    qpos[:, 2] += 0.04
    link = ground.points[0].link
    first = figure.links[link].qpos
    tilt = quat.from_rotation_vector(np.radians([0.0, 12.0, 0.0]))
    qpos[:, first : first + 4] = quat.product(qpos[:, first : first + 4], tilt)
    found = settled(Recorded.of(figure, take.time, qpos), stances, ground.surfaces)
    places, _, _ = places_of(ground.points, samples_at(figure, found.path, take.time))
    height, _ = height_over(ground.surfaces, places, np.array([point.radius for point in ground.points]))
    assert np.abs(np.median(height[marked(stances, take, ground)])) < 0.005
    true = Recorded.of(figure, take.time, take.qpos)
    apart = quat.product(quat.conjugate(true.path.at(take.time)[:, _columns(figure, link)]),
                         found.path.at(take.time)[:, _columns(figure, link)])  # fmt: skip
    assert np.degrees(np.median(2 * np.arccos(np.clip(np.abs(apart[:, 0]), 0, 1)))) < 4


def _columns(figure, link: int) -> slice:
    return slice(figure.links[link].qpos, figure.links[link].qpos + 4)


SLED = Figure(
    mujoco.MjModel.from_xml_string(
        """<mujoco><worldbody><body><joint type="slide" axis="1 0 0"/><geom size=".1"/>
        <body><joint type="slide" axis="0 0 1"/><geom size=".1"/></body></body></worldbody></mujoco>"""
    )
)
RUNNER = Point("runner", 2, np.array([0.0, 0, -0.1]), 0.05)
FLOOR = Plane("floor", np.zeros(3), np.array([0.0, 0, 1]))


def stances_of(times: np.ndarray, x: np.ndarray, over: np.ndarray) -> tuple[Stood, ...]:
    """Of a sphere at places along a line, its lowest spot so high over the floor."""
    return stood(Recorded.of(SLED, times, np.column_stack([x, over + 0.15]), exact=True), [RUNNER], [FLOOR])


@pytest.mark.parametrize("below", [False, True])
@pytest.mark.parametrize("count", [6, 31])
def test_what_hovers_still_stands_as_long_as_its_samples_outweigh_what_a_stance_costs(count, below):
    """n samples at a height h, in such as count, speak n (1 − h²) for it: that is one at h = √(1 − 1/n)."""
    times = np.arange(count) / FPS
    bound = np.sqrt(1 - ONE / count) * (-LOW / SUNK if below else LOW)
    for share, stands in ((0.9996, True), (1.0004, False)):
        found = stances_of(times, 0 * times, np.full(count, share * bound))
        assert found == ((Stood(RUNNER, times[0], times[-1]),) if stands else ())


@pytest.mark.parametrize("before", [12, 30])
def test_a_stance_lasts_from_when_the_point_has_come_to_rest_until_it_leaves(before):
    """It slides in and on at 0.4 m/s, slowly enough to be of the run, too fast to stand."""
    k = np.arange(before + 80)
    found = stances_of(k / FPS, 0.4 / FPS * (k - np.clip(k - before, 0, 40)), 0 * k)
    assert found == (Stood(RUNNER, before / FPS, (before + 40) / FPS),)


def test_of_all_ways_to_cut_a_recording_into_stances_the_likeliest_is_taken(rng):
    """All ways, one by one. White noise scatters the places of n samples about their middle by 3 (n − 1) variances."""
    count = 9
    pairs = [(a, b) for a in range(count) for b in range(a + 2, count + 1)]

    def ways(first: int) -> list[list[tuple[int, int]]]:
        return [[], *([(a, b), *rest] for a, b in pairs if a >= first for rest in ways(b))]

    every, seen = ways(0), set()
    for _ in range(40):
        noise, steps = rng.uniform(0, 0.02), rng.normal(size=(3, count)) * rng.choice([0.002, 0.04], count)
        place, height = np.cumsum(steps, axis=1) + rng.normal(0, noise, (3, count)), rng.uniform(0, 1.2, count)
        variance = noise**2 + ROLLS**2

        def cost(a: int, b: int, place=place, height=height, noise=noise, variance=variance) -> float:
            scatter = (b - a) * np.var(place[:, a:b], axis=1).sum() - 3 * (b - a - 1) * noise**2
            own = scatter / variance + (b - a) * (np.mean(height[a:b]) ** 2 - 1)
            return ONE + NOISY * noise**2 / variance + own

        costs = {pair: cost(*pair) for pair in pairs}
        least = min(every, key=lambda runs, costs=costs: sum(costs[run] for run in runs))
        assert _cut(np.arange(count) / FPS, place, height, noise) == least
        seen.add(len(least))
    assert seen >= {0, 1, 2}


def test_nothing_stands_where_there_is_no_ground_or_no_sole(figure, rng):
    times = np.linspace(0, 1, 31)
    recorded = Recorded.of(figure, times, np.tile(figure.model.qpos0, (31, 1)))
    assert stood(recorded, (), ()) == ()
    assert settled(recorded, (), ()) is recorded


def test_the_noise_of_places_is_that_of_their_samples_whatever_smooth_way_they_go_and_gaps_hold(rng):
    count, sizes = 4000, np.array([0.002, 0.01, 0.0])
    noise = sizes[:, None] * rng.normal(size=(3, 3, count))
    known = np.ones(count)
    found = white(noise, known)
    np.testing.assert_allclose(found, sizes, rtol=0.06)
    t = np.linspace(-1, 1, count)
    smooth = np.polynomial.polynomial.polyval(t, rng.normal(size=(4, 3, 3)))  # of degree three
    np.testing.assert_allclose(white(noise + smooth, known), found, atol=1e-9)
    known[1000:1100] = known[2500] = 0
    wild = np.where(known > 0, noise, 100 * rng.normal(size=noise.shape))
    np.testing.assert_allclose(white(wild, known), sizes, rtol=0.06)
    np.testing.assert_array_equal(white(noise[..., :ORDER], known[:ORDER]), np.zeros(3))
    assert np.all(white(noise[:, :2, : ORDER + 1], known[: ORDER + 1])[:2] > 0)


def test_how_unsure_a_recording_is_of_its_points_is_the_noise_of_the_one_that_is_known_worst(rng):
    times = np.arange(400) / FPS
    qpos = np.column_stack([0.5 * times, 0.2 * np.sin(times)]) + 0.004 * rng.normal(size=(400, 2))
    recorded = Recorded(SLED, times, qpos, np.ones((400, 2)))
    first = Point("first", 1, np.zeros(3))
    low, high = unsure(recorded, [first]), unsure(recorded, [first, RUNNER])
    assert low <= high
    seen = white(np.stack([qpos[:, 0], 0 * times, qpos[:, 1]])[:, None], np.ones(400))[0]
    assert high == pytest.approx(seen, rel=0.3)
    assert unsure(recorded, []) == 0
    short = Recorded(SLED, times[: ORDER - 1], qpos[: ORDER - 1], np.ones((ORDER - 1, 2)))
    assert unsure(short, [RUNNER]) == 0
    assert stood(short, [RUNNER], [FLOOR]) == ()


@pytest.mark.parametrize("times_as_many", [1, 2, 4])
def test_more_samples_a_second_than_tell_anything_make_the_same_stances(times_as_many):
    k = np.arange(100 * times_as_many)
    fine = FPS * times_as_many
    found = stances_of(k / fine, 1.5 / FPS * (k / times_as_many - np.clip(k / times_as_many - 30, 0, 40)), 0 * k)
    (one,) = found
    assert one.first == pytest.approx(30 / FPS, abs=1.01 / FPS)
    assert one.last == pytest.approx(70 / FPS, abs=1.01 / FPS)


@pytest.mark.parametrize(("apart", "gap", "one"), [(0.0, 3, True), (0.02, 3, True), (0.04, 3, False), (0.0, 12, False)])
def test_two_runs_shortly_after_each_other_in_the_same_place_are_one_stance(apart, gap, one):
    times = np.arange(60) / FPS
    place = np.zeros((3, 60))
    place[0, 20 + gap :] = apart
    runs = _joined(times, [(0, 20), (20 + gap, 60)], place, 0.0)
    assert runs == ([(0, 60)] if one else [(0, 20), (20 + gap, 60)])
