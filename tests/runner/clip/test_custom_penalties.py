"""Soft constraints of a program's own: they take part, are checked, and are never lost in silence."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from rekeyed import with_keys
from tiny import written

from dynsplines import Clip, Keyframe, Motion, UserError, build, inbetween, load, load_motion
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.figure.wrenches import Wrenches, every_axis
from dynsplines.solver.penalty import Block, Normalization, Penalty


@dataclass(frozen=True)
class Calm(Penalty):
    """The squared speed of all bodies' origins."""

    called: str = "calm"

    @property
    def name(self) -> str:
        return self.called

    @property
    def normalization(self) -> Normalization:
        return Normalization(1.0, time_power=2)

    def residuals(self, samples: Samples) -> Iterator[Block]:
        links = np.arange(1, len(samples.figure.links))
        at, link, axes = every_axis(links, samples.count)
        yield Block(at, samples.links.x_d[:, links].ravel(), (Wrenches(at, link, force_d=axes),))


def swing(**more: object) -> Clip:
    poses = [np.array([0, 0, z, 1, 0, 0, 0.0]) for z in (1.0, 1.6, 1.0)]
    keys = [Keyframe(float(i), qpos=pose) for i, pose in enumerate(poses)]
    return build("spinner", keys, solve={"evaluations": 20}, **more)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def calm() -> Motion:
    return inbetween(swing(custom_penalties=[(Calm(), 30.0)]))


def speed(motion: Motion) -> float:
    velocity = motion.sampled(200).qvel[:, :3]
    return float(np.mean(np.sum(velocity**2, axis=1)))


def test_it_takes_part_in_the_search(calm: Motion) -> None:
    assert calm.clip.penalties[-1][0].name == "calm"
    assert calm.clip.custom_penalties == ((Calm(), 30.0),)
    assert speed(calm) < 0.99 * speed(inbetween(swing()))


def test_load_takes_it_too_and_other_keyframes_keep_it(tmp_path: Path) -> None:
    clip = load(written(tmp_path), custom_penalties=[(Calm(), 0.1)])
    assert [penalty.name for penalty, _ in clip.penalties][-1] == "calm"
    again = with_keys(clip, clip.keys)
    assert again.custom_penalties == clip.custom_penalties and again.penalties[-1] == (Calm(), 0.1)
    assert swing(custom_penalties=[(Calm(), 0)]).custom_penalties == ()


@pytest.mark.parametrize(
    ("custom_penalties", "says"),
    [
        ([Calm()], "every entry is (penalty, weight)"),
        ([(Calm(), "much")], "the weight of 'calm' is a number from 0 on, not 'much'"),
        ([(Calm("torque"), 1.0)], "called 'torque' already exists"),
        ([(Calm(), 1.0), (Calm(), 2.0)], "called 'calm' already exists"),
    ],
)
def test_what_is_none_is_refused(custom_penalties: object, says: str) -> None:
    with pytest.raises(UserError) as error:
        swing(custom_penalties=custom_penalties)
    assert says in str(error.value)


def test_saving_and_loading_warn_that_no_file_holds_it(calm: Motion, tmp_path: Path) -> None:
    for name in ("up.npz", "up.toml"):
        not_stored = "custom penalties are not stored: calm; pass them again as custom_penalties="
        with pytest.warns(UserWarning, match=not_stored):
            calm.save(tmp_path / name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = load_motion(tmp_path / "up.npz")
        np.testing.assert_array_equal(found.at(0.7), calm.at(0.7))
    with pytest.warns(UserWarning, match="also had the custom penalty 'calm'"):
        clip = found.clip
    assert clip.custom_penalties == ()
