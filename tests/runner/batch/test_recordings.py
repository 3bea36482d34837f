"""A batch of recordings: each cleaned or brought on to a figure, measured, and the worst named."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
import shipped
from processes import Command, quiet, refusal
from texts import read_cases

pytest.importorskip("distributed")

from dynsplines import UserError, load_motion
from dynsplines.batch.dispatch import run
from dynsplines.batch.inputs import sources, task_of
from dynsplines.batch.manifest import Manifest
from dynsplines.batch.task import BatchOptions
from dynsplines.clean.command import Source
from dynsplines.edit import edits
from dynsplines.exchange import formats


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two recordings, one below the other's folder, one that is none, and files of other kinds."""
    folder = tmp_path_factory.mktemp("recordings")
    (folder / "more").mkdir()
    walk = edits.trim(shipped.solved("walk_loop"), 0.1, 0.7)
    formats.export(walk, "bvh", folder / "walk.bvh", fps=30)
    formats.export(walk, "csv", folder / "more" / "turn.csv", fps=40)
    (folder / "torn.bvh").write_text("HIERARCHY\nROOT", encoding="utf-8")
    (folder / "notes.txt").write_text("nothing", encoding="utf-8")
    return folder


def test_a_folder_gives_what_its_endings_select_by_the_path_below_it(folder: Path) -> None:
    assert [str(source.name) for source in sources([str(folder)], recordings=True)] == ["more/turn", "torn", "walk"]
    assert [str(source.name) for source in sources([str(folder / "w*")], recordings=True)] == ["walk"]
    assert [str(source.name) for source in sources([str(folder / "notes.txt")], recordings=True)] == ["notes"]
    with pytest.raises(UserError, match=r"it contains no recordings; `dynsplines formats` lists the endings"):
        sources([str(folder / "*.txt")], recordings=True)
    with pytest.raises(UserError, match=r"no file .*absent\.bvh"):
        sources([str(folder / "absent.bvh")], recordings=True)


def test_all_that_is_requested_goes_along_and_counts(folder: Path, tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text("[scene]\n", encoding="utf-8")
    (source,) = sources([str(folder / "walk.bvh")], recordings=True)
    asked = Source(Path(), "human", scene=scene)
    options = BatchOptions(cleaning=asked)
    files = task_of(source, {}, options)
    assert files.others.keys() == {"scene"}
    assert files.files[files.others["scene"]] == scene.read_bytes()
    assert files.files[files.clip] == (folder / "walk.bvh").read_bytes()
    before = files.digest
    assert before == task_of(source, {}, options).digest
    assert before != task_of(source, {}, BatchOptions(cleaning=replace(asked, fps=60.0))).digest
    scene.write_text("[scene]\n# another\n", encoding="utf-8")
    assert before != task_of(source, {}, options).digest


@pytest.mark.slow
def test_each_is_cleaned_once_and_one_that_is_torn_stops_nothing(
    in_process: None, folder: Path, tmp_path: Path
) -> None:
    shutil.copytree(folder, tmp_path / "in")
    options = BatchOptions(workers=1, cleaning=Source(Path(), "human"))
    into = tmp_path / "in" / "out"  # below what is read, which it is no part of
    tally = run([str(tmp_path / "in")], into, options, quiet())
    assert (tally.solved, [entry.clip for entry in tally.failed]) == (2, ["torn"])
    entries = Manifest.of(into).entries
    for name in ("walk", "more/turn"):
        motion = load_motion(into / f"{name}.npz")
        assert motion.duration > 0.5
        texts = [each.text.partition(": ")[2] or each.text for each in motion.violations]
        assert all(each["text"].partition(",")[0] in texts for each in entries[name].violations)
        assert not [each for each in entries[name].violations if each["kind"] == "penetration"]
    again = run([str(tmp_path / "in")], into, options, quiet())
    assert (again.solved, len(again.good), len(again.failed)) == (0, 2, 1)
    assert again.good[0].violations == entries[again.good[0].clip].violations


@pytest.mark.parametrize(("words", "line"), read_cases("batch_of_recordings.toml"))
def test_what_does_not_go_together_is_reported(
    folder: Path, words: tuple[str, ...], line: str, monkeypatch: pytest.MonkeyPatch, command: Command
) -> None:
    monkeypatch.chdir(folder)
    monkeypatch.setenv("MUJOCO_GL", "disable")
    assert line in refusal(command("batch", "walk.bvh", *words))
