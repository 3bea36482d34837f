"""Forces of a motion: the wrench at the root, the ground reaction on each foot, and the joint torques.

Torques and wrench are MuJoCo's `mj_inverse` of qpos, qvel and qacc without contacts. They include the model's springs,
dampers, friction loss, gravity compensation, fluid, tendons and constraints. The ground reactions are those of
`support`: forces within friction cones at the points in contact that supply as much of the root's wrench as possible.
Where neither a stance nor a flight determines them, they and the torques that depend on them are nan.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import applied, cross
from dynsplines.solver.figure.dynamics import inverse_dynamics
from dynsplines.solver.figure.forward import set_qpos
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.root_wrench import RootWrench
from dynsplines.solver.penalty import Support
from dynsplines.solver.penalty.ground.support import Reactions

from ..clip import load as clip
from ..motion import samples_at
from .trajectory import SampledTrajectory


@dataclass(frozen=True)
class Foot:
    """The ground reaction on a body, in world axes.

    force   (3, T) [N], zero without contact
    centre  (3, T) [m] of pressure: mean of the points in contact, weighted by normal force; nan without contact
    moment  (3, T) [N m] about the centre, about the normal alone on level ground; nan without contact
    """

    name: str
    force: Array
    centre: Array
    moment: Array


@dataclass(frozen=True)
class Forces:
    """The forces of a trajectory.

    samples  the motion; support  None for a figure without a free root
    model    the trajectory's model, or one with the same joints whose forces are evaluated
    """

    trajectory: SampledTrajectory
    samples: Samples
    support: Support | None
    model: mujoco.MjModel

    @classmethod
    def of(cls, trajectory: SampledTrajectory, model: mujoco.MjModel | None = None) -> Forces:
        """Return the forces of a motion in its model, or in another one with the same joints."""
        saved = trajectory.saved
        support = clip.clip_from_motion(saved).context.support
        samples = samples_at(saved.figure, path_of(saved.timeline), trajectory.time)
        return cls(
            trajectory,
            samples,
            None if support is None else support.stiff,
            trajectory.model if model is None else model,
        )

    @cached_property
    def has_known_support(self) -> Mask:
        """(T,) whether the forces that carry the figure are known; always, for a figure without stances and flights."""
        if self.support is None or not self.support.has_intervals:
            return np.ones(self.samples.count, bool)
        return self.support.known(self.samples.t)

    @cached_property
    def inverse(self) -> Array:
        """(T, nv) MuJoCo's qfrc_inverse without contacts: the joint forces as if the ground exerted none."""
        return inverse_dynamics(self.model, self.trajectory.qpos, self.trajectory.qvel, self.trajectory.qacc)

    @cached_property
    def wrench(self) -> RootWrench | None:
        """Force and moment at the free root, and the centre of mass; all forces of the model are included."""
        if self.support is None:
            return None
        out, root = RootWrench(self.samples, self.support.root), self.support.root
        dof = self.trajectory.figure.links[root].dof
        links = self.samples.links
        out.force = np.ascontiguousarray(self.inverse[:, dof : dof + 3].T)
        moment = applied(links.rotation[:, :, [root]], self.inverse[:, dof + 3 : dof + 6].T[:, None])[:, 0]
        out.moment = moment - cross(out.centre - links.anchor[:, root], out.force)
        return out

    @cached_property
    def _reactions(self) -> Reactions | None:
        return None if self.support is None else self.support.reactions(self.samples, self.wrench)

    @cached_property
    def rest(self) -> Array:
        """(6, T) [N, N m] force and moment at the root that the ground does not supply; nan where unknown."""
        support = self.support
        if support is None:
            return np.zeros((6, self.samples.count))
        units = np.repeat([support.unit, support.unit * support.length], 3)[:, None]
        return np.where(self.has_known_support, support.rest(self.samples, self.wrench) * units, np.nan)

    @cached_property
    def feet(self) -> tuple[Foot, ...]:
        """The ground reactions of all bodies with a stance."""
        if self.support is None or self._reactions is None:
            return ()
        links = self._links
        return tuple(self._foot(int(link)) for link in np.unique(links))

    @property
    def _links(self) -> Index:
        assert self.support is not None
        return np.array([footing.point.link for footing in self.support.footings], np.intp)

    def _foot(self, link: int) -> Foot:
        assert self.support is not None and self._reactions is not None
        reactions, count, figure = self._reactions, self.samples.count, self.trajectory.figure
        indices = np.flatnonzero(self._links[reactions.footing] == link)
        at, place, force = reactions.at[indices], reactions.place[:, indices], reactions.force[:, indices]
        normals = np.array([self.support.footings[i].normal for i in reactions.footing[indices]]).reshape(-1, 3).T
        press = np.maximum(np.sum(normals * force, axis=0), 0)
        total = np.bincount(at, press, count)
        whole = np.array([np.bincount(at, part, count) for part in force])
        with np.errstate(invalid="ignore", divide="ignore"):
            centre = np.array([np.bincount(at, press * part, count) for part in place]) / total
        away = place - centre[:, at]
        moment = np.array([np.bincount(at, part, count) for part in cross(away, force)])
        loaded = total > 0
        name = figure.body_name(link)
        return Foot(
            name,
            np.where(self.has_known_support, whole, np.nan),
            np.where(self.has_known_support & loaded, centre, np.nan),
            np.where(self.has_known_support & loaded, moment, np.nan),
        )

    @cached_property
    def torques(self) -> Array:
        """(T, nv) MuJoCo's qfrc_inverse minus the ground reactions; at a free root, the remaining wrench."""
        out = self.inverse.copy()
        reactions, model = self._reactions, self.trajectory.model
        if self.support is None or reactions is None:
            return out
        data, jacobian = mujoco.MjData(model), np.zeros((3, model.nv))
        bodies = [self.trajectory.figure.links[link].body for link in self._links]
        order = np.argsort(reactions.at, kind="stable")
        posed = -1
        for i in order:
            t = int(reactions.at[i])
            if t != posed:
                set_qpos(model, data, self.trajectory.qpos[t])
                posed = t
            mujoco.mj_jac(model, data, jacobian, None, reactions.place[:, i], bodies[reactions.footing[i]])
            out[t] -= reactions.force[:, i] @ jacobian
        return np.where(self.has_known_support[:, None], out, np.nan)
