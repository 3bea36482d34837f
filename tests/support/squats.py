"""What is measured of squats, at 1 kHz: depth of the soles, how far they move, knees, ranges, angular acceleration."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from quiet import quiet

from dynsplines import recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.motion import samples_at
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import dot
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import BendLimits, JointRange, joint_ranges
from dynsplines.solver.surface.points import places_of

RATE = 1000.0  # [Hz]


@dataclass(frozen=True)
class Measured:
    """The worst of a motion.

    deep, moved  [m] of the sole points: below the ground, and away from where they begin
    beyond       [degrees] beyond its range, by joint, of those that are
    flexion      [degrees] least of the knees and elbows on ball joints; crooked: most sideways and twisted
    acceleration [rad/s²] of a link relative to its parent
    """

    deep: float
    moved: float
    beyond: dict[str, float]
    flexion: float
    crooked: float
    acceleration: float


def solved(problem: Clip, **settings: Any) -> solving.Solved:
    problem = problem.with_problem(settings=replace(problem.settings, **settings))
    return solving.solve(problem, quiet())


def squat(height: float, *, contacts: bool, figure: str = "human") -> Clip:
    """The simplest squat: at rest, the root at a height, at rest again."""
    text = f"""figure = "{figure}"
        [[keyframe]]
        time = 0
        others = "rest"
        [[keyframe]]
        time = 1
        root.position = [0, 0, {height}]
        [[keyframe]]
        time = 2
        others = "rest"
        """
    for point in ("left_heel", "right_heel", "left_toe", "right_toe") if contacts else ():
        text += f'[[contact]]\npoint = "{point}"\nfrom = 0\nto = 2\n'
    return recordings.from_text(text, name="squat")


def measured(problem: Clip, timeline: Timeline) -> Measured:
    path, figure = path_of(timeline), problem.figure
    first, last = path.span
    samples = samples_at(figure, path, np.linspace(first, last, round((last - first) * RATE) + 1))
    centres, _ = places_of(problem.context.points, samples)
    inside = np.max([surface.inside(centres) for surface in problem.context.surfaces], axis=0)
    away = np.sqrt(dot(centres - centres[:, :, :1], centres - centres[:, :, :1]))
    ranges = JointRange(joint_ranges(figure))
    beyond = np.degrees(ranges.beyond(samples).max(axis=1)) if ranges.joints else np.zeros(0)
    bends = next((penalty for penalty, _ in problem.penalties if isinstance(penalty, BendLimits)), None)
    angles = np.zeros((3, 1, 1)) if bends is None else np.degrees(bends.angles(samples))
    return Measured(
        float(inside.max()),
        float(away.max()),
        {joint.name: float(over) for joint, over in zip(ranges.joints, beyond, strict=True) if over > 0},
        float(angles[0].min()),
        float(np.abs(angles[1:]).max()),
        _acceleration(samples),
    )


def _acceleration(samples: Samples) -> float:
    links, figure = samples.links, samples.figure
    relative = np.linalg.norm(links.alpha - links.alpha[:, figure.tables.parents], axis=0)
    turning = [i for i, link in enumerate(figure.links) if i and link.kind in (JointKind.BALL, JointKind.HINGE)]
    return float(relative[turning].max())
