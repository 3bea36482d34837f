"""Left and right exchanged: what MuJoCo's kinematics make of the mirrored figure is the mirror image."""

import mujoco
import numpy as np
import pytest
from figures import BALL_TREE, figure_of, link_named
from oracles import kinematics
from random_models import evenly, random_qpos
from texts import read_data

from dynsplines import models
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.raw import raw_timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.curve.symmetry import other_side
from dynsplines.solver.figure.figure import Figure

ROBOT = read_data("mirrored_robot.xml")

REFLECTION = np.diag([1.0, -1, 1])


def human() -> mujoco.MjModel:
    return mujoco.MjSpec.from_string(models.figure_text("human")).compile()


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_the_mirrored_spline_is_the_spline_of_the_mirrored_frames_and_comes_back(rng, ends):
    figure = Figure(human())
    mirror, first = Mirror.of(figure), random_qpos(figure, rng)
    states = [first + 0.2 * rng.normal(size=first.size) for _ in range(3)]
    keys = [Frame.key(0.4 * i, state) for i, state in enumerate([first, *states, first])]
    mask = np.ones(figure.width, bool)
    mask[figure.links[link_named(figure, "left_knee") or 0].qpos + np.arange(4)] = False
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
    left, right = (figure.links[link_named(figure, f"{side}_knee") or 0].qpos for side in ("left", "right"))
    assert not mirrored.frames[4].fixed[right : right + 4].any()
    assert mirrored.frames[4].fixed[left : left + 4].all()


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("left_knee", "right_knee"),
        ("LeftUpLeg", "RightUpLeg"),
        ("mixamo:RightFoot", "mixamo:LeftFoot"),
        ("l_arm", "r_arm"),
        ("foot.L", "foot.R"),
        ("thighR", "thighL"),
        ("FL_hipx", "FR_hipx"),
        ("lf_foot", "rf_foot"),
        ("hr", "hl"),
        ("hip_left_x", "hip_right_x"),
        ("spine", "spine"),
        ("bright", "bright"),
    ],
)
def test_sides_are_recognised_by_words_and_separate_letters(name, other):
    assert other_side(name) == other
    assert other_side(other) == name


def changed(old: str, new: str, text: str = ROBOT) -> Figure:
    assert old in text
    return figure_of(text.replace(old, new))


# a shoulder that is too high, beside a crane, whose size is not that of the robot
LOWER = ROBOT.replace('pos="0 -.2 0"', 'pos="0 -.2 .1"').replace(
    "</worldbody>",
    """<body name="crane"><freejoint/><geom size=".1"/><body pos="50 0 0"><joint name="jib" axis="0 1 0"/>
    <geom size=".1"/></body></body></worldbody>""",
)

# a hand on the trunk instead of its arm
LOOSE = ROBOT.replace('<body name="RightHand"', '</body><body name="RightHand"').replace(
    "</body></body>\n  </body></worldbody>", "</body>\n  </body></worldbody>"
)


def leaning(y: float, drop: float = 0.0) -> Figure:
    """A robot of 0.6 m whose neck, which tilts sideways, is off the middle, and whose right arm is too low [m]."""
    lower = ROBOT.replace('pos="0 -.2 0"', f'pos="0 -.2 {-drop}"')
    return changed(
        'pos="0 0 .2"><joint name="neck" axis="0 1 0"', f'pos="0 {y} .2"><joint name="neck" axis="1 0 0"', lower
    )


def test_a_small_asymmetry_is_tolerated_more_between_partners_than_in_the_middle():
    assert Mirror.of(leaning(0.002, drop=0.02)).partner.tolist() == [0, 1, 2, 6, 7, 8, 3, 4, 5]


