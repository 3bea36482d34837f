"""Quantities of one column of a report, by name, with their units.

Quantities that are also checked for violations come from the `Measurement` that the violations use. Others are measured
at the same times.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from dynsplines.solver.array import runs
from dynsplines.solver.contacts import within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import generalised_forces
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.naming import geom_name
from dynsplines.solver.figure.root_wrench import RootWrench
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Rolling
from dynsplines.solver.surface import Box
from dynsplines.solver.surface.heights import FAR, height_above, heights
from dynsplines.solver.surface.points import body_points, displacements, places_of
from dynsplines.solver.surface.touch import counts_all, movers

from ..clip.build import Clip
from ..motion import samples_at
from .checks import Row
from .measurement import RATE, Measurement, bend_limits, inferred

HIGHEST = 1.0  # [m] upper limit of the lift of a foot in a stance, in the report


@dataclass(frozen=True, eq=False)
class Side:
    """One column of a report: the raw spline or the solved motion of a clip, with its measurement and E."""

    clip: Clip
    objective: Objective
    timeline: Timeline
    measurement: Measurement

    @classmethod
    def of(cls, clip: Clip, objective: Objective, timeline: Timeline, raw: Timeline) -> Side:
        return cls(clip, objective, timeline, Measurement.of(clip, timeline, raw))

    @cached_property
    def samples(self) -> Samples:
        return samples_at(self.clip.figure, path_of(self.timeline), self.measurement.time)

    @cached_property
    def terms(self) -> dict[str, float]:
        """The contribution of every term to E."""
        values = self.objective.integrals(path_of(self.timeline))
        return {t.penalty.name: float(t.factor * v) for t, v in zip(self.objective.terms, values, strict=True)}

    def quantities(self) -> dict[str, object]:
        """Return all quantities by name; those that do not apply to the clip are omitted or empty."""
        clip, samples, timeline, worst = self.clip, self.samples, self.timeline, self.measurement.worst
        in_grasped = [entry for entry in worst("self") if entry[0].kind == "penetration"]
        every = {
            "objective": sum(self.terms.values()),
            "terms": self.terms,
            "penetration, m": _penetration(clip, worst("penetration")),
            "self-penetration, m": _deepest([entry for entry in worst("self") if entry[0].kind == "self"]),
            "bends, degrees": _bends(clip, worst("bend")),
            "beyond joint range": _most(worst("range"), "joint"),
            "equality constraints": _equalities(worst("coupled"), worst("torn")),
            "skate": _skate(clip, samples),
            "stances": _stances(clip, timeline),
            "swings": swings(clip, samples),
            "contacts": _contacts(clip, timeline),
            "grasps": _grasps(clip, self.measurement),
            "penetration of held objects, m": _deepest(in_grasped) if clip.context.schedule.grasps else {},
            "target distance, m": {f"{row.name} at {time:g} s": away for row, away, time in worst("placement")},
            "edge clearance, m": _edge_clearance(clip, samples),
            "unit deviation": _unit_deviation(samples),
            "keyframe error": keyframe_error(clip, timeline),
            "seam": _seam(clip, timeline),
            "angular acceleration, rad/s²": _peak(worst("whip")),
            "torque, N m": _torque(samples),
            "support": _support(clip, samples),
        }
        return {name: value for name, value in every.items() if value is not None}


Entry = dict[str, float | str]  # values of a quantity by name and unit
Worst = Sequence[tuple[Row, float, float]]  # rows with their largest amounts and the times [s], worst first


def _deepest(worst: Worst) -> Entry:
    """Return the deepest penetration [m], and where."""
    if not worst or worst[0][1] <= 0:
        return {"deepest": 0.0, "where": "nothing"}
    row, depth, time = worst[0]
    return {"deepest": depth, "where": f"{row.name} in {row.other} at {time:.3f} s"}


def _penetration(clip: Clip, worst: Worst) -> dict[str, Any]:
    """Return the depths [m] of the figure's geoms and contact points in their surroundings."""
    model = clip.figure.model
    names, depths = {geom_name(model, geom) for geom in movers(model)}, dict[str, float]()
    for row, depth, _ in worst:
        depths.setdefault(row.name, depth)
    return {
        **_deepest([entry for entry in worst if entry[0].name in names]),
        "geoms": {name: depth for name, depth in depths.items() if name in names},
        "points": {point.name: depths.get(point.name, 0.0) for point in clip.context.points if clip.context.surfaces},
        "all geoms count": counts_all(model),
    }


