"""Keyframes by position, and the names of points and bodies."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
from figures import figure_of, link_named
from oracles import kinematics
from problems import HINGE
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.clip import load as clip
from dynsplines.clip.build import Clip
from dynsplines.clip.mirror import mirrored_tables
from dynsplines.clip.parse import parse
from dynsplines.clip.posing.places import Places, posable_sites, sole_points
from dynsplines.clip.table import ClipTable, KeyframeTable, PenaltyTable, RecordingTable
from dynsplines.edit.files import retimed_tables
from dynsplines.errors import UserError
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.posing import MET

HEAD = 'figure = "human"\n'


REST = HEAD + '[[keyframe]]\ntime = 0.0\nothers = "rest"\n'


STEP = "sites.left_toe = [0.4, 0.1, 0.27]\nbodies.left_foot = {flat = true}\n"


def read(text: str, name: str = "c") -> Clip:
    return recordings.from_text(text, name=name)


ARM = """<body name="{0}_arm" pos="0 {1} 1"><joint name="{0}_shoulder" axis="0 1 0"/>
  <geom type="capsule" size=".03" fromto="0 0 0 .3 0 0"/><site name="{0}_hand" pos=".3 0 0"/></body>"""
ARMS = f"<mujoco><worldbody>{ARM.format('left', 0.2)}{ARM.format('right', -0.2)}</worldbody></mujoco>"


def arms(*bodies: str) -> str:
    """Keyframes of two arms of 0.3 m, one a second."""
    keys = "".join(f"[[keyframe]]\ntime = {t}\n{body}" for t, body in enumerate(bodies))
    return f'figure = "arms.xml"\n{keys}'


def read_arms(*bodies: str) -> Clip:
    return recordings.from_text(arms(*bodies), name="arms", spec=mujoco.MjSpec.from_string(ARMS))


def second(body: str, first: str = REST) -> str:
    return f"{first}[[keyframe]]\ntime = 0.8\n{body}"


def seen(problem: Clip, qpos: np.ndarray) -> mujoco.MjData:
    return kinematics(problem.figure.model, qpos)


def fixed_joints(problem: Clip, key: Frame) -> set[str]:
    size = {0: 7, 1: 4, 2: 1, 3: 1}
    links = problem.figure.links[1:]
    return {link.name for link in links if key.fixed[link.qpos : link.qpos + size[int(link.kind)]].all()}


EVERY = {"root", "spine"} | {
    f"{s}_{j}" for s in ("left", "right") for j in ("shoulder", "elbow", "hip", "knee", "ankle")
}


@pytest.mark.slow
@pytest.mark.parametrize("others", ["free", "previous"])
def test_a_site_is_where_the_keyframe_specifies_and_stays_so_in_the_motion(others):
    text = second(f'others = "{others}"\n{STEP}') + '[[keyframe]]\ntime = 1.4\nothers = "previous"\n'
    problem = read(text)
    rest, key, held = problem.keys
    data = seen(problem, key.state)
    np.testing.assert_allclose(data.site("left_toe").xpos, [0.4, 0.1, 0.27], atol=MET)
    np.testing.assert_allclose(data.body("left_foot").xmat.reshape(3, 3)[2], [0, 0, 1], atol=1e-5)
    leg = {"left_hip", "left_knee", "left_ankle"}
    assert fixed_joints(problem, key) == (EVERY if others != "free" else {"root"} | leg)
    if others != "free":
        same = {n for n in EVERY if np.array_equal(_own(problem, key.state, n), _own(problem, rest.state, n))}
        assert same == EVERY - leg
        np.testing.assert_array_equal(held.state, key.state)
    raw = solving.raw_spline(problem)
    there = seen(problem, raw.at(0.8)[0]).site("left_toe").xpos
    np.testing.assert_allclose(there, [0.4, 0.1, 0.27], atol=MET)


def _own(problem: Clip, qpos: np.ndarray, name: str) -> np.ndarray:
    link = problem.figure.links[link_named(problem.figure, name) or 0]
    return qpos[link.qpos : link.qpos + (7 if name == "root" else 4)]


def test_what_is_given_stays_to_the_bit_the_rest_of_the_limb_gives_way_and_a_body_is_turned_in_the_world():
    body = 'others = "previous"\njoints.left_knee = {rotvec = [0, 70, 0]}\nsites.left_heel = [0.15, "free", 0.3]\n'
    problem = read(
        second(f"{body}bodies.chest = {{rotvec = [0, -10, 20]}}\nroot.rotation = {{rotvec = [0, 10, 40]}}\n")
    )
    key = problem.keys[1]
    knee = quat.from_rotation_vector([0, np.radians(70), 0])
    np.testing.assert_array_equal(_own(problem, key.state, "left_knee"), knee)
    data = seen(problem, key.state)
    np.testing.assert_allclose(data.site("left_heel").xpos[[0, 2]], [0.15, 0.3], atol=MET)
    assert not np.array_equal(_own(problem, key.state, "left_hip"), [1, 0, 0, 0])
    wanted = quat.from_rotation_vector(np.radians([0, -10, 20]))
    assert quat.angle_between(data.body("chest").xquat, wanted) < 1e-5


@pytest.mark.slow
def test_a_loop_can_begin_and_end_by_position():
    text = HEAD + '[solve]\nends = "periodic"\n'
    for i in range(3):
        text += f"[[keyframe]]\ntime = {i}\n{STEP if i != 1 else 'root.position = [0, 0, 0.9]'}\n"
    problem = read(text)
    np.testing.assert_allclose(problem.keys[0].state, problem.keys[2].state, atol=1e-12)
    np.testing.assert_allclose(seen(problem, problem.keys[2].state).site("left_toe").xpos, [0.4, 0.1, 0.27], atol=MET)


def test_it_takes_the_pose_nearest_to_the_neighbouring_path():
    """A hand between two keyframes that hold it high and low stays near them; a knee bends forward."""
    arm = "joints.left_shoulder = {{rotvec = [0, {}, 0]}}\njoints.left_elbow = {{rotvec = [0, -40, 0]}}\n"
    text = f'{HEAD}[[keyframe]]\ntime = 0\nothers = "rest"\n{arm.format(-20)}'
    text += '[[keyframe]]\ntime = 0.5\nothers = "rest"\nsites.left_hand = ["free", "free", 1.0]\n'
    text += f'[[keyframe]]\ntime = 1\nothers = "rest"\n{arm.format(-60)}'
    problem = read(text)
    shoulder = np.degrees(quat.rotation_vector(_own(problem, problem.keys[1].state, "left_shoulder")))
    assert -60 < shoulder[1] < -20
    np.testing.assert_allclose(shoulder[[0, 2]], 0, atol=5)
    assert seen(problem, problem.keys[1].state).site("left_hand").xpos[2] == pytest.approx(1.0, abs=MET)


def test_hinges_and_slides_are_solved_too(tmp_path):
    tip = 'mass="1"/><site name="tip" pos="0 0 -.3"/>\n      </body>'
    figure = HINGE.format(keys="").replace('mass="1"/>\n      </body>', tip)
    (tmp_path / "h.xml").write_text(figure, encoding="utf-8")
    text = 'figure = "h.xml"\n[[keyframe]]\ntime = 0\njoints.swing = 0\njoints.slide = 0\n'
    text += "[[keyframe]]\ntime = 1\nsites.tip = [0.5, 0, 0.6]\n"
    problem = recordings.from_text(text, name="h", folder=tmp_path)
    assert problem.keys[1].is_key
    np.testing.assert_allclose(seen(problem, problem.keys[1].state).site("tip").xpos, [0.5, 0, 0.6], atol=MET)


FAR = "sites.{}_hand = [3, 0, 1]\n"


def test_all_places_without_a_pose_are_reported_at_once():
    with pytest.raises(UserError) as caught:
        read_arms('others = "rest"\n', FAR.format("left") + FAR.format("right"), FAR.format("right"))
    told = str(caught.value)
    assert told.count("no pose found that puts site") == 3 and "\n" not in told
    hand = "keyframe 2 (t = 1 s): no pose found that puts site 'left_hand'"
    assert all(words in told for words in (hand, "'right_hand'", "keyframe 3 (t = 2 s)"))


def test_an_unmet_position_of_a_body_is_not_reported_as_that_of_the_site_that_names_it():
    with pytest.raises(UserError, match=r"no pose found that puts body '(?!left_hand)\w+' at \(3, 0, 1\)"):
        read_arms('others = "rest"\n', "bodies.left_hand = {position = [3, 0, 1]}\n")


def test_a_place_without_a_pose_is_as_near_as_it_comes_where_that_is_wanted():
    unmet: list[str] = []
    text = arms('others = "rest"\n', "sites.left_hand = [0, 0.2, 3]\n")
    problem = clip.from_parsed(parse(text, "c", "c.toml"), spec=mujoco.MjSpec.from_string(ARMS), unmet=unmet)
    assert [line.split(" (")[0] for line in unmet] == ["keyframe 2"]
    np.testing.assert_allclose(seen(problem, problem.keys[1].state).site("left_hand").xpos, [0, 0.2, 1.3], atol=1e-3)


@pytest.mark.slow
def test_keyframes_are_drawn_as_near_as_they_come(tmp_path: Path, monkeypatch, command):
    (tmp_path / "arms.xml").write_text(ARMS, encoding="utf-8")
    (tmp_path / "far.toml").write_text(arms('others = "rest"\n', FAR.format("left")), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    done = command("render", "far.toml", "--only", "keys", "-o", "far.png", "--size", "96x64")
    assert not done.code and (tmp_path / "far.png").is_file()
    note = " ".join(done.err.split())
    assert "no pose found that puts site 'left_hand' at (3, 0, 1)" in note and "drawn as near as it comes" in note


def test_a_hand_that_reaches_down_bends_knees_and_trunk_over_feet_that_point_forward():
    problem = read(f'{second("sites.right_hand = [0.5, -0.2, 0.45]")}\n[[keyframe]]\ntime = 1.6\nothers = "rest"\n')
    data = seen(problem, problem.keys[1].state)
    mujoco.mj_comPos(problem.figure.model, data)
    toes = [data.site(f"{side}_toe").xpos for side in ("left", "right")]
    assert -0.055 < data.subtree_com[1][0] < max(toe[0] for toe in toes) + 0.02  # [m]; the tip of the shoe
    for side, toe in zip(("left", "right"), toes, strict=True):
        heel = data.site(f"{side}_heel").xpos
        np.testing.assert_allclose(heel, [-0.055, 0.09 if side == "left" else -0.09, 0], atol=1e-3)
        assert abs(np.degrees(np.arctan2(toe[1] - heel[1], toe[0] - heel[0]))) < 10


def heading(data: mujoco.MjData, side: str) -> float:
    """The heading of a foot in degrees."""
    ahead = data.site(f"{side}_toe").xpos - data.site(f"{side}_heel").xpos
    assert abs(ahead[2]) < 1e-6, "the sole is level"
    return float(np.degrees(np.arctan2(ahead[1], ahead[0])))


LUNGE = """root.position = [-0.1, 0.4, 0.62]
sites.left_heel = [-0.055, 0.65, 0]
bodies.left_foot = {flat = true}
sites.right_heel = [-0.055, -0.09, 0]
bodies.right_foot = {flat = true}
sites.right_hand = [0.25, 0.6, 0.4]
"""


def test_a_flat_foot_keeps_its_heading_where_it_stays_in_its_position():
    turned = LUNGE.replace("left_foot = {flat = true}", "left_foot = {flat = true, heading = 20}")
    problem = read(second(turned))
    first, lunge = (seen(problem, key.state) for key in problem.keys)
    assert heading(lunge, "right") == pytest.approx(heading(first, "right"), abs=1e-4)
    assert heading(lunge, "left") == pytest.approx(20, abs=1e-4)


def test_a_flat_foot_that_stays_in_its_position_is_not_turned_to_reach_it():
    """The nearest pose turned both feet by 117 degrees about their toes."""
    far = "root.position = [0.55, 0, 0.85]\n"
    feet = (
        f"sites.{side}_toe = [0.17, {y}, 0]\nbodies.{side}_foot = {{flat = true}}\n"
        for side, y in (("left", 0.09), ("right", -0.09))
    )
    with pytest.raises(UserError, match=r"_toe' at .* m off in the nearest pose, .* and body '.*_foot' turned as"):
        read(second(far + "".join(feet)))


def test_a_free_height_lifts_the_other_foot_out_of_the_floor():
    raised = """root.position = [0, 0.66, "free"]
