"""MOTION.npz: plain arrays in MuJoCo's conventions, from which everything can be made again, written whole or not."""

import zipfile
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from oracles import aligned
from shipped import Move

from dynsplines import motion
from dynsplines.errors import UserError
from dynsplines.motion import Sampled, Saved, load, save


@pytest.fixture(scope="module")
def arrays(motion_file: Path) -> dict[str, np.ndarray]:
    with np.load(motion_file, allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}


def differentiated(model: mujoco.MjModel, qpos: np.ndarray, dt: float) -> np.ndarray:
    """Central differences of configurations, by MuJoCo."""
    out = np.empty((len(qpos) - 2, model.nv))
    for i in range(1, len(qpos) - 1):
        mujoco.mj_differentiatePos(model, out[i - 1], 2 * dt, qpos[i - 1], qpos[i + 1])
    return out


def changed(source: Path, target: Path, **changes: Any) -> Path:
    """A motion file with some arrays replaced (None: left out)."""
    with np.load(source, allow_pickle=False) as archive:
        data = {name: archive[name] for name in archive.files} | changes
    np.savez(target, **{name: value for name, value in data.items() if value is not None})
    return target


@pytest.mark.parametrize(("duration", "fps", "count"), [(0.3, 10, 4), (0.29, 100, 30), (0.29, 10, 3), (2.2, 30, 67)])
def test_a_last_sample_on_the_last_keyframe_is_not_lost_to_rounding(duration, fps, count):
    assert motion.sample_count(duration, fps) == count
    with pytest.raises(UserError, match="lower the rate"):
        motion.sample_count(600.0, 1e5)


def test_times_shapes_and_names_fit_the_model_in_the_file(arrays):
    np.testing.assert_allclose(arrays["time"], np.arange(int(np.floor(0.41 * 20)) + 1) / 20, rtol=0, atol=1e-12)
    model = mujoco.MjModel.from_xml_string(str(arrays["mjcf"]))
    assert (model.nq, model.nv) == (11, 9)
    assert model.geom("floor").id >= 0
    for prefix in ("", "raw_"):
        assert arrays[f"{prefix}qpos"].shape == (9, 11)
        assert arrays[f"{prefix}qvel"].shape == arrays[f"{prefix}qacc"].shape == (9, 9)
        for columns in (slice(3, 7), slice(7, 11)):
            q = arrays[f"{prefix}qpos"][:, columns]
            np.testing.assert_allclose(np.linalg.norm(q, axis=1), 1, atol=1e-12)
            assert np.all(np.sum(q[1:] * q[:-1], axis=1) > 0)  # no jumps to the other sign
    assert arrays["key_qpos"].shape == arrays["key_fixed"].shape == (3, 11)
    assert arrays["joint_names"].tolist() == ["root", "left_knee"]
    assert arrays["body_names"].tolist() == ["world", "pelvis", "left_shin"]
    assert {array.dtype.kind for array in arrays.values()} <= set("fiubU")


def test_velocities_and_accelerations_are_mujocos(saved: Saved):
    model = saved.figure.model
    dt = 1e-4
    for side in (saved, saved.before):
        fine = Sampled.of(side, 1 / dt)
        velocity = differentiated(model, fine.qpos, dt)
        np.testing.assert_allclose(fine.qvel[1:-1], velocity, atol=1e-4 * np.abs(velocity).max())
        slope = (fine.qvel[2:] - fine.qvel[:-2]) / (2 * dt)
        # at a knot the acceleration has a corner, which no difference sees
        smooth = np.min(np.abs(fine.time[1:-1, None] - side.timeline.times), axis=1) > 1.5 * dt
        np.testing.assert_allclose(fine.qacc[1:-1][smooth], slope[smooth], atol=1e-3 * np.abs(slope).max())


