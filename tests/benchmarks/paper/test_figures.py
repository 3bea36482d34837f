"""The paper's figures show what was measured, in the paper's strokes, each with its caption beneath."""

from __future__ import annotations

import json
from pathlib import Path

import imageio.v3 as iio
import pytest
import shipped
from paper.figures import drawing, scenes
from paper.figures.drawing import FIGURES, Results
from problems import names
from processes import quiet
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.motion import Saved
from dynsplines.picture.graphics import Graphics

SOFTWARE = Graphics("software", "renderer: software")
STEP_UP = read_data("step_up.toml")


@pytest.fixture(scope="module")
def climber() -> Saved:
    return solving.solve(recordings.from_text(STEP_UP, name="climber"), quiet()).motion


@pytest.fixture(scope="module")
def tumbler() -> Saved:
    return shipped.solved("tumble").motion


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures that rays draw in a moment."""
    for name, value in (("WIDTH", 160), ("TALL", 64), ("FLAT", 48), ("LOOK_RATE", 60.0)):
        monkeypatch.setattr(scenes, name, value)


@pytest.fixture
def results(climber: Saved, tumbler: Saved, monkeypatch: pytest.MonkeyPatch) -> Results:
    """Of a short clip in place of the runner, which is not solved anew."""
    found = {drawing.RUNNER: climber, drawing.TUMBLER: tumbler}
    monkeypatch.setattr(Results, "_solved", lambda self, name: found[name])
    return Results(SOFTWARE, quiet())


@pytest.mark.slow
def test_all_figures_are_drawn_into_a_folder_that_is_made_for_them(results, small, tmp_path):
    drawn = drawing.draw(tmp_path / "new" / "figures", SOFTWARE, quiet())
    assert [each.number for each in drawn] == [6, 7, 9, 10, 11, 12] == list(FIGURES)
    assert names(tmp_path / "new" / "figures") == sorted(f"figure_{number}.png" for number in FIGURES)
    for each in drawn:
        assert iio.imread(each.file).shape[1] in (160, 1200)
    told = json.loads(json.dumps([each.as_json for each in drawn]))
    assert "7 orientations" in told[1]["caption"]
    assert f"{len(results.runner.keys)} keyframes" in told[0]["caption"].replace("Its ", "")
    assert f"{1000 * results.dip.depth:.0f} mm deep" in told[4]["caption"]


def test_the_page_of_the_docs_shows_every_figure_that_is_drawn():
    page = (Path(__file__).parents[3] / "docs" / "paper.md").read_text(encoding="utf-8")
    for number in FIGURES:
        assert f"../renders/paper/figure_{number}.png" in page
