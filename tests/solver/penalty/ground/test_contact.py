"""Contacts, stances, targets, grasps, resting points, skating and hovering: values, and motions that obey them."""

import dataclasses
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from figures import BALL, FLOOR, SMOOTHNESS, UP, figure_of, plane_below, random_points, stance_of, two_points
from gradients import assembled, curvature_of
from oracles import kinematics
from random_models import at_times, random_samples

from dynsplines.solver import penalty
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact, resting_objects, stances
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point, places_of


def test_it_is_the_sum_of_squared_depths_of_points_placed_by_mujoco(figure, rng):
    samples = random_samples(figure, rng, 8)
    samples.y[:, 2] = 0
    points = random_points(figure, rng)
    expected = []
    ends = {link.body: i for i, link in enumerate(figure.links) if i and figure.body_link[link.body] == i}
    points = tuple(p for p in points if p.link in ends.values())
    for qpos in figure.to_qpos(samples.y):
        data = kinematics(figure.model, qpos)
        total = 0.0
        for body, link in ends.items():
            for point in (p for p in points if p.link == link):
                height = (data.xpos[body] + data.xmat[body].reshape(3, 3) @ point.position)[2]
                total += max(point.radius + 0.05 - height, 0) ** 2
        expected.append(total)
    np.testing.assert_allclose(penalty.Collision(points, (FLOOR,), margin=0.05).evaluate(samples), expected, rtol=1e-10)
    assert np.count_nonzero(expected) > 4


FOOT = Point("foot", 1, np.array([0.0, 0, -0.5]), 0.1)


def test_it_is_the_squared_distance_from_the_drifting_spot_while_the_stance_lasts(figure, rng):
    t = np.array([0.0, 0.49, 0.5, 0.75, 1.0, 1.01])
    samples = at_times(random_samples(figure, rng, 6), t)
    stance = stance_of(1, 0.5, 1.0)
    offset = np.einsum("ijs,j->is", samples.links.rotation[:, :, 1], stance.point.position)
    away = samples.links.x[:, 1] + offset - np.array([0.1, 0.2, 0])[:, None]
    away -= np.array([0.03, 0, 0.01])[:, None] * (t - 0.5) / 0.5
    expected = np.where((t >= 0.5) & (t <= 1.0), np.sum(away**2, axis=0), 0)
    np.testing.assert_allclose(penalty.Attachment((stance,)).evaluate(samples), expected, rtol=1e-12)
    assert np.count_nonzero(expected) == 3


def found(places: list[tuple[float, float]]) -> tuple[Contact, ...]:
    """The stances of a ball on a stick whose foot is at these (x, height) in keyframes a second apart."""
    model = mujoco.MjModel.from_xml_string(BALL)
    figure = Figure(model)
    keys = [Frame.key(float(i), [x, 0, z + 0.6, 1, 0, 0, 0]) for i, (x, z) in enumerate(places)]
    return stances(KeyframePoints.of(figure, raw_timeline(figure, keys), (FOOT,), (FLOOR,)))


def test_two_keyframes_with_the_point_on_one_spot_plant_it_between_them():
    (stance,) = found([(0.0, 0.3), (0.5, 0.005), (0.52, -0.005), (1.0, 0.3)])
    assert (stance.first, stance.last) == (1.0, 2.0)
    np.testing.assert_allclose(stance.place(np.array([1.0, 1.5, 2.0]))[0], [0.5, 0.51, 0.52])
    np.testing.assert_allclose(stance.place(np.array([1.0, 1.5, 2.0]))[2], [0.105, 0.1, 0.095])


@pytest.mark.parametrize(
    "places",
    [
        [(0.0, 0.0), (0.06, 0.0)],  # slid
        [(0.0, 0.0), (0.0, 0.02)],  # lifted
        [(0.0, -0.02), (0.0, 0.0)],  # below the floor
        [(0.0, 0.0), (0.0, 0.3), (0.0, 0.0)],  # a hop
    ],
)
def test_a_point_that_moved_or_left_the_surface_is_not_planted(places):
    assert found(places) == ()


BOX = """<mujoco><worldbody><body name="box"><freejoint name="box"/><geom type="box" size=".1 .2 .3"/></body>
</worldbody></mujoco>"""


def box_keys(figure: Figure, places: list[list[float]], told: list[bool]) -> Timeline:
    """Keyframes a second apart of a box at places, turned alike; those that are not told leave its place free."""
    masks = [np.array([each] * 3 + [True] * 4) for each in told]
    turned = quat.from_rotation_vector([0.3, 0.2, 0.1])
    keys = [
        Frame.key(float(i), [*place, *turned], mask) for i, (place, mask) in enumerate(zip(places, masks, strict=True))
    ]
    return raw_timeline(figure, keys)


