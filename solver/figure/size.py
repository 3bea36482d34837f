"""The size of a figure: its lengths relative to an adult, and its times by dynamic similarity.

Bodies of one shape that move under gravity are dynamically similar if lengths grow by λ and times by √(λ/g)
(R. McN. Alexander 1976). A threshold that holds for an adult then holds for a doll, a robot or a giant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .dynamics import STANDARD_GRAVITY, height
from .figure import Figure

ADULT = 1.41223671  # [m] `height` of the shipped human, 1.7 m tall
DIGITS = 6  # of the ratio of lengths: the shipped human has the size of an adult exactly


@dataclass(frozen=True)
class Size:
    """The ratios of a figure's lengths and times to those of an adult on earth."""

    length: float = 1.0
    time: float = 1.0

    @property
    def enlargement(self) -> float:
        """How many times the figure is larger than an adult; 1 for smaller ones."""
        return max(1.0, self.length)

    @classmethod
    def of(cls, figure: Figure) -> Size:
        """Return the size of a figure's tree.

        Rigid objects, machines with a fixed base and trees without mass have the size of an adult, because they have no
        legs whose length could be measured.
        """
        root, gravity = figure.root, float(np.linalg.norm(figure.gravity)) or STANDARD_GRAVITY
        tall = height(figure, root.link) if root is not None and root.limbs else 0.0
        length = round(tall / ADULT, DIGITS) or 1.0
        return cls(length, float(np.sqrt(length * STANDARD_GRAVITY / gravity)))