@pytest.mark.parametrize("y", [0.0, 0.01])
def test_two_hinges_on_one_axis_are_in_the_middle_unless_their_masses_are_mirror_images(y):
    flap = '<body><joint name="{}" axis="0 1 0"/><geom size=".1" pos="0 {} .5"/></body>'
    flaps = flap.format("one", y) + flap.format("two", -y)
    figure = figure_of(f'<mujoco><worldbody><body><freejoint/><geom size=".1"/>{flaps}</body></worldbody></mujoco>')
    if not y:
        assert Mirror.of(figure).partner.tolist() == [0, 1, 2, 3]
    else:
        with pytest.raises(ValueError, match="no partner on the other side for: 'one', 'two'"):
            Mirror.of(figure)


@pytest.mark.parametrize(
    ("figure", "words"),
    [
        (changed('pos="0 0 .2"', 'pos="0 .1 .2"'), "no partner on the other side for: 'neck'"),
        (
            changed('quat=".9 -.1 .2 -.3"', 'quat=".9 .1 .2 -.3"'),
            "the axes of 'LeftPitch' and 'RightPitch' are no mirror images",
        ),
        (
            changed('"RightReach" type="slide"', '"RightReach" type="hinge"'),
            "'LeftReach' and 'RightReach' differ in kind of joint or in parent",
        ),
        (figure_of(LOWER), "'LeftPitch' at rest is no mirror image of 'RightPitch'"),
        (figure_of(LOOSE), "'LeftReach' and 'RightReach' differ in kind of joint or in parent"),
        (leaning(0.008), "no partner on the other side for: 'neck'"),
        (figure_of(BALL_TREE), "no partner .* 'shoulder', 'elbow', 'hip'; .*\\[mirror\\] of a clip"),
        (
            changed('"root"/><geom size=".1"', '"root"/><geom size=".1" pos="0 .3 0" mass="50"'),
            "no partner on the other side for: 'root'",
        ),
    ],
)
def test_a_figure_without_two_sides_is_refused_by_the_joints_that_have_no_partner(figure, words):
    with pytest.raises(ValueError, match=words):
        Mirror.of(figure)


@pytest.mark.parametrize("scale", [0.01, 1.0, 100.0])
@pytest.mark.parametrize("y", [-0.2, -0.195, 0.0])
def test_a_hinge_across_the_mirror_plane_is_in_the_middle_if_its_mass_is(y, scale):
    """Its body begins beside the plane. A difference of a few per cent of the figure's size is tolerated."""
    size, begin, place = (" ".join(str(scale * x) for x in part) for part in ((0.1,), (0, 0.2, 0.1), (0, y, 0.1)))
    figure = figure_of(f"""<mujoco><worldbody><body><freejoint/><geom size="{size}" mass="3"/>
      <body name="lid" pos="{begin}"><joint name="lid" axis="0 1 0"/><geom size="{size}" pos="{place}" mass="3"/>
      </body></body></worldbody></mujoco>""")
    if y:
        assert Mirror.of(figure).partner.tolist() == [0, 1, 2]
    else:
        with pytest.raises(ValueError, match="no partner on the other side for: 'lid'"):
            Mirror.of(figure)


PARTS = (  # name, parent, place at rest, kind and axis of the joint
    ("trunk", "", (0.0, 0, 1), "free", (0, 0, 0)),
    ("waist", "trunk", (0, 0, 1.2), "hinge", (1, 0, 0)),
    ("neck", "waist", (0.02, 0, 1.5), "ball", (0, 0, 0)),
    ("left_arm", "waist", (0, 0.2, 1.4), "ball", (0, 0, 0)),
    ("left_elbow", "left_arm", (0.1, 0.5, 1.4), "hinge", (0.1, 0.3, 0.9)),
    ("left_leg", "trunk", (0, 0.1, 0.9), "hinge", (0, 1, 0)),
    ("left_shin", "left_leg", (0.03, 0.12, 0.5), "slide", (0.3, 0.1, 0.9)),
)


def other_part(part):
    name, parent, (x, y, z), kind, axis = part
    sign = -1 if kind == "hinge" else 1
    swapped = (name.replace("left", "right"), parent.replace("left", "right"))
    return *swapped, (x, -y, z), kind, tuple(sign * np.array(axis) * [1, -1, 1])


