"""Detection of gaps, jumps, and duplicate and invalid samples of a recording.

An implausible sample is discarded, and the motion there is interpolated from the samples before and after it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.curve.recording import UNLIKE, Track, between, groups, places
from dynsplines.solver.figure.figure import Figure

from ..errors import UserError, list_names
from ..exchange import gaps
from ..exchange.recording import Recording, median_step
from ..measure.bounds import with_unit

FEWEST = 5  # least number of samples of a motion
LONGEST_GAP = 2.0  # [s] longest gap that is interpolated
TURN, WAY = np.radians(10), 0.04  # [rad], [m] least deviation of a jump
BESIDE = 0.5  # largest distance between the neighbours of a jump, relative to its deviation


def repair(figure: Figure, recording: Recording) -> tuple[Recording, Mask]:
    """Return a recording, some of whose entries are not finite, with repaired samples.

    Their times rise with equal steps except for irregular recordings. Notes name all repairs. The mask (T, nq) contains
    the entries that were recorded and are plausible. Raises UserError for too few samples, decreasing times, and gaps
    that are too long.
    """
    time, qpos, where, notes = recording.time, recording.qpos, recording.name, list[str]()
    if time.size < FEWEST:
        raise UserError(f"{where}: {time.size} sample{'s' * (time.size != 1)}; a motion to clean has {FEWEST} at least")
    if np.any(np.diff(time) < 0):
        i = int(np.argmax(np.diff(time) < 0))
        raise UserError(f"{where}: times go back: sample {i + 2} is at {time[i + 1]:g} s, after {time[i]:g} s")
    time, qpos = _without_duplicates(time, qpos, notes)
    known = _numbers(figure, qpos, time, notes)
    whole = np.flatnonzero(known.all(axis=1))
    if pose := gaps.initial_pose(figure.model, time[whole], qpos[whole]):
        pose = int(whole[pose])
        notes.append(f"{gaps.POSE} {time[pose]:.3f} s: the pose is left out")
        time, qpos, known = time[pose:], qpos[pose:], known[pose:]
    _check_gaps(figure, time, known, where)
    time, qpos, known = _interpolate(time, qpos, known, notes)
    known &= ~_jumps(figure, time, qpos, known, notes)
    lost = [_name(figure, columns) for columns in groups(figure) if known[:, columns].all(axis=1).sum() < FEWEST]
    if lost:
        raise UserError(f"{where}: too few samples of {', '.join(lost)}")
    return replace(recording, time=time, qpos=qpos, notes=tuple(notes)), known


def outliers(track: Track) -> Iterator[str]:
    """Yield a note on samples far from the smoothed recording, such as several successive ones that jump."""
    off, far = between(track.figure, track.bridged, track.states, track.known > 0), np.zeros(track.times.size, bool)
    worst: list[tuple[float, str, str]] = []
    for columns in track.groups:
        is_place, noise = track.is_place[columns[0]], track.noise[columns[0]] * (1 + track.is_half[columns[0]])
        away, bound = np.linalg.norm(off[:, columns], axis=1), max(WAY if is_place else TURN, UNLIKE * noise)
        far |= away > bound
        if away.max() > bound:
            most = with_unit(away.max(), "m") if is_place else with_unit(np.degrees(away.max()), "degrees")
            worst.append((float(away.max() / bound), _name(track.figure, columns), most))
    if worst:
        _, names, amounts = zip(*sorted(worst, reverse=True), strict=True)
        whose = list_names(dict.fromkeys(names))
        yield f"{whose}: smoothing changes samples by up to {amounts[0]}, at {gaps.intervals(track.times, far)}"


def _name(figure: Figure, columns: Index) -> str:
    """Return the quoted name of the link that a group of columns belongs to."""
    link = next(link for link in reversed(figure.links[1:]) if link.qpos <= columns[0])
    return f"'{link.name}'"


def _without_duplicates(time: Array, qpos: Array, notes: list[str]) -> tuple[Array, Array]:
    twice = np.append(False, np.diff(time) <= 0.1 * median_step(time))  # one instant
    if twice.any():
        first, count = float(time[twice][0]), int(twice.sum())
        notes.append(f"{count} sample{'s come' if count > 1 else ' comes'} twice, first at {first:.3f} s: left out")
    return time[~twice], qpos[~twice]


def _numbers(figure: Figure, qpos: Array, time: Array, notes: list[str]) -> Mask:
    """Return the mask (T, nq) of finite entries and of nonzero quaternions; replace the others by the rest pose."""
    known = np.isfinite(qpos)
    for columns in groups(figure):
        fine = known[:, columns].all(axis=1)
        if columns.size == 4:
            fine = fine & (np.linalg.norm(np.where(known[:, columns], qpos[:, columns], 0.0), axis=1) > 1e-6)
        known[:, columns] = np.reshape(fine, (-1, 1))
    bad = np.asarray(~known.all(axis=1))
    if bad.any():
        joints = [_name(figure, columns) for columns in groups(figure) if not known[:, columns].all()]
        notes.append(
            f"{bad.sum()} samples of {list_names(joints)} hold no numbers, at {gaps.intervals(time, bad)}: interpolated"
        )
    np.copyto(qpos, np.asarray(figure.model.qpos0), where=~known)
    return known


def _check_gaps(figure: Figure, time: Array, known: Mask, where: str) -> None:
    """Raise UserError if a joint has no entry for longer than LONGEST_GAP."""
    for columns in groups(figure):
        edges = np.concatenate([time[:1], time[known[:, columns[0]]], time[-1:]])
        i = int(np.argmax(np.diff(edges)))
        if edges.size > 2 and edges[i + 1] - edges[i] > LONGEST_GAP:
            raise UserError(
                f"{where}: {_name(figure, columns)} is not recorded from {edges[i]:.3f} to {edges[i + 1]:.3f} s, over "
                f"{LONGEST_GAP:g} s; cut the recording there"
            )


def _interpolate(time: Array, qpos: Array, known: Mask, notes: list[str]) -> tuple[Array, Array, Mask]:
    step = float(np.median(np.diff(time)))
    missing = np.maximum(np.round(np.diff(time) / step).astype(int) - 1, 0)
    missing[np.diff(time) < 1.5 * step] = 0
    for i in np.flatnonzero(missing):
        notes.append(f"gap from {time[i]:.3f} to {time[i + 1]:.3f} s: interpolated")
    if not missing.any():
        return time, qpos, known
    row = np.repeat(np.arange(time.size), np.append(missing + 1, 1))
    inside = np.arange(row.size) - np.searchsorted(row, row)
    spacing = np.append(np.diff(time) / (missing + 1), 0.0)
    return time[row] + inside * spacing[row], qpos[row], known[row] & (inside == 0)[:, None]


def _jumps(figure: Figure, time: Array, qpos: Array, known: Mask, notes: list[str]) -> Mask:
    """Return the mask (T, nq) of entries of single samples that jump away and back."""
    out, metres = np.zeros(known.shape, bool), places(figure)
    for columns in groups(figure):
        values = quat.align_signs(qpos[:, columns]) if columns.size == 4 else qpos[:, columns]
        bound = WAY if metres[columns[0]] else TURN * (0.5 if columns.size == 4 else 1.0)
        off = np.linalg.norm(values[1:-1] - 0.5 * (values[:-2] + values[2:]), axis=1)
        apart = np.linalg.norm(values[2:] - values[:-2], axis=1)
        far = (off > np.maximum(bound, UNLIKE * np.median(off))) & (apart < BESIDE * off)
        far &= known[:-2, columns[0]] & known[1:-1, columns[0]] & known[2:, columns[0]]
        out[1:-1, columns] = far[:, None]
    has_jump = np.asarray(out.any(axis=1))
    if has_jump.any():
        whose = sorted({_name(figure, columns) for columns in groups(figure) if out[:, columns].any()})
        notes.append(
            f"{list_names(whose)}: {has_jump.sum()} samples jump, at {gaps.intervals(time, has_jump)}: interpolated"
        )
    return out
