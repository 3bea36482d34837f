"""Edits of solved motions and of clips' files; what they do to curves is tested in tests/solver/edit."""

from __future__ import annotations

import io
import re
import tomllib
from typing import Any

import numpy as np
import puppet
import pytest
import shipped
import tiny
from oracles import aligned, kinematics
from quiet import quiet
from rich.console import Console

from dynsplines import Keyframe, Motion, build, inbetween, models, motion, recordings, solving
from dynsplines.clip import load as clip
from dynsplines.clip.mirror import mirrored_tables
from dynsplines.clip.parse import table_of
from dynsplines.clip.table import RotationTable
from dynsplines.clip.text import keyframe_tables, rotation, tables, written
from dynsplines.edit import edits
from dynsplines.edit import files as edit_files
from dynsplines.errors import UserError
from dynsplines.motion import Saved, sampled
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.system.progress import Progress

FPS = 97.0


def solved(text: str, name: str) -> Saved:
    return solving.solve(recordings.from_text(text, name=name), quiet()).saved(quiet(), with_report=False)


@pytest.fixture(scope="module")
def steps() -> Saved:
    """The same with free ends, and the second knee left free at one keyframe."""
    text = models.clip_text("run_loop").replace('ends = "periodic"', "")
    text = text.replace("variable = 3", "variable = 1").replace("frames = 18", "frames = 8\nevaluations = 4")
    keyframes = text.split("[[keyframe]]")
    keyframes[3] = re.sub(r"joints.right_knee = .*\n", "", keyframes[3])
    text = "[[keyframe]]".join(keyframes[:-1])
    return solved(text, "steps")


def assert_same(saved: Saved, got: Array, wanted: Array) -> None:
    """Configurations (T, nq), whatever the signs of quaternions."""
    np.testing.assert_allclose(aligned(saved.figure, got, wanted), wanted, rtol=0, atol=1e-9)


@pytest.mark.slow
def test_edited_motions_have_the_edited_keyframes_and_raw_splines(steps):
    mirror, mirrored, fast = Mirror.of(steps.figure), edits.mirrored(steps), edits.retimed(steps, 1.5)
    for before, after in ((steps.timeline, mirrored.timeline), (steps.raw, mirrored.raw)):
        one, two = (sampled(steps.figure, each, FPS) for each in (before, after))
        assert_same(steps, two.qpos, mirror.states(one.qpos))
    for a, b in zip(edits.mirrored(mirrored).keys, steps.keys, strict=True):
        np.testing.assert_array_equal(a.state, b.state)
        np.testing.assert_array_equal(a.fixed, b.fixed)
    for before, after in ((steps.timeline, fast.timeline), (steps.raw, fast.raw)):
        assert_same(steps, sampled(steps.figure, after, 1.5 * FPS).qpos, sampled(steps.figure, before, FPS).qpos)
    assert [key.time * 1.5 for key in fast.keys] == pytest.approx([key.time for key in steps.keys])
    part = edits.trimmed(steps, 10 / FPS, 50 / FPS)
    assert part.keys[0].is_key and part.keys[-1].is_key
    assert [key.time for key in part.keys[1:-1]] == [0.12, 0.26, 0.37, 0.49]
    np.testing.assert_array_equal(part.keys[2].fixed, steps.keys[2].fixed)
    whole, end = edits.joined(steps, part, 0.25, quiet()), steps.timeline.times[-1]
    assert [key.time for key in whole.keys] == pytest.approx(
        [key.time for key in steps.keys] + [key.time - 10 / FPS + end + 0.25 for key in part.keys]
    )
    bounds = path_of(whole.timeline).at(np.linspace(end, end + 0.25, 40))[:, 2]
    assert 0.8 < bounds.min() < bounds.max() < 1


@pytest.mark.slow
def test_a_repeated_loop_is_sampled_without_a_doubled_image():
    fps = FPS
    cycle = shipped.solved("run_loop").saved(quiet(), with_report=False)
    many, seam = edits.repeated(cycle, 3), Seam.of(cycle.figure, cycle.timeline)
    run = sampled(cycle.figure, many.timeline, fps)
    assert len(run.time) == int(3 * 0.74 * fps + 1e-9) + 1
    number = np.minimum((run.time / 0.74).astype(int), 2)
    within = path_of(cycle.timeline).at(run.time - 0.74 * number)
    wanted = cycle.figure.to_qpos(np.array([seam.moved(y, k) for y, k in zip(within, number, strict=True)]))
    assert_same(cycle, run.qpos, wanted)
    pace = np.diff(run.qpos[:, 0]) * fps
    assert pace.min() > 2
    assert [key.time for key in many.keys] == pytest.approx(
        [k.time + 0.74 * i for i in range(3) for k in cycle.keys[i > 0 :]]
    )
    assert clip.of_motion(many).ends == "periodic"
    assert edits.repeated(cycle, 1) is cycle


