"""Rows of residual blocks against central differences of their values."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Penalty
from dynsplines.solver.penalty.block import Block

STEP = 1e-5


def assert_rows_of(penalty: Penalty, samples: Samples, rng: np.random.Generator, rtol: float = 1e-7) -> None:
    """Along a random direction of y, y', y'' every residual changes as its row says."""
    direction = rng.normal(size=(3, *samples.y.shape))
    blocks = [block for block in penalty.nearby(samples) if isinstance(block, Block)]
    moved = [_blocks(penalty, samples, sign * STEP * direction) for sign in (-1, 1)]
    assert blocks
    for block, before, after in zip(blocks, *moved, strict=True):
        rows = block.rows(samples)
        found = np.einsum("pon,opn->p", rows, direction[: rows.shape[1], block.at])
        expected = (after.value - before.value) / (2 * STEP)
        np.testing.assert_allclose(found, expected, rtol=0, atol=rtol * max(np.abs(expected).max(initial=0), 1.0))


def _blocks(penalty: Penalty, samples: Samples, change: Array) -> list[Block]:
    moved = Samples(samples.figure, samples.y + change[0], samples.y_d + change[1], samples.y_dd + change[2], samples.t)
    return [block for block in penalty.nearby(moved) if isinstance(block, Block)]
