"""Upright: bodies such as a head, a tray or a cup stay upright. Not in the paper."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index
from ...figure.algebra import cross, rotate
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_turn
from ..block import Block
from ..penalty import Normalization, Penalty, Role


@dataclass(frozen=True, eq=False)
class Upright(Penalty):
    """Σ over links of |R axis − z|², approximately the squared angle [rad²] of the axis to the vertical.

    Attributes:
        links: The links, (n,).
        axes: A unit axis of each link that must be vertical, (3, n).
    """

    links: Index
    axes: Array

    name = "upright"
    role = Role.TARGET
    normalization = Normalization(float(np.radians(10) ** 2))

    @classmethod
    def of(cls, figure: Figure, bodies: Sequence[int], axis: Sequence[float] | None = None) -> Upright:
        """Return the penalty of bodies by index.

        Args:
            bodies: MuJoCo's ids of the bodies.
            axis: The axis in each body's frame, (3,); None: the axis that points up at rest.

        Raises:
            ValueError: The axis is zero.
        """
        links = figure.body_link[np.array(bodies)]
        if axis is not None and not np.any(axis):
            raise ValueError("axis is [0, 0, 0], which points nowhere")
        if axis is None:
            return cls(links, Samples.of_qpos(figure).links.rotation[2][:, links, 0])
        axes = [quat.rotate(figure.body_turn[body], axis) / np.linalg.norm(axis) for body in bodies]
        return cls(links, np.transpose(axes))

    def residuals(self, samples: Samples) -> Iterator[Block]:
        at, which = np.divmod(np.arange(samples.count * self.links.size), self.links.size)
        turned = rotate(samples.links.poses(self.links[which] * samples.count + at)[1], self.axes[:, which])
        at, link, along = along_axes(at, self.links[which])
        changes = of_turn(at, link, cross(np.tile(turned, 3), along))
        yield Block(at, (turned - np.array([[0.0], [0], [1]])).ravel(), (changes,))
