"""Edited motions stand alone, and have the targets and contacts of their clips, wherever the edit moves them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shipped
import tiny
from quiet import quiet

from dynsplines import models, motion, recordings, solving
from dynsplines.clip import file as clip_file
from dynsplines.clip.build import Clip
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import tables
from dynsplines.edit import edits, thinning
from dynsplines.edit import files as edit_files
from dynsplines.errors import UserError
from dynsplines.motion import Saved, sampled
from dynsplines.solver.curve.spline import path_of

FOLLOWING = 'figure = "tiny.xml"\nfps = 20\n[recording]\nfile = "own.npz"\n'
FLYING = tiny.CLIP.replace("[[keyframe]]", '[[penalty]]\nkind = "flight"\nintervals = [[0.05, 0.15]]\n[[keyframe]]', 1)


@pytest.fixture(autouse=True)
def shared(monkeypatch: pytest.MonkeyPatch) -> None:
    shipped.share(monkeypatch)


def solved(clip: Clip) -> Saved:
    return solving.solve(clip, quiet()).saved(quiet(), with_report=False)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With a motion, and a clip that follows it."""
    out = tmp_path_factory.mktemp("own")
    motion.save(solved(recordings.load(str(tiny.written(out)))), out / "own.npz")
    (out / "following.toml").write_text(FOLLOWING, encoding="utf-8")
    return out


@pytest.fixture(scope="module")
def followed(folder: Path) -> Saved:
    return solved(recordings.load(str(folder / "following.toml")))


@pytest.fixture
def flying(tmp_path: Path) -> Saved:
    return solved(recordings.load(str(tiny.written(tmp_path, FLYING))))


def flights(saved: Saved) -> list[list[float]] | None:
    said = [row for row in tables(table_of(saved.text, saved.name))["penalty"] if row["kind"] == "flight"]
    return said[0].get("intervals")


def at(saved: Saved, times: np.ndarray) -> np.ndarray:
    """qpos (T, nq), quaternions by one of their two signs."""
    qpos = saved.figure.to_qpos(path_of(saved.timeline).at(times))
    for columns in saved.figure.tables.quaternion_columns.T:
        qpos[:, columns] *= np.where(qpos[:, columns[:1]] < 0, -1.0, 1.0)
    return qpos


@pytest.mark.parametrize(
    ("edit", "when", "off"),
    [
        (lambda saved: edits.retimed(saved, 2.0), lambda t: t / 2, 1e-6),
        (lambda saved: edits.trimmed(saved, 0.1, 0.3), lambda t: t, 2e-3),  # whose ends' slopes a clip does not hold
    ],
)
def test_what_is_edited_of_a_motion_that_follows_a_recording_is_a_motion_of_keyframes(
    followed, tmp_path, edit, when, off
):
    edited = edit(followed)
    assert "recording" not in edited.text
    assert all(key.fixed.all() for key in edited.keys)
    times = np.linspace(0.11, 0.29, 7)
    np.testing.assert_allclose(at(edited, when(times)), at(followed, times), rtol=0, atol=1e-9)
    measured = solving.measured(edited, quiet(), "edited")
    assert measured.report
    assert isinstance(solving.Solved.of(edited).violations, tuple)
    for exact in (False, True):
        clip_file.write(edited, tmp_path / "part.toml", exact=exact, overwrite=True)
        again = recordings.load(str(tmp_path / "part.toml"))
        np.testing.assert_allclose([k.time for k in again.keys], [k.time for k in edited.keys], atol=1e-12)
    own = solving.solve(again, quiet()).motion.timeline  # exact: the spline through them as it is
    np.testing.assert_allclose(
        again.figure.to_qpos(path_of(own).at(when(times)))[:, :3], at(edited, when(times))[:, :3], rtol=0, atol=off
    )


def test_two_motions_that_follow_recordings_are_joined(followed):
    both, times = edits.joined(followed, followed, 0.2, quiet()), np.linspace(0.02, 0.4, 7)
    assert "recording" not in both.text
    np.testing.assert_allclose(at(both, times), at(followed, times), rtol=0, atol=1e-9)


def test_a_clip_that_follows_a_recording_is_edited_as_a_motion(folder, tmp_path):
    for edit in (edit_files.retimed(2.0, None), edit_files.mirrored()):
        name = str(folder / "following.toml")
        with pytest.raises(UserError, match=r"-o NAME\.npz"):
            edit_files.run([name], edit, tmp_path / "out.toml", overwrite=False, progress=quiet())
    edit = edit_files.retimed(2.0, None)
    target, told = edit_files.run([name], edit, tmp_path / "out.npz", overwrite=False, progress=quiet())
    assert [violation.text for violation in told if violation.keyframe is not None] == []
    assert "recording" not in motion.load(target).text
    assert not (tmp_path / "out.toml").exists()


