"""A captured skeleton as a new figure: MJCF with a free root, ball joints, and capsules along the bones."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.tolerances import NEGLIGIBLE

from ...scene.roles import SIDES, lineage, unique
from .captured_skeleton import CapturedSkeleton

DENSITY = 1000.0  # [kg/m³]
# By role: radius of a capsule as a fraction of its bone's length, and its bounds [m]
THICKNESS = {"": (0.16, 0.007, 0.045), "thigh": (0.17, 0.03, 0.075), "shin": (0.13, 0.02, 0.055),
             "foot": (0.2, 0.015, 0.035), "upper_arm": (0.16, 0.02, 0.05), "forearm": (0.15, 0.015, 0.04),
             "pelvis": (0.5, 0.05, 0.1), "chest": (0.4, 0.04, 0.1), "neck": (0.5, 0.03, 0.055),
             "head": (0.5, 0.05, 0.09)}  # fmt: skip
WORLD = "world"  # name reserved by MuJoCo
COLOURS = {"left": "0.17 0.45 0.56 1", "right": "0.93 0.55 0.22 1", "": "0.45 0.5 0.56 1"}


def figure(captured: CapturedSkeleton) -> tuple[str, Array]:
    """Return the MJCF text and qpos (T, nq); the zero pose of the file is the rest pose of the figure."""
    lowest = min(
        captured.at_zero[:, 2].min(), *(captured.at_zero[i, 2] + end[2] for i, end in captured.ends.items()), 0.0
    )
    root = ET.Element("mujoco", model="captured")
    ET.SubElement(root, "compiler", angle="radian")
    default = ET.SubElement(root, "default")
    ET.SubElement(default, "geom", type="capsule", contype="0", conaffinity="0", density=f"{DENSITY:g}")
    ET.SubElement(default, "site", group="4", size="0.012")
    bodies: list[ET.Element] = []
    names = unique(("_".join(name.replace("/", "_").split()) for name in captured.names), [WORLD])
    by_joint = {joint: role for role, joint in captured.roles.items()}
    for i, parent in enumerate(captured.parents):
        place = captured.offset[i] if parent >= 0 else np.array([0.0, 0.0, -lowest])
        above = ET.SubElement(root, "worldbody") if parent < 0 else bodies[parent]
        body = ET.SubElement(above, "body", name=names[i], pos=_row(place))
        if parent < 0:
            ET.SubElement(body, "freejoint", name="root" if "root" not in names else names[0])
        else:
            ET.SubElement(body, "joint", name=names[i], type="ball")
        bodies.append(body)
    taken = set(names)
    for i, body in enumerate(bodies):
        role = by_joint.get(i, "").removeprefix("left_").removeprefix("right_")
        part, colour = role if role in THICKNESS else "", COLOURS[_side(captured, i, by_joint)]
        _bones(body, captured, i, names[i], part, colour, taken)
    _soles(bodies, captured)
    _hands(bodies, captured)
    for body in bodies:  # a body's geoms and sites precede its children
        body[:] = sorted(body, key=lambda child: child.tag == "body")
    order, turn = _depth_first(captured)[1:], captured.rotation
    above = quat.conjugate(turn[:, [captured.parents[i] for i in order]])
    local = quat.align_signs(quat.product(above, turn[:, order])).reshape(len(turn), -1)
    qpos = np.concatenate([captured.position[:, 0], turn[:, 0], local], axis=1)
    ET.indent(root)
    return ET.tostring(root, encoding="unicode"), qpos


def _depth_first(captured: CapturedSkeleton, joint: int = 0) -> list[int]:
    return [joint, *(below for child in captured.children(joint) for below in _depth_first(captured, child))]


def _side(captured: CapturedSkeleton, joint: int, by_joint: dict[int, str]) -> str:
    for i in lineage(joint, captured.parents):
        side = by_joint.get(i, "").partition("_")[0]
        if side in SIDES:
            return side
    return ""


def _row(values: Iterable[float]) -> str:
    return " ".join(f"{value:.9g}" for value in values)


def _bones(
    body: ET.Element, captured: CapturedSkeleton, joint: int, name: str, role: str, colour: str, taken: set[str]
) -> None:
    """Add a capsule to every child and to the end, or a sphere without any; the first has the body's name."""
    share, least, most = THICKNESS[role]
    count = 0
    for start, tip in _lines(captured, joint, role):
        length = float(np.linalg.norm(tip - start))
        if length > NEGLIGIBLE:
            radius = min(float(np.clip(share * length, least, most)), 0.45 * length + least)
            count += 1
            called = unique([name], taken)[0] if count > 1 else name
            taken.add(called)
            line = _row([*start, *tip])
            ET.SubElement(body, "geom", name=called, size=f"{radius:.4g}", fromto=line, rgba=colour)
    if not count:
        ET.SubElement(body, "geom", name=name, type="sphere", size=f"{least:.4g}", rgba=colour)


def _lines(captured: CapturedSkeleton, joint: int, role: str) -> list[tuple[Array, Array]]:
    """Return the ends (3,) of the bones of a joint; of the chest, to the midpoint between the limbs, and from left to
    right."""
    below = captured.children(joint)
    origin, tips = np.zeros(3), [captured.offset[child] for child in below]
    sides = [_begins(captured, child) for child in below]
    if role == "chest" and sorted(filter(None, sides)) == list(SIDES):
        left, right = (tips[sides.index(side)] for side in SIDES)
        rest = [(origin, tip) for tip, side in zip(tips, sides, strict=True) if not side]
        return [(origin, 0.5 * (left + right)), (0.8 * left + 0.2 * right, 0.2 * left + 0.8 * right), *rest]
    tips += [captured.ends[joint]] if joint in captured.ends else []
    return [(origin, tip) for tip in tips]


def _begins(captured: CapturedSkeleton, joint: int) -> str:
    for side in SIDES:
        limb = [captured.roles[role] for role in captured.roles if role.startswith(side)]
        if any(joint in lineage(i, captured.parents) for i in limb):
            return side
    return ""


def _soles(bodies: list[ET.Element], captured: CapturedSkeleton) -> None:
    """Add sites at heel and toe, on the ground where the foot is lowest, for the penalties on sliding and sinking."""
    for side, (ankle, toe, end, low) in captured.feet.items():
        over_ankle, over_toe = captured.position[low, ankle], captured.at(toe, end)[low]
        back = over_ankle - 0.25 * (over_toe - over_ankle)
        for name, joint, point in (("heel", ankle, back), ("toe", toe, over_toe)):
            on_ground = np.array([point[0], point[1], captured.ground]) - captured.position[low, joint]
            place = quat.rotate(quat.conjugate(captured.rotation[low, joint]), on_ground)
            ET.SubElement(bodies[joint], "site", name=f"{side}_{name}", pos=_row(place))


def _hands(bodies: list[ET.Element], captured: CapturedSkeleton) -> None:
    for side in SIDES:
        joint = captured.roles.get(f"{side}_hand")
        if joint is not None:
            below = captured.children(joint)
            ends = [captured.offset[i] for i in below] or [captured.ends.get(joint, np.zeros(3))]
            ET.SubElement(bodies[joint], "site", name=f"{side}_hand", pos=_row(0.5 * np.mean(ends, axis=0)))
