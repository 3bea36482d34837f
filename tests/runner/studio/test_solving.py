"""The loop of the solver process: texts in; keyframes, paths and violations out."""

from __future__ import annotations

import itertools
import json
import pickle
import struct
from dataclasses import replace

import mujoco
import numpy as np
import problems
import pytest
from processes import Recorded

from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.refine.euler_lagrange import residual
from dynsplines.solver.refine.subdivision import CRITERIA
from dynsplines.studio import paths

DEVIATION = ("Euler-Lagrange residual", "what a frame promises")


@pytest.fixture
def work(tmp_path):
    problems.written(tmp_path)
    return Recorded()


def test_a_text_becomes_a_figure_keyframes_better_and_better_paths_and_a_verdict(work, tmp_path):
    told = work.loaded(tmp_path, problems.CLIP, first=True)
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


def test_an_edited_keyframe_is_solved_on_from_the_present_path(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP, first=True)
    text = problems.CLIP.replace("[0, 40, 0]", "[0, 44, 0]")
    told = work.loaded(tmp_path, text, 1)
    assert "stage" not in {each["is"] for each in told}  # the figure is the same
    kinds = [each["kind"] for each in told if each["is"] == "path"]
    assert kinds[0] == "initial"
    assert kinds.count("raw") == 1
    again = work.loaded(tmp_path, problems.CLIP, 2)  # undone: as it was found before
    first = next(each for each in again if each["is"] == "path" and each["kind"] == "initial")
    assert pickle.loads(first["timeline"]).times.size == work.path_cache[problems.CLIP].times.size


def test_a_text_that_is_no_clip_is_refused_in_words_and_the_last_one_stays(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP, first=True)
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


def test_nothing_is_searched_while_it_is_stopped(work, tmp_path):
    told = work.loaded(tmp_path, problems.CLIP, first=True, go=False)
    assert [each["kind"] for each in told if each["is"] == "path"] == ["initial", "raw"]
    assert told[-1]["stop"] == "paused"
    assert "best" in {each.get("kind") for each in work.asked("go")}


def test_a_path_is_sent_as_poses_of_every_body(work, tmp_path):
    told = work.loaded(tmp_path, problems.CLIP, first=True)
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


def test_curves_are_of_joints_feet_and_terms(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP, first=True)
    (told,) = work.asked("curves", on=True)
    groups = {group["name"]: group for group in told["curves"]["groups"]}
    assert set(groups) == {"angle", "speed", "height of feet", "torque", "E by segment", *DEVIATION}
    knee = next(each for each in groups["angle"]["series"] if each["name"] == "left_knee")
    at = told["curves"]["time"].index(min(told["curves"]["time"], key=lambda t: abs(t - 0.2)))
    assert knee["after"][at] == pytest.approx(40, abs=1)
    assert len(knee["after"]) == len(told["curves"]["time"])
    assert groups["E by segment"]["series"][0]["name"] == "all"

    # the residual is the solver's own, and where more frames are promised most is where it would insert them
    objective, timeline = work.clip.problem.objective, work.solution.timeline
    (size,), (promise,) = (groups[name]["series"] for name in DEVIATION)
    strong = residual(objective, path_of(timeline))
    duration = told["curves"]["time"][-1] - told["curves"]["time"][0]
    assert np.mean(10 ** np.array(size["after"]) - 1) * duration == pytest.approx(strong.deviation().sum(), rel=0.2)
    scores = CRITERIA["weak"](objective, timeline)
    time = np.array(told["curves"]["time"])
    inside = time[int(np.argmax(promise["after"]))]
    assert timeline.times[scores.argmax()] <= inside <= timeline.times[scores.argmax() + 1]


def test_the_present_motion_is_kept_for_what_is_made_of_it(work, tmp_path):
    from dynsplines import motion

    assert work.asked("save", file=str(tmp_path / "none.npz"), id=1)[0]["is"] == "refused"
    work.loaded(tmp_path, problems.CLIP, first=True)
    assert work.asked("save", file=str(tmp_path / "now.npz"), id=1) == [{"is": "saved", "id": 1}]
    assert motion.load(tmp_path / "now.npz").timeline.times.size == work.solution.timeline.times.size


def interrupted_after(work, checks):
    """Let a message wait after some checks for one: the first two are before the first evaluation."""
    counted = itertools.count()
    work.has_message = lambda: next(counted) >= checks


def uninterrupted(work):
    work.has_message = lambda: False


