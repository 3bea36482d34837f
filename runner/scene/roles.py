"""Which part of the body a joint is, by its name and its position in the tree.

The words are those of skeletons from CMU, Mixamo, LAFAN1, SFU, ACCAD, Unreal, 3ds Max' Biped, VRM, VRoid, MMD, Rigify,
Daz, Character Creator, OptiTrack, Second Life, Kinect and SMPL, and those of the shipped figures.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from ..errors import UserError, unknown

SIDES = ("left", "right")
SIDE_WORDS = {"left": "left", "l": "left", "lft": "left", "right": "right", "r": "right", "rgt": "right", "rt": "right",
         "hidari": "left", "migi": "right"}  # fmt: skip
WORDS = {role: tuple(words.split()) for role, words in {
    "clavicle": "clavicle collar collarbone shouldercollar thorax",
    "upper_arm": "upperarm uparm uarm humerus shldr shldrbend upperarmbend ude armupper upperarmlink",
    "forearm": "forearm lowerarm lowarm farm forearmbend elbow hiji radius ulna armlower loarm",
    "hand": "hand wrist tekubi",
    "thigh": "thigh upleg upperleg uleg femur legupper hipthigh thighbend ashi",
    "shin": "shin lowerleg lowleg calf tibia knee hiza shank leglower loleg",
    "foot": "foot ankle talus ashikubi",
    "toe": "toe toes toebase ball forefoot tsumasaki",
}.items()}  # fmt: skip
MIDDLE = {
    "neck": ("neck", "kubi", "necklower", "lowerneck", "necktwist"),
    "head": ("head", "atama"),
}
EITHER = {
    "arm": ("upper_arm", "forearm"),
    "leg": ("shin", "thigh"),
    "shoulder": ("clavicle", "upper_arm"),
    "hip": ("thigh",),
}
ONWARD = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot", "foot": "toe"}  # next in a limb
KNOWN = {word for words in WORDS.values() for word in words} | set(EITHER)
ROLES = ("pelvis", "chest", *MIDDLE, *(f"{side}_{role}" for side in ("left", "right") for role in WORDS))
NEEDED = ("left_thigh", "right_thigh", "left_shin", "right_shin")  # required for retargeting
AXES = {"pitch", "roll", "yaw"}  # robots have a body for each: hip pitch, hip roll, hip yaw
FILLING = {"link", "joint", "body", "jnt", "bone", "bind", *AXES}
PREFIX = re.compile(
    r"^(.*[:|])|^(valvebiped\.|mixamorig\d*(?=[A-Z])|(?-i:m(?=[A-Z])))"
    r"|^(mixamorig\d*|j_bip(_c)?|bip\d*|bip\d+|character\d*|b|def|org|skel|bone|jnt|c)[ _-](?=.)",
    re.IGNORECASE,
)
SECONDARY = re.compile(r"^(.*[:|])?(j_)?(sec|adj|opt)_", re.IGNORECASE)  # VRoid: hair, skirts, helpers
SEPARATORS = re.compile(r"[ _:.|-]+")
SHARED = 0.8  # least fraction of the names with a common prefix, which is the name of a character
CJK = {  # names in MMD and Chinese rigs without their side; matched as a whole, which excludes IK and twist bones
    "肩": "clavicle", "腕": "upperarm", "上腕": "upperarm", "上臂": "upperarm", "ひじ": "elbow", "肘": "elbow",
    "前腕": "forearm", "前臂": "forearm", "手首": "wrist", "手": "hand", "足": "thigh", "太もも": "thigh",
    "大腿": "thigh", "ひざ": "knee", "膝": "knee", "小腿": "shin", "足首": "ankle", "脚": "foot", "つま先": "toe",
    "足先EX": "toe", "首": "neck", "頭": "head", "头": "head", "下半身": "lowerbody", "上半身": "upperbody",
}  # fmt: skip
CJK_SIDE = {"左": "left", "右": "right"}
LATIN_SIDE = re.compile(r"^(.*?)[ _.]([LR])$", re.IGNORECASE)
SPLIT = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def split(name: str) -> tuple[str | None, str]:
    """Return side and word of a name: ("left", "forearm") for "mixamorig:LeftForeArm"; None as side in the middle."""
    if SECONDARY.match(name):
        return None, ""
    before, name = None, unicodedata.normalize("NFKC", name)
    while before != name:
        before, name = name, PREFIX.sub("", name)
    if not name.isascii():
        return _cjk(name)
    words = [word.lower() for word in SPLIT.findall(name)]
    words = [word for word in words if word not in FILLING] or words
    for i, word in enumerate(words):
        if word in SIDE_WORDS and len(words) > 1:
            return SIDE_WORDS[word], "".join(words[:i] + words[i + 1 :])
    whole = "".join(words)
    starts = ("left", "right", "hidari", "migi", "l", "r")
    for start, side in ((start, SIDE_WORDS[start]) for start in starts):
        if whole.startswith(start) and whole[len(start) :] in KNOWN:
            return side, whole[len(start) :]
    return None, whole


def _cjk(name: str) -> tuple[str | None, str]:
    """Return `split` for a name in Japanese or Chinese: its side is first, or last as in Blender's "足.L"."""
    side = None
    if name[:1] in CJK_SIDE:
        side, name = CJK_SIDE[name[0]], name[1:]
    elif ends := LATIN_SIDE.match(name):
        side, name = SIDE_WORDS[ends[2].lower()], ends[1]
    return side, CJK.get(name, name)


