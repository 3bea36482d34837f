"""Quantities of one column of a report, by name, with their units.

Quantities that are also checked for violations come from the `Measurement` that the violations use. Others are measured
at the same times.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dynsplines.solver.contacts import within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import RootWrench, generalised_forces
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import geom_name
from dynsplines.solver.objective import Objective
from dynsplines.solver.surface.heights import heights
from dynsplines.solver.surface.points import displacements, places_of
from dynsplines.solver.surface.touch import counts_all, movers
from dynsplines.solver.tolerances import TINY

from ..clip.build import Clip
from .bounds import Row
from .measurement import Measurement, bend_limits

Entry = dict[str, float | str]  # values of a quantity by name and unit
Worst = Sequence[tuple[Row, float, float]]  # rows with their largest amounts and the times [s], worst first


def quantities(clip: Clip, objective: Objective, measurement: Measurement, samples: Samples) -> dict[str, object]:
    """Return all quantities of the raw spline or of the solved motion by name. Those that do not apply to the clip are
    omitted or empty.

    samples  the motion at the times of the measurement
    """
    timeline = measurement.timeline

    def worst(name: str) -> Worst:
        return sorted(measurement.largest(name), key=lambda entry: -entry[1])

    values = objective.integrals(path_of(timeline))
    terms = {t.penalty.name: float(t.factor * v) for t, v in zip(objective.terms, values, strict=True)}
    overlaps = worst("self")
    in_grasped = [entry for entry in overlaps if entry[0].kind == "penetration"]
    every = {
        "objective": sum(terms.values()),
        "terms": terms,
        "penetration, m": _penetration(clip, worst("penetration")),
        "self-penetration, m": _deepest([entry for entry in overlaps if entry[0].kind == "self"]),
        "bends, degrees": _bends(clip, worst("bend")),
        "beyond joint range": _most(worst("range"), "joint"),
        "equality constraints": _equalities(worst("coupled"), worst("torn")),
        "skate": _skate(clip, samples),
        "stances": _rests(measurement, "stance"),
        "contacts": _rests(measurement, "contact"),
        "grasps": _grasps(clip, measurement),
        "penetration of held objects, m": _deepest(in_grasped) if clip.context.schedule.grasps else {},
        "keyframe error": keyframe_error(clip, timeline),
        "seam": _seam(clip, timeline),
        "angular acceleration, rad/s²": _peak(worst("whip")),
        "torque, N m": _torque(samples),
        "support": _support(clip, samples),
    }
    return {name: value for name, value in every.items() if value is not None}


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
        if depth > 0:
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
    out = list[Entry]()
    for grasp, (_, moved, time) in zip(clip.context.schedule.grasps, measurement.largest("grasp"), strict=True):
        row: Entry = {
            "hand": grasp.point.name,
            "body": clip.figure.body_name(grasp.on),
            "from, s": grasp.first,
            "to, s": grasp.last,
        }
        out.append(row | {"moved, m": moved, "at, s": time})
    return out


def _rests(measurement: Measurement, kind: str) -> list[Entry]:
    """Return the points of contacts, or of stances inferred from keyframes, with the distances from their places."""
    rests = [target.contact for target in measurement.contact_targets if target.kind == kind]
    return [
        {"point": rest.point.name, "from, s": rest.first, "to, s": rest.last, "moved, m": moved}
        for rest, (_, moved, _) in zip(rests, measurement.largest(kind), strict=True)
    ]


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
    height, _ = heights(clip.context.surfaces, centres, radii)
    low = np.abs(height) < Thresholds.of(clip.figure).near_surface
    steps = displacements(centres[:2])
    together = low[:, 1:] & low[:, :-1]
    pace = np.diff(samples.t)
    out = {}
    for i, point in enumerate(clip.context.points):
        length, rest = float(steps[i, together[i]].sum()), float(pace[together[i]].sum())
        out[point.name] = {"path, m": length, "speed, m/s": length / rest if rest > 0 else 0.0, "rest, s": rest}
    return out


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
        up = -clip.figure.gravity / max(float(np.linalg.norm(clip.figure.gravity)), TINY)
        lifted = np.maximum(up @ wrench.force[:, aloft], 0)
        out["off free fall, g"] = float(np.mean(np.linalg.norm(wrench.force[:, aloft], axis=0)) / carried.unit)
        out["upward force in flight, N"] = float(np.mean(lifted))
        out["largest upward force in flight, N"] = float(lifted.max())
    return out
