"""Left and right exchanged in a clip's tables, in the notation of the file: angles remain angles, "free" remains
"free"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.mirror import AXIAL, POLAR, TURN, Mirror
from dynsplines.solver.curve.symmetry import UNEVEN, UNPAIRED, WORLD
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.posing import rest_rotation
from dynsplines.solver.surface.points import Point

from ..errors import UserError, unknown
from .posing.places import Places, sole_points
from .table import (
    KEY,
    BarTable,
    BodyTable,
    BoxTable,
    ClipTable,
    KeyframeTable,
    PenaltyTable,
    RootTable,
    RotationTable,
    SceneTable,
    SolveTable,
    SphereTable,
    Table,
)

Placed = TypeVar("Placed", bound=Table)
Obstacle = TypeVar("Obstacle", BoxTable, SphereTable, BarTable)
Turned = TypeVar("Turned", bound=RotationTable)


@dataclass(frozen=True)
class _Sides:
    """A figure's names, and their counterparts on the other side."""

    places: Places
    mirror: Mirror

    @classmethod
    def of(cls, figure: Figure, mirror: Mirror) -> _Sides:
        return cls(Places(figure, sole_points(figure, np.zeros((0, figure.width)))), mirror)

    @property
    def figure(self) -> Figure:
        return self.places.figure

    def link(self, name: str) -> int:
        return next(i for i, link in enumerate(self.figure.links) if i and link.name == name)

    def other(self, name: str) -> str:
        """Return the site, foot, geom, body or joint on the other side, or the same name in the mirror plane."""
        body, alike, links = self.places.body(name), self.places.alike(name), self.figure.links
        if body is None:
            return name
        if not alike:
            return links[self.mirror.partner[self.link(name)]].name  # of a joint
        link = links[self.figure.body_link[body]]
        partner, other = self.mirror.partner[self.figure.body_link[body]], self.mirror.other(name)
        if alike == list(self.places.soles):  # their numbers do not depend on the side
            other = self._nearest(name, alike) or other
        elif other == name and alike == self.places.bodies_listed and body == link.body:
            other = str(self.figure.model.body(links[partner].body).name)
        elif other == name:
            other = self._nearest(name, [name]) or ""
        there = self.places.body(other)
        if there is None or self.figure.body_link[there] != partner:
            raise UserError(f"no partner on the other side for: '{name}'; {UNPAIRED}")
        return other

    def _nearest(self, name: str, names: list[str]) -> str | None:
        """Return the name of the point nearest to a point's mirror image on its partner link; None if there is none."""
        point = self._point(name)
        partner, image = self.mirror.partner[point.link], self.mirror.reflection[point.link] @ point.position
        away = {
            other: float(np.linalg.norm(there.position - image))
            for other in names
            if (there := self._point(other)).link == partner
        }
        best = min(away, key=lambda candidate: (away[candidate], candidate != name), default=None)
        return best if best is not None and away[best] <= UNEVEN * self.mirror.size else None

    def _point(self, name: str) -> Point:
        """Return a site, a foot, the middle of a geom or the origin of a body."""
        point = self.places.point(name)
        assert point is not None
        return point

    def reflection(self, name: str) -> Array:
        """Return the reflection (3, 3) from the frame of a body to that of the body on the other side."""
        body, other = self.places.body(name), self.places.body(self.other(name))
        return WORLD if body is None or other is None else self.mirror.of_bodies(body, other)

    def rest(self, body: int, other: int) -> Array:
        """Return the orientations (2, 4) of a body and of the body on the other side in the rest pose."""
        return np.stack([rest_rotation(self.figure.model, body), rest_rotation(self.figure.model, other)])


def figure_mirror(figure: Figure, table: ClipTable, where: str) -> Mirror:
    """Return the mirror map of a clip's figure; raises UserError for a figure without left and right sides."""
    for name in (name for pair in table.mirror.pairs for name in pair):
        if Places(figure).body(name) is None:
            joints = [link.name for link in figure.links[1:]]
            raise UserError(f"{where}: mirror.pairs: {unknown('joint', name, joints)}")
    try:
        return Mirror.of(figure, table.mirror.pairs)
    except ValueError as error:
        raise UserError(f"{where}: {error}") from None


