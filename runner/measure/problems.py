"""Violations of a motion, worst first.

A quick check on a grid fine enough for motion between images, where `report` takes some seconds. Violations within a
keyframe are reported for the keyframe, and not again for the path next to it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.inbetween import hard_ranges
from dynsplines.solver.penalty import (
    BendLimits,
    Contact,
    Hold,
    Penalty,
    Placement,
    Planted,
    Rest,
    Resting,
    Rolling,
    SelfContact,
    Stance,
    Sum,
    slipped,
    stances,
)
from dynsplines.solver.refine.limits import farthest
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.points import Point, arrays_of, body_points, places_of

from ..clip import load as clips
from ..clip.kinds import BODY, bolted_links, steady_joints
from ..clip.load import Clip
from ..clip.pose_report import standing_trees
from ..errors import UserError
from ..motion import Saved, samples_at
from . import measures
from .bounds import BOUNDS
from .measures import Hits, Measure, Row

RATE = 240.0  # [1/s]: a foot at 4 m/s goes 17 mm from one look to the next
RUN = 1000  # samples looked at at once, whose arrays do not fill the memory
MOST_TOLD = 10
FEW = 60  # samples of what a whole motion is like
ROUNDING = 1e-9  # [s]


@dataclass(frozen=True)
class Flaw:
    """One violation.

    kind      of `dynsplines.measure.bounds.BOUNDS`
    name      of the point, joint or contact
    time      [s] when it is worst; None for what is of no one time
    amount    how much, in `unit` ("m", "degrees", "rad/s²" or ""); bound: the tolerated amount
    keyframe  the number, from 1, of the keyframe that causes it; None if the path does
    text      all of it in one line
    """

    kind: str
    name: str
    time: float | None
    amount: float
    unit: str
    bound: float
    keyframe: int | None
    text: str

    @property
    def severity(self) -> float:
        """How many times its bound it is."""
        return self.amount / self.bound

    def __str__(self) -> str:
        return self.text


def problems(clip: Clip, timeline: Timeline, raw: Timeline, stop: Stop = Stop.CONVERGED) -> tuple[Flaw, ...]:
    """What is wrong with a timeline that is to answer a clip, worst first.

    raw   the raw spline through its keyframes, by which a whip is told
    stop  why the search ended
    """
    found = list(_found(clip, timeline, raw))
    if stop in (Stop.BUDGET, Stop.STUCK):
        bound = BOUNDS["search"]
        text = f"the search ended before it was done: {stop.value}"
        found.append(Flaw("search", stop.name.lower(), None, bound.most, bound.unit, bound.most, None, text))
    return tuple(sorted(found, key=lambda problem: -problem.severity))


def of_motion(saved: Saved) -> tuple[Flaw, ...]:
    """What is wrong with a motion, by what its file holds."""
    try:
        clip = clips.answered(saved)
    except UserError:  # a text that this program cannot read, in a file from elsewhere
        clip = clips.of_motion(replace(saved, text=""))
    return problems(clip, saved.timeline, saved.raw, stop_of(saved))


def stop_of(saved: Saved) -> Stop:
    """Why the search of a motion ended, where there was one."""
    return Stop.__members__.get(str(saved.search.get("stop")), Stop.CONVERGED)


def is_recording(saved: Saved) -> bool:
    """Whether a motion is nothing but its keyframes: no search is to blame for any of it."""
    return not saved.search and saved.timeline.variable_count == 0


def lines(found: Sequence[Flaw], file: object = None) -> list[str]:
    """For the terminal: a line each of the worst, and how many more there are."""
    told: dict[tuple[str, int], int] = {}
    first: list[Flaw] = []
    for problem in found:
        if problem.keyframe is not None:
            place = problem.kind, problem.keyframe
            told[place] = told.get(place, 0) + 1
            if told[place] > 1:
                continue
        first.append(problem)
    out = []
    for problem in first[:MOST_TOLD]:
        others = told.get((problem.kind, problem.keyframe or 0), 1) - 1
        out.append(f"problem: {problem.text}" + (f"; {others} more like it there" if others else ""))
    more = len(first) - MOST_TOLD
    return [*out, f"... and {more} more" + (f": dynsplines report {file}" if file else "")] if more > 0 else out


def by_name(found: Sequence[Flaw]) -> tuple[Flaw, ...]:
    """Return the worst violation of each point, joint or contact of a recording, worst first, with their count.

    Every sample of a recording is a keyframe; listed one by one, a single joint would fill the terminal.
    """
    groups: dict[tuple[str, str], list[Flaw]] = {}
    for flaw in found:
        groups.setdefault((flaw.kind, flaw.name), []).append(flaw)
    out = []
    for first, *others in groups.values():
        samples = len({flaw.keyframe for flaw in (first, *others)})
        text = first.text.removeprefix(f"keyframe {first.keyframe} itself: ")
        out.append(replace(first, keyframe=None, text=f"{text}, {samples} samples in all" if samples > 1 else text))
    return tuple(out)


def plain(found: Sequence[Flaw]) -> list[dict[str, Any]]:
    """For JSON."""
    return [asdict(problem) for problem in found]


def _found(clip: Clip, timeline: Timeline, raw: Timeline) -> Iterator[Flaw]:
    clip = _as_keyed(clip)
    figure, path = clip.figure, path_of(timeline)
    key_times = np.array([key.time for key in clip.keys])
    said = {key.time for key in clip.said}
    numbers = np.cumsum([key.time in said for key in clip.keys])
    held = list(_held(clip, timeline))
    ends = [t for each in held for stance in each.stances for t in (stance.first, stance.last)]
    ends += [t for hold in clip.context.holds for t in (hold.first, hold.last)]
    time = _grid(timeline, key_times, ends)
    grid, keys = samples_at(figure, path, time), samples_at(figure, path, key_times)
    raw_peak = _peak(samples_at(figure, path_of(raw), time))
    for measure in (*held, *_slips(clip, timeline), *_measures(clip, raw_peak)):
        yield from _worst(measure, grid, keys, numbers)
    yield from _drifts(held, key_times, numbers)
    yield from _misses(clip, timeline)
    yield from _aloft(clip, grid, keys, numbers)
    yield from _beyond_hard(clip, timeline)


def _aloft(clip: Clip, grid: Samples, keys: Samples, numbers: Index) -> Iterator[Flaw]:
    """A jointed figure that moves about and is above the ground all the time, without a flight in the clip."""
    context, figure = clip.context, clip.figure
    flies = context.support is not None and context.support.flights
    if flies or context.holds or context.contacts.given or not np.any(figure.gravity):
        return
    for root in standing_trees(figure):
        points = [point for point in body_points(figure) if figure.tables.path[point.link, root]]
        if not figure.tables.children[root] or not points or not context.surfaces:
            continue
        sparse = grid.taken(np.arange(0, grid.count, max(1, grid.count // FEW)))
        low, time = min(
            (_lowest(context.surfaces, points, samples) for samples in (keys, sparse)), key=lambda at: round(at[0], 3)
        )
        bound = BOUNDS["aloft"].most
        if bound < low < np.inf:
            k = np.flatnonzero(keys.t == time)
            text = f"the figure never comes down: lowest point {low:.2f} m above the floor"
            row = Row("aloft", figure.links[root].name, text, bound)
            yield _problem(row, low, time, int(numbers[k[0]]) if k.size else None)


def _lowest(surfaces: Sequence[Surface], points: Sequence[Point], samples: Samples) -> tuple[float, float]:
    """[m] the least height of any point above what is below it, and when [s]."""
    links, positions, radii = arrays_of(points)
    centres, _ = samples.links.points(links, positions)
    above = np.min([surface.height(centres) for surface in surfaces], axis=0) - radii[:, None]
    lows = above.min(axis=0)
    return float(lows.min()), float(samples.t[int(lows.argmin())])


def _as_keyed(clip: Clip) -> Clip:
    """Of a recording's frames, which nobody gave, the first and the last beside the keyframes."""
    said, ends = {key.time for key in clip.said}, (0, len(clip.keys) - 1)
    nothing = np.zeros(clip.figure.width, bool)
    keys = tuple(
        key if key.time in said else replace(key, fixed=nothing)
        for k, key in enumerate(clip.keys)
        if key.time in said or k in ends
    )
    return clip if len(keys) == len(clip.keys) else replace(clip, problem=replace(clip.problem, keys=keys))


