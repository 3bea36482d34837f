"""Stances with an initial guess in which the legs step.

The raw spline between two keyframes in which both feet stand slides them over the ground, with straight legs. The
initial guess has poses in the middle of steps and between them, see `Footsteps.poses`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import ContactSchedule, Stance
from dynsplines.solver.contacts.footsteps import Swing
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import applied
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrenches import of_point
from dynsplines.solver.penalty import Attachment, BendLimits, Block, Guide
from dynsplines.solver.surface.points import free_root, places_of

from .standing_feet import Standing, upright


@dataclass(frozen=True)
class SteppingStances(Attachment, Guide):
    """The stances of a clip with footsteps, and the squared depths [m²] of points below `Swing.lowest` in steps.

    Without these depths, the search would press feet to the ground that the initial guess raises, as low feet need less
    acceleration, and slipping costs nothing at the height of the guess.

    Attributes:
        swings: The movements of sole points in steps.
        poses: Variable frames in the poses of the steps.
        spans: The times [s] of the keyframes before and after steps.
    """

    is_binding = True  # the raw spline may cost less, as if hands have targets, but its feet slide instead of stepping
    swings: tuple[Swing, ...] = ()
    poses: tuple[Frame, ...] = ()
    spans: tuple[tuple[float, float], ...] = ()

    @classmethod
    def of(cls, schedule: ContactSchedule, bends: BendLimits, stances: tuple[Stance, ...]) -> SteppingStances:
        """Return the stances of a clip with footsteps; legs bend within their limits."""
        path, times, poses = path_of(schedule.keys), schedule.keys.times, list[Frame]()
        for steps in schedule.footsteps:
            states = path.at(np.array([time for time, _ in steps.poses]))
            for state, (time, places) in zip(states, steps.poses, strict=True):
                poses.append(Frame.variable(time, _stepped(schedule, bends, state, places)))
        segments = [steps.segment for steps in schedule.footsteps]
        swings = tuple(swing for steps in schedule.footsteps for swing in steps.swings if swing.height)
        spans = tuple((float(times[k]), float(times[k + 1])) for k in segments)
        return cls(stances, swings=swings, poses=tuple(poses), spans=spans)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        yield from super().residuals(samples)
        for swing in self.swings:
            at = np.flatnonzero((samples.t > swing.first) & (samples.t < swing.last))
            link = np.full(at.size, swing.point.link)
            origin, rotation = samples.links.poses(link * samples.count + at)
            offset = applied(rotation, np.tile(swing.point.position[:, None], at.size))
            depth = swing.lowest(samples.t[at]) - (origin + offset)[2]
            down = np.tile([[0.0], [0.0], [-1.0]], at.size)
            yield Block(at, depth, (of_point(at, link, offset, down),), one_sided=True)

    def initial_guess(self, timeline: Timeline, most: int | None) -> Timeline:
        """Return the timeline with the poses of steps instead of its variable frames there, if `most` permits it."""
        frames = [
            frame
            for frame in timeline.frames
            if not frame.is_variable or not any(first < frame.time < last for first, last in self.spans)
        ]
        frames = sorted((*frames, *self.poses), key=lambda frame: frame.time)
        guess = Timeline(tuple(frames), timeline.end_slope, timeline.ends)
        return timeline if most is not None and guess.variable_count > most else guess


def _stepped(schedule: ContactSchedule, bends: BendLimits, state: Array, places: Array) -> Array:
    """Return a state (N,) with the sole points at `places` (3, n) [m], as far as the legs reach.

    The trunk keeps its orientation. A free root that carries the feet moves with them.
    """
    figure, points = schedule.figure, schedule.stepping_points
    root = free_root(figure, points)
    samples, qpos = Samples.still(figure, state[None]), figure.to_qpos(state)
    if root is not None:
        moves = places - places_of(points, samples)[0][..., 0]
        qpos[figure.links[root].qpos + np.arange(2)] += moves.mean(axis=1)[:2]
    goals = []
    for link in sorted({point.link for point in points}):
        foot = [i for i, point in enumerate(points) if point.link == link]
        turn = quat.from_matrix(samples.links.rotation[:, :, link, 0])
        goals += Standing(tuple(points[i] for i in foot), places[:, foot].T, turn).goals(figure)
    pose = upright(figure, qpos, np.ones(figure.width, bool), goals, bends)
    return figure.to_state_near(pose.qpos, state)
