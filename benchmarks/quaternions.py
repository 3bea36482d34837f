"""How near the least energy paths through seven orientations come, beside RotationSpline and SQUAD, and subdivision."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from bench import Effort, Section, Target, median, worst
from numpy.typing import NDArray
from rotations import Track, acceleration_energy, energy, exact_energy, in_other_class, sampled_energy, solved, track
from scipy.spatial.transform import Rotation, RotationSpline

from dynsplines.solver import Improvement, Settings
from dynsplines.solver import quaternion as quat
from dynsplines.solver.refine.subdivision import by_weak_form

Array = NDArray[np.float64]
Row = dict[str, float]

KEYFRAMES = 7
SETS = {"moderate": (200, 8), "random": (100, 6)}
FIRST_SEED = 1000
VARIABLE, FINEST, MOST_UNIFORM = 3, 15, 8
GOAL = 1.00002
THRESHOLD, BATCH = 3e-6, 0.2
FACTOR, SHARE = 3.0, 0.95
TIGHT: dict[str, Any] = {"tolerance": 1e-10, "max_evaluations": 2000}


def squad(keys: Array) -> Callable[[Array], Array]:
    """Shoemake's spherical quadrangles through unit quaternions (K, 4), 1 s apart: orientations at u in [0, K − 1].

    The rotations before the first and after the last keyframe repeat their neighbours'.
    """
    turns = _log(quat.product(quat.inverse(keys[:-1]), keys[1:]))
    before, after = np.vstack([turns[:1], turns]), np.vstack([turns, turns[-1:]])
    inner = quat.product(keys, quat.from_rotation_vector((before - after) / 4))

    def at(u: Array) -> Array:
        i = np.clip(u.astype(int), 0, len(keys) - 2)
        h = u - i
        return _slerp(_slerp(keys[i], keys[i + 1], h), _slerp(inner[i], inner[i + 1], h), 2 * h * (1 - h))

    return at


def _slerp(a: Array, b: Array, share: Array) -> Array:
    return quat.product(a, quat.from_rotation_vector(share[:, None] * _log(quat.product(quat.inverse(a), b))))


def _log(q: Array) -> Array:
    """Rotation vectors of unit quaternions, their signs as they are: angles up to a whole turn, and so continuous."""
    length = np.linalg.norm(q[:, 1:], axis=1, keepdims=True)
    return 2 * np.arctan2(length, q[:, :1]) * q[:, 1:] / np.maximum(length, 1e-300)


def rotation_spline(track: Track) -> float:
    """Energy of SciPy's RotationSpline."""
    spline = RotationSpline(track.times, Rotation.from_quat(track.orientations[:, [1, 2, 3, 0]]))
    return acceleration_energy(track.times, lambda t: spline(t, 2))


def evenly(track: Track, variable: int) -> Any:
    """Our optimum with `variable` frames in every segment, tightly converged."""
    return solved(track, Settings(variable=variable, frames=0, **TIGHT), light=True)


def adaptive(track: Track, least: float) -> tuple[float, float, float]:
    """Subdivision by the weak form until no segment promises more: ratio and frames at the end, and the fewest frames
    after a round at which the ratio was at most 1.00002 (infinite: never)."""
    last: dict[int, Improvement] = {}

    def improved(step: Improvement) -> None:
        last[step.round] = step

    settings = Settings(variable=1, frames=200, threshold=THRESHOLD, batch=BATCH, **TIGHT)
    motion = solved(track, settings, improved, light=True)
    rounds = [(step.path.spline.times.size - KEYFRAMES, energy(step.path) / least) for step in last.values()]
    enough = [frames for frames, ratio in rounds if ratio <= GOAL]
    return energy(motion.path) / least, motion.timeline.variable_count, min(enough, default=np.inf)


def uniform_need(track: Track, least: float) -> float:
    """The total number of uniform variable frames for 1.00002 (infinite: more than 8 a segment)."""
    for variable in range(1, MOST_UNIFORM + 1):
        if energy(evenly(track, variable).path) / least <= GOAL:
            return variable * (KEYFRAMES - 1)
    return np.inf


def of_set(track: Track) -> Row:
    """Every figure of one set of keyframes."""
    fine = evenly(track, FINEST)
    finest = energy(fine.path)
    exact = exact_energy(track)
    least = finest if exact is None or in_other_class(finest / exact) else exact
    row = {"finest / exact": finest / exact if exact else np.nan, "seed": float(track.seed)}
    for variable in (1, VARIABLE):
        motion = evenly(track, variable)
        row[f"{variable} a segment"] = energy(motion.path) / least
        objective = motion.objective
        gap = objective.value(motion.path) - objective.value(fine.path)
        estimate = float(by_weak_form(objective, motion.timeline).sum())
        row[f"estimate / gap, {variable} a segment"] = estimate / gap if gap > 0 else np.nan
    row["RotationSpline"] = rotation_spline(track) / least
    row["SQUAD"] = sampled_energy(track.times, squad(track.orientations)) / least
    row["adaptive"], row["adaptive, frames"], row["adaptive, frames to 1.00002"] = adaptive(track, least)
    row["evenly, frames to 1.00002"] = uniform_need(track, least)
    return row


