"""The content of a recording that was read from a file."""

from __future__ import annotations

from dataclasses import dataclass

from dynsplines.solver.array import Array

from ..scene.assets import Scene


@dataclass(frozen=True)
class Recording:
    """The content of a file that was read, in MuJoCo's order and units.

    Attributes:
        time: Times (T,) [s], rising.
        qpos: Configurations (T, nq) of the figure.
        scene: The figure that the file contains, such as the hierarchy of a BVH file; None for the caller's figure.
        fps: The sampling rate [1/s], if the file states it more exactly than its times.
        notes: Lines for the user on how the file was read.
        assumed_layout: The root's quaternions and vertical axis, if only the format's documentation states them.
    """

    time: Array
    qpos: Array
    scene: Scene | None = None
    fps: float | None = None
    notes: tuple[str, ...] = ()
    assumed_layout: str | None = None
