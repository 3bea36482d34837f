"""A limb whose raw spline goes through an obstacle goes over it, measured by MuJoCo at 1 kHz."""

from pathlib import Path

import pytest
from paper.penetration import penetration
from processes import quiet
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.motion import Sampled

LIMB = read_data("rail_limb.xml").replace("{ridge}", " ".join(["0 .2 .4 .6 .8 .9 1 .9 .8 .6 .4 .2 0"] * 7))
OBSTACLES = {
    "rail": 'type="capsule" size=".02 .6" euler="90 0 0" pos="0 0 .47"',
    "rock": 'type="mesh" mesh="rock" pos="0 0 .43"',
    "ridge": 'type="hfield" hfield="ridge" pos="0 0 .36"',
}
CLIP = read_data("limb.toml")


@pytest.mark.slow
@pytest.mark.parametrize("obstacle", OBSTACLES)
def test_a_limb_goes_through_an_obstacle_on_the_raw_spline_and_at_most_two_millimetres_when_solved(
    tmp_path: Path, obstacle: str
):
    (tmp_path / "limb.xml").write_text(LIMB.replace("{obstacle}", OBSTACLES[obstacle]), encoding="utf-8")
    solved = solving.solve(recordings.from_text(CLIP, name="limb", folder=tmp_path), quiet())
    figure, deepest = solved.clip.figure, []
    for side in (solved.motion.before, solved.motion):
        run = Sampled.of(side, 1000.0)
        deepest.append(penetration(figure.model, run.time, run.qpos).deepest)
    assert deepest[0] > 0.015
    assert deepest[1] <= 0.002
