"""Loading of clips: keys of the model, ends, notes and errors."""

import re
from pathlib import Path

import mujoco
import numpy as np
import pytest
import shipped
from oracles import kinematics
from problems import CLIP, FIGURE, HINGE, changed, written
from scipy.spatial.transform import Rotation
from texts import read_data

import dynsplines
from dynsplines import Keyframe, build, load, load_motion, models, recordings
from dynsplines.clip import load as clip
from dynsplines.clip.build import Clip
from dynsplines.clip.context import knees_and_elbows
from dynsplines.clip.mirror import mirrored_keyframe
from dynsplines.clip.table import KeyframeTable
from dynsplines.errors import UserError
from dynsplines.scene.compose import compose
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import Bend, Flight, HoverPenalty, Support

KNEE = "joints.left_knee = {rotvec = [0, 0, 0]}"


def loaded(folder: Path, text: str = CLIP) -> Clip:
    return recordings.load(str(written(folder, text)))


def rotation_of(key: np.ndarray, start: int) -> Rotation:
    return Rotation.from_quat(key[start : start + 4], scalar_first=True)


def assert_same(found: Rotation, wanted: Rotation, tolerance: float = 1e-12) -> None:
    assert (found.inv() * wanted).magnitude() < tolerance


@pytest.mark.parametrize(
    ("entry", "wanted"),
    [
        ("{rotvec = [10, -20, 30.5]}", Rotation.from_rotvec([10, -20, 30.5], degrees=True)),
        ("{rotvec = [0, 350, 0]}", Rotation.from_rotvec([0, 350, 0], degrees=True)),
        ("{euler = [0, -40, 5]}", Rotation.from_euler("XYZ", [0, -40, 5], degrees=True)),
        ('{euler = [10, -40, 5], order = "zyx"}', Rotation.from_euler("ZYX", [10, -40, 5], degrees=True)),
        ('{euler = [10, -40, 5], order = "zxz"}', Rotation.from_euler("ZXZ", [10, -40, 5], degrees=True)),
        ('{euler = [25], order = "y"}', Rotation.from_euler("Y", 25, degrees=True)),
        ("{quat = [-0.1, 0, 0, 0.2]}", Rotation.from_quat([-0.1, 0, 0, 0.2], scalar_first=True)),
    ],
)
def test_every_way_to_write_a_rotation_means_what_scipy_means(tmp_path, entry, wanted):
    text = CLIP
    for place in ("root.rotation", "joints.left_knee"):
        text = changed(f"{place} = {{rotvec = [0, 0, 0]}}", f"{place} = {entry}", text)
    key = loaded(tmp_path, text).keys[0]
    for start in (3, 7):
        assert_same(rotation_of(key.state, start), wanted)
        assert key.fixed[start : start + 4].all()


def test_a_joints_rotation_is_relative_to_the_parent_at_rest(tmp_path):
    text = changed("root.rotation = {rotvec = [0, 0, 0]}", "root.rotation = {rotvec = [5, 60, -20]}")
    problem = loaded(tmp_path, changed(KNEE, "joints.left_knee = {rotvec = [10, 30, 0]}", text))
    model = problem.figure.model
    data = kinematics(model, problem.keys[0].state)
    pelvis, shin = (Rotation.from_quat(data.xquat[i], scalar_first=True) for i in (1, 2))
    assert_same(pelvis, Rotation.from_rotvec([5, 60, -20], degrees=True))
    at_rest = Rotation.from_euler("Z", 30, degrees=True)
    wanted = pelvis * at_rest * Rotation.from_rotvec([10, 30, 0], degrees=True)
    assert_same(shin, wanted, 1e-6)  # MuJoCo writes a model with seven digits


def test_what_a_keyframe_leaves_out_is_free(tmp_path):
    first, second, third = loaded(tmp_path).keys
    assert first.is_key and third.is_key
    assert second.fixed.tolist() == [True, True, False] + 4 * [False] + 4 * [True]
    np.testing.assert_array_equal(second.state[:2], [0.1, 0])
    text = changed("joints.left_knee = {rotvec = [0, 40, 0]}", 'joints.left_knee = "free"')
    for free in ('root.position = "free"', 'root.position = ["free", "free", "free"]'):
        assert loaded(tmp_path, changed('root.position = [0.1, 0, "free"]', free, text)).keys[1].is_variable


