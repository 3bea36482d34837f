"""What is wrong with a recording's samples: each fault is found, told and bridged, and a sound motion is left alone."""

import numpy as np
import pytest

from dynsplines.clean.repairs import Repaired, repaired
from dynsplines.clip.load import figure_of
from dynsplines.errors import UserError
from dynsplines.scene.compose import compose, figure_spec

FIGURE = figure_of(compose(figure_spec("human")), "human")
TIMES = np.arange(60) / 30
ELBOW = FIGURE.model.joint("left_elbow").qposadr[0]


def motion() -> np.ndarray:
    """qpos (T, nq) of somebody who rises a little and bends an elbow."""
    out = np.tile(FIGURE.model.qpos0, (TIMES.size, 1))
    out[:, 2] += 0.05 * np.sin(3 * TIMES) + 0.03
    angle = 0.8 + 0.5 * np.sin(4 * TIMES)
    out[:, ELBOW], out[:, ELBOW + 2] = np.cos(angle / 2), -np.sin(angle / 2)
    return out


def mended(time: np.ndarray, qpos: np.ndarray) -> Repaired:
    return repaired(FIGURE, time, qpos, "walk.csv")


def test_a_sound_motion_is_left_alone():
    found = mended(TIMES, motion())
    assert found.notes == ()
    assert found.known.all()
    np.testing.assert_array_equal(found.qpos, motion())


def test_samples_that_come_twice_are_left_out():
    row = np.repeat(np.arange(60), 1 + (np.arange(60) == 20))
    found = mended(TIMES[row], motion()[row])
    np.testing.assert_array_equal(found.time, TIMES)
    assert found.notes == ("1 sample comes twice, first at 0.667 s: left out",)


def test_most_samples_can_come_twice_at_times_that_differ_by_rounding():
    row = np.repeat(np.arange(60), 2)
    found = mended(TIMES[row] + np.where(np.arange(120) == 41, 1e-6, 0.0), motion()[row])
    np.testing.assert_array_equal(found.time, TIMES)


def test_what_is_no_number_is_bridged_and_its_joint_alone():
    qpos = motion()
    qpos[10:13, ELBOW + 1] = np.nan
    qpos[20, ELBOW : ELBOW + 4] = 0
    found = mended(TIMES, qpos)
    assert found.notes == ("4 samples of 'left_elbow' hold no numbers, first at 0.333 s: bridged",)
    assert np.isfinite(found.qpos).all()
    assert (~found.known).sum() == 4 * 4
    assert found.known[10, :ELBOW].all()


def test_missing_samples_are_put_in_and_known_to_be_missing():
    keep = np.r_[0:30, 40:60]
    found = mended(TIMES[keep], motion()[keep])
    np.testing.assert_allclose(found.time, TIMES, atol=1e-9)
    assert not found.known[30:40].any()
    assert found.known.all(axis=1).sum() == 50
    assert found.notes == ("nothing is recorded from 0.967 to 1.333 s: bridged",)


def test_a_sample_that_jumps_away_and_back_is_not_believed():
    qpos = motion()
    qpos[25, 2] += 0.3
    found = mended(TIMES, qpos)
    assert found.notes == ("'root': 1 samples jump, first at 0.833 s: bridged",)
    assert not found.known[25, :3].any()
    assert found.known.sum() == found.known.size - 3


def test_a_sample_of_the_other_sign_jumps_nowhere():
    qpos = motion()
    qpos[25, ELBOW : ELBOW + 4] *= -1
    assert mended(TIMES, qpos).known.all()


@pytest.mark.parametrize("count", [1, 9])
def test_a_pose_at_the_start_that_ends_with_a_jump_is_left_out(count):
    pose = motion()[0]
    pose[ELBOW : ELBOW + 4] = np.sqrt(0.5), 0, 0, np.sqrt(0.5)
    found = mended(np.arange(60 + count) / 30, np.vstack([np.tile(pose, (count, 1)), motion()]))
    assert found.notes == (
        f"the recording starts with a pose and jumps to the motion at {count / 30:.3f} s: the pose is left out",
    )
    np.testing.assert_array_equal(found.qpos, motion())


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda t, q: (t[:1], q[:1]), "1 sample; a motion to clean has 5 at least"),
        (lambda t, q: (t[::-1], q), "times go back: sample 2 is at 1.93333 s, after 1.96667 s"),
        (lambda t, q: (np.append(t[:30], t[30:] + 3), q), "nothing is recorded from 0.967 to 4.000 s, over 2 s"),
        (lambda t, q: (t, np.where(np.arange(q.shape[1]) == ELBOW, np.nan, q)), "too few samples of 'left_elbow'"),
    ],
)
def test_what_nobody_can_mend_is_refused(change, told):
    with pytest.raises(UserError, match=r"walk\.csv") as refused:
        mended(*change(TIMES, motion()))
    assert told in str(refused.value)
