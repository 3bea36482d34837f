"""A clip's soft constraints by kind: defaults, what its [[penalty]] tables change, what a figure's names tell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.naming import geom_name
from dynsplines.solver.penalty import (
    Bend,
    BendLimits,
    Bound,
    Closed,
    Contact,
    Coupled,
    CovariantAcceleration,
    Cycle,
    Flight,
    Grounded,
    Holding,
    JointRange,
    Lean,
    PeakAcceleration,
    Penalty,
    Placed,
    Placement,
    Planted,
    Posture,
    Resting,
    RootAcceleration,
    SelfContact,
    Skate,
    Stance,
    Support,
    Together,
    Torque,
    UnitMagnitude,
    Upright,
    carried_links,
    closures,
    couplings,
    flights,
    footings,
    grounded_intervals,
    joint_ranges,
    leans,
    lying,
    stances,
    surfaces_on,
)
from dynsplines.solver.reading.rhythm import Rhythm
from dynsplines.solver.reading.stride import Gait
from dynsplines.solver.surface import Box, Plane, Surface
from dynsplines.solver.surface.cover import covering_points
from dynsplines.solver.surface.points import Point, body_points
from dynsplines.solver.surface.touch import bolted

from ..errors import UserError, unknown
from .contacts import contacts
from .feet import sole_points
from .holds import holds
from .places import Places
from .table import ContactTable, HoldTable, PenaltyTable

KINDS = (
    "covariant", "root", "unit", "contact", "clearance", "planted", "resting", "hold", "skate", "grounded", "posture",
    "bend",     "range", "coupled", "closed", "self", "placement", "upright", "flight", "support", "peak", "torque",
    "cycle",
)  # fmt: skip
DEFAULT_WEIGHTS = {
    "covariant": 1.0,
    "root": 1.0,
    "unit": 1.0,
    "contact": 30.0,
    "clearance": 30.0,
    "planted": 0.3,
    "resting": 750.0,
    "hold": 750.0,
    "skate": 1.4,
    "grounded": 0.3,
    "posture": 0.7,
    "bend": 1.0,
    "range": 1.0,
    "coupled": 300.0,
    "closed": 300.0,
    "placement": 30.0,
    "upright": 1.0,
    "flight": 3.0,
    "support": 0.01,
    "peak": 0.01,
    "cycle": 0.1,
}
CARRIED = ("flight", "support", "peak")  # on by default where keyframes tell what carries the figure
ROOT_WEIGHT_CARRIED = 0.45  # of "root", which flight and support then know better
KNEES, ELBOWS = ("knee", "shin"), ("elbow", "forearm", "farm")
BEND_BOUND = 8.0  # degrees; 10° with room for a soft constraint
OPTIONS = {
    "covariant": {"form"},
    "unit": {"form"},
    "contact": {"points", "margin"},
    "clearance": {"margin"},
    "skate": {"reach"},
    "grounded": {"reach"},
    "self": {"margin"},
    "bend": {"joints", "least", "sideways", "twist"},
    "flight": {"intervals", "angular"},
    "support": {"friction"},
    "cycle": {"period"},
}
RAW_UNIT = 0.1  # of the raw spline's squared deviations from unit length, summed over joints, that are believed
DEEP = 0.02  # [m] of a sole point in something, by a keyframe, from which on the user is told


def numbers(entries: Sequence[PenaltyTable], place: str) -> dict[str, int]:
    """The number of every kind's table; raises UserError for kinds and options that are not there, or given twice."""
    seen: dict[str, int] = {}
    for i, entry in enumerate(entries, 1):
        here = f"{place}: penalty {i}"
        if entry.kind not in KINDS:
            raise UserError(f"{here}: {unknown('penalty', entry.kind, KINDS)}")
        if entry.kind in seen:
            raise UserError(f"{here}: kind '{entry.kind}' is given already by penalty {seen[entry.kind]}")
        for option in sorted(entry.model_fields_set - {"kind", "weight"} - OPTIONS.get(entry.kind, set())):
            takes = ", ".join(["weight", *sorted(OPTIONS.get(entry.kind, ()))])
            raise UserError(f"{here}: '{option}' is not for kind '{entry.kind}', which takes: {takes}")
        seen[entry.kind] = i
    return seen


