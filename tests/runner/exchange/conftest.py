"""A motion of the human without any symmetry, to be read only."""

from __future__ import annotations

import pytest
import wild

from dynsplines.motion import Saved


@pytest.fixture(scope="session")
def human() -> Saved:
    return wild.motion_of("human")
