"""Flight: free fall costs nothing, the value against mj_inverse, the gradient, and what it does to a hop."""

import mujoco
import numpy as np
from figures import BALL_TREE, figure_of
from oracles import mujoco_forces
from random_samples import at_times, random_samples

from dynsplines.solver import quaternion as quat
from dynsplines.solver.contacts import within
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.root_wrench import RootWrench, weight
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import CovariantAcceleration, Flight, Penalty, RootAcceleration
from dynsplines.solver.problem import Problem, Settings

G = 9.81
BRICK = f"""<mujoco><option gravity="0 0 -{G}"/><worldbody><body><freejoint/>
<inertial mass="3" pos=".1 .2 .3" diaginertia=".2 .3 .4"/></body></worldbody></mujoco>"""
ALL = ((-1.0, 9.0),)


def test_it_is_the_root_force_of_mj_inverse_in_weights_while_a_flight_lasts(figure, rng):
    samples = at_times(random_samples(figure, rng, 6), np.array([0.0, 0.1, 0.2, 0.3, 0.6, 0.7]))
    expected = np.sum(mujoco_forces(samples)[:, :3] ** 2, axis=1) / weight(figure, 1) ** 2
    expected[[0, 4]] = 0
    found = Flight.of(figure, 1, ((0.05, 0.4), (0.7, 0.8))).evaluate(samples)
    np.testing.assert_allclose(found, expected, rtol=1e-9)
    assert np.count_nonzero(expected) == 4


def thrown() -> Samples:
    """A body of three different moments of inertia that tumbles freely, by MuJoCo's own simulation."""
    figure = figure_of(BRICK)
    model, data = figure.model, mujoco.MjData(figure.model)
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    data.qvel[:] = 1, -0.5, 3, 2, -3, 1
    y, y_d, y_dd = np.zeros((3, 20, 7))
    model.opt.timestep = 0.02
    for i in range(20):
        mujoco.mj_forward(model, data)
        spin, spin_rate = data.qvel[3:], data.qacc[3:]
        q = data.qpos[3:].copy()
        q_d = 0.5 * quat.product(q, np.append(0, spin))
        y[i], y_d[i] = data.qpos, np.append(data.qvel[:3], q_d)
        y_dd[i, :3] = data.qacc[:3]
        y_dd[i, 3:] = 0.5 * (quat.product(q_d, np.append(0, spin)) + quat.product(q, np.append(0, spin_rate)))
        mujoco.mj_step(model, data)
    return Samples(figure, y, y_d, y_dd)


def test_a_body_that_tumbles_freely_costs_nothing_and_one_that_hovers_one():
    samples = thrown()
    flight = Flight.of(samples.figure, 1, ALL, 1.0)
    assert flight.evaluate(samples).max() < 1e-20
    still = Samples(samples.figure, samples.y, 0 * samples.y, 0 * samples.y)
    np.testing.assert_allclose(flight.evaluate(still), 1.0, rtol=1e-12)


def test_a_flight_lasts_from_its_first_moment_to_its_last():
    t = np.array([0.0, 0.25, 0.5, 0.75, 1.0, 2.0])
    assert within(((0.25, 0.5), (1.0, 1.0)), t).tolist() == [False, True, True, False, True, False]
    assert within(((0.0, 0.75), (0.5, 2.0)), t).all()
    assert not within((), t).any()


def hop(*penalties: tuple[Penalty, float]) -> tuple[float, float]:
    """How far the centre of mass of a jointed figure is off g in its flight from 0.3 to 0.7 s: before, after."""
    figure = figure_of(BALL_TREE)
    rest = np.array(mujoco.MjData(figure.model).qpos)
    heights, keys = {0.0: 1.0, 0.3: 1.1, 0.7: 1.1, 1.0: 1.0}, []
    for time, z in heights.items():
        qpos = rest.copy()
        qpos[:3] = 2 * time, 0, z
        qpos[7:11] = quat.from_rotation_vector(np.array([0, 2 * np.sin(9 * time), 0]))
        keys.append(Frame.key(time, qpos))
    motion = inbetween(Problem(figure, keys, [(CovariantAcceleration(), 1.0), *penalties], Settings(frames=20)))
    off = []
    for timeline in (motion.raw, motion.timeline):
        samples = Samples(figure, *path_of(timeline).motion(np.linspace(0.3, 0.7, 201)))
        off.append(np.mean(np.linalg.norm(RootWrench(samples, 1).force, axis=0)) / weight(figure, 1))
    return off[0], off[1]


def test_flight_falls_as_it_should_and_without_the_penalty_it_does_not():
    figure = figure_of(BALL_TREE)
    before, after = hop((Flight.of(figure, 1, ((0.3, 0.7),)), 3.0))
    assert before > 0.2
    assert after < 0.05
    assert hop((RootAcceleration(), 1.0))[1] > 0.2
