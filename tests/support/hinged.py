"""A chain of hinges, keyframes of it, and soft constraints for it."""

from __future__ import annotations

from figures import figure_of

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.penalty import CovariantAcceleration, Penalty, RootAcceleration, UnitMagnitude

PENALTIES: list[tuple[Penalty, float]] = [
    (CovariantAcceleration(), 1.0),
    (UnitMagnitude(), 0.5),
    (RootAcceleration(), 1.0),
]


def hinged() -> Figure:
    arm = '<joint axis="0 1 0"/><geom size=".1"/>'
    return figure_of(f'<mujoco><worldbody><body>{arm}<body pos="0 0 -1">{arm}</body></body></worldbody></mujoco>')


def hinge_keys() -> list[Frame]:
    return [Frame.key(t, [a, b]) for t, a, b in [(0, 0.0, 1.0), (0.5, 1.0, -1.0), (1.4, 0.2, 0.4), (2, -1.0, 0)]]
