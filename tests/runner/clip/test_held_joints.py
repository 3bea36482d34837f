"""Holds in a clip: the arm that two keyframes hold stays there beside a fast motion, and nothing is left to report."""

from __future__ import annotations

import time

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dynsplines import inbetween, recordings
from dynsplines.clip.build import Clip
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of

FAST = ((0, 0), (1, 0), (1.3, -120), (2.3, -120))


def read(keys: tuple[tuple[float, float], ...]) -> Clip:
    """An arm raised between two holds."""
    rows = "".join(
        f'[[keyframe]]\ntime = {t}\nothers = "rest"\njoints.right_shoulder = {{rotvec = [0, {angle}, 0]}}\n'
        for t, angle in keys
    )
    return recordings.from_text(f'figure = "human"\n{rows}', name="c")


def off(problem: Clip, qpos: Array, angle: float) -> float:
    """[degrees] that the shoulder is off an angle at most, by SciPy."""
    at = problem.figure.model.joint("right_shoulder").qposadr[0]
    turned = Rotation.from_quat(qpos[:, at : at + 4], scalar_first=True)
    home = Rotation.from_rotvec([0, angle, 0], degrees=True)
    return float(np.degrees((home.inv() * turned).magnitude()).max())


@pytest.mark.slow
def test_an_arm_is_held_before_and_after_a_fast_motion() -> None:
    problem = read(FAST)
    raw = problem.figure.to_qpos(path_of(problem.problem.raw).at(np.linspace(0, 1, 200)))
    assert off(problem, raw, 0) > 30
    motion = inbetween(problem)
    assert off(problem, motion.at(np.linspace(0, 1, 200)), 0) < 4
    assert off(problem, motion.at(np.linspace(1.3, 2.3, 200)), -120) < 4
    assert motion.violations == []


@pytest.mark.slow
def test_holds_among_a_thousand_keyframes_take_seconds() -> None:
    problem = read(tuple((0.5 * i, 90 * (i // 50 % 2)) for i in range(1000)))
    begin = time.perf_counter()
    held = problem.context.held_joints
    assert time.perf_counter() - begin < 10.0
    assert len(held) >= 38
