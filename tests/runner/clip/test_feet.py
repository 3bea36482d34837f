"""The points on which figures stand, and keyframes that are put down on the ground."""

import mujoco
import numpy as np
import pytest
from figures import BIPED
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import kinematics
from rekeyed import with_keys

from dynsplines import Keyframe, build, inbetween, recordings
from dynsplines.clip.build import Clip
from dynsplines.clip.posing.grounding import _beside
from dynsplines.clip.posing.places import Places, sole_points, sphere_at
from dynsplines.solver.array import Array
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure

LEG = """<body name="{name}_thigh" pos="{x} {y} 0"><joint name="{name}_hip" axis="0 1 0"/>
  <geom type="capsule" size=".03" fromto="0 0 0 0 0 -.3"/>
  <body name="{name}_shin" pos="0 0 -.3"><joint name="{name}_knee" axis="0 1 0"/>
    <geom type="capsule" size=".02" fromto="0 0 0 0 0 -.3"/>{foot}</body></body>"""


SPHERE = '<geom name="{name}_foot" size=".04" pos="0 0 -.3"/>'


BOX = """<body name="{name}_ankle" pos="0 0 -.3"><joint name="{name}_ankle" axis="0 1 0"/>
  <geom name="{name}_sole" type="box" size=".1 .04 .01" pos=".03 0 -.03"/></body>"""


SITE = '<site name="{name}_toe" pos="0 0 -.34"/>'


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
        found = sphere_at(figure, mark)
        np.testing.assert_allclose((*found.position, found.radius), (*centre, radius), atol=1e-9)
        assert (found.name, found.link) == (mark.name, mark.link)


def test_feet_of_level_legs_are_those_of_the_rest_pose_within_the_ranges():
    assert soles(spider("40 80")) == ["leg0", "leg90", "leg180", "leg270"]
    assert soles(spider("-40 80")) == []  # the rest pose is within the ranges
    assert soles(spider("1 80")) == []  # the trunk is still lower


HEAD = 'figure = "human"\n'


STANDING = 'others = "rest"\n'  # at 0.93 m


AIRBORNE = 'others = "rest"\nroot.position = [0, 0, 1.5]\n'


CROUCHED = """others = "rest"
joints.left_hip = {rotvec = [0, -80, 0]}
joints.left_knee = {rotvec = [0, 100, 0]}
joints.right_hip = {rotvec = [0, -80, 0]}
joints.right_knee = {rotvec = [0, 100, 0]}
joints.left_ankle = {rotvec = [0, -20, 0]}
joints.right_ankle = {rotvec = [0, -20, 0]}
"""


LANDING = {"left_hip": -60, "right_hip": -60, "left_knee": 70, "right_knee": 70}
OPEN = 'root.position = [0, 0, "free"]\n'


NEARLY = 2e-3  # [m] that marks on soles and the geoms round them differ by


def read(*bodies: str, head: str = HEAD, tail: str = "") -> Clip:
    """Keyframes half a second apart."""
    keys = "".join(f"[[keyframe]]\ntime = {i / 2}\n{body}" for i, body in enumerate(bodies))
    return recordings.from_text(f"{head}{keys}{tail}", name="c")


def clearance(problem: Clip, qpos: Array) -> float:
    """[m] between the geoms that move and those that do not, by MuJoCo; negative for a depth."""
    model = problem.figure.model
    data = kinematics(model, qpos)
    moves = model.body_weldid[model.geom_bodyid] != 0
    fixed, moving = np.flatnonzero(~moves), np.flatnonzero(moves)
    return min(mujoco.mj_geomDistance(model, data, int(a), int(b), 3.0, None) for a in fixed for b in moving)


def site(problem: Clip, qpos: Array, name: str) -> Array:
    data = kinematics(problem.figure.model, qpos)
    return np.array(data.site(name).xpos)


def path(problem: Clip, count: int = 60) -> Array:
    """qpos (count, nq) along the motion."""
    motion = inbetween(problem)
    return motion.at(np.linspace(motion.start, motion.end, count))


