"""Violations of a motion are reported: every kind on a motion that has it and nothing else, worst first."""

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
import shipped
from motions import raw_violations
from oracles import kinematics
from paper.penetration import penetration
from processes import quiet
from texts import read_data

from dynsplines import Keyframe, build, import_motion, inbetween, load, load_motion, motion, recordings, solving
from dynsplines.clip import load as clip
from dynsplines.clip.build import Clip
from dynsplines.clip.load import clip_from_motion
from dynsplines.edit import edits
from dynsplines.exchange import formats
from dynsplines.measure import violation
from dynsplines.measure.bounds import BOUNDS, WHIP_SHARE, Violation
from dynsplines.measure.ground import missing_support
from dynsplines.measure.measurement import Measurement
from dynsplines.motion import Sampled
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.search.minimum import Stop

BALL = """<mujoco><worldbody><body name="ball" pos="0 0 1"><freejoint name="root"/>
  <geom name="ball" type="sphere" size=".1" mass="1"/><site name="mark" pos="0 0 0"/></body></worldbody></mujoco>"""
RAIL = """<mujoco><compiler angle="degree" autolimits="true"/><worldbody>
  <body name="rail" pos="0 0 2"><joint name="slide" type="slide" axis="1 0 0" range="-1 1"/><geom size=".05" mass="1"/>
    <body name="upper" pos="0 .2 0"><joint name="swing" type="hinge" axis="0 1 0" range="-90 90"/>
      <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/><site name="tip" pos="0 0 -.3"/></body></body>
  {more}</worldbody>{equality}</mujoco>"""
ARM = RAIL.format(more="", equality="")
TWIN = """<body name="twin" pos="0 {} 2"><joint name="twin" type="hinge" axis="0 1 0"/>
  <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/></body>"""
FOLLOWS = '<equality><joint joint1="twin" joint2="swing" polycoef="0 1 0 0 0"/></equality>'
TIED = '<equality><connect name="bolt" body1="upper" body2="twin" anchor="0 0 -.3"/></equality>'
TRUNK = read_data("trunk.xml")
HOPPER = """<mujoco>{}<worldbody>{}<body name="trunk" pos="0 0 .5"><freejoint name="root"/><geom size=".1"/>
    <body pos="0 0 -.2"><joint name="knee" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 -.2" size=".05"/></body>
    </body></worldbody></mujoco>"""
ON_FLOOR = HOPPER.format("", '<geom type="plane" size="1 1 .1" pos="0 0 .1"/>')

REST = 'others = "rest"\n'
ARMS = "joints = {{left_shoulder = {{rotvec = [0, {0}, 0]}}, right_shoulder = {{rotvec = [0, {0}, 0]}}}}\n"
HIGH = REST + "root.position = [0, 0, 3]\n"  # above all floors


def read(text: str, figure: str = "human") -> Clip:
    """A clip from text; its figure ships, or is MJCF."""
    is_shipped = not figure.startswith("<")
    spec = None if is_shipped else mujoco.MjSpec.from_string(figure)
    return recordings.from_text(f'figure = "{figure if is_shipped else "it"}"\n{text}', name="it", spec=spec)


def keys(*rows: str, times: Sequence[float] | np.ndarray | None = None) -> str:
    """Keyframes at times [s], by default one a second."""
    when = range(len(rows)) if times is None else times
    return "".join(f"[[keyframe]]\ntime = {t:.9g}\n{row}\n" for t, row in zip(when, rows, strict=True))


def at(x: float, y: float, z: float, more: str = "", rotvec: str = "[0, 0, 0]") -> str:
    return f"root = {{position = [{x:.12g}, {y:.12g}, {z:.12g}], rotation = {{rotvec = {rotvec}}}}}\n{more}\n"


def hung(*heights: float, times: Sequence[float] | np.ndarray | None = None) -> str:
    """Keyframes of the hopper, whose foot is 0.45 m below its origin."""
    return keys(*(at(0, 0, z, "joints.knee = 0") for z in heights), times=times)


def standing(*places: float, z: float = 0.93, seconds: float = 1.0) -> str:
    """Keyframes of a human at rest at places along x [m]."""
    rows = (f"root.position = [{x}, 0, {z}]\n{REST}" for x in places)
    return keys(*rows, times=seconds * np.arange(len(places)))


def leaning(angle: float) -> str:
    """A human at rest leans so far forward [degrees] about its toes."""
    turn = quat.from_rotation_vector([0, np.radians(angle), 0])
    toe = np.array([0.17, 0, 0])
    x, _, z = toe + quat.rotate(turn, [0, 0, 0.93] - toe)
    row = f"root.position = [{x}, 0, {z}]\nroot.rotation = {{rotvec = [0, {angle}, 0]}}\n{REST}"
    return keys(row, row)


def tiptoe(distance: float, height: float) -> str:
    """A human on tiptoe is moved so far [m] within 0.5 s; the spheres of the toes are so high [m] above the floor."""
    ankle, toe = np.radians(40), np.array([0.17, -0.061])
    lower = toe @ [np.sin(ankle), -np.cos(ankle)] - 0.061
    pose = "".join(f"joints.{side}_ankle = {{rotvec = [0, 40, 0]}}\n" for side in ("left", "right"))
    rows = (f"root.position = [{x}, 0, {0.93 + lower + height}]\n{pose}{REST}" for x in (0, distance))
    return keys(*rows, times=(0, 0.5))


