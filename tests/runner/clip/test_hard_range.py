"""Joint ranges from the model through the clip to the report, as soft and as hard limits."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import pytest
from quiet import quiet
from rich.console import Console
from tiny import CLIP, FIGURE, HINGE, changed, written

from dynsplines import recordings, solving
from dynsplines.clip import load as clip
from dynsplines.clip.build import Clip
from dynsplines.errors import UserError
from dynsplines.measure.report import report, tables
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


LIMITED = FIGURE.replace('name="left_knee" type="ball"', 'name="left_knee" type="ball" limited="true" range="0 42"')
SWING = """figure = "hinge.xml"
[[keyframe]]
time = 0
joints = {swing = 0, slide = 0}
[[keyframe]]
time = 1
joints = {swing = 40, slide = 0}
[[keyframe]]
time = 1.3
joints = {swing = 40, slide = 0}
[[keyframe]]
time = 2.3
joints = {swing = 0, slide = 0}
"""


def kinds(problem: clip.Clip) -> set[str]:
    return {penalty.name for penalty, _ in problem.penalties}


def solved(problem: clip.Clip) -> dict:
    found = solving.solve(problem, quiet())
    return report(found.clip, found.motion, 0.0)


def test_ranges_count_by_default_where_the_model_has_them(tmp_path):
    assert "limits.range" not in kinds(clip.load(str(written(tmp_path))))
    (tmp_path / "tiny.xml").write_text(LIMITED, encoding="utf-8")
    assert "limits.range" in kinds(clip.load(str(tmp_path / "tiny.toml")))
    written(tmp_path, changed("[[keyframe]]", "[[penalty]]\nkind='limits'\nweight={range=0}\n[[keyframe]]", CLIP))
    (tmp_path / "tiny.xml").write_text(LIMITED, encoding="utf-8")
    assert "limits.range" not in kinds(clip.load(str(tmp_path / "tiny.toml")))


@pytest.mark.slow
@pytest.mark.parametrize("joint", ["hinge", "ball"])
def test_a_motion_that_overshoots_a_range_is_kept_within_and_the_report_contains_it(tmp_path, joint):
    text = SWING
    if joint == "ball":
        text = SWING.replace("swing = 0", "swing = {rotvec = [0, 0, 0]}").replace(
            "swing = 40", "swing = {rotvec = [0, 40, 0]}"
        )
    limit = 'range="-5 40.2"' if joint == "hinge" else 'range="0 40.2"'
    figure = HINGE.format(keys="")
    if joint == "ball":
        figure = figure.replace('type="hinge" axis="0 1 0"', 'type="ball"')
    figure = figure.replace('name="swing"', f'name="swing" limited="true" {limit}')
    path = written(tmp_path, text)
    (tmp_path / "hinge.xml").write_text(figure, encoding="utf-8")
    data = solved(clip.load(str(path)))
    json.dumps(data, allow_nan=False)
    out = io.StringIO()
    Console(file=out, width=160).print(tables(data))
    assert "beyond joint range: joint / at / most" in out.getvalue()
    before, after = (data[side]["beyond joint range"] for side in ("before", "after"))
    assert before["most"] > 0.6
    assert after["most"] < 0.1
    assert (before["joint"], before["unit"]) == ("swing", "degrees")
    assert 1 < before["at, s"] < 1.3


def test_a_slide_beyond_its_range_is_reported_in_metres(tmp_path):
    path = written(
        tmp_path, SWING.replace("slide = 0}\n[[keyframe]]\ntime = 1.3", "slide = 0.3}\n[[keyframe]]\ntime = 1.3")
    )
    text = HINGE.format(keys="").replace('name="slide"', 'name="slide" limited="true" range="-.1 .2"')
    (tmp_path / "hinge.xml").write_text(text, encoding="utf-8")
    data = report((one := solving.unsolved(clip.load(str(path)))).clip, one.motion, 0.0)["after"]["beyond joint range"]
    assert data["unit"] == "m"
    assert 0.1 <= data["most"] < 0.3


def test_no_limited_joints_no_row(tmp_path):
    one = solving.unsolved(clip.load(str(written(tmp_path))))
    assert report(one.clip, one.motion, 0.0)["after"]["beyond joint range"] == {}
