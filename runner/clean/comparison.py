"""Comparison before and after cleaning: penetration, slip and jumps, unsupported forces, and displacements."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from rich.table import Table

from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Rest
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import JointRange, Rolling, Speed, Support, TrackingPenalty, joint_ranges
from dynsplines.solver.penalty.motion.peak import relative_accelerations
from dynsplines.solver.solution import Improvement
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import arrays_of, places_of

from ..clip.tracking.penalties import Ground
from ..motion import even_times, sample_runs
from .cleaning import Cleaned, started_at
from .penetration import depth

RATE = 120.0  # [1/s] of the samples
SLIP, DEPTH, HOVER = 5.0, 2.0, 5.0  # [mm] largest values of a sound motion
STRICTER, TRIES = 2.0, 7  # factor of the recording's weight in each try to reduce deviations, and most tries
RANGE = 0.5  # [°] largest excess of a joint's range in a sound motion


@dataclass(frozen=True)
class Line:
    """A measured quantity before and after, with its unit, and the bound of acceptable values, if any."""

    label: str
    unit: str
    before: float
    after: float
    bound: float | None = None


@dataclass(frozen=True)
class BodyDisplacement:
    """Median, 95th percentile and maximum of a body's deviation from the recording [m], with the latter's time [s]."""

    name: str
    median: float
    percentile_95: float
    maximum: float
    time: float


class HighestSole(NamedTuple):
    """The largest height [m] of a point in a stance, with its time [s]."""

    rest: Rest
    time: float
    height: float


@dataclass(frozen=True, eq=False)
class Comparison:
    """The changes by cleaning."""

    cleaned: Cleaned

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """The defects before and after."""
        before, after = (
            PathMeasurement(self.cleaned, path, self.times) for path in (self.cleaned.before, self.cleaned.after)
        )
        rows = [
            ("deepest penetration", "mm", "depth", DEPTH),
            ("largest stance slip", "mm", "slip", SLIP),
            ("largest sole height in a stance", "mm", "hover", HOVER),
            ("largest joint range excess", "°", "range", RANGE),
            ("largest joint speed", "rad/s", "speed", self.cleaned.ground.speed),
            ("largest joint acceleration", "rad/s²", "peak", None),
            ("mean body jerk", "m/s³", "jerk", None),
            ("mean unsupported force", "weight", "force", None),
        ]
        return tuple(Line(name, unit, getattr(before, of), getattr(after, of), bound) for name, unit, of, bound in rows)

    @property
    def violations(self) -> list[dict[str, Any]]:
        """The remaining defects, worst first, as in a batch's manifest."""
        violations = [
            {"text": f"{line.label}: {line.after:.3g} {line.unit}", "amount": line.after, "bound": line.bound}
            for line in self.lines
            if line.bound is not None and line.after > line.bound
        ]
        return sorted(violations, key=lambda one: -one["amount"] / one["bound"])

    @property
    def figures(self) -> dict[str, tuple[float, float]]:
        """The measured quantities before and after, by name and unit."""
        return {f"{line.label} [{line.unit}]": (round(line.before, 6), round(line.after, 6)) for line in self.lines}

    @cached_property
    def highest_sole(self) -> HighestSole | None:
        """The largest height of a point of the recording during its stances, None without stances."""
        return max(self._recorded.highest_soles(self.cleaned.rests), key=lambda one: one.height, default=None)

    @cached_property
    def raised_soles(self) -> tuple[HighestSole, ...]:
        """The longest interval in which a point of the recording rests too high for a stance, for every such point."""
        longest = {
            id(rest.point): rest for rest in sorted(self.cleaned.raised, key=lambda rest: rest.last - rest.first)
        }
        return tuple(self._recorded.highest_soles(tuple(longest.values())))

    @cached_property
    def _recorded(self) -> PathMeasurement:
        return PathMeasurement(self.cleaned, self.cleaned.recorded.path, self.times)

    @cached_property
    def times(self) -> Array:
        """(T,) [s] of the samples."""
        return even_times(self.cleaned.before.span, RATE)

    @cached_property
    def displacements(self) -> tuple[BodyDisplacement, ...]:
        """The deviations of pelvis, hands and feet from the recording, largest first."""
        figure, farthest = self.cleaned.figure, list[BodyDisplacement]()
        links = compared_links(figure)
        sides = (sample_runs(figure, path, self.times) for path in (self.cleaned.recorded.path, self.cleaned.after))
        off = [
            np.linalg.norm(_tips(one, links) - _tips(other, links), axis=0) for one, other in zip(*sides, strict=True)
        ]
        for link, row in zip(links, np.concatenate(off, axis=1), strict=True):
            high, at = float(np.percentile(row, 95)), int(row.argmax())
            name = figure.body_name(link)
            farthest.append(BodyDisplacement(name, float(np.median(row)), high, float(row[at]), float(self.times[at])))
        return tuple(sorted(farthest, key=lambda one: -one.maximum))

    @property
    def largest_displacement(self) -> float:
        """The largest deviation of pelvis, hands and feet [m]."""
        return max(one.maximum for one in self.displacements)

    @property
    def is_sound(self) -> bool:
        """Whether nothing slips or penetrates."""
        after = PathMeasurement(self.cleaned, self.cleaned.after, self.times)
        return after.slip <= SLIP and after.depth <= DEPTH

    def table(self) -> Table:
        out = Table(box=None, pad_edge=False)
        for heading in ("", "before", "after"):
            out.add_column(heading, justify="left" if not heading else "right")
        for line in self.lines:
            out.add_row(line.label, *(f"{value:.3g} {line.unit}" for value in (line.before, line.after)))
        for one in self.displacements:
            out.add_row(
                f"{one.name} moved",
                f"{100 * one.median:.1f} cm median",
                f"{100 * one.percentile_95:.1f} cm in 95 %, {100 * one.maximum:.1f} at {one.time:.2f} s",
            )
        return out


