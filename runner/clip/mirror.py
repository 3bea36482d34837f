"""Left and right exchanged in a clip's tables, in the notation of the file: angles stay angles, free stays free."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.mirror import AXIAL, POLAR, TURN, Mirror
from dynsplines.solver.curve.symmetry import WORLD, other_side
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.surface.points import Point

from ..errors import UserError
from .posing.feet import sole_points
from .posing.places import Places
from .posing.rotation import quaternion_of
from .table import (
    KEY,
    Axes,
    BarTable,
    BodyTable,
    BoxTable,
    ClipTable,
    KeyframeTable,
    PenaltyTable,
    RootTable,
    RotationTable,
    SceneTable,
    SiteTable,
    SolveTable,
    SphereTable,
    Table,
)
from .text import rotation

Placed = TypeVar("Placed", bound=Table)
Obstacle = TypeVar("Obstacle", BoxTable, SphereTable, BarTable)
Turned = TypeVar("Turned", bound=RotationTable)

NEAR = 0.02  # of a figure's size: how far a point may be from the image of its partner


@dataclass(frozen=True)
class _Sides:
    """A figure's names, and what is on the other side of each."""

    places: Places
    mirror: Mirror

    @classmethod
    def of(cls, figure: Figure, mirror: Mirror) -> _Sides:
        return cls(Places(figure, sole_points(figure, np.zeros((0, figure.width)))), mirror)

    @property
    def figure(self) -> Figure:
        return self.places.figure

    def link(self, name: str) -> int:
        """The link of this name."""
        return next(i for i, link in enumerate(self.figure.links) if i and link.name == name)

    def other(self, name: str) -> str:
        """The site, foot, geom, body or joint on the other side; itself in the middle, or where the figure lacks it."""
        body, other = self.places.body(name), other_side(name)
        if body is None:
            return name
        partner = self.mirror.partner[self.figure.body_link[body]]
        there = self.places.body(other)
        if other != name and there is not None and self.figure.body_link[there] == partner:
            is_sole = name in self.places.soles and self.places.point(name) is self.places.soles[name]
            return self._nearest(name, list(self.places.soles)) or other if is_sole else other
        if not self.places.alike(name):  # the name of a joint
            return self.figure.links[self.mirror.partner[self.link(name)]].name
        counterpart = self._nearest(name, self.places.alike(name))
        if counterpart is None:
            raise UserError(f"'{name}': it has no counterpart on the other side; mirror the solved motion instead")
        return counterpart

    def _nearest(self, name: str, names: list[str]) -> str | None:
        """The name of the point nearest to a point's mirror image, on its partner link; None without any."""
        point = self._point(name)
        partner, image = self.mirror.partner[point.link], self.mirror.reflection[point.link] @ point.position
        away = {
            other: float(np.linalg.norm(there.position - image))
            for other in names
            if (there := self._point(other)).link == partner
        }
        best = min(away, key=lambda candidate: (away[candidate], candidate != name), default=None)
        return best if best is not None and away[best] <= NEAR * self.mirror.size else None

    def _point(self, name: str) -> Point:
        """A site, a foot, the middle of a geom or the origin of a body."""
        point = self.places.point(name)
        assert point is not None
        return point

    def reflection(self, name: str) -> Array:
        """(3, 3) from the frame of a body to that of the body on the other side."""
        body, other = self.places.body(name), self.places.body(self.other(name))
        return WORLD if body is None or other is None else self.mirror.of_bodies(body, other)


def mirrored_tables(clip: ClipTable, figure: Figure, mirror: Mirror) -> ClipTable:
    """Return a clip's tables for the mirrored figure; step and obstacles, which have places, change sides as well.

    Raises:
        UserError: for a clip without a mirror image.
    """
    for others in dict.fromkeys(row.others for row in clip.keyframe):
        _check_symmetric(others, figure, mirror)
    if clip.recording is not None:
        raise UserError("recording: such a clip cannot be mirrored; mirror the solved motion: -o NAME.npz")
    sides = _Sides.of(figure, mirror)
    return clip.changed(
        scene=_scene(clip.scene),
        solve=_solve(clip.solve),
        penalty=[_penalty(entry, sides) for entry in clip.penalty],
        contact=[_placed(row.changed(point=sides.other(row.point)), "position") for row in clip.contact],
        hold=[
            _placed(row.changed(hand=sides.other(row.hand), body=sides.other(row.body)), "position")
            for row in clip.hold
        ],
        keyframe=[_keyframe(row, sides) for row in clip.keyframe],
    )


def mirrored_keyframe(row: KeyframeTable, figure: Figure, mirror: Mirror) -> KeyframeTable:
    """Return one keyframe's table for the mirrored figure.

    Raises:
        UserError: for a keyframe without a mirror image.
    """
    _check_symmetric(row.others, figure, mirror)
    return _keyframe(row, _Sides.of(figure, mirror))


def _check_symmetric(others: str, figure: Figure, mirror: Mirror) -> None:
    """Raises UserError where what a keyframe does not name is as in a pose that is not symmetric."""
    if others != "rest" and not others.startswith(KEY):
        return
    qpos = figure.model.qpos0 if others == "rest" else figure.model.key(others.removeprefix(KEY)).qpos
    if not _is_symmetric(np.array(qpos), mirror):
        what = "the figure's rest" if others == "rest" else f"the model's key '{others.removeprefix(KEY)}'"
        raise UserError(f"{what} is not symmetric: specify every joint instead of others = '{others}'")


