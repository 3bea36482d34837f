"""The shipped moves about things: sitting down, a jump over a box, a hand on a rail, a crate carried, a cartwheel.
MuJoCo measures them.

Every figure is of the solved motion between its keyframes, beside that of the raw spline where that shows what it is
good for.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
import pytest
import shipped

from dynsplines.clip import load as clips
from dynsplines.clip.load import Clip
from dynsplines.clip.text import tables, written
from dynsplines.edit.edits import retimed_tables
from dynsplines.measure.hold_report import in_carried
from dynsplines.measure.penetration import penetration
from dynsplines.motion import continuous, sampled
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.penalty import BendLimits
from dynsplines.solver.solution import Solution

RATE = 500.0
G = 9.81

# site, from and to [s] of everything that rests
RESTS = {
    "sit_down": [(f"{side}_{part}", 0.0, 1.9) for side in ("left", "right") for part in ("heel", "toe")],
    "jump_over_box": [
        (f"{side}_{part}", first, last)
        for side in ("left", "right")
        for part in ("heel", "toe")
        for first, last in ((0.0, 0.55), (1.38, 2.3))
    ],
    "hand_on_rail": [
        ("left_hand", 0.80, 2.0),
        ("left_heel", 0.0, 0.42),
        ("left_toe", 0.0, 0.70),
        ("right_heel", 0.80, 2.0),
        ("right_toe", 1.1, 2.0),
        ("left_heel", 1.45, 2.0),
        ("left_toe", 1.45, 2.0),
    ],
    "carry_box": [
        ("left_heel", 0.0, 0.36),
        ("left_toe", 0.0, 0.62),
        ("right_heel", 0.74, 1.0),
        ("right_toe", 1.0, 1.28),
        ("left_heel", 1.38, 1.64),
        ("left_toe", 1.64, 1.94),
        ("right_heel", 1.98, 2.32),
        ("right_toe", 1.98, 2.60),
        ("left_heel", 2.64, 6.0),
        ("left_toe", 2.64, 6.24),
        ("right_heel", 3.24, 5.62),
        ("right_toe", 3.24, 5.62),
        ("right_heel", 6.36, 8.15),
        ("right_toe", 6.62, 8.15),
        ("left_heel", 6.90, 8.15),
        ("left_toe", 6.90, 8.15),
    ],
    "cartwheel": [
        ("left_hand", 0.60, 0.98),
        ("right_hand", 0.92, 1.30),
        ("right_heel", 0.0, 0.19),
        ("right_toe", 0.0, 0.36),
        ("left_heel", 0.40, 0.46),
        ("left_toe", 0.40, 0.58),
        ("right_toe", 1.32, 1.50),
        ("right_heel", 1.44, 1.50),
        ("left_toe", 1.54, 1.90),
        ("left_heel", 1.71, 1.90),
    ],
}
RAW_DEPTH = {  # [m] at least, before
    "sit_down": 0.02,
    "jump_over_box": 0.1,
    "hand_on_rail": 0.02,
    "carry_box": 0.02,
    "cartwheel": 0.02,
}


@dataclass(frozen=True)
class Move:
    clip: Clip
    motion: Solution

    @cached_property
    def time(self) -> Array:
        first, last = self.clip.keys[0].time, self.clip.keys[-1].time
        return np.linspace(first, last, round((last - first) * RATE) + 1)

    @cached_property
    def qpos(self) -> Array:
        return continuous(self.clip.figure, self.motion.at(self.time))

    @cached_property
    def scene(self) -> mujoco.MjModel:
        return self.clip.figure.model

    @cached_property
    def _seen(self) -> tuple[Array, Array, Array]:
        """Sites (T, n, 3), the centre of mass (T, 3) and bodies' upward axes (T, b, 3) at all times."""
        data, sites, centre, up = mujoco.MjData(self.scene), [], [], []
        for qpos in self.qpos:
            data.qpos[:] = qpos
            mujoco.mj_kinematics(self.scene, data)
            mujoco.mj_comPos(self.scene, data)
            sites.append(data.site_xpos.copy())
            centre.append(data.subtree_com[1].copy())
            up.append(data.xmat.reshape(-1, 3, 3)[:, :, 2].copy())
        return np.array(sites), np.array(centre), np.array(up)

    def site(self, name: str) -> Array:
        """(T, 3) [m]"""
        return self._seen[0][:, self.scene.site(name).id]

    @property
    def centre(self) -> Array:
        """(T, 3) [m] of mass."""
        return self._seen[1]

    def up(self, body: str) -> Array:
        """(T, 3) a body's upward axis."""
        return self._seen[2][:, self.scene.body(body).id]

    def at(self, time: float) -> int:
        return int(np.argmin(np.abs(self.time - time)))

    def on(self, body: str, site: str, *, raw: bool = False) -> Array:
        """(T, 3) [m] where a site is on a body, in its axes, at all times."""
        data, out = mujoco.MjData(self.scene), []
        path = path_of(self.motion.raw if raw else self.motion.timeline)
        for qpos in self.clip.figure.to_qpos(path.at(self.time)):
            data.qpos[:] = qpos
            mujoco.mj_kinematics(self.scene, data)
            held = data.body(body)
            out.append(held.xmat.reshape(3, 3).T @ (data.site(site).xpos - held.xpos))
        return np.array(out)

    def body(self, name: str) -> Array:
        """(T, 7) place [m] and rotation of a body with a free joint."""
        start = int(self.scene.joint(name).qposadr[0])
        return self.qpos[:, start : start + 7]

    def gap(self, time: float, words: tuple[str, ...], obstacle: str) -> float:
        """The least distance [m] of geoms whose names begin with some words from an obstacle."""
        data = mujoco.MjData(self.scene)
        data.qpos[:] = self.qpos[self.at(time)]
        mujoco.mj_kinematics(self.scene, data)
        own = [g for g in range(self.scene.ngeom) if self.scene.geom(g).name.startswith(words)]
        solid = self.scene.geom(obstacle).id
        return min(mujoco.mj_geomDistance(self.scene, data, geom, solid, 1.0, None) for geom in own)

    def deepest(self, *, raw: bool = False) -> float:
        run = sampled(self.clip.figure, self.motion.raw if raw else self.motion.timeline, RATE)
        return penetration(self.scene, run.time, run.qpos).deepest


