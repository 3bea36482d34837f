"""The process that solves, without a process: texts in, keyframes, paths and verdicts out."""

from __future__ import annotations

import itertools
import json
import pickle
import struct
from contextlib import contextmanager
from dataclasses import replace

import mujoco
import numpy as np
import pytest
import tiny
from spoken import Line, load

from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.inbetween import inbetween
from dynsplines.solver.refine.euler_lagrange import residual
from dynsplines.solver.refine.subdivision import CRITERIA
from dynsplines.studio import paths
from dynsplines.studio.solving.loop import SolverLoop

DEVIATION = ("Euler-Lagrange residual", "what a frame promises")


@pytest.fixture
def work(tmp_path):
    tiny.written(tmp_path)
    return SolverLoop(Line())


def test_a_text_becomes_a_figure_keyframes_better_and_better_paths_and_a_verdict(work, tmp_path):
    told = load(work, tmp_path, tiny.CLIP, first=True)
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
    load(work, tmp_path, tiny.CLIP, first=True)
    text = tiny.CLIP.replace("[0, 40, 0]", "[0, 44, 0]")
    told = load(work, tmp_path, text, 1)
    assert "stage" not in {each["is"] for each in told}  # the figure is the same
    kinds = [each["kind"] for each in told if each["is"] == "path"]
    assert kinds[0] == "initial"
    assert kinds.count("raw") == 1
    again = load(work, tmp_path, tiny.CLIP, 2)  # undone: as it was found before
    first = next(each for each in again if each["is"] == "path" and each["kind"] == "initial")
    assert pickle.loads(first["timeline"]).times.size == work.path_cache[tiny.CLIP].times.size


def test_a_text_that_is_no_clip_is_refused_in_words_and_the_last_one_stays(work, tmp_path):
    load(work, tmp_path, tiny.CLIP, first=True)
    before = work.solution
    for old, new, words in (
        ("time = 0.2", "time = 0.9", "times must rise"),
        ("[0, 40, 0]", "[0, nan, 0]", "finite number"),
        ("left_knee = {rotvec = [0, 40", "left_kne = {rotvec = [0, 40", "no joint 'left_kne'"),
        ("fps = 20", "fps = 20\n[", "not valid TOML"),
    ):
        told = load(work, tmp_path, tiny.CLIP.replace(old, new), 1)
        assert [each["is"] for each in told] == ["refused"]
        assert words in told[0]["words"]
    assert work.solution is before
    assert load(work, tmp_path, tiny.CLIP, 2)[-1]["is"] == "settled"


def test_nothing_is_searched_while_it_is_stopped(work, tmp_path):
    told = load(work, tmp_path, tiny.CLIP, first=True, go=False)
    assert [each["kind"] for each in told if each["is"] == "path"] == ["initial", "raw"]
    assert told[-1]["stop"] == "paused"
    work.do({"do": "go"})
    assert "best" in {each.get("kind") for each in work.line.taken()}


def test_a_path_is_sent_as_poses_of_every_body(work, tmp_path):
    told = load(work, tmp_path, tiny.CLIP, first=True)
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
    load(work, tmp_path, tiny.CLIP, first=True)
    work.do({"do": "curves", "on": True})
    (told,) = work.line.taken()
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

    work.do({"do": "save", "file": str(tmp_path / "none.npz")})
    assert work.line.taken()[0]["is"] == "refused"
    load(work, tmp_path, tiny.CLIP, first=True)
    work.do({"do": "save", "file": str(tmp_path / "now.npz")})
    assert work.line.taken()[0]["is"] == "saved"
    assert motion.load(tmp_path / "now.npz").timeline.times.size == work.solution.timeline.times.size


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
    work.has_message = lambda: True
    assert load(work, tmp_path, text, first=True)[-1]["stop"] == "INTERRUPTED"
    work.has_message = lambda: False
    told = load(work, tmp_path, text.replace("[0.0, 0, 1]", "[-0.01, 0, 1]", 1), 1)
    assert told[-1]["stop"] == "CONVERGED"
    whole = inbetween(work.clip.problem)
    assert work.solution.trace[-1][2] <= 1.05 * whole.trace[-1][2]


@pytest.fixture
def continued(work, tmp_path):
    """A clip whose path, after several searches of two evaluations, is better than the result of a restart."""
    load(work, tmp_path, tiny.changed("evaluations = 8", "evaluations = 2"), first=True)
    for _ in range(3):
        work.do({"do": "go"})
    work.line.taken()
    return work