def _bends(clip: Clip, worst: Worst) -> dict[str, dict[str, float]]:
    """Return the largest angles of knees and elbows: backward, sideways and twist."""
    limits = bend_limits(clip)
    within = {"backward": -limits.least, "sideways": limits.sideways, "twist": limits.twist}
    angles = {(row.name, row.kind): float(np.degrees(within[row.kind])) + beyond for row, beyond, _ in worst}
    return {bend.name: {kind: max(0.0, angles[bend.name, kind]) for kind in within} for bend in limits.joints}


def _most(worst: Worst, what: str) -> Entry:
    """Return the row that exceeds its bound most, in degrees or m."""
    if not worst:
        return {}
    row, most, time = worst[0]
    return {what: row.name, "at, s": time, "most": most, "unit": row.unit}


def _equalities(joints: Worst, loops: Worst) -> dict[str, Entry]:
    """Return deviations of coupled joints, and gaps of closed loops."""
    result: dict[str, Entry] = {"coupled": _most(joints, "joint")} if joints else {}
    return result | ({"closed": {"loop": loops[0][0].name, "most, m": loops[0][1]}} if loops else {})


def _grasps(clip: Clip, measurement: Measurement) -> list[Entry]:
    """Return the displacement of every grasp's site on the body since the start of the grasp."""
    largest, out = measurement.largest("grasp"), list[Entry]()
    for i, grasp in enumerate(clip.context.schedule.grasps):
        moved, time = largest.get(i, (0.0, grasp.first))
        row: Entry = {"hand": grasp.point.name, "body": grasp.body, "from, s": grasp.first, "to, s": grasp.last}
        out.append(row | {"moved, m": moved, "at, s": time})
    return out


def _peak(worst: Worst) -> Entry:
    """Return the largest angular acceleration of a link relative to its parent."""
    if not worst:
        return {"peak": 0.0, "joint": "", "at, s": 0.0}
    row, peak, time = worst[0]
    return {"peak": peak, "joint": row.name, "at, s": time}


def _skate(clip: Clip, samples: Samples) -> dict[str, dict[str, float]]:
    """Return the horizontal distance that each contact point travels while close to its surface, and its mean speed."""
    if not clip.context.points or not clip.context.surfaces:
        return {}
    centres, radii = places_of(clip.context.points, samples)
    low = np.abs(height_above(clip.context.surfaces, centres, radii[:, None])) < Thresholds.of(clip.figure).rests
    steps = displacements(centres[:2])
    together = low[:, 1:] & low[:, :-1]
    pace = np.diff(samples.t)
    out = {}
    for i, point in enumerate(clip.context.points):
        length, rest = float(steps[i, together[i]].sum()), float(pace[together[i]].sum())
        out[point.name] = {"path, m": length, "speed, m/s": length / rest if rest > 0 else 0.0, "rest, s": rest}
    return out


def swings(clip: Clip, samples: Samples) -> dict[str, list[dict[str, float]]]:
    """Return the swings of each foot: start and end [s], and height [m] of its lowest point above the surface below.

    A swing begins when all points of a foot have left the ground and ends when one touches it again.
    """
    if not clip.context.points or not clip.context.surfaces:
        return {}
    limits = Thresholds.of(clip.figure)
    by_foot: dict[str, list[dict[str, float]]] = {}
    for link in sorted({point.link for point in clip.context.points}):
        points = tuple(point for point in clip.context.points if point.link == link)
        over, _ = heights(clip.context.surfaces, *places_of(points, samples))
        lowest = over.min(axis=0)
        by_foot[clip.figure.body_name(link)] = [
            {"from, s": float(samples.t[a]), "to, s": float(samples.t[b - 1]), "height, m": float(lowest[a:b].max())}
            for a, b in runs(lowest > limits.swings)
            if samples.t[b - 1] - samples.t[a] >= limits.brief_swing and lowest[a:b].max() < FAR
        ]
    return by_foot


