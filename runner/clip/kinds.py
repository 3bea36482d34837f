"""The soft constraints that clips know, a record each: its weight, its options, what it keeps small, how it is made.

A new one is a class in the solver and a record here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from dynsplines.solver.figure.figure import Figure, JointKind
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
    Level,
    PeakAcceleration,
    Penalty,
    Placement,
    Planted,
    Posture,
    Range,
    Resting,
    RootAcceleration,
    SelfContact,
    Skate,
    Speed,
    Steady,
    Sum,
    Support,
    Torque,
    UnitMagnitude,
    Upright,
    closures,
    couplings,
    grounded_intervals,
    joint_ranges,
    open_intervals,
    steady,
    surfaces_on,
)
from dynsplines.solver.penalty.ground.grounded import CLOSE
from dynsplines.solver.surface import Box, Plane, Surface
from dynsplines.solver.surface.cover import covering_points
from dynsplines.solver.surface.points import Point, body_points, hanging
from dynsplines.solver.surface.touch import bolted

from ..errors import UserError, unknown
from .context import Context
from .holds import moving_bodies
from .table import Angle, Number, Real, Table

HARD, HARD_TRAVEL = float(np.radians(0.05)), 5e-5  # [rad, m] that a keyframe may be beyond a hard range
BEND_BOUND = 8.0  # degrees; 10° with room for a soft constraint
RAW_UNIT = 0.1  # of the raw spline's squared deviations from unit length, summed over joints, that are believed


class Options(Table):
    """The options of a [[penalty]] table besides its kind; None: the default of the kind."""

    weight: Annotated[Real, Field(ge=0, le=1e9)] = 1.0


class CovariantOptions(Options):
    """Which of two readings of the covariant acceleration: the intrinsic one, or eq. 25 as it stands."""

    form: str | None = Field(default=None, description="'intrinsic' or 'paper'")


class UnitOptions(Options):
    """Which measure of how far a quaternion's length is from one."""

    form: str | None = Field(default=None, description="'square' or 'absolute'")


class Margin(Options):
    """How far off points are kept."""

    margin: Annotated[Real, Field(ge=0, le=0.1)] | None = Field(default=None, description="m")


class SoleMargin(Margin):
    """How far off the soles are kept, and which points they are."""

    points: list[str] | None = Field(default=None, description="sites")


class Reach(Options):
    """How high above a surface a point still counts."""

    reach: Annotated[Real, Field(gt=0, le=1)] | None = Field(default=None, description="m")


class BendOptions(Options):
    """Which limbs, and how far they may go."""

    joints: list[str] | None = Field(default=None, description="joints")
    least: Annotated[Real, Field(ge=-360, le=360)] | None = Field(default=None, description="degrees")
    sideways: Angle | None = Field(default=None, description="degrees")
    twist: Angle | None = Field(default=None, description="degrees")


class RangeOptions(Options):
    """Whether the path may go beyond the ranges a little."""

    limit: Literal["soft", "hard"] | None = Field(default=None, description="'soft' or 'hard'")


class FlightOptions(Options):
    """When the figure flies, and how much its moment counts."""

    intervals: list[tuple[Number, Number]] | None = Field(default=None, description="[from, to] in s")
    angular: Annotated[Real, Field(ge=0, le=1e6)] | None = Field(
        default=None, description="of the moment beside the force"
    )


class SupportOptions(Options):
    """How slippery the ground is."""

    friction: Annotated[Real, Field(gt=0, le=10)] | None = Field(default=None, description="coefficient")


class CycleOptions(Options):
    """How long a cycle lasts."""

    period: Annotated[Real, Field(gt=0, le=60)] | None = Field(default=None, description="s")


class SpeedOptions(Options):
    """How fast joints may turn."""

    limit: Annotated[Real, Field(gt=0, le=100_000)] | None = Field(default=None, description="degrees/s")


class LevelOptions(Options):
    """Which bodies, and what in them is up."""

    bodies: list[str] = Field(default=[], description="bodies")
    axis: tuple[Number, Number, Number] | None = Field(
        default=None, description="in the body's axes, else what is up at rest"
    )


