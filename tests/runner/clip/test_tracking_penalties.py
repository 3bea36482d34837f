"""What a motion that follows a recording keeps: frames away from keyframes, all of its feet out of the ground."""

import numpy as np
import pytest
import shipped
from figures import figure_of

from dynsplines.clip.tracking.penalties import NEXT_TO, Ground, ground_of, problem
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.recording import RecordedMotion
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.penalty import TrackingPenalty


@pytest.mark.parametrize("beside", [3e-4, -0.004])
def test_no_frame_is_next_to_a_keyframe_and_the_ends_stay(beside):
    solved = shipped.solved("run_loop")
    figure, times = solved.clip.figure, np.linspace(0, 0.7, 43)
    qpos = figure.to_qpos(path_of(solved.motion.timeline).at(times))
    recorded = RecordedMotion.of(figure, times, qpos, exact=True)
    edits = [Frame.key(at, figure.to_qpos(recorded.path.at(np.array([at])))[0]) for at in (0.001, times[20] + beside)]
    frames = problem(TrackingPenalty(recorded), Ground(figure, (), ()), (), times, edits).keys
    at = np.array([frame.time for frame in frames])
    assert (at[0], at[-1]) == (times[0], times[-1])
    inner = np.diff(at[1:])
    assert inner.min() > NEXT_TO
    assert {edit.time for edit in edits} <= set(at)


def test_all_of_a_foot_is_to_stay_out_of_the_ground():
    figure_39 = shipped.solved("run_loop").clip.figure
    ground = ground_of(figure_39, figure_39.model.qpos0[None])
    names = {point.name for point in ground.clear}
    assert {"left_toe_sole", "left_heel_sole", "right_toe_box"} <= names
    assert [(point.name, point.radius) for point in ground.points][:2] == [("left_heel", 0.024), ("left_toe", 0.024)]


def test_geoms_below_the_soles_are_exempt():
    """A shin thicker than its ankle is high: no stance could keep it out."""
    legs = "".join(
        f"""<body name="{side}_shin" pos="0 {y} -.3"><joint name="{side}_knee" axis="0 1 0"/>
        <geom name="{side}_shin" type="capsule" size=".05" fromto="0 0 0 0 0 -.3"/>
        <body name="{side}_foot" pos="0 0 -.3"><joint name="{side}_ankle" axis="0 1 0"/>
        <geom name="{side}_foot" type="box" size=".1 .04 .01" pos=".03 0 -.02"/>
        <site name="{side}_heel" pos="-.07 0 -.03"/><site name="{side}_toe" pos=".13 0 -.03"/></body></body>"""
        for side, y in (("left", 0.1), ("right", -0.1))
    )
    figure = figure_of(
        f"""<mujoco><worldbody><geom type="plane" size="9 9 1"/><body name="trunk" pos="0 0 .63"><freejoint/>
        <geom name="trunk" type="box" size=".1 .1 .1"/>{legs}</body></worldbody></mujoco>"""
    )
    clear = ground_of(figure, figure.model.qpos0[None]).clear
    low = [point for point in clear if point.name == "left_shin" and point.position[2] < -0.29]
    assert not low
    assert {"left_foot", "left_shin", "trunk"} <= {point.name for point in clear}