def _slips(clip: Clip, timeline: Timeline) -> Iterator[Measure]:
    """The clip's holds, beside where they began."""
    held = clip.context.holds
    if held:
        placed = measures.links_placed(clip.figure, np.array([key.fixed for key in clip.keys]))
        yield measures.slips(
            clip.context.holds, [begun(clip.figure, timeline, hold) for hold in clip.context.holds], placed
        )


def begun(figure: Figure, timeline: Timeline, hold: Hold) -> Array:
    """(3,) [m] where on the link that it holds a hold's point is when it begins."""
    return slipped(samples_at(figure, path_of(timeline), np.array([hold.first])), hold)[:, 0]


def _grid(timeline: Timeline, key_times: Array, ends: Sequence[float]) -> Array:
    """(T,) [s] so many a second, and the instants that matter: of keyframes, and the ends of contacts and holds."""
    first, last = float(timeline.times[0]), float(timeline.times[-1])
    even = np.linspace(first, last, max(2, round((last - first) * RATE) + 1))
    return np.unique(np.concatenate([even, np.clip(key_times, first, last), np.array(ends, float)]))


def _peak(samples: Samples) -> float:
    """[rad/s²] of all links relative to their parents, but for roots."""
    rows = measures.turning(samples.figure)
    return max((float(measures.turns(part)[rows].max(initial=0.0)) for part in samples.parts(RUN)), default=0.0)


