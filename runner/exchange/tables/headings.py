"""Assignment of a table's columns to components of qpos, by names of this program or of others.

Exact names have precedence. For other names, letter case, punctuation, units in brackets, and words such as `joint`,
`dof` or `pos` around a joint's name are ignored: `root_pos_x`, `base_quat_w`, `left_knee_joint`,
`dof.left_knee [deg]`. The root may have the name of its joint or body, or root, base, pelvis and the like. Numbered
columns are taken in their order.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.root import root_of

from ...errors import UserError, listed

UNIT = re.compile(r"[\[(]\s*([^\])]*?)\s*[\])]\s*$")
DEGREES, MILLI = {"deg", "degree", "degrees", "°"}, {"mm", "ms"}
CENTI = {"cm"}
AROUND = {"joint", "joints", "dof", "pos", "position", "q", "qpos", "angle", "value", "jnt", "j", "deg", "rad"}
ROOT = {"root", "base", "pelvis", "torso", "trunk", "hips", "free", "freejoint", "floating", "link", "body", "joint"}
PLACE = {"pos", "position", "p", "t", "trans", "translation", "offset", "xyz", "location", "global", "world", "w"}
TURN = {"quat", "quaternion", "rot", "rotation", "orientation", "q", "r", "ori", "global", "world", "w"}
TIMES = {"time", "t", "timestamp", "sec", "seconds", "times"}
NUMBERED = re.compile(r"^(.*?)[\W_]*([0-9]+)\W*$")


def resolve(
    model: mujoco.MjModel, components: Sequence[str], names: Sequence[str], numbers: Array, where: object
) -> tuple[Array, Array | None, bool, tuple[str, ...]]:
    """Return the configurations in a table with named columns.

    Args:
        components: (nq,) names of the components of qpos in this program.
        names: (n,) of the table's columns.
        numbers: (T, n) the table.
        where: Label of the file in errors.

    Returns:
        qpos (T, nq) [m, rad], the times (T,) [s] or None, whether columns are only numbered, so that their order is the
        file's, and notes.

    Raises:
        UserError: A component has no column, or several.
    """
    units = [(match[1].lower() if (match := UNIT.search(name)) else "") for name in names]
    bare = [name if name in components else UNIT.sub("", name).strip() for name in names]
    for name in dict.fromkeys([*components, "time"]):
        _check_single(name, bare, numbers, where)
    exact = {name: bare.index(name) for name in components if name in bare}
    matched = set(exact.values())
    aliases = _aliases(model, components, [(i, name) for i, name in enumerate(bare) if i not in matched], where)
    places = {**{name: place for name, place in aliases.items() if name not in exact}, **exact}
    is_numbered = False
    if len(places) < len(components):
        numbered = _numbered(components, places, [(i, name) for i, name in enumerate(bare) if i not in places.values()])
        is_numbered, places = bool(numbered), places | numbered
    missing = [name for name in components if name not in places]
    if missing:
        lacking = listed((f"'{name}'" for name in missing), 1)
        raise UserError(
            f"{where}: no column {lacking}; the figure's columns: {', '.join(components)}; "
            f"the file's: {', '.join(names)}"
        )
    others = [f"{names[place]} for {name}" for name, place in places.items() if name not in exact]
    notes = []
    if others:
        notes.append(f"columns by other names: {listed(others, 4)}")
    hinges = {components[int(model.jnt_qposadr[j])] for j in range(model.njnt) if model.jnt_type[j] == JointKind.HINGE}
    factors = [_factor(units[places[name]], bare[places[name]], is_hinge=name in hinges) for name in components]
    if any(name in hinges and factor != 1 for name, factor in zip(components, factors, strict=True)):
        notes.append("angles in degrees, by their columns' names")
    clock = _clock(bare, units, set(places.values()))
    qpos = numbers[:, [places[name] for name in components]] * np.array(factors)
    return qpos, None if clock is None else numbers[:, clock[0]] * clock[1], is_numbered, tuple(notes)


def _check_single(name: str, bare: Sequence[str], numbers: Array, where: object) -> None:
    """Raise UserError if several columns have a name and differ."""
    columns = [i for i, column in enumerate(bare) if column == name]
    for i in columns[1:]:
        if not np.array_equal(numbers[:, i], numbers[:, columns[0]], equal_nan=True):
            raise UserError(
                f"{where}: columns {columns[0] + 1} and {i + 1} are both '{name}', with different numbers; "
                "remove or rename one of them"
            )


def _factor(unit: str, name: str, *, is_hinge: bool) -> float:
    if is_hinge:
        return float(np.pi / 180) if unit in DEGREES or (not unit and name.lower().endswith(("_deg", ".deg"))) else 1.0
    return 1e-3 if unit in MILLI else 1e-2 if unit in CENTI else 1.0


def _clock(bare: Sequence[str], units: Sequence[str], taken: set[int]) -> tuple[int, float] | None:
    if "time" in bare:
        place = bare.index("time")
        return place, 1e-3 if units[place] in MILLI else 1.0
    for i, name in enumerate(bare):
        words = _words(name)
        if i not in taken and words and words[0] in TIMES and set(words[1:]) <= {"s", "ms", "sec", "seconds"}:
            return i, 1e-3 if units[i] in MILLI or "ms" in words[1:] else 1.0
    return None


def _words(name: str) -> list[str]:
    """Return the words of a name in lower case, the same for `basePosX` and `base_pos.x`."""
    parts = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name)
    return [word for word in re.split(r"[\W_]+", parts.lower()) if word]


def _aliases(
    model: mujoco.MjModel, components: Sequence[str], columns: Sequence[tuple[int, str]], where: object
) -> dict[str, int]:
    """Return the columns that have other programs' names; raises UserError for ambiguous ones."""
    root = root_of(model)
    out: dict[str, int] = {}

    def claim(name: str, place: int, column: str) -> None:
        if name in out:
            first = next(text for i, text in columns if i == out[name])
            raise UserError(f"{where}: the columns '{first}' and '{column}' could both be '{name}'")
        out[name] = place

    if root is not None and root.is_free:
        joint = root.joints[0]
        root_words = {*_words(model.joint(joint).name), *_words(model.body(root.body).name), *ROOT}
        start = int(model.jnt_qposadr[joint])
        for part, axis in enumerate(("x", "y", "z", "w", "x", "y", "z")):
            for place, text in columns:
                if _is_component(_words(text), axis, root_words, is_turn=part > 2):
                    claim(components[start + part], place, text)
    of_root = set(out.values())
    stems = [(place, text, _stem(text)) for place, text in columns if place not in of_root]
    for joint in np.flatnonzero(np.isin(model.jnt_type, (JointKind.HINGE, JointKind.SLIDE))):
        name = components[int(model.jnt_qposadr[joint])]
        stem = _stem(name)
        for place, text, other in stems:
            if stem and stem == other:
                claim(name, place, text)
    return out