def test_hinges_are_degrees_and_slides_metres_and_only_free_and_ball_joints_are_solved_in_the_world(tmp_path):
    text = 'figure = "hinge.xml"\n'
    for i, (swing, slide) in enumerate([(0, 0), (90, 0.25)]):
        text += f"[[keyframe]]\ntime = {i}\njoints.swing = {swing}\njoints.slide = {slide}\n"
    problem = loaded(tmp_path, text)
    np.testing.assert_allclose(problem.keys[1].state, [0.25, np.pi / 2])
    assert problem.keys[1].is_key
    assert problem.figure.coordinates == "joint"
    assert loaded(tmp_path).figure.is_world


def by_name(problem: Clip) -> dict[str, tuple[object, float]]:
    return {penalty.name: (penalty, weight) for penalty, weight in problem.penalties}


def test_settings_in_the_file_reach_the_solver(tmp_path):
    entries = (
        'variable = 3\nframes = 9\ncriterion = "residual"\nthreshold = 0.5\noptimiser = "slsqp"\ntolerance = 1e-3\n'
    )
    text = changed("evaluations = 8\nframes = 2\n", entries + 'evaluations = 77\nends = "clamped"\n')
    problem = loaded(tmp_path, text)
    s = problem.settings
    assert (s.variable, s.frames, s.criterion, s.threshold) == (3, 9, "residual", 0.5)
    assert (s.optimiser, s.tolerance, s.max_evaluations, problem.ends) == ("slsqp", 1e-3, 77, "clamped")
    assert not problem.problem.raw.end_slope.any()
    assert problem.fps == 20
    assert recordings.load(str(tmp_path / "tiny.toml"), fps=12.5).fps == 12.5


@pytest.mark.parametrize(
    ("joint", "body", "lateral"),
    [
        ("left_knee", "x", 1),
        ("x", "RightShin", 1),
        ("elbow_l", "x", -1),
        ("x", "left_forearm", -1),
        ("x", "r_farm", -1),
    ],
)
def test_knees_and_elbows_are_found_by_joint_or_body(tmp_path, joint, body, lateral):
    written(tmp_path, CLIP.replace("left_knee", joint))
    figure = FIGURE.replace('"left_knee"', f'"{joint}"').replace('"left_shin"', f'"{body}"')
    (tmp_path / "tiny.xml").write_text(figure, encoding="utf-8")
    (bend,) = recordings.load(str(tmp_path / "tiny.toml")).context.bends
    assert isinstance(bend, Bend)
    assert bend.name == joint
    np.testing.assert_array_equal(bend.lateral, [0, lateral, 0])


@pytest.mark.parametrize(
    ("upper", "lower", "count"),
    [
        ("0.02 0.03 -0.3", "0.01 0 -0.25", 1),
        ("0.02 0.3 -0.01", "0 0.25 -0.02", 0),  # a T-pose
        ("0 0 -0.3", "0.25 0 0", 0),  # an elbow bent at rest
    ],
)
def test_an_elbow_bends_from_an_arm_that_is_straight_at_rest(upper, lower, count):
    text = f"""<mujoco><worldbody><body pos="0 0 1"><freejoint/><geom type="capsule" size=".03" fromto="0 0 0 {upper}"/>
     <body pos="{upper}"><joint name="elbow" type="ball"/><geom type="capsule" size=".1" fromto="0 0 0 {lower}"/></body>
    </body></worldbody></mujoco>"""
    assert len(knees_and_elbows(Figure(mujoco.MjModel.from_xml_string(text)))) == count


@pytest.mark.parametrize(
    ("time", "qpos", "words"),
    [
        (np.arange(3.0), np.zeros((3, 3)), r"\(K, 2\)"),
        (np.arange(2.0), np.array([[0, 0], [0, np.nan]]), r"keyframe 2 \(t = 1 s\)"),
        (np.arange(2.0), np.full((2, 2), 1e9), "keyframe 1 .* too large"),
        (np.zeros(1), np.zeros((1, 2)), "1 keyframe; a clip needs at least two"),
        (np.zeros(0), np.zeros((0, 2)), "no keyframes"),
        (np.array([0, 1.0, 1.0]), np.zeros((3, 2)), r"keyframe 3 .* not after keyframe 2"),
    ],
    ids=range(6),
)
def test_arrays_that_are_no_keyframes_are_refused_in_one_line(time, qpos, words):
    scene = compose(mujoco.MjSpec.from_string(HINGE.format(keys="")))
    with pytest.raises(UserError, match=words) as caught:
        clip.from_qpos("it", scene, time, qpos, 30.0, "it.npz")
    assert "it.npz" in str(caught.value)
    assert "\n" not in str(caught.value)


