"""Size and position of a figure: for the camera's distance, the haze, and the height of a floor."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.model import boxes, kinematics
from dynsplines.solver.surface.touch import moves

from .configuration import kinematics_of

STANDING = 2.05  # [m] height of a person with a hand raised over the head
PEOPLE = (1.3, 2.2)  # [m] range of heights of people
WIDTH, HEIGHT = 0.8, 1.06  # [1] visible width and height about a figure's middle, relative to the figure's


def box(model: mujoco.MjModel, data: mujoco.MjData) -> tuple[Array, Array]:
    """Return the lowest and highest corner (3,) [m] of moving parts and the fixed bodies that carry them, in `data`."""
    moving = moves(model)
    carrier = np.isin(model.geom_bodyid, _carriers(model)) & (model.geom_bodyid != 0)
    geoms = np.flatnonzero((moving | carrier) & (model.geom_type != int(mujoco.mjtGeom.mjGEOM_PLANE)))
    if not geoms.size:
        centres = data.xipos[model.body_weldid != 0] if model.njnt else data.xipos
        return centres.min(axis=0), centres.max(axis=0)
    centre, reach = boxes(model, data, geoms)
    return (centre - reach).min(axis=0), (centre + reach).max(axis=0)


def _carriers(model: mujoco.MjModel) -> Array:
    """Return the bodies between the world and moving ones."""
    carriers = set()
    for body in np.flatnonzero(model.body_jntnum > 0):
        parent = int(model.body_parentid[body])
        while parent:
            carriers.add(parent)
            parent = int(model.body_parentid[parent])
    return np.array(sorted(carriers), int)


def rest_box(model: mujoco.MjModel) -> tuple[Array, Array]:
    """Return the same for the rest pose."""
    return box(model, kinematics(model))


def is_of_people_size(model: mujoco.MjModel) -> bool:
    """Return whether a figure is upright and as tall as a person."""
    low, high = rest_box(model)
    size = high - low
    return bool(PEOPLE[0] <= size[2] <= PEOPLE[1] and size[2] >= size[:2].max())


def size_of(model: mujoco.MjModel) -> float:
    """Return the camera's `height` for the figure at rest [m]."""
    low, high = rest_box(model)
    return STANDING if is_of_people_size(model) else _camera_height((high - low) / 2)


def _camera_height(reach: Array) -> float:
    """Return the camera's `height` [m] that shows the extent (3,) [m] to either side of its target."""
    return float(max(*(2 * reach[:2] / WIDTH), 2 * reach[2] / HEIGHT, 1e-3))


def middles(figure: Figure, qpos: Array) -> Array:
    """Return the positions of a figure along qpos (T, nq), (T, 3) [m]: its root, or the middle of its moving parts."""
    if figure.root is not None:
        return qpos[:, figure.tables.position_columns[:, 0]]
    low, high = _boxes(figure, qpos)
    return np.tile((low.min(axis=0) + high.max(axis=0)) / 2, (len(qpos), 1))


def height(figure: Figure, qpos: Array) -> float:
    """Return the `height` [m] of a camera that follows `middles` and shows the whole figure along qpos (T, nq)."""
    if figure.root is not None and is_of_people_size(figure.model):
        return STANDING
    low, high = _boxes(figure, qpos)
    middle = middles(figure, qpos)[spread(len(qpos))]
    return _camera_height(np.maximum(high - middle, middle - low).max(axis=0))


def spread(count: int, most: int = 60) -> Index:
    """Return evenly spaced indices of at most `most` of `count` items, with the first and the last. By default, these
    poses represent a motion."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))


def _boxes(figure: Figure, qpos: Array) -> tuple[Array, Array]:
    """Return the figure's boxes in these poses: lowest and highest corners, (n, 3) each."""
    poses = qpos[spread(len(qpos))]
    low, high = zip(*(box(figure.model, data) for data in kinematics_of(figure.model, poses)), strict=True)
    return np.array(low), np.array(high)