def test_a_thing_lies_still_between_keyframes_that_both_say_the_same_of_it():
    figure = figure_of(BOX)
    here, there = [0.0, 0, 0.3], [0.01, 0, 0.3]
    found = resting_objects(
        KeyframePoints.of(figure, box_keys(figure, [here, here, there, there], [True] * 4), ()), [1]
    )
    assert [(stance.first, stance.last) for stance in found] == [(0.0, 1.0)] * 3 + [(2.0, 3.0)] * 3
    places = [stance.place(np.array([stance.first, stance.last])) for stance in found]
    np.testing.assert_allclose(np.ptp(places, axis=2), 0, atol=1e-12)
    for told in ([True, False], [False, True], [False, False]):
        assert resting_objects(KeyframePoints.of(figure, box_keys(figure, [here, here], told), ()), [1]) == ()
    assert resting_objects(KeyframePoints.of(figure, box_keys(figure, [here, here], [True, True]), ()), []) == ()


TILT = np.array([0.28, 0, 0.96])


LOW_FLOOR = Plane("floor", -50 * UP, UP)


def case(figure: Figure, rng: np.random.Generator) -> tuple[Samples, penalty.Attachment]:
    samples = at_times(random_samples(figure, rng, 6), np.linspace(0, 1, 6))
    last, slope = len(figure.links) - 1, Plane("slope", -50 * UP + 3 * TILT, TILT)
    rests = (
        Contact(Point("a", 1, np.array([0.1, 0.2, -0.3]), 0.05), 0.1, 0.5, rolls=True),
        Contact(Point("b", last, UP), 0.3, 1.0),
        Contact(Point("c", last, np.array([0.2, 0.1, 0.0]), 0.02), 0.1, 0.9, surface=slope, rolls=True),
        Contact(Point("d", last, np.array([0.0, 0.1, 0.2]), 0.03), 0.2, 0.8),
        Contact(Point("c again", last, np.array([0.2, 0.1, 0.0]), 0.02), 0.5, 1.0, rolls=True),
    )
    return samples, penalty.Attachment(rests, (LOW_FLOOR,))


def test_the_value_by_hand(figure, rng):
    samples, resting = case(figure, rng)
    expected = np.zeros(6)
    for rest in resting.resting:
        links = samples.links
        offset = np.einsum("ijs,j->is", links.rotation[:, :, rest.point.link], rest.point.position)
        place, normal = links.x[:, rest.point.link] + offset, UP if rest.surface is None else TILT
        lowest = offset - rest.rolls * rest.point.radius * normal[:, None]
        velocity = links.x_d[:, rest.point.link] + np.cross(links.omega[:, rest.point.link].T, lowest.T).T
        height = normal @ (place + 50 * UP[:, None]) - (3 if rest.surface else 0) - rest.point.radius
        during = (samples.t >= rest.first) & (samples.t <= rest.last)
        expected += during * (height**2 + Thresholds.of(samples.figure).settling ** 2 * np.sum(velocity**2, axis=0))
    np.testing.assert_allclose(resting.evaluate(samples), expected, rtol=1e-9)


@pytest.mark.parametrize("angle", [-0.7, 0.0, 1.2])
def test_a_sphere_that_rolls_goes_as_far_as_it_has_turned(angle):
    start = quat.from_rotation_vector([0.2, -0.4, 0.9])
    turned = quat.product(quat.from_rotation_vector([0, angle, 0]), start)[:, None]
    for rolls, ground, way in ((True, None, 1.0), (True, Plane("floor", np.zeros(3), UP), 1.0), (False, None, 0.0)):
        rest = Contact(Point("ball", 1, np.zeros(3), 0.05), 0.0, 1.0, surface=ground, rolls=rolls)
        found = dataclasses.replace(rest, start=start).roll(turned)
        np.testing.assert_allclose(found[:, 0], [way * 0.05 * angle, 0, 0], atol=1e-12)


TWO = """<mujoco><worldbody>
<body name="hand"><freejoint/><geom size=".1"/></body>
<body name="box"><freejoint/><geom type="box" size=".2 .3 .1"/></body>
</worldbody></mujoco>"""


HAND = Point("hand", 1, np.array([0.1, 0.2, -0.3]))


def grasps(figure: Figure) -> tuple[Contact, Contact]:
    """One whose spot drifts and then stays, with more and more slack, and one whose spot nobody knows."""
    last = len(figure.links) - 1
    places = np.array([[0.1, 0, 0.2], [0.1, 0.3, 0], [0.1, 0.3, 0]])
    drifting = Contact(HAND, 0.1, 0.8, last, places, np.array([0.1, 0.4, 0.8]), slack=np.array([0.0, 0.3, 0.7]))
    return drifting, Contact(Point("b", last, np.ones(3)), 0.3, 1.0, 1)