def test_legs_that_are_bent_stand_on_the_ground():
    problem = read(STANDING, CROUCHED + OPEN, STANDING)
    key = problem.keys[1]
    assert clearance(problem, key.state) == pytest.approx(0, abs=NEARLY)
    assert key.state[2] < 0.7
    up = np.eye(key.state.size)[2]
    high = Frame(key.time, key.state + 0.4 * up, key.fixed & (up == 0))
    again = with_keys(problem, [problem.keys[0], high, problem.keys[2]])
    assert again.keys[1].state[2] == pytest.approx(key.state[2], abs=1e-6)


def test_a_step_at_walking_speed_is_on_the_ground_where_its_height_is_free():
    stride = """others = "rest"
root.position = [0.5, 0, "free"]
joints.left_hip = {rotvec = [0, -30, 0]}
joints.right_hip = {rotvec = [0, 20, 0]}
joints.right_knee = {rotvec = [0, 20, 0]}
"""
    problem = read(STANDING, stride, STANDING + "root.position = [1.0, 0, 0.93]\n")
    assert clearance(problem, inbetween(problem).at([0.5])[0]) == pytest.approx(0, abs=NEARLY)


@settings(deadline=None, max_examples=3)
@given(st.lists(st.floats(-90, 90), min_size=6, max_size=6), st.floats(-40, 40))
def test_any_pose_does_to_a_hair(angles, lean):
    legs = "".join(
        f"joints.{side}_{joint} = {{rotvec = [0, {angles.pop():.3f}, 0]}}\n"
        for side in ("left", "right")
        for joint in ("hip", "knee", "ankle")
    )
    turn = f"root.rotation = {{rotvec = [{lean:.3f}, 0, 0]}}\n"
    problem = read(STANDING, f'others = "rest"\n{legs}{turn}{OPEN}', STANDING)
    assert clearance(problem, problem.keys[1].state) == pytest.approx(0, abs=0.02)  # by the mesh of a head or a hand


def test_the_ground_carries_who_stands_before_and_after_a_fall_and_while_no_keyframe_tells_the_height():
    waves = read(STANDING, "joints.left_shoulder = {rotvec = [0, 20, 0]}\n", STANDING)
    assert waves.context.schedule.grounded_intervals == ((0.0, 0.5), (0.5, 1.0))
    schedule = read(STANDING, STANDING + "root.position = [0, 0, 1.6]\n", STANDING).context.schedule
    ((first, last),), (before, after) = schedule.flights, schedule.grounded_intervals
    assert 0 == before[0] < before[1] < first < last < after[0] < after[1] == 1


def test_a_figure_of_no_height_but_the_first_does_not_float_away():
    above = 'others = "rest"\nroot.position = [0, 0, 1.1]\n'
    problem = read(above, CROUCHED + OPEN, f"{STANDING}{OPEN}", CROUCHED + OPEN)
    assert [clearance(problem, key.state) for key in problem.keys[1:]] == pytest.approx([0] * 3, abs=NEARLY)
    hangs = read(above, "joints.left_shoulder = {rotvec = [0, -80, 0]}\n")
    assert clearance(hangs, hangs.keys[1].state) == pytest.approx(0, abs=NEARLY)


def test_feet_stay_where_they_stand_if_the_root_may_go_anywhere():
    problem = read(STANDING, f'{CROUCHED}root.position = "free"\n', STANDING)
    at = {name: site(problem, problem.keys[0].state, name) for name in ("left_heel", "right_toe")}
    for name, place in at.items():
        np.testing.assert_allclose(site(problem, problem.keys[1].state, name), place, atol=1e-3)
    assert problem.keys[1].state[0] < -0.2  # the pelvis goes back over the heels
    key = read(STANDING, f'{CROUCHED}root.position = ["free", 0.02, "free"]\n', STANDING).keys[1]
    assert key.state[1] == 0.02 and key.fixed[:3].tolist() == [False, True, False]
    assert key.state[0] < -0.2
    seen = path(problem)
    for name, place in at.items():
        assert max(np.linalg.norm((site(problem, qpos, name) - place)[:2]) for qpos in seen) < 0.01


FREE_LEGS = "".join(f'joints.{s}_{j} = "free"\n' for s in ("left", "right") for j in ("hip", "knee", "ankle"))


