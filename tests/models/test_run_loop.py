"""The shipped run loop: a loop of two steps that are mirror images, out of the floor, and smooth across its seam."""

from __future__ import annotations

import numpy as np
import pytest

from dynsplines.clip import load as clip
from dynsplines.measure.penetration import penetration
from dynsplines.motion import sampled
from dynsplines.solver.array import Array
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.solution import Solution

PROBLEM = clip.load("run_loop")
STRIDE, PERIOD = 2.0, 0.74


@pytest.fixture(scope="module")
def run() -> Solution:
    return inbetween(PROBLEM.problem)


@pytest.mark.slow
def test_it_travels_and_goes_on_across_the_seam(run):
    seam = Seam.of(run.figure, run.timeline)
    np.testing.assert_allclose(seam.travel, STRIDE * np.eye(run.figure.width)[0], atol=1e-12)
    assert seam.apart(run.path).max() < 1e-9


@pytest.mark.slow
def test_what_the_first_keyframe_says_is_met_at_the_end_as_well(run):
    first, last = run.at([0.0, PERIOD])
    wanted = PROBLEM.keys[0].state
    assert not PROBLEM.keys[-1].is_key
    for qpos in (first, last - STRIDE * np.eye(first.size)[0]):
        for columns in run.figure.tables.quaternion_columns.T:
            qpos[columns] *= np.sign(qpos[columns] @ wanted[columns])
        np.testing.assert_allclose(qpos, wanted, atol=1e-9)


@pytest.mark.slow
def test_it_stays_out_of_the_floor_that_the_raw_spline_runs_into(run):
    deepest = []
    for timeline in (run.raw, run.timeline):
        fine = sampled(run.figure, timeline, 1000.0)
        deepest.append(penetration(run.figure.model, fine.time, fine.qpos).deepest)
    assert deepest[0] > 0.015
    assert deepest[1] < 0.001


def test_its_keyframes_are_mirror_images_half_a_period_apart():
    mirror, ahead = Mirror.of(PROBLEM.figure), STRIDE / 2 * np.eye(PROBLEM.figure.width)[0]

    def turned(state: Array) -> Array:
        return np.round(state, 12) + 0.0

    for one, two in zip(PROBLEM.keys[:3], PROBLEM.keys[3:6], strict=True):
        np.testing.assert_allclose(turned(two.state), turned(mirror.states(one.state) + ahead), atol=1e-12)
        assert two.time - one.time == pytest.approx(PERIOD / 2)
