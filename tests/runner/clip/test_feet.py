"""Where figures of other makes than the human's stand."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from dynsplines.clip.contacts import contacts
from dynsplines.clip.posing.places import rounded, sole_points
from dynsplines.clip.table import ContactTable
from dynsplines.errors import UserError
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.unknowns import raw_timeline
from dynsplines.solver.figure.figure import Figure

LEG = """<body name="{name}_thigh" pos="{x} {y} 0"><joint name="{name}_hip" axis="0 1 0"/>
  <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/>
  <body name="{name}_shin" pos="0 0 -.3"><joint name="{name}_knee" axis="0 1 0"/>
    <geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/>{foot}</body></body>"""
SPHERE = '<geom name="{name}_foot" size=".04" pos="0 0 -.3"/>'
BOX = """<body name="{name}_ankle" pos="0 0 -.3"><joint name="{name}_ankle" axis="0 1 0"/>
  <geom name="{name}_sole" type="box" size=".1 .04 .01" pos=".03 0 -.03"/></body>"""
SITE = '<site name="{name}_toe" pos="0 0 -.34"/>'
IN_SPHERE = SPHERE + '<site name="{name}_toe" pos="0 0 -.3"/>'


def figure_of(legs: dict[str, tuple[float, float]], foot: str, joint: str = "<freejoint/>", extra: str = "") -> Figure:
    parts = "".join(LEG.format(name=n, x=x, y=y, foot=foot.format(name=n)) for n, (x, y) in legs.items())
    text = f"""<mujoco><worldbody><body name="trunk" pos="0 0 .65">{joint}
      <geom type="box" size=".3 .1 .05"/>{parts}</body>{extra}</worldbody></mujoco>"""
    return Figure(mujoco.MjModel.from_xml_string(text))


ROUND = """<body name="{name}_ankle" pos="0 0 -.3"><joint name="{name}_ankle" axis="0 1 0"/>
  <geom name="{name}_in" type="cylinder" size=".02" fromto="-.06 -.02 -.03 .15 -.02 -.03"/>
  <geom name="{name}_out" type="cylinder" size=".02" fromto="-.06 .02 -.03 .15 .02 -.03"/></body>"""

FOUR = {"fl": (0.3, 0.1), "fr": (0.3, -0.1), "bl": (-0.3, 0.1), "br": (-0.3, -0.1)}
TWO = {"l": (0.0, 0.1), "r": (0.0, -0.1)}


LEVEL = """<body euler="0 0 {heading}"><body pos=".4 0 0"><joint axis="0 1 0" range="{span}"/>
  <geom name="leg{heading}" type="capsule" size=".04" fromto="0 0 0 .4 0 0"/></body></body>"""


def spider(span: str) -> Figure:
    """Return a trunk with four legs, which are level in the rest pose, with ranges of their hips [degrees]."""
    legs = "".join(LEVEL.format(heading=heading, span=span) for heading in (0, 90, 180, 270))
    text = f'<body name="trunk" pos="0 0 .6"><freejoint/><geom size=".15"/>{legs}</body>'
    return Figure(mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{text}</worldbody></mujoco>"))


def soles(figure: Figure) -> list[str]:
    return [point.name for point in sole_points(figure, np.zeros((0, figure.width)))]


PLANE = '<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint axis="0 1 0"/>'
BESIDE = '<body name="ball" pos="1 0 .1"><freejoint name="ball"/><geom name="ball" size=".1"/></body>'
OTHER = """<body pos="0 2 .4"><freejoint/><geom type="box" size=".1 .1 .05"/>
  <body><joint axis="0 1 0"/><geom name="peg" type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/></body>{}</body>"""
OTHER_LEG = '<body><joint axis="0 1 0"/><geom name="leg" type="capsule" size=".02" fromto="0 .1 0 0 .1 -.3"/></body>'
FEET = {
    "spheres of four legs": (figure_of(FOUR, SPHERE), ["fl_foot", "fr_foot", "bl_foot", "br_foot"]),
    "corners of soles": (figure_of(TWO, BOX), [f"{side}_sole {k}" for side in "lr" for k in (1, 2, 3, 4)]),
    "sites called toe or heel first": (figure_of(TWO, SITE), ["l_toe", "r_toe"]),
    "a mark on top of a toe is no sole": (
        figure_of(TWO, SPHERE + '<site name="{name}_toe" pos="0 0 -.2"/>'), ["l_foot", "r_foot"]),
    "sliding in a plane": (figure_of(TWO, SPHERE, PLANE), []),
    "hinged to the world": (figure_of(TWO, SPHERE, '<joint axis="0 1 0"/>'), []),
    "bolted to the world": (figure_of(TWO, SPHERE, ""), []),
    "a ball beside a robot": (figure_of(TWO, SPHERE, extra=BESIDE), ["l_foot", "r_foot"]),
    "two robots": (figure_of(TWO, SPHERE, extra=OTHER.format(OTHER_LEG)), ["l_foot", "r_foot", "peg", "leg"]),
    "what hangs does not stand": (figure_of(TWO, SPHERE, extra=OTHER.format("")), ["l_foot", "r_foot"]),
    "named after bodies": (figure_of(TWO, '<geom size=".04" pos="0 0 -.3"/>'), ["l_shin", "r_shin"]),
    "corners named after bodies": (
        figure_of(TWO, BOX.replace('name="{name}_sole"', "")),
        [f"{side}_ankle {k}" for side in "lr" for k in (1, 2, 3, 4)]),
}  # fmt: skip


@pytest.mark.parametrize("case", FEET)
def test_figures_of_many_makes_stand_on_their_feet(case):
    figure, expected = FEET[case]
    assert soles(figure) == expected


def test_points_of_spheres_are_as_thick_as_they():
    for figure in (figure_of(FOUR, SPHERE), figure_of(TWO, IN_SPHERE)):
        assert {point.radius for point in sole_points(figure, np.zeros((0, figure.width)))} == {0.04}


def test_who_is_tallest_on_the_tips_of_his_toes_stands_on_his_soles():
    """A robot's sole stands straight up and down in a pose that is a little taller than the one at rest."""
    figure = figure_of(TWO, BOX)
    tips = figure.model.qpos0.copy()
    tips[figure.model.joint("r_ankle").qposadr[0]] = np.radians(80)
    at_rest, seen = sole_points(figure, np.zeros((0, figure.width))), sole_points(figure, tips[None])
    assert [point.name for point in seen] == [point.name for point in at_rest]
    np.testing.assert_allclose([p.position for p in seen], [p.position for p in at_rest])


