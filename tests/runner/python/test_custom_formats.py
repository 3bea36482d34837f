"""Formats of a program's own: what a writer writes appears whole or not at all, what a reader gives is a motion."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
import shipped

from dynsplines import UserError, import_motion
from dynsplines.exchange.trajectory import Recording, SampledTrajectory
from dynsplines.python.motion import Motion
from dynsplines.system.progress import Progress


class Plain:
    """qpos under times, as numbers in rows."""

    def write(self, take: SampledTrajectory, path: Path) -> None:
        np.savetxt(path, np.column_stack([take.time, take.qpos]), fmt="%.17g")

    def read(self, path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
        rows = np.loadtxt(path)
        return Recording(rows[:, 0], rows[:, 1:], fps=fps)


class Broken:
    """Gives up in the middle."""

    def write(self, take: SampledTrajectory, path: Path) -> None:
        path.write_text("half")
        raise UserError("no more")

    def read(self, path: Path, model: mujoco.MjModel | None, fps: float | None) -> Recording:
        return "nothing"  # type: ignore[return-value]


@pytest.fixture(scope="module")
def tumble() -> Motion:
    return Motion(shipped.solved("tumble").saved(Progress(), with_report=False))


def test_a_motion_goes_out_and_comes_back(tumble, tmp_path):
    file = tumble.export(tmp_path / "tumble.rows", to=Plain(), fps=60)
    again = import_motion(file, figure="spinner", format=Plain(), fps=60)
    assert again.difference(tumble).distance < 0.02
    np.testing.assert_allclose(again.sampled(60).qpos, tumble.sampled(60).qpos, atol=1e-9)


def test_what_fails_leaves_what_was_there(tumble, tmp_path):
    file = tmp_path / "a.rows"
    file.write_text("whole")
    with pytest.raises(UserError, match="no more"):
        tumble.export(file, to=Broken())
    assert file.read_text() == "whole"
    assert [path.name for path in tmp_path.iterdir()] == ["a.rows"]


def test_a_reader_gives_a_recording_on_a_figure(tumble, tmp_path):
    file = tumble.export(tmp_path / "tumble.rows", to=Plain())
    with pytest.raises(UserError, match="gives a Recording, not str"):
        import_motion(file, figure="spinner", format=Broken())
    with pytest.raises(UserError, match="its reader gives no figure; name one"):
        import_motion(file, format=Plain())
    with pytest.raises(UserError, match="no file"):
        import_motion(tmp_path / "none.rows", figure="spinner", format=Plain())