def thrown(gravity: float) -> str:
    """Keyframes every 0.05 s of a hopper that leaves the floor and lands after 0.5 s, falling with `gravity` [m/s²]."""
    times = np.arange(-2, 13) * 0.05
    return hung(*(0.55 + np.maximum(0.5 * gravity * times * (0.5 - times), 0)), times=times + 0.1)


def turned_about_its_heel() -> str:
    """A human at rest turns by 60° about the left heel, so that the right foot moves around it."""
    heel, (cos, sin) = np.array([-0.055, 0.09]), (0.5, np.sqrt(0.75))
    x, y = heel - np.array([[cos, -sin], [sin, cos]]) @ heel
    return keys(at(0, 0, 0.93, REST), at(x, y, 0.93, REST, rotvec="[0, 0, 60]"))


def swinging(*turns: float) -> str:
    """Keyframes of TRUNK, one a second, that swing its arm by angles [degrees] with the hand beside the trunk."""
    arm = "joints = {{shoulder = {{rotvec = [-40, {}, 0]}}, wrist = {{rotvec = [0, 0, 0]}}}}"
    return keys(*(at(0, 0, 2, arm.format(turn)) for turn in turns))


def chained(between: int) -> tuple[str, str]:
    """A ball with links at its middle and one that slides deeper into it, and keyframes."""
    chain = '<body name="c" pos=".12 0 0"><joint name="c" type="slide" axis="1 0 0"/><geom size=".05" mass="1"/></body>'
    names = "ab"[:between]
    for name in names:
        inertia = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
        chain = f'<body name="{name}"><joint name="{name}"/>{inertia}{chain}</body>'
    joints = "".join(f", {name} = 0" for name in names)
    rows = (at(0, 0, 2, f"joints = {{c = {-0.03 * t}{joints}}}") for t in (0, 1))
    return BALL.replace('<site name="mark" pos="0 0 0"/>', chain), keys(*rows)


def knee(rotvec: str) -> str:
    return keys(HIGH, HIGH + f"joints.left_knee = {{rotvec = {rotvec}}}", HIGH)


def joints(*rows: str) -> str:
    return keys(*(f"joints = {{slide = {row}}}" for row in rows))


