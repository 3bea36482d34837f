"""The symmetry of a figure at rest: the partner of each link on the opposite side, and the map between their frames.

Links are paired by left and right in their names, otherwise by geometry. In both cases the axis of a hinge must be the
image of its partner's axis as a line, and that of a slide as a direction. The mirror plane passes through the middle of
the figure. It is the x-z plane of the root's frame, that of the world at rest, or another plane of the root's axes: the
first in which all links have partners.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index
from ..figure.figure import Figure, JointKind

WORLD = np.diag([1.0, -1, 1])  # S, the reflection of the world
SAME_LINE = 1e-3  # [1] tolerance of 1 − cosine of the angle between an axis and the image of its partner's
MIDDLE, UNEVEN = 0.01, 0.05  # [1] tolerances of axes and of centres of mass, relative to the figure's size
UPRIGHT_PLANES = 2  # the first candidates: the x-z planes of the root and of the world
EXACT = 1e-9  # entries of a reflection are rounded to 0, 1 or −1 within this
# a separate word, a capitalised word, or a letter next to that for front, rear, hind, back or middle: FL, rh
ENDS_LEG = r"[FRHBMfrhbm]"
SIDE = re.compile(
    rf"(?<![A-Za-z])(?:[Ll]eft|[Rr]ight|LEFT|RIGHT|[LlRr](?![LRlr](?![A-Za-z])))(?![a-z])"
    rf"|(?<=[a-z])(?:Left|Right|[LR])(?![a-z])"
    rf"|(?<![A-Za-z])[lr](?=[fhbm](?![A-Za-z]))"
    rf"|(?<=(?<![A-Za-z]){ENDS_LEG})[LRlr](?![A-Za-z])"
)
WORDS = {"left": "right", "Left": "Right", "LEFT": "RIGHT", "l": "r", "L": "R"}
OTHER = WORDS | {right: word for word, right in WORDS.items()}


MISFITS = {
    "kinds": "'{}' and '{}' differ in kind of joint or in parent",
    "axes": "the axes of '{}' and '{}' are no mirror images",
    "places": "'{}' at rest is no mirror image of '{}'",
}


class MirrorError(ValueError):
    """A figure without left and right sides to exchange."""


def other_side(name: str) -> str:
    """Return a name with left and right exchanged: left_knee -> right_knee, foot_l -> foot_r, FL_hip -> FR_hip.

    Names without a side are returned unchanged.
    """
    return SIDE.sub(lambda match: OTHER[match[0]], name)


@dataclass(frozen=True, eq=False)
class Rest:
    """A figure at rest, every link relative to its tree's free root, or in the world.

    Attributes:
        root: The free root of each link's tree, 0 for links fixed to the world, (L,).
        place: Joint anchors, (L, 3) [m].
        turn: Rotation matrices of the links' frames, (L, 3, 3).
        axis: Axes of hinges and slides, (L, 3).
        centre: The centre of mass of each link with its descendants, NaN without mass, (L, 3) [m].
        size: The extent of the figure [m]; 1 for a single link.
    """

    figure: Figure
    root: Index
    place: Array
    turn: Array
    axis: Array
    centre: Array
    size: float

    @classmethod
    def of(cls, figure: Figure) -> Rest:
        links, count = figure.links, len(figure.links)
        root = np.zeros(count, np.intp)
        place, origin, turn = np.zeros((count, 3)), np.zeros((count, 3)), np.tile(np.eye(3), (count, 1, 1))
        for i, link in enumerate(links[1:], start=1):
            if link.kind is JointKind.FREE:
                root[i] = i
                continue
            root[i] = root[link.parent]
            turn[i] = turn[link.parent] @ quat.matrices(link.turn)
            place[i] = origin[link.parent] + turn[link.parent] @ link.offset
            origin[i] = place[i] - turn[i] @ link.anchor
        axis = np.einsum("lij,lj->li", turn, np.array([link.axis for link in links]))
        mass = figure.tables.mass
        centres = origin + np.einsum("lij,lj->li", turn, np.array([link.centre for link in links]))
        descends = figure.tables.beyond
        with np.errstate(invalid="ignore"):
            centre = descends @ (mass[:, None] * centres) / (descends @ mass)[:, None]
        spread = [np.ptp(np.vstack([place[root == r], centres[root == r]]), axis=0) for r in np.unique(root[1:])]
        return cls(
            figure, root, place, turn, axis, centre, max(float(np.linalg.norm(extent)) for extent in spread) or 1.0
        )

    def sense(self, i: int, j: int, reflection: Array) -> float:
        """Return 1 if hinge or slide j moves in the direction of the mirrored i, or −1 if in the opposite one."""
        return 1.0 if self._share(i, j, self._image(i, j, reflection)) > 0 else -1.0

    def misfit(self, i: int, j: int, image: Array, middle: float) -> str:
        """Return why link j cannot be the image of link i in a mirror (3, 3) of the root's frame; "" if it can."""
        one, two = self.figure.links[i], self.figure.links[j]
        if one.kind is not two.kind:
            return "kinds"
        if one.kind in (JointKind.FREE, JointKind.SLIDE) or one.kind is JointKind.BALL:
            offset = self.place[j] - image @ self.place[i]
            if one.kind is JointKind.SLIDE:
                return "" if abs(self._share(i, j, image)) >= 1 - SAME_LINE else "axes"
        else:
            if abs(self._share(i, j, image)) < 1 - SAME_LINE:
                return "axes"
            offset = self.place[j] - image @ self.place[i]
            offset = offset - self.axis[j] * (offset @ self.axis[j])
        return "" if np.linalg.norm(offset) <= middle * self.size else "places"

    def unlike(self, i: int, j: int, image: Array) -> float:
        """Return the distance [m] of the centre of mass of link j's subtree from the image of that of link i's."""
        off = np.linalg.norm(self.centre[j] - image @ self.centre[i])
        return float(off) if np.isfinite(off) else 0.0

    def _share(self, i: int, j: int, image: Array) -> float:
        """Return the cosine of the angle between the axis of j and the image of that of i."""
        along = image @ self.axis[i] * (-1.0 if self.figure.links[i].kind is JointKind.HINGE else 1.0)
        return float(along @ self.axis[j])

    def _image(self, i: int, j: int, reflection: Array) -> Array:
        return self.turn[j] @ reflection @ self.turn[i].T


