"""Closed loops: points of two bodies that `connect` and `weld` equality constraints hold together.

A connection holds one point of each body together. A weld holds three, which are ARM apart, so that an error of
rotation costs about as much as an error of position; it holds one if its `torquescale` is zero.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from ... import quaternion as quat
from ...array import Array, Index
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import every_axis, of_point
from ...surface.points import Point
from ..block import Block
from ..penalty import Normalization, Penalty

TORQUE_SCALE = 10  # index of `torquescale` in the data of a weld; zero leaves the rotation free
UNTURNED = np.array([1.0, 0, 0, 0])
ARM = 0.1  # [m] distance from the middle of a weld to the points that hold its rotation


@dataclass(frozen=True, eq=False)
class Closure:
    """Two points that must coincide, on different links or on a link and the world (link 0)."""

    name: str
    one: Point
    two: Point


@dataclass(frozen=True)
class LoopClosure(Penalty):
    """Σ over closures of the squared distance [m²]."""

    closures: tuple[Closure, ...]

    name = "closed"
    normalization = Normalization(1e-4, length_power=2, is_violation=True)

    @cached_property
    def _sides(self) -> tuple[tuple[Index, Array], tuple[Index, Array]]:
        """The links (n,) and positions (3, n) of both ends."""
        ends = [[c.one for c in self.closures], [c.two for c in self.closures]]
        one, two = (
            (np.array([p.link for p in end], np.intp), np.array([p.position for p in end]).T.reshape(3, -1))
            for end in ends
        )
        return one, two

    def gaps(self, samples: Samples) -> Array:
        """Return the vectors from the second points to the first, (3, n, S) [m]."""
        (links, positions), (others, places) = self._sides
        return samples.links.points(links, positions)[0] - samples.links.points(others, places)[0]

    def residuals(self, samples: Samples) -> Iterator[Block]:
        places, changes = [], []
        for (links, positions), sign in zip(self._sides, (1.0, -1.0), strict=True):
            place, arms = samples.links.points(links, positions)
            places.append(place)
            at, link, axes = every_axis(links, samples.count)
            changes.append(of_point(at, link, np.tile(arms.reshape(3, -1), 3), sign * axes))
        yield Block(changes[0].at, (places[0] - places[1]).ravel(), tuple(changes))


def closures(figure: Figure) -> tuple[Closure, ...]:
    """Return the active connections and welds of a model, except those of mocap bodies."""
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
                result.append(Closure(name, ends[0], ends[1]))
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
