"""Points, bodies and roots of a figure by name, and the points on which it stands.

Names are those of sites, soles, bodies, geoms and joints. The soles are sites named heel or toe, or else the lowest
points of the feet. Named sites count if at least one of them is as low as the figure; points on the paths of muscles
never do. Feet are the lowest ends of limbs in the pose in which the figure is tallest: the rest pose or one of its
keyframes. The rest pose has precedence if it is nearly as tall, since a walking figure is tallest on its toes. If no
such pose shows feet, the rest pose within the joints' ranges is examined. These figures have no feet: one whose trunk
is as low, one with a single limb, and one without a free joint.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import geom_name
from dynsplines.solver.figure.root import Root, roots_of
from dynsplines.solver.penalty import joint_ranges
from dynsplines.solver.surface.points import (
    Point,
    arrays_of,
    body_points,
    bottoms_of,
    hanging,
    places_of,
    site_points,
)
from dynsplines.solver.surface.touch import movers

from ...errors import UserError, unknown
from ..table import KeyframeTable

# Names of points of a muscle's path and of its wrapping sides in models converted from OpenSim.
MUSCLE = re.compile(r"-P\d+[a-z]?(_|$)|path_?point|side_?site|_site_", re.IGNORECASE)
SOLES = ("heel", "toe")
LOW = 0.1  # largest height of a foot above the figure's lowest point, relative to the figure's height
THICK = 0.02  # largest height of points of a foot above its lowest, relative to the figure's height
THIN, HALF = (0.0015, 0.003, 0.006), 0.45  # tried heights of supporting points; their least share of the extent
SUNK = 0.005  # largest height of a named site on a figure with muscles, relative to the figure's height
UPRIGHT = 0.8  # least height of a pose that is examined, relative to the tallest
NEARLY = 0.9  # least height of the rest pose to have precedence, relative to the tallest
ROUND = (int(mujoco.mjtGeom.mjGEOM_SPHERE), int(mujoco.mjtGeom.mjGEOM_CAPSULE))
SKIN = 0.1  # largest distance of a site from a sphere's surface, relative to its radius


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

    def named_point(self, name: str, where: str) -> Point:
        """Return a point by name; raises UserError that lists sites and feet, or bodies if there are none."""
        point = self.point(name)
        if point is None:
            names = list(dict.fromkeys([*posable_sites(self.figure.model), *self.soles])) or self.bodies_listed
            raise UserError(f"{where}: {unknown('site', name, names)}")
        return point

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
        centre = model.geom_pos[geom] + quat.rotate(model.geom_quat[geom], middle)
        link, position = self.figure.point_on_link(int(model.geom_bodyid[geom]), centre)
        return Point(name, link, position, float(half.min()))

    def _body_point(self, name: str, body: int) -> Point:
        figure = self.figure
        link, position = figure.point_on_link(body, np.zeros(3))
        origin = Point(name, link, position)
        points = [point for point in body_points(figure) if point.link == link]
        if not points or not link:
            return origin
        rest = Samples.of_qpos(figure)
        height, *bottoms = bottoms_of([origin, *points], rest)[:, 0]
        return replace(origin, radius=max(float(height - min(bottoms)), 0.0))


def root_links(figure: Figure, row: KeyframeTable) -> set[int]:
    """Return the links of the roots that a keyframe's tables set."""
    main = {figure.root.link} if row.root.model_fields_set and figure.root is not None else set()
    named = roots_by_name(figure) if row.roots else {}
    return main | {named[name].link for name in row.roots if name in named}


def roots_by_name(figure: Figure) -> dict[str, Root]:
    """Return the roots by the names that `roots.NAME` accepts: of free joints, then of their bodies."""
    roots = roots_of(figure.model)
    out = {figure.links[root.link].name: root for root in roots}
    for root in roots:
        out.setdefault(str(figure.model.body(root.body).name) or figure.links[root.link].name, root)
    return out