def _measures(clip: Clip, raw_peak: float) -> Iterator[Measure]:
    figure, fixed = clip.figure, np.array([key.fixed for key in clip.keys])
    placed = measures.links_placed(figure, fixed)
    parts = list(_parts(clip))
    yield measures.Sunk(_kept_out(clip, parts), frozenset(point.name for point in clip.context.points), placed)
    rests = [rest for part in parts if isinstance(part, Resting) for rest in part.rests]
    optional: tuple[Measure | None, ...] = (
        measures.hovering(rests, clip.context.surfaces, placed) if rests and clip.context.surfaces else None,
        measures.ranges(figure, fixed),
        None if clip.follows else measures.overshoots(steady_joints(clip.context), len(clip.keys)),
        measures.coupled(figure, fixed),
        measures.torn(figure, placed),
        measures.lengths(figure, len(clip.keys)),
        measures.whips(figure, raw_peak, len(clip.keys)),
    )
    yield from (measure for measure in optional if measure is not None)
    for part in parts:
        if isinstance(part, BendLimits) and part.joints:
            yield measures.bends(figure, part, fixed)
        if isinstance(part, SelfContact) and part.pairs.size:
            yield measures.Tangled(figure, part, placed)


def _parts(clip: Clip) -> Iterator[Penalty]:
    """The soft constraints, those that stand together one by one."""
    for penalty, _ in clip.penalties:
        yield from penalty.parts if isinstance(penalty, Sum) else (penalty,)


def _kept_out(clip: Clip, parts: Sequence[Penalty]) -> tuple[Contact, ...]:
    """Soles and body, and what they are to stay out of, whether or not the clip has it penalised."""
    found = [part for part in parts if isinstance(part, Contact)]
    names = {part.name for part in found}
    if Contact.called not in names:
        found.append(Contact(clip.context.points, clip.context.surfaces))
    if BODY not in names:
        body, bolted = body_points(clip.figure), bolted_links(clip.figure)
        for surface in clip.context.surfaces:
            links = bolted.get(surface.name, frozenset())
            found.append(Contact(tuple(point for point in body if point.link not in links), (surface,)))
    return tuple(part for part in found if part.points and part.surfaces)


def _held(clip: Clip, timeline: Timeline) -> Iterator[measures.Held]:
    """The clip's contacts, and the stances inferred from its keyframes."""
    figure, fixed = clip.figure, np.array([key.fixed for key in clip.keys])
    placed = measures.links_placed(figure, fixed)
    known = [part.stances for part in _parts(clip) if isinstance(part, Planted)]
    rests = clip.context.contacts.given
    if rests:
        middle = samples_at(figure, path_of(timeline), np.array([0.5 * (rest.first + rest.last) for rest in rests]))
        spots = np.diagonal(places_of([rest.point for rest in rests], middle)[0], axis1=1, axis2=2)
        pieces = [list(_pieces(rest, known, spot)) for rest, spot in zip(rests, spots.T, strict=True)]
        groups = np.repeat(np.arange(len(pieces)), [len(some) for some in pieces])
        says = [f"contact {stance.point.name} moves {{}} while it should rest" for some in pieces for stance in some]
        flat = tuple(stance for some in pieces for stance in some)
        rolling = tuple(Rolling.of(rests[k], middle.links.Q[:, rests[k].point.link, k]) for k in groups.tolist())
        yield measures.Held("contact", flat, groups, tuple(says), placed, rolling)
    told = [
        stance
        for stance in _told(clip, timeline)
        if not any(_same(stance, rest) for rest in clip.context.contacts.given)
    ]
    if told:
        feet = [(stance.point.link, stance.first) for stance in told]
        _, groups = np.unique(feet, axis=0, return_inverse=True)
        says = [f"{stance.point.name} moves {{}} between keyframes that put it in one place" for stance in told]
        yield measures.Held("stance", tuple(told), groups.ravel(), tuple(says), placed)


