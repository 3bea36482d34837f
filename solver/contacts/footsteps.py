"""Footsteps: the steps of two feet in turn, inferred between two keyframes if both feet change their places."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from .. import quaternion as quat
from ..array import Array
from ..surface.heights import height_above
from .keyframe_points import KeyframePoints
from .stance import Stance
from .steps import same_leg

OVERLAP = 0.08  # [1] half of the time on both feet between two steps, relative to the time of a step
FIRM = 10.0  # [1] weight of the stances, relative to those between keyframes of the same position
WIDEST = 1.75  # [rad] largest turn of one foot ahead of the other
PASSING_TURN = 0.35  # [rad] likewise of a foot that overtakes the other one
PASSING = 0.25  # [1] largest lead sideways of a foot that overtakes the other one, relative to their distance sideways
SIDEWAYS = 0.05  # [1] travel to the side, relative to all travel, from which it decides which foot steps first
MOST_TRIED = 4  # patterns of steps that are tried if there is no ground for them
ROUNDING = 1e-9  # [s] rounding tolerance of times
CLEAR = 0.4  # [1] least height of a foot in the middle of a step, relative to that of the initial guess
STEEP = 0.3  # [1] height of a foot in the middle of a short step, relative to its length
UP = np.array([0.0, 0, 1])


@dataclass(frozen=True)
class Swing(Stance):
    """A point of a foot that takes a step from `spot` to `landed`.

    Attributes:
        height: How far the point stays above the line between them in the middle of the step, at least [m].
    """

    height: float = 0.0

    def lowest(self, t: Array) -> Array:
        """Return the smallest height of the point at times t (S,) [s], (S,) [m]."""
        share = (t - self.first) / (self.last - self.first)
        return np.asarray(self.place(t)[2] + self.height * np.sin(np.pi * share) ** 2)


@dataclass(frozen=True, eq=False)
class Footsteps:
    """The steps of two feet in turn between two keyframes, because both change their places.

    Attributes:
        segment: The index of the first keyframe.
        leading: The link of the foot that steps first.
        count: The number of steps.
        stances: The stances before, between and after the steps.
        swings: The movements of the points of the feet between the stances.
        poses: Times [s] in the middle of each step and between steps, with positions (3, n) [m] of all sole points for
            the initial guess.
    """

    segment: int
    leading: int
    count: int
    stances: tuple[Stance, ...]
    swings: tuple[Swing, ...]
    poses: tuple[tuple[float, Array], ...]


def footsteps(soles: KeyframePoints) -> tuple[tuple[Footsteps, ...], ...]:
    """Return the steps between keyframes, each in all possible orders.

    In both keyframes, all points of both feet are near a surface, and both feet move by more than 8 cm (for an adult).
    They take as few steps in turn as possible, of at least 0.4 s each, which fill the time between the keyframes.
    Neither foot gets more than 70 cm or 100° ahead of the other, each measured along its way, and they do not cross.
    Between the steps they stand on the ground.

    In the first order, the leading foot is the one on the side to which the figure moves or turns, so that legs do not
    cross; if it does neither, the foot behind.

    If one foot is in the air in one keyframe, these are at least 0.6 s apart and the other foot moves by at most 70 cm,
    it is the leading foot in the first keyframe and the following foot in the second one, and there is no other order.
    """
    feet = _feet(soles)
    if len(feet) != 2:
        return ()
    limits, spans = soles.limits, np.diff(soles.keys.times)
    low, high = soles.is_near, (soles.heights > limits.near_surface) & soles.is_known
    stands, raised = (np.array([points_at[foot].all(axis=0) for foot in feet]) for points_at in (low, high))
    least, most = (np.array([end(soles.moves[foot], axis=0) for foot in feet]) for end in (np.min, np.max))
    moves = (least > limits.same_spot) & (most > limits.strode)
    result = list[tuple[Footsteps, ...]]()
    for foot, other in ((0, 1), (1, 0)):
        is_step = moves[other] & (most[other] < limits.longest_step) & (spans >= 1.5 * limits.far_apart - ROUNDING)
        is_step &= stands[other, :-1] & stands[other, 1:]
        for k in np.flatnonzero(is_step & raised[foot, :-1] & stands[foot, 1:]).tolist():
            result.append((_Walk(soles, k, feet[foot], feet[other]).landing,))
        for k in np.flatnonzero(is_step & stands[foot, :-1] & raised[foot, 1:]).tolist():
            result.append((_Walk(soles, k, feet[other], feet[foot]).lifting,))
    for k in np.flatnonzero(stands[:, :-1].all(axis=0) & stands[:, 1:].all(axis=0) & moves.all(axis=0)).tolist():
        walk = _Walk(soles, k, *feet)
        orders = (walk, walk.reversed) if walk.is_in_order else (walk.reversed, walk)
        possible = [steps for order in orders if (steps := order.fewest()) is not None]
        result.append(tuple(sorted(possible, key=lambda steps: steps.count)))
    return tuple(sorted(filter(None, result), key=lambda orders: orders[0].segment))


@dataclass(frozen=True, eq=False)
class _Walk:
    """Two feet that step in turn from keyframe k to the next.

    Attributes:
        leading: The indices of the points of the foot that steps first.
        following: Those of the other foot.
    """

    soles: KeyframePoints
    k: int
    leading: list[int]
    following: list[int]

    @property
    def reversed(self) -> _Walk:
        """The walk in which the other foot steps first."""
        return replace(self, leading=self.following, following=self.leading)

    @property
    def landing(self) -> Footsteps:
        """Two steps, of which the first begins in the air and takes half as long as the second."""
        return self._steps((1.0, 1.0), np.array([0.0, 1 / 3, 1.0]), is_landing=True)

    @property
    def lifting(self) -> Footsteps:
        """Two steps, of which the second ends in the air and takes half as long as the first."""
        return self._steps((1.0, 1.0), np.array([0.0, 2 / 3, 1.0]), is_lifting=True)

    def fewest(self) -> Footsteps | None:
        """Return the smallest possible number of steps; None without one."""
        tried, span = 0, float(np.diff(self.soles.keys.times)[self.k])
        for count in range(2, int(span / self.soles.limits.far_apart + ROUNDING) + 1):
            for shares in _patterns(count):
                if not self._is_short(np.array(shares)):
                    continue
                if self._has_ground(shares):
                    return self._steps(shares, np.linspace(0, 1, count + 1))
                tried += 1
            if tried >= MOST_TRIED:
                return None
        return None

    @property
    def is_in_order(self) -> bool:
        """Whether the leading foot is on the side to which the figure moves or turns, or else the foot behind."""
        as_tall, travel = self.soles.limits.as_tall, self._travel
        # if the feet are farther apart sideways after the first step, the figure moves to the side of that foot
        side = np.sign(self._halfway(self._apart).sum(axis=1) @ self._leftward)
        preference = side * (travel @ self._leftward + self.soles.limits.turning * self._turn)
        if abs(preference) > as_tall + SIDEWAYS * float(np.linalg.norm(travel)):
            return bool(preference > 0)
        return bool(self._apart[:, 0] @ travel <= 0)

    def _is_short(self, shares: Array) -> bool:
        """Return whether steps that land at these fractions (n,) of the way are short and do not cross."""
        limits, ahead = self.soles.limits, float(np.abs(np.diff([0.0, *shares])).max())
        moves = self.soles.moves[[*self.leading, *self.following], self.k]
        if ahead * moves.max() >= limits.longest_step or ahead * abs(self._turn) >= WIDEST:
            return False
        if shares[1] <= shares[0]:
            return True
        # the feet overtake each other
        sideways = abs(float(self._travel @ self._leftward)) / 2
        apart = float(np.abs(self._halfway(self._apart).T @ self._leftward).min())
        return ahead * abs(self._turn) <= PASSING_TURN and ahead * sideways <= PASSING * apart + limits.as_tall

    def _has_ground(self, shares: tuple[float, ...]) -> bool:
        """Return whether the feet stand on ground at these fractions of the way, between the keyframes."""
        landings = [(i, share) for j, share in enumerate(shares) for i in self._foot(j) if share < 1]
        if not landings:
            return True
        centres = np.array([self._place(i, share) for i, share in landings]).T
        height = height_above(self.soles.surfaces, centres, self.soles.radii[[i for i, _ in landings]])
        return bool((np.abs(height) < self.soles.limits.near_surface).all())

    def _steps(
        self, shares: tuple[float, ...], edges: Array, *, is_landing: bool = False, is_lifting: bool = False
    ) -> Footsteps:
        """Return steps in turn.

        Args:
            shares: How far along its way the foot is after each of the n steps.
            edges: The limits of the steps relative to the time between the keyframes, (n + 1,).
            is_landing: Whether the leading foot is in the air in the first keyframe.
            is_lifting: Whether the following foot is in the air in the second keyframe.
        """
        begin, end = self.soles.keys.times[self.k : self.k + 2].tolist()
        count, times = len(shares), begin + (end - begin) * edges
        overlap = OVERLAP * (end - begin) / count
        lifts, lands = times[:-1] + overlap, times[1:] - overlap
        lifts[0], lands[-1] = begin if is_landing else lifts[0], end if is_lifting else lands[-1]
        stances, swings = list[Stance](), list[Swing]()
        for first in (0, 1):
            turns = range(first, count, 2)
            bounds = [begin, *(t for j in turns for t in (float(lifts[j]), float(lands[j]))), end]
            landed = 0.0, *(shares[j] for j in turns)
            heights = [CLEAR * self._raised(first, after - before) for before, after in pairwise(landed)]
            for i in self._foot(first):
                point, spots = self.soles.points[i], [self._place(i, share) for share in landed]
                for spot, start, stop in zip(spots, bounds[::2], bounds[1::2], strict=True):
                    if start < stop:
                        stances.append(Stance(point, start, stop, spot, spot, FIRM))
                for spots_of_step, start, stop, height in zip(
                    pairwise(spots), bounds[1:-1:2], bounds[2::2], heights, strict=True
                ):
                    is_whole = not ((is_landing and start == begin) or (is_lifting and stop == end))
                    swings.append(Swing(point, start, stop, *spots_of_step, height=height * is_whole))
        leading = int(self.soles.links[self.leading[0]])
        poses = tuple(self._poses(shares, times))
        return Footsteps(self.k, leading, count, tuple(stances), tuple(swings), poses)

    def _poses(self, shares: tuple[float, ...], times: Array) -> Iterator[tuple[float, Array]]:
        """Yield times and positions of points as in `Footsteps.poses`; steps have limits (n + 1,) [s]."""
        at = [0.0, 0.0]  # the fractions of the way of the two feet
        for j, share in enumerate(shares):
            for is_landed, time in ((False, times[j : j + 2].mean()), (True, times[j + 1])):
                raised = self._raised(j, share - at[j % 2]) * UP * (not is_landed)
                at[j % 2] = share if is_landed else (at[j % 2] + share) / 2
                places = np.empty((3, len(self.soles.points)))
                for foot in (0, 1):
                    for i in self._foot(foot):
                        places[:, i] = self._place(i, at[foot]) + raised * (foot == j % 2)
                if j + 1 < len(shares) or not is_landed:
                    yield float(time), places

    def _raised(self, step: int, share: float) -> float:
        """Return the height [m] of a foot in the middle of a step over a fraction of its way, in the initial guess."""
        length = abs(share) * float(self.soles.moves[self._foot(step), self.k].max())
        return min(STEEP * length, self.soles.limits.mid_step)

    def _foot(self, step: int) -> list[int]:
        """Return the points of the foot that takes a step."""
        return self.following if step % 2 else self.leading

    def _place(self, i: int, share: float) -> Array:
        """Return the position (3,) [m] of a point at a fraction of its way, on which the feet turn evenly."""
        first, last = self.soles.centres[:, i, self.k], self.soles.centres[:, i, self.k + 1]
        if share in (0.0, 1.0):
            return np.array(last if share else first)
        before, after = self._places.mean(axis=0).T
        offset = (1 - share) * (first - before) + share * (_about_vertical(-self._turn) @ (last - after))
        return before + share * (after - before) + _about_vertical(share * self._turn) @ offset

    @cached_property
    def _places(self) -> Array:
        """The centres of the two feet in the two keyframes, (2, 3, 2) [m]."""
        at = self.soles.centres[..., self.k : self.k + 2]
        return np.array([at[:, foot].mean(axis=1) for foot in self._both])

    @cached_property
    def _ahead(self) -> Array:
        """Vectors from ankles to soles in both keyframes, (3, 2); about zero for feet that are points."""
        links = self.soles.links[[foot[0] for foot in self._both]]
        return (self._places - np.moveaxis(self.soles.samples.links.x[:, links, self.k : self.k + 2], 0, 1)).sum(axis=0)

    @cached_property
    def _turn(self) -> float:
        """The angle [rad] by which the feet turn about the vertical."""
        rotation = self.soles.samples.links.rotation[:, :, [self.soles.links[foot[0]] for foot in self._both]]
        turned = np.einsum("ijf,kjf->ik", rotation[..., self.k + 1], rotation[..., self.k])
        return float(np.arctan2(turned[1, 0] - turned[0, 1], turned[0, 0] + turned[1, 1]))

    @property
    def _both(self) -> tuple[list[int], list[int]]:
        return self.leading, self.following

    @property
    def _apart(self) -> Array:
        """Vectors from the following foot to the leading one in both keyframes, (3, 2) [m]."""
        return self._places[0] - self._places[1]

    @property
    def _travel(self) -> Array:
        """The sum of the displacements of both feet, (3,) [m]."""
        return (self._places[..., 1] - self._places[..., 0]).sum(axis=0)

    @cached_property
    def _leftward(self) -> Array:
        """The unit vector to the left after half of the turn, (3,); for feet that are points along the line between."""
        as_tall, leftward = self.soles.limits.as_tall, np.cross(UP, self._halfway(self._ahead).sum(axis=1))
        if np.linalg.norm(leftward) < as_tall:
            leftward = self._apart.sum(axis=1) * [1, 1, 0]
        return leftward / max(float(np.linalg.norm(leftward)), as_tall)

    def _halfway(self, vectors: Array) -> Array:
        """Return vectors (3, 2) of both keyframes in the direction that they have after half of the turn."""
        half = self._turn / 2
        return np.column_stack([_about_vertical(half) @ vectors[:, 0], _about_vertical(-half) @ vectors[:, 1]])


def _patterns(count: int) -> Iterator[tuple[float, ...]]:
    """Yield the fractions of the way at which steps of two feet land in turn.

    The feet overtake each other, as in a walk, or the second foot follows to the place of the first, as in steps to the
    side.
    """
    yield tuple(min(1.0, j / (count - 1)) for j in range(1, count + 1))
    if count % 2 == 0 and count > 2:
        yield tuple((j // 2) / (count // 2) for j in range(2, count + 2))


def _about_vertical(angle: float) -> Array:
    """Return the matrix (3, 3) of a rotation about the vertical by an angle [rad]."""
    return quat.matrices(quat.from_rotation_vector(angle * UP))


def _feet(soles: KeyframePoints) -> list[list[int]]:
    """Return the indices of the points of each foot. Of several links of a foot, that next to the leg comes first."""
    feet: list[list[int]] = []
    is_same_leg, depths = same_leg(soles.figure), soles.figure.tables.path.sum(axis=1)
    for i in np.argsort(depths[soles.links], kind="stable").tolist():
        foot = next((foot for foot in feet if is_same_leg[soles.links[i], soles.links[foot[0]]]), None)
        if foot is None:
            feet.append([i])
        else:
            foot.append(i)
    return feet
