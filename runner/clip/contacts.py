"""A clip's [[contact]] and [[grasp]] tables: points that rest on the ground, and sites that stay on a body.

Their position is `position` of the table, else that of the point in keyframes within the interval, of which the first
has precedence. Without either, the search determines the position of a contact, and a hold only must not slide. If a
keyframe puts the body out of the limb's reach, the grasp is relaxed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.contacts import Contact, ContactSchedule
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import grasp_places
from dynsplines.solver.penalty.penalty import Allowance
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import Point, arrays_of, sets_places, sets_poses
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
    samples = Samples.still(figure, keys.states)
    specified = contacts(samples, keys, tables, where, soles, surfaces)
    grasps = contacts(samples, keys, grasp_tables, where, soles)
    firm = [grasp for grasp, table in zip(grasps, grasp_tables, strict=True) if table.rotation != "free"]
    turns = tuple(turn for grasp in firm if _is_alone(grasp, grasps) for turn in rotation_points(samples, keys, grasp))
    return ContactSchedule(figure, keys, soles, surfaces, specified, grasps, turns)


def contacts(
    samples: Samples,
    keys: Timeline,
    tables: Sequence[ContactTable | GraspTable],
    where: str,
    soles: Sequence[Point] = (),
    surfaces: Sequence[Surface] = (),
) -> tuple[Contact, ...]:
    """Return the contacts of a clip's tables of one kind; raises UserError that names the invalid table.

    samples   the poses of the keyframes
    surfaces  if a keyframe has a point inside one of these, the point rises as `collision` requires
    """
    places, specified = Places(samples.figure, soles), list[Contact]()
    for i, table in enumerate(tables):
        kind, label = ("grasp", f" on '{table.body}'") if isinstance(table, GraspTable) else ("contact", "")
        name = f"{where}: {kind} {i + 1} ('{table.point}'{label})"
        contact = _without_places(places, table, name)
        _check_times(table, [(f"{kind} {k}", other) for k, other in enumerate(tables[:i], 1)], keys, name)
        specified.append(_with_places(samples, keys, contact, surfaces, f"{name}: keyframe {{}} (t = {{:g}} s)"))
    _check_hands(samples, keys, [contact for contact in specified if contact.on], where)
    _check_bodies(
        [piece for contact in specified if not contact.on for piece in contact.pieces()], places.figure, where
    )
    return tuple(specified)


def _without_places(places: Places, table: ContactTable | GraspTable, name: str) -> Contact:
    """Return the contact of a table, without the positions that keyframes specify."""
    point = places.named_point(table.point, name)
    target = None if table.position is None else np.array(table.position, float)
    if not isinstance(table, GraspTable):
        return Contact(point, table.start, table.end, specified=target)
    figure, bodies = places.figure, moving_bodies(places.figure)
    if table.body not in bodies:
        raise UserError(f"{name}: {_no_body(figure, table.body, bodies)}")
    link = int(figure.body_link[bodies[table.body]])
    if point.link == link:
        raise UserError(f"{name}: the site is on that body itself, where it always stays")
    if target is not None:
        target = figure.point_on_link(bodies[table.body], target)[1]
    return Contact(point, table.start, table.end, link, specified=target)


def _check_times(
    table: ContactTable | GraspTable,
    earlier: Sequence[tuple[str, ContactTable | GraspTable]],
    keys: Timeline,
    name: str,
) -> None:
    """Raise UserError unless a table's times rise, are within the clip, and overlap no earlier table of the point."""
    first, last = float(keys.times[0]), float(keys.times[-1])
    if not table.start < table.end:
        raise UserError(f"{name}: from = {table.start:g} s is not before to = {table.end:g} s")
    if table.start < first - ROUNDING or table.end > last + ROUNDING:
        raise UserError(
            f"{name}: {table.start:g} to {table.end:g} s is outside the clip, which runs from {first:g} to {last:g} s"
        )
    for label, other in earlier:
        first, last = max(table.start, other.start), min(table.end, other.end)
        if other.point == table.point and last - first > ROUNDING:
            raise UserError(
                f"{name}: overlaps {label} of the same point from {first:g} to {last:g} s; a point touches one thing "
                "at a time"
            )


