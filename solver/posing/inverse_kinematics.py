"""Poses that meet target positions of points and target rotations of bodies, from several starting poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..array import Array, Mask
from ..cache import Cache, cache_key
from ..figure.figure import Figure, JointKind
from ..penalty.joints.bend import BendLimits
from .goals import Goal, entries_of, moved_by
from .pose_search import Posed, PoseSearch

STARTS = 12  # [1] largest number of starting poses
ALIKE = 2e-3  # [1] rough poses whose costs differ by no more than this share are taken to be the same
MOST_CACHED = 1000  # [1] largest number of cached poses


def find_pose(
    figure: Figure,
    qpos: Array,
    free: Mask,
    goals: Sequence[Goal],
    bends: BendLimits | None = None,
    starts: int = STARTS,
    preferred: Sequence[tuple[float, Goal]] = (),
) -> Posed:
    """Return the pose nearest to qpos that meets the goals; if none does, the pose with the smallest residual.

    A pose that already meets the goals is returned unchanged.

    Args:
        qpos: The initial pose, (nq,).
        free: The mask of the entries of qpos that may change, (nq,).
        bends: The knees and elbows on ball joints, with their bounds.
        preferred: Pairs of a weight [1/rad or 1/m] and a goal that is met approximately.
    """
    free, there = np.asarray(free, bool), np.array(qpos, float)
    fixed, missed, tried = np.zeros(figure.width, bool), np.zeros(len(goals)), 0
    for group in _apart(figure, free, goals):
        pose = _find(figure, there, free, tuple(goals[i] for i in group), bends, starts, tuple(preferred))
        there, fixed, tried = np.where(pose.fixed, pose.qpos, there), fixed | pose.fixed, max(tried, pose.starts)
        missed[group] = pose.missed
    return Posed(there, fixed, missed, tried)


_poses = Cache[Posed](MOST_CACHED)


def _find(
    figure: Figure,
    home: Array,
    free: Mask,
    goals: tuple[Goal, ...],
    bends: BendLimits | None,
    starts: int,
    preferred: tuple[tuple[float, Goal], ...],
) -> Posed:
    """Return the pose for goals that share free joints, from the cache if possible. Joints that the goals do not depend
    on are set to the rest pose, so that they do not change the cache key. Editing a clip repeats most of its poses."""
    goal_key = entries_of(figure, goals)
    home, free = np.where(goal_key, home, figure.model.qpos0), free & goal_key
    key = cache_key((figure.digest, home, free, goals, bends, starts, preferred))
    return _poses.get(key, lambda: _pose(PoseSearch(figure, home, free, goals, bends, preferred=preferred), starts))


def _pose(search: PoseSearch, starts: int) -> Posed:
    """Return the pose for goals that share free joints."""
    best = search.result(search.home)
    if best.is_met or not search.dofs.size:
        return best
    near = [search.rough_minimum(start) for start in search.bent_starts()[:starts]]
    poses: list[Posed] = []
    last = 0.0
    for rough, cost in sorted(near, key=lambda pair: pair[1]):
        if cost > (1 + ALIKE) * last:  # otherwise the same as the previous rough pose
            poses.append(search.refine(rough))
            if poses[-1].is_met:
                return poses[-1]
        last = cost
    for start in search.starts_around(starts - len(near)):
        poses.append(search.refine(search.rough_minimum_near(start)))
        if poses[-1].is_met:
            return poses[-1]
    closest = search.minimum(min(poses, key=lambda pose: pose.worst).qpos)
    return replace(min([best, *poses, closest], key=lambda pose: pose.worst), starts=starts)


def in_winding(figure: Figure, qpos: Array, near: Array, which: Mask) -> Array:
    """Return qpos (nq,) with unlimited hinges shifted by multiples of 2π to be nearest to another pose.

    Args:
        qpos: The pose, (nq,).
        near: The other pose, (nq,).
        which: The mask of the entries that may be shifted, (nq,).
    """
    out, limited = np.array(qpos), figure.model.jnt_limited
    columns = [link.qpos for link in figure.links[1:] if link.kind is JointKind.HINGE and not limited[link.joint]]
    unlimited = np.array([column for column in columns if which[column]], np.intp)
    out[unlimited] += 2 * np.pi * np.round((near[unlimited] - out[unlimited]) / (2 * np.pi))
    return out


def _apart(figure: Figure, free: Mask, goals: Sequence[Goal]) -> list[list[int]]:
    """Return the indices of goals in groups; goals that share free joints are in the same group."""
    groups: list[tuple[set[int], list[int]]] = []
    for number, goal in enumerate(goals):
        links = {i for i in moved_by(figure, goal) if free[figure.links[i].columns].any()}
        touched = [group for group in groups if group[0] & links]
        groups = [group for group in groups if not group[0] & links]
        merged = sorted(i for _, members in touched for i in members)
        groups.append((links.union(*(members for members, _ in touched)), [*merged, number]))
    return [members for _, members in groups]
