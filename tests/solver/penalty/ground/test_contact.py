"""The contact penalty: which points it makes of a body, its values by hand, its gradient, both sides of the surface."""

import mujoco
import numpy as np
import pytest
from figures import LEG
from ground import FLOOR, SLOPE, some_points
from penalty_slope import penalty_slope
from random_keys import random_keys
from random_samples import random_samples

from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Contact, block
from dynsplines.solver.penalty.ground.contact import neighbours
from dynsplines.solver.surface import Box, static_surfaces
from dynsplines.solver.surface.points import Point, body_points, site_points

BLOCK = Box("block", np.array([0.1, -0.2, 0.0]), np.eye(3), np.array([2.0, 1.5, 1.0]), buried=False)
STEP = Box("step", np.array([0.0, 0, -0.5]), np.eye(3), np.array([2.0, 2.5, 1.0]), buried=True)


@pytest.mark.parametrize(
    "surfaces", [(FLOOR,), (SLOPE,), (BLOCK,), (STEP,), (FLOOR, BLOCK)], ids=lambda each: "+".join(s.name for s in each)
)
def test_the_gradient_has_taylor_slope_two(figure, rng, surfaces):
    samples = random_samples(figure, rng, 8)
    samples.y[:, 2] = -0.3
    contact = Contact(some_points(figure, rng), surfaces, margin=0.02)
    assert np.count_nonzero(contact.evaluate(samples)) >= 4
    assert penalty_slope(contact, samples, rng) > 1.9


def test_it_is_the_sum_of_squared_depths_of_points_placed_by_mujoco(figure, rng):
    samples = random_samples(figure, rng, 8)
    samples.y[:, 2] = 0
    points = some_points(figure, rng)
    data, expected = mujoco.MjData(figure.model), []
    ends = {link.body: i for i, link in enumerate(figure.links) if i and figure.body_link[link.body] == i}
    points = tuple(p for p in points if p.link in ends.values())
    for qpos in figure.to_qpos(samples.y):
        data.qpos[:] = qpos
        mujoco.mj_kinematics(figure.model, data)
        total = 0.0
        for body, link in ends.items():
            for point in (p for p in points if p.link == link):
                height = (data.xpos[body] + data.xmat[body].reshape(3, 3) @ point.position)[2]
                total += max(point.radius + 0.05 - height, 0) ** 2
        expected.append(total)
    np.testing.assert_allclose(Contact(points, (FLOOR,), margin=0.05).evaluate(samples), expected, rtol=1e-10)
    assert np.count_nonzero(expected) > 4


def test_without_points_or_surfaces_there_is_nothing_to_let_pass(figure, rng):
    keys = raw_timeline(figure, random_keys(figure, rng))
    for nothing in (Contact((), (FLOOR,)), Contact(some_points(figure, rng), ()), Contact((), ())):
        assert nothing.allowing(figure, keys) is nothing
        assert not nothing.evaluate(random_samples(figure, rng)).any()


def test_surfaces_and_points_add_up_one_by_one(figure, rng):
    samples = random_samples(figure, rng, 8)
    samples.y[:, 2] = 0
    points = some_points(figure, rng)
    every = Contact(points, (FLOOR, BLOCK, STEP)).evaluate(samples)
    single = sum(Contact((p,), (s,)).evaluate(samples) for p in points for s in (FLOOR, BLOCK, STEP))
    np.testing.assert_allclose(every, single, rtol=1e-12)


@pytest.mark.parametrize("carrier", [0, 1])
def test_by_way_of_their_links_motions_the_rows_of_many_points_are_what_they_are_one_by_one(
    carrier, figure, rng, monkeypatch
):
    """A cloud in the floor, or in a slope that the first link carries: the same residuals, rows and pull-back."""
    samples = random_samples(figure, rng, 4)
    samples.y[:, 2] = 0
    links = range(1 + carrier, len(figure.links))
    points = tuple(Point("cloud", i, 0.3 * rng.normal(size=3), 0.1) for i in links for _ in range(30))
    contact, found = Contact(points, (FLOOR, SLOPE), carrier=carrier), []
    if not points:
        pytest.skip("nothing beside what carries the surfaces")
    for many in (1000, 0):
        monkeypatch.setattr(block, "MANY", many)
        sides = contact.one_sided_residuals(samples)
        assert sides is not None
        found.append(sides)
    one_by_one, by_motion = found
    assert all(rows.is_plain for rows in one_by_one.gradients)
    assert not any(rows.is_plain for rows in by_motion.gradients)
    np.testing.assert_array_equal(by_motion.at, one_by_one.at)
    np.testing.assert_array_equal(by_motion.value, one_by_one.value)
    np.testing.assert_allclose(by_motion.rows, one_by_one.rows, atol=1e-9)


