"""The symmetry of a figure at rest: which link is on the other side of which, and how their frames are related.

Links are paired by left and right in their names, else by geometry. Either way the axis of a hinge is the image of its
partner's axis as a line, and a slide's as a direction, in a plane through the middle of the figure: the x-z plane of
the root's frame, of the world at rest, or another plane of the root's axes, the first in which all links have partners.
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
SAME_LINE = 1e-3  # 1 − cosine of the angle between an axis and the image of its partner's
MIDDLE, UNEVEN = 0.01, 0.05  # of the figure's size: how far axes, and centres of mass, may be from symmetric
UPRIGHT_PLANES = 2  # of those tried: the x-z planes of the root and of the world
EXACT = 1e-9  # entries of a reflection are rounded to 0, 1 or −1 within this
# a separate word, or an initial capital; or next to the letter for front, rear, hind, back or middle: FL, rh
ENDS_LEG = r"[FRHBMfrhbm]"
SIDE = re.compile(
    rf"(?<![A-Za-z])(?:[Ll]eft|[Rr]ight|LEFT|RIGHT|[LlRr](?![LRlr](?![A-Za-z])))(?![a-z])"
    rf"|(?<=[a-z])(?:Left|Right|[LR])(?![a-z])"
    rf"|(?<![A-Za-z])[lr](?=[fhbm](?![A-Za-z]))"
    rf"|(?<=(?<![A-Za-z]){ENDS_LEG})[LRlr](?![A-Za-z])"
)
WORDS = {"left": "right", "Left": "Right", "LEFT": "RIGHT", "l": "r", "L": "R"}
OTHER = WORDS | {right: left for left, right in WORDS.items()}


MISFITS = {
    "kinds": "'{}' and '{}' are not alike: other kinds of joints, or other parents",
    "axes": "the axes of '{}' and '{}' are no mirror images",
    "places": "'{}' at rest is no mirror image of '{}'",
}


class MirrorError(ValueError):
    """A figure that has no left and right to exchange."""


def other_side(name: str) -> str:
    """left_knee -> right_knee, LeftArm -> RightArm, foot_l -> foot_r, FL_hip -> FR_hip; others stay as they are."""
    return SIDE.sub(lambda match: OTHER[match[0]], name)


@dataclass(frozen=True, eq=False)
class Rest:
    """A figure at rest: every link in the frame of its tree's free root, or in the world.

    root   (L,) the free root of each link's tree, 0 for what hangs on the world
    place  (L, 3) [m] anchors;  turn  (L, 3, 3) of the links' frames;  axis  (L, 3) of hinges and slides
    centre  (L, 3) [m] the centre of mass of a link and its descendants, NaN without mass
    size   [m] from end to end, 1 for a single link
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
        carried = figure.tables.beyond
        with np.errstate(invalid="ignore"):
            centre = carried @ (mass[:, None] * centres) / (carried @ mass)[:, None]
        spread = [np.ptp(np.vstack([place[root == r], centres[root == r]]), axis=0) for r in np.unique(root[1:])]
        return cls(
            figure, root, place, turn, axis, centre, max(float(np.linalg.norm(extent)) for extent in spread) or 1.0
        )

    def sense(self, i: int, j: int, reflection: Array) -> float:
        """1 or −1: whether hinge or slide j moves as i does, or the other way, in the mirror."""
        return 1.0 if self._share(i, j, self._image(i, j, reflection)) > 0 else -1.0

    def misfit(self, i: int, j: int, image: Array, middle: float) -> str:
        """Why link j cannot be the image of link i in a mirror, (3, 3) of the root's frame; "" where it can."""
        one, two = self.figure.links[i], self.figure.links[j]
        if one.kind is not two.kind:
            return "kinds"
        if one.kind in (JointKind.FREE, JointKind.SLIDE) or one.kind is JointKind.BALL:
            off = self.place[j] - image @ self.place[i]
            if one.kind is JointKind.SLIDE:
                return "" if abs(self._share(i, j, image)) >= 1 - SAME_LINE else "axes"
        else:
            if abs(self._share(i, j, image)) < 1 - SAME_LINE:
                return "axes"
            off = self.place[j] - image @ self.place[i]
            off = off - self.axis[j] * (off @ self.axis[j])
        return "" if np.linalg.norm(off) <= middle * self.size else "places"

    def unlike(self, i: int, j: int, image: Array) -> float:
        """[m] distance of the centre of mass of link j's subtree from the image of that of link i's."""
        off = np.linalg.norm(self.centre[j] - image @ self.centre[i])
        return float(off) if np.isfinite(off) else 0.0

    def _share(self, i: int, j: int, image: Array) -> float:
        """Cosine of the angle between an axis and the image of another."""
        along = image @ self.axis[i] * (-1.0 if self.figure.links[i].kind is JointKind.HINGE else 1.0)
        return float(along @ self.axis[j])

    def _image(self, i: int, j: int, reflection: Array) -> Array:
        return self.turn[j] @ reflection @ self.turn[i].T