@dataclass(frozen=True)
class Kind:
    """A soft constraint as clips have it.

    weight   default; None: absent unless a clip lists it
    says     what it keeps small
    make     of what a clip tells and its options; None where there is nothing to look at
    options  of a table, with units
    """

    name: str
    weight: float | None
    says: str
    make: Callable[[Context, Any], Penalty | None]
    options: type[Options] = Options

    def choices(self) -> dict[str, str]:
        """The options besides the weight, and what each is given in."""
        return {name: field.description or "" for name, field in self.options.model_fields.items() if name != "weight"}


def _some(make: Callable[[Any], Penalty], given: Sequence[Any]) -> Penalty | None:
    return make(given) if given else None


def _contact(context: Context, chosen: SoleMargin) -> Penalty | None:
    made = Contact(context.points, context.surfaces, chosen.margin or 0.0)
    return made.allowing(context.figure, context.keys) if context.points else None


def _bend(context: Context, chosen: BendOptions) -> Penalty | None:
    return limits(context.bends, chosen).allowing(context.figure, context.keys) if context.bends else None


def limits(bends: tuple[Bend, ...], chosen: BendOptions) -> BendLimits:
    """How far knees and elbows may go."""
    sideways, twist = chosen.sideways or BEND_BOUND, chosen.twist or BEND_BOUND
    least, sideways, twist = np.radians([chosen.least or 0.0, sideways, twist])
    return BendLimits(bends, float(least), float(sideways), float(twist))


def _clearance(context: Context, chosen: Margin) -> Penalty:
    """The body's corners out of floors and steps, all of its skin out of whatever is round, thin or in the air."""
    figure, margin = context.figure, chosen.margin or 0.0
    ground = tuple(s for s in context.surfaces if isinstance(s, Plane) or (isinstance(s, Box) and s.buried))
    others = tuple(s for s in context.surfaces if all(s is not g for g in ground))
    clear = _apart(context, body_points(figure), ground, margin)
    if not others and not context.carried:
        return clear[0] if len(clear) == 1 else Sum(clear, called="clearance")
    skin = _apart(context, covering_points(figure), others, margin) if others else ()
    return Sum((*clear, *skin, *_beside(context, margin)), called="clearance")


def _beside(context: Context, margin: float) -> tuple[Contact, ...]:
    """The corners of the figure out of what it carries, which is near its hands all the time: the whole of its skin
    would take ten times as long."""
    own = context.own(body_points(context.figure))
    found = [(link, surfaces_on(context.figure, link)) for link in context.carried]
    return tuple(
        Contact(own, surfaces, margin, called="clearance", carrier=link).allowing(
            context.figure,
            context.keys,
            [(hold.point.link, hold.first, hold.last) for hold in context.holds if hold.link == link],
        )
        for link, surfaces in found
        if surfaces
    )


def _apart(
    context: Context, points: tuple[Point, ...], surfaces: tuple[Surface, ...], margin: float
) -> tuple[Contact, ...]:
    """Points out of surfaces, each but those of links that are bolted to it."""
    held = bolted_links(context.figure)
    groups: dict[frozenset[int], list[Surface]] = {}
    for surface in surfaces:
        groups.setdefault(held.get(surface.name, frozenset()), []).append(surface)
    found = [
        Contact(tuple(p for p in points if p.link not in some), tuple(group), margin, called="clearance")
        for some, group in groups.items()
    ] or [Contact(points, surfaces, margin, called="clearance")]
    return tuple(contact.allowing(context.figure, context.keys) for contact in found)


def bolted_links(figure: Figure) -> dict[str, frozenset[int]]:
    """The links that are in a static geom by design, by the geom's name as surfaces have it."""
    found: dict[str, set[int]] = {}
    for body, geom in bolted(figure.model):
        name = geom_name(figure.model, geom)
        found.setdefault(name, set()).add(int(figure.body_link[body]))
    return {name: frozenset(links) for name, links in found.items()}


def _planted(context: Context, chosen: Options) -> Penalty | None:
    stances = (*context.stances, *context.lying)
    return Planted(stances) if context.points or context.lying else None


def _resting(context: Context, chosen: Options) -> Penalty | None:
    given = context.contacts
    parts = Planted(given.stances), Resting(given.rests, context.surfaces)
    return Sum(parts, called="resting") if given.given else None


def _skate(context: Context, chosen: Reach) -> Penalty | None:
    if not context.points:
        return None
    bound = Bound.of(context.figure, context.keys, context.points, swings=not context.flies)
    return Skate(context.points, context.surfaces, chosen.reach or Skate.reach, bound)


