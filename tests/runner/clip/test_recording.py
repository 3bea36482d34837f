"""[recording]: keyframes that edit a motion are exact, the rest stays as it was, and its detail is followed."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
import shipped
from figures import OBJECT_BALL, biped, figure_of, scene
from oracles import kinematics
from paper.penetration import penetration

import dynsplines
from dynsplines import Keyframe, build, motion, recordings, solving
from dynsplines.clip import load as clips
from dynsplines.clip.kinds import KINDS, Options
from dynsplines.clip.load import clip_from_motion
from dynsplines.clip.tracking.problem import tracking_context
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.measure.report import report as measured
from dynsplines.measure.violation import violations
from dynsplines.motion import Saved
from dynsplines.solver.contacts import Contact
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.penalty import JointRange, Support, TrackingPenalty

REACH = """
figure = "human"
[scene]
step = {{x = 2.90, height = 0.35}}
[recording]
file = "run.npz"
[[keyframe]]
time = {time}
sites.left_hand = [3.95, 0.3, 1.75]
"""
BARE = 'figure = "human"\n[recording]\nfile = "run.npz"\n'


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With run_and_step solved."""
    out = tmp_path_factory.mktemp("edits")
    motion.save(shipped.solved("run_and_step"), out / "run.npz")
    (out / "itself.toml").write_text(BARE.replace("run.npz", "itself.toml"), encoding="utf-8")
    return out


@pytest.fixture(scope="module")
def saved(folder: Path) -> Saved:
    return motion.load(folder / "run.npz")


