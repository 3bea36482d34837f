"""What shipped clips promise, measured by MuJoCo's own geometry: out of the scene, feet in their places."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
import pytest
import shipped

from dynsplines import models
from dynsplines.clip.load import Clip
from dynsplines.measure.penetration import penetration, self_penetration
from dynsplines.measure.problems import problems
from dynsplines.motion import sampled, samples_at
from dynsplines.solver.array import Array
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam, heading_between
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.objective import SMALL_SHARE
from dynsplines.solver.penalty import BendLimits, Planted, SelfContact, Stance, Sum
from dynsplines.solver.reading.stride import Gait
from dynsplines.solver.search.astray import is_astray
from dynsplines.solver.solution import Solution
from dynsplines.solver.surface.points import places_of


@dataclass(frozen=True)
class Promise:
    """What holds of a clip.

    raw      [m] that the spline through its keyframes penetrates at least
    contacts how many times a heel or toe is at rest
    travel   [m] along x from the first time to the last; climb: along z
    mirrored how far the steps of a loop are from mirror images, of a quaternion's entry or a metre
    """

    raw: float
    contacts: int
    travel: float
    climb: float = 0.0
    mirrored: float = 0.0


PROMISES = {
    "run_loop": Promise(raw=0.02, contacts=4, travel=2.0, mirrored=1e-3),
    "stairs": Promise(raw=0.05, contacts=32, travel=1.19, climb=0.68),
    "walk_and_turn": Promise(raw=0.007, contacts=49, travel=2.652),
    # the knee of a leg that is given by its foot may swivel a little, another way in either step
    "walk_loop": Promise(raw=0.005, contacts=14, travel=1.38, mirrored=0.04),
}
LOOPS = [name for name, promise in PROMISES.items() if promise.mirrored]
DEEPEST = 0.001  # [m]
LIFT, SLIDE = 0.006, 0.005  # [m] of a point at rest
SIDEWAYS = np.radians(5)  # [rad] of knees and elbows, twisted as well
SELF = 0.005  # [m] of limbs in each other or in the trunk


@dataclass(frozen=True, eq=False)
class Found:
    """A clip and its motion."""

    name: str
    clip: Clip
    motion: Solution

    @property
    def promise(self) -> Promise:
        return PROMISES[self.name]

    def deepest(self, *, raw: bool, rate: float) -> float:
        run = sampled(self.clip.figure, self.motion.raw if raw else self.motion.timeline, rate)
        return penetration(self.clip.figure.model, run.time, run.qpos).deepest

    def samples(self, first: float, last: float, count: int) -> Samples:
        return samples_at(self.clip.figure, path_of(self.motion.timeline), np.linspace(first, last, count))

    def all(self) -> Samples:
        return self.samples(self.clip.keys[0].time, self.clip.keys[-1].time, 500)

    def stances(self) -> tuple[Stance, ...]:
        penalties = [penalty for penalty, _ in self.clip.penalties]
        parts = [p for penalty in penalties for p in (penalty.parts if isinstance(penalty, Sum) else (penalty,))]
        return tuple(stance for part in parts if isinstance(part, Planted) for stance in part.stances)

    def away(self, stance: Stance) -> Array:
        """(3, S) how far a point at rest is from its spot."""
        samples = self.samples(stance.first, stance.last, 100)
        places, _, _ = places_of((stance.point,), samples)
        return places[:, 0] - stance.place(samples.t)


@functools.cache
def of(name: str) -> Found:
    """A clip, solved once a session."""
    done = shipped.solved(name)
    return Found(name, done.clip, done.motion)


@pytest.fixture(params=sorted(PROMISES))
def found(request: pytest.FixtureRequest) -> Found:
    return of(request.param)


@pytest.mark.slow
def test_the_raw_spline_penetrates_and_the_solved_motion_does_not(found):
    assert found.deepest(raw=True, rate=200) >= found.promise.raw
    assert found.deepest(raw=False, rate=500) <= DEEPEST


@pytest.mark.slow
def test_keyframes_are_met(found):
    figure = found.clip.figure
    for key, qpos in zip(found.clip.keys, found.motion.at([key.time for key in found.clip.keys]), strict=True):
        for columns in figure.tables.quaternion_columns.T:
            qpos[columns] *= np.sign(qpos[columns] @ key.state[columns])
        np.testing.assert_allclose(qpos[key.fixed], key.state[key.fixed], atol=1e-12)


@pytest.mark.slow
def test_knees_and_elbows_bend_the_right_way(found):
    assert len(found.clip.context.bends) == 4
    flexion, sideways, twist = BendLimits(found.clip.context.bends).angles(found.all())
    assert flexion.min() > 0
    assert max(np.abs(sideways).max(), np.abs(twist).max()) <= SIDEWAYS


@pytest.mark.slow
def test_feet_at_rest_stay_down_and_in_their_places(found):
    stances = found.stances()
    assert len(stances) == found.promise.contacts
    for stance in stances:
        away = found.away(stance)
        assert np.abs(away[2]).max() <= LIFT
        assert np.linalg.norm(away[:2], axis=0).max() <= SLIDE


@pytest.mark.slow
def test_no_limb_goes_through_the_body(found):
    figure = found.clip.figure
    run = sampled(figure, found.motion.timeline, 60.0)
    deepest, where = self_penetration(figure.model, SelfContact.of(figure, 0.0).geom_pairs, run.time, run.qpos)
    assert deepest <= SELF, where


@pytest.mark.slow
def test_it_gets_where_it_is_to(found):
    first, last = found.motion.at([found.clip.keys[0].time, found.clip.keys[-1].time])
    assert (last - first)[[0, 2]] == pytest.approx([found.promise.travel, found.promise.climb], abs=0.01)


@pytest.mark.slow
@pytest.mark.parametrize("name", LOOPS)
def test_a_loop_goes_on_across_its_seam(name):
    motion = of(name).motion
    assert Seam.of(motion.figure, motion.timeline).apart(motion.path).max() < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("name", LOOPS)
def test_the_two_steps_of_a_loop_are_mirror_images(name):
    motion, promise = of(name).motion, PROMISES[name]
    figure, half = motion.figure, float(motion.timeline.times[-1]) / 2
    t = np.linspace(0, half, 40)
    ahead = promise.travel / 2 * np.eye(figure.width)[0]
    one, two = Mirror.of(figure).states(motion.at(t)) + ahead, motion.at(t + half)
    for columns in figure.tables.quaternion_columns.T:
        one[:, columns] *= np.sign(np.sum(one[:, columns] * two[:, columns], axis=1))[:, None]
    assert np.abs(one - two).max() < promise.mirrored


@pytest.mark.slow
def test_in_walking_a_foot_is_always_down_and_knees_and_pelvis_move_as_in_normal_gait():
    walk = of("walk_loop")
    samples = walk.all()
    places, _, _ = places_of(walk.clip.context.points, samples)
    assert places[2].min(axis=0).max() < 0.005
    flexion, _, _ = np.degrees(BendLimits(walk.clip.context.bends).angles(samples))
    knees = [i for i, bend in enumerate(walk.clip.context.bends) if "knee" in bend.name]
    assert len(knees) == 2
    for knee in flexion[knees]:
        assert 5 < knee.min() < 12
        assert 55 < knee.max() < 70
    assert 0.03 < np.ptp(samples.y[:, 2]) < 0.05


@pytest.mark.slow
def test_the_walk_turns_a_quarter_evenly_over_its_middle_steps_and_its_feet_land_turned_as_the_way_is():
    walk = of("walk_and_turn")
    t = walk.all().t
    heading = np.unwrap(heading_between(np.array([1.0, 0, 0, 0]), level(walk.motion.at(t)[:, 3:7])))
    about = np.degrees(heading)
    assert abs(about[0]) < 5
    assert abs(about[-1] - 90) < 5
    assert np.abs(about[t < 0.9]).max() < 15
    assert np.abs(about[t > 3.2] - 90).max() < 15
    assert np.ptp(np.gradient(about, t)) < 160  # degrees a second, the pelvis' own turn at every step included
    # it goes where it faces: along x at first, along y in the end
    places = walk.motion.at(np.array([0.0, 0.56, 3.36, 3.92]))[:, :2]
    first, last = places[1] - places[0], places[3] - places[2]
    assert first[0] > 0.55
    assert abs(first[1]) < 0.1
    assert last[1] > 0.55
    assert abs(last[0]) < 0.1


@pytest.mark.slow
def test_every_third_keyframe_of_the_turning_walk_tells_its_cycle():
    found = of("walk_and_turn").clip
    some = raw_timeline(found.figure, list(found.keys[::3]))
    rhythm = Gait(found.figure, some, found.context.points, found.context.surfaces).told()
    assert rhythm is not None
    assert rhythm.period == pytest.approx(1.12, rel=0.01)
    assert rhythm.slip < 0.15


def level(rotations: Array) -> Array:
    """The turns about the vertical in rotations (n, 4)."""
    about = rotations * np.array([1.0, 0, 0, 1])
    return about / np.linalg.norm(about, axis=1, keepdims=True)


UNHINDERED = {"tumble"}  # nothing is in its way: its raw spline breaks nothing and is only less smooth
# the toe of a foot that leaves the ground is turned inward by the keyframe that lifts it, while its contact lasts
KNOWN = {"walk_loop": [("left_toe", 5), ("left_toe", 6), ("right_toe", 2), ("right_toe", 9)]}


@pytest.mark.slow
@pytest.mark.parametrize("name", models.clips())
def test_nothing_is_wrong_with_a_clip_that_ships_but_what_is_known(name):
    found = of(name)
    told = problems(found.clip, found.motion.timeline, found.motion.raw, found.motion.stop)
    assert sorted((each.name, each.keyframe) for each in told) == KNOWN.get(name, []), [each.text for each in told]
    assert {each.kind for each in told} <= {"contact"}
    assert all(each.amount < 0.02 for each in told)
    raw = problems(found.clip, found.motion.raw, found.motion.raw)
    if name in UNHINDERED:
        assert not raw
        return
    assert len(raw) > len(told)
    assert raw[0].severity > 2


@pytest.mark.slow
@pytest.mark.parametrize("name", models.clips())
def test_no_clip_that_ships_ends_in_a_heap_or_begins_with_a_jerk(name):
    motion = of(name).motion
    assert not is_astray(motion.objective, motion.timeline, motion.trace[-1][3])
    raw = path_of(motion.raw)
    length, spacing = np.ptp(raw.span), np.ptp(raw.span) / (raw.spline.times.size - 1)
    for term, whole in zip(motion.objective.terms, motion.objective.integrals(raw), strict=True):
        if term.penalty.name in ("covariant", "root"):
            scale = term.penalty.normalization
            small = SMALL_SHARE * scale.reference * length / spacing**scale.time_power
            assert term.factor == pytest.approx(term.weight / max(whole, small), rel=1e-12)


@pytest.mark.slow
def test_the_stairs_are_climbed_foot_over_foot():
    """The heels stand on step after step in turn, and both on the last."""
    heels = [stance for stance in of("stairs").stances() if "heel" in stance.point.name]
    order = sorted(heels, key=lambda stance: stance.first)
    steps = [(stance.point.name.split("_")[0], round(stance.spot[2] / 0.17, 6)) for stance in order]
    assert list(dict.fromkeys(steps)) == [
        ("right", 0),
        ("left", 1),
        ("right", 2),
        ("left", 3),
        ("right", 4),
        ("left", 4),
    ]