def closer(cleaned: Cleaned, max_displacement: float, improved: Callable[[Improvement], None] | None = None) -> Cleaned:
    """Return a motion that deviates by at most `max_displacement` [m] from its recording, as far as possible.

    The recording's weight is increased while nothing slips or penetrates.
    """
    problem, best = cleaned.problem, cleaned
    for _ in range(TRIES):
        off = Comparison(best).largest_displacement
        if off <= max_displacement:
            break
        weights = [(p, STRICTER * w if isinstance(p, TrackingPenalty) else w) for p, w in problem.penalties]
        problem = replace(problem, penalties=tuple(weights))
        tried = replace(cleaned, solution=inbetween(started_at(problem, best.solution), improved=improved))
        comparison = Comparison(tried)
        if not comparison.is_sound:
            break
        if comparison.largest_displacement < off:
            best = tried
    return best


def compared_links(figure: Figure) -> list[int]:
    """Return the links that are compared: free roots, and the ends of limbs."""
    parents = figure.tables.parents
    ends = [i for i in range(1, len(figure.links)) if not np.any(parents[1:] == i)]
    roots = [int(i) for i in figure.tables.free_links if i not in ends]
    return [*roots, *ends]


def _tips(samples: Samples, links: list[int]) -> Array:
    """Return the centres of mass (3, n, T) [m] of links."""
    centres = np.array([samples.figure.links[i].centre for i in links]).T
    return samples.links.points(np.array(links), centres)[0]


