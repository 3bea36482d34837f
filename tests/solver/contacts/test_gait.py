"""Gait cycles, their periods, and steps."""

from pathlib import Path

import figures
import mujoco
import numpy as np
import pytest
from motions import FIGURE, FINE, GROUND, PERIOD, SOLES, TIME, WALK, gait

from dynsplines import Keyframe, build, load
from dynsplines.clip.build import Clip, constraints
from dynsplines.clip.contacts import schedule_of
from dynsplines.clip.context import Context
from dynsplines.clip.parse import options_of
from dynsplines.clip.table import PenaltyTable
from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts.gait import SLIP, Gait
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.penalty import Cycle
from dynsplines.solver.surface import Plane


def facing(angle: float, rate: float = 0.0) -> np.ndarray:
    """The walk on a line that way, or on a circle at a rate [rad/s]."""
    out, way = WALK.copy(), angle + rate * TIME
    step = np.diff(WALK[:, 0], prepend=0.0)
    out[:, 0], out[:, 1] = np.cumsum(step * np.cos(way)), np.cumsum(step * np.sin(way))
    turn = quat.from_rotation_vector(np.outer(way, [0.0, 0, 1]))
    out[:, 3:7] = quat.product(turn, WALK[:, 3:7])
    return out


@pytest.mark.parametrize("every", [0.3, 0.7, 1.0])
def test_a_walks_period_is_found_even_from_keyframes_two_steps_apart(every):
    gait_cycle = gait(WALK, every).infer()
    assert gait_cycle is not None
    assert abs(gait_cycle.period / PERIOD - 1) < 0.05
    assert gait_cycle.slip < SLIP / 1.3


def test_it_does_not_matter_which_way_the_figure_walks():
    gait_cycle = gait(facing(-1.0, 0.4), 0.42).infer()
    assert gait_cycle is not None
    assert abs(gait_cycle.period / PERIOD - 1) < 0.05


def test_its_poses_are_those_of_the_walk():
    seen = gait(WALK, 0.42)
    gait_cycle = seen.infer()
    assert gait_cycle is not None
    columns = gait_cycle.poses.map.columns.T
    real = WALK[np.round(gait_cycle.times * FINE).astype(int)][:, columns]
    plain = FIGURE.to_qpos(path_of(seen.keys).at(gait_cycle.times))[:, columns]
    assert np.degrees(quat.angle_between(gait_cycle.rotations, real).mean()) < 2
    assert np.degrees(quat.angle_between(plain, real).mean()) > 4


def test_poses_without_a_rhythm_tell_none(rng):
    wild = WALK.copy()
    for columns in FIGURE.tables.quaternion_columns.T[1:]:
        wild[:, columns] = quat.from_rotation_vector(rng.normal(scale=0.5, size=(TIME.size, 3)))
    assert gait(wild, 0.42).infer() is None
    for qpos, better in ((WALK, True), (wild, False)):
        gait_cycle = gait(qpos, 0.42).with_period(PERIOD)
        assert gait_cycle is not None and (gait_cycle.gain > 0) == better  # than a smooth motion


def test_a_figure_that_stays_where_it_is_or_climbs_tells_none():
    still, up = WALK.copy(), gait(WALK, 0.42)
    still[:, 0] = 0.0
    assert gait(still, 0.42).infer() is None
    slope = Plane("slope", np.zeros(3), np.array([-0.1, 0, 1]) / np.hypot(0.1, 1))
    assert Gait(KeyframePoints.of(FIGURE, up.keys, SOLES, (slope,))).infer() is None


def test_a_clip_has_the_cycle_by_itself_or_as_asked_and_not_with_weight_0():
    keys = gait(WALK, 0.42).keys

    def periods(*entries: PenaltyTable) -> list[float]:
        _, penalties, _ = constraints(
            Context(schedule_of(FIGURE, keys, GROUND, "walk"), "walk"), options_of(entries, "walk")
        )
        return [penalty.gait_cycle.period for penalty, _ in penalties if isinstance(penalty, Cycle)]

    assert periods() == pytest.approx([PERIOD], rel=0.05)
    assert periods(PenaltyTable.of("cycle", period=0.9)) == [0.9]
    assert periods(PenaltyTable.of("cycle")) == pytest.approx([PERIOD], rel=0.05)
    assert periods(PenaltyTable.of("cycle", weight=0)) == []


def test_a_pose_to_set_out_from_stands_outside_the_cycle():
    before = np.array(WALK)
    before[:3, 7:] = FIGURE.model.qpos0[7:]  # at rest, and a tenth of a second later in full stride
    turned = FIGURE.tables.quaternion_columns.T[1:]
    for columns in turned[: len(turned) // 2]:
        before[:3, columns] = quat.from_rotation_vector(np.array([1.2, 0, 0]))
    first = [Frame.key(TIME[0], before[0])]
    keys = [Frame.key(TIME[k], WALK[k]) for k in range(3, TIME.size, round(0.42 * FINE))]
    seen = Gait(KeyframePoints.of(FIGURE, raw_timeline(FIGURE, first + keys), SOLES, GROUND))
    gait_cycle = seen.infer()
    assert gait_cycle is not None
    assert abs(gait_cycle.period / PERIOD - 1) < 0.05
    assert gait_cycle.times[0] == TIME[3]
    assert seen._cycle_of_all is None or seen._cycle_of_all.gain < gait_cycle.gain - 0.2
    whole = Gait(KeyframePoints.of(FIGURE, raw_timeline(FIGURE, keys), SOLES, GROUND)).infer()
    assert whole is not None
    assert whole.times[0] == TIME[3]


def placing(clip: Clip) -> set[str]:
    """The names of the links whose joints place a foot."""
    steps = clip.context.schedule.steps
    return {link.name for link, places in zip(clip.figure.links, steps.placing.tolist(), strict=True) if places}


def test_hips_and_knees_of_a_person_place_a_foot():
    assert placing(load("run_and_step")) == {"left_hip", "right_hip", "left_knee", "right_knee"}


@pytest.mark.parametrize(
    ("text", "others"),
    [(figures.BIPED, "_ankle_roll"), (figures.QUADRUPED, "trunk")],
    ids=["feet with several points", "feet that are points"],
)
def test_every_joint_of_a_leg_places_a_foot_unless_it_only_turns_one(text: str, others: str, tmp_path: Path):
    (tmp_path / "walker.xml").write_text(text, encoding="utf-8")
    model = mujoco.MjModel.from_xml_string(text)
    clip = build(str(tmp_path / "walker.xml"), [Keyframe(t, qpos=model.qpos0) for t in (0.0, 1.0)])
    elsewhere = ("world", "root", "waist", "shoulder", "elbow", others)
    expected = {link.name for link in clip.figure.links if not any(part in link.name for part in elsewhere)}
    assert placing(clip) == expected and len(expected) >= 10