LOOP = tiny.changed("frames = 2", 'frames = 2\nends = "periodic"\ntravel = [0.3, 0, 0.1]').replace(
    "root.position = [0.3, 0, 1]\nroot.rotation = {rotvec = [0, 10, 170]}", 'root.position = [0.3, "free", 1.1]'
)


def test_seams_of_a_repeated_loop_have_the_entries_that_either_end_fixes():
    text = models.clip_text("walk_loop")
    loop = solving.unsolved(recordings.from_text(text, name="walk")).saved(quiet(), with_report=False)
    assert not loop.keys[-1].is_key
    many = edits.repeated(loop, 3)
    again = recordings.from_text(many.text, name="again").keys
    seam = Seam.of(loop.figure, loop.timeline)
    for number in (1, 2):
        key = again[number * (len(loop.keys) - 1)]
        assert key.is_key
        wanted = loop.figure.to_qpos(seam.moved(loop.timeline.states[:1], number))
        assert_same(loop, key.state[None], wanted)


@pytest.mark.slow
def test_an_edited_loop_is_still_measured_as_one(tmp_path):
    found = clip.load(str(tiny.written(tmp_path, LOOP)))
    edited = edits.repeated(edits.retimed(solving.solve(found, quiet()).saved(quiet(), with_report=False), 2.0), 2)
    report = solving.measured(edited, quiet(), "edited").report
    for side in ("before", "after"):
        seam = report[side]["seam"]
        np.testing.assert_allclose(seam["travel, m"], [0.6, 0, 0.2], atol=1e-12)
        for name in ("state", "first derivative", "second derivative"):
            assert seam[name] < 1e-9
    again = table_of(edited.text, "again").solve
    assert (again.ends, again.travel) == ("periodic", pytest.approx((0.6, 0, 0.2)))


def test_a_trimmed_recording_at_1_khz_has_all_its_samples():
    clip = build("human", [Keyframe(i / 1000, others="rest") for i in range(20)])
    recorded = solving.unsolved(clip).saved(quiet(), with_report=False)
    assert len(edits.trimmed(recorded, 0.008, 0.017).keys) == 10


# what cannot be


@pytest.mark.slow
def test_edits_that_make_no_motion_are_refused(steps, saved):
    with pytest.raises(UserError, match=r"steps: from 0\.1 to 0\.7 s is not inside 0 to 0\.63 s"):
        edits.trimmed(steps, 0.1, 0.7)
    with pytest.raises(UserError, match="steps: an interval ends after it begins"):
        edits.trimmed(steps, 0.5, 0.1)
    with pytest.raises(UserError, match=r"less than 0\.001 s"):
        edits.trimmed(steps, 0.5, 0.5004)
    with pytest.raises(UserError, match=r"less than 0\.001 s"):
        edits.retimed(steps, 500)
    with pytest.raises(UserError, match="over 600 s"):
        edits.retimed(steps, 1e-3)
    with pytest.raises(UserError, match="only a loop"):
        edits.repeated(steps, 2)
    cycle = shipped.solved("run_loop").saved(quiet(), with_report=False)
    with pytest.raises(UserError, match="over 600 s"):
        edits.repeated(cycle, 1000)
    for transition in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(UserError, match=r"a transition lasts 0\.001 to 600 s"):
            edits.joined(steps, steps, transition, quiet())
    with pytest.raises(UserError, match="of different figures; they differ in: left_ankle, left_elbow"):
        edits.joined(steps, saved, 0.4, quiet())
    text = steps.text.replace("[solve]", '[solve]\ncoordinates = "joint"')
    other = solving.unsolved(recordings.from_text(text, name="other")).saved(quiet(), with_report=False)
    with pytest.raises(UserError, match="'steps' is in world coordinates, 'other' in joint coordinates"):
        edits.joined(steps, other, 0.4, quiet())
    with pytest.raises(UserError, match="puppet: no partner on the other side for: "):
        edits.mirrored(puppet.moved())


def test_a_clip_written_again_is_equal():
    for name in models.clips():
        text = models.clip_text(name)
        table = tables(table_of(text, name))
        assert tables(table_of(written(table), name)) == table


def test_odd_names_and_texts_survive_being_written():
    table: dict[str, Any] = {
        "figure": 'a "quoted" \\ ünïcode\x7f\n',
        "scene": {"odd key": [1, 2.5, True, {"a b": "free"}]},
    }
    table["keyframe"] = [{"time": 1e-9, "joints": {"left knee": {"quat": [1.0, 0.0, -0.0, 1e300]}, "b": "free"}}]
    assert tomllib.loads(written(table)) == table


