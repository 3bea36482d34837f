"""Checks of a motion, each for one or a few kinds of violation.

A check measures several quantities, its rows, such as the depths of many points. An amount is the value of a row at a
sample. Most amounts are residuals of a penalty; the search's tolerance near keyframes is not subtracted.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.figure.figure import Figure, JointKind, sets_joints
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    Attachment,
    BendLimits,
    Collision,
    CouplingPenalty,
    JointRange,
    Range,
    Speed,
    closures,
    couplings,
    grasp_places,
)
from dynsplines.solver.penalty.motion.acceleration import relative_accelerations
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import FAR, heights
from dynsplines.solver.surface.points import places_of, sets_depths, sets_poses

from ..motion import samples_at
from .bounds import BOUNDS, SPEED_SHARE, WHIP_SHARE, Row, row_of
from .depths import bunches, colliding, depths, overlaps

SAME_DEPTH = 0.002  # [m] a sole point is named although another point of the foot is deeper, if by at most this


@dataclass(frozen=True, eq=False)
class Hits:
    """Large amounts: `amount` (m,) of the rows `row` (m,) at the samples `at` (m,), in the unit of the row."""

    row: Index
    at: Index
    amount: Array

    @classmethod
    def of(cls, amounts: Array) -> Hits:
        """Return the positive amounts (n, S) of n rows at S samples."""
        row, at = np.nonzero(amounts > 0)
        return cls(row, at, amounts[row, at])

    @classmethod
    def join(cls, parts: Sequence[Hits]) -> Hits:
        if not parts:
            return cls(np.zeros(0, np.intp), np.zeros(0, np.intp), np.zeros(0))
        return cls(*(np.concatenate([getattr(part, name) for part in parts]) for name in ("row", "at", "amount")))

    def select(self, which: Index | Mask) -> Hits:
        return Hits(self.row[which], self.at[which], self.amount[which])

    def largest(self, label: Index) -> Index:
        """Return the index of the largest amount, the first of equal ones, for every label that is not negative."""
        order = np.lexsort((-self.at, self.amount, label))
        last = np.append(label[order][1:] != label[order][:-1], True)[: order.size]
        return order[last & (label[order] >= 0)]


@dataclass(frozen=True, eq=False)
class Check:
    """A kind of violation with n rows. Only the worst row of a group is reported, such as the deepest point of a foot.

    hits      function that returns the amounts in samples; also amounts below the bounds, for the report
    row       function that returns a row by its index
    bounds    (n,) amounts above which there is a violation
    groups    (n,) group of each row, as a number
    is_fixed  function of indices of rows (m,) and keyframes (m,): whether the keyframe determines the amount of the
              row, so that it causes the violation
    named     (n,) whether the row is named even if another row of its group is slightly worse; None: no row
    is_once_per_group  whether all keyframes that violate a group are reported in one line, instead of one line each
    """

    hits: Callable[[Samples], Hits]
    row: Callable[[int], Row]
    bounds: Array
    groups: Index
    is_fixed: Callable[[Index, Index], Mask]
    named: Mask | None = None
    is_once_per_group: bool = False

    @classmethod
    def each(
        cls,
        rows: Sequence[Row],
        hits: Callable[[Samples], Hits],
        fixed: Mask | None = None,
        groups: Index | None = None,
    ) -> Check:
        """Return the check of a list of rows.

        fixed   (n, K) whether a keyframe causes the amounts of a row; None: none does
        groups  (n,) as in `Check`; None: each row is a group
        """

        def is_fixed(row: Index, key: Index) -> Mask:
            return np.zeros(row.size, bool) if fixed is None else fixed[row, key]

        bounds = np.array([row.bound for row in rows])
        return cls(hits, rows.__getitem__, bounds, np.arange(len(rows)) if groups is None else groups, is_fixed)


@dataclass(frozen=True, eq=False)
class Fixed:
    """What keyframes fix: entries of the state, `states` (K, N), and whole poses of links, `places` (L, K)."""

    figure: Figure
    states: Mask

    @cached_property
    def places(self) -> Mask:
        links = np.arange(len(self.figure.links))
        return sets_poses(self.figure, self.states, links, 0 * links)

    def contacts(self, contacts: Sequence[Contact]) -> Mask:
        """Return which keyframes fix the poses of points relative to what they touch, (n, K)."""
        links = [contact.point.link for contact in contacts]
        return sets_poses(self.figure, self.states, links, [contact.on for contact in contacts])


def bends(limits: BendLimits, fixed: Fixed, bound: float | None) -> Check:
    """Return the check of knees and elbows that bend backward or sideways, or twist.

    bound  largest tolerated angle [degrees]; None: that of the kind of violation
    """
    rows = [
        row_of(kind, joint.name, f"{joint.name} {text}", bound)
        for kind, text in (
            ("backward", "is bent {} backward"),
            ("sideways", "bends {} sideways beyond its limit"),
            ("twist", "is twisted {} beyond its limit"),
        )
        for joint in limits.joints
    ]

    def hits(samples: Samples) -> Hits:
        flexion, sideways, twist = limits.angles(samples)
        beyond = [limits.least - flexion, np.abs(sideways) - limits.sideways, np.abs(twist) - limits.twist]
        return Hits.of(np.degrees(np.concatenate(beyond)))

    is_set = sets_joints(fixed.figure, fixed.states, [joint.link for joint in limits.joints])
    return Check.each(rows, hits, np.tile(is_set, (3, 1)))


def ranges(joints: Sequence[Range], kinds: tuple[str, str], text: str, fixed: Mask | None = None) -> Check:
    """Return the check of joint ranges.

    kinds  kind of violation of hinges and ball joints, and that of slides
    text   the message, a format string with the fields of the `Range` as {joint.name} and so on
    fixed  (n, K) whether a keyframe fixes a joint; None: no keyframe causes violations
    """
    limits, slides = JointRange(tuple(joints)), np.array([joint.kind is JointKind.SLIDE for joint in joints])
    rows = [
        row_of(kinds[int(slide)], joint.name, text.format("{}", joint=joint))
        for joint, slide in zip(joints, slides, strict=True)
    ]

    def hits(samples: Samples) -> Hits:
        excess = Hits.of(limits.beyond(samples))
        return replace(excess, amount=np.where(slides[excess.row], excess.amount, np.degrees(excess.amount)))

    return Check.each(rows, hits, fixed)


def speeds(figure: Figure, limit: Speed) -> Check:
    """Return the check of hinges and ball joints that exceed a speed limit."""
    most = float(np.degrees(limit.limit))
    bound, text = max(BOUNDS["speed"].most, SPEED_SHARE * most), f"faster than its limit of {most:.0f} degrees/s"
    names = [figure.links[i].name for i in figure.tables.rotary_links]
    rows = [row_of("speed", name, f"{name} turns {{}} {text}", bound) for name in names]
    return Check.each(rows, lambda samples: Hits.of(np.degrees(limit.excess(samples))))


def coupling_errors(fixed: Fixed) -> Check | None:
    """Return the check of joints that equality constraints couple to others."""
    joints = couplings(fixed.figure)
    if not joints:
        return None
    law, turns = CouplingPenalty(joints), np.array([[joint.unit == "degrees"] for joint in joints])
    kinds = ["coupled" if joint.unit == "degrees" else "coupled travel" for joint in joints]
    rows = [
        row_of(kind, joint.name, f"{joint.name} is {{}} off what it follows")
        for kind, joint in zip(kinds, joints, strict=True)
    ]

    def hits(samples: Samples) -> Hits:
        away = np.abs(law.away(samples)[0])
        return Hits.of(np.where(turns, np.degrees(away), away))

    is_fixed = fixed.states.T
    both = [is_fixed[joint.follower] & (is_fixed[joint.driver] if joint.driver >= 0 else True) for joint in joints]
    return Check.each(rows, hits, np.array(both))


def loop_gaps(fixed: Fixed) -> Check | None:
    """Return the check of gaps in closed loops."""
    pairs = closures(fixed.figure)
    if not pairs:
        return None
    names = [pair.point.name for pair in pairs]
    rows = [row_of("torn", name, f"the loop of {name} is torn by {{}}") for name in names]
    loops = Attachment(pairs)

    def hits(samples: Samples) -> Hits:
        row, at, away = loops.displacements(samples)
        return Hits(row, at, np.linalg.norm(away, axis=0))

    _, groups = np.unique(names, return_inverse=True)
    return Check.each(rows, hits, fixed.contacts(pairs), groups)


def whips(figure: Figure, raw_peak: float) -> Check | None:
    """Return the check of links with a much greater angular acceleration in the parent than the raw spline requires."""
    links = figure.tables.rotary_links
    if not links.size:
        return None
    bound = max(BOUNDS["whip"].most, WHIP_SHARE * raw_peak)
    names = [figure.links[i].name for i in links]
    rows = [row_of("whip", name, f"{name} whips: {{}}, the raw spline needs {raw_peak:.0f}", bound) for name in names]
    return Check.each(rows, lambda samples: Hits.of(relative_accelerations(samples)[1][links]))


def lengths(figure: Figure) -> Check | None:
    """Return the check of quaternions with lengths far from 1."""
    names = [figure.links[i].name for i in figure.tables.quaternion_links]
    text = "the quaternion of {} is {{}} off length 1 and turns fast"
    rows = [row_of("length", name, text.format(name)) for name in names]
    return Check.each(rows, lambda samples: Hits.of(np.abs(np.sqrt(samples.q_dots[0]) - 1))) if rows else None


def hovering(rests: Sequence[Contact], surfaces: Sequence[Surface], groups: Index, fixed: Fixed) -> Check:
    """Return the check of contacts whose points are above their surface, or above the one below them."""
    text = "contact {} is {{}} above its surface"
    rows = [row_of("hover", rest.point.name, text.format(rest.point.name)) for rest in rests]
    points = tuple(rest.point for rest in rests)

    def hits(samples: Samples) -> Hits:
        places, radii = places_of(points, samples)
        height, _ = heights(surfaces, places, radii)
        for i, rest in enumerate(rests):
            if rest.surface is not None:
                height[i] = rest.surface.height(places[:, i]) - radii[i]
        during = np.array([rest.during(samples.t) for rest in rests])
        return Hits.of(np.where(during & (height < FAR), height, 0.0))

    return Check.each(rows, hits, fixed.places[[point.link for point in points]], groups)


def displacements(kind: str, contacts: Sequence[Contact], groups: Index, fixed: Fixed) -> Check:
    """Return the check of points that leave their places; kind: "contact" or "stance"."""
    attachment, points = Attachment(tuple(contacts)), [contact.point for contact in contacts]

    def hits(samples: Samples) -> Hits:
        row, at, away = attachment.displacements(samples)
        for i, contact in enumerate(contacts):
            if contact.start is not None:
                mine = row == i
                away[:, mine] -= contact.roll(samples.links.Q[:, contact.point.link, at[mine]])
        return Hits(row, at, np.linalg.norm(away, axis=0))

    text = {
        "contact": "contact {} is {{}} from the place where it should rest",
        "stance": "{} moves {{}} between keyframes with the same position",
    }[kind]
    rows = [row_of(kind, point.name, text.format(point.name)) for point in points]
    return Check.each(rows, hits, fixed.places[[point.link for point in points]], groups)


def slips(grasps: Sequence[Contact], starts: Sequence[Array], fixed: Fixed) -> Check:
    """Return the check of sites that move on grasped links; starts: initial positions (3,) [m] on these."""
    text = "{} is {{}} from the place where it grasps {}"
    rows = [
        row_of("grasp", grasp.point.name, text.format(grasp.point.name, fixed.figure.body_name(grasp.on)))
        for grasp in grasps
    ]

    def hits(samples: Samples) -> Hits:
        out = np.zeros((len(grasps), samples.count))
        for i, (grasp, start) in enumerate(zip(grasps, starts, strict=True)):
            out[i] = grasp.during(samples.t) * np.linalg.norm(grasp_places(samples, grasp) - start[:, None], axis=0)
        return Hits.of(out)

    return Check.each(rows, hits, fixed.contacts(grasps))


def turns(contacts: Sequence[Contact], path: Path, fixed: Fixed) -> Check:
    """Return the check of bodies that rotate in a grasp, by the contacts of points next to the site."""
    figure, text = fixed.figure, "{} rotates by {{}} in the grasp of {}"
    names = [(figure.body_name(contact.on), contact.point.name) for contact in contacts]
    rows = [row_of("grasp rotation", hand, text.format(body, hand)) for body, hand in names]
    starts = [grasp_places(samples_at(figure, path, np.array([contact.first])), contact) for contact in contacts]

    def hits(samples: Samples) -> Hits:
        out = np.zeros((len(contacts), samples.count))
        for i, (contact, start) in enumerate(zip(contacts, starts, strict=True)):
            place = contact.place(samples.t) if contact.is_placed else start
            away = np.linalg.norm(grasp_places(samples, contact) - place, axis=0)
            out[i] = contact.during(samples.t) * np.degrees(away / Thresholds.of(figure).object_arm)
        return Hits.of(out)

    _, groups = np.unique([f"{hand} {body}" for body, hand in names], return_inverse=True)
    return Check.each(rows, hits, fixed.contacts(contacts), groups)


def penetrations(parts: Sequence[Collision], soles: frozenset[str], feet: Index, fixed: Fixed) -> Check:
    """Return the check of points in surfaces: a row for each pair, a group for each pair of a foot or limb and a
    surface.

    parts  points and the surfaces that they must avoid;  soles  names of points with precedence in messages
    feet   (L,) the link that represents a foot or limb
    """
    pairs = [(point, surface.name) for part in parts for surface in part.surfaces for point in part.points]
    numbers: dict[tuple[int, str], int] = {}
    groups = [numbers.setdefault((int(feet[point.link]), name), len(numbers)) for point, name in pairs]
    bunched = [bunches(part.points) for part in parts]

    def hits(samples: Samples) -> Hits:
        hits_of_bunches, first = [], 0
        for part, limbs in zip(parts, bunched, strict=True):
            for surface in part.surfaces:
                for bunch, at, deep in depths(limbs, surface, samples):
                    row, sample = np.nonzero(deep > 0)
                    if row.size:
                        hits_of_bunches.append(Hits(first + bunch.which[row], at[sample], deep[row, sample]))
                first += len(part.points)
        return Hits.join(hits_of_bunches)

    def row(index: int) -> Row:
        point, surface = pairs[index]
        return row_of("penetration", point.name, f"{point.name} is {{}} in {_quote(surface)}", other=surface)

    is_set = np.concatenate(
        [sets_depths(fixed.figure, fixed.states, part.points, [surface]) for part in parts for surface in part.surfaces]
        or [np.zeros((0, len(fixed.states)), bool)]
    )

    def is_fixed(row: Index, key: Index) -> Mask:
        return is_set[row, key]

    named = np.array([point.name in soles for point, _ in pairs], bool)
    bounds = np.full(len(pairs), BOUNDS["penetration"].most)
    return Check(hits, row, bounds, np.array(groups, np.intp), is_fixed, named)


def self_overlaps(carried: Sequence[int], fixed: Fixed) -> Check:
    """Return the check of overlapping bodies: a row per pair of links, a group per pair of limbs; grasped ones are
    solid."""
    figure, count = fixed.figure, len(fixed.figure.links)
    model, at_rest = colliding(figure)
    limbs, is_carried = _limbs(figure), np.isin(np.arange(count), carried)
    is_solid = is_carried[:, None] != is_carried
    bounds = np.where(is_solid, BOUNDS["penetration"].most, BOUNDS["self"].most).ravel()
    groups = (np.minimum(limbs[:, None], limbs) * count + np.maximum(limbs[:, None], limbs)).ravel()

    def hits(samples: Samples) -> Hits:
        at, links, depth = overlaps(figure, model, figure.to_qpos(samples.y))
        deeper = depth - at_rest[links]
        return Hits(links[0] * count + links[1], at, deeper).select(deeper > 0)

    def row(index: int) -> Row:
        links = divmod(index, count)
        one, two = (figure.body_name(i) for i in links)
        if is_solid[links]:
            one, two = (two, one) if is_carried[links[0]] else (one, two)
            return row_of("penetration", one, f"{one} is {{}} in {_quote(two)}", other=two)
        deeper = "deeper " if at_rest[links] else ""
        return row_of("self", one, f"{one} and {two} are {{}} {deeper}in each other", other=two)

    def is_fixed(row: Index, key: Index) -> Mask:
        pairs, of_row = np.unique(row, return_inverse=True)
        return sets_poses(figure, fixed.states, *np.divmod(pairs, count))[of_row, key]

    return Check(hits, row, bounds, groups, is_fixed, is_once_per_group=True)


def _quote(name: str) -> str:
    """Return the name of a surface in a sentence."""
    return f"the {name}" if name.isalpha() and name.islower() else f"'{name}'"


def _limbs(figure: Figure) -> Index:
    """Return the first link (L,) of the part of the body of each link. A part is the trunk, which is the root with
    adjacent branching links, or a limb, which is a chain without branches."""
    parents = figure.tables.parents
    branches = figure.tables.children > 1
    limbs, in_trunk = np.arange(parents.size), parents == 0
    for i in range(1, parents.size):
        parent = parents[i]
        in_trunk[i] |= branches[i] and in_trunk[parent]
        if parent and (in_trunk[i] or not branches[parent]):
            limbs[i] = limbs[parent]
    return limbs
