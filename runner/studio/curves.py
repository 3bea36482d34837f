"""Curves beside the timeline: coordinates, speeds and torques of joints, and where they overshoot keyframes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.dynamics import velocities
from dynsplines.solver.figure.figure import Figure, JointKind, Link, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Torque
from dynsplines.solver.problem import Solution
from dynsplines.solver.tolerances import ROUNDING

from ..measure.bounds import BOUNDS
from ..motion import RESAMPLED, samples_at
from .paths import MOST_SAMPLES

UNITS = {"angle": "°", "position": "m", "speed": "°/s", "torque": "N m"}
AXES = {JointKind.BALL: ("x", "y", "z"), JointKind.FREE: ("x", "y", "z", "turn x", "turn y", "turn z")}


def curves(figure: Figure, solution: Solution) -> dict[str, Any]:
    """Return groups of series, with a unit each, at times [s]. Those of coordinates have the number of an axis."""
    sides = {"after": solution.timeline}
    if solution.timeline is not solution.raw:
        sides["before"] = solution.raw
    time = _times(solution.timeline)
    by_side = {side: _series(figure, samples_at(figure, path_of(line), time)) for side, line in sides.items()}
    groups: dict[str, list[dict[str, Any]]] = {name: [] for name in UNITS}
    for i, (group, link, axis, values) in enumerate(by_side["after"]):
        series = {"name": _label(link, axis), "joint": link.name, "axis": axis, "after": _round(values)}
        if "before" in by_side:
            series["before"] = _round(by_side["before"][i][-1])
        groups[group].append(series)
    listed = [{"name": name, "unit": UNITS[name], "series": series} for name, series in groups.items()]
    return {"time": time.round(4).tolist(), "groups": listed}


def overshoots(figure: Figure, keys: Sequence[Frame], timeline: Timeline) -> list[dict[str, Any]]:
    """Return where joints go beyond the values of both neighbouring keyframes that fix them, one for each interval."""
    time = _times(timeline)
    worst: dict[tuple[float, float], tuple[float, dict[str, Any]]] = {}
    for group, link, axis, values in _coordinates(figure, figure.to_qpos(path_of(timeline).at(time))):
        fixed = [key.time for key in keys if key.fixed[link.qpos]] if group == "angle" else []
        for first, last in pairwise(fixed if link.kind is not JointKind.FREE else ()):
            begin, end = np.interp([first, last], time, values)
            inside = np.where((time > first) & (time < last), values, begin)
            beyond = np.maximum(inside - max(begin, end), min(begin, end) - inside)
            at = int(beyond.argmax())
            if beyond[at] > max(BOUNDS["overshoot"].most, worst.get((first, last), (0.0,))[0]):
                text = f"{_label(link, axis)} goes from {begin:.0f}° to {values[at]:.0f}°, and then to {end:.0f}°"
                mark = {"time": float(time[at]), "joint": link.name, "text": text}
                worst[first, last] = float(beyond[at]), mark
    return [mark for _, mark in worst.values()]


def _times(timeline: Timeline) -> Array:
    first, last = float(timeline.times[0]), float(timeline.times[-1])
    return np.linspace(first, last, int(np.clip((last - first) * RESAMPLED, 20, MOST_SAMPLES)) + 1)


def _series(figure: Figure, samples: Samples) -> list[tuple[str, Link, int | None, Array]]:
    """Return group, joint, axis and values (T,) of every series."""
    (qvel, _), torques = velocities(samples), _torques(samples)
    out: list[tuple[str, Link, int | None, Array]] = [*_coordinates(figure, figure.to_qpos(samples.y))]
    out += [("speed", link, None, np.degrees(_norm(link, qvel))) for link in figure.links[1:] if not _slides(link)]
    return out + [
        ("torque", link, None, torques[i])
        for i, link in enumerate(figure.links[1:], start=1)
        if link.kind is not JointKind.FREE
    ]


def _torques(samples: Samples) -> Array:
    """Return the torques of hinges and slides, and the norms of those of ball joints, by link (L, T)."""
    tables, (efforts,) = samples.figure.tables, Torque().residuals(samples)
    balls, others = np.split(efforts.value, [3 * tables.ball_links.size])
    out = np.zeros((len(tables.parents), samples.count))
    out[tables.ball_links] = np.linalg.norm(balls.reshape(3, -1, samples.count), axis=0)
    out[[*tables.hinge_links, *tables.slide_links]] = others
    return out


def _coordinates(figure: Figure, qpos: Array) -> Iterator[tuple[str, Link, int, Array]]:
    """Yield group, joint, axis and values (T,) of the coordinates of poses (T, nq): rotations as rotation vectors."""
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        values = np.degrees(qpos[:, [link.qpos]] if columns is None else _continuous(qpos[:, columns]))
        lengths = qpos[:, link.qpos : link.qpos + (1 if _slides(link) else 3 if link.kind is JointKind.FREE else 0)]
        values = lengths if _slides(link) else np.hstack([lengths, values])
        for axis in range(values.shape[1]):
            yield "position" if axis < lengths.shape[1] else "angle", link, axis, values[:, axis]


def _continuous(rotations: Array) -> Array:
    """Return the rotation vectors (T, 3) [rad] of quaternions (T, 4), also beyond half a turn without a jump."""
    vectors = quat.rotation_vector(rotations)
    sizes = np.linalg.norm(vectors, axis=1)
    axes = vectors / np.maximum(sizes, ROUNDING)[:, None]
    signs = np.cumprod([1.0, *np.where((axes[1:] * axes[:-1]).sum(axis=1) < 0, -1.0, 1.0)])
    return (signs * np.unwrap(signs * sizes))[:, None] * axes


def _label(link: Link, axis: int | None) -> str:
    """Return the name of a joint's series; without an axis that of the whole joint."""
    return link.name if axis is None else f"{link.name} {AXES.get(link.kind, ('',))[axis]}".strip()


def _slides(link: Link) -> bool:
    return link.kind is JointKind.SLIDE


def _norm(link: Link, values: Array) -> Array:
    """Return the norm of a joint's part of velocities (T, nv), of a free joint's rotation only, (T,)."""
    components = values[:, link.dofs]
    return np.linalg.norm(components[:, -3:], axis=1) if components.shape[1] > 1 else components[:, 0]


def _round(values: Array) -> list[float]:
    return np.asarray(values, float).round(3).tolist()
