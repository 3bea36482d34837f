"""The pose before a recording's motion is told from standing still, and left out if asked for."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from dynsplines import models, motion, solving
from dynsplines.clean import rest_pose_trim
from dynsplines.clip import load as clip
from dynsplines.edit import thin_files
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.spline import path_of
from dynsplines.system.progress import Progress

RATE = 60.0
HUMAN = mujoco.MjModel.from_xml_string(models.figure_text("human"))
LOW_ARMS = np.radians(15)


class Ear(Progress):
    def __init__(self):
        super().__init__()
        self.heard = []

    def report(self, line):
        self.heard.append(line)


@pytest.fixture(scope="module")
def walk():
    """(T, nq) at RATE, a person who walks."""
    loop = clip.load("walk_loop")
    found = solving.unsolved(loop).motion.timeline
    times = np.arange(0, found.times[-1] - found.times[0], 1 / RATE) + found.times[0]
    return loop.figure.to_qpos(path_of(found).at(times))


def raised(angle: float, at: np.ndarray = HUMAN.qpos0) -> np.ndarray:
    """A pose with its arms lifted sideways by an angle [rad] from hanging."""
    out = at.copy()
    for name, sign in (("left_shoulder", 1), ("right_shoulder", -1)):
        turn = quat.from_rotation_vector(np.array([sign * angle, 0, 0]))
        first = int(HUMAN.jnt_qposadr[HUMAN.joint(name).id])
        out[first : first + 4] = turn
    for name in ("left_elbow", "right_elbow"):
        first = int(HUMAN.jnt_qposadr[HUMAN.joint(name).id])
        out[first : first + 4] = [1, 0, 0, 0]
    return out


def seen(*parts):
    qpos = np.concatenate([np.atleast_2d(part) for part in parts])
    return rest_pose_trim.find_rest_pose(HUMAN, np.arange(len(qpos)) / RATE, qpos)


@pytest.mark.slow
def test_a_single_t_pose_before_a_walk_is_found(walk):
    found = seen(raised(np.pi / 2), walk)
    assert found is not None and (found.count, found.what) == (1, "a T-pose")
    found = seen(*([raised(np.pi / 2)] * 3), walk)
    assert found is not None and (found.count, found.last) == (3, pytest.approx(2 / RATE))


@pytest.mark.slow
def test_a_t_pose_that_is_held_and_lowered_ends_where_the_arms_leave_it(walk):
    lowered = [raised(angle) for angle in np.linspace(np.pi / 2, LOW_ARMS, 31)]  # 2.5° an image
    found = seen(*([raised(np.pi / 2)] * 30), *lowered, walk)
    assert found is not None
    assert 30 + 6 <= found.count <= 30 + 9  # 20° of tolerance


@pytest.mark.slow
def test_standing_still_is_motion(walk):
    standing = HUMAN.qpos0
    assert seen(*([raised(LOW_ARMS)] * 60), walk) is None
    # even at the figure's own rest to the last digit, if what follows begins where it ends
    off = [raised(angle) for angle in np.linspace(0, 1, 40) ** 2]
    assert seen(*([standing] * 60), *off) is None
    assert seen(*([raised(np.pi / 2)] * 60)) is None  # nothing would be left


@pytest.mark.slow
def test_a_rest_pose_that_the_motion_jumps_out_of_is_found(walk):
    found = seen(HUMAN.qpos0, raised(1.4), raised(1.39), raised(1.38))
    assert found is not None and (found.count, found.what) == (1, "the figure's rest pose")
    gently = [raised(angle) for angle in np.linspace(0, 1.4, 30)]
    assert seen(*gently) is None


def test_a_walk_with_arms_spread_is_motion():
    spread = np.tile(raised(np.pi / 2), (60, 1))
    spread[:, 0] += 1.2 * np.arange(60) / RATE
    lowered = np.array([raised(angle, spread[-1]) for angle in np.linspace(np.pi / 2, 0, 40)])
    assert seen(spread, lowered) is None


def test_figures_without_arms_begin_at_once():
    model = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body><freejoint/><geom size=".1"/></body></worldbody></mujoco>'
    )
    assert rest_pose_trim.find_rest_pose(model, np.arange(9) / RATE, np.tile(model.qpos0, (9, 1))) is None


def spline(qpos):
    found = clip.from_qpos("walk", compose(figure_spec("human")), np.arange(len(qpos)) / RATE, qpos, RATE, "walk.csv")
    return solving.unsolved(found).saved(Progress(), with_report=False)


@pytest.fixture
def recording(walk, tmp_path):
    motion.save(spline(np.concatenate([raised(np.pi / 2)[None], walk[:20]])), tmp_path / "walk.npz")
    return tmp_path / "walk.npz"


def read(path, *, skip_rest):
    ear = Ear()
    return thin_files.Recording(str(path), skip_rest=skip_rest).read(ear), ear.heard


@pytest.mark.slow
def test_it_is_told_and_stays_unless_it_is_to_be_left_out(recording, walk):
    says = "note: the recording begins with a T-pose (1 image, 0.000 s), no motion: "
    whole, heard = read(recording, skip_rest=False)
    assert len(whole.keys) == 21
    assert heard == [says + "--skip-rest leaves it out"]
    cut, heard = read(recording, skip_rest=True)
    assert heard == [says + "left out"]
    assert [key.time for key in cut.keys] == [key.time for key in whole.keys[1:]]
    # the spline is that of the rest alone: nothing is left of the jump, through which it ran
    alone = path_of(spline(walk[:20]).timeline)
    between = np.arange(0.5, 19) / RATE
    np.testing.assert_allclose(path_of(cut.timeline).at(between + 1 / RATE), alone.at(between), atol=1e-9)
    assert np.abs(path_of(whole.timeline).at(between + 1 / RATE) - alone.at(between)).max() > 0.01


@pytest.mark.slow
def test_leaving_out_what_is_not_there_is_told(recording):
    cut, _ = read(recording, skip_rest=True)
    ear = Ear()
    assert rest_pose_trim.trim(cut, ear, skip=True) is cut
    assert ear.heard == ["note: --skip-rest: no T-pose or rest pose stands before the motion; nothing is left out"]
