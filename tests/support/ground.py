"""A floor, a slope, points that touch them and stances on them."""

from __future__ import annotations

import numpy as np

from dynsplines.solver.contacts import Stance
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.surface import Plane
from dynsplines.solver.surface.points import Point

FLOOR = Plane("floor", np.zeros(3), np.array([0.0, 0, 1]))
SLOPE = Plane("slope", np.array([0.1, 0, 0.2]), np.array([0.6, 0, 0.8]))


def random_points(figure: Figure, rng: np.random.Generator) -> tuple[Point, ...]:
    """Two points on every link, so that links repeat."""
    indices = [*range(1, len(figure.links)), *range(1, len(figure.links))]
    return tuple(Point(f"p{n}", i, 0.3 * rng.normal(size=3), rng.uniform(0, 0.2)) for n, i in enumerate(indices))


def stance_of(link: int, first: float, last: float) -> Stance:
    point = Point("p", link, np.array([0.1, 0.2, -0.3]))
    return Stance(point, first, last, np.array([0.1, 0.2, 0]), np.array([0.13, 0.2, 0.01]))
