"""Windings: shortest arcs, a spin that goes on, all choices tried by hand, joints before bodies."""

import itertools

import numpy as np
import pytest
from figures import figure_of
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.curve.winding import NEARLY_HALF, signs


def turned_by(angles: list[float], axis: tuple[float, float, float] = (0, 0, 1)) -> np.ndarray:
    """(K, 4) a body turned to these angles [degrees] about an axis, all on one half of the quaternions."""
    q = quat.from_rotation_vector(np.radians(angles)[:, None] * np.array(axis))
    return q * np.where(q[:, :1] < 0, -1, 1)


def arcs(track: np.ndarray) -> np.ndarray:
    """The arcs [degrees] that a track of quaternions with signs turns by, up to 360."""
    return np.degrees(2 * np.arccos(np.clip(np.sum(track[1:] * track[:-1], axis=1), -1, 1)))


def wound(angles: list[float], *, spins: bool) -> np.ndarray:
    track = turned_by(angles)
    return arcs(track * signs(np.arange(len(angles), dtype=float), track, spins=spins)[:, None])


@pytest.mark.parametrize("spins", [False, True])
def test_arcs_under_150_degrees_are_the_shortest(spins):
    np.testing.assert_allclose(wound([0, 140, 0, -140, 70, 200], spins=spins), [140, 140, 140, 150, 130], atol=1e-4)


def test_a_spin_continues_past_a_half_turn():
    np.testing.assert_allclose(wound([0, 100, 287, 387], spins=True), [100, 187, 100], atol=1e-4)


def test_a_joint_does_not():
    np.testing.assert_allclose(wound([0, 100, 287, 387], spins=False), [100, 173, 100], atol=1e-4)
    np.testing.assert_allclose(wound([0, 0, 170, 0, 0], spins=False), [0, 170, 170, 0], atol=1e-4)


@pytest.mark.slow
@settings(deadline=None)
@given(st.lists(st.floats(-175, 175), min_size=2, max_size=6), st.integers(0, 100))
@example([0.0, 150.001, 11.0], 0)
def test_the_choice_is_the_best_of_all(turns, seed):
    rng = np.random.default_rng(seed)
    rotations = [Rotation.identity()]
    for turn in turns:
        axis = rng.normal(size=3)
        rotations.append(rotations[-1] * Rotation.from_rotvec(np.radians(turn) * axis / np.linalg.norm(axis)))
    track = np.array([np.roll(r.as_quat(), 1) for r in rotations])
    times = np.append(0, np.cumsum(rng.uniform(0.2, 2, len(turns))))
    steps = np.array([(a.inv() * b).as_rotvec() for a, b in itertools.pairwise(rotations)])
    angle = np.linalg.norm(steps, axis=1)
    assume(np.all(np.abs(angle - NEARLY_HALF) > 1e-9))  # on the bound itself rounding decides

    def cost(ways: tuple[bool, ...]) -> float:
        rates = [s * (1 - 2 * np.pi / a if w else 1) for s, a, w in zip(steps, angle, ways, strict=True)]
        rates = np.array(rates) / np.diff(times)[:, None]
        return float(np.sum(np.sum(np.diff(rates, axis=0) ** 2, axis=1) * 2 / (times[2:] - times[:-2])))

    choices = itertools.product(*[(False, True) if a > NEARLY_HALF else (False,) for a in angle])
    best = min(cost(ways) for ways in choices)
    chosen = arcs(track * signs(times, track, spins=True)[:, None]) > 180 + 1e-9
    assert cost(tuple(chosen)) <= best * (1 + 1e-9) + 1e-9


@pytest.mark.parametrize("turn", [120.0, 160.0, 178.0])
def test_a_limb_goes_with_a_body_that_turns_far(turn):
    """Root and hip turn the same way: the thigh turns by the sum in the world, not by the rest of the circle."""
    figure = figure_of(models.figure_text("human"))
    hip = next(link for link in figure.links if link.name == "left_hip")
    keys = []
    for i in range(2):
        qpos = np.array(figure.model.qpos0)
        qpos[3:7] = quat.from_rotation_vector(np.radians([0, 0, i * turn]))
        qpos[hip.qpos : hip.qpos + 4] = quat.from_rotation_vector(np.radians([0, 0, i * 100.0]))
        keys.append(Frame.key(float(i), qpos))
    states = raw_timeline(figure, keys).states
    np.testing.assert_allclose(arcs(states[:, hip.qpos : hip.qpos + 4]), [turn + 100], atol=1e-4)
