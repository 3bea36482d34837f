"""Strides: dynamic similarity, tops of likelihoods between the periods tried, feet that slide with the ground."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from gaits import FIGURE, GROUND, PERIOD, SOLES, WALK, gait

from dynsplines.solver.contacts.gait import PoseProcess
from dynsplines.solver.contacts.gait_period import Gait
from dynsplines.solver.contacts.pose_vectors import PoseVectors
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.surface import Plane


def test_bodies_of_one_dynamic_similarity_have_strides_of_one_shape():
    """Faster and larger by the law v² ~ g h: the same period in units of √(h / g), so the same relative stride."""
    one = gait(WALK, 0.42)
    slower = raw_timeline(
        FIGURE,
        [Frame.key(2 * f.time, q) for f, q in zip(one.keys.frames, FIGURE.to_qpos(one.keys.states), strict=True)],
    )
    half = Gait(FIGURE, slower, SOLES, GROUND)
    assert half.usual_period == pytest.approx(one.usual_period * 2 ** (1 - 2 * 0.3))


def test_candidates_come_likeliest_first_between_the_periods_asked_for_and_above_the_least():
    seen = gait(WALK, 0.3)
    poses = PoseVectors.of(FIGURE, seen.keys)
    assert poses is not None
    process = PoseProcess(poses)
    found = seen.candidates(process, (0.4, 2.6), -np.inf)
    gains = [gait_cycle.gain for gait_cycle in found]
    assert len(found) > 1
    assert gains == sorted(gains, reverse=True)
    assert abs(found[0].period / PERIOD - 1) < 0.05
    for gait_cycle in found:
        assert 0.4 <= gait_cycle.period <= 2.6
        around = [process.gain(gait_cycle.period * factor) for factor in (0.985, 1.0, 1.015)]
        assert gait_cycle.period in (0.4, 2.6) or around[1] == max(around)
        assert gait_cycle.gain == pytest.approx(process.gain(gait_cycle.period))
    above = seen.candidates(process, (0.4, 2.6), gains[1] - 1e-9)
    assert [gait_cycle.period for gait_cycle in above[:1]] == [found[0].period]
    assert len(above) <= 2
    assert seen.candidates(process, (1.0, 1.0), -np.inf) == []
    given = seen.with_period(0.9)
    assert given is not None
    assert given.period == 0.9


def test_feet_slide_by_as_much_as_the_body_is_carried_along_besides_whatever_the_ground_is_called():
    """Pushed forward by a share of its speed, the standing foot slides by that share of the new one."""
    seen = gait(WALK, 0.3)
    gait_cycle = seen.with_period(PERIOD)
    assert gait_cycle is not None
    assert gait_cycle.slip < 0.2
    for share in (1.0, 3.0):
        pushed = np.array(WALK)
        pushed[:, 0] *= 1 + share
        carried = gait(pushed, 0.3).with_period(PERIOD)
        assert carried is not None
        assert carried.slip == pytest.approx(share / (1 + share), abs=0.12)
    low = replace(seen, surfaces=(Plane("low", np.array([0, 0, -0.7]), np.array([0.0, 0, 1])),))
    sunk = low.with_period(PERIOD)
    assert sunk is not None
    assert sunk.slip == pytest.approx(gait_cycle.slip, rel=1e-6)  # low is what is lowest of them, not what touches


@pytest.mark.parametrize("between", [(0.95, 1.06), (1.14, 1.25)])
def test_a_likelihood_that_rises_to_an_end_of_what_may_be_has_its_peak_there(between):
    seen = gait(WALK, 0.3)
    poses = PoseVectors.of(FIGURE, seen.keys)
    assert poses is not None
    found = seen.candidates(PoseProcess(poses), between, -np.inf)
    nearest = min(between, key=lambda end: abs(end - PERIOD))
    assert found[0].period == pytest.approx(nearest, rel=1e-9)
