"""Grasps and flights, inferred from keyframes."""

import numpy as np
import pytest
from figures import FLOOR, figure_of
from oracles import kinematics
from random_models import random_samples
from texts import read_data

from dynsplines import inbetween, load
from dynsplines.solver.contacts import Contact, ContactSchedule, grasped_links, surfaces_on
from dynsplines.solver.contacts.flight import STRETCHED
from dynsplines.solver.contacts.grasp import resting_objects
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.figure.dynamics import Size
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Collision
from dynsplines.solver.surface import moving_surface
from dynsplines.solver.surface.cover import covering_points
from dynsplines.solver.surface.points import Point

CARRIER = read_data("carrier.xml")


def few(link: int) -> Collision:
    """Three spheres of arm and trunk instead of hundreds, one of them a point."""
    places = ((2, 0.9, 0.25), (2, 0.5, 0.0), (1, 0.1, 0.3))
    points = tuple(Point(f"{i}", i, np.array([0.05, 0, z]), radius) for i, z, radius in places)
    return Collision(points, surfaces_on(figure_of(CARRIER), link), carrier=link)


def tangled(figure: Figure, rng: np.random.Generator) -> Samples:
    """Poses near enough to each other that arm and crate meet."""
    samples = random_samples(figure, rng, 12)
    y = samples.y.copy()
    columns = figure.tables.position_columns
    y[:, columns] *= 0.3
    return Samples(figure, y, samples.y_d, samples.y_dd)


def test_what_another_tree_holds_is_carried_with_all_its_parts():
    figure = figure_of(CARRIER)
    hand, knee = Point("hand", 2, np.zeros(3)), Point("knee", 1, np.zeros(3))
    assert grasped_links(figure, [Contact(hand, 0, 1, 3)]) == (3, 4)
    assert grasped_links(figure, [Contact(hand, 0, 1, 1)]) == ()
    assert grasped_links(figure, [Contact(Point("hook", 3, np.zeros(3)), 0, 1, 1)]) == (1, 2)
    assert grasped_links(figure, [Contact(hand, 0, 1, 3), Contact(knee, 0, 1, 2)]) == (3, 4)
    assert [surface.name for surface in surfaces_on(figure, 3)] == ["crate", "knob"]
    schedule = ContactSchedule(
        figure,
        raw_timeline(figure, [Frame.key(t, figure.model.qpos0) for t in (0, 1)]),
        grasps=(Contact(hand, 0, 1, 3),),
    )
    assert schedule.exclude_grasped([hand, knee, Point("lid", 4, np.zeros(3))]) == (hand, knee)
    assert {point.link for point in schedule.low_points} == {1, 2}


def test_what_is_deep_is_as_deep_as_in_what_stands_still_there(rng):
    """MuJoCo puts every pose's crate into the world, as a surface of its own."""
    figure = figure_of(CARRIER)
    model, samples, contact = figure.model, tangled(figure, rng), few(3)
    found, own = contact.evaluate(samples), [model.geom(name).id for name in ("crate", "knob")]
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data = kinematics(model, qpos)
        still = [moving_surface(model, g, data.geom_xpos[g], data.geom_xmat[g].reshape(3, 3)) for g in own]
        expected = Collision(contact.points, tuple(s for s in still if s is not None)).evaluate(
            samples.select(np.array([i]))
        )
        np.testing.assert_allclose(found[i], expected[0], rtol=1e-6, atol=1e-12)
    assert np.count_nonzero(found) > 3


def test_a_limb_that_holds_on_may_stay_as_deep_as_it_took_hold_while_the_hold_lasts_and_no_longer():
    """The arm of the trunk holds on, but not a wing in the world, though it is as free."""
    wing = '<body pos="0 0 1"><joint type="ball"/><geom type="capsule" size=".1" fromto="0 0 0 0 0 .3"/></body>'
    figure = figure_of(CARRIER.replace("</worldbody>", wing + "</worldbody>"))
    arm = np.zeros(figure.width, bool)
    for link in (2, 5):
        arm[figure.links[link].qpos : figure.links[link].qpos + 4] = True
    keys = []
    for time, is_free in ((0.0, True), (1.0, False), (2.0, True), (3.0, True), (4.0, True)):
        qpos = np.array(figure.model.qpos0)
        crate = figure.links[3].qpos
        qpos[crate : crate + 3] = [0, 0, 1.2]  # the arm's tip is in it
        keys.append(Frame(time, qpos, ~arm if is_free else np.ones(figure.width, bool)))
    timeline, points = raw_timeline(figure, keys), covering_points(figure)
    contact = Collision(tuple(p for p in points if p.link in (1, 2, 5)), surfaces_on(figure, 3), carrier=3)
    plain = contact.allowing(figure, timeline).allowed
    holding = contact.allowing(figure, timeline, [(2, 1.0, 3.0)]).allowed
    assert plain is not None
    assert holding is not None
    limb = np.array([point.link == 2 for point in contact.points])
    deep = plain.excess[limb, 1].max()
    assert deep > 0.05
    np.testing.assert_array_equal(plain.excess[limb].max(axis=0), [0, deep, 0, 0, 0])
    np.testing.assert_array_equal(holding.excess[limb].max(axis=0), [0, deep, deep, deep, 0])
    np.testing.assert_array_equal(plain.excess[~limb], holding.excess[~limb])
    assert plain.excess[[point.link == 5 for point in contact.points], 1].max() > 0.05


