"""A motion as images: before | after, one of them, the keyframes, figure 6; drawn by the CPU alone."""

import pickle
from dataclasses import replace

import imageio.v3 as iio
import numpy as np
import pytest

from dynsplines.motion import Saved
from dynsplines.picture import film, show
from dynsplines.picture.graphics import Graphics
from dynsplines.picture.show import Look, figure_six, images, shots_of
from dynsplines.system.progress import silent
from dynsplines.system.workers import in_order

SOFTWARE = Graphics("software", "renderer: software")
W, H = 48, 32


def look(**more) -> Look:
    return replace(Look(W, H, fps=10.0, camera="high"), **more)


def shot(saved: Saved, **more) -> list[np.ndarray]:
    return list(images(saved, look(**more), SOFTWARE))


def apart(a: np.ndarray, b: np.ndarray) -> int:
    """How many pixels differ."""
    return int((np.abs(a.astype(int) - b.astype(int)).max(axis=-1) > 8).sum())


def test_before_and_after_stand_side_by_side_in_one_picture_of_the_requested_size(saved):
    both = shot(saved)
    assert len(both) == 5
    assert {image.shape for image in both} == {(H, W, 3)}
    assert {image.dtype for image in both} == {np.dtype(np.uint8)}
    left, right = (shot(saved, only=name, width=W // 2) for name in ("before", "after"))
    for whole, before, after in zip(both, left, right, strict=True):
        np.testing.assert_array_equal(whole[H // 2 :, : W // 2 - 1], before[H // 2 :, :-1])
        np.testing.assert_array_equal(whole[H // 2 :, W // 2 + 1 :], after[H // 2 :, 1:])
        assert apart(whole[: H // 2, : W // 2 - 1], before[: H // 2, :-1]) > 5  # a title tells the two apart


def test_one_image_at_a_time_and_picked_images_are_those_of_the_video_and_slower_means_more_of_them(saved):
    shown = shot(saved, only="after")
    (one,) = shot(saved, only="after", at=0.2)
    np.testing.assert_array_equal(one, shown[2])
    shots = shots_of(saved, look(only="after"))
    some = list(images(saved, look(only="after"), SOFTWARE, [shots[0], shots[3]]))
    np.testing.assert_array_equal(some, [shown[0], shown[3]])
    assert apart(shown[0], shown[-1]) > 5
    np.testing.assert_array_equal(shot(saved, only="after", slow=2.0)[::2], shown)


def test_keyframes_are_shown_as_they_are_each_for_half_a_second(saved):
    shown = shot(saved, only="keys")
    assert len(shown) == 3 * 5
    for i in range(3):
        for image in shown[5 * i : 5 * i + 5]:
            np.testing.assert_array_equal(image, shown[5 * i])
    assert apart(shown[0], shown[5]) > 3
    single = [replace(shot, frames=1) for shot in shots_of(saved, look(only="keys"))]
    sheet = list(images(saved, look(only="keys"), SOFTWARE, single))
    assert len(sheet) == 3
    np.testing.assert_array_equal(sheet, shown[::5])


def test_a_sheet_shows_all_keyframes_but_few_moments_of_a_motion(saved, tmp_path, monkeypatch):
    def sheet(only: str) -> np.ndarray:
        show.draw(saved, look(only=only), SOFTWARE, tmp_path / "a.png", 1, silent())
        return iio.imread(tmp_path / "a.png")

    keys, after = sheet("keys"), sheet("after")
    monkeypatch.setattr(film, "SHEET_PICTURES", 2)
    np.testing.assert_array_equal(sheet("keys"), keys)
    assert sheet("after").size < after.size


def test_ghosts_add_the_keyframes_to_every_image(saved):
    plain, haunted = (shot(saved, only="after", ghosts=ghosts, width=96, height=64) for ghosts in (False, True))
    assert all(apart(a, b) > 10 for a, b in zip(plain, haunted, strict=True))


@pytest.mark.slow
def test_figure_six_shows_keyframes_darker_than_what_is_between(saved):
    empty = replace(saved, keys=())
    everything = figure_six(saved, look(width=96, height=64), SOFTWARE)
    keys = figure_six(saved, look(width=96, height=64, only="keys"), SOFTWARE)
    none = figure_six(empty, look(width=96, height=64, only="keys"), SOFTWARE)
    assert everything.shape == keys.shape == (64, 96, 3)
    assert apart(keys, none) > 20
    own = np.abs(keys.astype(int) - none).max(axis=-1) > 8
    more = (np.abs(everything.astype(int) - none).max(axis=-1) > 8) & ~own
    assert more.sum() > 3
    change = np.abs(everything.astype(int) - none).mean(axis=-1)
    assert change[own].mean() > 1.5 * change[more].mean()


def test_more_workers_draw_the_same_images(saved, monkeypatch):
    """All that goes to processes comes out of pickles as it was."""

    def pickled(opened, work, items, workers):
        assert workers == 2
        return in_order(*pickle.loads(pickle.dumps((opened, work, list(items)))))

    chosen = look(ghosts=True)
    shots = shots_of(saved, chosen)[:2]
    one = list(images(saved, chosen, SOFTWARE, shots))
    monkeypatch.setattr(show, "PIXELS_OF_A_PROCESS", 1)
    monkeypatch.setattr(show, "in_order", pickled)
    np.testing.assert_array_equal(list(images(saved, chosen, SOFTWARE, shots, workers=2)), one)
