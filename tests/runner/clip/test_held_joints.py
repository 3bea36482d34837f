"""Holds in a clip: the arm that two keyframes hold stays there beside a fast motion, and nothing is left to report."""

from __future__ import annotations

import time

import mujoco
import numpy as np
import pytest
from oracles import tracks
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


def turned(problem: Clip, qpos: Array) -> dict[str, float]:
    """[degrees] by which every ball joint and the root turn from the first configuration (T, nq), at most, by SciPy."""
    model, out = problem.figure.model, {}
    for i in np.flatnonzero(model.jnt_type <= int(mujoco.mjtJoint.mjJNT_BALL)):
        at = model.jnt_qposadr[i] + 3 * int(model.jnt_type[i] == int(mujoco.mjtJoint.mjJNT_FREE))
        rotations = Rotation.from_quat(qpos[:, at : at + 4], scalar_first=True)
        out[model.joint(int(i)).name] = float(np.degrees((rotations[0].inv() * rotations).magnitude()).max())
    return out


@pytest.mark.slow
def test_an_arm_and_the_body_are_held_before_and_after_a_fast_motion_of_the_arm() -> None:
    problem = read(FAST)
    raw = problem.figure.to_qpos(path_of(problem.problem.raw).at(np.linspace(0, 1, 200)))
    assert turned(problem, raw)["right_shoulder"] > 30
    motion = inbetween(problem)
    for hold in (np.linspace(0, 1, 200), np.linspace(1.3, 2.3, 200)):
        qpos = motion.at(hold)
        assert max(turned(problem, qpos).values()) < 2  # the spine turned by 15 degrees for the arm's sake
        assert np.linalg.norm(qpos[:, :3] - qpos[0, :3], axis=1).max() < 0.01
    assert motion.violations == []


LURCH = """
figure = "human"
[solve]
ends = "clamped start"
[[keyframe]]
time = 0.0
others = "rest"
joints = {left_shoulder = {rotvec = [20, 0, 0]}, right_shoulder = {rotvec = [-20, 0, 0]}}
[[keyframe]]
time = 0.7
root.position = "free"
sites = {left_heel = [0.42, 0.09, 0], right_toe = [0.17, -0.09, 0], right_heel = ["free", "free", 0.05]}
bodies.left_foot = {flat = true}
others = "previous"
[[contact]]
point = "right_toe"
from = 0
to = 0.7
[[contact]]
point = "right_heel"
from = 0
to = 0.5
"""


@pytest.mark.slow
def test_a_person_does_not_lurch_back_before_a_step() -> None:
    """By 18 cm if nothing keeps the root near its way."""
    motion = inbetween(recordings.from_text(LURCH, name="c"))
    assert motion.sampled(100).qpos[:, 0].min() > -0.1
    assert motion.violations == []


SIDEWAYS_AND_AHEAD = """
figure = "human"
[[keyframe]]
time = 0.0
others = "rest"
[[keyframe]]
time = TIME
root.position = "free"
sites.left_heel = LEFT
sites.right_heel = [-0.055, -0.09, 0]
bodies.left_foot.flat = true
bodies.right_foot.flat = true
others = "previous"
"""


@pytest.mark.slow
@pytest.mark.parametrize(("left", "time"), [([0.25, 0.09, 0], 0.7), ([0.55, 0.2, 0], 1.2), ([-0.4, 0.09, 0], 2.0)])
def test_the_other_foot_stays_flat_in_a_step(left: list[float], time: float) -> None:
    """It rose by up to 8 cm on its toes, while the pelvis tilted by 6 degrees, if the stepping leg kept its posture."""
    text = SIDEWAYS_AND_AHEAD.replace("TIME", str(time)).replace("LEFT", str(left))
    motion = inbetween(recordings.from_text(text, name="c"))
    qpos = motion.sampled(100).qpos
    heights = tracks(motion.model, qpos, ["right_heel", "right_toe", "left_heel", "left_toe"])[..., 2]
    assert heights[:, :2].max() < 0.005
    assert heights[:, 2:].min(axis=1).max() > 0.07
    upright = Rotation.from_quat(qpos[:, 3:7], scalar_first=True).as_matrix()[:, 2, 2]
    assert np.degrees(np.arccos(upright.min())) < 2
    assert [violation for violation in motion.violations if violation.kind != "self"] == []


@pytest.mark.slow
def test_holds_among_a_thousand_keyframes_take_seconds() -> None:
    problem = read(tuple((0.5 * i, 90 * (i // 50 % 2)) for i in range(1000)))
    begin = time.perf_counter()
    held = problem.context.holds.swinging
    assert time.perf_counter() - begin < 10.0
    assert len(held) >= 38


STEP = """
figure = "human"
scene.step = {x = 0.25, height = 0.2}
[[keyframe]]
time = 0.0
others = "rest"
[[keyframe]]
time = 0.7
root = {position = [0.1, 0, 0.91], rotation = {rotvec = [0, LEAN, 0]}}
sites.left_heel = [0.4, 0.09, 0.2]
sites.right_heel = [-0.05, -0.09, 0]
bodies.left_foot.flat = true
bodies.right_foot.flat = true
others = "previous"
[[keyframe]]
time = 1.6
root.position = [0.45, 0, 1.13]
others = "rest"
"""


@pytest.mark.slow
@pytest.mark.parametrize("lean", [0, 10])
def test_a_person_who_climbs_a_step_does_not_lean_to_the_side(lean: int) -> None:
    motion = inbetween(recordings.from_text(STEP.replace("LEAN", str(lean)), name="c"))
    rotation = Rotation.from_quat(motion.at(np.linspace(0, 1.6, 161))[:, 3:7], scalar_first=True)
    sideways = np.degrees(np.arcsin(rotation.as_matrix()[:, 2, 1]))  # 30 degrees without the bound
    assert np.abs(sideways).max() < 6.5 + 0.65 * lean
    assert not [violation for violation in motion.violations if violation.kind == "overshoot"]


def test_a_rotation_of_the_root_that_swings_between_equal_keyframes_is_reported() -> None:
    text = STEP.replace("LEAN", "0") + "".join(
        f'[[penalty]]\nkind = "{k}"\nweight = 0\n' for k in ("upright", "posture")
    )
    kinds = {violation.kind: violation for violation in inbetween(recordings.from_text(text, name="c")).violations}
    assert kinds["overshoot"].name == "root"
    assert kinds["overshoot"].amount > 15
