"""What can be opened: shipped clips, files, models, motions and recordings, each as a clip's text."""

from __future__ import annotations

import tomllib

import pytest
import tiny

from dynsplines import models, motion, recordings
from dynsplines.errors import UserError
from dynsplines.studio.sources import opened


def test_a_shipped_clip_has_no_file_and_nothing_to_save(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = opened("run_and_step")
    assert found.text == models.clip_text("run_and_step")
    assert found.file is None
    assert not found.is_dirty
    assert found.folder == tmp_path


def test_a_file_is_opened_as_it_is(tmp_path):
    file = tiny.written(tmp_path)
    found = opened(str(file))
    assert (found.text, found.file, found.folder) == (tiny.CLIP, file.resolve(), tmp_path.resolve())
    assert not found.is_dirty


def test_a_model_becomes_a_clip_to_begin_with(tmp_path):
    tiny.written(tmp_path)
    found = opened(str(tmp_path / "tiny.xml"))
    assert found.is_dirty
    assert found.folder == tmp_path.resolve()
    clip = recordings.from_text(found.text, name="tiny", folder=found.folder)
    assert len(clip.keys) >= 2


def test_a_solved_motion_is_its_clip_again(motion_file):
    tiny.written(motion_file.parent)
    found = opened(str(motion_file))
    assert found.text == tiny.CLIP
    assert found.is_dirty


def test_what_was_recorded_is_followed_by_a_clip_whose_keyframes_edit_it(saved, tmp_path):
    from dataclasses import replace

    recorded = replace(saved, text="", search={}, timeline=saved.raw)
    motion.save(recorded, tmp_path / "walk.npz")
    found = opened(str(tmp_path / "walk.npz"))
    table = tomllib.loads(found.text)
    assert table["recording"]["file"] == "walk.npz"
    assert table["figure"] == "walk.xml"
    assert (tmp_path / "walk.xml").read_text() == saved.mjcf
    clip = recordings.from_text(found.text, name="walk", folder=found.folder)
    assert clip.keys[-1].time == pytest.approx(saved.keys[-1].time, abs=0.01)
    assert opened(str(tmp_path / "walk.npz")).text == found.text  # and once more


def test_a_solved_motion_that_lies_elsewhere_brings_its_figure(saved, tmp_path):
    motion.save(saved, tmp_path / "moved.npz")
    found = opened(str(tmp_path / "moved.npz"))
    clip = recordings.from_text(found.text, name="moved", folder=found.folder)
    assert [key.time for key in clip.keys] == [key.time for key in saved.keys]
    assert (tmp_path / "moved.xml").read_text() == saved.mjcf


def test_a_motion_that_followed_a_recording_elsewhere_is_its_own_keyframes(saved, tmp_path):
    from dataclasses import replace

    text = 'figure = "tiny.xml"\nfps = 20\n[recording]\nfile = "gone.npz"\n'
    motion.save(replace(saved, text=text), tmp_path / "moved.npz")
    found = opened(str(tmp_path / "moved.npz"))
    clip = recordings.from_text(found.text, name="moved", folder=found.folder)
    assert not clip.has_recording
    assert [key.time for key in clip.keys] == saved.timeline.times.tolist()


def test_a_file_of_plain_arrays_is_a_recording_as_its_ending_selects(saved, tmp_path):
    from dynsplines.exchange.formats import export

    export(saved, "npz", tmp_path / "walk.qpos.npz")
    tiny.written(tmp_path)
    found = opened(str(tmp_path / "walk.qpos.npz"), figure=str(tmp_path / "tiny.xml"))
    assert tomllib.loads(found.text)["recording"]["file"] == "walk.npz"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("nowhere.toml", "no file 'nowhere.toml'; open a clip (.toml), a model (.xml)"),
        ("run_and_stp", "run_and_step"),
        (".", "is a folder; open"),
    ],
)
def test_what_is_not_there_is_reported_with_what_could_be(tmp_path, monkeypatch, name, words):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UserError) as error:
        opened(name)
    assert words in str(error.value)
