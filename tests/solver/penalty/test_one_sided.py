"""One-sided residuals, against the matrix of their gradients."""

from __future__ import annotations

import numpy as np
import pytest
from figures import TINY, figure_of
from random_samples import random_samples

from dynsplines.solver.penalty import one_sided
from dynsplines.solver.penalty.block import Block, Entries
from dynsplines.solver.penalty.one_sided import OneSidedResiduals

SAMPLES, WIDTH = 5, 7


def residuals_at(rng: np.random.Generator, at: list[int]) -> OneSidedResiduals:
    return OneSidedResiduals(np.array(at, int), rng.normal(size=len(at)), rng.normal(size=(len(at), WIDTH)))


@pytest.mark.parametrize("at_once", [2 * WIDTH, 10**6])
@pytest.mark.parametrize("at", [[0, 0, 3, 4], [4, 1, 1, 0, 4], []])
def test_what_a_change_moves_and_forces_pull_back_are_the_matrix_and_its_transpose(at_once, at, rng, monkeypatch):
    monkeypatch.setattr(one_sided, "ENTRIES_AT_ONCE", at_once)
    change, sides = rng.normal(size=(SAMPLES, WIDTH)), residuals_at(rng, at)
    np.testing.assert_allclose(sides.moved(change), np.sum(sides.rows * change[sides.at], axis=1), rtol=1e-12)
    forces = rng.normal(size=len(at))
    for pushed in (forces, forces * (np.arange(len(at)) % 2), 0 * forces):
        pulled, expected = np.ones((2, SAMPLES, WIDTH))
        np.add.at(expected, sides.at, pushed[:, None] * sides.rows)
        sides.pull_back(pushed, pulled)
        np.testing.assert_allclose(pulled, expected, atol=1e-13)


def test_weights_of_a_block_are_in_its_residuals_and_their_rows(rng):
    figure, at, column = figure_of(TINY), np.array([0, 1, 1]), np.array([2, 0, 5])
    samples, weight = random_samples(figure, rng, 2), np.array([4.0, 0.25, 9.0])
    entries = Entries(at, 0, column, np.array([1.0, -2.0, 3.0])), Entries(at, 0, column + 1)
    sides = Block(at, np.array([0.1, 0.2, 0.3]), entries, weight, one_sided=True).one_sided_residuals(samples)
    np.testing.assert_allclose(sides.value, [0.2, 0.1, 0.9])
    expected = np.zeros((3, figure.width))
    expected[np.arange(3), column], expected[np.arange(3), column + 1] = [2.0, -1.0, 9.0], [2.0, 0.5, 3.0]
    np.testing.assert_allclose(sides.rows, expected)


def test_joined_they_follow_one_another(rng):
    first, second = residuals_at(rng, [3, 0, 3]), residuals_at(rng, [1, 4])
    joined = OneSidedResiduals.joined([first, second])
    assert joined.at.tolist() == [3, 0, 3, 1, 4]
    np.testing.assert_array_equal(joined.value, np.append(first.value, second.value))
    np.testing.assert_array_equal(joined.select(np.array([2, 3])).rows, [first.rows[2], second.rows[0]])
