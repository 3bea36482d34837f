"""Quantities of one column of a report, by name, with their units, besides the amounts of violations."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.contacts import within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import RootWrench, generalised_forces
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.surface.heights import heights
from dynsplines.solver.surface.points import displacements, places_of
from dynsplines.solver.tolerances import TINY

from ..clip.build import Clip

Entry = dict[str, float | str]  # values of a quantity by name and unit


def quantities(clip: Clip, objective: Objective, timeline: Timeline, samples: Samples) -> dict[str, object]:
    """Return the quantities of the raw spline or of the solved motion by name. Those that do not apply to the clip are
    omitted or empty.

    samples  the motion at the times of its measurement
    """
    values = objective.integrals(path_of(timeline))
    terms = {t.penalty.name: float(t.factor * v) for t, v in zip(objective.terms, values, strict=True)}
    every = {
        "objective": sum(terms.values()),
        "terms": terms,
        "skate": _skate(clip, samples),
        "keyframe error": keyframe_error(clip, timeline),
        "seam": _seam(clip, timeline),
        "torque, N m": _torque(samples),
        "support": _support(clip, samples),
    }
    return {name: value for name, value in every.items() if value is not None}


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
        "peak root force, N": float(max(root, default=0.0)),
    }


def _support(clip: Clip, samples: Samples) -> dict[str, float]:
    """Return unsupported force and moment: in flight, and beyond what the footings can supply."""
    if clip.context.support is None or not clip.context.support.has_intervals:
        return {}
    carried = clip.context.support.stiff
    rest = carried.rest(samples)[:, carried.is_known(samples.t)]
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