def test_a_restart_does_not_replace_the_present_path_by_a_worse_one(continued):
    present, objective = continued.solution, continued.clip.problem.objective
    continued.do({"do": "go", "restart": True})
    messages = continued.line.taken()
    assert continued.solution is present
    shown = [pickle.loads(message["timeline"]) for message in messages if message["is"] == "path"]
    least = objective.value(path_of(present.timeline))
    assert all(objective.value(path_of(timeline)) <= least * (1 + 1e-9) for timeline in shown)
    (note,) = [message["words"] for message in messages if message["is"] == "note"]
    assert note == "the restarted search found no better path"
    assert messages[-1]["is"] == "settled"


def test_an_interrupted_restart_does_not_replace_the_present_path_and_is_repeated(continued):
    present, checks = continued.solution, itertools.count()
    continued.has_message = lambda: next(checks) > 0  # from the first evaluation on
    continued.do({"do": "go", "restart": True})
    messages = continued.line.taken()
    assert messages[-1]["stop"] == "INTERRUPTED"
    assert "note" not in {message["is"] for message in messages}
    assert continued.solution is present
    continued.has_message = lambda: False
    continued.do({"do": "curves", "on": False})
    assert "note" in {message["is"] for message in continued.line.taken()}
    assert continued.solution is present


def test_a_restart_replaces_a_worse_path(work, tmp_path):
    load(work, tmp_path, tiny.CLIP, first=True)
    good, objective = work.solution, work.clip.problem.objective
    rows = good.timeline.rows.copy()
    rows[1:-1][~good.timeline.fixed.any(axis=1)] += 0.8
    work.solution = replace(good, timeline=good.timeline.with_rows(rows), trace=())
    work.do({"do": "go", "restart": True})
    assert objective.value(path_of(work.solution.timeline)) == pytest.approx(good.trace[-1][2], rel=1e-6)
    notes = [message["words"] for message in work.line.taken() if message["is"] == "note"]
    assert notes == [f"the restarted search found a better path: E {good.trace[-1][2]:.3g}"]


def test_a_message_that_came_while_a_clip_was_loaded_is_not_kept_waiting(work, tmp_path):
    load(work, tmp_path, tiny.CLIP, first=True)
    work.has_message = lambda: True
    told = load(work, tmp_path, tiny.CLIP.replace("[0, 40, 0]", "[0, 44, 0]"), 1)
    assert [each["kind"] for each in told if each["is"] == "path"] == ["initial", "raw"]
    assert told[-1]["stop"] == "INTERRUPTED"
    work.has_message = lambda: False
    assert load(work, tmp_path, tiny.CLIP.replace("[0, 40, 0]", "[0, 45, 0]"), 2)[-1]["stop"] != "INTERRUPTED"


@pytest.mark.parametrize(
    "asked",
    [
        {"do": "curves", "on": True},
        {"do": "save", "file": "now.npz"},
        {"do": "load", "text": "figure = 1", "name": "tiny", "place": "tiny.toml", "folder": ".", "revision": 1,
         "go": True, "first": False},
    ],
)  # fmt: skip
def test_a_search_continues_after_a_message_that_does_not_end_it(work, tmp_path, asked):
    work.has_message = lambda: True
    assert load(work, tmp_path, tiny.CLIP, first=True)[-1]["stop"] == "INTERRUPTED"
    work.has_message = lambda: False
    told = {**asked, "file": str(tmp_path / "now.npz")} if "file" in asked else asked
    work.do(told)
    ends = [each["stop"] for each in work.line.taken() if each["is"] == "settled"]
    assert ends
    assert "INTERRUPTED" not in ends
    work.do({"do": "curves", "on": False})
    assert work.line.taken() == []  # nothing is left to search


def test_a_message_in_the_last_steps_of_a_search_cuts_it_and_no_more(work, tmp_path, monkeypatch):
    searching = SolverLoop._searching

    @contextmanager
    def ended_late(self):
        with searching(self):
            yield
        monkeypatch.setattr(SolverLoop, "_searching", searching)
        raise KeyboardInterrupt

    monkeypatch.setattr(SolverLoop, "_searching", ended_late)
    told = load(work, tmp_path, tiny.CLIP, first=True)
    assert [each["is"] for each in told].count("searching") == 2
    assert told[-1]["is"] == "settled"
    assert told[-1]["stop"] == "CONVERGED"


def test_a_search_that_was_stopped_stays_so(work, tmp_path):
    work.has_message = lambda: True
    load(work, tmp_path, tiny.CLIP, first=True)
    work.has_message = lambda: False
    work.do({"do": "stop"})
    work.do({"do": "curves", "on": True})
    assert {each["is"] for each in work.line.taken()} == {"curves"}
