"""Figures and objects that float above the ground without falling, and feet that slide or drag on it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dynsplines.solver.array import Array, Index, Mask, runs
from dynsplines.solver.contacts import within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import cross
from dynsplines.solver.figure.dynamics import RootWrench, weight
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.heights import FAR, heights
from dynsplines.solver.surface.points import arrays_of, body_points, hanging, places_of
from dynsplines.solver.tolerances import TINY

from ..clip.posing.places import sphere_at
from ..motion import samples_at
from .bounds import BOUNDS, Bound, Violation, row_of
from .measurement import Measurement, feet_of

# [1] smallest force of an unknown support relative to the weight, up or down; in free fall this force is zero
CARRIED = 0.5


def floating_and_sliding(motion: Measurement) -> Iterator[Violation]:
    """Yield figures and carried objects that float, and feet that slide or drag."""
    context, figure = motion.clip.context, motion.clip.figure
    if not context.surfaces or not np.any(figure.gravity):
        return
    at = np.union1d(np.arange(0, motion.time.size, 4), motion.key_at)  # every fourth: 60 Hz
    samples = samples_at(figure, path_of(motion.timeline), motion.time[at])
    for root in figure.tables.free_links.tolist():
        points = hanging(figure, root, body_points(figure))
        if points and (figure.tables.children[root] or root in context.schedule.objects):
            height, _ = heights(context.surfaces, *places_of(points, samples))
            yield from _floating(motion, samples, at, root, height.min(axis=0))
    yield from _sliding(motion, samples)


def _floating(motion: Measurement, samples: Samples, at: Index, root: int, height: Array) -> Iterator[Violation]:
    """Yield intervals in which a tree is above the ground, but does not fall as a body without support would: it stays
    there, or it is pushed down.

    samples  S samples of the motion;  at  (S,) their indices among its times
    root     index of the tree's root link;  height  (S,) [m] of its lowest point
    """
    schedule, figure = motion.clip.context.schedule, motion.clip.figure
    is_object = root in schedule.objects
    contacts = [
        contact
        for contact in (*schedule.on_ground, *schedule.grasps)
        if not is_object or root in (contact.point.link, contact.on)
    ]
    carrying = [(contact.first, contact.last) for contact in contacts]
    sets_height = [key.fixed[figure.links[root].columns][2] for key in motion.clip.keys]
    numbers = np.where(sets_height, motion.numbers, 0)
    name, lowest = figure.links[root].name, int(height.round(3).argmin())
    if BOUNDS["aloft"].most < height[lowest] < FAR and not schedule.flights and not carrying:
        text = f"the figure never comes down: lowest point {height[lowest]:.2f} m above the floor"
        key = np.flatnonzero(motion.key_at == at[lowest])
        number = int(numbers[key[0]]) if key.size else 0
        yield row_of("aloft", name, text).violation(float(height[lowest]), float(samples.t[lowest]), number)
        return
    limits = Thresholds.of(figure)
    carried = RootWrench(samples, root).force[2] / max(weight(figure, root), TINY)
    is_explained = within((*carrying, *(schedule.specified_flights or ())), samples.t)
    for start, end in runs((height > limits.clear) & ~is_explained):
        run = np.arange(start, end)
        t, top, number = samples.t[run], run[height[run].argmax()], 0
        seconds = np.ptp(t) * np.mean(np.abs(carried[run]) >= CARRIED)
        if np.ptp(t) < limits.moment or seconds < min(np.ptp(t) / 2, limits.push_off):
            continue
        keys = np.flatnonzero(np.isin(motion.key_at, at[run[carried[run] >= CARRIED]]))
        if keys.size:
            key = int(keys[height[np.searchsorted(at, motion.key_at[keys])].argmax()])
            top, number = int(np.searchsorted(at, motion.key_at[key])), int(numbers[key])
        what = name if is_object else "the figure"
        text = f"{what} floats {{}} above the ground, for {np.ptp(t):.2f} s, and is not in free fall"
        yield row_of("float", name, text).violation(float(height[top]), float(samples.t[top]), number)


def _sliding(motion: Measurement, samples: Samples) -> Iterator[Violation]:
    """Yield intervals in which all points of a foot's sole move along the ground, or one of them drags on it.

    A sole is on the ground, or it moves fast near the ground for longer than a landing takes. The farthest drag of each
    foot is reported. Intervals in which a point must not move have checks of their own.
    """
    context, figure = motion.clip.context, motion.clip.figure
    if not context.points:
        return
    limits, points = Thresholds.of(figure), tuple(sphere_at(figure, point) for point in context.points)
    links, positions, _ = arrays_of(points)
    speeds = np.linalg.norm(_velocities(samples, links, positions)[:2], axis=0)
    centres, radii = places_of(points, samples)
    height, _ = heights(context.surfaces, centres, radii)
    stances = [
        (sphere_at(figure, contact.point), contact) for contacts in motion.targets.values() for contact in contacts
    ]
    rests = np.array(
        [
            within(tuple((one.first, one.last) for at, one in stances if at.coincides(point)), samples.t)
            for point in points
        ]
    )
    feet, drags = feet_of(figure, points)[links], (height < limits.brushes) & ~rests
    for foot in np.unique(feet):
        sole = np.flatnonzero(feet == foot)
        top, speed = height[sole].max(axis=0), speeds[sole].min(axis=0)
        slides = top < limits.near_surface
        for start, end in runs((top < limits.clear) & (speed > limits.travels)):
            slides[start:end] |= np.ptp(samples.t[start:end]) >= limits.step
        for start, end, distance in _moves(centres[:2, sole], slides & ~rests[sole].any(axis=0), BOUNDS["slide"]):
            drags[sole, start:end] = False
            yield _move("slide", figure.body_name(int(foot)), samples.t[start:end], speed[start:end], distance)
        moves = [(k, *move) for k in sole for move in _moves(centres[:2, [k]], drags[k], BOUNDS["drag"])]
        for k, start, end, distance in sorted(moves, key=lambda move: -move[-1])[:1]:
            yield _move("drag", points[k].name, samples.t[start:end], speeds[k, start:end], distance)


def _moves(places: Array, during: Mask, bound: Bound) -> Iterator[tuple[int, int, float]]:
    """Yield the first and last sample of intervals in which all points move farther than a bound, and how far [m].

    places  (2, P, S) [m] horizontal positions of the points;  during  (S,) whether a sample is in an interval
    """
    for start, end in runs(during):
        run = places[..., start:end]
        distance = float(np.linalg.norm(run - run[..., :1], axis=0).min(axis=0).max())
        if distance > bound.most:
            yield start, end, distance


def _move(kind: str, name: str, t: Array, speed: Array, distance: float) -> Violation:
    """Return the violation of a foot or point that moves along the ground at times t (S,) [s]; speed (S,) [m/s]."""
    text = f"{name} {kind}s {{}} along the ground from {t[0]:.2f} to {t[-1]:.2f} s, fastest"
    return row_of(kind, name, text).violation(distance, float(t[speed.argmax()]))


def _velocities(samples: Samples, links: Index, positions: Array) -> Array:
    """Return the velocities (3, P, S) [m/s] of points of links."""
    motion = samples.links
    _, offset = motion.points(links, positions)
    return motion.x_d[:, links] + cross(motion.omega[:, links], offset)
