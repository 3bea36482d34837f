"""Drags of a standing figure by any point: soles stay flat on the ground, ankles in range, balance is kept."""

from __future__ import annotations

import numpy as np
import pytest
from oracles import kinematics
from pulls import Pull, Pulls, human_model

from dynsplines.clip.kinds import posing_limits
from dynsplines.solver.figure.kinematics import Samples

SAMPLE = 4


@pytest.fixture(scope="module")
def human() -> Pulls:
    return Pulls(human_model(), "_sole")


@pytest.mark.parametrize("seed", range(SAMPLE))
def test_random_drags_keep_soles_joints_and_balance(human, seed):
    result = human.result(human.drawn(np.random.default_rng(seed)), moves=4)
    assert result.violations == {}


def flexion(pulls: Pulls, qpos) -> dict[str, float]:
    """Return the flexion of knees and elbows [degrees]."""
    bends, _ = posing_limits(pulls.figure, {})
    assert bends is not None
    angles = bends.angles(Samples.still(pulls.figure, pulls.figure.to_state(qpos[None])))
    return {joint.name: float(np.degrees(angle)) for joint, angle in zip(bends.joints, angles[0, :, 0], strict=True)}


@pytest.mark.parametrize("offset", [[0, 0.14, 0], [-0.1, 0, 0.02], [0.1, 0, 0.05], [0, 0, 0]])
def test_a_pelvis_that_is_pulled_down_squats_whatever_point_is_held(human, offset):
    pelvis = human.model.body("pelvis").id
    result = human.result(Pull(pelvis, np.array(offset, float), np.array([0, 0, -0.25])), moves=6)
    assert result.violations == {}
    assert result.miss < 0.02
    angles = flexion(human, result.qpos)
    assert angles["left_knee"] > 40
    assert angles["right_knee"] > 40


@pytest.mark.parametrize(("by", "most"), [([0.2, 0.1, 1.1], 0.02), ([-0.4, 0, 0.3], 5e-3), ([0.2, 0, 0.5], 5e-3)])
def test_a_hand_that_is_pulled_up_or_back_bends_the_elbow_forward(human, by, most):
    """Overhead, back and to the shoulder; what a straight arm reaches moves nothing else."""
    model = human.model
    forearm, hand = model.body("left_forearm").id, model.site("left_hand").pos
    result = human.result(Pull(forearm, np.array(hand), np.array(by, float)))
    assert result.violations == {}
    assert result.miss < most
    angles = flexion(human, result.qpos)
    assert -1 < angles["left_elbow"] < 151
    assert angles["left_knee"] > -1


@pytest.mark.parametrize("by", [[0.25, 0.05, -0.1], [0, 0.2, 0.01], [-0.2, 0, 0.0]])
def test_a_foot_that_is_put_down_lands_flat_on_the_ground(human, by):
    foot = human.model.body("left_foot").id
    result = human.result(Pull(foot, np.zeros(3), np.array(by)), moves=5)
    assert result.violations == {}
    data = kinematics(human.model, result.qpos)
    assert data.site("left_heel").xpos[2] == pytest.approx(0, abs=1e-3)
    assert data.site("left_toe").xpos[2] == pytest.approx(0, abs=1e-3)
    before = human.home[:2] + human.model.body("left_thigh").pos[:2]
    np.testing.assert_allclose(data.xpos[foot][:2], before + by[:2], atol=5e-3)
