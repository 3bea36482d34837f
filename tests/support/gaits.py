"""A walk whose gait is to be read."""

from __future__ import annotations

import numpy as np
from walker import FINE, walk, walker

from dynsplines.solver.contacts.gait_period import Gait
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.surface import Plane

PERIOD = 1.1
GROUND = (Plane("floor", np.zeros(3), np.array([0.0, 0, 1])),)
FIGURE, SOLES = walker()
TIME, WALK = walk(FIGURE, SOLES, PERIOD, 3.5)


def gait(qpos: np.ndarray, every: float) -> Gait:
    """Keyframes of a fine motion, so far apart [s]."""
    keys = [Frame.key(TIME[k], qpos[k]) for k in range(0, TIME.size, round(every * FINE))]
    return Gait(FIGURE, raw_timeline(FIGURE, keys), SOLES, GROUND)
