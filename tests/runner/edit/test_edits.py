"""Edits of motions and of files of clips; what they do to curves is tested in tests/solver/edit."""

import io
import tomllib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import problems
import pytest
import shipped
from motions import moved
from oracles import aligned
from processes import quiet
from rich.console import Console
from texts import read_data

from dynsplines import models, motion, recordings, solving
from dynsplines.clip import text as clip_text
from dynsplines.clip.load import clip_from_motion
from dynsplines.clip.mirror import mirrored_tables
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import tables, text_of
from dynsplines.edit import edits
from dynsplines.edit import files as edit_files
from dynsplines.errors import UserError
from dynsplines.measure.report import report
from dynsplines.measure.violation import violations
from dynsplines.motion import Saved
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.curve.mirror import Mirror
from dynsplines.solver.curve.seam import Seam
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.figure import Figure
from dynsplines.system.progress import Progress

FOLLOWING = 'figure = "tiny.xml"\nfps = 20\n[recording]\nfile = "own.npz"\n'
CONTACT = '[[contact]]\npoint = "left_toe"\nfrom = 0.05\nto = 0.35\nposition = [0.1, 0.2, 0]\n\n'
LOOP = problems.changed("frames = 2", 'frames = 2\nends = "periodic"\ntravel = [0.3, 0, 0.1]').replace(
    "root.position = [0.3, 0, 1]\nroot.rotation = {rotvec = [0, 10, 170]}", 'root.position = [0.3, "free", 1.1]'
)
TIMES = np.linspace(0, 0.41, 42)
Edit = Callable[[Saved], Saved]


def solved(text: str, folder: Path) -> Saved:
    found = recordings.load(str(problems.written(folder, text)))
    return solving.solve(found, quiet())


@pytest.fixture(scope="module")
def motions(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Saved]:
    """A solved clip with contacts and a partial keyframe, one that follows its motion, and a loop."""
    folder = tmp_path_factory.mktemp("own")
    plain = solved(problems.changed("[[keyframe]]", CONTACT + "[[keyframe]]"), folder)
    motion.save(plain, folder / "own.npz")
    return {"plain": plain, "following": solved(FOLLOWING, folder), "loop": solved(LOOP, folder)}


def at(saved: Saved, times: Array) -> Array:
    return saved.figure.to_qpos(path_of(saved.timeline).at(times))


def assert_same(saved: Saved, got: Array, wanted: Array) -> None:
    """Configurations (T, nq), whatever the signs of quaternions."""
    np.testing.assert_allclose(aligned(saved.figure, got, wanted), wanted, rtol=0, atol=1e-9)


def assert_equal(one: Saved, other: Saved) -> None:
    """Curves before and after, and keyframes."""
    times = np.linspace(*path_of(other.timeline).span, 42)
    for a, b in ((one.timeline, other.timeline), (one.raw, other.raw)):
        assert_same(other, *(other.figure.to_qpos(path_of(each).at(times)) for each in (a, b)))
    for a, b in zip(one.keys, other.keys, strict=True):
        assert a.time == pytest.approx(b.time, abs=1e-12)
        np.testing.assert_array_equal(a.fixed, b.fixed)
        assert_fixed(other, a.fixed, a.state, b.state)


def assert_fixed(saved: Saved, fixed: Mask, got: Array, wanted: Array) -> None:
    """Configurations (nq,), but for entries that are not fixed."""
    assert_same(saved, *(np.where(fixed, state, saved.figure.model.qpos0)[None] for state in (got, wanted)))


METAMORPHIC: dict[str, tuple[str, Edit, Edit]] = {  # the motion, and two ways to edit it
    "mirrored twice": ("plain", lambda saved: edits.mirror(edits.mirror(saved)), edits.without_clip),
    "slower, then faster": ("loop", lambda saved: edits.retime(edits.retime(saved, 0.4), 2.5), edits.without_clip),
    "mirrored and faster": (
        "following",
        lambda saved: edits.mirror(edits.retime(saved, 2)),
        lambda saved: edits.retime(edits.mirror(saved), 2),
    ),
    "trimmed in two steps": (
        "following",
        lambda saved: edits.trim(edits.trim(saved, 0.05, 0.4), 0.1, 0.3),
        lambda saved: edits.trim(saved, 0.1, 0.3),
    ),
    "repeated in two steps": (
        "loop",
        lambda saved: edits.repeat(edits.repeat(saved, 2), 2),
        lambda saved: edits.repeat(saved, 4),
    ),
}


