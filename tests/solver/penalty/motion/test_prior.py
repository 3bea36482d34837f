"""The prior meets keyframes, does not depend on place, heading and rest pose, and has no weight where it is unsure."""

from dataclasses import replace
from itertools import pairwise

import mujoco
import numpy as np
import pytest
import shipped
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.clip.build import Clip
from dynsplines.clip.context import person_of
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts.contact import Contact
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Prior
from dynsplines.solver.penalty.motion import people
from dynsplines.solver.penalty.motion.prior import Person
from dynsplines.solver.surface.points import Point


@pytest.fixture(scope="module")
def walk() -> Clip:
    """A walk with every fourth keyframe, 0.56 s apart."""
    clip = shipped.loaded("walk_and_turn")
    raw = clip.context.keys
    keys = timeline(raw, raw.times[::4], raw.states[::4])
    return replace(clip, context=replace(clip.context, schedule=replace(clip.context.schedule, keys=keys)))


def timeline(keys: Timeline, times: Array, states: Array) -> Timeline:
    return Timeline(tuple(map(Frame.key, times.tolist(), states)), keys.end_slope)


def prior_of(clip: Clip, keys: Timeline | None = None) -> Prior:
    person = clip.context.person
    assert person is not None
    return Prior.of(person, clip.context.keys if keys is None else keys, models.prior(), 0.0)


def walker(clip: Clip) -> Person:
    assert clip.context.person is not None
    return clip.context.person


def values(prior: Prior, states: Array) -> Array:
    return states[:, np.concatenate([prior.positions, prior.quaternions.ravel()])]


def up_to_sign(a: Array, b: Array, atol: float) -> None:
    np.testing.assert_allclose(a[..., :3], b[..., :3], atol=atol)
    p, q = (x[..., 3:].reshape(*x.shape[:-1], -1, 4) for x in (a, b))
    np.testing.assert_allclose(np.abs(np.sum(p * q, axis=-1)), 1, atol=atol)


def test_the_prediction_meets_the_keyframes(walk: Clip) -> None:
    prior, keys = prior_of(walk), walk.context.keys
    for at, states in ((0, keys.states[:-1]), (-1, keys.states[1:])):
        up_to_sign(prior.predicted[:, at], values(prior, states), atol=1e-9)
    assert np.all(prior.weights >= 0)
    assert np.any(prior.weights > 0)


@pytest.mark.parametrize("phase", [0, 12, 16.5, 32])
def test_the_value_is_zero_along_the_prediction(walk: Clip, phase: float) -> None:
    """Between phases, along the line between the predictions, with quaternions of unit length."""
    prior, figure = prior_of(walk), walk.figure
    times = prior.times[:-1] + np.diff(prior.times) * phase / (prior.predicted.shape[1] - 1)
    expected = (prior.predicted[:, int(np.floor(phase))] + prior.predicted[:, int(np.ceil(phase))]) / 2
    rotations = quat.normalise(expected[:, 3:].reshape(-1, 12, 4)).reshape(-1, 48)
    states = walk.context.keys.states[:-1].copy()
    states[:, prior.positions], states[:, prior.quaternions.ravel()] = expected[:, :3], rotations
    np.testing.assert_allclose(prior.evaluate(Samples.still(figure, states, times)), 0, atol=1e-12)


def test_keyframes_moved_and_turned_about_the_vertical_have_the_same_prediction(walk: Clip) -> None:
    person, keys = walker(walk), walk.context.keys
    turn, shift = quat.from_rotation_vector(np.array([0, 0, 2.0])), np.array([3.0, -1, 0])
    states = keys.states.copy()
    states[:, person.position] = quat.rotate(turn, states[:, person.position]) + shift
    states[:, person.quaternions] = quat.product(turn, states[:, person.quaternions])
    prior, moved = prior_of(walk), prior_of(walk, timeline(keys, keys.times, states))
    expected = prior.predicted.copy()
    expected[..., :3] = quat.rotate(turn, expected[..., :3]) + shift
    rotations = expected[..., 3:].reshape(*expected.shape[:2], 12, 4)
    expected[..., 3:] = quat.product(turn, rotations).reshape(*expected.shape[:2], 48)
    up_to_sign(moved.predicted, expected, atol=1e-8)
    np.testing.assert_allclose(moved.weights, prior.weights, rtol=1e-6)


def test_the_height_of_keyframes_matters_only_over_known_ground(walk: Clip) -> None:
    person, keys = walker(walk), walk.context.keys
    shift = np.zeros(51)
    shift[2] = 0.2
    states = keys.states.copy()
    states[:, person.position] += shift[:3]
    lifted = timeline(keys, keys.times, states)
    for ground, same in ((None, True), (0.0, False)):
        one, other = (Prior.of(person, each, models.prior(), ground).predicted for each in (keys, lifted))
        assert np.allclose(other, one + shift, atol=1e-9) == same


