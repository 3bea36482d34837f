"""Seams of loops, and the signs and turns of quaternions."""

import itertools

import numpy as np
import pytest
from figures import BALL, ONE_BALL, TINY, figure_of
from gradients import SMOOTH, assert_dense, smooth_problem
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from oracles import aligned, by_scipy
from problems import (
    CENTRE,
    HOP_TERMS,
    PERIOD,
    STRIDE,
    TURN,
    UP,
    assert_exact_gradient,
    assert_splits_keep_the_curve,
    hop,
    loop,
    pose,
    turned,
)
from random_models import TIMES, closed, distance_from_key, evenly, mask_without, partial_keys
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.raw import NEARLY_HALF, raw_timeline, signs, straighten
from dynsplines.solver.curve.seam import Seam, close_loop
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import Unknowns
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.problem import Problem, Settings

WAYS = ["straight", "spinning", "circle"]
FIXED_BALL = '<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>'


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("partial", [False, True])
@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_a_loop_is_smooth_across_its_seam_for_every_x(rng, coordinates, partial, way):
    """Not by the seam's formulas: velocities in the world turn with the figure."""
    figure = figure_of(TINY, coordinates)
    timeline = evenly(loop(figure, way, partial=partial), 1)
    unknowns = Unknowns.of(figure, timeline)
    np.testing.assert_allclose(unknowns.rows(unknowns.start), timeline.rows, atol=1e-11)
    angle, sign = (way == "circle") * TURN, -1 if way == "spinning" else 1
    turn = quat.from_rotation_vector(angle * UP)
    travel = CENTRE - quat.rotate(turn, CENTRE) if way == "circle" else [STRIDE, 0, 0]
    for x in (unknowns.start, unknowns.start + 0.1 * rng.normal(size=unknowns.size)):
        moved = timeline.with_rows(unknowns.rows(x))
        path, seam = path_of(moved), Seam.of(figure, moved)
        np.testing.assert_allclose(seam.headings, angle, atol=1e-12)
        assert seam.discontinuity(path).max() < 1e-9
        for order in range(3):
            start, end = path.at([0.0, PERIOD], order)
            place = quat.rotate(turn, start[:3]) + (0 if order else travel)
            knee = sign * quat.product(turn, start[7:]) if coordinates == "world" else start[7:]
            expected = np.concatenate([place, sign * quat.product(turn, start[3:7]), knee])
            np.testing.assert_allclose(end, expected, atol=1e-9)


@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_the_gradient_and_the_step_through_a_turning_seam_are_exact(rng, coordinates):
    figure = figure_of(TINY, coordinates)
    raw = loop(figure, "circle", partial=True)
    assert_exact_gradient(raw, figure, rng)
    assert_splits_keep_the_curve(raw)
    problem, x = smooth_problem(raw, figure, rng)
    assert_dense(problem, SMOOTH, x, rtol=1e-3)


@pytest.mark.slow
def test_a_turning_loop_is_the_middle_of_the_same_motion_round_many_periods():
    figure = figure_of(TINY)
    settings = Settings(variable=2, frames=0, tolerance=1e-12, renormalise=False)
    found = inbetween(Problem(figure, hop(way="circle"), HOP_TERMS, settings, ends="periodic"))
    t = np.linspace(0, PERIOD, 40)
    for periods, error in ((3, 5e-3), (5, 2.5e-4)):  # the influence of the ends fades
        middle = periods // 2
        run = inbetween(Problem(figure, hop(periods, "circle"), HOP_TERMS, settings)).at(t + PERIOD * middle)
        wanted = np.array([turned(qpos, TURN * middle) for qpos in found.at(t)])
        assert np.abs(aligned(figure, run, wanted) - wanted).max() < error


