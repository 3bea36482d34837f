"""The contact points of a figure's feet, and the constraints that keep feet and body on the ground."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.model import kinematics
from dynsplines.solver.posing import FloorClearance, PointGoal
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import heights
from dynsplines.solver.surface.points import Point, body_points
from dynsplines.solver.surface.surface import Plane
from dynsplines.solver.surface.touch import LEVEL

from ..clip.posing.places import posable_sites

CONTACT = 0.004  # [m] height over the lowest point of a foot up to which its points touch the ground
END = 0.45  # distance to the tip, relative to the limb's length, below which a joint is an ankle or a wrist


@dataclass(frozen=True, eq=False)
class Spheres:
    """Spheres that cover a body: MuJoCo's id, offsets (n, 3) [m] in its axes, and radii (n,) [m]."""

    body: int
    offsets: Array
    radii: Array

    def centres(self, data: mujoco.MjData) -> Array:
        """Return the centres (n, 3) [m] in the world."""
        return data.xpos[self.body] + self.offsets @ data.xmat[self.body].reshape(3, 3).T

    def lowest(self, data: mujoco.MjData) -> Spheres:
        """Return the spheres that reach lowest, on which the body stands on level ground."""
        bottoms = self.centres(data)[:, 2] - self.radii
        return self._select(np.flatnonzero(bottoms < bottoms.min() + CONTACT))

    def outermost(self, data: mujoco.MjData) -> Spheres:
        """Return at most four spheres, the corners of their horizontal extent, which suffice to fix the body."""
        centres = self.centres(data)[:, :2]
        off = centres - centres.mean(axis=0)
        _, _, axes = np.linalg.svd(off, full_matrices=False)
        off = off @ axes.T
        off = off / np.maximum(np.ptp(off, axis=0), 1e-3)
        signs = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])[:, : off.shape[1]]
        return self._select(np.unique(np.argmax(off @ signs.T, axis=0)))

    def above(self, floor: FloorClearance, height: float) -> FloorClearance:
        """Return the limit that keeps the spheres at a minimum height [m] above a floor."""
        bodies, allowed = np.full(len(self.radii), self.body), np.full(len(self.radii), -height)
        return replace(floor, bodies=bodies, offsets=self.offsets, radii=self.radii, allowed=allowed)

    def _select(self, indices: Index) -> Spheres:
        return Spheres(self.body, self.offsets[indices], self.radii[indices])


class Footing:
    """Spheres that cover a figure's links, and the surfaces of its scene; `soles` are contact points of its feet."""

    def __init__(self, figure: Figure, soles: Sequence[Point], surfaces: Sequence[Surface]) -> None:
        self.figure, self.soles, self.surfaces = figure, tuple(soles), tuple(surfaces)

    @cached_property
    def spheres(self) -> dict[int, Spheres]:
        points: dict[int, list[Point]] = {}
        for point in (*body_points(self.figure), *self.soles):
            points.setdefault(point.link, []).append(point)
        out = {}
        for link in sorted(points):
            offsets = np.array([PointGoal.of(self.figure, point).offsets[0] for point in points[link]])
            radii = np.array([point.radius for point in points[link]])
            out[link] = Spheres(self.figure.links[link].body, offsets, radii)
        return out

    @cached_property
    def rest(self) -> mujoco.MjData:
        return kinematics(self.figure.model)

    @cached_property
    def end_joints(self) -> frozenset[int]:
        """The links of ankles and wrists: the joints of a limb that are near its tip."""
        figure, out = self.figure, set[int]()
        for links in (links for links in figure.limbs if links[0] in self.spheres):
            tips = self.spheres[links[0]].centres(self.rest)
            anchors = [self.rest.xanchor[figure.links[link].joint] for link in links]
            lengths = [float(np.linalg.norm(tips - anchor, axis=1).max()) for anchor in anchors]
            out |= {link for link, length in zip(links, lengths, strict=True) if length < END * max(lengths)}
        return frozenset(out)

    def heights(self, centres: Array, radii: Array) -> Array:
        """Return the heights (n,) [m] of spheres with centres (n, 3) above the surfaces below them."""
        return heights(self.surfaces, centres.T[..., None], radii)[0][:, 0]

    def clearance(self, foot: Spheres, data: mujoco.MjData) -> float:
        """Return the height [m] of a foot's lowest point above the ground."""
        return float(self.heights(foot.centres(data), foot.radii).min())

    def fix(self, foot: Spheres, data: mujoco.MjData) -> PointGoal:
        """Return the goal that fixes a foot."""
        outermost = foot.outermost(data)
        return PointGoal("sole", foot.body, outermost.offsets, outermost.centres(data))

    def lock(self, body: int, data: mujoco.MjData) -> PointGoal:
        """Return the goal that fixes a body, or its last site if its limb has less than six degrees of freedom."""
        model, dofs = self.figure.model, [self.figure.links[link].dofs for link in self.figure.limb(body)]
        offsets = np.eye(3, 3, -1)  # [m]
        if sum(each.stop - each.start for each in dofs) < 6:
            sites = (model.site(name) for name in posable_sites(model))
            offsets = np.array([model.body_ipos[body], *(site.pos for site in sites if site.bodyid[0] == body)])[-1:]
        return PointGoal("lock", body, offsets, data.xpos[body] + offsets @ data.xmat[body].reshape(3, 3).T)

    def levels(self, foot: Spheres, data: mujoco.MjData, by: ArrayLike) -> Array:
        """Return the levels (n,) [m] of the ground below a foot's spheres, after the foot has moved by (3,) [m].

        Beyond the edge of a box on which the foot stands, it is the level of the box.
        """
        moved = np.array(by, float)
        centres = foot.centres(data) + moved
        centres[:, 2] = np.maximum(centres[:, 2], data.xpos[foot.body, 2] + moved[2])  # a sole may be in the box
        levels = centres[:, 2] - foot.radii - self.heights(centres, foot.radii)
        length = float(np.ptp(centres[:, :2], axis=0).max())
        return np.where(levels < levels.max() - length / 2, levels.max(), levels)

    def land(self, foot: Spheres, data: mujoco.MjData, by: ArrayLike) -> PointGoal:
        """Return the goal that puts a foot on the ground, free to slide, after a displacement by (3,) [m]."""
        outermost = foot.outermost(data)
        positions = np.full((len(outermost.radii), 3), np.nan)
        positions[:, 2] = self.levels(outermost, data, by) + outermost.radii
        return PointGoal("sole", foot.body, outermost.offsets, positions)

    def floor(self, root: int, data: mujoco.MjData) -> FloorClearance | None:
        """Return the limit of a tree to above the highest level plane, or its present depth; None without a plane."""
        planes = [surface for surface in self.surfaces if isinstance(surface, Plane) and surface.normal[2] > LEVEL]
        moving = [spheres for link, spheres in self.spheres.items() if self.figure.tables.path[link, root]]
        if not planes or not moving:
            return None
        plane = max(planes, key=lambda surface: float(surface.point[2]))
        moving = sorted(moving, key=lambda spheres: spheres.body)
        bodies = np.concatenate([np.full(len(spheres.radii), spheres.body) for spheres in moving])
        offsets = np.concatenate([spheres.offsets for spheres in moving])
        radii = np.concatenate([spheres.radii for spheres in moving])
        level = float(plane.normal @ plane.point)
        limit = FloorClearance(bodies, offsets, radii, np.zeros(len(radii)), plane.normal, level)
        return replace(limit, allowed=np.maximum(limit.depth(data), 0))
