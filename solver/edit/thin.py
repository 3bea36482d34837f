"""Thinning: few keyframes whose in-between stays within a bound of a recorded motion.

Keyframes are at instants of the recording, so a choice of keyframes is a set of instants. First, greedy insertion where
the in-between deviates most satisfies the bound. Then keyframes are removed that are not needed, or whose neighbours
can compensate after a move, until no more can be removed. The minimum would require a search of every set; on short
motions the result has at most one keyframe more. Sliding is more visible than a small offset in motion. The bound is
therefore stricter for hands and feet while they are still, which leads to keyframes where contacts begin and end.

Insertion at the largest deviation is the method of U. Ramer (1972) and D. Douglas & T. Peucker (1973), here for a
spline instead of a polygon. A spline changes on both sides of a keyframe, so each trial checks the neighbourhood of its
change.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from ..array import Array, Index, Mask, runs
from ..curve.frame import Frame, Timeline
from ..curve.seam import Seam
from ..curve.spline import path_of
from ..curve.unknowns import raw_timeline
from ..figure.figure import Figure, on_links
from ..figure.kinematics import LinkMotion, States
from ..surface.points import body_points

InBetween = Callable[[Sequence[Frame]], Timeline]

REACH = 4  # keyframes on either side of a change that a trial checks; beyond, a spline moves by less than 1 %
MARGIN = 3  # further keyframes on either side that the spline of a trial interpolates
SHARE = 0.5  # [1] deviation relative to the worst, from which segments get a keyframe in the same round
NEAR = 3  # keyframes on either side of a removed one that may move
FIRST_STEP, LEAST_STEP = 0.5, 0.04  # [1] first and smallest moves, relative to the distance to the next keyframe
GAIN = 0.98  # [1] maximum excess after a useful move, relative to that before
FINE = 1e-9  # [1] rounding tolerance of the bound
STILL = 0.1  # [m/s] speed below which the end of a limb is still, above that of captured feet in stance
STANDS = 0.1  # [s] minimum duration of stillness; a shorter one is a reversal
CLOSELY = 0.25  # [1] factor of the bound for ends of limbs that are still


@dataclass(frozen=True)
class Bound:
    """The error bound: distance [m] of a body's origin or site, angle [rad] of a link."""

    distance: float
    angle: float

    def __post_init__(self) -> None:
        if not (self.distance > 0 and self.angle > 0):
            raise ValueError(f"a bound is above 0, not {self.distance:g} m and {self.angle:g} rad")


@dataclass(frozen=True)
class Worst:
    """The largest deviation of one kind: value [m or rad], instant, and name of the point or link."""

    value: float
    instant: int
    name: str