@pytest.mark.parametrize("turn", [0.0, 0.9])
def test_a_period_is_one_by_default_and_takes_what_hangs_from_the_root_with_it(turn, rng):
    figure = figure_of(TINY, "world")
    first = figure.to_state(pose(0.0))
    about = quat.from_rotation_vector(np.array([0, 0, turn]))
    last = np.array(first)
    last[:3] = quat.rotate(about, first[:3]) + np.array([0.5, -0.1, 0])
    last[3:7], last[7:] = quat.product(about, first[3:7]), quat.product(about, first[7:])
    seam = Seam.between(figure, first, last)
    np.testing.assert_allclose(seam.move(first), last, atol=1e-12)
    np.testing.assert_allclose(seam.turn(), about, atol=1e-12)
    np.testing.assert_allclose(seam.turn(-1), quat.inverse(about), atol=1e-12)
    states = rng.normal(size=(4, figure.width))
    np.testing.assert_allclose(states @ seam.matrix().T, seam.linear(states), atol=1e-12)
    np.testing.assert_allclose(seam.linear(seam.linear(states)), seam.linear(states, 2), atol=1e-12)
    points = rng.normal(size=(4, 3))
    expected = quat.rotate(about, points) + np.array([0.5, -0.1, 0])
    np.testing.assert_allclose(seam.moved_points(figure, points), expected, atol=1e-12)
    back = seam.moved_points(figure, expected, -1)
    np.testing.assert_allclose(back, points, atol=1e-12)


def ending(change: Array) -> list[Frame]:
    keys = hop()
    return [*keys[:-1], Frame.key(PERIOD, keys[-1].state + change)]


def loose() -> list[Frame]:
    """Keyframes round a circle whose ends leave y free."""
    mask = mask_without(figure_of(TINY), "root y")
    return [Frame.key(key.time, key.state, mask if key.time in (0, PERIOD) else None) for key in hop(way="circle")]


CUP = BALL.replace("</worldbody>", '<body name="cup"><freejoint name="cup"/><geom size=".1"/></body></worldbody>')
AT_CUP = np.array([0, 0, 1, 1, 0, 0, 0, 2, 2, 2, 1, 0, 0, 0.0])
ONE = np.eye(11)
AT_REST = [Frame.key(t, [1.0, 0, 0, 0]) for t in (0.0, 1.0)]


@pytest.mark.parametrize(
    ("keys", "given", "words"),
    [
        (ending(0.02 * ONE[2]), {}, r"\(t = 0\.8 s\) .* 'root' along z \(with travel = \[0\.6, 0, 0\]\) by 0\.02"),
        (hop(), {"travel": [0.5, 0, 0]}, r"at 'root' along x \(with travel = \[0\.5, 0, 0\]\) by 0\.1"),
        (ending(0.1 * ONE[4]), {}, r"at 'root' \(a loop may travel, and turn about the vertical\) by"),
        (ending(ONE[4] - ONE[3]), {}, r"at 'root' \(a loop may travel, and turn about the vertical\) by 1;"),
        (ending(0.1 * ONE[9]), {}, "at 'knee' by"),
        (hop(way="circle"), {"turn": np.radians(40)}, "turn about the vertical, here by 40 degrees"),
        (loose(), {}, "a loop that turns needs x and y of 'root' in its first or its last"),
        (hop(), {"travel": [1, 0, 0], "ends": "free"}, "travel is for ends = 'periodic', not 'free'"),
        (hop(), {"turn": TURN, "ends": "free"}, "turn is for ends = 'periodic', not 'free'"),
        (hop(), {"travel": [1, 0]}, "three finite numbers"),
        (hop(), {"travel": [1, 0, np.nan]}, "three finite numbers"),
        (AT_REST, {"travel": [1, 0, 0]}, "no free joint, so no root to travel"),
        (AT_REST, {"turn": TURN}, "no free joint, so no root to turn"),
    ],
)
def test_a_loop_that_does_not_close_is_refused_with_the_place_and_the_difference(keys, given, words):
    with pytest.raises(TimelineError, match=words):
        raw_timeline(figure_of(FIXED_BALL if keys is AT_REST else TINY), keys, given.pop("ends", "periodic"), **given)