def turned_frames(rng, *, names: str, root=None) -> tuple[mujoco.MjModel, list[int], list[tuple[str, str]]]:
    """A symmetric figure whose bodies' frames are turned at random, and whose axes point either way; the body on the
    other side of each, and the pairs of joints whose names do not tell. "one side": only the left is named as such."""
    parts = [*PARTS, *(other_part(part) for part in PARTS if "left" in part[0])]
    turns = {name: quat.normalise(rng.normal(size=4)) for name, *_ in parts}
    turns["trunk"] = np.array([1.0, 0, 0, 0]) if root is None else quat.normalise(root)
    place = {name: np.array(where) for name, _, where, *_ in parts}
    called = {name: name for name, *_ in parts}
    if names == "one side":
        called = {name: name.replace("right_", "") for name in called}
    elif names == "none":
        called = {name: f"b{i}" for i, name in enumerate(called)}
    spec = mujoco.MjSpec()
    bodies = {"": spec.worldbody}
    for name, parent, where, kind, axis in parts:
        back = quat.inverse(turns[parent]) if parent else np.array([1.0, 0, 0, 0])
        offset = np.array(where) - (place[parent] if parent else 0)
        body = bodies[parent].add_body(
            name=called[name], pos=quat.rotate(back, offset), quat=quat.product(back, turns[name])
        )
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.05, 0, 0])
        bodies[name] = body
        if kind == "free":
            body.add_freejoint(name=f"{called[name]}_joint")
            continue
        sign = rng.choice([-1.0, 1.0])
        joint = body.add_joint(name=f"{called[name]}_joint", type=getattr(mujoco.mjtJoint, f"mjJNT_{kind.upper()}"))
        side = ("left" in name) - ("right" in name)  # the joint's anchor is off the body's origin
        joint.pos = quat.rotate(quat.inverse(turns[name]), np.array([0.05, 0.02 * side, -0.03]))
        if kind != "ball":
            joint.axis, joint.ref = quat.rotate(quat.inverse(turns[name]), sign * np.array(axis, float)), rng.normal()
    model = spec.compile()
    ids = {name: model.body(called[name]).id for name in called}
    left = [name for name, *_ in parts if "left" in name and names == "none"]
    pairs = [(f"{called[name]}_joint", f"{called[other_side(name)]}_joint") for name in left]
    return model, [0, *(ids[other_side(name)] for name in sorted(ids, key=ids.__getitem__))], pairs


@pytest.mark.parametrize(
    ("names", "root"),
    [("both sides", None), ("one side", (0.9, 0.3, -0.4, 0.1)), ("none", (1.0, 0, 0, 1)), ("none", None)],
)
@pytest.mark.parametrize("coordinates", ["world", "joint"])
def test_frames_turned_at_random_have_mirrored_places_and_come_back(rng, names, root, coordinates):
    model, partner, pairs = turned_frames(rng, names=names, root=root)
    figure = Figure(model, coordinates)
    mirror = Mirror.of(figure, pairs)
    for _ in range(3):
        qpos = random_qpos(figure, rng)
        state, slope = figure.to_state(qpos), rng.normal(size=qpos.shape)
        image = figure.to_qpos(mirror.states(state))
        np.testing.assert_allclose(
            kinematics(model, image).xpos[partner], kinematics(model, qpos).xpos @ REFLECTION, atol=1e-9
        )
        np.testing.assert_allclose(
            kinematics(model, mirror.configurations(qpos)).xpos, kinematics(model, image).xpos, atol=1e-9
        )
        np.testing.assert_allclose(mirror.configurations(mirror.configurations(qpos)), qpos, atol=1e-9)
        np.testing.assert_allclose(mirror.states(mirror.states(state)), state, atol=1e-9)
        np.testing.assert_allclose(mirror.states(state + slope), mirror.states(state) + mirror.slopes(slope), atol=1e-9)
