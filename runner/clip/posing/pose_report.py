"""Violations of a pose: equality constraints, joint ranges, the floor, overlapping bodies."""

from __future__ import annotations

from collections.abc import Iterator

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.forward import kinematics
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import JointRange, joint_ranges
from dynsplines.solver.surface.points import body_points, bottoms_of, hanging
from dynsplines.solver.surface.touch import grounds

from .equalities import OPEN, Equalities, in_words

HIGH, DEEP = 0.02, 0.005  # [m] least distance above the floor, and below it or inside a body, that is reported
VERTICAL = 0.99  # least vertical component of a lifting slide's axis
MOST = 3  # most lines of a kind


def violations(figure: Figure, qpos: Array, equalities: Equalities) -> list[str]:
    """Return a line for each violation of a pose (nq,), the worst of a kind first, a few of each."""
    report: list[str] = []
    for lines in (
        [str(opening) for opening in equalities.open(qpos)],
        list(_off_the_floor(figure, qpos)),
        _out_of_range(figure, qpos),
        _in_each_other(figure, qpos),
    ):
        report += lines[:MOST] + ([f"and {len(lines) - MOST} more like it"] if len(lines) > MOST else [])
    return report


def floor_height(model: mujoco.MjModel) -> float | None:
    """Return the height [m] of the highest level plane; None without one."""
    data = kinematics(model)
    return max((float(data.geom_xpos[geom, 2]) for geom in grounds(model)), default=None)


def lifts(figure: Figure) -> list[tuple[int, int, float]]:
    """Return the links that can be lifted, with the column of qpos that does so and 1, or −1 for a slide down."""
    columns = [(link, figure.links[link].qpos + 2, 1.0) for link in figure.tables.free_links.tolist()]
    if figure.root is not None and not figure.root.is_free:
        data = kinematics(figure.model)
        slides = [figure.links[i] for i in figure.root.links if figure.links[i].kind is JointKind.SLIDE]
        ups = [(slide.qpos, float(data.xaxis[slide.joint, 2])) for slide in slides]
        columns += [(figure.root.link, column, float(np.sign(up))) for column, up in ups if abs(up) > VERTICAL]
    return columns


def standing_trees(figure: Figure) -> list[int]:
    """Return the root links of articulated trees that can be lifted, else of the first free body."""
    roots = [root for root, _, _ in lifts(figure)]
    return [root for root in roots if figure.tables.children[root]] or roots[:1]


def lowest_point(figure: Figure, qpos: Array, root: int) -> float | None:
    """Return the height [m] of the lowest point of a link and its descendants; None without points."""
    points = hanging(figure, root, body_points(figure))
    if not points:
        return None
    return float(bottoms_of(points, Samples.still(figure, figure.to_state(qpos[None]))).min())


def _off_the_floor(figure: Figure, qpos: Array) -> Iterator[str]:
    floor = floor_height(figure.model)
    if floor is None or not np.any(figure.gravity):
        return
    trees = standing_trees(figure)
    for root in trees:
        low, name = lowest_point(figure, qpos, root), figure.links[root].name
        whose = f"of '{name}' " if len(trees) > 1 else ""
        if low is None:
            continue
        if low - floor > HIGH:
            yield f"lowest point {whose}{low - floor:.2f} m above the floor"
        elif floor - low > DEEP:
            yield f"lowest point {whose}{1000 * (floor - low):.0f} mm below the floor"


def _out_of_range(figure: Figure, qpos: Array) -> list[str]:
    excesses: list[tuple[float, str]] = []
    joints = joint_ranges(figure)
    beyond = JointRange(joints).beyond(Samples.still(figure, figure.to_state(qpos[None])))[:, 0]
    for joint, excess in zip(joints, beyond.tolist(), strict=True):
        unit = "m" if joint.kind is JointKind.SLIDE else "degrees"
        amount = excess if unit == "m" else float(np.degrees(excess))
        if amount > OPEN[unit]:
            excesses.append((amount, f"joint '{joint.name}' {in_words(amount, unit)} beyond its range"))
    return [line for _, line in sorted(excesses, reverse=True)]


def _in_each_other(figure: Figure, qpos: Array) -> list[str]:
    """Return lines on overlapping bodies that collide in MuJoCo."""
    model, data = figure.model, kinematics(figure.model, qpos)
    mujoco.mj_collision(model, data)
    depths: dict[tuple[int, int], float] = {}
    for k in range(data.ncon):
        one, two = sorted(int(model.geom_bodyid[geom]) for geom in data.contact.geom[k])
        if figure.body_link[one] and figure.body_link[two]:
            depths[one, two] = max(depths.get((one, two), 0.0), -float(data.contact.dist[k]))
    deep = sorted(((depth, pair) for pair, depth in depths.items() if depth > DEEP), reverse=True)
    return [
        f"bodies '{model.body(one).name}' and '{model.body(two).name}' {1000 * depth:.0f} mm in each other"
        for depth, (one, two) in deep
    ]
