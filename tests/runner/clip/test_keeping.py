"""Frames of a motion that follows a recording: none next to a keyframe, for the spline through both would go wild."""

import numpy as np
import pytest
import shipped

from dynsplines.clip.follow.keeping import NEXT_TO, Ground, problem
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.penalty import Near
from dynsplines.solver.reading.recorded import Recorded


@pytest.mark.parametrize("beside", [3e-4, -0.004, 0.02])
def test_no_frame_is_next_to_a_keyframe_and_the_ends_stay(beside):
    solved = shipped.solved("run_loop")
    figure, times = solved.clip.figure, np.linspace(0, 0.7, 43)
    qpos = figure.to_qpos(path_of(solved.motion.timeline).at(times))
    recorded = Recorded.of(figure, times, qpos, exact=True)
    edits = [Frame.key(at, figure.to_qpos(recorded.path.at(np.array([at])))[0]) for at in (0.001, times[20] + beside)]
    frames = problem(Near(recorded), Ground(figure, (), ()), (), times, edits).keys
    at = np.array([frame.time for frame in frames])
    assert (at[0], at[-1]) == (times[0], times[-1])
    inner = np.diff(at[1:])
    assert inner.min() > NEXT_TO
    assert {edit.time for edit in edits} <= set(at)
