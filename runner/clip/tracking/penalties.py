"""Soft constraints of a motion that follows a recording: contacts, ranges, balance.

These terms are not normalised by the raw spline, because the recording defines their scale. Differences from the
recording form a chi-squared sum, 1 per standard deviation. A weight, `Part.tracking`, states how much a squared metre
or radian over one second costs on this scale.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from pydantic import TypeAdapter, ValidationError

from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.quadrature import Quadrature
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import (
    Attachment,
    BendLimits,
    Collision,
    JointRange,
    Penalty,
    Range,
    SelfContact,
    Speed,
    Support,
    TrackingPenalty,
    UnitMagnitude,
    joint_ranges,
)
from dynsplines.solver.problem import Problem, Settings
from dynsplines.solver.surface import Plane, Surface, static_surfaces
from dynsplines.solver.surface.points import Point, body_points, bottoms_of
from dynsplines.solver.tolerances import ROUNDING

from ...errors import UserError
from ..context import knees_and_elbows
from ..kinds import TRACKING_WEIGHTS
from ..posing.places import Places, rounded, sole_points
from ..table import ContactTable, StanceTable

STANCES = TypeAdapter(list[StanceTable])
# longest panel [s] of Gauss's rule, and its number of nodes, exact for polynomials of degree 5
LONGEST_PANEL, POINTS = 0.05, 3
TOLERANCE = 3e-3  # [1] progress relative to E at which a search ends
INSIDE = 0.015  # [rad, m] margin inside a joint's range
NEXT_TO = 0.008  # [s] minimum distance of frames from a keyframe, half of their minimum spacing
RARE = 2.0  # [%] share of poses with extreme knee and elbow angles that is ignored
LOOKED_AT = 50  # number of poses from which soles are inferred
SLOWER = 0.95  # [1] factor on the speed limit of joints, because soft constraints yield a little


@dataclass(frozen=True, eq=False)
class Ground:
    """The soles of a figure, and the surfaces on which it stands.

    Attributes:
        avoids_self_collision: Whether self-collision is penalised, which takes twice as long.
        speed: The maximum speed of its joints [rad/s], if any.
        bends: The limits of its knees and elbows on ball joints.
    """

    figure: Figure
    points: tuple[Point, ...]
    surfaces: tuple[Surface, ...]
    avoids_self_collision: bool = False
    speed: float | None = None
    bends: BendLimits | None = None

    @cached_property
    def clear(self) -> tuple[Point, ...]:
        """The points of the body that must avoid obstacles.

        Points of feet and ankles below the resting soles are excluded, because the sole points represent them.
        """
        figure, body = self.figure, body_points(self.figure)
        if not body or not self.points:
            return body
        rest = Samples.still(figure, figure.to_state(figure.model.qpos0[None]))
        heights = bottoms_of((*body, *self.points), rest)[:, 0]
        soles = np.array([point.link for point in self.points])
        lowest = {link: heights[len(body) :][soles == link].min() for link in np.unique(soles).tolist()}

        flush = Thresholds.of(figure).tiny

        def is_below(point: Point, height: float) -> bool:
            feet = [link for link in lowest if point.link in (link, figure.links[link].parent)]
            return any(height < lowest[link] - flush for link in feet)

        return tuple(
            p for p, height in zip(body, heights[: len(body)].tolist(), strict=True) if not is_below(p, height)
        )


def ground_of(figure: Figure, qpos: Array) -> Ground:
    """Return the soles and surfaces of a figure, from poses (T, nq)."""
    sampled = qpos[:: max(1, len(qpos) // LOOKED_AT)]
    soles = tuple(rounded(figure, point) for point in sole_points(figure, sampled))
    return Ground(figure, soles, tuple(static_surfaces(figure.model)), bends=_bends(figure, sampled))


def _bends(figure: Figure, qpos: Array) -> BendLimits | None:
    """Return the limits of knees and elbows: the usual ones, extended to nearly all of the poses (T, nq)."""
    usual = BendLimits(tuple(knees_and_elbows(figure)))
    if not usual.joints:
        return None
    flexion, *aside = usual.angles(Samples.still(figure, figure.to_state(qpos)))
    sideways, twist = (float(np.percentile(np.abs(angle), 100 - RARE)) for angle in aside)
    return replace(
        usual,
        least=min(usual.least, float(np.percentile(flexion, RARE))),
        sideways=max(usual.sideways, sideways),
        twist=max(usual.twist, twist),
    )


def rests_of(
    ground: Ground, tables: Sequence[ContactTable], span: tuple[float, float], where: str
) -> tuple[Contact, ...]:
    """Return the stances of [[contact]] tables for a recording over a span [s]; `where` is the label in errors."""
    places, soles, rests = Places(ground.figure, ground.points), {p.name: p for p in ground.points}, list[Contact]()
    for number, table in enumerate(tables, start=1):
        name = f"{where}: contact {number} ('{table.point}')"
        point = soles.get(table.point) or places.named_point(table.point, name)
        if not span[0] - ROUNDING <= table.start < table.end <= span[1] + ROUNDING:
            raise UserError(
                f"{name}: {table.start:g} to {table.end:g} s is not within the recording, {span[0]:g} to {span[1]:g} s"
            )
        rests.append(Contact(point, table.start, table.end, rolls=True))
    return tuple(rests)


def stances_of(rests: Sequence[Contact]) -> list[dict[str, object]]:
    """Return stances as stored in a motion's file, see `StanceTable`."""
    return [
        {
            "point": rest.point.name,
            "from, s": rest.first,
            "to, s": rest.last,
            **({} if rest.surface is None else {"on": [*rest.surface.point.tolist(), *rest.surface.normal.tolist()]}),
        }
        for rest in rests
    ]


