"""Time beside InterpolatePy's natural Riemannian cubic (C++ multiple shooting), at 7 and 1000 keyframes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from bench import NOT_INSTALLED, Effort, Section, Target, alternated, median, peer, worst
from rotations import Track, energy, exact_energy, in_other_class, solved, track

from dynsplines.solver import Settings, Solution

FIRST_SEED = 2000
SIZES = {7: (20, 3), 1000: (2, 1)}
VARIABLE = (1, 2, 3)
RATIO = 1.0001
TOLERANCE = 1e-3
CLOSED = 1e-6
LIMITS = {7: 2.0, 1000: 1.0}


def shot(module: Any, times: Any, quaternions: list[Any]) -> Any:
    """The peer's curve, solved with its own defaults; None where it raises."""
    try:
        return module.ShootingQuaternionInterpolation(times, quaternions)
    except (RuntimeError, ValueError, ArithmeticError):
        return None


def quaternions_of(module: Any, track: Track) -> list[Any]:
    """The keyframes as the peer takes them."""
    return [module.Quaternion(*map(float, q)) for q in track.orientations]


def has_closed(curve: Any) -> bool:
    """Whether the peer's own residual is small."""
    return curve is not None and bool(np.isfinite(curve.residual_norm)) and curve.residual_norm <= CLOSED


def energy_of(curve: Any) -> float:
    """¼ ∫ |ω'|² of the peer's curve; it reports ∫ |ω'|²."""
    return float(curve.acceleration_energy) / 4


def of_set(track: Track, module: Any, effort: Effort) -> dict[str, Any]:
    """Times [s] and energies of one set: the peer's and ours with 1, 2 and 3 variable frames a segment."""
    works: dict[str, Callable[[], Any]] = {}
    if module is not None:
        works["peer"] = partial(shot, module, track.times, quaternions_of(module, track))
    for variable in VARIABLE:
        works[f"{variable}"] = partial(solved, track, Settings(variable=variable, frames=0, tolerance=TOLERANCE))
    times, results = alternated(works, effort.repeats)
    curve = results.get("peer")
    least = energy_of(curve) if has_closed(curve) else None
    if len(track.keys) <= 20:
        least = exact_energy(track) or least
    row: dict[str, Any] = {"kind": track.kind, "seed": track.seed, "exact": least}
    row["peer [s]"] = median(times["peer"]) if "peer" in times else None
    row["peer closed"] = has_closed(curve)
    row["peer / exact"] = energy_of(curve) / least if has_closed(curve) and least else None
    for variable in VARIABLE:
        motion: Solution = results[f"{variable}"]
        row[f"{variable} [s]"] = median(times[f"{variable}"])
        row[f"{variable} / exact"] = energy(motion.path) / least if least else None
        row[f"{variable}, evaluations"] = motion.evaluations
    return row


def measure(effort: Effort) -> Section:
    module = peer("interpolatepy")
    section = Section(
        "Time of the least-energy path through orientations 1 s apart, beside InterpolatePy's C++ multiple shooting",
        ("keyframes", "kind", "method", "median [ms]", "× theirs", "energy / exact: median", "worst", "failed"),
    )
    rows: dict[str, list[dict[str, Any]]] = {}
    for size, counts in SIZES.items():
        for kind in ("moderate", "random"):
            sets = range(FIRST_SEED, FIRST_SEED + effort.count(*counts))
            rows_ = rows[f"{size} {kind}"] = []
            for seed in sets:
                effort.report(f"{size} keyframes, {kind}, seed {seed}")
                rows_.append(of_set(track(kind, seed, size), module, effort))
            _add_rows(section, size, kind, rows_, module is not None)
    _targets(section, rows)
    section.notes = [
        "theirs: ShootingQuaternionInterpolation with its defaults, from times and its own Quaternion objects; ours: "
        f"`inbetween` from keyframes, intrinsic form, no subdivision, tolerance {TOLERANCE:g}, all of it on the clock",
        "sets: " + ", ".join(f"{len(rows_)} × {name}" for name, rows_ in rows.items()) + f", seeds from {FIRST_SEED}; "
        "times are medians over sets of each set's median; exact: multiple shooting of the tests at 7 keyframes, "
        "theirs at 1000",
        f"targets are for moderate steps (20-90°), with the fewest variable frames whose median ratio is ≤ {RATIO}; "
        "theirs solves exactly this problem; it has no soft constraints, partial keyframes or figures",
        f"failed: theirs raises, or its residual is > {CLOSED:g}; ours: another winding class (energy off by > 5 %)",
    ]
    section.data = {"sets": rows}
    return section


def _add_rows(section: Section, size: int, kind: str, rows: list[dict[str, Any]], installed: bool) -> None:
    theirs = [row["peer [s]"] for row in rows if row["peer closed"]]
    if installed:
        ratios = [row["peer / exact"] for row in rows if row["peer / exact"]]
        failed = f"{len(rows) - len(theirs)} of {len(rows)}"
        cells = (1e3 * median(theirs), 1.0, f"{median(ratios):.6f}", f"{worst(ratios):.6f}", failed)
        section.add(size, kind, "InterpolatePy", *cells)
    else:
        section.add(size, kind, "InterpolatePy", NOT_INSTALLED, *["–"] * 4)
    for variable in VARIABLE:
        ratios = [row[f"{variable} / exact"] for row in rows if row[f"{variable} / exact"]]
        failed = f"{sum(in_other_class(r) for r in ratios)} of {len(rows)}"
        spent = median([row[f"{variable} [s]"] for row in rows])
        times = spent / median(theirs) if theirs else None
        cells = (1e3 * spent, times, f"{median(ratios):.6f}", f"{worst(ratios):.6f}", failed)
        section.add(size, kind, f"ours, {variable} a segment", *cells)


def _targets(section: Section, rows: dict[str, list[dict[str, Any]]]) -> None:
    for size, limit in LIMITS.items():
        moderate = rows[f"{size} moderate"]
        reach = {v: median([row[f"{v} / exact"] for row in moderate if row[f"{v} / exact"]]) for v in VARIABLE}
        enough = [v for v in VARIABLE if reach[v] <= RATIO]
        theirs = [row["peer [s]"] for row in moderate if row["peer closed"]]
        words = f"{size} keyframes, moderate, {enough[0] if enough else 'no number of'} a segment: ours / theirs"
        mine = median([row[f"{enough[0]} [s]"] for row in moderate]) if enough else np.nan
        section.targets.append(Target(words, mine / median(theirs) if theirs else None, limit))
