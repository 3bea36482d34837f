"""Obstacles of a clip's scene: boxes, spheres, capsules and cylinders in metres, as geoms of the stage.

An obstacle with a `body` is part of a free object, in its axes. Keyframes place the object, and hands can grasp it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

from dynsplines.solver.array import Array
from dynsplines.solver.surface.touch import SCENERY

from ..errors import UserError

KINDS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
}


@dataclass(frozen=True)
class Obstacle:
    """A static geom, or a part of a free body.

    Attributes:
        kind: "box", "sphere", "capsule" or "cylinder".
        size: MuJoCo's size: half sizes, or radius and half length [m].
        place: The centre, (3,) [m].
        turn: The orientation, (4,) wxyz.
        ends: The end points of a capsule or cylinder, instead of `place` and `turn`, (6,) [m].
        color: Red, green, blue, opacity; None: that of the step.
        body: The body of which it is a part, with `place` and `turn` in its axes; None: the world.
        mass: The mass of the part [kg].
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
        """Add the geom to the world of a spec, or to its body."""
        if any(geom.name == self.name for geom in spec.geoms):
            raise UserError(f"the scene has a {self.kind} '{self.name}', but the model already has a geom of that name")
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
    """Add the bodies of the parts that have one, each with a free joint of its name, at rest at the world's origin."""
    for name in dict.fromkeys(part.body for part in parts if part.body is not None):
        names = {body.name for body in spec.bodies} | {joint.name for joint in spec.joints}
        if name in names:
            raise UserError(f"the scene has a body '{name}', but the model already has a body or joint of that name")
        spec.worldbody.add_body(name=name).add_freejoint(name=name)
