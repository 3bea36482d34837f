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
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, TimelineError
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import Placed
from dynsplines.solver.posing import (
    BodyGoal,
    Goal,
    PointGoal,
    Posed,
    chain,
    in_winding,
    limb,
    posed,
    reached,
)

from ...errors import UserError, unknown
from ..table import BodyTable, KeyframeTable, SiteTable
from .places import Places
from .root_entries import posed_roots, root_links
from .rotation import quaternion_of
from .standing_feet import Stander
from .unmet_goals import can_move, immovable


@dataclass(frozen=True, eq=False)
class Wanted:
    """A keyframe's position entries: goals of its pose, and points that the search places."""

    goals: tuple[Goal, ...] = ()
    placed: tuple[Placed, ...] = ()

    def loose(self, figure: Figure, row: KeyframeTable) -> list[int]:
        """Return the links whose joints the goals and points free, independent of `others`."""
        model = figure.model
        bodies = [goal.bodies(model)[0] for goal in self.goals]
        bodies += [figure.links[point.point.link].body for point in self.placed]
        named = root_links(figure, row) | {i for i, link in enumerate(figure.links) if link.name in row.joints}
        return sorted({link for body in bodies for link in limb(figure, body)} - named)


def wanted(places: Places, row: KeyframeTable, where: str) -> Wanted:
    """Read a keyframe's sites and bodies; raises UserError for unknown names and contradictions."""
    figure = places.figure
    goals: list[Goal] = []
    placed: list[Placed] = []
    for name, table in row.sites.items():
        point = places.point(name)
        if point is None:
            raise UserError(f"{where}: {unknown('site', name, places.points_listed)}")
        table = table if isinstance(table, SiteTable) else SiteTable(position=table)
        target = _target(table.position, f"{where}: sites.{name}", "the site")
        goal = PointGoal.of(figure, point, target)
        _check_moves(figure, goal, f"{where}: site '{name}'")
        if table.by == "pose":
            goals.append(goal)
        else:
            placed.append(Placed(point, row.time, target))
    for name, table in row.bodies.items():
        body = places.body(name)
        if body is None:
            raise UserError(f"{where}: {unknown('body', name, places.bodies_listed)}")
        body_goals = _body_goals(name, body, table, f"{where}: bodies.{name}")
        _check_moves(figure, body_goals[0], f"{where}: body '{name}'")
        goals += body_goals
    for root, position in posed_roots(figure, row):
        name = str(figure.model.body(root.body).name)
        goals.append(PointGoal(name, root.body, np.zeros(3), _target(position, f"{where}: root.position", "it")))
    return Wanted(tuple(goals), tuple(placed))


def _target(position: Sequence[float | str], where: str, what: str) -> Array:
    """Return a position (3,) [m] of a table, NaN along free axes."""
    target = np.array([np.nan if axis == "free" else float(axis) for axis in position])
    if np.all(np.isnan(target)):
        raise UserError(f"{where}: every axis is free; leave {what} out, or give it a where")
    return target


def with_pose(
    figure: Figure,
    keys: Sequence[Frame],
    k: int,
    goals: Sequence[Goal],
    stander: Stander,
    where: str,
) -> tuple[Frame, Posed]:
    """Return keyframe k posed for its goals, with the joints on which they depend fixed, and the pose with its errors.

    The pose is the nearest one to the spline through the other keyframes, if possible with feet in their stances.
    """
    try:
        path = stander.timeline(keys)
    except TimelineError as error:
        raise UserError(f"{where}: {error}") from None
    key = keys[k]
    home = np.where(key.fixed, key.state, figure.to_qpos(path.states[k]))
    for columns in figure.tables.quaternion_columns.T:
        home[columns] = quat.normalised(home[columns])
    also = stander.beside(path, key, k, goals)
    best = posed(figure, home, ~key.fixed, [*goals, *also], stander.bends) if also else None
    if best is None or not best.is_met:
        best = posed(figure, home, ~key.fixed, goals, stander.bends)
    pose = in_winding(figure, best.qpos, path.states[k - 1] if k else home, ~key.fixed)
    posed_key = Frame.key(key.time, np.where(key.fixed, key.state, pose), key.fixed | reached(figure, goals))
    return posed_key, best


def check_search(figure: Figure, key: Frame, placed: Sequence[Placed], where: str) -> None:
    """Raise UserError for a point left to the search that no free joint moves."""
    for point in placed:
        body = figure.links[point.point.link].body
        if not can_move(figure, key, body):
            raise UserError(f"{where}: site '{point.point.name}' {immovable(figure, body)}")


def _body_goals(name: str, body: int, table: BodyTable, where: str) -> list[Goal]:
    """Return goals for the position of a body's origin or of a point in its axes, and for its orientation."""
    goals: list[Goal] = []
    if table.position is not None:
        target = _target(table.position, where, "the position")
        goals.append(PointGoal(name, body, np.array(table.at or (0.0, 0, 0)), target))
    if table.is_rotation:
        goals.append(BodyGoal(name, quaternion_of(table), body))
    if table.flat:
        goals.append(BodyGoal(name, index=body))
    return goals


def _check_moves(figure: Figure, goal: Goal, what: str) -> None:
    if not chain(figure, goal.bodies(figure.model)[0]):
        raise UserError(f"{what} is not part of the figure: no joint moves it")
