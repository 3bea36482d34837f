"""Left and right exchanged: a figure's motion reflected in the x-z plane, as a linear map of its states.

A link with orientation R in the world is reflected to its partner's orientation S R Mᵀ. S = diag(1, −1, 1) reflects the
world. M maps vectors in the link's frame to their images in the partner's frame, defined by the figure at rest. If all
frames are aligned with the world, M = S, and a quaternion w, x, y, z becomes w, −x, y, −z. A hinge follows its partner
if its axis at rest is the image of the partner's axis as a line, for any orientation of the frames.

For aligned frames the map only permutes columns and changes signs. Mirroring twice is then exact to the last bit,
except for hinges and slides whose rest value is not zero. The mirrored spline is the spline of the mirrored frames.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure, JointKind, quaternion_columns
from .frame import Frame, Timeline
from .symmetry import MIDDLE, WORLD, other_side, round_to_signs, symmetric

POLAR, AXIAL = (
    np.array([1.0, -1, 1]),
    np.array([-1.0, 1, -1]),
)  # signs of mirrored positions, and of mirrored axes of rotation
TURN = np.array([1.0, -1, 1, -1])


@dataclass(frozen=True, eq=False)
class _Columns:
    """A linear map of rows (..., N).

    Attributes:
        source: Column i becomes sign_i · (column source_i), (N,).
        sign: (N,).
        turned: Quaternions, mapped by a matrix instead: target columns, source columns, matrix (4, 4).
    """

    source: Index
    sign: Array
    turned: tuple[tuple[slice, slice, Array], ...]

    def __call__(self, rows: Array) -> Array:
        out = rows[..., self.source] * self.sign
        for to, origin, matrix in self.turned:
            out[..., to] = rows[..., origin] @ matrix.T
        return out


@dataclass(frozen=True, eq=False)
class Mirror:
    """The mirror map of states and of configurations. They differ if a ball joint's state is its orientation in the
    world.

    Attributes:
        of_qpos: The linear part for configurations.
        shift: The constant part, for hinges and slides whose rest value is not zero, (N,).
        partner: The partner of each link on the other side, or the link itself in the middle, (L,).
        reflection: M, from each link's frame to its partner's, (L, 3, 3).
        size: The extent of the figure [m].
        pairs: Names of partners without left and right in their names.
    """

    figure: Figure
    of_states: _Columns
    of_qpos: _Columns
    shift: Array
    partner: Index
    reflection: Array
    size: float
    pairs: Sequence[tuple[str, str]] = ()

    @classmethod
    def of(cls, figure: Figure, pairs: Sequence[tuple[str, str]] = (), middle: float = MIDDLE) -> Mirror:
        """Return the mirror map of a figure.

        Args:
            pairs: Names of further partners, for joints without left and right in their names.
            middle: Tolerance of axes in the mirror plane, relative to the figure's size.

        Raises:
            ValueError: Links have no partner; the message names them.
        """
        rest, partner, reflection = symmetric(figure, pairs, middle)
        source, sign, shift = np.arange(figure.width), np.ones(figure.width), np.zeros(figure.width)
        for i, link in enumerate(figure.links[1:], start=1):
            j = int(partner[i])
            other = figure.links[j]
            if link.kind is JointKind.FREE:
                position = link.qpos + np.arange(3)
                source[position], sign[position] = other.qpos + np.arange(3), POLAR
            elif link.kind is not JointKind.BALL:
                sign[link.qpos] = rest.sense(j, i, reflection[j])
                source[link.qpos] = other.qpos
                shift[link.qpos] = link.reference - sign[link.qpos] * other.reference
        free = [link.kind is JointKind.FREE for link in figure.links]
        states = _with_quaternions(figure, source, sign, partner, reflection, figure.tables.in_world)
        qpos = _with_quaternions(figure, source, sign, partner, reflection, free)
        return cls(figure, states, qpos, shift, partner, reflection, float(rest.size.max()), pairs)

    def states(self, states: Array) -> Array:
        """Return states (..., N) of the mirrored figure."""
        return self.of_states(states) + self.shift

    def configurations(self, qpos: Array) -> Array:
        """Return configurations qpos (..., N) of the mirrored figure."""
        return self.of_qpos(qpos) + self.shift

    def slopes(self, slopes: Array) -> Array:
        """Return derivatives of states (..., N) of the mirrored figure."""
        return self.of_states(slopes)

    def sense(self, link: int) -> float:
        """Return 1 if a hinge or slide moves in its partner's direction, or −1 if in the opposite one."""
        return float(self.of_qpos.sign[self.figure.links[link].qpos])

    def key(self, key: Frame) -> Frame:
        """Return a mirrored keyframe, which holds a configuration; masks are mirrored as well."""
        return self._move(key, self.configurations(key.state))

    def timeline(self, timeline: Timeline) -> Timeline:
        """Return the timeline of the mirrored motion, whose frames hold states."""
        frames = tuple(self._move(frame, self.states(frame.state)) for frame in timeline.frames)
        return Timeline(frames, self.slopes(timeline.end_slope), timeline.ends)

    def _move(self, frame: Frame, state: Array) -> Frame:
        source = self.of_qpos.source
        return Frame(frame.time, state, frame.fixed[source], None if frame.posed is None else frame.posed[source])

    def other(self, name: str) -> str:
        """Return the name of the counterpart on the other side; a name without a side is returned unchanged."""
        return other_side(name, self.pairs)

    def of_bodies(self, body: int, other: int) -> Array:
        """Return the reflection (3, 3) from one body's frame to another's, by MuJoCo's ids."""
        figure = self.figure
        reflection = self.reflection[figure.body_link[body]]
        turn, other_turn = (quat.matrices(figure.body_turn[number]) for number in (body, other))
        return np.asarray(other_turn.T @ reflection @ turn)


def _with_quaternions(
    figure: Figure, source: Index, sign: Array, partner: Index, reflection: Array, in_world: Sequence[bool] | Mask
) -> _Columns:
    """Return the map of columns with quaternions added, in world coordinates where `in_world` (L,)."""
    source, sign, turned = np.array(source), np.array(sign), list[tuple[slice, slice, Array]]()
    for i, link in enumerate(figure.links):
        j = int(partner[i])
        target, origin = quaternion_columns(link), quaternion_columns(figure.links[j])
        if target is None or origin is None:
            continue
        matrix = _of_quaternion(reflection, j, i) if in_world[i] else _of_joint(reflection[j])
        source[target] = np.arange(origin.start, origin.stop)
        turned.append((target, origin, matrix))
    return _Columns(source, sign, tuple(turned))


def _of_joint(reflection: Array) -> Array:
    """Return the matrix (4, 4) of a reflection M on a joint's quaternion: w, −M v."""
    matrix = np.eye(4)
    matrix[1:, 1:] = -reflection
    return round_to_signs(matrix)


def _of_quaternion(reflection: Array, source: int, link: int) -> Array:
    """Return the matrix (4, 4) of a reflection on a link's orientation in the world. S R Mᵀ = (S R S) (S Mᵀ), so it is
    the quaternion of S R S times a constant. The constant's sign makes two mirrorings cancel."""
    first = min(source, link)
    constant = quat.from_matrix(WORLD @ reflection[first].T)
    if source != first:
        constant = quat.inverse(TURN * constant)
    return round_to_signs(quat.right_matrix(constant) @ np.diag(TURN))
