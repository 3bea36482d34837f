"""Video frames into a video, an animated GIF or a contact sheet, selected by the extension of the target.

Frames of videos are streamed, so the clip is never in memory, and a file gets its name only when it is complete. Video
is tagged as BT.709, so that players show the same colours. One thread encodes, so that equal frames result in equal
bytes. It is not the drawing thread, so that the next frame is drawn meanwhile.
"""

from __future__ import annotations

import math
import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from fractions import Fraction
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar, cast

import imageio.v3 as iio
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ..errors import UserError
from ..system import output
from ..system.workers import AHEAD

if TYPE_CHECKING:  # stills and GIFs need no video library
    import av
    from av.video.stream import VideoStream

Picture = NDArray[np.uint8]
Writer = Callable[[Path, Iterator[Picture], float], None]
Item = TypeVar("Item")

SHEET_PICTURES = 12  # maximum number of frames on a contact sheet, except of keyframes
SHEET_TILE = 480  # [pixels] longer side of a frame on a contact sheet
SHEET_MARGIN = 8  # [pixels] between frames on a contact sheet
GIF_FPS = 50  # [1/s] maximum rate of a GIF; browsers slow down faster ones

# by extension: codec, its options, and those of the container. The index of .mp4 is at the front of the file, so that a
# browser can start before it is loaded. x264's macroblock tree is disabled: at widths such as 848 or 960 pixels its
# assembly reads uninitialised memory, and equal frames result in different bytes. It would save 3 to 10 % of the size.
CODECS = {
    ".mp4": ("libx264", {"preset": "medium", "crf": "20", "mbtree": "0"}, {"movflags": "+faststart"}),
    ".webm": ("libvpx-vp9", {"crf": "24", "b:v": "0", "deadline": "good", "cpu-used": "4", "row-mt": "0"}, {}),
}


def check_target(path: str | os.PathLike[str], width: int, height: int) -> None:
    """Raise UserError if `write` could not write frames of this size [pixels] to a path. Writes nothing."""
    target = Path(path)
    output.check_target(target, endings=_WRITERS)
    if width < 1 or height < 1:
        raise UserError(f"{target}: {width}x{height} pixels; both must be at least 1")
    if target.suffix.lower() in CODECS and (width % 2 or height % 2):
        even = f"{width + width % 2}x{height + height % 2}"
        raise UserError(
            f"{target}: {width}x{height} pixels; {target.suffix} needs even sizes: take {even}, or write .gif"
        )


def write(path: str | os.PathLike[str], images: Iterable[Picture], fps: float) -> None:
    """Write frames to a file: .mp4, .webm, .gif, or .png for a contact sheet.

    On failure, an existing file is unchanged and no temporary file remains.

    Args:
        images: One or more frames, each (H, W, 3), all of one size.
        fps: Frames per second [1/s].
    """
    if not (math.isfinite(fps) and fps > 0):
        raise UserError(f"{path}: {fps} images a second; it must be a positive number")
    source = iter(images)
    first = next(source)
    check_target(path, first.shape[1], first.shape[0])
    target = Path(path)
    with output.Replacement(target) as partial:
        _WRITERS[target.suffix.lower()](partial, chain([first], source), fps)


def _write_video(path: Path, images: Iterator[Picture], fps: float) -> None:
    """Encode as yuv420p with BT.709."""
    codec, codec_options, container_options = CODECS[path.suffix.lower()]
    import av
    from av.video.reformatter import ColorRange, Colorspace

    rate = Fraction(fps).limit_denominator(65535)
    with av.open(str(path), "w", container_options={"fflags": "+bitexact", **container_options}) as container:
        first = next(images)
        stream = cast("VideoStream", container.add_stream(codec, rate, options=codec_options))
        stream.height, stream.width = first.shape[:2]
        stream.pix_fmt = "yuv420p"
        context = stream.codec_context
        context.thread_count = 1
        context.colorspace = context.color_primaries = context.color_trc = Colorspace.ITU709.value
        context.color_range = ColorRange.MPEG.value

        def put(picture: av.VideoFrame | None) -> None:
            if picture is not None:
                picture = picture.reformat(format="yuv420p", dst_colorspace="ITU709", threads=1)
            container.mux(stream.encode(picture))

        _in_a_thread(put, chain(_frames(chain([first], images), 1 / rate), [None]))