def without_prefix(names: Sequence[str]) -> list[str]:
    """Return names without the beginning that nearly all of them share, such as the name of a character."""
    starts = Counter(name[: separator.end()] for name in names for separator in SEPARATORS.finditer(name))
    least = max(2, SHARED * len(names))
    prefix = max((start for start, count in starts.items() if count >= least), key=len, default="")
    return [name[len(prefix) :] or name if name.startswith(prefix) else name for name in names]


def roles(names: Sequence[str], parents: Sequence[int]) -> dict[str, int]:
    """Return indices by role: "pelvis", "chest", "neck", "head", "left_upper_arm", ... as far as identified.

    The pelvis is where the legs meet, the chest where the arms do; parents precede their children, -1 for none. If a
    role fits several joints, it is the first with a continuation of the limb: some files contain bones of a drawing
    next to the skeleton's, "L_Humerus" next to "LeftArm".
    """
    parts = [split(name) for name in without_prefix(names)]
    hinged = [_is_hinge(name) for name in names]
    by_role: dict[str, int] = {}
    for side in ("left", "right"):
        on = {role: _going_on(role, side, parts, parents) for role in WORDS}
        for role, words in WORDS.items():
            fitting = [i for i, (s, word) in enumerate(parts) if s == side and word in words]
            general = [i for i, part in enumerate(parts) if part[0] == side and role in EITHER.get(part[1], ())]
            at_ends = on[role].isdisjoint(fitting) and not on[role].isdisjoint(general)
            _first(by_role, f"{side}_{role}", [] if at_ends else _prefer(fitting, on[role]))
        for word, choices in EITHER.items():
            same = [i for i, part in enumerate(parts) if part == (side, word)]
            for role in choices:
                if f"{side}_{role}" not in by_role and _fits(by_role, side, role, word, same, parents):
                    _first(by_role, f"{side}_{role}", _prefer(same, on[role]))
                    break
    for role, words in MIDDLE.items():
        _first(by_role, role, [i for i, (side, word) in enumerate(parts) if side is None and word in words])
    for side in ("left", "right"):
        _foot_below_ankle(by_role, side, parts, parents)
    for role, first in by_role.items():  # of several bodies for the hinges of one hip, the last is the thigh
        same = [i for i, part in enumerate(parts) if part == parts[first] and hinged[i]]
        if hinged[first] and all(first in lineage(i, parents) for i in same):
            by_role[role] = max(same, key=lambda i: len(lineage(i, parents)))
    by_role = with_trunk(by_role, names, parents)
    _spine_above_chest(by_role, parts, parents)
    return by_role


def first_hinge(joint: int, names: Sequence[str], parents: Sequence[int]) -> int:
    """Return the first of several joints for the hinges of one part, such as the hip's; otherwise the joint itself."""
    parts = [split(name) for name in without_prefix(names)]
    same = [i for i in lineage(joint, parents) if parts[i] == parts[joint] and _is_hinge(names[i])]
    return same[-1] if _is_hinge(names[joint]) else joint


def _is_hinge(name: str) -> bool:
    """Return whether a name contains an axis, as for a robot's hip pitch."""
    return bool(AXES.intersection(word.lower() for word in SPLIT.findall(name)))


def with_trunk(found: Mapping[str, int], names: Sequence[str], parents: Sequence[int]) -> dict[str, int]:
    """Return roles with pelvis and chest added, if legs and arms determine them."""
    out, words = dict(found), [split(name)[1] for name in without_prefix(names)]
    for role, limb in (("pelvis", "thigh"), ("chest", "upper_arm")):
        ends = [found[f"{side}_{limb}"] for side in ("left", "right") if f"{side}_{limb}" in found]
        if len(ends) == 2:
            shared = [i for i in lineage(ends[0], parents)[1:] if i in lineage(ends[1], parents)]
            if shared:
                out[role] = _trunk(role, shared, words)
    return out


