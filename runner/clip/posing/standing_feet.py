"""Posing of the free entries of partial keyframes: feet with a stance keep it.

A straight leg has no gradient that bends it, so the search alone cannot find a squat. The goals of a pose are points
that rest in a [[contact]] at the keyframe's time, sites that a [[grasp]] keeps on a body, sole points with one position
in the keyframes before and after, and positions left to the search. The entries on which these depend start in the
pose and remain free.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.contacts import Contact, ContactSchedule
from dynsplines.solver.contacts.keyframe_points import KeyframePoints
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import BendLimits
from dynsplines.solver.posing import (
    Balance,
    BodyGoal,
    Goal,
    PointGoal,
    find_pose,
    in_winding,
    reached,
)
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.points import Point, placed

from ..contacts import schedule_of
from ..table import ContactTable, GraspTable, SolveTable
from .grounding import Grounding

NEARLY = 1e-3  # [m, rad] largest error of a pose that meets its goals
STARTS = 4  # most starting poses
BALANCE = 100.0  # [1/m] weight of the preference of balance, relative to 1 rad of a limb joint
STANDING = 0.6  # [1] size of the polygon above which a standing figure is posed, relative to that of its feet
OWN_TURN = 1e-3  # weight of a foot's orientation relative to its points, two of which do not determine it
TURNS = 4  # iterations, each from the previous orientation, which remove this bias


@dataclass(frozen=True, eq=False)
class Standing:
    """A foot in a stance: n points, their positions (n, 3) [m], and the orientation (4,) of its link in a keyframe."""

    points: tuple[Point, ...]
    spots: Array
    turn: Array

    def goals(self, figure: Figure) -> list[Goal]:
        """Return goals for the centre of the points, and for their orientation if they are several."""
        link, positions = self.points[0].link, np.array([point.position for point in self.points])
        body, spot = figure.links[link].body, self.spots.mean(axis=0)
        middle = Point(self.points[0].name, link, positions.mean(axis=0))
        goals: list[Goal] = [PointGoal.of(figure, middle, spot)]
        if len(self.points) > 1:
            turn = fitted(positions - middle.position, self.spots - spot, self.turn)
            rotation = quat.product(turn, figure.body_turn[body])
            goals.append(BodyGoal(self.points[0].name, rotation, body))
        return goals


def fitted(own: Array, seen: Array, turn: Array) -> Array:
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


def balance_of(
    figure: Figure, soles: Sequence[Point], goals: Sequence[Goal], share: float = 1.0
) -> list[tuple[float, Goal]]:
    """Return balance as a preference with its weight, for a figure all of whose feet have goals; else none.

    Args:
        share: The size of the permitted polygon, relative to the support polygon.
    """
    placed_bodies = {body for goal in goals for body in goal.bodies(figure.model)}
    feet = {figure.links[point.link].body for point in soles}
    if figure.root is None or not feet or not feet <= placed_bodies or not figure.gravity.any():
        return []
    points = tuple(PointGoal.of(figure, point) for point in soles)
    return [(BALANCE, Balance("balance", figure.links[figure.root.link].body, points, share))]


def _during(tables: Sequence[ContactTable], first: float, last: float) -> Iterator[ContactTable]:
    """Yield the contacts within [first, last], for a recording only those near its keyframes."""
    for table in tables:
        start, end = max(table.start, first), min(table.end, last)
        if start < end or not table.start < table.end:
            yield table.model_copy(update={"start": start, "end": end}) if start < end else table


@dataclass(frozen=True, eq=False)
class Stander:
    """Detects stances of feet in partial keyframes, and poses the feet.

    Attributes:
        bends: The limits of knees and elbows.
        where: The label of the clip in errors.
        aloft: Specified flights, (first, last) [s].
    """

    figure: Figure
    surfaces: tuple[Surface, ...]
    bends: BendLimits | None
    solve: SolveTable
    where: str
    contact_tables: Sequence[ContactTable] = ()
    grasp_tables: Sequence[GraspTable] = ()
    aloft: Sequence[tuple[float, float]] = ()

    def timeline(self, keys: Sequence[Frame]) -> Timeline:
        """Return the keyframes' timeline, for a loop with its seam; raises TimelineError."""
        slope, solve = np.zeros((2, self.figure.width)), self.solve
        if solve.ends != "periodic":  # loading the clip reports an invalid travel or turn
            return raw_timeline(self.figure, list(keys), solve.ends, slope)
        turn = None if solve.turn is None else float(np.radians(solve.turn))
        return raw_timeline(self.figure, list(keys), solve.ends, slope, solve.travel, turn)

    def pose_feet(self, keys: Sequence[Frame]) -> list[Frame]:
        """Pose the free entries of partial keyframes as far as they are certain."""
        if all(key.is_key for key in keys):
            return list(keys)
        try:
            inferred = self.known_positions(self.timeline(keys))
        except TimelineError:  # loading the clip reports it
            return list(keys)
        count = len(keys) - (self.solve.ends == "periodic")  # the last keyframe of a loop is the first
        posed_keys = [
            self._pose(keys[k], inferred, k) if k < count and not keys[k].is_key else keys[k] for k in range(len(keys))
        ]
        grounding = Grounding.of(self.figure, inferred.soles, self.surfaces, self.aloft)
        if grounding is None or not grounding.is_asked(posed_keys):
            return posed_keys
        timeline = self.timeline(posed_keys)
        return [
            *grounding.leaping(timeline).put_down(posed_keys[:count], timeline, inferred.staying),
            *posed_keys[count:],
        ]

    def feet_goals(self, keys: Sequence[Frame], k: int, goals: Sequence[Goal]) -> tuple[Timeline, list[Goal]]:
        """Return the keyframes' timeline, and goals of feet in a stance at keyframe k, for limbs without goals.

        These are only feet that the goals also move; `pose_feet` handles others.
        """
        figure, free, timeline = self.figure, ~keys[k].fixed, self.timeline(keys)
        is_reached = reached(figure, goals)
        busy = {link for goal in goals for link in figure.limb(goal.bodies(figure.model)[0])}
        if not free[is_reached].any():
            return timeline, []
        inferred = self.known_positions(timeline)
        result: list[Goal] = []
        for foot in inferred.standing(k):
            more = foot.goals(figure)
            if foot.points[0].link not in busy and (reached(figure, more) & is_reached & free).any():
                result += more
        for goal in inferred.holding(k):
            links = figure.limb(goal.bodies(figure.model)[0])
            if not busy.intersection(links) and (reached(figure, [goal]) & is_reached & free).any():
                result.append(goal)
        return timeline, result

    def known_positions(self, timeline: Timeline) -> _KnownPositions:
        tables = list(_during(self.contact_tables, *timeline.times[[0, -1]].tolist()))
        return _KnownPositions(schedule_of(self.figure, timeline, self.surfaces, self.where, tables, self.grasp_tables))

    def _pose(self, key: Frame, known: _KnownPositions, k: int) -> Frame:
        """Return keyframe k posed for its feet and goals; feet that cannot keep their stance are released."""
        figure = self.figure
        frame = known.timeline.frames[k]
        groups = [foot.goals(figure) for foot in known.standing(k)]
        groups += [[goal] for goal in known.holding(k)]
        home = figure.to_qpos(frame.state)
        root = figure.root
        may_shift = root is not None and not frame.fixed[figure.links[root.link].qpos + np.arange(2)].all()
        is_determined, missed = np.zeros(figure.width, bool), list[Goal]()
        while groups:
            goals = [goal for group in groups for goal in group]
            preferred = balance_of(figure, known.soles, goals, STANDING) if may_shift else []
            pose = find_pose(figure, home, ~frame.fixed, goals, self.bends, STARTS, preferred=preferred)
            if pose.worst <= NEARLY:
                home, is_determined = pose.qpos, pose.fixed & ~frame.fixed
                break
            of_group = np.repeat(np.arange(len(groups)), [len(group) for group in groups])
            missed += groups.pop(int(of_group[np.argmax(pose.missed)]))
        home, more = self._reaching(home, ~frame.fixed & ~is_determined, missed)
        is_determined |= more
        home = in_winding(figure, home, known.timeline.states[k - 1] if k else home, is_determined)
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


