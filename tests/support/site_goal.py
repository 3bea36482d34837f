"""A goal of inverse kinematics that is not of the solver: a site of MuJoCo at a position."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Mask


@dataclass(frozen=True, eq=False)
class SiteGoal:
    """A site at a place in the world: position (3,) [m], NaN along the axes that are free."""

    name: str
    position: Array

    def bodies(self, model: mujoco.MjModel) -> list[int]:
        return [int(model.site_bodyid[model.site(self.name).id])]

    def missed(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return (data.site(self.name).xpos - self.position)[self._specified]

    def rows(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacSite(model, data, rows, None, model.site(self.name).id)
        return rows[self._specified]

    @cached_property
    def _specified(self) -> Mask:
        return ~np.isnan(self.position)