def stances_in(stances: object, ground: Ground, where: str) -> tuple[Contact, ...]:
    """Return the stances that a motion's file contains.

    Raises:
        UserError: The stances are damaged, or are not of this figure.
    """
    places, soles, rests = Places(ground.figure, ground.points), {p.name: p for p in ground.points}, list[Contact]()
    try:
        rows = STANCES.validate_python(stances)
    except ValidationError:
        raise UserError(f"{where}: its stances are damaged; solve the clip again") from None
    for row in rows:
        point = soles.get(row.point) or places.point(row.point)
        if point is None or not row.start < row.end:
            raise UserError(f"{where}: its stances belong to another figure; solve the clip again")
        on = None if row.on is None else Plane("ground", np.array(row.on[:3]), np.array(row.on[3:]))
        rests.append(Contact(point, row.start, row.end, surface=on, rolls=True))
    return tuple(rests)


def problem(
    near: TrackingPenalty, ground: Ground, rests: Sequence[Contact], times: Array, edits: Sequence[Frame] = ()
) -> Problem:
    """Return the problem of tracking a recording; times: times of the frames, (M,) [s]."""
    figure, path = near.recorded.figure, near.recorded.path
    free = _clear(times, np.array([edit.time for edit in edits]))
    frames = loose(figure, free, path.at(free))
    keys = sorted([*edits, *frames], key=lambda frame: frame.time)
    quadrature = Quadrature("gauss", POINTS, LONGEST_PANEL)
    settings = Settings(variable=0, frames=0, tolerance=TOLERANCE, renormalise=False, quadrature=quadrature)
    weighted = [(penalty, TRACKING_WEIGHTS[penalty.name]) for penalty in penalties_of(ground, rests)]
    return Problem(figure, tuple(keys), ((near, 1.0), *weighted), settings)


def loose(figure: Figure, times: Array, states: Array) -> tuple[Frame, ...]:
    """Return frames without fixed entries, at times (M,) [s], with initial states (M, N)."""
    everything = np.ones(figure.width, bool)
    poses = zip(times, figure.to_qpos(states), strict=True)
    return tuple(Frame(time, qpos, ~everything, everything) for time, qpos in poses)


def _clear(times: Array, key_times: Array) -> Array:
    """Return the times (M,) of frames that are not next to keyframes, where the spline would oscillate."""
    if not key_times.size:
        return times
    away = np.abs(times[:, None] - key_times).min(axis=1)
    ends = np.isin(times, (times[0], times[-1]))
    return times[(away > NEXT_TO) | (ends & (away > ROUNDING))]


def penalties_of(ground: Ground, rests: Sequence[Contact]) -> list[Penalty]:
    """Return all constraints besides the recording."""
    figure, surfaces = ground.figure, ground.surfaces
    penalties: list[Penalty] = []
    if figure.tables.quaternion_columns.size:
        penalties.append(UnitMagnitude())
    if surfaces and ground.points:
        penalties.append(Collision(ground.points, surfaces))
    if surfaces and (body := ground.clear):
        penalties.append(Collision(body, surfaces, term_name="collision.body"))
    if rests:
        penalties.append(Attachment(tuple(rests), surfaces, "attach.contact"))
        if figure.tables.free_links.size:
            penalties.append(Support.of(figure, int(figure.tables.free_links[0]), footings_of(rests), ()))
    if ranges := joint_ranges(figure):
        penalties.append(JointRange(tuple(map(_inside, ranges))))
    if ground.bends is not None:
        penalties.append(ground.bends)
    if ground.speed is not None:
        penalties.append(Speed.of(figure, SLOWER * ground.speed))
    self_contact = SelfContact.of(figure, 0.0) if ground.avoids_self_collision else None
    return [*penalties, self_contact] if self_contact is not None and self_contact.pairs.size else penalties


def footings_of(rests: Sequence[Contact]) -> tuple[Contact, ...]:
    """Return the footings of the stances of a recording: the ground is taken to be level."""
    return tuple(replace(rest, surface=None) for rest in rests)


def _inside(joint_range: Range) -> Range:
    margin = min(INSIDE, 0.1 * (joint_range.high - joint_range.low))
    return replace(
        joint_range,
        low=joint_range.low + margin * (joint_range.low != 0 or joint_range.kind is not JointKind.BALL),
        high=joint_range.high - margin,
    )
