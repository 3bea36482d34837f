"""Level: a trunk, a tray or a cup stays upright. Not in the paper."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index
from ...figure.algebra import cross
from ...figure.figure import Figure
from ...figure.kinematics import Samples
from ...figure.wrenches import every_axis, of_turn
from ..block import Block
from ..penalty import Normalization, Penalty


@dataclass(frozen=True, eq=False)
class Level(Penalty):
    """Σ over bodies of |R axis − z|², approximately the squared angle [rad²] of an axis to the vertical.

    Attributes:
        links: The links of the bodies, (B,).
        axes: Unit vectors in the links' axes, (3, B).
    """

    links: Index
    axes: Array

    name = "upright.bodies"
    normalization = Normalization(float(np.radians(10) ** 2), is_violation=True)

    @classmethod
    def of(cls, figure: Figure, bodies: Sequence[int], axis: Sequence[float] | None = None) -> Level:
        """Return the penalty of bodies by index.

        Args:
            bodies: MuJoCo's ids of the bodies.
            axis: The axis in each body's frame, (3,); None: the axis that points up at rest.

        Raises:
            ValueError: The axis is zero.
        """
        links, rest = figure.body_link[np.array(bodies)], figure.to_state(figure.model.qpos0)[None]
        if axis is None:
            return cls(links, Samples.still(figure, rest).links.rotation[2][:, links, 0])
        size = np.linalg.norm(axis)
        if not size:
            raise ValueError("axis is [0, 0, 0], which points nowhere")
        return cls(links, np.array([quat.rotated(figure.body_turn[body], axis) for body in bodies]).T / size)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        axes = np.einsum("ijbs,jb->ibs", samples.links.rotation[:, :, self.links], self.axes)
        away = axes - np.array([0.0, 0, 1])[:, None, None]
        at, link, along = every_axis(self.links, samples.count)
        turned = of_turn(at, link, cross(np.tile(axes.reshape(3, -1), 3), along))
        yield Block(at, away.ravel(), (turned,))
