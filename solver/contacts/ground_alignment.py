"""Alignment of a recording with the ground: stances touch it, with level soles.

The height of a captured skeleton's ankle depends on its marker set. A sole that is flat in the recording may stand on
its toes in the figure. Both are constant offsets of the recording, not motion.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from .. import quaternion as quat
from ..array import SAMPLES_AT_ONCE, Array, Mask
from ..curve.recording import Track
from ..figure.figure import Figure, JointKind, quaternion_columns
from ..figure.kinematics import Samples
from ..surface import Surface
from ..surface.heights import height_over, heights
from ..surface.points import Point, arrays_of, places_of
from .contact import Contact, within
from .thresholds import Thresholds

LOWEST = 2.0  # [%] of the samples that may be below the ground
MOST = np.radians(25)  # [rad] largest tilt of a sole that counts as an offset; beyond, the figure stands on its toes
ENOUGH = 5  # least number of samples in which a whole sole stands


def align_to_ground(recorded: Track, stances: Sequence[Contact], surfaces: Sequence[Surface]) -> Track:
    """Return the recording with level soles, and shifted vertically so that stances are on the ground."""
    if not stances or not surfaces:
        return recorded
    for link in {one.point.link for one in stances}:
        recorded = _level(recorded, [one for one in stances if one.point.link == link], link)
    points = _points(stances)
    places = _places(recorded, points)
    height, _ = height_over(surfaces, places, np.array([point.radius for point in points]))
    standing = _during(recorded.times, stances, points)
    lift = -float(np.median(height[standing])) if standing.any() else 0.0
    return recorded if abs(lift) < Thresholds.of(recorded.figure).tiny else recorded.move([0, 0, lift])


def move_to_ground(recorded: Track, points: Sequence[Point], surfaces: Sequence[Surface]) -> Track:
    """Return the recording shifted vertically if all of it is far in or above the ground, as of another floor."""
    if not points or not surfaces:
        return recorded
    places = _places(recorded, points)
    lowest, _ = heights(surfaces, places, np.array([point.radius for point in points]))
    lift = -float(np.percentile(lowest.min(axis=0), LOWEST))
    return recorded.move([0, 0, lift]) if abs(lift) > Thresholds.of(recorded.figure).same_spot else recorded


def _level(recorded: Track, stances: Sequence[Contact], link: int) -> Track:
    """Return the recording rotated at the link of a sole, so that the mean of it is level when all of it stands."""
    figure = recorded.figure
    columns = quaternion_columns(figure.links[link])
    points = _points(stances)
    if columns is None or figure.links[link].kind is JointKind.FREE or len(points) < 2:
        return recorded
    flat = _during(recorded.times, stances, points).all(axis=0)
    if flat.sum() < ENOUGH:
        return recorded
    vertical = [samples.links.rotation[2, :, link] for samples in _runs(figure, recorded.bridged[flat])]
    up = _unit(np.concatenate(vertical, axis=1).mean(axis=1))
    _, positions, radii = arrays_of(points)
    bottom = (positions - radii * up[:, None]).T
    if len(points) == 2:
        along = _unit(bottom[1] - bottom[0])
        start, end = along, _unit(along - up * (along @ up))
    else:
        normal = np.linalg.svd(bottom - bottom.mean(axis=0))[2][2]
        start, end = normal * np.sign(normal @ up), up
    if start @ end < np.cos(MOST):
        return recorded
    return recorded.turn(columns, quat.swing(start, end, up))


def _runs(figure: Figure, states: Array) -> Iterator[Samples]:
    """Yield poses (T, N) in runs."""
    for first in range(0, len(states), SAMPLES_AT_ONCE):
        yield Samples.still(figure, states[first : first + SAMPLES_AT_ONCE])


def _places(recorded: Track, points: Sequence[Point]) -> Array:
    """Return positions (3, n, T) [m] of points on the most likely curve at the samples."""
    return np.concatenate(
        [places_of(points, samples)[0] for samples in _runs(recorded.figure, recorded.bridged)], axis=2
    )


def _points(stances: Sequence[Contact]) -> list[Point]:
    return list({id(one.point): one.point for one in stances}.values())


def _during(times: Array, stances: Sequence[Contact], points: Sequence[Point]) -> Mask:
    """Return the mask (n, T) of times within any of the stances of each point."""
    intervals = [tuple((one.first, one.last) for one in stances if one.point is point) for point in points]
    return np.array([within(stood, times) for stood in intervals])


def _unit(vector: Array) -> Array:
    return vector / np.linalg.norm(vector)
