"""Overlaps of moving bodies, by MuJoCo's collision detection with its filters, whether or not the clip penalizes them.

The model determines which bodies collide: contype and conaffinity, <exclude>, <pair>, and no parent with its child. In
a model without collisions, all geoms count. Bodies at most two joints apart that overlap at rest do so by design, such
as a hip in the abdomen, and are excluded. For other connected bodies, the depth at rest is subtracted.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from functools import lru_cache

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.touch import counts_all, movers

from ..scene.configuration import posed

JOINED = 2  # most joints between two bodies that are excluded if they overlap at rest


@dataclass(frozen=True, eq=False)
class Overlaps:
    """The bodies of a figure that can overlap.

    model    a copy in which only moving geoms collide
    at_rest  (L, L) [m] depth of two links in each other at rest, the smaller index first; infinite if excluded
    """

    figure: Figure
    model: mujoco.MjModel
    at_rest: Array

    @classmethod
    @lru_cache(maxsize=2)
    def of(cls, figure: Figure) -> Overlaps:
        """Return all bodies that collide in MuJoCo."""
        model, at_rest = _collision_model(figure.model), np.zeros((len(figure.links),) * 2)
        _, links, depth = _overlaps(figure, model, figure.model.qpos0[None])
        steps = _steps(figure)[links]
        np.maximum.at(at_rest, links, np.where(steps <= JOINED, np.inf, np.where(np.isfinite(steps), depth, 0.0)))
        return cls(figure, model, at_rest)

    def met(self, samples: Samples) -> tuple[Index, tuple[Index, Index], Array]:
        """Return the overlaps in samples, as `_overlaps` does; depths are reduced by those at rest."""
        at, links, depth = _overlaps(self.figure, self.model, self.figure.to_qpos(samples.y))
        return at, links, depth - self.at_rest[links]


def _overlaps(figure: Figure, model: mujoco.MjModel, qpos: Array) -> tuple[Index, tuple[Index, Index], Array]:
    """Return overlaps of geoms at qpos (k, nq): rows (m,) of qpos, links of the geoms (m,) each, the smaller index
    first, and depths (m,) [m]."""
    parts = []
    for sample, data in enumerate(posed(model, qpos)):
        mujoco.mj_collision(model, data)
        if data.ncon:
            parts.append((np.full(data.ncon, sample), data.contact.geom.T.copy(), -data.contact.dist))
    parts.append((np.zeros(0, np.intp), np.zeros((2, 0), np.intp), np.zeros(0)))
    when, geoms, depth = (np.concatenate(part, axis=-1) for part in zip(*parts, strict=True))
    links = np.sort(figure.body_link[model.geom_bodyid[geoms]], axis=0)
    deep = np.flatnonzero((depth > 0) & (links[0] > 0) & (links[0] < links[1]))
    return when[deep], (links[0, deep], links[1, deep]), depth[deep]


def _collision_model(model: mujoco.MjModel) -> mujoco.MjModel:
    """Return a copy in which moving geoms collide with each other as in MuJoCo, or all of them if none does."""
    out, solid = copy.copy(model), movers(model)
    still = np.setdiff1d(np.arange(model.ngeom), solid)
    bodies = np.unique(model.geom_bodyid[solid])
    if counts_all(model):
        out.geom_contype[solid] = out.geom_conaffinity[solid] = 1
        out.body_contype[bodies] = out.body_conaffinity[bodies] = 1
        out.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)  # its trees have colliding geoms only
    out.geom_contype[still] = out.geom_conaffinity[still] = 0
    fixed = np.setdiff1d(np.arange(model.nbody), bodies)
    out.body_contype[fixed] = out.body_conaffinity[fixed] = 0
    out.opt.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    out.geom_margin[:] = 0
    return out


def _steps(figure: Figure) -> Array:
    """Return the number of bodies from one link to another, (L, L): 1 to a child, infinite between free trees."""
    bodies, path = np.array([link.body for link in figure.links]), figure.tables.path
    first = np.append(True, bodies[1:] != bodies[:-1])  # a body's other joints do not count
    depth, shared = path[:, first].sum(axis=1), path[:, first] @ path[:, first].T
    is_free: Mask = np.any(path[:, figure.tables.free_links] > 0, axis=1)
    apart = np.logical_or.outer(is_free, is_free) & (path @ path.T == 0)
    return np.where(apart, np.inf, depth[:, None] + depth - 2 * shared)