def test_a_motion_that_follows_a_recording_is_saved_or_thinned_as_a_clip_that_needs_none(followed, tmp_path):
    clip_file.write(followed, tmp_path / "elsewhere.toml", overwrite=False)
    again = recordings.load(str(tmp_path / "elsewhere.toml"))
    assert not again.has_recording
    assert len(again.keys) == followed.timeline.times.size
    thinning.write(thinning.thinned(followed, 0.02, 0.1), tmp_path / "thin.toml", exact=False)
    again = recordings.load(str(tmp_path / "thin.toml"))
    assert not again.has_recording
    assert len(again.keys) < len(followed.keys)


@pytest.mark.slow
def test_one_that_follows_what_ships_is_saved_as_the_same_edit(tmp_path):
    saved = solving.unsolved(recordings.load("step_on_kerb")).saved(quiet(), with_report=False)
    clip_file.write(saved, tmp_path / "kerb.toml", overwrite=False)
    again = recordings.load(str(tmp_path / "kerb.toml"))
    assert again.has_recording
    assert [key.time for key in again.authored_keys] == [2.24, 2.86, 3.24]
    clip_file.write(saved, tmp_path / "exact.toml", exact=True, overwrite=False)
    assert not recordings.load(str(tmp_path / "exact.toml")).has_recording


def test_flights_are_cut_and_shifted_as_contacts_are(flying):
    assert flights(edits.trimmed(flying, 0.1, 0.3)) == [[0.1, 0.15]]
    cut = edits.trimmed(flying, 0.2, 0.4)
    assert flights(cut) == []
    assert isinstance(solving.Solved.of(cut).violations, tuple)
    assert solving.measured(cut, quiet(), "cut").report
    both = flights(edits.joined(flying, flying, 0.2, quiet()))
    assert both is not None
    np.testing.assert_allclose(both, [[0.05, 0.15], [0.66, 0.76]], rtol=0, atol=1e-12)


def test_flights_are_left_to_the_keyframes_where_one_of_two_motions_says_none(flying, tmp_path):
    other = solved(recordings.load(str(tiny.written(tmp_path, name="other.toml"))))
    assert flights(edits.joined(flying, other, 0.2, quiet())) is None


@pytest.mark.slow
def test_a_loop_flies_as_often_as_it_is_repeated():
    text = models.clip_text("run_loop")
    assert "flight" not in text
    last = recordings.load("run_loop").keys[-1].time
    said = f'[[penalty]]\nkind = "flight"\nintervals = [[{0.2 * last}, {0.3 * last}]]\n\n[[keyframe]]'
    clip = recordings.from_text(text.replace("[[keyframe]]", said, 1), name="flying")
    saved = solving.unsolved(clip).saved(quiet(), with_report=False)
    thrice = flights(edits.repeated(saved, 3))
    assert thrice is not None
    wanted = [[(0.2 + i) * last, (0.3 + i) * last] for i in range(3)]
    np.testing.assert_allclose(thrice, wanted, rtol=0, atol=1e-9)


@pytest.mark.parametrize("source", ["tiny.toml", "own.npz"])
def test_a_clip_that_is_written_elsewhere_finds_its_figure(folder, tmp_path, source):
    where = [str(folder / source)]
    for sources, edit, end in ((where, edit_files.trimmed(0.1, 0.3), 0.3), (where * 2, edit_files.joined(0.2), 1.02)):
        target, _ = edit_files.run(sources, edit, tmp_path / f"{end}.toml", overwrite=False, progress=quiet())
        assert recordings.load(str(target)).keys[-1].time == pytest.approx(end)


def test_what_the_second_motion_leaves_free_is_where_it_goes_when_they_are_joined(tmp_path):
    """Its root turns by 170° on the way, so the second goes on in another direction."""
    text = tiny.CLIP.replace('root.position = [0.1, 0, "free"]', 'root.position = ["free", 0.02, 1]')
    saved = solved(recordings.load(str(tiny.written(tmp_path, text))))
    both = edits.joined(saved, saved, 0.2, quiet())
    key = next(key for key in both.keys if abs(key.time - 0.81) < 1e-6)
    there = at(both, np.array([0.81]))[0]
    np.testing.assert_array_equal(key.fixed[:3], [True, True, True])
    np.testing.assert_allclose(key.state[:3], there[:3], rtol=0, atol=1e-9)
    raw = both.figure.to_qpos(path_of(both.raw).at(np.array([0.81])))[0]
    np.testing.assert_allclose(raw[:3], there[:3], rtol=0, atol=1e-9)
    assert sampled(both.figure, both.timeline, 20.0).qpos.shape[0] == 21


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
    head, *keyframes = tiny.CLIP.replace("fps = 20", "fps = 20" + THING).split("[[keyframe]]")
    text = "[[keyframe]]".join([head, *(each + PLACED.format(x=x) for x, each in enumerate(keyframes, 1))])
    recorded = solved(recordings.load(str(tiny.written(tmp_path, text))))
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