sites.left_heel = [-0.055, 0.65, 0]
bodies.left_foot = {flat = true}
joints.right_hip = {rotvec = [0, -80, 0]}
joints.right_knee = {rotvec = [0, 90, 0]}
others = "rest"
"""
    low = LUNGE.replace("[-0.1, 0.4, 0.62]", "[-0.1, 0.4, 0.35]").replace("sites.right_hand = [0.25, 0.6, 0.4]\n", "")
    problem = read(f"{second(low)}[[keyframe]]\ntime = 1.6\n{raised}")
    data = seen(problem, problem.keys[2].state)
    assert data.site("left_heel").xpos == pytest.approx([-0.055, 0.65, 0], abs=1e-4)
    assert min(data.site(f"right_{part}").xpos[2] for part in ("heel", "toe")) > -0.001


def test_a_foot_raised_by_its_heel_alone_has_its_toes_out_of_the_floor():
    """The nearest pose had a straight ankle, and toes 3 cm below the floor."""
    raised = """root.position = [0.08, 0, 0.92]
sites.left_heel = [-0.055, 0.09, 0]
bodies.left_foot.flat = true
sites.right_heel = [0.15, -0.09, 0.05]
others = "previous"
"""
    problem = read(second(raised))
    data = seen(problem, problem.keys[1].state)
    assert data.site("right_heel").xpos == pytest.approx([0.15, -0.09, 0.05], abs=1e-4)
    assert data.site("right_toe").xpos[2] > 0
    assert data.site("left_toe").xpos[2] == pytest.approx(0, abs=1e-4)


def test_the_trunk_follows_two_feet_that_are_placed_elsewhere():
    """It stayed behind as far as the legs reach, so that the figure crouched, deeper with every keyframe."""
    text, angle = REST, np.radians(heading := 80)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    for k in range(1, 4):
        text += f'[[keyframe]]\ntime = {3 * k}\nothers = "previous"\nroot.position = "free"\n'
        text += f"root.rotation.heading = {heading}\n"
        for side, y in (("left", 0.09), ("right", -0.09)):
            x, y = turn @ [-0.055 + 1.2 * k, y]
            text += f"sites.{side}_heel = [{x}, {y}, 0]\nbodies.{side}_foot = {{flat = true, heading = {heading}}}\n"
    roots = read(text).context.keys.states[:, :3]
    np.testing.assert_allclose(roots[:, 2], roots[0, 2], atol=0.01)
    np.testing.assert_allclose(roots[1:, :2], [turn @ [1.2 * k, 0] for k in range(1, 4)], atol=0.05)


ROBOT = read_data("round_legs.xml")


ROBOT_HEAD = (
    'figure = "robot.xml"\n[[keyframe]]\ntime = 0\nothers = "rest"\n[[keyframe]]\ntime = 1\nothers = "previous"\n'
)


def figure() -> Figure:
    return figure_of(ROBOT)


def read_robot(said: str, more: str = "") -> Clip:
    return recordings.from_text(ROBOT_HEAD + said + more, name="it", spec=mujoco.MjSpec.from_string(ROBOT))


def places() -> Places:
    whole = figure()
    return Places(whole, sole_points(whole, np.zeros((0, whole.width))))


def seen_points(problem: Clip, k: int = 1) -> mujoco.MjData:
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


@pytest.mark.parametrize(("geom", "count"), [("", 1), (' name="hand"', 2)])
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
    np.testing.assert_allclose(seen_points(problem).body("hand").xpos, [0, 0.4, 1], atol=1e-6)
    (held,) = problem.context.schedule.grasps
    np.testing.assert_allclose(held.point.position, 0)


def test_feet_geoms_and_bodies_are_put_where_a_keyframe_specifies_and_rest_as_contacts_specify():
    points = ["right_ball", "left_calf 2", "left_calf", "trunk"]
    contacts = "".join(f'[[contact]]\npoint = "{point}"\nfrom = 0\nto = 1\n' for point in points)
    problem = read_robot("joints.left_knee = 12\n", contacts)
    assert [rest.point.name for rest in problem.context.schedule.on_ground] == points
    problem = read_robot("sites.left_ball = [0.2, 0.12, 0.1]\n")
    np.testing.assert_allclose(seen_points(problem).geom("left_ball").xpos, [0.2, 0.12, 0.1], atol=1e-6)


def test_a_body_takes_a_place_of_its_origin_or_of_a_point_in_its_axes():
    problem = read_robot("bodies.left_calf = {position = [0.18, 0.1, 0.41]}\n")
    np.testing.assert_allclose(seen_points(problem).body("left_calf").xpos, [0.18, 0.1, 0.41], atol=1e-6)
    problem = read_robot('bodies.left_calf = {position = [0.1, "free", 0.15], at = [0, 0, -0.3]}\n')
    data = seen_points(problem)
    tip = data.body("left_calf").xpos + data.body("left_calf").xmat.reshape(3, 3) @ [0, 0, -0.3]
    np.testing.assert_allclose(tip[[0, 2]], [0.1, 0.15], atol=1e-6)


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
