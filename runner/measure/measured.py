"""What is measured of a motion, a record each: its name in a report, how it is found, how it is shown.

A new measure is a function and a record here, and a function in `shown`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import generalised_forces
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrench import RootWrench
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import (
    BendLimits,
    Closed,
    Coupled,
    JointRange,
    Placement,
    Rolling,
    SelfContact,
    carried_links,
    closures,
    couplings,
    joint_ranges,
    slipped,
    stances,
    within,
)
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.points import places_of
from dynsplines.solver.surface.touch import counts_all

from ..clip.build import Clip
from ..motion import continuous, samples_at
from . import shown
from .depths import depth
from .exactness import keyframe_error
from .penetration import lowest, moving_geoms, penetration, self_penetration
from .shown import Line
from .swings import swings

RESTING = 0.01  # [m] from a surface, up to which a point that moves skates
LEAST_STANCE = 0.05  # [s]: shorter, and two images of a recording stand next to each other, and no foot
RATE = 1000.0  # [1/s], between the samples that the optimiser saw
STIFF = 1e-7  # softness of what supports: what is left then is what cannot be supplied


@dataclass(frozen=True)
class Grid:
    """One motion on the fine grid: times (T,) [s], samples, qpos (T, nq)."""

    time: Array
    samples: Samples
    qpos: Array

    @classmethod
    def of(cls, clip: Clip, timeline: Timeline, rate: float = RATE) -> Grid:
        first, last = float(timeline.times[0]), float(timeline.times[-1])
        time = np.linspace(first, last, max(2, round((last - first) * rate) + 1))
        samples = samples_at(clip.figure, path_of(timeline), time)
        return cls(time, samples, continuous(clip.figure, clip.figure.to_qpos(samples.y)))


@dataclass(frozen=True, eq=False)
class Seen:
    """One side of a report: a timeline that answers a clip, and its motion on the grid."""

    clip: Clip
    objective: Objective
    timeline: Timeline
    grid: Grid

    @cached_property
    def parts(self) -> list[tuple[str, float]]:
        """Every term's part of E."""
        terms = self.objective.terms
        values = self.objective.integrals(path_of(self.timeline))
        return [(t.penalty.name, float(t.factor * v)) for t, v in zip(terms, values, strict=True)]


@dataclass(frozen=True)
class Measured:
    """One measure.

    name     its key in a report, with the unit
    compute  a plain value, of one side; None where there is nothing of the kind, and the key is left out
    lines    what a screen shows of both sides' values
    """

    name: str
    compute: Callable[[Seen], Any]
    lines: Callable[[Any, Any], Iterator[Line]]


def side(seen: Seen) -> dict[str, Any]:
    """All that is measured of one side, by name."""
    found = {measured.name: measured.compute(seen) for measured in MEASURES}
    return {name: value for name, value in found.items() if value is not None}


