"""Rows that are combinations of a few, against the matrices that they stand for, written out."""

from __future__ import annotations

import numpy as np
import pytest
from figures import TINY, figure_of
from random_samples import random_samples

from dynsplines.solver.array import Array, Index
from dynsplines.solver.penalty import one_sided
from dynsplines.solver.penalty.block import Block, Entries
from dynsplines.solver.penalty.one_sided import OneSidedResiduals, Rows

SAMPLES, WIDTH = 5, 7


def combined(rng: np.random.Generator, of: list[int], k: int = 3) -> Rows:
    """Rows that are combinations of k at every one of six places, of which the third and fourth are one sample's."""
    shares = rng.normal(size=(len(of), k))
    return Rows(np.array(of), shares, np.array([3, 0, 2, 2, 4, 1]), rng.normal(size=(6, k, WIDTH)))


def plain(rng: np.random.Generator, at: list[int]) -> Rows:
    return Rows.plain(np.array(at), rng.normal(size=(len(at), WIDTH)))


def dense(rows: Rows) -> tuple[Index, Array]:
    """Samples (P,) and gradients (P, N), one by one."""
    each = [
        sum(share * basis for share, basis in zip(s, rows.basis[r], strict=True))
        for r, s in zip(rows.of, rows.shares, strict=True)
    ]
    return rows.at[rows.of], np.array(each).reshape(-1, WIDTH)


CROWDED = [0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2, 3, 5, 5]  # five of the first place, four of the third; of k three


def every(rng: np.random.Generator) -> list[Rows]:
    return [
        combined(rng, CROWDED),
        combined(rng, [4, 1, 4, 4, 0, 4, 1]),
        combined(rng, [0, 1, 2]),
        combined(rng, [5, 5, 2, 5], k=2),
        plain(rng, [0, 0, 3, 4]),
        plain(rng, [4, 1, 1, 0, 4]),
        plain(rng, [0, 3, 1, 3]),
        combined(rng, [1, 1, 1, 1, 2, 2, 2, 2]),
    ]


@pytest.mark.parametrize("at_once", [2 * WIDTH, 10**6])
def test_what_a_change_moves_and_forces_pull_back_are_the_matrix_and_its_transpose(at_once, rng, monkeypatch):
    monkeypatch.setattr(one_sided, "ENTRIES_AT_ONCE", at_once)
    change = rng.normal(size=(SAMPLES, WIDTH))
    for rows in every(rng):
        at, written = dense(rows)
        some = np.arange(1, len(written), 2)
        np.testing.assert_allclose(rows.select(some), written[some], rtol=1e-12)
        np.testing.assert_allclose(rows.moved(change), np.einsum("pn,pn->p", written, change[at]), rtol=1e-12)
        for forces in (
            rng.normal(size=at.size),
            rng.normal(size=at.size) * (np.arange(at.size) % 2),
            np.zeros(at.size),
        ):
            pulled, expected = np.ones((2, SAMPLES, WIDTH))
            np.add.at(expected, at, forces[:, None] * written)
            rows.pull_back(forces, pulled)
            np.testing.assert_allclose(pulled, expected, atol=1e-13)


def test_the_fewer_rows_that_stand_for_many_have_the_same_squares_at_every_sample(rng):
    for rows in every(rng):
        at, written = dense(rows)
        for some in (np.arange(at.size), np.arange(0, at.size, 2), np.zeros(0, np.intp)):
            factor = rng.uniform(0.5, 2, some.size)
            found_at, found = rows.squared(some, factor)
            squares, expected = np.zeros((2, SAMPLES, WIDTH, WIDTH))
            np.add.at(squares, found_at, found[:, :, None] * found[:, None])
            own = factor[:, None] * written[some]
            np.add.at(expected, at[some], own[:, :, None] * own[:, None])
            np.testing.assert_allclose(squares, expected, atol=1e-10)


def joined(rng: np.random.Generator) -> OneSidedResiduals:
    parts = [plain(rng, [3, 0, 3]), combined(rng, [0, 0, 1, 4]), plain(rng, [1, 4, 0, 0]), combined(rng, [5, 2])]
    return OneSidedResiduals.joined(
        [OneSidedResiduals(dense(rows)[0], rng.normal(size=rows.of.size), (rows,)) for rows in parts]
    )


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
    sides = joined(rng)
    assert [(run.start, run.stop) for run, _ in sides.parts()] == [(0, 3), (3, 7), (7, 11), (11, 13)]
    written = np.concatenate([dense(rows)[1] for rows in sides.gradients])
    np.testing.assert_allclose(sides.rows, written, rtol=1e-12)
    for some in ([0], [2, 3], [3, 6, 7, 12], [12], list(range(13))):
        np.testing.assert_allclose(sides.select(np.array(some)), written[some], rtol=1e-12)
    assert not sides.select(np.zeros(0, np.intp)).size


def test_sorted_the_plain_ones_come_first_by_sample_and_all_are_what_they_were(rng):
    sides = joined(rng)
    found, order = sides.sorted()
    assert order.tolist() == [1, 9, 10, 7, 0, 2, 8, 3, 4, 5, 6, 11, 12]
    np.testing.assert_array_equal(found.at, sides.at[order])
    np.testing.assert_array_equal(found.value, sides.value[order])
    np.testing.assert_allclose(found.rows, sides.rows[order], rtol=1e-12)
    assert [rows.is_plain for rows in found.gradients] == [True, False, False]
    again, same = found.sorted()
    assert same.tolist() == list(range(13))
    np.testing.assert_array_equal(again.rows, found.rows)
    bare = OneSidedResiduals(np.array([3, 0]), np.zeros(2), (combined(rng, [0, 1]),))
    assert bare.sorted()[0] is bare
    assert bare.sorted()[1].tolist() == [0, 1]
