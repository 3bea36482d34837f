"""The report's numbers against what is known by hand or from MuJoCo."""

import io
import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
import shipped
from matplotlib.figure import Figure
from paper.nearest import optimise
from problems import FIGURE, names, written
from processes import largest_file, quiet
from random_models import evenly
from rekeyed import with_keys
from rich.console import Console
from shipped import Move
from texts import read_data

from dynsplines import recordings, solving
from dynsplines.errors import UserError
from dynsplines.measure import chart
from dynsplines.measure.bounds import BOUNDS
from dynsplines.measure.chart import draw
from dynsplines.measure.measurement import Measurement
from dynsplines.measure.report import report, rows, tables
from dynsplines.measure.violation import Violation, by_name
from dynsplines.motion import Sampled
from dynsplines.solver.curve.spline import path_of

FOOT = read_data("foot.xml")


def unsolved(folder, keys: list[tuple[float, float, float, float]], head: str = "") -> Move:
    """A box whose keyframes are (time, x, y, z) of its middle, upright, as the raw spline has it."""
    text = f'figure = "foot.xml"\n{head}\n'
    for time, x, y, z in keys:
        text += f"[[keyframe]]\ntime = {time}\nroot.position = [{x}, {y}, {z}]\nroot.rotation = {{rotvec=[0,0,0]}}\n"
    written(folder, text, "foot.toml")
    (folder / "foot.xml").write_text(FOOT, encoding="utf-8")
    return raw_move(folder / "foot.toml")


def raw_move(path: Path) -> Move:
    return Move(clip := recordings.load(str(path)), solving.raw_spline(clip))


def side(solved: Move) -> dict:
    return report(solved.clip, solved.motion)["after"]


def test_penetration_of_a_known_pose_is_what_it_is(tmp_path):
    data = side(unsolved(tmp_path, [(0, 0, 0, 0.1), (0.5, 0, 0, 0.07), (1, 0, 0, 0.1)]))
    found = data["largest"]["penetration"]
    assert found["amount"] == pytest.approx(0.03, abs=1e-4)
    assert found["name"] in ("heel in floor", "toe in floor", "box in floor")
    assert found["at, s"] == pytest.approx(0.5)


def test_a_box_that_hovers_in_flight_is_a_whole_weight_off_free_fall(tmp_path):
    data = side(unsolved(tmp_path, [(0, 0, 0, 1), (0.4, 0, 0, 1)]))["support"]
    assert data["off free fall, g"] == pytest.approx(1)
    assert data["upward force in flight, N"] == pytest.approx(2 * 9.81)
    assert data["largest upward force in flight, N"] == pytest.approx(2 * 9.81)
    assert data["root mean square"] == pytest.approx(1)
    assert data["moment, root mean square"] == pytest.approx(0, abs=1e-9)
    slow = unsolved(tmp_path, [(t, 0, 0, 1 - 2 * (t - 0.2) ** 2) for t in (0, 0.1, 0.2, 0.3, 0.4)])
    missing = 1 + Sampled.of(slow.motion, 1000).qacc[:, 2] / 9.81
    assert side(slow)["support"]["root mean square"] == pytest.approx(np.sqrt(np.mean(missing**2)), rel=0.01)


def test_a_box_that_stands_is_carried_by_the_floor_and_one_of_which_nothing_is_known_is_not(tmp_path):
    data = side(unsolved(tmp_path, [(0, 0, 0, 0.1), (0.4, 0, 0, 0.1)]))["support"]
    assert data["root mean square"] < 1e-3
    assert "off free fall, g" not in data
    data = side(unsolved(tmp_path, [(0, 0, 0, 1), (3, 0, 0, 1)]))
    assert data["support"] == {}
    assert "penetration" not in data["largest"]


@pytest.mark.slow
def test_forces_and_moments_that_are_missing_are_reported_below_their_bounds_too():
    clip, motion = shipped.loaded("run_and_step"), shipped.solved("run_and_step")
    data = report(clip, motion)
    assert not {"unsupported", "toppling"} & {each["kind"] for each in data["violations"]}
    before, after = (data[side]["largest"] for side in ("before", "after"))
    assert 0.05 < after["unsupported"]["amount"] < BOUNDS["unsupported"].most < before["unsupported"]["amount"]
    assert 0.05 < after["toppling"]["amount"] < BOUNDS["toppling"].most and after["toppling"]["name"] == "root"


