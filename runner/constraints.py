"""A clip's soft constraints by kind: defaults, what its [[penalty]] tables change, what a figure's names tell."""

from __future__ import annotations

import numpy as np

from solver import quaternion as quat
from solver.figure import Figure, JointKind
from solver.frame import Timeline
from solver.penalty import (
    Bend,
    BendLimits,
    Contact,
    CovariantAcceleration,
    JointRange,
    Penalty,
    Placed,
    Placement,
    Planted,
    Point,
    RootAcceleration,
    SelfContact,
    Together,
    Torque,
    UnitMagnitude,
    body_points,
    covering_points,
    joint_ranges,
    site_points,
    stances,
)
from solver.quaternion import Array
from solver.surface import Box, Plane, Surface

from .clip_table import PenaltyTable
from .errors import UserError, unknown

KINDS = (
    "covariant", "root", "unit", "contact", "clearance", "planted", "bend", "range", "self", "placement", "torque",
)  # fmt: skip
DEFAULT_WEIGHTS = {
    "covariant": 1.0,
    "root": 1.0,
    "unit": 1.0,
    "contact": 30.0,
    "clearance": 30.0,
    "planted": 0.1,
    "bend": 1.0,
    "range": 1.0,
    "placement": 30.0,
}
KNEES, ELBOWS = ("knee", "shin"), ("elbow", "forearm", "farm")
SOLES = ("heel", "toe")
BEND_BOUND = 8.0  # degrees; 10° with room for a soft constraint
OPTIONS = {
    "covariant": {"form"},
    "unit": {"form"},
    "contact": {"points", "margin"},
    "clearance": {"margin"},
    "self": {"margin"},
    "bend": {"joints", "least", "sideways", "twist"},
}


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
    ) -> None:
        self.figure, self.keys, self.surfaces, self.notes, self.place = figure, keys, surfaces, notes, place
        self.placed = placed
        model = figure.model
        self.sites = [model.site(i).name for i in range(model.nsite)]
        self.points = site_points(figure, [s for s in self.sites if any(word in s.lower() for word in SOLES)])
        self.bends = tuple(_bends(figure))
        if not surfaces:
            notes.append("no static geom found: nothing to stay out of")
        if not self.points:
            notes.append("no site named heel or toe found: no contact points")
        if not self.bends:
            notes.append("no knee, shin, elbow or forearm on a ball joint found: no limits on bending")

    def all(self, entries: list[PenaltyTable]) -> tuple[tuple[Penalty, float], ...]:
        chosen = {kind: PenaltyTable(kind=kind, weight=weight) for kind, weight in DEFAULT_WEIGHTS.items()}
        if not joint_ranges(self.figure):
            del chosen["range"]
        seen: dict[str, int] = {}
        for i, entry in enumerate(entries, 1):
            place = f"{self.place}: penalty {i}"
            if entry.kind not in KINDS:
                raise UserError(f"{place}: {unknown('penalty', entry.kind, KINDS)}")
            if entry.kind in seen:
                raise UserError(f"{place}: kind '{entry.kind}' is given already by penalty {seen[entry.kind]}")
            for option in sorted(entry.model_fields_set - {"kind", "weight"} - OPTIONS.get(entry.kind, set())):
                takes = ", ".join(["weight", *sorted(OPTIONS.get(entry.kind, ()))])
                raise UserError(f"{place}: '{option}' is not for kind '{entry.kind}', which takes: {takes}")
            seen[entry.kind] = i
            chosen[entry.kind] = entry
        if not self.placed:
            del chosen["placement"]
        built = [(self.one(entry), entry.weight) for entry in chosen.values()]
        return tuple((penalty, weight) for penalty, weight in built if weight > 0)

    def one(self, entry: PenaltyTable) -> Penalty:
        try:
            if entry.kind == "covariant":
                return CovariantAcceleration(entry.form or "intrinsic")
            if entry.kind == "unit":
                return UnitMagnitude(entry.form or "square")
        except ValueError as error:
            raise UserError(f"{self.place}: penalty '{entry.kind}': {error}") from None
        if entry.kind == "root":
            return RootAcceleration()
        if entry.kind == "torque":
            return Torque()
        if entry.kind == "range":
            return JointRange(joint_ranges(self.figure))
        if entry.kind == "self":
            return SelfContact.of(self.figure, entry.margin or 0.0)
        if entry.kind == "clearance":
            return self._clearance(entry.margin or 0.0)
        if entry.kind == "planted":
            return Planted(stances(self.figure, self.keys, self.points, self.surfaces))
        if entry.kind == "placement":
            return Placement(self.placed)
        if entry.kind == "contact":
            if entry.points is not None:
                self.points = self._sites(entry.points)
            return Contact(self.points, self.surfaces, entry.margin or 0.0)
        return self._bend(entry)

    def _clearance(self, margin: float) -> Penalty:
        """The body's corners out of floors and steps, all of its skin out of whatever is round, thin or in the air."""
        ground = tuple(s for s in self.surfaces if isinstance(s, Plane) or (isinstance(s, Box) and s.buried))
        others = tuple(s for s in self.surfaces if all(s is not g for g in ground))
        clear = Contact(body_points(self.figure), ground, margin, name="clearance")
        if not others:
            return clear
        return Together((clear, Contact(covering_points(self.figure), others, margin)), name="clearance")

    def _sites(self, names: list[str]) -> tuple[Point, ...]:
        for name in names:
            if name not in self.sites:
                raise UserError(f"{self.place}: penalty 'contact': {unknown('site', name, self.sites)}")
        return site_points(self.figure, names)

    def _bend(self, entry: PenaltyTable) -> Penalty:
        if entry.joints is not None:
            known = {bend.name: bend for bend in self.bends}
            for name in entry.joints:
                if name not in known:
                    raise UserError(f"{self.place}: penalty 'bend': {unknown('joint', name, known)}")
            self.bends = tuple(known[name] for name in entry.joints)
        return _limits(self.bends, entry)


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