class Constraints:
    """The table of soft constraints by kind."""

    def __init__(
        self,
        figure: Figure,
        keys: Timeline,
        surfaces: tuple[Surface, ...],
        notes: list[str],
        place: str,
        placed: tuple[Placed, ...] = (),
        tables: Sequence[ContactTable] = (),
        held: Sequence[HoldTable] = (),
    ) -> None:
        self.figure, self.keys, self.surfaces, self.notes, self.place = figure, keys, surfaces, notes, place
        self.placed = placed
        whole = [figure.to_qpos(frame.state) for frame in keys.frames if frame.fixed.all()]
        self.points = sole_points(figure, np.reshape(whole, (-1, figure.width)))
        self.bends = tuple(_bends(figure))
        self.contacts = contacts(figure, keys, tables, place, self.points, surfaces)
        self.holds = holds(figure, keys, held, place, self.points)
        self.carried = carried_links(figure, self.holds)
        self.support: Support | None = None
        self.rhythm: Rhythm | None = None
        if not surfaces:
            notes.append("no static geom found: nothing to stay out of")
        if not self.points and _is_free(figure):
            notes.append("no feet found, nor a site named heel or toe: no contact points")
        if not self.bends and figure.tables.ball_links.size:
            notes.append("no knee, shin, elbow or forearm on a ball joint found: no limits on bending")

    def all(self, entries: list[PenaltyTable]) -> tuple[tuple[Penalty, float], ...]:
        chosen = {kind: PenaltyTable(kind=kind, weight=weight) for kind, weight in DEFAULT_WEIGHTS.items()}
        if not joint_ranges(self.figure):
            del chosen["range"]
        seen = numbers(entries, self.place)
        chosen |= {entry.kind: entry for entry in entries}
        for kind, given in (
            ("placement", self.placed),
            ("upright", self._leans),
            ("resting", self.contacts.given),
            ("hold", self.holds),
            ("coupled", couplings(self.figure)),
            ("closed", closures(self.figure)),
        ):
            if not given:
                chosen.pop(kind, None)
        for kind in self._senseless - seen.keys():
            chosen.pop(kind, None)
        if "contact" in seen and chosen["contact"].points is not None:
            self.points = self._sites(chosen["contact"].points)
        self.support = self._carried(chosen["flight"], "flight" in seen)
        told = self.support is not None and self.support.tells
        for kind in CARRIED:
            if self.support is None and kind in seen and kind != "peak":
                raise UserError(f"{self.place}: penalty '{kind}' needs a figure with a free joint; there is none")
            if kind not in seen and not told:
                del chosen[kind]
        if told and "root" not in seen:
            chosen["root"] = PenaltyTable(kind="root", weight=ROOT_WEIGHT_CARRIED)
        self.rhythm = self._rhythm(chosen["cycle"], "cycle" in seen)
        if self.rhythm is None:
            del chosen["cycle"]
        built = [(self.one(entry), entry.weight) for entry in chosen.values()]
        self._tell_deep([penalty for penalty, _ in built if isinstance(penalty, Contact) and penalty.name == "contact"])
        return tuple((penalty, weight) for penalty, weight in built if weight > 0)

    def _tell_deep(self, found: Sequence[Contact]) -> None:
        """Notes of keyframes that drive a foot into something: the motion goes through them all the same."""
        for contact in found:
            if contact.allowed is None or not contact.allowed.excess.any():
                continue
            states = self.keys.states
            centres, _, _ = contact.centres(Samples(self.figure, states, 0 * states, 0 * states))
            inside = np.max([surface.inside(centres) for surface in contact.surfaces], axis=0)
            deepest = np.where(contact.allowed.excess > 0, inside, 0).max(axis=0)
            worst = int(deepest.argmax())
            if deepest[worst] <= DEEP:
                continue
            point, frame = contact.points[int(inside[:, worst].argmax())], self.keys.frames[worst]
            others = int(np.sum(deepest > DEEP)) - 1
            more = f", as do {others} more keyframe{'s' if others > 1 else ''}" if others else ""
            self.notes.append(
                f"keyframe {worst + 1} (t = {frame.time:g} s) puts {point.name} {1000 * deepest[worst]:.0f} mm deep "
                f"into something solid{more}; keyframes are met exactly, so there it goes"
            )

    @property
    def _senseless(self) -> set[str]:
        """Kinds that have nothing to look at in this figure."""
        tables = self.figure.tables
        soles = set() if self.points else {"contact", "skate"}
        stay = set() if self.points or self._lying else {"planted"}
        afoot = set() if self.points or tables.free_links.size else {"grounded"}
        quaternions = set() if tables.quaternion_links.size else {"unit"}
        return soles | stay | afoot | quaternions | (set() if self.bends else {"bend"})

    def one(self, entry: PenaltyTable) -> Penalty:
        try:
            if entry.kind == "covariant":
                return CovariantAcceleration(entry.form or "intrinsic")
            if entry.kind == "unit":
                return UnitMagnitude(entry.form or "square", most=RAW_UNIT)
        except ValueError as error:
            raise UserError(f"{self.place}: penalty '{entry.kind}': {error}") from None
        if entry.kind == "root":
            return RootAcceleration()
        if entry.kind == "torque":
            return Torque()
        if entry.kind == "range":
            return JointRange(joint_ranges(self.figure)).allowing(self.figure, self.keys)
        if entry.kind == "coupled":
            return Coupled(couplings(self.figure))
        if entry.kind == "closed":
            return Closed(closures(self.figure))
        if entry.kind == "self":
            return SelfContact.of(self.figure, entry.margin or 0.0)
        if entry.kind == "clearance":
            return self._clearance(entry.margin or 0.0)
        if entry.kind == "planted":
            return Planted((*self._found, *self._lying))
        if entry.kind == "hold":
            return Holding(self.holds)
        if entry.kind == "resting":
            parts = Planted(self.contacts.stances), Resting(self.contacts.rests, self.surfaces)
            return Together(parts, name="resting")
        if entry.kind == "skate":
            bound = Bound.of(self.figure, self.keys, self.points, swings=not self._flies)
            return Skate(self.points, self.surfaces, entry.reach or Skate.reach, bound)
        if entry.kind == "grounded":
            return self._grounded(entry.reach or Grounded.reach)
        if entry.kind == "posture":
            return Posture()
        if entry.kind == "placement":
            return Placement(self.placed)
        if entry.kind == "upright":
            return Upright(self._leans)
        if entry.kind == "contact":
            return Contact(self.points, self.surfaces, entry.margin or 0.0).allowing(self.figure, self.keys)
        if entry.kind == "flight" and self.support is not None:
            return Flight.of(self.figure, self.support.root, self.support.flights, entry.angular or 0.0)
        if entry.kind == "support" and self.support is not None:
            return replace(self.support, friction=entry.friction or self.support.friction)
        if entry.kind == "peak":
            return PeakAcceleration()
        if entry.kind == "cycle" and self.rhythm is not None:
            return Cycle(self.figure, self.rhythm)
        return self._bend(entry)

    def _clearance(self, margin: float) -> Penalty:
        """The body's corners out of floors and steps, all of its skin out of whatever is round, thin or in the air."""
        ground = tuple(s for s in self.surfaces if isinstance(s, Plane) or (isinstance(s, Box) and s.buried))
        others = tuple(s for s in self.surfaces if all(s is not g for g in ground))
        clear = self._apart(body_points(self.figure), ground, margin)
        if not others and not self.carried:
            return clear[0] if len(clear) == 1 else Together(clear, name="clearance")
        skin = self._apart(covering_points(self.figure), others, margin) if others else ()
        return Together((*clear, *skin, *self._beside(margin)), name="clearance")

    def _beside(self, margin: float) -> tuple[Contact, ...]:
        """The corners of the figure out of what it carries, which is near its hands all the time: the whole of its
        skin would take ten times as long."""
        own = self._own(body_points(self.figure))
        found = [(link, surfaces_on(self.figure, link)) for link in self.carried]
        return tuple(
            Contact(own, surfaces, margin, name="clearance", carrier=link).allowing(
                self.figure,
                self.keys,
                [(hold.point.link, hold.first, hold.last) for hold in self.holds if hold.link == link],
            )
            for link, surfaces in found
            if surfaces
        )

    def _own(self, points: Sequence[Point]) -> tuple[Point, ...]:
        """The points that are not of what is carried."""
        return tuple(point for point in points if point.link not in self.carried)

    def _apart(self, points: tuple[Point, ...], surfaces: tuple[Surface, ...], margin: float) -> tuple[Contact, ...]:
        """Points out of surfaces, each but those of links that are bolted to it."""
        held = bolted_links(self.figure)
        groups: dict[frozenset[int], list[Surface]] = {}
        for surface in surfaces:
            groups.setdefault(held.get(surface.name, frozenset()), []).append(surface)
        found = [
            Contact(tuple(p for p in points if p.link not in some), tuple(group), margin, name="clearance")
            for some, group in groups.items()
        ] or [Contact(points, surfaces, margin, name="clearance")]
        return tuple(contact.allowing(self.figure, self.keys) for contact in found)

    @property
    def _flies(self) -> bool:
        """Whether there are flights: who runs has feet on the ground for a short while only, between keyframes."""
        return self.support is not None and bool(self.support.flights)

    @property
    def _found(self) -> tuple[Stance, ...]:
        """The stances that keyframes tell, where the clip's contacts do not speak of the same point."""
        found = stances(self.figure, self.keys, self.points, self.surfaces)
        return tuple(stance for stance in found if not self.contacts.overlaps(stance))

    @property
    def _lying(self) -> tuple[Stance, ...]:
        """Where what is carried lies before and after."""
        return lying(self.figure, self.keys, [link for link in self.carried if self.figure.links[link].parent == 0])

    @property
    def _leans(self) -> tuple[Lean, ...]:
        """How the trunk leans where it was posed."""
        roots = [link for link in self.figure.tables.free_links.tolist() if link not in self.carried]
        return leans(self.figure, self.keys, roots)

    def _grounded(self, reach: float) -> Penalty:
        """The lowest point of sole or body stays down between keyframes that are, but for flights."""
        points = self._own((*self.points, *body_points(self.figure)))
        aloft = () if self.support is None else self.support.flights
        intervals = grounded_intervals(self.figure, self.keys, points, self.surfaces, aloft)
        return Grounded(points, self.surfaces, intervals, reach)

    def _carried(self, entry: PenaltyTable, asked: bool) -> Support | None:
        """What carries the figure when: the flights that the clip gives, or what its keyframes tell."""
        figure, keys = self.figure, self.keys
        if not figure.tables.free_links.size:
            return None
        root = next((r for r in figure.tables.free_links if self._stands(int(r))), figure.tables.free_links[0])
        held, body = (*self._found, *self.contacts.stances, *self.contacts.rests), self._own(body_points(figure))
        carriers = footings(figure, keys, self.points, self.surfaces, held, body)
        if entry.intervals is not None:
            aloft = tuple(entry.intervals)
        elif asked and not self.surfaces:
            aloft = ((float(keys.times[0]), float(keys.times[-1])),)
        else:
            aloft = flights(figure, int(root), keys, self.points, self.surfaces, held, body)
        for first, last in aloft:
            if not keys.times[0] <= first < last <= keys.times[-1]:
                given, span = f"[{first:g}, {last:g}]", f"{keys.times[0]:g} to {keys.times[-1]:g} s"
                raise UserError(
                    f"{self.place}: penalty 'flight': {given} is no interval of the clip, which runs from {span}"
                )
        return Support.of(figure, int(root), carriers, aloft)

    def _rhythm(self, entry: PenaltyTable, asked: bool) -> Rhythm | None:
        """The clip's cycle: with the period that it gives, or as its keyframes tell it, beyond doubt unless asked."""
        if entry.weight == 0:
            return None
        gait = Gait(self.figure, self.keys, self.points, self.surfaces)
        if not asked:
            return gait.told()
        found = gait.likeliest() if entry.period is None else gait.given(entry.period)
        if found is None:
            self.notes.append(
                "no cycle: that takes three keyframes that fix every joint, not all alike, and one free joint or none"
            )
        return found

    def _stands(self, root: int) -> bool:
        """Whether sole points are on the tree of a free link."""
        return any(self.figure.tables.path[point.link, root] for point in self.points)

    def _sites(self, names: list[str]) -> tuple[Point, ...]:
        places, found = Places(self.figure, self.points), list[Point]()
        for name in names:
            point = places.point(name)
            if point is None:
                raise UserError(f"{self.place}: penalty 'contact': {unknown('site', name, places.points_listed)}")
            found.append(point)
        return tuple(found)

    def _bend(self, entry: PenaltyTable) -> Penalty:
        if entry.joints is not None:
            known = {bend.name: bend for bend in self.bends}
            for name in entry.joints:
                if name not in known:
                    raise UserError(f"{self.place}: penalty 'bend': {unknown('joint', name, known)}")
            self.bends = tuple(known[name] for name in entry.joints)
        return _limits(self.bends, entry).allowing(self.figure, self.keys)


