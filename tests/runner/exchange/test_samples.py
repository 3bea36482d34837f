"""Samples without numbers are refused or left out, and unlimited hinges that wrap at ±180° are unwrapped."""

import io
import re
from pathlib import Path

import motions
import numpy as np
import pytest
import shipped
from rich.console import Console
from texts import read_data

from dynsplines import UserError
from dynsplines.exchange import formats, gaps
from dynsplines.exchange.motion_import import import_recording, read_recording
from dynsplines.system.progress import Progress


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A walk of 30 images a second, the 13th to 15th of which hold no numbers, in several formats."""
    folder = tmp_path_factory.mktemp("gaps")
    walk = shipped.unsolved("walk_loop")
    formats.export(walk, "bvh", folder / "whole.bvh", fps=30)
    head, rows = (folder / "whole.bvh").read_text(encoding="utf-8").split("Frame Time")
    lines = rows.splitlines()
    for i in (13, 14, 15):
        words = lines[i].split()
        lines[i] = " ".join(["nan", *words[1:4], "inf", *words[5:]])
    (folder / "torn.bvh").write_text(f"{head}Frame Time{chr(10).join(lines)}\n", encoding="utf-8")
    formats.export(walk, "csv", folder / "whole.csv", fps=30)
    table = (folder / "whole.csv").read_text(encoding="utf-8").splitlines()
    for i in (13, 14, 15):
        words = table[i].split(",")
        table[i] = ",".join([words[0], "nan", *words[2:]])
    (folder / "torn.csv").write_text("\n".join(table) + "\n", encoding="utf-8")
    formats.export(walk, "npz", folder / "whole.qpos.npz", fps=30)
    with np.load(folder / "whole.qpos.npz") as file:
        arrays = dict(file)
    arrays["qpos"][12:15, 7] = np.nan
    np.savez(folder / "torn.qpos.npz", **arrays)
    return folder


FILES = ["bvh", "qpos.npz"]


@pytest.mark.parametrize("ending", [*FILES, "csv"])
def test_import_refuses_them(folder: Path, ending: str) -> None:
    with pytest.raises(UserError, match=r"finite"):
        import_recording(folder / f"torn.{ending}", figure="human")


@pytest.mark.parametrize("ending", FILES)
def test_they_are_left_out_with_a_note_and_the_others_are_as_they_were(folder: Path, ending: str) -> None:
    whole, text = read_recording(folder / f"whole.{ending}", figure="human"), io.StringIO()
    with gaps.allow():
        progress = Progress(Console(file=text, width=200))
        torn = read_recording(folder / f"torn.{ending}", figure="human", progress=progress)
    assert "note: 3 samples lack some or all numbers, at 0.400-0.467 s: left out as a whole" in text.getvalue()
    kept = np.delete(np.arange(whole.time.size), [12, 13, 14])
    np.testing.assert_allclose(torn.time, whole.time[kept], atol=1e-9)
    np.testing.assert_allclose(np.abs(torn.qpos), np.abs(whole.qpos[kept]), atol=1e-6)


def test_a_file_of_nothing_else_is_refused_all_the_same(folder: Path, tmp_path: Path) -> None:
    with np.load(folder / "whole.qpos.npz") as file:
        arrays = dict(file)
    arrays["qpos"][:, 7] = np.nan
    np.savez(tmp_path / "none.qpos.npz", **arrays)
    with gaps.allow(), pytest.raises(UserError, match="'qpos': an entry is not a finite number"):
        read_recording(tmp_path / "none.qpos.npz")


def test_the_rate_is_that_of_samples_at_different_times(folder: Path, tmp_path: Path) -> None:
    head, *rows = (folder / "whole.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    (tmp_path / "twice.csv").write_text(head + "".join(2 * row for row in rows), encoding="utf-8")
    assert read_recording(tmp_path / "twice.csv", figure="human").rate == pytest.approx(30)


POSE, LOWERED = np.zeros(9), np.linspace(0, 1.4, 30)


@pytest.mark.parametrize(
    ("angles", "seconds"),
    [
        ([*POSE[:1], *(1.4 + LOWERED)], 0.034),
        ([*POSE, *(1.4 + LOWERED)], 0.3),
        ([*POSE, *(1.4 + POSE)], 0.3),
        ([*POSE, *LOWERED], None),  # a pose that is left as fast as people move
        ([*POSE, 1.4, *POSE, *LOWERED], None),  # an outlier
        ([*LOWERED, *(2.8 + LOWERED)], None),  # a jump in a motion
        (POSE, None),
    ],
)
def test_a_jump_out_of_a_pose_at_the_start_is_reported(angles, seconds, tmp_path: Path) -> None:
    (tmp_path / "arm.xml").write_text(
        '<mujoco><worldbody><body><joint name="swing"/><geom size=".1"/></body></worldbody></mujoco>'
    )
    np.savez(tmp_path / "arm.npz", qpos=np.reshape(angles, (-1, 1)), fps=30)
    text = io.StringIO()
    import_recording(tmp_path / "arm.npz", figure=str(tmp_path / "arm.xml"), progress=Progress(Console(file=text)))
    found = re.findall(
        r"starts with a pose and jumps .* `dynsplines trim --from (\S+)`", " ".join(text.getvalue().split())
    )
    assert found == ([] if seconds is None else [f"{seconds:g}"])


ARM = read_data("arm_on_base.xml")
TIME = np.linspace(0, 2, 61)


@pytest.fixture
def arm(tmp_path):
    (tmp_path / "arm.xml").write_text(ARM)
    return tmp_path / "arm.xml"


def wrapped(angle, low=-np.pi):
    return (angle - low) % (2 * np.pi) + low


def recording(**columns):
    """qpos (61, 11) at rest but for the columns named."""
    qpos = np.zeros((TIME.size, 11))
    qpos[:, 3] = 1
    for name, values in columns.items():
        qpos[:, 7 + ["turret", "shoulder", "elbow", "rail"].index(name)] = values
    return qpos


def read(arm, qpos):
    np.savetxt(arm.parent / "arm.csv", np.column_stack([TIME, qpos]), delimiter=",", fmt="%.9f")
    return read_recording(arm.parent / "arm.csv", "csv", figure=str(arm), progress=Progress(Console(width=200))).qpos


@pytest.mark.parametrize("low", [-np.pi, 0.0])
def test_a_hinge_without_range_or_with_a_whole_turn_is_unwrapped_and_named(arm, low, capsys):
    angle = low + 5.7 + 1.5 * TIME + np.sin(5 * TIME)
    start = wrapped(angle, low)[0] - angle[0]
    found = read(arm, recording(turret=wrapped(angle, low), shoulder=wrapped(-angle, low)))
    np.testing.assert_allclose(found[:, 7], angle + start, atol=1e-8)
    np.testing.assert_allclose(np.diff(found[:, 8]), -np.diff(angle), atol=1e-8)
    note = "note: 'turret', 'shoulder': angles wrap at a whole turn, first at "
    assert capsys.readouterr().out.startswith(note)


def test_limited_hinges_and_slides_and_turns_that_are_recorded_stay(arm):
    jumps = np.where(TIME < 1, 3.1, -3.1)
    fast = 3.5 * np.arange(TIME.size)  # more than half a turn a sample, over many turns
    qpos = recording(turret=fast, elbow=jumps * 0.9, rail=jumps)
    np.testing.assert_allclose(read(arm, qpos), qpos, atol=1e-8)


@pytest.mark.parametrize("kind", ["npz", "mjlab", "locomujoco", "gmr", "mimickit"])
def test_every_format_is_unwrapped(arm, kind, tmp_path):
    angle = np.linspace(2.8, 3.6, 5)
    text = ARM.replace('<joint name="rail" type="slide" axis="1 0 0"/>', "") if kind == "mimickit" else ARM
    arm.write_text(text)
    qpos = recording(turret=wrapped(2.8 + 0.8 * TIME / 2))[:, : 10 if kind == "mimickit" else 11]
    keys = np.tile(qpos[0], (5, 1))
    keys[:, 7] = wrapped(angle)
    saved = motions.through(str(arm), np.linspace(0, 2, 5), keys)
    target = formats.export(saved, kind, tmp_path / f"a{formats.writer(kind).ending}", fps=2.0)
    found = read_recording(target, figure=str(arm), fps=2.0)
    np.testing.assert_allclose(found.qpos[:, 7], angle, atol=1e-8)
