"""Edits of solved motions: the samples of the edited are those of the original, transformed; and of clips' files."""

from __future__ import annotations

import io
import re
import tomllib
from dataclasses import replace
from typing import Any

import numpy as np
import puppet
import pytest
import shipped
import tiny
from rich.console import Console

from dynsplines import models, motion, solving
from dynsplines.clip import load as clip
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
from dynsplines.solver.surface import Box
from dynsplines.system.progress import Progress

FPS = 97.0


def progress() -> Progress:
    return Progress(Console(file=io.StringIO()))


def solved(text: str, name: str) -> Saved:
    return solving.solve(clip.from_text(text, name=name), progress()).saved(progress(), with_report=False)


@pytest.fixture(scope="module")
def cycle() -> Saved:
    """The run loop: it travels."""
    return shipped.solved("run_loop").saved(progress(), with_report=False)


@pytest.fixture(scope="module")
def steps() -> Saved:
    """The same with free ends, and the second knee left free at one keyframe."""
    text = models.clip_text("run_loop").replace('ends = "periodic"', "")
    text = text.replace("variable = 3", "variable = 1").replace("frames = 18", "frames = 8")
    keyframes = text.split("[[keyframe]]")
    keyframes[3] = re.sub(r"joints.right_knee = .*\n", "", keyframes[3])
    text = "[[keyframe]]".join(keyframes[:-1])
    return solved(text, "steps")


def assert_same(saved: Saved, got: Array, wanted: Array) -> None:
    """Configurations (T, nq), whatever the signs of quaternions."""
    got = got.copy()
    for columns in saved.figure.tables.quaternion_columns.T:
        got[:, columns] *= np.sign(np.sum(got[:, columns] * wanted[:, columns], axis=1))[:, None]
    np.testing.assert_allclose(got, wanted, rtol=0, atol=1e-9)


@pytest.mark.slow
def test_mirrored_samples_are_the_mirror_images_of_samples(cycle, steps):
    for saved in (cycle, steps):
        mirror, mirrored = Mirror.of(saved.figure), edits.mirrored(saved)
        for before, after in ((saved.timeline, mirrored.timeline), (saved.raw, mirrored.raw)):
            one, two = (sampled(saved.figure, each, FPS) for each in (before, after))
            assert_same(saved, two.qpos, mirror.states(one.qpos))
        twice = edits.mirrored(mirrored)
        np.testing.assert_array_equal(twice.timeline.rows, saved.timeline.rows)
        for a, b in zip(twice.keys, saved.keys, strict=True):
            np.testing.assert_array_equal(a.state, b.state)
            np.testing.assert_array_equal(a.fixed, b.fixed)


@pytest.mark.slow
def test_the_run_loop_is_its_own_mirror_image_half_a_period_on(cycle):
    t = np.linspace(0, 0.37, 30)
    later, other = cycle.timeline, edits.mirrored(cycle).timeline
    wanted = cycle.figure.to_qpos(path_of(later).at(t + 0.37))
    got = cycle.figure.to_qpos(path_of(other).at(t)) + np.eye(cycle.figure.width)[0]
    for columns in cycle.figure.tables.quaternion_columns.T:
        got[:, columns] *= np.sign(np.sum(got[:, columns] * wanted[:, columns], axis=1))[:, None]
    assert np.abs(got - wanted).max() < 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("speed", [0.4, 1.5])
def test_retimed_samples_are_those_at_other_times(cycle, steps, speed):
    for saved in (cycle, steps):
        fast = edits.retimed(saved, speed)
        one, two = sampled(saved.figure, saved.timeline, FPS), sampled(saved.figure, fast.timeline, FPS * speed)
        assert_same(saved, two.qpos, one.qpos)
        np.testing.assert_allclose(two.qvel, one.qvel * speed, atol=1e-9 * np.abs(one.qvel).max() + 1e-9)
        np.testing.assert_allclose(two.qacc, one.qacc * speed**2, atol=1e-9 * np.abs(one.qacc).max() * 10)
        assert [key.time * speed for key in fast.keys] == pytest.approx([key.time for key in saved.keys])