def bodies(saved_figure, path, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places (T, n, 3) [m] of bodies and sites, by MuJoCo, and the bodies' rotations (T, n, 9)."""
    data, places, rotations = mujoco.MjData(saved_figure.model), [], []
    for qpos in saved_figure.to_qpos(path.at(times)):
        kinematics(saved_figure.model, qpos, data)
        places.append(np.concatenate([data.xpos, data.site_xpos]))
        rotations.append(data.xmat.copy())
    return np.array(places), np.array(rotations)


@pytest.mark.slow
def test_a_reach_is_exact_and_changes_little_of_the_rest(folder, saved, tmp_path, monkeypatch, command):
    """Solved by the command, from another folder."""
    text = REACH.format(time=1.75)
    (folder / "reach.toml").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    done = command("solve", folder / "reach.toml", "-o", "reach.npz")
    assert done.code == 0, done.err
    clip = clips.clip_from_motion(solution := motion.load(tmp_path / "reach.npz"))
    found = path_of(solution.timeline)
    times = np.linspace(0, 2.2, 221)
    (own, _), (true, _) = (bodies(clip.figure, p, times) for p in (found, path_of(saved.timeline)))
    away = np.linalg.norm(own - true, axis=2)[np.abs(times - 1.75) > 0.4]
    assert away.max() < 0.03 and np.median(away) < 0.005
    hand = clip.figure.model.nbody + mujoco.mj_name2id(clip.figure.model, mujoco.mjtObj.mjOBJ_SITE, "left_hand")
    there, _ = bodies(clip.figure, found, np.array([1.75]))
    np.testing.assert_allclose(there[0, hand], [3.95, 0.3, 1.75], atol=2e-3)
    key = next(k for k in clip.keys if k.time == 1.75)
    own_state = clip.figure.to_qpos(found.at(np.array([1.75])))[0]
    np.testing.assert_allclose(np.abs(own_state[key.fixed]), np.abs(key.state[key.fixed]), atol=1e-12)


@pytest.mark.parametrize(
    ("said", "first", "last", "middle"),
    [
        ("", 0.0, 2.2, 1.1),
        ("from = 0.2\nto = 1.2\nat = 5.0", 5.0, 6.0, 0.7),
        ("from = 0.2\nto = 1.2\nat = 0\nspeed = 2.0", 0.0, 0.5, 0.7),
        ("times = [[0.0, 0.0], [1.1, 2.0], [2.2, 3.0]]", 0.0, 3.0, None),
    ],
)
def test_what_of_the_recording_comes_when_is_as_the_clip_specifies(folder, saved, said, first, last, middle):
    clip = recordings.from_text(f"{BARE}{said}", name="cut", folder=folder)
    assert [clip.keys[0].time, clip.keys[-1].time] == pytest.approx([first, last], abs=0.01)
    near, figure = clip.problem.penalties[0][0], clip.figure
    assert isinstance(near, TrackingPenalty)
    here, there = (2.0, 1.1) if middle is None else ((first + last) / 2, middle)
    own, wanted = near.recorded.path.at(np.array([here])), path_of(saved.timeline).at(np.array([there]))
    np.testing.assert_allclose(np.abs(figure.to_qpos(own)), np.abs(figure.to_qpos(wanted)), atol=2e-3)


@pytest.mark.parametrize("pairs", [[[0.3, 0.0], [0.8, 1.5], [1.3, 1.9]], [[0.5, 0.3], [1.0, 0.6], [1.5, 3.0]]])
def test_beyond_pairs_of_times_the_speed_is_that_of_the_neighbouring_interval(folder, saved, pairs):
    clip = recordings.from_text(f"{BARE}times = {pairs}", name="cut", folder=folder)
    recorded, there = np.array(pairs).T
    slopes = np.diff(there) / np.diff(recorded)
    ends = [there[0] - slopes[0] * recorded[0], there[-1] + slopes[-1] * (2.2 - recorded[-1])]
    assert [clip.keys[0].time, clip.keys[-1].time] == pytest.approx(ends, abs=1e-9)


KERB = """
figure = "human"
[recording]
file = "walk_loop"
repeat = 3
[[scene.box]]
name = "kerb"
size = [4.0, 3.0, 0.12]
position = [4.62, 0, 0.06]
"""


BVH = """
figure = "human"
[recording]
file = "{file}"
[[keyframe]]
time = 0.4
joints.right_shoulder = {{rotvec = [0, -60, 0]}}
"""


def test_a_recording_of_another_program_is_cleaned_and_followed(folder, saved):
    formats.export(saved, "bvh", folder / "run.bvh", fps=30)
    clip = recordings.from_text(BVH.format(file="run.bvh"), name="edit", folder=folder)
    [edit] = clip.authored_keys
    assert edit.time == 0.4
    near = clip.problem.penalties[0][0]
    assert isinstance(near, TrackingPenalty)
    at = np.array([0.3, 1.2])
    own, wanted = (saved.figure.to_qpos(path.at(at)) for path in (near.recorded.path, path_of(saved.timeline)))
    np.testing.assert_allclose(own[:, :3], wanted[:, :3], atol=0.05)
    (folder / "run.xyz").write_bytes(b"")
    with pytest.raises(UserError, match="neither a motion"):
        recordings.from_text(BVH.format(file="run.xyz"), name="edit", folder=folder)


def test_from_python_a_keyframe_of_an_arm_is_exact_and_leaves_the_body_unchanged(folder, saved, monkeypatch):
    """The recording is bent through the arm's pose: the trunk does not make up for it."""
    monkeypatch.chdir(folder)
    raised = Keyframe(1.0, joints={"right_shoulder": {"rotvec": [0, -140, 0]}})
    clip = build("human", [raised], scene={"step": {"x": 2.90, "height": 0.35}}, recording={"file": "run.npz"})
    path = path_of(inbetween(clip.problem).timeline)
    times = np.array([0.85, 1.0, 1.15])
    at, half = clip.figure.model.joint("right_shoulder").qposadr[0], np.radians(70)
    arm = clip.figure.to_qpos(path.at(times))[1, at : at + 4]
    np.testing.assert_allclose(arm * np.sign(arm[0]), [np.cos(half), 0, -np.sin(half), 0], atol=1e-9)
    was, now = (bodies(saved.figure, each, times) for each in (path_of(saved.timeline), path))
    body = {name: saved.figure.model.body(name).id for name in ("chest", "right_forearm", "left_foot")}
    assert np.linalg.norm(now[1][:, body["chest"]] - was[1][:, body["chest"]], axis=1).max() < 0.2
    assert np.linalg.norm(now[0][:, body["left_foot"]] - was[0][:, body["left_foot"]], axis=1).max() < 0.03
    assert np.linalg.norm(now[0][1, body["right_forearm"]] - was[0][1, body["right_forearm"]]) > 0.5


def test_a_loop_that_ships_is_followed_as_often_as_the_clip_specifies_and_false_stances_are_refused(tmp_path):
    """To its very end, three periods on, where it began but for its way."""
    clip = recordings.from_text(KERB, name="kerb", folder=tmp_path)
    loop = recordings.load("walk_loop").keys
    period = loop[-1].time - loop[0].time
    assert clip.keys[-1].time - clip.keys[0].time == pytest.approx(3 * period, abs=1e-9)
    near = clip.problem.penalties[0][0]
    assert isinstance(near, TrackingPenalty)
    qpos = clip.figure.to_qpos(near.recorded.path.at(np.array([0.3, 0.3 + period, 0.3 + 2 * period])))
    np.testing.assert_allclose(np.diff(qpos[:, 0]), 1.38, atol=0.01)
    np.testing.assert_allclose(np.abs(qpos[:, 1:]), np.abs(qpos[[0, 0, 0], 1:]), atol=2e-3)
    found = solving.raw_spline(clip)
    changes: list[Any] = [[{}], {"a": 1}, [{"point": "left_toe", "from, s": 1, "to, s": 0}], 3]
    for change in changes:
        with pytest.raises(UserError, match="stances"):
            clips.clip_from_motion(replace(found, search={"stances": change}))
    kept = clips.clip_from_motion(replace(found, search={"stances": clip.stances}))
    assert [(r.point.name, r.first, r.last) for r in kept.context.schedule.on_ground] == [
        (r.point.name, r.first, r.last) for r in clip.context.schedule.on_ground
    ]


@pytest.mark.slow
def test_a_walk_steps_on_to_a_kerb_and_only_the_given_keyframes_are_reported():
    """Contacts lie far from some keyframes, whose poses are found all the same; feet stay out of the kerb."""
    clip, solution = shipped.loaded("step_on_kerb"), shipped.solved("step_on_kerb")
    path, model = path_of(solution.timeline), clip.figure.model
    soles = [model.nbody + model.site(f"{side}_{part}").id for side in ("left", "right") for part in ("heel", "toe")]
    times = np.linspace(0, 3.24, 300)
    at = bodies(clip.figure, path, times)[0][:, soles]
    over = at[..., 2] - np.where(at[..., 0] > 2.63, 0.12, 0.0)
    assert over.min() > -0.01
    assert at[-1, 0, 2] == pytest.approx(0.12, abs=1e-6)
    assert [violation.text for violation in violations(clip, solution)] == []
    found = penetration(model, times, clip.figure.to_qpos(path.at(times)))
    assert found.deepest < 0.004, found.worst()
    report = measured(clip_from_motion(solution), solution)
    assert report["violations"] == []
    assert (report["keyframes"], report["partial keyframes"]) == (3, 3)
    largest = report["after"]["largest"]
    assert largest.get("backward", {"amount": 0.0})["amount"] < 1
    assert largest["contact"]["amount"] < 0.005
    whole = report["after"]["objective"]
    assert whole == pytest.approx(clip.problem.objective.value(path), abs=22.0)  # the recording is known by its frames


@pytest.mark.slow
def test_a_target_of_a_hand_in_a_recording_leaves_the_feet_in_their_stances():
    """The pelvis rose by 13 cm to the hand's target, and the standing heel with it."""
    target = np.array([0.6, -0.3, 1.0])
    keyframe = f"[[keyframe]]\ntime = 0.667\nsites.right_hand = {target.tolist()}\n"
    walk = '[recording]\nfile = "walk_loop"\n'
    reach = dynsplines.inbetween(recordings.from_text(f'figure = "human"\n{walk}{keyframe}', name="reach"))
    data = kinematics(reach.model, reach.at(0.667))
    assert np.linalg.norm(data.site("right_hand").xpos - target) < 1e-6
    assert abs(data.site("right_heel").xpos[2]) < 0.01
    assert reach.violations == []


def test_all_of_a_foot_is_to_stay_out_of_the_ground():
    figure_39 = shipped.loaded("run_loop").figure
    rest = np.tile(figure_39.to_state(figure_39.model.qpos0), (2, 1))
    context = tracking_context(figure_39, np.array([0.0, 1.0]), rest, "rest")
    names = {point.name for point in context.body_above_soles}
    assert {"left_toe_sole", "left_heel_sole", "right_toe_box"} <= names
    assert [(point.name, point.radius) for point in context.points][:2] == [("left_heel", 0.024), ("left_toe", 0.024)]


def test_the_ground_supports_the_figure_with_feet_after_another_free_body():
    figure = figure_of(scene(OBJECT_BALL, biped()))
    states = np.tile(figure.to_state(figure.model.qpos0), (2, 1))
    context = tracking_context(figure, np.array([0.0, 1.0]), states, "biped")
    standing = context.with_schedule(on_ground=tuple(Contact(point, 0.0, 1.0) for point in context.points))
    ((support, weight),) = KINDS["support"].terms(standing, Options())
    assert isinstance(support, Support)
    assert figure.links[support.root].name == "root"
    assert (len(support.footings), weight) == (len(context.points), 1000.0)


def test_a_recording_is_followed_a_little_inside_the_ranges_of_joints():
    figure = figure_of(scene(biped()))
    states = np.tile(figure.to_state(figure.model.qpos0), (2, 1))
    context = tracking_context(figure, np.array([0.0, 1.0]), states, "biped")
    terms = [term for term, _ in KINDS["limits"].terms(context, Options()) if isinstance(term, JointRange)]
    joints = [joint for term in terms for joint in term.joints]
    assert len(joints) == 6
    for joint in joints:
        low, high = figure.model.joint(joint.name).range
        assert low < joint.low < joint.high < high
