"""A motion of the human without any symmetry, to be read only."""

from __future__ import annotations

import motions
import pytest

from dynsplines.motion import Saved


@pytest.fixture(scope="session")
def human() -> Saved:
    return motions.motion_of("human")
