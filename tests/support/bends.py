"""A limb with a knee, and the limits of bends."""

from __future__ import annotations

import numpy as np
from figures import figure_of

from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import (
    Bend,
    BendLimits,
)


def limits_of(figure: Figure) -> BendLimits:
    """Bounds on every ball joint."""
    joints = figure.tables.ball_links
    return BendLimits(tuple(Bend(f"{i}", i, KNEE, np.array([0.0, 0, -1])) for i in joints), 0.1, 0.2, 0.3)


LIMB = """
<mujoco><worldbody><body name="upper" pos="0 0 1"><freejoint/><geom size=".1"/>
  <body name="lower" pos="0 0 -.4" quat="{quat}"><joint name="joint" type="ball"/><geom size=".1"/></body></body>
</worldbody></mujoco>"""
DOWN = np.array([0.0, 0, -1])
TEN = float(np.radians(10))
KNEE, ELBOW = np.array([0.0, 1, 0]), np.array([0.0, -1, 0])


def limb(coordinates: str = "world", quat: str = "1 0 0 0") -> Figure:
    return figure_of(LIMB.format(quat=quat), coordinates)


def limits(lateral: np.ndarray, *, least: float = 0.0, sideways: float = TEN, twist: float = TEN) -> BendLimits:
    return BendLimits((Bend("joint", 2, lateral, DOWN),), least, sideways, twist)
