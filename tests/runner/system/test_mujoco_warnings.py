"""MuJoCo's warnings are notes of a command and Python warnings of the API, and never a MUJOCO_LOG.TXT."""

from pathlib import Path

import crew
import figures
import mujoco
import pytest
from processes import Command
from texts import read_data

from dynsplines import Keyframe, build, inbetween
from dynsplines.batch import solving
from dynsplines.batch.task import BatchOptions, Task
from dynsplines.clip import load
from dynsplines.system import mujoco_warnings
from dynsplines.system.workers import in_order

SINGULAR = """<mujoco><worldbody><geom type="plane" size="1 1 1"/><body pos="0 0 1">
    <freejoint/><geom size=".2"/><body>
    <joint name="a" axis="0 1 0"/><joint name="b" axis="0 1 0"/><geom size=".1" pos=".3 0 0"/></body></body>
    </worldbody></mujoco>"""
CLIP = read_data("warned.toml")


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, command: Command, tmp_path: Path) -> Command:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(load, "scene_and_figure", figures.COMPOSED)  # MuJoCo warns while a figure is built
    Path("arm.xml").write_text(SINGULAR)
    Path("clip.toml").write_text(CLIP)
    return command


def notes(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.startswith("note: MuJoCo: ")]


def test_a_command_reports_a_warning_once_and_leaves_no_log(run: Command):
    done = run("solve", "clip.toml", "-o", "arm.npz")
    assert done.code == 0
    (note,) = notes(done.err)
    assert "too close to singular" in note
    assert "Time" not in note
    for words in (("export", "arm.npz", "--to", "locomujoco", "-o", "a.loco.npz"), ("new", "arm.xml", "-o", "n.toml")):
        assert len(notes(run(*words).err)) == 1
    assert not Path("MUJOCO_LOG.TXT").exists()
    assert mujoco.get_mju_user_warning() is None


def test_python_gets_a_warning_at_its_line(run: Command):
    spec = mujoco.MjSpec.from_string(SINGULAR)
    keys = [
        Keyframe(0, joints={"a": 0.0, "b": 0.0}, others="rest"),
        Keyframe(1, joints={"a": 20.0, "b": 30.0}, others="rest"),
    ]
    with pytest.warns(UserWarning, match="MuJoCo: Inertia matrix") as issued:
        clip = build(spec, keys)
    assert [warning.filename for warning in issued] == [__file__]
    with pytest.warns(UserWarning, match="MuJoCo: Inertia matrix"):
        inbetween(clip).export("arm.loco.npz", "locomujoco")
    assert not Path("MUJOCO_LOG.TXT").exists()
    assert mujoco.get_mju_user_warning() is None


def test_workers_pass_theirs_on_and_the_process_reports_each_kind_once(run: Command):
    reported: list[str] = []
    with mujoco_warnings.reported_to(reported.append):
        assert len(list(in_order(crew.Bench, crew.warns, range(4), 2))) == 4
    assert len(reported) == 1
    assert reported[0].startswith("MuJoCo: Nan, Inf or huge value in QVEL")
    assert not Path("MUJOCO_LOG.TXT").exists()


def test_a_batch_has_it_among_the_notes_of_a_clip(run: Command, tmp_path: Path):
    folder = tmp_path / "work"
    folder.mkdir()
    files, options = {"clip.toml": CLIP.encode(), "arm.xml": SINGULAR.encode()}, BatchOptions(to="locomujoco")
    product = solving.solve(Task("clip.toml", files, options=options, output="clip.loco.npz"), folder)
    assert [note[:24] for note in product.notes if "MuJoCo" in note] == ["MuJoCo: Inertia matrix i"]
    assert not Path("MUJOCO_LOG.TXT").exists()


def test_a_handler_of_the_user_is_left_in_place(run: Command):
    def mine(text: str) -> None:
        raise AssertionError(text)

    mujoco.set_mju_user_warning(mine)
    try:
        with pytest.warns(UserWarning, match="Inertia"):
            build("arm.xml", [Keyframe(0, joints={"a": 0.0}), Keyframe(1, joints={"a": 20.0})])
        assert mujoco.get_mju_user_warning() is mine
    finally:
        mujoco.set_mju_user_warning(None)