def _with_places(
    samples: Samples, keys: Timeline, contact: Contact, surfaces: Sequence[Surface], label: str
) -> Contact:
    """Return a contact with the point's positions, as far as the table and keyframes specify them.

    Posed keyframes count only if nothing else specifies a position; label: of a keyframe in errors.
    """
    limits, target = Thresholds.of(samples.figure), contact.specified
    setting, places, exact = _positions(samples, keys, contact)
    is_posed = target is None and not exact[setting].any()
    firm = setting if is_posed else setting[exact[setting]]
    spots: dict[float, Array] = {}
    for k in firm.tolist():
        distance = float(np.linalg.norm(places[:, k] - (places[:, firm[0]] if target is None else target)))
        if distance <= limits.same_spot:
            spots[float(keys.times[k])] = places[:, k].copy()
        elif not is_posed:
            kind, body = ("grasp", " on the body") if contact.on else ("contact", "")
            there = f"the {kind}'s position" if target is not None else f"where keyframe {firm[0] + 1} has it"
            raise UserError(
                f"{label.format(k + 1, keys.times[k])} puts the point {distance:.3f} m from {there}{body}; "
                f"a {kind} may drift by {limits.same_spot:.3g} m"
            )
    if spots and surfaces:
        spots |= _rise(keys, contact, spots, places, exact, surfaces)
    if target is not None and not spots:
        spots = {contact.first: target}
    if not spots:
        return contact
    placed_contact = _at_spots(contact, spots)
    others = np.setdiff1d(setting, firm)
    return _loosen(placed_contact, spots, keys, places, others, limits) if contact.on else placed_contact


def _at_spots(contact: Contact, spots: Mapping[float, Array]) -> Contact:
    """Return a contact with positions (3,) [m] by time [s], if there are any."""
    times = sorted(spots)
    return replace(contact, times=np.array(times), places=np.array([spots[t] for t in times])) if spots else contact


def _rise(
    keys: Timeline,
    contact: Contact,
    spots: Mapping[float, Array],
    places: Array,
    exact: Mask,
    surfaces: Sequence[Surface],
) -> dict[float, Array]:
    """Return the positions (3,) [m] of a point at the ends [s] of its contact, if the nearest keyframe has it inside a
    surface. It is higher by the decrease of the allowed depth.

    places  (3, K) [m] in the keyframes;  exact  (K,) which of them fix it
    """
    height, up = height_over(surfaces, places[:, None], np.array([contact.point.radius]))
    sunk, out = Allowance(keys.times, np.maximum(-height[0], 0.0) * exact), dict[float, Array]()
    for time, end in ((min(spots), contact.first), (max(spots), contact.last)):
        deep = sunk.at(np.array([time, end]))
        if abs(end - time) > ROUNDING and deep[0] > deep[1]:
            out[end] = spots[time] + (deep[0] - deep[1]) * up[:, 0, np.searchsorted(keys.times, time)]
    return out


def _loosen(
    grasp: Contact, spots: Mapping[float, Array], keys: Timeline, places: Array, posed: Index, limits: Thresholds
) -> Contact:
    """Return a grasp with slack at posed keyframes that have the site elsewhere, because it is out of reach.

    Without slack a stretched limb whips there and back.
    """
    slack: dict[float, float] = {}
    more = dict(spots)
    for k in posed.tolist():
        t = float(keys.times[k])
        short = float(np.linalg.norm(places[:, k] - grasp.place(np.array([t]))[:, 0]))
        if short <= limits.out_of_reach:
            more[t], slack[t] = places[:, k].copy(), short * (short > limits.tiny)
    loosely = _at_spots(grasp, more)
    if not any(slack.values()):
        return loosely
    times = np.unique([grasp.first, *more, grasp.last])
    return replace(
        loosely, times=times, places=loosely.place(times).T, slack=np.array([slack.get(t, 0.0) for t in times])
    )


