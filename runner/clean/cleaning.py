"""A repaired recording, its stances, and the motion near it that keeps to them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import Path, natural_spline, path_of
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Near, Rest
from dynsplines.solver.problem import Problem
from dynsplines.solver.reading.recorded import Recorded
from dynsplines.solver.reading.settled import on_the_ground, settled
from dynsplines.solver.reading.stances import NEAR, Stood, stood, unsure
from dynsplines.solver.solution import Improvement, Solution

from ..clip.follow.keeping import Ground, problem
from .repairs import Repaired

NOISY = 0.008  # [m] of the soles' places, from which on stances are looked for twice
STRICTER, TRIES = 2.0, 7  # how much more the recording counts every time that something is too far off it


@dataclass(frozen=True, eq=False)
class Cleaned:
    """A recording and the motion that it was made.

    before   the spline through the samples as they were recorded
    recorded what the motion is near: smoothed, on its soles
    rests    the stances that it keeps
    problem  what was asked for
    """

    ground: Ground
    before: Path
    recorded: Recorded
    rests: tuple[Rest, ...]
    problem: Problem
    solution: Solution

    @property
    def figure(self) -> Figure:
        return self.ground.figure

    @property
    def after(self) -> Path:
        """The motion."""
        return path_of(self.solution.timeline)

    @property
    def frames(self) -> list[Frame]:
        """The motion as keyframes, every frame one."""
        figure, timeline = self.figure, self.solution.timeline
        return [Frame.key(frame.time, figure.to_qpos(frame.state)) for frame in timeline.frames]


class Verdict(NamedTuple):
    """How far [m] what is off a recording, at most, and whether nothing slips or sinks."""

    off: float
    is_sound: bool = True


def cleaned(
    ground: Ground,
    repaired: Repaired,
    given: Sequence[Rest] | None = None,
    *,
    within: float | None = None,
    verdict: Callable[[Cleaned], Verdict] = lambda cleaned: Verdict(0.0),
    improved: Callable[[Improvement], None] | None = None,
) -> Cleaned:
    """The motion near a recording that keeps to its stances.

    given   the stances, instead of those that are read off the recording
    within  [m] that nothing should be off it: it counts more until nothing is, as long as stances are kept to
    verdict how far what is off the recording, and whether the motion is sound
    """
    figure = ground.figure
    recorded = Recorded.of(figure, repaired.time, repaired.qpos, _by_state(figure, repaired.known))
    before = natural_spline(recorded.times, np.where(recorded.known > 0, recorded.states, recorded.bridged))
    recorded = on_the_ground(recorded, ground.points, ground.surfaces)
    stances: Sequence[Stood] = [Stood(one.point, one.first, one.last) for one in given or ()]
    if given is None:
        stances = stood(recorded, ground.points, ground.surfaces)
    recorded = settled(recorded, stances, ground.surfaces)
    if given is None:
        stances = stood(recorded, ground.points, ground.surfaces, NEAR)
    rests = tuple(Rest(*stance) for stance in stances)
    near = Near(recorded)
    asked = problem(near, ground, rests, near.times())
    found = Cleaned(ground, before, recorded, rests, asked, inbetween(asked, improved=improved))
    if given is None and unsure(recorded, ground.points) > NOISY:
        found = _second_look(found, near, improved)
        asked = found.problem
    if within is None:
        return found
    for _ in range(TRIES):
        off = verdict(found).off
        if off <= within:
            break
        weights = [(p, STRICTER * w if p is near else w) for p, w in asked.penalties]
        asked = replace(asked, penalties=tuple(weights), keys=_from(found))
        closer = replace(found, solution=inbetween(asked, improved=improved))
        told = verdict(closer)
        if told.off >= off or not told.is_sound:
            break
        found = closer
    return found


def _second_look(found: Cleaned, near: Near, improved: Callable[[Improvement], None] | None) -> Cleaned:
    """Of a noisy recording more stances are seen once the surest of them are kept: cleaned with those."""
    ground, recorded = found.ground, found.recorded
    calm = Recorded.of(ground.figure, recorded.times, ground.figure.to_qpos(found.after.at(recorded.times)))
    rests = tuple(Rest(*stance) for stance in stood(calm, ground.points, ground.surfaces, NEAR))
    asked = problem(near, ground, rests, near.times())
    return replace(found, rests=rests, problem=asked, solution=inbetween(asked, improved=improved))


def _from(found: Cleaned) -> tuple[Frame, ...]:
    """Frames to go on from."""
    figure = found.figure
    everything = np.ones(figure.width, bool)
    return tuple(
        Frame(frame.time, figure.to_qpos(frame.state), ~everything, everything)
        for frame in found.solution.timeline.frames
    )


def _by_state(figure: Figure, known: Mask) -> Array:
    """(T, N) what is known of states, from what is of qpos: turned in the world, a link takes all above it."""
    out = known.astype(float)
    for link in figure.links[1:]:
        own, above = quaternion_columns(link), quaternion_columns(figure.links[link.parent])
        if own is not None and above is not None and figure.tables.in_world[link.joint + 1]:
            out[:, own] *= out[:, above].min(axis=1, keepdims=True)
    return out
