"""What is carried: limbs and the thing keep out of each other, wherever it is and however it is turned."""

import numpy as np
import pytest
from figures import figure_of
from oracles import kinematics
from penalty_slope import penalty_slope
from random_samples import random_samples

from dynsplines.solver.contacts import ContactSchedule, Grasp, grasped_links, surfaces_on
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Contact
from dynsplines.solver.surface import moving_surface
from dynsplines.solver.surface.cover import covering_points
from dynsplines.solver.surface.points import Point

CARRIER = """<mujoco><compiler angle="degree"/><worldbody>
<body name="trunk"><freejoint/><geom name="trunk" size=".3"/>
  <body name="arm" pos="0 0 .2"><joint type="ball"/><geom name="arm" type="capsule" size=".1" fromto="0 0 0 0 0 .9"/>
  </body></body>
<body name="crate"><freejoint/>
  <geom name="crate" type="box" size=".5 .4 .3" pos=".1 0 0" euler="20 10 0"/>
  <geom name="knob" type="cylinder" size=".2 .3" pos=".1 .6 0" euler="90 0 0"/>
  <body name="lid" pos="0 0 .4"><joint type="hinge" axis="0 1 0"/><geom name="lid" type="box" size=".5 .4 .05"/></body>
</body></worldbody></mujoco>"""


def few(link: int) -> Contact:
    """Three spheres of arm and trunk instead of hundreds, one of them a point."""
    places = ((2, 0.9, 0.25), (2, 0.5, 0.0), (1, 0.1, 0.3))
    points = tuple(Point(f"{i}", i, np.array([0.05, 0, z]), radius) for i, z, radius in places)
    return Contact(points, surfaces_on(figure_of(CARRIER), link), carrier=link)


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
    assert grasped_links(figure, [Grasp(hand, 3, "crate", 0, 1)]) == (3, 4)
    assert grasped_links(figure, [Grasp(hand, 1, "trunk", 0, 1)]) == ()
    assert grasped_links(figure, [Grasp(Point("hook", 3, np.zeros(3)), 1, "trunk", 0, 1)]) == (1, 2)
    assert grasped_links(figure, [Grasp(hand, 3, "crate", 0, 1), Grasp(knee, 2, "arm", 0, 1)]) == (3, 4)
    assert [surface.name for surface in surfaces_on(figure, 3)] == ["crate", "knob"]
    schedule = ContactSchedule(
        figure,
        raw_timeline(figure, [Frame.key(t, figure.model.qpos0) for t in (0, 1)]),
        grasps=(Grasp(hand, 3, "crate", 0, 1),),
    )
    assert schedule.exclude_grasped([hand, knee, Point("lid", 4, np.zeros(3))]) == (hand, knee)
    assert {point.link for point in schedule.low_points} == {1, 2}


@pytest.mark.parametrize("link", [3, 4])
def test_the_gradient_has_taylor_slope_two_with_few_spheres(link, rng):
    samples = tangled(figure_of(CARRIER), rng)
    assert np.count_nonzero(few(link).evaluate(samples)) > 2
    assert penalty_slope(few(link), samples, rng) > 1.9


def test_what_is_deep_is_as_deep_as_in_what_stands_still_there(rng):
    """MuJoCo puts every pose's crate into the world, as a surface of its own."""
    figure = figure_of(CARRIER)
    model, samples, contact = figure.model, tangled(figure, rng), few(3)
    found, own = contact.evaluate(samples), [model.geom(name).id for name in ("crate", "knob")]
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data = kinematics(model, qpos)
        still = [moving_surface(model, g, data.geom_xpos[g], data.geom_xmat[g].reshape(3, 3)) for g in own]
        expected = Contact(contact.points, tuple(s for s in still if s is not None)).evaluate(
            samples.select(np.array([i]))
        )
        np.testing.assert_allclose(found[i], expected[0], rtol=1e-6, atol=1e-12)
    assert np.count_nonzero(found) > 3


@pytest.mark.parametrize("link", [3, 4])
def test_the_rows_of_its_sides_are_its_gradient(link, rng):
    figure = figure_of(CARRIER)
    samples, contact = tangled(figure, rng), few(link)
    sides = contact.one_sided_residuals(samples)
    assert sides is not None
    deep = sides.value > 0
    cotangent = Cotangent(samples)
    np.testing.assert_allclose(
        np.bincount(sides.at[deep], sides.value[deep] ** 2, samples.count),
        contact.evaluate(samples, cotangent, 1.0),
        rtol=1e-9,
    )
    expected = np.zeros(samples.y.shape)
    np.add.at(expected, sides.at[deep], 2 * sides.value[deep, None] * sides.rows[deep])
    np.testing.assert_allclose(expected, cotangent.gradients()[0], rtol=1e-8, atol=1e-9)


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
    contact = Contact(tuple(p for p in points if p.link in (1, 2, 5)), surfaces_on(figure, 3), carrier=3)
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
