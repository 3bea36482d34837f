"""Pictures of the shipped clips, for the README or the gallery: python docs/gallery.py [-o renders/gallery.png]

--films writes the animated pictures of docs/howto.md instead, renders/films/NAME.webp.
The picture has a tile per clip, four in a row, each drawn by `dynsplines render`. A clip without an entry in TILES is
shown in the middle of its time; `tumble` is shown along its whole path, in a tile twice as wide.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import imageio.v3 as iio
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from dynsplines import models

Picture = NDArray[np.uint8]

ROOT = Path(__file__).parent.parent
COMMAND = "import sys; from dynsplines.cli import main; main()"
WIDTH, HEIGHT, GAP = 400, 300, 6  # [pixels]
COLUMNS = 4
WHITE = 255
CAMERA = "three_quarter"
TILES: dict[str, tuple[float, str]] = {  # clips in their order: the time that is shown [s], from where
    "run_and_step": (1.03, "side"),
    "walk_loop": (0.57, CAMERA),
    "run_loop": (0.17, "side"),
    "stairs": (2.0, "side"),
    "jump_over_box": (1.07, CAMERA),
    "sit_down": (1.3, CAMERA),
    "cartwheel": (1.3, "side"),
    "hand_on_rail": (1.0, CAMERA),
    "carry_box": (5.4, CAMERA),
}
FILM = (384, 216)  # [pixels]
FPS, QUALITY = 15, 55  # of films
ALONG = ("tumble",)  # shown along their whole way


def tile(name: str, folder: Path) -> Picture:
    """A clip's picture."""
    target = folder / f"{name}.png"
    if name in ALONG:
        words = ["--ghosts", "--size", f"{2 * WIDTH + GAP}x{HEIGHT}"]
    else:
        time, camera = TILES.get(name, (middle(name), CAMERA))
        words = ["--only", "after", "--at", f"{time:g}", "--camera", camera, "--size", f"{WIDTH}x{HEIGHT}"]
    subprocess.run([sys.executable, "-c", COMMAND, "render", name, *words, "-o", str(target)], cwd=ROOT, check=True)
    return np.asarray(Image.open(target).convert("RGB"))


def film(name: str, folder: Path, target: Path) -> None:
    """A clip as a small animated picture, seen from where its tile is."""
    drawn, size = folder / f"{name}.mp4", f"{FILM[0]}x{FILM[1]}"
    words = ["--only", "after", "--size", size, "--fps", str(FPS), "--camera", TILES.get(name, (0, CAMERA))[1]]
    subprocess.run([sys.executable, "-c", COMMAND, "render", name, *words, "-o", str(drawn)], cwd=ROOT, check=True)
    first, *others = [Image.fromarray(image) for image in iio.imiter(drawn)]
    target.parent.mkdir(parents=True, exist_ok=True)
    first.save(
        target, save_all=True, append_images=others, duration=round(1000 / FPS), loop=0, quality=QUALITY, method=6
    )


def middle(name: str) -> float:
    """The middle of a clip's time [s]."""
    times = [key["time"] for key in tomllib.loads(models.clip_text(name))["keyframe"]]
    return (times[0] + times[-1]) / 2


def rows(tiles: list[Picture]) -> list[list[Picture]]:
    """Tiles in rows that are no wider than COLUMNS."""
    out: list[list[Picture]] = [[]]
    for tile in tiles:
        if sum(one.shape[1] + GAP for one in [*out[-1], tile]) > COLUMNS * (WIDTH + GAP):
            out.append([])
        out[-1].append(tile)
    return out


def sheet(tiles: list[Picture]) -> Picture:
    """All tiles on white, each row in the middle."""
    tile_rows = rows(tiles)
    out = np.full((len(tile_rows) * (HEIGHT + GAP) - GAP, COLUMNS * (WIDTH + GAP) - GAP, 3), WHITE, np.uint8)
    for i, row in enumerate(tile_rows):
        x0 = (out.shape[1] - sum(one.shape[1] + GAP for one in row) + GAP) // 2
        for one in row:
            top = i * (HEIGHT + GAP)
            out[top : top + HEIGHT, x0 : x0 + one.shape[1]] = one
            x0 += one.shape[1] + GAP
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "renders" / "gallery.png")
    parser.add_argument("--films", action="store_true", help="the small films instead")
    arguments = parser.parse_args()
    target = arguments.output
    if arguments.films:
        with tempfile.TemporaryDirectory() as folder:
            for name in models.clips():
                film(name, Path(folder), target.parent / "films" / f"{name}.webp")
        return
    others = [name for name in models.clips() if name not in (*TILES, *ALONG)]
    with tempfile.TemporaryDirectory() as folder:
        tiles = [tile(name, Path(folder)) for name in (*TILES, *others, *ALONG)]
    Image.fromarray(sheet(tiles)).save(target, optimize=True)


if __name__ == "__main__":
    main()
