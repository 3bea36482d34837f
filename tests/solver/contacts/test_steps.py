"""Steps: which joints place a foot."""

from pathlib import Path

import mujoco
import pytest
import walkers

from dynsplines import Keyframe, build, load
from dynsplines.clip.build import Clip


def placing(clip: Clip) -> set[str]:
    """The names of the links whose joints place a foot."""
    steps = clip.context.schedule.steps
    return {link.name for link, places in zip(clip.figure.links, steps.placing.tolist(), strict=True) if places}


def test_hips_and_knees_of_a_person_place_a_foot():
    assert placing(load("run_and_step")) == {"left_hip", "right_hip", "left_knee", "right_knee"}


@pytest.mark.parametrize(
    ("text", "others"),
    [(walkers.BIPED, "_ankle_roll"), (walkers.QUADRUPED, "trunk")],
    ids=["feet with several points", "feet that are points"],
)
def test_every_joint_of_a_leg_places_a_foot_unless_it_only_turns_one(text: str, others: str, tmp_path: Path):
    (tmp_path / "walker.xml").write_text(text, encoding="utf-8")
    model = mujoco.MjModel.from_xml_string(text)
    clip = build(str(tmp_path / "walker.xml"), [Keyframe(t, qpos=model.qpos0) for t in (0.0, 1.0)])
    elsewhere = ("world", "root", "waist", "shoulder", "elbow", others)
    expected = {link.name for link in clip.figure.links if not any(part in link.name for part in elsewhere)}
    assert placing(clip) == expected and len(expected) >= 10
