"""What clips a command names, what their outputs are called, and which files go to a worker."""

import io
import sys
from dataclasses import replace
from pathlib import Path, PurePosixPath

import pytest
from problems import CLIP, changed, written
from texts import read_cases

from dynsplines import recordings
from dynsplines.batch import solving
from dynsplines.batch.inputs import InputSource, sources, task_of
from dynsplines.errors import UserError
from dynsplines.motion import load

MESHED = """<mujoco><include file="parts/more.xml"/><compiler meshdir="meshes"/>
  <!-- <mesh file="not_this.stl"/> --><asset><mesh name="a" file="a.stl"/></asset></mujoco>"""


@pytest.fixture
def tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """clips/a/walk.toml, clips/b/walk.toml, clips/run.toml, and files that are no clips."""
    monkeypatch.chdir(tmp_path)
    for name in ("a/walk.toml", "b/walk.toml", "run.toml", "readme.txt"):
        path = tmp_path / "clips" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(CLIP, encoding="utf-8")
    return tmp_path


def names(found: list[InputSource]) -> list[str]:
    return [str(source.name) for source in found]


def test_a_folder_is_every_clip_below_it_under_its_path(tree: Path):
    assert names(sources(["clips"])) == ["a/walk", "b/walk", "run"]


def test_files_patterns_and_names_are_under_their_stems_and_none_is_there_twice(tree: Path):
    found = sources(["clips/run.toml", "walk_loop", "clips/*/walk.toml", "clips/../clips/run.toml", "clips/**/*.toml"])
    assert names(found) == ["run", "walk_loop", "walk", "walk"]
    assert [source.place(tree / "out") for source in found] == [
        "../clips/run.toml",
        "shipped:walk_loop",
        "../clips/a/walk.toml",
        "../clips/b/walk.toml",
    ]


def test_a_list_names_more_a_line_each(tree: Path, monkeypatch: pytest.MonkeyPatch):
    (tree / "list.txt").write_text("# these\n\nclips/run.toml\n  sit_down \n", encoding="utf-8")
    assert names(sources(["stairs"], "list.txt")) == ["stairs", "run", "sit_down"]
    monkeypatch.setattr(sys, "stdin", io.StringIO("clips/a/walk.toml\n"))
    assert names(sources([], "-")) == ["walk"]


@pytest.mark.parametrize(("word", "complaint"), read_cases("absent_clips.toml"))
def test_what_is_not_there_is_reported(tree: Path, word: str, complaint: str):
    (tree / "empty").mkdir()
    with pytest.raises(UserError, match=complaint):
        sources([word])
    with pytest.raises(UserError, match="--list nowhere: No such file"):
        sources([], "nowhere")


def test_a_clip_takes_its_figure_along(tmp_path: Path):
    (tmp_path / "clips").mkdir()
    (tmp_path / "figures").mkdir()
    written(tmp_path / "figures")
    path = tmp_path / "clips" / "tiny.toml"
    path.write_text(changed('"tiny.xml"', '"../figures/tiny.xml"'), encoding="utf-8")
    figures: dict[Path, dict[Path, bytes]] = {}
    files = task_of(InputSource(path, PurePosixPath("tiny")), figures)
    assert files.clip == "clips/tiny.toml"
    assert sorted(files.files) == ["clips/tiny.toml", "figures/tiny.xml"]
    assert not files.others
    path.write_text(changed('"tiny.xml"', f'"{(tmp_path / "figures/tiny.xml").as_posix()}"'), encoding="utf-8")
    files = task_of(InputSource(path, PurePosixPath("tiny")), figures)
    assert files.others == {"figure": "figures/tiny.xml"}


def test_a_model_takes_along_what_it_includes_and_refers_to(tmp_path: Path):
    for name, data in {
        "model.xml": MESHED,
        "parts/more.xml": '<mujoco><asset><texture fileright="../right.png"/></asset></mujoco>',
        "meshes/a.stl": "mesh",
        "right.png": "image",
        "meshes/not_this.stl": "",
    }.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(data, encoding="utf-8")
    (tmp_path / "it.toml").write_text('figure = "model.xml"', encoding="utf-8")
    files = task_of(InputSource(tmp_path / "it.toml", PurePosixPath("it")), {})
    assert sorted(files.files) == ["it.toml", "meshes/a.stl", "model.xml", "parts/more.xml", "right.png"]


