"""What segments are split by: their shares of E, and how far they are from a finer optimum."""

from __future__ import annotations

import numpy as np
import pytest
from even_frames import evenly
from hinged import PENALTIES, hinge_keys, hinged

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature, gauss_nodes
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.objective import Objective
from dynsplines.solver.refine.subdivision import CRITERIA, by_objective, by_resolution, midpoints, split
from dynsplines.solver.search.descent import optimised


@pytest.fixture(params=[1, 2])
def problem(request, rng) -> tuple[Objective, Timeline]:
    """Variable frames that are off where they should be."""
    figure = hinged()
    timeline = evenly(raw_timeline(figure, hinge_keys()), request.param)
    off = 0.2 * rng.normal(size=timeline.states.shape) * ~timeline.fixed
    frames = Frame.many(timeline.times, timeline.states + off, timeline.fixed)
    timeline = Timeline(tuple(frames), timeline.end_slope, timeline.ends)
    return Objective.of(figure, PENALTIES, quadrature=Quadrature(points=6)), timeline


@pytest.mark.parametrize("name", CRITERIA)
def test_every_segment_has_a_score_of_its_own(name, problem):
    objective, timeline = problem
    scores = CRITERIA[name](objective, timeline)
    assert scores.shape == (timeline.times.size - 1,)
    assert np.all(scores >= 0)
    assert scores.max() > 0


def test_the_segments_shares_add_up_to_e(problem):
    objective, timeline = problem
    assert by_objective(objective, timeline).sum() == pytest.approx(objective.value(path_of(timeline)), rel=1e-9)


def test_how_far_a_segment_is_from_a_finer_optimum_is_the_integral_of_that_distance(problem):
    objective, timeline = problem
    fine = path_of(optimised(objective, split(timeline, midpoints(timeline))))
    t, w = gauss_nodes(np.asarray(timeline.times), 200)
    apart = w * np.linalg.norm(path_of(timeline).at(t) - fine.at(t), axis=1)
    expected = apart.reshape(-1, 200).sum(axis=1)
    np.testing.assert_allclose(by_resolution(objective, timeline), expected, atol=0.05 * expected.max())
