"""The main function of the solver: its inputs, its results, and what every callback guarantees."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from figures import BALL, ONE_BALL, PENALTIES, TINY, figure_of, hinge_keys, hinged
from random_models import TIMES, closed, distance_from_key, partial_keys, random_keys

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.curve.recording import RecordedMotion
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.inbetween import _Loop, continue_from, inbetween
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import (
    Contact,
    CovariantAcceleration,
    OvershootPenalty,
    RootAcceleration,
    TrackingPenalty,
    UnitMagnitude,
)
from dynsplines.solver.problem import SPACING, Guides, Problem, Settings, guide_of
from dynsplines.solver.refine.parts import Part
from dynsplines.solver.refine.subdivision import CRITERIA, split
from dynsplines.solver.search.minimum import Stop, StopSearch
from dynsplines.solver.search.nlopt_methods import METHODS
from dynsplines.solver.solution import AT_AN_END, Improvement, Solution
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point

BRIEF = Settings(variable=1, max_evaluations=40)


def solved(motion: Solution) -> float:
    """E of what came out, by a sum finer than the search's."""
    return Objective(motion.figure, motion.objective.terms, FINE).value(motion.path)


def raw(motion: Solution) -> float:
    return Objective(motion.figure, motion.objective.terms, FINE).value(path_of(motion.raw))


FINE = Quadrature(points=12)


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_e_falls_strictly_and_every_callback_meets_the_keyframes(figure, rng, ends):
    keys = partial_keys(figure, rng)
    keys = closed(keys) if ends == "periodic" else keys
    slope = np.zeros((2, figure.width)) if ends == "clamped" else None
    seen: list[Improvement] = []
    motion = inbetween(Problem(figure, keys, PENALTIES, BRIEF, ends=ends, end_slope=slope), improved=seen.append)
    values = [each.value for each in seen]
    assert len(values) > 2
    assert np.all(np.diff(values) < 0)
    assert np.all(np.diff([each.evaluation for each in seen]) > 0)
    for each in seen:
        np.testing.assert_allclose(sum(each.parts.values()), each.value)
        for key, state in zip(keys, each.path.at(TIMES), strict=True):
            assert distance_from_key(figure, state, key) < 1e-11
    assert motion.trace == tuple((s.evaluation, s.round, s.value, s.parts) for s in seen)
    assert seen[-1].round >= 1
    assert seen[0].evaluation == 1 and seen[-1].evaluation <= motion.evaluations
    assert solved(motion) < 0.9 * raw(motion)
    qpos = motion.at(np.linspace(0, 1.3, 7))
    np.testing.assert_allclose(figure.to_qpos(figure.to_state(qpos)), qpos, atol=1e-12)
    assert motion.at(0.3).shape == (1, figure.width)


@pytest.mark.parametrize(
    ("error", "method", "evaluations"),
    [(StopSearch, "none", 1), (KeyboardInterrupt, "none", 3), (StopSearch, "lbfgs", 7)],
)
def test_a_stop_after_any_number_of_evaluations_gives_a_path_no_worse_than_the_raw_one(
    figure, rng, error, method, evaluations
):
    keys, told = partial_keys(figure, rng), []

    def stop(each: Improvement) -> None:
        told.append(each)
        if each.evaluation >= evaluations:
            raise error

    motion = inbetween(Problem(figure, keys, PENALTIES, Settings(optimiser=method)), improved=stop)
    assert motion.stop is Stop.INTERRUPTED
    assert motion.evaluations == told[-1].evaluation >= evaluations
    assert solved(motion) <= raw(motion) * (1 + 1e-9)
    np.testing.assert_array_equal(motion.timeline.rows, told[-1].path.rows)
    for key, state in zip(keys, motion.path.at(TIMES), strict=True):
        assert distance_from_key(figure, state, key) < 1e-11


@pytest.mark.parametrize("criterion", CRITERIA)
def test_ctrl_c_while_segments_are_judged_returns_the_best_motion_so_far(rng, monkeypatch, criterion):
    figure = hinged()
    judging: list[bool] = []
    judge = CRITERIA[criterion]

    def interrupted(objective, timeline):
        judging.append(True)
        return judge(objective, timeline)

    monkeypatch.setitem(CRITERIA, criterion, interrupted)

    class Touchy(CovariantAcceleration):
        def residuals(self, samples):
            if judging:
                raise KeyboardInterrupt
            return super().residuals(samples)

    motion = inbetween(Problem(figure, hinge_keys(), [(Touchy(), 1.0)], Settings(criterion=criterion, variable=1)))
    assert judging
    assert motion.stop is Stop.INTERRUPTED
    assert motion.timeline.variable_count == 3
    judging.clear()
    assert solved(motion) <= raw(motion)