@pytest.mark.parametrize(
    "free",
    [
        f'others = "previous"\nroot.position = ["free", "free", 0.75]\n{FREE_LEGS}',
        "sites.left_hand = [0.45, 0.1, 0.9]\n",
    ],
    ids=["squat", "reach"],
)
def test_free_legs_keep_their_feet_and_balance_between_keyframes_that_are_put_down(free):
    problem = read(STANDING + OPEN, free, STANDING + OPEN)
    at = {
        f"{s}_{end}": site(problem, problem.keys[0].state, f"{s}_{end}")
        for s in ("left", "right")
        for end in ("heel", "toe")
    }
    lower, upper = np.min(list(at.values()), axis=0)[:2], np.max(list(at.values()), axis=0)[:2]
    for qpos in path(problem):
        centre = kinematics(problem.figure.model, qpos).subtree_com[1]
        assert np.all((centre[:2] > lower) & (centre[:2] < upper))
        for name, place in at.items():
            assert np.linalg.norm(site(problem, qpos, name) - place) < 0.01


@pytest.mark.parametrize("height", [0.7, 0.5, 0.3])
def test_a_squat_is_posed_over_the_middle_of_the_feet(height, tmp_path):
    """From straight legs, leaning is nearer in angles than bending both knees."""
    (tmp_path / "biped.xml").write_text(BIPED, encoding="utf-8")
    squat = Keyframe(1, root={"position": ["free", "free", height]})
    clip = build(str(tmp_path / "biped.xml"), [Keyframe(0, others="rest"), squat, Keyframe(2, others="rest")])
    state = kinematics(clip.figure.model, clip.keys[1].state)
    feet = [state.body(f"{side}_foot").xpos + np.array([0.04, 0, 0]) for side in ("left", "right")]
    np.testing.assert_allclose(state.subtree_com[1][:2], np.mean(feet, axis=0)[:2], atol=0.006)
    assert state.qpos[1] == pytest.approx(0, abs=1e-3)


def test_feet_that_stay_keep_their_heading_beyond_a_keyframe_that_leaves_the_legs_free():
    """Of a figure that turns, while a keyframe before specifies only a hand."""
    turned = """root.rotation = {heading = 15}
sites = {left_heel = [-0.055, 0.09, 0], right_heel = [-0.055, -0.09, 0]}
bodies = {left_foot = {flat = true}, right_foot = {flat = true}}
joints.spine = {rotvec = [0, 0, 20]}
"""
    texts = ('others = "rest"\n', "sites.right_hand = [0.3, -0.2, 1.15]\n", turned)
    keys = [f"[[keyframe]]\ntime = {0.7 * i:g}\n{text}" for i, text in enumerate(texts)]
    problem = recordings.from_text('figure = "human"\n' + "".join(keys), name="c")
    for toe in ("left_toe", "right_toe"):
        first, last = (kinematics(problem.figure.model, problem.keys[i].state).site(toe).xpos for i in (0, 2))
        np.testing.assert_allclose(last, first, atol=0.005)


def test_a_figure_with_one_foot_in_the_air_is_posed_above_the_other():
    lifted = """others = "previous"
root.position = "free"
sites = {left_heel = [-0.055, 0.09, 0.2], right_heel = [-0.055, -0.09, 0]}
bodies = {left_foot = {flat = true}, right_foot = {flat = true}}
"""
    keys = [f"[[keyframe]]\ntime = {time}\n{body}" for time, body in ((0, STANDING), (1.5, lifted), (3, STANDING))]
    problem = recordings.from_text(HEAD + "".join(keys), name="c")
    centre = kinematics(problem.figure.model, problem.keys[1].state).subtree_com[1]
    assert centre[1] == pytest.approx(-0.09, abs=0.025)  # above the right foot, whose sole is 27 mm wide
    assert "unbalanced" not in {violation.kind for violation in inbetween(problem).violations}


def test_objects_do_not_change_a_pose_in_balance():
    box = 'scene.box = [{body = "toy", size = [0.1, 0.1, 0.1]}]\n'
    placed = "roots.toy = {position = [3, 0, 0.05], rotation = {rotvec = [0, 0, 0]}}\n"
    reach = """others = "previous"
root = {position = "free", rotation = {rotvec = [0, 40, 0]}}
sites = {left_heel = [-0.055, 0.09, 0], right_heel = [-0.055, -0.09, 0], right_hand = [0.4, -0.18, 0.25]}
bodies = {left_foot = {flat = true}, right_foot = {flat = true}}
"""
    alone, beside = read(STANDING, reach), read(placed + STANDING, reach, head=HEAD + box)
    poses = [clip.figure.to_qpos(clip.keys[1].state)[: alone.figure.width] for clip in (alone, beside)]
    np.testing.assert_allclose(poses[0], poses[1], atol=1e-6)
    assert poses[0][0] < 0.1  # the pelvis stays over the feet


