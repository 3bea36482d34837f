"""What the ground does not carry: floating figures, sliding feet, missing forces, a centre of mass beside the feet.

Every point of the body and the soles that is near a surface may push, along the normal and by friction. The rest of the
force and moment at the root that a motion needs (eqs. 18 and 21 of the paper) is unsupported: a real figure falls.
Brief peaks are averaged, because captured motion has them as well.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dynsplines.solver.array import Array, Index, Mask, runs
from dynsplines.solver.contacts import Contact, within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import cross
from dynsplines.solver.figure.dynamics import RootWrench, Size, weight
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Support, closures
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.heights import FAR, height_over, heights
from dynsplines.solver.surface.points import Point, arrays_of, body_points, hanging, places_of
from dynsplines.solver.tolerances import TINY

from ..clip.posing.places import sphere_at
from ..motion import samples_at
from .bounds import BOUNDS, Bound, Violation, row_of
from .measurement import Measurement, feet_of, is_imported

WINDOW = 0.3  # [s] interval of an adult over which amounts are averaged
SLOW = 0.05  # [m/s] horizontal speed of the centre of mass of an adult below which it must be over the feet
DIRECTIONS = 64  # number of horizontal directions in which the support of the feet is compared with the centre of mass
# [1] smallest force of an unknown support relative to the weight, up or down; in free fall this force is zero
CARRIED = 0.5


def floating_and_sliding(motion: Measurement) -> Iterator[Violation]:
    """Yield figures and carried objects that float, and feet that slide or drag."""
    context, figure = motion.clip.context, motion.clip.figure
    if not context.surfaces or not np.any(figure.gravity):
        return
    at = np.union1d(motion.sparse, motion.key_at)
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
        if np.ptp(t) < limits.moment or seconds < min(np.ptp(t) / 2, limits.far_apart):
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
    feet, drags = feet_of(figure, points)[links], (height < limits.slight) & ~rests
    for foot in np.unique(feet):
        sole = np.flatnonzero(feet == foot)
        top, speed = height[sole].max(axis=0), speeds[sole].min(axis=0)
        slides = top < limits.near_surface
        for start, end in runs((top < limits.clear) & (speed > limits.travels)):
            slides[start:end] |= np.ptp(samples.t[start:end]) >= limits.shortly
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


def missing_support(motion: Measurement) -> Iterator[Violation]:
    """Yield forces and moments of trees on a free root that contacts cannot supply, and imbalance, even below bounds.

    The accelerations of a recording as imported are noise, so that only its balance is checked.
    """
    context, figure, path = motion.clip.context, motion.clip.figure, path_of(motion.timeline)
    window = WINDOW * Size.of(figure).time
    if not context.surfaces or not np.any(figure.gravity) or np.ptp(path.span) < window:
        return
    samples = samples_at(figure, path, motion.time[motion.sparse])
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
    feet = {point.link for point in motion.clip.context.points}  # their soles are wider and bend
    near = np.where([point.link in feet for point in points], limits.clear, limits.near_surface)
    touches: Mask = np.asarray(height < near[:, None])
    wrench = RootWrench(samples, root)
    size, speed = Size.of(figure), np.linalg.norm(np.gradient(wrench.centre[:2], t, axis=1), axis=0)
    is_slow = speed < SLOW * size.length / size.time
    amounts = {"unbalanced": is_slow * _beside(wrench.centre[:2], centres[:2], touches)}
    if not is_imported(motion.clip, motion.timeline):
        contacts = touching(samples, points, touches, up)
        air = [(t[first], t[end - 1]) for first, end in runs(np.asarray(~touches.any(axis=0)))]
        missing = Support.of(figure, root, contacts, air).stiff.rest(samples, wrench)
        amounts["unsupported"], amounts["toppling"] = (np.linalg.norm(part, axis=0) for part in np.split(missing, 2))
    texts = {
        "unsupported": "contacts cannot supply a force of {{}} of the weight, for {:.2f} s, worst",
        "toppling": "contacts cannot supply a moment of {{}} of weight times height, for {:.2f} s, worst",
        "unbalanced": "the centre of mass of the standing figure is {{}} beside its contacts, for {:.2f} s, worst",
    }
    explained = _is_explained(motion, samples, limits.clear)
    aloft = ~touches.any(axis=0) & ~within(motion.clip.context.schedule.specified_flights or (), t)
    for start, end in runs(aloft):
        explained[start:end] |= np.ptp(t[start:end]) >= limits.moment  # reported as `float`
    for kind, amount in amounts.items():
        amount = np.where(explained, 0.0, amount)
        mean = _average(amount, t, window)
        worst, bound = int(mean.argmax()), BOUNDS[kind].most
        if mean[worst] > 0:
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
