"""What shipped clips promise, measured at 1 kHz by MuJoCo's own geometry: out of the scene, feet in their places."""

from __future__ import annotations

import functools
import io
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from runner import clip, work
from runner.motion import sampled, samples_at
from runner.penetration import self_penetration
from runner.progress import Teller
from runner.report import report
from runner.work import Solved
from solver.mirror import Mirror
from solver.penalty import BendLimits, Contact, SelfContact
from solver.seam import Seam
from solver.subdivision import path_of


@dataclass(frozen=True)
class Promise:
    """What holds of a clip.

    raw      [m] that the spline through its keyframes penetrates at least
    stances  how many times a foot stays put from one keyframe to the next
    travel   [m] along x from the first time to the last; climb: along z
    """

    raw: float
    stances: int
    travel: float
    climb: float = 0.0


PROMISES = {
    "run_loop": Promise(raw=0.02, stances=4, travel=2.0),
    "stairs": Promise(raw=0.05, stances=20, travel=1.19, climb=0.68),
    "walk_loop": Promise(raw=0.005, stances=8, travel=1.38),
}
DEEPEST = 0.001  # [m] after
LIFT, SLIDE = 0.005, 0.005  # [m] of a planted foot
BACKWARD, SIDEWAYS = 0.1, 5.0  # degrees of knees and elbows
SELF = 0.005  # [m] of limbs in each other or in the trunk


@dataclass(frozen=True, eq=False)
class Found:
    name: str
    solved: Solved
    report: dict[str, Any]

    @property
    def after(self) -> dict[str, Any]:
        return self.report["after"]


def _no_segments(_i: int, _count: int) -> None:
    raise KeyboardInterrupt


@functools.cache
def of(name: str) -> Found:
    """A clip, solved and measured once a session."""
    solved = work.solve(clip.load(name), Teller(Console(file=io.StringIO())))
    return Found(name, solved, report(solved.clip, solved.motion, solved.seconds, _no_segments))


@pytest.fixture(params=sorted(PROMISES))
def found(request: pytest.FixtureRequest) -> Found:
    return of(request.param)


def test_the_raw_spline_penetrates_and_the_solved_motion_does_not(found):
    assert found.report["before"]["penetration, m"]["deepest"] >= PROMISES[found.name].raw
    assert found.after["penetration, m"]["deepest"] <= DEEPEST


def test_keyframes_are_met(found):
    assert found.after["keyframe error"] < 1e-12


def test_knees_and_elbows_bend_the_right_way(found):
    bends = found.after["bends, degrees"]
    assert len(bends) == 4
    for angles in bends.values():
        assert angles["backward"] <= BACKWARD
        assert max(angles["sideways"], angles["twist"]) <= SIDEWAYS


def test_planted_feet_stay_down_and_in_their_place(found):
    stances = found.after["stances"]
    assert len(stances) == PROMISES[found.name].stances
    for stance in stances:
        assert stance["lift, m"] <= LIFT
        assert stance["slide, m"] <= SLIDE


def test_no_limb_goes_through_the_body(found):
    figure = found.solved.clip.figure
    run = sampled(figure, found.solved.motion.timeline, 60.0)
    pairs = SelfContact.of(figure, 0.0).geom_pairs
    deepest, where = self_penetration(figure.model, pairs, run.time, run.qpos)
    assert deepest <= SELF, where


def test_it_gets_where_it_is_to(found):
    first, last = found.solved.motion.at(found.solved.motion.timeline.times[[0, -1]])
    assert (last - first)[[0, 2]] == pytest.approx([PROMISES[found.name].travel, PROMISES[found.name].climb], abs=0.01)


@pytest.mark.parametrize("name", ["run_loop", "walk_loop"])
def test_a_loop_goes_on_across_its_seam(name):
    motion = of(name).solved.motion
    assert Seam.of(motion.figure, motion.timeline).apart(motion.path).max() < 1e-9


@pytest.mark.parametrize("name", ["run_loop", "walk_loop"])
def test_the_two_steps_of_a_loop_are_mirror_images(name):
    """To a millimetre and a tenth of a degree; of quaternions, 1e-3 is that."""
    found = of(name)
    motion, figure = found.solved.motion, found.solved.motion.figure
    half, mirror = float(motion.timeline.times[-1]) / 2, Mirror.of(figure)
    t = np.linspace(0, half, 40)
    one, two = (figure.to_qpos(path_of(motion.timeline).at(times)) for times in (t, t + half))
    one = mirror.states(one) + PROMISES[name].travel / 2 * np.eye(figure.width)[0]
    for columns in figure.tables.quaternion_columns.T:
        one[:, columns] *= np.sign(np.sum(one[:, columns] * two[:, columns], axis=1))[:, None]
    assert np.abs(one - two).max() < 1e-3


def test_in_walking_a_foot_is_always_down_and_knees_and_pelvis_move_as_in_normal_gait():
    solved = of("walk_loop").solved
    figure, timeline = solved.clip.figure, solved.motion.timeline
    samples = samples_at(figure, path_of(timeline), np.linspace(0, float(timeline.times[-1]), 200))
    places, _, _ = Contact(solved.clip.points, ()).centres(samples)
    assert places[2].min(axis=0).max() < 0.005
    knees = [i for i, bend in enumerate(solved.clip.bends) if "knee" in bend.name]
    flexion, _, _ = np.degrees(BendLimits(solved.clip.bends).angles(samples))
    for knee in flexion[knees]:
        assert 5 < knee.min() < 12
        assert 55 < knee.max() < 70
    assert 0.03 < np.ptp(samples.y[:, 2]) < 0.05


def test_the_stairs_are_climbed_foot_over_foot():
    """The feet stand on step after step in turn, and both on the last."""
    solved = of("stairs").solved
    steps = []
    for stance in of("stairs").after["stances"]:
        at = np.array([(stance["from, s"] + stance["to, s"]) / 2])
        samples = samples_at(solved.clip.figure, path_of(solved.motion.timeline), at)
        places, _, _ = Contact(solved.clip.points, ()).centres(samples)
        if "heel" in stance["points"]:
            names = [point.name for point in solved.clip.points]
            height = places[2, names.index(stance["points"].split(" and ")[0]), 0]
            steps.append((stance["points"].split("_")[0], round(float(height) / 0.17)))
    assert list(dict.fromkeys(steps)) == [
        ("right", 0), ("left", 1), ("right", 2), ("left", 3), ("right", 4), ("left", 4),
    ]  # fmt: skip
