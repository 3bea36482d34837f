"""The paper's figures show what was measured, in the paper's strokes, each with its caption beneath."""

from __future__ import annotations

import json
from pathlib import Path

import imageio.v3 as iio
import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from paper.equations import covariant_residual
from paper.figures import charts, drawing, scenes
from paper.figures.captioned import captioned
from paper.figures.charts import Deviations, Lengths
from paper.figures.drawing import FIGURES, Results
from paper.figures.scenes import Dip, inset, looked_at
from paper.orientations import PAPER, TENTHS, Case, figure_ten, promised, strong_tenths, weak_tenths
from quiet import quiet
from tiny import names

from dynsplines import recordings, solving
from dynsplines.motion import Saved
from dynsplines.picture.graphics import Graphics

SOFTWARE = Graphics("software", "renderer: software")
STEP_UP = """
figure = "human"
[scene]
step = {x = 0.4, height = 0.27}
[[keyframe]]
time = 0
others = "rest"
[[keyframe]]
time = 0.8
root.position = [0.7, 0, 1.2]
others = "rest"
"""


@pytest.fixture(scope="module")
def case() -> Case:
    return Case(2)


@pytest.fixture(scope="module")
def lengths(case: Case) -> Lengths:
    return Lengths.of(case.keys)


@pytest.fixture(scope="module")
def climber() -> Saved:
    return solving.solve(recordings.from_text(STEP_UP, name="climber"), quiet()).saved(quiet(), with_report=False)


@pytest.fixture(scope="module")
def tumbler() -> Saved:
    return shipped.solved("tumble").saved(quiet(), with_report=False)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures that rays draw in a moment."""
    for name, value in (("WIDTH", 160), ("TALL", 64), ("FLAT", 48), ("LOOK_RATE", 60.0)):
        monkeypatch.setattr(scenes, name, value)


# captions


def test_a_caption_stands_on_white_under_a_picture_that_stays_as_it_is(rng):
    picture = rng.integers(0, 255, (40, 700, 3), dtype=np.uint8)
    page = captioned(picture, "Figure 0", "words " * 60)
    np.testing.assert_array_equal(page[:40], picture)
    strip = page[40:]
    assert strip.shape[0] > 40
    assert (strip < 128).any(axis=-1).sum() > 500
    for edge in (strip[:, :8], strip[:, -8:], strip[:8], strip[-8:]):
        assert edge.min() == 255


# figure 9


def test_the_solid_line_is_the_optimum_and_dashed_ones_what_came_before(case, lengths):
    optimum = case.solved(PAPER, 1).path
    np.testing.assert_allclose(lengths.best, np.linalg.norm(optimum.at(lengths.time), axis=1), atol=1e-6)
    assert lengths.worst == pytest.approx(np.abs(lengths.best - 1).max(), abs=1e-5)
    raw = figure_ten(case, PAPER)["raw"]
    np.testing.assert_allclose(lengths.raw, np.linalg.norm(raw.at(lengths.time), axis=1), atol=1e-12)
    assert len(lengths.steps) == charts.SHOWN_STEPS - 1
    away = [np.abs(line - 1).max() for line in (lengths.raw, *lengths.steps)]
    assert away[0] > away[1] > lengths.worst


# figure 10


@pytest.mark.slow
def test_tenths_of_the_strong_form_are_the_mean_size_of_equation_ten(case):
    motion = case.solved(PAPER, 1)
    factors = {term.penalty.name: term.factor for term in motion.objective.terms}
    first, last = motion.path.span
    cuts = np.linspace(first, last, TENTHS + 1)
    found = strong_tenths(motion.objective, motion.path)["strong"]
    for i, value in enumerate(found):
        t = np.linspace(cuts[i], cuts[i + 1], 20001)[:-1] + (cuts[1] - cuts[0]) / 40000
        size = np.linalg.norm(
            covariant_residual(motion.path, t, factors["unit"] / factors["acceleration.angular"]), axis=1
        )
        assert value == pytest.approx(size.mean(), rel=0.01)  # a size has corners, which Gauss' nodes blur


def test_tenths_of_the_weak_form_add_up_to_what_all_frames_promise(case):
    motion = case.solved(PAPER, 1)
    tenths = weak_tenths(motion.objective, motion.path)
    assert tenths.shape == (TENTHS,)
    assert tenths.min() > 0
    assert tenths.sum() == pytest.approx(promised(motion.objective, motion.path).sum(), rel=1e-12)
    # six segments of two spans each: the first tenth is six tenths of the first segment
    first = promised(motion.objective, motion.path)[:2]
    assert tenths[0] == pytest.approx(first[0] + 0.2 * first[1], rel=1e-9)


@pytest.mark.parametrize(
    ("one", "three", "words"),
    [(2.0, 1.0, ", in the order"), (2.0, 3.0, "first frame and no further"), (5.0, 1.0, ", not in the paper's order.")],
)
def test_the_caption_says_whether_the_deviation_falls_in_the_papers_order(one, three, words):
    curves = {name: np.full(TENTHS, value) for name, value in (("raw", 4.0), ("1", one), ("3", three), (charts.FEW, 2))}
    found = Deviations(curves, {name: curve / 100 for name, curve in curves.items()})
    assert f"4 raw, {one:g} with one frame, {three:g} with three" in found.caption
    assert f"40 % raw, {10 * one:g} % with one frame, {10 * three:g} % with three" in found.caption
    assert found.caption.count(words) == 2


# figures 11 and 12


@pytest.mark.slow
def test_the_dip_is_where_mujoco_finds_the_raw_motion_deepest_in_the_step(climber):
    dip = Dip.of(climber, climber.raw)
    assert dip.depth > 0.05
    model = climber.figure.model
    data = kinematics(model, scenes.pose(climber, climber.raw, dip.time))
    step = next(g for g in range(model.ngeom) if "step" in model.geom(g).name)
    own = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] > 0]
    deepest = max(-mujoco.mj_geomDistance(model, data, geom, step, 1.0, None) for geom in own)
    assert dip.depth == pytest.approx(deepest, abs=1e-9)
    assert looked_at(climber, climber.timeline).deepest < 0.1 * dip.depth


def test_an_inset_stands_framed_in_the_upper_left_corner():
    out = inset(np.zeros((100, 100, 3), np.uint8), np.full((10, 20, 3), 7, np.uint8))
    first = scenes.MARGIN + scenes.BORDER
    assert (out[first : first + 10, first : first + 20] == 7).all()
    assert (out[first - 1, first : first + 20] == 255).all()
    assert (out == 0).all(axis=-1).sum() == 100 * 100 - (10 + 2 * scenes.BORDER) * (20 + 2 * scenes.BORDER)


# all of them


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
