"""The soft constraint `prior` in clips: which figures have it, exact keyframes, and the shipped networks."""

import hashlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from texts import read_data

from dynsplines import Keyframe, build, inbetween, models
from dynsplines.clip.build import Clip
from dynsplines.clip.context import note_on
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Prior

MODELS = Path(models.__file__).parent
POSES = {
    "left_shoulder": {"rotvec": [0, -40, 0]},
    "right_hip": {"rotvec": [0, -50, 0]},
    "right_knee": {"rotvec": [0, 60, 0]},
}


STEP = {"left_hip": {"rotvec": [0, -50, 0]}, "left_knee": {"rotvec": [0, 60, 0]}}


def of(figure: str, span: float = 0.7, **more: Any) -> Clip:
    """A figure that moves from one pose to another of its legs."""
    poses = (STEP, POSES) if figure == "human" else ({"left_hip_pitch": -1.0}, {"right_hip_pitch": -1.0})
    keyframes = [Keyframe(t, joints=pose, others="rest") for t, pose in zip((0, span), poses, strict=True)]
    return build(figure, keyframes, **more)


def priors(clip: Clip) -> list[tuple[Prior, float]]:
    return [(penalty, weight) for penalty, weight in clip.penalties if isinstance(penalty, Prior)]


def written(tmp_path: Path, name: str) -> str:
    (tmp_path / name).write_text(read_data(name), encoding="utf-8")
    return str(tmp_path / name)


def test_it_is_on_for_people_unless_keyframes_are_close_or_leave_the_place_of_the_pelvis_free():
    assert priors(of("human"))[0][1] == 1
    assert priors(of("human", penalties={"prior": 2}))[0][1] == 2
    assert not priors(of("human", penalties={"prior": 0}))
    assert not priors(of("human", span=0.15))
    anywhere = [
        Keyframe(t, joints=pose, root={"position": "free"}, others="rest") for t, pose in ((0, STEP), (0.7, POSES))
    ]
    assert not priors(build("human", anywhere))


def test_it_is_off_for_robots_unless_listed_and_moves_their_hinges(tmp_path):
    robot = written(tmp_path, "android.xml")
    assert not priors(of(robot))
    listed = of(robot, penalties={"prior": 4})
    ((prior, _),) = priors(listed)
    samples = Samples.still(listed.figure, listed.context.keys.states, listed.context.keys.times)
    np.testing.assert_allclose(prior.evaluate(samples), 0, atol=1e-9)
    assert note_on(robot) == "; on if listed, as the figure has hinges"
    assert note_on("human") == ""


def test_a_figure_whose_keyframes_are_alike_stays_as_it_is():
    assert not priors(build("human", [Keyframe(t, others="rest") for t in (0, 0.6, 1.2)], penalties={"prior": 1}))


def test_a_figure_without_all_parts_has_none_and_a_note_says_so(tmp_path):
    beast = written(tmp_path, "quadruped.xml")
    clip = build(beast, [Keyframe(t, others="rest") for t in (0, 0.7)], penalties={"prior": 4})
    assert not priors(clip)
    assert any(note.startswith("penalty 'prior' has no effect in this clip") for note in clip.notes)
    assert "no body has a name of these parts: " in note_on(beast)


@pytest.mark.slow
def test_keyframes_stay_exact_and_the_motion_approaches_the_prediction():
    clip, plain = (of("human", penalties={"prior": weight}, solve={"evaluations": 3}) for weight in (1, 0))
    ((prior, _),) = priors(clip)
    with_prior, without = inbetween(clip), inbetween(plain)
    np.testing.assert_allclose(
        with_prior.at(clip.context.keys.times), without.at(clip.context.keys.times), rtol=0, atol=1e-9
    )
    times = np.linspace(prior.times[0], prior.times[-1], 50)
    costs = [
        prior.evaluate(Samples.still(clip.figure, clip.figure.to_state(motion.at(times)), times)).mean()
        for motion in (with_prior, without)
    ]
    assert costs[0] < costs[1]


def test_the_shipped_networks_are_those_of_their_card():
    content = (MODELS / "prior.npz").read_bytes()
    assert len(content) <= 2e6
    assert hashlib.sha256(content).hexdigest() in (MODELS / "prior.md").read_text(encoding="utf-8")
    assert len(models.prior()) == 2
