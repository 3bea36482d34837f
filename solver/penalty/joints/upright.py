"""Upright: a trunk, a tray or a cup stays upright. A trunk of unspecified rotation stays at its tilt over the feet.

Without the latter a squat leans far back, which shortens the path of the hips at no other cost. Not in the paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ... import quaternion as quat
from ...array import Array, Index, pairs_within
from ...curve.frame import Timeline
from ...figure.algebra import cross, rotate
from ...figure.figure import Figure, quaternion_columns
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_turn
from ..block import Block
from ..penalty import Normalization, Penalty, Role


@dataclass(frozen=True, eq=False)
class Lean:
    """A unit axis (3,) of a link that must be vertical, always or from `first` to `last` [s]."""

    link: int
    axis: Array
    first: float = -np.inf
    last: float = np.inf


@dataclass(frozen=True)
class Upright(Penalty):
    """Σ over leans of |R axis − z|², approximately the squared angle [rad²] of the axis to the vertical."""

    leans: tuple[Lean, ...]
    name: str = "upright.trunk"

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
        links = figure.body_link[np.array(bodies)].tolist()
        if axis is not None and not np.any(axis):
            raise ValueError("axis is [0, 0, 0], which points nowhere")
        if axis is None:
            rest = Samples.of_qpos(figure)
            axes = rest.links.rotation[2][:, links, 0].T
        else:
            axes = [quat.rotate(figure.body_turn[body], axis) / np.linalg.norm(axis) for body in bodies]
        return cls(tuple(Lean(link, along) for link, along in zip(links, axes, strict=True)), "upright.bodies")

    @cached_property
    def is_sharp(self) -> bool:
        return all(np.isfinite([lean.first, lean.last]).all() for lean in self.leans)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        links, axes, *times = self._arrays
        which, at = pairs_within(samples.t, *times)
        if not which.size:
            return
        turned = rotate(samples.links.poses(links[which] * samples.count + at)[1], axes[:, which])
        at, link, along = along_axes(at, links[which])
        changes = of_turn(at, link, cross(np.tile(turned, 3), along))
        yield Block(at, (turned - np.array([[0.0], [0], [1]])).ravel(), (changes,))

    @cached_property
    def _arrays(self) -> tuple[Index, Array, Array, Array]:
        """The links (n,), the axes (3, n), and the first and last times (n,) [s]."""
        axes = np.array([lean.axis for lean in self.leans]).reshape(-1, 3).T
        first, last = (np.array([getattr(lean, name) for lean in self.leans]) for name in ("first", "last"))
        return np.array([lean.link for lean in self.leans], np.intp), axes, first, last


def leans(figure: Figure, keys: Timeline, roots: Sequence[int]) -> tuple[Lean, ...]:
    """Return the tilt of roots in the keyframes that were posed with free rotation.

    It lasts from the middle of the segment before a keyframe to the middle of the one after it.

    Args:
        roots: Links with a free joint.
    """
    samples, times = Samples.still(figure, keys.states), keys.times
    edges = np.concatenate([times[:1], (times[1:] + times[:-1]) / 2, times[-1:]]).tolist()
    result = []
    for root in roots:
        columns = quaternion_columns(figure.links[int(root)])
        posed = keys.known[:, columns].all(axis=1) & ~keys.fixed[:, columns].all(axis=1)
        for k in np.flatnonzero(posed):
            axis = samples.links.rotation[2, :, root, k].copy()
            result.append(Lean(int(root), axis, *edges[k : k + 2]))
    return tuple(result)