@pytest.mark.slow
def test_trimmed_samples_are_those_of_the_interval(cycle, steps):
    for saved in (cycle, steps):
        part = edits.trimmed(saved, 10 / FPS, 50 / FPS)
        one, two = sampled(saved.figure, saved.timeline, FPS), sampled(saved.figure, part.timeline, FPS)
        assert_same(saved, two.qpos, one.qpos[10:51])
        assert part.keys[0].is_key
        assert part.keys[-1].is_key
        assert [key.time for key in part.keys[1:-1]] == [0.12, 0.26, 0.37, 0.49]
        np.testing.assert_array_equal(part.keys[2].fixed, saved.keys[2].fixed)


@pytest.mark.slow
@pytest.mark.parametrize("fps", [30.0, FPS])
def test_a_repeated_loop_is_sampled_without_a_doubled_image(cycle, fps):
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


@pytest.mark.slow
def test_a_joined_motion_continues_where_the_first_ends_and_as_the_second_is(steps):
    after = edits.trimmed(steps, 0.2, 0.55)
    whole = edits.joined(steps, after, 0.25, progress())
    figure, path = steps.figure, path_of(whole.timeline)
    end = steps.timeline.times[-1]
    t = np.linspace(0, end, 80)
    np.testing.assert_allclose(path.at(t), path_of(steps.timeline).at(t), atol=1e-9)
    t = np.linspace(0.2, 0.55, 40)
    got, was = figure.to_qpos(path.at(t - 0.2 + end + 0.25)), figure.to_qpos(path_of(after.timeline).at(t))
    for columns in figure.tables.quaternion_columns.T[1:]:
        np.testing.assert_allclose(quat.angle_between(got[:, columns], was[:, columns]), 0, atol=1e-7)
    np.testing.assert_allclose(got[:, 2], was[:, 2], atol=1e-9)
    turn = quat.product(got[:, 3:7], quat.inverse(was[:, 3:7]))
    np.testing.assert_allclose(turn[:, 1:3], 0, atol=1e-9)
    np.testing.assert_allclose(quat.angle_between(turn, turn[0]), 0, atol=1e-7)
    np.testing.assert_allclose(got[:, :3] - got[0, :3], quat.rotated(turn[0], was[:, :3] - was[0, :3]), atol=1e-9)
    bounds = path.at(np.linspace(end, end + 0.25, 40))[:, 2]
    assert 0.8 < bounds.min() < bounds.max() < 1
    times = [key.time for key in whole.keys]
    assert times == sorted(times)
    assert len(times) == len(steps.keys) + len(after.keys)


def test_an_edited_motion_is_measured_saved_and_read_again(saved, tmp_path):
    part = edits.measured(replace(edits.trimmed(saved, 0.1, 0.3), name="part"), progress(), "not searched: trimmed")
    assert part.report["keyframes"] == 3
    assert part.report["stopped because"] == "not searched: trimmed"
    assert part.report["after"]["keyframe error"] < 1e-9
    assert part.report["before"]["keyframe error"] < 1e-9
    motion.save(part, tmp_path / "part.npz")
    again = motion.load(tmp_path / "part.npz")
    np.testing.assert_array_equal(again.timeline.rows, part.timeline.rows)
    assert again.report == part.report


LOOP = tiny.changed("frames = 2", 'frames = 2\nends = "periodic"\ntravel = [0.3, 0, 0.1]').replace(
    "root.position = [0.3, 0, 1]\nroot.rotation = {rotvec = [0, 10, 170]}", 'root.position = [0.3, "free", 1.1]'
)


@pytest.mark.slow
def test_an_edited_loop_is_still_measured_as_one(tmp_path):
    found = clip.load(str(tiny.written(tmp_path, LOOP)))
    saved = solving.solve(found, progress()).saved(progress(), with_report=False)
    for edited in (saved, edits.retimed(saved, 2.0), edits.repeated(saved, 2)):
        report = edits.measured(edited, progress(), "edited").report
        count = len(edited.keys) // 2
        for side in ("before", "after"):
            seam = report[side]["seam"]
            np.testing.assert_allclose(seam["travel, m"], [0.3 * count, 0, 0.1 * count], atol=1e-12)
            for name in ("state", "first derivative", "second derivative"):
                assert seam[name] < 1e-9
        again = table_of(edited.text, "again").solve
        assert (again.ends, again.travel) == ("periodic", pytest.approx((0.3 * count, 0, 0.1 * count)))


# what cannot be


