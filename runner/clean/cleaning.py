"""The motion near a repaired recording that satisfies its stances, and its displacement from the recording."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.ground_alignment import align_to_ground, move_to_ground
from dynsplines.solver.contacts.recorded_stances import infer_stances, largest_noise
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.curve.spline import Path, natural_spline, path_of
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import TrackingPenalty, UnitMagnitude
from dynsplines.solver.problem import Improvement, Problem, Solution
from dynsplines.solver.search.minimum import Stop

from ..clip.context import Context
from ..clip.kinds import Options
from ..clip.tracking.problem import loose_frames, tracking_problem
from ..exchange.recording import Recording
from ..measure.depths import bunches, depths
from ..motion import RATE, even_times, sample_runs

SOFTNESS = (1e-3, 0.03)  # factors of all weights but the recording's in successive searches; later ones omit the first
ROUGHLY = 0.1  # relative progress of E at which a search with reduced weights ends
FAITHFUL = 1.0  # detail that a segment may lose in a recording without noise, see `TrackingPenalty.times`
FAR, CLOSE = 0.02, 0.01  # [s] largest distance of the ends of a stance from a frame, with and without noise
SHARE = 0.25  # largest share of a stance at either end that is not sure
OUTSIDE = 0.04  # [s] time from the end of a stance to another frame, outside of the stance


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
    repaired: Recording,
    known: Mask,
    specified: Sequence[Contact] | None = None,
    *,
    improved: Callable[[Improvement], None] | None = None,
) -> Cleaned:
    """Return the motion near a recording that satisfies its stances, by default those inferred from it.

    Args:
        options: The options of the soft constraints by kind, where they differ from the defaults.
        known: The entries of qpos that were recorded, (T, nq).
    """
    figure = context.figure
    recorded = Track.of(figure, repaired.time, repaired.qpos, _by_state(figure, known))
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

    is_noisy = largest_noise(recorded, context.points) > Thresholds.of(figure).slight
    if is_noisy:
        sure = rests if specified is not None else tuple(_without_ends(context, recorded, rest) for rest in rests)
        tracking = _with_soft_start(problem_of(sure, near.times()), near, SOFTNESS, improved)
        if specified is None:
            rests = _refined_stances(context, recorded, tracking)
            tracking = start_on(problem_of(rests, _times(tracking)), path_of(tracking.raw))
    else:
        tracking = problem_of(rests, near.times(FAITHFUL), far=CLOSE)
    if is_noisy or _is_deep(context, recorded):
        tracking = _with_soft_start(tracking, near, SOFTNESS[1:], improved)
    return Cleaned(context, before, recorded, rests, raised, tracking, inbetween(tracking, improved=improved))


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
        if solution.stop is Stop.INTERRUPTED:
            raise KeyboardInterrupt
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
    averaged = max(1.0, recorded.rate * Thresholds.of(context.figure).lift_off)  # samples
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


def displacements(cleaned: Cleaned) -> tuple[Array, dict[str, Array]]:
    """Return times (T,) [s], and how far free roots and the ends of limbs are then from the recording, by the names of
    their bodies, (T,) [m] each."""
    figure, times = cleaned.figure, even_times(cleaned.after.span, RATE)
    parents = figure.tables.parents
    ends = [i for i in range(1, len(figure.links)) if not np.any(parents[1:] == i)]
    links = [*(int(i) for i in figure.tables.free_links if i not in ends), *ends]
    sides = (sample_runs(figure, path, times) for path in (cleaned.recorded.path, cleaned.after))
    runs = [
        np.linalg.norm(_centres(one, links) - _centres(other, links), axis=0) for one, other in zip(*sides, strict=True)
    ]
    return times, dict(zip(map(figure.body_name, links), np.concatenate(runs, axis=1), strict=True))


def _centres(samples: Samples, links: list[int]) -> Array:
    """Return the centres of mass (3, n, T) [m] of links."""
    centres = np.array([samples.figure.links[i].centre for i in links]).T
    return samples.links.points(np.array(links), centres)[0]