def symmetric(figure: Figure, middle: float) -> tuple[Rest, Index, Array]:
    """Pair the links of a figure.

    Args:
        middle: Tolerance of axes from the images of their partners', relative to the figure's size.

    Returns:
        The figure at rest, the partner of each link (L,), and the reflections from each link's frame to its partner's
        (L, 3, 3).

    Raises:
        MirrorError: Links have no partners.
    """
    rest = Rest.of(figure)
    partner = np.full(len(figure.links), -1, np.intp)
    images = np.tile(WORLD, (len(figure.links), 1, 1))
    partner[0] = 0
    for root in (0, *figure.tables.free_links.tolist()):
        if root and partner[root] >= 0:
            continue
        other = _named(figure, root)
        other = root if other is None or figure.links[other].kind is not JointKind.FREE else other
        planes = _planes(figure, root) if other == root else [WORLD]
        pairings = [_paired(rest, partner, (root, other), image, middle) for image in planes]
        paired = [
            (pairing, image)
            for n, (pairing, image) in enumerate(zip(pairings, planes, strict=True))
            if not pairing.complaint and (n < UPRIGHT_PLANES or _exchanges_sides(figure, pairing.partner))
        ]
        if not paired:
            raise MirrorError(pairings[0].complaint)
        best, images[root] = min(paired, key=lambda pair: (pair[0].misnamed, round(pair[0].unlike / rest.size, 3)))
        partner, images[other] = best.partner, images[root]
    reflection = np.array(
        [rest.turn[j].T @ images[r] @ rest.turn[i] for i, (j, r) in enumerate(zip(partner, rest.root, strict=True))]
    )
    return rest, partner, rounded(reflection)


def _exchanges_sides(figure: Figure, partner: Index) -> bool:
    """Return whether links named left and right are partners (L,); otherwise the plane may exchange front and back."""
    names = [link.name for link in figure.links]
    return any(j > i > 0 and other_side(names[i]) == names[j] != names[i] for i, j in enumerate(partner))