@pytest.mark.slow
def test_edits_that_make_no_motion_are_refused(steps, cycle, saved):
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
    with pytest.raises(UserError, match="over 600 s"):
        edits.repeated(cycle, 1000)
    for transition in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(UserError, match=r"a transition lasts 0\.001 to 600 s"):
            edits.joined(steps, steps, transition, progress())
    with pytest.raises(UserError, match="of different figures; they differ in: left_ankle, left_elbow"):
        edits.joined(steps, saved, 0.4, progress())
    with pytest.raises(UserError, match="puppet: no partner on the other side for: "):
        edits.mirrored(puppet.moved())


@pytest.mark.slow
def test_motions_in_different_coordinates_are_not_joined(steps):
    text = steps.text.replace("[solve]", '[solve]\ncoordinates = "joint"')
    other = solving.unsolved(clip.from_text(text, name="other")).saved(progress(), with_report=False)
    with pytest.raises(UserError, match="'steps' is in world coordinates, 'other' in joint coordinates"):
        edits.joined(steps, other, 0.4, progress())


# clips' files


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


@pytest.mark.slow
def test_keyframes_of_a_motion_become_a_clip_of_the_same_keyframes(steps):
    table = table_of(steps.text, "steps").changed(keyframe=keyframe_tables(steps.figure, steps.keys))
    again = clip.from_text(written(table), name="again")
    for a, b in zip(again.keys, steps.keys, strict=True):
        np.testing.assert_array_equal(a.fixed, b.fixed)
        np.testing.assert_allclose(a.state[a.fixed], b.state[b.fixed], atol=1e-12)


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


@pytest.mark.slow
def test_a_mirrored_clip_is_the_clip_of_the_mirrored_keyframes(tmp_path):
    text = models.clip_text("run_and_step").replace("height = 0.35}", "height = 0.35, y = 0.2}")
    text = text.replace('kind = "limits"', 'kind = "limits"\nbend_joints = ["left_knee", "right_elbow"]')
    text = text.replace(
        "joints.spine = {rotvec = [2.258, 1.991, -12.803]}", "joints.spine = {euler = [5, 6, 7], order = 'zyx'}"
    )
    text = text.replace("root.position = [0.4200, 0.0000, 0.9150]", 'root.position = [0.4200, 0.1000, "free"]')
    source = tmp_path / "run.toml"
    source.write_text(text, encoding="utf-8")
    target = tmp_path / "deeper" / "mirrored.toml"
    target.parent.mkdir()
    edit_files.run([str(source)], edit_files.mirrored(), target, overwrite=False, progress=progress())
    before, after = clip.load(str(source)), clip.load(str(target))
    mirror = Mirror.of(before.figure)
    for a, b in zip(after.keys, map(mirror.key, before.keys), strict=True):
        np.testing.assert_array_equal(a.fixed, b.fixed)
        np.testing.assert_allclose(a.state[a.fixed], b.state[b.fixed], atol=1e-12)
    assert [bend.name for bend in after.context.bends] == ["right_knee", "left_elbow"]
    steps = [next(each for each in found.context.surfaces if isinstance(each, Box)) for found in (before, after)]
    assert [step.centre[1] for step in steps] == [0.2, -0.2]
    edit_files.run([str(target)], edit_files.mirrored(), tmp_path / "again.toml", overwrite=False, progress=progress())
    twice = clip.load(str(tmp_path / "again.toml"))
    for a, b in zip(twice.keys, before.keys, strict=True):
        np.testing.assert_array_equal(a.state, b.state)


