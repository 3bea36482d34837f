"""Edited motions have the targets and contacts of their clips, wherever the edit moves them."""

from __future__ import annotations

from pathlib import Path

import pytest
import tiny
from quiet import quiet

from dynsplines import recordings, solving
from dynsplines.clip import file as clip_file
from dynsplines.clip.build import Clip
from dynsplines.edit import edits
from dynsplines.measure import violation
from dynsplines.motion import Saved

TARGET = 'sites.left_toe = {position = [0.3, "free", 0.85], by = "search"}\n'
LEVEL = 'sites.left_toe = {position = ["free", "free", 0.85], by = "search"}\n'
CONTACT = '[[contact]]\npoint = "left_toe"\nfrom = 0.05\nto = 0.35\nposition = [0.1, 0.2, 0]\n\n'
LOOP = tiny.changed("frames = 2", 'frames = 2\nends = "periodic"')


def with_target(text: str, number: int, target: str = TARGET) -> str:
    """A clip with a target in one of its keyframes."""
    head, *keyframes = text.split("[[keyframe]]")
    keyframes[number] += target
    return "[[keyframe]]".join([head, *keyframes])


def solved(folder: Path, text: str) -> Saved:
    clip: Clip = recordings.load(str(tiny.written(folder, text)))
    return solving.unsolved(clip).saved(quiet(), with_report=False)


def amounts(saved: Saved, kind: str) -> list[float]:
    return sorted(v.amount for v in violation.of_motion(saved) if v.kind == kind)


def reloaded(saved: Saved, folder: Path) -> Clip:
    clip_file.write(saved, folder / "edited.toml", overwrite=True)
    return recordings.load(str(folder / "edited.toml"))


@pytest.mark.parametrize("interval", [(0.0, 0.41), (0.1, 0.3), (0.2, 0.41), (0.0, 0.2)])
def test_a_trimmed_motion_has_its_targets_also_at_a_cut(tmp_path, interval):
    saved = solved(tmp_path, with_target(tiny.CLIP, 1))
    (missed,) = amounts(saved, "placement")
    cut = edits.trimmed(saved, *interval)
    assert amounts(cut, "placement") == pytest.approx([missed], rel=0, abs=1e-9)
    assert [goal.time for goal in reloaded(cut, tmp_path).context.placed] == [0.2]
    assert amounts(edits.trimmed(saved, 0.25, 0.41), "placement") == []


@pytest.mark.parametrize("target", [TARGET, LEVEL])
def test_joined_motions_have_the_targets_of_both(tmp_path, target):
    """The second motion is rotated by 170°, so its target has another direction."""
    saved = solved(tmp_path, with_target(tiny.CLIP, 1, target))
    both = edits.joined(saved, saved, 0.2, quiet())
    assert amounts(both, "placement") == pytest.approx(2 * amounts(saved, "placement"), rel=0, abs=1e-9)
    assert [goal.time for goal in reloaded(both, tmp_path).context.placed] == pytest.approx([0.2, 0.81])
    assert both.text.count('["free", "free", 0.85]') == (2 if target == LEVEL else 0)


def test_joined_motions_have_targets_where_they_meet(tmp_path):
    saved = solved(tmp_path, with_target(tiny.CLIP, 1))
    ending, starting = edits.trimmed(saved, 0.0, 0.2), edits.trimmed(saved, 0.2, 0.41)
    both = edits.joined(ending, starting, 0.2, quiet())
    missed = sorted(amounts(ending, "placement") + amounts(starting, "placement"))
    assert len(missed) == 2
    assert amounts(both, "placement") == pytest.approx(missed, rel=0, abs=1e-9)
    reloaded(both, tmp_path)


@pytest.mark.parametrize("turn", [0, 90])
def test_a_repeated_loop_has_its_targets_in_every_period(tmp_path, turn):
    saved = solved(tmp_path, with_target(tiny.changed("[0, 10, 170]", f"[0, 0, {turn}]", LOOP), 1))
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
    many = edits.repeated(solved(tmp_path, with_target(text, number)), 3)
    times = [goal.time for goal in reloaded(many, tmp_path).context.placed]
    assert times == pytest.approx([0.41 * (i + number / 2) for i in range(3)])


def test_positions_of_contacts_move_with_the_second_motion(tmp_path):
    saved = solved(tmp_path, tiny.changed("[[keyframe]]", CONTACT + "[[keyframe]]"))
    both = edits.joined(saved, saved, 0.2, quiet())
    (missed,) = amounts(saved, "contact")
    assert amounts(both, "contact") == pytest.approx([missed, missed], rel=0, abs=1e-9)