def test_keyframes_are_met_with_the_paths_own_sign(arrays, solved: Move):
    wanted = np.array([key.state for key in solved.clip.keys])
    reached, fixed = arrays["key_qpos"], arrays["key_fixed"]
    np.testing.assert_array_equal(fixed, [key.fixed for key in solved.clip.keys])
    wanted = aligned(solved.clip.figure, wanted, reached)
    np.testing.assert_allclose(reached[fixed], wanted[fixed], atol=1e-9)
    on_path = motion.continuous(solved.clip.figure, Sampled.of(solved.motion, 1000.0).qpos)
    np.testing.assert_allclose(reached[1], on_path[200], atol=1e-9)
    np.testing.assert_allclose(reached[0], arrays["qpos"][0], atol=1e-12)


def test_a_loaded_motion_saves_to_the_same_arrays(motion_file: Path, tmp_path: Path, arrays):
    save(load(motion_file), tmp_path / "again.npz")
    with np.load(tmp_path / "again.npz") as again:
        assert set(again.files) == set(arrays)
        for name in set(arrays) - {"key_qpos"}:
            np.testing.assert_array_equal(again[name], arrays[name], err_msg=name)
        np.testing.assert_allclose(again["key_qpos"], arrays["key_qpos"], atol=1e-12)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"qacc": None}, "no 'qacc'"),
        ({"format_version": 3}, "format 3"),
        ({"format_version": np.ones(3, int)}, "format_version"),
        ({"fps": 0.0}, "fps is 0"),
        ({"qpos": np.zeros((2, 11))}, "'qpos'"),
        ({"qpos": np.full((9, 11), np.nan)}, "'qpos'"),
        ({"time": np.arange(4.0)}, "fit together"),
        ({"key_time": np.array([0.0, 0.25, 0.41])}, "a keyframe has no frame"),
        ({"key_fixed": np.ones((3, 3), bool)}, "fit together"),
        ({"frame_state": np.zeros((5, 11))}, "zero"),
        ({"frame_state": np.zeros((5, 11), complex)}, "complex"),
        ({"frame_time": np.arange(5.0)[::-1].copy()}, "fit together"),
        ({"end_slope": np.zeros((2, 3))}, "end_slope"),
        ({"mjcf": "<mujoco"}, "fit together"),
        ({"coordinates": "polar"}, "polar"),
        ({"trace": "{"}, "fit together"),
        ({"report": "[1]"}, "fit together"),
        ({"report": np.array([{}], object)}, "pickled"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, dict) else "",
)
def test_a_motion_whose_parts_contradict_each_other_is_refused_in_one_line(motion_file, tmp_path, changes, words):
    with pytest.raises(UserError, match=words) as caught:
        load(changed(motion_file, tmp_path / "odd.npz", **changes))
    assert str(caught.value).startswith(str(tmp_path / "odd.npz"))
    assert "\n" not in str(caught.value)


def foreign(folder: Path, motion_file: Path) -> dict[str, Path]:
    """Files that are called .npz and hold something else."""
    whole = motion_file.read_bytes()
    contents = {
        "empty": b"",
        "random": np.random.default_rng(0).bytes(3000),
        "a start": whole[:10],
        "a half": whole[: len(whole) // 2],
        "all but the end": whole[:-5],
        "a hole": whole[:3000] + b"x" * 60 + whole[3060:],
    }
    for name, content in contents.items():
        (folder / f"{name}.npz").write_bytes(content)
    with zipfile.ZipFile(folder / "zip.npz", "w") as archive:
        archive.writestr("a.txt", "hello")
    with zipfile.ZipFile(folder / "nothing.npz", "w"):
        pass
    with (folder / "one array.npz").open("wb") as stream:
        np.save(stream, np.ones(3))
    np.savez(folder / "others.npz", a=np.ones(3))
    np.savez(folder / "objects.npz", a=np.array([{}], object))
    (folder / "folder.npz").mkdir()
    return {path.stem: path for path in folder.iterdir()}


def test_files_that_are_no_motion_are_refused_in_one_line(motion_file: Path, tmp_path: Path):
    files = foreign(tmp_path, motion_file)
    assert len(files) == 12
    for path in (*files.values(), tmp_path / "missing.npz"):
        with pytest.raises(UserError) as caught:
            load(path)
        assert path.name in str(caught.value)
        assert "\n" not in str(caught.value)
