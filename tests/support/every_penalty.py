"""Every soft constraint at once, and a random clip to see them on."""

from __future__ import annotations

import numpy as np
from random_keys import TIMES, mask_without, random_keys

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import (
    Bend,
    BendLimits,
    Contact,
    CovariantAcceleration,
    Penalty,
    RootAcceleration,
    Torque,
    UnitMagnitude,
)
from dynsplines.solver.surface import Box, Plane
from dynsplines.solver.surface.points import Point

SURFACES = (
    Plane("floor", np.zeros(3), np.array([0.0, 0, 1])),
    Box("step", np.array([0.3, 0.2, 0.1]), np.eye(3), np.array([0.9, 0.8, 0.5])),
)


def every_penalty(figure: Figure) -> list[tuple[Penalty, float]]:
    balls = [i for i, link in enumerate(figure.links) if i and link.kind is link.kind.BALL]
    joints = tuple(Bend(f"{i}", i, np.array([0.0, 1, 0]), np.array([0.0, 0, -1])) for i in balls)
    points = tuple(Point(f"{i}", i, np.array([0.05, 0.1, -0.2]), 0.1) for i in range(1, len(figure.links)))
    return [
        (CovariantAcceleration(), 2.0),
        (CovariantAcceleration(), 0.5),
        (UnitMagnitude(), 5.0),
        (UnitMagnitude(most=0.1), 1.0),
        (RootAcceleration(), 1.5),
        (Torque(), 0.3),
        (BendLimits(joints), 2.5),
        (Contact(points, SURFACES), 4.0),
    ]


def clip(figure: Figure, rng: np.random.Generator, ends: str = "free") -> Timeline:
    joint = figure.links[2].name
    keys = random_keys(figure, rng, {1: mask_without(figure, joint, "root x"), 2: mask_without(figure, "root turn")})
    if ends == "periodic":
        keys[-1] = Frame.key(TIMES[-1], keys[0].state)
    slope = rng.normal(size=(2, figure.width)) if ends.startswith("clamped") else None
    return raw_timeline(figure, keys, ends, slope)