def _stances(clip: Clip, timeline: Timeline) -> list[Entry]:
    """Return every stance of a foot inferred from keyframes, with the rise of its lowest geom and its slide."""
    shortest = Thresholds.of(clip.figure).brief_stance
    long_stances = [stance for stance in inferred(clip, timeline) if stance.last - stance.first > shortest]
    groups: dict[tuple[float, float, int], list[Any]] = {}
    for stance in long_stances:
        groups.setdefault((stance.first, stance.last, stance.point.link), []).append(stance)
    out: list[Entry] = []
    for (first, last, link), group in groups.items():
        time = np.linspace(first, last, max(2, round((last - first) * RATE)))
        samples = samples_at(clip.figure, path_of(timeline), time)
        foot = tuple(point for point in body_points(clip.figure) if point.link == link)
        height, _ = heights(clip.context.surfaces, *places_of(foot, samples))
        centres, _ = places_of(tuple(stance.point for stance in group), samples)
        slide = max(
            float(np.linalg.norm((centres[:, i] - stance.place(time))[:2], axis=0).max())
            for i, stance in enumerate(group)
        )
        names = " and ".join(stance.point.name for stance in group)
        lift = min(float(height.min(axis=0).max()), HIGHEST)
        out.append({"points": names, "from, s": first, "to, s": last, "lift, m": lift, "slide, m": slide})
    return out


