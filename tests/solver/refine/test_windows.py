"""Windows of long clips and of edits."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from figures import FLOOR, TINY, figure_of
from random_models import distance_from_key, evenly, mask_without

from dynsplines.solver import penalty
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.objective import Objective, segment_integrals
from dynsplines.solver.problem import Improvement, Problem, Settings, Solution
from dynsplines.solver.refine.parts import AHEAD, BEHIND, KEPT, SearchPart, Window, windows
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.surface.points import Point

SEGMENTS = 20


FIGURE = figure_of(TINY)


FINE = Quadrature(points=12)


def penalties() -> list[tuple[penalty.Penalty, float]]:
    contact = penalty.Collision((Point("foot", 2, np.array([0.01, 0, -0.3]), 0.06),), (FLOOR,))
    return [
        (penalty.CovariantAcceleration(), 1.0),
        (penalty.UnitMagnitude(), 0.5),
        (penalty.RootAcceleration(), 1.0),
        (contact, 1.0),
    ]


def long_keys(*, partial: bool = False) -> list[Frame]:
    """Hops over a floor at uneven times, turning; with `partial`, every third leaves something free."""
    rng, keys, time = np.random.default_rng(3), [], 0.0
    turn = FIGURE.links[2].turn
    for i in range(SEGMENTS + 1):
        root = [0.3 * i, 0.1 * np.sin(i), (0.4, 0.55)[i % 2]]
        way = quat.from_rotation_vector([0.3 * np.sin(i), 0.4 * np.cos(0.7 * i), 0.2 * i])
        knee = quat.product(quat.inverse(turn), quat.from_rotation_vector(0.3 * rng.normal(size=3)))
        state = np.concatenate([root, way, quat.product(knee, turn)])
        free = ("root turn", "root x") if i % 2 else ("knee",)
        keys.append(Frame.key(time, state, mask_without(FIGURE, *free) if partial and i % 3 == 1 else None))
        time += rng.uniform(0.3, 0.6)
    return keys


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Windows of six segments, for any clip."""
    monkeypatch.setattr("dynsplines.solver.refine.parts.KEPT", 6)
    monkeypatch.setattr("dynsplines.solver.refine.parts.LARGEST", 0)


def fine_value(motion: Solution, path: Path | None = None) -> float:
    return Objective(motion.figure, motion.objective.terms, FINE).value(path or motion.path)


def assert_whole(path: Path, keys: list[Frame]) -> None:
    """That a path runs through all keyframes."""
    times = np.array([key.time for key in keys])
    assert path.span == (times[0], times[-1])
    for key, state in zip(keys, path.at(times), strict=True):
        assert distance_from_key(FIGURE, state, key) < 1e-12


@pytest.mark.parametrize("segments", [1, 5, 24, 25, 29, 47, 48, 49, 100, 241])
def test_windows_keep_every_segment_once_and_overlap_their_neighbours(segments):
    found = windows(segments)
    edges = [window.first for window in found] + [segments]
    assert edges[0] == 0
    sizes = np.diff(edges)
    assert max(sizes) <= KEPT
    assert max(sizes) - min(sizes) <= 1
    for window, kept_to in zip(found, edges[1:], strict=True):
        assert window.begin == max(window.first - BEHIND, 0)
        assert window.end == min(kept_to + AHEAD, segments)
    for one, other in pairwise(found):
        assert other.begin < other.first < one.end


@pytest.mark.slow
def test_a_clip_in_windows_costs_no_more_than_the_whole_and_meets_its_keyframes(request):
    keys, ends, slope = long_keys()[:15], "clamped", np.zeros((2, FIGURE.width))
    alike = Settings(variable=1, frames=14, tolerance=1e-4)
    whole = inbetween(Problem(FIGURE, keys, penalties(), alike, ends=ends, end_slope=slope))
    request.getfixturevalue("short")
    seen: list[tuple[Improvement, Path]] = []
    found = inbetween(
        Problem(FIGURE, keys, penalties(), alike, ends=ends, end_slope=slope),
        improved=lambda each: seen.append((each, each.path)),
    )
    assert found.stop is whole.stop is Stop.CONVERGED
    assert fine_value(found) < 1.005 * fine_value(whole)
    assert fine_value(found) < 0.6 * fine_value(found, path_of(found.raw))
    assert_whole(found.path, keys)
    for each, path in seen:  # the whole clip at once and later, and about its E
        assert_whole(path, keys)
        np.testing.assert_allclose(found.objective.value(path), each.value, rtol=0.03)
        np.testing.assert_array_equal(each.path.rows, path.rows)


class Counted(penalty.CovariantAcceleration):
    """Counts its calls; at number `stop_at` Ctrl-C is pressed."""

    calls, stop_at = 0, 0

    def residuals(self, samples: Samples) -> Iterator[penalty.Block | penalty.Dense]:
        Counted.calls += 1
        if Counted.calls == Counted.stop_at:
            raise KeyboardInterrupt
        return super().residuals(samples)