CONTACT = '[[contact]]\npoint = "right_{}"\nfrom = {}\nto = {}\n'
SPEED = '[[penalty]]\nkind = "limits"\nspeed = {}\n'
FLIGHT = '[[penalty]]\nkind = "flight"\nintervals = [[{}]]\n'
CRATE = '[[scene.box]]\nname = "crate"\nposition = [0, 0, 1]\nsize = [0.4, 0.4, 0.4]\n'
NEVER = "keyframe 1 itself: the figure never comes down: lowest point {} m above the floor at 0.00 s"
FLOATS = r"the figure floats \d+ mm above the ground, for .* s, and is not in free fall at .* s"
SECOND = "keyframe 2 itself: "
FAULTS: dict[str, tuple[str, str, str, list[str]]] = {  # figure, clip, kind ("": all but aloft), texts
    "bent backward": ("human", knee("[0, -20, 0]"), "", [SECOND + "left_knee is bent 20° backward at 1.00 s"]),
    "bent sideways": (
        "human", knee("[20, 0, 0]"), "", [SECOND + "left_knee bends 12° sideways beyond its limit at 1.00 s"]),
    "twisted": ("human", knee("[0, 0, 20]"), "", [SECOND + "left_knee is twisted 12° beyond its limit at 1.00 s"]),
    "bends that a clip allows": (
        "human", '[[penalty]]\nkind = "limits"\nweight = {bend = 0}\n' + knee("[0, -20, 0]"), "", []),
    "beyond a range": (
        ARM, joints("0, swing = 0", "0, swing = 98"), "", [SECOND + "swing is 8° beyond its range at 1.00 s"]),
    "a slide beyond its range": (
        ARM, joints("0, swing = 0", "1.02, swing = 0"), "", [SECOND + "slide is 20 mm beyond its range at 1.00 s"]),
    "off what it follows": (
        RAIL.format(more=TWIN.format(".4"), equality=FOLLOWS),
        joints("0, swing = 0, twin = 0", "0, swing = 30, twin = 24"), "",
        [SECOND + "twin is 6° off what it follows at 1.00 s"]),
    "a torn loop": (  # by 2 · 0.3 m · sin 3°
        RAIL.format(more=TWIN.format(".2"), equality=TIED),
        joints("0, swing = 0, twin = 0", "0, swing = 20, twin = 14"), "",
        [SECOND + "the loop of bolt is torn by 31 mm at 1.00 s"]),
    "too fast": (
        ARM, joints("0, swing = 0", "0, swing = 80") + SPEED.format(50), "",
        [r"swing turns 30 degrees/s faster than its limit of 50 degrees/s at 0\..* s"]),
    "hardly too fast": (ARM, joints("0, swing = 0", "0, swing = 80") + SPEED.format(75), "", []),
    "through a box": (  # 0.15 m to the nearest face, and the ball's radius
        BALL, CRATE + keys(at(-1, 0.05, 1), at(1, 0.05, 1)), "", [r"ball is 250 mm in the crate at 0\.[45]. s"]),
    "limbs in each other": (TRUNK, swinging(40, -40), "", [r"trunk and hand are 7\d mm in each other at 0\.50 s"]),
    "limbs in each other in keyframes": (
        TRUNK, swinging(2, 0, 3), "",
        [SECOND + r"trunk and hand are \d+ mm in each other at 1.00 s, and in 2 other keyframes"]),
    "limbs in each other, wherever the root is": (
        TRUNK, swinging(2, 0, 3).replace("[0, 0, 2]", '"free"'), "",
        [SECOND + r"trunk and hand are \d+ mm in each other at 1.00 s, and in 2 other keyframes"]),
    "overlaps at rest": (*chained(2), "", [SECOND + "ball and c are 30 mm deeper in each other at 1.00 s"]),
    "overlaps at rest of joined bodies": (*chained(1), "", []),
    "standing": ("human", standing(0, 0, 0), "", []),
    "sunk, wherever the root is": (
        "human", standing(0, 0, 0, z=0.83).replace("[0, 0, 0.83]", '["free", "free", 0.83]'), "penetration",
        12 * [r"keyframe \d itself: (left|right)_(heel|toe|sock) is (100|45) mm in the floor at .*"]),
    "a contact in the air": (
        "human", standing(0, 0, 0.4, z=1.03) + CONTACT.format("toe", 0.4, 0.6), "hover",
        ["contact right_toe is 100 mm above its surface at .* s"]),
    "keyframes that move a contact": (
        "human", standing(0, 0.03, 0.03) + CONTACT.format("toe", 0, 1), "contact",
        [SECOND + "right_toe should rest, but is 30 mm from its position in the previous keyframe at 1.00 s"]),
    "always in the air": (ON_FLOOR, hung(1.45, 1.5), "aloft", [NEVER.format("0.90")]),
    "always above the stage": (HOPPER.format("", ""), hung(1.45, 1.5), "aloft", [NEVER.format("1.00")]),
    "always above a millimetre": (ON_FLOOR, hung(0.56, 0.56), "aloft", []),
    "landing": (ON_FLOOR, hung(1.0, 0.55), "aloft", []),
    "no gravity": (HOPPER.format('<option gravity="0 0 0"/>', ""), hung(1.5, 1.5), "aloft", []),
    "a flight of the clip": (ON_FLOOR, thrown(2.0) + FLIGHT.format("0.1, 0.6"), "float", []),
    "beside a flight of the clip": (ON_FLOOR, thrown(2.0) + FLIGHT.format("0.3, 0.4"), "float", 2 * [".*" + FLOATS]),
    "faster than friction allows": (
        "human", standing(0, 0.5, 0, seconds=0.3), "unsupported",
        [r"contacts cannot supply a force of \d\.\d\d of the weight, for .*"]),
    "too short for an average": ("human", standing(0, 0.5, 0, seconds=0.1), "unsupported", []),
    "slowly from side to side": ("human", standing(0, 0.5, 0, seconds=2.0), "unsupported", []),
    "leaning far forward": (
        "human", leaning(30), "unbalanced", [r"the centre of mass of the standing figure is \d+ mm beside its .*"]),
    "leaning on hands just above the floor": (  # by 24 mm
        "human", leaning(68).replace(REST, ARMS.format(-68) + REST),
        "unbalanced", ["the centre of mass of the standing figure is .* beside its .*"]),
    "leaning little": ("human", leaning(5), "unbalanced", []),
    "sliding": (
        "human", standing(0, 0.06, seconds=0.5), "slide",
        2 * [".*_foot slides 60 mm along the ground from 0.00 to 0.50 s, fastest at .* s"]),
    "hardly sliding": ("human", standing(0, 0.04, seconds=0.5), "slide", []),
    "sliding near the ground": (
        "human", standing(0, 0.5, z=0.96, seconds=0.5), "slide", 2 * [".*_foot slides 500 mm along the ground .*"]),
    "slowly near the ground": ("human", standing(0, 0.2, z=0.96, seconds=0.5), "slide", []),
    "above the ground": ("human", standing(0, 0.5, z=0.99, seconds=0.5), "slide", []),
    "a turn about a heel": ("human", turned_about_its_heel(), "slide", ["right_foot slides .*"]),
    "dragging toes": (
        "human", tiptoe(0.12, 0), "drag", [f"{side}_toe drags 120 mm .*" for side in ("left", "right")]),
    "toes do not slide": ("human", tiptoe(0.5, 0), "slide", []),
    "hardly dragging toes": ("human", tiptoe(0.09, 0), "drag", []),
    "toes above the ground": ("human", tiptoe(0.5, 0.01), "drag", []),
}  # fmt: skip