def apply_bone_map(
    found: Mapping[str, int], bone_map: Mapping[str, str], names: Sequence[str], whose: str
) -> dict[str, int]:
    """Return indices by role with those of a bone map: a name, or "" for none.

    Raises:
        UserError: For a name or role that does not exist.
    """
    out = dict(found)
    for role, name in bone_map.items():
        if role not in ROLES:
            raise UserError(f"map: {whose}: {unknown('role', role, ROLES)}")
        out.pop(role, None)
        if name:
            if name not in names:
                raise UserError(f"map: {whose}.{role}: {unknown('body', name, names)}")
            out[role] = list(names).index(name)
    return out


def mapped_roles(
    names: Sequence[str], parents: Sequence[int], bone_map: Mapping[str, str], whose: str
) -> dict[str, int]:
    """Return indices by role, from names and a bone map, with pelvis and chest where the limbs of the map meet."""
    by_role = apply_bone_map(roles(names, parents), bone_map, names, whose)
    if not bone_map:
        return by_role
    trunk = with_trunk(by_role, names, parents)
    return by_role | {role: joint for role, joint in trunk.items() if role not in {*by_role, *bone_map}}


def _trunk(role: str, shared: list[int], words: list[str]) -> int:
    """Return the joint where two limbs meet; Biped attaches arms to the neck and legs to the spine."""
    if role == "chest":
        return next((i for i in shared if words[i] != "neck"), shared[0])
    return next((i for i in shared if words[i] in ("pelvis", "hips", "hip")), shared[0])


def _going_on(role: str, side: str, parts: Sequence[tuple[str | None, str]], parents: Sequence[int]) -> set[int]:
    """Return the joints with a descendant that may be the next part of the limb; none at its end."""
    onward = ONWARD.get(role)
    if onward is None:
        return set()
    words = (*WORDS[onward], *(word for word, choices in EITHER.items() if onward in choices))
    ends = [i for i, (s, word) in enumerate(parts) if s == side and word in words]
    return {above for end in ends for above in lineage(end, parents)[1:]}


def _prefer(fitting: list[int], on: set[int]) -> list[int]:
    """Sort joints with a continuation of the limb first."""
    return sorted(fitting, key=lambda i: i not in on)


def _first(found: dict[str, int], role: str, fitting: list[int]) -> None:
    if fitting:
        found[role] = fitting[0]


def _foot_below_ankle(
    found: dict[str, int], side: str, parts: Sequence[tuple[str | None, str]], parents: Sequence[int]
) -> None:
    """Without a toe by name, take a "foot" below the "ankle" as the toe, as in SMPL and Kinect."""
    ankle = found.get(f"{side}_foot")
    if f"{side}_toe" not in found and ankle is not None and parts[ankle][1] == "ankle":
        feet = [i for i, part in enumerate(parts) if part == (side, "foot")]
        _first(found, f"{side}_toe", [i for i in feet if ankle in lineage(i, parents)])


def _spine_above_chest(found: dict[str, int], parts: Sequence[tuple[str | None, str]], parents: Sequence[int]) -> None:
    """Without neck and head by name, take the first and last bone of the spine above the chest, as in Rigify."""
    chest = found.get("chest")
    if chest is None or "neck" in found or parts[chest][1] != "spine":
        return
    above = [i for i, part in enumerate(parts) if part == parts[chest] and chest in lineage(i, parents)[1:]]
    _first(found, "neck", above)
    if "head" not in found and len(above) > 1:
        found["head"] = max(above, key=lambda i: len(lineage(i, parents)))


def _fits(found: dict[str, int], side: str, role: str, word: str, same: list[int], parents: Sequence[int]) -> bool:
    """Return whether joints `same` with an ambiguous word fit a role. An "arm" is the upper arm above a forearm and the
    forearm below an upper arm; a "shoulder" is its clavicle."""
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


def unique(names: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Return unique names, none of which is in `taken`: duplicates get a number."""
    used, out = set(taken), []
    for name in names:
        count, candidate = 2, name
        while candidate in used:
            candidate, count = f"{name}_{count}", count + 1
        used.add(candidate)
        out.append(candidate)
    return out


def lineage(index: int, parents: Sequence[int]) -> list[int]:
    """Return a joint and all its ancestors."""
    out = []
    while index >= 0:
        out.append(index)
        index = parents[index]
    return out