@pytest.mark.parametrize("frames", [3, 8])
def test_the_budget_of_variable_frames_is_respected(figure, rng, frames):
    settings = Settings(variable=1, frames=frames, threshold=0.0, batch=1.0, max_evaluations=15)
    motion = inbetween(Problem(figure, random_keys(figure, rng), PENALTIES, settings))
    assert motion.timeline.variable_count == frames
    assert motion.raw.variable_count == 0


@pytest.mark.parametrize("frames", [4, 6])
def test_the_segments_that_need_it_most_are_split_first(monkeypatch, frames):
    needs = np.array([0.1, 0.6, 0.3, 0.5, 0.2, 0.4])  # of the halves of three segments
    monkeypatch.setitem(CRITERIA, "resolution", lambda objective, timeline: needs)
    settings = Settings(variable=1, frames=frames, criterion="resolution", threshold=0.0)
    motion = inbetween(Problem(hinged(), hinge_keys(), [(CovariantAcceleration(), 1.0)], settings))
    halves = np.array([0.0, 0.25, 0.5, 0.95, 1.4, 1.7, 2.0])
    middles = (halves[1:] + halves[:-1]) / 2
    expected = np.sort(np.append(halves, middles[np.argsort(-needs)[: frames - 3]]))
    np.testing.assert_allclose(motion.timeline.times, expected)


@pytest.mark.parametrize(
    ("criterion", "since", "until"), [("resolution", 0.2, 1.5), ("weak", -np.inf, np.inf), ("weak", 0.7, 0.71)]
)
def test_nothing_is_split_in_what_is_held_and_nothing_that_promises_too_little(monkeypatch, criterion, since, until):
    needs = np.array([0.1, 0.6, 0.3, 0.5, 0.2, 0.4])
    monkeypatch.setitem(CRITERIA, criterion, lambda objective, timeline: needs)
    settings = Settings(criterion=criterion, threshold=0.3, batch=0.5)
    loop = _Loop(Objective.of(hinged(), [(CovariantAcceleration(), 1.0)]), settings, None)
    timeline = split(raw_timeline(hinged(), hinge_keys()), np.array([0.25, 0.95, 1.7]))
    loop.part = Part(timeline, timeline, since, until, (True, True), np.array([2.0]))
    loop.trace = [(0, 0, 9.0, {}), (1, 0, 4.4, {})]
    middles = (timeline.times[1:] + timeline.times[:-1]) / 2
    left = 4.4 - 2.0  # of E, in three segments: a segment deserves a frame beyond three tenths of its share
    least = 0.3 * left / 3 if criterion == "weak" else 0.3
    worth = [k for k in np.argsort(-needs) if since < middles[k] < until]
    for room in (1, 2, 6):
        best = [k for k in worth[: min(room, 3)] if needs[k] > least]
        chosen, promise = loop.chosen(timeline, room)
        np.testing.assert_array_equal(chosen, np.sort(middles[best]))
        assert promise == pytest.approx(needs[best].sum() / left if criterion == "weak" else 0.0)


@pytest.mark.parametrize(("tiny", "frames"), [(0.0099, 0), (0.0101, 2)])
def test_a_segment_shorter_than_a_twentieth_of_the_spacing_of_frames_next_to_it_begins_with_none(tiny, frames):
    """Two frames in 0.6 s are 0.2 s apart: a hundredth of a second is the bound, before and after."""
    for spans in ([0.6, tiny], [tiny, 0.6], [0.05, tiny, 0.6]):
        times = np.cumsum([0.0, *spans])
        found = Settings().beginning(times, in_windows=False)
        counts = np.histogram(found, times)[0].tolist()
        assert counts == [frames if span == tiny else 2 for span in spans]
    np.testing.assert_allclose(Settings().beginning(np.array([0, 0.6]), in_windows=False), [0.2, 0.4])


def test_evaluations_are_bounded_in_every_round(figure, rng):
    settings = Settings(variable=1, max_evaluations=2, frames=6, threshold=0.0)
    motion = inbetween(Problem(figure, random_keys(figure, rng), PENALTIES, settings))
    rounds = motion.trace[-1][1] + 1
    assert motion.evaluations <= 2 * rounds + 2
    assert motion.stop is Stop.MAX_EVALUATIONS