def wrong(problem: Clip, timeline: Timeline | None = None, stop: Stop = Stop.CONVERGED) -> tuple[Violation, ...]:
    """With the raw spline, or with another timeline through its keyframes; figures here may hang in the air."""
    raw = problem.problem.raw
    found = violation.violations_of(Measurement.of(problem, timeline or raw, raw), stop)
    return tuple(each for each in found if each.kind != "aloft")


def of_kind(problem: Clip, kind: str) -> list[Violation]:
    """Those of a kind on the raw spline, by time and name; "": of all kinds but aloft."""
    found = raw_violations(problem) if kind == "aloft" else wrong(problem)
    return sorted((each for each in found if kind in ("", each.kind)), key=lambda v: (v.time or 0.0, v.name))


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_reported_once_and_nothing_else(fault):
    figure, text, kind, expected = FAULTS[fault]
    found = of_kind(read(text, figure), kind)
    assert len(found) == len(expected), found
    for each, pattern in zip(found, expected, strict=True):
        assert re.fullmatch(pattern, each.text)
        assert (each.keyframe is not None) == each.text.startswith(f"keyframe {each.keyframe} itself: ")
        assert each.amount > each.bound and each.unit == BOUNDS[each.kind].unit


@pytest.mark.slow
def test_a_push_in_the_air_just_before_a_flight_is_reported():
    """The feet are in the air too briefly to float, but the figure still accelerates upward."""
    feet: Any = {
        "sites": {f"{side}_heel": [-0.055, y, 0] for side, y in (("left", 0.09), ("right", -0.09))},
        "bodies": {f"{side}_foot": {"flat": True} for side in ("left", "right")},
    }
    keys = [
        Keyframe(0.0, root={"position": [0, 0, 0.92]}, others="rest", **feet),
        Keyframe(0.5, root={"position": [0, 0, 0.7]}, others="previous", **feet),
        Keyframe(0.72, root={"position": [0, 0, 1.25]}, others="rest"),
        Keyframe(0.94, root={"position": [0, 0, 0.7]}, others="rest", **feet),
        Keyframe(1.44, root={"position": [0, 0, 0.92]}, others="rest", **feet),
    ]
    motion = inbetween(build("human", keys, penalties={"flight": {"intervals": [[0.62, 0.82]]}}))
    assert "unsupported" in kinds(motion.violations)


@pytest.mark.parametrize(
    ("text", "expected"),
    [(leaning(30), {"unbalanced"}), (standing(0, 0.5, 0, seconds=0.3), set())],
    ids=["leaning far forward", "faster than friction allows"],
)
def test_of_an_imported_recording_the_balance_is_measured_but_no_force(text, expected, tmp_path):
    saved = solving.raw_spline(read(text, "human"))
    formats.export(saved, "csv", tmp_path / "a.csv")
    found = kinds(import_motion(tmp_path / "a.csv", figure="human").violations)
    assert found & {"unbalanced", "unsupported", "toppling"} == expected


SLIDING = keys(*(f"root.position = [{x}, 0, 0.1]\n{REST}" for x in (0, 0.5, 0)), times=0.3 * np.arange(3))
LIMB = '<body name="{0}" pos="0 0 .2"><joint name="{0}" axis="0 1 0"/>{1}</body>'
TREE = "<mujoco><worldbody><body pos='0 0 .1'><freejoint/>{}</body></worldbody><equality>{}</equality></mujoco>"
SOLID, MASS = '<geom size=".1" mass="1"/>', '<inertial pos="0 0 0" mass="1" diaginertia=".1 .1 .1"/>'
TIE = '<connect body1="a" {} anchor="0 0 0"/>'


@pytest.mark.parametrize(
    ("part", "limbs", "tie", "is_measured"),
    [
        (SOLID, ("a", "b"), "", True),
        (SOLID, ("a", "b"), TIE.format('body2="b"'), True),
        (SOLID, ("a", "b"), TIE.format(""), False),  # the world may carry it
        (SOLID, (), "", False),
        (MASS, ("a",), "", False),
    ],
)
def test_support_is_measured_of_limbed_trees_that_no_loop_ties_to_others(part, limbs, tie, is_measured):
    problem = read(SLIDING, TREE.format(part + "".join(LIMB.format(limb, part) for limb in limbs), tie))
    raw = problem.problem.raw
    assert any(missing_support(Measurement.of(problem, raw, raw))) == is_measured


def unposed(problem: Clip) -> Clip:
    """The clip without the poses of entries that its keyframes leave to the search."""
    return problem.with_problem(keys=tuple(replace(key, posed=None) for key in problem.keys))


def kinds(found: Sequence[Violation]) -> set[str]:
    return {each.kind for each in found}


def with_frame(problem: Clip, time: float, change: np.ndarray) -> Timeline:
    """The raw spline with one more frame, in which the state is another."""
    raw = solving.raw_spline(problem).raw
    return raw.insert([Frame.variable(time, path_of(raw).at(np.array([time]))[0] + change)])


# penetration

