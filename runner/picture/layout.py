"""Pictures side by side, and captions. An image is (H, W, 3), uint8; sizes do not change."""

from __future__ import annotations

import functools
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

Picture = NDArray[np.uint8]
Place = Literal["top", "bottom right"]

_PAPER = (250, 251, 252)  # red, green, blue
_INK = (24, 30, 38)  # red, green, blue
_OPACITY = 0.72  # [1] opacity of labels
_SUPERSAMPLING = 4  # samples per pixel, in either direction, for the round corners of labels


def side_by_side(left: Picture, right: Picture) -> Picture:
    """Return two pictures of equal height as one, (H, Wl + Wr, 3), with a fine line between them."""
    both = np.concatenate([left, right], axis=1)
    seam = left.shape[1]
    half = 1 if both.shape[1] >= 200 else 0
    both[:, seam - half : seam + half] = _PAPER
    return both


def caption(image: Picture, text: str, *, place: Place = "top") -> Picture:
    """Return the picture with a word on a rounded plate, such as "before" or "0.80 s".

    The height of the letters is 1/30 of the picture's, and less for long text.
    """
    height, width = image.shape[:2]
    if not text.strip() or min(height, width) < 24:
        return image.copy()
    margin = max(2, round(height / 40))
    letters = max(9, round(height / 30))
    pill = _pill(text, letters)
    while letters > 6 and (pill.shape[1] > width - 2 * margin or pill.shape[0] > height - 2 * margin):
        letters -= 1
        pill = _pill(text, letters)
    pill = pill[: height - 2 * margin, : width - 2 * margin]
    rows, columns = pill.shape[:2]
    is_top = place == "top"
    top, x0 = (margin, (width - columns) // 2) if is_top else (height - margin - rows, width - margin - columns)
    out = image.copy()
    under = out[top : top + rows, x0 : x0 + columns].astype(np.float32)
    alpha = pill[..., 3:]
    out[top : top + rows, x0 : x0 + columns] = np.rint(under * (1 - alpha) + pill[..., :3] * alpha).astype(np.uint8)
    return out


@functools.lru_cache(maxsize=64)
def _pill(text: str, letters: int) -> NDArray[np.float32]:
    """Return a rounded plate with its text, (h, w, 4): colour 0 to 255, alpha 0 to 1, with smooth edges."""
    font = ImageFont.load_default(letters)
    x0, _, right, _ = font.getbbox(text)
    # the height of these letters makes all plates equally high
    _, top, _, bottom = font.getbbox("Ahgy0")
    pad_x, pad_y = round(0.7 * letters), round(0.38 * letters)
    width, height = round(right - x0) + 2 * pad_x, round(bottom - top) + 2 * pad_y
    big = Image.new("L", (width * _SUPERSAMPLING, height * _SUPERSAMPLING), 0)
    ImageDraw.Draw(big).rounded_rectangle((0, 0, big.width - 1, big.height - 1), radius=big.height // 2, fill=255)
    plate = np.asarray(big.resize((width, height), Image.Resampling.BOX), dtype=np.float32)[..., None] / 255
    ink = Image.new("L", (width, height), 0)
    ImageDraw.Draw(ink).text((pad_x - x0, pad_y - top), text, fill=255, font=font)
    cover = np.asarray(ink, dtype=np.float32)[..., None] / 255
    alpha = np.maximum(plate * _OPACITY, cover)
    colour = np.asarray(_PAPER, np.float32) * cover + np.asarray(_INK, np.float32) * (1 - cover)
    return np.concatenate([colour, alpha], axis=-1).astype(np.float32)
