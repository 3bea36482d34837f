"""Left and right exchanged in a clip's tables, in the words of the file: angles stay angles, free stays free."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.mirror import AXIAL, POLAR, TURN, Mirror, other_side
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.surface.points import Point

from ..errors import UserError
from .posing.feet import sole_points
from .posing.places import Places, places_at

KNOWN = {
    "keyframe": {"time", "root", "roots", "joints", "sites", "bodies", "others"},
    "scene": {"step", "box", "sphere", "capsule", "cylinder"},
    "root": {"position", "rotation"},
}


def mirrored_tables(clip: dict[str, Any], figure: Figure, mirror: Mirror) -> dict[str, Any]:
    """A clip's tables for the mirrored figure; step and obstacles, which have places, change sides as well."""
    rest = np.array(figure.model.qpos0)
    if any(row.get("others") == "rest" for row in clip["keyframe"]) and not np.allclose(
        mirror.states(rest), rest, atol=1e-9
    ):
        raise UserError("the figure's rest is no mirror image of itself: say every joint instead of others = 'rest'")
    if "recording" in clip:
        raise UserError("recording: what a clip follows has no mirror image; mirror the solved motion: -o NAME.npz")
    places = Places(figure, sole_points(figure, np.zeros((0, figure.width))))
    out: dict[str, Any] = clip | {"keyframe": [_keyframe(row, places, mirror) for row in clip["keyframe"]]}
    if "scene" in clip:
        _check_known("scene", clip["scene"])
        out["scene"] = {kind: _obstacles(said) for kind, said in clip["scene"].items()}
    if "contact" in clip:
        out["contact"] = [_placed(row | {"point": _other(row["point"], places)}) for row in clip["contact"]]
    if "hold" in clip:
        other = [row | {key: _other(row[key], places) for key in ("hand", "body")} for row in clip["hold"]]
        out["hold"] = [_placed(row) for row in other]
    if clip.get("solve", {}).get("travel") is not None:
        out["solve"] = clip["solve"] | {"travel": _signed(clip["solve"]["travel"], POLAR)}
    if clip.get("solve", {}).get("turn") is not None:
        out["solve"] = out["solve"] | {"turn": 0.0 - clip["solve"]["turn"]}
    if "penalty" in clip:
        out["penalty"] = [_renamed(entry, places) for entry in clip["penalty"]]
    return out


def mirrored_keyframe(row: dict[str, Any], figure: Figure, mirror: Mirror) -> dict[str, Any]:
    """One keyframe's table for the mirrored figure."""
    return _keyframe(row, Places(figure, sole_points(figure, np.zeros((0, figure.width)))), mirror)


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


def _other(name: str, places: Places) -> str:
    """The site, foot, geom, body or joint on the other side; itself where there is none."""
    other = other_side(name)
    if name in places.soles and places.point(name) is places.soles[name] and other != name:
        return _other_sole(name, places.figure, list(places.soles.values()))
    return other if places.body(other) is not None else name


def _other_sole(name: str, figure: Figure, soles: Sequence[Point]) -> str:
    """The sole point that is nearest to where another one is seen in the mirror, at rest."""
    found = places_at(figure, figure.model.qpos0, soles)
    seen = found[:, [point.name for point in soles].index(name)] * POLAR
    return soles[int(np.linalg.norm(found - seen[:, None], axis=0).argmin())].name


def _body(name: str, table: dict[str, Any], places: Places) -> dict[str, Any]:
    """How a body is turned and where it is, or a point in its axes, said of the one on the other side."""
    out = _rotation(table)
    if table.get("position") is not None:
        out["position"] = _signed(table["position"], POLAR)
    if table.get("at") is not None:
        out["at"] = _on_the_other(name, table["at"], places)
    return out


def _on_the_other(name: str, vector: Sequence[float], places: Places) -> list[float]:
    """A vector in a body's axes as the body on the other side has it."""
    own, other = (_turn_at_rest(places.figure.model, places.body(which)) for which in (name, _other(name, places)))
    return (other.T @ (POLAR * (own @ np.array(vector, float)))).tolist()


def _turn_at_rest(model: mujoco.MjModel, body: int | None) -> Array:
    """(3, 3) a body's axes in the world at rest."""
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    return data.xmat[body or 0].reshape(3, 3).copy()


def _renamed(entry: dict[str, Any], places: Places) -> dict[str, Any]:
    """A penalty for the points, joints and bodies of the other side, an axis of these in their own axes there."""
    sides = ("points", "joints", "bodies")
    out = entry | {key: [_other(name, places) for name in entry[key]] for key in sides if entry.get(key)}
    if entry.get("axis") is None or not entry.get("bodies"):
        return out
    axes = [_on_the_other(name, entry["axis"], places) for name in entry["bodies"]]
    if not np.allclose(axes, axes[0], atol=1e-9):
        raise UserError(f"penalty '{entry['kind']}': bodies that are turned differently share no mirrored axis")
    return out | {"axis": axes[0]}


def _keyframe(row: dict[str, Any], places: Places, mirror: Mirror) -> dict[str, Any]:
    _check_known("keyframe", row)
    out = dict(row)
    if "root" in row:
        out["root"] = _root(row["root"])
    if "roots" in row:
        out["roots"] = {_other(name, places): _root(table) for name, table in row["roots"].items()}
    if "joints" in row:
        out["joints"] = dict(_joint(name, value, places.figure, mirror) for name, value in row["joints"].items())
    if "sites" in row:
        out["sites"] = {_other(name, places): _site(value) for name, value in row["sites"].items()}
    if "bodies" in row:
        out["bodies"] = {_other(name, places): _body(name, value, places) for name, value in row["bodies"].items()}
    return out


def _root(table: dict[str, Any]) -> dict[str, Any]:
    """A free joint's place on the other side."""
    _check_known("root", table)
    out = dict(table)
    if table.get("position", "free") != "free":
        out["position"] = _signed(table["position"], POLAR)
    if table.get("rotation", "free") != "free":
        out["rotation"] = _rotation(table["rotation"])
    return out


def _site(value: Any) -> Any:
    """Where a site is to be: a position, or a table with one."""
    if isinstance(value, dict):
        return value | {"position": _signed(value["position"], POLAR)}
    return _signed(value, POLAR)


def _joint(name: str, value: Any, figure: Figure, mirror: Mirror) -> tuple[str, Any]:
    """What a keyframe says of one joint, said of its partner."""
    number = next(i for i, link in enumerate(figure.links) if i and link.name == name)
    partner = figure.links[mirror.partner[number]]
    if isinstance(value, dict):
        return partner.name, _rotation(value)
    if value == "free":
        return partner.name, value
    shift = mirror.shift[partner.qpos]
    shift = float(np.degrees(shift)) if partner.kind is JointKind.HINGE else float(shift)
    return partner.name, float(mirror.sign[partner.qpos]) * value + shift


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
