"""The loop of the solver process: texts in; keyframes, paths and violations out."""

import itertools
import json
import pickle
import platform
import re
import struct
from dataclasses import replace

import mujoco
import numpy as np
import problems
import psutil
import pytest
from figures import figure_of
from oracles import mujoco_forces
from processes import Recorded
from random_models import random_samples
from texts import read_data

from dynsplines.solver.figure.figure import Figure
from dynsplines.studio import curves, paths
from dynsplines.studio.solver import release_memory


@pytest.fixture
def work(tmp_path):
    problems.written(tmp_path)
    return Recorded()


def test_a_text_becomes_a_figure_keyframes_better_and_better_paths_and_a_verdict(work, tmp_path):
    told = work.loaded(tmp_path, problems.CLIP)
    assert [each["is"] for each in told][:2] == ["stage", "loaded"]
    assert told[-1]["is"] == "settled"
    stage = json.loads(told[0]["stage"])
    assert [joint["name"] for joint in stage["joints"]] == ["root", "left_knee"]
    loaded = told[1]
    assert loaded["outline"]["keys"][1]["joints"]["left_knee"] == {"rotvec": (0, 40, 0)}
    assert [all(key["fixed"]) for key in loaded["keys"]] == [True, False, True]
    kinds = [each["kind"] for each in told if each["is"] == "path"]
    assert kinds.count("raw") == 1
    assert set(kinds) == {"initial", "raw", "best"}
    values = [each["value"] for each in told if each["is"] == "path" and "value" in each]
    assert values == sorted(values, reverse=True)


def test_an_edited_keyframe_is_solved_on_from_the_present_path_and_undo_returns_to_the_former_one(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP)
    former = work.solution.timeline
    told = work.loaded(tmp_path, problems.CLIP.replace("[0, 40, 0]", "[0, 44, 0]"), 1)
    assert "stage" not in {each["is"] for each in told}  # the figure is the same
    kinds = [each["kind"] for each in told if each["is"] == "path"]
    assert kinds[0] == "initial"
    assert kinds.count("raw") == 1
    again = work.loaded(tmp_path, problems.CLIP, 2)
    first = next(each for each in again if each["is"] == "path" and each["kind"] == "initial")
    np.testing.assert_array_equal(pickle.loads(first["timeline"]).rows, former.rows)
    assert {each["is"] for each in again} == {"loaded", "path", "settled"}  # it need not be solved again


def test_a_text_that_is_no_clip_is_refused_in_words_and_the_last_one_stays(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP)
    before = work.solution
    for old, new, words in (
        ("time = 0.2", "time = 0.9", "times must rise"),
        ("[0, 40, 0]", "[0, nan, 0]", "finite number"),
        ("left_knee = {rotvec = [0, 40", "left_kne = {rotvec = [0, 40", "no joint 'left_kne'"),
        ("fps = 20", "fps = 20\n[", "not valid TOML"),
    ):
        told = work.loaded(tmp_path, problems.CLIP.replace(old, new), 1)
        assert [each["is"] for each in told] == ["refused"]
        assert words in told[0]["words"]
    assert work.solution is before
    assert work.loaded(tmp_path, problems.CLIP, 2)[-1]["is"] == "settled"


def test_a_path_is_sent_as_poses_of_every_body(work, tmp_path):
    told = work.loaded(tmp_path, problems.CLIP)
    data = next(each for each in told if each["is"] == "path")["data"]
    (size,) = struct.unpack("<I", data[:4])
    head = json.loads(data[4 : 4 + size])
    assert (4 + size) % 4 == 0
    numbers = np.frombuffer(data[4 + size :], "<f4")
    count, bodies = head["count"], head["bodies"]
    assert numbers.size == count * (bodies * 7 + 3)
    turns = numbers[3 * count * bodies : 7 * count * bodies].reshape(-1, 4)
    np.testing.assert_allclose(np.linalg.norm(turns, axis=1), 1, atol=1e-5)
    assert head["first"] == 0
    assert head["count"] == round(head["last"] * head["rate"]) + 1
    assert paths.rate_of(600) * 600 <= paths.MOST_SAMPLES


