"""A picture with its caption beneath, as a printed figure has it: "Figure 7" in bold, then words, wrapped to its width.

Letters are those that matplotlib brings along, so a caption can hold whatever a chart can.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import matplotlib
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

Picture = NDArray[np.uint8]
Word = tuple[str, ImageFont.FreeTypeFont]

PAPER, INK = (255, 255, 255), (34, 48, 58)  # red, green, blue
LETTERS = 70  # a picture is so many letter heights wide: a line holds some 130 letters
LEAST_LETTERS = 8  # [pixels]
LEADING = 1.45  # line spacing, in letter heights
MARGIN = 1.0  # round the caption, in letter heights


def captioned(picture: Picture, label: str, text: str) -> Picture:
    """The picture on white, (H + h, W, 3), with "label: text" under it; same width."""
    width = picture.shape[1]
    letters = max(LEAST_LETTERS, round(width / LETTERS))
    margin, leading = round(MARGIN * letters), round(LEADING * letters)
    lines = _wrapped(_words(label, text, letters), width - 2 * margin)
    strip = Image.new("RGB", (width, 2 * margin + leading * len(lines)), PAPER)
    draw = ImageDraw.Draw(strip)
    for row, line in enumerate(lines):
        across = float(margin)
        for word, font in line:
            draw.text((across, margin + row * leading), word, fill=INK, font=font)
            across += font.getlength(word + " ")
    return np.concatenate([picture, np.asarray(strip, dtype=np.uint8)])


def _words(label: str, text: str, letters: int) -> list[Word]:
    bold, plain = _font("DejaVuSans-Bold", letters), _font("DejaVuSans", letters)
    return [*((word, bold) for word in f"{label}:".split()), *((word, plain) for word in text.split())]


def _wrapped(words: list[Word], width: float) -> list[list[Word]]:
    """Words in lines that are no wider than this; a word that is goes into a line of its own."""
    lines: list[list[Word]] = [[]]
    used = 0.0
    for word, font in words:
        if lines[-1] and used + font.getlength(word) > width:
            lines.append([])
            used = 0.0
        lines[-1].append((word, font))
        used += font.getlength(word + " ")
    return lines


@cache
def _font(name: str, letters: int) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(str(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / f"{name}.ttf"), letters)