class _KnownPositions:
    """Positions of points at keyframes, as far as these determine them.

    For a loop three periods are evaluated, which include the keyframes before the first and after the last.
    """

    def __init__(self, schedule: ContactSchedule) -> None:
        self.figure, self.timeline, self.limits = schedule.figure, schedule.keys, Thresholds.of(schedule.figure)
        self.soles, self.contacts = schedule.points, schedule.on_ground
        self.grasps, self.turns = schedule.grasps, schedule.turns
        rests = [contact.point for contact in self.contacts if contact.is_placed]
        self.points = self.soles
        for point in rests:
            self.points += () if any(point.coincides(other) for other in self.points) else (point,)
        self.at_keys = KeyframePoints.of(self.figure, self.timeline, self.points, schedule.surfaces)
        self.told = self.at_keys.is_known
        self.times, self.centres, self.low = self._unroll()

    def _unroll(self) -> tuple[Array, Array, Mask]:
        """Return times (T,), positions of the points (n, T, 3), and whether they are on a surface (n, T)."""
        times, centres = self.timeline.times, np.moveaxis(self.at_keys.centres, 0, 2)
        low = np.abs(self.at_keys.heights) < self.limits.near_surface
        if self.timeline.ends != "periodic":
            return times, centres, low
        seam, period = Seam.of(self.figure, self.timeline), times[-1] - times[0]
        turns = np.arange(-1, 2)
        return (
            (times[:-1] + period * turns[:, None]).ravel(),
            np.concatenate([seam.moved_points(self.figure, centres[:, :-1], turn) for turn in turns], axis=1),
            np.tile(low[:, :-1], (1, 3)),
        )

    def standing(self, k: int) -> list[Standing]:
        """Return the feet in a stance at keyframe k, and the other points with a specified contact."""
        by_link: dict[int, list[tuple[Point, Array, Array]]] = {}
        for i, point in enumerate(self.points):
            if self.told[i, k]:
                continue
            near = self._neighbours(i, k)
            spot = self._resting(point, k)
            if spot is None and i < len(self.soles) and not self._spoken_of(point, k) and not self._is_set(point, k):
                spot = self._stays(i, k, near)
            if spot is not None:
                by_link.setdefault(point.link, []).append((point, spot, self._turn(point.link, k, near)))
        return [
            Standing(tuple(p for p, _, _ in members), np.array([spot for _, spot, _ in members]), members[0][2])
            for members in by_link.values()
        ]

    def holding(self, k: int) -> list[PointGoal]:
        """Return goals of sites that hold a known spot at keyframe k, unless it determines both bodies.

        A body follows the rotation of a hand, whereas a hand follows only the position of a body.
        """
        return [goal for grasp in (*self.grasps, *self.turns) if (goal := self._holding(grasp, k)) is not None]

    def _holding(self, grasp: Contact, k: int) -> PointGoal | None:
        t, is_known = self.timeline.times[k], self.timeline.known[k : k + 1]
        ends = (grasp.point, Point(grasp.point.name, grasp.on, np.zeros(3)))
        hand, body = placed(self.figure, is_known, ends)[:, 0]
        if not grasp.is_placed or not grasp.covers(t) or (body and (hand or grasp in self.turns)):
            return None
        return PointGoal.of(self.figure, grasp.point, grasp.place(np.array([t]))[:, 0], grasp.on)

    def _neighbours(self, i: int, k: int) -> tuple[int | None, int | None]:
        """Return the nearest keyframes before and after k, also of other periods, that give the position of point i."""
        count = self.times.size // 3 if self.timeline.ends == "periodic" else self.times.size
        at = k + (count if self.timeline.ends == "periodic" else 0)
        is_told = self.told[i, :count] if self.timeline.ends != "periodic" else np.tile(self.told[i, :count], 3)
        before, after = np.flatnonzero(is_told[:at]), np.flatnonzero(is_told[at + 1 :])
        return (int(before[-1]) if before.size else None), (int(at + 1 + after[0]) if after.size else None)

    def staying(self, k: int) -> Array:
        """Return positions (3, n) of sole points in a stance at keyframe k, whatever it sets; NaN for others."""
        spots = np.full((3, len(self.soles)), np.nan)
        for i in range(len(self.soles)):
            spot = self._stays(i, k, self._neighbours(i, k))
            if spot is not None:
                spots[:, i] = spot
        return spots

    def _stays(self, i: int, k: int, near: tuple[int | None, int | None]) -> Array | None:
        """Return the stance position of a point: that between equal positions in the keyframes before and after. In the
        first and last keyframes it is that of the only neighbour. None without a stance."""
        before, after = near
        neighbours = [n for n in near if n is not None]
        if not neighbours or not all(self.low[i, n] for n in neighbours):
            return None
        if before is None or after is None:
            return self.centres[i, neighbours[0]]
        spot, landed = self.centres[i, before], self.centres[i, after]
        seconds = self.times[after] - self.times[before]
        if np.linalg.norm(landed - spot) >= self.limits.farthest_planted(seconds):
            return None
        return spot + (self.timeline.times[k] - self.times[before]) / seconds * (landed - spot)

    def _is_set(self, point: Point, k: int) -> bool:
        links = self.figure.limb(self.figure.links[point.link].body)
        fixed = self.timeline.frames[k].fixed
        return any(fixed[self.figure.links[link].columns].any() for link in links)

    def _resting(self, point: Point, k: int) -> Array | None:
        """Return the position that a contact specifies for a point at keyframe k, None if contacts contradict."""
        t = self.timeline.times[k]
        spots = [
            contact.place(np.array([t]))[:, 0]
            for contact in self.contacts
            if contact.is_placed and point.coincides(contact.point) and contact.covers(t)
        ]
        is_contradicted = any(np.linalg.norm(spot - spots[0]) >= self.limits.same_spot for spot in spots)
        return spots[0] if spots and not is_contradicted else None

    def _spoken_of(self, point: Point, k: int) -> bool:
        """Return whether a contact covers a point at keyframe k."""
        t = self.timeline.times[k]
        return any(point.coincides(contact.point) and contact.covers(t) for contact in self.contacts)

    def _turn(self, link: int, k: int, near: tuple[int | None, int | None]) -> Array:
        """Return the orientation (4,) of a link in the nearer neighbour that determines it, else at keyframe k."""
        neighbours = [n for n in near if n is not None]
        nearest = min(neighbours, key=lambda n: abs(self.times[n] - self.timeline.times[k])) if neighbours else k
        if self.timeline.ends != "periodic" or not neighbours:
            return quat.from_matrix(self.at_keys.samples.links.rotation[:, :, link, nearest])
        number, nearest = divmod(nearest, self.times.size // 3)  # of the periods before, of and after the loop
        rotation = quat.from_matrix(self.at_keys.samples.links.rotation[:, :, link, nearest])
        return quat.product(Seam.of(self.figure, self.timeline).turn(number - 1), rotation)