def test_mirrored_keyframes_have_the_mirrored_prediction(walk: Clip) -> None:
    person, keys = walker(walk), walk.context.keys
    other = people.MIRRORED
    states = keys.states.copy()
    states[:, person.position] *= people.SIDES
    states[:, person.quaternions] = states[:, person.quaternions[other]] * [1, -1, 1, -1]
    prior, mirrored = prior_of(walk), prior_of(walk, timeline(keys, keys.times, states))
    expected = prior.predicted.copy()
    expected[..., :3] *= people.SIDES
    rotations = expected[..., 3:].reshape(*expected.shape[:2], 12, 4)[:, :, other] * [1, -1, 1, -1]
    expected[..., 3:] = rotations.reshape(*expected.shape[:2], 48)
    up_to_sign(mirrored.predicted, expected, atol=1e-8)


def test_a_figure_that_rests_with_raised_arms_has_the_same_posture(walk: Clip) -> None:
    """Orientations of parts do not depend on the model's rest pose."""
    spec = mujoco.MjSpec.from_string(models.figure_text("human"))
    for side, angle in (("left", 90), ("right", -90)):
        spec.body(f"{side}_upper_arm").quat = Rotation.from_euler("x", angle, degrees=True).as_quat(scalar_first=True)
    raised = Figure(spec.compile())
    hanging = Figure(mujoco.MjModel.from_xml_string(models.figure_text("human")))
    people = person_of(raised, walk.context.points), person_of(hanging, walk.context.points)
    qpos = hanging.model.qpos0[None].copy()
    down = hanging.to_state(qpos)
    for side, angle in (("left", -90), ("right", 90)):
        joint = raised.model.joint(f"{side}_shoulder")
        qpos[:, joint.qposadr[0] : joint.qposadr[0] + 4] = Rotation.from_euler("x", angle, degrees=True).as_quat(
            scalar_first=True
        )
    for found, expected in zip(
        people[0].posture(raised.to_state(qpos), 0.0), people[1].posture(down, 0.0), strict=True
    ):
        np.testing.assert_allclose(found, expected, atol=1e-6)
    np.testing.assert_allclose(people[0].offsets, people[1].offsets, atol=1e-6)


def test_trust_is_zero_between_keyframes_close_in_time_or_very_far_apart(walk: Clip) -> None:
    keys = walk.context.keys
    spans = np.resize([0.1, 0.6, 0.19, 1.0, 3.0], keys.times.size - 1)
    prior = prior_of(walk, timeline(keys, np.append(0, np.cumsum(spans)), keys.states))
    trusted = prior.weights.max(axis=1) > 0
    np.testing.assert_array_equal(trusted, (spans > 0.2) & (spans < 2.5))


def test_an_arm_has_no_weight_before_during_and_after_a_contact_of_its_hand(walk: Clip) -> None:
    person, keys, prior = walker(walk), walk.context.keys, prior_of(walk)
    contacts = [
        Contact(Point(part, int(person.links[people.PARTS.index(part)]), np.zeros(3)), *keys.times[[2, 3]].tolist())
        for part in ("left_forearm", "right_foot")
    ]
    expected = prior.weights.copy()
    arm = [people.PARTS.index(part) for part in ("left_upper_arm", "left_forearm")]
    expected[1:4, 3:].reshape(3, 12, 4)[:, arm] = 0
    touching = Prior.of(person, keys, models.prior(), 0.0, contacts=contacts)
    assert np.all(prior.weights[1:4, 3:].reshape(3, 12, 4)[:, arm] > 0)
    np.testing.assert_array_equal(touching.weights, expected)


def test_a_loop_is_predicted_across_its_seam(walk: Clip) -> None:
    """A loop has the same prediction as in the middle of its repetitions."""
    loop = shipped.loaded("walk_loop")
    keys, person = loop.context.keys, walker(loop)
    assert keys.ends == "periodic"
    length = keys.times[-1] - keys.times[0]
    repeated = np.concatenate([keys.states[:-1] + k * (keys.states[-1] - keys.states[0]) for k in range(3)])
    turned = repeated.copy()
    turned[:, person.quaternions.ravel()] = np.tile(keys.states[:-1], (3, 1))[:, person.quaternions.ravel()]
    times = np.concatenate([keys.times[:-1] + k * length for k in range(3)])
    count = keys.times.size - 1
    once, thrice = prior_of(loop), prior_of(loop, timeline(keys, times, turned))
    shift = np.zeros(51)
    shift[:3] = (keys.states[-1] - keys.states[0])[person.position]
    up_to_sign(once.predicted + shift, thrice.predicted[count : 2 * count], atol=1e-6)


