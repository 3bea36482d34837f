"""Names of a figure in a clip: sites, inferred feet, bodies, geoms and joints, as points or bodies."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.naming import geom_name
from dynsplines.solver.surface.points import Point, body_points, bottoms_of, site_points

# Names of points of a muscle's path and of its wrapping sides in models converted from OpenSim.
MUSCLE = re.compile(r"-P\d+[a-z]?(_|$)|path_?point|side_?site|_site_", re.IGNORECASE)


def posable_sites(model: mujoco.MjModel) -> list[str]:
    """Return the names of a model's sites, without those on the paths of muscles and cables."""
    wraps = mujoco.mjtWrap
    on_path = model.wrap_objid[model.wrap_type == int(wraps.mjWRAP_SITE)]
    around = np.isin(model.wrap_type, [int(wraps.mjWRAP_SPHERE), int(wraps.mjWRAP_CYLINDER)])
    through = {int(site) for site in (*on_path, *model.wrap_prm[around])}
    names = [(i, str(model.site(i).name)) for i in range(model.nsite)]
    has_muscles = bool(model.ntendon)
    return [name for i, name in names if name and i not in through and not (has_muscles and MUSCLE.search(name))]


class Places:
    """The names of one figure, each as a point or as a body; soles: the inferred sole points."""

    def __init__(self, figure: Figure, soles: Sequence[Point] = ()) -> None:
        self.figure, self.soles = figure, {point.name: point for point in soles}

    def point(self, name: str) -> Point | None:
        """Return a site, an inferred foot, the origin of a body, or the centre of a geom, in this order; None without.

        The radius of a geom is that of a ball that fits into it; that of a body, its height above its lowest point at
        rest.
        """
        if name in self._sites:
            return site_points(self.figure, [name])[0]
        if name in self.soles:
            return self.soles[name]
        if name in self._geoms and name not in self._bodies:
            return self._geom_point(name)
        body = self.body(name)
        return None if body is None else self._body_point(name, body)

    def body(self, name: str) -> int | None:
        """Return the id of a body by its name, or by that of a joint, site, foot or geom; None without."""
        model = self.figure.model
        if name in self._bodies:
            return self._bodies[name]
        joint = next((link for link in self.figure.links[1:] if link.name == name), None)
        if joint is not None:
            return int(joint.body)
        if name in self._sites:
            return int(model.site_bodyid[self._sites[name]])
        if name in self._geoms:
            return int(model.geom_bodyid[self._geoms[name]])
        return self.figure.links[self.soles[name].link].body if name in self.soles else None

    def alike(self, name: str) -> list[str]:
        """Return all names of the first kind to which a name belongs: sites, feet, bodies or geoms."""
        kinds = (self._sites, self.soles, self._bodies, self._geoms)
        return next((list(names) for names in kinds if name in names), [])

    @property
    def points_listed(self) -> list[str]:
        """The names of points listed in a message: sites and feet, or bodies if there are none."""
        return list(dict.fromkeys([*posable_sites(self.figure.model), *self.soles])) or self.bodies_listed

    @property
    def bodies_listed(self) -> list[str]:
        return list(self._bodies)

    @cached_property
    def _sites(self) -> dict[str, int]:
        model = self.figure.model
        return {name: i for i in range(model.nsite) if (name := str(model.site(i).name))}

    @cached_property
    def _bodies(self) -> dict[str, int]:
        model = self.figure.model
        return {name: i for i in range(1, model.nbody) if (name := str(model.body(i).name))}

    @cached_property
    def _geoms(self) -> dict[str, int]:
        model = self.figure.model
        return {geom_name(model, i): i for i in range(model.ngeom) if model.geom_type[i] != mujoco.mjtGeom.mjGEOM_PLANE}

    def _geom_point(self, name: str) -> Point:
        model, geom = self.figure.model, self._geoms[name]
        middle, half = np.split(model.geom_aabb[geom], 2)
        centre = model.geom_pos[geom] + quat.rotated(model.geom_quat[geom], middle)
        link, position = self.figure.point_on_link(int(model.geom_bodyid[geom]), centre)
        return Point(name, link, position, float(half.min()))

    def _body_point(self, name: str, body: int) -> Point:
        figure = self.figure
        link, position = figure.point_on_link(body, np.zeros(3))
        origin = Point(name, link, position)
        points = [point for point in body_points(figure) if point.link == link]
        if not points or not link:
            return origin
        rest = Samples.still(figure, figure.to_state(figure.model.qpos0[None]))
        height, *bottoms = bottoms_of([origin, *points], rest)[:, 0]
        return replace(origin, radius=max(float(height - min(bottoms)), 0.0))
