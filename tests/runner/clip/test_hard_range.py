"""`limit = "hard"`: no joint leaves its range at any time, keyframes beyond are refused, the rest is a violation."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from dynsplines import recordings
from dynsplines.clip.build import Clip
from dynsplines.errors import UserError
from dynsplines.measure.violation import violations
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween
from tests.support.biped import biped, scene

HARD = '[[penalty]]\nkind = "limits"\nrange = "hard"\n'
REST = '[[keyframe]]\ntime = {}\nothers = "rest"\n'
FREE_HINGE = '<mujoco><worldbody><body><joint/><geom size=".1"/></body></worldbody></mujoco>'
KICK = f"{REST.format(0)}{REST.format(0.4)}joints = {{left_hip = -80, left_knee = 125}}\n"
KICK += f"{REST.format(0.6)}joints = {{left_hip = -40, left_knee = 124}}\n{REST.format(0.8)}{REST.format(1.0)}"


def read(folder: Path, keys: str, penalty: str = HARD, model: str = "") -> Clip:
    (folder / "model.xml").write_text(model or scene(biped()), encoding="utf-8")
    return recordings.from_text(f'figure = "model.xml"\n{penalty}{keys}', name="c", folder=folder)


def beyond(problem: Clip, timeline: Timeline) -> float:
    """[degrees] that a hinge is beyond its range at most, 4000 times a second."""
    model, path = problem.figure.model, path_of(timeline)
    qpos = problem.figure.to_qpos(path.at(np.linspace(0, 1, 4001)))
    hinges = [j for j in range(model.njnt) if model.jnt_limited[j]]
    values, (low, high) = qpos[:, model.jnt_qposadr[hinges]], model.jnt_range[hinges].T
    return float(np.degrees(np.maximum(low - values, values - high).max()))


def test_a_kick_from_straight_knees_stays_in_range_and_the_raw_spline_is_a_violation(tmp_path: Path) -> None:
    problem = read(tmp_path, KICK)
    raw = problem.problem.raw
    assert beyond(problem, raw) > 0.05
    assert beyond(problem, inbetween(problem.problem).timeline) < 0.05
    found = [each for each in violations(problem, raw, raw) if each.kind == "hard range"]
    assert {each.name for each in found} >= {"left_knee"}
    assert found[0].bound == 0.05 and "beyond its hard range" in found[0].text


def test_a_keyframe_beyond_its_range_is_refused_with_place_and_numbers(tmp_path: Path) -> None:
    keys = KICK.replace("125", "130")
    assert read(tmp_path, keys, penalty="") is not None
    beyond_range = r"c.toml: keyframe 2 \(t = 0.4 s\): 'left_knee' is 4 degrees beyond its range, 0 to 126 degrees"
    with pytest.raises(UserError, match=beyond_range):
        read(tmp_path, keys)


def test_what_cannot_be_hard_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="needs a weight over 0"):
        read(tmp_path, KICK, f"{HARD}weight = 0\n")
    with pytest.raises(UserError, match="no joint of the figure has a range"):
        read(tmp_path, REST.format(0) + REST.format(1), model=FREE_HINGE)
    with pytest.raises(UserError, match="range must be 'soft' or 'hard'"):
        read(tmp_path, KICK, HARD.replace("hard", "firm"))