def _is_symmetric(qpos: Array, mirror: Mirror) -> bool:
    """Whether a configuration (nq,) is the mirror image of itself."""
    image = mirror.configurations(qpos)
    for link in mirror.figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None and image[columns] @ qpos[columns] < 0:
            image[columns] *= -1
    return bool(np.allclose(image, qpos, atol=1e-9))


def _scene(scene: SceneTable) -> SceneTable:
    """The obstacles on the other side."""
    step = None if scene.step is None else scene.step.changed(y=0.0 - scene.step.y)
    return scene.changed(
        step=step,
        box=[_obstacle(row, "position") for row in scene.box],
        sphere=[_obstacle(row, "position") for row in scene.sphere],
        capsule=[_obstacle(row, "position", "start", "end") for row in scene.capsule],
        cylinder=[_obstacle(row, "position", "start", "end") for row in scene.cylinder],
    )


def _obstacle(row: Obstacle, *places: str) -> Obstacle:
    out = _placed(row, *places)
    return out if out.rotation is None else out.changed(rotation=_rotation(out.rotation))


def _solve(solve: SolveTable) -> SolveTable:
    """The displacement of a loop on the other side."""
    return _placed(solve, "travel").changed(turn=None if solve.turn is None else 0.0 - solve.turn)


def _placed(row: Placed, *names: str) -> Placed:
    """A table with the places (3,) of some keys on the other side."""
    return row.changed(**{name: _signed(place, POLAR) for name in names if (place := getattr(row, name)) is not None})


def _penalty(entry: PenaltyTable, sides: _Sides) -> PenaltyTable:
    """A penalty for the points, joints and bodies of the other side, an axis of these in their frames there."""
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
    return row.changed(
        root=_root(row.root, reflection),
        roots=dict(_further_root(name, table, sides) for name, table in row.roots.items()),
        joints=dict(_joint(name, value, sides) for name, value in row.joints.items()),
        sites={sides.other(name): _site(value) for name, value in row.sites.items()},
        bodies={sides.other(name): _body(value, sides.reflection(name)) for name, value in row.bodies.items()},
    )


def _further_root(name: str, table: RootTable, sides: _Sides) -> tuple[str, RootTable]:
    """The name and the table of another free joint."""
    link, mirror = sides.link(name), sides.mirror
    return sides.figure.links[mirror.partner[link]].name, _root(table, mirror.reflection[link])


def _root(table: RootTable, reflection: Array) -> RootTable:
    """The place of a free joint on the other side."""
    position = table.position if table.position == "free" else _signed(table.position, POLAR)
    rotation_ = table.rotation if table.rotation == "free" else _in_world(table.rotation, reflection)
    return table.changed(position=position, rotation=rotation_)


def _body(table: BodyTable, reflection: Array) -> BodyTable:
    """The rotation and the place of a body, or of a point in its frame, for the one on the other side."""
    at = None if table.at is None else tuple((reflection @ np.array(table.at)).tolist())
    return _placed(_in_world(table, reflection), "position").changed(at=at)


def _site(value: SiteTable | Axes) -> SiteTable | tuple[float | str, ...]:
    return _placed(value, "position") if isinstance(value, SiteTable) else _signed(value, POLAR)


def _joint(name: str, value: RotationTable | float | str, sides: _Sides) -> tuple[str, RotationTable | float | str]:
    """The entry of a joint, for its partner."""
    mirror, number = sides.mirror, sides.link(name)
    partner = sides.figure.links[mirror.partner[number]]
    if isinstance(value, RotationTable):
        return partner.name, _in_parent(value, mirror.reflection[number])
    if isinstance(value, str):
        return partner.name, value
    shift = mirror.shift[partner.qpos]
    shift = float(np.degrees(shift)) if partner.kind is JointKind.HINGE else float(shift)
    return partner.name, float(mirror.sense(mirror.partner[number]) * value + shift)


def _in_world(table: Turned, reflection: Array) -> Turned:
    """A rotation R in the world as S R Mᵀ, for the reflection M of its frame."""
    if np.array_equal(reflection, WORLD) or not table.is_rotation:
        return _rotation(table)
    matrix = WORLD @ quat.matrices(quaternion_of(table)) @ reflection.T
    return _with_rotation(table, quat.from_matrix(matrix))


def _in_parent(table: RotationTable, reflection: Array) -> RotationTable:
    """A ball joint's rotation: about an axis and by an angle that the reflection M of its frame takes to the other."""
    if np.array_equal(reflection, WORLD):
        return _rotation(table)
    quaternion = quaternion_of(table)
    return _with_rotation(table, np.concatenate([quaternion[:1], -reflection @ quaternion[1:]]))


def _with_rotation(table: Turned, quaternion: Array) -> Turned:
    return table.without(*RotationTable.model_fields).changed(rotvec=rotation(quaternion).rotvec)


def _rotation(table: Turned) -> Turned:
    """A rotation vector and a quaternion by their entries, Euler angles by their axes."""
    signs = [AXIAL["xyz".index(letter)] for letter in table.order or "xyz"]
    return table.changed(
        rotvec=None if table.rotvec is None else _signed(table.rotvec, AXIAL),
        quat=None if table.quat is None else _signed(table.quat, TURN),
        euler=None if table.euler is None else list(_signed(table.euler, signs)),
        heading=None if table.heading is None else 0.0 - table.heading,
    )


def _signed(values: Sequence[float | str], signs: Sequence[float] | Array) -> tuple[float | str, ...]:
    """Numbers with signs changed; "free" stays, and a zero has no sign."""
    return tuple(x if isinstance(x, str) else float(sign) * x + 0.0 for x, sign in zip(values, signs, strict=True))