LEG_IN_CENTIMETRES = """<body name="{0}_thigh" pos="0 {1} -10"><joint name="{0}_hip" axis="0 1 0"/>
<geom type="capsule" size="5" fromto="0 0 0 0 0 -35"/><body name="{0}_shin" pos="0 0 -40">
<joint name="{0}_knee" axis="0 1 0"/><geom type="capsule" size="4" fromto="0 0 0 0 0 -30"/>
<body name="{0}_foot" pos="0 0 -35"><joint name="{0}_ankle" axis="0 1 0"/>
<geom type="box" size="10 4 2" pos="4 0 -3"/></body></body></body>"""
IN_CENTIMETRES = f"""<mujoco><option gravity="0 0 -981"/><worldbody><geom name="floor" type="plane" size="900 900 9"/>
<body name="pelvis" pos="0 0 90"><freejoint/><geom type="box" size="10 15 10"/>
{LEG_IN_CENTIMETRES.format("left", 10)}{LEG_IN_CENTIMETRES.format("right", -10)}</body></worldbody></mujoco>"""


@pytest.mark.parametrize(("centimetres", "count"), [(0.2, 0), (2.0, 2)])
def test_bounds_of_lengths_hold_in_a_model_in_centimetres(centimetres, count):
    found = of_kind(
        read(keys(f"root.position = [0, 0, {90 - centimetres}]\n{REST}", REST), IN_CENTIMETRES), "penetration"
    )
    assert len({each.name.partition(" ")[0] for each in found}) == count
    assert all(each.bound == pytest.approx(0.5, rel=0.7) for each in found)


SQUAT = keys(REST, REST + "root.position = [0, 0, 0.73]", REST)


def test_a_keyframe_in_the_floor_is_at_fault_in_one_line_and_the_path_to_it_is_not():
    found = wrong(read(SQUAT))
    assert [(each.kind, each.keyframe, each.time, each.unit) for each in found] == 4 * [("penetration", 2, 1.0, "m")]
    assert re.fullmatch(r"keyframe 2 itself: (left|right)_heel is 200 mm in the floor at 1.00 s", found[0].text)
    assert found[0].amount == pytest.approx(0.2, abs=1e-4)
    assert violation.lines(found) == [f"violation: {found[0].text}; 3 more like it there"]


def test_a_path_that_goes_deeper_than_the_keyframes_next_to_it_is_at_fault_too():
    problem = read(SQUAT)
    down = np.zeros(problem.figure.width)
    down[2] = -0.3
    found = wrong(problem, with_frame(problem, 0.8, down))
    path = [each for each in found if each.keyframe is None and each.name.endswith(("heel", "toe"))]
    assert path[0].kind == "penetration" and path[0].text.startswith(f"{path[0].name} is ")
    assert path[0].amount > 0.3
    assert any(each.keyframe == 2 for each in found)


def test_between_frames_a_path_in_the_floor_is_found_as_deep_as_it_is():
    problem = read(keys(*(at(0, 0, z) for z in (1, 0.11, 0.11, 1)), times=(0, 0.5, 1, 1.5)), BALL)
    found = next(each for each in wrong(problem) if each.kind == "penetration")
    run = Sampled.of(solving.raw_spline(problem), 1000.0)
    seen = penetration(problem.figure.model, run.time, run.qpos)
    assert found.amount == pytest.approx(seen.deepest, abs=1e-4)
    assert found.time == pytest.approx(0.75, abs=0.01)
    assert found.text == f"ball is {1000 * seen.deepest:.0f} mm in the floor at {found.time:.2f} s"


@pytest.mark.slow
def test_depths_are_mujocos():
    problem = shipped.loaded("jump_over_box")
    found = [each for each in wrong(problem) if each.kind == "penetration"]
    run = Sampled.of(solving.raw_spline(problem), 240.0)
    seen = penetration(problem.figure.model, run.time, run.qpos)
    assert seen.deepest > 0.02
    assert found[0].amount == pytest.approx(seen.deepest, abs=0.002)
    assert f"in the {seen.worst().split(' in ')[1].split()[0]} " in found[0].text


DECK = """<mujoco><worldbody><body name="cart" pos="0 0 .5"><freejoint name="root"/>
  <geom name="deck" type="box" size=".3 .3 .1" mass="1"/></body></worldbody></mujoco>"""
