"""The cycle that keyframes tell: its period from few of them, no alias, and nothing where there is none."""

from dataclasses import replace

import numpy as np
import pytest
from figures import EVERY_JOINT, figure_of
from gaits import FIGURE, GROUND, PERIOD, SOLES, TIME, WALK, gait
from walker import FINE

from dynsplines.clip.build import constraints
from dynsplines.clip.context import Context
from dynsplines.clip.parse import chosen
from dynsplines.clip.table import PenaltyTable
from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts.gait_period import SLIP, Gait
from dynsplines.solver.contacts.pose_vectors import PoseVectors
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.kinematics import Samples
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


def sped_up(factor: float, stops: bool = False) -> np.ndarray:
    """The walk, carried along faster than its feet go; if it stops, at a tenth of that in its last quarter."""
    out, step = WALK.copy(), factor * np.diff(WALK[:, 0], prepend=WALK[0, 0])
    if stops:
        step[3 * step.size // 4 :] *= 0.1
    out[:, 0] = np.cumsum(step)
    return out


def test_feet_that_slip_are_believed_where_those_of_other_periods_slip_more_and_the_body_travels_steadily():
    every = 0.42
    gait_cycle = gait(sped_up(2.0), every).infer()
    assert gait_cycle is not None
    assert gait_cycle.slip > SLIP
    assert abs(gait_cycle.period / PERIOD - 1) < 0.05
    assert gait(sped_up(2.0, stops=True), every).infer() is None
    assert gait(sped_up(5.0), every).infer() is None


def test_feet_that_slip_are_not_believed_at_an_unsteady_pace_however_slow():
    poses, every = sped_up(1.5, stops=True), round(0.42 * FINE)
    keys = [Frame.key(1.5 * TIME[k], poses[k]) for k in range(0, TIME.size, every)]
    assert Gait(FIGURE, raw_timeline(FIGURE, keys), SOLES, GROUND).infer() is None


def test_its_poses_are_those_of_the_walk():
    seen = gait(WALK, 0.42)
    gait_cycle = seen.infer()
    assert gait_cycle is not None
    columns = gait_cycle.poses.map.columns.T
    real = WALK[np.round(gait_cycle.times * FINE).astype(int)][:, columns]
    plain = FIGURE.to_qpos(path_of(seen.keys).at(gait_cycle.times))[:, columns]
    assert np.degrees(quat.angle_between(gait_cycle.rotations, real).mean()) < 2
    assert np.degrees(quat.angle_between(plain, real).mean()) > 4


def test_equal_poses_have_no_vectors():
    figure = figure_of(EVERY_JOINT)
    poses = np.tile(figure.model.qpos0, (4, 1))
    poses[:, figure.tables.hinge_columns] = 0.3
    poses[3, figure.tables.hinge_columns[0]] = 0.4
    keys = [Frame.key(0.5 * k, pose) for k, pose in enumerate(poses)]
    assert PoseVectors.of(figure, raw_timeline(figure, keys[:3])) is None
    assert PoseVectors.of(figure, raw_timeline(figure, keys)) is not None


def test_poses_without_a_rhythm_tell_none(rng):
    wild = WALK.copy()
    for columns in FIGURE.tables.quaternion_columns.T[1:]:
        wild[:, columns] = quat.from_rotation_vector(rng.normal(scale=0.5, size=(TIME.size, 3)))
    assert gait(wild, 0.42).infer() is None


def test_a_figure_that_stays_where_it_is_or_climbs_tells_none():
    still, up = WALK.copy(), gait(WALK, 0.42)
    still[:, 0] = 0.0
    assert gait(still, 0.42).infer() is None
    slope = Plane("slope", np.zeros(3), np.array([-0.1, 0, 1]) / np.hypot(0.1, 1))
    assert Gait(FIGURE, up.keys, SOLES, (slope,)).infer() is None


def test_two_keyframes_tell_none_even_if_asked():
    keys = raw_timeline(FIGURE, [Frame.key(TIME[k], WALK[k]) for k in (0, 200)])
    two = Gait(FIGURE, keys, SOLES, GROUND)
    assert two.infer() is two.likeliest() is two.with_period(1.0) is None
    found = constraints(Context.of(FIGURE, keys, GROUND, "two"), chosen([PenaltyTable.of("cycle", period=1.0)], "two"))
    assert "cycle" not in {penalty.name for penalty, _ in found.penalties}
    assert (
        "no cycle: that takes three keyframes that fix every joint, not all alike, and one free joint or none"
        in found.notes
    )


def test_a_figure_that_is_moved_along_in_one_pose_tells_none():
    still = WALK.copy()
    still[:, 2:] = FIGURE.model.qpos0[2:]
    moved = gait(still, 0.5)
    assert moved.infer() is moved.likeliest() is moved.with_period(1.0) is None
    assert gait(WALK, 0.5).likeliest() is not None


def test_a_clip_has_the_cycle_by_itself_or_as_asked_and_not_with_weight_0():
    keys = gait(WALK, 0.42).keys

    def periods(*entries: PenaltyTable) -> list[float]:
        found = constraints(Context.of(FIGURE, keys, GROUND, "walk"), chosen(entries, "walk"))
        return [penalty.gait_cycle.period for penalty, _ in found.penalties if isinstance(penalty, Cycle)]

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
    seen = Gait(FIGURE, raw_timeline(FIGURE, first + keys), SOLES, GROUND)
    gait_cycle = seen.infer()
    assert gait_cycle is not None
    assert abs(gait_cycle.period / PERIOD - 1) < 0.05
    assert gait_cycle.times[0] == TIME[3]
    assert seen._cycle_of_all is None or seen._cycle_of_all.gain < gait_cycle.gain - 0.2
    whole = Gait(FIGURE, raw_timeline(FIGURE, keys), SOLES, GROUND).infer()
    assert whole is not None
    assert whole.times[0] == TIME[3]


def test_where_the_cycle_is_not_told_it_asks_for_nothing():
    gait_cycle = gait(WALK, 0.42).infer()
    assert gait_cycle is not None
    late = replace(gait_cycle, times=gait_cycle.times + 1.0)
    t = np.array([gait_cycle.times[0], late.times[0], late.times[-1], late.times[-1] + 0.1])
    y = np.repeat(FIGURE.to_state(FIGURE.model.qpos0[None]), t.size, axis=0)
    values = Cycle(FIGURE, late).evaluate(Samples(FIGURE, y, 0 * y, 0 * y, t=t))
    assert values[0] == values[-1] == 0
    assert np.all(values[1:3] > 0)
