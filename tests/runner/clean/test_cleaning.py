"""Cleaning a run that ships, made bad: soles stand still on the ground, and the motion is nearer to the true one."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shipped
from motions import Take, kneeling
from paper.penetration import penetration
from processes import quiet
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.clean import cleaning
from dynsplines.clean.cleaning import Cleaned
from dynsplines.clean.repairs import outliers, repair
from dynsplines.clip.load import figure_of
from dynsplines.clip.tracking.problem import tracking_context
from dynsplines.errors import UserError
from dynsplines.exchange.recording import Recording
from dynsplines.motion import even_times, samples_at
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact
from dynsplines.solver.curve.recording import Track
from dynsplines.solver.curve.spline import Path
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import JointRange, Support, joint_ranges
from dynsplines.solver.penalty.motion.acceleration import relative_accelerations
from dynsplines.solver.problem import Improvement
from dynsplines.solver.surface.heights import height_over
from dynsplines.solver.surface.points import places_of

FPS = 60.0

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def take() -> Take:
    """The first 1.3 s, which is quick to clean."""
    return first_samples(Take.of(shipped.solved("run_and_step"), FPS), 80)


@pytest.fixture(scope="module")
def bad() -> Array:
    """With noise, while it slides and sinks."""
    whole, rng = Take.of(shipped.solved("run_and_step"), FPS), np.random.default_rng(11)
    return whole.shaking(whole.sliding(rng), rng, 0.005, np.radians(1.0))[:80]


@pytest.fixture(scope="module")
def clean(take: Take, bad: Array) -> Cleaned:
    return cleaned_of(take, bad)


def first_samples(take: Take, count: int) -> Take:
    return Take(take.figure, take.time[:count], take.qpos[:count])


def cleaned_of(take: Take, qpos: Array, rests: Sequence[Contact] | None = None, **options: Any) -> Cleaned:
    figure, (repaired, known) = take.figure, repair(take.figure, Recording(take.time, qpos, name="recording"))
    context = tracking_context(figure, repaired.time, figure.to_state(repaired.qpos), "recording")
    return cleaning.clean(context, {}, repaired, known, rests, **options)


def ankle_error(take: Take, found: Cleaned) -> Array:
    """The angles between the true and the cleaned ankles (2, T) [degrees]."""
    figure, qpos = take.figure, take.figure.to_qpos(found.after.at(take.time))
    feet = [figure.links[int(figure.body_link[figure.model.body(name).id])] for name in ("left_foot", "right_foot")]
    cosine = np.array([np.abs(np.sum((take.qpos * qpos)[:, quaternion_columns(foot)], axis=1)) for foot in feet])
    return np.degrees(2 * np.arccos(np.minimum(cosine, 1)))


def slip(figure: Figure, path: Path, rest: Contact) -> float:
    """The largest distance [m] of a resting point from its mean position, without the part of rolling."""
    samples = samples_at(figure, path, np.linspace(rest.first, rest.last, 100))
    rotation = samples.links.Q[:, rest.point.link]
    rolling = replace(rest, start=rotation[:, samples.count // 2])
    places = places_of((rest.point,), samples)[0][:, 0] - rolling.roll(rotation)
    return float(np.linalg.norm(places - places.mean(axis=1, keepdims=True), axis=0).max())


def measured(clean: Cleaned, path: Path) -> dict[str, float]:
    """Slip [m], height in stances [m], acceleration [rad/s²], jerk [m/s³] and unsupported force [weights]."""
    figure = clean.figure
    samples = samples_at(figure, path, even_times(path.span, 120))
    heights = [
        height_over(
            clean.context.surfaces if rest.surface is None else (rest.surface,), *places_of((rest.point,), still)
        )[0]
        for rest in clean.rests
        for still in [samples_at(figure, path, np.linspace(rest.first, rest.last, 50))]
    ]
    support = next(penalty for penalty, _ in clean.problem.penalties if isinstance(penalty, Support))
    force = support.rest(samples)[:3][:, support.is_known(samples.t)]
    return {
        "slip": max(slip(figure, path, rest) for rest in clean.rests),
        "height": max(float(height.max()) for height in heights),
        "range": float(np.sqrt(JointRange(joint_ranges(figure)).evaluate(samples).max())),
        "acceleration": float(relative_accelerations(samples)[1].max()),
        "jerk": float(np.linalg.norm(np.diff(samples.links.x[:, 1:], 3, axis=2), axis=0).mean()),
        "force": float(np.linalg.norm(force, axis=0).mean()),
    }


def test_an_interrupt_of_a_search_that_only_prepares_ends_the_cleaning(take, bad):
    def interrupt(_: Improvement) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        cleaned_of(take, bad, improved=interrupt)


def test_soles_stand_still_on_the_ground_and_nothing_shakes(clean):
    before, after = measured(clean, clean.before), measured(clean, clean.after)
    assert before["slip"] > 0.01
    assert after["slip"] < 0.005
    assert after["height"] < 0.005
    assert after["range"] < np.radians(1)
    for name, share in (("acceleration", 0.3), ("jerk", 0.1), ("force", 0.4)):
        assert after[name] < share * before[name]


def test_nothing_of_the_figure_is_deep_in_the_ground(clean):
    """By MuJoCo's own distances, all geoms looked at."""
    first, last = clean.after.span
    times = np.linspace(first, last, 200)
    found = [
        penetration(clean.figure.model, times, clean.figure.to_qpos(p.at(times))) for p in (clean.before, clean.after)
    ]
    assert found[0].deepest > 0.02
    assert found[1].deepest < 0.003, found[1].worst()