@pytest.mark.parametrize("way", METAMORPHIC)
def test_the_same_motion_by_two_ways(motions, way):
    name, *ways = METAMORPHIC[way]
    one, other = (edit(motions[name]) for edit in ways)
    assert_equal(one, other)


EDITS: dict[str, tuple[Edit, Callable[[Array], Array]]] = {
    "mirrored": (edits.mirror, lambda t: t),
    "retimed": (lambda saved: edits.retime(saved, 2.0), lambda t: t / 2),
    "trimmed": (lambda saved: edits.trim(saved, 0.1, 0.3), lambda t: t),
}


@pytest.mark.parametrize("name", ["plain", "following", "loop"])
@pytest.mark.parametrize("edit", EDITS)
def test_an_edited_motion_has_the_samples_of_the_motion_and_no_clip(motions, tmp_path, name, edit):
    before, times = motions[name], np.linspace(0.11, 0.29, 19)
    edited = EDITS[edit][0](before)
    wanted = before.figure.to_state(at(before, times))
    wanted = Mirror.of(before.figure).states(wanted) if edit == "mirrored" else wanted
    assert_same(before, at(edited, EDITS[edit][1](times)), before.figure.to_qpos(wanted))
    assert_plain(edited, tmp_path)
    assert all(key.is_key for key in edited.keys) == (name == "following" or edit == "trimmed")


def assert_plain(edited: Saved, folder: Path) -> None:
    """A motion without a clip, whose keyframes are on its raw spline, that is measured and comes back from a file."""
    assert (edited.text, edited.trace, edited.report, edited.search) == ("", [], {}, {})
    on_raw = edited.figure.to_qpos(path_of(edited.raw).at(np.array([key.time for key in edited.keys])))
    for key, state in zip(edited.keys, on_raw, strict=True):
        assert_fixed(edited, key.fixed, key.state, state)
    motion.save(edited, folder / "edited.npz")
    again = motion.load(folder / "edited.npz")
    assert_equal(again, edited)
    assert isinstance(violations(clip_from_motion(again), again), tuple)
    assert solving.measure(clip_from_motion(again), again, quiet(), "edited").report["stopped because"]


def test_an_edited_motion_is_followed_as_a_recording(motions, tmp_path):
    """To change a motion without a clip."""
    problems.written(tmp_path)
    motion.save(edits.retime(motions["plain"], 0.5), tmp_path / "own.npz")
    key = "[[keyframe]]\ntime = 0.4\njoints.left_knee = {rotvec = [0, 70, 0]}\n"
    found = recordings.from_text(FOLLOWING + key, name="changed", folder=tmp_path)
    assert (found.has_recording, found.keys[-1].time) == (True, pytest.approx(0.82))


@pytest.mark.parametrize("count", [1, 3])
def test_a_repeated_loop_has_the_samples_and_keyframes_of_every_period(motions, count):
    loop = motions["loop"]
    many, seam, period = edits.repeat(loop, count), Seam.of(loop.figure, loop.timeline), 0.41
    for number in range(count):
        wanted = loop.figure.to_qpos(seam.move(path_of(loop.timeline).at(TIMES), number))
        assert_same(loop, at(many, np.minimum(TIMES + number * period, count * period)), wanted)
    wanted = [key.time + period * i for i in range(count) for key in loop.keys[i > 0 :]]
    assert [key.time for key in many.keys] == pytest.approx(wanted)
    for i, key in enumerate(many.keys):
        first, inner, last = (each.fixed for each in loop.keys)
        seam_fixed = first if i == 0 else last if i == 2 * count else first | last
        np.testing.assert_array_equal(key.fixed, inner if i % 2 else seam_fixed)
    found = clip_from_motion(many)
    assert found.ends == "periodic"
    seam = report(found, many)["after"]["seam"]
    np.testing.assert_allclose(seam["travel, m"], [0.3 * count, 0, 0.1 * count], atol=1e-12)
    assert max(seam[name] for name in ("state", "first derivative", "second derivative")) < 1e-9


# what cannot be

REFUSED: dict[str, tuple[Callable[[Saved], object], str]] = {
    "beyond": (lambda saved: edits.trim(saved, 0.1, 0.7), r"from 0\.1 to 0\.7 s is not inside 0 to 0\.41 s"),
    "backwards": (lambda saved: edits.trim(saved, 0.4, 0.1), "ends before it begins"),
    "too short": (lambda saved: edits.trim(saved, 0.2, 0.2004), r"less than 0\.001 s"),
    "too fast": (lambda saved: edits.retime(saved, 500), r"less than 0\.001 s"),
    "too slow": (lambda saved: edits.retime(saved, 1e-4), "over 600 s"),
    "no loop": (lambda saved: edits.repeat(saved, 2), "only a loop"),
}


