"""Loops that do not close, and travel that makes no sense: refused, and told where and by how much."""

from __future__ import annotations

import numpy as np
import pytest
from figures import BALL, TINY, figure_of
from hopping_loop import PERIOD, hop
from scipy.spatial.transform import Rotation

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, TimelineError
from dynsplines.solver.curve.loop_keys import SAME, close_loop
from dynsplines.solver.curve.unknowns import raw_timeline


def refused(words: str, change: Array | None = None, travel: list[float] | None = None, ends: str = "periodic") -> None:
    figure = figure_of(TINY)
    keys = hop()
    keys[-1] = Frame.key(PERIOD, keys[-1].state + (0 if change is None else change))
    with pytest.raises(TimelineError, match=words):
        raw_timeline(figure, keys, ends, travel=travel)


def test_a_loop_that_does_not_close_reports_where_and_by_how_much():
    one = np.eye(11)
    refused(
        r"\(t = 0\.8 s\) differs from the first at 'root' along z \(with travel = \[0\.6, 0, 0\]\) by 0\.02",
        0.02 * one[2],
    )
    refused(r"at 'root' along x \(with travel = \[0\.5, 0, 0\]\) by 0\.1", travel=[0.5, 0, 0])
    refused(r"at 'root' \(a loop may travel, and turn about the vertical\) by", 0.1 * one[4])
    refused(r"at 'knee' by", 0.1 * one[9])


def test_travel_that_makes_no_sense_is_refused():
    refused("travel is for ends = 'periodic', not 'free'", travel=[1, 0, 0], ends="free")
    refused("three finite numbers", travel=[1, 0])
    refused("three finite numbers", travel=[1, 0, np.nan])
    ball = figure_of('<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>')
    keys = [Frame.key(t, [1, 0, 0, 0]) for t in (0, 1)]
    with pytest.raises(TimelineError, match="no free joint, so no root to travel"):
        raw_timeline(ball, keys, "periodic", travel=[1, 0, 0])


WAYS = [(way, turn) for way in ("both", "first", "last", "apart") for turn in (0.0, 0.7, -2.5)]


@pytest.mark.parametrize(("way", "turn"), WAYS)
def test_what_either_end_of_a_loop_fixes_is_where_it_was_there_and_a_travel_and_a_turn_on_at_the_other(way, turn, rng):
    """Of the root's place and turn, whichever keyframe says them; by SciPy's rotations."""
    figure, travel = figure_of(TINY), np.array([0.6, -0.2, 0.1])
    root, knee = (np.isin(np.arange(11), columns) for columns in (range(7), range(7, 11)))
    height = np.arange(11) == 2
    masks = {
        "both": (root | knee, root | knee),
        "first": (root | knee, height & False),
        "last": (height & False, root | knee),
        "apart": ((root & ~height), (height | knee)),
    }[way]
    about = Rotation.from_rotvec([0, 0, turn])
    given = np.concatenate(
        [rng.normal(size=3), Rotation.random(None, np.random.default_rng(1)).as_quat(scalar_first=True), [1, 0, 0, 0]]
    )
    end = np.array(given)
    end[:3] += travel
    turned = about * Rotation.from_quat(given[3:7], scalar_first=True)
    end[3:7] = turned.as_quat(scalar_first=True)
    anywhere = np.array([9, 9, 9, *np.full(8, 0.5)])  # in what neither says nothing may be read
    keys = [
        Frame.key(0.0, np.where(masks[0], given, anywhere), masks[0]),
        Frame.key(0.5, given),
        Frame.key(1.0, np.where(masks[1], end, anywhere), masks[1]),
    ]
    ends, seam = close_loop(figure, keys, travel, turn)
    begun, ended = ends[0].state, ends[-1].state
    np.testing.assert_allclose(begun[:3], given[:3], atol=1e-12)
    np.testing.assert_allclose(ended[:3], end[:3], atol=1e-12)
    if way in ("both", "first"):
        np.testing.assert_array_equal(begun[:3], given[:3])
    for found, expected in ((begun, given), (ended, end)):
        np.testing.assert_allclose(abs(found[3:7] @ expected[3:7]), 1, atol=1e-12)
        np.testing.assert_allclose(abs(found[7:] @ expected[7:]), 1, atol=1e-12)
    for frame in (ends[0], ends[-1]):
        np.testing.assert_array_equal(frame.fixed, masks[0] | masks[1])
    np.testing.assert_allclose(seam.headings, [turn], atol=1e-12)
    assert ends[1] is keys[1]


