"""How far a path is from the optimum: every segment solved by itself, put together by hand and summed finely."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from even_frames import evenly
from hinged import PENALTIES, hinge_keys, hinged
from paper.displacement import NODES, displacement
from paper.orientations import INTRINSIC, Case

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.quadrature import Quadrature, gauss_nodes
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Torque
from dynsplines.solver.refine.euler_lagrange import residual
from dynsplines.solver.search.descent import optimised

TERMS = [*PENALTIES, (Torque(), 0.02)]  # for which no cubic is an optimum, as it is without


@pytest.fixture
def shaken(rng) -> tuple[Objective, Timeline]:
    """A timeline whose variable frames are off where they should be; a quadrature that segments do not have."""
    timeline = evenly(raw_timeline(hinged(), hinge_keys()[:3]), 1)
    off = 0.2 * rng.normal(size=timeline.states.shape) * ~timeline.fixed
    frames = Frame.many(timeline.times, timeline.states + off, timeline.fixed)
    timeline = Timeline(tuple(frames), timeline.end_slope, timeline.ends)
    return Objective.of(hinged(), TERMS, quadrature=Quadrature("uniform", 400)), timeline


@pytest.mark.parametrize("variable", [1, 3])
def test_every_segment_is_compared_with_its_own_optimum_between_places_and_speeds_that_are_held(variable, shaken):
    objective, timeline = shaken
    path = path_of(timeline)
    found = displacement(objective, timeline, variable=variable, tolerance=1e-12)
    local = Objective.of(objective.figure, TERMS, quadrature=Quadrature("gauss", 5))
    density = residual(objective, path)
    for i, (a, b) in enumerate(pairwise(timeline.times)):
        times = np.linspace(a, b, variable + 2)
        ends = [Frame.key(t, path.at(np.array([t]))[0]) for t in (a, b)]
        inner = [Frame.variable(t, path.at(np.array([t]))[0]) for t in times[1:-1]]
        alone = Timeline((ends[0], *inner, ends[1]), path.at(np.array([a, b]), 1), "clamped")
        better = optimised(local, alone, tolerance=1e-12)
        t, w = gauss_nodes(np.array([a, b]), NODES)
        apart = np.linalg.norm(path.at(t) - path_of(better).at(t), axis=1)
        saved = local.value(path_of(alone)) - local.value(path_of(better))
        assert found.distance[i] == pytest.approx(w @ apart, rel=1e-3)
        assert found.reduction[i] == pytest.approx(saved, rel=1e-3)
        level = np.interp(t, density.t[i], density.size[i])
        assert found.gap[i] == pytest.approx(w @ (apart * level), rel=1e-3)
        assert 0 < found.reduction[i] < found.gap[i]


@pytest.mark.slow
def test_the_distance_to_the_local_optimum_shrinks_as_variable_frames_are_added() -> None:
    one, three = (Case(0).solved(INTRINSIC, variable) for variable in (1, 3))
    found = [displacement(one.objective, timeline) for timeline in (one.raw, one.timeline, three.timeline)]
    total = [d.distance.sum() for d in found]
    assert total[0] > 3 * total[1] > 9 * total[2] > 0
    for d in found:
        assert np.all(d.reduction > -1e-9)
        assert np.all(d.gap >= 0.9 * d.reduction)
