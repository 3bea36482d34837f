"""The motion near a repaired recording that satisfies its stances, and its displacement from the recording."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dynsplines.solver.array import Array, Mask, runs
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.ground_alignment import align_to_ground, move_to_ground
from dynsplines.solver.contacts.recorded_stances import infer_stances, largest_noise
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.curve.spline import Path, natural_spline, path_of
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import continue_from, inbetween
from dynsplines.solver.penalty import TrackingPenalty, UnitMagnitude
from dynsplines.solver.problem import Problem
from dynsplines.solver.solution import Improvement, Solution
from dynsplines.solver.surface.points import places_of

from ..clip.context import Context
from ..clip.kinds import Options
from ..clip.tracking.problem import LONGEST_PANEL, NEXT_TO, POINTS, loose_frames, tracking_problem
from ..measure.depths import bunches, depths
from ..measure.measurement import RATE
from ..motion import even_times, sample_runs, samples_at
from .repairs import Repaired

SOFTEST, SOFTER = (1e-3, 0.03), (0.03,)  # factors of all weights but the recording's, in first and later searches
ROUGHLY = 0.1  # relative progress of E at which a search with reduced weights ends
FAITHFUL = 1.0  # detail that a segment may lose in a recording without noise, see `TrackingPenalty.times`
FAR, CLOSE = 0.02, 0.01  # [s] largest distance of the ends of a stance from a frame, with and without noise
SHARE = 0.25  # largest share of a stance at either end that is not sure
OUTSIDE = 0.04  # [s] time from the end of a stance to another frame, outside of the stance
ABOUT, AT_ONCE = 0.15, 2.0  # [s] interval around a new frame that is searched again, and longest such interval
LONG = 60.0  # [s] shortest recording that is searched again in parts only
SLIP, DEPTH = 0.005, 0.002  # [m] largest slip in a stance and depth in a surface, of a motion near its recording
DEEP = 0.001  # [m] least depth that a search should prevent
SHALLOW = LONGEST_PANEL / POINTS  # [s] between samples of a search, which so evaluates longer penetrations


@dataclass(frozen=True, eq=False)
class Cleaned:
    """A recording and its cleaned motion.

    before   the spline through the samples as recorded
    recorded the tracked recording: smoothed, and aligned with the ground
    rests    the stances that the motion satisfies
    raised   intervals in which points are at rest too high for a stance; empty for specified stances
    problem  the solved problem
    """

    context: Context
    before: Path
    recorded: Track
    rests: tuple[Contact, ...]
    raised: tuple[Contact, ...]
    problem: Problem
    solution: Solution

    @property
    def figure(self) -> Figure:
        return self.context.figure

    @property
    def after(self) -> Path:
        return path_of(self.solution.timeline)


def clean(
    context: Context,
    options: Mapping[str, Options],
    repaired: Repaired,
    specified: Sequence[Contact] | None = None,
    *,
    improved: Callable[[Improvement], None] | None = None,
) -> Cleaned:
    """Return the motion near a recording that satisfies its stances, by default those inferred from it.

    Args:
        options: The options of the soft constraints by kind, where they differ from the defaults.
    """
    figure = context.figure
    recorded = Track.of(figure, repaired.time, repaired.qpos, _by_state(figure, repaired.known))
    before = natural_spline(recorded.times, np.where(recorded.known > 0, recorded.states, recorded.bridged))
    recorded = move_to_ground(recorded, context.points, context.surfaces)
    rests, raised = tuple(specified or ()), tuple[Contact, ...]()
    if specified is None:
        rests, _ = infer_stances(recorded, context.points, context.surfaces, aligned=False)
    recorded = align_to_ground(recorded, rests, context.surfaces)
    if specified is None:
        rests, raised = infer_stances(recorded, context.points, context.surfaces)
    near = TrackingPenalty(recorded)

    def problem_of(rests: Sequence[Contact], times: Array, far: float = FAR) -> Problem:
        standing = context.with_schedule(on_ground=tuple(rests))
        return tracking_problem(near, standing, options, _times_with_ends(near, rests, times, far))

    is_noisy = largest_noise(recorded, context.points) > Thresholds.of(figure).noisy
    if is_noisy:
        sure = rests if specified is not None else tuple(_without_ends(context, recorded, rest) for rest in rests)
        tracking = _with_soft_start(problem_of(sure, near.times()), near, SOFTEST, improved)
        if specified is None:
            rests = _refined_stances(context, recorded, tracking)
            tracking = start_on(problem_of(rests, _times(tracking)), path_of(tracking.raw))
    else:
        tracking = problem_of(rests, near.times(FAITHFUL), far=CLOSE)
    if is_noisy or _is_deep(context, recorded):
        tracking = _with_soft_start(tracking, near, SOFTER, improved)
    tracking, solution = _out_of_edges(context, tracking, inbetween(tracking, improved=improved), improved)
    return Cleaned(context, before, recorded, rests, raised, tracking, solution)


def _out_of_edges(
    context: Context, problem: Problem, solution: Solution, improved: Callable[[Improvement], None] | None
) -> tuple[Problem, Solution]:
    """Continue the search with more frames where a point passed through an edge between two samples. A long recording
    is searched only around these frames: another search of all of it would double the time."""
    for _ in range(3):
        path, times = path_of(solution.timeline), solution.timeline.times
        more = missed_edge_times(context, path, times)
        if not more.size:
            break
        times = np.union1d(times, more)
        problem = replace(problem, keys=loose_frames(problem.figure, times, path.at(times)))
        if times[-1] - times[0] < LONG:
            solution = inbetween(problem, improved=improved)
        else:
            solution = continue_from(problem, problem.raw, between=list(_stretches(more)), improved=improved)
    return problem, solution


def _stretches(times: Array) -> Iterator[tuple[float, float]]:
    """Yield intervals [s] around rising times, of which close ones are merged up to the size of a window."""
    first = last = float(times[0])
    for time in times[1:].tolist():
        if time - last > 4 * ABOUT or time - first > AT_ONCE:
            yield first - ABOUT, last + ABOUT
            first = time
        last = time
    yield first - ABOUT, last + ABOUT


def _is_deep(context: Context, recorded: Track) -> bool:
    times = even_times(recorded.path.span, RATE)
    return bool(depth(context, recorded.path, times).max() > Thresholds.of(context.figure).hovers)


def _with_soft_start(
    problem: Problem, near: TrackingPenalty, shares: Sequence[float], improved: Callable[[Improvement], None] | None
) -> Problem:
    """Return the problem with its start at the solution for smaller weights of all penalties but the recording's. Stiff
    penalties, and a noisy recording deep in surfaces, would lead to a poor local minimum."""
    for share in shares:
        weights = tuple(
            (p, w if p is near or isinstance(p, UnitMagnitude) else share * w) for p, w in problem.penalties
        )
        roughly = replace(problem.settings, tolerance=ROUGHLY)
        solution = inbetween(replace(problem, penalties=weights, settings=roughly), improved=improved)
        problem = start_on(problem, path_of(solution.timeline))
    return problem


def _times_with_ends(near: TrackingPenalty, rests: Sequence[Contact], times: Array, far: float) -> Array:
    """Return times (M,) [s] of frames, more of them near the starts and ends of stances.

    Velocity and acceleration are 0 there, so that the path outside of a stance could hardly follow the recording
    without a frame `OUTSIDE` the end."""
    first, last = near.recorded.path.span
    ends = {time for rest in rests for time in (rest.first, rest.last)}
    outside = {time for rest in rests for time in (rest.first - OUTSIDE, rest.last + OUTSIDE) if first < time < last}
    for time in (*sorted(ends), *sorted(outside)):
        if np.abs(times - time).min() > far:
            times = np.sort(np.append(times, time))
    return times


def _times(problem: Problem) -> Array:
    return np.array([key.time for key in problem.keys])


def _without_ends(context: Context, recorded: Track, rest: Contact) -> Contact:
    """Return a stance without the times in which the point may already move, hidden by noise."""
    first, last = recorded.path.span
    unsure = min(Thresholds.of(context.figure).moment, SHARE * (rest.last - rest.first))
    return replace(
        rest,
        first=rest.first + unsure * (rest.first > first),
        last=rest.last - unsure * (rest.last < last),
    )


def _refined_stances(context: Context, recorded: Track, soft_problem: Problem) -> tuple[Contact, ...]:
    """Return the stances of a noisy recording after a search with the sure parts of its first ones.

    Brief stances are left out, at both ends of a recording also somewhat longer ones: noise hides that a foot moves."""
    calm = context.figure.to_qpos(path_of(soft_problem.raw).at(recorded.times))
    smoothed = Track.of(context.figure, recorded.times, calm)
    averaged = max(1.0, recorded.rate * Thresholds.of(context.figure).blurred)  # samples
    noise = largest_noise(recorded, context.points) / np.sqrt(averaged)
    stances, _ = infer_stances(smoothed, context.points, context.surfaces, noise)
    unsure, (first, last) = Thresholds.of(context.figure).moment, recorded.path.span

    def is_sure(stance: Contact) -> bool:
        is_cut_off = stance.first < first + unsure or stance.last > last - unsure
        return stance.last - stance.first >= (2 * unsure if is_cut_off else unsure)

    return tuple(stance for stance in stances if is_sure(stance))


def start_on(problem: Problem, path: Path) -> Problem:
    """Return a problem whose search starts on a path."""
    times = _times(problem)
    return replace(problem, keys=loose_frames(problem.figure, times, path.at(times)))


def _by_state(figure: Figure, known: Mask) -> Array:
    """Return the mask (T, N) of known states from that of qpos: orientations in the world need all ancestors."""
    out = known.astype(float)
    for link in figure.links[1:]:
        columns, above = quaternion_columns(link), quaternion_columns(figure.links[link.parent])
        if columns is not None and above is not None and figure.tables.in_world[link.joint + 1]:
            out[:, columns] *= out[:, above].min(axis=1, keepdims=True)
    return out


def depth(context: Context, path: Path, times: Array) -> Array:
    """Return the largest depth (T,) [m] of body and soles at times (T,)."""
    body, result = bunches((*context.body_above_soles, *context.points)), list[Array]()
    for samples in sample_runs(context.figure, path, times):
        result.append(np.zeros(samples.count))
        for surface in context.surfaces:
            for _, at, deep in depths(body, surface, samples):
                result[-1][at] = np.maximum(result[-1][at], deep.max(axis=0))
    return np.concatenate(result)


def missed_edge_times(context: Context, path: Path, frames: Array) -> Array:
    """Return times (k,) [s] for more frames beyond those at `frames` (M,) [s], where a foot passes through an edge
    unseen."""
    times = even_times(path.span, RATE)
    deep = depth(context, path, times)
    missed_times = list[float]()
    for first, end in runs(deep > DEEP):
        if (end - first) / RATE > SHALLOW:
            continue
        worst = float(times[first + deep[first:end].argmax()])
        after = int(np.clip(np.searchsorted(frames, worst), 1, frames.size - 1))
        about = frames[max(0, after - 2) : after + 2]
        wanted = [worst] if np.abs(frames - worst).min() > NEXT_TO else (0.5 * (about[1:] + about[:-1])).tolist()
        missed_times += [t for t in wanted if np.abs(frames - t).min() > NEXT_TO]
    return np.unique(missed_times)


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
        tried = replace(cleaned, solution=inbetween(start_on(problem, best.after), improved=improved))
        if not is_sound(tried):
            break
        if displacements(tried)[0].maximum < largest:
            best = tried
    return best


def is_sound(cleaned: Cleaned) -> bool:
    """Return whether nothing slips or penetrates."""
    figure, path = cleaned.figure, cleaned.after
    slips = (slip(figure, path, rest) for rest in cleaned.rests)
    return max(slips, default=0.0) <= SLIP and depth(cleaned.context, path, even_times(path.span, RATE)).max() <= DEPTH


def slip(figure: Figure, path: Path, rest: Contact) -> float:
    """Return the largest distance [m] of a resting point from its mean position, without the part of rolling."""
    samples = samples_at(
        figure, path, np.linspace(rest.first, rest.last, max(2, round((rest.last - rest.first) * RATE)))
    )
    rotation = samples.links.Q[:, rest.point.link]
    rolling = replace(rest, start=rotation[:, samples.count // 2])
    places = places_of((rest.point,), samples)[0][:, 0] - rolling.roll(rotation)
    return float(np.linalg.norm(places - places.mean(axis=1, keepdims=True), axis=0).max())