@pytest.mark.parametrize("way", ["both", "first", "last", "apart"])
@pytest.mark.parametrize("turn", [0.0, 0.7, -2.5, 4.0])
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
    np.testing.assert_allclose(seam.headings, [(turn + np.pi) % (2 * np.pi) - np.pi], atol=1e-12)
    assert ends[1] is keys[1]


def test_a_given_turn_is_that_of_the_first_of_several_roots():
    last = np.array(AT_CUP)
    last[3:7] = quat.product(quat.from_rotation_vector([0, 0, 0.5]), AT_CUP[3:7])
    _, seam = close_loop(figure_of(CUP), [Frame.key(0.0, AT_CUP), Frame.key(1.0, last)], None, 0.5)
    np.testing.assert_allclose(seam.headings, [0.5, 0], atol=1e-12)


def test_a_loop_goes_as_far_over_the_ground_as_its_keyframes_specify_and_neither_rises_nor_moves_other_bodies():
    figure, first = figure_of(CUP), AT_CUP
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
    figure, first = figure_of(CUP), AT_CUP
    travel = np.array([0.5, -0.25, 0, 0, 0, 0, 0, 0.5, -0.25, 0, 0, 0, 0, 0])
    ends, seam = close_loop(figure, [Frame.key(0, first), Frame.key(1, first + travel)], given, None)
    np.testing.assert_allclose(ends[1].state - ends[0].state, travel, atol=1e-15)
    np.testing.assert_allclose(seam.move(first, 3), first + 3 * travel, atol=1e-15)
    with pytest.raises(TimelineError, match=r"'cup' along x \(with travel = \[0.5, -0.25, 0\]\) by 0.001"):
        close_loop(figure, [Frame.key(0, first), Frame.key(1, first + travel + 1e-3 * np.eye(14)[7])], given, None)


def turned_by(angles: list[float], axis: tuple[float, float, float] = (0, 0, 1)) -> np.ndarray:
    """(K, 4) a body turned to these angles [degrees] about an axis, all on one half of the quaternions."""
    q = quat.from_rotation_vector(np.radians(angles)[:, None] * np.array(axis))
    return q * np.where(q[:, :1] < 0, -1, 1)


def arcs(track: np.ndarray) -> np.ndarray:
    """The arcs [degrees] that a track of quaternions with signs turns by, up to 360."""
    return np.degrees(2 * np.arccos(np.clip(np.sum(track[1:] * track[:-1], axis=1), -1, 1)))


def wound(angles: list[float], *, spins: bool) -> np.ndarray:
    track = turned_by(angles)
    return arcs(track * signs(np.arange(len(angles), dtype=float), track, spins=spins)[:, None])


@pytest.mark.parametrize(
    ("angles", "spins", "expected"),
    [
        ([0, 140, 0, -140, 70, 200], True, [140, 140, 140, 150, 130]),
        ([0, 140, 0, -140, 70, 200], False, [140, 140, 140, 150, 130]),
        ([0, 100, 287, 387], True, [100, 187, 100]),
        ([0, 100, 287, 387], False, [100, 173, 100]),
        ([0, 0, 170, 0, 0], False, [0, 170, 170, 0]),
    ],
)
def test_arcs_are_the_shortest_but_a_spin_continues_past_a_half_turn(angles, spins, expected):
    np.testing.assert_allclose(wound(angles, spins=spins), expected, atol=1e-4)
    figure = figure_of(BALL if spins else ONE_BALL)  # a free body, and a joint
    columns = figure.tables.quaternion_columns[:, 0]
    qpos = np.tile(figure.model.qpos0, (len(angles), 1))
    qpos[:, columns] = turned_by(angles)
    states = raw_timeline(figure, [Frame.key(float(i), row) for i, row in enumerate(qpos)]).states
    np.testing.assert_allclose(arcs(states[:, columns]), expected, atol=1e-4)


