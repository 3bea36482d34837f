"""Violations of a motion, worst first.

The check is quick, on a grid fine enough for motion between video frames, whereas `report` takes some seconds.
A violation in the pose of a keyframe is reported once, with the number of the keyframe. The motion next to it is
reported too only if it is worse.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
from typing import Any

import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.dynamics import Size
from dynsplines.solver.search.minimum import Stop

from ..clip.build import Clip
from ..motion import Saved
from .bounds import BOUNDS, Row, Violation, row_of
from .checks import SAME_DEPTH, Check, Hits
from .ground import floating_and_sliding, missing_support
from .measurement import Measurement, feet_of

MAX_LINES = 10  # most violations that are printed
FEW = 3  # number of violations of one kind that are printed before others of this kind


def violations(clip: Clip, motion: Saved) -> tuple[Violation, ...]:
    """Return the violations of a motion that solves a clip, worst first."""
    return violations_of(Measurement.of(clip, motion.timeline, motion.raw), motion.stop)


def violations_of(motion: Measurement, stop: Stop = Stop.CONVERGED) -> tuple[Violation, ...]:
    """Return all violations in a measured motion, worst first."""
    violations = [violation for check, hits in motion.checks for violation in _worst(check, hits, motion)]
    violations += _drifts(motion)
    on_ground = list(floating_and_sliding(motion))
    aloft = {violation.name for violation in on_ground if violation.kind in ("aloft", "float")}
    violations += on_ground
    violations += [v for v in missing_support(motion) if v.severity > 1 and v.name not in aloft]
    if stop in (Stop.MAX_EVALUATIONS, Stop.NO_PROGRESS):
        row = row_of("search", stop.name.lower(), f"the search ended early: {stop.value}")
        violations.append(row.violation(row.bound))
    scale = Size.of(motion.clip.figure).enlargement  # of bounds of lengths, as in models in centimetres
    if scale > 1:
        lengths = [replace(v, bound=scale * v.bound) for v in violations if v.unit == "m"]
        violations = [v for v in violations if v.unit != "m"] + [v for v in lengths if v.severity > 1]
    return tuple(sorted(violations, key=lambda violation: -violation.severity))


def is_recording(saved: Saved) -> bool:
    """Return whether a motion consists of its keyframes only, so that no search causes its violations."""
    return not saved.search and saved.timeline.variable_count == 0


def lines(violations: Sequence[Violation], file: object = None) -> list[str]:
    """Return the worst violations for the terminal, one per line, and the number of the others.

    The worst few of each kind come before the others of a kind with many violations.
    """
    counts: dict[tuple[str, int], int] = {}
    first: list[Violation] = []
    for violation in violations:
        if violation.keyframe is not None:
            place = violation.kind, violation.keyframe
            counts[place] = counts.get(place, 0) + 1
            if counts[place] > 1:
                continue
        first.append(violation)
    kinds = [violation.kind for violation in first]
    selected = sorted(range(len(first)), key=lambda i: kinds[:i].count(kinds[i]) >= FEW)[:MAX_LINES]
    out = []
    for violation in (first[i] for i in sorted(selected)):
        others = counts.get((violation.kind, violation.keyframe or 0), 1) - 1
        out.append(f"violation: {violation.text}" + (f"; {others} more like it there" if others else ""))
    more = len(first) - MAX_LINES
    return [*out, f"... and {more} more" + (f": dynsplines report {file}" if file else "")] if more > 0 else out


def by_name(violations: Sequence[Violation]) -> tuple[Violation, ...]:
    """Return the worst violation of each point, joint or contact of an imported recording, worst first.

    Its text contains the number of samples with this violation. Every sample of an imported recording is a keyframe. A
    list of all violations of one joint would fill the terminal.
    """
    groups: dict[tuple[str, str], list[Violation]] = {}
    for violation in violations:
        groups.setdefault((violation.kind, violation.name), []).append(violation)
    out = []
    for first, *others in groups.values():
        samples = len({violation.keyframe for violation in (first, *others)})
        text = first.text.removeprefix(f"keyframe {first.keyframe} itself: ")
        out.append(replace(first, keyframe=None, text=f"{text}, {samples} samples in all" if samples > 1 else text))
    return tuple(out)


def plain(violations: Sequence[Violation]) -> list[dict[str, Any]]:
    """Return the violations for JSON."""
    return [asdict(violation) for violation in violations]


def summary(saved: Saved, violations: Sequence[Violation]) -> dict[str, object]:
    """Return a short summary of a solve with its violations, as plain numbers for JSON."""
    times, trace = saved.timeline.times, saved.trace
    values = {"objective before": trace[0][2], "objective": trace[-1][2]} if trace else {}
    return {
        "clip": saved.name,
        "duration, s": float(times[-1] - times[0]),
        "keyframes": len(saved.keys),
        "partial keyframes": sum(not key.is_key for key in saved.keys),
        "variable frames": saved.timeline.variable_count,
        **values,
        **saved.search,
        "violations": plain(violations),
    }


def _worst(check: Check, hits: Hits, motion: Measurement) -> Iterator[Violation]:
    """Yield the worst of every group in each keyframe that causes it, and on the path if it is worse there."""
    hits = hits.select(hits.amount > check.bounds[hits.row])
    if not hits.row.size:
        return
    keys = np.full(motion.time.size, -1)
    keys[motion.key_at] = np.arange(motion.key_at.size)
    key, group = keys[hits.at], check.groups[hits.row]
    caused = key >= 0
    caused[caused] = check.is_fixed(hits.row[caused], key[caused])
    caps: dict[int, Array] = {}
    for i in hits.largest(np.where(caused, group * keys.size + key, -1)).tolist():
        caps.setdefault(int(group[i]), np.zeros(motion.key_at.size))[key[i]] = hits.amount[i]
    for i in hits.largest(np.where(caused, group if check.is_once_per_group else group * keys.size + key, -1)).tolist():
        row, time = _name(check, hits, group, i), float(motion.time[hits.at[i]])
        violation = check.row(row).violation(float(hits.amount[i]), time, int(motion.numbers[key[i]]))
        others = np.count_nonzero(caps[int(group[i])]) - 1 if check.is_once_per_group else 0
        also = f", and in {others} other keyframe{'s' if others > 1 else ''}" if others else ""
        yield replace(violation, text=violation.text + also)
    before = np.clip(np.searchsorted(motion.key_at, hits.at, side="right") - 1, 0, motion.key_at.size - 2)
    tolerated = np.zeros(hits.row.size)
    for number, cap in caps.items():
        of_group = group == number
        tolerated[of_group] = np.maximum(cap[:-1], cap[1:])[before[of_group]]
    bound = np.where(tolerated > 0, check.bounds[hits.row], 0.0)
    for i in hits.largest(np.where(hits.amount > tolerated + bound, group, -1)).tolist():
        row = _name(check, hits, group, i)
        yield check.row(row).violation(float(hits.amount[i]), float(motion.time[hits.at[i]]))


def _name(check: Check, hits: Hits, group: Index, worst: int) -> int:
    """Return the row that is named for the worst hit of a group: one in `check.named` if it is about as large."""
    if check.named is not None:
        beside = (hits.at == hits.at[worst]) & (group == group[worst]) & check.named[hits.row]
        beside &= hits.amount >= hits.amount[worst] - SAME_DEPTH
        if beside.any():
            return int(hits.row[beside.argmax()])
    return int(hits.row[worst])


def _drifts(motion: Measurement) -> Iterator[Violation]:
    """Yield the keyframes in which a resting point is not at its position in the previous keyframe."""
    worst: dict[tuple[str, int, int], tuple[float, Row, float]] = {}
    feet = feet_of(motion.clip.figure, motion.clip.context.points)
    pieces = [
        (kind, piece) for kind, contacts in motion.targets.items() for target in contacts for piece in target.pieces()
    ]
    for kind, contact in pieces:
        assert contact.places is not None
        drift = float(np.linalg.norm(contact.places[-1] - contact.places[0]))
        key = int(np.argmin(np.abs(motion.time[motion.key_at] - contact.last)))
        place = kind, int(feet[contact.point.link]), key
        if drift > max(BOUNDS[kind].most, worst[place][0] if place in worst else 0.0):
            text = f"{contact.point.name} should rest, but is {{}} from its position in the previous keyframe"
            worst[place] = drift, row_of(kind, contact.point.name, text), contact.last
    for (_, _, k), (drift, row, time) in worst.items():
        yield row.violation(drift, time, int(motion.numbers[k]))
