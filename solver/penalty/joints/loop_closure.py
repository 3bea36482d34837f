"""Closed loops: points of two bodies that `connect` and `weld` equality constraints hold together.

A connection holds one point of each body together. A weld holds three, which are ARM apart, so that an error of
rotation costs about as much as an error of position; it holds one if its `torquescale` is zero.
"""

from __future__ import annotations

import mujoco
import numpy as np

from ... import quaternion as quat
from ...array import Array
from ...contacts.stance import Stance
from ...figure.figure import Figure
from ...surface.points import Point

TORQUE_SCALE = 10  # index of `torquescale` in the data of a weld; zero leaves the rotation free
UNTURNED = np.array([1.0, 0, 0, 0])
ARM = 0.1  # [m] distance from the middle of a weld to the points that hold its rotation


def closures(figure: Figure) -> tuple[Stance, ...]:
    """Return the points that the active connections and welds of a model hold, except those of mocap bodies."""
    model, result = figure.model, []
    kinds = {int(mujoco.mjtEq.mjEQ_CONNECT): "connect", int(mujoco.mjtEq.mjEQ_WELD): "weld"}
    for i in np.flatnonzero(model.eq_active0 != 0):
        kind = kinds.get(int(model.eq_type[i]))
        if kind is None:
            continue
        frames = _frames(model, int(i), weld=kind == "weld")
        turns = kind == "weld" and model.eq_data[i, TORQUE_SCALE] > 0
        if any(model.body_mocapid[body] >= 0 for body, _, _ in frames):
            continue
        name = model.equality(int(i)).name or " and ".join(model.body(body).name or "world" for body, _, _ in frames)
        offsets = [np.zeros(3), *(ARM * np.eye(3)[:2])] if turns else [np.zeros(3)]
        for offset in offsets:
            ends = []
            for body, position, turn in frames:
                link, place = figure.point_on_link(body, position + quat.rotated(turn, offset))
                ends.append(Point(name, link, place))
            if ends[0].link != ends[1].link:
                one, two = ends
                result.append(Stance(one, -np.inf, np.inf, two.position, two.position, link=two.link))
    return tuple(result)


def _frames(model: mujoco.MjModel, equality: int, *, weld: bool) -> list[tuple[int, Array, Array]]:
    """Return the two frames that must coincide: body, position in it (3,) [m] and rotation in it (4,)."""
    ids, data = (int(model.eq_obj1id[equality]), int(model.eq_obj2id[equality])), model.eq_data[equality]
    if int(model.eq_objtype[equality]) == int(mujoco.mjtObj.mjOBJ_SITE):
        return [(int(model.site_bodyid[s]), np.array(model.site_pos[s]), np.array(model.site_quat[s])) for s in ids]
    if not weld:
        return [(ids[0], np.array(data[:3]), UNTURNED), (ids[1], np.array(data[3:6]), UNTURNED)]
    # the anchor in the second body, the anchor in the first, and the rotation of the second in the first
    anchor, place, turn = np.array(data[:3]), np.array(data[3:6]), quat.normalised(np.array(data[6:10]))
    return [(ids[0], place, turn), (ids[1], anchor, UNTURNED)]