OTHERS = read_data("others.toml")


def test_others_are_at_rest_or_as_in_the_keyframe_before():
    problem = recordings.from_text(OTHERS, name="others")
    first, second = problem.keys
    hip, knee = (problem.figure.model.joint(f"left_{name}").qposadr[0] for name in ("hip", "knee"))
    np.testing.assert_array_equal(first.state, problem.figure.model.qpos0)
    assert not first.fixed[hip : hip + 4].any()
    assert first.fixed.sum() == problem.figure.width - 4
    changed = np.zeros(problem.figure.width, bool)
    changed[[0, knee, knee + 2]] = True
    np.testing.assert_array_equal(first.state[~changed], second.state[~changed])
    assert second.state[0] == 1
    assert not second.fixed[1]
    np.testing.assert_array_equal(np.delete(first.fixed, 1), np.delete(second.fixed, 1))
    with pytest.raises(UserError, match=r"keyframe 1 \(t = 0 s\).*previous"):
        recordings.from_text(OTHERS.replace('"rest"', '"previous"'), name="others")


def test_joints_without_names_of_their_own_go_by_their_bodys_and_a_number(tmp_path):
    (tmp_path / "two.xml").write_text(
        '<mujoco><worldbody><body name="a"><joint type="hinge" axis="1 0 0"/><joint type="hinge" axis="0 1 0"/>'
        '<geom size=".1"/></body></worldbody></mujoco>'
    )
    keys = "".join(f"[[keyframe]]\ntime = {t}\njoints.a_1 = 30\njoints.a_2 = {t}\n" for t in (0, 1))
    problem = recordings.from_text('figure = "two.xml"\n' + keys, name="two", folder=tmp_path)
    np.testing.assert_allclose(problem.keys[1].state, np.radians([30, 1]))
    with pytest.raises(UserError, match=r"no joint 'a'.*a_1, a_2"):
        recordings.from_text('figure = "two.xml"\n' + keys.replace("a_1", "a"), name="two", folder=tmp_path)


STILL = "root.position = [0, 0, 1]\nroot.rotation = {rotvec = [0, 0, 0]}\njoints.left_knee = {rotvec = [0, 0, 0]}\n"


HOVER = f"[[keyframe]]\ntime = 0\n{STILL}[[keyframe]]\ntime = 0.4\n{STILL}"


def hovering(tmp_path, penalties: str = "") -> Clip:
    return loaded(tmp_path, 'figure = "tiny.xml"\n' + penalties + HOVER)


def test_a_clip_can_say_when_it_flies_itself(tmp_path):
    penalties = '[[penalty]]\nkind = "flight"\nintervals = [[0.1, 0.2], [0.3, 0.4]]\nangular = 0.5\n'
    penalties += '[[penalty]]\nkind = "support"\nfriction = 0.3\n'
    found = by_name(hovering(tmp_path, penalties))
    flight, support = found["flight"][0], found["support"][0]
    assert isinstance(flight, Flight)
    assert isinstance(support, Support)
    assert flight.intervals == support.flights == ((0.1, 0.2), (0.3, 0.4))
    assert (flight.angular, support.friction) == (0.5, 0.3)
    assert found["flight"][1] == 6.0
    with pytest.raises(
        UserError, match=r"'flight': \[0.3, 0.2\] is not an interval of the clip, which runs from 0 to 0.4"
    ):
        hovering(tmp_path, '[[penalty]]\nkind = "flight"\nintervals = [[0.3, 0.2]]\n')


def test_an_optimiser_that_does_nothing_with_so_many_unknowns_is_reported():
    standing = 'figure = "human"\n' + "".join(f'[[keyframe]]\ntime = {t}\nothers = "rest"\n' for t in range(5))
    dense = recordings.from_text(standing + '[solve]\nends = "free"\noptimiser = "slsqp"', name="dense")
    assert "optimiser 'slsqp' is dense: with some 612 unknowns, over 300" in dense.notes[-1]


CRATE = """
[[scene.box]]
name = "crate"
body = "crate"
size = [0.3, 0.3, 0.3]
mass = 5

[[keyframe]]"""


