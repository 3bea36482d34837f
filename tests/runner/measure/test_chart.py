"""Charts show the numbers of the report, in the kinds of file they say they are, whole or not at all."""

from __future__ import annotations

import copy

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.figure import Figure
from tiny import names

from dynsplines.errors import UserError
from dynsplines.measure import chart
from dynsplines.measure.chart import check_target, draw
from dynsplines.motion import Saved


def drawn(saved: Saved, target, report=None) -> None:
    draw(saved.name, report or saved.report, saved.trace, np.array([key.time for key in saved.keys]), target)


@pytest.fixture(scope="module")
def figure(saved: Saved, tmp_path_factory: pytest.TempPathFactory) -> Figure:
    """The figure as it was when it went into the file; to be looked at only."""
    kept: list[Figure] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart.plt, "close", kept.append)
        drawn(saved, tmp_path_factory.mktemp("chart") / "c.png")
    plt.close(kept[0])
    return kept[0]


@pytest.mark.slow
@pytest.mark.parametrize(("ending", "magic"), [("svg", b"<?xml"), ("pdf", b"%PDF")])
def test_the_ending_selects_what_is_written(saved, tmp_path, ending, magic):
    drawn(saved, tmp_path / f"c.{ending}")
    assert (tmp_path / f"c.{ending}").read_bytes().startswith(magic)
    assert names(tmp_path) == [f"c.{ending}"]
    assert plt.get_fignums() == []


@pytest.mark.slow
def test_the_first_chart_is_the_height_of_the_lowest_point(figure, saved):
    lines = {line.get_label(): line for line in figure.axes[0].get_lines()}
    for side in ("before", "after"):
        curves = saved.report["curves"][side]
        lowest = 100 * np.min(list(curves["height"].values()), axis=0)
        np.testing.assert_allclose(lines[side].get_ydata(), lowest)
        np.testing.assert_allclose(lines[side].get_xdata(), curves["time"])
    assert lowest[0] == pytest.approx(90, abs=0.1)


@pytest.mark.slow
def test_keyframes_are_marked_on_the_charts_over_time(figure):
    for axes in figure.axes[:2]:
        upright = {float(line.get_xdata()[0]) for line in axes.get_lines() if len(set(line.get_xdata())) == 1}
        assert upright == {0, 0.2, 0.41}


@pytest.mark.slow
def test_the_third_chart_has_a_bar_a_tenth_and_side(figure, saved):
    heights = [bar.get_height() for bar in figure.axes[2].patches]
    wanted = [value for side in ("before", "after") for value in saved.report["curves"][side]["EL over tenths"]]
    np.testing.assert_allclose(heights, wanted)


@pytest.mark.slow
def test_the_fourth_chart_falls_with_the_objective(figure, saved):
    lines = {line.get_label(): line.get_ydata() for line in figure.axes[3].get_lines()}
    np.testing.assert_allclose(lines["objective"], [entry[2] for entry in saved.trace])
    assert set(saved.trace[-1][3]) < set(lines)


@pytest.mark.slow
def test_every_penalty_has_a_stroke_of_its_own(saved, tmp_path, monkeypatch):
    kept: list[Figure] = []
    monkeypatch.setattr(chart.plt, "close", kept.append)
    names = [f"penalty {i}" for i in range(25)]
    trace = [[*entry[:3], dict.fromkeys(names, 0.1)] for entry in saved.trace]
    draw("many", saved.report, trace, np.array([0.0]), tmp_path / "many.png")
    monkeypatch.undo()
    plt.close(kept[0])
    lines = [line for line in kept[0].axes[3].get_lines() if line.get_label() in names]
    assert len({(line.get_color(), line.get_linestyle()) for line in lines}) == len(names)


@pytest.mark.slow
def test_a_clip_without_feet_or_evaluations_can_be_charted(saved, tmp_path):
    bare = copy.deepcopy(saved.report)
    for side in ("before", "after"):
        bare["curves"][side]["height"] = {}
        bare["curves"][side]["EL over tenths"] = [0.0] * 10
    draw(r"a$\frac$b", bare, [], np.array([0.0, 1.0]), tmp_path / "bare.svg")  # a name with dollars is no formula
    assert (tmp_path / "bare.svg").stat().st_size > 1000


@pytest.mark.slow
def test_a_clip_on_which_nothing_is_to_be_gained_can_be_charted(saved, tmp_path):
    trace = [[1, 0, 0.0, {"root": 0.0}], [2, 0, 0.0, {"root": 0.0}]]
    draw("still", saved.report, trace, np.array([0.0, 1.0]), tmp_path / "still.PNG")
    assert (tmp_path / "still.PNG").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("name", ["c.jpg", "c", "c.npz", ".png"])
def test_other_endings_are_refused(tmp_path, name):
    with pytest.raises(UserError, match=r"endings: \.png, \.svg, \.pdf"):
        check_target(tmp_path / name)


def test_a_chart_that_breaks_off_leaves_what_was_there(saved, tmp_path, monkeypatch):
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    (tmp_path / "c.png").write_bytes(b"before")
    monkeypatch.setattr(Figure, "savefig", full)
    with pytest.raises(UserError, match=r"cannot write .*: No space"):
        drawn(saved, tmp_path / "c.png")
    assert (tmp_path / "c.png").read_bytes() == b"before"
    assert names(tmp_path) == ["c.png"]
    assert plt.get_fignums() == []
