"""Keyframes at uneven times, intervals up to 50 : 1: who fails how often."""

from __future__ import annotations

import importlib
from dataclasses import replace
from typing import Any

import numpy as np
from bench import NOT_INSTALLED, Effort, Section, Target, median, peer, seconds, worst
from paper.nearest import optimise
from rotations import KINDS, Track, energy, exact_energy, exact_energy_from, solved, track
from shooting import energy_of, has_closed, quaternions_of, shot

from dynsplines.solver import Settings, Solution
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.refine.subdivision import by_weak_form, midpoints, split

FIRST_SEED = 3000
RATIO = 50.0
SIZES = (7, 20)
SETS = (60, 4)
MOST_VARIABLE = 40  # a segment on average; long segments beside short ones turn several times and take up to 100
OURS = Settings(variable=1, threshold=1e-5, tolerance=1e-10, max_evaluations=500)  # 1e-6 ends near saddles
LEFT, NEAR = 1e-2, 1e-2
BELOW = 1e-6
SAME = 1e-4
MOST_SHOT = 7  # keyframes; from the natural cubic shooting hardly ever closes through more
WAYS = ("exact from ours", "exact from refined", "exact", "refined")


def of_set(track: Track, module: Any) -> dict[str, Any]:
    """The results of both programs for one set: times [s], energies, and whether ours is confirmed."""
    row: dict[str, Any] = {"kind": track.kind, "keyframes": len(track.keys), "seed": track.seed}
    if module is not None:
        row |= _theirs(track, module)
    shooting = exact_energy(track) if len(track.keys) <= MOST_SHOT else None
    row["shooting"] = shooting
    row["exact"] = exact = shooting or row.get("peer energy")
    row |= _ours(track, exact)
    energy, nearest = row["energy"], row["nearest"]
    row["ours / exact"] = energy / nearest if energy and nearest else None
    row["other minimum"] = bool(exact and nearest and abs(nearest / exact - 1) > SAME)
    ratio = row["ours / exact"]
    row["confirmed"] = bool(ratio and row["left"] <= LEFT and abs(ratio - 1) <= NEAR)
    return row


def _theirs(track: Track, module: Any) -> dict[str, Any]:
    spent, curve = seconds(lambda: shot(module, track.times, quaternions_of(module, track)))
    closed = has_closed(curve)
    why = None if closed else "raised" if curve is None else f"residual {curve.residual_norm:.1e}"
    return {"peer [s]": spent, "peer failed": why, "peer energy": energy_of(curve) if closed else None}


def _nearest(track: Track, motion: Solution, exact: float | None) -> tuple[float, str]:
    """The energy of the minimum that ours is near, and how it is known."""
    own_energy = energy(motion.path)
    from_ours = exact_energy_from(track, motion.path)
    if from_ours is not None and _is_near(own_energy, from_ours):
        return from_ours, WAYS[0]
    halved = split(motion.timeline, midpoints(motion.timeline))
    fine = path_of(optimise(motion.objective, halved, max_evaluations=600, tolerance=1e-10))
    for candidate, method in zip((exact_energy_from(track, fine), exact), WAYS[1:-1], strict=True):
        if candidate is not None and _is_near(own_energy, candidate):
            return candidate, method
    return energy(fine), WAYS[-1]


def _is_near(exact: float, minimum: float) -> bool:
    """Whether an exact path's energy can be the minimum that ours is near: a little below it."""
    return -BELOW <= exact / minimum - 1 <= NEAR


def _ours(track: Track, exact: float | None) -> dict[str, Any]:
    settings = replace(OURS, frames=MOST_VARIABLE * (len(track.keys) - 1))
    try:
        spent, motion = seconds(lambda: solved(track, settings))
    except (ArithmeticError, ValueError, np.linalg.LinAlgError) as error:
        why = f"{type(error).__name__}: {error}"
        return {"ours [s]": None, "energy": None, "nearest": None, "known by": "", "left": np.inf, "stop": why}
    remaining = float(by_weak_form(motion.objective, motion.timeline).sum()) / motion.objective.value(motion.path)
    nearest, method = _nearest(track, motion, exact)
    return {
        "ours [s]": spent,
        "energy": energy(motion.path),
        "nearest": nearest,
        "known by": method,
        "left": remaining,
        "stop": motion.stop.name,
        "frames": motion.timeline.variable_count,
        "evaluations": motion.evaluations,
    }