def test_a_foot_that_wanders_between_two_planted_keyframes_slides_as_far_as_it_does(tmp_path):
    keys = [
        (-0.5, 0.0, 0.0, 0.1),
        (0.0, 0.0, 0.0, 0.1),
        (0.5, 0.3, 0.0, 0.4),
        (1.0, 0.0, 0.02, 0.1),
        (1.5, 0.0, 0.02, 0.1),
    ]
    solved = unsolved(tmp_path, keys)
    stances = Measurement.sides(solved.clip, solved.motion)[1].targets["stance"]
    assert {(s.point.name, s.first, s.last) for s in stances} == {
        (point, *span) for point in ("heel", "toe") for span in ((-0.5, 0), (1, 1.5))
    }
    run = Sampled.of(solved.motion, 2000.0)
    at_start = np.linalg.norm(run.qpos[run.time <= 0, :3] - [0, 0, 0.1], axis=1).max()
    at_end = np.linalg.norm(run.qpos[run.time >= 1, :3] - [0, 0.02, 0.1], axis=1).max()
    assert 0.01 < at_start < at_end
    found = side(solved)["largest"]["stance"]
    assert found["amount"] == pytest.approx(at_end, rel=1e-3)
    assert 1 < found["at, s"] < 1.5
    drifting = unsolved(tmp_path, [(0, 0, 0, 0.1), (1, 0.04, 0, 0.1)], '[solve]\nends = "free"')
    assert side(drifting)["largest"].get("stance", {"amount": 0.0})["amount"] < 1e-9


def test_skate_of_round_feet_is_measured_at_their_lowest_points(tmp_path):
    (tmp_path / "ball.xml").write_text(
        """<mujoco><worldbody><body name="trunk" pos="0 0 .4"><freejoint/><geom size=".1"/>
        <body name="left_foot" pos="0 .1 -.37"><joint name="l" axis="0 1 0"/><geom name="left" size=".03"/></body>
        <body name="right_foot" pos="0 -.1 -.37"><joint name="r" axis="0 1 0"/><geom name="right" size=".03"/></body>
        </body></worldbody></mujoco>"""
    )
    key = '[[keyframe]]\ntime = {0}\nroot.position = [{0}, 0, 0.4]\nothers = "rest"\n'
    keys = key.format(0.0) + key.format(1.0)
    written(tmp_path, f'figure = "ball.xml"\n[solve]\nends = "free"\n{keys}', "ball.toml")
    solved = raw_move(tmp_path / "ball.toml")
    skate = side(solved)["skate"]
    assert skate and all(one["path, m"] == pytest.approx(1) for one in skate.values())
    assert all(one["speed, m/s"] == pytest.approx(1) == one["rest, s"] for one in skate.values())


@pytest.mark.slow
def test_keyframe_error_is_seen_where_a_keyframe_is_missed(solved: Move):
    data = report(solved.clip, solved.motion)
    assert data["after"]["keyframe error"] < 1e-12
    key = solved.clip.keys[1]
    state = key.state.copy()
    state[0] += 0.0125
    state[2] += 5  # which the keyframe does not fix
    keys = (solved.clip.keys[0], type(key)(key.time, state, key.fixed), solved.clip.keys[2])
    missed = report(with_keys(solved.clip, keys), solved.motion)
    assert missed["after"]["keyframe error"] == pytest.approx(0.0125, abs=1e-9)


@pytest.mark.slow
def test_what_is_left_to_gain_is_about_what_four_times_the_frames_gain(solved: Move):
    motion = solved.motion
    told = report(solved.clip, motion)["left to gain"]
    objective = solved.clip.problem.objective
    fine = optimise(objective, evenly(motion.timeline, 3), tolerance=1e-6)
    gained = objective.value(motion.path) - objective.value(path_of(fine))
    assert gained / 3 < told["objective"] < 3 * gained
    assert told["share"] == pytest.approx(told["objective"] / objective.value(motion.path))


@pytest.mark.slow
def test_a_recording_is_reported_once_and_nothing_is_said_of_a_search(tmp_path):
    keys = [(0.02 * i, 0.01 * i, 0.0, 0.07 + 0.001 * (i % 3)) for i in range(40)]
    solved = unsolved(tmp_path, keys)
    data = report(solved.clip, solved.motion)
    assert data["left to gain"] == {} and "stance" not in data["after"]["largest"]
    assert {name: data["before"][name] for name in data["before"]} == {
        name: data["after"][name] for name in data["before"]
    }
    assert len(data["violations"]) > 30  # every image has the box in the floor itself
    out = io.StringIO()
    Console(file=out, width=160).print(tables(json.loads(json.dumps(data))))
    shown = out.getvalue()
    assert "recording" in shown and "before" not in shown.split("centre of mass")[0] and "left to gain" not in shown
    told = [line for line in shown.splitlines() if line.startswith("violation:")]
    assert len(told) < 5
    assert any(line.rstrip().endswith("samples in all") for line in told)
    (alone,) = by_name([Violation(**data["violations"][0])])
    assert "samples in all" not in alone.text


