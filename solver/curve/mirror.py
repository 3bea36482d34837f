"""Left and right exchanged: a figure's motion reflected in the x-z plane, as a linear map of its states.

A reflection S = diag(1, −1, 1) takes a rotation R of one side to S R S on the other: its quaternion w, x, y, z becomes
w, −x, y, −z, a point x, −y, z. The map moves columns and changes signs, no more: the mirrored spline is the spline
of the mirrored frames, and twice mirrored is the same to the last bit (but for hinges and slides that rest off zero).
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index
from ..figure.figure import Figure, JointKind, Link
from .frame import Frame, Timeline

POLAR, AXIAL = np.array([1.0, -1, 1]), np.array([-1.0, 1, -1])  # what a mirror does to places, and to axes of rotation
TURN = np.array([1.0, -1, 1, -1])
SAME_ANGLE, MIDDLE = 1e-3, 1e-3  # [rad], [m] how far a figure may be from symmetric
# a word of its own, or the capital that begins one; or beside the letter for front, rear, hind, back or middle: FL, rh
ENDS_LEG = r"[FRHBMfrhbm]"
SIDE = re.compile(
    rf"(?<![A-Za-z])(?:[Ll]eft|[Rr]ight|LEFT|RIGHT|[LlRr](?![LRlr](?![A-Za-z])))(?![a-z])"
    rf"|(?<=[a-z])(?:Left|Right|[LR])(?![a-z])"
    rf"|(?<![A-Za-z])[lr](?=[fhbm](?![A-Za-z]))"
    rf"|(?<=(?<![A-Za-z]){ENDS_LEG})[LRlr](?![A-Za-z])"
)
WORDS = {"left": "right", "Left": "Right", "LEFT": "RIGHT", "l": "r", "L": "R"}
OTHER = WORDS | {right: left for left, right in WORDS.items()}


class MirrorError(ValueError):
    """A figure that has no left and right to exchange."""


def other_side(name: str) -> str:
    """left_knee -> right_knee, LeftArm -> RightArm, foot_l -> foot_r, FL_hip -> FR_hip; others stay as they are."""
    return SIDE.sub(lambda found: OTHER[found[0]], name)


@dataclass(frozen=True, eq=False)
class Mirror:
    """The map of states: column i becomes sign_i · (column source_i) + shift_i; each (N,).

    partner  (L,) the link on the other side of every link, itself in the middle
    """

    source: Index
    sign: Array
    shift: Array
    partner: Index

    @classmethod
    def of(cls, figure: Figure, middle: float = MIDDLE) -> Mirror:
        """Links paired by name; raises MirrorError that names those without a partner.

        middle  [m] how far off the x-z plane a joint without a partner may be
        """
        partner = _partners(figure, middle)
        source, sign, shift = np.arange(figure.width), np.ones(figure.width), np.zeros(figure.width)
        for i, link in enumerate(figure.links[1:], start=1):
            other = figure.links[partner[i]]
            signs = _signs(other, link)
            columns = link.qpos + np.arange(signs.size)
            source[columns] = other.qpos + np.arange(signs.size)
            sign[columns] = signs
            if link.kind in (JointKind.HINGE, JointKind.SLIDE):
                shift[columns] = link.reference - signs[0] * other.reference
        return cls(source, sign, shift, partner)

    def states(self, states: Array) -> Array:
        """States (..., N), or configurations qpos, of the mirrored figure."""
        return self.slopes(states) + self.shift

    def slopes(self, slopes: Array) -> Array:
        """Derivatives of states (..., N)."""
        return slopes[..., self.source] * self.sign

    def frame(self, frame: Frame) -> Frame:
        """A frame, its fixed and posed entries on the other side."""
        posed = None if frame.posed is None else frame.posed[self.source]
        return Frame(frame.time, self.states(frame.state), frame.fixed[self.source], posed)

    def timeline(self, timeline: Timeline) -> Timeline:
        """The timeline of the mirrored motion."""
        frames = tuple(self.frame(frame) for frame in timeline.frames)
        return Timeline(frames, self.slopes(timeline.end_slope), timeline.ends)


def _partners(figure: Figure, middle: float) -> Index:
    """(L,) every link's partner by name."""
    places: dict[str, list[int]] = {}
    for i, link in enumerate(figure.links):
        places.setdefault(link.name, []).append(i)
    partner = np.zeros(len(figure.links), np.intp)
    lonely: list[str] = []
    for i, link in enumerate(figure.links[1:], start=1):
        among = places.get(other_side(link.name), [])
        number = places[link.name].index(i)  # several joints of one body share its name
        if number < len(among):
            partner[i] = among[number]
        elif re.search("left|right", link.name, re.IGNORECASE) is None:
            partner[i] = i
        if partner[i] == 0 or (partner[i] == i and _is_off_the_middle(link, middle)):
            lonely.append(link.name)
    if lonely:
        names = ", ".join(f"'{name}'" for name in lonely)
        raise MirrorError(f"no partner on the other side for: {names}; joints are paired by left and right, l and r")
    for i, link in enumerate(figure.links[1:], start=1):
        other = figure.links[partner[i]]
        if other.kind is not link.kind or partner[link.parent] != other.parent:
            raise MirrorError(
                f"'{link.name}' and '{other.name}' are not alike: other kinds of joints, or other parents"
            )
        turned = quat.angle_between(link.turn * TURN, other.turn)
        if link.kind is not JointKind.FREE and turned > SAME_ANGLE:
            raise MirrorError(f"'{link.name}' at rest is no mirror image of '{other.name}'")
    return partner


def _is_off_the_middle(link: Link, middle: float) -> bool:
    return link.kind is not JointKind.FREE and abs(float(link.offset[1])) > middle


def _signs(source: Link, link: Link) -> Array:
    """The signs with which the columns of one link's joint become those of its partner's."""
    if link.kind is JointKind.FREE:
        return np.concatenate([POLAR, TURN])
    if link.kind is JointKind.BALL:
        return TURN
    along = source.axis * (AXIAL if link.kind is JointKind.HINGE else POLAR)
    share = float(along @ link.axis)  # of unit vectors
    if abs(share) < 1 - SAME_ANGLE:
        raise MirrorError(f"the axes of '{source.name}' and '{link.name}' are no mirror images")
    return np.array([np.sign(share)])
