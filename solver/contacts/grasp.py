"""Grasped objects: which links are held, their surfaces, and where they rest before and after a hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from .. import quaternion as quat
from ..array import Array, Mask
from ..curve.spline import path_of
from ..figure.figure import Figure
from ..figure.kinematics import Samples
from ..surface import Surface, moving_surface
from ..surface.points import Point
from ..surface.touch import movers
from .contact import Contact
from .keyframe_points import KeyframePoints
from .stances import contact_between


def tree_of(figure: Figure, link: int) -> int:
    """Return the first link of a link's tree: 0 for the world."""
    while figure.links[link].parent:
        link = figure.links[link].parent
    return link


def grasped_links(figure: Figure, grasps: Sequence[Contact]) -> tuple[int, ...]:
    """Return the links, in order, of trees that are held by a point of another tree and hold nothing."""
    holders = {tree_of(figure, grasp.point.link) for grasp in grasps}
    trees = {tree_of(figure, grasp.on) for grasp in grasps} - holders
    return tuple(i for i in range(1, len(figure.links)) if tree_of(figure, i) in trees)


def surfaces_on(figure: Figure, link: int) -> tuple[Surface, ...]:
    """Return the solid geoms of a link as surfaces in its axes."""
    surfaces: list[Surface] = []
    for geom in movers(figure.model):
        body = int(figure.model.geom_bodyid[geom])
        if figure.body_link[body] != link:
            continue
        _, centre = figure.point_on_link(body, figure.model.geom_pos[geom])
        turn = quat.product(figure.body_turn[body], figure.model.geom_quat[geom])
        surface = moving_surface(figure.model, geom, np.asarray(centre), quat.matrices(turn))
        if surface is not None:
            surfaces.append(surface)
    return tuple(surfaces)


def resting_objects(
    keyframes: KeyframePoints, links: Sequence[int], grasps: Sequence[Contact] = ()
) -> tuple[Contact, ...]:
    """Return the stances of objects before and after holds, three points per object.

    An object with equal poses in two neighbouring keyframes rests between them. In a segment in which a hold begins or
    ends, it also rests between the hold and a keyframe at which it lies: its pose is the same in the keyframe on the
    other side, or there is none. A hand must be near it at this end of the hold. Otherwise the object may be in flight,
    as if thrown.

    Args:
        keyframes: Any points at the keyframes.
        links: The objects: links with a separate kinematic tree.
        grasps: All grasps.
    """
    inferred: list[Contact] = []
    for link in links:
        arm, name = keyframes.limits.object_arm, keyframes.figure.links[link].name
        points = keyframes.with_points([Point(name, link, arm * axis) for axis in np.eye(3)])
        is_set = np.logical_and.reduce(points.is_known)
        stays: Mask = np.logical_and.reduce(points.moves < points.limits.tiny) & is_set[:-1] & is_set[1:]
        inferred += [contact_between(points, i, k) for k in np.flatnonzero(stays).tolist() for i in range(3)]
        for k, grasp, hold in _unheld(points, stays, is_set, [grasp for grasp in grasps if grasp.on == link]):
            if _is_at_hand(points, k, grasp, hold, link):
                first, last = sorted((float(keyframes.keys.times[k]), hold))
                places = points.centres[:, :, k].T.copy()
                inferred += [Contact.at(p, first, last, at) for p, at in zip(points.points, places, strict=True)]
    return tuple(inferred)


def _unheld(
    points: KeyframePoints, stays: Mask, is_set: Mask, grasps: Sequence[Contact]
) -> Iterator[tuple[int, Contact, float]]:
    """Yield the parts of segments before and after holds of one object, given by its points.

    Args:
        stays: The segments in which it rests, (K − 1,).
        is_set: The keyframes that place it, (K,).
        grasps: Its grasps.

    Yields:
        The keyframe at which it lies, and the grasp that begins or ends the hold at the other end, with its time [s].
    """
    for k, start, end in points.segments():
        holds = [grasp for grasp in grasps if grasp.first < end and start < grasp.last]
        if not holds or stays[k]:
            continue
        first, last = min(holds, key=lambda grasp: grasp.first), max(holds, key=lambda grasp: grasp.last)
        if first.first - start > points.limits.lift_off and is_set[k] and _lies(stays, k - 1):
            yield k, first, first.first
        if end - last.last > points.limits.lift_off and is_set[k + 1] and _lies(stays, k + 1):
            yield k + 1, last, last.last


def _lies(stays: Mask, beyond: int) -> bool:
    """Return whether an object lies in the segment beyond a keyframe, or there is none."""
    return not 0 <= beyond < stays.size or bool(stays[beyond])


def _is_at_hand(points: KeyframePoints, k: int, grasp: Contact, hold: float, link: int) -> bool:
    """Return whether the hand is near the object of keyframe k when the hold begins or ends [s], on the spline through
    the keyframes."""
    at, links = np.array([hold]), points.samples.links
    samples = Samples(points.figure, *path_of(points.keys).motion(at))
    hand, _ = samples.links.points(np.array([grasp.point.link]), grasp.point.position[:, None])
    place: Array = links.x[:, link, k]
    if grasp.is_placed:
        place = place + links.rotation[:, :, link, k] @ grasp.place(at)[:, 0]
    return float(np.linalg.norm(hand[:, 0, 0] - place)) < points.limits.away