ROD = """<mujoco><worldbody><body name="arm" pos="0 0 1"><joint name="lift" axis="0 1 0"/>
  <geom name="rod" type="cylinder" size=".04 .5" pos=".5 0 0" euler="0 90 0" mass="1"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize(("above", "is_penalized"), [(0.0, True), (0.02, False)])  # [m]: on the floor it is a step
@pytest.mark.parametrize(
    ("model", "geom", "row", "box"),
    [
        (DECK, "deck", "root.position = [1, 0, 0.5]", "size = [0.06, 0.06, 1.2]\nposition = [1, 0, {}]"),
        (ROD, "rod", "joints.lift = 20", "size = [0.04, 1, 0.9]\nposition = [0.6, 0, {}]"),
    ],
)
def test_a_narrow_obstacle_inside_a_wide_geom_is_reported(model, geom, row, box, above, is_penalized):
    scene = f"[[scene.box]]\nname = 'post'\n{box.format(above + (0.6 if model is DECK else 0.45))}\n"
    off = "" if is_penalized else "[[penalty]]\nkind = 'collision'\nweight = 0\n"
    problem = read(scene + off + keys(row, row), model)
    data = kinematics(posed := problem.figure.model, problem.keys[0].state)
    assert mujoco.mj_geomDistance(posed, data, *(posed.geom(name).id for name in (geom, "post")), 0.1, None) < -0.02
    assert any(v.kind == "penetration" and v.amount > 0.02 for v in wrong(problem))


def deepest(problem: Clip, rate: float) -> float:
    """[m] of any pair of geoms that MuJoCo lets collide, by its distances, along the raw spline."""
    model, data = problem.figure.model, mujoco.MjData(problem.figure.model)
    run = Sampled.of(solving.raw_spline(problem), rate)
    depth = 0.0
    for qpos in run.qpos:
        data.qpos[:] = qpos
        mujoco.mj_forward(model, data)
        for one, two in data.contact.geom.tolist():
            depth = max(depth, -mujoco.mj_geomDistance(model, data, one, two, 1.0, None))
    return depth


SELF = "[[penalty]]\nkind = 'collision'\nself = true\nweight = {self = 1}\nmargin = 0.01\n"


@pytest.mark.parametrize("penalty", ["", SELF])
def test_limbs_in_each_other_are_as_deep_as_mujoco_has_them_whatever_the_clip_penalizes(penalty):
    problem = read(swinging(40, -40) + penalty, TRUNK)
    (found,) = wrong(problem)
    assert found.kind == "self" and found.amount == pytest.approx(deepest(problem, 500), abs=0.002)


@pytest.mark.parametrize(
    ("one", "other", "count"),
    [
        ('geom name="trunk"', 'geom name="trunk" contype="0" conaffinity="2"', 0),
        ('geom name="trunk"', 'geom name="trunk" contype="0" conaffinity="1"', 1),
        ("</worldbody>", '</worldbody><contact><exclude body1="trunk" body2="hand"/></contact>', 0),
        ("</worldbody>", '</worldbody><contact><exclude body1="trunk" body2="arm"/></contact>', 1),
        ("<geom ", '<geom contype="0" conaffinity="0" ', 1),
    ],
)
def test_bodies_collide_as_mujoco_has_it_or_all_of_them_if_none_would(one, other, count):
    problem = read(swinging(40, -40), TRUNK.replace(one, other))
    assert [each.kind for each in wrong(problem)] == ["self"] * count
    assert (deepest(problem, 60) > 0.01) == (count > 0 and 'contype="0" conaffinity="0"' not in other)


@pytest.mark.parametrize("offset", [0.0, 0.004])
def test_hands_that_pass_fast_through_each_other_are_reported(offset):
    """Two balls of 80 mm meet at 0.25 s + offset with 8 m/s: they overlap by more than 10 mm for 17 ms."""
    ball = '<body pos="{} 0 1"><joint name="{}" type="slide" axis="1 0 0"/><geom size=".04" mass="1"/></body>'
    figure = f"<mujoco><worldbody>{ball.format(0, 'a')}{ball.format(1, 'b')}</worldbody></mujoco>"
    rows = (f"joints = {{a = {x}, b = {-x - 1}}}" for x in (-1 - 4 * offset, 1 - 4 * offset))
    (overlap,) = of_kind(read(keys(*rows, times=(0, 0.5)), figure), "self")
    assert 0.04 < overlap.amount < 0.081
    assert overlap.time == pytest.approx(0.25 + offset, abs=0.005)


# places and joints between keyframes


def test_a_joint_that_swings_in_a_hold_is_reported():
    arm = '<mujoco><worldbody><body pos="0 0 2"><joint name="arm"/><geom size=".1"/></body></worldbody></mujoco>'
    problem = read(keys(*(f"joints.arm = {angle}" for angle in (0, 0, 120, 120)), times=(0, 1, 1.3, 2.3)), arm)
    first, second = of_kind(problem, "overshoot")
    raw = np.degrees(problem.figure.to_qpos(path_of(problem.problem.raw).at(np.linspace(0, 1, 1001))))
    assert (first.name, second.name) == ("arm", "arm")
    assert first.amount == pytest.approx(np.abs(raw).max(), abs=0.01)
    assert "away from its values in the keyframes at 0 and 1 s" in first.text
    assert violation.violations(problem, solving.solve(problem, quiet())) == ()


def test_a_contact_that_moves_is_reported_at_its_worst_moment_once_for_a_foot():
    toe = CONTACT.format("toe", 1.2, 1.8)
    problem = read(standing(0, 0, 0.4) + toe)
    (found,) = of_kind(problem, "contact")
    x = path_of(solving.raw_spline(problem).raw).at(np.array([1.2, 1.5, 1.8]))[:, 0]
    assert (found.name, found.keyframe) == ("right_toe", None)
    assert found.amount == pytest.approx(max(x[1] - x[0], x[2] - x[1]), abs=1e-3)
    assert found.time in (1.2, 1.8)
    assert found.text.startswith("contact right_toe is ")
    assert " from the place where it should rest at " in found.text
    (both,) = of_kind(read(standing(0, 0, 0.4) + toe + CONTACT.format("heel", 1.1, 1.7)), "contact")
    assert both.amount >= found.amount
    apart = CONTACT.format("toe", 1.1, 1.4) + CONTACT.format("heel", 1.5, 1.8)
    assert len(of_kind(read(standing(0, 0, 0.4) + apart), "contact")) == 2


def test_a_foot_that_keyframes_leave_standing_slides():
    problem = read(standing(0, 0, 0))
    aside = np.zeros(problem.figure.width)
    aside[1] = 0.05
    found = wrong(problem, with_frame(problem, 0.5, aside))
    assert [each.kind for each in found] == ["stance", "stance"]  # a foot each
    assert found[0].amount == pytest.approx(0.05, abs=0.005)
    assert "between keyframes with the same position at 0.5" in found[0].text


@pytest.mark.parametrize(("step", "reported"), [(0.1, set()), (1.0, {"stance"})])
def test_a_foot_moves_between_samples_of_a_recording_unless_they_are_far_apart(step, reported):
    """A sole on the ground in two neighbouring samples, 25 mm apart, lands or slides between them."""
    standing_still = read(standing(0, 0))
    qpos = np.tile(standing_still.keys[0].state, (4, 1))
    qpos[2:, 0] += 0.025
    recorded = clip.from_qpos("it", standing_still.scene, step * np.arange(4), qpos, 30.0, "it")
    assert kinds(wrong(recorded)) == reported


def test_a_limb_that_whips():
    problem = read(keys(HIGH, HIGH))
    raw = solving.raw_spline(problem).raw
    elbow = next(link for link in problem.figure.links if link.name == "left_elbow").qpos
    state = path_of(raw).at(np.array([0.5]))[0]
    turned = state.copy()
    turn = quat.from_rotation_vector(np.array([0, -1.0, 0]))
    turned[elbow : elbow + 4] = quat.product(turn, state[elbow : elbow + 4])
    frames = [Frame.variable(0.45, state), Frame.variable(0.5, turned), Frame.variable(0.55, state)]
    found = [each for each in wrong(problem, raw.insert(frames)) if each.kind == "whip"]
    assert found[0].name == "left_elbow"
    assert found[0].text.startswith("left_elbow whips: ")
    assert found[0].time == pytest.approx(0.5, abs=0.06)


# the ground


@pytest.mark.parametrize("sets_height", [True, False])
@pytest.mark.parametrize("gravity", [7.0, 9.81, 12.0, 3.0, 20.0])
def test_a_figure_that_falls_too_slowly_or_too_fast_floats(gravity, sets_height):
    text = thrown(gravity) + '[[penalty]]\nkind = "flight"\nweight = 0\nintervals = [[0, 0.01]]\n'
    problem = read(text, ON_FLOOR)
    masks = (np.where(np.arange(key.fixed.size) == 2, sets_height, key.fixed) for key in problem.keys)
    keys = [replace(key, fixed=mask) for key, mask in zip(problem.keys, masks, strict=True)]
    raw = solving.raw_spline(problem).raw
    floats = [each for each in wrong(problem.with_problem(keys=tuple(keys)), raw) if each.kind == "float"]
    assert len(floats) == (gravity in (3.0, 20.0))
    for each in floats:
        assert each.amount == pytest.approx(gravity * 0.25**2 / 2, abs=1e-3)
        assert each.time == pytest.approx(0.35)
        # neither a fast fall nor a height that is free is the fault of a keyframe
        assert each.keyframe == (8 if gravity < 9.81 and sets_height else None)


# recordings

BARREL = """
<mujoco><worldbody>
  <body name="barrel" pos="0 0 .5"><freejoint name="root"/><geom name="barrel" type="box" size=".25 .25 .25"/>
    <body name="arm" pos="0 .3 0"><joint name="swing" axis="0 1 0"/>
      <geom type="capsule" size=".04" fromto="0 0 0 0 0 -.2"/></body></body>
