"""Measurement of a motion: the amounts of all checks of its clip, on one grid.

The measured quantities do not depend on which ones the clip penalizes. Violations and reports use the same amounts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.contacts import Contact
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solver.figure.figure import Figure, sets_joints
from dynsplines.solver.penalty import BendLimits, Collision, Sum, grasp_places, joint_ranges
from dynsplines.solver.penalty.motion.acceleration import relative_accelerations
from dynsplines.solver.surface.points import Point, places_of
from dynsplines.solver.tolerances import ROUNDING

from ..clip.build import Clip
from ..clip.kinds import BODY, KINDS, body_contacts
from ..motion import RATE, Saved, even_times, sample_runs, samples_at
from . import checks
from .bounds import Row
from .checks import Check, Fixed, Hits


@dataclass(frozen=True, eq=False)
class Measurement:
    """The amounts of all checks along a timeline of a clip.

    clip    the clip; if it follows a recording, its frames are only the specified keyframes, the first and the last
    time    (T,) [s] of the grid;  key_at  (K,) indices of the keyframes in it
    checks  each with the amounts of its rows
    targets  contacts whose points must not move: "contact", those of the clip, and "stance", inferred from keyframes
    """

    clip: Clip
    timeline: Timeline
    time: Array
    key_at: Index
    checks: tuple[tuple[Check, Hits], ...]
    targets: Mapping[str, Sequence[Contact]]

    @classmethod
    def of(cls, clip: Clip, timeline: Timeline, raw: Timeline) -> Measurement:
        """Measure a timeline; `raw` is the raw spline, whose angular accelerations are the reference for whips."""
        clip, path = _as_keyed(clip), path_of(timeline)
        key_times = np.clip([key.time for key in clip.keys], *path.span)
        targets = {"contact": _contacts(clip, timeline), "stance": _stances(clip, timeline)}
        contacts = (*targets["contact"], *targets["stance"], *clip.context.schedule.grasps)
        instants = [t for contact in contacts for t in (contact.first, contact.last)]
        time = np.unique(np.concatenate([even_times(path.span, RATE), key_times, instants]))
        key_at = np.searchsorted(time, key_times)
        every = list(_checks(clip, timeline, targets, _peak(clip.figure, raw, time)))
        parts: list[list[Hits]] = [[] for _ in every]
        for samples in sample_runs(clip.figure, path, time):
            first = np.searchsorted(time, samples.t[0])
            for check, hits in zip(every, parts, strict=True):
                part = check.hits(samples)
                hits.append(replace(part, at=first + part.at))
        amounts = tuple((check, Hits.join(hits)) for check, hits in zip(every, parts, strict=True))
        return cls(clip, timeline, time, key_at, amounts, targets)

    def largest(self) -> dict[str, tuple[Row, float, float]]:
        """Return the row, the amount and the time [s] of the largest amount of every kind of violation, if positive."""
        kinds: dict[str, tuple[Row, float, float]] = {}
        for check, hits in self.checks:
            for i in hits.largest(np.where(hits.amount > 0, hits.row, -1)).tolist():
                row, amount = check.row(int(hits.row[i])), float(hits.amount[i])
                if row.kind not in kinds or amount > kinds[row.kind][1]:
                    kinds[row.kind] = row, amount, float(self.time[hits.at[i]])
        return kinds

    @classmethod
    def sides(cls, clip: Clip, motion: Saved) -> tuple[Measurement, Measurement]:
        """Return the measurements of the raw spline and of a motion."""
        before = cls.of(clip, motion.raw, motion.raw)
        return before, before if motion.is_raw else cls.of(clip, motion.timeline, motion.raw)

    def by_kind(self, *, relative: bool = False) -> dict[str, Array]:
        """Return the largest amount (T,) of every kind of violation at the times of the grid, at least 0.

        relative  whether amounts are divided by their bounds
        """
        kinds: dict[str, Array] = {}
        for check, hits in self.checks:
            hits = replace(hits, amount=hits.amount / check.bounds[hits.row]) if relative else hits
            rows, which = np.unique(hits.row, return_inverse=True)
            kind_of_row = np.array([check.row(row).kind for row in rows.tolist()])
            for kind in np.unique(kind_of_row).tolist():
                of_kind = hits.select(kind_of_row[which] == kind)
                np.maximum.at(kinds.setdefault(kind, np.zeros(self.time.size)), of_kind.at, of_kind.amount)
        return kinds

    @property
    def sparse(self) -> Index:
        """The indices of `sparse_times` in the grid."""
        return np.searchsorted(self.time, sparse_times(path_of(self.timeline)))

    @property
    def numbers(self) -> Index:
        """(K,) numbers of the keyframes as specified, from 1; 0 for a frame of the recording."""
        specified = {key.time for key in self.clip.authored_keys}
        is_specified = np.array([key.time in specified for key in self.clip.keys])
        return np.where(is_specified, np.cumsum(is_specified), 0)


def sparse_times(path: Path) -> Array:
    """Return every fourth of the equally spaced times [s] of the grid, for quantities that are slow to compute."""
    return even_times(path.span, RATE)[::4]


def _as_keyed(clip: Clip) -> Clip:
    """Return a clip with few frames if it follows a recording: the keyframes, and the first and the last frame."""
    key_times, ends = {key.time for key in clip.authored_keys}, (0, len(clip.keys) - 1)
    nothing = np.zeros(clip.figure.width, bool)
    keys = tuple(
        key if key.time in key_times else replace(key, fixed=nothing)
        for k, key in enumerate(clip.keys)
        if key.time in key_times or k in ends
    )
    return clip if len(keys) == len(clip.keys) else replace(clip, problem=replace(clip.problem, keys=keys))


def _peak(figure: Figure, raw: Timeline, time: Array) -> float:
    """Return the largest angular acceleration [rad/s²] of a link relative to its parent on the raw spline."""
    runs = sample_runs(figure, path_of(raw), time[::2])
    return max(float(relative_accelerations(samples)[1].max(initial=0.0)) for samples in runs)


def _checks(
    clip: Clip, timeline: Timeline, targets: Mapping[str, Sequence[Contact]], raw_peak: float
) -> Iterator[Check]:
    figure, context = clip.figure, clip.context
    fixed = Fixed(figure, np.array([key.fixed for key in clip.keys]))
    feet = feet_of(figure, context.points)
    for kind, contacts in targets.items():
        if contacts:
            yield checks.displacements(kind, contacts, _groups(contacts, feet), fixed)
    if context.schedule.grasps:
        path = path_of(timeline)
        starts = [
            grasp_places(samples_at(figure, path, np.array([grasp.first])), grasp)[:, 0]
            if grasp.specified is None
            else grasp.specified
            for grasp in context.schedule.grasps
        ]
        yield checks.slips(context.schedule.grasps, starts, fixed)
    if context.schedule.turns:
        yield checks.turns(context.schedule.turns, path_of(timeline), fixed)
    soles = frozenset(point.name for point in context.points)
    yield checks.penetrations(_obstacle_contacts(clip), soles, feet, fixed)
    rests = [rest for contacts in _penalties(clip, "hover") for rest in contacts.resting]
    if rests and context.surfaces:
        yield checks.hovering(rests, context.surfaces, _groups(rests, feet), fixed)
    joints = joint_ranges(figure)
    if joints:
        fixed_joints = sets_joints(figure, fixed.states, [joint.link for joint in joints])
        yield checks.ranges(joints, ("range", "travel"), "{joint.name} is {} beyond its range", fixed_joints)
    if context.holds and not clip.has_recording:
        text = "{joint.name} swings {} away from its values in the keyframes at {joint.first:g} and {joint.last:g} s"
        yield checks.ranges(context.holds, ("overshoot", "overshoot travel"), text)
    optional = (
        checks.coupling_errors(fixed),
        checks.loop_gaps(fixed),
        checks.lengths(figure),
        checks.whips(figure, raw_peak),
        checks.self_overlaps(context.schedule.grasped, fixed),
    )
    yield from (check for check in optional if check is not None)
    if context.bends:
        limits = next(_penalties(clip, "twist"), None)
        yield checks.bends(limits or BendLimits(context.bends), fixed, np.inf if limits is None else None)
    yield from (checks.speeds(figure, limit) for limit in _penalties(clip, "speed"))


def _penalties(clip: Clip, violation: str) -> Iterator[Any]:
    """Yield the clip's soft constraints that a kind of violation measures, see `KINDS`. Of a `Sum`, yield its parts."""
    terms = {kind.term(part) for kind in KINDS.values() for part in kind.parts if violation in part.violations}
    for penalty, _ in clip.penalties:
        if penalty.name in terms:
            yield from penalty.parts if isinstance(penalty, Sum) else (penalty,)