def test_totals_are_of_the_search_in_strict_json_and_on_the_screen(solved: Move):
    data = report(solved.clip, replace(solved.motion, search=solved.motion.search | {"seconds": 1.25}))
    assert data["after"]["objective"] == pytest.approx(solved.motion.trace[-1][2], rel=1e-9)
    assert data["after"]["objective"] == pytest.approx(sum(data["after"]["terms"].values()))
    assert data["after"]["objective"] < data["before"]["objective"]
    assert data["seconds"] == 1.25
    assert (data["keyframes"], data["partial keyframes"]) == (3, 1)
    assert data["duration, s"] == pytest.approx(0.41)
    assert data["variable frames"] == solved.motion.timeline.variable_count
    assert json.loads(json.dumps(data, allow_nan=False)) == data
    out = io.StringIO()
    Console(file=out, width=160).print(tables(data))
    shown = out.getvalue()
    words = ("3 keyframes (1 partial)", "largest whip", "keyframe error", "left_knee")
    assert not [each for each in words if each not in shown]
    assert "nan" not in shown
    labels = [label for label, *_ in rows(data["before"], data["after"])]
    assert not [label for label in labels if re.search(r", (m|s|N|degrees)\b", label)]


@pytest.mark.slow
@pytest.mark.parametrize("figure", ["hinges", "no sites"])
def test_figures_without_feet_or_quaternions_have_a_report_too(tmp_path, figure):
    if figure == "hinges":
        text = 'figure = "hinge.xml"\n[solve]\nevaluations = 3\n'
        text += "".join(f"[[keyframe]]\ntime = {i}\njoints.swing = {40 * i * i}\n" for i in range(3))
        path = written(tmp_path, text)
    else:
        path = written(tmp_path)
        (tmp_path / "tiny.xml").write_text(FIGURE.replace("left_toe", "tip"), encoding="utf-8")
    clip = recordings.load(str(path))
    data = report(clip, solving.solve(clip, quiet()))
    json.dumps(data, allow_nan=False)
    assert data["after"]["skate"] == {}
    assert "stance" not in data["after"]["largest"]
    Console(file=io.StringIO()).print(tables(data))


def test_the_objective_of_the_report_is_that_of_the_search():
    """Limbs of the walk graze by 2 mm, which the search does not count."""
    walk = shipped.of("walk_loop")
    data = report(walk.clip, walk.motion)
    assert data["after"]["objective"] == pytest.approx(walk.motion.trace[-1][2], rel=0.05)
    assert data["left to gain"]["share"] < 0.1


@pytest.fixture(scope="module")
def sides(solved: Move) -> tuple[Measurement, Measurement]:
    return Measurement.sides(solved.clip, solved.motion)


@pytest.fixture
def kept() -> Iterator[list[Figure]]:
    """The figures as they were when they went into their files."""
    figures: list[Figure] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(chart.plt, "close", figures.append)
        yield figures
    for each in figures:
        plt.close(each)


@pytest.mark.parametrize(("ending", "start"), [("svg", b"<?xml"), ("pdf", b"%PDF"), ("PNG", b"\x89PNG")])
def test_the_chart_is_of_the_largest_amount_of_each_kind(sides, tmp_path, kept, ending, start):
    name = r"a$\frac$b"  # a name with dollars is no formula
    draw(name, sides[0], sides[1], tmp_path / f"c.{ending}")
    assert (tmp_path / f"c.{ending}").read_bytes().startswith(start)
    assert names(tmp_path) == [f"c.{ending}"]
    (axes,) = kept[0].axes
    lines = {line.get_label(): line for line in axes.get_lines() if not str(line.get_label()).startswith("_")}
    before, after = (side.largest() for side in sides)
    amounts = {
        kind: max(side[kind][1] / side[kind][0].bound for side in (before, after) if kind in side)
        for kind in {*before, *after}
    }
    assert lines.keys() == {kind for kind, amount in amounts.items() if amount >= chart.LEAST}
    assert len(lines) > 1
    for kind in lines.keys() & after.keys():
        row, worst, time = after[kind]
        values = np.asarray(lines[kind].get_ydata())
        assert values.max() == pytest.approx(worst / row.bound)
        assert time in lines[kind].get_xdata()[values == values.max()]
    upright = {float(line.get_xdata()[0]) for line in axes.get_lines() if len(set(line.get_xdata())) == 1}
    assert upright == {0, 0.2, 0.41}


def test_a_chart_that_breaks_off_leaves_what_was_there(sides, tmp_path):
    (tmp_path / "c.png").write_bytes(b"before")
    with largest_file(1000), pytest.raises(UserError, match=r"cannot write '.*c\.png': "):
        draw("c", sides[0], sides[1], tmp_path / "c.png")
    assert (tmp_path / "c.png").read_bytes() == b"before"
    assert names(tmp_path) == ["c.png"]
    assert plt.get_fignums() == []
