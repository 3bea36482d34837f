"""Planted points: which keyframes plant one, where it should be in between, the value by hand and the gradient."""

import itertools

import mujoco
import numpy as np
import pytest
from figures import BALL, figure_of
from ground import stance_of
from random_samples import at_times, random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts import Stance, resting_objects, stances
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import Attachment
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point

FLOOR = Plane("floor", np.zeros(3), np.array([0.0, 0, 1]))
FOOT = Point("foot", 1, np.array([0.0, 0, -0.5]), 0.1)


def test_it_is_the_squared_distance_from_the_drifting_spot_while_the_stance_lasts(figure, rng):
    t = np.array([0.0, 0.49, 0.5, 0.75, 1.0, 1.01])
    samples = at_times(random_samples(figure, rng, 6), t)
    stance = stance_of(1, 0.5, 1.0)
    offset = np.einsum("ijs,j->is", samples.links.rotation[:, :, 1], stance.point.position)
    away = samples.links.x[:, 1] + offset - np.array([0.1, 0.2, 0])[:, None]
    away -= np.array([0.03, 0, 0.01])[:, None] * (t - 0.5) / 0.5
    expected = np.where((t >= 0.5) & (t <= 1.0), np.sum(away**2, axis=0), 0)
    np.testing.assert_allclose(Attachment((stance,)).evaluate(samples), expected, rtol=1e-12)
    assert np.count_nonzero(expected) == 3


def found(places: list[tuple[float, float]]) -> tuple[Stance, ...]:
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


def test_no_points_or_no_surfaces_plant_nothing(figure, rng):
    keys = [Frame.key(float(i), figure.to_qpos(figure.to_state(rng.normal(size=figure.width)))) for i in range(2)]
    timeline = raw_timeline(figure, keys)
    assert stances(KeyframePoints.of(figure, timeline, (), (FLOOR,))) == ()
    assert stances(KeyframePoints.of(figure, timeline, (FOOT,))) == ()


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


def test_of_several_things_those_lie_still_that_do_not_move_whatever_the_others_do():
    names = ("first", "second", "third")
    bodies = "".join(f'<body name="{name}"><freejoint name="{name}"/><geom size=".1"/></body>' for name in names)
    figure = figure_of(f"<mujoco><worldbody>{bodies}</worldbody></mujoco>")
    for still in itertools.product([False, True], repeat=3):
        poses = np.tile([0.0, 0, 1, 1, 0, 0, 0], (2, 3, 1))
        poses[1, ~np.array(still), 0] += 0.3
        keys = raw_timeline(figure, [Frame.key(float(i), pose.ravel()) for i, pose in enumerate(poses)])
        found = resting_objects(KeyframePoints.of(figure, keys, ()), [1, 2, 3])
        assert [stance.point.name for stance in found] == [
            name for name, lies in zip(names, still, strict=True) for _ in range(3 * lies)
        ]


def test_a_thing_lies_still_between_keyframes_that_both_say_the_same_of_it():
    figure = figure_of(BOX)
    here, there = [0.0, 0, 0.3], [0.01, 0, 0.3]
    found = resting_objects(
        KeyframePoints.of(figure, box_keys(figure, [here, here, there, there], [True] * 4), ()), [1]
    )
    assert [(stance.first, stance.last) for stance in found] == [(0.0, 1.0)] * 3 + [(2.0, 3.0)] * 3
    np.testing.assert_allclose([stance.landed for stance in found], [stance.spot for stance in found], atol=1e-12)
    for told in ([True, False], [False, True], [False, False]):
        assert resting_objects(KeyframePoints.of(figure, box_keys(figure, [here, here], told), ()), [1]) == ()
    assert resting_objects(KeyframePoints.of(figure, box_keys(figure, [here, here], [True, True]), ()), []) == ()
