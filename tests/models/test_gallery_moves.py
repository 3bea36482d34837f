"""Moves about things: sitting down, a jump over a box, a hand on a rail, a crate carried, a cartwheel, a run on to a
step, and a limb over obstacles. MuJoCo measures them.

Every figure is of the solved motion between its keyframes, beside that of the raw spline where that shows what it is
good for.
"""

from pathlib import Path
from typing import Any

import numpy as np
import perturbed
import pytest
import shipped
from bench import Effort
from paper.penetration import penetration
from processes import quiet
from shipped import in_carried, of
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.measure.report import report
from dynsplines.motion import Sampled
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.points import places_of

pytestmark = pytest.mark.slow
G = 9.81


def test_sitting_down_ends_on_the_bench_and_the_weight_is_over_the_feet_until_shortly_before():
    move = of("sit_down")
    for time in (1.3, 1.6, 1.9):
        assert 0 <= move.gap(time, ("left_shorts", "right_shorts"), "bench") + 0.0005 <= 0.003
    assert move.gap(0.5, ("left_shorts", "right_shorts", "left_hip", "right_hip"), "bench") > 0.05
    on_feet = move.time <= 0.95
    assert np.all(move.centre[on_feet, 0] > move.site("left_heel")[on_feet, 0])
    assert np.all(move.centre[on_feet, 0] < move.site("left_toe")[on_feet, 0])
    lean = np.degrees(np.arccos(move.up("chest")[:, 2]))
    assert 40 <= lean.max() <= 60
    assert lean[-1] <= 5


def test_the_jump_falls_freely_as_high_as_its_take_off_is_fast():
    move = of("jump_over_box")
    air = (move.time >= 0.90) & (move.time <= 1.36)
    time, height = move.time[air], move.centre[air, 2]
    curve = np.polyfit(time - time[0], height, 2)
    assert -2 * curve[0] == pytest.approx(G, rel=0.03)
    assert np.abs(np.polyval(curve, time - time[0]) - height).max() <= 0.003
    rise = height.max() - height[0]
    assert rise == pytest.approx(curve[1] ** 2 / (2 * G), rel=0.05)
    assert 0.12 <= rise <= 0.3
    along = move.centre[air, 0]
    assert np.abs(along - np.polyval(np.polyfit(time, along, 1), time)).max() <= 0.003


def test_the_hand_comes_from_above_and_is_closed_about_the_rail():
    move = of("hand_on_rail")
    hand = ("left_palm", "left_knuckles", "left_index", "left_middle", "left_ring", "left_little", "left_thumb")
    for time in (0.85, 1.2, 1.6, 2.0):
        assert -0.0015 <= move.gap(time, hand, "rail") <= 0.005
    coming = (move.time >= 0.4) & (move.time <= 0.6)
    assert np.all(move.site("left_hand")[coming, 2] > 0.97 + 0.05)
    passed = move.qpos[move.at(2.0), 0] - move.qpos[move.at(0.75), 0]
    assert passed == pytest.approx(0.25, abs=0.01)


def test_the_crate_lies_on_the_floor_is_carried_level_and_stands_on_the_table():
    move = of("carry_box")
    crate, bottom = move.body("crate"), move.body("crate")[:, 2] - 0.17
    lying, standing = move.time <= 4.45, move.time >= 7.25
    for some, height in ((lying, 0.0), (standing, 0.70)):
        np.testing.assert_allclose(bottom[some], height, atol=0.0015)
        assert np.linalg.norm(crate[some, :3] - crate[some][0, :3], axis=1).max() <= 0.0015
    assert np.degrees(2 * np.arccos(np.abs(crate[:, 3]))).max() <= 10
    assert bottom[move.at(6.0)] > 0.70
    assert in_carried(move.clip, move.time[::10], move.qpos[::10])["deepest"] <= 0.005


