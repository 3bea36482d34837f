"""The report on a motion before and after solving, also *between* the samples of the optimiser.

The data are plain dicts for JSON, the motion file and the terminal.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from rich.console import Group
from rich.table import Table
from rich.text import Text

from dynsplines.solver.array import Array
from dynsplines.solver.figure.algebra import turned
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Cycle
from dynsplines.solver.refine.subdivision import by_weak_form
from dynsplines.solver.solution import Solution

from ..clip.build import Clip
from .bounds import BOUNDS
from .formatting import rows
from .measurement import Measurement
from .quantities import Side
from .violation import Violation, by_name, plain, violations_of, with_unit

DRIFT = "centre of mass displacement, m"  # distance between the centres of mass before and after solving


def report(clip: Clip, motion: Solution, seconds: float | None) -> dict[str, Any]:
    """Return the full report of a solved clip.

    seconds  duration of the solve, if known

    An imported recording is measured once for both columns. It has no remaining decrease, because nothing is optimised.
    A cleaned recording has none either, because this is not the objective that was minimised.
    """
    is_compared = not motion.is_raw
    searched = is_compared and (motion.evaluations > 0 or motion.timeline.variable_count > 0)
    before = Side.of(clip, motion.objective, motion.raw, motion.raw)
    after = Side.of(clip, motion.objective, motion.timeline, motion.raw) if is_compared else before
    first = before.quantities()
    sides = {"before": first, "after": after.quantities() if is_compared else dict(first)}
    drift = np.linalg.norm(_centre_of_mass(after.samples) - _centre_of_mass(before.samples), axis=0)
    sides["after"][DRIFT] = {"largest": float(drift.max())}
    return {
        "violations": plain(violations_of(after.measurement, motion.stop)),
        "clip": clip.name,
        "duration, s": float(np.ptp(before.samples.t)),
        "left to gain": _remaining_decrease(motion) if searched else {},
        "keyframes": len(clip.authored_keys),
        "partial keyframes": sum(not key.is_key for key in clip.authored_keys),
        "variable frames": motion.timeline.variable_count,
        "evaluations": motion.evaluations,
        **({} if seconds is None else {"seconds": seconds}),
        "stopped because": motion.stop.value,
        "cycle": _cycle_report(clip),
        **sides,
    }


def compare(before: Measurement, after: Measurement) -> Table:
    """Return a table of the kinds of violations before or after, with the largest amount of each on both sides."""
    table, sides = Table("", "before", "after", box=None, pad_edge=False), list[dict[str, float]]()
    violations = [violations_of(side) for side in (before, after)]
    for side, listed in zip((before, after), violations, strict=True):
        amounts = {kind: float(values.max()) for kind, values in side.by_kind().items()}
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
    centres = samples.links.x + turned(samples.links.rotation, tables.centre)
    return np.einsum("l,cls->cs", tables.mass, centres) / max(float(tables.mass.sum()), 1e-12)


def _remaining_decrease(motion: Solution) -> dict[str, float]:
    """Return the estimated decrease of E by one more frame in every interval between frames (weak form), at most E."""
    value = motion.objective.value(motion.path)
    promised = min(float(by_weak_form(motion.objective, motion.timeline).sum()), value)
    return {"objective": promised, "share": promised / value if value > 0 else 0.0}


def tables(data: dict[str, Any]) -> Group:
    """Return the report for the terminal."""
    before, after = data["before"], data["after"]
    share = data["left to gain"].get("share", 0.0)
    about = "an unknown share" if share >= 1 else f"about {share:.1%}"
    gain = f"; {about} of the objective is left to gain" if data["left to gain"] else ""
    took = f" in {data['seconds']:.2f} s" if "seconds" in data else ""
    evaluations = f"{data['evaluations']} evaluations{took}; " if data["evaluations"] else ""
    head = (
        f"{data['clip']}: {data['duration, s']:.2f} s, {data['keyframes']} keyframes "
        f"({data['partial keyframes']} partial), {data['variable frames']} variable frames; "
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
