"""The content of a recording that was read from a file."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dynsplines.solver.array import Array

from ..scene.assets import Scene


@dataclass(frozen=True)
class Recording:
    """The content of a file that was read, in MuJoCo's order and units.

    Attributes:
        time: Times (T,) [s], rising.
        qpos: Configurations (T, nq) of the figure.
        scene: The figure that the file contains, such as the hierarchy of a BVH file; None for the caller's figure.
        fps: The sampling rate [1/s]; None: that of the times.
        notes: Lines for the user on how the file was read.
        assumed_layout: The root's quaternions and vertical axis, if only the format's documentation states them.
        name: The name of the recording.
    """

    time: Array
    qpos: Array
    scene: Scene | None = None
    fps: float | None = None
    notes: tuple[str, ...] = ()
    assumed_layout: str | None = None
    name: str = ""

    @property
    def rate(self) -> float:
        """The sampling rate [1/s]: that of the file, or that of the times, which are rounded; 30 for a single time."""
        step = median_step(self.time)
        return self.fps or (float(np.round(1 / step, 6)) if step else 30.0)


def median_step(time: Array) -> float:
    """Return the median distance of successive samples at different times (T,), [s]; 0 if all times are equal."""
    steps = np.diff(time)
    return float(np.median(steps[steps > 0])) if (steps > 0).any() else 0.0
