"""Forces of a motion: joint torques, ground reactions of the feet, and what nothing supplies.

Torques and wrench are MuJoCo's `mj_inverse` of qpos, qvel and qacc without contacts. They include the model's springs,
dampers, friction loss, gravity compensation, fluid, tendons and constraints. The ground reactions are those of the soft
constraint `support`: forces within friction cones at the points in contact that supply as much of the root's wrench as
possible. Feet also push outside their stances while they touch the ground and are slow, as in steps of a gait cycle.
Where neither contacts nor a flight determine them, as on a chair, they and the torques that depend on them are nan.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import mujoco
import numpy as np

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.contacts import Contact, within
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.figure.algebra import cross, rotate
from dynsplines.solver.figure.dynamics import RootWrench, inverse_dynamics
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.model import set_qpos
from dynsplines.solver.penalty import Support
from dynsplines.solver.penalty.ground.support import Reactions
from dynsplines.solver.surface import static_surfaces
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import Point, body_points, hanging, places_of, split_at_feet

from ..clip import load as clip
from ..clip.context import Context
from ..motion import Sampled, samples_at
from .ground import touching
from .measurement import sparse_times

PASSIVE = 1e4  # [1] weight of joints without a motor, whose torques the constraints have to supply


@dataclass(frozen=True)
class Foot:
    """The ground reaction on a body, in world axes. Where the support is unknown, its arrays are nan.

    Attributes:
        name: The name of the body.
        has_contact: Whether the body touches the ground, with or without load, and the support is known, (T,).
        force: The force (T, 3) [N]; zero without contact.
        centre: The centre of pressure (T, 3) [m]: mean of the points in contact, weighted by normal force; nan without
            load.
        moment: The moment (T, 3) [N m] about the centre, about the normal alone on level ground; nan without load.
    """

    name: str
    has_contact: Mask
    force: Array
    centre: Array
    moment: Array


@dataclass(frozen=True)
class Forces:
    """The forces of a motion at its samples, by MuJoCo's inverse dynamics, with estimated ground reactions.

    Attributes:
        sampled: The samples of the motion.
        samples: The same times of its spline.
        support: The contacts that may exert forces on the figure; None without a free root.
        model: The motion's model, or one with the same joints whose forces are evaluated.
        touches_elsewhere: When parts of the body without contacts touch the surroundings, (T,) each, by body.
    """

    sampled: Sampled
    samples: Samples
    support: Support | None
    model: mujoco.MjModel
    touches_elsewhere: dict[str, Mask]

    @classmethod
    def of(cls, sampled: Sampled, model: mujoco.MjModel | None = None) -> Forces:
        """Return the forces of a motion in its model, or in another one with the same joints."""
        context, path, figure = clip.clip_from_motion(sampled.motion).context, sampled.motion.path, sampled.figure
        support, samples = context.support, samples_at(figure, path, sampled.time)
        if support is not None and not context.is_tracking:
            support = replace(support, footings=tuple(_carriers(context, support, path)))
        stiff, elsewhere = None if support is None else support.stiff, dict[str, Mask]()
        if support is not None:
            _, others = split_at_feet(context.points, body_points(figure))
            points, near, _, _ = _touches(context, support, samples, others)
            near &= ~_during(context.schedule.on_ground, points, samples.t)
            for i in np.flatnonzero(near.any(axis=1)).tolist():
                body = figure.body_name(points[i].link)
                elsewhere[body] = near[i] | elsewhere.get(body, False)
        return cls(sampled, samples, stiff, sampled.model if model is None else model, elsewhere)

    @cached_property
    def has_known_support(self) -> Mask:
        """(T,) whether the forces that carry the figure are known: while feet stand and no other part of the body
        touches the surroundings, in flights, and where there is no ground or no gravity."""
        if self.support is not None and self.support.has_intervals:
            elsewhere = np.any([np.zeros(self.samples.count, bool), *self.touches_elsewhere.values()], axis=0)
            return np.asarray(self.support.is_known(self.samples.t) & ~elsewhere)
        is_carried = self.support is not None and self.sampled.figure.gravity.any() and static_surfaces(self.model)
        return np.full(self.samples.count, not is_carried)

    @cached_property
    def inverse(self) -> Array:
        """(T, nv) MuJoCo's qfrc_inverse without contacts: the joint forces as if the ground exerted none."""
        return inverse_dynamics(self.model, self.sampled.qpos, self.sampled.qvel, self.sampled.qacc)

    @cached_property
    def wrench(self) -> RootWrench | None:
        """Force and moment at the free root, and the centre of mass; all forces of the model are included."""
        if self.support is None:
            return None
        out, root = RootWrench(self.samples, self.support.root), self.support.root
        dof = self.sampled.figure.links[root].dof
        links = self.samples.links
        out.force = np.ascontiguousarray(self.inverse[:, dof : dof + 3].T)
        moment = rotate(links.rotation[:, :, [root]], self.inverse[:, dof + 3 : dof + 6].T[:, None])[:, 0]
        out.moment = moment - cross(out.centre - links.anchor[:, root], out.force)
        return out

    @cached_property
    def _reactions(self) -> Reactions | None:
        return None if self.support is None else self.support.reactions(self.samples, self.wrench)

    @cached_property
    def rest(self) -> Array:
        """(T, 6) [N, N m] force and moment at the root that the ground does not supply; nan where unknown."""
        support = self.support
        if support is None:
            return np.zeros((self.samples.count, 6))
        units = np.repeat([support.unit, support.unit * support.length], 3)
        rest = support.rest(self.samples, self.wrench).T * units
        return np.where(self.has_known_support[:, None], rest, np.nan)

    @cached_property
    def feet(self) -> tuple[Foot, ...]:
        """The ground reactions of all feet that stand."""
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
        reactions, count, figure = self._reactions, self.samples.count, self.sampled.figure
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
        spans = [(footing.first, footing.last) for footing in self.support.footings if footing.point.link == link]
        is_known, is_placed = self.has_known_support[:, None], (self.has_known_support & loaded)[:, None]
        return Foot(
            figure.body_name(link),
            self.has_known_support & within(spans, self.samples.t),
            np.where(is_known, whole.T, np.nan),
            np.where(is_placed, centre.T, np.nan),
            np.where(is_placed, moment.T, np.nan),
        )

    @cached_property
    def torques(self) -> Array:
        """(T, nv) [N m, N] the joint torques and forces, in the order of qvel: MuJoCo's qfrc_inverse minus the ground
        reactions, from the motors; at a free root, the wrench that nothing supplies. nan where unknown."""
        return motor_torques(self.sampled.model, self.sampled.qpos, self._joint_torques)

    @property
    def _joint_torques(self) -> Array:
        """(T, nv) the same, as if every joint had a motor."""
        out = self.inverse.copy()
        reactions, model = self._reactions, self.sampled.model
        if self.support is None or reactions is None:
            return out
        data, jacobian = mujoco.MjData(model), np.zeros((3, model.nv))
        bodies = [self.sampled.figure.links[link].body for link in self._links]
        order = np.argsort(reactions.at, kind="stable")
        posed = -1
        for i in order:
            t = int(reactions.at[i])
            if t != posed:
                set_qpos(model, data, self.sampled.qpos[t])
                posed = t
            mujoco.mj_jac(model, data, jacobian, None, reactions.place[:, i], bodies[reactions.footing[i]])
            out[t] -= reactions.force[:, i] @ jacobian
        return np.where(self.has_known_support[:, None], out, np.nan)


