"""The kinds of soft constraint in clip files. Each has a record with its parts, their weights, and its options.

A new kind is a class in the solver and a record here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any

import numpy as np
from pydantic import Discriminator, Field, Tag

from dynsplines import models
from dynsplines.solver.contacts import surfaces_on
from dynsplines.solver.contacts.stances import low_swing_segments
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import geom_name
from dynsplines.solver.penalty import (
    Attachment,
    Bend,
    BendLimits,
    Between,
    Collision,
    CouplingPenalty,
    CovariantAcceleration,
    Cycle,
    Flight,
    HoverPenalty,
    JointRange,
    PeakAcceleration,
    Penalty,
    Posture,
    Prior,
    Range,
    RootAcceleration,
    SelfContact,
    Skate,
    Speed,
    Sum,
    Support,
    Torque,
    UnitMagnitude,
    Upright,
    closures,
    couplings,
    joint_ranges,
    overshoot,
)
from dynsplines.solver.surface import Box, Plane, Surface
from dynsplines.solver.surface.cover import covering_points, wide_points
from dynsplines.solver.surface.points import Point, body_points
from dynsplines.solver.surface.touch import overlapping_pairs

from ..errors import UserError, unknown
from .contacts import moving_bodies
from .context import Context, knees_and_elbows
from .table import Angle, Flag, Names, Number, Real, Table

BEND_BOUND = 8.0  # [degrees] default bound; the soft constraint then rarely exceeds 10°
RAW_UNIT = 0.1  # [1] `most` of `UnitMagnitude`: limit of the raw spline's mean squared deviation, all joints together
INSIDE = 0.015  # [rad, m] margin inside a joint's range while tracking
BODY = "collision.body"  # name of the term of the body's contacts with surfaces


Weight = Annotated[Real, Field(ge=0, le=1e9)]


class Options(Table):
    """The options of [[penalty]] tables besides their kind, each for the kinds that list it; None means the default.

    Attributes:
        weight: The weight of the first part, which scales the other parts in proportion; or a table of the parts'
            weights.
    """

    weight: (
        Annotated[
            Annotated[Weight, Tag("number")] | Annotated[dict[str, Weight], Tag("table")],
            Discriminator(lambda value: "table" if isinstance(value, dict) else "number"),
        ]
        | None
    ) = None
    margin: Annotated[Real, Field(ge=0, le=0.1)] | None = Field(
        default=None, description="distance to keep, m; for the parts body and self; default 0"
    )
    points: Names | None = Field(default=None, description="sites instead of heels and toes")
    self: Flag = Field(default=True, description="true or false; default true")
    reach: Annotated[Real, Field(gt=0, le=1)] | None = Field(
        default=None, description="height scale, m; default 0.033, for grounded 0.3"
    )
    bend_joints: Names | None = Field(default=None, description="knees and elbows to limit; default: all")
    least_bend: Annotated[Real, Field(ge=-360, le=360)] | None = Field(
        default=None, description="smallest angle, degrees; default 0"
    )
    sideways: Angle | None = Field(default=None, description="largest angle, degrees; default 8")
    twist: Angle | None = Field(default=None, description="largest angle, degrees; default 8")
    speed: Annotated[Real, Field(gt=0, le=100_000)] | None = Field(default=None, description="degrees/s")
    bodies: Names | None = Field(default=None, description="bodies to keep upright")
    axis: Annotated[tuple[Number, Number, Number] | None, "[x, y, z] in the body's own axes"] = Field(
        default=None, description="their upward axis; default: upward at rest"
    )
    intervals: Annotated[list[tuple[Number, Number]] | None, "a list of [from, to] in seconds"] = Field(
        default=None, description="flights, [from, to] in s; default: inferred"
    )
    angular: Annotated[Real, Field(ge=0, le=1e6)] | None = Field(
        default=None, description="weight of the moment relative to the force; default 0"
    )
    friction: Annotated[Real, Field(gt=0, le=10)] | None = Field(default=None, description="coefficient; default 0.8")
    period: Annotated[Real, Field(gt=0, le=60)] | None = Field(
        default=None, description="duration of a cycle, s; default: inferred"
    )


@dataclass(frozen=True)
class Part:
    """A term of E that a kind of soft constraint adds.

    Attributes:
        weight: The default α in E.
        quantity: What it penalises.
        violations: The kinds of violation that measure it in a motion, keys of `dynsplines.measure.bounds.BOUNDS`.
        build: Returns the penalty for a clip's context and the options of its table; None if it does not apply.
        name: The key in a table of weights; the term is KIND.NAME. Empty for the only part of a kind.
        option: The option that switches it on or off; None: always on.
        tracking: The weight while a motion follows a recording; None: the part is then off. These terms are not divided
            by their values on the raw spline, because the recording defines the scale: differences from it form a
            chi-squared sum, 1 per standard deviation.
    """

    weight: float
    quantity: str
    violations: tuple[str, ...]
    build: Callable[[Context, Any], Penalty | None]
    name: str = ""
    option: str | None = None
    tracking: float | None = None

    @property
    def is_default(self) -> bool:
        """Whether it is on without its option."""
        return self.option is None or bool(getattr(Options(), self.option))


@dataclass(frozen=True)
class Kind:
    """A kind of soft constraint in clip files.

    Attributes:
        parts: The terms of E.
        options: The options that it takes besides the weight.
        is_default: Whether it is on in clips that do not list it.
    """

    name: str
    parts: tuple[Part, ...]
    options: tuple[str, ...] = ()
    is_default: bool = True

    def choices(self) -> dict[str, str]:
        """Return the options besides the weight, with their units or values."""
        return {name: Options.model_fields[name].description or "" for name in self.options}

    def describe(self) -> dict[str, Any]:
        """Return the parts and options as rows of a table."""
        parts = [
            {
                "part": part.name,
                "term": self.term(part),
                "weight": part.weight,
                "quantity": part.quantity,
                "is on": self.is_default and part.is_default,
                "violations": list(part.violations),
            }
            for part in self.parts
        ]
        return {"kind": self.name, "parts": parts, "options": self.choices()}

    def term(self, part: Part) -> str:
        """Return the name of a part in E."""
        return f"{self.name}.{part.name}" if part.name else self.name

    def terms(self, context: Context, options: Options) -> Iterator[tuple[Penalty, float]]:
        """Yield the soft constraints that apply, with their weights.

        Raises:
            UserError: For options that do not fit the figure.
        """
        weights = self.tracking_weights(options) if context.is_tracking else self.weights(options)
        for part in [part for part in self.parts if part.name in weights]:
            try:
                penalty = part.build(context, options)
            except UserError:
                raise
            except ValueError as error:
                raise UserError(f"{context.where}: penalty '{self.name}': {error}") from None
            if penalty is not None:
                yield penalty, weights[part.name]

    def factors(self, options: Options) -> dict[str, float]:
        """Return the factors of the weights of parts, by name, that options specify for following a recording."""
        weight = options.weight
        every = {part.name: weight.get(part.name) if isinstance(weight, dict) else weight for part in self.parts}
        return {name: factor for name, factor in every.items() if factor is not None}

    def tracking_weights(self, options: Options) -> dict[str, float]:
        """Return the weights of the parts that are on while tracking: those with an option only if it is specified."""
        factors, specified = self.factors(options), options.model_fields_set
        on = [p for p in self.parts if p.option is None or (p.option in specified and getattr(options, p.option))]
        return {p.name: p.tracking * factors.get(p.name, 1.0) for p in on if p.tracking is not None}

    def weights(self, options: Options) -> dict[str, float]:
        """Return the weights of the parts that are on, by name."""
        weight, first = options.weight, self.parts[0].weight
        on = [part for part in self.parts if part.option is None or getattr(options, part.option)]
        if isinstance(weight, dict):
            return {part.name: weight.get(part.name, part.weight) for part in on}
        return {part.name: part.weight if weight is None else weight * (part.weight / first) for part in on}


def _soles(context: Context, options: Options) -> Penalty | None:
    contact = Collision(context.points, context.surfaces)
    return contact.allowing(context.figure, context.keys) if context.points else None


def _bend(context: Context, options: Options) -> Penalty | None:
    if not context.bends:
        return None
    if context.is_tracking:
        return BendLimits(context.bends).extend(Samples.still(context.figure, context.keys.states))
    return bend_limits(context.bends, options).allowing(context.figure, context.keys)


def bend_limits(bends: tuple[Bend, ...], options: Options) -> BendLimits:
    """Return the limits of knees and elbows."""
    sideways, twist = options.sideways or BEND_BOUND, options.twist or BEND_BOUND
    least, sideways, twist = np.radians([options.least_bend or 0.0, sideways, twist])
    return BendLimits(bends, float(least), float(sideways), float(twist))


def _body(context: Context, options: Options) -> Penalty:
    margin = options.margin or 0.0
    if context.is_tracking:  # the corners alone, which a recording keeps near its path
        return Collision(context.body_above_soles, context.surfaces, name=BODY)
    parts = *body_contacts(context, margin), *_grasped_object_contacts(context, margin)
    return parts[0] if len(parts) == 1 else Sum(parts, name=BODY)


def body_contacts(context: Context, margin: float = 0.0) -> tuple[Collision, ...]:
    """Return the contacts of the body with surfaces.

    On floors these are its corners. On steps they are its corners, and spheres in geoms into which an edge may enter
    between them. Elsewhere they are spheres that fill the body.
    """
    figure = context.figure
    steps = tuple(s for s in context.surfaces if isinstance(s, Box) and s.buried)
    ground = tuple(s for s in context.surfaces if isinstance(s, Plane) or any(s is step for step in steps))
    others = tuple(s for s in context.surfaces if all(s is not g for g in ground))
    contacts = _contacts(context, body_points(figure), ground, margin)
    for points, surfaces in ((wide_points, steps), (covering_points, others)):
        if surfaces and points(figure):
            contacts += _contacts(context, points(figure), surfaces, margin)
    return contacts


def _grasped_object_contacts(context: Context, margin: float) -> tuple[Collision, ...]:
    """Return the contacts of the figure's corners with the objects that it grasps. Spheres that fill the figure would
    take ten times as long, because these objects are always near its hands."""
    points = context.schedule.exclude_grasped(body_points(context.figure))
    objects = [(link, surfaces_on(context.figure, link)) for link in context.schedule.grasped]
    return tuple(
        Collision(points, surfaces, margin, name=BODY, carrier=link).allowing(
            context.figure,
            context.keys,
            [(grasp.point.link, grasp.first, grasp.last) for grasp in context.schedule.grasps if grasp.on == link],
        )
        for link, surfaces in objects
        if surfaces
    )


def _contacts(
    context: Context, points: tuple[Point, ...], surfaces: tuple[Surface, ...], margin: float
) -> tuple[Collision, ...]:
    """Return contacts of points with surfaces, except those of links that overlap a surface by design."""
    links = bolted_links(context.figure)
    groups: dict[frozenset[int], list[Surface]] = {}
    for surface in surfaces:
        groups.setdefault(links.get(surface.name, frozenset()), []).append(surface)
    contacts = [
        Collision(tuple(p for p in points if p.link not in bolted_here), tuple(group), margin, name=BODY)
        for bolted_here, group in groups.items()
    ] or [Collision(points, surfaces, margin, name=BODY)]
    return tuple(contact.allowing(context.figure, context.keys) for contact in contacts)


def bolted_links(figure: Figure) -> dict[str, frozenset[int]]:
    """Return the links that overlap a static geom by design, by the name of its surface."""
    links: dict[str, set[int]] = {}
    for body, geom in overlapping_pairs(figure.model):
        links.setdefault(geom_name(figure.model, geom), set()).add(int(figure.body_link[body]))
    return {name: frozenset(numbers) for name, numbers in links.items()}


def _self(context: Context, options: Options) -> Penalty | None:
    contact = SelfContact.of(context.figure, options.margin or 0.0)
    return contact.allowing(context.figure, context.keys) if contact.pairs.size else None


def _stance(context: Context, options: Options) -> Penalty | None:
    schedule = context.schedule
    stances = (*schedule.stances, *schedule.resting_objects)
    return Attachment(stances) if context.points or schedule.resting_objects else None


def _contact(context: Context, options: Options) -> Penalty | None:
    contacts = context.schedule.on_ground
    return Attachment(contacts, context.surfaces, "attach.contact") if contacts else None


def _grasp(context: Context, options: Options) -> Penalty | None:
    grasps, turns = context.schedule.grasps, context.schedule.turns
    return Attachment((*grasps, *turns), name="attach.grasp") if grasps else None


def _no_slip(context: Context, options: Options) -> Penalty | None:
    if not context.points:
        return None
    soles = context.schedule.soles
    reach = options.reach or soles.limits.slip_reach
    return Skate(context.points, context.surfaces, reach, context.keys.times, low_swing_segments(soles))


def _hover(context: Context, options: Options) -> Penalty | None:
    schedule, limits = context.schedule, Thresholds.of(context.figure)
    if not schedule.is_grounded.any() or not (context.points or context.figure.tables.free_links.size):
        return None
    reach = options.reach or limits.away
    return HoverPenalty(schedule.low_points, context.surfaces, reach, limits.float_blend, schedule.grounded_intervals)


def _equality(context: Context, options: Options) -> Penalty | None:
    """Return the penalty of closed loops [m²] and coupled joints [rad² or m²]; 1° costs as much as 17 mm."""
    loops, followers = closures(context.figure), couplings(context.figure)
    parts = list[Penalty]()
    if loops:
        parts.append(Attachment(loops, name="closed"))
    if followers:
        parts.append(CouplingPenalty(followers))
    return Sum(tuple(parts), name="equality") if parts else None


def _flight(context: Context, options: Options) -> Penalty | None:
    if options.intervals:
        _support_of(context, "flight")  # raises without a free joint
    support = context.support
    if support is None or not support.flights:
        return None
    return Flight.of(context.figure, support.root, support.flights, options.angular or 0.0)


def _support(context: Context, options: Options) -> Penalty | None:
    if context.is_tracking and not context.schedule.footings:
        return None
    support = _support_of(context, "support")
    return replace(support, friction=options.friction or support.friction)


def _support_of(context: Context, kind: str) -> Support:
    if context.support is None:
        raise UserError(f"{context.where}: penalty '{kind}' needs a figure with a free joint; there is none")
    return context.support


def _range(context: Context, options: Options) -> Penalty | None:
    figure, joints = context.figure, joint_ranges(context.figure)
    if context.is_tracking:
        joints = tuple(map(_inside, joints))
    return JointRange(joints).allowing(figure, context.keys) if joints else None


def _inside(joint: Range) -> Range:
    """Return a range with a margin inside, because a soft constraint is exceeded a little."""
    margin = min(INSIDE, 0.1 * (joint.high - joint.low))
    low = joint.low + margin * (joint.low != 0 or joint.kind is not JointKind.BALL)
    return replace(joint, low=low, high=joint.high - margin)


def _posture(context: Context, options: Options) -> Penalty:
    return Posture(between=Between.of(context.figure, context.keys, context.schedule.steps))


def _prior(context: Context, options: Options) -> Penalty | None:
    person = context.person
    if person is None:
        return None
    schedule, ground = context.schedule, _ground(context.surfaces)
    prior = Prior.of(person, context.keys, models.prior(), ground, schedule.gait_cycle, schedule.on_ground)
    return prior if prior.weights.any() else None


def _ground(surfaces: Sequence[Surface]) -> float | None:
    """Return the height of level ground [m]; None if there are other surfaces, or none."""
    planes = [surface for surface in surfaces if isinstance(surface, Plane) and surface.is_level]
    return float(planes[0].point[2]) if len(planes) == len(surfaces) == 1 else None


def _overshoot(context: Context, options: Options) -> Penalty | None:
    return overshoot(context.holds)


def _speed(context: Context, options: Options) -> Penalty | None:
    return Speed(float(np.radians(options.speed or 0.0))) if context.figure.tables.rotary_links.size else None


def _upright(context: Context, options: Options) -> Penalty:
    movable, links = moving_bodies(context.figure), list[int]()
    if not options.bodies:
        raise UserError(f"{context.where}: penalty 'upright' needs bodies = [...], the bodies to keep upright")
    for name in options.bodies:
        if name not in movable:
            raise UserError(f"{context.where}: penalty 'upright': {unknown('body', name, movable)}")
        links.append(movable[name])
    return Upright.of(context.figure, links, options.axis)


def _unit(context: Context, options: Options) -> Penalty | None:
    return UnitMagnitude(most=RAW_UNIT) if context.figure.tables.quaternion_links.size else None


def _cycle(context: Context, options: Options) -> Penalty | None:
    cycle = context.schedule.gait_cycle
    return None if cycle is None else Cycle(context.figure, cycle)


# While tracking, 1 is the cost of a second with 0.1 mm of depth or 2 mm/s of sliding at a weight of 1e8, 0.02° at 1e7,
# 0.2 °/s at 1e5, and a thirtieth of the figure's weight at 1000.
KINDS = {
    kind.name: kind
    for kind in (
        Kind("acceleration", (
            Part(1.0, "angular acceleration of bodies and of hinges", ("whip",),
                 lambda context, options: CovariantAcceleration(), "angular"),
            Part(1.0, "acceleration of the root and of slides", (),
                 lambda context, options: RootAcceleration(), "linear"),
        )),
        Kind("unit", (Part(1.0, "deviation of quaternions from unit length", ("length",), _unit, tracking=1e4),)),
        Kind("collision", (
            Part(30.0, "depth of heels and toes in static geoms", ("penetration",), _soles, "soles", tracking=1e8),
            # higher while tracking, so that a body on the ground hovers rather than sinks
            Part(30.0, "depth of all geoms of the figure in static geoms and held objects", ("penetration",),
                 _body, "body", tracking=2e8),
            Part(30.0, "depth of limbs in the trunk and in each other", ("self",), _self, "self", "self", tracking=1e6),
        ), ("margin", "points", "self")),
        Kind("attach", (
            Part(30.0, "movement of soles between two keyframes with the same sole position", ("stance",),
                 _stance, "stance"),
            Part(750.0, "movement of [[contact]] points", ("contact", "hover"), _contact, "contact", tracking=1e8),
            Part(750.0, "movement of [[grasp]] sites relative to the held body", ("grasp", "grasp rotation"),
                 _grasp, "grasp"),
        )),
        Kind("no_slip", (
            Part(1.4, "speed of heels and toes near a surface", ("slide", "drag"), _no_slip),
        ), ("reach",)),
        Kind("grounded", (
            Part(0.003, "height of the lowest point of a figure that is on the ground in some keyframe",
                 ("aloft", "float"), _hover),
        ), ("reach",)),
        Kind("posture", (Part(0.7, "velocity of joints and roots", (), _posture),)),
        Kind("prior", (Part(1.0, "distance from the motion that is predicted for a person", (), _prior),)),
        Kind("limits", (
            Part(1.0, "knees and elbows bent backward, sideways or twisted", ("backward", "sideways", "twist"),
                 _bend, "bend", tracking=1e7),
            Part(1.0, "angle or displacement beyond the model's joint ranges", ("range", "travel"),
                 _range, "range", tracking=1e7),
            Part(10.0, "movement of joints between two keyframes with the same joint value",
                 ("overshoot", "overshoot travel"), _overshoot, "overshoot"),
            Part(100.0, "speed of hinges and ball joints beyond a limit", ("speed",),
                 _speed, "speed", "speed", tracking=1e5),
        ), ("bend_joints", "least_bend", "sideways", "twist", "speed")),
        Kind("equality", (
            Part(300.0, "violation of <equality> constraints", ("coupled", "coupled travel", "torn"), _equality),
        )),
        Kind("upright", (
            Part(30.0, "tilt of listed bodies, such as a head or a tray", (), _upright),
        ), ("bodies", "axis"), is_default=False),
        Kind("flight", (
            Part(6.0, "force on the figure during flights, except gravity", ("float",), _flight),
        ), ("intervals", "angular")),
        Kind("support", (
            Part(2.0, "force and moment that feet on the ground cannot supply; "
                 "also on if a standing figure's x or y is free",
                 ("unsupported", "toppling", "unbalanced"), _support, tracking=1000.0),
        ), ("friction",), is_default=False),
        Kind("peak", (
            Part(0.01, "peaks of angular acceleration of joints", (), lambda context, options: PeakAcceleration()),
        ), is_default=False),
        Kind("cycle", (Part(0.1, "deviation from the gait cycle of the keyframes", (), _cycle),), ("period",)),
        Kind("torque", (
            Part(1.0, "joint torques of inertia, gravity and armature; ground reaction and passive forces are ignored",
                 (), lambda context, options: Torque()),
        ), is_default=False),
    )
}  # fmt: skip


def posing_limits(figure: Figure, listed: Mapping[str, Options]) -> BendLimits | None:
    """Return the limits of knees and elbows of a clip's listed kinds, or None if their penalty is off."""
    limits = listed.get("limits", Options())
    names = limits.bend_joints
    bends = tuple(bend for bend in knees_and_elbows(figure) if names is None or bend.name in names)
    return bend_limits(bends, limits) if bends and KINDS["limits"].weights(limits)["bend"] > 0 else None
