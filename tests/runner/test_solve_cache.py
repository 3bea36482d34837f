"""Solved clips that are kept: used again while nothing that they depend on changes, and never trusted blindly."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command import commanded
from quiet import quiet
from tiny import CLIP, FIGURE, changed, names, written

from dynsplines import solve_cache, solving
from dynsplines.clip import load as clip
from dynsplines.clip.build import Clip
from dynsplines.solver.search.minimum import Stop
from dynsplines.solving import Solved
from dynsplines.system.progress import Progress

TETRAHEDRON = "v 0 0 0\nv .1 0 0\nv 0 .1 0\nv 0 0 {}\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
MESHED = FIGURE.replace(
    "<worldbody>", '<include file="more.xml"/><asset><mesh name="hat" file="hat.obj"/></asset><worldbody>', 1
).replace('<site name="left_toe"', '<geom type="mesh" mesh="hat" mass=".1"/><site name="left_toe"', 1)
MORE = '<mujoco><option gravity="0 0 -{}"/></mujoco>'


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("DYNSPLINES_CACHE", str(folder))
    return folder


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the clips that are really solved."""
    done: list[str] = []
    solve = solving.solve

    def watched(clip: Clip, progress: Progress) -> Solved:
        done.append(clip.name)
        return solve(clip, progress)

    monkeypatch.setattr(solving, "solve", watched)
    return done


def tiny(folder: Path, text: str = CLIP) -> Clip:
    folder.mkdir(exist_ok=True)
    return clip.load(str(written(folder, text)))


def meshed(folder: Path, tip: float = 0.1, gravity: float = 9.8) -> Clip:
    """The tiny clip with a mesh, of a file, on its trunk, and an included file."""
    folder.mkdir(exist_ok=True)
    (folder / "hat.obj").write_text(TETRAHEDRON.format(tip), encoding="utf-8")
    (folder / "more.xml").write_text(MORE.format(gravity), encoding="utf-8")
    path = written(folder)
    (folder / "tiny.xml").write_text(MESHED, encoding="utf-8")
    return clip.load(str(path))


def only(cache: Path) -> Path:
    (file,) = cache.iterdir()
    return file


def assert_same(one: Solved, other: Solved) -> None:
    for name in ("timeline", "raw"):
        a, b = getattr(one.motion, name), getattr(other.motion, name)
        np.testing.assert_array_equal(a.rows, b.rows)
        np.testing.assert_array_equal(a.times, b.times)
        np.testing.assert_array_equal(a.fixed, b.fixed)
        assert a.ends == b.ends
    assert one.search == other.search
    assert list(one.motion.trace) == list(other.motion.trace)
    assert one.violations == other.violations


def test_an_unchanged_clip_is_not_solved_again_and_is_the_same(tmp_path, cache, counted):
    first = solve_cache.solved(tiny(tmp_path / "a"), quiet())
    again = solve_cache.solved(tiny(tmp_path / "a"), quiet())
    assert counted == ["tiny"]
    assert_same(first, again)
    assert len(names(cache)) == 1


def test_a_clip_that_is_only_written_otherwise_or_lies_elsewhere_is_not_solved_again(tmp_path, cache, counted):
    solve_cache.solved(tiny(tmp_path / "a"), quiet())
    solve_cache.solved(tiny(tmp_path / "b", "# Other words.\n" + changed("fps = 20", "fps = 25")), quiet())
    solve_cache.solved(tiny(tmp_path / "c", changed("time = 0\n", "time    =   0\n")), quiet())
    assert counted == ["tiny"]


