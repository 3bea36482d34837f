"""Left and right exchanged: a figure's motion reflected in the x-z plane, as a linear map of its states.

A link at orientation R in the world is reflected to S R Mᵀ of its partner. S = diag(1, −1, 1) reflects the world. M
takes vectors in the link's frame to their images in the partner's frame: at rest S R Mᵀ is the partner's orientation.
With M = S, frames along the axes of the world, a quaternion w, x, y, z becomes w, −x, y, −z. A hinge follows its
partner if its axis is the image of the partner's axis, as lines of the rest pose, however their frames are turned.

Where all frames are along the axes the map moves columns and changes signs, no more: twice mirrored is the same to the
last bit (but for hinges and slides that rest off zero). The mirrored spline is the spline of the mirrored frames.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index, Mask
from ..figure.figure import Figure, JointKind, quaternion_columns
from .frame import Frame, Timeline
from .symmetry import MIDDLE, WORLD, rounded, symmetric

POLAR, AXIAL = np.array([1.0, -1, 1]), np.array([-1.0, 1, -1])  # what a mirror does to places, and to axes of rotation
TURN = np.array([1.0, -1, 1, -1])


@dataclass(frozen=True, eq=False)
class _Columns:
    """A linear map of rows (..., N): column i becomes sign_i · (column source_i); both (N,).

    turned  quaternions of which it is a matrix: columns, columns of the source, (4, 4)
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
    """The map of states and of configurations, which differ where a ball joint's state is its link's orientation.

    shift       (N,) what is added, of hinges and slides that rest off zero
    partner     (L,) the link on the other side of every link, itself in the middle
    reflection  (L, 3, 3) M, from a link's frame to its partner's
    size        [m] of the figure from end to end
    """

    figure: Figure
    of_states: _Columns
    of_qpos: _Columns
    shift: Array
    partner: Index
    reflection: Array
    size: float

    @classmethod
    def of(cls, figure: Figure, middle: float = MIDDLE) -> Mirror:
        """Links paired by name, else by geometry; raises MirrorError that names those without a partner.

        middle  how far axes may be off their partners' images, as a share of the figure's size
        """
        rest, partner, reflection = symmetric(figure, middle)
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
        return cls(figure, states, qpos, shift, partner, reflection, rest.size)

    def states(self, states: Array) -> Array:
        """States (..., N) of the mirrored figure."""
        return self.of_states(states) + self.shift

    def configurations(self, qpos: Array) -> Array:
        """Configurations qpos (..., N) of the mirrored figure."""
        return self.of_qpos(qpos) + self.shift

    def slopes(self, slopes: Array) -> Array:
        """Derivatives of states (..., N)."""
        return self.of_states(slopes)

    def sense(self, link: int) -> float:
        """1 or −1: whether a hinge or slide moves as its partner does, or the other way."""
        return float(self.of_qpos.sign[self.figure.links[link].qpos])

    def key(self, key: Frame) -> Frame:
        """A keyframe, which holds a configuration, its fixed and posed entries on the other side."""
        return self._moved(key, self.configurations(key.state))

    def timeline(self, timeline: Timeline) -> Timeline:
        """The timeline of the mirrored motion, whose frames hold states."""
        frames = tuple(self._moved(frame, self.states(frame.state)) for frame in timeline.frames)
        return Timeline(frames, self.slopes(timeline.end_slope), timeline.ends)

    def _moved(self, frame: Frame, state: Array) -> Frame:
        source = self.of_qpos.source
        return Frame(frame.time, state, frame.fixed[source], None if frame.posed is None else frame.posed[source])

    def of_bodies(self, body: int, other: int) -> Array:
        """(3, 3) the reflection from one body's frame to another's, by MuJoCo's ids."""
        figure = self.figure
        reflection = self.reflection[figure.body_link[body]]
        turn, other_turn = (quat.matrices(figure.body_turn[number]) for number in (body, other))
        return np.asarray(other_turn.T @ reflection @ turn)


def _with_quaternions(
    figure: Figure, source: Index, sign: Array, partner: Index, reflection: Array, in_world: Sequence[bool] | Mask
) -> _Columns:
    """The map of columns, those of quaternions added: orientations in the world (L,), or relative to the parent."""
    source, sign, turned = np.array(source), np.array(sign), list[tuple[slice, slice, Array]]()
    for i, link in enumerate(figure.links):
        j = int(partner[i])
        to, origin = quaternion_columns(link), quaternion_columns(figure.links[j])
        if to is None or origin is None:
            continue
        matrix = _of_quaternion(reflection, j, i) if in_world[i] else _of_joint(reflection[j])
        moved = np.argmax(np.abs(matrix), axis=1)
        source[to], sign[to] = origin.start + moved, matrix[np.arange(4), moved]
        if not np.all(np.isin(matrix, (-1.0, 0.0, 1.0))):
            source[to] = np.arange(origin.start, origin.stop)
            turned.append((to, origin, matrix))
    return _Columns(source, sign, tuple(turned))


def _of_joint(reflection: Array) -> Array:
    """(4, 4) what a reflection M does to a joint's quaternion: w, −M v."""
    matrix = np.eye(4)
    matrix[1:, 1:] = -reflection
    return rounded(matrix)


def _of_quaternion(reflection: Array, source: int, link: int) -> Array:
    """(4, 4) the same of links' orientations in the world: that of S R Mᵀ = (S R S) (S Mᵀ) is one of S R S times a
    constant, whose sign lets two mirrorings cancel."""
    first = min(source, link)
    constant = quat.from_matrix(WORLD @ reflection[first].T)
    if source != first:
        constant = quat.inverse(TURN * constant)
    return rounded(quat.right_matrix(constant) @ np.diag(TURN))