def rounded(matrix: Array) -> Array:
    """Return a matrix with entries close to 0, 1 or −1 rounded to these."""
    whole = np.round(matrix)
    return np.where(np.abs(matrix - whole) < EXACT, whole + 0.0, matrix)


def _planes(figure: Figure, root: int) -> list[Array]:
    """Return the candidate reflections (3, 3), in planes through a root's origin, in its frame."""
    if not root:
        return [WORLD]
    x, y, z = np.eye(3)
    normals = (y, quat.rotated(quat.inverse(figure.links[root].turn), y), x, z)
    return [rounded(np.eye(3) - 2 * np.outer(normal, normal)) for normal in normals]


def _named(figure: Figure, link: int) -> int | None:
    """Return the link named for the other side, or without a side (thigh_joint for thigh_left_joint), or None."""
    name = figure.links[link].name
    other, plain = other_side(name), _without_side(name)
    for i, candidate in enumerate(figure.links):
        if i and other != name and candidate.name == other:
            return i
    alike = [
        i for i, candidate in enumerate(figure.links) if i and i != link and _without_side(candidate.name) == plain
    ]
    return alike[0] if len(alike) == 1 else None


def _without_side(name: str) -> str:
    return re.sub(r"[\W_]", "", SIDE.sub("", name))


@dataclass(frozen=True)
class _Paired:
    """The pairing of links for one plane.

    Attributes:
        partner: The partner of each link, (L,).
        misnamed: The number of links whose partner is not the one of the other side by name.
        unlike: The total distance of the subtrees' centres of mass from symmetry [m].
        complaint: Why there is no pairing, or "".
    """

    partner: Index
    misnamed: int
    unlike: float
    complaint: str


def _paired(rest: Rest, partner: Index, top: tuple[int, int], image: Array, middle: float) -> _Paired:
    """Return the pairing of all descendants of two links that are each other's partners."""
    links, waiting, alone = rest.figure.links, [top], list[str]()
    partner = np.array(partner)
    partner[top[0]], partner[top[1]] = top[1], top[0]
    misnamed, unlike = 0, rest.unlike(*top, image) if rest.figure.tables.children[top[0]] and top[0] else 0.0
    is_level = unlike <= UNEVEN * rest.size
    while waiting:
        parent, other = waiting.pop(0)
        for i in _children(rest.figure, parent):
            if partner[i] >= 0:
                continue
            free = [j for j in _children(rest.figure, other) if partner[j] < 0]
            chosen, complaint = _partner(rest, i, free, image, middle)
            if chosen is None and complaint:
                return _Paired(partner, misnamed, unlike, complaint)
            if chosen is None:
                alone.append(links[i].name)
                continue
            misnamed, unlike = misnamed + bool(complaint), unlike + rest.unlike(i, chosen, image)
            partner[i], partner[chosen] = chosen, i
            waiting += [(i, chosen)] if i == chosen else [(i, chosen), (chosen, i)]
    names = ", ".join(f"'{name}'" for name in alone or [links[top[0]].name])
    by = "joints are paired by left and right, l and r, or by their places"
    return _Paired(
        partner, misnamed, unlike, f"no partner on the other side for: {names}; {by}" if alone or not is_level else ""
    )


def _children(figure: Figure, parent: int) -> list[int]:
    return [i for i, link in enumerate(figure.links) if i and link.parent == parent and link.kind is not JointKind.FREE]


def _partner(rest: Rest, i: int, free: Sequence[int], image: Array, middle: float) -> tuple[int | None, str]:
    """Return the partner of link i among unpaired links, by name or else by geometry; None without one. The second
    value is the misfit of the link with the matching name, or ""."""
    named, complaint = _named(rest.figure, i), ""
    if named is not None:
        misfit = rest.misfit(i, named, image, UNEVEN) if named in free else "kinds"
        if not misfit:
            return named, ""
        complaint = MISFITS[misfit].format(rest.figure.links[i].name, rest.figure.links[named].name)
    fits = {j: rest.unlike(i, j, image) for j in free if not rest.misfit(i, j, image, middle)}
    best = min(fits, key=lambda j: (fits[j], j != i), default=None)
    return (None if best is None or fits[best] > UNEVEN * rest.size else best), complaint