def measure(effort: Effort) -> Section:
    section = Section(
        "Energy ∫ ¼|ω'|² of the normalised path / the exact minimiser's, seven keyframes 1 s apart",
        ("path", "moderate: median", "worst", "random: median", "worst"),
    )
    rows: dict[str, list[Row]] = {}
    for kind, counts in SETS.items():
        count = effort.count(*counts)
        rows[kind] = []
        for i in range(count):
            effort.report(f"{kind}, set {i + 1} of {count}")
            rows[kind].append(of_set(track(kind, FIRST_SEED + i, KEYFRAMES)))
    same_class = {kind: [row for row in of_kind if not _is_in_other_class(row)] for kind, of_kind in rows.items()}
    names = ("3 a segment", "1 a segment", "adaptive", "RotationSpline", "SQUAD")
    words = {"3 a segment": "ours, 3 variable frames a segment", "1 a segment": "ours, 1 a segment"}
    words |= {"adaptive": "ours, adaptive from 1 a segment, weak form"}
    for name in names:
        cells = [f"{f(_column(same_class[kind], name)):.6f}" for kind in SETS for f in (median, worst)]
        section.add(words.get(name, name), *cells)
    for name in ("adaptive, frames", "adaptive, frames to 1.00002", "evenly, frames to 1.00002"):
        section.add(name, *(f(_column(same_class[kind], name)) for kind in SETS for f in (median, worst)))
    _estimates(section, same_class)
    _targets(section, same_class)
    others = {kind: [int(r["seed"]) for r in of_kind if _is_in_other_class(r)] for kind, of_kind in rows.items()}
    unclosed = {k: [int(r["seed"]) for r in of_kind if np.isnan(r["finest / exact"])] for k, of_kind in rows.items()}
    section.notes = [
        f"sets: {', '.join(f'{len(of_kind)} {kind}' for kind, of_kind in rows.items())}, seeds from {FIRST_SEED}; "
        "moderate: steps of 20-90°, random: uniformly random rotations; intrinsic form, free end slopes, "
        "weight of the unit term 0.05 × the covariant one",
        "exact: multiple shooting (benchmarks/exact_path.py), which shares no code with the solver; energy by "
        "8 Gauss points on panels of 50 ms",
        f"another winding class than the exact one (energy off by more than 5 %), left out above: {_listed(others)}",
        f"the exact solver did not converge, replaced by 15 frames a segment: {_listed(unclosed)}",
        "RotationSpline has its end rates clamped to SLERP's; SQUAD is Shoemake's; neither minimises this energy",
        f"adaptive: from 1 a segment, the neediest {BATCH:.0%} of the segments a round, until none promises more than "
        f"{THRESHOLD:g} of E",
        "frames to 1.00002: all variable frames; adaptive counts those after the first round that gets there",
    ]
    section.data = {"sets": rows}
    return section


def _estimates(section: Section, rows: dict[str, list[Row]]) -> None:
    for variable in (1, VARIABLE):
        name = f"estimate / gap, {variable} a segment"
        columns = [_column(rows[kind], name) for kind in SETS]
        cells = [f(column) for column in columns for f in (median, _farthest)]
        section.add(f"estimated distance / gap to 15 a segment, at {variable} a segment", *cells)
        ratios = np.concatenate(columns)
        near = float(np.mean((ratios >= 1 / FACTOR) & (ratios <= FACTOR)))
        words = f"sets whose estimated distance at {variable} a segment is within a factor of 3"
        section.targets.append(Target(words, near, SHARE, least=True))


def _targets(section: Section, rows: dict[str, list[Row]]) -> None:
    ours = {kind: _column(rows[kind], "3 a segment") for kind in SETS}
    section.targets[:0] = [
        Target("moderate, median", median(ours["moderate"]), 1.00002),
        Target("moderate, worst", worst(ours["moderate"]), 1.0005),
        Target("random, median", median(ours["random"]), 1.0003),
    ]
    for kind in SETS:
        adaptive, even = (_column(rows[kind], f"{who}, frames to 1.00002") for who in ("adaptive", "evenly"))
        ratios = [a / b for a, b in zip(adaptive, even, strict=True)]
        section.targets += [
            Target(f"adaptive, {kind}, worst ratio", worst(_column(rows[kind], "adaptive")), GOAL),
            Target(f"{kind}: frames to 1.00002, adaptive / evenly, median", median(ratios), 1.0),
            Target("the same, worst", worst(ratios), 1.0),
        ]


def _is_in_other_class(row: Row) -> bool:
    return in_other_class(row["finest / exact"]) or in_other_class(row["3 a segment"])


def _column(rows: list[Row], name: str) -> list[float]:
    return [row[name] for row in rows]


def _farthest(ratios: list[float]) -> float:
    """The ratio farthest from 1, by factor."""
    return max(ratios, key=lambda r: abs(np.log(max(r, 1e-300))) if np.isfinite(r) else np.inf, default=np.nan)


def _listed(seeds: dict[str, list[int]]) -> str:
    return "; ".join(f"{kind} {len(of_kind)}{f' ({of_kind})' if of_kind else ''}" for kind, of_kind in seeds.items())
