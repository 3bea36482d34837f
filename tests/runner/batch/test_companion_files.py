"""What lies beside an output in its format comes with it, is missed when it is gone, and is no other figure's."""

from __future__ import annotations

from pathlib import Path

import mujoco
import pytest
import tiny
from quiet import quiet

pytest.importorskip("distributed")

from dynsplines.batch.dispatch import run
from dynsplines.batch.manifest import Manifest
from dynsplines.batch.tally import Tally
from dynsplines.batch.task import Options

CORNERS = "v 0 0 0\nv {size} 0 0\nv 0 {size} 0\nv 0 0 {size}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
MESHED = tiny.FIGURE.replace("<worldbody>", '<asset><mesh name="part" file="part.obj"/></asset><worldbody>').replace(
    '<geom name="shin"', '<geom name="part" type="mesh" mesh="part" mass=".1"/><geom name="shin"'
)


@pytest.fixture
def clips(tmp_path: Path) -> Path:
    """Two clips, each of a figure with a mesh of the same name: another one, or the same."""
    folder = tmp_path / "clips"
    for number, (name, size) in enumerate({"one": 0.1, "two": 0.2}.items()):
        (folder / name).mkdir(parents=True)
        (folder / name / "tiny.xml").write_text(MESHED, encoding="utf-8")
        (folder / name / "part.obj").write_text(CORNERS.format(size=size), encoding="utf-8")
        text = tiny.changed('"tiny.xml"', f'"{name}/tiny.xml"')
        (folder / f"{number}.toml").write_text(text, encoding="utf-8")
    return folder


def done(clips: Path, name: str = "") -> Tally:
    options = Options(workers=1, to="mjcf")
    return run([str(clips / name)], clips.parent / "out", options, quiet())


@pytest.mark.slow
def test_a_mesh_comes_with_the_model_and_another_figures_is_not_written_over_it(clips: Path) -> None:
    tally = done(clips)
    (failed,), out = tally.failed, clips.parent / "out"
    assert tally.solved == 1
    assert "'part.obj' already exists, where a file of this motion's figure would be written" in failed.error
    good = "1" if failed.clip == "0" else "0"
    assert mujoco.MjModel.from_xml_path(str(out / f"{good}.keys.xml")).nkey > 0
    assert list(Manifest.of(out).entries[good].files) == [f"{good}.keys.xml", "part.obj"]

    same = (clips / ("one" if good == "0" else "two") / "part.obj").read_bytes()
    for place in ("one", "two"):
        (clips / place / "part.obj").write_bytes(same)
    assert done(clips).solved == 1
    (out / "part.obj").unlink()
    assert done(clips).solved == 2
    assert (out / "part.obj").read_bytes() == same

    (out / "part.obj").unlink()
    (clips / "1.toml").write_text((clips / "1.toml").read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert done(clips, "1.toml").solved == 1  # the other one stays done, and has the same mesh
    assert (out / "part.obj").read_bytes() == same
