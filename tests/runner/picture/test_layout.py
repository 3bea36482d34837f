"""Pictures beside each other and words on them, at exactly the size that was asked for."""

import numpy as np
import pytest

from dynsplines.picture.layout import caption, side_by_side


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


def test_a_caption_is_readable_on_black_and_on_white():
    for value in (0, 255):
        pill = caption(plain(360, 640, value), "before")[5:60, 260:380]
        assert pill.max() > 230
        assert pill.min() < 110


def test_a_caption_too_long_for_the_picture_is_set_smaller():
    image = plain(120, 160)
    after = caption(image, "a caption that is rather long for a picture")
    assert (after[:, :2] == 120).all()
    assert (after[:, -2:] == 120).all()


@pytest.mark.parametrize(("size", "text"), [(100, ""), (100, "  "), (8, "before")])
def test_no_words_and_too_small_a_picture_for_words_leave_no_mark(size: int, text: str):
    assert (caption(plain(size, size), text) == 120).all()