def _is_free(figure: Figure) -> bool:
    """Whether it may move about on a ground."""
    return bool(figure.tables.free_links.size)


def bolted_links(figure: Figure) -> dict[str, frozenset[int]]:
    """The links that are in a static geom by design, by the geom's name as surfaces have it."""
    found: dict[str, set[int]] = {}
    for body, geom in bolted(figure.model):
        name = geom_name(figure.model, geom)
        found.setdefault(name, set()).add(int(figure.body_link[body]))
    return {name: frozenset(links) for name, links in found.items()}


def posing_bends(figure: Figure, entries: list[PenaltyTable]) -> BendLimits | None:
    """How far knees and elbows may go in a pose: as in the motion, or None where their penalty is taken away."""
    entry = next((entry for entry in entries if entry.kind == "bend"), PenaltyTable(kind="bend"))
    bends = tuple(bend for bend in _bends(figure) if entry.joints is None or bend.name in entry.joints)
    return _limits(bends, entry) if bends and entry.weight > 0 else None


def _limits(bends: tuple[Bend, ...], entry: PenaltyTable) -> BendLimits:
    sideways, twist = entry.sideways or BEND_BOUND, entry.twist or BEND_BOUND
    least, sideways, twist = np.radians([entry.least or 0.0, sideways, twist])
    return BendLimits(bends, float(least), float(sideways), float(twist))


def _bends(figure: Figure) -> list[Bend]:
    """Ball joints that are knees or elbows by their own name or their body's, of a figure that faces x."""
    found = []
    for i, link in enumerate(figure.links[1:], start=1):
        names = f"{link.name} {figure.model.body(link.body).name}".lower()
        lateral = 1.0 if any(w in names for w in KNEES) else -1.0 if any(w in names for w in ELBOWS) else 0.0
        if lateral and link.kind is JointKind.BALL:
            long_axis = link.centre - link.anchor
            down = quat.rotated(link.turn, long_axis)
            down[1] = 0.0
            if np.linalg.norm(down) > 1e-6:
                axis = np.array([0.0, lateral, 0.0])
                found.append(Bend(link.name, i, axis, _principal(down)))
    return found


def _principal(direction: Array) -> Array:
    """The coordinate axis nearest to a direction: limbs hang along one at rest."""
    axis = np.zeros(3)
    axis[np.argmax(np.abs(direction))] = np.sign(direction[np.argmax(np.abs(direction))])
    return axis