def grasp_case(figure: Figure, rng: np.random.Generator) -> tuple[Samples, tuple[Contact, Contact]]:
    return at_times(random_samples(figure, rng, 6), np.linspace(0, 1, 6)), grasps(figure)


def known(samples: Samples, grasp: Contact) -> Array:
    """(S, 3) the way from the spot to the hand, as far as it is beyond the slack."""
    links = samples.links
    away = np.empty((samples.count, 3))
    for s, t in enumerate(samples.t):
        share = np.clip((t - 0.1) / 0.3, 0, 1)
        spot = np.array([0.1, 0.3 * share, 0.2 * (1 - share)])
        hand = links.x[:, grasp.point.link, s] + links.rotation[:, :, grasp.point.link, s] @ grasp.point.position
        whole = hand - links.x[:, grasp.on, s] - links.rotation[:, :, grasp.on, s] @ spot
        far = float(np.linalg.norm(whole))
        away[s] = max(far - np.interp(t, [0.1, 0.8], [0, 0.7]), 0) / far * whole
    return away


def sliding(samples: Samples, grasp: Contact) -> Array:
    """(S, 3) how fast the hand moves on the body, in that link's axes, by differences along y', y''."""
    h = 1e-5
    there = [
        penalty.grasp_places(Samples(samples.figure, samples.y + k * h * samples.y_d, samples.y_d, samples.y_dd), grasp)
        for k in (-1, 1)
    ]
    return ((there[1] - there[0]) / (2 * h)).T


