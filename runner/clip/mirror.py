"""Left and right exchanged in a clip's tables, in the words of the file: angles stay angles, free stays free."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

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
from .table import KEY, RotationTable
from .text import rotation

NEAR = 0.02  # of a figure's size: how far a point may be from the image of its partner
WAYS = {"rotvec", "euler", "order", "quat", "heading"}  # to give a rotation
KNOWN = {
    "keyframe": {"time", "root", "roots", "joints", "sites", "bodies", "others"},
    "scene": {"step", "box", "sphere", "capsule", "cylinder"},
    "root": {"position", "rotation"},
}


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
        found = self._nearest(name, self.places.alike(name))
        if found is None:
            raise UserError(f"'{name}': nothing like it on the other side; mirror the solved motion instead")
        return found

    def _nearest(self, name: str, names: list[str]) -> str | None:
        """Of names the point that is nearest to a point's image, on the partner of its link; None without any."""
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


def mirrored_tables(clip: dict[str, Any], figure: Figure, mirror: Mirror) -> dict[str, Any]:
    """A clip's tables for the mirrored figure; step and obstacles, which have places, change sides as well."""
    for others in dict.fromkeys(str(row.get("others")) for row in clip["keyframe"]):
        _check_symmetric(others, figure, mirror)
    if "recording" in clip:
        raise UserError("recording: what a clip follows has no mirror image; mirror the solved motion: -o NAME.npz")
    sides = _Sides.of(figure, mirror)
    out: dict[str, Any] = clip | {"keyframe": [_keyframe(row, sides) for row in clip["keyframe"]]}
    if "scene" in clip:
        _check_known("scene", clip["scene"])
        out["scene"] = {kind: _obstacles(said) for kind, said in clip["scene"].items()}
    if "contact" in clip:
        out["contact"] = [_placed(row | {"point": sides.other(row["point"])}) for row in clip["contact"]]
    if "hold" in clip:
        other = [row | {key: sides.other(row[key]) for key in ("hand", "body")} for row in clip["hold"]]
        out["hold"] = [_placed(row) for row in other]
    if clip.get("solve", {}).get("travel") is not None:
        out["solve"] = clip["solve"] | {"travel": _signed(clip["solve"]["travel"], POLAR)}
    if clip.get("solve", {}).get("turn") is not None:
        out["solve"] = out["solve"] | {"turn": 0.0 - clip["solve"]["turn"]}
    if "penalty" in clip:
        out["penalty"] = [_renamed(entry, sides) for entry in clip["penalty"]]
    return out


def mirrored_keyframe(row: dict[str, Any], figure: Figure, mirror: Mirror) -> dict[str, Any]:
    """One keyframe's table for the mirrored figure."""
    _check_symmetric(str(row.get("others")), figure, mirror)
    return _keyframe(row, _Sides.of(figure, mirror))


def _check_symmetric(others: str, figure: Figure, mirror: Mirror) -> None:
    """Raises UserError where what a keyframe does not name is as in a pose that is not symmetric."""
    if others != "rest" and not others.startswith(KEY):
        return
    qpos = figure.model.qpos0 if others == "rest" else figure.model.key(others.removeprefix(KEY)).qpos
    if not _is_symmetric(np.array(qpos), mirror):
        what = "the figure's rest" if others == "rest" else f"the model's key '{others.removeprefix(KEY)}'"
        raise UserError(f"{what} is no mirror image of itself: specify every joint instead of others = '{others}'")


def _is_symmetric(qpos: Array, mirror: Mirror) -> bool:
    """Whether a configuration (nq,) is the mirror image of itself."""
    image = mirror.configurations(qpos)
    for link in mirror.figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None and image[columns] @ qpos[columns] < 0:
            image[columns] *= -1
    return bool(np.allclose(image, qpos, atol=1e-9))


def _check_known(table: str, entries: dict[str, Any]) -> None:
    """What this does not know may have sides, too."""
    for key in entries:
        if key not in KNOWN[table]:
            raise UserError(f"{table}: '{key}' has no mirror image yet; mirror the solved motion instead")


def _obstacles(said: Any) -> Any:
    """The step, or the obstacles of one kind, on the other side."""
    if isinstance(said, dict):
        return said | {"y": -said["y"]} if "y" in said else said
    return [_placed(row) for row in said]


def _placed(row: dict[str, Any]) -> dict[str, Any]:
    """A table with a place of its own, where its reflection is."""
    places = ("position", "from", "to")
    out = row | {key: _signed(row[key], POLAR) for key in places if isinstance(row.get(key), list | tuple)}
    return out | {"rotation": _rotation(row["rotation"])} if row.get("rotation") else out


def _body(name: str, table: dict[str, Any], sides: _Sides) -> dict[str, Any]:
    """How a body is turned and where it is, or a point in its axes, said of the one on the other side."""
    out = _in_world(table, sides.reflection(name))
    if table.get("position") is not None:
        out["position"] = _signed(table["position"], POLAR)
    if table.get("at") is not None:
        out["at"] = (sides.reflection(name) @ np.array(table["at"], float)).tolist()
    return out