def measure(effort: Effort) -> Section:
    module = peer("interpolatepy")
    section = Section(
        "Keyframe intervals log-uniform between 1 : 1 and 50 : 1: failures",
        ("keyframes", "kind", "sets", "InterpolatePy failed", "ours unconfirmed", "ours / exact: median", "worst",
         "ours at another minimum", "ours [ms]", "theirs [ms]"),
    )  # fmt: skip
    importlib.import_module("warnings").simplefilter("ignore", RuntimeWarning)
    rows: list[dict[str, Any]] = []
    count = effort.count(*SETS)
    for size in SIZES:
        for kind in KINDS:
            results = []
            for i in range(count):
                effort.report(f"{size} keyframes, {kind}, set {i + 1} of {count}")
                results.append(of_set(track(kind, FIRST_SEED + i, size, RATIO), module))
            rows += results
            section.add(size, kind, count, *_cells(results, module is not None))
    mine = sum(not row["confirmed"] for row in rows)
    theirs = sum(row["peer failed"] is not None for row in rows) if module else None
    section.targets = [Target(f"ours unconfirmed, of {len(rows)} (theirs: {theirs})", float(mine), 0.0)]
    apart = [f"{_track_name(row)}: {row['nearest'] / row['exact']:.4f}" for row in rows if row["other minimum"]]
    higher = sum(row["nearest"] > row["exact"] for row in rows if row["other minimum"])
    by = {method: sum(row["known by"] == method for row in rows) for method in WAYS}
    exact = sum(row["exact"] is not None for row in rows)
    few = [row for row in rows if row["keyframes"] <= MOST_SHOT]
    closed = sum(row["shooting"] is not None for row in few)
    doubtful = [
        f"{_track_name(row)}: {row['ours / exact'] or np.nan:.4f}, left {row['left']:.1e}, {row['stop']}"
        for row in rows
        if not row["confirmed"]
    ]
    section.notes = [
        "theirs fails if it raises or its residual is over 1e-6. Ours is confirmed if the weak form promises less than "
        f"{LEFT:.0%} of the energy from a frame in every segment, and the energy is within {NEAR:.0%} of the minimum "
        f"it is near: the exact path to which the tests' multiple shooting closes from ours ({by[WAYS[0]]} sets), from "
        f"ours with twice the frames ({by[WAYS[1]]}), another exact one ({by[WAYS[2]]}), or, where nothing closes, "
        f"ours with twice the frames itself ({by[WAYS[3]]})",
        "ours: from 1 variable frame a segment, subdivision by the weak form to at most "
        f"{MOST_VARIABLE} a segment on average (taken: {median([row['frames'] for row in rows if 'frames' in row]):g}, "
        f"at most {worst([row['frames'] for row in rows if 'frames' in row]):g} in all); the clock is a single run",
        f"another exact path to compare with, by shooting from the natural cubic ({closed} of {len(few)} sets of at "
        f"most {MOST_SHOT} keyframes close) or theirs: {exact} of {len(rows)} sets. Ours is at another minimum than "
        f"that on {len(apart)}, {higher} of them higher; its minimum / that one: {'; '.join(apart) or 'none'}",
        f"ours unconfirmed, energy / minimum, left, stop: {'; '.join(doubtful) or 'none'}",
    ]
    section.data = {"sets": rows}
    return section


def _track_name(row: dict[str, Any]) -> str:
    return f"{row['kind']} {row['keyframes']} seed {row['seed']}"


def _cells(rows: list[dict[str, Any]], installed: bool) -> tuple[Any, ...]:
    ratios = [row["ours / exact"] for row in rows if row["ours / exact"]]
    failed = sum(row["peer failed"] is not None for row in rows) if installed else NOT_INSTALLED
    clocks = [row["peer [s]"] for row in rows] if installed else []
    return (
        failed,
        sum(not row["confirmed"] for row in rows),
        f"{median(ratios):.5f}",
        f"{worst(ratios):.5f}",
        sum(row["other minimum"] for row in rows),
        1e3 * median([row["ours [s]"] for row in rows if row["ours [s]"]]),
        1e3 * median(clocks),
    )