def test_feet_with_round_edges_stand_on_what_touches_the_floor():
    """Not on the sides of cylinders that lie, which reach farther to the corners of the foot."""
    points = sole_points(figure_of(TWO, ROUND), np.zeros((0, 13)))
    assert len(points) == 8
    np.testing.assert_allclose([point.position[2] for point in points], -0.05, atol=1e-9)
    assert np.ptp([point.position[0] for point in points]) == pytest.approx(0.21)


def test_a_figure_that_lies_on_its_belly_has_none_but_where_a_keyframe_stands_it_up():
    figure = figure_of(TWO, SPHERE)
    lying = Figure(figure.model)
    hips = [lying.model.joint(name).qposadr[0] for name in ("l_hip", "r_hip")]
    lying.model.qpos0[hips] = np.pi / 2
    standing = np.array(figure.model.qpos0)
    standing[hips] = 0
    flat = mujoco.MjModel.from_xml_string(
        '<mujoco><worldbody><body pos="0 0 1"><freejoint/><geom type="box" size=".5 .5 .1"/><body pos=".5 0 .1">'
        '<joint axis="0 1 0"/><geom type="capsule" size=".02" fromto="0 0 0 .3 0 0"/></body></body>'
        "</worldbody></mujoco>"
    )
    assert soles(Figure(flat)) == []
    assert [point.name for point in sole_points(lying, standing[None])] == ["l_foot", "r_foot"]


def test_a_clip_calls_found_feet_by_their_names():
    figure = figure_of(FOUR, SPHERE)
    keys = raw_timeline(figure, [Frame.key(float(t), figure.model.qpos0) for t in range(3)])
    points = sole_points(figure, np.zeros((0, figure.width)))
    table = ContactTable.model_validate({"point": "bl_foot", "from": 0.0, "to": 1.0})
    found = contacts(figure, keys, [table], "clip", points)
    assert [rest.point.name for rest in found.requested] == ["bl_foot"]
    with pytest.raises(UserError, match="did you mean 'bl_foot'"):
        contacts(figure, keys, [table.model_copy(update={"point": "bl_fot"})], "clip", points)


def test_of_a_kick_the_feet_are_found_in_a_pose_that_stands_on_both():
    """The tallest pose is on the toes of one leg, the other one held out: both feet are told all the same."""
    figure = figure_of(TWO, BOX)
    kick = np.array(figure.model.qpos0)
    kick[[9, 10]] = [0.6, -1.4]
    found = sole_points(figure, kick[None])
    assert {point.name.split()[0] for point in found} == {"l_sole", "r_sole"}


@pytest.mark.parametrize(
    ("foot", "centre", "radius"),
    [
        (SPHERE + SITE, (0, 0, -0.3), 0.04),
        ('<geom type="capsule" size=".04" fromto="-.1 0 -.3 .1 0 -.3"/><site name="{name}_toe" pos=".07 0 -.339"/>',
         (0.07, 0, -0.3), 0.04),
        (SPHERE + '<site name="{name}_toe" pos="0 0 -.36"/>', (0, 0, -0.36), 0.0),
        ('<geom type="box" size=".1 .04 .04" pos="0 0 -.3"/>' + SITE, (0, 0, -0.34), 0.0),
    ],
)  # fmt: skip
def test_a_mark_on_what_is_round_is_as_round_as_that(foot, centre, radius):
    """A mark beside its skin, or on a box, stays a point."""
    figure = figure_of(TWO, foot)
    marks = sole_points(figure, figure.model.qpos0[None])
    assert {mark.radius for mark in marks} == {0.0}
    for mark in marks:
        found = rounded(figure, mark)
        np.testing.assert_allclose((*found.position, found.radius), (*centre, radius), atol=1e-9)
        assert (found.name, found.link) == (mark.name, mark.link)


def test_feet_of_level_legs_are_those_of_the_rest_pose_within_the_ranges():
    assert soles(spider("40 80")) == ["leg0", "leg90", "leg180", "leg270"]
    assert soles(spider("-40 80")) == []  # the rest pose is within the ranges
    assert soles(spider("1 80")) == []  # the trunk is still lower
