"""Feet, geoms and bodies go by the names that are told: in `sites.`, in `bodies.` and in [[contact]]."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest
from figures import figure_of
from oracles import kinematics

from dynsplines import recordings
from dynsplines.clip.build import Clip
from dynsplines.clip.mirror import mirrored_tables
from dynsplines.clip.posing.places import Places, posable_sites, sole_points
from dynsplines.clip.table import ClipTable, KeyframeTable, PenaltyTable, RecordingTable
from dynsplines.edit.edits import retimed_tables
from dynsplines.errors import UserError
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.figure.figure import Figure

LEG = """<body name="{side}_thigh" pos="0 {y} 0"><joint name="{side}_hip_x" axis="1 0 0" range="-60 60"/>
  <joint name="{side}_hip_y" axis="0 1 0" range="-120 90"/><geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/>
  <body name="{side}_calf" pos="0 0 -.3"><joint name="{side}_knee" axis="0 1 0" range="0 150"/>
    <geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/><geom name="{side}_ball" size=".04" pos="0 0 -.3"/>
    <geom type="box" size=".01 .02 .03" pos=".05 0 -.1" quat=".6 0 .8 0"/></body></body>"""
ROBOT = (
    '<mujoco model="robot"><compiler angle="degree"/><worldbody><body name="trunk" pos="0 0 .65">'
    '<freejoint name="base"/>'
    '<geom name="box" type="box" size=".1 .1 .05"/>'
    f"{LEG.format(side='left', y=0.1)}{LEG.format(side='right', y=-0.1)}</body></worldbody></mujoco>"
)
HEAD = 'figure = "robot.xml"\n[[keyframe]]\ntime = 0\nothers = "rest"\n[[keyframe]]\ntime = 1\nothers = "previous"\n'


def figure() -> Figure:
    return figure_of(ROBOT)


def read(said: str, more: str = "") -> Clip:
    return recordings.from_text(HEAD + said + more, name="it", spec=mujoco.MjSpec.from_string(ROBOT))


def places() -> Places:
    whole = figure()
    return Places(whole, sole_points(whole, np.zeros((0, whole.width))))


def seen(problem: Clip, k: int = 1) -> mujoco.MjData:
    return kinematics(problem.figure.model, problem.keys[k].state)


@pytest.mark.parametrize("name", ["left_ball", "left_calf 2", "left_calf 1", "left_calf", "box"])
def test_a_point_is_where_mujoco_has_the_geom_or_the_body(name, rng):
    found, whole = places().point(name), figure()
    assert found is not None
    data = kinematics(whole.model, rng.normal(size=whole.width))
    geoms = {"left_ball": 3, "left_calf 1": 2, "left_calf 2": 4, "box": 0}
    there = data.geom_xpos[geoms[name]] if name in geoms else data.body(name).xpos
    link = whole.links[found.link].body
    here = data.xpos[link] + data.xmat[link].reshape(3, 3) @ found.position
    np.testing.assert_allclose(here, there, atol=1e-9)


@pytest.mark.parametrize("geom", ["", ' name="hook"', ' name="hand"'])
@pytest.mark.parametrize("count", [1, 2])
def test_a_body_is_its_origin_whatever_geoms_it_has(geom, count):
    text = f"""<mujoco><worldbody><body name="arm" pos="0 0 1"><joint axis="0 1 0"/><joint axis="0 0 1"/>
      <geom size=".02"/><geom size=".03" pos=".1 0 0"/><body name="hand" pos=".4 0 0"><joint axis="0 1 0"/>
        <geom{geom} size=".05" pos=".1 0 0"/>{'<geom size=".05" pos=".2 0 0"/>' * (count - 1)}</body></body>
      <body name="cup" pos=".5 .1 1"><freejoint/><geom size=".05"/></body></worldbody></mujoco>"""
    rows = "[[keyframe]]\ntime = 0\nothers = 'rest'\n[[keyframe]]\ntime = 1\nothers = 'previous'\n"
    more = "sites.hand = [0, 0.4, 1]\nroots.cup.position = 'free'\nroots.cup.rotation = 'free'\n"
    grasp = "[[grasp]]\nhand = 'hand'\nbody = 'cup'\nfrom = 0\nto = 1\n"
    problem = recordings.from_text(
        f"figure = 'arm.xml'\n{rows}{more}{grasp}", name="it", spec=mujoco.MjSpec.from_string(text)
    )
    np.testing.assert_allclose(seen(problem).body("hand").xpos, [0, 0.4, 1], atol=1e-6)
    (held,) = problem.context.schedule.grasps
    np.testing.assert_allclose(held.point.position, 0)


def test_points_are_as_thick_as_what_they_name():
    known = places()
    thick = {name: known.point(name) for name in ("left_ball", "left_calf 2", "left_calf")}
    assert {name: round(point.radius, 6) for name, point in thick.items() if point} == {
        "left_ball": 0.04, "left_calf 2": 0.01, "left_calf": 0.34
    }  # fmt: skip


def test_a_body_goes_by_the_names_of_all_that_is_on_it():
    known, model = places(), figure().model
    for name in ("left_calf", "left_knee", "left_ball", "left_calf 2"):
        assert known.body(name) == model.body("left_calf").id
    assert known.body("nothing") is None
    assert known.point("nothing") is None


def test_feet_geoms_and_bodies_are_put_where_a_keyframe_specifies_and_rest_as_contacts_specify():
    points = ["right_ball", "left_calf 2", "left_calf", "trunk"]
    contacts = "".join(f'[[contact]]\npoint = "{point}"\nfrom = 0\nto = 1\n' for point in points)
    problem = read("joints.left_knee = 12\n", contacts)
    assert [rest.point.name for rest in problem.context.schedule.contacts.requested] == points
    problem = read("sites.left_ball = [0.2, 0.12, 0.1]\n")
    np.testing.assert_allclose(seen(problem).geom("left_ball").xpos, [0.2, 0.12, 0.1], atol=1e-6)


def test_a_body_takes_a_place_of_its_origin_or_of_a_point_in_its_axes():
    problem = read("bodies.left_calf = {position = [0.18, 0.1, 0.41]}\n")
    np.testing.assert_allclose(seen(problem).body("left_calf").xpos, [0.18, 0.1, 0.41], atol=1e-6)
    problem = read('bodies.left_calf = {position = [0.1, "free", 0.15], at = [0, 0, -0.3]}\n')
    data = seen(problem)
    tip = data.body("left_calf").xpos + data.body("left_calf").xmat.reshape(3, 3) @ [0, 0, -0.3]
    np.testing.assert_allclose(tip[[0, 2]], [0.1, 0.15], atol=1e-6)


def test_a_body_is_placed_and_turned_at_once():
    problem = read(
        'root = {position = "free", rotation = "free"}\nbodies.trunk = {position = [0.1, 0, 0.6], flat = true}\n'
    )
    data = seen(problem)
    np.testing.assert_allclose(data.body("trunk").xpos, [0.1, 0, 0.6], atol=1e-6)
    np.testing.assert_allclose(data.body("trunk").xmat[8], 1, atol=1e-9)


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("sites.left_bal = [0, 0, 0]\n", "no site 'left_bal'; did you mean 'left_ball'? Sites: left_ball, right_ball"),
        ("bodies.left_calf = {at = [0, 0, 0]}\n", "'at' is a point of the body"),
        ('bodies.left_calf = {position = ["free", "free", "free"]}\n', "every axis is free"),
        ("bodies.left_calf = {position = [0, 0]}\n", "position must be [x, y, z] in metres"),
        ("bodies.left_calf = {position = [9, 0, 0]}\n", "no pose found that puts body 'left_calf' at (9, 0, 0)"),
        ("sites.left_ball = [9, 0, 0]\n", "no pose found that puts point 'left_ball' at (9, 0, 0)"),
    ],
)
def test_an_error_is_one_line_that_says_what_there_is(said, words):
    with pytest.raises(UserError) as caught:
        read(said)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_feet_bodies_and_their_axes_change_sides_in_a_mirror():
    whole, level = figure(), PenaltyTable.of("upright", bodies=["left_calf"], axis=[0.6, 0.8, 0])
    key = {
        "sites": {"left_ball": [0.1, 0.2, 0.3]},
        "bodies": {"left_calf": {"position": [0.1, 0.2, "free"], "at": [0.01, 0.02, 0.03]}},
        "time": 0,
    }
    table = ClipTable(figure="whole", penalty=[level], keyframe=[KeyframeTable.model_validate(key)])
    mirrored = mirrored_tables(table, whole, Mirror.of(whole))
    (out,), (penalty,) = mirrored.keyframe, mirrored.penalty
    assert out.sites == {"right_ball": (0.1, -0.2, 0.3)}
    assert out.bodies["right_calf"].position == (0.1, -0.2, "free")
    assert out.bodies["right_calf"].at == pytest.approx([0.01, -0.02, 0.03], abs=1e-12)
    assert penalty.options["bodies"] == ["right_calf"]
    np.testing.assert_allclose(penalty.options["axis"], [0.6, -0.8, 0], atol=1e-12)


def test_a_clip_that_follows_a_recording_is_mirrored_and_retimed_when_it_is_solved():
    whole, clip_ = figure(), ClipTable(figure="whole", recording=RecordingTable(file="a.npz"))
    with pytest.raises(UserError, match="mirror the solved motion"):
        mirrored_tables(clip_, whole, Mirror.of(whole))
    with pytest.raises(UserError, match="retime the solved motion"):
        retimed_tables(clip_, 2.0)


MUSCLES = """<mujoco><worldbody><body name="leg" pos="0 0 1"><freejoint/><geom type="capsule" size=".05 .3"/>
  <site name="knee"/><site name="toe_muscle"/><site name="edl-P1_r"/><site name="wrap"/><site name="ext-P2"/>
  <geom name="bone" type="sphere" size=".1"/><body><joint/><geom size=".1"/><site name="tip"/></body></body></worldbody>
  <tendon><spatial><site site="toe_muscle"/><geom geom="bone" sidesite="wrap"/><site site="tip"/></spatial></tendon>
</mujoco>"""


def test_the_points_of_muscles_are_no_sites_to_pose_and_no_feet():
    model = mujoco.MjModel.from_xml_string(MUSCLES)
    assert posable_sites(model) == ["knee"]
    whole = Figure(model)
    assert all(point.name != "toe_muscle" for point in sole_points(whole, np.zeros((0, whole.width))))
    bare = mujoco.MjModel.from_xml_string(MUSCLES[: MUSCLES.index("<tendon>")] + "</mujoco>")
    assert "edl-P1_r" in posable_sites(bare)  # who has no muscles may call a site what one likes