@pytest.mark.parametrize(("free", "spans"), [(None, {(0, 1), (1, 2)}), (0, {(1, 2)}), (1, set()), (2, {(0, 1)})])
def test_an_object_rests_between_two_keyframes_that_both_place_it(free, spans):
    figure = figure_of(CARRIER)
    others = np.ones(figure.width, bool)
    others[figure.links[3].columns] = False
    keys = [Frame(float(k), figure.model.qpos0, others if k == free else others | True) for k in range(3)]
    rests = resting_objects(KeyframePoints.of(figure, raw_timeline(figure, keys), (), (FLOOR,)), [3])
    assert {(rest.first, rest.last) for rest in rests} == spans
    assert len(rests) == 3 * len(spans)


G = 9.81


# of the size of an adult, with its centre of mass at the root, 1 m above the sole
HOPPER = """<mujoco><worldbody><body pos="0 0 1"><freejoint name="root"/><geom size=".1" pos="0 0 .5" mass="33"/>
  <geom size=".1" pos="0 0 -.5" mass="33"/>
  <body><joint name="leg" type="slide" axis="0 0 1"/><geom size=".05" pos="0 0 -.95" mass="1e-6"/></body>
</body></worldbody></mujoco>"""


FIGURE = figure_of(HOPPER)


SOLE = tuple(Point(name, 2, np.array([x, 0, -1.0])) for name, x in (("heel", -0.1), ("toe", 0.1)))


def hop(*poses: tuple[float, float, float], hold: tuple[float, float] | None = None) -> ContactSchedule:
    """Keyframes at a time, of a root height and with the leg drawn in by some length, while a hand may be held."""
    keys = raw_timeline(FIGURE, [Frame.key(t, [0, 0, z, 1, 0, 0, 0, drawn]) for t, z, drawn in poses])
    hand = Point("hand", 1, np.zeros(3))
    rests = (Contact.at(hand, *hold, np.zeros(3)),) if hold else ()
    return ContactSchedule(FIGURE, keys, SOLE, (FLOOR,), rests)


def crouch(t: float, z: float = 0.8) -> tuple[float, float, float]:
    return t, z, 1.0 - z


@pytest.mark.parametrize(("landing", "top"), [(0.9, 0.45), (1.1, 0.5), (0.8, 0.425)])
def test_a_free_fall_through_one_keyframe_has_its_top_halfway_to_the_middle_of_its_neighbours(landing, top):
    ((first, last),) = hop(crouch(0), (0.45, 1.45, 0.1), crouch(landing)).flights
    assert (first + last) / 2 == pytest.approx(top)
    height = 1.45 + G / 2 * (0.45 - top) ** 2
    assert last - first == pytest.approx(2 * np.sqrt(2 * (height - STRETCHED) / G))


@pytest.mark.parametrize("times", [(0.3, 0.6), (0.25, 0.4, 0.65), (0.2, 0.35, 0.5, 0.7)])
def test_keyframes_on_an_arc_are_in_one_free_fall_that_ends_where_a_stretched_leg_reaches_the_ground(times):
    speed, start = 3.0, 0.15  # at take-off
    arc = [(t, STRETCHED + speed * (t - start) - G * (t - start) ** 2 / 2, 0.3) for t in times]
    for wrong in (0.0, 0.05):  # what keyframes in between may miss
        poses = [(t, z + wrong * (0 < k < len(arc) - 1), drawn) for k, (t, z, drawn) in enumerate(arc)]
        schedule = hop(crouch(0), *poses, crouch(1.0))
        np.testing.assert_allclose(schedule.flights, [(start, start + 2 * speed / G)], atol=1e-9)