@dataclass(frozen=True, eq=False)
class Recorded:
    """The motion to approximate, and the bound.

    Attributes:
        times: The instants, (S,) [s], rising.
        qpos: The configurations, (S, nq).
        ends: The end conditions of the in-between, see `Problem`; also `travel` and `turn`.
    """

    figure: Figure
    times: Array
    qpos: Array
    bound: Bound
    ends: str = "free"
    travel: ArrayLike | None = None
    turn: float | None = None

    @cached_property
    def points(self) -> tuple[tuple[str, ...], Index, Array]:
        """The compared points: names, links (n,), and positions (3, n) [m] in the links.

        They are the origins of moving bodies, the sites on them, and the tips of limbs that have no site.
        """
        figure, model = self.figure, self.figure.model
        names = [model.body(i).name or f"body {i}" for i in range(model.nbody)]
        located = [(name, figure.point_on_link(i, np.zeros(3))) for i, name in enumerate(names)]
        for i in range(model.nsite):
            place = figure.point_on_link(int(model.site_bodyid[i]), model.site_pos[i])
            located.append((model.site(i).name or f"site {i} of {names[model.site_bodyid[i]]}", place))
        moving = [(name, link, place) for name, (link, place) in located if link]
        moving += tips(figure, {int(model.site_bodyid[i]) for i in range(model.nsite)})
        called, links, places = zip(*moving, strict=True)
        return called, np.array(links, np.intp), np.array(places).T

    @cached_property
    def _weights(self) -> Array:
        _, links, places = self.points
        return on_links(places, links, len(self.figure.links))

    def _poses(self, states: Array) -> tuple[Array, Array]:
        """Return positions of the points (3, n, S) and unit orientations of the links (4, L, S) for states (S, N)."""
        links = LinkMotion(States(self.figure, states, states, states))
        turned = links.Q / np.sqrt(links.length_squared)
        return links.x.take(self.points[1], axis=1) + links.fixed(self._weights), turned

    @cached_property
    def _recorded_poses(self) -> tuple[Array, Array]:
        return self._poses(self.figure.to_state(self.qpos))

    @cached_property
    def is_still(self) -> Mask:
        """Whether a point at the end of a limb is still for some time, (n, S)."""
        links = self.points[1]
        ends = self.figure.tables.children[links] == 0
        slow = np.zeros((links.size, self.times.size), bool)
        if self.times.size > 1:
            velocity = np.gradient(self._recorded_poses[0], self.times, axis=2)
            slow[ends] = np.einsum("cns,cns->ns", velocity, velocity)[ends] < STILL**2
        return np.array([_long_runs(row, self.times, STANDS) for row in slow])

    @cached_property
    def _lengths(self) -> Array:
        """The permitted errors of the points, (n, S) [m]."""
        return self.bound.distance * np.where(self.is_still, CLOSELY, 1.0)

    @cached_property
    def _states(self) -> Array:
        return raw_timeline(self.figure, self.frames(range(len(self.times)))).states

    def misses(self, timeline: Timeline) -> tuple[Array, Array]:
        """Return distances (n, S) [m] of the points and angles (L, S) [rad] of the links at the instants."""
        return self._misses(path_of(timeline).at(self.times), np.arange(len(self.times)))

    def _misses(self, states: Array, instants: Index) -> tuple[Array, Array]:
        """Return the deviations of states (R, N) at the instants (R,)."""
        places, turned = self._poses(states)
        own_places, own_turned = (own_values.take(instants, axis=2) for own_values in self._recorded_poses)
        apart = places - own_places
        sign = np.where(np.einsum("cls,cls->ls", turned, own_turned) < 0, -1.0, 1.0)
        chord = turned - sign * own_turned
        half = np.sqrt(np.einsum("cls,cls->ls", chord, chord)) / 2
        return np.sqrt(np.einsum("cns,cns->ns", apart, apart)), 4 * np.arcsin(half)

    def excess(self, timeline: Timeline) -> Array:
        """Return the largest deviation at every instant, as a multiple of the bound, (S,)."""
        return self._excess(*self.misses(timeline), np.arange(len(self.times)))

    def _excess(self, distance: Array, angle: Array, instants: Index) -> Array:
        lengths = self._lengths.take(instants, axis=1)
        return np.maximum((distance / lengths).max(axis=0), angle.max(axis=0) / self.bound.angle)

    def breaches(self, sets: Sequence[Sequence[int]], at: int) -> Array:
        """Return by how much raw splines through sets of instants exceed the bound near one instant of each set.

        The value is Σ max(0, excess − 1)², see `excess`, for splines through REACH + MARGIN keyframes on either side,
        with the signs of the recording.

        Args:
            sets: Sets of instants, all of the same size.
            at: The index of the instant in the sets.

        Returns:
            The values, (len(sets),).
        """
        if self.ends.startswith("clamped"):
            over = [self.excess(self.spline(self.frames(selection))) - 1 - FINE for selection in sets]
            return np.sum(np.maximum(over, 0) ** 2, axis=1)
        chosen, last = np.array(sets), len(self.times) - 1
        numbers, first, end = self._near(chosen.shape[1], at)
        turns, numbers = np.divmod(numbers, chosen.shape[1] - 1) if self.ends == "periodic" else (0 * numbers, numbers)
        neighbours = chosen[:, numbers] + turns * last  # instants, continued through the periods of a loop
        spans = [np.arange(row[first], row[end] + 1) for row in neighbours]
        owner = np.repeat(np.arange(len(sets)), [span.size for span in spans])
        instants = np.concatenate(spans)
        times, values = self._unrolled(neighbours)
        states = natural_splines(times, values, owner, self._unrolled(instants)[0])
        if self.ends == "periodic":
            turns, instants = np.divmod(instants, last)
            states = self._seam.moved(states, -turns)
        over = np.maximum(self._excess(*self._misses(states, instants), instants) - 1 - FINE, 0)
        return np.bincount(owner, over**2, len(sets)).astype(float)

    def _near(self, count: int, at: int) -> tuple[Index, int, int]:
        """Return indices of keyframes, of `count`, around `at`, and the two that bound the examined span."""
        if self.ends == "periodic":
            before = min(REACH, (count - 1) // 2)
            after = min(REACH, count - 1 - before)
            return np.arange(at - before - MARGIN, at + after + MARGIN + 1), MARGIN, MARGIN + before + after
        low, high = max(0, at - REACH - MARGIN), min(count, at + REACH + MARGIN + 1)
        return np.arange(low, high), max(0, at - REACH) - low, min(count - 1, at + REACH) - low

    @cached_property
    def _seam(self) -> Seam:
        return Seam.between(self.figure, self._states[0], self._states[-1])

    def _unrolled(self, instants: Index) -> tuple[Array, Array]:
        """Return times (...) and states (..., N) at instants (...), which may lie outside the period of a loop."""
        if self.ends != "periodic":
            return self.times[instants], self._states[instants]
        turns, within = np.divmod(instants, len(self.times) - 1)
        states = self._seam.moved(self._states[within], turns)
        return self.times[within] + turns * (self.times[-1] - self.times[0]), states

    def worst(self, timeline: Timeline) -> tuple[Worst, Worst]:
        names = self.points[0], [link.name for link in self.figure.links]
        largest = []
        for missed, called in zip(self.misses(timeline), names, strict=True):
            row, instant = np.unravel_index(int(missed.argmax()), missed.shape)
            largest.append(Worst(float(missed[row, instant]), int(instant), called[row]))
        return largest[0], largest[1]

    def slipped(self, timeline: Timeline) -> float:
        return float(self.misses(timeline)[0][self.is_still].max(initial=0.0))

    def frames(self, instants: Sequence[int]) -> list[Frame]:
        return Frame.many(
            self.times[list(instants)], self.qpos[list(instants)], np.ones((len(instants), self.figure.width), bool)
        )

    def spline(self, keys: Sequence[Frame]) -> Timeline:
        slope = np.zeros((2, self.figure.width)) if self.ends.startswith("clamped") else None
        travel, turn = (self.travel, self.turn) if self.ends == "periodic" else (None, None)
        return raw_timeline(self.figure, list(keys), self.ends, slope, travel, turn)


@dataclass(frozen=True, eq=False)
class Thinned:
    """The selected instants, and the in-between through them."""

    instants: tuple[int, ...]
    timeline: Timeline


def thin(recorded: Recorded, report: Callable[[str], None] = lambda note: None) -> Thinned:
    """Return a small set of instants whose raw spline stays within the bound at every sample of the recording."""
    selection = refined(recorded, (0, len(recorded.times) - 1), recorded.spline, report).instants
    while True:
        fewer = _repaired(recorded, _without_redundant(recorded, list(selection), report), report)
        if len(fewer) == len(selection):
            return Thinned(tuple(fewer), recorded.spline(recorded.frames(fewer)))
        selection = tuple(fewer)


def refined(
    recorded: Recorded, instants: Sequence[int], inbetween: InBetween, report: Callable[[str], None] = lambda note: None
) -> Thinned:
    """Return more instants, each where the in-between deviates most, until it is within the bound at all samples."""
    chosen = sorted(instants)
    while True:
        timeline = inbetween(recorded.frames(chosen))
        excess = recorded.excess(timeline)
        report(f"{len(chosen)} keyframes, {excess.max():.3g} × the bound")
        if excess.max() <= 1 + FINE or len(chosen) == len(recorded.times):
            return Thinned(tuple(chosen), timeline)
        excess[chosen] = 0.0
        least = max(1.0, SHARE * excess.max())
        peaks = [a + 1 + int(excess[a + 1 : b].argmax()) for a, b in pairwise(chosen) if b > a + 1]
        chosen = sorted([*chosen, *(peak for peak in peaks if excess[peak] >= min(least, excess.max()))])


def tips(figure: Figure, marked: Set[int]) -> list[tuple[str, int, Array]]:
    """Return the tips of limbs, farthest from their last joint: name, link and position (3,) [m] in it.

    Args:
        marked: Bodies that have a site, which serves as the tip of their limbs.
    """
    model, out = figure.model, []
    ends = set(np.flatnonzero(figure.tables.children == 0).tolist())
    ends -= {figure.point_on_link(body, np.zeros(3))[0] for body in marked}
    far: dict[int, tuple[float, Array]] = {}
    for point in body_points(figure) if ends else ():
        size = float(np.linalg.norm(point.position))
        if point.link in ends and size > 0 and size + point.radius > far.get(point.link, (0.0,))[0]:
            far[point.link] = size + point.radius, point.position * (1 + point.radius / size)
    for link, (_, place) in sorted(far.items()):
        name = model.body(figure.links[link].body).name or f"body {figure.links[link].body}"
        out.append((f"tip of {name}", link, place))
    return out


def _long_runs(mask: Mask, times: Array, least: float) -> Mask:
    """Return a mask (S,) without runs shorter than `least` [s]."""
    out = np.zeros(mask.size, bool)
    for first, end in runs(mask):
        out[first:end] = times[end - 1] - times[first] >= least
    return out


def natural_splines(times: Array, values: Array, owner: Index, t: Array) -> Array:
    """Return natural cubic splines, many at once, at t (S,) [s].

    The second derivatives solve the usual tridiagonal system, here as a dense matrix because the splines are short.

    Args:
        times: Knots, (C, K) [s].
        values: Values at the knots, (C, K, N).
        owner: The spline of each time, (S,).
    """
    h = np.diff(times)
    count = times.shape[1]
    inner = np.arange(1, count - 1)
    matrix = np.tile(np.eye(count), (len(times), 1, 1))
    matrix[:, inner, inner - 1], matrix[:, inner, inner + 1] = h[:, :-1], h[:, 1:]
    matrix[:, inner, inner] = 2 * (h[:, :-1] + h[:, 1:])
    bends = np.zeros(values.shape)
    bends[:, 1:-1] = 6 * np.diff(np.diff(values, axis=1) / h[:, :, None], axis=1)
    bends = np.linalg.solve(matrix, bends)
    segment = np.clip((times[owner] <= t[:, None]).sum(axis=1) - 1, 0, count - 2)
    step = h[owner, segment, None]
    ahead = (t - times[owner, segment])[:, None] / step
    behind = 1 - ahead
    straight = behind * values[owner, segment] + ahead * values[owner, segment + 1]
    bent = (behind**3 - behind) * bends[owner, segment] + (ahead**3 - ahead) * bends[owner, segment + 1]
    return straight + bent * step**2 / 6


def _is_within_bound(recorded: Recorded, instants: Sequence[int]) -> bool:
    return float(recorded.excess(recorded.spline(recorded.frames(instants))).max()) <= 1 + FINE


def _without_redundant(recorded: Recorded, instants: list[int], report: Callable[[str], None]) -> list[int]:
    """Return the keyframes without those that are not needed; those with the nearest neighbours are removed first."""
    needed = {instants[0], instants[-1]}
    while True:
        loss = {i: recorded.breaches([_dropped(instants, i)], n)[0] for n, i in enumerate(instants) if i not in needed}
        gone = 0
        for i in sorted(
            (i for i in loss if loss[i] == 0),
            key=lambda i: instants[instants.index(i) + 1] - instants[instants.index(i) - 1],
        ):
            fewer = _dropped(instants, i)
            if recorded.breaches([fewer], instants.index(i))[0] == 0 and _is_within_bound(recorded, fewer):
                instants, gone = fewer, gone + 1
        if not gone:
            return instants
        report(f"{len(instants)} keyframes")


def _repaired(recorded: Recorded, instants: list[int], report: Callable[[str], None]) -> list[int]:
    """Return the keyframes without those that their neighbours can replace after a move."""
    needed = {instants[0], instants[-1]}
    for i in list(instants):
        if i in instants and i not in needed:
            at = instants.index(i)
            moved = _moved(recorded, _dropped(instants, i), at)
            if moved is not None and _is_within_bound(recorded, moved):
                instants = moved
                report(f"{len(instants)} keyframes")
    return instants


def _moved(recorded: Recorded, instants: list[int], at: int) -> list[int] | None:
    """Return instants with those near index `at` moved one at a time until the bound holds there, or None. The first
    steps are half the distance to the neighbour. They become shorter if none helps, down to one instant."""
    needed = {instants[0], instants[-1]}
    near = [n for n in range(max(0, at - NEAR), min(len(instants), at + NEAR)) if instants[n] not in needed]
    breach, share = float(recorded.breaches([instants], at)[0]), FIRST_STEP
    while breach > 0:
        trials = []
        for n in near:
            for neighbour in (instants[n - 1], instants[n + 1]):
                place = instants[n] + (
                    round(share * (neighbour - instants[n])) or int(np.sign(neighbour - instants[n]))
                )
                if place != neighbour:
                    trials.append([*instants[:n], place, *instants[n + 1 :]])
        remaining = recorded.breaches(trials, at) if trials else np.array([np.inf])
        best = int(remaining.argmin())
        if remaining[best] < GAIN * breach:
            instants, breach = trials[best], float(remaining[best])
        elif share > LEAST_STEP:
            share /= 2
        else:
            return None
    return instants


def _dropped(instants: Sequence[int], removed: int) -> list[int]:
    return [i for i in instants if i != removed]
