"""Edits of timelines: speed, trimming, repetition of a loop.

A cubic spline's curve is determined by the states at its knots and the slopes at both ends. Speed, trimming and
repetition transform knots and slopes without fitting, so the result is the same curve up to rounding.
"""

from __future__ import annotations

import numpy as np

from ..array import Array
from ..curve.frame import Frame, Timeline, TimelineError
from ..curve.seam import Seam
from ..curve.spline import path_of
from ..figure.figure import Figure
from ..tolerances import ROUNDING


def retime(timeline: Timeline, speed: float) -> Timeline:
    """Return the same path at `speed` times the speed, from the same start: y(t₀ + (t − t₀) · speed)."""
    if not (np.isfinite(speed) and speed > 0):
        raise TimelineError(f"speed must be a number above 0, not {speed:g}")
    # the end slopes of a loop are the jumps of y' and y'' at its seam
    powers = np.array([1, 2]) if timeline.ends == "periodic" else np.ones(2)
    times = timeline.times[0] + (timeline.times - timeline.times[0]) / speed
    frames = Frame.many(times, timeline.states, timeline.fixed)
    return Timeline(tuple(frames), timeline.end_slope * speed ** powers[:, None], timeline.ends)


def check_interval(span: tuple[float, float], first: float, last: float) -> None:
    """Raise TimelineError unless `first` to `last` [s] is within the motion."""
    if not first < last:
        raise TimelineError(f"the interval from {first:g} to {last:g} s ends before it begins")
    if first < span[0] - ROUNDING or last > span[1] + ROUNDING:
        raise TimelineError(f"from {first:g} to {last:g} s is not inside {span[0]:g} to {span[1]:g} s")


def trim(timeline: Timeline, first: float, last: float) -> Timeline:
    """Return the part of a timeline from `first` to `last` [s], with free ends; both are keyframes on the curve."""
    times = timeline.times
    check_interval((float(times[0]), float(times[-1])), first, last)
    near = times[np.abs(times[:, None] - np.array([first, last])).argmin(axis=0)]
    edges = np.where(np.abs(near - np.array([first, last])) <= ROUNDING, near, [first, last])
    path = path_of(timeline)
    inside = [frame for frame in timeline.frames if edges[0] < frame.time < edges[1]]
    whole = np.ones(timeline.width, bool)
    begin, end = (Frame(t, path.at(t)[0], whole) for t in edges.tolist())
    return Timeline((begin, *inside, end), path.at(edges, 1))


def repeat(figure: Figure, timeline: Timeline, count: int) -> Timeline:
    """Return a loop repeated `count` times as one loop, with accumulated travel and one frame at each inner seam."""
    if timeline.ends != "periodic":
        raise TimelineError(f"only a loop, with ends = 'periodic', can be repeated; these are '{timeline.ends}'")
    if count < 1:
        raise TimelineError(f"a loop is played at least once, not {count} times")
    seam, period = Seam.of(figure, timeline), timeline.times[-1] - timeline.times[0]
    frames = list(timeline.frames[:1])
    for number in range(count):
        states = seam.move(timeline.states[1:], number)
        frames += Frame.many(timeline.times[1:] + number * period, states, timeline.fixed[1:])
    return Timeline(tuple(frames), _jumps(timeline, seam, count), "periodic")


def _jumps(timeline: Timeline, seam: Seam, count: int) -> Array:
    """Return the jumps (2, N) of y' and y'' from the end of `count` periods to the start, see `Spline`."""
    start = path_of(timeline).motion(timeline.times[:1])[1:, 0]
    return seam.linear(start, count) - start
