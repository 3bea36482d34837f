"""Faults of a recording's samples are reported and interpolated; a sound motion does not change."""

from typing import Any

import numpy as np
import pytest

from dynsplines.clean.repairs import Repaired, repair
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
    return repair(FIGURE, time, qpos, "walk.csv")


def changed(rows: Any, columns: Any, value: Any) -> np.ndarray:
    """The motion with other values in some rows and columns."""
    qpos = motion()
    qpos[rows, columns] = value
    return qpos


MISSING, TWICE = np.r_[0:30, 40:60], np.repeat(np.arange(60), 1 + (np.arange(60) == 20))
ALL_TWICE = np.repeat(np.arange(60), 2)
JOINT = slice(ELBOW, ELBOW + 4)
POSE = changed(0, JOINT, (np.sqrt(0.5), 0, 0, np.sqrt(0.5)))[:1]
STARTS = "the recording starts with a pose and jumps to the motion at {:.3f} s: the pose is left out"
FAULTS = {  # times, qpos, rows and columns that are not known afterwards, notes
    "none": (TIMES, motion(), (), (), ()),
    "other sign": (TIMES, changed(25, JOINT, -motion()[25, JOINT]), (), (), ()),
    "twice": (TIMES[TWICE], motion()[TWICE], (), (), ("1 sample comes twice, first at 0.667 s: left out",)),
    "all twice, times rounded": (
        TIMES[ALL_TWICE] + np.where(np.arange(120) == 41, 1e-6, 0.0), motion()[ALL_TWICE], (), (),
        ("60 samples come twice, first at 0.000 s: left out",)),
    "no numbers in one joint": (
        TIMES, changed([10, 11, 12], ELBOW + 1, np.nan), [10, 11, 12], JOINT,
        ("3 samples of 'left_elbow' hold no numbers, first at 0.333 s: bridged",)),
    "a quaternion of zeros": (
        TIMES, changed(20, JOINT, 0), [20], JOINT,
        ("1 samples of 'left_elbow' hold no numbers, first at 0.667 s: bridged",)),
    "missing": (
        TIMES[MISSING], motion()[MISSING], slice(30, 40), slice(None),
        ("nothing is recorded from 0.967 to 1.333 s: bridged",)),
    "a sample off": (
        TIMES, changed(25, 2, motion()[25, 2] + 0.3), [25], slice(0, 3),
        ("'root': 1 samples jump, first at 0.833 s: bridged",)),
    "a pose at the start": (
        np.arange(-1, 60) / 30, np.vstack([POSE, motion()]), (), (), (STARTS.format(0),)),
    "a pose held at the start": (
        np.arange(-9, 60) / 30, np.vstack([*9 * [POSE], motion()]), (), (), (STARTS.format(0),)),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_reported_and_repaired_and_nothing_else_changes(fault):
    time, qpos, rows, columns, notes = FAULTS[fault]
    found, known = mended(time, qpos.copy()), np.ones((60, FIGURE.width), bool)
    if columns != ():
        known[rows, columns] = False
    assert found.notes == notes
    np.testing.assert_allclose(found.time, TIMES, atol=1e-9)
    np.testing.assert_array_equal(found.known, known)
    assert np.isfinite(found.qpos).all()
    same = found.qpos[found.known], motion()[found.known]
    np.testing.assert_allclose(np.abs(same[0]), np.abs(same[1]), atol=1e-12)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda t, q: (t[:1], q[:1]), "1 sample; a motion to clean has 5 at least"),
        (lambda t, q: (t[::-1], q), "times go back: sample 2 is at 1.93333 s, after 1.96667 s"),
        (lambda t, q: (np.append(t[:30], t[30:] + 3), q), "'root' is not recorded from 0.967 to 4.000 s, over 2 s"),
        (
            lambda t, q: (2 * t, np.where((t[:, None] > 0.5) & (np.arange(q.shape[1]) == ELBOW), np.nan, q)),
            "'left_elbow' is not recorded from 1.000 to 3.933 s, over 2 s",
        ),
        (lambda t, q: (t, np.where(np.arange(q.shape[1]) == ELBOW, np.nan, q)), "too few samples of 'left_elbow'"),
    ],
)
def test_what_nobody_can_mend_is_refused(change, told):
    with pytest.raises(UserError, match=r"walk\.csv") as refused:
        mended(*change(TIMES, motion()))
    assert told in str(refused.value)
