"""A motion as a bad recording has it: it slides, sinks and hovers, shakes, and misses samples."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dynsplines.motion import sampled
from dynsplines.solver import quaternion as quat
from dynsplines.solver.figure.figure import Figure
from dynsplines.solving import Solved

SLIDE, TURNS_IN = 0.05, 4.0  # [m/s] whose direction goes round once in so many seconds
SINKS, EVERY = 0.02, 1.0  # [m] down and up in turn, [s] each


@dataclass(frozen=True)
class Take:
    """A figure's motion at equal times: time (T,) [s], qpos (T, nq)."""

    figure: Figure
    time: np.ndarray
    qpos: np.ndarray

    @classmethod
    def of(cls, solved: Solved, fps: float) -> Take:
        figure = solved.clip.figure
        samples = sampled(figure, solved.motion.timeline, fps)
        return cls(figure, samples.time, samples.qpos)

    def sliding(self, rng: np.random.Generator) -> np.ndarray:
        """qpos of a root that slides, sinks and hovers."""
        out, since = self.qpos.copy(), self.time - self.time[0]
        turn = 2 * np.pi / TURNS_IN
        angle = turn * since + rng.uniform(0, 2 * np.pi)
        way = np.stack([np.sin(angle) - np.sin(angle[0]), np.cos(angle[0]) - np.cos(angle)], axis=1)
        out[:, :2] += SLIDE / turn * way
        out[:, 2] += SINKS * np.where(np.floor(since / EVERY) % 2, 1, -1)
        return out

    def shaking(self, qpos: np.ndarray, rng: np.random.Generator, metres: float, radians: float) -> np.ndarray:
        """qpos with white noise on the root's place and every rotation."""
        out = qpos.copy()
        for columns in self.figure.tables.position_columns.T:
            out[:, columns] += rng.normal(0, metres, (len(out), 3))
        for link in self.figure.links[1:]:
            if link.kind.name in ("BALL", "FREE"):
                first = link.qpos + 3 * (link.kind.name == "FREE")
                noise = quat.from_rotation_vector(rng.normal(0, radians, (len(out), 3)))
                out[:, first : first + 4] = quat.product(out[:, first : first + 4], noise)
            elif link.kind.name == "HINGE":
                out[:, link.qpos] += rng.normal(0, radians, len(out))
        return out
