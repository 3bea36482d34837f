"""What can be wrong with a motion at some time, each as rows of amounts over time: depths, bends, ranges, contacts, ...

A measure gives the hits: which of its rows is beyond its bound at which sample, and by how much. What keyframes say of
a row themselves they are to blame for, and not the path.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    BendLimits,
    Closed,
    Contact,
    Coupled,
    Hold,
    JointRange,
    Range,
    Rest,
    Rolling,
    SelfContact,
    Stance,
    closures,
    couplings,
    joint_ranges,
    slipped,
)
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import FAR, heights
from dynsplines.solver.surface.points import Point, places_of
from dynsplines.solver.surface.points import placed as points_placed

from .bounds import BOUNDS, WHIP_SHARE
from .depths import bunches, depths

SELF_STRIDE = 4  # limbs in each other take long to look for, and are not missed in a sixtieth of a second
SAME_DEPTH = 0.002  # [m] by which a sole point may be less deep than a corner of its foot and be named in its place


@dataclass(frozen=True)
class Row:
    """What is measured: its kind of bound, its name, and a sentence with {} for the amount."""

    kind: str
    name: str
    says: str
    bound: float


@dataclass(frozen=True, eq=False)
class Hits:
    """Rows (m,) beyond their bounds at samples (m,), with the amounts (m,)."""

    row: Index
    at: Index
    amount: Array

    @classmethod
    def of(cls, amounts: Array, bounds: Array | float) -> Hits:
        """Of amounts (n, S) and bounds (n, 1)."""
        row, at = np.nonzero(amounts > bounds)
        return cls(row, at, amounts[row, at])

    @classmethod
    def joined(cls, parts: Sequence[Hits]) -> Hits:
        if not parts:
            return cls(np.zeros(0, np.intp), np.zeros(0, np.intp), np.zeros(0))
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("row", "at", "amount")))


class Measure(Protocol):
    """Some rows; of those of one group the worst is reported.

    stride  how many samples of the grid to go on by
    """

    @property
    def groups(self) -> Index: ...

    @property
    def stride(self) -> int: ...

    def hits(self, samples: Samples) -> Hits: ...

    def row(self, index: int) -> Row: ...

    def given(self, index: int) -> Mask:
        """(K,) which keyframes fix the row's amount."""
        ...

    def named(self, hits: Hits, worst: int) -> int:
        """The row to name for the worst of some hits of one group at one time."""
        ...


@dataclass(frozen=True, eq=False)
class Plain:
    """Rows with an amount at every sample: amounts(samples) -> (n, S), fixed (n, K)."""

    rows: tuple[Row, ...]
    amounts: Callable[[Samples], Array]
    fixed: Mask
    groups: Index
    stride: int = 1

    @classmethod
    def each(cls, rows: Sequence[Row], amounts: Callable[[Samples], Array], fixed: Mask) -> Plain:
        """Every row a group of its own."""
        return cls(tuple(rows), amounts, fixed, np.arange(len(rows)))

    def hits(self, samples: Samples) -> Hits:
        return Hits.of(self.amounts(samples), np.array([[row.bound] for row in self.rows]))

    def row(self, index: int) -> Row:
        return self.rows[index]

    def given(self, index: int) -> Mask:
        return self.fixed[index]

    def named(self, hits: Hits, worst: int) -> int:
        return int(hits.row[worst])


def bends(figure: Figure, limits: BendLimits, fixed: Mask) -> Plain:
    """Knees and elbows bent backward, sideways or twisted."""
    most = np.degrees([limits.sideways, limits.twist])
    joints = limits.joints
    rows = [_row("backward", joint.name, f"{joint.name} is bent {{}} backward") for joint in joints]
    rows += [_row("sideways", joint.name, f"{joint.name} bends {{}} farther sideways than it may") for joint in joints]
    rows += [_row("twist", joint.name, f"{joint.name} is twisted {{}} farther than it may be") for joint in joints]

    def amounts(samples: Samples) -> Array:
        flexion, sideways, twist = np.degrees(limits.angles(samples))
        back = np.degrees(limits.least) - flexion
        return np.concatenate([back, np.abs(sideways) - most[0], np.abs(twist) - most[1]])

    own = _joints_fixed(figure, [joint.link for joint in joints], fixed)
    return Plain.each(rows, amounts, np.tile(own, (3, 1)))


