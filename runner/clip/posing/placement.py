"""Keyframes by position: joint values from goals for sites' positions and bodies' orientations.

Entries with "pose" are solved here, and their joints are fixed; entries with "search" become soft constraints.
Independent of `others`, the joints of the limb from the site or body up to the next branch are free unless the keyframe
specifies them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.frame import Frame, Timeline, TimelineError
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import kinematics
from dynsplines.solver.posing import (
    BodyGoal,
    Goal,
    PointGoal,
    Posed,
    entries_of,
    find_pose,
    in_winding,
    rest_rotation,
    same_heading,
)
from dynsplines.solver.surface import Surface
from dynsplines.solver.surface.heights import heights
from dynsplines.solver.surface.points import Point, body_points, hanging, places_of, split_at_feet

from ...errors import UserError, unknown
from ..table import BodyTable, KeyframeTable
from .places import Places, root_links
from .standing_feet import Stander, balance_of

RISES = 10  # [1] most attempts to raise the root until soles are out of the ground
ALIKE = 0.5  # [1] largest deviation of a foot's displacement from the mean, relative to the mean
SHIFTED = 0.5  # [1] size of the polygon above which a pose that may shift is balanced, relative to that of its feet


def released_links(figure: Figure, row: KeyframeTable, goals: Sequence[Goal]) -> list[int]:
    """Return the links whose joints a keyframe's goals free, independent of `others`."""
    bodies = [goal.bodies(figure.model)[0] for goal in goals]
    named = root_links(figure, row) | {i for i, link in enumerate(figure.links) if link.name in row.joints}
    return sorted({link for body in bodies for link in figure.limb(body)} - named)


def goals_of(places: Places, row: KeyframeTable, where: str) -> list[Goal]:
    """Return the goals of a keyframe's pose.

    Raises:
        UserError: For unknown names and contradictions.
    """
    figure = places.figure
    goals: list[Goal] = []
    for name, position in row.sites.items():
        point = places.named_point(name, where)
        target = _target(position, f"{where}: sites.{name}", "the site")
        goal = PointGoal.of(figure, point, target)
        _check_moves(figure, goal, f"{where}: site '{name}'")
        goals.append(goal)
    for name, table in row.bodies.items():
        body = places.body(name)
        if body is None:
            raise UserError(f"{where}: {unknown('body', name, places.bodies_listed)}")
        body_name = str(figure.model.body(body).name) or name  # in messages, that of a site on it would mislead
        body_goals = _body_goals(figure, body_name, body, table, f"{where}: bodies.{name}")
        _check_moves(figure, body_goals[0], f"{where}: body '{name}'")
        goals += body_goals
    return goals


def _target(position: Sequence[float | str], where: str, what: str) -> Array:
    """Return a position (3,) [m] of a table, NaN along free axes."""
    target = np.array([np.nan if axis == "free" else float(axis) for axis in position])
    if np.all(np.isnan(target)):
        raise UserError(f"{where}: every axis is free; omit {what}, or give a coordinate")
    return target


def with_pose(
    stander: Stander, keys: Sequence[Frame], k: int, goals: Sequence[Goal], soles: Sequence[Point], where: str
) -> tuple[Frame, Posed, list[Goal]]:
    """Return keyframe k posed for its goals, with the joints on which they depend fixed; the pose with its errors; and
    the goals, with those of the headings of feet that are flat where they were in the keyframe before.

    The pose is the nearest one to the spline through the other keyframes, if possible with feet in their stances. If
    all feet are to move alike, the root moves with them first.
    """
    try:
        path, also = stander.feet_goals(keys, k, goals)
    except TimelineError as error:
        raise UserError(f"{where}: {error}") from None
    figure, key = stander.figure, keys[k]
    home = np.where(key.fixed, key.state, figure.to_qpos(path.states[k]))
    for columns in figure.tables.quaternion_columns.T:
        home[columns] = quat.normalise(home[columns])
    goals = [*goals, *_kept_headings(figure, keys[:k], goals)]
    home = _root_above_feet(figure, home, ~key.fixed, goals, soles)
    ground = stander.surfaces if _is_slow(figure, path, k) else ()
    best = _Request(stander, key, [*goals, *also], soles).pose(home, ground)
    if also and not best.is_met:
        best = _Request(stander, key, goals, soles).pose(home, ground)
    pose = in_winding(figure, best.qpos, path.states[k - 1] if k else home, ~key.fixed)
    posed_key = Frame.key(key.time, np.where(key.fixed, key.state, pose), key.fixed | entries_of(figure, goals))
    return posed_key, best, goals


