"""The prior meets keyframes, does not depend on place, heading and rest pose, and has no weight where it is unsure."""

from __future__ import annotations

from dataclasses import replace

import mujoco
import numpy as np
import pytest
import shipped
from scipy.spatial.transform import Rotation

from dynsplines import models
from dynsplines.clip.build import Clip
from dynsplines.clip.person import person_of
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Prior
from dynsplines.solver.penalty.motion import people
from dynsplines.solver.penalty.motion.prior import Person


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
    rotations = quat.normalised(expected[:, 3:].reshape(-1, 12, 4)).reshape(-1, 48)
    states = walk.context.keys.states[:-1].copy()
    states[:, prior.positions], states[:, prior.quaternions.ravel()] = expected[:, :3], rotations
    np.testing.assert_allclose(prior.evaluate(Samples.still(figure, states, times)), 0, atol=1e-12)


def test_keyframes_moved_and_turned_about_the_vertical_have_the_same_prediction(walk: Clip) -> None:
    person, keys = walker(walk), walk.context.keys
    turn, shift = quat.from_rotation_vector(np.array([0, 0, 2.0])), np.array([3.0, -1, 0])
    states = keys.states.copy()
    states[:, person.position] = quat.rotated(turn, states[:, person.position]) + shift
    states[:, person.quaternions] = quat.product(turn, states[:, person.quaternions])
    prior, moved = prior_of(walk), prior_of(walk, timeline(keys, keys.times, states))
    expected = prior.predicted.copy()
    expected[..., :3] = quat.rotated(turn, expected[..., :3]) + shift
    rotations = expected[..., 3:].reshape(*expected.shape[:2], 12, 4)
    expected[..., 3:] = quat.product(turn, rotations).reshape(*expected.shape[:2], 48)
    up_to_sign(moved.predicted, expected, atol=1e-8)
    np.testing.assert_allclose(moved.weights, prior.weights, rtol=1e-6)


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
