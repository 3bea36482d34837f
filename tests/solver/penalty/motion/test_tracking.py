"""Near: its value by SciPy's spline and MuJoCo's places, gradient and curvature, the frames that hold a recording."""

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from random_models import at_times, random_samples
from scipy.interpolate import CubicSpline

from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.recording import RecordedMotion
from dynsplines.solver.curve.spline import natural_spline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import TrackingPenalty
from dynsplines.solver.penalty.motion.tracking import BACK, EASED, STRAYS

TIMES = np.linspace(0, 2, 61)


def near(figure: Figure, rng: np.random.Generator) -> TrackingPenalty:
    states = figure.to_state(figure.model.qpos0 + 0.3 * np.sin(3 * TIMES[:, None] + rng.uniform(0, 6, figure.width)))
    return TrackingPenalty(RecordedMotion(figure, TIMES, states, np.ones_like(states)))


def around(figure: Figure, rng: np.random.Generator, count: int) -> tuple[TrackingPenalty, Samples]:
    """A recording, and samples at times of it that are not its own."""
    found = near(figure, rng)
    return found, at_times(random_samples(figure, rng, count), rng.uniform(0.1, 1.9, count))


def test_the_value_is_that_of_differences_from_scipys_spline_and_mujocos_places(figure, rng):
    found, samples = around(figure, rng, 4)
    curve = CubicSpline(TIMES, found.recorded.bridged, bc_type="natural")
    weights = found.weights(samples.t)
    links, _ = found.ends

    def places(state: np.ndarray) -> np.ndarray:
        data = kinematics(figure.model, figure.to_qpos(state[None])[0])
        bodies = [figure.links[link].body for link in links]
        arms = zip(bodies, found.ends[1].T, strict=True)
        return np.array([data.xpos[b] + data.xmat[b].reshape(3, 3) @ offset for b, offset in arms])

    for s, t in enumerate(samples.t):
        target = [curve(t), curve(t, 1), curve(t, 2)]
        for columns in figure.tables.quaternion_columns.T:
            if target[0][columns] @ samples.y[s, columns] < 0:
                for part in target:
                    part[columns] *= -1
        off = [part[s] - own for part, own in zip((samples.y, samples.y_d, samples.y_dd), target, strict=True)]
        value = sum(float(w[s] @ d**2) for w, d in zip(weights, off, strict=True))
        away = places(samples.y[s]) - places(target[0])
        value += float(np.sum(away**2)) / (2 * STRAYS**2 * BACK)
        np.testing.assert_allclose(found.evaluate(samples)[s], value, rtol=1e-7)


def test_a_root_that_strays_and_comes_back_as_fast_as_it_may_costs_a_half_and_any_other_way_back_more(figure, rng):
    """∫ w₀ z² + w₁ z'² along z = s e^(−t/τ) is (w₀ τ + w₁ / τ) s² / 2: least, half a squared deviation, at τ = BACK."""
    weights = near(figure, rng).weights(np.array([0.4, 1.1]))
    for columns in figure.tables.position_columns.T:
        pose, speed = (weights[order][:, columns] for order in (0, 1))
        np.testing.assert_allclose((pose * BACK + speed / BACK) * STRAYS**2 / 2, 0.5, rtol=1e-3)
        np.testing.assert_allclose(np.sqrt(speed / pose), BACK, rtol=1e-3)
    np.testing.assert_array_equal(weights[1][:, figure.tables.quaternion_columns], 0)


def test_next_to_an_edit_poses_hardly_count_and_smoothly_more_until_its_width_where_all_of_them_does(figure, rng):
    plain = near(figure, rng)
    eased = TrackingPenalty(plain.recorded, ((1.0, 0.4),))
    t = np.linspace(0.5, 1.5, 101)
    whole, held = plain.weights(t), eased.weights(t)
    share = held[0] / whole[0]
    np.testing.assert_allclose(share, np.repeat(share[:, :1], figure.width, axis=1))
    share = share[:, 0]
    at = dict(zip(np.round(t, 2).tolist(), share.tolist(), strict=True))
    assert at[1.0] == pytest.approx(EASED)
    assert at[0.8] == pytest.approx(at[1.2]) == pytest.approx((1 + EASED) / 2)
    np.testing.assert_allclose(share[np.abs(t - 1) > 0.4 - 1e-9], 1)
    assert np.all(np.diff(share[t >= 1]) >= -1e-12)
    assert np.abs(np.diff(share)).max() < 1.6 * 0.01 / 0.4  # no jumps: half as steep again as a straight line
    np.testing.assert_array_equal(held[1:], whole[1:])


def test_its_frames_hold_the_detail_that_it_asks_for_and_are_few(figure, rng):
    found = near(figure, rng)
    few, many = found.times(1e4), found.times(1e-3)
    assert few.size < many.size <= 2 * 60 + 3
    t = np.linspace(0, 2, 400)

    def off(times: np.ndarray) -> float:
        path = natural_spline(times, found.recorded.path.at(times))
        return float(np.abs(path.at(t) - found.recorded.path.at(t)).max())

    assert off(many) < 0.02
    assert off(many) < off(few)


def test_it_leads_variable_frames_to_the_recording_and_no_others(figure, rng):
    found = near(figure, rng)
    state, wanted = figure.to_state(figure.model.qpos0[None])[0], found.recorded.path.at([1.0])[0]
    columns = figure.tables.quaternion_columns
    signs = np.where(np.sum(state[columns] * wanted[columns], axis=0) < 0, -1, 1)
    for flip in (1, -1):  # quaternions have the signs of the timeline's
        start, expected = np.array(state), np.array(wanted)
        start[columns] *= flip
        expected[columns] *= flip * signs
        frames = [Frame.key(0.0, start), Frame.variable(1.0, start), Frame.key(2.0, start)]
        initial_guess = found.initial_guess(Timeline(tuple(frames), np.zeros((2, figure.width))), None)
        np.testing.assert_allclose(initial_guess.frames[1].state, expected)
        assert all(np.array_equal(initial_guess.frames[k].state, start) for k in (0, 2))


def test_the_ends_of_limbs_are_the_bodies_that_carry_none_and_are_where_mujoco_has_their_mass(figure, rng):
    found = near(figure, rng)
    model, links = figure.model, figure.links
    bodies = [link.body for link in links]
    carrying = set()
    for body in bodies:
        above = int(model.body_parentid[body]) if body > 0 else 0
        while above:
            carrying.add(above)
            above = int(model.body_parentid[above])
    ends, arms = found.ends
    assert {bodies[i] for i in ends} == {body for body in bodies if body > 0} - carrying
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for link, arm in zip(ends, arms.T, strict=True):
        body = bodies[link]
        if not any(model.body_weldid[other] == body for other in range(model.nbody) if other != body):
            place = data.xpos[body] + data.xmat[body].reshape(3, 3) @ arm
            np.testing.assert_allclose(place, data.xipos[body], atol=1e-12)
