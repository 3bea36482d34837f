"""A clip's [[contact]] and [[grasp]] tables: points that rest on the ground, and sites that stay on a body.

Their position is `position` of the table, else that of the point in keyframes within the interval, of which the first
has precedence. Without either, the search determines the position of a contact, and a hold only must not slide. If a
keyframe puts the body out of the limb's reach, the grasp is relaxed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from operator import itemgetter

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.contacts import Contact, ContactSchedule
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import slipped
from dynsplines.solver.penalty.allowance import Allowance
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import Point, placed
from dynsplines.solver.tolerances import ROUNDING

from ..errors import UserError, unknown
from .posing.places import Places, sole_points
from .table import ContactTable, GraspTable

TURN = 0.1  # [1] weight of the points that hold a rotation, relative to the site of the grasp
FINE = float(np.radians(5))  # [rad] rotation over which the way of a point is taken to be straight


def schedule_of(
    figure: Figure,
    keys: Timeline,
    surfaces: tuple[Surface, ...],
    where: str,
    tables: Sequence[ContactTable] = (),
    grasp_tables: Sequence[GraspTable] = (),
) -> ContactSchedule:
    """Return the schedule of a figure's soles, and of the contacts and grasps that tables and keyframes specify.

    Raises:
        UserError: For an invalid table, by its number.
    """
    complete = [frame.state for frame in keys.frames if frame.is_key]
    soles = sole_points(figure, figure.to_qpos(np.reshape(complete, (-1, figure.width))))
    specified = contacts(figure, keys, tables, where, soles, surfaces)
    samples = Samples.still(figure, keys.states)
    grasps = grasps_of(samples, keys, grasp_tables, where, soles)
    firm = [grasp for grasp, table in zip(grasps, grasp_tables, strict=True) if table.rotation != "free"]
    turns = tuple(turn for grasp in firm if _is_alone(grasp, grasps) for turn in rotation_points(samples, keys, grasp))
    return ContactSchedule(figure, keys, soles, surfaces, specified, grasps, turns)


def contacts(
    figure: Figure,
    keys: Timeline,
    tables: Sequence[ContactTable],
    where: str,
    soles: Sequence[Point] = (),
    surfaces: Sequence[Surface] = (),
) -> tuple[Contact, ...]:
    """Return the contacts of a clip's tables; raises UserError that names the invalid table.

    surfaces  if a keyframe has a point inside one of these, the point rises as `collision` requires
    """
    places = Places(figure, soles)
    specified: list[Contact] = []
    for i, table in enumerate(tables):
        name = f"{where}: contact {i + 1} ('{table.point}')"
        point = places.named_point(table.point, name)
        same = [(f"contact {k} of the same point", t) for k, t in enumerate(tables[:i], 1) if t.point == table.point]
        _check_times(table, same, keys, name, "a point rests in one place at a time")
        target = None if table.position is None else np.array(table.position, float)
        contact = Contact(point, table.start, table.end, specified=target)
        specified.append(_placed(contact, _spots(figure, keys, contact, name, surfaces)))
    _check_bodies(
        [piece for contact in specified for piece in contact.pieces()], where, Thresholds.of(figure).near_surface
    )
    return tuple(specified)


def _placed(contact: Contact, spots: Sequence[tuple[float, Array]]) -> Contact:
    """Return a contact with positions (3,) [m] at times [s], if there are any."""
    if not spots:
        return contact
    times, places = zip(*spots, strict=True)
    return replace(contact, times=np.array(times), places=np.array(places))


def _check_times(
    table: ContactTable | GraspTable,
    same: Sequence[tuple[str, ContactTable | GraspTable]],
    keys: Timeline,
    name: str,
    why: str,
) -> None:
    """Raise UserError unless a table's times rise, are within the clip, and overlap no earlier table of the `same`."""
    first, last = float(keys.times[0]), float(keys.times[-1])
    if not table.start < table.end:
        raise UserError(f"{name}: from = {table.start:g} s is not before to = {table.end:g} s")
    if table.start < first - ROUNDING or table.end > last + ROUNDING:
        raise UserError(
            f"{name}: {table.start:g} to {table.end:g} s is outside the clip, which runs from {first:g} to {last:g} s"
        )
    for label, other in same:
        first, last = max(table.start, other.start), min(table.end, other.end)
        if last - first > ROUNDING:
            raise UserError(f"{name}: overlaps {label} from {first:g} to {last:g} s; {why}")