@pytest.mark.slow
def test_ctrl_c_anywhere_in_the_middle_returns_a_whole_motion_no_worse_than_the_raw_one(short):
    keys, terms = long_keys(partial=True)[:15], [(Counted(), 1.0), *penalties()[1:]]
    settings, values = Settings(variable=1, frames=14, tolerance=1e-2), []
    Counted.calls = Counted.stop_at = 0
    inbetween(Problem(FIGURE, keys, terms, settings))
    total = Counted.calls
    for share in (0.05, 0.5, 0.88):  # in a descent, and in a search without some terms
        Counted.calls, Counted.stop_at = 0, int(share * total)
        motion = inbetween(Problem(FIGURE, keys, terms, settings))
        assert motion.stop is Stop.INTERRUPTED
        assert_whole(motion.path, keys)
        values.append(fine_value(motion))
        assert values[-1] <= fine_value(motion, path_of(evenly(motion.raw, 1))) * (1 + 1e-9)
    assert values[-1] < 0.7 * values[0]


def part_of(timeline: Timeline, raw: Timeline, window: Window) -> SearchPart:
    terms = np.arange(3.0 * SEGMENTS).reshape(SEGMENTS, 3)
    part = SearchPart.of(path_of(timeline), timeline, raw.times, window, terms)
    elsewhere = [k for k in range(SEGMENTS) if not window.begin <= k < window.end]
    np.testing.assert_allclose(part.outside_terms, terms[elsewhere].sum(axis=0))
    return part


def nudged(timeline: Timeline, size: float, rng: np.random.Generator) -> Timeline:
    """What may move of the frames a little elsewhere."""
    frames = [replace(f, state=f.state + size * rng.normal(size=f.state.size) * ~f.fixed) for f in timeline.frames]
    return Timeline(tuple(frames), timeline.end_slope, timeline.ends)


OPENED = [Window(0, 0, 7), Window(3, 6, 16), Window(13, 16, 20), Window(0, 2, 20)]


@pytest.mark.parametrize("ends", ["free", "clamped"])
@pytest.mark.parametrize("window", OPENED, ids=str)
def test_a_window_begins_as_the_clip_has_it_and_put_back_unchanged_changes_nothing(window, ends):
    """A C² spline through the same frames with the same slopes at its ends is the same spline."""
    slope = np.random.default_rng(1).normal(size=(2, FIGURE.width)) if ends == "clamped" else None
    raw = raw_timeline(FIGURE, long_keys(), ends, slope)
    timeline = nudged(evenly(raw, 1), 0.02, np.random.default_rng(2))
    path, times, part = path_of(timeline), raw.times, part_of(timeline, raw, window)
    own = path_of(part.timeline)
    assert own.span == (times[window.begin], times[window.end])
    t = np.linspace(*own.span, 300)
    np.testing.assert_allclose(own.motion(t), path.motion(t), rtol=1e-7, atol=1e-7)
    free = [frame.time for frame in part.timeline.frames if frame.is_variable]
    beyond = times[window.first] if window.begin < window.first else -np.inf
    variable = [f.time for f in timeline.frames if f.is_variable and own.span[0] < f.time <= own.span[1]]
    expected = [time for time in variable if beyond < time]
    assert free == expected
    held = [frame.time for frame in part.timeline.frames if not frame.is_variable]
    within = [f.time for f in timeline.frames if own.span[0] <= f.time <= own.span[1] and f.time not in free]
    pinned = int(window.begin > 0 and ends == "free")  # one more beside a cut
    assert len(held) == len(within) + pinned
    assert held[:1] + held[1 + pinned :] == within
    whole = part.put_back(part.timeline)
    np.testing.assert_array_equal(whole.times, timeline.times)
    t = np.linspace(times[0], times[-1], 300)
    np.testing.assert_allclose(path_of(whole).motion(t), path.motion(t), rtol=1e-7, atol=1e-7)
    assert whole.ends == ends


@pytest.mark.parametrize("ends", ["free", "clamped"])
def test_a_few_steps_in_windows_lower_e_in_every_part_of_the_clip_and_are_reported_as_of_the_whole(short, ends):
    slope = np.zeros((2, FIGURE.width)) if ends == "clamped" else None
    keys, told = long_keys()[:15], []
    settings = Settings(variable=1, frames=14, max_evaluations=4)
    problem = Problem(FIGURE, keys, penalties()[:2], settings, ends=ends, end_slope=slope)
    motion = inbetween(problem, improved=told.append)
    values, evaluations = [each.value for each in told], [each.evaluation for each in told]
    assert np.all(np.diff(values) < 0)
    assert np.all(np.diff(evaluations) > 0)
    assert {each.round for each in told} >= {0, 1, 2}
    for each in told:
        np.testing.assert_allclose(sum(each.parts.values()), each.value)
        assert_whole(each.path, keys)
    assert_whole(motion.path, keys)
    np.testing.assert_allclose(values[-1], motion.objective.value(motion.path), rtol=1e-2)
    times = np.array([key.time for key in keys])
    raw = segment_integrals(motion.objective, path_of(evenly(motion.raw, 1)), times).sum(axis=1)
    found = segment_integrals(motion.objective, motion.path, times).sum(axis=1)
    assert found.sum() < 0.95 * raw.sum()
    edges = [window.first for window in windows(14)]
    assert np.all(np.add.reduceat(found, edges) < np.add.reduceat(raw, edges))
