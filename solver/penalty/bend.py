"""Knees and elbows: not backward, and neither sideways nor twisted beyond a bound (§5 of the paper).

With u the child's long axis and v its hinge axis, both seen in the parent (Rᵀ_parent R_child e): flexion is the angle
of u in the parent's sagittal plane, sideways bend the angle of u out of it, twist the angle of v about u (too large by
1/cos of the sideways bend).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..algebra import add_at, applied, cross, dot, turned, turned_back
from ..kinematics import Cotangent, Samples
from ..quaternion import Array, Index
from .penalty import Scale

Seen = tuple[Index, Index, tuple[Array, ...]]


@dataclass(frozen=True)
class Bend:
    """One knee or elbow.

    link       index of the child's link
    lateral    (3,) unit axis that the joint flexes about by positive angles, in the parent at rest: +y for knees,
               −y for elbows of a figure that faces x
    long_axis  (3,) unit axis of the child at rest, from the joint along the limb
    """

    name: str
    link: int
    lateral: Array
    long_axis: Array


@dataclass(frozen=True)
class BendLimits:
    """Σ over joints of squared excess angles [rad²]: of flexion below `least`, of |sideways| and |twist| over bounds.

    least, sideways, twist  [rad]
    """

    joints: tuple[Bend, ...]
    least: float = 0.0
    sideways: float = np.radians(10)
    twist: float = np.radians(10)
    name: str = "bend"

    @property
    def scale(self) -> Scale:
        return Scale(float(np.radians(1) ** 2), is_violation=True)

    def angles(self, samples: Samples) -> Array:
        """(3, n, S) [rad]: flexion, sideways bend and twist of every joint."""
        return self._seen(samples)[0]

    def _seen(self, samples: Samples) -> tuple[Array, Seen]:
        links = samples.links
        own = np.array([joint.link for joint in self.joints], np.intp)
        parents = samples.figure.tables.parents[own]
        turn = samples.figure.tables.turn[:, own]
        lateral = np.array([joint.lateral for joint in self.joints]).T
        down = np.array([joint.long_axis for joint in self.joints]).T
        forward = np.cross(lateral.T, down.T).T
        to_child = _matrices(turn)
        back = np.einsum("jin,jn->in", to_child, lateral), np.einsum("jin,jn->in", to_child, down)
        child, parent = links.rotation[:, :, own], links.rotation[:, :, parents]
        v = turned_back(parent, turned(child, back[0]))
        u = turned_back(parent, turned(child, back[1]))
        side, d, f = (a[:, :, None] for a in (lateral, down, forward))
        x, z, y = dot(u, f), dot(u, d), dot(u, side)
        planar = np.maximum(np.hypot(x, z), 1e-9)
        flexion, sideways = np.arctan2(x, z), np.arctan2(y, planar)
        normal = (x * d - z * f) / planar
        twist = np.arctan2(dot(v, normal), dot(v, side))
        return np.stack([flexion, sideways, twist]), (own, parents, (u, v, side, d, f, planar, normal))

    def evaluate(self, samples: Samples, into: Cotangent | None = None, scale: Array | float = 1.0) -> Array:
        if not self.joints:
            return np.zeros(samples.count)
        (flexion, sideways, twist), seen = self._seen(samples)
        low = np.minimum(flexion - self.least, 0)
        side = np.sign(sideways) * np.maximum(np.abs(sideways) - self.sideways, 0)
        turn = np.sign(twist) * np.maximum(np.abs(twist) - self.twist, 0)
        if into is not None and (low.any() or side.any() or turn.any()):
            self._pull_back(samples, into, seen, (2 * scale * low, 2 * scale * side, 2 * scale * turn))
        return np.sum(low**2 + side**2 + turn**2, axis=0)

    def _pull_back(self, samples: Samples, into: Cotangent, seen: Seen, gradient: tuple[Array, ...]) -> None:
        own, parents, (u, v, side, d, f, planar, normal) = seen
        flexion_bar, sideways_bar, twist_bar = gradient
        x, z = dot(u, f), dot(u, d)
        p, q = dot(v, normal), dot(v, side)
        both = np.maximum(p**2 + q**2, 1e-18)
        p_bar, q_bar = twist_bar * q / both, -twist_bar * p / both
        v_bar = p_bar * normal + q_bar * side
        # the normal turns in the sagittal plane as the limb flexes: d normal / d flexion = (z d + x f) / |(x, z)|
        flexion_bar = flexion_bar + p_bar * dot(v, z * d + x * f) / planar
        u_bar = flexion_bar * (z * f - x * d) / planar**2 + sideways_bar / planar * side
        torque = applied(samples.links.rotation[:, :, parents], cross(u, u_bar) + cross(v, v_bar))
        room = into.room("turn")
        add_at(room, own, torque)
        add_at(room, parents, -torque)


def _matrices(quaternions: Array) -> Array:
    """Rotation matrices (3, 3, n) of quaternions (4, n), any length."""
    w, x, y, z = quaternions / np.linalg.norm(quaternions, axis=0)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