def _spots(
    figure: Figure, keys: Timeline, rest: Contact, name: str, surfaces: Sequence[Surface]
) -> list[tuple[float, Array]]:
    """Return the point's specified positions at times of the interval, from the table and from keyframes.

    Posed keyframes count only if the table specifies no position.
    """
    at_keys, target = KeyframePoints.of(figure, keys, [rest.point], surfaces), rest.specified
    centres, drift = at_keys.centres, at_keys.limits.same_spot
    inside = (keys.times >= rest.first - ROUNDING) & (keys.times <= rest.last + ROUNDING)
    setting = np.flatnonzero(inside & (at_keys.is_known if target is None else at_keys.is_fixed)[0])

    def contradicts(k: int, distance: float, first: int | None) -> str:
        where = "the contact's position" if first is None else f"where keyframe {first + 1} does"
        return (
            f"{name}: keyframe {k + 1} (t = {keys.times[k]:g} s) puts the point {distance:.3f} m from {where}; "
            f"a contact may drift by {drift:.3g} m"
        )

    agreed = agreeing(centres[:, 0], setting, at_keys.is_fixed[0], target, drift, contradicts)
    if not agreed:
        return [] if target is None else [(rest.first, target)]
    height, up = height_over(surfaces, centres, np.array([rest.point.radius]))
    sunk = Allowance(keys.times, np.maximum(-height[0], 0.0) * at_keys.is_fixed[0])
    spots = [(float(keys.times[k]), centres[:, 0, k].copy()) for k in agreed]
    first, last = (_risen(spots[i], end, sunk, up[:, 0, agreed[i]]) for i, end in ((0, rest.first), (-1, rest.last)))
    return [*first, *spots, *last]


def _risen(spot: tuple[float, Array], end: float, penetration: Allowance, up: Array) -> list[tuple[float, Array]]:
    """Return the position of a point at an end [s] of its contact, if the nearest keyframe has it inside a surface.

    It is higher by the decrease of the allowed depth.

    spot  time [s] and position (3,) [m] in the keyframe;  sunk  depths of keyframes;  up  (3,) direction
    """
    deep = penetration.at(np.array([spot[0], end]))
    return [(end, spot[1] + (deep[0] - deep[1]) * up)] if abs(end - spot[0]) > ROUNDING and deep[0] > deep[1] else []


def agreeing(
    places: Array,
    specified: Index,
    exact: Mask,
    target: Array | None,
    drift: float,
    contradicts: Callable[[int, float, int | None], str],
) -> list[int]:
    """Return the keyframes of `specified` whose positions, of (3, K) [m], agree with the wanted one (3,) within a
    drift.

    Without a wanted position, that of the first keyframe counts.

    exact        (K,) which keyframes fix the position; posed ones are omitted if they disagree
    contradicts  returns the error for a keyframe that fixes another position: index, distance [m], and the first one
    """
    kept: list[int] = []
    specified = specified[np.argsort(~exact[specified], kind="stable")]
    for k in specified.tolist():
        reference = places[:, specified[0]] if target is None else target
        distance = float(np.linalg.norm(places[:, k] - reference))
        if distance <= drift:
            kept.append(k)
        elif exact[k]:
            raise UserError(contradicts(k, distance, int(specified[0]) if target is None else None))
    return sorted(kept)


def _check_bodies(contacts: Sequence[Contact], where: str, stretch: float) -> None:
    """Raise UserError if the distance of resting points of one body differs from that on it by more than a stretch."""
    placed = [(contact, contact.places[0]) for contact in contacts if contact.places is not None]
    for i, (one, spot) in enumerate(placed):
        for other, other_spot in placed[:i]:
            start, end = max(one.first, other.first), min(one.last, other.last)
            if one.point.link != other.point.link or end <= start + ROUNDING:
                continue
            apart = float(np.linalg.norm(spot - other_spot))
            distance = float(np.linalg.norm(one.point.position - other.point.position))
            if abs(apart - distance) > stretch:
                raise UserError(
                    f"{where}: contacts of '{other.point.name}' and '{one.point.name}' contradict each other from "
                    f"{start:g} to {end:g} s: they are {apart:.3f} m apart there, but {distance:.3f} m on their body"
                )


def grasps_of(
    samples: Samples, keys: Timeline, tables: Sequence[GraspTable], where: str, soles: Sequence[Point] = ()
) -> tuple[Contact, ...]:
    """Return the grasps of a clip's tables; raises UserError that names the invalid table.

    samples  the poses of the keyframes
    """
    figure = samples.figure
    places, bodies = Places(figure, soles), moving_bodies(figure)
    grasps: list[Contact] = []
    for i, table in enumerate(tables):
        name = f"{where}: grasp {i + 1} ('{table.hand}' on '{table.body}')"
        point = places.named_point(table.hand, name)
        if table.body not in bodies:
            raise UserError(f"{name}: {_no_body(figure, table.body, bodies)}")
        link = int(figure.body_link[bodies[table.body]])
        if point.link == link:
            raise UserError(f"{name}: the site is on that body itself, where it always stays")
        same = [(f"grasp {k} of the same site", t) for k, t in enumerate(tables[:i], 1) if t.hand == table.hand]
        _check_times(table, same, keys, name, "a site holds one thing at a time")
        target = None
        if table.position is not None:
            target = figure.point_on_link(bodies[table.body], np.array(table.position, float))[1]
        grasps.append(_grasped(samples, keys, Contact(point, table.start, table.end, link, specified=target), name))
    return tuple(grasps)