@pytest.mark.parametrize(
    "text",
    [
        changed("rotvec = [0, 40, 0]", "rotvec = [0, 41, 0]"),
        changed("evaluations = 8", "evaluations = 7"),
        changed("[solve]", '[[penalty]]\nkind = "posture"\nweight = 2\n[solve]'),
        changed("[solve]", "[[scene.sphere]]\nposition = [2, 0, 0]\nradius = 0.1\n[solve]"),
        changed("[solve]", '[[contact]]\npoint = "left_toe"\nfrom = 0.2\nto = 0.3\n[solve]'),
    ],
)
def test_whatever_changes_its_solution_makes_it_another_clip(tmp_path, text):
    assert solve_cache.key_of(tiny(tmp_path / "a")) != solve_cache.key_of(tiny(tmp_path / "b", text))


def test_so_does_any_file_of_its_model(tmp_path):
    keys = {
        solve_cache.key_of(meshed(tmp_path / "a")),
        solve_cache.key_of(meshed(tmp_path / "b", tip=0.2)),
        solve_cache.key_of(meshed(tmp_path / "c", gravity=9.9)),
    }
    assert len(keys) == 3
    assert solve_cache.key_of(meshed(tmp_path / "d")) in keys


def test_so_does_the_program_that_solves_it(tmp_path, monkeypatch):
    problem = tiny(tmp_path / "a")
    before = solve_cache.key_of(problem)
    versions = dict.fromkeys(("dynamic-splines", *solve_cache.LIBRARIES), "7")
    for name in versions:
        solve_cache._program.cache_clear()
        monkeypatch.setattr(solve_cache, "version_of", {**versions, name: "8"}.__getitem__)
        before, old = solve_cache.key_of(problem), before
        assert before != old
    monkeypatch.setattr(solve_cache, "__file__", str(tmp_path / "a" / "solve_cache.py"))
    (tmp_path / "a" / "more.py").write_text("1", encoding="utf-8")
    solve_cache._program.cache_clear()
    text = solve_cache.key_of(problem)
    (tmp_path / "a" / "more.py").write_text("2", encoding="utf-8")
    solve_cache._program.cache_clear()
    assert text not in (before, solve_cache.key_of(problem))
    solve_cache._program.cache_clear()


def flipped(data: bytes) -> bytes:
    return data[:700] + bytes([data[700] ^ 1]) + data[701:]


def told(file: Path, **changes: object) -> None:
    """The file with some of its arrays replaced, and nothing else wrong."""
    with np.load(file) as data:
        arrays = {name: data[name] for name in data.files}
    np.savez(file, **{**arrays, **{name: np.asarray(value) for name, value in changes.items()}})  # type: ignore[arg-type]


def moved(file: Path) -> None:
    """Off the last keyframe by a micrometre."""
    with np.load(file) as data:
        state = data["state"]
    state[-1, 0] += 1e-6
    told(file, state=state)


def shortened(file: Path) -> None:
    with np.load(file) as data:
        told(file, time=data["time"][:-1], state=data["state"][:-1])


def zero(file: Path) -> None:
    with np.load(file) as data:
        state = data["state"]
    state[1:-1, 7:11] = 0
    told(file, state=state)


DAMAGE = {
    "empty": lambda file: file.write_bytes(b""),
    "text": lambda file: file.write_text("no motion", encoding="utf-8"),
    "cut short": lambda file: file.write_bytes(file.read_bytes()[:-300]),
    "a bit turned": lambda file: file.write_bytes(flipped(file.read_bytes())),
    "of another clip": lambda file: told(file, key="0" * 40),
    "off a keyframe": moved,
    "without its end": shortened,
    "no number": lambda file: told(file, end_slope=np.full((2, 11), np.nan)),
    "zero quaternions": zero,
    "words for times": lambda file: told(file, time="soon"),
    "an end unheard of": lambda file: told(file, stop="BORED"),
    "pickled": lambda file: np.savez(file, state=np.array([{}], object), allow_pickle=True),
}