def symmetric(figure: Figure, middle: float) -> tuple[Rest, Index, Array]:
    """The figure at rest, every link's partner (L,), and the reflection from its frame to the partner's (L, 3, 3).

    middle  how far axes may be off the images of their partners', as a share of the figure's size
    Raises MirrorError.
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
        tried = [_paired(rest, partner, (root, other), image, middle) for image in planes]
        paired = [
            (pairing, image)
            for n, (pairing, image) in enumerate(zip(tried, planes, strict=True))
            if not pairing.complaint and (n < UPRIGHT_PLANES or _exchanges_sides(figure, pairing.partner))
        ]
        if not paired:
            raise MirrorError(tried[0].complaint)
        best, images[root] = min(paired, key=lambda pair: (pair[0].misnamed, round(pair[0].unlike / rest.size, 3)))
        partner, images[other] = best.partner, images[root]
    reflection = np.array(
        [rest.turn[j].T @ images[r] @ rest.turn[i] for i, (j, r) in enumerate(zip(partner, rest.root, strict=True))]
    )
    return rest, partner, rounded(reflection)


def _exchanges_sides(figure: Figure, partner: Index) -> bool:
    """Whether left and right by name are partners (L,); else the plane might exchange front and back."""
    names = [link.name for link in figure.links]
    return any(j > i > 0 and other_side(names[i]) == names[j] != names[i] for i, j in enumerate(partner))


def rounded(matrix: Array) -> Array:
    """A matrix with entries that are nearly 0, 1 or −1 exactly that."""
    whole = np.round(matrix)
    return np.where(np.abs(matrix - whole) < EXACT, whole + 0.0, matrix)


def _planes(figure: Figure, root: int) -> list[Array]:
    """Reflections (3, 3) in planes through a root's origin, in its frame: those that may be a figure's middle."""
    if not root:
        return [WORLD]
    x, y, z = np.eye(3)
    normals = (y, quat.rotated(quat.inverse(figure.links[root].turn), y), x, z)
    return [rounded(np.eye(3) - 2 * np.outer(normal, normal)) for normal in normals]


def _named(figure: Figure, link: int) -> int | None:
    """The link whose name is that of the other side, or the same but for a side: thigh_joint, thigh_left_joint."""
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
    """A name without left and right, and without what separates words."""
    return re.sub(r"[\W_]", "", SIDE.sub("", name))


@dataclass(frozen=True)
class _Paired:
    """The partners (L,) that a plane leads to.

    misnamed   how many links have another partner than that of the name of the other side
    unlike     [m] how far what links carry is from symmetric, in all
    complaint  what prevents it, or ""
    """

    partner: Index
    misnamed: int
    unlike: float
    complaint: str


def _paired(rest: Rest, partner: Index, top: tuple[int, int], image: Array, middle: float) -> _Paired:
    """The partners of all descendants of two links that are partners of each other."""
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
    """The children of a link, those of the world without free bodies."""
    return [i for i, link in enumerate(figure.links) if i and link.parent == parent and link.kind is not JointKind.FREE]


def _partner(rest: Rest, i: int, free: Sequence[int], image: Array, middle: float) -> tuple[int | None, str]:
    """The partner of link i among those that have none yet, by name or else by geometry.

    With the misfit of the link of that name, "" without one.
    """
    named, complaint = _named(rest.figure, i), ""
    if named is not None:
        misfit = rest.misfit(i, named, image, UNEVEN) if named in free else "kinds"
        if not misfit:
            return named, ""
        complaint = MISFITS[misfit].format(rest.figure.links[i].name, rest.figure.links[named].name)
    fits = {j: rest.unlike(i, j, image) for j in free if not rest.misfit(i, j, image, middle)}
    best = min(fits, key=lambda j: (fits[j], j != i), default=None)
    return (None if best is None or fits[best] > UNEVEN * rest.size else best), complaint
