"""The chart shows the amounts of violations in the kinds of file that it says, whole or not at all."""

from collections.abc import Iterator

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.figure import Figure
from problems import names
from processes import largest_file

from dynsplines.errors import UserError
from dynsplines.measure import chart
from dynsplines.measure.chart import draw
from dynsplines.measure.measurement import Measurement
from dynsplines.solving import Solved


@pytest.fixture(scope="module")
def sides(solved: Solved) -> tuple[Measurement, Measurement]:
    return Measurement.sides(solved.clip, solved.motion)


@pytest.fixture
def kept() -> Iterator[list[Figure]]:
    """The figures as they were when they went into their files."""
    figures: list[Figure] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart.plt, "close", figures.append)
        yield figures
    for each in figures:
        plt.close(each)


@pytest.mark.parametrize(("ending", "start"), [("svg", b"<?xml"), ("pdf", b"%PDF"), ("PNG", b"\x89PNG")])
def test_the_chart_is_of_the_largest_amount_of_each_kind(sides, tmp_path, kept, ending, start):
    name = r"a$\frac$b"  # a name with dollars is no formula
    draw(name, sides[0], sides[1], tmp_path / f"c.{ending}")
    assert (tmp_path / f"c.{ending}").read_bytes().startswith(start)
    assert names(tmp_path) == [f"c.{ending}"]
    (axes,) = kept[0].axes
    lines = {line.get_label(): line for line in axes.get_lines() if not str(line.get_label()).startswith("_")}
    before, after = (side.largest() for side in sides)
    amounts = {
        kind: max(side[kind][1] / side[kind][0].bound for side in (before, after) if kind in side)
        for kind in {*before, *after}
    }
    assert lines.keys() == {kind for kind, amount in amounts.items() if amount >= chart.LEAST}
    assert len(lines) > 1
    for kind in lines.keys() & after.keys():
        row, worst, time = after[kind]
        values = np.asarray(lines[kind].get_ydata())
        assert values.max() == pytest.approx(worst / row.bound)
        assert time in lines[kind].get_xdata()[values == values.max()]
    upright = {float(line.get_xdata()[0]) for line in axes.get_lines() if len(set(line.get_xdata())) == 1}
    assert upright == {0, 0.2, 0.41}


def test_a_chart_that_breaks_off_leaves_what_was_there(sides, tmp_path):
    (tmp_path / "c.png").write_bytes(b"before")
    with largest_file(1000), pytest.raises(UserError, match=r"cannot write '.*c\.png': "):
        draw("c", sides[0], sides[1], tmp_path / "c.png")
    assert (tmp_path / "c.png").read_bytes() == b"before"
    assert names(tmp_path) == ["c.png"]
    assert plt.get_fignums() == []
