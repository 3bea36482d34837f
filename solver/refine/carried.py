"""A path that was found carried over to keyframes that were edited since: where a search goes on from what is seen.

Times between keyframes that are in both stretch with them, and the path is moved by what the keyframes were moved by,
so that it runs through all of them at once and stays as smooth as it was.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline
from ..curve.spline import path_of
from ..curve.unknowns import raw_timeline
from ..figure.figure import Figure

SAME = 1e-9  # [s, and of a state's entries] nearer, a keyframe is the one that it was
FEW = 2  # variable frames in a segment that has none
CLOSE = 0.15  # of a segment, nearer to a keyframe a variable frame is left out
TINY = 0.02  # [s] a segment so short gets no variable frames


def carried(
    figure: Figure,
    found: Timeline,
    before: Sequence[Frame],
    keys: Sequence[Frame],
    raw: Timeline,
    travel: Array | None = None,
    turn: float | None = None,
) -> Timeline:
    """The timeline through `keys` nearest to one found through the keyframes `before`, with its variable frames.

    before, keys  hold qpos, as a Problem's;  raw  the timeline of the spline through keys
    travel, turn  of a loop, as a Problem's
    """
    old_times, new_times = _matched(before, keys)
    path = path_of(found)
    first, last = found.times[0], found.times[-1]

    def old(times: Array) -> Array:
        """(T, N) the path found, at times of the new keyframes."""
        return path.at(np.clip(_stretched(times, new_times, old_times), first, last))

    times = raw.times
    was = old(times)
    known = {key.time: key for key in before}
    qpos = figure.to_qpos(was)
    warm = [_warm(key, known.get(key.time), pose) for key, pose in zip(keys, qpos, strict=True)]
    slope = None if raw.ends == "free" else raw.end_slope
    start = raw_timeline(figure, warm, raw.ends, slope if raw.ends == "clamped" else None, travel, turn)
    start = Timeline(start.frames, raw.end_slope, raw.ends) if raw.ends == "clamped" else start
    signs = _signs(figure, start.states, was)
    inner = np.sort(_stretched(found.times[~found.fixed.any(axis=1)], old_times, new_times))
    inner = _placed(times, inner)
    states = _moved(figure, start, signs, was, inner, old(inner))
    frames = Frame.many(inner, states, np.zeros(states.shape, bool))
    posed = [replace(frame, posed=of.posed) for frame, of in zip(start.frames, raw.frames, strict=True)]
    slopes = np.array(start.end_slope)
    if raw.ends == "free":
        slopes = np.array(found.end_slope) * signs[[0, -1]]
    return Timeline(tuple(posed), slopes, raw.ends).inserted(frames)


def _matched(before: Sequence[Frame], keys: Sequence[Frame]) -> tuple[Array, Array]:
    """Times (m,) of keyframes that are in both, as they were and as they are: all by number, or those of one time."""
    old, new = np.array([key.time for key in before]), np.array([key.time for key in keys])
    if old.size == new.size:
        return old, new
    common = [(a, b) for a in old for b in new[np.abs(new - a) < SAME]]
    if not common:
        return old[[0, -1]], new[[0, -1]]
    pairs = np.array(common)
    return pairs[:, 0], pairs[:, 1]


def _stretched(times: Array, here: Array, there: Array) -> Array:
    """Times between some moments as they lie between others, and beyond them as far away as they were."""
    out = np.interp(times, here, there)
    return np.where(
        times < here[0], there[0] + times - here[0], np.where(times > here[-1], there[-1] + times - here[-1], out)
    )


def _warm(key: Frame, was: Frame | None, pose: Array) -> Frame:
    """A keyframe with what it leaves free as the path found has it; as it is posed, if it is another than it was."""
    same = was is not None and np.array_equal(was.fixed, key.fixed) and np.abs(was.state - key.state).max() < SAME
    told = key.fixed if same else key.known
    return Frame(key.time, np.where(told, key.state, pose), key.fixed, ~key.fixed)


def _signs(figure: Figure, states: Array, was: Array) -> Array:
    """(K, N) ±1: which quaternions of the path found lie on the other hemisphere at a keyframe."""
    signs = np.ones(states.shape)
    for columns in figure.tables.quaternion_columns.T:
        along = np.einsum("kn,kn->k", states[:, columns], was[:, columns])
        signs[:, columns] = np.where(along < 0, -1.0, 1.0)[:, None]
    return signs


def _placed(times: Array, inner: Array) -> Array:
    """Variable frames' times that are far enough from keyframes, and some in segments that have none."""
    kept: list[float] = []
    for a, b in pairwise(times):
        margin = CLOSE * (b - a)
        own = inner[(inner > a + margin) & (inner < b - margin)]
        own = own[np.append(True, np.diff(own) > SAME)] if own.size else own
        if not own.size and b - a > TINY:
            own = a + (b - a) * np.arange(1, FEW + 1) / (FEW + 1)
        kept += own.tolist()
    return np.array(kept)


def _moved(figure: Figure, start: Timeline, signs: Array, was: Array, inner: Array, states: Array) -> Array:
    """(V, N) the states of a path moved by what its keyframes were; on the spline through them where a quaternion
    turns another way round than it did."""
    times, moved = start.times, start.states - signs * was
    span = np.clip(np.searchsorted(times, inner, side="right") - 1, 0, times.size - 2)
    share = ((inner - times[span]) / (times[span + 1] - times[span]))[:, None]
    out = signs[span] * states + moved[span] + share * (moved[span + 1] - moved[span])
    torn = signs[span] != signs[span + 1]
    return np.where(torn, path_of(start).at(inner), out) if torn.any() else out