def _check_bodies(contacts: Sequence[Contact], figure: Figure, where: str) -> None:
    """Raise UserError if the distance of resting points of one body differs from that on it."""
    placed = [(contact, contact.places[0]) for contact in contacts if contact.places is not None]
    for i, (one, spot) in enumerate(placed):
        for other, other_spot in placed[:i]:
            start, end = max(one.first, other.first), min(one.last, other.last)
            if one.point.link != other.point.link or end <= start + ROUNDING:
                continue
            apart = float(np.linalg.norm(spot - other_spot))
            distance = float(np.linalg.norm(one.point.position - other.point.position))
            if abs(apart - distance) > Thresholds.of(figure).near_surface:
                raise UserError(
                    f"{where}: contacts of '{other.point.name}' and '{one.point.name}' contradict each other from "
                    f"{start:g} to {end:g} s: they are {apart:.3f} m apart there, but {distance:.3f} m on their body"
                )


def _check_hands(samples: Samples, keys: Timeline, grasps: Sequence[Contact], where: str) -> None:
    """Raise UserError if a keyframe fixes two hands at another distance than that at which they hold one body."""
    figure, (links, positions, _) = samples.figure, arrays_of([grasp.point for grasp in grasps])
    hands = samples.links.points(links, positions)[0]
    for (i, one), (j, other) in combinations(enumerate(grasps), 2):
        if one.on != other.on or not one.meets(other.first, other.last):
            continue
        is_fixed = sets_poses(figure, keys.fixed, [one.point.link], [other.point.link])[0]
        inside = [k for k in np.flatnonzero(is_fixed).tolist() if all(g.covers(keys.times[k]) for g in (one, other))]
        apart = np.linalg.norm(hands[:, i] - hands[:, j], axis=0)[inside]
        distance = apart[0] if apart.size else 0.0
        if one.places is not None and other.places is not None:
            distance = np.linalg.norm(one.places[0] - other.places[0])
        for k in np.flatnonzero(np.abs(apart - distance) > Thresholds.of(figure).same_spot)[:1].tolist():
            raise UserError(
                f"{where}: keyframe {inside[k] + 1} (t = {keys.times[inside[k]]:g} s) has '{one.point.name}' and "
                f"'{other.point.name}' {apart[k]:.3f} m apart, but they grasp '{figure.body_name(one.on)}' "
                f"{distance:.3f} m apart; free an arm in this keyframe, or end a grasp before it"
            )


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


def rotation_points(samples: Samples, keys: Timeline, grasp: Contact) -> Iterator[Contact]:
    """Yield the contacts of two points beside the site of a grasp, which hold the rotation of the body.

    Between keyframes that specify the rotation of the site's link and of the body, it changes at a constant rate.
    """
    setting, spots, _ = _positions(samples, keys, grasp)
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
        places = [(time, spot + quat.rotate(turn, axis)) for time, spot, turn in dense]
        yield _at_spots(Contact(beside, grasp.first, grasp.last, grasp.on, weight=TURN), dict(places))


def _is_alone(grasp: Contact, grasps: Sequence[Contact]) -> bool:
    """Return whether no other site holds the same body at the same time. Several hold it by their positions."""
    others = (other for other in grasps if other is not grasp and other.on == grasp.on)
    return not any(other.meets(grasp.first, grasp.last) for other in others)


def _positions(samples: Samples, keys: Timeline, contact: Contact) -> tuple[Index, Array, Mask]:
    """Return the indices (k,) of keyframes within a contact that set both the point and the link that it touches, the
    positions (3, K) on that link in all keyframes, and which (K,) fix them."""
    both = [contact.point, Point(contact.point.name, contact.on, np.zeros(3))]
    is_set, exact = (
        np.logical_and.reduce(sets_places(samples.figure, mask, both)) for mask in (keys.known, keys.fixed)
    )
    inside = (keys.times >= contact.first - ROUNDING) & (keys.times <= contact.last + ROUNDING)
    return np.flatnonzero(inside & is_set), grasp_places(samples, contact), exact