</worldbody></mujoco>"""


def following(folder: Path, places: Sequence[Sequence[float]], text: str) -> list[Violation]:
    """The violations of a clip that follows a motion of the barrel through places at rest."""
    (folder / "barrel.xml").write_text(BARREL, encoding="utf-8")
    rows = [Keyframe(float(t), root={"position": place}, others="rest") for t, place in enumerate(places)]
    inbetween(build(str(folder / "barrel.xml"), rows)).save(folder / "rec.npz")
    text = f'figure = "barrel.xml"\n[recording]\nfile = "rec.npz"\n{text}joints.swing = 20\n'
    (folder / "follow.toml").write_text(text, encoding="utf-8")
    return inbetween(load(str(folder / "follow.toml"))).violations


def test_an_obstacle_inside_a_body_that_follows_a_recording_is_reported(tmp_path):
    rail = '[[scene.capsule]]\nname = "rail"\nfrom = [0.15, -2, 0.55]\nto = [0.15, 2, 0.55]\nradius = 0.02\n'
    found = following(tmp_path, [(0, 0, 0.5), (0, 0.3, 0.5), (0, 0, 0.5)], f"{rail}[[keyframe]]\ntime = 1\n")
    (deep,) = [each for each in found if each.kind == "penetration"]
    assert deep.name == "barrel" and deep.amount == pytest.approx(0.12, abs=0.008)  # from the rail's far side
    assert [each.keyframe for each in found if each.kind == "aloft"] == [None]  # a fault of the recording


# the search, order and number of lines


def test_a_search_that_ended_early():
    problem = read(hung(0.55, 0.55), ON_FLOOR)
    for stop in Stop:
        found = [(each.kind, each.time, each.text) for each in wrong(problem, stop=stop)]
        is_early = stop in (Stop.MAX_EVALUATIONS, Stop.NO_PROGRESS)
        assert found == ([("search", None, f"the search ended early: {stop.value}")] if is_early else [])


def test_the_worst_comes_first_by_how_many_times_its_bound_it_is():
    text = SQUAT + "joints.left_knee = {rotvec = [0, -20, 0]}\n" + CONTACT.format("toe", 0.3, 0.9)
    found = wrong(read(text), stop=Stop.MAX_EVALUATIONS)
    assert len(kinds(found)) >= 4
    severities = [each.amount / each.bound for each in found]
    assert severities == sorted(severities, reverse=True) == [each.severity for each in found]
    assert all(severity >= 1 for severity in severities)
    assert len(set(found)) == len(found)


def test_of_many_lines_the_worst_are_reported_and_the_rest_counted():
    many = [
        Violation("range", f"joint {i}", 0.1, 20.0 - i, "degrees", 2.0, None, f"joint {i} is off") for i in range(14)
    ]
    lines = violation.lines(many, "it.npz")
    assert lines[:2] == ["violation: joint 0 is off", "violation: joint 1 is off"]
    assert lines[10:] == ["... and 4 more: dynsplines report it.npz"]
    assert violation.lines(many[:10]) == lines[:10]
    assert violation.lines([]) == []
    two = [replace(each, kind="speed", amount=4.0 - i, text=f"{i} is fast") for i, each in enumerate(many[:2])]
    assert violation.lines([*many, *two]) == [
        *lines[:8],
        *(f"violation: {i} is fast" for i in range(2)),
        "... and 6 more",
    ]


# of motions in files


def test_edited_motions_have_the_violations_of_their_samples_and_not_of_the_clip():
    """A contact that moves is a fault of the clip; feet that slide are in the samples."""
    problem = unposed(read(standing(0, 0, 0.4) + CONTACT.format("toe", 1.2, 1.8)))
    walked = solving.raw_spline(problem)

    def found(saved: motion.Saved) -> set[tuple[str, str]]:
        return {(each.kind, each.name) for each in violation.violations(clip_from_motion(saved), saved)}

    assert found(walked) >= {("contact", "right_toe")}
    slides = {("slide", f"{side}_foot") for side in ("left", "right")}
    stances = {("stance", f"{side}_toe") for side in ("left", "right")}
    assert found(edits.mirror(walked)) == found(edits.retime(walked, 2.0)) == slides | stances
    assert found(edits.trim(walked, 1.1, 2.0)) == slides
    assert found(replace(walked, text="figure = ")) == found(edits.without_clip(walked))  # an unreadable clip


@pytest.mark.slow
def test_why_the_search_ended_is_in_the_file(tmp_path):
    rows = [Keyframe(t, root={"position": [0, 0, z]}, others="rest") for t, z in ((0, 1), (0.8, 1.4), (1, 1))]
    found = inbetween(build("spinner", rows, solve={"evaluations": 2, "tolerance": 1e-12}))
    assert [each.kind for each in found.violations].count("search") == 1
    found.save(tmp_path / "m.npz")
    assert motion.load(tmp_path / "m.npz").report == {}
    again = load_motion(tmp_path / "m.npz")
    assert [each.text for each in again.violations] == [each.text for each in found.violations]
    assert again.report()["evaluations"] == found.saved.search["evaluations"] > 0
    assert found.saved.search["seconds"] > 0
    assert "seconds" not in again.report()  # a file knows no clock
    assert again.report()["stopped because"] == Stop.MAX_EVALUATIONS.value
    assert [each["text"] for each in again.report()["violations"]] == [each.text for each in found.violations]
    assert str(again.report()).splitlines()[0].startswith("violation: ")
    again.save(tmp_path / "measured.npz")
    assert motion.load(tmp_path / "measured.npz").report["keyframes"] == 3


def test_the_bounds_of_the_page_are_those_of_the_code():
    """A row for every bound, or one for two of the same size."""
    page = (Path(__file__).parents[3] / "docs" / "check.md").read_text(encoding="utf-8").split("## The report")[0]
    listed = {}
    for names, most in re.findall(r"^\| (`[^|]+`) \| ([^|]+) \|", page, flags=re.MULTILINE):
        listed |= dict.fromkeys(re.findall(r"`([^`]+)`", names), most)
    words = {"m": lambda most: f"{1000 * most:g} mm", "degrees": lambda most: f"{most:g}°"}
    bounds = {
        kind: words.get(bound.unit, lambda most, unit=bound.unit: f"{most:g} {unit}".strip())(bound.most)
        for kind, bound in BOUNDS.items()
    }
    assert listed == bounds | {"search": "–"}
    assert f"{WHIP_SHARE:g} times the largest one of all limbs in the raw spline" in page