def test_rotations_are_written_as_one_would_write_them(rng):
    for size in 10.0 ** rng.uniform(-12, 0, 200):
        q = quat.normalised([1, *(size * rng.normal(size=3))]) * rng.choice([-1, 1])
        rotvec = rotation(q).rotvec or ()
        again = quat.from_rotation_vector(np.radians(rotvec))
        assert quat.angle_between(q, again) < 1e-10
        assert all(x == 0 or abs(x) >= 1e-9 for x in rotvec)
    assert rotation(quat.from_rotation_vector([np.radians(30), 1e-18, -1e-18])) == RotationTable(
        rotvec=(30.0, 0.0, 0.0)
    )
    assert str(rotation([1, 0, -1e-17, 0]).rotvec) == "(0.0, 0.0, 0.0)"
    assert rotation(quat.from_rotation_vector(np.radians([30.000013, 0, 0]))) == RotationTable(
        rotvec=(30.000013, 0.0, 0.0)
    )


def test_hinges_and_slides_come_back_in_degrees_and_metres(tmp_path):
    keyframes = "".join(f"[[keyframe]]\ntime = {i}\njoints = {{slide = 0.1, swing = {30 * i}}}\n" for i in range(2))
    path = tiny.written(tmp_path, f'figure = "hinge.xml"\n{keyframes}')
    found = clip.load(str(path))
    assert [row.joints for row in keyframe_tables(found.figure, found.keys)] == [
        {"slide": 0.1, "swing": pytest.approx(30 * i)} for i in range(2)
    ]


ROUND = """
figure = "human"
[scene]
step = {x = 1, height = 0.2, y = 0.1}
box = [{position = [1, 2, 0.5], size = [1, 1, 1], rotation = {rotvec = [0, 0, 20]}}]
capsule = [{radius = 0.1, from = [0, 1, 1], to = [1, 2, 1]}]
[[penalty]]
kind = "flight"
intervals = [[0.2, 0.4]]
[[penalty]]
kind = "limits"
bend_joints = ["left_knee", "right_elbow"]
[[penalty]]
kind = "cycle"
period = 2.0
[[contact]]
point = "left_toe"
from = 0.6
to = 1.0
position = [0.2, 0.1, 0.0]
[[keyframe]]
time = 0.0
others = "rest"
root.position = [0.0, 0.1, "free"]
joints.spine = {euler = [5, 6, 7], order = "zyx"}
[[keyframe]]
time = 1.0
others = "previous"
root.position = [0.0, 0.02, 0.9]
sites.left_toe = [0.2, 0.1, 0.0]
sites.right_hand = {position = [0.4, -0.3, "free"], by = "search"}
bodies.left_foot = {euler = [5, 10, 0], order = "zyx"}
bodies.right_foot = {flat = true}
"""


@pytest.mark.slow
def test_keyframes_places_contacts_and_obstacles_change_sides_with_a_clip(tmp_path):
    target = tmp_path / "deeper" / "two.toml"
    target.parent.mkdir()
    (tmp_path / "one.toml").write_text(ROUND, encoding="utf-8")
    edit_files.run([str(tmp_path / "one.toml")], edit_files.mirrored(), target, overwrite=False, progress=quiet())
    one, two = clip.load(str(tmp_path / "one.toml")), clip.load(str(target))
    mirror = Mirror.of(one.figure)
    for a, b in zip(two.keys, map(mirror.key, one.keys), strict=True):
        np.testing.assert_array_equal(a.fixed, b.fixed)
        np.testing.assert_allclose(a.state[a.fixed], b.state[b.fixed], atol=1e-6)
    table = table_of(two.text, "two")
    assert table.contact[0].point == "right_toe"
    assert table.contact[0].position == (0.2, -0.1, 0.0)
    assert two.context.placed[0].point.name == "left_hand"
    assert [bend.name for bend in two.context.bends] == ["right_knee", "left_elbow"]
    for geom in ("step", "box 1", "capsule 1"):
        mine, its = (found.figure.model.geom(geom) for found in (one, two))
        np.testing.assert_allclose(its.pos, mine.pos * [1, -1, 1], atol=1e-12)
    assert tables(mirrored_tables(table, one.figure, mirror)) == tables(table_of(ROUND, "one"))


@pytest.mark.parametrize(("y", "is_noted"), [(0.4, True), (0.0, False)])
def test_a_mirrored_motion_keeps_its_scene_and_a_note_states_it(tmp_path, y, is_noted):
    ball = f'\n[[scene.sphere]]\nname = "ball"\nradius = 0.1\nposition = [2, {y}, 1]\n'
    path = tiny.written(tmp_path, tiny.changed("fps = 20", "fps = 20" + ball))
    output = io.StringIO()
    progress = Progress(Console(file=output))
    for ending in ("toml", "npz"):
        target = tmp_path / f"other.{ending}"
        edit_files.run([str(path)], edit_files.mirrored(), target, overwrite=False, progress=progress)
        assert ("note: step and obstacles are not mirrored" in output.getvalue()) is (is_noted and ending == "npz")
    there = clip.load(str(tmp_path / "other.toml")).figure.model.geom("ball").pos[1]
    assert (there, motion.load(tmp_path / "other.npz").figure.model.geom("ball").pos[1]) == (-y, y)