def ranges(figure: Figure, fixed: Mask) -> Plain | None:
    """Joints beyond the model's ranges."""
    found = joint_ranges(figure)
    if not found:
        return None
    limits, slides = JointRange(found), np.array([joint.kind is JointKind.SLIDE for joint in found])
    text = "{} is {{}} beyond its range"
    rows = [
        _row("travel" if slide else "range", joint.name, text.format(joint.name))
        for joint, slide in zip(found, slides, strict=True)
    ]

    def amounts(samples: Samples) -> Array:
        beyond = limits.beyond(samples)
        return np.where(slides[:, None], beyond, np.degrees(beyond))

    return Plain.each(rows, amounts, _joints_fixed(figure, [joint.link for joint in found], fixed))


def overshoots(held: Sequence[Range], keys: int) -> Plain | None:
    """Joints that leave a value that two neighbouring keyframes give them."""
    if not held:
        return None
    limits, slides = JointRange(tuple(held)), np.array([joint.kind is JointKind.SLIDE for joint in held])
    text = "{} swings {{}} off the value that the keyframes at {:g} and {:g} s both specify"
    rows = [
        _row("overshoot travel" if slide else "overshoot", joint.name, text.format(joint.name, joint.first, joint.last))
        for joint, slide in zip(held, slides, strict=True)
    ]

    def amounts(samples: Samples) -> Array:
        beyond = np.maximum(limits.beyond(samples), 0.0)
        return np.where(slides[:, None], beyond, np.degrees(beyond))

    return Plain.each(rows, amounts, np.zeros((len(rows), keys), bool))


def coupled(figure: Figure, fixed: Mask) -> Plain | None:
    """Joints off what equality constraints make them follow."""
    found = couplings(figure)
    if not found:
        return None
    law, degrees = Coupled(found), np.array([[each.unit == "degrees"] for each in found])
    rows = [
        _row(
            "coupled" if each.unit == "degrees" else "coupled travel",
            each.name,
            f"{each.name} is {{}} off what it follows",
        )
        for each in found
    ]

    def amounts(samples: Samples) -> Array:
        away = np.abs(law.away(samples)[0])
        return np.where(degrees, np.degrees(away), away)

    own = np.array([fixed[:, each.follower] & (fixed[:, each.driver] if each.driver >= 0 else True) for each in found])
    return Plain.each(rows, amounts, own)


def torn(figure: Figure, placed: Mask) -> Plain | None:
    """Closed loops whose ends come apart."""
    found = closures(figure)
    if not found:
        return None
    loops = Closed(found)
    rows = [_row("torn", each.name, f"the loop of {each.name} is torn by {{}}") for each in found]
    own = placed[[each.one.link for each in found]] & placed[[each.two.link for each in found]]
    _, groups = np.unique([each.name for each in found], return_inverse=True)
    return Plain(tuple(rows), lambda samples: np.linalg.norm(loops.apart(samples), axis=0), own, groups)


def whips(figure: Figure, raw_peak: float, keys: int) -> Plain | None:
    """Links whose angular acceleration relative to their parents is far beyond what the raw spline needs."""
    rows_of = turning(figure)
    if not rows_of:
        return None
    bound = whip_bound(raw_peak)
    rows = [
        _row("whip", figure.links[i].name, f"{figure.links[i].name} whips: {{}}, {_times(raw_peak)}", bound)
        for i in rows_of
    ]
    return Plain.each(rows, lambda samples: turns(samples)[rows_of], np.zeros((len(rows), keys), bool))


def turning(figure: Figure) -> list[int]:
    """The links that turn about a joint."""
    return [i for i, link in enumerate(figure.links) if i > 0 and link.kind in (JointKind.BALL, JointKind.HINGE)]


def whip_bound(raw_peak: float) -> float:
    """[rad/s²] beyond which a limb whips, where the raw spline's largest angular acceleration is `raw_peak`."""
    return max(BOUNDS["whip"].most, WHIP_SHARE * raw_peak)


def _times(raw_peak: float) -> str:
    return f"the raw spline needs {raw_peak:.0f}"


def turns(samples: Samples) -> Array:
    """(L, S) [rad/s²] size of every link's angular acceleration relative to its parent."""
    alpha = samples.links.alpha
    return np.linalg.norm(alpha - alpha[:, samples.figure.tables.parents], axis=0)