def sole_points(figure: Figure, qpos: Array) -> tuple[Point, ...]:
    """Return the points on which feet stand; qpos (K, nq) are poses other than the rest pose in which it may stand."""
    names = posable_sites(figure.model)  # no points of the muscles that bend toes
    named = site_points(figure, [name for name in names if any(word in name.lower() for word in SOLES)])
    named = tuple(_grow(figure, point) for point in named if point.link)
    rest = figure.model.qpos0[None]
    if named and (_near_ground(figure, named, rest) or _near_ground(figure, named, qpos)):
        return named
    return _lowest(figure, np.vstack([rest, qpos])) or named or _lowest_within(figure)


def rest_within_ranges(figure: Figure) -> Array:
    """Return the rest pose (nq,) within the joints' ranges."""
    qpos = np.array(figure.model.qpos0)
    for joint in joint_ranges(figure):
        if joint.kind is not JointKind.BALL:
            column = figure.links[joint.link].qpos
            qpos[column] = np.clip(qpos[column], joint.low, joint.high)
    return qpos


def _lowest_within(figure: Figure) -> tuple[Point, ...]:
    """Return the lowest points of the feet in the rest pose within the joints' ranges, as legs may be level at rest."""
    pose = rest_within_ranges(figure)
    return () if np.array_equal(pose, figure.model.qpos0) else _lowest(figure, pose[None])


def _near_ground(figure: Figure, points: Sequence[Point], qpos: Array) -> bool:
    """Return whether one of the points is as low as the figure in one of the poses (K, nq), unlike sites on a toe."""
    body = body_points(figure)
    if not body:
        return True
    places, radii = places_of((*points, *body), Samples.of_qpos(figure, qpos))
    low, high = places[2] - radii[:, None], places[2] + radii[:, None]
    ground, tall = low.min(axis=0), np.ptp(np.concatenate([low, high]), axis=0)
    share = SUNK if figure.model.ntendon else THICK  # feet of figures with muscles have sites everywhere
    return bool(np.any(low[: len(points)] <= ground + share * tall))


def _grow(figure: Figure, point: Point) -> Point:
    """Return a site in the middle of a sphere of its link with that radius, as it marks a foot; others unchanged."""
    for (centre, _), radius in _round(figure, point.link, ROUND[:1]):
        if np.linalg.norm(point.position - centre) < 0.5 * radius:
            return Point(point.name, point.link, centre, radius)
    return point


def sphere_at(figure: Figure, point: Point) -> Point:
    """Return a site on the surface of a sphere or capsule of its link as that sphere, on which the foot rolls."""
    if point.radius:
        return point
    best = point
    for (first, last), radius in _round(figure, point.link, ROUND):
        along = last - first
        share = np.clip((point.position - first) @ along / max(along @ along, 1e-12), 0, 1)
        centre = first + share * along
        off = abs(np.linalg.norm(point.position - centre) - radius)
        if off < SKIN * radius and radius > best.radius:
            best = Point(point.name, point.link, centre, radius)
    return best


def _round(figure: Figure, link: int, kinds: Sequence[int]) -> Iterator[tuple[Array, float]]:
    """Yield the ends (2, 3) [m], equal for spheres, and the radii [m] of a link's spheres and capsules."""
    model = figure.model
    wanted = (figure.body_link[model.geom_bodyid] == link) & np.isin(model.geom_type, kinds)
    for geom in movers(model) if wanted.any() else ():
        if not wanted[geom]:
            continue
        half = 0.0 if model.geom_type[geom] == ROUND[0] else float(model.geom_size[geom, 1])
        half_axis = half * quat.rotate(model.geom_quat[geom], np.eye(3)[2])
        _, ends = figure.point_on_link(
            int(model.geom_bodyid[geom]), model.geom_pos[geom] + np.stack([-half_axis, half_axis])
        )
        yield ends, float(model.geom_size[geom, 0])


