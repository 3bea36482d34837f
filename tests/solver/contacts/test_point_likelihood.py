"""How surprising places are of a point that moves: one normal distribution of all of them, by its covariances."""

import numpy as np
import pytest
from densities import log_normal

from dynsplines.solver.contacts.recorded_stances import surprisal
from dynsplines.solver.contacts.thresholds import Thresholds

ADULT = Thresholds()


def covariance(times: np.ndarray, variance: float, first: float) -> np.ndarray:
    """Of a place that begins known to a sample's noise at `first`, at unknown speed, its acceleration white noise."""
    t = times - first
    early, late = np.minimum.outer(t, t), np.maximum.outer(t, t)
    wiener = ADULT.lively * (early**2 * (3 * late - early) / 6)  # twice integrated
    return variance + ADULT.fastest**2 * np.multiply.outer(t, t) + wiener + variance * np.eye(t.size)


@pytest.mark.parametrize("share", [1.0, 0.6])
def test_it_adds_up_to_the_density_of_all_samples_together(rng, share):
    times = np.cumsum(rng.uniform(0.01, 0.06, 14))
    known = rng.random(14) < share
    known[3:5] = True
    places = rng.normal(0, 0.2, (3, 2, 14))
    variance = np.array([0.01, 0.03]) ** 2
    found = surprisal(times, places, variance, known, ADULT)
    first, *later = np.flatnonzero(known)
    for i, own in enumerate(variance):
        whole = covariance(times[later], own, times[first])
        for many in range(1, len(later) + 1):
            off = places[:, i, later[:many]] - places[:, i, [first]]
            assert found[i, : later[many - 1] + 1].sum() == pytest.approx(
                -sum(log_normal(row, whole[:many, :many]) for row in off), rel=1e-9
            )
    assert np.all(found[:, ~known] == 0)
    assert np.all(found[:, first] == 0)


def test_nothing_is_surprising_where_nothing_is_known():
    assert np.all(surprisal(np.arange(4.0), np.zeros((3, 1, 4)), np.ones(1), np.zeros(4, bool), ADULT) == 0)