def mirrored_tables(clip: ClipTable, figure: Figure, mirror: Mirror) -> ClipTable:
    """Return a clip's tables for the mirrored figure. Step and obstacles are mirrored as well.

    Raises:
        UserError: For a clip without a mirror image.
    """
    for others in dict.fromkeys(row.others for row in clip.keyframe):
        _check_symmetric(others, figure, mirror)
    if clip.recording is not None:
        raise UserError("recording: such a clip cannot be mirrored; mirror the solved motion: -o NAME.npz")
    sides = _Sides.of(figure, mirror)
    return clip.change(
        scene=_scene(clip.scene),
        solve=_solve(clip.solve),
        penalty=[_penalty(entry, sides) for entry in clip.penalty],
        contact=[_mirror_places(row.change(point=sides.other(row.point)), "position") for row in clip.contact],
        grasp=[
            _mirror_places(row.change(point=sides.other(row.point), body=sides.other(row.body)), "position")
            for row in clip.grasp
        ],
        keyframe=[_keyframe(row, sides) for row in clip.keyframe],
    )


def mirrored_keyframe(row: KeyframeTable, figure: Figure, mirror: Mirror) -> KeyframeTable:
    """Return one keyframe's table for the mirrored figure; raises UserError for a keyframe without a mirror image."""
    _check_symmetric(row.others, figure, mirror)
    return _keyframe(row, _Sides.of(figure, mirror))


def _check_symmetric(others: str, figure: Figure, mirror: Mirror) -> None:
    """Raise UserError if unspecified joints come from a pose that is not symmetric."""
    if others != "rest" and not others.startswith(KEY):
        return
    qpos = figure.model.qpos0 if others == "rest" else figure.model.key(others.removeprefix(KEY)).qpos
    if not _is_symmetric(np.array(qpos), mirror):
        what = "the figure's rest" if others == "rest" else f"the model's key '{others.removeprefix(KEY)}'"
        raise UserError(f"{what} is not symmetric: specify every joint instead of others = '{others}'")


def _is_symmetric(qpos: Array, mirror: Mirror) -> bool:
    """Return whether a configuration (nq,) is its own mirror image."""
    image = mirror.configurations(qpos)
    for link in mirror.figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None and image[columns] @ qpos[columns] < 0:
            image[columns] *= -1
    return bool(np.allclose(image, qpos, atol=1e-9))


def _scene(scene: SceneTable) -> SceneTable:
    step = None if scene.step is None else scene.step.change(y=0.0 - scene.step.y)
    return scene.change(
        step=step,
        box=[_obstacle(row, "position") for row in scene.box],
        sphere=[_obstacle(row, "position") for row in scene.sphere],
        capsule=[_obstacle(row, "position", "start", "end") for row in scene.capsule],
        cylinder=[_obstacle(row, "position", "start", "end") for row in scene.cylinder],
    )


def _obstacle(row: Obstacle, *places: str) -> Obstacle:
    out = _mirror_places(row, *places)
    return out if out.rotation is None else out.change(rotation=_rotation(out.rotation))


def _solve(solve: SolveTable) -> SolveTable:
    return _mirror_places(solve, "travel").change(turn=None if solve.turn is None else 0.0 - solve.turn)


def _mirror_places(row: Placed, *names: str) -> Placed:
    """Return a table with the positions (3,) of some keys mirrored."""
    return row.change(**{name: _flip(place, POLAR) for name in names if (place := getattr(row, name)) is not None})


def _penalty(entry: PenaltyTable, sides: _Sides) -> PenaltyTable:
    """Return a penalty for the points, joints and bodies of the other side, with its axis in their frames."""
    options = dict(entry.options)
    for key in ("points", "bend_joints", "bodies"):
        if options.get(key):
            options[key] = [sides.other(name) for name in entry.options[key]]
    if options.get("axis") is not None and options.get("bodies"):
        axis = np.array(options["axis"], float)
        axes = [(sides.reflection(name) @ axis).tolist() for name in entry.options["bodies"]]
        if not np.allclose(axes, axes[0], atol=1e-9):
            raise UserError(f"penalty '{entry.kind}': bodies with different orientations have no common mirrored axis")
        options["axis"] = axes[0]
    return PenaltyTable.of(entry.kind, **options)


