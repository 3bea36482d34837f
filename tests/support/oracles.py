"""Independent references: MuJoCo, SciPy, exact paths, dense matrices."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from dynsplines.solver.array import Array, Index, Mask
from dynsplines.solver.figure.dynamics import velocities
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import SelfContact

# What MuJoCo and SciPy can be asked as oracles, and from which version on.

tells_height_fields = pytest.mark.skipif(
    int(mujoco.__version__[0]) < 4, reason="MuJoCo 3 tells no distances from height fields"
)


def by_scipy(figure: Figure, times: Array, qpos: Array, t: Array) -> Array:
    """(T, nq): configurations (K, nq) joined by SciPy's SLERP of every joint's own rotation, and by lines."""
    out = np.array([np.interp(t, times, column) for column in qpos.T]).T
    for link in figure.links[1:]:
        columns = quaternion_columns(link)
        if columns is not None:
            turns = Slerp(times, Rotation.from_quat(np.roll(qpos[:, columns], -1, axis=1)))(t)
            out[:, columns] = np.roll(turns.as_quat(), 1, axis=1)
    return out


def mujoco_forces(samples: Samples) -> np.ndarray:
    figure = samples.figure
    model = figure.model
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
    return _inverse(model, figure.to_qpos(samples.y), *velocities(samples))


def _inverse(model: mujoco.MjModel, *motion: Array) -> Array:
    """(T, nv) by mj_inverse of positions, velocities and accelerations."""
    data, out = mujoco.MjData(model), []
    for data.qpos[:], data.qvel[:], data.qacc[:] in zip(*motion, strict=True):
        mujoco.mj_inverse(model, data)
        out.append(data.qfrc_inverse.copy())
    return np.array(out)


def kinematics(model: mujoco.MjModel, qpos: Array | None = None, data: mujoco.MjData | None = None) -> mujoco.MjData:
    """Return bodies, sites, centres of mass and Jacobians of a pose, by default the model's own, by MuJoCo, in `data`
    or in new data, which take a millisecond."""
    data = mujoco.MjData(model) if data is None else data
    data.qpos[:] = model.qpos0 if qpos is None else qpos
    mujoco.mj_normalizeQuat(model, data.qpos)
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    return data


def distance_of_ball(model: mujoco.MjModel, name: str, centre: Array, reach: float = 10.0) -> float:
    """Signed distance [m] of the surface of the ball at a centre from the named geom, at most `reach` away."""
    data = kinematics(model, np.append(centre, model.qpos0[3:]))
    return mujoco.mj_geomDistance(model, data, model.geom("ball").id, model.geom(name).id, reach, None)


def differences(model: mujoco.MjModel, qpos: Array, values: Callable[[Array], Array], h: float = 1e-6) -> Array:
    """(k, nv): how values of a pose change along every velocity."""
    columns = []
    for direction in np.eye(model.nv):
        ends = np.array(qpos), np.array(qpos)
        for end, way in zip(ends, (h, -h), strict=True):
            mujoco.mj_integratePos(model, end, direction, way)
        columns.append((values(ends[0]) - values(ends[1])) / (2 * h))
    return np.array(columns).T


def inverse_dynamics(model, at, rows=slice(None)):
    """(T, nv) by mj_inverse of a motion's samples, without contacts."""
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    model.opt.enableflags = 0
    return _inverse(model, at.qpos[rows], at.qvel[rows], at.qacc[rows])


def tracks(model: mujoco.MjModel, qpos: Array, names: Sequence[str]) -> Array:
    """(T, n, 3) [m]: the places of sites along configurations (T, nq), by MuJoCo."""
    data = mujoco.MjData(model)
    return np.array([[kinematics(model, row, data).site(name).xpos.copy() for name in names] for row in qpos])


def aligned(figure: Figure, qpos: Array, wanted: Array) -> Array:
    """Configurations (..., nq) with the quaternions' signs of others."""
    out = np.array(qpos)
    for columns in figure.tables.quaternion_columns.T:
        out[..., columns] *= np.sign(np.sum(out[..., columns] * wanted[..., columns], axis=-1, keepdims=True))
    return out


# The pairs of geoms that a penalty of self-contact keeps apart.


def geom_pairs(penalty: SelfContact) -> Index:
    """The pairs of geoms, each once, (2, g)."""
    geoms = np.array([bar.geom for bar in penalty.bars], np.intp)
    return np.unique(geoms[penalty.pairs], axis=1) if penalty.pairs.size else np.zeros((2, 0), np.intp)


# A goal of inverse kinematics that is not of the solver: a site of MuJoCo at a position.


@dataclass(frozen=True, eq=False)
class SiteGoal:
    """A site at a place in the world: position (3,) [m], NaN along the axes that are free."""

    name: str
    position: Array

    def bodies(self, model: mujoco.MjModel) -> list[int]:
        return [int(model.site_bodyid[model.site(self.name).id])]

    def residual(self, model: mujoco.MjModel, data: mujoco.MjData) -> Array:
        return (data.site(self.name).xpos - self.position)[self._specified]

    def linearise(self, model: mujoco.MjModel, data: mujoco.MjData) -> tuple[Array, Array]:
        rows = np.zeros((3, model.nv))
        mujoco.mj_jacSite(model, data, rows, None, model.site(self.name).id)
        return self.residual(model, data), rows[self._specified]

    @cached_property
    def _specified(self) -> Mask:
        return ~np.isnan(self.position)