def _is_component(words: list[str], axis: str, root_words: set[str], *, is_turn: bool) -> bool:
    """Return whether a column's words name a component of the root's position or quaternion."""
    if not words:
        return False
    last, before = words[-1], words[:-1]
    letters = {f"q{axis}"} if is_turn else {f"p{axis}", f"t{axis}"}
    kinds = TURN if is_turn else PLACE
    if last not in {axis, *letters} or (is_turn and last == axis and not set(before) & kinds):
        return False
    return set(before) <= root_words | kinds


def _stem(name: str) -> str:
    """Return a joint's name without the words around it."""
    words = _words(name)
    while words and words[0] in AROUND:
        words = words[1:]
    while words and words[-1] in AROUND:
        words = words[:-1]
    return "_".join(words)


def _numbered(components: Sequence[str], places: dict[str, int], columns: Sequence[tuple[int, str]]) -> dict[str, int]:
    """Return columns for the missing components: the group of equally many columns with one name and a number each."""
    groups: dict[str, list[tuple[int, int]]] = {}
    for i, text in columns:
        if (match := NUMBERED.match(text)) is not None:
            groups.setdefault(match[1].lower(), []).append((int(match[2]), i))
    missing = [name for name in components if name not in places]
    fitting = [sorted(group) for group in groups.values() if len(group) == len(missing)]
    if len(fitting) != 1:
        return {}
    return {name: place for name, (_, place) in zip(missing, fitting[0], strict=True)}
