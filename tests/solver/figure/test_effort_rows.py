"""Jacobian rows of joints' efforts and of the root's wrench, on figures of any joints, against adjoint sweeps."""

from __future__ import annotations

import numpy as np
import pytest
from closed_forms import WOOD, assert_near
from figures import figure_of, with_armature
from random_model import random_figure
from random_samples import random_samples

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.adjoint import Cotangent
from dynsplines.solver.figure.effort_rows import Pushes, joint_rows, wrench_rows
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.root_wrench import RootWrench
from dynsplines.solver.figure.turns import turning
from dynsplines.solver.penalty import Torque
from dynsplines.solver.penalty.curvature import jacobian

SEEDS = range(12)


def some_pushes(samples: Samples, root: int, rng: np.random.Generator) -> Pushes:
    """On links of one root's tree, two at one sample and link."""
    link = rng.choice(np.flatnonzero(samples.figure.tables.path[:, root]), 7)
    at = np.sort(rng.integers(0, samples.count, 7))
    link[1], at[1] = link[0], at[0]
    return Pushes(at, link, rng.normal(0, 0.1, (3, 7)), rng.normal(0, 50, (3, 7)))


def swept(samples: Samples, root: int, pushes: Pushes | None) -> Array:
    """The wrench's rows by one adjoint sweep each, (S, 6, 3, N)."""
    at = np.repeat(np.arange(samples.count), 6)

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        bars = np.zeros((2, 3, rows.size))
        bars[rows % 6 // 3, rows % 3, np.arange(rows.size)] = 1.0
        wrench = RootWrench(copies, root)
        if pushes is None:
            wrench.pull_back(cotangent, bars[0], bars[1])
            return
        push, copy = np.nonzero(pushes.at[:, None] == at[rows])  # every row's own copy gets its sample's
        own = Pushes(copy, pushes.link[push], pushes.offset[:, push], pushes.force[:, push])
        own.pull_back(wrench, cotangent, bars[0], bars[1])

    return jacobian(samples, at, seeded).reshape(samples.count, 6, 3, -1)


def check_wrench(figure: Figure, rng: np.random.Generator) -> int:
    """Compares those of every free root; how many there are."""
    samples, roots = random_samples(figure, rng), figure.tables.free_links
    for root in roots:
        for pushes in (None, some_pushes(samples, root, rng)):
            wrench = RootWrench(samples, root)
            found = wrench_rows(wrench, pushes)
            assert_near(found, swept(samples, root, pushes), 1e-10)
            assert_near(wrench_rows(wrench, pushes, moment=False), found[:, :3], 1e-12)
    return roots.size


def check_efforts(figure: Figure, rng: np.random.Generator) -> int:
    """Compares the rows of all joints' efforts with sweeps of the torque; how many there are."""
    samples = random_samples(figure, rng)
    (efforts,) = Torque().residuals(samples)
    count = len(efforts.value)
    at = np.repeat(np.arange(samples.count), count)

    def seeded(copies: Samples, cotangent: Cotangent, rows: Index) -> None:
        bar = np.zeros((count, rows.size))
        bar[rows % count, np.arange(rows.size)] = 1.0
        (own,) = Torque().residuals(copies)
        own.pulled_back(cotangent, bar)

    if count:
        expected = jacobian(samples, at, seeded).reshape(samples.count, count, 3, -1)
        assert_near(joint_rows(samples), expected, 1e-10)
    return count


def test_rows_are_those_of_the_adjoint_sweep(figure, rng):
    assert check_wrench(figure, rng) == figure.tables.free_links.size > 0
    assert check_efforts(figure, rng) > 0
    assert check_efforts(with_armature(figure, rng), rng) > 0


@pytest.mark.parametrize("coordinates", ["auto", "joint"])
def test_so_they_are_on_random_models(coordinates):
    assert sum(check_wrench(*random_figure(seed, coordinates)) for seed in SEEDS) > 5
    assert sum(check_efforts(*random_figure(seed, coordinates)) for seed in SEEDS) > 50


def test_so_they_are_where_quaternions_in_the_world_follow_each_other(rng):
    figure = figure_of(WOOD, "world")
    assert not np.array_equal(turning(figure), figure.tables.beyond)
    assert check_wrench(figure, rng) == 2
    assert check_efforts(figure, rng) == 3 * figure.tables.ball_links.size