def _obstacle_contacts(clip: Clip) -> tuple[Collision, ...]:
    """Return soles and body with the surfaces that they must avoid, whether or not the clip penalises it."""
    contacts = list(_penalties(clip, "penetration"))
    if clip.has_recording:  # whose own contacts have the corners of bodies only
        contacts = [part for part in contacts if part.name != BODY]
    names = {part.name for part in contacts}
    if Collision.name not in names:
        contacts.append(Collision(clip.context.points, clip.context.surfaces))
    if BODY not in names:
        contacts += body_contacts(clip.context)
    return tuple(part for part in contacts if part.points and part.surfaces and not part.carrier)


def feet_of(figure: Figure, points: Sequence[Point]) -> Index:
    """Return for each link (L,) the link that represents it: of toes the foot, of any other link itself."""
    feet, soles = np.arange(len(figure.links)), {point.link for point in points}
    for i, link in enumerate(figure.links[1:], start=1):
        if i in soles and link.parent in soles:
            feet[i] = feet[link.parent]
    return feet


def _groups(rests: Sequence[Contact], feet: Index) -> Index:
    """Return a number (n,) for every foot and interval; overlapping intervals of a foot are one."""
    order = sorted(range(len(rests)), key=lambda i: (feet[rests[i].point.link], rests[i].first))
    groups, number, foot, end = np.zeros(len(rests), np.intp), -1, -1, -np.inf
    for i in order:
        if feet[rests[i].point.link] != foot or rests[i].first > end - ROUNDING:
            number, end = number + 1, -np.inf
        groups[i], foot, end = number, feet[rests[i].point.link], max(end, rests[i].last)
    return groups