def test_feet_that_are_far_from_where_they_stood_do_not_drag_the_root_along():
    lunge = """others = "rest"
joints.left_hip = {rotvec = [0, -50, 0]}
joints.right_hip = {rotvec = [0, 50, 0]}
joints.left_ankle = {rotvec = [0, 50, 0]}
joints.right_ankle = {rotvec = [0, -50, 0]}
root.position = "free"
"""
    problem = read(STANDING, lunge, STANDING)
    key = problem.keys[1]
    assert clearance(problem, key.state) == pytest.approx(0, abs=NEARLY)
    assert key.posed is not None and key.posed[:3].tolist() == [False, False, True]


@pytest.mark.parametrize(
    ("bodies", "tail"),
    [
        ((AIRBORNE, CROUCHED + OPEN, AIRBORNE), ""),
        ((STANDING, CROUCHED + OPEN, STANDING), '[[penalty]]\nkind = "flight"\nintervals = [[0.2, 0.8]]\n'),
        (('others = "rest"\nroot.position = [0, 0, 3]\n', CROUCHED + OPEN), ""),
        (
            (
                STANDING,
                "joints.left_hip = {rotvec = [0, -80, 0]}\njoints.right_hip = {rotvec = [0, -70, 0]}\n",
                AIRBORNE,
            ),
            "",
        ),
    ],
    ids=["between two in the air", "in a flight", "high up", "of legs that are not known"],
)
def test_what_is_in_doubt_is_left(bodies, tail):
    key = read(*bodies, tail=tail).keys[1]
    assert key.posed is None or not key.posed[2]


def test_a_leap_between_crouches_stays_one():
    """However low: the figure leaves the ground well before its apex, and comes back well after."""
    apex = 1.08
    hop = CROUCHED.replace("-80", "-50").replace("100", "70") + OPEN
    problem = read(STANDING, hop, f'others = "rest"\nroot.position = [0, 0, {apex}]\n', hop, STANDING)
    z = inbetween(problem).at(np.linspace(0.5, 1.5, 101))[:, 2]
    assert z[50] == pytest.approx(apex) and z.max() < apex + 0.03
    assert np.abs(np.diff(z, 2)).max() / 0.01**2 < 30  # [m/s²]; if it is held down until the last moment, 60 and more


def test_a_landing_with_free_ankles_and_arms_is_on_the_ground():
    lands = "".join(f"joints.{name} = {{rotvec = [0, {angle}, 0]}}\n" for name, angle in LANDING.items())
    key = read(AIRBORNE, f"root.rotation = {{rotvec = [0, 15, 0]}}\n{lands}{OPEN}", STANDING).keys[1]
    assert key.fixed[2] and key.state[2] < 0.85


def test_a_jump_of_which_only_the_top_has_a_height_starts_and_ends_on_the_ground():
    top = 'others = "rest"\nroot.position = [0, 0, 1.35]\n'
    problem = read(STANDING + OPEN, CROUCHED + OPEN, top, CROUCHED + OPEN, STANDING + OPEN)
    assert [clearance(problem, key.state) for key in problem.keys if key.time != 1.0] == pytest.approx(
        [0] * 4, abs=NEARLY
    )
    ((first, last),) = problem.context.schedule.flights
    assert 0.5 < first < 1 < last < 1.5
    key = read(top, 'others = "rest"\n' + OPEN).keys[1]
    assert key.posed is None or not key.posed[2]  # half a second may be a fall


BOX_GROUNDING = '[[scene.box]]\nname = "box"\nsize = [{}]\nposition = [{}]\n'


BEAM, TABLE = (
    HEAD + BOX_GROUNDING.format(*box) for box in (("0.1, 3, 0.1", "0, 0, 1.47"), ("0.8, 1, 0.05", "0.6, 0, 0.75"))
)


BEFORE_IT, BEHIND_IT = "root.position = [-1, 0, 0.93]\n", "root.position = [1, 0, 0.93]\n"