def _lowest(figure: Figure, poses: Array) -> tuple[Point, ...]:
    """Return the lowest points of the feet in poses (K, nq), of which the first is at rest."""
    lowest: list[Point] = []
    body = body_points(figure)
    for root in roots_of(figure.model):
        tree_points = hanging(figure, root.link, body)
        if tree_points:
            lowest += _feet(figure, root, tree_points, poses)
    return tuple(lowest)


def _feet(figure: Figure, root: Root, points: Sequence[Point], poses: Array) -> list[Point]:
    """Return the lowest points of a tree's lowest ends, in the tallest pose in which it stands on at least two feet."""
    samples = Samples.of_qpos(figure, poses)
    places, radii = places_of(points, samples)
    bottom = places[2] - radii[:, None]
    tall = samples.links.x[2, root.link] - bottom.min(axis=0)
    tall[0] = max(tall[0], tall.max()) if tall[0] >= NEARLY * tall.max() else tall[0]
    order = np.argsort(-np.where(tall > tall.max() - Thresholds.of(figure).tiny, np.inf, tall), kind="stable")
    for pose in order[tall[order] >= UPRIGHT * tall.max()]:
        feet = _feet_in(figure, root.link, points, places[:, :, pose], radii)
        if len({point.link for point in feet}) >= 2:  # feet
            return feet
    return []


def _feet_in(figure: Figure, root: int, points: Sequence[Point], places: Array, radii: Array) -> list[Point]:
    """Return the feet in one pose, with points at positions (3, n) [m]; none if the trunk is as low."""
    links, bottom = arrays_of(points)[0], places[2] - radii
    height = float(np.ptp(places[2]))
    feet: list[Point] = []
    for foot in np.unique(links):
        members = np.flatnonzero(links == foot)
        beyond = bottom[(figure.tables.path[links, foot] > 0) & (links != foot)]
        least = float(bottom[members].min())
        carries = beyond.size and beyond.min() < least - Thresholds.of(figure).tiny
        if not carries and least <= bottom.min() + LOW * height:
            if foot == root:
                return []
            feet += _corners(figure, points, _sole(members, bottom[members], places[:2], height), places)
    return feet


def _sole(own: Index, bottom: Array, places: Array, height: float) -> Index:
    """Return the points of a foot, with lowest heights (n,) [m], that touch a floor, without round edges of the foot.

    places  (2, N) [m] horizontal positions of all points;  height  [m] of the figure
    """
    above = bottom - bottom.min()
    thick = own[above <= THICK * height]
    axes = np.linalg.eigh(np.cov(places[:, thick], bias=True))[1]
    extent = np.ptp(axes.T @ places[:, thick], axis=1)
    for share in THIN:
        touching = own[above <= share * height]
        if np.all(np.ptp(axes.T @ places[:, touching], axis=1) >= HALF * extent):
            return touching
    return thick


def _corners(figure: Figure, points: Sequence[Point], some: Index, places: Array) -> list[Point]:
    """Return the named points of a foot that extend farthest to its four corners."""
    angle = np.pi * (0.25 + 0.5 * np.arange(4)) + 0.05
    reach = places[:2, some].T @ np.array([np.cos(angle), np.sin(angle)])
    corners = sorted({int(some[i]) for i in reach.argmax(axis=0)})
    names = [_foot_name(figure, points[i]) for i in corners]
    if len(corners) == 1:
        return [replace(points[corners[0]], name=names[0])]
    return [
        replace(points[i], name=f"{name} {number}")
        for number, (i, name) in enumerate(zip(corners, names, strict=True), 1)
    ]


def _foot_name(figure: Figure, point: Point) -> str:
    """Return a foot's name: that of its geom, body or joint."""
    model, kinds = figure.model, mujoco.mjtObj
    if mujoco.mj_name2id(model, int(kinds.mjOBJ_GEOM), point.name) >= 0:
        return point.name
    stem, _, number = point.name.rpartition(" ")
    body = stem if number.isdigit() else point.name
    is_named = mujoco.mj_name2id(model, int(kinds.mjOBJ_BODY), body) >= 0
    return body if is_named else figure.links[point.link].name
