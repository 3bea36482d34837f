"""Strides: dynamic similarity, tops of likelihoods between the periods tried, feet that slide with the ground."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from gaits import FIGURE, GROUND, PERIOD, SOLES, TIME, WALK, gait

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.reading.pose_vectors import PoseVectors
from dynsplines.solver.reading.rhythm import Process
from dynsplines.solver.reading.stride import (
    ANY_PERIOD,
    CYCLES,
    GAIN,
    GRAVITY,
    LONGER,
    OUTSIDE,
    SHORTER,
    Gait,
    _refined,
)
from dynsplines.solver.surface import Plane


@pytest.mark.parametrize("at", [1, 3, 5])
@pytest.mark.parametrize("off", [-0.4, 0.0, 0.3])
def test_the_top_of_a_parabola_over_the_logarithm_of_the_period_is_found_exactly(at, off):
    tried = np.geomspace(0.5, 2.0, 7)
    top = float(tried[at] * (tried[1] / tried[0]) ** off)
    gain = 3 - 2.0 * np.log(tried / top) ** 2
    assert _refined(None, tried, gain, at) == pytest.approx(top, rel=1e-12)  # type: ignore[arg-type]


def test_at_either_end_and_where_likelihoods_lie_on_a_line_the_period_tried_is_taken():
    tried = np.geomspace(0.5, 2.0, 7)
    for gain in (np.arange(7.0), 0 * tried, np.log(tried) ** 2):
        for i in (0, 3, 6):
            if i != 3 or np.diff(gain, 2)[2] >= 0:
                assert _refined(None, tried, gain, i) == tried[i]  # type: ignore[arg-type]


def test_bodies_of_one_dynamic_similarity_have_strides_of_one_shape():
    """Faster and larger by the law v² ~ g h: the same period in units of √(h / g), so the same relative stride."""
    one = gait(WALK, 0.42)
    period, hips, speed = one.usual_period, one._hips, one._travel
    relative = speed * period / hips
    assert relative == pytest.approx(2.3 * (speed**2 / (9.81 * hips)) ** 0.3, rel=1e-9)
    assert pytest.approx(9.81) == GRAVITY
    assert speed == pytest.approx((WALK[-1, 0] - WALK[0, 0]) / (TIME[-1] - TIME[0]), rel=1e-3)
    assert hips == pytest.approx(0.95, abs=0.1)  # of the human, slightly bent
    slower = raw_timeline(
        FIGURE,
        [Frame.key(2 * f.time, q) for f, q in zip(one.keys.frames, FIGURE.to_qpos(one.keys.states), strict=True)],
    )
    half = Gait(FIGURE, slower, SOLES, GROUND)
    assert half._travel == pytest.approx(speed / 2)
    assert half.usual_period == pytest.approx(period * 2 ** (1 - 2 * 0.3))


def test_candidates_come_likeliest_first_between_the_periods_asked_for_and_above_the_least():
    seen = gait(WALK, 0.3)
    poses = PoseVectors.of(FIGURE, seen.keys)
    assert poses is not None
    process = Process(poses)
    found = seen.candidates(process, (0.4, 2.6), -np.inf)
    gains = [rhythm.gain for rhythm in found]
    assert len(found) > 1
    assert gains == sorted(gains, reverse=True)
    assert abs(found[0].period / PERIOD - 1) < 0.05
    for rhythm in found:
        assert 0.4 <= rhythm.period <= 2.6
        around = [process.gain(rhythm.period * factor) for factor in (0.985, 1.0, 1.015)]
        assert rhythm.period in (0.4, 2.6) or around[1] == max(around)
        assert rhythm.gain == pytest.approx(process.gain(rhythm.period))
    above = seen.candidates(process, (0.4, 2.6), gains[1] - 1e-9)
    assert [rhythm.period for rhythm in above[:1]] == [found[0].period]
    assert len(above) <= 2
    assert seen.candidates(process, (1.0, 1.0), -np.inf) == []
    given = seen.given(0.9)
    assert given is not None
    assert given.period == 0.9


def test_periods_are_looked_for_from_a_share_of_the_usual_one_to_a_multiple_of_it(monkeypatch):
    seen, asked = gait(WALK, 0.3), []
    monkeypatch.setattr(Gait, "candidates", lambda self, process, between, least: asked.append((between, least)) or [])
    assert seen.likeliest() is None
    assert seen.told() is None
    usual = seen.usual_period
    assert asked[0] == ((SHORTER * usual, LONGER * usual), -np.inf)
    (shortest, longest), least = asked[1]
    assert shortest == SHORTER * usual
    assert shortest < longest <= LONGER * usual
    assert least == GAIN
    still = gait(WALK * (np.arange(WALK.shape[1]) != 0), 0.3)
    assert still.likeliest() is None
    assert asked[-1] == (ANY_PERIOD, -np.inf)


def test_feet_slide_by_as_much_as_the_body_is_carried_along_besides_whatever_the_ground_is_called():
    """Pushed forward by a share of its speed, the standing foot slides by that share of the new one."""
    seen = gait(WALK, 0.3)
    rhythm = seen.given(PERIOD)
    assert rhythm is not None
    assert rhythm.slip < 0.2
    for share in (1.0, 3.0):
        pushed = np.array(WALK)
        pushed[:, 0] *= 1 + share
        carried = gait(pushed, 0.3).given(PERIOD)
        assert carried is not None
        assert carried.slip == pytest.approx(share / (1 + share), abs=0.12)
    low = replace(seen, surfaces=(Plane("low", np.array([0, 0, -0.7]), np.array([0.0, 0, 1])),))
    sunk = low.given(PERIOD)
    assert sunk is not None
    assert sunk.slip == pytest.approx(rhythm.slip, rel=1e-6)  # low is what is lowest of them, not what touches


def test_on_stairs_and_in_loops_no_cycle_is_told():
    seen = gait(WALK, 0.42)
    assert seen._is_level
    step = 0.06 * np.arange(len(seen.keys.frames))
    qpos = FIGURE.to_qpos(seen.keys.states)
    qpos[:, 2] += step
    up = raw_timeline(FIGURE, [Frame.key(f.time, q) for f, q in zip(seen.keys.frames, qpos, strict=True)])
    slope = Plane("slope", np.zeros(3), np.array([-0.2, 0, 1]) / np.hypot(0.2, 1))
    assert not Gait(FIGURE, up, SOLES, (slope,))._is_level
    assert Gait(FIGURE, up, SOLES, GROUND)._is_level  # the ground is level, wherever the body is


@pytest.mark.parametrize("between", [(0.95, 1.06), (1.14, 1.25)])
def test_a_likelihood_that_rises_to_an_end_of_what_may_be_has_its_peak_there(between):
    seen = gait(WALK, 0.3)
    poses = PoseVectors.of(FIGURE, seen.keys)
    assert poses is not None
    found = seen.candidates(Process(poses), between, -np.inf)
    nearest = min(between, key=lambda end: abs(end - PERIOD))
    assert found[0].period == pytest.approx(nearest, rel=1e-9)


@pytest.mark.parametrize(
    ("gains", "best"),
    [
        ({(0, 0): 0.0, (1, 0): OUTSIDE + 0.05, (0, 1): OUTSIDE + 0.15, (1, 1): 2 * OUTSIDE + 0.1}, (0, 1)),
        ({(0, 0): 0.0, (1, 0): OUTSIDE - 0.05, (0, 1): OUTSIDE - 0.15, (1, 1): 2 * OUTSIDE - 0.1}, (0, 0)),
        ({(0, 0): 0.0, (1, 0): OUTSIDE + 0.05, (0, 1): OUTSIDE + 0.15, (1, 1): 2 * OUTSIDE + 0.2}, (1, 1)),
    ],
)
def test_ends_are_left_out_where_that_tells_more_than_it_costs_each(monkeypatch, gains, best):
    told = {out: SimpleNamespace(gain=gain) for out, gain in gains.items()}
    monkeypatch.setattr(Gait, "_without", lambda _, *out: SimpleNamespace(_told_by_all=told[out]))
    assert gait(WALK, 0.42).told() is told[best]


def test_a_clip_has_most_of_a_cycle_from_its_first_keyframe_to_its_last(monkeypatch):
    seen, asked = gait(WALK, 0.42), []
    poses = PoseVectors.of(FIGURE, seen.keys)
    assert poses is not None
    monkeypatch.setattr(Gait, "_periods", property(lambda _: (0.1, 1e3)))
    monkeypatch.setattr(Gait, "candidates", lambda _, process, periods, gain: asked.append(periods) or [])
    assert seen._told_by_all is None
    times = [frame.time for frame in seen.keys.frames]
    assert asked == [(0.1, pytest.approx(poses.sides / 2 * (times[-1] - times[0]) / CYCLES, rel=1e-12))]
