"""Frames, timelines and their unknowns."""

import numpy as np
import pytest
from figures import BALL, TINY, figure_of
from random_models import TIMES, distance_from_key, evenly, mask_without, masks_by_name, random_keys
from scipy.interpolate import CubicSpline

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import Path, Spline, path_of
from dynsplines.solver.curve.unknowns import Unknowns
from dynsplines.solver.figure.figure import Figure, JointKind

KINDS = [
    "whole",
    "a joint free, what hangs on it fixed",
    "root orientation free",
    "root position free on single axes",
    "any",
]


def prepared(figure: Figure, keys: list[Frame], ends: str, rng: np.random.Generator) -> Timeline:
    slope = rng.normal(size=(2, figure.width)) if ends == "clamped" else None
    return evenly(raw_timeline(figure, keys, ends, slope), 1)


def random_x(unknowns: Unknowns, rng: np.random.Generator) -> np.ndarray:
    x = rng.normal(size=unknowns.size)
    return 10 * x / np.linalg.norm(x) if x.size else x


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
@pytest.mark.parametrize("kind", KINDS)
def test_every_x_meets_the_keyframes_the_start_is_the_timeline_and_the_map_has_its_transpose(figure, rng, kind, ends):
    keys = random_keys(figure, rng, masks_by_name(figure, kind, rng))
    if ends == "periodic":
        last = Frame.key(TIMES[-1], keys[0].state, keys[0].fixed & keys[-1].fixed)
        keys[-1] = last
    timeline = prepared(figure, keys, ends, rng)
    unknowns = Unknowns.of(figure, timeline)
    for _ in range(2):
        path = Path(Spline(timeline.times, ends), unknowns.rows(x := random_x(unknowns, rng)))
        for key, state in zip(keys, path.at(TIMES), strict=True):
            assert distance_from_key(figure, state, key) <= 1e-12
    np.testing.assert_allclose(unknowns.rows(unknowns.start), timeline.rows, atol=1e-11)
    np.testing.assert_allclose(Unknowns.of(figure, timeline.with_rows(path.rows)).start, x, atol=1e-12)
    x, g = rng.normal(size=unknowns.size), rng.normal(size=timeline.rows.shape)
    linear = unknowns.rows(x) - unknowns.rows(0 * x)
    np.testing.assert_allclose(np.sum(g * linear), unknowns.pulled_back(g) @ x, rtol=1e-11, atol=1e-11)
    assert unknowns.size > 0


def test_the_raw_timeline_of_whole_keyframes_is_the_natural_spline(figure, rng):
    raw = raw_timeline(figure, random_keys(figure, rng))
    np.testing.assert_allclose(path_of(raw).at([TIMES[0], TIMES[-1]], 2), 0, atol=1e-9)
    for columns in figure.tables.quaternion_columns.T:
        track = raw.states[:, columns]
        np.testing.assert_allclose(np.linalg.norm(track, axis=1), 1, atol=1e-12)
        assert np.all(np.sum(track[1:] * track[:-1], axis=1) >= 0)


@pytest.mark.parametrize("others", [[0, 2, 3], [0, 3], [1, 3]])
def test_entries_missing_from_keyframes_start_on_the_spline_of_their_neighbours(figure, rng, others):
    """Constant before the first neighbour."""
    columns = [2, *(link.qpos for link in figure.links[1:] if link.kind in (JointKind.HINGE, JointKind.SLIDE))]
    mask = np.ones(figure.width, bool)
    mask[columns] = False
    keys = random_keys(figure, rng, {i: mask for i in range(4) if i not in others})
    times, values = np.array(TIMES), np.array([keys[i].state[columns] for i in others])
    expected = CubicSpline(times[others], values, bc_type="natural")(np.maximum(times, times[others[0]]))
    np.testing.assert_allclose(figure.to_qpos(raw_timeline(figure, keys).states)[:, columns], expected, atol=1e-12)


def test_a_free_joint_starts_as_its_own_keyframes_say_however_its_parents_turn(figure, rng):
    joint = figure.links[2]
    keys = random_keys(figure, rng, dict.fromkeys((1, 2), mask_without(figure, joint.name)))
    turned = [key.state.copy() for key in keys]
    for qpos in turned:
        qpos[3:7] = quat.normalise(rng.normal(size=4))
    others = [Frame.key(key.time, qpos, key.fixed) for key, qpos in zip(keys, turned, strict=True)]
    one, other = (figure.to_qpos(raw_timeline(figure, each).states)[:, joint.columns] for each in (keys, others))
    if joint.kind is JointKind.BALL:  # q and −q are one rotation
        other *= np.sign(np.sum(one * other, axis=1))[:, None]
    np.testing.assert_allclose(other, one, atol=1e-12)


def test_what_no_keyframe_says_starts_at_the_rest_pose(figure, rng):
    joint = figure.links[2].name
    mask = mask_without(figure, "root", "root x", "root y", "root z", joint)
    raw = raw_timeline(figure, random_keys(figure, rng, dict.fromkeys(range(4), mask)))
    rest = np.array(figure.model.qpos0)
    for qpos in figure.to_qpos(raw.states):
        np.testing.assert_allclose(qpos[~mask], rest[~mask], atol=1e-12)