@pytest.mark.slow
def test_a_retimed_clip_has_other_times_also_of_contacts_flights_and_cycles_and_nothing_else(tmp_path):
    path = tiny.written(tmp_path)
    (tmp_path / "sub").mkdir()
    target = tmp_path / "sub" / "fast.toml"
    edit_files.run([str(path)], edit_files.retimed(2.0, None), target, overwrite=False, progress=quiet())
    before, after = clip.load(str(path)), clip.load(str(target))
    assert [key.time for key in after.keys] == pytest.approx([key.time / 2 for key in before.keys])
    for a, b in zip(after.keys, before.keys, strict=True):
        np.testing.assert_array_equal(a.state, b.state)
    assert after.settings == before.settings
    edit_files.run([str(path)], edit_files.retimed(None, 3.0), target, overwrite=True, progress=quiet())
    assert clip.load(str(target)).keys[-1].time == pytest.approx(3)
    table = edits.retimed_tables(table_of(ROUND, "one"), 2.0)
    assert (table.contact[0].start, table.contact[0].end) == (0.3, 0.5)
    assert table.penalty[0].options["intervals"] == [[0.1, 0.2]]
    assert table.penalty[2].options["period"] == 1.0


def test_nothing_is_written_over_what_is_edited_unasked(tmp_path, saved):
    source = tmp_path / "tiny.npz"
    motion.save(saved, source)
    was = source.read_bytes()
    edit = edit_files.trimmed(0.1, None)
    with pytest.raises(UserError, match="already exists; give another -o, or --overwrite"):
        edit_files.run([str(source)], edit, source, overwrite=False, progress=quiet())
    with pytest.raises(UserError, match=r"as a motion, \.npz, or as a clip, \.toml"):
        edit_files.run([str(source)], edit, tmp_path / "out.mp4", overwrite=False, progress=quiet())
    with pytest.raises(UserError, match="not inside"):
        edit_files.run([str(source)], edit_files.trimmed(-7, None), source, overwrite=True, progress=quiet())
    assert source.read_bytes() == was
    assert tiny.names(tmp_path) == ["tiny.npz"]
    edit_files.run([str(source)], edit, source, overwrite=True, progress=quiet())
    assert motion.load(source).keys[0].time == 0.1
    edit_files.run(
        [str(source)], edit_files.trimmed(None, 0.3), tmp_path / "cut.toml", overwrite=False, progress=quiet()
    )
    tiny.written(tmp_path)
    assert [key.time for key in clip.load(str(tmp_path / "cut.toml")).keys] == [0.1, 0.2, 0.3]


ARM = """<mujoco><worldbody>
<body><joint name="shoulder" axis="0 0 1"/><geom type="capsule" size=".02" fromto=".02 0 0 .3 0 0"/>
 <body pos=".3 0 0"><joint name="elbow" axis="0 0 1"/><geom type="capsule" size=".02" fromto=".02 0 0 .3 0 0"/>
  <site name="hand" pos=".3 0 0"/></body></body>
<body name="ball"><freejoint name="ball"/><geom size=".03"/></body></worldbody></mujoco>"""


def holding(poses: dict[float, tuple[float, float]]) -> Motion:
    """A motion of the arm with the ball in its hand; angles [degrees] of shoulder and elbow by time."""
    keys = []
    for time, (shoulder, elbow) in poses.items():
        x, y = (0.3 * wave(np.radians([shoulder, shoulder + elbow])).sum() for wave in (np.cos, np.sin))
        ball = {"position": [x, y, 0], "rotation": {"heading": 0}}
        keys.append(Keyframe(time, joints={"shoulder": shoulder, "elbow": elbow}, roots={"ball": ball}))
    return inbetween(build(ARM, keys, grasps=[{"hand": "hand", "body": "ball", "from": 0.0, "to": 0.5}]))


def test_an_arm_on_a_base_keeps_what_it_holds_when_motions_are_joined():
    """The ball is in the hand before, in and after the transition, although free objects move with a root."""
    both = holding({0: (0, 20), 0.5: (60, 90)}).joined(holding({0: (80, 90), 0.5: (100, 20)}), transition=0.4)
    sampled_ = both.sampled(100)
    seen = [kinematics(both.model, qpos) for qpos in sampled_.qpos]
    apart = [np.linalg.norm(data.site("hand").xpos - data.body("ball").xpos) for data in seen]
    assert sampled_.time[-1] == pytest.approx(1.4)
    assert max(apart) < 1e-3
