"""Robots through export, import and simulation, each compared with MuJoCo's results on the user's own file."""

from pathlib import Path

import motions
import mujoco
import numpy as np
import pytest
from motions import exported_scene as exported
from motions import played
from oracles import inverse_dynamics
from random_models import motion_of
from texts import read_data

from dynsplines.errors import UserError
from dynsplines.exchange import quantities
from dynsplines.measure.forces import Forces
from dynsplines.motion import Sampled, Saved
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask

WITHIN = 0.05  # [rad], [m]
EXACT = 1e-6  # [m], [rad]
EVERY = ("csv", "npz")
FREE, SLIDE = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_SLIDE)

ROBOTS = {  # tests/data/robot_*.xml, and the formats that can hold their motions
    "free": (*EVERY, "mjlab", "mjlab-csv", "locomujoco", "gmr", "mimickit"),
    "balls": (*EVERY, "mimickit"),
    "planar": EVERY,
    "fixed": EVERY,
}


def assert_close(actual: Array, expected: Array) -> None:
    """To 1e-6 of the largest value."""
    np.testing.assert_allclose(actual, expected, rtol=0, atol=EXACT * np.abs(expected).max(initial=1e-9))


def borne(forces: Forces) -> Mask:
    """(T,) whether the ground gives forces."""
    return np.any([np.any(foot.force != 0, axis=1) for foot in forces.feet], axis=0)


def check_forces(saved: Saved, expected: Array) -> None:
    """Torques, and the root's wrench about the centre of mass, are those of mj_inverse."""
    forces, at, model = Forces.of(Sampled.of(saved)), motions.samples(saved), saved.figure.model
    rows = forces.has_known_support & ~borne(forces)
    np.testing.assert_allclose(forces.torques[rows], expected[rows], rtol=0, atol=EXACT * np.abs(expected).max())
    root = saved.figure.root
    if root is None:
        with pytest.raises(UserError, match="no free root"):
            quantities.table(Sampled.of(saved), ("wrench",))
        return
    columns = quantities.wrench(forces)
    force, moment, centre = np.array(list(columns.values())).reshape(3, 3, -1).transpose(0, 2, 1)
    q, dof, data = int(model.jnt_qposadr[root.joint]), int(model.jnt_dofadr[root.joint]), mujoco.MjData(model)
    for qpos, row in zip(at.qpos, centre, strict=True):
        data.qpos = qpos
        mujoco.mj_fwdPosition(model, data)
        np.testing.assert_allclose(row, data.subtree_com[root.body], atol=EXACT)
    assert_close(force, expected[:, dof : dof + 3])
    turned = quat.rotate(at.qpos[:, q + 3 : q + 7], expected[:, dof + 3 : dof + 6])
    assert_close(moment, turned - np.cross(centre - at.qpos[:, q : q + 3], force))


def check_feed_forward(model: mujoco.MjModel, expected: Array, rows: Mask) -> None:
    """At keys without ground reactions the actuators exert the forces of mj_inverse, at all joints but free ones."""
    data, forces = mujoco.MjData(model), []
    for key in range(model.nkey):
        mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_forward(model, data)
        forces.append(data.qfrc_actuator.copy())
    driven = model.jnt_type[model.dof_jntid] != FREE
    assert np.abs(np.array(forces) - expected)[np.ix_(rows, driven)].max(initial=0) <= EXACT * np.abs(expected).max()


def largest_errors(model: mujoco.MjModel) -> tuple[float, float]:
    """How far `mj_step` leaves the keys in a second: [rad] and [m]."""
    worst = played(model, 1.0).worst
    is_length = model.jnt_type[model.dof_jntid] == SLIDE
    for joint in np.flatnonzero(model.jnt_type == FREE):
        is_length[model.jnt_dofadr[joint] + np.arange(3)] = True
    return worst[~is_length].max(initial=0), worst[is_length].max(initial=0)


def check_simulation(saved: Saved, folder: Path, expected: Array) -> None:
    """The scene follows the motion, or a note says that it does not."""
    model, notes = exported(saved, folder)
    forces = Forces.of(Sampled.of(saved))
    check_feed_forward(model, expected, forces.has_known_support & ~borne(forces))
    angle, length = largest_errors(model)
    line = next(note for note in notes if note.startswith("mj_step of the scene"))
    assert ("stays within" in line) == (angle < WITHIN and length < WITHIN), (line, angle, length)


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
def test_robots_of_every_feature_are_exported_imported_and_simulated_as_mujoco_computes(name: str, tmp_path: Path):
    """Springs, dampers, friction, fluid, tendons, couplings, actuators, frames, defaults, references and ranges."""
    figure = tmp_path / "robot.xml"
    figure.write_text(read_data(f"robot_{name}.xml"))
    model = mujoco.MjModel.from_xml_path(str(figure))
    saved = motion_of(figure, seed=3, spread=0.6 if name == "planar" else 0.1)
    check_forces(saved, inverse_dynamics(model, motions.samples(saved)))
    for kind in ROBOTS[name]:
        target, _ = motions.exported(saved, kind, tmp_path)
        motions.came_back(saved, target, str(figure), EXACT, kind=kind, fps=saved.fps)
    model.jnt_actgravcomp[:] = 0  # the scene compensates gravity without actuators
    check_simulation(saved, tmp_path, inverse_dynamics(model, motions.samples(saved)))