def test_a_clamped_turn_by_more_than_half_a_circle_ends_with_its_slope():
    figure = figure_of(BALL)
    turns = [quat.from_rotation_vector([0, 0, np.radians(angle)]) for angle in (0, 100, 200, 300)]
    keys = [Frame.key(float(i), [0, 0, 1, *turn]) for i, turn in enumerate(turns)]
    slope = np.zeros((2, 7))
    slope[1, 3:] = quat.product(turns[-1], np.array([0, 0, 0, 0.5]))
    path = path_of(raw_timeline(figure, keys, "clamped", slope))
    np.testing.assert_allclose(path.at(np.array([0.0, 3.0]), 1), slope, atol=1e-12)


SLOPE = np.arange(6.0).reshape(2, 3)


def three_frames() -> tuple[Frame, ...]:
    return (Frame.key(0.0, [1, 2, 3]), Frame.key(0.5, [4, 5, 6], [True, False, False]), Frame.variable(1.25, [7, 8, 9]))


def keys_at(*times: float) -> Timeline:
    return Timeline(tuple(Frame.key(t, [1, 2, 3]) for t in times), SLOPE)


HINGED = figure_of(TINY)
KEYS = random_keys(HINGED, np.random.default_rng(0))
ROOT = np.isin(np.arange(11), range(3, 7))


def with_key(index: int, state: np.ndarray, mask: np.ndarray | None = None, ends: str = "free") -> Timeline:
    """The raw timeline of four keyframes, one of them replaced."""
    key = Frame.key(TIMES[index], state, mask)
    return raw_timeline(HINGED, [*KEYS[:index], key, *KEYS[index + 1 :]], ends)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: keys_at(0.0), "at least 2 frames, not 1"),
        (lambda: keys_at(), "at least 2 frames, not 0"),
        (lambda: keys_at(0.0, 2.0, 1.0), "frame 3 is at t = 1 s, not after frame 2 at t = 2 s"),
        (lambda: keys_at(0.0, 1.0, 1.0), "frame 3 is at t = 1 s, not after frame 2 at t = 1 s"),
        (lambda: Timeline((Frame.key(0, [1, 2]), Frame.key(1, [1, 2, 3])), SLOPE), r"different lengths: \[2, 3\]"),
        (lambda: Timeline(three_frames(), SLOPE[:, :2]), r"\(2, 2\), not \(2, 3\)"),
        (lambda: Timeline(three_frames(), SLOPE, "loop"), "'loop': not one of 'free', 'clamped', 'clamped start'"),
        (lambda: Timeline(three_frames(), SLOPE).with_rows(np.zeros((3, 3))), r"\(3, 3\), not \(5, 3\)"),
        (lambda: Frame.key(0.5, [1, np.nan, 3]), r"t = 0\.5 s holds entries that are not finite"),
        (lambda: Frame.key(-np.inf, [1, 2, 3]), "not finite"),
        (lambda: Frame(0.0, np.ones(3), np.array([True, False])), "must be vectors of one length"),
        (lambda: Frame(0.0, np.ones((1, 2)), np.array([[True, True]])), "must be vectors of one length"),
        (lambda: Frame(0.0, np.array(1.0), np.array(True)), "must be vectors of one length"),
        (lambda: Frame.many([0, 1], [[1, 2], [np.inf, 3]], np.eye(2) > 0), "t = 1 s holds entries that are not finite"),
        (lambda: Frame.many([0, 1], np.zeros((3, 2)), np.eye(3, 2) > 0), "do not match"),
        (lambda: with_key(1, KEYS[1].state, np.arange(11) != 4), r"\(t = 0\.4 s\): the quaternion of 'root' is fixed"),
        (lambda: with_key(2, KEYS[2].state * ~ROOT), r"keyframe 3 \(t = 1 s\): the quaternion of 'root' is zero"),
        (lambda: with_key(0, np.ones(12)), "keyframe 1 .*: 12 entries, .* qpos has 11"),
        (lambda: raw_timeline(HINGED, KEYS, "clamped"), "clamped ends need end_slope of shape"),
        (lambda: raw_timeline(HINGED, KEYS, "clamped", np.zeros(3)), "clamped ends need end_slope of shape"),
        (lambda: raw_timeline(HINGED, KEYS, "looped"), "not one of 'free', 'clamped', 'clamped start', 'clamped end'"),
    ],
)
def test_frames_that_make_no_timeline_are_refused(make, text):
    with pytest.raises(TimelineError, match=text):
        make()


def test_a_zero_quaternion_that_is_not_fixed_is_allowed():
    assert np.all(np.isfinite(with_key(2, KEYS[2].state * ~ROOT, ~ROOT).rows))


def test_no_array_of_a_frame_or_a_timeline_can_be_written_to_nor_follows_the_array_it_was_made_from():
    timeline = Timeline(three_frames(), SLOPE)
    frame = timeline.frames[0]
    arrays = [frame.state, frame.fixed, timeline.end_slope, timeline.times, timeline.states, timeline.fixed]
    for array in [*arrays, timeline.rows]:
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    state, mask = np.array([1.0, 2, 3]), np.array([True, False, True])
    frame = Frame.key(0, state, mask)
    state[:], mask[:] = 9, False
    np.testing.assert_array_equal(frame.state, [1, 2, 3])
    np.testing.assert_array_equal(frame.fixed, [True, False, True])