def test_an_edit_of_a_half_solved_clip_is_followed_by_a_search_of_the_whole_clip(work, tmp_path):
    """The first search is interrupted; then the first of many keyframes is edited, far from most of the clip."""
    row = """
[[keyframe]]
time = {:.1f}
root.position = [{}, 0, 1]
root.rotation = {{rotvec = [0, 0, 0]}}
joints.left_knee = {{rotvec = [0, {}, 0]}}
"""
    partial = row.replace("root.rotation = {{rotvec = [0, 0, 0]}}\n", "").replace(", 0, 1]", ', 0, "free"]')
    rows = [(partial if i % 2 else row).format(0.3 * i, 0.1 * i, 20 * (i % 3)) for i in range(15)]
    text = 'figure = "tiny.xml"\n' + "".join(rows)
    interrupted_after(work, 2)
    assert "settled" not in {each["is"] for each in work.loaded(tmp_path, text, first=True)}
    uninterrupted(work)
    told = work.loaded(tmp_path, text.replace("[0.0, 0, 1]", "[-0.01, 0, 1]", 1), 1)
    assert told[-1]["stop"] == "CONVERGED"
    whole = inbetween(work.clip.problem)
    assert work.solution.trace[-1][2] <= 1.05 * whole.trace[-1][2]


@pytest.fixture
def continued(work, tmp_path):
    """A clip whose path, after several searches of two evaluations, is better than the result of a restart."""
    work.loaded(tmp_path, problems.changed("evaluations = 8", "evaluations = 2"), first=True)
    for _ in range(3):
        work.asked("go")
    return work


def test_a_restart_does_not_replace_the_present_path_by_a_worse_one(continued):
    present, objective = continued.solution, continued.clip.problem.objective
    messages = continued.asked("go", restart=True)
    assert continued.solution is present
    shown = [pickle.loads(message["timeline"]) for message in messages if message["is"] == "path"]
    least = objective.value(path_of(present.timeline))
    assert all(objective.value(path_of(timeline)) <= least * (1 + 1e-9) for timeline in shown)
    (note,) = [message["words"] for message in messages if message["is"] == "note"]
    assert note == "the restarted search found no better path"
    assert messages[-1]["is"] == "settled"


def test_an_interrupted_restart_does_not_replace_the_present_path_and_is_repeated(continued):
    present = continued.solution
    interrupted_after(continued, 2)
    messages = continued.asked("go", restart=True)
    assert not {"note", "settled"} & {message["is"] for message in messages}
    assert continued.solution is present
    uninterrupted(continued)
    assert "note" in {message["is"] for message in continued.asked("curves", on=False)}
    assert continued.solution is present


def test_a_restart_replaces_a_worse_path(work, tmp_path):
    work.loaded(tmp_path, problems.CLIP, first=True)
    good, objective = work.solution, work.clip.problem.objective
    rows = good.timeline.rows.copy()
    rows[1:-1][~good.timeline.fixed.any(axis=1)] += 0.8
    work.solution = replace(good, timeline=good.timeline.with_rows(rows), trace=())
    messages = work.asked("go", restart=True)
    assert objective.value(path_of(work.solution.timeline)) == pytest.approx(good.trace[-1][2], rel=1e-6)
    notes = [message["words"] for message in messages if message["is"] == "note"]
    assert notes == [f"the restarted search found a better path: E {good.trace[-1][2]:.3g}"]


INVALID = {"text": "figure = 1", "name": "tiny", "place": "tiny.toml", "folder": ".", "revision": 1, "go": True}


@pytest.mark.parametrize("checks", [0, 1, 2, 4])
@pytest.mark.parametrize(
    "asked",
    [
        ("curves", {"on": True}),
        ("save", {"file": "now.npz"}),
        ("load", {**INVALID, "first": False}),
    ],
)
def test_a_search_continues_after_a_message_that_does_not_replace_the_clip(work, tmp_path, monkeypatch, asked, checks):
    monkeypatch.chdir(tmp_path)
    interrupted_after(work, checks)
    assert "settled" not in {each["is"] for each in work.loaded(tmp_path, problems.CLIP, first=True)}
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
    told = work.loaded(tmp_path, problems.CLIP, first=True)
    assert [each["is"] for each in told].count("searching") == 2
    assert told[-1]["stop"] == "CONVERGED"


def test_a_search_that_was_stopped_stays_so(work, tmp_path):
    interrupted_after(work, 2)
    work.loaded(tmp_path, problems.CLIP, first=True)
    uninterrupted(work)
    assert [each["stop"] for each in work.asked("stop")] == ["INTERRUPTED"]
    assert {each["is"] for each in work.asked("curves", on=True)} == {"curves"}
