"""Depths of a figure's points in surfaces, and of its bodies in each other.

A point is the centre of a sphere. Points of links whose bounding sphere is far from a surface are omitted. Distances to
planes, boxes and other signed distance fields are exact. The depth in a height field is the distance to its nearest
exit, to first order.

Overlaps of bodies are those of MuJoCo's collision detection with its filters, whether or not the clip penalizes them.
The model determines which bodies collide: contype and conaffinity, <exclude>, <pair>, and no parent with its child. In
a model without collisions, all geoms count. Bodies at most two joints apart that overlap at rest do so by design, such
as a hip in the abdomen, and are excluded. For other connected bodies, the depth at rest is subtracted.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty.joints.self_contact import steps_between
from dynsplines.solver.surface import Box, Surface
from dynsplines.solver.surface.points import Point
from dynsplines.solver.surface.touch import counts_all, movers
from dynsplines.solver.tolerances import TINY

from ..scene.configuration import kinematics_of


@dataclass(frozen=True, eq=False)
class Bunch:
    """The points of one link: indices (p,), positions on it (3, p) [m], radii (p,) [m], and a bounding sphere."""

    link: int
    which: Index
    places: Array
    radii: Array
    middle: Array
    reach: float


def bunches(points: Sequence[Point]) -> tuple[Bunch, ...]:
    """Return points grouped by their links."""
    links = np.array([point.link for point in points], np.intp)
    out = []
    for link in np.unique(links).tolist():
        which = np.flatnonzero(links == link)
        members = [points[i] for i in which.tolist()]
        places, radii = np.array([point.position for point in members]).T, np.array([point.radius for point in members])
        middle = places.mean(axis=1)
        reach = float((np.linalg.norm(places - middle[:, None], axis=0) + radii).max())
        out.append(Bunch(link, which, places, radii, middle, reach))
    return tuple(out)


def depths(nearby: Sequence[Bunch], surface: Surface, samples: Samples) -> Iterator[tuple[Bunch, Index, Array]]:
    """Yield the bunches near a surface with their samples (k,), and the depths of their points (p, k) [m]."""
    if not nearby:
        return
    links = np.array([bunch.link for bunch in nearby], np.intp)
    around, _ = samples.links.points(links, np.array([bunch.middle for bunch in nearby]).T)
    near = surface.near(around, np.array([[bunch.reach] for bunch in nearby]))
    for bunch, close in zip(nearby, near, strict=True):
        at = np.flatnonzero(close)
        if at.size:
            x, rotation = samples.links.poses(bunch.link * samples.count + at)
            centres = np.einsum("ijk,jp->ipk", rotation, bunch.places) + x[:, None]
            yield bunch, at, depth(surface, centres, bunch.radii)


def depth(surface: Surface, centres: Array, radii: Array) -> Array:
    """Return the depths (p, k) [m] of spheres with centres (3, p, k) and radii (p,) in a surface, at most 0 outside."""
    if isinstance(surface, Box):
        return radii[:, None] - surface.distance(centres)
    deep, direction = surface.depth(centres, radii)
    return deep / np.maximum(np.linalg.norm(direction, axis=0), TINY)


@lru_cache(maxsize=2)
def colliding(figure: Figure) -> tuple[mujoco.MjModel, Array]:
    """Return the model for `overlaps`, and the depths (L, L) [m] of two links in each other at rest, the smaller index
    first; infinite if excluded."""
    model, at_rest = _collision_model(figure.model), np.zeros((len(figure.links),) * 2)
    _, links, depth = overlaps(figure, model, figure.model.qpos0[None])
    steps = steps_between(figure)[links]
    np.maximum.at(at_rest, links, np.where(steps <= 2, np.inf, np.where(np.isfinite(steps), depth, 0.0)))
    return model, at_rest


def overlaps(figure: Figure, model: mujoco.MjModel, qpos: Array) -> tuple[Index, tuple[Index, Index], Array]:
    """Return overlaps of geoms at qpos (k, nq): rows (m,) of qpos, links of the geoms (m,) each, the smaller index
    first, and depths (m,) [m]."""
    parts = []
    for sample, data in enumerate(kinematics_of(model, qpos)):
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