def _grounded(context: Context, chosen: Reach) -> Penalty | None:
    """The lowest point of sole or body stays down between keyframes that are, but for flights."""
    if not context.points and not context.figure.tables.free_links.size:
        return None
    points, support = context.own((*context.points, *body_points(context.figure))), context.support
    if support is not None:  # which is what else moves freely
        points = hanging(context.figure, support.root, points)
    aloft = () if support is None else support.flights
    figure, keys, surfaces = context.figure, context.keys, context.surfaces
    firm = open_intervals(figure, support.root, keys, points, surfaces, aloft) if support and context.points else ()
    rest = tuple(one for one in grounded_intervals(figure, keys, points, surfaces, aloft) if one not in firm)
    blend = CLOSE if firm else Grounded.blend
    return Grounded(points, surfaces, rest, chosen.reach or Grounded.reach, blend, firm)


def _equality(context: Context, chosen: Options) -> Penalty | None:
    """Closed loops [m²], and joints that follow others [rad² or m²]: a degree off counts like 17 mm."""
    parts = _some(Closed, closures(context.figure)), _some(Coupled, couplings(context.figure))
    return _some(lambda given: Sum(tuple(given), called="equality"), [part for part in parts if part is not None])


def _flight(context: Context, chosen: FlightOptions) -> Penalty:
    support = _supported(context, "flight")
    return Flight.of(context.figure, support.root, support.flights, chosen.angular or 0.0)


def _support(context: Context, chosen: SupportOptions) -> Penalty:
    support = _supported(context, "support")
    return replace(support, friction=chosen.friction or support.friction)


def _supported(context: Context, kind: str) -> Support:
    if context.support is None:
        raise UserError(f"{context.where}: penalty '{kind}' needs a figure with a free joint; there is none")
    return context.support


def _range(context: Context, chosen: RangeOptions) -> Penalty | None:
    figure, joints = context.figure, joint_ranges(context.figure)
    if chosen.limit != "hard":
        return JointRange(joints).allowing(figure, context.keys) if joints else None
    where = f"{context.where}: penalty 'range': limit = 'hard'"
    if not joints:
        raise UserError(f"{where}: no joint of the figure has a range")
    if not chosen.weight:
        raise UserError(f"{where}: it needs a weight over 0; leave weight out")
    _check_keyframes(context, joints)
    inner = tuple(replace(joint, low=joint.low + _inside(joint), high=joint.high - _inside(joint)) for joint in joints)
    return replace(JointRange(inner).allowing(figure, context.keys), hard=joints)


def _inside(joint: Range) -> float:
    """[rad, m] how far inside a hard range the search stays, so that little is left to move back."""
    return min(0.005 if joint.kind is JointKind.SLIDE else np.radians(0.5), 0.05 * (joint.high - joint.low))


def _check_keyframes(context: Context, joints: Sequence[Range]) -> None:
    """Raises UserError for a keyframe that is beyond a hard range."""
    allowed = JointRange(tuple(joints)).allowing(context.figure, context.keys).allowed
    assert allowed is not None, "of some joints"
    for joint, excess in zip(joints, allowed.excess.max(axis=0), strict=True):
        k, slides = int(excess.argmax()), joint.kind is JointKind.SLIDE
        if excess[k] > (HARD_TRAVEL if slides else HARD):
            over, low, high = (float(x if slides else np.degrees(x)) for x in (excess[k], joint.low, joint.high))
            unit = "m" if slides else "degrees"
            raise UserError(
                f"{context.where}: keyframe {k + 1} (t = {context.keys.times[k]:g} s): '{joint.name}' is {over:.3g} "
                f"{unit} beyond its range, {low:g} to {high:g} {unit}, which penalty 'range' makes hard; move it inside"
            )


def steady_joints(context: Context) -> tuple[Range, ...]:
    """The joints that keyframes hold and that the spline through them would swing."""
    aloft = () if context.support is None else context.support.flights
    repeats = context.keys.ends == "periodic" or context.rhythm is not None
    return steady(context.figure, context.keys, repeats=repeats, aloft=aloft)


def _steady(context: Context, chosen: Options) -> Penalty | None:
    return _some(lambda held: Steady.of(context.figure, held, context.keys.times), steady_joints(context))


