"""Warm start: an earlier solution mapped to edited keyframes, from which a search continues.

Times between keyframes that are in both versions are mapped linearly, and the path is displaced by the displacement of
the keyframes, interpolated in time. It thus passes through all of them and stays as smooth as before.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ..array import Array, segments_at
from ..curve.frame import Frame, Timeline
from ..curve.raw import raw_timeline
from ..curve.spline import path_of
from ..figure.figure import Figure
from ..tolerances import ROUNDING
from .subdivision import FEW

CLOSE = 0.15  # [1] distance from a keyframe, relative to the segment, below which a variable frame is omitted
SHORT = 0.02  # [s] length of a segment up to which it gets no variable frames


def warm_start(
    figure: Figure,
    solved: Timeline,
    before: Sequence[Frame],
    keys: Sequence[Frame],
    raw: Timeline,
    travel: Array | None = None,
    turn: float | None = None,
) -> Timeline:
    """Return the warm start through edited keyframes, with the variable frames of an earlier solution.

    Args:
        solved: The earlier solution's timeline.
        before: The keyframes of the earlier solution, which hold qpos.
        keys: The edited keyframes, which hold qpos.
        raw: The timeline of the spline through `keys`.
        travel: Of a loop, see `Problem`, (3,) [m].
        turn: Of a loop, see `Problem` [rad].
    """
    old_times, new_times = _match(before, keys)
    path = path_of(solved)
    first, last = solved.times[0], solved.times[-1]

    def old(times: Array) -> Array:
        return path.at(np.clip(_stretch(times, new_times, old_times), first, last))

    times = raw.times
    was = old(times)
    key_at = {key.time: key for key in before}
    qpos = figure.to_qpos(was)
    warm = [_warm(key, key_at.get(key.time), pose) for key, pose in zip(keys, qpos, strict=True)]
    is_clamped = raw.ends.startswith("clamped")
    start = raw_timeline(figure, warm, raw.ends, raw.end_slope if is_clamped else None, travel, turn)
    start = Timeline(start.frames, raw.end_slope, raw.ends) if is_clamped else start
    signs = _signs(figure, start.states, was)
    inner = np.sort(_stretch(solved.times[~solved.fixed.any(axis=1)], old_times, new_times))
    inner = _place(times, inner)
    states = _move(figure, start, signs, was, inner, old(inner))
    frames = Frame.many(inner, states, np.zeros(states.shape, bool))
    posed = [replace(frame, posed=of.posed) for frame, of in zip(start.frames, raw.frames, strict=True)]
    slopes = np.array(start.end_slope)
    free = np.array(raw.free_slopes)[:, None]
    slopes = np.where(free, np.array(solved.end_slope) * signs[[0, -1]], slopes)
    return Timeline(tuple(posed), slopes, raw.ends).insert(frames)


def _match(before: Sequence[Frame], keys: Sequence[Frame]) -> tuple[Array, Array]:
    """Return the earlier and present times (m,) [s] of keyframes in both clips, matched by index or else by time."""
    old, new = np.array([key.time for key in before]), np.array([key.time for key in keys])
    if old.size == new.size:
        return old, new
    common = [(a, b) for a in old for b in new[np.abs(new - a) < ROUNDING]]
    if not common:
        return old[[0, -1]], new[[0, -1]]
    pairs = np.array(common)
    return pairs[:, 0], pairs[:, 1]


def _stretch(times: Array, here: Array, there: Array) -> Array:
    """Return times mapped piecewise linearly from `here` to `there`, shifted beyond the ends."""
    out = np.interp(times, here, there)
    return np.where(
        times < here[0], there[0] + times - here[0], np.where(times > here[-1], there[-1] + times - here[-1], out)
    )


def _warm(key: Frame, was: Frame | None, pose: Array) -> Frame:
    """Return a keyframe with unspecified entries from the earlier path, unless an edited keyframe poses them."""
    same = was is not None and np.array_equal(was.fixed, key.fixed) and np.abs(was.state - key.state).max() < ROUNDING
    is_known = key.fixed if same else key.known
    return Frame(key.time, np.where(is_known, key.state, pose), key.fixed, ~key.fixed)


def _signs(figure: Figure, states: Array, was: Array) -> Array:
    """Return signs (K, N): −1 where a quaternion and the earlier path are on opposite hemispheres, else 1."""
    signs = np.ones(states.shape)
    for columns in figure.tables.quaternion_columns.T:
        along = np.einsum("kn,kn->k", states[:, columns], was[:, columns])
        signs[:, columns] = np.where(along < 0, -1.0, 1.0)[:, None]
    return signs


def _place(times: Array, inner: Array) -> Array:
    """Return the times of variable frames that are far enough from keyframes, with some added to empty segments."""
    result: list[float] = []
    for a, b in pairwise(times):
        margin = CLOSE * (b - a)
        inside = inner[(inner > a + margin) & (inner < b - margin)]
        inside = inside[np.append(True, np.diff(inside) > ROUNDING)] if inside.size else inside
        if not inside.size and b - a > SHORT:
            inside = a + (b - a) * np.arange(1, FEW + 1) / (FEW + 1)
        result += inside.tolist()
    return np.array(result)


def _move(figure: Figure, start: Timeline, signs: Array, was: Array, inner: Array, states: Array) -> Array:
    """Return the states (V, N) of a path displaced with its keyframes. Where a quaternion turns in another direction
    than before, the states are on the spline through the keyframes."""
    times, moved = start.times, start.states - signs * was
    span = segments_at(times, inner)
    share = ((inner - times[span]) / (times[span + 1] - times[span]))[:, None]
    out = signs[span] * states + moved[span] + share * (moved[span + 1] - moved[span])
    is_torn = signs[span] != signs[span + 1]
    return np.where(is_torn, path_of(start).at(inner), out) if is_torn.any() else out
