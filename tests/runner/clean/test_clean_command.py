"""`dynsplines clean`: a recording's file in, a clean one of its format or another out, bad input told."""

import re
from pathlib import Path

import numpy as np
import pytest
from motions import kneeling, uncleaned
from oracles import kinematics
from texts import read_cases

from dynsplines import load_motion, motion
from dynsplines.clean import command as clean_command
from dynsplines.clip import load as clips
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import read_recording
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solving import raw_spline

TIMES = np.arange(31) / 30


@pytest.fixture(scope="module")
def squats(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with somebody who bobs with soles that sink and slide, in some formats."""
    folder = tmp_path_factory.mktemp("recordings")
    scene = compose(figure_spec("human"))
    model = scene.model()
    qpos = np.tile(model.qpos0, (TIMES.size, 1))
    bend = 0.3 + 0.25 * np.sin(4 * TIMES)
    for joint, share in (("hip", -1.0), ("knee", 2.0), ("ankle", -1.0)):
        for side in ("left", "right"):
            at = model.joint(f"{side}_{joint}").qposadr[0]
            qpos[:, at], qpos[:, at + 2] = np.cos(share * bend / 2), np.sin(share * bend / 2)
    soles = [i for i in range(model.nsite) if any(word in model.site(i).name for word in ("heel", "toe"))]
    lowest = np.array([kinematics(model, row).site_xpos[soles, 2].min() for row in qpos])
    qpos[:, 2] += 0.015 * np.sin(6 * TIMES) - lowest
    qpos[:, 0] += 0.06 * TIMES
    found = clips.from_qpos("bobs", scene, TIMES, qpos, 30.0, "bobs")
    saved = raw_spline(found)
    motion.save(saved, folder / "bobs.npz")
    formats.export(saved, "bvh", folder / "bobs.bvh")
    formats.export(saved, "csv", folder / "bobs.csv")
    return folder


def soles(source: Path) -> np.ndarray:
    """(T, 3) [m] the left heel, by MuJoCo."""
    saved = motion.load(source)
    samples, model = motion.Sampled.of(saved, 120), saved.figure.model
    return np.array([kinematics(model, row).site("left_heel").xpos for row in samples.qpos])


@pytest.mark.slow
def test_a_motion_of_feet_that_slide_and_sink_comes_out_clean(command, squats, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    done = command("clean", squats / "bobs.npz", "-o", "clean.npz")
    assert done.code == 0, done.err
    assert "left_heel stands" in done.err
    assert re.search(r"penetration +1\d mm +[01] mm", done.err), done.err
    assert done.last == "wrote clean.npz"
    before, after = soles(squats / "bobs.npz"), soles(tmp_path / "clean.npz")
    assert np.ptp(before[:, 0]) > 0.05
    assert np.ptp(after, axis=0).max() < 0.005
    assert before[:, 2].min() < -0.01
    assert after[:, 2].min() > -0.002
    data = load_motion("clean.npz").report()
    table = " ".join(str(data).split())
    assert "0 variable frames; cleaned recording ┏" in table
    assert "before" in table and "after" in table
    assert data["left to gain"] == {}
    deepest = [data[side]["largest"]["penetration"]["amount"] for side in ("before", "after")]
    assert deepest[1] < 0.002 < 0.01 < deepest[0]
    saved = motion.load(tmp_path / "clean.npz")
    np.testing.assert_allclose(saved.raw.times[[0, -1]], TIMES[[0, -1]], atol=1e-9)


@pytest.mark.slow
def test_what_came_in_a_format_goes_out_in_it_unasked(command, squats, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(clean_command, "_clean", lambda recording, *_: uncleaned(recording))
    words = ("clean", squats / "bobs.bvh", "--figure", "human")
    done = command(*words)
    assert done.code == 0, done.err
    assert done.last == "wrote bobs.clean.bvh"
    found = read_recording(tmp_path / "bobs.clean.bvh", figure="human")
    assert found.time[-1] == pytest.approx(TIMES[-1], abs=0.05)
    again = command(*words)
    assert again.code == 2
    assert "--overwrite" in again.last


@pytest.mark.slow
def test_stances_are_those_of_a_file_and_how_far_what_moved_is_told(command, squats, tmp_path, monkeypatch):
    """Those of geoms and bodies are listed after those of soles."""
    monkeypatch.chdir(tmp_path)
    spans = [("right_shin", 0.2, 0.3), ("right_toe_sole", 0.2, 0.8), ("left_heel", 0.3, 0.9), ("right_shin", 0.7, 0.9)]
    tables = [f'[[contact]]\npoint = "{point}"\nfrom = {first}\nto = {last}\n' for point, first, last in spans]
    (tmp_path / "c.toml").write_text("".join(tables), encoding="utf-8")
    done = command("clean", squats / "bobs.npz", "--scene", "c.toml", "-o", "a.npz")
    assert done.code == 0, done.err
    assert "mm off the recording at" in done.err
    assert "above the ground" not in done.err
    assert [line for line in done.err.splitlines() if " stands " in line] == [
        "left_heel stands 0.30-0.90 s",
        "right_shin stands 0.20-0.30, 0.70-0.90 s",
        "right_toe_sole stands 0.20-0.80 s",
    ]
    assert np.ptp(soles(tmp_path / "a.npz")[42:103, :2], axis=0).max() < 0.005
    saved = motion.load(tmp_path / "a.npz")
    run, model = motion.Sampled.of(saved, 120), saved.figure.model
    during = (run.time >= 0.25) & (run.time <= 0.75)
    toe = np.array([kinematics(model, row).geom("right_toe_sole").xpos for row in run.qpos[during]])
    assert np.ptp(toe, axis=0).max() < 0.005


@pytest.mark.slow
def test_a_heel_at_rest_in_the_air_is_named_and_does_not_stand(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    take = kneeling(15, np.radians(36))
    found = clips.from_qpos("kneels", compose(figure_spec("human")), take.time, take.qpos, 15.0, "kneels")
    motion.save(raw_spline(found), tmp_path / "kneels.npz")
    done = command("clean", "kneels.npz", "-o", "a.npz")
    assert done.code == 0, done.err
    (note,) = [line for line in done.err.splitlines() if "right_heel rests above the ground" in line]
    assert "--scene" in note
    (stands,) = [line for line in done.err.splitlines() if line.startswith("right_heel stands")]
    assert stands.startswith("right_heel stands 0.00-0.9")
    assert "," not in stands


@pytest.mark.parametrize(("words", "told"), read_cases("clean_words.toml"))
def test_what_cannot_be_cleaned_is_told_and_nothing_is_written(command, squats, tmp_path, monkeypatch, words, told):
    monkeypatch.chdir(tmp_path)
    text = '[[contact]]\npoint = "{}"\nfrom = {}\nto = {}\n'
    (tmp_path / "bad.toml").write_text("[figure]\nname = 1\n", encoding="utf-8")
    (tmp_path / "s.toml").write_text("[scene.step]\nx = 1.0\nheight = 0.2\n", encoding="utf-8")
    (tmp_path / "far.toml").write_text(text.format("left_heel", 1, 9), encoding="utf-8")
    (tmp_path / "placed.toml").write_text(text.format("left_heel", 0, 1) + "position = [0, 0, 0]\n", encoding="utf-8")
    (tmp_path / "odd.toml").write_text(text.format("left_hel", 0, 1), encoding="utf-8")
    present = sorted(tmp_path.iterdir())
    done = command("clean", *(word.format(f=squats) for word in words))
    assert done.code == 2
    assert told in done.last, done.last
    assert sorted(tmp_path.iterdir()) == present


@pytest.mark.slow
def test_from_python_a_motion_is_cleaned_by_a_method(squats):
    found = load_motion(squats / "bobs.npz").cleaned()
    model = found.clip.figure.model
    heel = [kinematics(model, found.at(t)).site("left_heel").xpos for t in np.linspace(0, TIMES[-1], 40)]
    assert np.ptp(heel, axis=0).max() < 0.01