@pytest.mark.parametrize("way", REFUSED)
def test_edits_that_make_no_motion_are_refused(motions, way):
    edit, words = REFUSED[way]
    with pytest.raises(UserError, match=words):
        edit(motions["plain"])


def test_loops_of_other_coordinates_figures_and_lengths_are_refused(motions):
    with pytest.raises(UserError, match="over 600 s"):
        edits.repeat(motions["loop"], 2000)
    plain = motions["plain"]  # motions of older versions may have other coordinates
    other = replace(plain, figure=Figure(plain.scene.model(), "joint"), name="tiny")
    with pytest.raises(UserError, match="is in world coordinates, 'tiny' in joint coordinates"):
        edits.check_alike(plain, other)
    with pytest.raises(UserError, match="puppet: no partner on the other side for: "):
        edits.mirror(moved())


# clips


def test_a_clip_written_again_is_equal():
    for name in models.clips():
        text = models.clip_text(name)
        table = tables(table_of(text, name))
        assert tables(table_of(text_of(table), name)) == table


def test_odd_names_and_texts_survive_being_written():
    table: dict[str, Any] = {
        "figure": 'a "quoted" \\ ünïcode\x7f\n',
        "scene": {"odd key": [1, 2.5, True, {"a b": "free"}]},
    }
    table["keyframe"] = [{"time": 1e-9, "joints": {"left knee": {"quat": [1.0, 0.0, -0.0, 1e300]}, "b": "free"}}]
    assert tomllib.loads(text_of(table)) == table


ROUND = read_data("sides.toml")


@pytest.mark.slow
def test_keyframes_places_contacts_and_obstacles_change_sides_with_a_clip(tmp_path):
    target = tmp_path / "deeper" / "two.toml"
    target.parent.mkdir()
    (tmp_path / "one.toml").write_text(ROUND, encoding="utf-8")
    edit_files.mirror(str(tmp_path / "one.toml"), target, overwrite=False, progress=quiet())
    one, two = recordings.load(str(tmp_path / "one.toml")), recordings.load(str(target))
    mirror = Mirror.of(one.figure)
    for a, b in zip(two.keys, map(mirror.key, one.keys), strict=True):
        np.testing.assert_array_equal(a.fixed, b.fixed)
        np.testing.assert_allclose(a.state[a.fixed], b.state[b.fixed], atol=1e-6)
    table = table_of(two.text, "two")
    assert table.contact[0].point == "right_toe"
    assert table.contact[0].position == (0.2, -0.1, 0.0)
    assert table.keyframe[1].sites["left_hand"] == (0.4, 0.3, "free")
    assert [bend.name for bend in two.context.bends] == ["right_knee", "left_elbow"]
    for geom in ("step", "box 1", "capsule 1"):
        mine, its = (found.figure.model.geom(geom) for found in (one, two))
        np.testing.assert_allclose(its.pos, mine.pos * [1, -1, 1], atol=1e-12)
    assert tables(mirrored_tables(table, one.figure, mirror)) == tables(table_of(ROUND, "one"))


@pytest.mark.parametrize(("y", "is_noted"), [(0.4, True), (0.0, False)])
def test_a_mirrored_motion_keeps_its_scene_and_a_note_states_it(tmp_path, y, is_noted):
    ball = f'\n[[scene.sphere]]\nname = "ball"\nradius = 0.1\nposition = [2, {y}, 1]\n'
    path = problems.written(tmp_path, problems.changed("fps = 20", "fps = 20" + ball))
    output = io.StringIO()
    progress = Progress(Console(file=output))
    for ending in ("toml", "npz"):
        target = tmp_path / f"other.{ending}"
        edit_files.mirror(str(path), target, overwrite=False, progress=progress)
        assert ("note: step and obstacles are not mirrored" in output.getvalue()) is (is_noted and ending == "npz")
    there = recordings.load(str(tmp_path / "other.toml")).figure.model.geom("ball").pos[1]
    assert (there, motion.load(tmp_path / "other.npz").figure.model.geom("ball").pos[1]) == (-y, y)


