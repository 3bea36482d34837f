"""Small files that ask for all the memory there is are refused before they get it."""

import io
import struct
import zipfile
from pathlib import Path

import mujoco
import numpy as np
import pytest

from dynsplines import motion
from dynsplines.clip.parse import check_times
from dynsplines.errors import UserError
from dynsplines.exchange.array_reader import read_npz
from dynsplines.scene.assets import taken_along
from dynsplines.scene.compose import figure_spec
from dynsplines.system import size_limit


def test_the_environment_says_how_large_is_too_large(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "large.xml"
    path.write_text("<mujoco/>".ljust(3_000_000), encoding="utf-8")
    figure_spec(str(path))
    monkeypatch.setenv("DYNSPLINES_LARGEST", "2")
    with pytest.raises(UserError, match=r"large.xml: it comes to 3 MB in memory, over 2 MB; .*set DYNSPLINES_LARGEST"):
        figure_spec(str(path))
    monkeypatch.setenv("DYNSPLINES_LARGEST", "lots")
    with pytest.raises(UserError, match="DYNSPLINES_LARGEST=lots: give a number of MB, such as 4000"):
        size_limit.bound()


def archive(path: Path, arrays: dict[str, bytes]) -> None:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as target:
        for name, data in arrays.items():
            target.writestr(f"{name}.npy", data)


def npy(shape: str, data: bytes) -> bytes:
    head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + data


@pytest.mark.slow
@pytest.mark.parametrize("read", [motion.read_arrays, read_npz])
def test_arrays_are_weighed_before_they_are_read(read, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DYNSPLINES_LARGEST", "10")
    bomb = tmp_path / "bomb.npz"
    archive(bomb, {f"a{i}": npy("(500000,)", bytes(4_000_000)) for i in range(3)})
    assert bomb.stat().st_size < 20_000
    with pytest.raises(UserError, match=r"bomb.npz: what it holds comes to 12 MB in memory, over 10 MB"):
        read(bomb)
    archive(bomb, {"a": npy("(1000000000000,)", bytes(800))})
    with pytest.raises(UserError, match=r"bomb.npz: 'a.npy' does not have the size in its header"):
        read(bomb)
    stream = io.BytesIO()
    np.savez_compressed(stream, a=np.arange(1e6))
    bomb.write_bytes(stream.getvalue())
    found = read(bomb)
    assert (found.entries if read is read_npz else found)["a"].size == 1e6


def test_keyframes_too_unevenly_apart_for_a_spline_are_refused() -> None:
    check_times([0, 0.001, 10.001, 20], "clip")
    check_times([0, 0.001, 1, 100], "clip")
    for times, told in (
        ([0, 0.001, 100], "keyframes 1, 2 and 3 are 0.001 s and 99.999 s apart, which is over 10,000 : 1"),
        ([-100, 0, 0.001], "keyframes 1, 2 and 3 are 100 s and 0.001 s apart, which is over 10,000 : 1"),
    ):
        with pytest.raises(UserError, match=f"clip: {told}; insert keyframes into the long interval, with shorter"):
            check_times(times, "clip")


def test_keyframes_can_be_1_ms_apart_in_spite_of_rounding() -> None:
    check_times([i / 1000 for i in range(100)], "clip")
    with pytest.raises(UserError, match=r"keyframe 2 \(t = 0\.00999 s\) is less than 0\.001 s after keyframe 1"):
        check_times([0.009, 0.00999, 1], "clip")


def test_the_files_of_a_model_are_held_to_the_same_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    spec = mujoco.MjSpec()
    spec.add_mesh(name="a", file="a.stl")
    spec.assets = {"a.stl": bytes(2_000_000)}
    monkeypatch.setenv("DYNSPLINES_LARGEST", "1")
    with pytest.raises(UserError, match="files it refers to hold comes to 2 MB in memory, over 1 MB"):
        taken_along(spec)
    monkeypatch.setenv("DYNSPLINES_LARGEST", "3")
    assert set(taken_along(spec)) == {"a.stl"}
