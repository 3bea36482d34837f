"""Obstacles of a clip's scene: boxes, spheres, capsules and cylinders in metres, as geoms of the stage.

Those that name a `body` are parts of a thing that moves freely, in its axes: keyframes place it, hands hold it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from solver.quaternion import Array
from solver.surface.touch import SCENERY

from ..clip.rotation import quaternion_of
from ..clip.table import BarTable, BoxTable, SceneTable, SphereTable
from ..errors import UserError

SHORTEST = 1e-4  # [m] from end to end
KINDS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
}


@dataclass(frozen=True)
class Obstacle:
    """A static geom, or a part of a body that moves freely.

    kind   "box", "sphere", "capsule" or "cylinder"
    size   MuJoCo's: half sizes, or radius and half length [m]
    place  (3,) centre [m]; turn (4,) wxyz; or ends (6,), the points that a capsule or cylinder goes from and to [m]
    color  (4,) red, green, blue, opacity; None: that of the step
    body   of which it is a part, place and turn in its axes; None: of the world;  mass  [kg] of the part
    """

    name: str
    kind: str
    size: tuple[float, ...]
    place: Array
    turn: Array
    ends: Array | None = None
    color: tuple[float, float, float, float] | None = None
    body: str | None = None
    mass: float | None = None

    def add_to(self, spec: mujoco.MjSpec, material: str) -> None:
        """The geom in the world of a spec, or on its body."""
        if any(geom.name == self.name for geom in spec.geoms):
            raise UserError(f"the scene has a {self.kind} '{self.name}', but there already is a geom of that name")
        owner = spec.worldbody if self.body is None else spec.body(self.body)
        geom = owner.add_geom(name=self.name, type=KINDS[self.kind], contype=0, conaffinity=1 | SCENERY)
        if self.mass is not None:
            geom.mass = self.mass
        geom.size[: len(self.size)] = self.size
        if self.ends is None:
            geom.pos, geom.quat = self.place, self.turn
        else:
            geom.fromto = self.ends
        if self.color is None:
            geom.material = material
        else:
            geom.rgba = self.color


def add_bodies(spec: mujoco.MjSpec, parts: Sequence[Obstacle]) -> None:
    """The bodies of the parts that have one, each with a free joint of its name, at the world's origin at rest."""
    for name in dict.fromkeys(part.body for part in parts if part.body is not None):
        known = {body.name for body in spec.bodies} | {joint.name for joint in spec.joints}
        if name in known:
            raise UserError(f"the scene has a body '{name}', but there already is a body or joint of that name")
        spec.worldbody.add_body(name=name).add_freejoint(name=name)


def obstacles(scene: SceneTable) -> tuple[Obstacle, ...]:
    """The obstacles of a scene's tables, in the order of their kinds."""
    return tuple(_obstacles(scene))


def _obstacles(scene: SceneTable) -> Iterator[Obstacle]:
    for kind in KINDS:
        for number, table in enumerate(getattr(scene, kind), start=1):
            name = table.name or f"{kind} {number}"
            where = f"scene.{kind} {number}" + (f" ('{table.name}')" if table.name else "")
            yield _one(kind, name, table, where)


def _one(kind: str, name: str, table: BoxTable | SphereTable | BarTable, where: str) -> Obstacle:
    ends = None
    if isinstance(table, BoxTable):
        size = tuple(0.5 * length for length in table.size)
    elif isinstance(table, SphereTable):
        size = (table.radius,)
    else:
        ends = _ends(table, where)
        size = (table.radius,) if table.length is None else (table.radius, 0.5 * table.length)
    if table.mass is not None and table.body is None:
        raise UserError(f"{where}: 'mass' is for parts of a body that moves; name it by body = '...'")
    if table.position is None and ends is None and table.body is None:
        raise UserError(f"{where}: 'position' is missing")
    place = np.array(table.position or (0.0, 0, 0))
    turn = np.array([1.0, 0, 0, 0]) if table.rotation is None else quaternion_of(table.rotation, f"{where}: rotation")
    return Obstacle(name, kind, size, place, turn, ends, table.color, table.body, table.mass)


def _ends(table: BarTable, where: str) -> Array | None:
    """Where a capsule or cylinder goes from and to, or None if it lies about its position."""
    about = [name for name in ("position", "length", "rotation") if getattr(table, name) is not None]
    if table.start is None and table.end is None:
        if table.length is None:
            raise UserError(f"{where}: give position and length, or from and to")
        return None
    if table.start is None or table.end is None:
        raise UserError(f"{where}: 'from' and 'to' go together")
    if about:
        raise UserError(f"{where}: give from and to, or position and length, not both ('{about[0]}' and 'from')")
    ends = np.array([*table.start, *table.end])
    if np.linalg.norm(ends[3:] - ends[:3]) < SHORTEST:
        raise UserError(f"{where}: from and to are the same point")
    return ends