def _keyframe(row: KeyframeTable, sides: _Sides) -> KeyframeTable:
    links = sides.figure.links
    first = next((link.name for link in links[1:] if link.kind is JointKind.FREE), None)
    reflection = WORLD if first is None else sides.mirror.reflection[sides.link(first)]
    root = 0 if sides.figure.root is None else sides.figure.root.body
    return row.change(
        root=_root(row.root, reflection, sides.rest(root, root)),
        roots=dict(_further_root(name, table, sides) for name, table in row.roots.items()),
        joints=dict(_joint(name, value, sides) for name, value in row.joints.items()),
        sites={sides.other(name): _flip(value, POLAR) for name, value in row.sites.items()},
        bodies={sides.other(name): _body(name, value, sides) for name, value in row.bodies.items()},
    )


def _further_root(name: str, table: RootTable, sides: _Sides) -> tuple[str, RootTable]:
    link, mirror = sides.link(name), sides.mirror
    partner = sides.figure.links[mirror.partner[link]]
    return partner.name, _root(table, mirror.reflection[link], sides.rest(sides.figure.links[link].body, partner.body))


def _root(table: RootTable, reflection: Array, rest: Array) -> RootTable:
    position = table.position if table.position == "free" else _flip(table.position, POLAR)
    rotation_ = table.rotation if table.rotation == "free" else _in_world(table.rotation, reflection, rest)
    return table.change(position=position, rotation=rotation_)


def _body(name: str, table: BodyTable, sides: _Sides) -> BodyTable:
    reflection, body, other = sides.reflection(name), sides.places.body(name), sides.places.body(sides.other(name))
    at = None if table.at is None else tuple((reflection @ np.array(table.at)).tolist())
    return _mirror_places(_in_world(table, reflection, sides.rest(body or 0, other or 0)), "position").change(at=at)


def _joint(name: str, value: RotationTable | float | str, sides: _Sides) -> tuple[str, RotationTable | float | str]:
    mirror, number = sides.mirror, sides.link(name)
    partner = sides.figure.links[mirror.partner[number]]
    if isinstance(value, RotationTable):
        return partner.name, _in_parent(value, mirror.reflection[number])
    if isinstance(value, str):
        return partner.name, value
    shift = mirror.shift[partner.qpos]
    shift = float(np.degrees(shift)) if partner.kind is JointKind.HINGE else float(shift)
    return partner.name, float(mirror.sense(mirror.partner[number]) * value + shift)


def _in_world(table: Turned, reflection: Array, rest: Array) -> Turned:
    """Return a rotation R in the world as S R Mᵀ, for the reflection M of its frame.

    rest  (2, 4) orientations in the rest pose: of the body, and of that on the other side
    """
    if table.is_heading:
        first, last = quat.matrices(rest)
        is_plain = np.allclose(WORLD @ first @ reflection.T, last, atol=1e-6)
    else:
        is_plain = np.array_equal(reflection, WORLD)
    if is_plain or not table.is_rotation:
        return _rotation(table)
    matrix = WORLD @ quat.matrices(table.quaternion(rest[0])) @ reflection.T
    return _with_rotation(table, quat.from_matrix(matrix))


def _in_parent(table: RotationTable, reflection: Array) -> RotationTable:
    """Return a ball joint's rotation about the reflected axis, for the reflection M of its frame."""
    if np.array_equal(reflection, WORLD):
        return _rotation(table)
    quaternion = table.quaternion()
    return _with_rotation(table, np.concatenate([quaternion[:1], -reflection @ quaternion[1:]]))


def _with_rotation(table: Turned, quaternion: Array) -> Turned:
    names = {*RotationTable.model_fields, *({"flat"} & table.model_fields_set)}
    return table.without(*names).change(rotvec=RotationTable.of(quaternion).rotvec)


def _rotation(table: Turned) -> Turned:
    """Return a rotation mirrored in its notation, for frames aligned with the world."""
    signs = [AXIAL["xyz".index(letter)] for letter in table.order or "xyz"]
    return table.change(
        rotvec=None if table.rotvec is None else _flip(table.rotvec, AXIAL),
        quat=None if table.quat is None else _flip(table.quat, TURN),
        euler=None if table.euler is None else list(_flip(table.euler, signs)),
        heading=None if table.heading is None else 0.0 - table.heading,
    )


def _flip(values: Sequence[float | str], signs: Sequence[float] | Array) -> tuple[float | str, ...]:
    """Return numbers with changed signs; "free" is unchanged, and zero has no sign."""
    return tuple(x if isinstance(x, str) else float(sign) * x + 0.0 for x, sign in zip(values, signs, strict=True))
