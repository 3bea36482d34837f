"""Stances read off a recording: of a shipped run they are where soles rest; noise and a slow swing make none."""

import numpy as np
import pytest
import shipped
from faulted import Take

from dynsplines.clip.follow.keeping import Ground
from dynsplines.clip.posing.feet import sole_points
from dynsplines.motion import samples_at
from dynsplines.solver import quaternion as quat
from dynsplines.solver.reading.recorded import Recorded
from dynsplines.solver.reading.settled import settled
from dynsplines.solver.reading.stances import Stood, stood
from dynsplines.solver.surface import static_surfaces
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import places_of

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


def test_nothing_stands_where_there_is_no_ground_or_no_sole(figure, rng):
    times = np.linspace(0, 1, 31)
    recorded = Recorded.of(figure, times, np.tile(figure.model.qpos0, (31, 1)))
    assert stood(recorded, (), ()) == ()
    assert settled(recorded, (), ()) is recorded