@pytest.mark.parametrize(("criterion", "method"), list(zip(CRITERIA, METHODS, strict=False)))
def test_hinges_are_solved_in_joint_coordinates_to_the_natural_spline(criterion, method):
    figure = hinged()
    assert figure.coordinates == "joint"
    settings = Settings(criterion=criterion, optimiser=method, tolerance=1e-10)
    motion = inbetween(Problem(figure, hinge_keys(), [(CovariantAcceleration(), 1.0)], settings))
    t = np.linspace(0, 2, 30)
    np.testing.assert_allclose(motion.at(t), path_of(motion.raw).at(t), atol=1e-3)
    np.testing.assert_allclose(motion.at(TIMES_OF_HINGES), [key.state for key in hinge_keys()], atol=1e-12)


TIMES_OF_HINGES = np.array([0.0, 0.5, 1.4, 2.0])


def test_a_floor_lifts_the_path_off_it():
    figure = figure_of(BALL)
    heights = [0.5, 0.15, 0.15, 0.5]
    keys = [Frame.key(t, [t, 0, z, 1, 0, 0, 0]) for t, z in zip(TIMES, heights, strict=True)]
    floor = Plane("floor", np.zeros(3), np.array([0.0, 0, 1]))
    contact = Contact((Point("ball", 1, np.zeros(3), 0.1),), (floor,))
    motion = inbetween(Problem(figure, keys, [*PENALTIES, (contact, 20.0)]))
    t = np.linspace(0, 1.3, 200)
    before = path_of(motion.raw).at(t)[:, 2].min() - 0.1
    after = motion.at(t)[:, 2].min() - 0.1
    assert before < -0.05
    assert after > 0.1 * before


def test_an_unknown_criterion_or_method_is_refused_and_the_known_ones_named(figure, rng):
    keys = random_keys(figure, rng)
    with pytest.raises(ValueError, match="'hunch'; there are: weak, residual, objective, resolution"):
        inbetween(Problem(figure, keys, PENALTIES, Settings(criterion="hunch")))
    with pytest.raises(ValueError, match="no optimiser 'magic'; there are: lbfgs, slsqp"):
        inbetween(Problem(figure, keys, PENALTIES, Settings(optimiser="magic")))


def test_nothing_to_choose_gives_the_keyframes_spline(figure, rng):
    keys, slope = random_keys(figure, rng), rng.normal(size=(2, figure.width))
    settings = Settings(variable=0, frames=0)
    motion = inbetween(Problem(figure, keys, PENALTIES, settings, ends="clamped", end_slope=slope))
    np.testing.assert_array_equal(motion.timeline.rows, motion.raw.rows)
    assert motion.evaluations == 1


def test_the_clock_does_not_matter(rng):
    figure = figure_of(ONE_BALL)
    turns = [[0.0, 0, 0], [0.7, 0.2, 0], [0.9, -0.8, 0.4], [0.1, -1.2, 1.0]]
    penalties = [(CovariantAcceleration(), 1.0), (UnitMagnitude(), 1.0)]
    paths = []
    for pace in (0.02, 1000.0):
        keys = [Frame.key(pace * i, quat.from_rotation_vector(v)) for i, v in enumerate(turns)]
        motion = inbetween(Problem(figure, keys, penalties, Settings(variable=1, frames=0)))
        paths.append(motion.at(pace * np.linspace(0, 3, 40)))
    assert np.degrees(quat.angle_between(*paths)).max() < 0.1


def many_hinge_keys() -> list[Frame]:
    angles = np.random.default_rng(2).normal(size=(13, 2))
    return [Frame.key(0.5 * i, pose) for i, pose in enumerate(angles)]


def resumed_between(*between: tuple[float, float], **settings: object) -> tuple[Problem, Timeline, Solution, list]:
    """A problem of twelve segments, where a search began, what it came to, and what it told."""
    chosen = Settings(**{"frames": 0, "max_evaluations": 3, **settings})  # type: ignore[arg-type]
    problem = Problem(hinged(), many_hinge_keys(), PENALTIES, chosen)
    rng, seen = np.random.default_rng(4), []
    even = split(problem.raw, problem.raw.times[:-1] + 0.25)
    begin = replace(
        even,
        frames=tuple(replace(f, state=f.state + 0.3 * rng.normal(size=2)) if f.is_variable else f for f in even.frames),
    )
    return problem, begin, continue_from(problem, begin, between=between, improved=seen.append), seen


