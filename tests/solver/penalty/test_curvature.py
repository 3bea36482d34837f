"""The curvature of a residual without one of its own, and predictions of the weak form."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import pytest
from figures import BALL, FLOOR, figure_of
from gradients import RESIDUALS, assert_squares, some_samples
from problems import slider

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Collision, CovariantAcceleration, Normalization, Penalty, RootAcceleration
from dynsplines.solver.penalty.block import Block, Dense, every
from dynsplines.solver.refine.euler_lagrange import WeakForm
from dynsplines.solver.refine.subdivision import midpoints, split
from dynsplines.solver.surface.points import Point


@dataclass(frozen=True)
class BySweeps(CovariantAcceleration):
    """The covariant acceleration without a curvature of its own."""

    def residuals(self, samples: Samples) -> Iterator[Block | Dense]:
        for block in super().residuals(samples):
            yield replace(block, curved=None) if isinstance(block, Dense) else block


def test_the_curvature_of_a_residual_without_one_of_its_own_is_twice_the_square_of_its_jacobian(figure, rng):
    _, residuals = RESIDUALS["covariant"]
    assert_squares(BySweeps(), residuals, some_samples(figure, rng), rng)


class Entry(Penalty):
    """Squares of the first entry of the state and its derivatives."""

    name, normalization = "entry", Normalization(1.0)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        for order, weight in enumerate((20.0, 2.5, 0.15)):
            yield every(samples, np.zeros(1, int), order, weight=weight)


@pytest.mark.parametrize("chosen", [slice(2, 3), slice(None)], ids=["one frame", "frames everywhere"])
def test_the_weak_form_promises_what_a_frame_moved_alone_brings_where_e_is_quadratic(rng, chosen):
    """A slide whose frames do not lie where its energy would have them, with a penalty of y besides."""
    problem = slider(np.linspace(0, 3, 4), 2)
    timeline = problem.timeline
    timeline = timeline.with_rows(timeline.rows + 0.1 * rng.normal(size=timeline.rows.shape))
    terms: list[tuple[Penalty, float]] = [(RootAcceleration(), 1.0), (Entry(), 1.0)]
    objective = Objective.of(problem.objective.figure, terms)
    candidates = midpoints(timeline)[chosen]
    finer, brought = split(timeline, candidates), []
    for row in np.searchsorted(finer.times, candidates):
        values = []
        for by in (-1.0, 0.0, 1.0):
            rows = np.array(finer.rows)
            rows[row] += by
            values.append(objective.value(path_of(finer.with_rows(rows))))
        slope, bent = (values[2] - values[0]) / 2, values[2] - 2 * values[1] + values[0]
        brought.append(slope**2 / (2 * bent))
    promised = WeakForm(objective, path_of(timeline)).decrements(candidates)
    np.testing.assert_allclose(promised, brought, rtol=2e-3)


def test_the_weak_form_ranks_the_segment_that_dips_into_the_floor_first():
    figure = figure_of(BALL)
    heights = [0.5, 0.4, 0.5, 0.12, 0.12, 0.5, 0.4]
    raw = raw_timeline(figure, [Frame.key(float(i), [0, 0, z, 1, 0, 0, 0]) for i, z in enumerate(heights)])
    contact = Collision((Point("ball", 1, np.zeros(3), 0.1),), (FLOOR,))
    objective = Objective.of(figure, [(RootAcceleration(), 1.0), (contact, 50.0)]).renormalise(path_of(raw))
    assert np.argmax(WeakForm(objective, path_of(raw)).decrements(midpoints(raw))) == 3