def _contacts(clip: Clip, timeline: Timeline) -> list[Entry]:
    """Return every contact of the clip, with its largest distance from mid-contact and the length of its path."""
    out: list[Entry] = []
    for rest in clip.context.schedule.contacts.requested:
        time = np.linspace(rest.first, rest.last, max(3, round((rest.last - rest.first) * RATE)))
        samples = samples_at(clip.figure, path_of(timeline), time)
        centres, _ = places_of((rest.point,), samples)
        turned = samples.links.Q[:, rest.point.link]
        track = centres[:, 0] - Rolling.of(rest, turned[:, time.size // 2]).displacement(turned)
        moved = float(np.linalg.norm(track - track[:, [time.size // 2]], axis=0).max())
        path = float(np.linalg.norm(np.diff(track, axis=1), axis=0).sum())
        speed = path / (rest.last - rest.first)
        interval: Entry = {"point": rest.point.name, "from, s": rest.first, "to, s": rest.last}
        out.append(interval | {"moved, m": moved, "path, m": path, "speed, m/s": speed})
    return out


def _edge_clearance(clip: Clip, samples: Samples) -> dict[str, float]:
    """Return the height of a foot's lowest contact point above a box as the foot's centre crosses its front edge."""
    out: dict[str, float] = {}
    for box in (surface for surface in clip.context.surfaces if isinstance(surface, Box)):
        edge = box.centre[0] - np.abs(box.axes[0]) @ box.half
        top = box.centre[2] + np.abs(box.axes[2]) @ box.half
        for link in sorted({point.link for point in clip.context.points}):
            points = tuple(point for point in clip.context.points if point.link == link)
            centres, _ = places_of(points, samples)
            middle = centres[0].mean(axis=0)
            for i in np.flatnonzero((middle[:-1] < edge) & (middle[1:] >= edge)):
                name = f"{clip.figure.links[link].name} over {box.name} at {samples.t[i]:.2f} s"
                out[name] = float(centres[2, :, i].min() - top)
    return out


def _unit_deviation(samples: Samples) -> dict[str, float]:
    length = np.linalg.norm(samples.q, axis=0)
    if not length.size:
        return {"shortest": 1.0, "longest": 1.0, "largest": 0.0}
    return {
        "shortest": float(length.min()),
        "longest": float(length.max()),
        "largest": float(np.abs(length - 1).max()),
    }


def keyframe_error(clip: Clip, timeline: Timeline) -> float:
    """Return the largest error of a fixed entry of qpos at its key time: [m] or [rad]; quaternions have no unit."""
    figure = clip.figure
    times = np.array([key.time for key in clip.keys])
    reached = figure.to_qpos(path_of(timeline).at(times))
    worst = 0.0
    for key, qpos in zip(clip.keys, reached, strict=True):
        specified = key.state.copy()
        for columns in figure.tables.quaternion_columns.T:
            specified[columns] /= np.linalg.norm(specified[columns])
            if specified[columns] @ qpos[columns] < 0:
                specified[columns] *= -1
        worst = max(worst, float(np.abs(specified - qpos)[key.fixed].max(initial=0.0)))
    return worst


def _seam(clip: Clip, timeline: Timeline) -> dict[str, float | list[float]] | None:
    """Return travel and rotation of a loop's root per period, and jumps of y, y', y'' at its end; else None."""
    if timeline.ends != "periodic":
        return None
    seam = Seam.of(clip.figure, timeline)
    roots = clip.figure.tables.position_columns
    position, velocity, acceleration = map(float, seam.discontinuity(path_of(timeline)))
    mismatch = {"state": position, "first derivative": velocity, "second derivative": acceleration}
    travel = seam.travel[roots[:, 0]].tolist() if roots.size else []
    turn = {"turn, degrees": float(np.degrees(seam.headings[0]))} if seam.turns else {}
    return {"travel, m": travel, **turn, **mismatch}


def _torque(samples: Samples) -> Entry:
    """Return joint torques by inverse dynamics, and the external wrench at the roots. The root mean square is over
    time, of the norm of the torques of all ball joints and hinges."""
    figure = samples.figure
    forces = generalised_forces(samples)
    roots = [link.dof for link in figure.links[1:] if link.kind is JointKind.FREE]
    torques = {figure.links[i].name: forces[:, figure.links[i].dofs] for i in figure.tables.rotary_links}
    joints = np.linalg.norm(np.hstack([forces[:, :0], *torques.values()]), axis=1)
    peaks = {name: float(np.linalg.norm(torque, axis=1).max()) for name, torque in torques.items()}
    strongest = max(peaks, key=lambda name: peaks[name], default="")
    root = [np.linalg.norm(forces[:, dof : dof + 3], axis=1).max() for dof in roots]
    return {
        "root mean square": float(np.sqrt(np.mean(joints**2))),
        "peak of one joint": peaks.get(strongest, 0.0),
        "joint": strongest,
        "peak root force": float(max(root, default=0.0)),
    }


def _support(clip: Clip, samples: Samples) -> dict[str, float]:
    """Return unsupported force and moment: in flight, and beyond what the footings can supply."""
    if clip.context.support is None or not clip.context.support.has_intervals:
        return {}
    carried = clip.context.support.stiff
    rest = carried.rest(samples)[:, carried.known(samples.t)]
    force = np.linalg.norm(rest[:3], axis=0)
    out = {"root mean square": float(np.sqrt(np.mean(force**2)))}
    out["moment, root mean square"] = float(np.sqrt(np.mean(np.sum(rest[3:] ** 2, axis=0))))
    aloft = within(carried.flights, samples.t)
    if aloft.any():
        wrench = RootWrench(samples, carried.root)
        up = -clip.figure.gravity / max(float(np.linalg.norm(clip.figure.gravity)), 1e-12)
        lifted = np.maximum(up @ wrench.force[:, aloft], 0)
        out["off free fall, g"] = float(np.mean(np.linalg.norm(wrench.force[:, aloft], axis=0)) / carried.unit)
        out["upward force in flight, N"] = float(np.mean(lifted))
        out["largest upward force in flight, N"] = float(lifted.max())
    return out