def test_a_loop_goes_as_far_over_the_ground_as_its_keyframes_specify_and_neither_rises_nor_moves_other_bodies():
    two = BALL.replace("</worldbody>", '<body name="cup"><freejoint name="cup"/><geom size=".1"/></body></worldbody>')
    figure = figure_of(two)
    first = np.array([0, 0, 1, 1, 0, 0, 0, 2, 2, 2, 1, 0, 0, 0.0])
    last = first + np.array([0.5, -0.25, *np.zeros(12)])
    ends, seam = close_loop(figure, [Frame.key(0, first), Frame.key(1, last)], None, None)
    np.testing.assert_allclose(ends[1].state - ends[0].state, last - first, atol=1e-15)
    np.testing.assert_allclose(seam.shift, last - first, atol=1e-15)
    hair = first + 1e-10 * np.eye(14)[0]
    _, still = close_loop(figure, [Frame.key(0, first), Frame.key(1, hair)], None, None)
    assert not still.shift.any()
    for column, words in ((9, "'cup' along z"), (7, "'cup' along x"), (2, "along z")):
        with pytest.raises(TimelineError, match=words):
            close_loop(figure, [Frame.key(0, first), Frame.key(1, first + 0.1 * np.eye(14)[column])], None, None)


@pytest.mark.parametrize("given", [None, [0.5, -0.25, 0]])
def test_what_a_root_carries_travels_with_it(given):
    two = BALL.replace("</worldbody>", '<body name="cup"><freejoint name="cup"/><geom size=".1"/></body></worldbody>')
    figure = figure_of(two)
    first = np.array([0, 0, 1, 1, 0, 0, 0, 2, 2, 2, 1, 0, 0, 0.0])
    travel = np.array([0.5, -0.25, 0, 0, 0, 0, 0, 0.5, -0.25, 0, 0, 0, 0, 0])
    ends, seam = close_loop(figure, [Frame.key(0, first), Frame.key(1, first + travel)], given, None)
    np.testing.assert_allclose(ends[1].state - ends[0].state, travel, atol=1e-15)
    np.testing.assert_allclose(seam.moved(first, 3), first + 3 * travel, atol=1e-15)
    with pytest.raises(TimelineError, match=r"'cup' along x \(with travel = \[0.5, -0.25, 0\]\) by 0.001"):
        close_loop(figure, [Frame.key(0, first), Frame.key(1, first + travel + 1e-3 * np.eye(14)[7])], given, None)


def test_a_turn_of_next_to_nothing_is_none_and_one_of_more_than_half_a_round_is_the_shorter_one_back():
    figure = figure_of(BALL)
    pose, none = np.array([1.0, 0, 1, 1, 0, 0, 0]), np.zeros(7, bool)
    for given, found in ((1e-10, 0.0), (2 * np.pi + 1e-10, 0.0), (4.0, 4.0 - 2 * np.pi), (-3.0, -3.0)):
        keys = [Frame.key(0, pose), Frame.key(1, pose, none)]
        _, seam = close_loop(figure, keys, [0, 0, 0], given)
        np.testing.assert_allclose(seam.headings, [found], atol=1e-12)
        assert seam.turns == (found != 0)


def test_ends_of_a_loop_may_differ_by_what_rounding_does_and_by_no_more():
    figure, pose = figure_of(BALL), np.array([0.0, 0, 0, 1, 0, 0, 0])
    for z, agree in ((SAME, True), (-SAME, True), (np.nextafter(SAME, 1), False)):
        keys = [Frame.key(0, pose), Frame.key(1, pose + z * np.eye(7)[2])]
        if agree:
            np.testing.assert_array_equal(close_loop(figure, keys, None, None)[0][1].state, pose)
        else:
            with pytest.raises(TimelineError, match="along z"):
                close_loop(figure, keys, None, None)