def _told(clip: Clip, timeline: Timeline) -> tuple[Stance, ...]:
    """The stances of soles inferred from keyframes."""
    states = path_of(timeline).at(np.array([key.time for key in clip.keys]))
    frames = [replace(key, state=state) for key, state in zip(clip.keys, states, strict=True)]
    return stances(
        clip.figure, Timeline(tuple(frames), np.zeros((2, timeline.width))), clip.context.points, clip.context.surfaces
    )


def _same(stance: Stance, rest: Rest) -> bool:
    """Whether a stance and a contact speak of one point at one time."""
    meet = stance.first < rest.last - ROUNDING and rest.first < stance.last - ROUNDING
    same = stance.point.link == rest.point.link and np.array_equal(stance.point.position, rest.point.position)
    return bool(meet and same)


def _pieces(rest: Rest, known: Sequence[Sequence[Stance]], middle: Array) -> Iterator[Stance]:
    """Where a contact's point is to be: as somebody says, else where it is in the middle of the contact, (3,) [m]."""
    said = [s for some in known for s in some if _same(s, rest) and s.first >= rest.first - ROUNDING]
    said = [stance for stance in said if stance.last <= rest.last + ROUNDING]
    yield from said or [Stance(rest.point, rest.first, rest.last, middle, middle)]


def _drifts(held: Sequence[measures.Held], key_times: Array, numbers: Index) -> Iterator[Flaw]:
    """Keyframes that put a point that is to rest somewhere else than the keyframe before."""
    for measure in held:
        bound = BOUNDS[measure.kind].most
        worst: dict[tuple[int, int], tuple[float, Stance]] = {}
        for group, stance in zip(measure.groups.tolist(), measure.stances, strict=True):
            drift = float(np.linalg.norm(stance.landed - stance.spot))
            place = group, int(np.argmin(np.abs(key_times - stance.last)))
            if drift > max(bound, worst[place][0] if place in worst else 0.0):
                worst[place] = drift, stance
        for (_, k), (drift, stance) in worst.items():
            name = stance.point.name
            says = f"{name}, which is to rest, is {{}} from where the keyframe before has it"
            yield _problem(Row(measure.kind, name, says, bound), drift, stance.last, int(numbers[k]))


def _misses(clip: Clip, timeline: Timeline) -> Iterator[Flaw]:
    """Points that were left to the search and are not where they were to be."""
    for point in clip.context.placed:
        samples = samples_at(clip.figure, path_of(timeline), np.array([point.time]))
        away = float(np.linalg.norm(Placement((point,)).away(samples)[1]))
        name, bound = point.point.name, BOUNDS["placement"].most
        if away > bound:
            yield _problem(Row("placement", name, f"{name} is {{}} off its place", bound), away, point.time)


def _beyond_hard(clip: Clip, timeline: Timeline) -> Iterator[Flaw]:
    """Joints beyond ranges that the clip makes hard, at any time."""
    for joint, over, time in farthest(clip.figure, timeline, hard_ranges(clip.penalties)):
        slides = joint.kind is JointKind.SLIDE
        kind, amount = ("hard travel", over) if slides else ("hard range", float(np.degrees(over)))
        bound = BOUNDS[kind].most
        if amount > bound:
            yield _problem(Row(kind, joint.name, f"{joint.name} is {{}} beyond its hard range", bound), amount, time)


