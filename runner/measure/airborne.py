"""Figures that stay above the ground although they neither fall nor touch anything, and feet that slide on it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dynsplines.solver.array import Array, Index, runs
from dynsplines.solver.contacts.footing import within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import cross
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrench import RootWrench, weight
from dynsplines.solver.surface.heights import heights
from dynsplines.solver.surface.points import arrays_of, body_points, places_of

from ..clip.posing.pose_report import standing_trees
from ..motion import samples_at
from .bounds import BOUNDS
from .checks import Row, row_of
from .measurement import Measurement, feet_of

RATE = 60.0  # [1/s] of the samples
# [1] smallest force of an unknown support relative to the weight, up or down; in free fall this force is zero
CARRIED = 0.5

Excess = tuple[Row, float, float, int | None]  # a row, its amount, the time [s], the index of a keyframe that causes it


def airborne(motion: Measurement) -> Iterator[Excess]:
    """Yield figures that float above the ground, and feet that slide on it."""
    context, figure = motion.clip.context, motion.clip.figure
    if not context.surfaces or not np.any(figure.gravity):
        return
    even = np.arange(0, motion.time.size, max(1, round(motion.time.size / (np.ptp(motion.time) * RATE + 1))))
    at = np.union1d(even, motion.key_at)
    samples = samples_at(figure, path_of(motion.timeline), motion.time[at])
    for root in standing_trees(figure):
        points = [point for point in body_points(figure) if figure.tables.path[point.link, root]]
        if figure.tables.children[root] and points:
            height, _ = heights(context.surfaces, *places_of(points, samples))
            yield from _floating(motion, samples, at, root, height.min(axis=0))
    yield from _sliding(motion, samples)


def _floating(motion: Measurement, samples: Samples, at: Index, root: int, height: Array) -> Iterator[Excess]:
    """Yield intervals in which a tree is above the ground, but does not fall as a body without support would: it stays
    there, or it is pushed down.

    samples  S samples of the motion;  at  (S,) their indices among its times
    root     index of the tree's root link;  height  (S,) [m] of its lowest point
    """
    schedule, figure = motion.clip.context.schedule, motion.clip.figure
    carrying = [(rest.first, rest.last) for rest in (*schedule.contacts.requested, *schedule.grasps)]
    name, lowest = figure.links[root].name, int(height.round(3).argmin())
    if BOUNDS["aloft"].most < height[lowest] < np.inf and not schedule.flights and not carrying:
        text = f"the figure never comes down: lowest point {height[lowest]:.2f} m above the floor"
        key = np.flatnonzero(motion.key_at == at[lowest])
        row = row_of("aloft", name, text)
        yield row, float(height[lowest]), float(samples.t[lowest]), int(key[0]) if key.size else None
        return
    if root not in figure.tables.free_links:
        return
    limits = Thresholds.of(figure)
    carried = RootWrench(samples, root).force[2] / max(weight(figure, root), 1e-9)
    is_explained = within((*carrying, *(schedule.specified_flights or ())), samples.t)
    for start, end in runs((height > limits.aloft) & ~is_explained):
        run = np.arange(start, end)
        t, top, key = samples.t[run], run[height[run].argmax()], None
        seconds = np.ptp(t) * np.mean(np.abs(carried[run]) >= CARRIED)
        if np.ptp(t) < limits.brief_flight or seconds < min(np.ptp(t) / 2, limits.push_off):
            continue
        keys = np.flatnonzero(np.isin(motion.key_at, at[run[carried[run] >= CARRIED]]))
        if keys.size:
            key = int(keys[height[np.searchsorted(at, motion.key_at[keys])].argmax()])
            top = int(np.searchsorted(at, motion.key_at[key]))
        text = f"the figure floats {{}} above the ground, for {np.ptp(t):.2f} s, and is not in free fall"
        yield row_of("float", name, text), float(height[top]), float(samples.t[top]), key


def _sliding(motion: Measurement, samples: Samples) -> Iterator[Excess]:
    """Yield intervals in which all points of a foot's sole move along the ground.

    The sole is on the ground, or it moves fast near the ground for longer than a landing takes. Intervals in which a
    point of the foot must not move have checks of their own.
    """
    context, figure = motion.clip.context, motion.clip.figure
    if not context.points:
        return
    limits = Thresholds.of(figure)
    links, positions, _ = arrays_of(context.points)
    speeds = np.linalg.norm(_velocities(samples, links, positions)[:2], axis=0)
    centres, radii = places_of(context.points, samples)
    height, _ = heights(context.surfaces, centres, radii)
    foot_of = feet_of(figure, context.points)
    feet, resting = foot_of[links], [target.stance for target, _ in motion.contact_targets]
    for foot in np.unique(feet):
        top, speed = height[feet == foot].max(axis=0), speeds[feet == foot].min(axis=0)
        rests = tuple((stance.first, stance.last) for stance in resting if foot_of[stance.point.link] == foot)
        slides = top < limits.swings
        for start, end in runs((top < limits.touching) & (speed > limits.dragged)):
            slides[start:end] |= np.ptp(samples.t[start:end]) >= limits.step
        for start, end in runs(slides & ~within(rests, samples.t)):
            places = centres[:2, feet == foot, start:end]
            distance = float(np.linalg.norm(places - places[..., :1], axis=0).min(axis=0).max())
            if distance > BOUNDS["slide"].most:
                name, fastest = figure.body_name(int(foot)), start + speed[start:end].argmax()
                text = f"{name} slides {{}} along the ground from {samples.t[start]:.2f} to {samples.t[end - 1]:.2f} s,"
                yield row_of("slide", name, f"{text} fastest"), distance, float(samples.t[fastest]), None


def _velocities(samples: Samples, links: Index, positions: Array) -> Array:
    """Return the velocities (3, P, S) [m/s] of points of links."""
    motion = samples.links
    _, offset = motion.points(links, positions)
    return motion.x_d[:, links] + cross(motion.omega[:, links], offset)
