"""A mirrored clip means the mirrored motion, whatever frames the figure's bodies have and whatever they are called."""

import re

import mujoco
import numpy as np
import pytest
from figures import biped, scene
from oracles import kinematics
from texts import read_data

from dynsplines import recordings
from dynsplines.clip import load as clips
from dynsplines.clip.mirror import figure_mirror, mirrored_tables
from dynsplines.clip.parse import parse, table_of
from dynsplines.clip.text import text_of
from dynsplines.errors import UserError
from dynsplines.solver.curve.mirror import Mirror

TURNED = read_data("turned_frames.xml")


def figure(text: str = TURNED) -> mujoco.MjSpec:
    return mujoco.MjSpec.from_string(text)


CLIP = read_data("turned_frames.toml")


def test_rotations_of_turned_frames_are_those_of_the_mirrored_motion():
    spec = figure()
    spec.joint("ankle_2").ref = 0.2  # [rad] whose angle at rest is not that of its partner
    clip = recordings.from_text(CLIP, name="one", spec=spec.copy())
    mirror = figure_mirror(clip.figure, table_of(CLIP, "one"), "one")
    names = [link.name for link in clip.figure.links]
    assert names[mirror.partner[names.index("swing_1")]] == "swing_2"
    text = text_of(mirrored_tables(table_of(CLIP, "one"), clip.figure, mirror))
    image = recordings.from_text(text, name="two", spec=spec.copy())
    model = clip.figure.model
    pairs = [model.body(name).id for name in ("pelvis", "waist", "hip_1", "foot_1", "hip_2", "foot_2")]
    there = [model.body(name).id for name in ("pelvis", "waist", "hip_2", "foot_2", "hip_1", "foot_1")]
    for one, two in zip(clip.keys, image.keys, strict=True):
        before, after = (kinematics(model, key.state) for key in (one, two))
        np.testing.assert_allclose(after.xpos[there], before.xpos[pairs] * [1, -1, 1], atol=2e-4)  # digits in the model
        for name, other in (("toe_1", "toe_2"), ("toe_2", "toe_1"), ("badge", "badge")):
            np.testing.assert_allclose(after.site(other).xpos, before.site(name).xpos * [1, -1, 1], atol=2e-4)
        np.testing.assert_array_equal(one.fixed.all(), two.fixed.all())


def test_bodies_are_exchanged_by_their_joints_and_sites_by_pairs():
    row = """figure = "turned.xml"
[mirror]
pairs = [["swing_1", "swing_2"], ["ankle_1", "ankle_2"], ["toe_1", "toe_2"]]
[[keyframe]]
time = 0
others = "rest"
[[keyframe]]
time = 1
others = "previous"
sites = {toe_1 = [0.3, 0.1, 0.4], badge = [0.1, 0.0, 0.8]}
bodies.foot_2 = {rotvec = [0, 20, 0]}
"""
    clip = clips.from_parsed(parse(row, "one", "one.toml"), spec=figure(), unmet=[])
    mirror = figure_mirror(clip.figure, table_of(row, "one"), "one")
    (_, last) = mirrored_tables(table_of(row, "one"), clip.figure, mirror).keyframe
    assert last.sites == {"toe_2": (0.3, -0.1, 0.4), "badge": (0.1, 0.0, 0.8)}
    assert list(last.bodies) == ["foot_1"]


def test_corners_of_soles_are_exchanged_by_their_places_and_not_by_their_numbers():
    text = 'figure = "biped.xml"\n[[contact]]\npoint = "left_foot 1"\nfrom = 0\nto = 1\n'
    text += "".join(f"[[keyframe]]\ntime = {time}\nothers = 'rest'\n" for time in (0, 1))
    clip = recordings.from_text(text, name="one", spec=mujoco.MjSpec.from_string(scene(biped())))
    mirror = figure_mirror(clip.figure, table_of(text, "one"), "one")
    (contact,) = mirrored_tables(table_of(text, "one"), clip.figure, mirror).contact
    one, two = (next(p for p in clip.context.points if p.name == name) for name in ("left_foot 1", contact.point))
    np.testing.assert_allclose(two.position, one.position * [1, -1, 1], atol=1e-12)
    assert contact.point.startswith("right_foot")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('["toe_1", "toe_2"]', '["toe_1", "badge"]', "no partner on the other side for: 'toe_1'"),
        (', ["toe_1", "toe_2"]', "", "no partner on the other side for: 'toe_1'; .*mirror"),
        ('"ankle_2"]', '"ankl_2"]', "one: mirror.pairs: no joint 'ankl_2'; did you mean 'ankle_2'"),
        (
            ', ["ankle_1", "ankle_2"]',
            "",
            "one: no partner on the other side for: 'ankle_1', 'ankle_2'; joints are paired",
        ),
    ],
)
def test_what_has_no_partner_is_refused_with_the_key_that_names_it(old, new, words):
    assert old in CLIP
    table = table_of(CLIP.replace(old, new) + "sites.toe_1 = [0.3, 0.1, 0.4]\n", "one")
    clip = recordings.from_text(CLIP, name="one", spec=figure())
    with pytest.raises(UserError, match=words):
        mirrored_tables(table, clip.figure, figure_mirror(clip.figure, table, "one"))


def sided(text: str) -> str:
    text = re.sub(r"\[mirror\]\n.*\n", "", text)
    return text.replace("_1", "_left").replace("_2", "_right")


def test_a_heading_alone_is_that_of_the_mirrored_motion():
    text = CLIP + "[[keyframe]]\ntime = 2\nothers = 'previous'\nroot.rotation = {heading = 50}\n"
    text += "[[keyframe]]\ntime = 3\nothers = 'previous'\nbodies.foot_1 = {heading = 10}\njoints.swing_1 = 'free'\n"
    text += "[[keyframe]]\ntime = 4\nothers = 'previous'\nbodies.waist = {flat = true, heading = 20}\n"
    spec, text = figure(sided(TURNED.replace(".5 .5 .5 .5", ".1 .1 .7 .7", 1))), sided(text)
    one = recordings.from_text(text, name="one", spec=spec.copy())
    mirror = Mirror.of(one.figure)
    table = mirrored_tables(table_of(text, "one"), one.figure, mirror)
    two = recordings.from_text(text_of(table), name="two", spec=spec.copy())
    model = one.figure.model
    for before, after in zip(one.keys, two.keys, strict=True):
        image = kinematics(model, mirror.configurations(before.state)).xmat
        np.testing.assert_allclose(kinematics(model, after.state).xmat, image, atol=2e-4)