def _worst(measure: Measure, grid: Samples, keys: Samples, numbers: Index) -> Iterator[Flaw]:
    """The worst of every group that keyframes say, each by its number (K,), and that the path adds."""
    groups = measure.groups
    said = _said(measure, keys)
    caps: dict[int, Array] = {}
    for (group, k), (amount, row) in said.items():
        yield _problem(measure.row(row), amount, float(keys.t[k]), int(numbers[k]))
        caps.setdefault(group, np.zeros(keys.count))[k] = amount
    worst: dict[int, tuple[float, float, int]] = {}
    for part in _strided(grid, measure.stride):
        hits = measure.hits(part)
        hits = _beyond_keyframes(measure, hits, part.t, keys.t, caps)
        for group in np.unique(groups[hits.row]):
            own = np.flatnonzero(groups[hits.row] == group)
            best = int(own[np.argmax(hits.amount[own])])
            if hits.amount[best] > worst.get(int(group), (0.0, 0.0, 0))[0]:
                row = _named(measure, hits, own, best)
                worst[int(group)] = float(hits.amount[best]), float(part.t[hits.at[best]]), row
    for amount, time, row in worst.values():
        yield _problem(measure.row(row), amount, time)


def _strided(grid: Samples, stride: int) -> list[Samples]:
    return (grid if stride == 1 else grid.taken(np.arange(0, grid.count, stride))).parts(RUN)


def _named(measure: Measure, hits: Hits, own: Index, best: int) -> int:
    """The row to name for the worst hit of a group."""
    together = own[hits.at[own] == hits.at[best]]
    some = Hits(hits.row[together], hits.at[together], hits.amount[together])
    return measure.named(some, int(np.flatnonzero(together == best)[0]))


def _said(measure: Measure, keys: Samples) -> dict[tuple[int, int], tuple[float, int]]:
    """What keyframes say themselves: by group and keyframe the largest amount, and the row to name."""
    hits, groups = measure.hits(keys), measure.groups
    kept = np.array([measure.given(int(row))[k] for row, k in zip(hits.row, hits.at, strict=True)], bool)
    hits = Hits(hits.row[kept], hits.at[kept], hits.amount[kept])
    found: dict[tuple[int, int], tuple[float, int]] = {}
    for group, k in set(zip(groups[hits.row].tolist(), hits.at.tolist(), strict=True)):
        own = np.flatnonzero((groups[hits.row] == group) & (hits.at == k))
        best = int(own[np.argmax(hits.amount[own])])
        found[group, k] = float(hits.amount[best]), _named(measure, hits, own, best)
    return found


def _beyond_keyframes(measure: Measure, hits: Hits, time: Array, key_times: Array, caps: dict[int, Array]) -> Hits:
    """The hits that are farther beyond their bounds than the keyframes before and after them."""
    if not caps or not hits.row.size:
        return hits
    groups = measure.groups[hits.row]
    before = np.clip(np.searchsorted(key_times, time[hits.at], side="right") - 1, 0, key_times.size - 2)
    none = np.zeros(key_times.size)
    between = {group: np.maximum(cap[:-1], cap[1:]) for group, cap in caps.items()}
    let = np.array([between.get(g, none)[k] for g, k in zip(groups.tolist(), before.tolist(), strict=True)])
    bound = np.array([measure.row(int(row)).bound if free else 0.0 for row, free in zip(hits.row, let, strict=True)])
    kept = hits.amount > let + bound
    return Hits(hits.row[kept], hits.at[kept], hits.amount[kept])


def _problem(row: Row, amount: float, time: float | None, keyframe: int | None = None) -> Flaw:
    unit = BOUNDS[row.kind].unit
    text = row.says.format(_spoken(amount, unit)) + ("" if time is None else f" at {time:.2f} s")
    if keyframe is not None:
        text = f"keyframe {keyframe} itself: {text}"
    return Flaw(row.kind, row.name, time, amount, unit, row.bound, keyframe, text)


def _spoken(amount: float, unit: str) -> str:
    if unit == "m" and amount < 0.001:
        return f"{1000 * amount:.2g} mm"
    if unit == "degrees" and amount < 1:
        return f"{amount:.2g}°"
    if unit == "m":
        return f"{1000 * amount:.0f} mm" if amount < 1 else f"{amount:.2f} m"
    if unit == "degrees":
        return f"{amount:.0f}°"
    return f"{amount:.0f} {unit}" if unit else f"{amount:.2f}"