def test_a_recording_without_faults_hardly_changes():
    """Heels land before toes, and leave the ground before them: no stance begins too early or ends too late."""
    take = first_samples(Take.of(shipped.solved("stairs"), 100), 150)
    after = cleaned_of(take, take.qpos).after
    links = [Samples.still(take.figure, s).links for s in (take.figure.to_state(take.qpos), after.at(take.time))]
    assert np.linalg.norm(links[0].x - links[1].x, axis=0).max() < 0.012
    turned = [each.rotation for each in links]
    cosine = 0.5 * (np.einsum("ijlt,ijlt->lt", *turned) - 1)
    assert np.degrees(np.arccos(np.clip(cosine, -1, 1))).max() < 4


def test_a_foot_lands_and_lifts_as_recorded():
    """Ankles are off by 3° (root mean square) if a first search holds the ends of the stances that it infers from
    noise."""
    take = first_samples(Take.of(shipped.solved("walk_and_turn"), 100), 150)
    bad = take.shaking(take.qpos, np.random.default_rng(9), 0.005, np.radians(0.7))
    assert np.sqrt(np.mean(ankle_error(take, cleaned_of(take, bad)) ** 2)) < 2.3


def test_a_foot_that_lifts_at_once_has_no_stance():
    """A stance of 0.1 s, inferred from noise, turns its ankle by 7 to 16° off the truth."""
    take = Take.of(solving.solve(recordings.from_text(read_data("side_step.toml"), name="c"), quiet()), 100)
    bad = take.shaking(take.qpos, np.random.default_rng(3), 0.004, np.radians(0.6))
    assert ankle_error(take, cleaned_of(take, bad)).max() < 6


def test_who_kneels_keeps_the_heel_in_the_air():
    """No link is off the truth by more than 3 cm; a heel held down is off by 9. Most of the noise is gone."""
    take = kneeling(FPS, np.radians(11))
    bad = take.shaking(take.qpos, np.random.default_rng(1), 0.004, np.radians(0.6))
    found = cleaned_of(take, bad)
    states = (take.figure.to_state(take.qpos), found.after.at(take.time), take.figure.to_state(bad))
    true, after, before = (Samples.still(take.figure, each).links.x for each in states)
    off, was = (np.linalg.norm(each - true, axis=0) for each in (after, before))
    assert off.max() < 0.03
    assert np.sqrt(np.mean(off**2)) < 0.5 * np.sqrt(np.mean(was**2))
    assert {rest.point.name for rest in found.raised} == {"right_heel"}


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


def mended(time: np.ndarray, qpos: np.ndarray) -> tuple[Recording, np.ndarray]:
    return repair(FIGURE, Recording(time, qpos, name="walk.csv"))


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
        ("3 samples of 'left_elbow' hold no numbers, at 0.333-0.400 s: interpolated",)),
    "a quaternion of zeros": (
        TIMES, changed(20, JOINT, 0), [20], JOINT,
        ("1 samples of 'left_elbow' hold no numbers, at 0.667 s: interpolated",)),
    "missing": (
        TIMES[MISSING], motion()[MISSING], slice(30, 40), slice(None),
        ("gap from 0.967 to 1.333 s: interpolated",)),
    "a sample off": (
        TIMES, changed(25, 2, motion()[25, 2] + 0.3), [25], slice(0, 3),
        ("'root': 1 samples jump, at 0.833 s: interpolated",)),
    "two samples off": (
        TIMES, changed([25, 40], 2, motion()[[25, 40], 2] + 0.3), [25, 40], slice(0, 3),
        ("'root': 2 samples jump, at 0.833, 1.333 s: interpolated",)),
    "a pose at the start": (
        np.arange(-1, 60) / 30, np.vstack([POSE, motion()]), (), (), (STARTS.format(0),)),
    "a pose held at the start": (
        np.arange(-9, 60) / 30, np.vstack([*9 * [POSE], motion()]), (), (), (STARTS.format(0),)),
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_reported_and_repaired_and_nothing_else_changes(fault):
    time, qpos, rows, columns, notes = FAULTS[fault]
    (found, was_known), known = mended(time, qpos.copy()), np.ones((60, FIGURE.width), bool)
    if columns != ():
        known[rows, columns] = False
    assert found.notes == notes
    np.testing.assert_allclose(found.time, TIMES, atol=1e-9)
    np.testing.assert_array_equal(was_known, known)
    assert np.isfinite(found.qpos).all()
    same = found.qpos[known], motion()[known]
    np.testing.assert_allclose(np.abs(same[0]), np.abs(same[1]), atol=1e-12)


def test_successive_samples_far_from_the_smoothed_recording_are_named():
    recorded, _ = mended(TIMES, changed([25, 26], 2, motion()[25:27, 2] + 0.3))
    assert recorded.notes == ()
    (note,) = outliers(Track.of(FIGURE, recorded.time, recorded.qpos))
    assert re.fullmatch(r"'root': smoothing changes samples by up to \d+ mm, at 0\.8[0-9. ,-]+ s", note), note
    assert not list(outliers(Track.of(FIGURE, TIMES, motion())))


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
