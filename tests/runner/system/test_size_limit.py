"""Small files that ask for all the memory there is are refused before they get it."""

from __future__ import annotations

import io
import struct
import zipfile
from pathlib import Path

import mujoco
import numpy as np
import pytest

from dynsplines import models, motion
from dynsplines.clip.load import load
from dynsplines.clip.parse import check_times
from dynsplines.errors import UserError
from dynsplines.exchange.array_reader import read_npz
from dynsplines.scene.assets import Scene, taken_along
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.system import size_limit


def model(inside: str) -> str:
    return f"<mujoco>{inside}</mujoco>"


def copies(inside: str, *counts: int) -> str:
    for count in counts:
        inside = f'<replicate count="{count}" offset="1 0 0">{inside}</replicate>'
    return model(f"<worldbody>{inside}</worldbody>")


BALL = '<geom size=".1"/>'
BOMBS = {
    "copies": copies(BALL, 1_000_000),
    "copies of copies": copies(BALL, 300, 300),
    "copies in a frame": copies(f"<frame pos='0 0 1'><body>{BALL}</body></frame>", 100_000),
    "a number in other letters": copies(BALL, 7).replace('"7"', '"&#49;e6"'),
    "behind a comment": "<!-- <replicate count='2'> ' -->" + copies(BALL, 1_000_000),
    "a height field": model('<asset><hfield name="a" nrow="20000" ncol="20000" size="1 1 1 1"/></asset>'),
    "a texture": model('<asset><texture name="a" builtin="flat" width="9000" height="54000"/></asset>'),
    "a grid": model('<worldbody><flexcomp name="a" type="grid" count="100 100 100" spacing=".1 .1 .1"/></worldbody>'),
    "an arena": model('<size memory="80G"/>'),
    "keyframes": model('<size nkey="100000000"/><worldbody><body><joint/><geom size="1"/></body></worldbody>'),
    "a table": model('<custom><numeric name="a" size="1000000000"/></custom>'),
    "a sensor": model('<sensor><user name="a" dim="1000000000"/></sensor>'),
    "fields of the user": model(f'<size nuser_geom="100000000"/><worldbody>{BALL}</worldbody>'),
}


@pytest.mark.parametrize("bomb", BOMBS)
def test_a_model_that_asks_for_too_much_is_refused_before_mujoco_reads_it(bomb: str, tmp_path: Path) -> None:
    path = tmp_path / "bomb.xml"
    path.write_text(BOMBS[bomb], encoding="utf-8")
    for attempt in (
        lambda: figure_spec(str(path)),
        lambda: load(str(path)),
        lambda: Scene(BOMBS[bomb]).model(),
        lambda: Scene(BOMBS[bomb]).spec(),
    ):
        with pytest.raises(
            UserError, match=r"describes comes to [\d,]+ MB in memory, over 1,000 MB; .*DYNSPLINES_LARG"
        ):
            attempt()


def test_copies_in_other_files_count_where_they_are_included_and_attached(tmp_path: Path) -> None:
    (tmp_path / "part.xml").write_text(copies(BALL, 100), encoding="utf-8")
    attached = '<asset><model name="p" file="part.xml"/></asset><worldbody>{}</worldbody>'.format(
        '<replicate count="1000"><attach model="p" prefix="x"/></replicate>'
    )
    (tmp_path / "many.xml").write_text(model(attached), encoding="utf-8")
    (tmp_path / "loop.xml").write_text(model('<include file="loop.xml"/>'), encoding="utf-8")
    for name in ("many", "part"):
        (tmp_path / "whole.xml").write_text(model(f'<include file="{name}.xml"/>'), encoding="utf-8")
        mjcf = tmp_path / "whole.xml"
        if name == "many":
            with pytest.raises(UserError, match="over 1,000 MB"):
                size_limit.check_mjcf_file(mjcf)
        else:
            size_limit.check_mjcf_file(mjcf)
    size_limit.check_mjcf_file(tmp_path / "loop.xml")


def test_an_image_is_as_large_as_its_head_says(tmp_path: Path) -> None:
    head = b"\x89PNG\r\n\x1a\n" + struct.pack(">I4sII", 13, b"IHDR", 40_000, 40_000)
    text = model('<asset><texture name="a" type="2d" file="a.png"/></asset>')
    (tmp_path / "m.xml").write_text(text, encoding="utf-8")
    (tmp_path / "a.png").write_bytes(head)
    with pytest.raises(UserError, match="9,600 MB"):
        size_limit.check_mjcf_file(tmp_path / "m.xml")
    with pytest.raises(UserError, match="9,600 MB"):
        Scene(text, {"a.png": head}).model()


@pytest.mark.parametrize("text", ["<a <a <a", '<a "' * 100_000, "<!--" * 100_000, "<", "<mujoco", "<a b='" * 100_000])
def test_what_is_no_xml_is_left_to_mujoco_and_takes_no_time(text: str) -> None:
    size_limit.check_mjcf(text, "model")


def test_what_ships_and_what_is_large_for_good_reason_passes() -> None:
    for name in models.figures():
        size_limit.check_mjcf(compose(figure_spec(name)).mjcf, name)
    size_limit.check_mjcf(copies(BALL, 10_000), "ten thousand copies")
    size_limit.check_mjcf(BOMBS["a height field"].replace("20000", "4000"), "four kilometres by the metre")


def test_the_environment_says_how_large_is_too_large(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DYNSPLINES_LARGEST", "100000")
    size_limit.check_mjcf(BOMBS["a height field"], "model")
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
