"""Swings of feet. A swing begins when all points of a foot have left the ground and ends when one touches it again."""

from __future__ import annotations

from dynsplines.solver.array import runs
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.heights import FAR, heights
from dynsplines.solver.surface.points import places_of

from ..clip.build import Clip

MOST_SHOWN = 6  # most swings of a foot whose heights a table lists one by one


def swings(clip: Clip, samples: Samples) -> dict[str, list[dict[str, float]]]:
    """Return the swings of each foot: start and end [s], and height [m] of its lowest point above the surface below."""
    if not clip.context.points or not clip.context.surfaces:
        return {}
    limits = Thresholds.of(clip.figure)
    by_foot: dict[str, list[dict[str, float]]] = {}
    for link in sorted({point.link for point in clip.context.points}):
        points = tuple(point for point in clip.context.points if point.link == link)
        over, _ = heights(clip.context.surfaces, *places_of(points, samples))
        lowest = over.min(axis=0)
        by_foot[clip.figure.body_name(link)] = [
            {"from, s": float(samples.t[a]), "to, s": float(samples.t[b - 1]), "height, m": float(lowest[a:b].max())}
            for a, b in runs(lowest > limits.swings)
            if samples.t[b - 1] - samples.t[a] >= limits.brief_swing and lowest[a:b].max() < FAR
        ]
    return by_foot


def swing_text(foot_swings: list[dict[str, float]]) -> str:
    """Return a foot's swings for a table, by their heights."""
    high = [1000 * swing["height, m"] for swing in foot_swings]
    if not high:
        return "never"
    if len(high) > MOST_SHOWN:
        return f"{len(high)} times, {min(high):.0f} to {max(high):.0f} mm"
    return ", ".join(f"{height:.0f}" for height in high) + " mm"