TARGET = 'sites.left_toe = {position = [0.3, "free", 0.85], by = "search"}\n'
LEVEL = 'sites.left_toe = {position = ["free", "free", 0.85], by = "search"}\n'
CONTACT = '[[contact]]\npoint = "left_toe"\nfrom = 0.05\nto = 0.35\nposition = [0.1, 0.2, 0]\n\n'
LOOP = tiny.changed("frames = 2", 'frames = 2\nends = "periodic"')


def with_target(text: str, number: int, target: str = TARGET) -> str:
    """A clip with a target in one of its keyframes."""
    head, *keyframes = text.split("[[keyframe]]")
    keyframes[number] += target
    return "[[keyframe]]".join([head, *keyframes])


def unsolved_of(folder: Path, text: str) -> Saved:
    clip: Clip = recordings.load(str(tiny.written(folder, text)))
    return solving.unsolved(clip).saved(quiet(), with_report=False)


def amounts(saved: Saved, kind: str) -> list[float]:
    return sorted(v.amount for v in solving.Solved.of(saved).violations if v.kind == kind)


def reloaded(saved: Saved, folder: Path) -> Clip:
    clip_file.write(saved, folder / "edited.toml", overwrite=True)
    return recordings.load(str(folder / "edited.toml"))


@pytest.mark.parametrize("interval", [(0.0, 0.41), (0.1, 0.3), (0.2, 0.41), (0.0, 0.2)])
def test_a_trimmed_motion_has_its_targets_also_at_a_cut(tmp_path, interval):
    saved = unsolved_of(tmp_path, with_target(tiny.CLIP, 1))
    (missed,) = amounts(saved, "placement")
    cut = edits.trimmed(saved, *interval)
    assert amounts(cut, "placement") == pytest.approx([missed], rel=0, abs=1e-9)
    assert [goal.time for goal in reloaded(cut, tmp_path).context.placed] == [0.2]
    assert amounts(edits.trimmed(saved, 0.25, 0.41), "placement") == []


@pytest.mark.parametrize("target", [TARGET, LEVEL])
def test_joined_motions_have_the_targets_of_both(tmp_path, target):
    """The second motion is rotated by 170°, so its target has another direction."""
    saved = unsolved_of(tmp_path, with_target(tiny.CLIP, 1, target))
    both = edits.joined(saved, saved, 0.2, quiet())
    assert amounts(both, "placement") == pytest.approx(2 * amounts(saved, "placement"), rel=0, abs=1e-9)
    assert [goal.time for goal in reloaded(both, tmp_path).context.placed] == pytest.approx([0.2, 0.81])
    assert both.text.count('["free", "free", 0.85]') == (2 if target == LEVEL else 0)


def test_joined_motions_have_targets_where_they_meet(tmp_path):
    saved = unsolved_of(tmp_path, with_target(tiny.CLIP, 1))
    ending, starting = edits.trimmed(saved, 0.0, 0.2), edits.trimmed(saved, 0.2, 0.41)
    both = edits.joined(ending, starting, 0.2, quiet())
    missed = sorted(amounts(ending, "placement") + amounts(starting, "placement"))
    assert len(missed) == 2
    assert amounts(both, "placement") == pytest.approx(missed, rel=0, abs=1e-9)
    reloaded(both, tmp_path)


@pytest.mark.parametrize("turn", [0, 90])
def test_a_repeated_loop_has_its_targets_in_every_period(tmp_path, turn):
    saved = unsolved_of(tmp_path, with_target(tiny.changed("[0, 10, 170]", f"[0, 0, {turn}]", LOOP), 1))
    (missed,) = amounts(saved, "placement")
    many = edits.repeated(saved, 3)
    assert amounts(many, "placement") == pytest.approx(3 * [missed], rel=0, abs=1e-9)
    assert [goal.time for goal in reloaded(many, tmp_path).context.placed] == pytest.approx([0.2, 0.61, 1.02])


@pytest.mark.parametrize("number", [0, 2])
def test_a_repeated_loop_has_the_target_of_its_seam_at_every_seam(tmp_path, number):
    text = tiny.changed("ends =", "travel = [0.3, 0, 0]\nends =", LOOP)
    entries = "root.position = [0.3, 0, 1]\nroot.rotation = {rotvec = [0, 10, 170]}\n"
    text = tiny.changed(entries, "", text)
    if number == 0:
        text = tiny.changed("root.position = [0, 0, 1]\nroot.rotation = {rotvec = [0, 0, 0]}\n", "", text)
    many = edits.repeated(unsolved_of(tmp_path, with_target(text, number)), 3)
    times = [goal.time for goal in reloaded(many, tmp_path).context.placed]
    assert times == pytest.approx([0.41 * (i + number / 2) for i in range(3)])


def test_positions_of_contacts_move_with_the_second_motion(tmp_path):
    saved = unsolved_of(tmp_path, tiny.changed("[[keyframe]]", CONTACT + "[[keyframe]]"))
    both = edits.joined(saved, saved, 0.2, quiet())
    (missed,) = amounts(saved, "contact")
    assert amounts(both, "contact") == pytest.approx([missed, missed], rel=0, abs=1e-9)