def lengths(figure: Figure, keys: int) -> Plain | None:
    """Quaternions far from length 1."""
    links = figure.tables.quaternion_links
    if not links.size:
        return None
    says = "the quaternion of {} is {{}} off length 1 and turns fast"
    rows = [_row("length", figure.links[i].name, says.format(figure.links[i].name)) for i in links]

    def amounts(samples: Samples) -> Array:
        return np.abs(np.sqrt(samples.q_dots[0]) - 1)

    return Plain.each(rows, amounts, np.zeros((len(rows), keys), bool))


def links_placed(figure: Figure, fixed: Mask) -> Mask:
    """(L, K) whether keyframes with masks (K, N) fix every joint from the root to a link."""
    return points_placed(figure, fixed, [Point("", link, np.zeros(3)) for link in range(len(figure.links))])


def _row(kind: str, name: str, says: str, bound: float | None = None) -> Row:
    return Row(kind, name, says, BOUNDS[kind].most if bound is None else bound)


def _joints_fixed(figure: Figure, links: Sequence[int], fixed: Mask) -> Mask:
    """(n, K) which keyframes fix the joints of some links."""
    columns = [quaternion_columns(figure.links[i]) or figure.links[i].qpos for i in links]
    return np.array([np.atleast_2d(fixed[:, some].T).all(axis=0) for some in columns])


def hovering(rests: Sequence[Rest], surfaces: Sequence[Surface], placed: Mask) -> Plain:
    """Contacts whose points are over what they rest on, or over the surface below them, where there is one."""
    rows = [
        _row("hover", rest.point.name, f"contact {rest.point.name} is {{}} up while it should rest") for rest in rests
    ]
    points = tuple(rest.point for rest in rests)
    radii = np.array([point.radius for point in points])

    def amounts(samples: Samples) -> Array:
        places = places_of(points, samples)[0]
        height, _ = heights(surfaces, places, radii)
        for i, rest in enumerate(rests):
            if rest.ground is not None:
                height[i] = rest.ground.height(places[:, i]) - radii[i]
        during = np.array([(samples.t >= rest.first) & (samples.t <= rest.last) for rest in rests])
        return np.where(during & (height < FAR), height, 0.0)

    return Plain.each(rows, amounts, placed[[point.link for point in points]])


@dataclass(frozen=True, eq=False)
class Held:
    """Points that are to stay in their places: a row each stance.

    kind    "contact" or "stance"
    groups  (n,) the contact or foot that each belongs to
    says    a sentence each
    rolling how each rolls; none at all if none does
    """

    kind: str
    stances: tuple[Stance, ...]
    groups: Index
    says: tuple[str, ...]
    placed: Mask
    rolling: tuple[Rolling, ...] = ()
    stride: int = 1

    def hits(self, samples: Samples) -> Hits:
        parts, bound = [], BOUNDS[self.kind].most
        for i, stance in enumerate(self.stances):
            at = np.flatnonzero((samples.t >= stance.first) & (samples.t <= stance.last))
            if at.size:
                off = _places(samples, stance.point, at) - stance.place(samples.t[at])
                if self.rolling:
                    off -= self.rolling[i].way(samples.links.Q[:, stance.point.link, at])
                away = np.linalg.norm(off, axis=0)
                far = np.flatnonzero(away > bound)
                parts.append(Hits(np.full(far.size, i), at[far], away[far]))
        return Hits.joined(parts)

    def row(self, index: int) -> Row:
        return _row(self.kind, self.stances[index].point.name, self.says[index])

    def given(self, index: int) -> Mask:
        return self.placed[self.stances[index].point.link]

    def named(self, hits: Hits, worst: int) -> int:
        return int(hits.row[worst])


def slips(holds: Sequence[Hold], begun: Sequence[Array], placed: Mask) -> Plain:
    """Sites that move on what they hold.

    begun  (3,) each: where on the link it was when the hold began [m]
    """
    rows = [
        _row("hold", hold.point.name, f"{hold.point.name} moves {{}} on {hold.body}, which it holds") for hold in holds
    ]

    def amounts(samples: Samples) -> Array:
        out = np.zeros((len(holds), samples.count))
        for i, (hold, spot) in enumerate(zip(holds, begun, strict=True)):
            during = (samples.t >= hold.first) & (samples.t <= hold.last)
            out[i] = during * np.linalg.norm(slipped(samples, hold) - spot[:, None], axis=0)
        return out

    own = np.array([placed[hold.point.link] & placed[hold.link] for hold in holds])
    return Plain.each(rows, amounts, own)