def _frames(images: Iterable[Picture], tick: Fraction) -> Iterator[av.VideoFrame]:
    """Yield the frames with their times, as copies, so that a renderer may reuse its buffer."""
    import av

    for index, image in enumerate(images):
        picture = av.VideoFrame.from_ndarray(image, format="rgb24")
        picture.pts, picture.time_base = index, tick
        yield picture


def _in_a_thread(work: Callable[[Item], None], items: Iterable[Item]) -> None:
    """Run `work` on the items in another thread, while the next ones are made. An error of either ends both."""
    with ThreadPoolExecutor(1, "encoder") as thread:
        waiting: deque[Future[None]] = deque()
        for item in items:
            waiting.append(thread.submit(work, item))
            while len(waiting) > AHEAD:
                waiting.popleft().result()
        for done in waiting:
            done.result()


def _write_gif(path: Path, images: Iterator[Picture], fps: float) -> None:
    """Write a GIF that repeats forever. The palette is that of the first frame, without dithering, so that still parts
    stay still and the file is small. Unlike a video, it is in memory until its end, at a byte per pixel."""
    step, durations = math.ceil(fps / GIF_FPS - 1e-9), list[int]()
    chosen = (Image.fromarray(image) for index, image in enumerate(images) if index % step == 0)

    def frames(palette: Image.Image) -> Iterator[Image.Image]:
        for image in chosen:
            durations.append(_gif_duration(len(durations), fps / step))
            yield image.quantize(palette=palette, dither=Image.Dither.NONE)

    first = next(chosen).quantize()
    durations.append(_gif_duration(0, fps / step))
    with path.open("wb") as stream:
        first.save(stream, "GIF", save_all=True, append_images=frames(first), duration=durations, loop=0)


def _gif_duration(index: int, fps: float) -> int:
    """Return the duration of a frame [ms] in whole hundredths of a second, such that their sum has no drift."""
    return 10 * (round(100 * (index + 1) / fps) - round(100 * index / fps))


def _write_sheet(path: Path, images: Iterator[Picture], fps: float) -> None:
    """Write a contact sheet, or a single frame."""
    first = next(images)
    second = next(images, None)
    sheet = first if second is None else _grid([_tile(image) for image in chain([first, second], images)])
    iio.imwrite(path, sheet, extension=".png")


def _tile(image: Picture) -> Picture:
    height, width = image.shape[:2]
    scale = SHEET_TILE / max(height, width)
    if scale >= 1:
        return image
    size = max(1, round(width * scale)), max(1, round(height * scale))
    return np.asarray(Image.fromarray(image).resize(size, Image.Resampling.LANCZOS))


def _grid(tiles: list[Picture]) -> Picture:
    """Return the tiles in reading order on white, with the number of columns that fits a screen best."""
    height, width = tiles[0].shape[:2]
    columns = min(range(1, len(tiles) + 1), key=lambda n: _misfit(n, len(tiles), width / height))
    rows = math.ceil(len(tiles) / columns)
    pitch_y, pitch_x = height + SHEET_MARGIN, width + SHEET_MARGIN
    sheet = np.full((rows * pitch_y + SHEET_MARGIN, columns * pitch_x + SHEET_MARGIN, 3), 255, np.uint8)
    for index, tile in enumerate(tiles):
        top, x0 = SHEET_MARGIN + index // columns * pitch_y, SHEET_MARGIN + index % columns * pitch_x
        sheet[top : top + height, x0 : x0 + width] = tile
    return sheet


def _misfit(columns: int, count: int, aspect: float) -> float:
    """Return the deviation of a grid from 16:9, with a penalty for empty places."""
    rows = math.ceil(count / columns)
    return abs(math.log(columns * aspect / rows / (16 / 9))) + 0.25 * (rows * columns - count)


_WRITERS: dict[str, Writer] = {**dict.fromkeys(CODECS, _write_video), ".gif": _write_gif, ".png": _write_sheet}
