"""The clip of the paper's figure 7: one body turns through seven orientations while it travels from left to right."""

from __future__ import annotations

import numpy as np
import pytest
import shipped
from paper.orientations import INTRINSIC, KEYFRAMES, Run, energy
from scipy.spatial.transform import Rotation

from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.spline import Path, path_of
from dynsplines.solving import Solved


@pytest.fixture
def tumble() -> Solved:
    return shipped.solved("tumble")


def turning(path: Path) -> Path:
    """The quaternion of a free body's path."""
    return Path(path.spline, path.rows[:, 3:7])


def test_it_has_seven_whole_keyframes_with_large_steps_between_them(tumble):
    keys = tumble.clip.keys
    assert len(keys) == KEYFRAMES == 7
    assert all(key.is_key for key in keys)
    turns = Rotation.from_quat([key.state[3:7] for key in keys], scalar_first=True)
    steps = np.degrees((turns[:-1].inv() * turns[1:]).magnitude())
    assert steps.min() > 50
    assert steps.max() < 91


def test_it_travels_evenly_from_left_to_right_which_is_x_from_the_side(tumble):
    time = np.linspace(0, 3, 200)
    places = tumble.motion.at(time)[:, :3]
    np.testing.assert_allclose(places, np.stack([2.4 * time, 0 * time, 0 * time + 1.2], axis=1), atol=1e-9)


def test_it_turns_with_nearly_the_least_energy_there_is_and_less_than_the_raw_spline(tumble):
    run = Run([Frame.key(key.time, key.state[3:7]) for key in tumble.clip.keys])
    least = energy(run.solved(INTRINSIC, 7).path)
    solved, raw = (energy(turning(path)) for path in (tumble.motion.path, path_of(tumble.motion.raw)))
    assert solved < 1.001 * least
    assert raw > 1.02 * least
