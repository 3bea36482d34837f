"""Keyframes by position: where sites are to be and how bodies are turned, as a clip says it, becomes joints.

What is "pose" is solved into a pose here, and its joints are fixed from then on; what is "search" is left to the
optimiser as a soft constraint. Whatever `others` says, the joints of the limb that a site or body ends, up to where
another limb branches off, are free unless the keyframe names them.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver import quaternion as quat
from solver.figure import Figure, JointKind
from solver.frame import Frame, TimelineError
from solver.penalty import Placed, site_points
from solver.posing import MET, BodyGoal, Goal, Posed, SiteGoal, chain, entries, limb, posed, reached
from solver.unknowns import raw_timeline

from .clip_table import ROTATION, BodyTable, KeyframeTable, SiteTable
from .errors import UserError, unknown
from .rotation import quaternion_of
from .standing import Stander

BESIDE = 0.1  # share of the worst miss up to which a goal is not told: it is off for the worst's sake


@dataclass(frozen=True, eq=False)
class Wanted:
    """What one keyframe says of places: goals of its pose, and points that are left to the search."""

    goals: tuple[Goal, ...] = ()
    placed: tuple[Placed, ...] = ()

    def loose(self, figure: Figure, row: KeyframeTable) -> list[int]:
        """The links whose joints the goals and points free, whatever `others` says."""
        model = figure.model
        bodies = [goal.body(model) for goal in self.goals]
        bodies += [figure.links[point.point.link].body for point in self.placed]
        named = {link.name for link in figure.links if link.name in row.joints or link.name in row.roots}
        if row.root.model_fields_set:
            named |= {link.name for link in figure.links[1:] if link.kind is JointKind.FREE}
        limbs = {link for body in bodies for link in limb(figure, body)}
        return sorted(link for link in limbs if figure.links[link].name not in named)


def wanted(figure: Figure, row: KeyframeTable, place: str) -> Wanted:
    """What a keyframe's sites and bodies say; raises UserError for names that are not there and for contradictions."""
    model = figure.model
    sites = [model.site(i).name for i in range(model.nsite) if model.site(i).name]
    bodies = [model.body(i).name for i in range(1, model.nbody) if model.body(i).name]
    goals: list[Goal] = []
    placed: list[Placed] = []
    for name, table in row.sites.items():
        if name not in sites:
            raise UserError(f"{place}: {unknown('site', name, sites)}")
        table = table if isinstance(table, SiteTable) else SiteTable(position=table)
        target = np.array([np.nan if axis == "free" else axis for axis in table.position])
        if np.all(np.isnan(target)):
            raise UserError(f"{place}: sites.{name}: every axis is free; leave the site out, or give it a place")
        goal = SiteGoal(name, target)
        _check_moves(figure, goal, f"{place}: site '{name}'")
        if table.by == "pose":
            goals.append(goal)
        else:
            placed.append(Placed(site_points(figure, [name])[0], row.time, target))
    _check_apart(figure, [goal for goal in goals if isinstance(goal, SiteGoal)], place)
    for name, table in row.bodies.items():
        if name not in bodies:
            raise UserError(f"{place}: {unknown('body', name, bodies)}")
        goals.append(_body_goal(name, table, f"{place}: bodies.{name}"))
        _check_moves(figure, goals[-1], f"{place}: body '{name}'")
    return Wanted(tuple(goals), tuple(placed))


def with_pose(
    figure: Figure,
    keys: Sequence[Frame],
    k: int,
    goals: Sequence[Goal],
    stander: Stander,
    place: str,
) -> tuple[Frame, list[str]]:
    """Keyframe k of some with the joints that its goals depend on fixed where they meet them, or come nearest to them;
    and what of the goals no pose was found for, a line each.

    The pose is the one nearest to where the spline through the other keyframes passes, if there is one with the feet
    where they stand before and after.
    """
    try:
        path = raw_timeline(figure, list(keys), "periodic" if stander.ends == "periodic" else "free")
    except TimelineError as error:
        raise UserError(f"{place}: {error}") from None
    key = keys[k]
    home = np.where(key.fixed, key.state, figure.to_qpos(path.states[k]))
    for columns in figure.tables.quaternion_columns.T:
        home[columns] = quat.normalised(home[columns])
    also = stander.beside(keys, k, goals)
    found = posed(figure, home, ~key.fixed, [*goals, *also], stander.bends) if also else None
    if found is None or not found.is_met:
        found = posed(figure, home, ~key.fixed, goals, stander.bends)
    posed_key = Frame.key(key.time, np.where(key.fixed, key.state, found.qpos), key.fixed | reached(figure, goals))
    return posed_key, [] if found.is_met else _complaints(figure, key, goals, found)