def test_the_value_is_the_distance_from_the_spot_or_what_the_hand_slides_on_the_body_in_a_twentieth_of_a_second(
    figure, rng
):
    samples, (first, second) = grasp_case(figure, rng)
    t = samples.t
    expected = ((t >= 0.1) & (t <= 0.8)) * np.sum(known(samples, first) ** 2, axis=1)
    settling = Thresholds.of(samples.figure).settling
    expected += ((t >= 0.3) & (t <= 1.0)) * settling**2 * np.sum(sliding(samples, second) ** 2, axis=1)
    np.testing.assert_allclose(penalty.Attachment((first, second)).evaluate(samples), expected, rtol=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("is_known", [True, False])
def test_a_hand_stays_on_a_box_that_turns_where_the_raw_spline_loses_it(is_known):
    figure = figure_of(TWO)
    spot, keys = np.array([0.9, 0, 0]), []
    for i in range(2):
        box, turn = np.array([0.5, 0.4, 0.3]) * i, [np.cos(0.6 * i), 0, 0, np.sin(0.6 * i)]
        keys.append(Frame.key(float(i), [*(box + quat.rotate(turn, spot)), 1, 0, 0, 0, *box, *turn]))
    hand = Point("hand", 1, np.zeros(3))
    grasp = Contact.at(hand, 0.0, 1.0, spot, on=2) if is_known else Contact(hand, 0.0, 1.0, 2)

    def worst(weight: float) -> float:
        penalties = [*SMOOTHNESS, (penalty.Attachment((grasp,)), weight)]
        motion = inbetween(Problem(figure, keys, penalties, Settings(tolerance=1e-5)))
        samples = Samples(figure, *(figure.to_state(motion.at(np.linspace(0, 1, 80))),) * 3)
        return float(np.linalg.norm(penalty.grasp_places(samples, grasp) - spot[:, None], axis=0).max())

    assert worst(0.0) > 0.1
    assert worst(300.0) < 0.003


def test_the_value_is_the_velocity_by_differences_weighted_by_height(figure, rng):
    samples, h = random_samples(figure, rng, 5), 1e-6
    points, floor = two_points(figure), plane_below(samples)
    before, after = (Samples(figure, samples.y + s * samples.y_d, samples.y_d, samples.y_dd) for s in (-h, h))
    contact = penalty.Collision(points, ())
    velocity = (contact.centres(after)[0] - contact.centres(before)[0]) / (2 * h)
    height = contact.centres(samples)[0][2] - floor.point[2] - np.array([0.05, 0])[:, None]
    u = height / 0.4
    expected = np.sum(np.exp(-u * (u + 0.5) / 1.5) * np.sum(velocity**2, axis=0), axis=0)
    np.testing.assert_allclose(penalty.Skate(points, (floor,), 0.4).evaluate(samples), expected, rtol=1e-6)


def test_a_step_of_the_model_cannot_gain_without_limit(figure, rng):
    """The gradient is within the range of the matrices, and the model promises at most the squares of its residuals."""
    samples = random_samples(figure, rng, 3)
    skate, cotangent = penalty.Skate(two_points(figure), (plane_below(samples),), 1.0), Cotangent(samples)
    values = skate.evaluate(samples, cotangent)
    matrices = assembled(curvature_of(skate, samples, np.ones(3)), np.tile(np.eye(3), (3, 1, 1)))
    for value, matrix, gradient in zip(values, matrices, np.hstack(cotangent.gradients()), strict=True):
        step = np.linalg.lstsq(matrix, -gradient, rcond=1e-10)[0]
        np.testing.assert_allclose(matrix @ step, -gradient, atol=1e-6 * np.abs(gradient).max())
        assert 0 < -0.5 * gradient @ step <= 2 * value * (1 + 1e-6)


def test_the_value_is_continuous_where_a_point_passes_over_the_edge_of_a_step():
    figure, skate = figure_of(BALL), penalty.Skate((BALL_POINT,), (FLOOR, STEP))
    for height in (0.0, 0.01, 0.05):
        y = np.array([[x, 0, 0.3 + height, 1, 0, 0, 0] for x in (-1e-9, 1e-9)])
        left, right = skate.evaluate(Samples(figure, y, np.eye(1, 7) + np.zeros((2, 1)), np.zeros((2, 7))))
        assert left > 0.1
        np.testing.assert_allclose(left, right, rtol=1e-6)


BALL_POINT = Point("foot", 1, np.zeros(3), 0.1)


STEP = Box("step", np.array([0.5, 0, 0.1]), np.eye(3), np.array([0.5, 0.5, 0.1]))


def speed_on_the_ground(weight: float, clock: float = 1.0) -> float:
    """How fast a ball moves on the average while it is within 5 mm of the floor, between keyframes on and above it."""
    figure = figure_of(BALL)
    places = [(0.0, 0.4), (0.4, 0.1), (0.5, 0.1), (0.9, 0.4)]
    keys = [Frame.key(0.3 * clock * i, [x, 0, z, 1, 0, 0, 0]) for i, (x, z) in enumerate(places)]
    motion = inbetween(
        Problem(figure, keys, [*SMOOTHNESS, (penalty.Skate((BALL_POINT,), (FLOOR,)), weight)], Settings(tolerance=1e-4))
    )
    t = np.linspace(0, 0.9 * clock, 901)
    qpos = motion.at(t)
    speed = np.linalg.norm(np.gradient(qpos[:, :2], t, axis=0), axis=1)
    np.testing.assert_allclose(motion.at([key.time for key in keys]), [key.state for key in keys], atol=1e-12)
    return float(clock * speed[np.abs(qpos[:, 2] - 0.1) < 0.005].mean())


@pytest.mark.slow
def test_a_point_that_comes_down_is_slow_there_and_without_the_penalty_it_is_not():
    assert speed_on_the_ground(0.0) > 0.25
    assert speed_on_the_ground(300.0) < 0.7 * speed_on_the_ground(0.0)


def ground_case(figure: Figure, rng: np.random.Generator, count: int = 6) -> tuple[Samples, penalty.HoverPenalty]:
    samples = at_times(random_samples(figure, rng, count), np.linspace(0, 1, count))
    return samples, penalty.HoverPenalty(two_points(figure), (plane_below(samples),), reach=0.8, blend=0.2)


def lowest(samples: Samples, grounded: penalty.HoverPenalty, blend: float | np.ndarray) -> np.ndarray:
    """The smooth minimum of the heights of the two points, (S,)."""
    (floor,) = grounded.surfaces
    assert isinstance(floor, Plane)
    centres, _ = places_of(grounded.points, samples)
    height = centres[2] - floor.point[2] - np.array([0.05, 0])[:, None]
    return np.maximum(-blend * np.log(np.sum(np.exp(-height / blend), axis=0)), 0)


def test_the_value_of_hovering_by_hand(figure, rng):
    samples, grounded = ground_case(figure, rng)
    low = lowest(samples, grounded, 0.2)
    expected = 0.64 * (1 - np.exp(-((low / 0.8) ** 2)))
    np.testing.assert_allclose(grounded.evaluate(samples), expected, rtol=1e-9)
    assert np.count_nonzero(expected) > 1
    landed, during = replace(grounded, landed=((0.3, 0.7),)), (samples.t >= 0.3) & (samples.t <= 0.7)
    np.testing.assert_allclose(landed.evaluate(samples), np.where(during, 100, 1) * expected, rtol=1e-9)