@pytest.mark.parametrize("between", [((2.0, 2.5),), ((0.5, 0.5), (4.5, 4.5)), ((1.5, 1.5), (2.0, 2.0))])
def test_a_search_within_an_interval_moves_only_what_it_affects_and_reports_e_of_the_whole(between):
    problem, begin, found, seen = resumed_between(*between)
    t = begin.times
    reached = np.any([(t > first - 0.5 - 1e-9) & (t < last + 0.5 + 1e-9) for first, last in between], axis=0)
    np.testing.assert_array_equal(found.timeline.times, t)
    np.testing.assert_array_equal(found.timeline.states[~reached], begin.states[~reached])
    moved = begin.fixed.any(axis=1)
    assert np.all(np.any(found.timeline.states != begin.states, axis=1)[reached & ~moved])
    values = [each.value for each in seen]
    assert np.all(np.diff(values) < 0)
    assert found.evaluations == 3 * len(between)
    assert values[-1] == pytest.approx(problem.objective.value(path_of(found.timeline)), rel=5e-3)
    first = values[0]
    assert first == pytest.approx(problem.objective.value(path_of(begin)), rel=5e-3)
    for each in seen:
        assert sum(each.parts.values()) == pytest.approx(each.value)


def test_where_one_of_several_edits_reaches_nearly_all_or_none_is_reported_all_of_the_clip_is_searched():
    for between in ((), ((0.5, 0.5), (0.5, 5.0))):
        problem, begin, found, _ = resumed_between(*between)
        free = ~begin.fixed.any(axis=1)
        assert np.all(np.any(found.timeline.states != begin.states, axis=1)[free])
        assert found.evaluations == 3
        assert found.stop is Stop.MAX_EVALUATIONS
        assert problem.objective.value(path_of(found.timeline)) < problem.objective.value(path_of(begin))


def test_a_part_has_its_share_of_the_budget_of_frames_but_keeps_what_it_has():
    """Of twelve segments a part of five moves three: 24 frames leave ten for it, and it begins with three."""
    for budget, more in ((0, 0), (24, 7), (26, 7), (36, 12)):
        _, begin, found, _ = resumed_between((2.0, 2.5), frames=budget, threshold=0.0, batch=100.0)
        assert found.timeline.variable_count - begin.variable_count == more
        new = np.setdiff1d(found.timeline.times, begin.times)
        assert np.all((new > 1.5) & (new < 3.0))


@pytest.mark.parametrize(("between", "segments"), [((), 12), (((2.0, 2.5),), 5)])
def test_without_a_budget_there_are_twelve_frames_a_segment_at_most(between, segments):
    _, begin, found, _ = resumed_between(*between, frames=None, threshold=0.0, batch=100.0)
    outside = begin.variable_count - (12 if segments == 12 else 3)
    assert found.timeline.variable_count == outside + 12 * segments


def test_ctrl_c_between_two_parts_ends_it_and_keeps_what_the_first_came_to():
    seen = []

    def stop(each: Improvement) -> None:
        seen.append(each)
        if len(seen) == 2:
            raise StopSearch

    problem, begin, _, _ = resumed_between((0.5, 0.5))
    found = continue_from(problem, begin, between=[(0.5, 0.5), (5.0, 5.0)], improved=stop)
    assert found.stop is Stop.INTERRUPTED
    assert len(seen) == 2
    late = begin.times > 2
    np.testing.assert_array_equal(found.timeline.states[late], begin.states[late])
    assert np.any(found.timeline.states[~late] != begin.states[~late])


class Leading:
    """What knows of a path to begin with: the timeline moved in its variable frames, told how it was asked."""

    def __init__(self, by: float, *, is_binding: bool = False) -> None:
        self.by, self.is_binding, self.asked = by, is_binding, []

    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        self.asked.append((timeline.variable_count, most))
        frames = (replace(f, state=f.state + self.by) if f.is_variable else f for f in timeline.frames)
        return replace(timeline, frames=tuple(frames))


