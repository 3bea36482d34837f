"""The run-and-step clip, before and after: flights, the step's edge, and what may grow.

The bounds are the product's promises. What the raw spline does shows that these tests can fail.
"""

from typing import Any

import numpy as np
import pytest
from shipped import of

from dynsplines.measure.report import report
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.points import places_of

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def measured() -> dict[str, Any]:
    return report(of("run_and_step").clip, of("run_and_step").motion)


def test_feet_cross_the_edge_of_the_step_close_above_it_and_limbs_do_not_whip(measured):
    step, samples = of("run_and_step").clip.context.surfaces[1], of("run_and_step").all()
    assert isinstance(step, Box)
    links = sorted({point.link for point in of("run_and_step").clip.context.points})
    for link in links:
        points = tuple(point for point in of("run_and_step").clip.context.points if point.link == link)
        x, _, z = places_of(points, samples)[0]
        crossing = np.flatnonzero(np.diff(np.sign(x.mean(axis=0) - (step.centre[0] - step.half[0]))) > 0)
        assert crossing.size == 1
        assert 0 < z[:, crossing[0]].min() - (step.centre[2] + step.half[2]) <= 0.12
    before, after = (measured[side]["largest"]["whip"]["amount"] for side in ("before", "after"))
    assert after <= 1.5 * before
    assert measured["after"]["centre of mass displacement, m"]["largest"] <= 0.10
    lengths = np.linalg.norm(samples.q, axis=0)
    assert 0.8 <= lengths.min() <= lengths.max() <= 1.25


def test_in_flight_the_centre_of_mass_falls_freely_and_half_the_force_that_no_contact_can_supply_is_gone(measured):
    before, after = (measured[side]["support"] for side in ("before", "after"))
    assert before["off free fall, g"] >= 0.2 and after["off free fall, g"] <= 0.05
    assert before["upward force in flight, N"] >= 200 and after["upward force in flight, N"] <= 20
    assert after["root mean square"] <= 0.5 * before["root mean square"]
    assert max(measured[side]["keyframe error"] for side in ("before", "after")) <= 1e-12