def _places(samples: Samples, point: Point, at: Index) -> Array:
    """(3, k) [m] of a point at some samples."""
    x, rotation = samples.links.poses(point.link * samples.count + at)
    return x + np.einsum("ijk,j->ik", rotation, point.position)


@dataclass(frozen=True, eq=False)
class Sunk:
    """Points of a figure in surfaces: a row each pair of them, a group each pair of a link and a surface.

    parts   points and the surfaces that they are to stay out of
    soles   the names of points to be named rather than others
    placed  (L, K) which keyframes say where a link is
    """

    parts: tuple[Contact, ...]
    soles: frozenset[str]
    placed: Mask
    stride: int = 1

    @cached_property
    def _pairs(self) -> list[tuple[Point, str, int]]:
        """The point and surface of every row, and the surface's carrier."""
        return [
            (point, surface.name, part.carrier)
            for part in self.parts
            for surface in part.surfaces
            for point in part.points
        ]

    @property
    def groups(self) -> Index:
        return self._groups

    @cached_property
    def _groups(self) -> Index:
        numbers: dict[tuple[int, str], int] = {}
        return np.array(
            [numbers.setdefault((point.link, name), len(numbers)) for point, name, _ in self._pairs], np.intp
        )

    def hits(self, samples: Samples) -> Hits:
        return Hits.joined(list(self._hits(samples, BOUNDS["penetration"].most)))

    def _hits(self, samples: Samples, bound: float) -> Iterator[Hits]:
        first = 0
        for part in self.parts:
            limbs = bunches(part.points)
            for surface in part.surfaces:
                for bunch, at, deep in depths(limbs, surface, samples, part.carrier):
                    row, sample = np.nonzero(deep > bound)
                    if row.size:
                        yield Hits(first + bunch.which[row], at[sample], deep[row, sample])
                first += len(part.points)

    def row(self, index: int) -> Row:
        point, surface, _ = self._pairs[index]
        return _row("penetration", point.name, f"{point.name} is {{}} in {_the(surface)}")

    def given(self, index: int) -> Mask:
        point, _, carrier = self._pairs[index]
        return self.placed[point.link] & self.placed[carrier] if carrier else self.placed[point.link]

    def named(self, hits: Hits, worst: int) -> int:
        """A sole point, where one is about as deep."""
        deep = hits.row[hits.amount >= hits.amount[worst] - SAME_DEPTH]
        return next((int(i) for i in deep if self._pairs[i][0].name in self.soles), int(hits.row[worst]))


def _the(surface: str) -> str:
    """A surface in a sentence."""
    return f"the {surface}" if surface.isalpha() and surface.islower() else f"'{surface}'"


@dataclass(frozen=True, eq=False)
class Tangled:
    """Limbs of a figure in each other: a row and a group each pair of links."""

    figure: Figure
    contact: SelfContact
    placed: Mask
    stride: int = SELF_STRIDE

    @property
    def groups(self) -> Index:
        return np.arange(len(self.figure.links) ** 2)

    def hits(self, samples: Samples) -> Hits:
        met = self.contact.meetings(samples, 0.0)
        if met is None:
            return Hits.joined([])
        depth = met.depth - self.contact.margin
        deep = np.flatnonzero(depth > BOUNDS["self"].most)
        return Hits((met.first * len(self.figure.links) + met.last)[deep], met.at[deep], depth[deep])

    def row(self, index: int) -> Row:
        one, two = (self._limb(i) for i in divmod(index, len(self.figure.links)))
        return _row("self", one, f"{one} and {two} are {{}} in each other")

    def _limb(self, link: int) -> str:
        return self.figure.model.body(self.figure.links[link].body).name or self.figure.links[link].name

    def given(self, index: int) -> Mask:
        one, two = divmod(index, len(self.figure.links))
        return self.placed[one] & self.placed[two]

    def named(self, hits: Hits, worst: int) -> int:
        return int(hits.row[worst])
