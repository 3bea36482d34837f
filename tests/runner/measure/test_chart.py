"""Charts show the numbers of the report, in the kinds of file they say they are, whole or not at all."""

from __future__ import annotations

import copy
from collections.abc import Iterator

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.figure import Figure
from small_disk import largest_file
from tiny import names

from dynsplines.errors import UserError
from dynsplines.measure import chart
from dynsplines.measure.chart import ENDINGS, draw
from dynsplines.motion import Saved
from dynsplines.system.output import check_target


def drawn(saved: Saved, target, report=None) -> None:
    draw(saved.name, report or saved.report, saved.trace, np.array([key.time for key in saved.keys]), target)


@pytest.fixture
def kept() -> Iterator[list[Figure]]:
    """The figures as they were when they went into their files."""
    figures: list[Figure] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart.plt, "close", figures.append)
        yield figures
    for each in figures:
        plt.close(each)


@pytest.mark.slow
def test_the_charts_are_of_the_report_and_the_search(saved, tmp_path, kept):
    drawn(saved, tmp_path / "c.svg")
    assert (tmp_path / "c.svg").read_bytes().startswith(b"<?xml")
    assert names(tmp_path) == ["c.svg"]
    (figure,) = kept
    heights, _, tenths, objective = figure.axes
    lines = {line.get_label(): line for line in heights.get_lines()}
    for side in ("before", "after"):
        curves = saved.report["curves"][side]
        lowest = 100 * np.min(list(curves["height"].values()), axis=0)
        np.testing.assert_allclose(lines[side].get_ydata(), lowest)
        np.testing.assert_allclose(lines[side].get_xdata(), curves["time"])
    assert lowest[0] == pytest.approx(90, abs=0.1)
    for axes in figure.axes[:2]:
        upright = {float(line.get_xdata()[0]) for line in axes.get_lines() if len(set(line.get_xdata())) == 1}
        assert upright == {0, 0.2, 0.41}
    wanted = [value for side in ("before", "after") for value in saved.report["curves"][side]["EL over tenths"]]
    np.testing.assert_allclose([bar.get_height() for bar in tenths.patches], wanted)
    lines = {line.get_label(): line.get_ydata() for line in objective.get_lines()}
    np.testing.assert_allclose(lines["objective"], [entry[2] for entry in saved.trace])
    assert set(saved.trace[-1][3]) < set(lines)


@pytest.mark.slow
def test_every_penalty_has_a_stroke_of_its_own(saved, tmp_path, kept):
    names = [f"penalty {i}" for i in range(25)]
    trace = [[*entry[:3], dict.fromkeys(names, 0.1)] for entry in saved.trace]
    draw("many", saved.report, trace, np.array([0.0]), tmp_path / "many.pdf")
    assert (tmp_path / "many.pdf").read_bytes().startswith(b"%PDF")
    lines = [line for line in kept[0].axes[3].get_lines() if line.get_label() in names]
    assert len({(line.get_color(), line.get_linestyle()) for line in lines}) == len(names)


@pytest.mark.slow
def test_a_clip_without_feet_or_anything_to_gain_can_be_charted(saved, tmp_path):
    bare = copy.deepcopy(saved.report)
    for side in ("before", "after"):
        bare["curves"][side]["height"] = {}
        bare["curves"][side]["EL over tenths"] = [0.0] * 10
    name, times = r"a$\frac$b", np.array([0.0, 1.0])  # a name with dollars is no formula
    trace = [[1, 0, 0.0, {"root": 0.0}], [2, 0, 0.0, {"root": 0.0}]]
    for each, target in (([], tmp_path / "bare.PNG"), (trace, tmp_path / "still.PNG")):
        draw(name, bare, each, times, target)
        assert target.read_bytes().startswith(b"\x89PNG")
    assert plt.get_fignums() == []


@pytest.mark.parametrize("name", ["c.jpg", "c", "c.npz", ".png"])
def test_other_endings_are_refused(tmp_path, name):
    with pytest.raises(UserError, match=r"endings: \.png, \.svg, \.pdf"):
        check_target(tmp_path / name, endings=ENDINGS)


def test_a_chart_that_breaks_off_leaves_what_was_there(saved, tmp_path):
    (tmp_path / "c.png").write_bytes(b"before")
    with largest_file(1000), pytest.raises(UserError, match=r"cannot write '.*c\.png': "):
        drawn(saved, tmp_path / "c.png")
    assert (tmp_path / "c.png").read_bytes() == b"before"
    assert names(tmp_path) == ["c.png"]
    assert plt.get_fignums() == []