@pytest.mark.slow
@settings(deadline=None)
@given(st.lists(st.floats(-175, 175), min_size=2, max_size=6), st.integers(0, 100))
@example([0.0, 150.001, 11.0], 0)
def test_the_choice_is_the_best_of_all(turns, seed):
    rng = np.random.default_rng(seed)
    rotations = [Rotation.identity()]
    for turn in turns:
        axis = rng.normal(size=3)
        rotations.append(rotations[-1] * Rotation.from_rotvec(np.radians(turn) * axis / np.linalg.norm(axis)))
    track = np.array([np.roll(r.as_quat(), 1) for r in rotations])
    times = np.append(0, np.cumsum(rng.uniform(0.2, 2, len(turns))))
    steps = np.array([(a.inv() * b).as_rotvec() for a, b in itertools.pairwise(rotations)])
    angle = np.linalg.norm(steps, axis=1)
    assume(np.all(np.abs(angle - NEARLY_HALF) > 1e-9))  # on the bound itself rounding decides

    def cost(ways: tuple[bool, ...]) -> float:
        rates = [s * (1 - 2 * np.pi / a if w else 1) for s, a, w in zip(steps, angle, ways, strict=True)]
        rates = np.array(rates) / np.diff(times)[:, None]
        return float(np.sum(np.sum(np.diff(rates, axis=0) ** 2, axis=1) * 2 / (times[2:] - times[:-2])))

    choices = itertools.product(*[(False, True) if a > NEARLY_HALF else (False,) for a in angle])
    best = min(cost(ways) for ways in choices)
    chosen = arcs(track * signs(times, track, spins=True)[:, None]) > 180 + 1e-9
    assert cost(tuple(chosen)) <= best * (1 + 1e-9) + 1e-9


@pytest.mark.parametrize("turn", [120.0, 160.0, 178.0])
def test_a_limb_goes_with_a_body_that_turns_far(turn):
    """Root and hip turn the same way: the thigh turns by the sum in the world, not by the rest of the circle."""
    figure = figure_of(models.figure_text("human"))
    hip = next(link for link in figure.links if link.name == "left_hip")
    keys = []
    for i in range(2):
        qpos = np.array(figure.model.qpos0)
        qpos[3:7] = quat.from_rotation_vector(np.radians([0, 0, i * turn]))
        qpos[hip.qpos : hip.qpos + 4] = quat.from_rotation_vector(np.radians([0, 0, i * 100.0]))
        keys.append(Frame.key(float(i), qpos))
    states = raw_timeline(figure, keys).states
    np.testing.assert_allclose(arcs(states[:, hip.qpos : hip.qpos + 4]), [turn + 100], atol=1e-4)


def apart(figure: Figure, a: Array, b: Array) -> float:
    """The largest entry by which configurations differ, quaternions up to their signs."""
    return float(np.abs(aligned(figure, a, b) - b).max())


def key_rows(timeline: Timeline) -> Index:
    return np.flatnonzero(timeline.fixed.any(axis=1))


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_variable_frames_are_moved_and_what_keyframes_fix_stays_even_partly(figure, rng, ends):
    keys = partial_keys(figure, rng)
    keys = closed(keys) if ends == "periodic" else keys
    first = evenly(raw_timeline(figure, keys, ends, rng.normal(size=(2, figure.width))), 2)
    found, told = straighten(figure, first), key_rows(first)
    assert told.size == len(keys)
    np.testing.assert_array_equal(found.rows[told], first.rows[told])
    np.testing.assert_array_equal(found.fixed, first.fixed)
    inner = np.setdiff1d(np.arange(len(first.frames)), told)
    expected = by_scipy(figure, first.times[told], figure.to_qpos(first.states[told]), first.times[inner])
    assert apart(figure, figure.to_qpos(found.states[inner]), expected) < 1e-12
    assert apart(figure, figure.to_qpos(first.states[inner]), expected) > 0.01
    if ends == "free":
        chords = np.diff(found.states, axis=0) / np.diff(found.times)[:, None]
        np.testing.assert_allclose(found.rows[-2:], chords[[0, -1]], atol=1e-12)
    for key, state in zip(keys, path_of(found).at(TIMES), strict=True):
        assert distance_from_key(figure, state, key) < 1e-11
