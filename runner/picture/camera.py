"""A camera that follows the figure smoothly: its position and direction for every video frame.

x is forward, y left, z up. The values are those of MuJoCo's free camera. It looks at a point from a distance, along the
azimuth (0 along +x, 90 along +y) and the elevation (negative is downward).
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.ndimage import gaussian_filter1d

from dynsplines.solver.array import Array

from ..scene.framing import HEIGHT


@dataclass(frozen=True)
class View:
    """One camera setting.

    Attributes:
        lookat: The point in the middle of the image, (3,) [m].
        distance: The distance from this point [m].
        azimuth: [degrees].
        elevation: [degrees].
        fixed: The name of a camera of the model, which is used instead of the other values.
    """

    lookat: tuple[float, float, float]
    distance: float
    azimuth: float
    elevation: float
    fixed: str | None = None


# azimuth and elevation [degrees]; "side" is at the figure's right, so that forward is from left to right
ANGLES: dict[str, tuple[float, float]] = {
    "side": (90.0, -8.0),
    "left": (-90.0, -8.0),
    "front": (180.0, -8.0),
    "three_quarter": (130.0, -12.0),
    "back": (0.0, -10.0),
}

SMOOTHING_SECONDS = 0.5  # [s] width of the smoothing of a camera's path


def plan(
    root_path: ArrayLike,
    fps: float,
    aspect: float,
    view: str = "side",
    *,
    fovy: float = 45.0,
    height: float = 1.8,
    cameras: Collection[str] = (),
) -> tuple[View, ...]:
    """Return one setting per video frame, which follow the root along the floor smoothly, at one distance for all.

    Args:
        root_path: The root's positions, (T, 3) [m]; or (n, T, 3) for figures that share the camera, which follows their
            mean.
        fps: Video frames per second [1/s].
        aspect: Width / height of the image.
        view: "side", "left", "front", "three_quarter", "back", or one of `cameras`.
        fovy: The camera's vertical field of view [degrees], the model's `visual/global/fovy`.
        height: The height of the figure [m].
        cameras: Names of the model's cameras.
    """
    paths = _paths(root_path)
    return _views(paths, smooth(paths.mean(axis=0)[:, :2], fps), aspect, view, fovy, height, cameras)


def still(
    root_path: ArrayLike,
    aspect: float,
    view: str = "side",
    *,
    fovy: float = 45.0,
    height: float = 1.8,
    cameras: Collection[str] = (),
) -> View:
    """Return a fixed setting that shows the figure along its whole path. The arguments are those of `plan`."""
    paths = _paths(root_path)
    middle = (paths.min(axis=(0, 1)) + paths.max(axis=(0, 1)))[None, :2] / 2
    return _views(paths, middle, aspect, view, fovy, height, cameras)[0]


def _views(
    paths: Array, places: Array, aspect: float, view: str, fovy: float, height: float, cameras: Collection[str]
) -> tuple[View, ...]:
    """Return one setting for each of the places (k, 2) [m] on the floor that are looked at, at one distance for all."""
    if view in cameras:
        return (View((0.0, 0.0, 0.0), 1.0, 0.0, 0.0, fixed=view),) * len(places)
    azimuth, elevation = ANGLES[view]
    lookat = np.column_stack([places, np.full(len(places), sum(_vertical(paths, height)) / 2)])
    distance = _distance(_corners(paths, height) - lookat[:, None], aspect, azimuth, elevation, fovy)
    return tuple(View((x, y, z), distance, azimuth, elevation) for x, y, z in lookat.tolist())


def smooth(path: Array, fps: float) -> Array:
    """Return a path (T, d) filtered by a Gaussian whose standard deviation is half of SMOOTHING_SECONDS.

    The path is continued at both ends by point reflection, so that uniform motion and both end points are unchanged.
    """
    sigma = SMOOTHING_SECONDS / 2 * fps
    reach = int(np.ceil(3 * sigma))
    if len(path) < 2 or reach < 1:
        return path.copy()
    padded = np.pad(path, ((reach, reach), (0, 0)), mode="reflect", reflect_type="odd")
    return gaussian_filter1d(padded, sigma, axis=0, radius=reach)[reach:-reach]


def axes(azimuth: float, elevation: float) -> Array:
    """Return the camera's right, up and forward directions in the world as rows (3, 3), for angles in degrees."""
    a, e = np.radians(azimuth), np.radians(elevation)
    right = np.array([np.sin(a), -np.cos(a), 0.0])
    forward = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
    return np.stack([right, np.cross(right, forward), forward])


def _paths(root_path: ArrayLike) -> Array:
    """Return the positions of one or more figures as (n, T, 3)."""
    paths = np.asarray(root_path, dtype=np.float64)
    return paths[None] if paths.ndim == 2 else paths


def _vertical(paths: Array, height: float) -> tuple[float, float]:
    """Return the lowest and highest visible z [m]: from below the feet to above the head, not far below the floor."""
    low, high = float(paths[..., 2].min()), float(paths[..., 2].max())
    floor = min(-0.05, low - 0.15 * height) if low > 0 else -np.inf
    return max(low - 0.58 * height, floor), high + 0.53 * height


def _corners(paths: Array, height: float) -> Array:
    """Return the corners (T, 8 n, 3) of a box around every figure, with an arm's reach to each side."""
    low, high = _vertical(paths, height)
    reach = 0.4 * height
    boxes = [
        np.stack([paths[..., 0] + x, paths[..., 1] + y, np.full(paths.shape[:2], z)], axis=-1)
        for x in (-reach, reach)
        for y in (-0.5 * reach, 0.5 * reach)
        for z in (low, high)
    ]
    return np.concatenate(boxes).swapaxes(0, 1)


def _distance(offsets: Array, aspect: float, azimuth: float, elevation: float, fovy: float) -> float:
    """Return the shortest distance [m] at which all offsets (..., 3) from the look-at point are within the image."""
    right, up, forward = np.moveaxis(offsets @ axes(azimuth, elevation).T, -1, 0)
    tan = np.tan(np.radians(fovy) / 2)
    needed = np.maximum(np.abs(right) / (tan * aspect), np.abs(up) / tan) * HEIGHT - forward
    return float(needed.max())
