"""The report on a motion before and after solving, also *between* the samples of the optimiser.

The data are plain dicts for JSON, the motion file and the terminal. The unit is part of a name. In the terminal,
entries whose name ends in ", m", and the entries that they contain, are in millimetres.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from rich.console import Group
from rich.table import Table
from rich.text import Text

from dynsplines.solver.array import Array
from dynsplines.solver.contacts import within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import rotate_fixed
from dynsplines.solver.figure.dynamics import RootWrench
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import Objective
from dynsplines.solver.penalty import Cycle
from dynsplines.solver.problem import renormalise
from dynsplines.solver.refine.subdivision import by_weak_form
from dynsplines.solver.surface.heights import heights
from dynsplines.solver.surface.points import displacements, places_of
from dynsplines.solver.tolerances import TINY

from ..clip.build import Clip
from ..motion import Saved, samples_at
from .bounds import BOUNDS, Row, Violation, row_of, with_unit
from .ground import missing_support
from .measurement import Measurement
from .violation import by_name, plain, violations_of

DRIFT = "centre of mass displacement, m"  # distance between the centres of mass before and after solving
Line = tuple[str, str, str]  # label, before, after


def report(clip: Clip, motion: Saved) -> dict[str, Any]:
    """Return the full report on a motion of a clip.

    An imported recording is measured once for both columns. It has no remaining decrease, because nothing is optimised.
    A cleaned recording has none either, because this is not the objective that was minimised.
    """
    searched = not motion.is_raw and (motion.evaluations > 0 or motion.timeline.variable_count > 0)
    objective = clip.problem.plain_objective
    if clip.settings.renormalise:
        objective = renormalise(objective, motion.raw)
    for side in (motion.raw, motion.timeline):  # as in the search, pairs of limbs that hardly touch do not count
        objective = objective.watching(path_of(side))
    measurements = Measurement.sides(clip, motion)
    samples = [samples_at(clip.figure, path_of(side.timeline), side.time) for side in measurements]
    before, after = _sides(measurements)
    before |= _quantities(clip, objective, motion.raw, samples[0])
    after |= before if motion.is_raw else _quantities(clip, objective, motion.timeline, samples[1])
    first, last = (_centre_of_mass(side) for side in samples)
    after |= {DRIFT: {"largest": float(np.linalg.norm(last - first, axis=0).max())}}
    return {
        "violations": plain(violations_of(measurements[1], motion.stop)),
        "clip": clip.name,
        "duration, s": float(np.ptp(measurements[0].time)),
        "left to gain": _remaining_decrease(objective, motion.timeline) if searched else {},
        "keyframes": len(clip.authored_keys),
        "partial keyframes": sum(not key.is_key for key in clip.authored_keys),
        "variable frames": motion.timeline.variable_count,
        "evaluations": motion.evaluations,
        **{name: motion.search[name] for name in ("seconds",) if name in motion.search},
        "stopped because": motion.search.get("stopped because", motion.stop.value),
        "cycle": _cycle_report(clip),
        "before": before,
        "after": after,
    }


def _quantities(clip: Clip, objective: Objective, timeline: Timeline, samples: Samples) -> dict[str, object]:
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
        "support": _support(clip, samples),
    }
    return {name: value for name, value in every.items() if value is not None}


def _skate(clip: Clip, samples: Samples) -> dict[str, dict[str, float]]:
    """Return the horizontal distance that each contact point travels while close to its surface, and its mean speed."""
    if not clip.context.surfaces:
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


def _sides(measurements: Sequence[Measurement]) -> list[dict[str, Any]]:
    """Return the largest amount of each kind of violation that any of the motions has, for each motion."""
    sides = [_largest(side) for side in measurements]
    kinds, out = [kind for kind in BOUNDS if any(kind in side for side in sides)], list[dict[str, Any]]()
    for side in sides:
        amounts = {kind: {"amount": 0.0, "unit": BOUNDS[kind].unit} for kind in kinds}
        for kind, (row, amount, time) in side.items():
            where = f"{row.name} in {row.other}" if row.other else row.name
            amounts[kind] |= {"amount": amount, "name": where, "at, s": time}
        out.append({"largest": amounts})
    return out


def _largest(motion: Measurement) -> dict[str, tuple[Row, float, float]]:
    """Return `Measurement.largest` and the largest missing forces and moments and imbalance, if positive."""
    missing = sorted(missing_support(motion), key=lambda each: each.amount)
    rows = {lack.kind: (row_of(lack.kind, lack.name, ""), lack.amount, lack.time or 0.0) for lack in missing}
    return motion.largest() | rows


def compare(before: Measurement, after: Measurement) -> Table:
    """Return a table of the kinds of violations before or after, with the largest amount of each on both sides."""
    table, sides = Table("", "before", "after", box=None, pad_edge=False), list[dict[str, float]]()
    violations = [violations_of(side) for side in (before, after)]
    for side, listed in zip((before, after), violations, strict=True):
        amounts = {kind: amount for kind, (_, amount, _) in _largest(side).items()}
        for violation in listed:
            amounts[violation.kind] = max(amounts.get(violation.kind, 0.0), violation.amount)
        sides.append(amounts)
    kinds = {violation.kind for listed in violations for violation in listed}
    for kind in (kind for kind in BOUNDS if kind in kinds):
        table.add_row(kind, *(with_unit(amounts.get(kind, 0.0), BOUNDS[kind].unit) for amounts in sides))
    return table


def _cycle_report(clip: Clip) -> dict[str, float]:
    """Return the gait cycle of the cycle penalty, and its confidence; empty if there is none.

    gain   log-likelihood of the keyframes as a cycle minus that as the best smooth motion, per specified number
    slip   mean speed of low feet along the cycle, relative to the travel speed; omitted without travel
    trust  uncertainty of the raw spline relative to that of the cycle: the ratio of their variances
    """
    gait_cycle = next((penalty.gait_cycle for penalty, _ in clip.penalties if isinstance(penalty, Cycle)), None)
    if gait_cycle is None:
        return {}
    result = {"period, s": gait_cycle.period, "gain": gait_cycle.gain, "trust": float(gait_cycle.trust.mean())}
    return result | ({} if np.isnan(gait_cycle.slip) else {"slip": gait_cycle.slip})


def _centre_of_mass(samples: Samples) -> Array:
    """Return the centre of mass (3, T) [m] of the whole figure."""
    tables = samples.figure.tables
    centres = samples.links.x + rotate_fixed(samples.links.rotation, tables.centre)
    return np.einsum("l,cls->cs", tables.mass, centres) / max(float(tables.mass.sum()), TINY)


def _remaining_decrease(objective: Objective, timeline: Timeline) -> dict[str, float]:
    """Return the estimated decrease of E by one more frame in every interval between frames (weak form), at most E."""
    value = objective.value(path_of(timeline))
    promised = min(float(by_weak_form(objective, timeline).sum()), value)
    return {"objective": promised, "share": promised / max(value, TINY)}


def tables(data: dict[str, Any]) -> Group:
    """Return the report for the terminal."""
    before, after = data["before"], data["after"]
    share = data["left to gain"].get("share", 0.0)
    about = "an unknown share" if share >= 1 else f"about {share:.1%}"
    gain = f"; {about} of the objective is left to gain" if data["left to gain"] else ""
    took = f" in {data['seconds']:.2f} s" if "seconds" in data else ""
    evaluations = f"{data['evaluations']} evaluations{took}; " if data["evaluations"] else ""
    partial = f" ({data['partial keyframes']} partial)" if data["partial keyframes"] else ""
    head = (
        f"{data['clip']}: {data['duration, s']:.2f} s, {data['keyframes']} keyframes{partial}, "
        f"{data['variable frames']} variable frames; "
        f"{evaluations}{data['stopped because']}"
        f"{gain}{_cycle_words(data)}"
    )
    searched = bool(data["left to gain"])
    is_compared = searched or after[DRIFT]["largest"] > 0
    sides = ("before", "after") if is_compared else ("recording",)
    main = Table("measure", *sides, title_justify="left")
    for name, one, two in rows(before, after):
        main.add_row(name, *((one, two) if is_compared else (two,)))
    listed = [Violation(**table) for table in data.get("violations", [])]
    wrong = [Text(f"violation: {violation}") for violation in (listed if searched else by_name(listed))]
    return Group(*wrong, head, main)


def _cycle_words(data: dict[str, Any]) -> str:
    cycle = data.get("cycle")
    if not cycle:
        return ""
    feet = f", low feet slide at {cycle['slip']:.0%} of the travel" if "slip" in cycle else ""
    return f"; a cycle of {cycle['period, s']:.2f} s, {cycle['trust']:.1f} times as sure as the raw spline{feet}"


def rows(before: dict[str, Any], after: dict[str, Any]) -> Iterator[Line]:
    """Yield the lines for the quantities of two columns. In a report of an older version, `before` may lack entries."""
    for name, value in after.items():
        if name == "largest":
            for kind, entry in value.items():
                yield f"largest {kind}", _amount(before.get(name, {}).get(kind)), _amount(entry)
        else:
            yield from _rows(name, before.get(name), value)


def _amount(entry: dict[str, Any] | None) -> str:
    """Return the largest amount of a kind of violation, and where and when it is."""
    if entry is None:
        return ""
    amount = with_unit(entry["amount"], entry["unit"])
    return f"{amount}, {entry['name']} at {entry['at, s']:.2f} s" if "name" in entry else amount


def _rows(name: str, before: Any, after: Any, unit: str = "") -> Iterator[Line]:
    label, unit = _label_and_unit(name, unit)
    if isinstance(after, dict):
        before = before or {}
        single = [key for key, value in after.items() if not isinstance(value, dict | list)]
        if len(single) > 4:
            for key in single:
                yield from _rows(f"{label}: {key}", before.get(key), after[key], unit)
        elif single:
            one, two = (" / ".join(_value(key, side.get(key), unit) for key in single) for side in (before, after))
            yield f"{label}: {' / '.join(_label_and_unit(key, unit)[0] for key in single)}", one, two
        for key in (key for key in after if key not in single):
            yield from _rows(f"{label}, {key}", before.get(key), after[key], unit)
    else:
        yield label, _value(name, before, unit), _value(name, after, unit)


def _label_and_unit(name: str, unit: str) -> tuple[str, str]:
    """Return a name without its unit, and the unit, by default that of the containing entry."""
    label, comma, own_unit = name.rpartition(", ")
    return (label, own_unit) if comma and own_unit in UNITS else (name, unit)


UNITS = {
    "m": lambda value: f"{1000 * value:.1f} mm",
    "degrees": lambda value: f"{value:.1f}°",
    "s": lambda value: f"{value:.2f} s",
    "m/s": lambda value: f"{value:.3f} m/s",
    "rad/s²": lambda value: f"{value:.0f} rad/s²",
    "N": lambda value: f"{value:.0f} N",
}


def _value(name: str, value: Any, unit: str) -> str:
    if value is None:
        return ""
    if isinstance(value, str | bool):
        return str(value)
    if isinstance(value, list):
        return ", ".join(_value(name, item, unit) for item in value)
    return UNITS.get(_label_and_unit(name, unit)[1], lambda number: f"{number:.4g}")(value)
