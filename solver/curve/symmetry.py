"""The symmetry of a figure at rest: the partner of each link on the opposite side, and the map between their frames.

Links are paired by left and right in their names, or by a list of pairs. All others are in the mirror plane. The axis
of a hinge must be the image of its partner's axis as a line, and that of a slide as a direction. The mirror plane
passes through the middle of the figure. It is the x-z plane of the root's frame, that of the world at rest, or another
plane of the root's axes: the one in which the links are the most symmetric.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .. import quaternion as quat
from ..array import Array, Index
from ..figure.figure import Figure, JointKind
from ..tolerances import NEGLIGIBLE, ROUNDING

WORLD = np.diag([1.0, -1, 1])  # S, the reflection of the world
MIDDLE, UNEVEN = 0.01, 0.05  # [1] tolerances of axes and of centres of mass, relative to the figure's size
UPRIGHT_PLANES = 2  # the first candidates: the x-z planes of the root and of the world
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

UNPAIRED = 'joints are paired by left and right, l and r in their names, or by "pairs" of the table [mirror] of a clip'
MISFITS = {
    "kinds": "'{}' and '{}' differ in kind of joint or in parent",
    "axes": "the axes of '{}' and '{}' are no mirror images",
    "places": "'{}' at rest is no mirror image of '{}'",
}


def other_side(name: str, pairs: Sequence[tuple[str, str]] = ()) -> str:
    """Return the other name of a pair, or else the name with left and right exchanged: left_knee -> right_knee,
    foot_l -> foot_r, FL_hip -> FR_hip. Names without a side are returned unchanged.
    """
    for one, other in pairs:
        if name in (one, other):
            return other if name == one else one
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
        size: The extent of each link's tree [m]; 1 for a single link, (L,).
    """

    figure: Figure
    root: Index
    place: Array
    turn: Array
    axis: Array
    centre: Array
    size: Array

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
        size = np.ones(count)
        for tree in (root == r for r in np.unique(root[1:])):
            size[tree] = float(np.linalg.norm(np.ptp(np.vstack([place[tree], centres[tree]]), axis=0))) or 1.0
        return cls(figure, root, place, turn, axis, centre, size)

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
                return "" if abs(self._share(i, j, image)) >= 1 - NEGLIGIBLE else "axes"
        else:
            if abs(self._share(i, j, image)) < 1 - NEGLIGIBLE:
                return "axes"
            offset = self.place[j] - image @ self.place[i]
            offset = offset - self.axis[j] * (offset @ self.axis[j])
        return "" if np.linalg.norm(offset) <= middle * self.size[i] else "places"

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


def symmetric(figure: Figure, pairs: Sequence[tuple[str, str]], middle: float) -> tuple[Rest, Index, Array]:
    """Pair the links of a figure.

    Args:
        pairs: Names of further partners, for joints without left and right in their names.
        middle: Tolerance of axes in the mirror plane, relative to the figure's size.

    Returns:
        The figure at rest, the partner of each link (L,), and the reflections from each link's frame to its partner's
        (L, 3, 3).

    Raises:
        ValueError: Links have no partners, or are no mirror images of them.
    """
    rest, partner = Rest.of(figure), _partners(figure, pairs)
    images = np.tile(WORLD, (len(figure.links), 1, 1))
    for root in (0, *figure.tables.free_links.tolist()):
        links = np.flatnonzero(np.isin(rest.root, [root, partner[root]]))
        planes = _planes(figure, root) if partner[root] == root else [WORLD]
        if np.array_equal(partner[links], links):
            planes = planes[:UPRIGHT_PLANES]  # others may exchange front and back
        fits = [_misfits(rest, links, partner, image, middle) for image in planes]
        costs = [(len(misfits), round(off / rest.size[links].max(), 3)) for misfits, off in fits]
        best = costs.index(min(costs))
        if fits[best][0]:
            raise ValueError(fits[best][0][0])
        images[root] = planes[best]
    reflection = np.array(
        [rest.turn[j].T @ images[r] @ rest.turn[i] for i, (j, r) in enumerate(zip(partner, rest.root, strict=True))]
    )
    return rest, partner, round_to_signs(reflection)


def round_to_signs(matrix: Array) -> Array:
    """Return a matrix with entries close to 0, 1 or −1 rounded to these."""
    whole = np.round(matrix)
    return np.where(np.abs(matrix - whole) < ROUNDING, whole + 0.0, matrix)


def _planes(figure: Figure, root: int) -> list[Array]:
    """Return the candidate reflections (3, 3), in planes through a root's origin, in its frame."""
    if not root:
        return [WORLD]
    x, y, z = np.eye(3)
    normals = (y, quat.rotate(quat.inverse(figure.links[root].turn), y), x, z)
    return [round_to_signs(np.eye(3) - 2 * np.outer(normal, normal)) for normal in normals]


def _partners(figure: Figure, pairs: Sequence[tuple[str, str]]) -> Index:
    """Return the partner of each link by its name, the link itself without one, (L,).

    A partner is that of `pairs`, the link named for the other side, or the only one whose name differs by a side alone
    (thigh_joint for thigh_left_joint).
    """
    names = [link.name for link in figure.links]
    plain = [re.sub(r"[\W_]", "", SIDE.sub("", name)) for name in names]
    partner = np.arange(len(names))
    for i, name in enumerate(names[1:], start=1):
        other = other_side(name, pairs)
        alike = [j for j in range(1, len(names)) if j != i and plain[j] == plain[i]]
        if other != name and other in names[1:]:
            partner[i] = names.index(other, 1)
        elif len(alike) == 1 and (other != name or other_side(names[alike[0]]) != names[alike[0]]):
            partner[i] = alike[0]
    return partner


def _misfits(rest: Rest, links: Index, partner: Index, image: Array, middle: float) -> tuple[list[str], float]:
    """Return why links are not the images of their partners in a mirror (3, 3), and how asymmetric they are: the total
    distance of the subtrees' centres of mass from the images of their partners' [m]."""
    figure, total, pairs, alone = rest.figure, 0.0, list[str](), list[int]()
    for i in links[links > 0].tolist():
        j = int(partner[i])
        one, two = figure.links[i], figure.links[j]
        misfit = rest.misfit(i, j, image, middle if i == j else UNEVEN)
        misfit = misfit if partner[one.parent] == two.parent and partner[j] == i else "kinds"
        is_object = one.kind is JointKind.FREE and not figure.tables.children[i]
        off = 0.0 if is_object else rest.unlike(i, j, image)
        if misfit and i != j:
            pairs.append(MISFITS[misfit].format(one.name, two.name))
        elif misfit or (i == j and (off > UNEVEN * rest.size[i] or _has_image(rest, links, partner, i, image, middle))):
            alone.append(i)
        total += off
    alone = [i for i in alone if figure.links[i].kind is not JointKind.FREE] or alone
    names = ", ".join(f"'{figure.links[i].name}'" for i in alone)
    return pairs + [f"no partner on the other side for: {names}; {UNPAIRED}"] * len(alone), total


def _has_image(rest: Rest, links: Index, partner: Index, i: int, image: Array, middle: float) -> bool:
    """Return whether another link without a partner is more like the image of a link i than the link itself."""
    parent, off = rest.figure.links[i].parent, rest.unlike(i, i, image)
    others = [j for j in links.tolist() if partner[j] == j != i and rest.figure.links[j].parent == parent]
    least = off - ROUNDING * rest.size[i]
    return any(not rest.misfit(i, j, image, middle) and rest.unlike(i, j, image) < least for j in others)