def test_a_clip_that_is_wrong_or_lacks_its_figure_goes_as_it_is(tmp_path: Path):
    for text in ("not toml [", changed("tiny.xml", "absent.xml"), 'figure = "human"'):
        path = tmp_path / "a.toml"
        path.write_text(text, encoding="utf-8")
        assert task_of(InputSource(path, PurePosixPath("a")), {}).files == {"a.toml": text.encode()}


def test_elsewhere_a_clip_is_solved_as_it_is_here(tmp_path: Path):
    here, there = tmp_path / "here", tmp_path / "there"
    here.mkdir()
    there.mkdir()
    figure = here / "tiny.xml"
    path = written(here, changed('"tiny.xml"', f'"{figure.as_posix()}"'))
    files = task_of(InputSource(path, PurePosixPath("tiny")), {})
    problem = recordings.load(str(path))
    figure.unlink()
    path.unlink()
    product = solving.solve(replace(files, output="tiny.npz"), there)
    (tmp_path / "result.npz").write_bytes(product.files["tiny.npz"])
    assert [problem["name"] for problem in product.violations] == ["root", "left_knee"]
    saved = load(tmp_path / "result.npz")
    assert saved.name == "tiny"
    assert saved.text == problem.text
    assert saved.mjcf == problem.mjcf
    assert len(saved.trace) > 1


def test_a_worker_with_another_version_is_rejected(tmp_path: Path):
    with pytest.raises(UserError, match=r"the worker has dynamic-splines .*, not 0\.0\.7"):
        solving.solve(
            replace(task_of(InputSource(None, PurePosixPath("stairs")), {}), output="stairs.npz", program="0.0.7"),
            tmp_path,
        )


FOLLOWING = 'figure = "tiny.xml"\nfps = 20\n[recording]\nfile = "{}"\n'


def test_a_clip_takes_along_the_recording_that_it_follows(tmp_path: Path):
    there = tmp_path / "there"
    there.mkdir()
    written(tmp_path)
    path = tmp_path / "tiny.toml"
    product = solving.solve(replace(task_of(InputSource(path, PurePosixPath("tiny")), {}), output="tiny.npz"), there)
    (tmp_path / "own.npz").write_bytes(product.files["tiny.npz"])
    (tmp_path / "through.toml").write_text(FOLLOWING.format("tiny.toml"), encoding="utf-8")
    clip_file, digests = tmp_path / "following.toml", []
    for recording, along in {"own.npz": ["own.npz"], "through.toml": ["through.toml", "tiny.toml"]}.items():
        clip_file.write_text(FOLLOWING.format(recording), encoding="utf-8")
        files = task_of(InputSource(clip_file, PurePosixPath("following")), {})
        assert sorted(files.files) == sorted(["following.toml", "tiny.xml", *along])
        elsewhere = tmp_path / f"elsewhere {recording}"
        elsewhere.mkdir()
        made = solving.solve(replace(files, output="made.npz"), elsewhere)
        (tmp_path / "made.npz").write_bytes(made.files["made.npz"])
        assert load(tmp_path / "made.npz").keys[-1].time == pytest.approx(0.41)
        digests.append(files.digest)
    path.write_text(changed("[0.3, 0, 1]", "[0.31, 0, 1]"), encoding="utf-8")
    assert task_of(InputSource(clip_file, PurePosixPath("following")), {}).digest not in digests


def test_a_recording_that_lies_elsewhere_or_follows_itself_does_not_go_along(tmp_path: Path):
    inner = tmp_path / "inner"
    inner.mkdir()
    written(inner)
    (tmp_path / "secret.npz").write_bytes(b"secret")
    for recording in ("../secret.npz", "following.toml", "absent.npz"):
        (inner / "following.toml").write_text(FOLLOWING.format(recording), encoding="utf-8")
        files = task_of(InputSource(inner / "following.toml", PurePosixPath("following")), {})
        assert sorted(files.files) == ["following.toml", "tiny.xml"]