@pytest.mark.parametrize(
    ("poses", "misses"),
    [
        ((crouch(0.3), (0.45, 1.6, 0.1), crouch(0.6)), 1),  # too high for the time
        ((crouch(0.3), (0.45, 1.7, 0.1), crouch(0.7)), 1),  # likewise, between uneven neighbours
        ((crouch(0), (0.3, 1.3, 0.1), (0.5, 1.9, 0.1), (0.7, 1.3, 0.1), crouch(1)), 2),
    ],
)
def test_keyframes_that_no_free_fall_meets_are_named_with_the_height_that_would_do(poses, misses):
    schedule = hop(*poses)
    (fall,) = schedule.falls
    assert schedule.flights == () and fall.misses == misses
    half, mended = (
        [(t, z - share * fall.by * (k == misses), drawn) for k, (t, z, drawn) in enumerate(poses)] for share in (0.5, 1)
    )
    assert hop(*half).falls[0].by == pytest.approx(fall.by / 2)
    assert hop(*mended).flights or hop(*mended).falls == ()


def test_a_keyframe_on_the_ground_before_a_free_fall_has_ended_is_named():
    schedule = hop(crouch(0), (0.3, 1.6, 0.1), (0.5, 1.6, 0.1), crouch(0.55))
    (fall,) = schedule.falls
    assert schedule.flights == () and fall.misses == 3 and fall.by < 0


@pytest.mark.parametrize(
    "poses",
    [
        (crouch(0), crouch(0.5), crouch(1)),
        ((0, 1.0, 0.0), (0.5, 1.1, 0.3), (1, 1.0, 0.0)),  # a stretched leg would reach the ground
        ((0, 0.9, 0.1), (0.5, 1.3, -0.3), (1, 0.9, 0.1)),  # a long leg does
        ((0, 1.5, 0.3), (1.5, 1.5, 0.3)),  # on the ground in between
    ],
)
def test_a_figure_that_may_reach_the_ground_is_in_no_flight(poses):
    assert hop(*poses).flights == ()


def test_a_fall_begins_and_ends_with_the_clip_in_the_air():
    assert hop((0, 1.5, 0.3), (0.3, 1.5, 0.3)).flights == ((0, 0.3),)


def test_keyframes_in_the_air_from_which_an_adult_would_rise_by_more_than_60_cm_are_in_no_flight():
    longest = 2 * np.sqrt(2 * 0.6 * Size.of(FIGURE).length / G)
    for share, count in ((0.99, 1), (1.01, 0)):
        assert len(hop((0, 1.5, 0.3), (share * longest, 1.5, 0.3)).flights) == count


@pytest.mark.parametrize(("first", "last"), [(0.0, 0.35), (0.5, 0.8), (0.4, 0.5)])
def test_there_is_none_while_something_else_carries(first, last):
    leap = crouch(0), (0.45, 1.45, 0.1), crouch(0.9)
    assert len(hop(*leap).flights) == 1
    carried = hop(*leap, hold=(first, last)).flights
    assert all(end <= first or begin >= last for begin, end in carried)
    assert len(carried) == (not first < 0.45 < last)


LEGS = ", ".join(f'{side}_{part} = "free"' for side in ("left", "right") for part in ("hip", "knee", "ankle"))


ARMS = "left_shoulder = {rotvec = [15, 40, 0]}, right_shoulder = {rotvec = [-15, 40, 0]}"


TUCKED = ", ".join(
    f"{side}_{part} = {{rotvec = [0, {angle}, 0]}}"
    for side in ("left", "right")
    for part, angle in (("hip", -30), ("knee", 40), ("shoulder", -100))
)


def crouched(time: float, x: float) -> str:
    return f"""
[[keyframe]]
time = {time}
sites = {{left_heel = [{x}, 0.09, 0], right_heel = [{x}, -0.09, 0]}}
bodies = {{left_foot = {{flat = true}}, right_foot = {{flat = true}}}}
joints = {{{LEGS}, {ARMS}}}
root = {{position = [{x - 0.08}, 0, 0.72], rotation = {{rotvec = [0, 20, 0]}}}}
others = "rest"
"""


LEAP = f"""figure = "human"{crouched(0.0, 0.0)}
[[keyframe]]
time = 0.4
root = {{position = [0.35, 0, 1.3], rotation = {{rotvec = [0, 0, 0]}}}}
joints = {{{TUCKED}}}
others = "rest"
{crouched(0.8, 0.7)}"""


def test_a_person_who_is_keyed_in_crouches_and_at_the_top_leaps_in_free_fall():
    """Between take-off and landing the centre of mass falls as MuJoCo has it, and nothing is reported."""
    clip = load(LEAP)
    ((first, last),) = clip.context.schedule.flights
    motion, model = inbetween(clip), clip.figure.model
    t = np.linspace(first + 0.02, last - 0.02, 40)
    heights = [float(kinematics(model, motion.at(time)).subtree_com[0, 2]) for time in t]
    assert np.polyfit(t, heights, 2)[0] == pytest.approx(-G / 2, rel=0.03)
    assert not motion.violations