def test_a_crate_that_lies_aside_tells_nothing_of_who_runs():
    text = models.clip_text("run_and_step")
    there = text.replace("[[keyframe]]", CRATE, 1)
    first = there.index("time = ", there.index("[[keyframe]]"))
    end = there.index("\n", first)
    there = there[:end] + "\nroots.crate = {position = [2, 3, 0.15], rotation = {rotvec = [0, 0, 0]}}" + there[end:]
    alone, beside = shipped.loaded("run_and_step"), recordings.from_text(there, name="run")
    assert beside.figure.tables.free_links.size == 2
    one, other = (each.context.support for each in (alone, beside))
    assert one is not None and other is not None
    assert other.flights == one.flights
    assert [stance.point.name for stance in beside.context.schedule.stances] == [
        stance.point.name for stance in alone.context.schedule.stances
    ]
    ours = [next(p for p, _ in each.penalties if isinstance(p, HoverPenalty)) for each in (alone, beside)]
    assert [point.name for point in ours[1].points] == [point.name for point in ours[0].points]


HEAD = 'figure = "human"\n[solve]\nevaluations = 1\nframes = 2\n'


STAND = '[[keyframe]]\ntime = {}\nothers = "rest"\n{}'


RAISED = "joints.left_shoulder = {rotvec = [0, -120, 0]}\n"


ALOFT = "root.position = [0, 0, 1.3]\n"


def clip_with_ends(first: str, middle: str, last: str, head: str = HEAD) -> Clip:
    bodies = enumerate((first, middle, last))
    return recordings.from_text(head + "".join(STAND.format(0.4 * i, body) for i, body in bodies), name="c")


def end_speeds(found: Clip) -> np.ndarray:
    path = path_of(inbetween(found.problem).timeline)
    return np.abs(path.at(np.array(path.span), 1)).max(axis=1)


@pytest.mark.parametrize(
    ("bodies", "ends"),
    [
        (("", RAISED, ""), "clamped"),
        ((ALOFT, "", ""), "clamped end"),
        (("", "", ALOFT), "clamped start"),
        ((ALOFT + RAISED, ALOFT, "root.position = [0, 0, 1.4]\n"), "free"),
    ],
)
def test_ends_are_at_rest_and_noted_unless_they_move_or_are_in_the_air(bodies, ends):
    found = clip_with_ends(*bodies)
    assert found.ends == ends
    at_rest = end_speeds(found) < 1e-9
    assert at_rest.tolist() == [ends in ("clamped", "clamped start"), ends in ("clamped", "clamped end")]
    assert any("ends = 'free'" in note for note in found.notes) == at_rest.any()


@pytest.mark.parametrize(
    ("base", "box", "ends"),
    [("", "", "clamped"), ("", '<freejoint name="box"/>', "clamped"), ("<freejoint/>", "", "free")],
)
def test_an_arm_on_a_fixed_base_begins_and_ends_at_rest(tmp_path, base, box, ends):
    (tmp_path / "arm.xml").write_text(
        f"""<mujoco><option gravity="0 0 0"/><worldbody>
          <body>{base}<geom size=".1"/>
            <body><joint name="lift" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 .4" size=".04"/>
              <body pos="0 0 .4"><joint name="elbow" axis="0 1 0"/><geom size=".04"/></body></body></body>
          <body pos="1 0 0">{box}<geom size=".1"/></body></worldbody></mujoco>"""
    )
    keyframes = "".join(
        f'[[keyframe]]\ntime = {0.4 * i}\nothers = "rest"\njoints.lift = {20 * i * i}\njoints.elbow = {30 * i}\n'
        for i in range(3)
    )
    head = f'figure = "{tmp_path / "arm.xml"}"\n[solve]\nframes = 2\n'
    found = recordings.from_text(head + keyframes, name="c")
    assert found.ends == ends
    assert (end_speeds(found) < 1e-9).all() == (ends == "clamped")


ROBOT = read_data("keyed.xml")


HOME = [0, 0.123456789012345, 0.4, 1, 0, 0, 0, 0.31, 0.31]


KEYED_CLIP = read_data("keyed.toml")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot.xml").write_text(ROBOT)
    (tmp_path / "clip.toml").write_text(KEYED_CLIP.format(more=""))
    return tmp_path


