"""Curves beside the timeline: angles, speeds and torques of joints."""

from __future__ import annotations

from typing import Any

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import generalised_forces, velocities
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.solution import Solution

from ..motion import samples_at

RATE = 100.0  # [1/s] sampling rate of a short motion
MOST = 1500  # number of samples of a long motion


def curves(figure: Figure, solution: Solution) -> dict[str, Any]:
    """Return groups of series, with a unit each, at times [s]."""
    first, last = float(solution.timeline.times[0]), float(solution.timeline.times[-1])
    time = np.linspace(first, last, int(np.clip((last - first) * RATE, 20, MOST)) + 1)
    sides = {"after": solution.timeline}
    if solution.timeline is not solution.raw:
        sides["before"] = solution.raw
    by_side = {side: _side(figure, timeline, time) for side, timeline in sides.items()}
    groups = []
    for name, unit in (("angle", "°"), ("speed", "°/s"), ("torque", "N m")):
        names = list(by_side["after"][name])
        series = [{"name": label, **{side: by_side[side][name].get(label, []) for side in by_side}} for label in names]
        groups.append({"name": name, "unit": unit, "series": series})
    return {"time": time.round(4).tolist(), "groups": groups}


def _side(figure: Figure, timeline: Timeline, time: Array) -> dict[str, dict[str, list[float]]]:
    samples = samples_at(figure, path_of(timeline), time)
    qpos, (qvel, _) = figure.to_qpos(samples.y), velocities(samples)
    forces = generalised_forces(samples)
    names = {i: figure.links[i].name for i in range(1, len(figure.links))}
    kinds = {i: figure.links[i].kind for i in names}
    turning = [i for i in names if kinds[i] is not JointKind.SLIDE]
    jointed = [i for i in names if kinds[i] is not JointKind.FREE]
    return {
        "angle": {names[i]: _rounded(_angle(figure, i, qpos)) for i in turning},
        "speed": {names[i]: _rounded(np.degrees(_size(figure, i, qvel))) for i in turning},
        "torque": {names[i]: _rounded(_size(figure, i, forces)) for i in jointed},
    }


def _angle(figure: Figure, index: int, qpos: Array) -> Array:
    """Return the rotation of a joint, (T,) [degrees]."""
    link = figure.links[index]
    columns = quaternion_columns(link)
    if columns is None:
        return np.degrees(qpos[:, link.qpos])
    return np.degrees(np.linalg.norm(quat.rotation_vector(qpos[:, columns]), axis=-1))


def _size(figure: Figure, index: int, values: Array) -> Array:
    """Return the norm of a joint's part of velocities or forces (T, nv), of a free joint's rotation only, (T,)."""
    components = values[:, figure.links[index].dofs]
    return np.linalg.norm(components[:, -3:], axis=1) if components.shape[1] > 1 else components[:, 0]


def _rounded(values: Array) -> list[float]:
    return np.asarray(values, float).round(3).tolist()