def test_a_damaged_file_is_as_good_as_none_and_is_replaced(tmp_path, cache, counted):
    first = solve_cache.solved(tiny(tmp_path / "a"), quiet())
    whole = only(cache).read_bytes()
    for name, damage in DAMAGE.items():
        only(cache).write_bytes(whole)
        assert solve_cache.read(only(cache), first.clip) is not None
        damage(only(cache))
        assert solve_cache.read(only(cache), first.clip) is None, name
    again = solve_cache.solved(tiny(tmp_path / "a"), quiet())
    assert counted == ["tiny", "tiny"]
    np.testing.assert_array_equal(again.motion.timeline.rows, first.motion.timeline.rows)
    assert solve_cache.read(only(cache), first.clip) is not None


@pytest.mark.slow
def test_old_ones_make_room_and_nothing_else_is_touched(tmp_path, cache, monkeypatch):
    texts = [changed("rotvec = [0, 40, 0]", f"rotvec = [0, {angle}, 0]") for angle in (40, 41, 42, 43)]
    problems = [tiny(tmp_path / f"{i}", text) for i, text in enumerate(texts)]
    for age, problem in enumerate(problems[:3]):
        solve_cache.solved(problem, quiet())
        os.utime(cache / f"{solve_cache.key_of(problem)}.npz", (1e9 + age, 1e9 + age))
    (cache / "mine.npz").write_bytes(bytes(10_000))
    solve_cache.solved(problems[0], quiet())  # used: now it is the youngest
    monkeypatch.setattr(
        solve_cache, "MOST_BYTES", 2.5 * (cache / f"{solve_cache.key_of(problems[0])}.npz").stat().st_size
    )
    solve_cache.solved(problems[3], quiet())
    assert names(cache) == sorted([f"{solve_cache.key_of(problems[i])}.npz" for i in (0, 3)] + ["mine.npz"])


@pytest.mark.slow
def test_where_nothing_can_be_kept_it_is_solved(tmp_path, cache, counted):
    cache.write_text("no folder", encoding="utf-8")
    for _ in range(2):
        solve_cache.solved(tiny(tmp_path / "a"), quiet())
    assert counted == ["tiny", "tiny"]
    assert cache.read_text(encoding="utf-8") == "no folder"


@pytest.mark.slow
def test_nothing_is_kept_if_nothing_is_to_be(tmp_path, cache, monkeypatch):
    for word in ("off", "0", "OFF"):
        monkeypatch.setenv("DYNSPLINES_CACHE", word)
        assert solve_cache.place() is None
    solve_cache.solved(tiny(tmp_path / "a"), quiet())
    assert not cache.exists()


def test_by_default_it_is_the_users_folder_for_such_things(monkeypatch, tmp_path):
    monkeypatch.delenv("DYNSPLINES_CACHE")
    if sys.platform == "linux":
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
        assert solve_cache.place() == tmp_path / "dynsplines"
    place = solve_cache.place()
    assert place is not None
    assert place.name.lower() in ("dynsplines", "cache")


def test_a_search_that_was_stopped_is_not_kept(tmp_path, cache, monkeypatch, solved):
    stopped = replace(solved, motion=replace(solved.motion, stop=Stop.INTERRUPTED))
    monkeypatch.setattr(solving, "solve", lambda *_: stopped)
    solve_cache.solved(tiny(tmp_path / "a"), quiet())
    assert not cache.exists()


@pytest.mark.slow
def test_commands_say_that_they_solved_it_before(tmp_path, cache, counted, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "disable")
    written(tmp_path)
    run, again = commanded(monkeypatch, capsys), ["solve", "-o", "again.npz"]
    commands = ["solve"], again, ["solve", "--no-cache"], ["solve", "--fresh"], ["export", "-o", "t.csv"]
    ended = [run(words[0], "tiny.toml", *words[1:]) for words in commands]
    assert not any(done.code for done in ended)
    noted = ["--no-cache solves it again" in done.err for done in ended]
    assert noted == [False, True, False, False, True]
    assert counted == ["tiny", "tiny", "tiny"]
    with np.load("tiny.npz") as one, np.load("again.npz") as two:
        for name in ("qpos", "qvel", "raw_qpos", "key_qpos", "frame_state", "trace"):
            np.testing.assert_array_equal(one[name], two[name])