@pytest.mark.parametrize(("count", "is_plain"), [(12, True), (13, False)])
def test_a_links_motion_is_worth_its_six_rows_from_more_than_twice_as_many_points(count, is_plain, rng):
    figure = Figure(mujoco.MjModel.from_xml_string(LEG))
    samples = random_samples(figure, rng, 3)
    samples.y[:, 2] = -9
    points = tuple(Point("cloud", 1, 0.1 * rng.normal(size=3)) for _ in range(count))
    sides = Contact(points, (FLOOR,)).one_sided_residuals(samples)
    assert sides is not None
    assert sides.at.size == 3 * count
    assert [rows.is_plain for rows in sides.gradients] == [is_plain]


def test_points_that_one_sphere_stands_for_are_64_at_most_neighbours_across_where_they_spread_farthest(rng):
    places = rng.normal(size=(3, 200)) * np.array([[1.0], [5.0], [0.2]])
    some = np.sort(rng.permutation(200)[:150])
    found = neighbours(places, some)
    assert [part.size for part in found] == [37, 38, 37, 38]
    np.testing.assert_array_equal(np.sort(np.concatenate(found)), some)
    low, high = np.concatenate(found[:2]), np.concatenate(found[2:])
    assert places[1, low].max() < places[1, high].min()
    assert [part.size for part in neighbours(places, some[:64])] == [64]
    assert [part.size for part in neighbours(places, some[:65])] == [32, 33]
    level = np.zeros((3, 70))
    assert [part.tolist() for part in neighbours(level, np.arange(70))] == [list(range(35)), list(range(35, 70))]


@pytest.mark.parametrize("surface", [FLOOR, BLOCK, STEP], ids=lambda s: s.name)
def test_a_figure_outside_costs_exactly_nothing_and_has_no_gradient(figure, rng, surface):
    samples = random_samples(figure, rng)
    samples.y[:, 2] = 50
    points = tuple(p for p in some_points(figure, rng) if figure.tables.path[p.link, 1])
    cotangent = Cotangent(samples)
    assert not Contact(points, (surface,)).evaluate(samples, cotangent).any()
    assert not any(g.any() for g in cotangent.gradients())


def test_no_points_or_no_surfaces_cost_nothing(figure, rng):
    samples = random_samples(figure, rng)
    assert not Contact((), (FLOOR,)).evaluate(samples, Cotangent(samples)).any()
    assert not Contact(some_points(figure, rng), ()).evaluate(samples, Cotangent(samples)).any()


def test_the_value_and_the_gradient_grow_smoothly_from_zero_at_the_surface():
    figure = Figure(mujoco.MjModel.from_xml_string(LEG))
    contact = Contact((Point("p", 1, np.zeros(3), 0.1),), (FLOOR,))
    y = np.tile(figure.to_state(figure.model.qpos0), (4, 1))
    y[:, 2] = 0.1 + np.array([1e-6, 0, -1e-6, -1e-3])
    samples = Samples(figure, y, 0 * y, 0 * y)
    cotangent = Cotangent(samples)
    np.testing.assert_allclose(contact.evaluate(samples, cotangent), [0, 0, 1e-12, 1e-6], rtol=1e-6)
    np.testing.assert_allclose(cotangent.gradients()[0][:, 2], [0, 0, -2e-6, -2e-3], rtol=1e-6)


def test_site_points_are_where_mujoco_has_the_sites(rng):
    figure = Figure(mujoco.MjModel.from_xml_string(LEG))
    points = site_points(figure, ["heel", "toe"])
    samples = random_samples(figure, rng, 3)
    centres, _, links = Contact(points, (FLOOR,)).centres(samples)
    data = mujoco.MjData(figure.model)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data.qpos[:] = qpos
        mujoco.mj_kinematics(figure.model, data)
        for n, name in enumerate(["heel", "toe"]):
            np.testing.assert_allclose(centres[:, n, i], data.site(name).xpos, atol=1e-12)
    assert links.tolist() == [1, 2]
    with pytest.raises(KeyError, match=r"heel.*toe"):
        site_points(figure, ["knee"])


