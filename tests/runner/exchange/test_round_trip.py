"""A motion that is written and read again is the same: formats times figures, and files of other programs."""

import pickle
from functools import cache
from pathlib import Path
from typing import Any

import motions
import mujoco
import numpy as np
import pytest
import shipped

from dynsplines import motion
from dynsplines.errors import UserError
from dynsplines.exchange import formats
from dynsplines.exchange.motion_import import import_recording
from dynsplines.motion import Saved

TETRAHEDRON = "v 0 0 0\nv .1 0 0\nv 0 .12 0\nv 0 0 .3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
MESHED = """
<mujoco><compiler meshdir="parts"/><asset><mesh name="trunk" file="trunk.obj"/></asset>
  <worldbody><body name="trunk" pos="0 0 1"><freejoint name="root"/><geom type="mesh" mesh="trunk"/>
    <body name="arm" pos="0 .2 0"><joint name="shoulder" type="ball"/><geom type="mesh" mesh="trunk"/></body></body>
  </worldbody></mujoco>"""
REST = motions.ROBOT.replace('name="left_knee"', 'name="left_knee" ref="0.5"').replace(
    'name="left_hip_roll"', 'name="left_hip_roll" ref="-0.3"'
)
OF_ROBOTS = ("mjlab", "mjlab-csv", "locomujoco", "gmr")
CASES = [
    *((kind, figure) for kind in ("npz", "csv", "mimickit") for figure in ("human", "robot", "rest", "meshed")),
    *((kind, figure) for kind in OF_ROBOTS for figure in ("robot", "rest")),
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files of the figures."""
    folder = tmp_path_factory.mktemp("figures")
    (folder / "parts").mkdir()
    (folder / "parts" / "trunk.obj").write_text(TETRAHEDRON)
    for name, text in (("robot", motions.ROBOT), ("rest", REST), ("meshed", MESHED)):
        (folder / f"{name}.xml").write_text(text)
    return folder


def named(figure: str, folder: Path) -> str:
    return "human" if figure == "human" else str(folder / f"{figure}.xml")


@cache
def moved(figure: str) -> Saved:
    return motions.motion_of(figure)


@pytest.mark.parametrize(("kind", "figure"), CASES)
def test_a_written_motion_is_read_as_it_was(kind: str, figure: str, folder: Path, tmp_path: Path):
    """With the complete ending, and by its content with the last part of it, as other programs name their files."""
    name = named(figure, folder)
    saved = moved(name)
    target, _ = motions.exported(saved, kind, tmp_path)
    motions.came_back(saved, target, name, fps=saved.fps)
    plain = target.rename(tmp_path / f"plain{target.suffix}")
    motions.came_back(saved, plain, name, kind=kind if kind == "mjlab-csv" else None, fps=saved.fps)


def test_a_file_that_holds_its_figure_holds_its_meshes(folder: Path, tmp_path: Path):
    saved = moved(named("meshed", folder))
    target, _ = motions.exported(saved, "npz", tmp_path)
    motions.came_back(saved, target, None)
    assert import_recording(target).figure.model.nmesh == 1
    target, notes = motions.exported(saved, "mjcf", tmp_path)
    assert f"wrote {tmp_path / 'trunk.obj'}" in notes
    assert mujoco.MjModel.from_xml_path(str(target)).nmesh == 1


def test_a_loop_wraps_and_its_last_frame_is_the_first_moved_on(tmp_path: Path):
    walk = shipped.unsolved("walk_loop")  # of a period that is not a whole number of samples
    period = walk.timeline.times[-1] - walk.timeline.times[0]
    target, _ = motions.exported(walk, "mimickit", tmp_path)
    held = pickle.loads(target.read_bytes())
    frames = np.array(held["frames"])
    assert held["loop_mode"] == 1 and (len(frames) - 1) / held["fps"] == pytest.approx(period, abs=1e-12)
    assert frames[-1, 0] - frames[0, 0] > 0.5
    np.testing.assert_allclose(frames[-1, 3:], frames[0, 3:], atol=1e-9)
    back = import_recording(target, figure="human")
    assert back.timeline.times[-1] - back.timeline.times[0] == pytest.approx(period, abs=1e-9)
    assert len(motions.samples(back).time) == len(frames)
    motions.same_poses(walk.figure.model, motions.samples(walk, held["fps"]).qpos, motions.samples(back).qpos, 1e-4)


def test_locomujoco_of_its_own_tool_has_joints_in_any_order(folder: Path, tmp_path: Path):
    saved, order = moved(named("robot", folder)), [3, 0, 1, 2, 4]
    before = motions.samples(saved)
    names = [saved.figure.model.joint(1 + i).name for i in order]
    entries: dict[str, Any] = {
        "joint_names": np.array([*names, "root_free"]),
        "jnt_type": np.array([3] * 5 + [0], np.int32),
        "qpos": np.concatenate([before.qpos[:, 7:][:, order], before.qpos[:, :7]], axis=1).astype(np.float32),
        "qvel": before.qvel,
        "frequency": np.array(motions.FPS),
        "split_points": np.array([0, len(before.time)], np.int32),
        "metadata": np.array(None, dtype=object),  # None is a pickle, which nobody loads
    }
    np.savez(tmp_path / "theirs.npz", **entries)
    motions.came_back(saved, tmp_path / "theirs.npz", named("robot", folder), tolerance=1e-5)
    np.savez(tmp_path / "two.npz", **entries | {"split_points": np.array([0, 10, len(before.time)])})
    with pytest.raises(UserError, match="holds 2 motions"):
        import_recording(tmp_path / "two.npz", figure=named("robot", folder))


def test_gmr_without_bodies_and_arrays_without_times_are_read(folder: Path, tmp_path: Path):
    name = named("robot", folder)
    target, _ = motions.exported(moved(name), "gmr", tmp_path)
    held = pickle.loads(target.read_bytes())
    target.write_bytes(pickle.dumps(held | {"local_body_pos": None, "link_body_list": None}, protocol=2))
    motions.came_back(moved(name), target, name)
    np.savez(tmp_path / "bare.npz", qpos=motions.samples(moved(name)).qpos)
    motions.came_back(moved(name), tmp_path / "bare.npz", name, fps=motions.FPS)


def test_a_motion_of_this_program_is_told_from_arrays(tmp_path: Path):
    motion.save(moved("human"), tmp_path / "ours.npz")
    assert len(import_recording(tmp_path / "ours.npz").keys) == len(motions.samples(moved("human")).time)
    assert not formats.is_foreign(tmp_path / "ours.npz")