def test_what_a_keyframe_does_not_name_is_as_in_the_key(folder: Path):
    first, second = load(folder / "clip.toml").keys
    np.testing.assert_array_equal(first.state, HOME)
    assert first.is_key
    np.testing.assert_allclose(np.delete(second.state, 2), [0.1, 0, 1, 0, 0, 0, np.pi / 4, -0.7], atol=1e-15)
    assert second.fixed.all()


def test_a_key_without_numbers_is_the_rest_and_a_hold_continues_from_a_key():
    keys = [Keyframe(0, others="key:short"), Keyframe(1, others="key:home"), Keyframe(2, others="previous")]
    made = build(ROBOT, keys)
    np.testing.assert_array_equal(made.keys[0].state, made.figure.model.qpos0)
    np.testing.assert_array_equal(made.keys[2].state, HOME)


@pytest.mark.parametrize(
    ("others", "words"),
    [
        (
            "key:hom",
            r"keyframe 1 \(t = 0 s\): others: no key 'hom'; did you mean 'home'\? Keys: home, step & go, short",
        ),
        ("key:", "others must be 'free', 'rest', 'previous' or 'key:NAME', a <key> of the model, not 'key:'"),
        ("home", "others must be 'free', 'rest', 'previous' or 'key:NAME', a <key> of the model, not 'home'"),
    ],
)
def test_an_unknown_key_is_refused_with_those_that_there_are(folder: Path, others: str, words: str):
    text = (folder / "clip.toml").read_text().replace("key:home", others)
    with pytest.raises(UserError, match=words):
        recordings.from_text(text, name="clip", folder=folder)


def test_a_saved_motion_is_written_as_a_clip_that_still_has_its_keys(folder: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(folder)
    dynsplines.inbetween("clip.toml").save("motion.npz")
    Path("robot.xml").unlink()
    load_motion("motion.npz").save("again.toml")
    assert 'others = "key:home"' in Path("again.toml").read_text()
    np.testing.assert_array_equal(load("again.toml").keys[0].state, HOME)
    model = mujoco.MjModel.from_xml_path("again.xml")
    np.testing.assert_array_equal(model.key("home").qpos, HOME)


def test_the_mirror_keeps_a_symmetric_key_and_refuses_another(folder: Path):
    text = (folder / "clip.toml").read_text().replace(".123456789012345", "0")
    (folder / "robot.xml").write_text(ROBOT.replace(".123456789012345", "0"))
    made = recordings.from_text(text, name="clip", folder=folder)
    mirror = Mirror.of(made.figure)
    assert mirrored_keyframe(KeyframeTable(time=0.0, others="key:home"), made.figure, mirror).others == "key:home"
    with pytest.raises(UserError, match="the model's key 'step & go' is not symmetric"):
        mirrored_keyframe(KeyframeTable(time=0.0, others="key:step & go"), made.figure, mirror)


def test_an_edit_that_names_another_key_has_it(folder: Path):
    text = (folder / "clip.toml").read_text()
    made = recordings.from_text(text, name="clip", folder=folder)
    other = recordings.from_text(text.replace("key:home", "key:short"), name="clip", folder=folder, like=made)
    np.testing.assert_array_equal(other.keys[0].state, other.figure.model.qpos0)


@pytest.mark.parametrize(
    ("steps", "note"),
    [
        ([(0, 0), (0.5, 0.5)], "keyframes 1 and 2, 0.5 s apart, form no gait cycle, but every foot moves 0.5 m; add"),
        ([(0, 0), (0.5, 0.4), (1.2, 1)], "keyframes 2 and 3, 0.7 .* 0.6 m, as for 1 more pair of keyframes; add"),
        ([(0, 0), (0.5, 0.6), (1, 1), (1.5, 1.4)], "keyframes 1 and 2, 0.5 .*, as for 2 more pairs of keyframes; add"),
        ([(0, 0), (0.5, 0.27)], None),  # at most a fifth of the height
        ([(0, 0), (0.39, 0.5)], None),
    ],
)
def test_pairs_of_keyframes_that_lack_steps_between_them_are_noted(steps, note):
    height = build("human", [Keyframe(0.0, others="rest"), Keyframe(1.0, others="rest")]).figure.model.qpos0[2]
    found = build("human", [Keyframe(t, others="rest", root={"position": [x, 0, height]}) for t, x in steps]).notes
    assert [bool(re.match(note, each)) for each in found if "gait cycle" in each] == ([True] if note else [])
