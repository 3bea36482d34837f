"""Joint ranges from the model through the clip to the report."""

from __future__ import annotations

import io
import json

import pytest
from quiet import quiet
from rich.console import Console
from tiny import CLIP, FIGURE, HINGE, changed, written

from dynsplines import solving
from dynsplines.clip import load as clip
from dynsplines.measure.report import report, tables

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
