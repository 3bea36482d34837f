"""Goals of inverse kinematics, and the joints that they depend on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import mujoco
import numpy as np

from .. import quaternion as quat
from ..array import Array, Mask
from ..figure.figure import Figure
from ..figure.model import kinematics
from ..surface.points import Point
from ..tolerances import TINY
from .least_squares import Part


class Goal(Protocol):
    """A target for a pose."""

    @property
    def name(self) -> str:
        """The site's or body's name in the model."""
        ...

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        """Return MuJoCo's ids of the bodies whose positions or rotations the goal depends on, the main one first."""
        ...

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        """Return the residual, current minus requested value, (k,) [m or rad]."""
        ...

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        """Return the residual and its Jacobian with respect to the degrees of freedom, (k, nv)."""
        ...


@dataclass(frozen=True, eq=False)
class PointGoal:
    """Target positions for n points of a body, in the world or on another body.

    Attributes:
        index: MuJoCo's id of the body.
        offsets: The points in the frame of the body, (n, 3) [m].
        spots: The targets in the frame of the reference body, (n, 3) [m]; NaN along unconstrained axes of the world.
        reference: MuJoCo's id of the body with the targets; 0: the world.
    """

    name: str
    index: int
    offsets: Array
    spots: Array
    reference: int = 0

    @classmethod
    def of(cls, figure: Figure, point: Point, spot: Array | None = None, link: int = 0) -> PointGoal:
        """Return the goal that a point of the figure is at a position (3,) [m] in the frame of a link.

        Link 0 is the world. Without a position it is the origin.
        """
        body, offset = _on_body(figure, point.link, point.position)
        reference, spot = 0, np.zeros(3) if spot is None else np.array(spot, float)
        if link:
            reference, spot = _on_body(figure, link, spot)
        return cls(point.name, body, offset[None], spot[None], reference)

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return [self.index, self.reference] if self.reference else [self.index]

    def places(self, data: mujoco.MjData) -> Array:
        """Return the current positions of the points in the world, (n, 3) [m]."""
        return data.xpos[self.index] + self.offsets @ data.xmat[self.index].reshape(3, 3).T

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return (self.places(data) - self._targets(data))[self._is_constrained]

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        places, targets = self.places(data), self._targets(data)
        rows = _jacobians(model, data, self.index, places)
        if self.reference:
            rows -= _jacobians(model, data, self.reference, targets)
        return (places - targets)[self._is_constrained], rows[self._is_constrained]

    def _targets(self, data: mujoco.MjData) -> Array:
        if not self.reference:
            return self.spots
        return data.xpos[self.reference] + self.spots @ data.xmat[self.reference].reshape(3, 3).T

    @cached_property
    def _is_constrained(self) -> Mask:
        return ~np.isnan(self.spots)


def _on_body(figure: Figure, link: int, position: Array) -> tuple[int, Array]:
    """Return the body of a link, and a position (3,) [m] in the frame of the link in that of the body."""
    body = figure.links[link].body
    return body, quat.rotate(quat.inverse(figure.body_turn[body]), position - figure.body_offset[body])


def _jacobians(model: mujoco.MjModel, data: mujoco.MjData, body: int, places: Array) -> Array:
    """Return the Jacobians (n, 3, nv) of points of a body at places (n, 3) [m] in the world."""
    rows = np.zeros((len(places), 3, model.nv))
    for row, place in zip(rows, places, strict=True):
        mujoco.mj_jac(model, data, row, None, place, body)
    return rows


@dataclass(frozen=True, eq=False)
class BodyGoal:
    """A target rotation for a body.

    Attributes:
        rotation: The target in the world, a wxyz quaternion (4,); None: upright as in the rest pose, with any heading.
        index: MuJoCo's id of the body; None: the body is identified by its name.
    """

    name: str
    rotation: Array | None = None
    index: int | None = None

    def bodies(self, model: mujoco.MjModel) -> Sequence[int]:
        return [self._body(model)]

    def _body(self, model: mujoco.MjModel) -> int:
        return int(model.body(self.name).id) if self.index is None else self.index

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        here = data.xquat[self._body(model)]
        if self.rotation is not None:
            return quat.rotation_vector(quat.product(here, quat.inverse(self.rotation)))
        up = quat.rotate(quat.product(here, quat.inverse(rest_rotation(model, self._body(model)))), [0.0, 0, 1])
        tilt = np.cross([0.0, 0, 1], up)
        length = float(np.linalg.norm(tilt))
        if length < TINY:
            return np.array([0.0 if up[2] > 0 else np.pi, 0.0])
        return tilt[:2] * np.arctan2(length, up[2]) / length

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> Part:
        missed, rows = self.residual(model, data), np.zeros((3, model.nv))
        mujoco.mj_jacBody(model, data, None, rows, self._body(model))
        return missed, rows[: missed.size]


def same_heading(figure: Figure, qpos: Array, body: int) -> BodyGoal:
    """Return the goal that a body is upright as in the rest pose, with the heading that it has in a pose (nq,)."""
    model, data = figure.model, kinematics(figure.model, qpos)
    at_rest = rest_rotation(model, body)
    turn = quat.product(data.xquat[body], quat.inverse(at_rest)) * [1.0, 0, 0, 1]
    heading = turn / np.linalg.norm(turn) if np.linalg.norm(turn) > TINY else np.array([1.0, 0, 0, 0])
    return BodyGoal(str(model.body(body).name), quat.product(heading, at_rest), body)


def moved_by(figure: Figure, goal: Goal) -> set[int]:
    """Return the links whose joints a goal depends on."""
    return {link for body in goal.bodies(figure.model) for link in figure.chain(body)}


def entries_of(figure: Figure, goals: Sequence[Goal]) -> Mask:
    """Return the mask of the entries of qpos that goals depend on, (nq,): the joints from the root to their bodies."""
    mask = np.zeros(figure.width, bool)
    for link in {link for goal in goals for link in moved_by(figure, goal)}:
        mask[figure.links[link].columns] = True
    return mask


def rest_rotation(model: mujoco.MjModel, body: int) -> Array:
    """Return the orientation of a body in the world in the rest pose, a wxyz quaternion (4,)."""
    turn = np.array([1.0, 0, 0, 0])
    while body:
        turn = quat.product(model.body_quat[body], turn)
        body = int(model.body_parentid[body])
    return quat.normalise(turn)