ROUND = """
figure = "human"
[scene]
step = {x = 1, height = 0.2, y = 0.1}
box = [{position = [1, 2, 0.5], size = [1, 1, 1], rotation = {rotvec = [0, 0, 20]}}]
capsule = [{radius = 0.1, from = [0, 1, 1], to = [1, 2, 1]}]
[[penalty]]
kind = "flight"
intervals = [[0.2, 0.4]]
[[contact]]
point = "left_toe"
from = 0.6
to = 1.0
position = [0.2, 0.1, 0.0]
[[keyframe]]
time = 0.0
others = "rest"
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
def test_places_contacts_and_obstacles_change_sides_with_a_clip(tmp_path):
    (tmp_path / "one.toml").write_text(ROUND, encoding="utf-8")
    for name, target in (("one", "two"), ("two", "three")):
        paths = tmp_path / f"{name}.toml", tmp_path / f"{target}.toml"
        edit_files.run([str(paths[0])], edit_files.mirrored(), paths[1], overwrite=False, progress=progress())
    one, two, three = (clip.load(str(tmp_path / f"{name}.toml")) for name in ("one", "two", "three"))
    mirror = Mirror.of(one.figure)
    for a, b in zip(two.keys, map(mirror.key, one.keys), strict=True):
        np.testing.assert_array_equal(a.fixed, b.fixed)
        np.testing.assert_allclose(a.state[a.fixed], b.state[b.fixed], atol=1e-6)
    table = table_of(two.text, "two")
    assert table.contact[0].point == "right_toe"
    assert table.contact[0].position == (0.2, -0.1, 0.0)
    assert two.context.placed[0].point.name == "left_hand"
    for geom in ("step", "box 1", "capsule 1"):
        mine, its = (found.figure.model.geom(geom) for found in (one, two))
        np.testing.assert_allclose(its.pos, mine.pos * [1, -1, 1], atol=1e-12)
    assert tables(table_of(three.text, "three")) == tables(table_of(ROUND, "one"))


@pytest.mark.slow
def test_contacts_and_flights_are_retimed_with_the_keyframes(tmp_path):
    (tmp_path / "one.toml").write_text(ROUND, encoding="utf-8")
    target = tmp_path / "fast.toml"
    edit_files.run(
        [str(tmp_path / "one.toml")], edit_files.retimed(2.0, None), target, overwrite=False, progress=progress()
    )
    table = table_of(target.read_text(encoding="utf-8"), "fast")
    assert (table.contact[0].start, table.contact[0].end) == (0.3, 0.5)
    assert table.penalty[0].options["intervals"] == [[0.1, 0.2]]


@pytest.mark.slow
def test_a_loop_with_contacts_can_be_repeated():
    many = edits.repeated(shipped.solved("walk_loop").saved(progress(), with_report=False), 2)
    assert clip.of_motion(many).keys[-1].time == pytest.approx(2 * 1.08)


@pytest.mark.slow
def test_a_retimed_clip_has_other_times_and_nothing_else(tmp_path):
    path = tiny.written(tmp_path)
    (tmp_path / "sub").mkdir()
    target = tmp_path / "sub" / "fast.toml"
    edit_files.run([str(path)], edit_files.retimed(2.0, None), target, overwrite=False, progress=progress())
    before, after = clip.load(str(path)), clip.load(str(target))
    assert [key.time for key in after.keys] == pytest.approx([key.time / 2 for key in before.keys])
    for a, b in zip(after.keys, before.keys, strict=True):
        np.testing.assert_array_equal(a.state, b.state)
    assert after.settings == before.settings
    edit_files.run([str(path)], edit_files.retimed(None, 3.0), target, overwrite=False, progress=progress())
    assert clip.load(str(target)).keys[-1].time == pytest.approx(3)


def test_nothing_is_written_over_what_is_edited_unasked(tmp_path, saved):
    source = tmp_path / "tiny.npz"
    motion.save(saved, source)
    was = source.read_bytes()
    edit = edit_files.trimmed(0.1, None)
    with pytest.raises(UserError, match="is the input file; give another -o, or --overwrite"):
        edit_files.run([str(source)], edit, source, overwrite=False, progress=progress())
    with pytest.raises(UserError, match=r"as a motion, \.npz, or as a clip, \.toml"):
        edit_files.run([str(source)], edit, tmp_path / "out.mp4", overwrite=False, progress=progress())
    with pytest.raises(UserError, match="not inside"):
        edit_files.run([str(source)], edit_files.trimmed(-7, None), source, overwrite=True, progress=progress())
    assert source.read_bytes() == was
    assert tiny.names(tmp_path) == ["tiny.npz"]
    edit_files.run([str(source)], edit, source, overwrite=True, progress=progress())
    assert motion.load(source).keys[0].time == 0.1
    edit_files.run(
        [str(source)], edit_files.trimmed(None, 0.3), tmp_path / "cut.toml", overwrite=False, progress=progress()
    )
    tiny.written(tmp_path)
    assert [key.time for key in clip.load(str(tmp_path / "cut.toml")).keys] == [0.1, 0.2, 0.3]
