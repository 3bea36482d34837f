"""How long a search goes on that nobody tells how long."""

from __future__ import annotations

from collections.abc import Callable

import mujoco
import numpy as np
import pytest
from figures import ONE_BALL

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import UnitMagnitude
from dynsplines.solver.search import descent


@pytest.mark.parametrize(("whole", "tolerance"), [(False, 1e-6), (True, 1e-7)])
def test_by_default_a_search_ends_at_a_millionth_and_at_the_nearest_minimum_at_a_tenth_of_it(
    monkeypatch: pytest.MonkeyPatch, whole: bool, tolerance: float
) -> None:
    asked = {}

    def seen(optimiser: object, problem: object, **options: object) -> None:
        asked.update(options)
        raise KeyboardInterrupt

    monkeypatch.setattr(descent.GaussNewton, "__call__", seen)
    figure = Figure(mujoco.MjModel.from_xml_string(ONE_BALL))
    timeline = raw_timeline(figure, [Frame.key(float(t), np.array(figure.model.qpos0)) for t in range(2)])
    objective = Objective.of(figure, ((UnitMagnitude(), 1.0),))
    search: Callable[[], object] = descent.Descent(objective, timeline).run
    with pytest.raises(KeyboardInterrupt):
        descent.optimised(objective, timeline) if whole else search()
    assert (asked["tolerance"], asked["max_evaluations"]) == (tolerance, 300)
