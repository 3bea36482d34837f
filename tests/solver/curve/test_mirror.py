"""Left and right exchanged: what MuJoCo's kinematics make of the mirrored figure is the mirror image."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE
from oracles import posed
from random_keys import random_qpos

from dynsplines import models
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.mirror import Mirror, MirrorError, other_side
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.refine.subdivision import evenly

ROBOT = """
<mujoco><compiler angle="radian"/><worldbody>
  <body name="trunk" pos="0 0 1"><freejoint name="root"/><geom size=".1"/>
    <body name="head" pos="0 0 .2"><joint name="neck" axis="0 1 0" ref=".1"/><geom size=".1"/></body>
    <body name="LeftArm" pos="0 .2 0" quat=".9 .1 .2 .3"><joint name="LeftPitch" axis="0 1 0" ref=".2"/>
      <joint name="LeftRoll" axis="1 0 0"/><geom size=".1"/>
      <body name="LeftHand" pos="0 0 -.2"><joint name="LeftReach" type="slide" axis="0 1 -1" ref=".05"/>
        <geom size=".05"/></body></body>
    <body name="RightArm" pos="0 -.2 0" quat=".9 -.1 .2 -.3"><joint name="RightPitch" axis="0 1 0"/>
      <joint name="RightRoll" axis="1 0 0"/><geom size=".1"/>
      <body name="RightHand" pos="0 0 -.2"><joint name="RightReach" type="slide" axis="0 1 1"/>
        <geom size=".05"/></body></body>
  </body></worldbody></mujoco>"""

REFLECTION = np.diag([1.0, -1, 1])


def human() -> mujoco.MjModel:
    return mujoco.MjSpec.from_string(models.figure_text("human")).compile()


@pytest.mark.parametrize(
    ("model", "coordinates"),
    [
        (human(), "world"),
        (human(), "joint"),
        (mujoco.MjModel.from_xml_string(ROBOT), "joint"),
    ],
    ids=["human, world", "human, joint", "robot"],
)
def test_every_body_stands_where_its_partners_reflection_does(rng, model, coordinates):
    figure = Figure(model, coordinates)
    mirror = Mirror.of(figure)
    partner = [0] + [model.body(other_side(model.body(i).name)).id for i in range(1, model.nbody)]
    assert partner != list(range(model.nbody))
    for _ in range(3):
        qpos = random_qpos(figure, rng)
        state = mirror.states(figure.to_state(qpos))
        place, turn = posed(model, qpos)
        for mirrored in (mirror.states(qpos), figure.to_qpos(state)):
            place_of_it, turn_of_it = posed(model, mirrored)
            np.testing.assert_allclose(place_of_it[partner], place @ REFLECTION, atol=1e-9)
            np.testing.assert_allclose(turn_of_it[partner], REFLECTION @ turn @ REFLECTION, atol=1e-9)


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_the_mirrored_spline_is_the_spline_of_the_mirrored_frames_and_comes_back(rng, ends):
    figure = Figure(human())
    mirror, first = Mirror.of(figure), random_qpos(figure, rng)
    states = [first + 0.2 * rng.normal(size=first.size) for _ in range(3)]
    keys = [Frame.key(0.4 * i, state) for i, state in enumerate([first, *states, first])]
    mask = np.ones(figure.width, bool)
    mask[figure.links[figure.link_named("left_knee") or 0].qpos + np.arange(4)] = False
    keys[2] = Frame.key(0.8, states[1], mask)
    slope = rng.normal(size=(2, figure.width)) if ends == "clamped" else None
    timeline = evenly(raw_timeline(figure, keys, ends, slope), 1)
    mirrored = mirror.timeline(timeline)
    t = np.linspace(0, 1.6, 60)
    for order in range(3):
        wanted = path_of(timeline).at(t, order)
        np.testing.assert_allclose(path_of(mirrored).at(t, order), mirror.slopes(wanted), atol=1e-9)
    twice = mirror.timeline(mirrored)
    np.testing.assert_array_equal(twice.rows, timeline.rows)
    np.testing.assert_array_equal(twice.fixed, timeline.fixed)
    left, right = (figure.links[figure.link_named(f"{side}_knee") or 0].qpos for side in ("left", "right"))
    assert not mirrored.frames[4].fixed[right : right + 4].any()
    assert mirrored.frames[4].fixed[left : left + 4].all()


def test_hinges_that_rest_off_zero_come_back_to_rounding(rng):
    figure = Figure(mujoco.MjModel.from_xml_string(ROBOT))
    mirror, qpos = Mirror.of(figure), random_qpos(figure, rng)
    np.testing.assert_allclose(mirror.states(mirror.states(qpos)), qpos, atol=1e-12)
    rest = np.array(figure.model.qpos0)
    np.testing.assert_allclose(mirror.states(rest), rest, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("left_knee", "right_knee"),
        ("RIGHT_HIP", "LEFT_HIP"),
        ("LeftUpLeg", "RightUpLeg"),
        ("mixamo:RightFoot", "mixamo:LeftFoot"),
        ("l_arm", "r_arm"),
        ("foot_r", "foot_l"),
        ("foot.L", "foot.R"),
        ("thighR", "thighL"),
        ("FL_hipx", "FR_hipx"),
        ("RL_knee", "RR_knee"),
        ("LH_foot", "RH_foot"),
        ("lf_foot", "rf_foot"),
        ("hr", "hl"),
        ("hip_left_x", "hip_right_x"),
        ("spine", "spine"),
        ("lower_spine", "lower_spine"),
        ("bright", "bright"),
        ("root", "root"),
    ],
)
def test_sides_are_told_by_words_and_letters_of_their_own(name, other):
    assert other_side(name) == other
    assert other_side(other) == name


def changed(old: str, new: str, text: str = ROBOT) -> Figure:
    assert old in text
    return Figure(mujoco.MjModel.from_xml_string(text.replace(old, new)))


@pytest.mark.parametrize(
    ("figure", "words"),
    [
        (changed('"RightRoll"', '"Roll"'), "no partner on the other side for: 'LeftRoll';"),
        (changed('pos="0 0 .2"', 'pos="0 .1 .2"'), "no partner on the other side for: 'neck'"),
        (
            changed('quat=".9 -.1 .2 -.3"', 'quat=".9 .1 .2 -.3"'),
            "'LeftPitch' at rest is no mirror image of 'RightPitch'",
        ),
        (
            changed('"RightReach" type="slide"', '"RightReach" type="hinge"'),
            "'LeftReach' and 'RightReach' are not alike",
        ),
        (changed('"RightRoll" axis="1 0 0"', '"RightRoll" axis="1 0 1"'), "axes of .* are no mirror images"),
        (Figure(mujoco.MjModel.from_xml_string(BALL_TREE)), "no partner .* 'shoulder', 'elbow', 'hip';"),
    ],
)
def test_a_figure_without_two_sides_is_refused_by_the_joints_that_have_no_partner(figure, words):
    with pytest.raises(MirrorError, match=words):
        Mirror.of(figure)