@pytest.mark.parametrize("root", ["", "<freejoint/>"])
def test_the_centre_of_mass_is_the_figure_s_without_its_table_and_what_lies_on_it(root):
    box = '<geom type="box" size=".1 .1 .1" mass="50"/>'
    free = f'<body pos="1 0 0"><freejoint/>{box}</body>' if root else ""
    text = f"""<mujoco><worldbody><body pos="2 0 0">{box}</body>{free}
     <body name="arm">{root}<geom size=".05" mass="{1 if root else 0.001}"/>
      <body><joint/><geom size=".05" pos=".2 0 0" mass="1"/></body></body></worldbody></mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    _, _, middle = paths.poses(Figure(model), data.qpos[None])
    np.testing.assert_allclose(middle[0], data.subtree_com[model.body("arm").id], atol=1e-3)


def test_curves_are_of_joints(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP)
    (told,) = work.asked("curves", on=True)
    groups = {group["name"]: group for group in told["curves"]["groups"]}
    assert set(groups) == {"angle", "position", "speed", "torque"}
    knee = next(each for each in groups["angle"]["series"] if each["name"] == "left_knee y")
    at = told["curves"]["time"].index(min(told["curves"]["time"], key=lambda t: abs(t - 0.2)))
    assert knee["after"][at] == pytest.approx(40, abs=1)
    assert len(knee["after"]) == len(told["curves"]["time"])


def test_torques_are_those_of_mujoco_for_joints_of_every_kind(rng):
    figure = figure_of(read_data("every_joint.xml"))
    samples = random_samples(figure, rng)
    forces = mujoco_forces(samples)
    torques = [(link, values) for group, link, _, values in curves._series(figure, samples) if group == "torque"]
    assert len(torques) == 6
    for link, values in torques:
        expected = forces[:, link.dofs]
        expected = expected[:, 0] if expected.shape[1] == 1 else np.linalg.norm(expected, axis=1)
        np.testing.assert_allclose(values, expected, rtol=1e-9)


def test_a_rotation_beyond_half_a_turn_is_a_curve_without_jumps(work, tmp_path):
    turned = problems.changed("rotvec = [0, 10, 170]", "rotvec = [0, 0, 170]")
    turned += "\n[[keyframe]]\ntime = 0.6\nroot.position = [0.5, 0, 1]\nroot.rotation = {rotvec = [0, 0, 200]}\n"
    work.loaded(tmp_path, turned)
    (told,) = work.asked("curves", on=True)
    angles = next(group["series"] for group in told["curves"]["groups"] if group["name"] == "angle")
    heading = np.array(next(each["after"] for each in angles if each["name"] == "root turn z"))
    assert heading[-1] == pytest.approx(200, abs=0.1)
    assert np.abs(np.diff(heading)).max() < 30


def test_a_joint_that_goes_beyond_both_its_keyframes_is_marked_at_the_peak(work, tmp_path):
    fast = problems.changed("rotvec = [0, 10, 170]", "rotvec = [0, 0, 0]").replace("[0, 40, 0]", "[0, 140, 0]")
    at = fast.rindex("joints.left_knee")
    work.loaded(tmp_path, fast[:at] + "joints.left_knee = {rotvec = [0, 140, 0]}\n")
    clip = work.clip
    (mark,) = curves.overshoots(clip.figure, clip.authored_keys, clip.problem.raw)
    assert mark["joint"] == "left_knee"
    assert 0.2 < mark["time"] < 0.41
    assert re.fullmatch(r"left_knee y goes from 140° to 15\d°, and then to 140°", mark["text"])
    assert curves.overshoots(clip.figure, clip.authored_keys[:2], clip.problem.raw) == []


def test_the_present_motion_is_kept_for_what_is_made_of_it(work, tmp_path):
    from dynsplines import motion

    assert work.asked("save", file=str(tmp_path / "none.npz"), id=1)[0]["is"] == "refused"
    work.loaded(tmp_path, problems.CLIP)
    assert work.asked("save", file=str(tmp_path / "now.npz"), id=1) == [{"is": "saved", "id": 1}]
    assert motion.load(tmp_path / "now.npz").timeline.times.size == work.solution.timeline.times.size


def interrupted_after(work, checks):
    """Let a message wait after some checks for one: the first two are before the first evaluation."""
    counted = itertools.count()
    work.has_message = lambda: next(counted) >= checks


def uninterrupted(work):
    work.has_message = lambda: False


@pytest.mark.parametrize("checks", [None, 0, 4, 8])
def test_the_motion_at_rest_depends_on_the_text_alone(work, tmp_path, checks):
    """It is that of a clip which is opened, also after an edit from a path far away or a message in between."""
    edited = problems.changed("[0, 40, 0]", "[0, 44, 0]")
    fresh = Recorded()
    fresh.loaded(tmp_path, edited)
    expected = fresh.solution
    assert expected is not None
    work.loaded(tmp_path, problems.CLIP)
    good = work.solution
    rows = good.timeline.rows.copy()
    rows[1:-1][~good.timeline.fixed.any(axis=1)] += 0.8
    work.solution = replace(good, timeline=good.timeline.with_rows(rows), trace=())
    if checks is not None:
        interrupted_after(work, checks)
    messages = work.loaded(tmp_path, edited, 1)
    uninterrupted(work)
    messages += work.asked("curves", on=False)
    assert [message["stop"] for message in messages if message["is"] == "settled"] == ["CONVERGED"]
    np.testing.assert_array_equal(work.solution.timeline.rows, expected.timeline.rows)


INVALID = {"text": "figure = 1", "name": "tiny", "place": "tiny.toml", "folder": ".", "revision": 1, "go": True}


@pytest.mark.parametrize(
    ("checks", "asked"),
    [
        (0, ("curves", {"on": True})),
        (1, ("save", {"file": "now.npz"})),
        (2, ("load", INVALID)),
        (4, ("curves", {"on": True})),
    ],
)
def test_a_search_continues_after_a_message_that_does_not_replace_the_clip(work, tmp_path, monkeypatch, asked, checks):
    monkeypatch.chdir(tmp_path)
    interrupted_after(work, checks)
    assert "settled" not in {each["is"] for each in work.loaded(tmp_path, problems.CLIP)}
    uninterrupted(work)
    do, arguments = asked
    ends = [each["stop"] for each in work.asked(do, **arguments) if each["is"] == "settled"]
    assert ends == ["CONVERGED"]
    assert work.asked("curves", on=False) == []  # nothing is left to search


@pytest.mark.parametrize("is_late", [False, True])
def test_an_interrupt_just_outside_of_a_search_repeats_it(work, tmp_path, monkeypatch, is_late):
    minimise = Recorded._minimise

    def interrupted(self, *arguments):
        monkeypatch.setattr(Recorded, "_minimise", minimise)
        if is_late:
            minimise(self, *arguments)
        raise KeyboardInterrupt

    monkeypatch.setattr(Recorded, "_minimise", interrupted)
    told = work.loaded(tmp_path, problems.CLIP)
    assert [each["is"] for each in told].count("searching") == 2
    assert told[-1]["stop"] == "CONVERGED"


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries return memory themselves, or never")
def test_freed_memory_is_returned_to_the_system():
    process, blocks = psutil.Process(), [bytearray(2000) for _ in range(50_000)]
    above = bytearray(2000)  # on the heap, where it keeps what is below
    blocks.clear()
    before = process.memory_info().rss
    release_memory()
    assert before - process.memory_info().rss > 50e6  # [bytes]
    assert above == bytes(2000)