def _carriers(context: Context, support: Support, path: Path) -> list[Contact]:
    """Return the contacts that carry the figure: the stances of feet, and, while they touch a surface along the path,
    slow feet outside their stances and other parts of the body in specified contacts."""
    figure, t = context.figure, sparse_times(path)
    samples, (feet, others) = samples_at(figure, path, t), split_at_feet(context.points, body_points(figure))
    links = {point.link for point in feet}
    stances = [footing for footing in support.footings if footing.point.link in links]
    support = replace(support, footings=tuple(stances))
    points, touches, centres, up = _touches(context, support, samples, feet)
    speeds = np.linalg.norm(np.gradient(centres, t, axis=2), axis=0)
    touches &= (speeds < Thresholds.of(figure).fast) & ~within(support.flights, t)
    stands = _during(stances, points, t)
    lands, lifts = touches[:, :-1] & stands[:, 1:], touches[:, 1:] & stands[:, :-1]
    touches[:, 1:] |= lands  # without a gap between a landing and its stance
    touches[:, :-1] |= lifts
    landings = touching(samples, points, touches, up)
    points, touches, _, up = _touches(context, support, samples, others)
    touches &= _during(context.schedule.on_ground, points, t)
    return [*stances, *landings, *touching(samples, points, touches, up)]


