"""The displacement of a cleaned motion from its recording, and its limit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Rest
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Rolling, TrackingPenalty
from dynsplines.solver.solution import Improvement
from dynsplines.solver.surface.points import places_of

from ..motion import even_times, sample_runs, samples_at
from .cleaning import RATE, Cleaned, depth, started_at

SLIP, DEPTH = 0.005, 0.002  # [m] largest slip in a stance and depth in a surface, of a motion near its recording


@dataclass(frozen=True)
class Displacement:
    """The 95th percentile and the maximum of a body's distance from the recording [m], with the latter's time [s]."""

    name: str
    percentile_95: float
    maximum: float
    time: float

    @property
    def line(self) -> str:
        return f"{self.name} is up to {1000 * self.maximum:.0f} mm off the recording at {self.time:.2f} s"


def displacements(cleaned: Cleaned) -> tuple[Displacement, ...]:
    """Return the displacements of free roots and of the ends of limbs, largest first."""
    figure, times = cleaned.figure, even_times(cleaned.after.span, RATE)
    parents = figure.tables.parents
    ends = [i for i in range(1, len(figure.links)) if not np.any(parents[1:] == i)]
    links = [*(int(i) for i in figure.tables.free_links if i not in ends), *ends]
    sides = (sample_runs(figure, path, times) for path in (cleaned.recorded.path, cleaned.after))
    runs = [
        np.linalg.norm(_centres(one, links) - _centres(other, links), axis=0) for one, other in zip(*sides, strict=True)
    ]
    rows = zip(links, np.concatenate(runs, axis=1), strict=True)
    every = [
        Displacement(
            figure.body_name(link), float(np.percentile(row, 95)), float(row.max()), float(times[row.argmax()])
        )
        for link, row in rows
    ]
    return tuple(sorted(every, key=lambda one: -one.maximum))


def _centres(samples: Samples, links: list[int]) -> Array:
    """Return the centres of mass (3, n, T) [m] of links."""
    centres = np.array([samples.figure.links[i].centre for i in links]).T
    return samples.links.points(np.array(links), centres)[0]


def closer(cleaned: Cleaned, max_displacement: float, improved: Callable[[Improvement], None] | None = None) -> Cleaned:
    """Return a motion that is displaced by at most `max_displacement` [m] from its recording, as far as possible.

    The recording's weight is doubled up to seven times while nothing slips or penetrates.
    """
    problem, best = cleaned.problem, cleaned
    for _ in range(7):
        largest = displacements(best)[0].maximum
        if largest <= max_displacement:
            break
        weights = [(p, 2 * w if isinstance(p, TrackingPenalty) else w) for p, w in problem.penalties]
        problem = replace(problem, penalties=tuple(weights))
        tried = replace(cleaned, solution=inbetween(started_at(problem, best.solution), improved=improved))
        if not is_sound(tried):
            break
        if displacements(tried)[0].maximum < largest:
            best = tried
    return best


def is_sound(cleaned: Cleaned) -> bool:
    """Return whether nothing slips or penetrates."""
    figure, path = cleaned.figure, cleaned.after
    slips = (slip(figure, path, rest) for rest in cleaned.rests)
    return max(slips, default=0.0) <= SLIP and depth(cleaned.ground, path, even_times(path.span, RATE)).max() <= DEPTH


def slip(figure: Figure, path: Path, rest: Rest) -> float:
    """Return the largest distance [m] of a resting point from its mean position, without the part of rolling."""
    samples = samples_at(
        figure, path, np.linspace(rest.first, rest.last, max(2, round((rest.last - rest.first) * RATE)))
    )
    rotation = samples.links.Q[:, rest.point.link]
    rolling = Rolling.of(rest, rotation[:, samples.count // 2])
    places = places_of((rest.point,), samples)[0][:, 0] - rolling.displacement(rotation)
    return float(np.linalg.norm(places - places.mean(axis=1, keepdims=True), axis=0).max())
