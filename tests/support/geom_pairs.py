"""The pairs of geoms that a penalty of self-contact keeps apart."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.array import Index
from dynsplines.solver.penalty import SelfContact


def geom_pairs(penalty: SelfContact) -> Index:
    """The pairs of geoms, each once, (2, g)."""
    geoms = np.array([bar.geom for bar in penalty.bars], np.intp)
    return np.unique(geoms[penalty.pairs], axis=1) if penalty.pairs.size else np.zeros((2, 0), np.intp)
