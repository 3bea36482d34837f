"""Images, beside each other and with words on them, become files that play and appear only when they are complete."""

import ctypes
import os
from collections.abc import Iterator
from pathlib import Path

import av
import imageio.v3 as iio
import numpy as np
import pytest
from texts import read_cases

from dynsplines.errors import UserError
from dynsplines.picture.film import AHEAD, SHEET_PICTURES, _in_a_thread, check_target, write
from dynsplines.picture.show import caption, side_by_side
from dynsplines.scene.framing import spread

RED = (200, 60, 40)
M_PERTURB = -6  # as glibc's malloc.h has it
ENDINGS = (".mp4", ".webm", ".gif", ".png")


def images(count: int = 6, height: int = 48, width: int = 64) -> Iterator[np.ndarray]:
    """A red ground with a bright square that moves."""
    for index in range(count):
        image = np.full((height, width, 3), RED, np.uint8)
        image[4:12, 4 + 3 * index : 12 + 3 * index] = (240, 240, 90)
        yield image


def decoded(path: Path) -> list[av.VideoFrame]:
    with av.open(str(path)) as container:
        return list(container.decode(video=0))


def bt709_to_rgb(picture: av.VideoFrame) -> np.ndarray:
    """(3,) the colour near the lower right corner, by the formula of BT.709 for limited range."""
    planes = picture.to_ndarray(format="yuv420p")
    height, width = picture.height, picture.width
    chroma = planes[height:].reshape(2, height // 2, width // 2)
    y = (float(planes[height - 6, width - 6]) - 16) / 219
    u, v = (chroma[:, height // 2 - 3, width // 2 - 3].astype(float) - 128) / 224
    red, blue = y + 1.5748 * v, y + 1.8556 * u
    return 255 * np.array([red, (y - 0.2126 * red - 0.0722 * blue) / 0.7152, blue])


@pytest.mark.parametrize("ending", [".mp4", ".webm"])
def test_a_video_shows_the_colour_that_was_drawn_as_bt709_of_limited_range(tmp_path: Path, ending: str):
    target = tmp_path / f"a{ending}"
    write(target, images(), 30)
    np.testing.assert_allclose(bt709_to_rgb(decoded(target)[3]), RED, atol=4)
    with av.open(str(target)) as container:
        context = container.streams.video[0].codec_context
        assert context.pix_fmt == "yuv420p"
        tags = (context.colorspace, context.color_primaries, context.color_trc, context.color_range)
        assert [int(tag) for tag in tags] == [1, 1, 1, 1]
    content = target.read_bytes()
    assert ending == ".webm" or content.index(b"moov") < content.index(b"mdat")  # browsers can start before the end


@pytest.mark.parametrize("ending", [".mp4", ".webm", ".gif"])
def test_every_image_arrives_at_its_time_also_if_it_is_drawn_over_for_the_next_one(tmp_path: Path, ending: str):
    def one_canvas() -> Iterator[np.ndarray]:
        canvas = np.empty((48, 64, 3), np.uint8)
        for image in images(9):
            canvas[:] = image
            yield canvas

    write(tmp_path / f"a{ending}", images(9), 25)
    pictures = decoded(tmp_path / f"a{ending}")
    assert len(pictures) == 9
    assert (pictures[0].width, pictures[0].height) == (64, 48)
    assert pictures[8].time == pytest.approx(8 / 25, abs=0.002)
    write(tmp_path / f"b{ending}", one_canvas(), 25)
    assert (tmp_path / f"a{ending}").read_bytes() == (tmp_path / f"b{ending}").read_bytes()


def test_what_memory_held_before_is_not_seen_in_a_video(tmp_path: Path):
    """glibc fills what it gives out and takes back with a byte of our choice."""
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None) if os.name == "posix" else None
    if mallopt is None:
        pytest.skip("no mallopt in this C library")
    films: set[bytes] = set()
    try:
        for filling in (1, 127, 254):
            mallopt(M_PERTURB, filling)
            write(tmp_path / "a.mp4", images(16, 144, 176), 30)
            films.add((tmp_path / "a.mp4").read_bytes())
    finally:
        mallopt(M_PERTURB, 0)
    assert len(films) == 1


def test_a_gif_keeps_its_colours_repeats_may_have_an_odd_size_and_is_not_faster_than_browsers_play(tmp_path: Path):
    write(tmp_path / "a.gif", images(3, height=31, width=47), 20)
    assert b"NETSCAPE2.0" in (tmp_path / "a.gif").read_bytes()
    picture = iio.imread(tmp_path / "a.gif", plugin="pillow", index=2)
    assert picture.shape[:2] == (31, 47)
    np.testing.assert_allclose(picture[-4, -4, :3].astype(int), RED, atol=3)
    write(tmp_path / "a.gif", images(12), 60)
    pictures = decoded(tmp_path / "a.gif")
    assert len(pictures) == 6
    assert pictures[3].time == pytest.approx(0.1, abs=0.011)


def test_a_contact_sheet_shows_few_images_all_and_twelve_of_many_and_of_one_is_the_image(tmp_path: Path):
    (image,) = images(1)
    write(tmp_path / "a.png", [image], 30)
    assert (iio.imread(tmp_path / "a.png") == image).all()
    write(tmp_path / "a.png", images(3), 30)
    sheet = iio.imread(tmp_path / "a.png")
    assert sheet.shape[0] * sheet.shape[1] > 3 * 48 * 64
    assert (sheet[0, 0] == 255).all()
    picks = spread(100, SHEET_PICTURES).tolist()
    assert len(picks) == 12 and (picks[0], picks[-1]) == (0, 99)
    assert max(np.diff(picks)) - min(np.diff(picks)) <= 1


@pytest.mark.parametrize(
    ("ending", "error"), [*((each, KeyboardInterrupt) for each in ENDINGS), (".mp4", RuntimeError)]
)
def test_a_broken_off_clip_leaves_what_was_there(tmp_path: Path, ending: str, error: type[BaseException]):
    def broken() -> Iterator[np.ndarray]:
        yield from images(3)
        raise error("stopped")

    target = tmp_path / f"a{ending}"
    target.write_bytes(b"the old film")
    with pytest.raises(error, match="stopped"):
        write(target, broken(), 30)
    assert target.read_bytes() == b"the old film"
    assert [entry.name for entry in tmp_path.iterdir()] == [target.name]


@pytest.mark.parametrize(("name", "size", "told"), read_cases("film_targets.toml"))
def test_a_target_that_cannot_be_written_is_refused(tmp_path: Path, name: str, size: tuple[int, int], told: str):
    (tmp_path / "folder.mp4").mkdir()
    with pytest.raises(UserError, match=told):
        check_target(tmp_path / name, *size)


def test_a_directory_without_permission_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(UserError, match="the folder is not writable"):
        check_target(tmp_path / "run.mp4", 64, 48)


@pytest.mark.parametrize("fps", [0.0, float("nan")])
def test_a_rate_that_is_not_positive_is_refused(tmp_path: Path, fps: float):
    with pytest.raises(UserError, match="positive"):
        write(tmp_path / "a.mp4", images(), fps)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("last", [0, 99])
def test_an_error_of_the_encoder_stops_the_drawing_and_is_not_lost(last: int):
    drawn: list[int] = []

    def full(item: int) -> None:
        if item == last:
            raise OSError(28, "No space left on device")

    with pytest.raises(OSError, match="No space left"):
        _in_a_thread(full, (drawn.append(item) or item for item in range(100)))
    assert len(drawn) <= last + AHEAD + 2


def plain(height: int, width: int, value: int = 120) -> np.ndarray:
    return np.full((height, width, 3), value, np.uint8)


def test_two_halves_of_one_height_make_exactly_the_whole():
    both = side_by_side(plain(720, 640, 10), plain(720, 640, 200))
    assert both.shape == (720, 1280, 3)
    assert both.dtype == np.uint8
    assert (both[:, :630] == 10).all()
    assert (both[:, 650:] == 200).all()


@pytest.mark.parametrize("place", ["top", "bottom right"])
def test_a_caption_is_written_where_it_was_requested_and_nowhere_else(place):
    before = plain(360, 640)
    after = caption(before, "0.80 s", place=place)
    assert (before == 120).all()
    changed = np.argwhere((after != before).any(axis=-1))
    y, x = changed.mean(axis=0) / after.shape[:2]
    assert after.shape == before.shape
    assert (y < 0.5) == place.startswith("top")
    assert {"left": x < 0.4, "right": x > 0.6}.get(place.partition(" ")[2], abs(x - 0.5) < 0.02)


def test_a_caption_is_readable_on_black_and_on_white_and_smaller_in_a_small_picture():
    for value in (0, 255):
        pill = caption(plain(360, 640, value), "before")[5:60, 260:380]
        assert pill.max() > 230
        assert pill.min() < 110
    after = caption(plain(120, 160), "a caption that is rather long for a picture")
    assert (after[:, [0, 1, -2, -1]] == 120).all()
    for text in ("", "  "):
        assert (caption(plain(100, 100), text) == 120).all()
