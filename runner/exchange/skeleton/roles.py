"""Which part of a body a joint is, by its name and its place in the tree: for skeletons of many makers.

Words as in the skeletons of CMU, Mixamo, LAFAN1, SFU, ACCAD, Unreal, 3ds Max' Biped, and our own figures.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from ...errors import UserError, unknown

SIDES = {"left": "left", "l": "left", "lft": "left", "right": "right", "r": "right", "rgt": "right", "rt": "right"}
WORDS = {
    "clavicle": ("clavicle", "collar", "collarbone", "shouldercollar"),
    "upper_arm": ("upperarm", "uparm", "uarm", "humerus", "shldr", "armupper", "upperarmlink"),
    "forearm": ("forearm", "lowerarm", "lowarm", "farm", "elbow", "radius", "ulna", "armlower", "loarm"),
    "hand": ("hand", "wrist"),
    "thigh": ("thigh", "upleg", "upperleg", "uleg", "femur", "legupper", "hipthigh"),
    "shin": ("shin", "lowerleg", "lowleg", "calf", "tibia", "knee", "shank", "leglower", "loleg"),
    "foot": ("foot", "ankle", "talus"),
    "toe": ("toe", "toes", "toebase", "ball", "forefoot"),
}
MIDDLE = {
    "neck": ("neck",),
    "head": ("head",),
}
EITHER = {
    "arm": ("upper_arm", "forearm"),
    "leg": ("shin", "thigh"),
    "shoulder": ("clavicle", "upper_arm"),
    "hip": ("thigh",),
}
ONWARD = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot", "foot": "toe"}  # along a limb
KNOWN = {word for words in WORDS.values() for word in words} | set(EITHER)
ROLES = ("pelvis", "chest", *MIDDLE, *(f"{side}_{role}" for side in ("left", "right") for role in WORDS))
AXES = {"pitch", "roll", "yaw"}  # robots have a body for each: hip pitch, hip roll, hip yaw
FILLING = {"link", "joint", "body", *AXES}
PREFIX = re.compile(
    r"^(.*[:|])|^(mixamorig\d*|bip\d*|bip\d+|character\d*|b|def|org|skel|bone|jnt)[ _](?=.)", re.IGNORECASE
)
SPLIT = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def split(name: str) -> tuple[str | None, str]:
    """("left", "forearm") of "mixamorig:LeftForeArm"; the side is None for what is in the middle."""
    before = None
    while before != name:
        before, name = name, PREFIX.sub("", name)
    words = [word.lower() for word in SPLIT.findall(name)]
    words = [word for word in words if word not in FILLING] or words
    for i, word in enumerate(words):
        if word in SIDES and len(words) > 1:
            return SIDES[word], "".join(words[:i] + words[i + 1 :])
    whole = "".join(words)
    for start, side in (("left", "left"), ("right", "right"), ("l", "left"), ("r", "right")):
        if whole.startswith(start) and whole[len(start) :] in KNOWN:
            return side, whole[len(start) :]
    return None, whole


def roles(names: Sequence[str], parents: Sequence[int]) -> dict[str, int]:
    """Index by role: "pelvis", "chest", "neck", "head", "left_upper_arm", ... as far as they are found.

    The pelvis is where the legs come together, the chest where the arms do; parents stand before their children, -1
    above the first. Of several joints that a role fits, it is the first on which the limb goes on: bones of a drawing
    hang beside the skeleton's in some files, "L_Humerus" beside "LeftArm".
    """
    parts = [split(name) for name in names]
    hinged = [bool(AXES.intersection(word.lower() for word in SPLIT.findall(name))) for name in names]
    found: dict[str, int] = {}
    for side in ("left", "right"):
        on = {role: _going_on(role, side, parts, parents) for role in WORDS}
        for role, words in WORDS.items():
            fitting = [i for i, (s, word) in enumerate(parts) if s == side and word in words]
            general = [i for i, part in enumerate(parts) if part[0] == side and role in EITHER.get(part[1], ())]
            at_ends = on[role].isdisjoint(fitting) and not on[role].isdisjoint(general)
            _first(found, f"{side}_{role}", [] if at_ends else _preferred(fitting, on[role]))
        for word, choices in EITHER.items():
            same = [i for i, part in enumerate(parts) if part == (side, word)]
            for role in choices:
                if f"{side}_{role}" not in found and _fits(found, side, role, word, same, parents):
                    _first(found, f"{side}_{role}", _preferred(same, on[role]))
                    break
    for role, words in MIDDLE.items():
        _first(found, role, [i for i, (side, word) in enumerate(parts) if side is None and word in words])
    for role, first in found.items():  # of bodies that turn a hip one after the other, the last is the thigh
        same = [i for i, part in enumerate(parts) if part == parts[first] and hinged[i]]
        if hinged[first] and all(first in lineage(i, parents) for i in same):
            found[role] = max(same, key=lambda i: len(lineage(i, parents)))
    return with_trunk(found, names, parents)


def with_trunk(found: Mapping[str, int], names: Sequence[str], parents: Sequence[int]) -> dict[str, int]:
    """With pelvis and chest, where they are told by the legs and arms that are found."""
    out, words = dict(found), [split(name)[1] for name in names]
    for role, limb in (("pelvis", "thigh"), ("chest", "upper_arm")):
        ends = [found[f"{side}_{limb}"] for side in ("left", "right") if f"{side}_{limb}" in found]
        if len(ends) == 2:
            shared = [i for i in lineage(ends[0], parents)[1:] if i in lineage(ends[1], parents)]
            if shared:
                out[role] = _trunk(role, shared, words)
    return out


def as_said(found: Mapping[str, int], said: Mapping[str, str], names: Sequence[str], whose: str) -> dict[str, int]:
    """Indices by role, as a map has them: a name, or "" for none; raises UserError for a name or role that is not
    there."""
    out = dict(found)
    for role, name in said.items():
        if role not in ROLES:
            raise UserError(f"map: {whose}: {unknown('role', role, ROLES)}")
        out.pop(role, None)
        if name:
            if name not in names:
                raise UserError(f"map: {whose}.{role}: {unknown('body', name, names)}")
            out[role] = list(names).index(name)
    return out


def _trunk(role: str, shared: list[int], words: list[str]) -> int:
    """Where two limbs come together; Biped hangs arms on the neck and legs on the spine."""
    if role == "chest":
        return next((i for i in shared if words[i] != "neck"), shared[0])
    return next((i for i in shared if words[i] in ("pelvis", "hips", "hip")), shared[0])


def _going_on(role: str, side: str, parts: Sequence[tuple[str | None, str]], parents: Sequence[int]) -> set[int]:
    """The joints that carry one that could be the next part of the limb; none at its end."""
    onward = ONWARD.get(role)
    if onward is None:
        return set()
    words = (*WORDS[onward], *(word for word, choices in EITHER.items() if onward in choices))
    ends = [i for i, (s, word) in enumerate(parts) if s == side and word in words]
    return {above for end in ends for above in lineage(end, parents)[1:]}


def _preferred(fitting: list[int], on: set[int]) -> list[int]:
    """Those first on which the limb goes on."""
    return sorted(fitting, key=lambda i: i not in on)


def _first(found: dict[str, int], role: str, fitting: list[int]) -> None:
    if fitting:
        found[role] = fitting[0]


def _fits(found: dict[str, int], side: str, role: str, word: str, same: list[int], parents: Sequence[int]) -> bool:
    """An "arm" is the upper arm above a forearm and the forearm below an upper arm, a "shoulder" its collar."""
    if not same:
        return False
    if word == "shoulder" and role == "clavicle":
        below = found.get(f"{side}_upper_arm")
        return below is not None and same[0] in lineage(below, parents)
    if word in ("arm", "leg"):
        above = found.get(f"{side}_{'upper_arm' if role == 'forearm' else 'thigh'}")
        if role in ("forearm", "shin"):
            return above is not None and above in lineage(same[0], parents)[1:]
    return True


def lineage(index: int, parents: Sequence[int]) -> list[int]:
    """A joint and all above it."""
    out = []
    while index >= 0:
        out.append(index)
        index = parents[index]
    return out
