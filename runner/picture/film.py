"""Video frames into a video, an animated GIF or a contact sheet, selected by the extension of the target.

Frames are streamed, so the clip is never in memory, and a file gets its name only when it is complete. Video is tagged
as BT.709, so that players show the same colours. One thread encodes, so that equal frames result in equal bytes. It is
not the drawing thread, so that the next frame is drawn meanwhile.
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

if TYPE_CHECKING:  # stills need no video library
    import av.filter
    from av.container import OutputContainer
    from av.video.stream import VideoStream

Picture = NDArray[np.uint8]
Writer = Callable[[Path, Iterator[Picture], float], None]
Item = TypeVar("Item")

MOST_WAITING = 2  # maximum number of frames that wait for the encoder
SHEET_PICTURES = 12  # maximum number of frames on a contact sheet
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

_BT709 = 1  # H.273's code of BT.709, for primaries, transfer and matrix
_TV_RANGE = 1  # AVCOL_RANGE_MPEG


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

    rate = Fraction(fps).limit_denominator(65535)
    with av.open(str(path), "w", container_options={"fflags": "+bitexact", **container_options}) as container:
        first = next(images)
        stream = cast("VideoStream", container.add_stream(codec, rate, options=codec_options))
        stream.height, stream.width = first.shape[:2]
        stream.pix_fmt = "yuv420p"
        context = stream.codec_context
        context.thread_count = 1
        context.colorspace = context.color_primaries = context.color_trc = _BT709
        context.color_range = _TV_RANGE

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
            while len(waiting) > MOST_WAITING:
                waiting.popleft().result()
        for done in waiting:
            done.result()


def _write_gif(path: Path, images: Iterator[Picture], fps: float) -> None:
    """Write a GIF with one palette for the whole clip, so that still parts stay still and the file is small. The
    palette is known only at the end, so the frames are stored in a lossless file, not in memory."""
    step = math.ceil(fps / GIF_FPS - 1e-9)
    rate = Fraction(fps).limit_denominator(65535) / step
    waiting = output.sibling(path, ".mkv")
    palette = _store(waiting, (image for index, image in enumerate(images) if index % step == 0), rate)
    _paint(path, waiting, palette, rate)


def _store(path: Path, images: Iterator[Picture], rate: Fraction) -> av.VideoFrame:
    """Write the frames to a lossless file, and return their palette."""
    import av.filter

    first = next(images)
    height, width = first.shape[:2]
    graph = av.filter.Graph()
    branch = graph.add_buffer(width=width, height=height, format=av.VideoFormat("rgb24"), time_base=1 / rate)
    graph.link_nodes(branch, graph.add("palettegen", "stats_mode=full"), graph.add("buffersink")).configure()
    with av.open(str(path), "w", format="matroska") as container:
        stream = container.add_stream("ffv1", rate, options={"level": "3"})
        stream.height, stream.width = height, width
        stream.pix_fmt = "bgr0"
        stream.codec_context.thread_count = 1

        def put(picture: av.VideoFrame | None) -> None:
            graph.vpush(picture)
            container.mux(stream.encode(picture.reformat(format="bgr0", threads=1) if picture else None))

        _in_a_thread(put, chain(_frames(chain([first], images), 1 / rate), [None]))
    return graph.vpull()


def _paint(path: Path, waiting: Path, palette: av.VideoFrame, rate: Fraction) -> None:
    """Convert the stored frames to the palette, one at a time, into a GIF that repeats forever."""
    import av.filter

    with av.open(str(waiting)) as source, av.open(str(path), "w", format="gif") as container:
        stored = source.streams.video[0]
        graph = av.filter.Graph()
        bgr0 = av.VideoFormat("bgr0")
        pictures = graph.add_buffer(width=stored.width, height=stored.height, format=bgr0, time_base=1 / rate)
        colours = graph.add_buffer(width=16, height=16, format=palette.format, time_base=1 / rate)
        reduced = graph.add("paletteuse", "dither=sierra2_4a:diff_mode=rectangle")
        end = graph.add("buffersink")
        pictures.link_to(reduced, 0, 0)
        colours.link_to(reduced, 0, 1)
        reduced.link_to(end)
        graph.configure()
        stream = container.add_stream("gif", rate)
        stream.height, stream.width = stored.height, stored.width
        stream.pix_fmt = "pal8"
        palette.pts, palette.time_base = 0, 1 / rate
        colours.push(palette)
        colours.push(None)
        for index, picture in enumerate(source.decode(stored)):
            picture.pts, picture.time_base = index, 1 / rate
            pictures.push(picture)
            _drain(graph, stream, container)
        pictures.push(None)
        _drain(graph, stream, container)
        container.mux(stream.encode(None))


def _drain(graph: av.filter.Graph, stream: VideoStream, container: OutputContainer) -> None:
    while True:
        try:
            picture = graph.vpull()
        except (BlockingIOError, EOFError):
            return
        container.mux(stream.encode(picture))


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