@pytest.mark.slow
def test_a_retimed_clip_has_other_times_also_of_contacts_flights_and_cycles_and_nothing_else(tmp_path):
    path = problems.written(tmp_path)
    (tmp_path / "sub").mkdir()
    target = tmp_path / "sub" / "fast.toml"
    edit_files.retime(str(path), 2.0, None, target, overwrite=False, progress=quiet())
    before, after = recordings.load(str(path)), recordings.load(str(target))
    assert [key.time for key in after.keys] == pytest.approx([key.time / 2 for key in before.keys])
    for a, b in zip(after.keys, before.keys, strict=True):
        np.testing.assert_array_equal(a.state, b.state)
    assert after.settings == before.settings
    edit_files.retime(str(path), None, 3.0, target, overwrite=True, progress=quiet())
    assert recordings.load(str(target)).keys[-1].time == pytest.approx(3)
    table = edit_files.retimed_tables(table_of(ROUND, "one"), 2.0)
    assert (table.contact[0].start, table.contact[0].end) == (0.3, 0.5)
    assert table.penalty[0].options["intervals"] == [[0.1, 0.2]]
    assert table.penalty[2].options["period"] == 1.0


@pytest.mark.parametrize("name", ["tiny.toml", "own.npz", "following.toml"])
def test_only_tables_of_clips_are_edited_to_a_clip(motions, tmp_path, name):
    problems.written(tmp_path)
    motion.save(motions["plain"], tmp_path / "own.npz")
    (tmp_path / "following.toml").write_text(FOLLOWING, encoding="utf-8")
    source, target = str(tmp_path / name), tmp_path / "out.toml"
    ways: list[tuple[Any, ...]] = [(edit_files.trim, source, 0.1, 0.3)]
    ways += [] if name == "tiny.toml" else [(edit_files.mirror, source), (edit_files.retime, source, 2.0, None)]
    for edit, *arguments in ways:
        with pytest.raises(UserError, match=r"out\.toml: only `mirror` and `retime` of a clip|-o NAME\.npz"):
            edit(*arguments, target, overwrite=False, progress=quiet())
        assert not target.exists()


def test_a_motion_as_a_clip_has_its_tables_or_else_its_keyframes(motions, tmp_path):
    clip_text.write(motions["plain"], tmp_path / "plain.toml", overwrite=False)
    assert recordings.load(str(tmp_path / "plain.toml")).context.schedule.on_ground
    clip_text.write(edits.mirror(motions["plain"]), tmp_path / "edited.toml", overwrite=True)
    again = recordings.load(str(tmp_path / "edited.toml"))
    assert [key.time for key in again.keys] == [0, 0.2, 0.41]
    assert not again.context.schedule.on_ground
    with pytest.raises(UserError, match=r"follows the recording 'own\.npz'; save it as a motion"):
        clip_text.write(motions["following"], tmp_path / "other.toml", overwrite=False)
    clip_text.write(shipped.unsolved("step_on_kerb"), tmp_path / "kerb.toml", overwrite=False)  # follows what ships
    again = recordings.load(str(tmp_path / "kerb.toml"))
    assert [key.time for key in again.authored_keys] == [2.24, 2.86, 3.24]


THING = """
[[scene.box]]
name = "crate"
body = "crate"
size = [0.2, 0.2, 0.2]
mass = 1
"""
PLACED = "roots.crate = {{position = [{x}, 2, 0.1], rotation = {{rotvec = [0, 0, 0]}}}}\n"


def test_things_go_with_the_recording_that_a_clip_follows(tmp_path):
    """Where a keyframe puts one is no place of it at the others, and without any all is as recorded."""
    head, *keyframes = problems.CLIP.replace("fps = 20", "fps = 20" + THING).split("[[keyframe]]")
    text = "[[keyframe]]".join([head, *(each + PLACED.format(x=x) for x, each in enumerate(keyframes, 1))])
    recorded = solved(text, tmp_path)
    motion.save(recorded, tmp_path / "own.npz")
    following = FOLLOWING.replace("[recording]", THING + "[recording]")
    bare = recordings.from_text(following, name="bare", folder=tmp_path)
    assert bare.has_recording
    edits_ = '[[keyframe]]\ntime = 0.1\nroot.position = ["free", "free", 1.01]\n[[keyframe]]\ntime = 0.3\n'
    clip = recordings.from_text(following + edits_ + PLACED.format(x=2.5), name="edited", folder=tmp_path)
    first, second = clip.authored_keys
    columns = clip.figure.tables.position_columns[:, 1]
    assert not first.fixed[columns].any()
    assert second.fixed[columns].all()
    np.testing.assert_allclose(first.state[columns], at(recorded, np.array([0.1]))[0, columns], atol=1e-3)
