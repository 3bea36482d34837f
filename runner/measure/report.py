"""What a motion is like, before and after, on a 1 kHz grid: *between* the samples that the optimiser saw.

Everything here is a plain dict, so that it goes into JSON, into the motion file and on to the screen alike.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from rich.console import Group
from rich.table import Table
from rich.text import Text

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import turned
from dynsplines.solver.figure.dynamics import generalised_forces
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrench import RootWrench
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import (
    BendLimits,
    Closed,
    Coupled,
    Cycle,
    JointRange,
    Placement,
    SelfContact,
    closures,
    couplings,
    joint_ranges,
    stances,
    within,
)
from dynsplines.solver.refine.displacement import displacement
from dynsplines.solver.refine.euler_lagrange import residual
from dynsplines.solver.refine.subdivision import by_weak_form
from dynsplines.solver.solution import Solution
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.points import places_of
from dynsplines.solver.surface.touch import counts_all

from ..clip.load import Clip
from ..motion import continuous, samples_at
from .exactness import keyframe_error
from .hold_report import hold_rows, in_carried
from .penetration import lowest, penetration, self_penetration
from .problems import plain, problems
from .swings import swings
from .swings import words as swing_words

RATE = 1000.0  # [1/s], between the samples that the optimiser saw
LOCAL_EVALUATIONS = 25  # that tell what a segment has left to gain
LOCAL_TOLERANCE = 1e-4  # of a segment's E; what is left is known to a tenth, in a quarter of the time that 1e-7 takes
RESTING = 0.01
LEAST_STANCE = 0.05  # [s]: shorter, and two images of a recording stand next to each other, and no foot
STIFF = 1e-7


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


def report(
    clip: Clip, motion: Solution, seconds: float | None, told: Callable[[int, int], None] | None = None
) -> dict[str, Any]:
    """The whole report of a solved clip; `seconds` is what the solve took, where that is known; `told`
    hears of the local solves' progress.

    Ctrl-C leaves out the segments, which take longest, and nothing else. Nothing was searched of a recording: it has no
    segments and nothing left to gain, and is measured once for both sides.
    """
    before, searched = Grid.of(clip, motion.raw), not motion.is_raw
    after = Grid.of(clip, motion.timeline) if searched else before
    first = _side(clip, motion.objective, motion.raw, before)
    sides = {
        "before": first,
        "after": _side(clip, motion.objective, motion.timeline, after) if searched else dict(first),
    }
    drift = np.linalg.norm(_centre_of_mass(after.samples) - _centre_of_mass(before.samples), axis=0)
    sides["after"]["centre of mass off before, m"] = {
        "largest": float(drift.max()),
        "away from trouble": float(drift[_far_from_trouble(clip, before)].max(initial=0.0)),
    }
    return {
        "problems": plain(problems(clip, motion.timeline, motion.raw, motion.stop)),
        "clip": clip.name,
        "duration, s": float(before.time[-1] - before.time[0]),
        "left to gain": _left_to_gain(motion) if searched else {},
        "keyframes": len(clip.keys),
        "partial keyframes": sum(not key.is_key for key in clip.keys),
        "variable frames": motion.timeline.variable_count,
        "evaluations": motion.evaluations,
        **({} if seconds is None else {"seconds": seconds}),
        "stopped because": motion.stop.value,
        "cycle": _cycle_report(clip),
        "segments": _segments(clip, motion, told) if searched else [],
        **sides,
    }


def _cycle_report(clip: Clip) -> dict[str, float]:
    """The cycle that the motion is drawn to, and how sure it is; empty where there is none.

    gain   log-likelihood of the keyframes over that of the best smooth motion, per number that they give
    slip   speed of feet that are low, along the cycle, as a share of the travel; left out where nothing travels
    trust  how many times the variance of the spline through the keyframes, about the cycle, is the cycle's own
    """
    rhythm = next((penalty.rhythm for penalty, _ in clip.penalties if isinstance(penalty, Cycle)), None)
    if rhythm is None:
        return {}
    found = {"period, s": rhythm.period, "gain": rhythm.gain, "trust": float(rhythm.trust.mean())}
    return found | ({} if np.isnan(rhythm.slip) else {"slip": rhythm.slip})


def _side(clip: Clip, objective: Objective, timeline: Timeline, grid: Grid) -> dict[str, Any]:
    model = clip.figure.model
    deep = penetration(model, grid.time, grid.qpos)
    order = [int(i) for i in np.argsort(-deep.depth, kind="stable") if deep.depth[i] > 0]
    parts = objective.integrals(path_of(timeline))
    names = [term.penalty.name for term in objective.terms]
    return {
        "objective": float(sum(t.factor * v for t, v in zip(objective.terms, parts, strict=True))),
        "terms": {n: float(t.factor * v) for n, t, v in zip(names, objective.terms, parts, strict=True)},
        "penetration, m": {
            "deepest": deep.deepest,
            "where": deep.worst(),
            "geoms": {deep.names[i]: float(deep.depth[i]) for i in order},
            "points": _point_depths(clip, grid),
            "all geoms count": counts_all(model),
        },
        "self-penetration, m": _self_report(clip, grid),
        "bends, degrees": _bend_report(clip, grid),
        "beyond joint range": _range_report(clip, grid),
        "equality constraints": _equality_report(clip, grid),
        "skate": _skate(clip, grid),
        "stances": _stance_report(clip, timeline),
        "swings": swings(clip, grid.samples),
        "contacts": _contact_report(clip, timeline),
        "holds": hold_rows(clip, timeline, RATE),
        "in what is carried, m": in_carried(clip, grid.time, grid.qpos),
        "off their places, m": _placement_report(clip, timeline),
        "edge clearance, m": _edge_clearance(clip, grid),
        "unit deviation": _unit_deviation(grid),
        "keyframe error": keyframe_error(clip, timeline),
        **_seam(clip, timeline),
        "angular acceleration, rad/s²": _peak_acceleration(grid),
        "torque, N m": _torque(grid),
        "support": _support(clip, grid),
    }


def _heights(clip: Clip, grid: Grid) -> Array:
    """(n, T) height of the contact points over the surface below them [m]."""
    centres, _, _ = places_of(clip.context.points, grid.samples)
    return np.min([surface.height(centres) for surface in clip.context.surfaces], axis=0)


def _point_depths(clip: Clip, grid: Grid) -> dict[str, float]:
    if not clip.context.points or not clip.context.surfaces:
        return {}
    centres, _, _ = places_of(clip.context.points, grid.samples)
    depth = np.max([surface.inside(centres) for surface in clip.context.surfaces], axis=0)
    return {point.name: float(d) for point, d in zip(clip.context.points, depth.max(axis=1), strict=True)}


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
    """The deepest that limbs are in the trunk or in each other; empty unless the clip asks for `self`."""
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
        centres, _, _ = places_of((rest.point,), samples_at(clip.figure, path_of(timeline), time))
        track = centres[:, 0]
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


def _seam(clip: Clip, timeline: Timeline) -> dict[str, Any]:
    """How far a loop's root travels and turns in a period, and by how far y, y', y'' at its end are off."""
    if timeline.ends != "periodic":
        return {}
    seam = Seam.of(clip.figure, timeline)
    roots = clip.figure.tables.position_columns
    position, velocity, acceleration = map(float, seam.apart(path_of(timeline)))
    mismatch = {"state": position, "first derivative": velocity, "second derivative": acceleration}
    travel = seam.travel[roots[:, 0]].tolist() if roots.size else []
    turn = {"turn, degrees": float(np.degrees(seam.headings[0]))} if seam.turns else {}
    return {"seam": {"travel, m": travel, **turn, **mismatch}}


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


def _centre_of_mass(samples: Samples) -> Array:
    """(3, T) [m] of the whole figure."""
    tables = samples.figure.tables
    centres = samples.links.x + turned(samples.links.rotation, tables.centre)
    return np.einsum("l,cls->cs", tables.mass, centres) / max(float(tables.mass.sum()), 1e-12)


def _far_from_trouble(clip: Clip, before: Grid, margin: float = 0.25) -> Mask:
    """Times at least `margin` [s] away from any at which the raw motion is in a box."""
    boxes = [surface for surface in clip.context.surfaces if isinstance(surface, Box)]
    inside = np.zeros(before.time.size, bool)
    if boxes and clip.context.points:
        centres, _, _ = places_of(clip.context.points, before.samples)
        for box in boxes:
            inside |= (box.inside(centres) > 0).any(axis=0)
    bad = before.time[inside]
    if not bad.size:
        return np.ones(before.time.size, bool)
    after = np.searchsorted(bad, before.time)
    gaps = np.abs([before.time - bad[np.maximum(after - 1, 0)], before.time - bad[np.minimum(after, bad.size - 1)]])
    return gaps.min(axis=0) > margin


def _left_to_gain(motion: Solution) -> dict[str, float]:
    """About how far E is above its optimum: what frames in the middle of all segments promise, summed (weak form)."""
    promised = float(by_weak_form(motion.objective, motion.timeline).sum())
    value = motion.objective.value(motion.path)
    return {"objective": promised, "share": promised / value if value > 0 else 0.0}


def _segments(clip: Clip, motion: Solution, told: Callable[[int, int], None] | None) -> list[dict[str, float]]:
    """Per segment between keyframes: EL deviation before and after, δ and what a local solve says is left (app. C)."""
    try:
        left = displacement(
            motion.objective,
            motion.timeline,
            max_evaluations=LOCAL_EVALUATIONS,
            tolerance=LOCAL_TOLERANCE,
            told=told,
        )
    except KeyboardInterrupt:
        return []
    after = residual(motion.objective, path_of(motion.timeline)).deviation()
    before = residual(motion.objective, path_of(motion.raw)).deviation()
    times = np.array([key.time for key in clip.keys])
    own = np.clip(np.searchsorted(times, motion.timeline.times[:-1] + 1e-9) - 1, 0, times.size - 2)
    sums = {
        "deviation after": after,
        "delta": left.distance,
        "delta · EL": left.gap,
        "left": left.found,
    }
    rows = []
    for i in range(times.size - 1):
        row = {"from, s": float(times[i]), "to, s": float(times[i + 1]), "deviation before": float(before[i])}
        row |= {name: float(values[own == i].sum()) for name, values in sums.items()}
        row["variable frames"] = float((own == i).sum() - 1)
        rows.append(row)
    return rows


def tables(data: dict[str, Any]) -> Group:
    """The report for a screen."""
    before, after = data["before"], data["after"]
    gain = (
        f"; about {data['left to gain']['share']:.1%} of the objective is left to gain" if data["left to gain"] else ""
    )
    took = f" in {data['seconds']:.2f} s" if "seconds" in data else ""
    head = (
        f"{data['clip']}: {data['duration, s']:.2f} s, {data['keyframes']} keyframes "
        f"({data['partial keyframes']} partial), {data['variable frames']} variable frames; "
        f"{data['evaluations']} evaluations{took}; {data['stopped because']}"
        f"{gain}{_cycle_words(data)}"
    )
    searched = bool(data["left to gain"])
    sides = ("before", "after") if searched else ("recording",)
    main = Table("measure", *sides, title="on a 1 kHz grid", title_justify="left")
    for name, one, two in _lines(before, after):
        main.add_row(name, *((one, two) if searched else (two,)))
    segments = Table("segment, s", "EL before", "EL after", "δ", "δ · EL", "left", "variable", title="segments")
    for row in data["segments"]:
        segments.add_row(
            f"{row['from, s']:.2f} - {row['to, s']:.2f}",
            *(f"{row[key]:.3g}" for key in ("deviation before", "deviation after", "delta", "delta · EL", "left")),
            f"{row['variable frames']:.0f}",
        )
    told = data.get("problems", [])
    wrong = [Text(f"problem: {text}") for text in ([p["text"] for p in told] if searched else _worst_of_each(told))]
    return Group(*wrong, head, main, *([segments] if data["segments"] else []))


def _worst_of_each(told: list[dict[str, Any]]) -> list[str]:
    """Of the problems of a recording, worst first, the first of a kind and a name: nearly every image repeats it."""
    count = Counter((problem["kind"], problem["name"]) for problem in told)
    first: dict[tuple[str, str], str] = {}
    for problem in told:
        first.setdefault((problem["kind"], problem["name"]), problem["text"])
    return [text + (f"; {count[key] - 1} times more" if count[key] > 1 else "") for key, text in first.items()]


def _cycle_words(data: dict[str, Any]) -> str:
    """The cycle in a few words, if there is one."""
    cycle = data.get("cycle")
    if not cycle:
        return ""
    feet = f", low feet slide at {cycle['slip']:.0%} of the travel" if "slip" in cycle else ""
    return f"; a cycle of {cycle['period, s']:.2f} s, {cycle['trust']:.1f} times as sure as the raw spline{feet}"


Line = tuple[str, str, str]  # what it is, before, after
Sides = tuple[dict[str, Any], dict[str, Any]]  # what was measured before and after


def _lines(before: dict[str, Any], after: dict[str, Any]) -> list[Line]:
    sides = (before, after)
    return [line for section in SECTIONS for line in section(sides)]


def _line(sides: Sides, name: str, shown: Callable[[dict[str, Any]], str]) -> Line:
    return name, shown(sides[0]), shown(sides[1])


def _paired(sides: Sides, key: str) -> Iterator[Sides]:
    """What a list of both sides holds, one by one."""
    yield from zip(sides[0].get(key, []), sides[1].get(key, []), strict=False)


def _millimetres(value: float) -> str:
    return f"{1000 * value:.1f} mm"


def _deepest(found: dict[str, Any]) -> str:
    return f"{_millimetres(found['deepest'])}, {found['where']}"


def _of_objective(sides: Sides) -> Iterator[Line]:
    yield _line(sides, "objective", lambda s: f"{s['objective']:.4g}")
    for name in sides[1]["terms"]:
        yield _line(sides, f"  {name}", lambda s, name=name: f"{s['terms'].get(name, 0):.4g}")


def _of_depth(sides: Sides) -> Iterator[Line]:
    key, selves = "penetration, m", "self-penetration, m"
    every = "; none collides, all count" if sides[1][key].get("all geoms count") else ""
    yield _line(sides, f"deepest penetration of any geom{every}", lambda s: _deepest(s[key]))
    for name in sides[1][key]["points"]:
        yield _line(sides, f"  {name}", lambda s, name=name: _millimetres(s[key]["points"][name]))
    if sides[1][selves]:
        yield _line(sides, "deepest of the figure in itself", lambda s: _deepest(s[selves]))


def _of_joints(sides: Sides) -> Iterator[Line]:
    def bent(angles: dict[str, float]) -> str:
        return f"{angles['backward']:.1f}° / {angles['sideways']:.1f}° / {angles['twist']:.1f}°"

    def torn(found: dict[str, Any]) -> str:
        return f"{_millimetres(found['most, m'])}, {found['loop']}"

    for name in sides[1]["bends, degrees"]:
        called = f"{name}: backward / sideways / twist"
        yield _line(sides, called, lambda s, name=name: bent(s["bends, degrees"][name]))
    if sides[1]["beyond joint range"]:
        yield _line(sides, "farthest beyond a joint's range", lambda s: _beyond(s["beyond joint range"]))
    key = "equality constraints"
    if "coupled" in sides[1].get(key, {}):
        yield _line(sides, "farthest off what it follows", lambda s: _beyond(s[key]["coupled"]))
    if "closed" in sides[1].get(key, {}):
        yield _line(sides, "closed loops apart", lambda s: torn(s[key]["closed"]))


def _of_feet(sides: Sides) -> Iterator[Line]:
    def skated(found: dict[str, float]) -> str:
        return f"{_millimetres(found['path, m'])}, {found['speed, m/s']:.3f} m/s"

    for name in sides[1]["skate"]:
        yield _line(sides, f"skate of {name}", lambda s, name=name: skated(s["skate"][name]))
    for pair in _paired(sides, "stances"):
        name = f"{pair[1]['points']} planted {_span(pair[1])}: lift / slide"
        yield _line(pair, name, lambda s: f"{_millimetres(s['lift, m'])} / {_millimetres(s['slide, m'])}")
    for foot in sides[1].get("swings", {}):
        name = f"{foot} off the floor, every swing"
        yield _line(sides, name, lambda s, foot=foot: swing_words(s["swings"][foot]))


def _span(found: dict[str, Any]) -> str:
    return f"{found['from, s']:.2f} - {found['to, s']:.2f} s"


def _of_contacts(sides: Sides) -> Iterator[Line]:
    for pair in _paired(sides, "contacts"):
        name = f"{pair[1]['point']} rests {_span(pair[1])}: moved / path"
        yield _line(pair, name, lambda c: f"{_millimetres(c['moved, m'])} / {_millimetres(c['path, m'])}")
    for pair in _paired(sides, "holds"):
        name = f"{pair[1]['hand']} on {pair[1]['body']} {_span(pair[1])}: moved"
        yield _line(pair, name, lambda found: _millimetres(found["moved, m"]))
    if sides[1].get("in what is carried, m"):
        yield _line(sides, "deepest in what is carried", lambda s: _deepest(s["in what is carried, m"]))


def _of_places(sides: Sides) -> Iterator[Line]:
    key = "off their places, m"
    for name in sides[1][key]:
        yield _line(sides, f"{name}, off its place", lambda s, name=name: _millimetres(s[key][name]))
    for name, value in sides[1]["edge clearance, m"].items():
        yield (f"clearance of {name}", "", _millimetres(value))


def _of_spline(sides: Sides) -> Iterator[Line]:
    def seams(found: dict[str, float]) -> str:
        return " / ".join(f"{found[k]:.0e}" for k in ("state", "first derivative", "second derivative"))

    def lengths(found: dict[str, float]) -> str:
        return f"{found['shortest']:.4f} - {found['longest']:.4f}"

    yield _line(sides, "length of quaternions", lambda s: lengths(s["unit deviation"]))
    yield _line(sides, "keyframe error", lambda s: f"{s['keyframe error']:.1e}")
    if "turn, degrees" in sides[1].get("seam", {}):
        yield _line(sides, "a period turns by", lambda s: f"{s['seam'].get('turn, degrees', 0.0):.4g}°")
    if "seam" in sides[1]:
        yield _line(sides, "seam of the loop: y / y' / y'' apart", lambda s: seams(s["seam"]))


def _of_effort(sides: Sides) -> Iterator[Line]:
    peak, torque = "angular acceleration, rad/s²", "torque, N m"
    efforts = (sides[0][torque], sides[1][torque])
    yield _line(sides, "peak angular acceleration", lambda s: f"{s[peak]['peak']:.0f} rad/s², {s[peak]['joint']}")
    name = "norm of all joints' torques, root mean square over time"
    yield _line(efforts, name, lambda t: f"{t['root mean square']:.0f} N m")
    yield _line(efforts, "  peak of one joint", lambda t: f"{t['peak of one joint']:.0f} N m, {t['joint']}")
    yield _line(efforts, "peak root force, the ground's to supply", lambda t: f"{t['peak root force']:.0f} N")


def _of_support(sides: Sides) -> Iterator[Line]:
    carried = (sides[0]["support"], sides[1]["support"])
    if "off free fall, g" in carried[1]:
        yield _line(carried, "in flight: centre of mass off g, mean", lambda c: f"{c['off free fall, g']:.1%}")
        yield _line(carried, "  upward force from nothing, mean", lambda c: f"{c['upward force in flight, N']:.0f} N")
    if carried[1]:
        name = "root force that no contact can supply, root mean square"
        yield _line(carried, name, lambda c: f"{c['root mean square']:.2f} body weights")
        yield _line(carried, "  moment, body weight × height", lambda c: f"{c['moment, root mean square']:.2f}")
    drift = sides[1].get("centre of mass off before, m")
    if drift:
        yield ("centre of mass off before, largest", "", _millimetres(drift["largest"]))
        yield ("  away from where before is in a box", "", _millimetres(drift["away from trouble"]))


SECTIONS: tuple[Callable[[Sides], Iterator[Line]], ...] = (
    _of_objective,
    _of_depth,
    _of_joints,
    _of_feet,
    _of_contacts,
    _of_places,
    _of_spline,
    _of_effort,
    _of_support,
)


def _beyond(found: dict[str, Any]) -> str:
    """How far a joint is beyond its range, in words."""
    if found["most"] == 0:
        return "not at all"
    far = f"{found['most']:.1f}°" if found["unit"] == "degrees" else f"{1000 * found['most']:.1f} mm"
    return f"{far}, {found['joint']}"