_SOLVED: dict[str, Move] = {}


def solved(name: str) -> Move:
    """A shipped clip, solved once."""
    if name not in _SOLVED:
        done = shipped.solved(name)
        _SOLVED[name] = Move(done.clip, done.motion)
    return _SOLVED[name]


@pytest.fixture(params=RESTS)
def move(request: pytest.FixtureRequest) -> Move:
    return solved(request.param)


@pytest.mark.slow
def test_nothing_goes_deeper_than_a_millimetre_and_a_half_into_what_the_raw_spline_runs_into(move):
    assert move.deepest(raw=True) >= RAW_DEPTH[move.clip.name]
    assert move.deepest() <= 0.0015


@pytest.mark.slow
def test_keyframes_are_met_exactly(move):
    reached = move.motion.at([key.time for key in move.clip.keys])
    for key, qpos in zip(move.clip.keys, reached, strict=True):
        wanted = np.array(key.state)
        for columns in move.clip.figure.tables.quaternion_columns.T:
            wanted[columns] *= np.sign(wanted[columns] @ qpos[columns]) / np.linalg.norm(wanted[columns])
        np.testing.assert_allclose(qpos[key.fixed], wanted[key.fixed], atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hand_on_rail", "jump_over_box"])
def test_at_another_speed_contacts_and_flights_keep_their_place_in_the_move(name):
    move = solved(name)
    said = tables(clips.table_of(move.clip.text, move.clip.name))
    fast = clips.from_text(written(retimed_tables(said, 2.0)), name="fast")
    assert fast.keys[-1].time == pytest.approx(move.clip.keys[-1].time / 2)
    table, own = clips.table_of(fast.text, "fast"), clips.table_of(move.clip.text, "own")
    assert [(c.start, c.end) for c in table.contact] == [(c.start / 2, c.end / 2) for c in own.contact]
    assert fast.context.support is not None and move.clip.context.support is not None
    np.testing.assert_allclose(fast.context.support.flights, np.array(move.clip.context.support.flights) / 2)


@pytest.mark.slow
def test_knees_and_elbows_bend_the_right_way(move):
    samples = move.motion.objective.samples(move.motion.path, move.time)
    flexion, sideways, twist = np.degrees(BendLimits(move.clip.context.bends).angles(samples))
    assert flexion.min() >= -0.5
    assert np.abs(sideways).max() <= 9
    assert np.abs(twist).max() <= 9


@pytest.mark.slow
def test_what_stands_or_holds_stays_in_its_place(move):
    for name, first, last in RESTS[move.clip.name]:
        during = (move.time >= first) & (move.time <= last)
        place = move.site(name)[during]
        away = np.linalg.norm(place - np.median(place, axis=0), axis=1).max()
        assert away <= 0.008, f"{name} moves by {1000 * away:.1f} mm from {first} to {last} s"


@pytest.mark.slow
def test_sitting_down_ends_on_the_bench_and_the_weight_is_over_the_feet_until_shortly_before():
    move = solved("sit_down")
    for time in (1.3, 1.6, 1.9):
        assert 0 <= move.gap(time, ("left_shorts", "right_shorts"), "bench") + 0.0005 <= 0.003
    assert move.gap(0.5, ("left_shorts", "right_shorts", "left_hip", "right_hip"), "bench") > 0.05
    on_feet = move.time <= 0.95
    assert np.all(move.centre[on_feet, 0] > move.site("left_heel")[on_feet, 0])
    assert np.all(move.centre[on_feet, 0] < move.site("left_toe")[on_feet, 0])
    lean = np.degrees(np.arccos(move.up("chest")[:, 2]))
    assert 40 <= lean.max() <= 60
    assert lean[-1] <= 5


@pytest.mark.slow
def test_the_jump_falls_freely_as_high_as_its_take_off_is_fast():
    move = solved("jump_over_box")
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


@pytest.mark.slow
def test_both_feet_go_over_the_top_of_the_box_together():
    move = solved("jump_over_box")
    front, back, top = 0.535, 0.785, 0.30
    for part in ("heel", "toe"):
        left, right = move.site(f"left_{part}"), move.site(f"right_{part}")
        np.testing.assert_allclose(left[:, [0, 2]], right[:, [0, 2]], atol=0.005)
        over = (left[:, 0] >= front) & (left[:, 0] <= back)
        assert over.sum() > 10
        assert left[over, 2].min() > top + 0.03
        assert np.abs(left[over, 1]).max() < 0.4


@pytest.mark.slow
def test_the_hand_comes_from_above_and_is_closed_about_the_rail():
    move = solved("hand_on_rail")
    hand = ("left_palm", "left_knuckles", "left_index", "left_middle", "left_ring", "left_little", "left_thumb")
    for time in (0.85, 1.2, 1.6, 2.0):
        assert -0.0015 <= move.gap(time, hand, "rail") <= 0.005
    coming = (move.time >= 0.4) & (move.time <= 0.6)
    assert np.all(move.site("left_hand")[coming, 2] > 0.97 + 0.05)
    passed = move.qpos[move.at(2.0), 0] - move.qpos[move.at(0.75), 0]
    assert passed == pytest.approx(0.25, abs=0.01)


@pytest.mark.slow
def test_the_hands_keep_their_place_on_the_crate_to_a_tenth_of_what_they_may():
    move = solved("carry_box")
    for hold in move.clip.context.holds:
        during = (move.time >= hold.first) & (move.time <= hold.last)
        for raw in (True, False):
            track = move.on("crate", hold.point.name, raw=raw)[during]
            moved = np.linalg.norm(track - track[0], axis=1).max()
            assert moved >= 0.01 if raw else moved <= 0.0003


@pytest.mark.slow
def test_the_crate_lies_on_the_floor_is_carried_level_and_stands_on_the_table():
    move = solved("carry_box")
    crate, bottom = move.body("crate"), move.body("crate")[:, 2] - 0.17
    lying, standing = move.time <= 4.45, move.time >= 7.25
    for some, height in ((lying, 0.0), (standing, 0.70)):
        np.testing.assert_allclose(bottom[some], height, atol=0.0015)
        assert np.linalg.norm(crate[some, :3] - crate[some][0, :3], axis=1).max() <= 0.0015
    assert np.degrees(2 * np.arccos(np.abs(crate[:, 3]))).max() <= 10
    assert bottom[move.at(6.0)] > 0.70
    assert in_carried(move.clip, move.time[::10], move.qpos[::10])["deepest"] <= 0.005


@pytest.mark.slow
def test_three_steps_and_a_quarter_turn_lead_to_the_crate_and_the_legs_lift_it():
    move = solved("carry_box")
    heading = np.degrees(np.unwrap(2 * np.arctan2(move.qpos[:, 6], move.qpos[:, 3])))
    assert heading[0] == pytest.approx(-90, abs=0.1) and np.abs(heading[move.time >= 3.2]).max() <= 6
    landings = [move.site(f"{side}_heel")[move.at(t), 1] for side, t in (("right", 0.8), ("left", 1.5), ("right", 2.1))]
    assert np.all(np.diff([1.39, *landings]) < -0.3)
    squat, upright = move.at(4.45), move.at(5.7)
    assert move.qpos[squat, 2] < 0.5 and move.qpos[upright, 2] > 0.9
    assert move.up("chest")[squat, 2] > np.cos(np.radians(60)) and move.up("chest")[upright, 2] > 0.99
    flexion = np.degrees(
        BendLimits(move.clip.context.bends).angles(move.motion.objective.samples(move.motion.path, move.time))
    )
    knees = [i for i, bend in enumerate(move.clip.context.bends) if "knee" in bend.name]
    assert flexion[0][knees, squat].min() > 90
    assert np.ptp(flexion[0][knees, squat]) <= 3


@pytest.mark.slow
def test_the_cartwheel_goes_over_left_hand_right_hand_right_foot():
    move = solved("cartwheel")
    upside_down = move.at(0.95)
    assert move.up("pelvis")[upside_down, 2] == pytest.approx(-1, abs=1e-6)
    assert move.up("pelvis")[0, 2] > 0.99
    assert move.up("pelvis")[-1, 2] > 0.99
    touching = {name: move.time[move.site(name)[:, 2] < 0.09] for name in ("left_hand", "right_hand")}
    assert 0.55 < touching["left_hand"][0] < touching["right_hand"][0] < 0.95
    assert 0.95 < touching["left_hand"][-1] < touching["right_hand"][-1] < 1.35
    during = slice(move.at(0.69), move.at(1.22))
    for part in ("left_heel", "left_toe", "right_heel", "right_toe"):
        assert move.site(part)[during, 2].min() > 0.05
    legs = [move.site(f"{side}_heel")[upside_down] - move.qpos[upside_down, :3] for side in ("left", "right")]
    straddle = np.degrees(np.arccos(legs[0] @ legs[1] / np.prod(np.linalg.norm(legs, axis=1))))
    assert straddle >= 90


@pytest.mark.slow
def test_the_cartwheels_second_half_is_the_first_one_backwards_and_mirrored():
    move = solved("cartwheel")
    swapped = {"left_hand": "right_hand", "left_toe": "right_toe", "right_heel": "left_heel"}
    for one, other in swapped.items():
        there = move.site(other)[::-1] * [-1, 1, 1] + [2 * 1.49, 0, 0]
        np.testing.assert_allclose(move.site(one), there, atol=0.04)