@pytest.mark.parametrize(
    ("settings", "asked"),
    [({}, (6, None)), ({"variable": 1, "frames": 9}, (3, 3)), ({"variable": 0}, None)],
)
@pytest.mark.parametrize(("is_better", "is_binding"), [(True, False), (False, False), (False, True)])
def test_a_search_begins_on_the_path_of_a_guide_if_it_is_better_or_binding(
    settings, asked, is_better, is_binding, monkeypatch
):
    """A constant added to what runs between keyframes makes a worse path of the spline, and a better one of that."""
    module, begun = import_module("dynsplines.solver.inbetween"), []
    guide = Leading(0.5 if not is_better else -0.5, is_binding=is_binding)
    monkeypatch.setattr(module, "guide_of", lambda objective: guide)
    monkeypatch.setattr(_Loop, "searched", lambda loop, begin, *told: begun.append((begin, *told)) or begin)
    if is_better:
        plain = module.split
        monkeypatch.setattr(module, "split", lambda *told: Leading(0.5).initial_guess(plain(*told), None))
    problem = Problem(hinged(), hinge_keys(), PENALTIES, Settings(**settings))
    inbetween(problem)
    ((begin, segments, budget),) = begun
    assert guide.asked == ([] if asked is None else [asked])
    assert segments == 3
    assert budget == settings.get("frames")
    raw = path_of(problem.raw).at(begin.times)
    moved = np.array([0.5 * (is_binding and frame.is_variable) for frame in begin.frames])
    np.testing.assert_allclose(begin.states, raw + moved[:, None], atol=1e-12)


