"""Loops that do not close, and travel that makes no sense: refused, and told where and by how much."""

from __future__ import annotations

import numpy as np
import pytest
from figures import TINY, figure_of
from hopping_loop import PERIOD, hop

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, TimelineError
from dynsplines.solver.curve.unknowns import raw_timeline


def refused(words: str, change: Array | None = None, travel: list[float] | None = None, ends: str = "periodic") -> None:
    figure = figure_of(TINY)
    keys = hop()
    keys[-1] = Frame.key(PERIOD, keys[-1].state + (0 if change is None else change))
    with pytest.raises(TimelineError, match=words):
        raw_timeline(figure, keys, ends, travel=travel)


def test_a_loop_that_does_not_close_says_where_and_by_how_much():
    one = np.eye(11)
    refused(
        r"\(t = 0\.8 s\) differs from the first at 'root' along z \(with travel = \[0\.6, 0, 0\]\) by 0\.02",
        0.02 * one[2],
    )
    refused(r"at 'root' along x \(with travel = \[0\.5, 0, 0\]\) by 0\.1", travel=[0.5, 0, 0])
    refused(r"at 'root' \(a loop may travel, and turn about the vertical\) by", 0.1 * one[4])
    refused(r"at 'knee' by", 0.1 * one[9])


def test_travel_that_makes_no_sense_is_refused():
    refused("travel is for ends = 'periodic', not 'free'", travel=[1, 0, 0], ends="free")
    refused("three finite numbers", travel=[1, 0])
    refused("three finite numbers", travel=[1, 0, np.nan])
    ball = figure_of('<mujoco><worldbody><body><joint type="ball"/><geom size=".1"/></body></worldbody></mujoco>')
    keys = [Frame.key(t, [1, 0, 0, 0]) for t in (0, 1)]
    with pytest.raises(TimelineError, match="no free joint, so no root to travel"):
        raw_timeline(ball, keys, "periodic", travel=[1, 0, 0])