def moving_bodies(figure: Figure) -> dict[str, int]:
    """Return the bodies that joints move, by name."""
    model = figure.model
    return {model.body(i).name: i for i in range(1, model.nbody) if model.body(i).name and figure.body_link[i]}


def _no_body(figure: Figure, name: str, bodies: dict[str, int]) -> str:
    """Return the error for a body that does not exist or cannot be held."""
    model = figure.model
    still = {model.body(i).name for i in range(model.nbody)} | {model.geom(i).name for i in range(model.ngeom)}
    if name in still and name not in bodies:
        return f"'{name}' does not move by itself; hold a body that does, or let the site rest by a [[contact]]"
    return unknown("body", name, bodies)


def _grasped(samples: Samples, keys: Timeline, grasp: Contact, name: str) -> Contact:
    """Return a grasp with the site's positions on the body, as far as the table and keyframes specify them."""
    limits = Thresholds.of(samples.figure)
    setting, places, exact = _grasp_places(samples, keys, grasp)
    target = grasp.specified

    def contradicts(k: int, distance: float, first: int | None) -> str:
        where = "the grasp's position" if first is None else f"where keyframe {first + 1} has it"
        return (
            f"{name}: keyframe {k + 1} (t = {keys.times[k]:g} s) has the site {distance:.3f} m from {where} on "
            f"the body; a grasp may drift by {limits.same_spot:.3g} m"
        )

    firm = setting[exact[setting]] if exact[setting].any() else setting
    agreed = agreeing(places, firm, exact, target, limits.same_spot, contradicts)
    spots = {float(keys.times[k]): places[:, k].copy() for k in agreed}
    if target is not None and not spots:
        spots = {grasp.first: target}
    if not spots:
        return grasp
    firmly = _placed(grasp, sorted(spots.items(), key=itemgetter(0)))
    slack: dict[float, float] = {}
    for k in np.setdiff1d(setting, firm):
        t = float(keys.times[k])
        short = float(np.linalg.norm(places[:, k] - firmly.place(np.array([t]))[:, 0]))
        if short <= limits.out_of_reach:
            # without slack a stretched limb whips there and back
            spots[t], slack[t] = places[:, k].copy(), short * (short > limits.tiny)
    loosely = _placed(grasp, sorted(spots.items(), key=itemgetter(0)))
    if not any(slack.values()):
        return loosely
    times = np.unique([grasp.first, *spots, grasp.last])
    return replace(
        loosely, times=times, places=loosely.place(times).T, slack=np.array([slack.get(t, 0.0) for t in times])
    )


def rotation_points(samples: Samples, keys: Timeline, grasp: Contact) -> Iterator[Contact]:
    """Yield the contacts of two points beside the site of a grasp, which hold the rotation of the body.

    Between keyframes that specify the rotation of the site's link and of the body, it changes at a constant rate.
    """
    setting, spots, _ = _grasp_places(samples, keys, grasp)
    hands, bodies = (samples.links.Q[:, link, setting].T for link in (grasp.point.link, grasp.on))
    turns = quat.product(quat.inverse(bodies), hands)  # of the hand in the axes of the body
    knots = [(float(keys.times[k]), spots[:, k], turn) for k, turn in zip(setting.tolist(), turns, strict=True)]
    dense = knots[:1]
    for (first, spot, turn), (last, end, end_turn) in pairwise(knots):
        whole = quat.rotation_vector(quat.product(end_turn, quat.inverse(turn)))
        count = max(1, int(np.ceil(np.linalg.norm(whole) / FINE)))
        for share in (np.arange(count) + 1) / count:
            turning = quat.product(quat.from_rotation_vector(share * whole), turn)
            dense.append((first + share * (last - first), spot + share * (end - spot), turning))
    for axis in Thresholds.of(samples.figure).object_arm * np.eye(3)[:2]:
        beside = replace(grasp.point, position=grasp.point.position + axis)
        places = [(time, spot + quat.rotated(turn, axis)) for time, spot, turn in dense]
        yield _placed(Contact(beside, grasp.first, grasp.last, grasp.on, weight=TURN), places)


def _is_alone(grasp: Contact, grasps: Sequence[Contact]) -> bool:
    """Return whether no other site holds the same body at the same time. Several hold it by their positions."""
    others = (other for other in grasps if other is not grasp and other.on == grasp.on)
    return not any(other.meets(grasp.first, grasp.last) for other in others)


def _grasp_places(samples: Samples, keys: Timeline, grasp: Contact) -> tuple[Index, Array, Mask]:
    """Return the keyframes within a grasp that specify it. These are indices (k,) of keyframes that set both site and
    body, positions (3, K) on the body, and which (K,) are fixed."""
    both = [grasp.point, Point(grasp.point.name, grasp.on, np.zeros(3))]
    is_set, exact = (np.logical_and.reduce(placed(samples.figure, mask, both)) for mask in (keys.known, keys.fixed))
    inside = (keys.times >= grasp.first - ROUNDING) & (keys.times <= grasp.last + ROUNDING)
    return np.flatnonzero(inside & is_set), slipped(samples, grasp), exact