TWO_SLIDES = """<mujoco><worldbody><body><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/>
<geom size=".02"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("seed", range(12))
def test_a_fast_point_does_not_pass_through_a_thin_wall_between_two_samples(seed):
    """A ball moves to and fro by 1 m within 0.3 to 0.7 s, across walls of 4 to 20 mm that are 2 to 10 cm too high."""
    rng, figure, radius = np.random.default_rng(seed), figure_of(TWO_SLIDES), 0.02
    seconds, x, top, half = rng.uniform((0.15, 0.3, 0.02, 0.002), (0.35, 0.7, 0.1, 0.01))
    keys = [Frame.key(t, np.array([far, 0.0])) for t, far in ((0.0, 0.0), (seconds, 1.0), (2 * seconds, 0.0))]
    wall = Box("wall", np.array([x, top - 1, 0]), np.eye(3), np.array([half, 1.0, 1.0]))
    ball = Point("ball", len(figure.links) - 1, np.zeros(3), radius)
    settings = Settings(quadrature=Quadrature(points=3, longest=0.05))
    motion = inbetween(Problem(figure, keys, [(RootAcceleration(), 1.0), (Contact((ball,), (wall,)), 100.0)], settings))
    away = np.abs(motion.path.at(np.linspace(0, 2 * seconds, 4000)) - [x, 0]) - [half, top]
    assert np.linalg.norm(np.maximum(away, 0), axis=1).min() > radius - 0.001
    samples = motion.objective.nodes(motion.timeline.times)[0].size
    assert samples < 10 * Quadrature(points=3, longest=0.05).nodes(motion.timeline.times)[0].size


@pytest.mark.parametrize("name", ["variable", "frames", "max_evaluations", "tolerance", "batch", "threshold"])
def test_the_least_that_may_be_requested_is_taken_and_less_is_refused(name):
    bounds: dict[str, Any] = {
        "variable": (0, -1),
        "frames": (0, -1),
        "max_evaluations": (1, 0),
        "tolerance": (1e-300, 0.0),
        "batch": (1e-300, 0.0),
        "threshold": (0.0, -1e-300),
    }
    least, less = bounds[name]
    assert getattr(Settings(**{name: least}), name) == least
    with pytest.raises(ValueError, match="settings: "):
        Settings(**{name: less})


def counts(settings: Settings, *spans: float, in_windows: bool = False) -> list[int]:
    """How many frames a segment begins with; that they are evenly spaced."""
    times = 3.0 + np.cumsum([0.0, *spans])
    found = settings.beginning(times, in_windows=in_windows)
    out = []
    for a, b in pairwise(times):
        own = found[(found > a) & (found < b)]
        np.testing.assert_allclose(np.diff([a, *own, b]), (b - a) / (own.size + 1))
        out.append(own.size)
    assert sum(out) == found.size
    return out


def test_a_segment_begins_with_two_frames_and_with_more_only_where_it_is_longer_than_three_spacings():
    """The frames that the spacing asks for are one fewer than its spans."""
    assert counts(Settings(), 3 * SPACING, 2.9 * SPACING, 0.5 * SPACING) == [2, 2, 2]
    assert counts(Settings(), 3.01 * SPACING, 4 * SPACING, 4.01 * SPACING) == [3, 3, 4]
    assert counts(Settings(), 9.5 * SPACING, 1.0 * SPACING) == [9, 2]
    assert counts(Settings(), 9.5 * SPACING, 1.0 * SPACING, in_windows=True) == [9, 3]


def test_a_budget_that_long_segments_would_break_leaves_them_as_they_are():
    spans = (9.5 * SPACING, SPACING)
    assert counts(Settings(frames=11), *spans) == [9, 2]
    assert counts(Settings(frames=10), *spans) == [2, 2]
    assert counts(Settings(frames=0), *spans) == [2, 2]


@pytest.mark.parametrize("variable", [0, 1, 5])
def test_a_given_number_applies_in_every_segment_however_long(variable):
    assert counts(Settings(variable=variable), 5.0, 0.001, 0.3) == [variable] * 3
    assert Settings(variable=variable, frames=2).in_each(3, in_windows=False) == variable


def test_in_windows_a_budget_is_shared_out_between_two_and_three_a_segment():
    assert [Settings(frames=n).in_each(10, in_windows=True) for n in (None, 5, 19, 20, 29, 30, 90)] == [
        3, 2, 2, 2, 2, 3, 3,
    ]  # fmt: skip
    assert [Settings(frames=n).in_each(10, in_windows=False) for n in (None, 0, 30)] == [2, 2, 2]


def test_limits_are_the_last_of_the_guides_that_have_a_weight():
    figure = figure_of(TINY)
    states = figure.to_state(np.tile(figure.model.qpos0, (9, 1)))
    recorded = RecordedMotion(figure, np.arange(9.0), states, np.ones_like(states))
    limit, tracking = OvershootPenalty((), figure=figure), TrackingPenalty(recorded)
    for penalties in ((limit, tracking), (tracking, limit)):
        guides = guide_of(Objective.of(figure, [(penalty, 1.0) for penalty in penalties]))
        assert isinstance(guides, Guides)
        assert guides.parts == (tracking, limit)
        assert guide_of(Objective.of(figure, [(tracking, 1.0), (limit, 0.0)])) is tracking
    assert guide_of(Objective.of(figure, [(limit, 0.0)])) is None


def solution() -> Solution:
    figure = hinged()
    raw = raw_timeline(figure, hinge_keys())
    return Solution(figure, Objective.of(figure, PENALTIES), raw, raw)


def test_a_motion_is_seen_from_its_first_keyframe_to_its_last_and_a_rounding_beyond():
    found = solution()
    t = np.array([0.0, 0.7, 2.0])
    np.testing.assert_allclose(found.at(t), path_of(found.timeline).at(t))
    assert found.at(0.7).shape == (1, 2)
    np.testing.assert_allclose(found.at([-AT_AN_END, 2 + 0.9 * AT_AN_END]), found.at([0.0, 2.0]), atol=1e-7)
    for outside in (-1.1 * AT_AN_END, 2 + 1.1 * AT_AN_END):
        with pytest.raises(ValueError, match="from 0 to 2 s; there is nothing to see outside"):
            found.at([0.5, outside])


def test_quaternions_of_a_motion_are_unit():
    figure = figure_of(BALL)
    keys = [Frame.key(t, [0, 0, 1, *(2 + t) * np.array([np.cos(t), 0, np.sin(t), 0])]) for t in (0.0, 1.0, 2.0)]
    raw = raw_timeline(figure, keys)
    found = Solution(figure, Objective.of(figure, PENALTIES), raw, raw).at(np.linspace(0, 2, 9))
    np.testing.assert_allclose(np.linalg.norm(found[:, 3:], axis=1), 1)


def test_it_is_raw_if_nothing_was_evaluated_and_times_states_and_speeds_are_those_of_the_raw_spline():
    found = solution()
    assert found.is_raw
    assert not replace(found, evaluations=1).is_raw
    raw = found.raw
    later = [replace(frame, time=frame.time + (i == 1) * 0.1) for i, frame in enumerate(raw.frames)]
    moved = [replace(frame, state=frame.state + (i == 1) * 0.1) for i, frame in enumerate(raw.frames)]
    for other in (
        Timeline(tuple(later), raw.end_slope, raw.ends),
        Timeline(tuple(moved), raw.end_slope, raw.ends),
        Timeline(raw.frames, raw.end_slope + 0.1, raw.ends),
    ):
        assert not replace(found, timeline=other).is_raw


def test_an_improvement_builds_its_path_once_and_only_when_it_is_requested():
    built, raw = [], solution().raw
    told = Improvement(3, 1, 0.5, {"acceleration.angular": 0.5}, lambda: built.append(1) or raw)
    assert not built
    np.testing.assert_array_equal(told.path.at(raw.times), path_of(raw).at(raw.times))
    assert told.path is told.path
    assert built == [1]