def test_body_points_cover_spheres_capsules_and_boxes_exactly_over_a_plane(rng):
    model = mujoco.MjModel.from_xml_string(
        LEG.replace('<geom type="ellipsoid" size=".1 .2 .3"/>', "").replace('<geom type="cylinder" size=".1 .3"/>', "")
    )
    figure = Figure(model)
    samples = random_samples(figure, rng, 6)
    points = body_points(figure)
    centres, _, _ = Contact(points, (FLOOR,)).centres(samples)
    lowest = (centres[2] - np.array([p.radius for p in points])[:, None]).min(axis=0)
    data = mujoco.MjData(model)
    for i, qpos in enumerate(figure.to_qpos(samples.y)):
        data.qpos[:] = qpos
        mujoco.mj_kinematics(model, data)
        exact = []
        for g in range(model.ngeom):
            up, size = data.geom_xmat[g].reshape(3, 3)[2], model.geom_size[g]
            drop = {
                mujoco.mjtGeom.mjGEOM_CAPSULE: size[0] + abs(up[2]) * size[1],
                mujoco.mjtGeom.mjGEOM_SPHERE: size[0],
                mujoco.mjtGeom.mjGEOM_BOX: np.abs(up) @ size,
            }
            exact.append(data.geom_xpos[g][2] - drop[mujoco.mjtGeom(int(model.geom_type[g]))])
        np.testing.assert_allclose(lowest[i], min(exact), atol=1e-12)


def test_body_points_stay_inside_cylinders_and_ellipsoids_and_leave_out_what_never_moves(rng):
    figure = Figure(mujoco.MjModel.from_xml_string(LEG.replace("<body", '<geom size=".3"/><body', 1)))
    points = body_points(figure)
    assert {p.link for p in points} == {1, 2}
    cylinder = [p for p in points if p.name == "shin 3"]
    assert len(cylinder) == 16
    np.testing.assert_allclose([np.hypot(*p.position[:2]) for p in cylinder], 0.1)
    ellipsoid = [p for p in points if p.name == "shin 2"]
    for p in ellipsoid:
        out = p.position * (1 + p.radius / max(np.linalg.norm(p.position), 1e-9))
        np.testing.assert_array_less(np.sum((out / [0.1, 0.2, 0.3]) ** 2), 1 + 1e-9)


@pytest.mark.parametrize("size", [(0.1, 0.2, 0.3), (0.3, 0.1, 0.1), (0.2, 0.2, 0.2)])
def test_body_points_of_an_ellipsoid_on_any_of_its_tips_are_as_high_over_a_plane_as_mujoco_has_it(size):
    text = " ".join(map(str, size))
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><geom name="floor" type="plane" size="1 1 1"/><body pos="0 0 1"><freejoint/>'
        f'<geom name="egg" type="ellipsoid" size="{text}"/></body></worldbody></mujoco>'
    )
    figure, data, turn = Figure(model), mujoco.MjData(model), np.sqrt(0.5)
    points = body_points(figure)
    radii = np.array([point.radius for point in points])
    for rotation in ([1, 0, 0, 0], [0, 1, 0, 0], [turn, turn, 0, 0], [turn, -turn, 0, 0], [turn, 0, turn, 0]):
        data.qpos[:] = [0, 0, 1, *rotation]
        mujoco.mj_kinematics(model, data)
        height = mujoco.mj_geomDistance(model, data, 0, 1, 10.0, None)
        state = figure.to_state(data.qpos[None])
        centres, _, _ = Contact(points, (FLOOR,)).centres(Samples(figure, state, 0 * state, 0 * state))
        assert (centres[2, :, 0] - radii).min() == pytest.approx(height, abs=1e-9)


def test_a_capsule_across_the_edge_of_a_box_is_noticed():
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><freejoint/><geom type="capsule" size=".024" fromto="-.2 0 0 .2 0 0"/></body>'
        '<geom name="beam" type="box" size=".01 .5 .1" pos="0 0 .1"/></worldbody></mujoco>'
    )
    figure = Figure(model)
    contact = Contact(body_points(figure), static_surfaces(model))
    for shift in np.linspace(-0.05, 0.05, 11):
        state = np.array([[shift, 0, 0.2 + 0.024 - 0.004, 1, 0, 0, 0]])
        assert contact.evaluate(Samples(figure, state, 0 * state, 0 * state))[0] > 0