def is_imported(clip: Clip, timeline: Timeline) -> bool:
    """Return whether a motion is a recording as imported, whose keyframes are its samples."""
    return not clip.text and timeline.variable_count == 0


def _contacts(clip: Clip, timeline: Timeline) -> list[Contact]:
    """Return the clip's contacts with their places: specified, else those in keyframes, else that in mid-contact."""
    rests, out = clip.context.schedule.on_ground, list[Contact]()
    if not rests:
        return out
    middle = samples_at(clip.figure, path_of(timeline), np.array([0.5 * (rest.first + rest.last) for rest in rests]))
    places, _ = places_of([rest.point for rest in rests], middle)
    for k, rest in enumerate(rests):
        rest = replace(rest, start=middle.links.Q[:, rest.point.link, k])
        if rest.specified is not None or not rest.is_placed:
            place = places[:, k, k] if rest.specified is None else rest.specified
            rest = replace(rest, places=place[None], times=np.array([rest.first]), slack=None)
        out.append(rest)
    return out


def _stances(clip: Clip, timeline: Timeline) -> list[Contact]:
    """Return the stances of soles inferred from keyframes, with unspecified entries from the motion.

    Frames of a recording are samples, not poses: a foot that lands between two of them is near its place in both.
    """
    shortest = Thresholds.of(clip.figure).far_apart if is_imported(clip, timeline) else 0.0
    states = path_of(timeline).at(np.array([key.time for key in clip.keys]))
    frames = [replace(key, state=state) for key, state in zip(clip.keys, states, strict=True)]
    keys = Timeline(tuple(frames), np.zeros((2, timeline.width)))
    stances = replace(clip.context.schedule, keys=keys).stances
    return [stance for stance in stances if stance.last - stance.first > shortest]
