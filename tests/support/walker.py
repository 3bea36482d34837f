"""A human that walks, feet flat, at the speed of the standing foot.

Hips go back evenly and forward faster, knees bent meanwhile.
"""

import numpy as np
from figures import figure_of

from dynsplines import models
from dynsplines.clip.posing.places import sole_points
from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.surface.points import Point, places_of

SWING, BENT, ARMS = 0.4, 0.9, 0.4  # [rad] amplitudes
STANCE = 0.62  # of a period
FINE = 400  # samples a second


def walker(coordinates: str = "auto") -> tuple[Figure, tuple[Point, ...]]:
    figure = figure_of(models.figure_text("human"), coordinates)
    return figure, sole_points(figure, np.zeros((0, figure.width)))


def walk(figure: Figure, points: tuple[Point, ...], period: float, seconds: float) -> tuple[np.ndarray, np.ndarray]:
    """Times (T,) [s] and configurations (T, nq)."""
    time = np.arange(round(seconds * FINE) + 1) / FINE
    qpos = np.tile(figure.model.qpos0, (time.size, 1))
    place = {link.name: link.qpos for link in figure.links[1:]}

    def turn(name: str, angle: np.ndarray) -> None:
        about = np.outer(angle, [0.0, 1, 0])
        qpos[:, place[name] : place[name] + 4] = quat.from_rotation_vector(about)

    phase = time / period
    stands = []
    for side, shift in (("left", 0.0), ("right", 0.5)):
        part = (phase + shift) % 1
        swing = np.maximum(part - STANCE, 0) / (1 - STANCE)
        stands.append(swing == 0)
        hip = SWING * np.where(swing == 0, 2 * part / STANCE - 1, np.cos(np.pi * swing))
        knee = 0.1 + BENT * np.sin(np.pi * swing) ** 2
        for name, angle in (("hip", hip), ("knee", knee), ("ankle", -hip - knee)):
            turn(f"{side}_{name}", angle)
        turn(f"{side}_shoulder", -ARMS * np.sin(2 * np.pi * (part + 0.2)))
    state = figure.to_state(qpos)
    places = places_of(points, Samples(figure, state, 0 * state, 0 * state))[0]
    left = np.array(["left" in point.name for point in points])
    back = np.diff(places[0, left].mean(axis=0))[stands[0][1:] & stands[0][:-1]]
    qpos[:, 0] = -np.median(back) * FINE * time
    qpos[:, 2] -= places[2].min(axis=0)
    return time, qpos