def _renamed(entry: dict[str, Any], sides: _Sides) -> dict[str, Any]:
    """A penalty for the points, joints and bodies of the other side, an axis of these in their own axes there."""
    lists = ("points", "bend_joints", "bodies")
    out = entry | {key: [sides.other(name) for name in entry[key]] for key in lists if entry.get(key)}
    if entry.get("axis") is None or not entry.get("bodies"):
        return out
    axes = [(sides.reflection(name) @ np.array(entry["axis"], float)).tolist() for name in entry["bodies"]]
    if not np.allclose(axes, axes[0], atol=1e-9):
        raise UserError(f"penalty '{entry['kind']}': bodies that are turned differently share no mirrored axis")
    return out | {"axis": axes[0]}


def _keyframe(row: dict[str, Any], sides: _Sides) -> dict[str, Any]:
    _check_known("keyframe", row)
    out = dict(row)
    if "root" in row:
        first = next((link.name for link in sides.figure.links[1:] if link.kind is JointKind.FREE), None)
        out["root"] = _root(row["root"], WORLD if first is None else sides.mirror.reflection[sides.link(first)])
    if "roots" in row:
        out["roots"] = dict(_further_root(name, table, sides) for name, table in row["roots"].items())
    if "joints" in row:
        out["joints"] = dict(_joint(name, value, sides) for name, value in row["joints"].items())
    if "sites" in row:
        out["sites"] = {sides.other(name): _site(value) for name, value in row["sites"].items()}
    if "bodies" in row:
        out["bodies"] = {sides.other(name): _body(name, value, sides) for name, value in row["bodies"].items()}
    return out


def _further_root(name: str, table: dict[str, Any], sides: _Sides) -> tuple[str, dict[str, Any]]:
    """A further free joint's name and table."""
    link, mirror = sides.link(name), sides.mirror
    return sides.figure.links[mirror.partner[link]].name, _root(table, mirror.reflection[link])


def _root(table: dict[str, Any], reflection: Array) -> dict[str, Any]:
    """A free joint's place on the other side."""
    _check_known("root", table)
    out = dict(table)
    if table.get("position", "free") != "free":
        out["position"] = _signed(table["position"], POLAR)
    if table.get("rotation", "free") != "free":
        out["rotation"] = _in_world(table["rotation"], reflection)
    return out


def _site(value: Any) -> Any:
    """Where a site is to be: a position, or a table with one."""
    if isinstance(value, dict):
        return value | {"position": _signed(value["position"], POLAR)}
    return _signed(value, POLAR)


def _joint(name: str, value: Any, sides: _Sides) -> tuple[str, Any]:
    """What a keyframe says of one joint, said of its partner."""
    mirror, number = sides.mirror, sides.link(name)
    partner = sides.figure.links[mirror.partner[number]]
    if isinstance(value, dict):
        return partner.name, _in_parent(value, mirror.reflection[number])
    if value == "free":
        return partner.name, value
    shift = mirror.shift[partner.qpos]
    shift = float(np.degrees(shift)) if partner.kind is JointKind.HINGE else float(shift)
    return partner.name, mirror.sense(mirror.partner[number]) * value + shift


def _in_world(table: dict[str, Any], reflection: Array) -> dict[str, Any]:
    """A rotation R in the world as S R Mᵀ, for the reflection M of its frame."""
    if np.array_equal(reflection, WORLD) or not WAYS & set(table):
        return _rotation(table)
    matrix = WORLD @ quat.matrices(_quaternion(table)) @ reflection.T
    return _without_rotation(table) | rotation(quat.from_matrix(matrix))


def _in_parent(table: dict[str, Any], reflection: Array) -> dict[str, Any]:
    """A ball joint's rotation: about an axis and by an angle that the reflection M of its frame takes to the other."""
    if np.array_equal(reflection, WORLD):
        return _rotation(table)
    quaternion = _quaternion(table)
    return _without_rotation(table) | rotation(np.concatenate([quaternion[:1], -reflection @ quaternion[1:]]))


def _quaternion(table: dict[str, Any]) -> Array:
    return quaternion_of(RotationTable(**{key: value for key, value in table.items() if key in WAYS}))


def _without_rotation(table: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key not in WAYS}


def _rotation(table: dict[str, Any]) -> dict[str, Any]:
    """A rotation vector and a quaternion by their entries, Euler angles by their axes."""
    out = dict(table)
    if table.get("rotvec") is not None:
        out["rotvec"] = _signed(table["rotvec"], AXIAL)
    if table.get("quat") is not None:
        out["quat"] = _signed(table["quat"], TURN)
    if table.get("euler") is not None:
        signs = [AXIAL["xyz".index(letter)] for letter in table.get("order") or "xyz"]
        out["euler"] = _signed(table["euler"], signs)
    if table.get("heading") is not None:
        out["heading"] = 0.0 - table["heading"]
    return out


def _signed(values: Any, signs: Any) -> list[Any]:
    """Numbers with signs changed; "free" stays, and a zero has no sign."""
    return [x if x == "free" else float(sign) * x + 0.0 for x, sign in zip(values, signs, strict=True)]