def test_the_cartwheel_goes_over_left_hand_right_hand_right_foot():
    move = of("cartwheel")
    upside_down = move.at(1.36)
    assert move.up("pelvis")[upside_down, 2] == pytest.approx(-1, abs=1e-6)
    assert move.up("pelvis")[0, 2] > 0.99
    assert move.up("pelvis")[-1, 2] > 0.99
    touching = {name: move.time[move.site(name)[:, 2] < 0.09] for name in ("left_hand", "right_hand")}
    assert 0.79 < touching["left_hand"][0] < touching["right_hand"][0] < 1.36
    assert 1.36 < touching["left_hand"][-1] < touching["right_hand"][-1] < 1.94
    during = slice(move.at(0.99), move.at(1.75))
    for part in ("left_heel", "left_toe", "right_heel", "right_toe"):
        assert move.site(part)[during, 2].min() > 0.05
    legs = [move.site(f"{side}_heel")[upside_down] - move.qpos[upside_down, :3] for side in ("left", "right")]
    straddle = np.degrees(np.arccos(legs[0] @ legs[1] / np.prod(np.linalg.norm(legs, axis=1))))
    assert straddle >= 90


def test_a_clip_whose_keyframes_move_a_little_does_not_whip(monkeypatch):
    shipped.share(monkeypatch)
    monkeypatch.setattr(perturbed, "solved", lambda clip: solving.solve(clip, quiet()))
    section = perturbed.compared(["run_loop"], [0], Effort(quick=True, report=lambda _: None))
    assert [target.met for target in section.targets] == [True] * 3
    (outcome,) = section.data["sets"]
    assert outcome["parts"]["collision.body"] < 1


@pytest.fixture(scope="module")
def measured() -> dict[str, Any]:
    return report(of("run_and_step").clip, of("run_and_step").motion)


def test_feet_cross_the_edge_of_the_step_close_above_it_and_limbs_do_not_whip(measured):
    step, samples = of("run_and_step").clip.context.surfaces[1], of("run_and_step").all()
    assert isinstance(step, Box)
    links = sorted({point.link for point in of("run_and_step").clip.context.points})
    for link in links:
        points = tuple(point for point in of("run_and_step").clip.context.points if point.link == link)
        x, _, z = places_of(points, samples)[0]
        crossing = np.flatnonzero(np.diff(np.sign(x.mean(axis=0) - (step.centre[0] - step.half[0]))) > 0)
        assert crossing.size == 1
        assert 0 < z[:, crossing[0]].min() - (step.centre[2] + step.half[2]) <= 0.12
    before, after = (measured[side]["largest"]["whip"]["amount"] for side in ("before", "after"))
    assert after <= 1.5 * before
    assert measured["after"]["centre of mass displacement, m"]["largest"] <= 0.10
    lengths = np.linalg.norm(samples.q, axis=0)
    assert 0.8 <= lengths.min() <= lengths.max() <= 1.25


def test_in_flight_the_centre_of_mass_falls_freely_and_half_the_force_that_no_contact_can_supply_is_gone(measured):
    before, after = (measured[side]["support"] for side in ("before", "after"))
    assert before["off free fall, g"] >= 0.2 and after["off free fall, g"] <= 0.05
    assert before["upward force in flight, N"] >= 200 and after["upward force in flight, N"] <= 20
    assert after["root mean square"] <= 0.5 * before["root mean square"]
    assert max(measured[side]["keyframe error"] for side in ("before", "after")) <= 1e-12


LIMB = read_data("rail_limb.xml").replace("{ridge}", " ".join(["0 .2 .4 .6 .8 .9 1 .9 .8 .6 .4 .2 0"] * 7))
OBSTACLES = {
    "rail": 'type="capsule" size=".02 .6" euler="90 0 0" pos="0 0 .47"',
    "rock": 'type="mesh" mesh="rock" pos="0 0 .43"',
    "ridge": 'type="hfield" hfield="ridge" pos="0 0 .36"',
}
CLIP = read_data("limb.toml")


@pytest.mark.parametrize("obstacle", OBSTACLES)
def test_a_limb_goes_through_an_obstacle_on_the_raw_spline_and_at_most_two_millimetres_when_solved(
    tmp_path: Path, obstacle: str
):
    (tmp_path / "limb.xml").write_text(LIMB.replace("{obstacle}", OBSTACLES[obstacle]), encoding="utf-8")
    saved, deepest = solving.solve(recordings.from_text(CLIP, name="limb", folder=tmp_path), quiet()), []
    for side in (saved.before, saved):
        run = Sampled.of(side, 1000.0)
        deepest.append(penetration(saved.figure.model, run.time, run.qpos).deepest)
    assert deepest[0] > 0.015
    assert deepest[1] <= 0.002