def _speed(context: Context, chosen: SpeedOptions) -> Penalty | None:
    if chosen.limit is None:
        raise UserError(f"{context.where}: penalty 'speed' needs a limit = ..., in degrees a second")
    made = Speed.of(context.figure, float(np.radians(chosen.limit)))
    return made if made.links.size else None


def _level(context: Context, chosen: LevelOptions) -> Penalty | None:
    if not chosen.bodies:
        raise UserError(f"{context.where}: penalty 'level' needs bodies = [...], the ones that are to be level")
    known, found = moving_bodies(context.figure), list[int]()
    for name in chosen.bodies:
        if name not in known:
            raise UserError(f"{context.where}: penalty 'level': {unknown('body', name, known)}")
        found.append(known[name])
    return _some(lambda bodies: Level.of(context.figure, bodies, chosen.axis), found)


RENAMED = {"coupled": "equality", "closed": "equality"}  # what older clip files call them, and what it is called now
KINDS = {
    kind.name: kind
    for kind in (
        Kind(
            "covariant", 1.0, "angular acceleration of every body (of every joint in joint coordinates)",
            lambda context, chosen: CovariantAcceleration(chosen.form or "intrinsic"), CovariantOptions,
        ),
        Kind("root", 1.0, "acceleration of the root and of slides", lambda context, chosen: RootAcceleration()),
        Kind(
            "unit", 1.0, "deviation of quaternions from unit length",
            lambda context, chosen: UnitMagnitude(chosen.form or "square", most=RAW_UNIT)
            if context.figure.tables.quaternion_links.size else None, UnitOptions,
        ),
        Kind("contact", 30.0, "depth of heels and toes, or points, in any static geom", _contact, SoleMargin),
        Kind(
            "clearance", 30.0, "depth of every geom of the figure in what it may run into, and in what it carries",
            _clearance, Margin,
        ),
        Kind("planted", 0.3, "movement of soles that neighbouring keyframes put on one spot", _planted),
        Kind("resting", 750.0, "movement of the points of [[contact]]s while they rest", _resting),
        Kind(
            "hold", 750.0, "movement of the sites of [[hold]]s on what they hold",
            lambda context, chosen: _some(Holding, context.holds),
        ),
        Kind("skate", 1.4, "speed of heels and toes near a surface", _skate, Reach),
        Kind("grounded", 0.3, "height of the lowest point between keyframes that touch the ground", _grounded, Reach),
        Kind("posture", 0.7, "angular velocity of joints beside their acceleration", lambda context, chosen: Posture()),
        Kind("bend", 1.0, "knees and elbows bent backward, sideways or twisted", _bend, BendOptions),
        Kind(
            "range", 1.0, "angle or displacement beyond the model's joint ranges",
            _range, RangeOptions,
        ),
        Kind("steady", 10.0, "motion of joints between neighbouring keyframes that give them the same value", _steady),
        Kind("equality", 300.0, "points and joints off what <equality> holds together or makes follow", _equality),
        Kind(
            "placement", 30.0, 'distance of sites with by = "search" from their places',
            lambda context, chosen: _some(Placement, context.placed),
        ),
        Kind(
            "upright", 1.0, "lean of a trunk away from how it was posed",
            lambda context, chosen: _some(Upright, context.leans),
        ),
        Kind("flight", 3.0, "force on the figure in flight", _flight, FlightOptions),
        Kind("support", 0.01, "force and moment that feet in contact cannot supply", _support, SupportOptions),
        Kind(
            "peak", 0.01, "eighth power of joints' angular acceleration",
            lambda context, chosen: PeakAcceleration(),
        ),
        Kind(
            "cycle", 0.1, "joints off the walking or running cycle that the keyframes tell",
            lambda context, chosen: None if context.rhythm is None else Cycle(context.figure, context.rhythm),
            CycleOptions,
        ),
        Kind(
            "self", None, "depth of limbs in the trunk and in each other",
            lambda context, chosen: SelfContact.of(context.figure, chosen.margin or 0.0), Margin,
        ),
        Kind(
            "torque",
            None,
            "joint torques by inverse dynamics: inertia, gravity, armature; no passive or contact forces",
            lambda context, chosen: Torque(),
        ),
        Kind("speed", None, "speed of hinges and ball joints beyond a limit", _speed, SpeedOptions),
        Kind("level", None, "lean of bodies, a trunk or a tray, from the vertical", _level, LevelOptions),
    )
}  # fmt: skip
