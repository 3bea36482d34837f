"""Forces that nothing carries: what contacts cannot supply, and a centre of mass beside the feet.

Every point of the body and the soles that is near a surface may push, along the normal and by friction. The rest of the
force and moment at the root that a motion needs (eqs. 18 and 21 of the paper) is unsupported: a real figure falls.
Brief peaks are averaged, because captured motion has them as well.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dynsplines.solver.array import Array, Mask, runs
from dynsplines.solver.contacts import Contact, within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import RootWrench, Size
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Support, closures
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import Point, body_points, hanging, places_of

from ..motion import even_times, samples_at
from .bounds import BOUNDS, Violation, row_of
from .measurement import Measurement, is_imported

RATE = 60.0  # [1/s] samples of the motion
WINDOW = 0.3  # [s] interval of an adult over which amounts are averaged
SLOW = 0.05  # [m/s] horizontal speed of the centre of mass of an adult below which it must be over the feet
DIRECTIONS = 64  # number of horizontal directions in which the support of the feet is compared with the centre of mass


def missing_support(motion: Measurement) -> Iterator[Violation]:
    """Yield forces and moments of trees on a free root that contacts cannot supply, and trees out of balance.

    The accelerations of a recording as imported are noise, so that it yields none.
    """
    context, figure, path = motion.clip.context, motion.clip.figure, path_of(motion.timeline)
    window = WINDOW * Size.of(figure).time
    if (
        is_imported(motion.clip, motion.timeline)
        or not context.surfaces
        or not np.any(figure.gravity)
        or np.ptp(path.span) < window
    ):
        return
    samples = samples_at(figure, path, even_times(path.span, RATE))
    held_by_loops = {link for loop in closures(figure) for link in (loop.point.link, loop.on)}
    for root in figure.tables.free_links.tolist():
        tree = set(np.flatnonzero(figure.tables.path[:, root]).tolist())
        points = hanging(figure, root, (*context.points, *body_points(figure)))
        if figure.tables.children[root] and points and not (tree & held_by_loops and held_by_loops - tree):
            yield from _of_tree(motion, samples, root, points, window)


def _of_tree(
    motion: Measurement, samples: Samples, root: int, points: Sequence[Point], window: float
) -> Iterator[Violation]:
    """Yield the largest missing force, missing moment and imbalance of a tree, by its points."""
    figure, t, limits = motion.clip.figure, samples.t, Thresholds.of(motion.clip.figure)
    centres, radii = places_of(points, samples)
    height, up = height_over(motion.clip.context.surfaces, centres, radii)
    touches: Mask = np.asarray(height < limits.clear)
    contacts = touching(samples, points, touches, up)
    air = [(t[first], t[end - 1]) for first, end in runs(np.asarray(~touches.any(axis=0)))]
    wrench = RootWrench(samples, root)
    missing = Support.of(figure, root, contacts, air).stiff.rest(samples, wrench)
    size, speed = Size.of(figure), np.linalg.norm(np.gradient(wrench.centre[:2], t, axis=1), axis=0)
    amounts = {
        "unsupported": np.linalg.norm(missing[:3], axis=0),
        "toppling": np.linalg.norm(missing[3:], axis=0),
        "unbalanced": (speed < SLOW * size.length / size.time) * _beside(wrench.centre[:2], centres[:2], touches),
    }
    texts = {
        "unsupported": "contacts cannot supply a force of {{}} of the weight, for {:.2f} s, worst",
        "toppling": "contacts cannot supply a moment of {{}} of weight times height, for {:.2f} s, worst",
        "unbalanced": "the centre of mass of the standing figure is {{}} beside its contacts, for {:.2f} s, worst",
    }
    explained = _is_explained(motion, samples, limits.clear)
    explained |= ~touches.any(axis=0) & ~within(motion.clip.context.schedule.specified_flights or (), t)  # see `float`
    for kind, amount in amounts.items():
        amount = np.where(explained, 0.0, amount)
        mean = _average(amount, t, window)
        worst, bound = int(mean.argmax()), BOUNDS[kind].most
        if mean[worst] > bound:
            seconds = (t[1] - t[0]) * np.count_nonzero(amount > bound)
            row = row_of(kind, figure.links[root].name, texts[kind].format(seconds))
            yield row.violation(float(mean[worst]), float(t[worst]))


def touching(samples: Samples, points: Sequence[Point], touches: Mask, up: Array) -> list[Contact]:
    """Return the contacts of points (n,) at the samples at which they touch a surface, (n, S), with normals (3, n, S).

    A contact is at the spot below the point in the middle of the run of samples.
    """
    contacts = list[Contact]()
    for i, point in enumerate(points):
        for first, end in runs(touches[i]):
            middle = (first + end) // 2
            normal = up[:, i, middle]
            below = samples.links.rotation[:, :, point.link, middle].T @ (point.radius * normal)
            spot = Point(point.name, point.link, point.position - below)
            plane = Plane("ground", np.zeros(3), normal)
            contacts.append(Contact(spot, samples.t[first], samples.t[end - 1], surface=plane))
    return contacts


def _beside(centre: Array, places: Array, touches: Mask) -> Array:
    """Return the horizontal distance (S,) [m] of a centre (2, S) from the convex hull of the points (2, n, S) that
    touch, (n, S); zero inside and where none touches."""
    angles = 2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS
    directions = np.stack([np.cos(angles), np.sin(angles)])
    along = np.einsum("ad,ans->dns", directions, places - centre[:, None])
    reach = np.where(touches, along, -np.inf).max(axis=1)
    return np.where(touches.any(axis=0), np.maximum(-reach.min(axis=0), 0.0), 0.0)


def _average(amount: Array, t: Array, window: float) -> Array:
    """Return the mean (S,) of an amount (S,) at equally spaced times (S,) over a window [s] around each; zero nearer
    to an end than half of it."""
    count = max(1, round(window / float(t[1] - t[0])))
    mean = np.convolve(amount, np.full(count, 1 / count), "valid")
    return np.pad(mean, (count // 2, amount.size - mean.size - count // 2))


def _is_explained(motion: Measurement, samples: Samples, clear: float) -> Mask:
    """Return at which samples (S,) a specified contact away from the ground may carry the figure, or the hand of
    another figure."""
    schedule = motion.clip.context.schedule
    contacts = (*schedule.on_ground, *schedule.grasps)
    if not contacts:
        return np.zeros(samples.count, bool)
    centres, radii = places_of([contact.point for contact in contacts], samples)
    height, _ = height_over(schedule.surfaces, centres, radii)
    during = np.array([contact.during(samples.t) for contact in contacts])
    return np.asarray((during & (height > clear)).any(axis=0))