class PathMeasurement:
    """Measurements of one path."""

    def __init__(self, cleaned: Cleaned, path: Path, times: Array) -> None:
        self.cleaned, self.path, self.times = cleaned, path, times

    @property
    def ground(self) -> Ground:
        return self.cleaned.ground

    def _parts(self) -> Iterator[Samples]:
        return sample_runs(self.ground.figure, self.path, self.times)

    @cached_property
    def _soles(self) -> tuple[Array, Array, Array]:
        """Positions (3, p, T), heights (p, T) [m] and links' orientations (4, p, T) of the soles' points."""
        points = self.ground.points
        if not points or not self.ground.surfaces:
            return np.zeros((3, 0, self.times.size)), np.zeros((0, self.times.size)), np.zeros((4, 0, self.times.size))
        links, _, radius = arrays_of(points)
        parts = [(places_of(points, samples)[0], samples.links.Q[:, links]) for samples in self._parts()]
        places, turned = (np.concatenate(part, axis=2) for part in zip(*parts, strict=True))
        return places, height_over(self.ground.surfaces, places, radius)[0], turned

    def _resting(self, rests: Sequence[Rest]) -> Iterator[tuple[Rest, Array, Array, Array]]:
        """Yield every stance, its times (t,) [s], positions without the part of rolling (3, t), and heights (t,)."""
        places, heights, turned = self._soles
        row = {id(point): i for i, point in enumerate(self.ground.points)}
        for rest in rests:
            i = row.get(id(rest.point))
            during = (self.times >= rest.first) & (self.times <= rest.last)
            if i is not None and during.any():
                resting_heights = heights[i, during]
                if rest.ground is not None:
                    resting_heights = height_over(
                        (rest.ground,), places[:, [i]][..., during], np.array([rest.point.radius])
                    )[0][0]
                its_turns = turned[:, i, during]
                rolling = Rolling.of(rest, its_turns[:, its_turns.shape[1] // 2])
                yield rest, self.times[during], places[:, i, during] - rolling.displacement(its_turns), resting_heights

    def highest_soles(self, rests: Sequence[Rest]) -> Iterator[HighestSole]:
        """Yield the largest height in every stance."""
        for rest, times, _, heights in self._resting(rests):
            at = int(heights.argmax())
            yield HighestSole(rest, float(times[at]), float(heights[at]))

    @property
    def depth(self) -> float:
        return 1000 * float(depth(self.ground, self.path, self.times).max(initial=0.0))

    @property
    def slip(self) -> float:
        """The largest distance of a resting point from its mean position in a stance."""
        centred = [at - at.mean(axis=1, keepdims=True) for *_, at, _ in self._resting(self.cleaned.rests)]
        return 1000 * float(max((np.linalg.norm(each, axis=0).max() for each in centred), default=0.0))

    @property
    def hover(self) -> float:
        return 1000 * max((one.height for one in self.highest_soles(self.cleaned.rests)), default=0.0)

    @property
    def range(self) -> float:
        joints = joint_ranges(self.ground.figure)
        if not joints:
            return 0.0
        beyond = max(float(JointRange(joints).evaluate(samples).max()) for samples in self._parts())
        return float(np.degrees(np.sqrt(beyond)))

    @property
    def speed(self) -> float:
        joints = Speed.of(self.ground.figure, 0.0)
        return max(float(joints.speeds(samples).max(initial=0.0)) for samples in self._parts())

    @property
    def peak(self) -> float:
        return max(float(relative_accelerations(samples)[1].max(initial=0.0)) for samples in self._parts())

    @property
    def jerk(self) -> float:
        x = np.concatenate([samples.links.x[:, 1:] for samples in self._parts()], axis=2)
        return float(np.linalg.norm(np.diff(x, 3, axis=2), axis=0).mean()) * RATE**3 if x.shape[2] > 3 else 0.0

    @property
    def force(self) -> float:
        """The mean unsupported force at instants with known support, with the contact forces of stances."""
        support = next((p for p, _ in self.cleaned.problem.penalties if isinstance(p, Support)), None)
        if support is None:
            return 0.0
        rest = np.concatenate([support.rest(s)[:3][:, support.known(s.t)] for s in self._parts()], axis=1)
        return float(np.linalg.norm(rest, axis=0).mean()) if rest.size else 0.0
