"""Posing of the free entries of partial keyframes: feet with a stance keep it.

A straight leg has no gradient that bends it, so the search alone cannot find a squat. The goals of a pose are points
that rest in a [[contact]] at the keyframe's time, sites that a [[grasp]] keeps on a body, sole points with one position
in the keyframes before and after, and positions left to the search. The entries on which these depend start in the
pose and remain free.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.contacts import Contact, ContactSchedule, Interval
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import BendLimits
from dynsplines.solver.posing import (
    Balance,
    BodyGoal,
    Goal,
    PointGoal,
    entries_of,
    find_pose,
    in_winding,
)
from dynsplines.solver.surface import Surface, static_surfaces
from dynsplines.solver.surface.points import Point, sets_places
from dynsplines.solver.tolerances import NEGLIGIBLE

from ..contacts import schedule_of
from ..kinds import posing_limits
from ..parse import Parsed
from ..table import ContactTable
from .grounding import put_down

STARTS = 4  # most starting poses
BALANCE = 100.0  # [1/m] weight of the preference of balance, relative to 1 rad of a limb joint
OWN_TURN = 1e-3  # weight of a foot's orientation relative to its points, two of which do not determine it
TURNS = 4  # iterations, each from the previous orientation, which remove this bias


def fit_rotation(own: Array, seen: Array, turn: Array) -> Array:
    """Return the rotation (4,) that takes vectors `own` (n, 3) nearest to `seen` (n, 3) (W. Kabsch 1976).

    Of several, it is the nearest to a rotation `turn` (4,).
    """
    spread = OWN_TURN * float(np.sum(own * own))
    rotation = quat.matrices(turn)
    for _ in range(TURNS):
        u, _, right = np.linalg.svd(seen.T @ own + spread * rotation)
        handed = np.diag([1.0, 1.0, np.linalg.det(u @ right)])
        rotation = u @ handed @ right
    return quat.from_matrix(rotation)


def balance_of(figure: Figure, soles: Sequence[Point], goals: Sequence[Goal], share: float) -> list[tuple[float, Goal]]:
    """Return balance as a preference with its weight, for a figure all of whose feet have goals; else none.

    Args:
        share: The size of the permitted polygon, relative to the support polygon; 0: its centroid.
    """
    placed_bodies = {body for goal in goals for body in goal.bodies(figure.model)}
    feet = {figure.links[point.link].body for point in soles}
    if figure.root is None or not feet or not feet <= placed_bodies or not figure.gravity.any():
        return []
    points = tuple(PointGoal.of(figure, point) for point in soles)
    return [(BALANCE, Balance("balance", figure.links[figure.root.link].body, points, share))]


def goals_at(schedule: ContactSchedule, k: int) -> list[list[Goal]]:
    """Return the goals of feet and grasps at keyframe k, a group for each foot, contact point or grasp."""
    points, links = schedule.resting_points, dict[int, list[int]]()
    spots = [None if points.is_known[i, k] else schedule.rest(i, k) for i in range(len(points.points))]
    for i in (i for i, spot in enumerate(spots) if spot is not None):
        links.setdefault(points.points[i].link, []).append(i)
    feet = [_foot(schedule, k, members, np.array([spots[i] for i in members])) for members in links.values()]
    grasps = [_grasp(schedule, grasp, k) for grasp in (*schedule.grasps, *schedule.turns)]
    return [*feet, *(group for group in grasps if group)]


def _foot(schedule: ContactSchedule, k: int, members: Sequence[int], spots: Array) -> list[Goal]:
    """Return goals for the centre of points at positions (n, 3) [m], and for their orientation if they are several."""
    figure, points = schedule.figure, [schedule.resting_points.points[i] for i in members]
    first, positions = points[0], np.array([point.position for point in points])
    centre, spot, body = positions.mean(axis=0), spots.mean(axis=0), figure.links[first.link].body
    goals: list[Goal] = [PointGoal.of(figure, replace(first, position=centre), spot)]
    if len(points) > 1:
        turn = fit_rotation(positions - centre, spots - spot, schedule.resting_points.orientation(members[0], k))
        goals.append(BodyGoal(first.name, quat.product(turn, figure.body_turn[body]), body))
    return goals


def _grasp(schedule: ContactSchedule, grasp: Contact, k: int) -> list[Goal]:
    """Return the goal of a site that holds a known spot at keyframe k, unless this determines both bodies.

    A body follows the rotation of a hand, whereas a hand follows only the position of a body.
    """
    t, ends = schedule.keys.times[k], (grasp.point, Point(grasp.point.name, grasp.on, np.zeros(3)))
    hand, body = sets_places(schedule.figure, schedule.keys.known[k : k + 1], ends)[:, 0]
    if not grasp.is_placed or not grasp.covers(t) or (body and (hand or grasp in schedule.turns)):
        return []
    return [PointGoal.of(schedule.figure, grasp.point, grasp.place(np.array([t]))[:, 0], grasp.on)]


@dataclass(frozen=True, eq=False)
class Stander:
    """Poses the feet of a clip's partial keyframes.

    Attributes:
        bends: The limits of knees and elbows.
        flights: The flights that the clip specifies; None: inferred.
    """

    figure: Figure
    source: Parsed
    surfaces: tuple[Surface, ...]
    bends: BendLimits | None
    flights: tuple[Interval, ...] | None

    @classmethod
    def of(cls, source: Parsed, figure: Figure) -> Stander:
        """Return the object that poses the feet of a clip."""
        bends, flight = posing_limits(figure, source.options), source.options.get("flight")
        flights = None if flight is None or flight.intervals is None else tuple(flight.intervals)
        return cls(figure, source, static_surfaces(figure.model), bends, flights)

    def pose_feet(self, keys: Sequence[Frame]) -> list[Frame]:
        """Pose the free entries of partial keyframes as far as they are certain."""
        if all(key.is_key for key in keys):
            return list(keys)
        try:
            keys, schedule = self._grounded(keys)
        except TimelineError:  # loading the clip reports it
            return list(keys)
        is_loop = schedule.keys.ends == "periodic"  # whose last keyframe is the first
        unposed = [k for k, key in enumerate(keys) if not key.is_key][: len(keys) - is_loop]
        posed = [self._pose(key, schedule, k) if k in unposed else key for k, key in enumerate(keys)]
        return put_down(posed, replace(schedule, keys=self.source.problem(self.figure, posed).raw), schedule)

    def _grounded(self, keys: Sequence[Frame], but: int = -1) -> tuple[Sequence[Frame], ContactSchedule]:
        """Return the keyframes with standing ones on the ground, but for one, and their contacts. Feet have stances
        only in keyframes of known heights. Raises TimelineError."""
        schedule = self._schedule(keys)
        grounded = put_down(keys, schedule, schedule)
        grounded = [keys[k] if k == but else key for k, key in enumerate(grounded)]
        if all(one is key for one, key in zip(grounded, keys, strict=True)):
            return keys, schedule
        return grounded, self._schedule(grounded)

    def feet_goals(self, keys: Sequence[Frame], k: int, goals: Sequence[Goal]) -> tuple[Timeline, list[Goal]]:
        """Return the keyframes' timeline, and goals of feet in a stance at keyframe k, for limbs without goals.

        These are only feet that the goals also move; `pose_feet` handles others.
        """
        figure, schedule = self.figure, self._grounded(keys, but=k)[1]
        may_move = entries_of(figure, goals) & ~keys[k].fixed
        busy = {link for goal in goals for link in figure.limb(goal.bodies(figure.model)[0])}
        groups = goals_at(schedule, k) if may_move.any() else []
        return schedule.keys, [
            goal
            for group in groups
            if figure.body_link[group[0].bodies(figure.model)[0]] not in busy
            and entries_of(figure, group)[may_move].any()
            for goal in group
        ]

    def _schedule(self, keys: Sequence[Frame]) -> ContactSchedule:
        """Return the contacts of the clip, whose keyframes may be few of those of a recording."""
        table, timeline = self.source.table, self.source.problem(self.figure, keys).raw
        tables = list(_during(table.contact, *timeline.times[[0, -1]].tolist()))
        schedule = schedule_of(self.figure, timeline, self.surfaces, self.source.where, tables, table.grasp)
        return replace(schedule, specified_flights=self.flights)

    def _pose(self, key: Frame, schedule: ContactSchedule, k: int) -> Frame:
        """Return keyframe k posed for its feet and goals; feet that cannot keep their stance are released."""
        figure, timeline, groups = self.figure, schedule.keys, goals_at(schedule, k)
        frame = timeline.frames[k]
        home, root = figure.to_qpos(frame.state), figure.root
        may_shift = root is not None and not frame.fixed[figure.links[root.link].qpos + np.arange(2)].all()
        is_determined, missed = np.zeros(figure.width, bool), list[Goal]()
        while groups:
            goals = [goal for group in groups for goal in group]
            preferred = balance_of(figure, schedule.points, goals, 0.0) if may_shift else []
            pose = find_pose(figure, home, ~frame.fixed, goals, self.bends, STARTS, preferred=preferred)
            if pose.worst <= NEGLIGIBLE:
                home, is_determined = pose.qpos, pose.fixed & ~frame.fixed
                break
            of_group = np.repeat(np.arange(len(groups)), [len(group) for group in groups])
            missed += groups.pop(int(of_group[np.argmax(pose.missed)]))
        home, more = self._reaching(home, ~frame.fixed & ~is_determined, missed)
        is_determined |= more
        home = in_winding(figure, home, timeline.states[k - 1] if k else home, is_determined)
        return (
            Frame(key.time, np.where(is_determined, home, key.state), key.fixed, is_determined)
            if is_determined.any()
            else key
        )

    def _reaching(self, home: Array, free: Mask, missed: Sequence[Goal]) -> tuple[Array, Mask]:
        """Return a pose with sites as near as possible to goals out of reach, and the entries (N,) that determine it.
        Sites that remain too far from their goals are left out."""
        goals = [goal for goal in missed if isinstance(goal, PointGoal) and goal.reference]
        while goals:
            pose = find_pose(self.figure, home, free, goals, self.bends, STARTS)
            if pose.worst <= Thresholds.of(self.figure).out_of_reach:
                return pose.qpos, pose.fixed & free
            del goals[int(np.argmax(pose.missed))]
        return home, np.zeros(self.figure.width, bool)


def _during(tables: Sequence[ContactTable], first: float, last: float) -> Iterator[ContactTable]:
    """Yield the contacts within [first, last], for a recording only those near its keyframes."""
    for table in tables:
        start, end = max(table.start, first), min(table.end, last)
        if start < end or not table.start < table.end:
            yield table.model_copy(update={"start": start, "end": end}) if start < end else table
