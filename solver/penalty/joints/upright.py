"""Upright: a trunk of unspecified rotation stays at the tilt of its pose over the feet.

Without it a squat leans far back, which shortens the path of the hips at no other cost. Not in the paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...array import Array, Index
from ...curve.frame import Timeline
from ...figure.algebra import applied, cross
from ...figure.figure import Figure, JointKind, quaternion_columns
from ...figure.kinematics import Samples
from ...figure.wrenches import along_axes, of_turn
from ..block import Block
from ..penalty import Momentary, Normalization


@dataclass(frozen=True, eq=False)
class Lean:
    """A unit axis (3,) of a link that must be vertical at a time [s]."""

    link: int
    time: float
    axis: Array


@dataclass(frozen=True)
class Upright(Momentary):
    """Σ over leans of |R axis − z|², approximately the squared angle [rad²] of the axis to the vertical."""

    leans: tuple[Lean, ...]

    name = "upright.trunk"
    normalization = Normalization(float(np.radians(10) ** 2), is_violation=True)

    @cached_property
    def times(self) -> Array:
        return np.array([lean.time for lean in self.leans])

    def residuals(self, samples: Samples) -> Iterator[Block]:
        which, at = self.pairs(samples)
        if not which.size:
            return
        links, axes = self._arrays
        turned = applied(samples.links.rotation[:, :, links[which], at], axes[:, which])
        at, link, along = along_axes(at, links[which])
        changes = of_turn(at, link, cross(np.tile(turned, 3), along))
        yield Block(at, (turned - np.array([[0.0], [0], [1]])).ravel(), (changes,))

    @cached_property
    def _arrays(self) -> tuple[Index, Array]:
        """Links (n,) and axes (3, n)."""
        axes = np.array([lean.axis for lean in self.leans]).reshape(-1, 3).T
        return np.array([lean.link for lean in self.leans], np.intp), axes


def leans(figure: Figure, keys: Timeline, roots: Sequence[int]) -> tuple[Lean, ...]:
    """Return the tilt of roots in the keyframes that were posed with free rotation.

    Args:
        roots: Links with a quaternion, or the link of the figure's root of slides and hinges.
    """
    states = keys.states
    samples = Samples.still(figure, states)
    result = []
    for root in roots:
        columns = _turning(figure, int(root))
        if not columns:
            continue
        posed = keys.known[:, columns].all(axis=1) & ~keys.fixed[:, columns].all(axis=1)
        for k in np.flatnonzero(posed):
            axis = samples.links.rotation[2, :, root, k].copy()
            result.append(Lean(int(root), float(keys.times[k]), axis))
    return tuple(result)


def _turning(figure: Figure, root: int) -> list[int]:
    main_root = figure.root
    chain = main_root.links if main_root is not None and main_root.link == root else (root,)
    out: list[int] = []
    for i in chain:
        columns, link = quaternion_columns(figure.links[i]), figure.links[i]
        if columns is not None:
            out += range(columns.start, columns.stop)
        elif link.kind is JointKind.HINGE:
            out.append(link.qpos)
    return out