def _during(contacts: Sequence[Contact], points: Sequence[Point], t: Array) -> Mask:
    """Return at which times (T,) [s] the links of points (n,) have one of the contacts, (n, T)."""
    during = [within([(c.first, c.last) for c in contacts if c.point.link == point.link], t) for point in points]
    return np.array(during, bool).reshape(len(points), t.size)


def _touches(
    context: Context, support: Support, samples: Samples, points: Sequence[Point]
) -> tuple[Sequence[Point], Mask, Array, Array]:
    """Return which points touch the surroundings outside the contacts of their links.

    Returns:
        The points of the tree of the support's root; whether they touch, (n, S); their centres, (3, n, S) [m]; and the
        gradients of their heights, (3, n, S).
    """
    points = hanging(context.figure, support.root, points)
    centres, radii = places_of(points, samples)
    height, up = height_over(context.surfaces, centres, radii)
    near = height < Thresholds.of(context.figure).near_surface
    return points, near & ~_during(support.footings, points, samples.t), centres, up


def motor_torques(model: mujoco.MjModel, qpos: Array, torques: Array) -> Array:
    """Return the torques (T, nv) of joints with motors, which also move those without one through equality constraints.

    Args:
        qpos: The poses, (T, nq).
        torques: The torques t that the motion needs at every joint, (T, nv). They are B u + Jᵀ λ with the motors'
            torques u and the forces λ of the constraints. Of several λ, the one with the smallest motor torques is
            returned. If no constraint moves a joint, or an actuator is not on a joint, they are returned unchanged.
    """
    is_on_joint = model.actuator_trntype == int(mujoco.mjtTrn.mjTRN_JOINT)
    if not model.neq or not model.nu or not is_on_joint.all():
        return torques
    driven = np.isin(model.dof_jntid, model.actuator_trnid[:, 0])
    is_free = model.jnt_type[model.dof_jntid] == int(mujoco.mjtJoint.mjJNT_FREE)
    data, out = mujoco.MjData(model), torques.copy()
    for t in np.flatnonzero(np.isfinite(torques).all(axis=1)):
        set_qpos(model, data, qpos[t])
        mujoco.mj_tendon(model, data)
        mujoco.mj_makeConstraint(model, data)
        rows = _equality_rows(model, data)
        passive = ~driven & ~is_free & (rows != 0).any(axis=0)
        if passive.any():
            weight = np.where(passive, PASSIVE, 1.0) * ~is_free
            multipliers = np.linalg.lstsq((weight * rows).T, weight * torques[t], rcond=None)[0]
            out[t] -= np.where(is_free, 0.0, multipliers @ rows)
    return out


def _equality_rows(model: mujoco.MjModel, data: mujoco.MjData) -> Array:
    """Return the Jacobian (n, nv) of the active equality constraints."""
    jacobian = np.zeros((data.nefc, model.nv))
    if mujoco.mj_isSparse(model):
        mujoco.mju_sparse2dense(jacobian, data.efc_J, data.efc_J_rownnz, data.efc_J_rowadr, data.efc_J_colind)
    else:
        jacobian[:] = data.efc_J.reshape(data.nefc, model.nv)
    return jacobian[data.efc_type == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)]