@dataclass(frozen=True, eq=False)
class _Request:
    """A request for a pose of a keyframe that meets goals, with the sole points of the figure."""

    stander: Stander
    key: Frame
    goals: Sequence[Goal]
    soles: Sequence[Point]

    def pose(self, home: Array, ground: Sequence[Surface]) -> Posed:
        """Return the pose nearest to `home` (nq,), if possible in balance on `ground`, with soles out of surfaces."""
        best, figure = self._find(home), self.stander.figure
        if best.is_met and (
            preferred := _unmet_balance(figure, best.qpos, self.key.fixed, self.goals, self.soles, ground)
        ):
            other = self._find(home, preferred=preferred)
            best = other if other.is_met else best
        if not best.is_met or not self.soles or not self.stander.surfaces:
            return best
        level = self._level_feet(best)
        best = self._shallower(best, best.qpos, level) if level else best
        height = None if figure.root is None else figure.links[figure.root.link].qpos + 2
        for _ in range(RISES):
            if height is None or self.key.fixed[height] or not self._is_deep(best).any():
                break
            raised = np.array(best.qpos)
            raised[height] += self._depths(best).max()
            best = self._shallower(best, raised)
        return best

    def _find(self, home: Array, more: Sequence[Goal] = (), preferred: Sequence[tuple[float, Goal]] = ()) -> Posed:
        goals, free = [*self.goals, *more], ~self.key.fixed
        return find_pose(self.stander.figure, home, free, goals, self.stander.bends, preferred=preferred)

    def _shallower(self, best: Posed, home: Array, more: Sequence[Goal] = ()) -> Posed:
        """Return the pose nearest to `home` (nq,), or the best one so far if its soles are less deep in the ground."""
        other = self._find(home, more)
        return other if other.is_met and self._depths(other).max() < self._depths(best).max() else best

    def _level_feet(self, pose: Posed) -> list[Goal]:
        """Return goals that level feet with goals of positions alone whose soles would be in the ground."""
        figure = self.stander.figure
        deep = {figure.links[self.soles[i].link].body for i in np.flatnonzero(self._is_deep(pose)).tolist()}
        turned = {goal.bodies(figure.model)[0] for goal in self.goals if isinstance(goal, BodyGoal)}
        feet = deep & {goal.bodies(figure.model)[0] for goal in self.goals} - turned
        return [BodyGoal(str(figure.model.body(foot).name), index=foot) for foot in sorted(feet)]

    def _is_deep(self, pose: Posed) -> Mask:
        """Return which soles are in the ground, (n,)."""
        return np.asarray(self._depths(pose) > Thresholds.of(self.stander.figure).tiny)

    def _depths(self, pose: Posed) -> Array:
        """Return the depths of the soles in the ground, (n,) [m]."""
        return _depths(self.stander.figure, pose.qpos, self.soles, self.stander.surfaces)


def _root_above_feet(figure: Figure, home: Array, free: Mask, goals: Sequence[Goal], soles: Sequence[Point]) -> Array:
    """Return `home` with the root moved horizontally by the feet's mean displacement.

    Goals place every foot, all in nearly the same direction and distance, and the root's x and y are free. Otherwise
    the root would lag behind, and the figure would crouch.
    """
    root, model = figure.root, figure.model
    if root is None:
        return home
    across = figure.links[root.link].qpos + np.arange(2)
    feet = {figure.links[point.link].body for point in hanging(figure, root.link, soles)}
    points = [goal for goal in goals if isinstance(goal, PointGoal) and not np.isnan(goal.spots[:, :2]).any()]
    if not free[across].all() or any(goal.index == figure.links[root.link].body for goal in points):
        return home
    data, moves = kinematics(model, home), dict[int, list[Array]]()
    for goal in points:
        foot = goal.index
        while int(model.body_parentid[foot]) in feet:  # toes count for their foot
            foot = int(model.body_parentid[foot])
        moves.setdefault(foot, []).append((goal.spots - goal.places(data))[0, :2])
    legs = {foot for foot in feet if int(model.body_parentid[foot]) not in feet}
    if not legs or not legs <= moves.keys():
        return home
    by_foot = [np.mean(moves[foot], axis=0) for foot in sorted(legs)]
    move = np.mean(by_foot, axis=0)
    is_alike = np.linalg.norm(by_foot - move, axis=1).max() < ALIKE * np.linalg.norm(move)
    if not is_alike or np.linalg.norm(move) < Thresholds.of(figure).strode:
        return home
    moved = np.array(home)
    moved[across] += move
    return moved