def lines(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """What a screen shows of two sides, in the order of the records."""
    for measured in MEASURES:
        if measured.name in after:
            yield from measured.lines(before.get(measured.name), after[measured.name])


def _penetration(seen: Seen) -> dict[str, Any]:
    model, grid = seen.clip.figure.model, seen.grid
    deep = penetration(model, grid.time, grid.qpos)
    order = [int(i) for i in np.argsort(-deep.depth, kind="stable") if deep.depth[i] > 0]
    return {
        "deepest": deep.deepest,
        "where": deep.worst(),
        "geoms": {deep.names[i]: float(deep.depth[i]) for i in order},
        "points": _point_depths(seen.clip, grid),
        "all geoms count": counts_all(model),
    }


def _heights(clip: Clip, grid: Grid) -> Array:
    """(n, T) height of the contact points over the surface below them [m]."""
    centres, _, _ = places_of(clip.context.points, grid.samples)
    return np.min([surface.height(centres) for surface in clip.context.surfaces], axis=0)


def _point_depths(clip: Clip, grid: Grid) -> dict[str, float]:
    if not clip.context.points or not clip.context.surfaces:
        return {}
    centres, _, _ = places_of(clip.context.points, grid.samples)
    radii = np.array([point.radius for point in clip.context.points])
    found = [depth(surface, centres, radii) for surface in clip.context.surfaces]
    deepest = np.maximum(np.max(found, axis=0), 0.0).max(axis=1)
    return {point.name: float(d) for point, d in zip(clip.context.points, deepest, strict=True)}


def _bend_report(clip: Clip, grid: Grid) -> dict[str, dict[str, float]]:
    if not clip.context.bends:
        return {}
    flexion, sideways, twist = np.degrees(BendLimits(clip.context.bends).angles(grid.samples))
    return {
        bend.name: {
            "backward": float(max(0.0, -flexion[i].min())),
            "sideways": float(np.abs(sideways[i]).max()),
            "twist": float(np.abs(twist[i]).max()),
        }
        for i, bend in enumerate(clip.context.bends)
    }


def _self_report(clip: Clip, grid: Grid) -> dict[str, Any]:
    """The deepest that limbs are in the trunk or in each other; empty without `self` of `collision`."""
    for penalty, _ in clip.penalties:
        if isinstance(penalty, SelfContact):
            deepest, where = self_penetration(clip.figure.model, penalty.geom_pairs, grid.time, grid.qpos)
            return {"deepest": deepest, "where": where}
    return {}


def _range_report(clip: Clip, grid: Grid) -> dict[str, Any]:
    """Which joint is how far beyond its range, in degrees or for slides in metres; empty without limited joints."""
    ranges = joint_ranges(clip.figure)
    if not ranges:
        return {}
    beyond = np.maximum(JointRange(ranges).beyond(grid.samples), 0)
    joint, at = np.unravel_index(beyond.argmax(), beyond.shape)
    worst, far = ranges[int(joint)], float(beyond[joint, at])
    slides = worst.kind is JointKind.SLIDE
    return {
        "joint": worst.name,
        "at, s": float(grid.time[at]),
        "most": far if slides else float(np.degrees(far)),
        "unit": "m" if slides else "degrees",
    }


def _equality_report(clip: Clip, grid: Grid) -> dict[str, Any]:
    """How far joints are off what they follow, in degrees or metres, and points of closed loops apart, in metres."""
    joined, loops = couplings(clip.figure), closures(clip.figure)
    out: dict[str, Any] = {}
    if joined:
        away = np.abs(Coupled(joined).away(grid.samples)[0]).max(axis=1)
        away = np.array([np.degrees(a) if c.unit == "degrees" else a for c, a in zip(joined, away, strict=True)])
        worst = int(np.argmax(away))
        out["coupled"] = {"joint": joined[worst].name, "most": float(away[worst]), "unit": joined[worst].unit}
    if loops:
        apart = np.linalg.norm(Closed(loops).apart(grid.samples), axis=0).max(axis=1)
        out["closed"] = {"loop": loops[int(np.argmax(apart))].name, "most, m": float(apart.max())}
    return out


def _skate(clip: Clip, grid: Grid) -> dict[str, dict[str, float]]:
    """Horizontal path of each contact point while within 1 cm of its surface, and its mean speed there."""
    if not clip.context.points or not clip.context.surfaces:
        return {}
    centres, _, _ = places_of(clip.context.points, grid.samples)
    low = np.abs(_heights(clip, grid)) < RESTING
    steps = np.linalg.norm(np.diff(centres[:2], axis=2), axis=0)
    together = low[:, 1:] & low[:, :-1]
    pace = np.diff(grid.time)
    out = {}
    for i, point in enumerate(clip.context.points):
        length, rest = float(steps[i, together[i]].sum()), float(pace[together[i]].sum())
        out[point.name] = {"path, m": length, "speed, m/s": length / rest if rest > 0 else 0.0, "rest, s": rest}
    return out


def _stance_report(clip: Clip, timeline: Timeline) -> list[dict[str, Any]]:
    """Every foot that two neighbouring keyframes plant for a while: how high its lowest geom rises, and its slide."""
    keys = _key_timeline(clip, timeline)
    found = [
        s
        for s in stances(clip.figure, keys, clip.context.points, clip.context.surfaces)
        if s.last - s.first > LEAST_STANCE
    ]
    groups: dict[tuple[float, float, int], list[Any]] = {}
    for stance in found:
        groups.setdefault((stance.first, stance.last, stance.point.link), []).append(stance)
    out = []
    for (first, last, link), group in groups.items():
        time = np.linspace(first, last, max(2, round((last - first) * RATE)))
        samples = samples_at(clip.figure, path_of(timeline), time)
        height = lowest(clip.figure.model, clip.figure.to_qpos(samples.y), clip.figure.links[link].body)
        centres, _, _ = places_of(tuple(stance.point for stance in group), samples)
        slide = max(
            float(np.linalg.norm((centres[:, i] - stance.place(time))[:2], axis=0).max())
            for i, stance in enumerate(group)
        )
        names = " and ".join(stance.point.name for stance in group)
        lift = float(height.max())
        out.append({"points": names, "from, s": first, "to, s": last, "lift, m": lift, "slide, m": slide})
    return out


def _contact_report(clip: Clip, timeline: Timeline) -> list[dict[str, Any]]:
    """Every contact that the clip gives: how far its point gets from where it is in the middle of it, and its path."""
    out = []
    for rest in clip.context.contacts.given:
        time = np.linspace(rest.first, rest.last, max(3, round((rest.last - rest.first) * RATE)))
        samples = samples_at(clip.figure, path_of(timeline), time)
        centres, _, _ = places_of((rest.point,), samples)
        turned = samples.links.Q[:, rest.point.link]
        track = centres[:, 0] - Rolling.of(rest, turned[:, time.size // 2]).way(turned)
        moved = float(np.linalg.norm(track - track[:, [time.size // 2]], axis=0).max())
        path = float(np.linalg.norm(np.diff(track, axis=1), axis=0).sum())
        speed = path / (rest.last - rest.first)
        told = {"point": rest.point.name, "from, s": rest.first, "to, s": rest.last}
        out.append(told | {"moved, m": moved, "path, m": path, "speed, m/s": speed})
    return out


def _placement_report(clip: Clip, timeline: Timeline) -> dict[str, float]:
    """How far every point that the search was to place is from there, at its time."""
    out: dict[str, float] = {}
    for point in clip.context.placed:
        samples = samples_at(clip.figure, path_of(timeline), np.array([point.time]))
        _, away = Placement((point,)).away(samples)
        out[f"{point.point.name} at {point.time:g} s"] = float(np.linalg.norm(away))
    return out


def hold_rows(clip: Clip, timeline: Timeline, rate: float) -> list[dict[str, Any]]:
    """Every hold that the clip gives: how far its site gets on the body from where it was when it took hold, on a grid
    of so many times a second."""
    out = []
    for hold in clip.context.holds:
        time = np.linspace(hold.first, hold.last, max(3, round((hold.last - hold.first) * rate)))
        track = slipped(samples_at(clip.figure, path_of(timeline), time), hold)
        moved = np.linalg.norm(track - track[:, :1], axis=0)
        told = {"hand": hold.point.name, "body": hold.body, "from, s": hold.first, "to, s": hold.last}
        out.append(told | {"moved, m": float(moved.max()), "at, s": float(time[int(moved.argmax())])})
    return out


def in_carried(clip: Clip, time: Array, qpos: Array) -> dict[str, Any]:
    """The deepest that the figure is in what it carries along qpos (T, nq), by MuJoCo; empty if it holds nothing."""
    model, links = clip.figure.model, carried_links(clip.figure, clip.context.holds)
    if not links:
        return {}
    movers = np.array(moving_geoms(model), np.intp)
    is_carried = np.isin(clip.figure.body_link[model.geom_bodyid[movers]], links)
    pairs = np.array(np.meshgrid(movers[~is_carried], movers[is_carried])).reshape(2, -1)
    deepest, where = self_penetration(model, pairs, time, qpos)
    return {"deepest": deepest, "where": where}


def _key_timeline(clip: Clip, timeline: Timeline) -> Timeline:
    """The keyframes alone, partial ones as the motion fills them."""
    times = np.array([key.time for key in clip.keys])
    at = np.searchsorted(timeline.times, times - 1e-9)
    return Timeline(tuple(timeline.frames[i] for i in at), np.zeros((2, timeline.width)))


def _edge_clearance(clip: Clip, grid: Grid) -> dict[str, float]:
    """Height of a foot's lowest contact point over a box's top when the foot's middle crosses the box's front edge."""
    out: dict[str, float] = {}
    for box in (surface for surface in clip.context.surfaces if isinstance(surface, Box)):
        edge = box.centre[0] - np.abs(box.axes[0]) @ box.half
        top = box.centre[2] + np.abs(box.axes[2]) @ box.half
        for link in sorted({point.link for point in clip.context.points}):
            points = tuple(point for point in clip.context.points if point.link == link)
            centres, _, _ = places_of(points, grid.samples)
            middle = centres[0].mean(axis=0)
            for i in np.flatnonzero((middle[:-1] < edge) & (middle[1:] >= edge)):
                name = f"{clip.figure.links[link].name} over {box.name} at {grid.time[i]:.2f} s"
                out[name] = float(centres[2, :, i].min() - top)
    return out


def _unit_deviation(grid: Grid) -> dict[str, float]:
    length = np.linalg.norm(grid.samples.q, axis=0)
    if not length.size:
        return {"shortest": 1.0, "longest": 1.0, "largest": 0.0}
    return {
        "shortest": float(length.min()),
        "longest": float(length.max()),
        "largest": float(np.abs(length - 1).max()),
    }


def _seam(clip: Clip, timeline: Timeline) -> dict[str, Any] | None:
    """How far a loop's root travels and turns in a period, and by how far y, y', y'' at its end are off; None where
    there is no loop."""
    if timeline.ends != "periodic":
        return None
    seam = Seam.of(clip.figure, timeline)
    roots = clip.figure.tables.position_columns
    position, velocity, acceleration = map(float, seam.apart(path_of(timeline)))
    mismatch = {"state": position, "first derivative": velocity, "second derivative": acceleration}
    travel = seam.travel[roots[:, 0]].tolist() if roots.size else []
    turn = {"turn, degrees": float(np.degrees(seam.headings[0]))} if seam.turns else {}
    return {"travel, m": travel, **turn, **mismatch}


def _peak_acceleration(grid: Grid) -> dict[str, Any]:
    """Largest angular acceleration of a joint: of a link relative to its parent."""
    links, figure = grid.samples.links, grid.samples.figure
    relative = np.linalg.norm(links.alpha - links.alpha[:, figure.tables.parents], axis=0)
    kinds = np.array([link.kind in (JointKind.BALL, JointKind.HINGE) and i > 0 for i, link in enumerate(figure.links)])
    if not kinds.any():
        return {"peak": 0.0, "joint": "", "at, s": 0.0}
    relative[~kinds] = 0
    link, at = np.unravel_index(relative.argmax(), relative.shape)
    return {"peak": float(relative.max()), "joint": figure.links[int(link)].name, "at, s": float(grid.time[at])}


def _torque(grid: Grid) -> dict[str, Any]:
    """Joint torques by inverse dynamics, and the wrench that the ground would have to supply at the roots.

    root mean square  over time, of the norm of the torques of all balls and hinges together
    """
    figure = grid.samples.figure
    forces = generalised_forces(grid.samples)
    roots = [link.dof for link in figure.links[1:] if link.kind is JointKind.FREE]
    sizes = {JointKind.BALL: 3, JointKind.HINGE: 1}
    turning = [link.dof + k for link in figure.links[1:] for k in range(sizes.get(link.kind, 0))]
    joints = np.linalg.norm(forces[:, turning], axis=1)
    peaks = {
        link.name: float(np.linalg.norm(forces[:, link.dof : link.dof + sizes[link.kind]], axis=1).max())
        for link in figure.links[1:]
        if link.kind in sizes
    }
    strongest = max(peaks, key=lambda name: peaks[name], default="")
    root = [np.linalg.norm(forces[:, dof : dof + 3], axis=1).max() for dof in roots]
    return {
        "root mean square": float(np.sqrt(np.mean(joints**2))),
        "peak of one joint": peaks.get(strongest, 0.0),
        "joint": strongest,
        "peak root force": float(max(root, default=0.0)),
    }


def _support(clip: Clip, grid: Grid) -> dict[str, float]:
    """What moves the figure from outside although nothing can push: in flight, and beyond what its footings supply."""
    if clip.context.support is None or not clip.context.support.tells:
        return {}
    # stiff, so that what is left is what cannot be supplied, and not what would cost force
    carried = replace(clip.context.support, softness=STIFF)
    rest = carried.rest(grid.samples)[:, carried.known(grid.time)]
    force = np.linalg.norm(rest[:3], axis=0)
    out = {"root mean square": float(np.sqrt(np.mean(force**2)))}
    out["moment, root mean square"] = float(np.sqrt(np.mean(np.sum(rest[3:] ** 2, axis=0))))
    aloft = within(carried.flights, grid.time)
    if aloft.any():
        wrench = RootWrench(grid.samples, carried.root)
        up = -clip.figure.gravity / max(float(np.linalg.norm(clip.figure.gravity)), 1e-12)
        lifted = np.maximum(up @ wrench.force[:, aloft], 0)
        out["off free fall, g"] = float(np.mean(np.linalg.norm(wrench.force[:, aloft], axis=0)) / carried.unit)
        out["upward force in flight, N"] = float(np.mean(lifted))
        out["largest upward force in flight, N"] = float(lifted.max())
    return out


MEASURES = (
    Measured("objective", lambda s: sum(value for _, value in s.parts), shown.objective),
    Measured("terms", lambda s: dict(s.parts), shown.terms),
    Measured("penetration, m", _penetration, shown.penetration),
    Measured("self-penetration, m", lambda s: _self_report(s.clip, s.grid), shown.in_itself),
    Measured("bends, degrees", lambda s: _bend_report(s.clip, s.grid), shown.bends),
    Measured("beyond joint range", lambda s: _range_report(s.clip, s.grid), shown.ranges),
    Measured("equality constraints", lambda s: _equality_report(s.clip, s.grid), shown.equalities),
    Measured("skate", lambda s: _skate(s.clip, s.grid), shown.skate),
    Measured("stances", lambda s: _stance_report(s.clip, s.timeline), shown.stances),
    Measured("swings", lambda s: swings(s.clip, s.grid.samples), shown.swings),
    Measured("contacts", lambda s: _contact_report(s.clip, s.timeline), shown.contacts),
    Measured("holds", lambda s: hold_rows(s.clip, s.timeline, RATE), shown.holds),
    Measured("in what is carried, m", lambda s: in_carried(s.clip, s.grid.time, s.grid.qpos), shown.in_carried),
    Measured("off their places, m", lambda s: _placement_report(s.clip, s.timeline), shown.off_their_places),
    Measured("edge clearance, m", lambda s: _edge_clearance(s.clip, s.grid), shown.edge_clearance),
    Measured("unit deviation", lambda s: _unit_deviation(s.grid), shown.lengths),
    Measured("keyframe error", lambda s: keyframe_error(s.clip, s.timeline), shown.keyframe_error),
    Measured("seam", lambda s: _seam(s.clip, s.timeline), shown.seam),
    Measured("angular acceleration, rad/s²", lambda s: _peak_acceleration(s.grid), shown.peak),
    Measured("torque, N m", lambda s: _torque(s.grid), shown.torque),
    Measured("support", lambda s: _support(s.clip, s.grid), shown.support),
)