def test_a_figure_that_lacks_a_part_or_lies_is_no_person() -> None:
    unknown, lying = (mujoco.MjSpec.from_string(models.figure_text("human")) for _ in range(2))
    unknown.body("left_foot").name = "left_thing"
    lying.body("pelvis").quat = Rotation.from_euler("y", 90, degrees=True).as_quat(scalar_first=True)
    for spec, reason in ((unknown, "no body has a name of these parts: left foot"), (lying, "does not stand")):
        with pytest.raises(ValueError, match=reason):
            person_of(Figure(spec.compile()))


def symmetric(rng: np.random.Generator) -> Array:
    """Outputs of a network that are the same for the mirror image, (13, OUTPUTS)."""
    outputs, other = 0.1 * rng.normal(size=(13, people.OUTPUTS)), [*people.MIRRORED, 12]
    images = outputs[other].copy()
    images[:, : 3 * people.MODES] *= np.tile(people.SIDES, people.MODES) * np.where(np.arange(13) < 12, -1, 1)[:, None]
    return (outputs + images) / 2


def constant(outputs: Array, **more: Array) -> people.Weights:
    """A network with the same outputs for all inputs."""
    inputs = models.prior()[0]["mean"].size
    return {
        "mean": np.zeros(()),
        "std": np.ones(()),
        "0": np.zeros((outputs.size, inputs)),
        "0.bias": outputs.ravel(),
        **more,
    }


def random_segments(rng: np.random.Generator) -> people.Segments:
    return people.Segments(
        rng.normal(size=(3, 4, 3)), quat.normalise(rng.normal(size=(3, 4, 12, 4))), rng.normal(size=(3, 12, 3)),
        rng.normal(size=(3, 4, 3)), rng.uniform(0.3, 1, (3, 3)), np.array([[True, True], [False, True], [True, False]]),
        np.ones((3, 4), bool), np.ones(3, bool),
    )  # fmt: skip


def tangents(gaps: Array, steps: Array, is_known: Array) -> Array:
    """By how much the parabolas through three points each are steeper in the middle one than the line between the
    second and the third of four, times its duration: (2, 3) of three steps (3, 3)."""
    times = np.concatenate([[0.0], np.cumsum(gaps)])
    points = np.concatenate([np.zeros((1, 3)), np.cumsum(steps, axis=0)])
    out = np.zeros((2, 3))
    for end in np.flatnonzero(is_known):
        parabola = np.polynomial.polynomial.polyfit(times[end : end + 3] - times[end + 1], points[end : end + 3], 2)
        out[end] = gaps[1] * parabola[1] - steps[1]
    return out


def test_predicted_poses_are_interpolated_with_sines_and_shares_of_tangents(rng: np.random.Generator) -> None:
    """By SciPy's rotations and cubics. All of it is smaller for a part that hardly moves."""
    segments, outputs, phases = random_segments(rng), symmetric(rng), np.array([0.0, 0.2, 0.5, 0.9])
    found = people.Prediction.of([constant(outputs)], segments, np.tile(phases, (3, 1)))
    cubics = CubicHermiteSpline([0, 1], np.zeros((2, 2)), np.eye(2))(phases)
    changes = np.zeros((3, 13))
    for b, part in np.ndindex(3, 13):
        turns = [Rotation.from_quat(q, scalar_first=True) for q in segments.turns[b, :, part % 12]]
        if part < 12:
            steps = np.array([(one.inv() * other).as_rotvec() for one, other in pairwise(turns)])
        else:
            steps = np.diff(segments.hips[b], axis=0)
        heading = Rotation.from_quat(segments.heading[b], scalar_first=True)
        shares = 1 / (1 + np.exp(-outputs[part, -3:-1]))
        waves = np.array([np.sin(np.pi * mode * phases) for mode in range(1, people.MODES + 1)]).T
        waves = waves @ outputs[part, : 3 * people.MODES].reshape(-1, 3)
        waves = heading.apply(waves) if part == 12 else waves
        away = waves + cubics @ (shares[:, None] * tangents(segments.gaps[b], steps, segments.is_known[b]))
        away *= steps[1] @ steps[1] / (steps[1] @ steps[1] + people.HELD**2)
        changes[b, part] = np.mean(np.sum(away**2, axis=1))
        linear = np.outer(phases, steps[1])
        if part == 12:
            np.testing.assert_allclose(found.hips[b], segments.hips[b, 1] + linear + away, atol=1e-12)
            continue
        expected = turns[1] * Rotation.from_rotvec(linear) * Rotation.from_rotvec(away)
        actual = Rotation.from_quat(found.turns[b, :, part], scalar_first=True)
        np.testing.assert_allclose((expected.inv() * actual).magnitude(), 0, atol=1e-9)
    np.testing.assert_allclose(found.changes, changes, rtol=1e-9)
    np.testing.assert_allclose(found.apart, 0, atol=1e-20)
    np.testing.assert_allclose(found.expected, np.tile(np.exp(outputs[:, -1]), (3, 1)), rtol=1e-12)