REACHING = (
    f"{CROUCHED}joints.left_shoulder = {{rotvec = [0, -80, 0]}}\njoints.right_shoulder = {{rotvec = [0, -80, 0]}}\n"
)


@pytest.mark.parametrize(
    ("head", "bodies"),
    [
        (BEAM, (f"{STANDING}{BEFORE_IT}", CROUCHED + OPEN, f"{STANDING}{BEHIND_IT}")),
        (TABLE, (f"{STANDING}{OPEN}", REACHING + OPEN)),
    ],
    ids=["beam", "table"],
)  # fmt: skip
def test_it_stands_under_what_is_over_it(head, bodies):
    problem = read(*bodies, head=head)
    assert problem.keys[1].state[2] == pytest.approx(0.562, abs=0.005)


def test_it_sits_and_stands_on_what_is_under_it():
    chair = HEAD + BOX_GROUNDING.format("0.42, 0.6, 0.45", "-0.3, 0, 0.225")
    sitting = CROUCHED.replace("-80", "-85").replace("100", "85").replace("-20", "0")
    problem = read(STANDING, f'{sitting}root.position = [-0.4, 0, "free"]\n', STANDING, head=chair)
    assert 0.53 < problem.keys[1].state[2] < 0.63
    assert clearance(problem, problem.keys[1].state) == pytest.approx(0, abs=0.02)
    up = 'others = "rest"\nroot.position = [0.8, 0, "free"]\n'
    step = f"{HEAD}[scene]\nstep = {{x = 0.3, height = 0.27}}\n"
    key = read(STANDING, up, 'others = "rest"\nroot.position = [1.2, 0, 1.2]\n', head=step).keys[1]
    assert key.state[2] == pytest.approx(0.93 + 0.27, abs=NEARLY)


def test_it_does_not_go_into_a_wall_to_keep_its_feet():
    wall = HEAD + BOX_GROUNDING.format("0.2, 3, 2", "-0.3, 0, 1")
    key = read(STANDING, f'{CROUCHED}root.position = "free"\n', STANDING, head=wall).keys[1]
    assert key.state[0] == 0 and key.posed is not None and key.posed[:3].tolist() == [False, False, True]


def test_who_stands_on_what_moves_is_left_there():
    board = 'figure = "human"\n[[scene.box]]\nname = "board"\nbody = "crate"\nsize = [0.8, 0.4, 0.1]\nmass = 5\n'
    on = "roots.crate = {position = [0.05, 0, 0.05]}\n"
    up = f"{STANDING}{on}root.position = [0, 0, 1.03]\n"
    key = read(up, CROUCHED + OPEN + on, up, head=board).keys[1]
    assert key.posed is None or not key.posed[2]


def test_in_a_loop_its_end_is_its_beginning():
    loop = '[solve]\nends = "periodic"\n'
    problem = read(STANDING, CROUCHED + OPEN, STANDING, tail=loop)
    assert clearance(problem, problem.keys[1].state) == pytest.approx(0, abs=NEARLY)
    of_none = read(f"{CROUCHED}{OPEN}", STANDING, f"{CROUCHED}{OPEN}", tail=loop).problem.raw
    assert of_none.states[0, 2] == of_none.states[2, 2] < 0.7


def test_named_bodies_are_as_high_as_their_lowest_point_at_rest_and_named_geoms_as_large_as_a_ball_in_them():
    figure = figure_of({"left": (0, 0)}, BOX)
    radii = {name: Places(figure).named_point(name, "test").radius for name in ("left_ankle", "left_shin", "left_sole")}
    assert radii == pytest.approx({"left_ankle": 0.04, "left_shin": 0.32, "left_sole": 0.01})


@pytest.mark.parametrize(
    ("k", "in_loop", "otherwise"), [(0, [3, 1], [1]), (2, [1, 3], [1, 3]), (4, [3, 1], [3]), (1, [3, 3], [3])]
)
def test_keyframes_beside_one_are_across_the_end_of_a_loop(k, in_loop, otherwise):
    sets_height = np.array([False, True, False, True, False])
    assert _beside(sets_height, k, loop=True) == in_loop
    assert _beside(sets_height, k, loop=False) == otherwise
    assert _beside(~sets_height & sets_height, k, loop=True) == []