def _depths(figure: Figure, qpos: Array, points: Sequence[Point], surfaces: Sequence[Surface]) -> Array:
    """Return the depths (n,) [m] of points below the ground in a pose (nq,), negative above it."""
    height, _ = heights(surfaces, *places_of(points, Samples.of_qpos(figure, qpos)))
    return -height[:, 0]


def _kept_headings(figure: Figure, earlier: Sequence[Frame], goals: Sequence[Goal]) -> list[Goal]:
    """Return goals of the headings of flat bodies that the last keyframe to set them has in the same position."""
    model, kept = figure.model, list[Goal]()
    for flat in (goal for goal in goals if isinstance(goal, BodyGoal) and goal.rotation is None):
        (body,) = flat.bodies(model)
        columns = [figure.links[link].columns for link in figure.chain(body)]
        before = next((key for key in reversed(earlier) if all(key.fixed[entries].all() for entries in columns)), None)
        points = [goal for goal in goals if isinstance(goal, PointGoal) and goal.index == body]
        if before is None or not points:
            continue
        data = kinematics(model, before.state)
        missed = np.concatenate([goal.residual(model, data) for goal in points])
        if np.linalg.norm(missed) <= Thresholds.of(figure).tiny:
            kept.append(same_heading(figure, before.state, body))
    return kept


def _unmet_balance(
    figure: Figure,
    pose: Array,
    fixed: Mask,
    goals: Sequence[Goal],
    soles: Sequence[Point],
    surfaces: Sequence[Surface],
) -> list[tuple[float, Goal]]:
    """Return balance as a preference with its weight if a pose (nq,) for goals misses it by far, else none.

    A figure that may shift sideways and of which all feet have goals is balanced over its feet on the ground, unless
    another body touches one of the surfaces; without surfaces, it need not be.
    """
    root, limits = figure.root, Thresholds.of(figure)
    if root is None or fixed[figure.links[root.link].columns][:2].all():
        return []
    if not surfaces or not balance_of(figure, soles, goals, SHIFTED):
        return []
    feet, others = split_at_feet(soles, hanging(figure, root.link, body_points(figure)))
    depths = _depths(figure, pose, feet, surfaces)
    standing = [point for point, depth in zip(feet, depths, strict=True) if depth > -limits.near_surface]
    preferred = balance_of(figure, standing, goals, SHIFTED)
    data = kinematics(figure.model, pose)
    if all(np.linalg.norm(goal.residual(figure.model, data)) <= limits.near_surface for _, goal in preferred):
        return []
    return [] if np.any(_depths(figure, pose, others, surfaces) > -limits.near_surface) else preferred


def _is_slow(figure: Figure, path: Timeline, k: int) -> bool:
    """Return whether the roots hardly travel between the keyframes before and after keyframe k."""
    first, last = max(k - 1, 0), min(k + 1, path.times.size - 1)
    moves = (path.states[last] - path.states[first])[figure.tables.position_columns[:2]]
    speed = float(np.linalg.norm(moves, axis=0).max(initial=0.0) / (path.times[last] - path.times[first]))
    return speed < Thresholds.of(figure).travels


def _body_goals(figure: Figure, name: str, body: int, table: BodyTable, where: str) -> list[Goal]:
    """Return goals for the position of a body's origin or of a point in its axes, and for its orientation."""
    goals: list[Goal] = []
    if table.position is not None:
        target = _target(table.position, where, "the position")
        goals.append(PointGoal(name, body, np.array([table.at or (0.0, 0, 0)]), target[None]))
    if table.is_rotation:
        goals.append(BodyGoal(name, table.quaternion(rest_rotation(figure.model, body)), body))
    elif table.flat:
        goals.append(BodyGoal(name, index=body))
    return goals


def _check_moves(figure: Figure, goal: Goal, what: str) -> None:
    if not figure.chain(goal.bodies(figure.model)[0]):
        raise UserError(f"{what} is not part of the figure: no joint moves it")