def check_search(figure: Figure, key: Frame, placed: Sequence[Placed], place: str) -> None:
    """Raises UserError for a point left to the search that nothing free can move."""
    for point in placed:
        body = figure.links[point.point.link].body
        if not _free_joints(figure, key, body):
            raise UserError(f"{place}: site '{point.point.name}' {_held(figure, body)}")


def _body_goal(name: str, table: BodyTable, place: str) -> BodyGoal:
    given = table.model_fields_set & {"rotvec", "euler", "quat", "order"}
    if table.flat is not None and given:
        raise UserError(f"{place}: give flat or a rotation, not both")
    if table.flat is None:
        return BodyGoal(name, quaternion_of(table, place))
    if not table.flat:
        raise UserError(f"{place}: flat = false says nothing; give flat = true or a rotation, {ROTATION}")
    return BodyGoal(name)


def _check_moves(figure: Figure, goal: Goal, what: str) -> None:
    if not chain(figure, goal.body(figure.model)):
        raise UserError(f"{what} is no part of the figure: no joint moves it")


def _check_apart(figure: Figure, goals: Sequence[SiteGoal], place: str) -> None:
    """Raises UserError for two sites that move together and are given another distance than they have."""
    points = dict(zip(goals, site_points(figure, [goal.name for goal in goals]), strict=True))
    for a, b in itertools.combinations(goals, 2):
        if points[a].link != points[b].link or np.isnan([a.position, b.position]).any():
            continue
        given = float(np.linalg.norm(a.position - b.position))
        real = float(np.linalg.norm(points[a].position - points[b].position))
        if abs(given - real) > MET:
            body = figure.model.body(a.body(figure.model)).name
            raise UserError(
                f"{place}: sites '{a.name}' and '{b.name}' are {_metres(real)} apart on the figure, not "
                f'{_metres(given)}; give one of them a "free" axis, or one site and bodies.{body}'
            )


def _complaints(figure: Figure, key: Frame, goals: Sequence[Goal], found: Posed) -> list[str]:
    """What is not met, and by how much: what misses by nothing beside the worst only makes room for that."""
    least = max(MET, BESIDE * found.worst)
    missing = [(goal, float(missed)) for goal, missed in zip(goals, found.missed, strict=True) if missed > least]
    return [_complaint(figure, key, goal, missed, found.starts) for goal, missed in missing]


def _complaint(figure: Figure, key: Frame, goal: Goal, missed: float, starts: int) -> str:
    body = goal.body(figure.model)
    joints = _free_joints(figure, key, body)
    kind = "site" if isinstance(goal, SiteGoal) else "body"
    if not joints:
        return f"{kind} '{goal.name}' {_held(figure, body)}"
    free = f"with the joints that are free: {', '.join(joints)}"
    if isinstance(goal, SiteGoal):
        where = ", ".join("free" if np.isnan(axis) else f"{axis:g}" for axis in goal.position)
        closest = f"({starts} starts; closest: {_metres(missed)} short)"
        return f"no pose found that puts site '{goal.name}' at ({where}) {closest} {free}"
    closest = f"({starts} starts; closest: {np.degrees(missed):.3g} degrees short)"
    return f"no pose found that turns body '{goal.name}' so {closest} {free}"


def _free_joints(figure: Figure, key: Frame, body: int) -> list[str]:
    """The joints from the root to a body of which a keyframe leaves something free."""
    links = [link for link in reversed(chain(figure, body)) if not key.fixed[entries(figure, link)].all()]
    return [figure.links[link].name for link in links]


def _held(figure: Figure, body: int) -> str:
    names = ", ".join(figure.links[link].name for link in reversed(chain(figure, body)))
    return f"cannot move: every joint on the way to it is given ({names}); leave one of them free"


def _metres(length: float) -> str:
    return f"{length:.3g} m" if length >= 0.01 else f"{1000 * length:.2g} mm"
