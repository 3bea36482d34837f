"""Video frames into a video, an animated GIF or a contact sheet; the ending of the target selects which.

Images stream through: the clip is never in memory. A file appears under its name only when it is complete. Video is
converted to and tagged as BT.709, so that players show the colours that were drawn, and encoded by one thread, so that
equal images give equal bytes; not by the thread that draws, so that the next image is drawn meanwhile.
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
from ..system.output import Replacement, beside, real_target

if TYPE_CHECKING:  # stills need no video library
    import av.filter
    from av.container import OutputContainer
    from av.video.stream import VideoStream

Picture = NDArray[np.uint8]
Writer = Callable[[Path, Iterator[Picture], float], None]
Item = TypeVar("Item")

MOST_WAITING = 2  # images drawn and not yet encoded
SHEET_PICTURES = 12
SHEET_TILE = 480  # [pixels] of a contact sheet's images
SHEET_MARGIN = 8  # [pixels] between them
GIF_FPS = 50  # browsers slow a GIF down when its images are shorter than 0.02 s

_BT709 = 1  # the number that H.273 gives to BT.709, for primaries, transfer and matrix alike
_TV_RANGE = 1  # AVCOL_RANGE_MPEG


class FilmError(UserError):
    """The target or the frames cannot become a film; the message is one line with the remedy."""


def check_target(path: str | os.PathLike[str], width: int, height: int) -> None:
    """Raise a FilmError if `write` could not write images of this size [pixels] there; writes nothing itself."""
    target = Path(path)
    if target.suffix.lower() not in _WRITERS:
        raise FilmError(f"{target}: no way to write '{target.suffix}'; endings: {', '.join(_WRITERS)}")
    if target.is_dir():
        raise FilmError(f"{target}: is a directory; name a file in it, such as {target / ('clip' + target.suffix)}")
    try:
        parent = real_target(target).parent
    except UserError as error:
        raise FilmError(str(error)) from None
    if not parent.is_dir():
        raise FilmError(f"{target}: the directory {parent} does not exist; create it or name another")
    if not os.access(parent, os.W_OK | os.X_OK):
        raise FilmError(f"{target}: the directory {parent} cannot be written to; name another")
    _check_size(target, width, height)


def write(path: str | os.PathLike[str], images: Iterable[Picture], fps: float) -> None:
    """Write the images to a file of the kind its ending names: .mp4, .webm, .gif, or .png for a contact sheet.

    images  each (H, W, 3), all of one size
    fps     images a second

    On failure, an existing file is unchanged and no temporary file remains.
    """
    if not (math.isfinite(fps) and fps > 0):
        raise FilmError(f"{path}: {fps} images a second; it must be a positive number")
    source = iter(images)
    first = next(source, None)
    if first is None:
        raise FilmError(f"{path}: there are no images to write")
    _check_image(Path(path), first, first.shape)
    check_target(path, first.shape[1], first.shape[0])
    target = Path(path)
    checked = _checked(target, chain([first], source), first.shape)
    with Replacement(target) as partial:
        _WRITERS[target.suffix.lower()](partial, checked, fps)


def _check_size(target: Path, width: int, height: int) -> None:
    if width < 1 or height < 1:
        raise FilmError(f"{target}: {width}x{height} pixels; both must be at least 1")
    if target.suffix.lower() in (".mp4", ".webm") and (width % 2 or height % 2):
        even = f"{width + width % 2}x{height + height % 2}"
        raise FilmError(
            f"{target}: {width}x{height} pixels; {target.suffix} needs even sizes: take {even}, or write .gif"
        )


def _check_image(target: Path, image: Picture, shape: tuple[int, ...]) -> None:
    if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3:
        raise FilmError(f"{target}: an image is (H, W, 3) of uint8, not {image.shape} of {image.dtype}")
    if image.shape != shape:
        raise FilmError(f"{target}: images change size from {shape[1]}x{shape[0]} to {image.shape[1]}x{image.shape[0]}")


def _checked(target: Path, images: Iterable[Picture], shape: tuple[int, ...]) -> Iterator[Picture]:
    for image in images:
        _check_image(target, image, shape)
        yield np.ascontiguousarray(image)


def _write_mp4(path: Path, images: Iterator[Picture], fps: float) -> None:
    """H.264; the index stands at the front of the file, so a browser starts before it has all of it.

    Without x264's macroblock tree: at widths such as 848 or 960 pixels its assembly reads uninitialised memory, and
    equal images give other bytes. The tree would spare 3 to 10 % of a file of this quality.
    """
    codec = {"preset": "medium", "crf": "20", "mbtree": "0"}
    _encode(path, images, fps, "libx264", codec, {"movflags": "+faststart"})


def _write_webm(path: Path, images: Iterator[Picture], fps: float) -> None:
    """VP9 of constant quality."""
    codec = {"crf": "24", "b:v": "0", "deadline": "good", "cpu-used": "4", "row-mt": "0"}
    _encode(path, images, fps, "libvpx-vp9", codec, {})


def _encode(
    path: Path,
    images: Iterator[Picture],
    fps: float,
    codec: str,
    codec_options: dict[str, str],
    container_options: dict[str, str],
) -> None:
    """Encode as yuv420p, BT.709 throughout."""
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
    """The frames with their times, as copies, so that a renderer may reuse its buffer."""
    import av

    for index, image in enumerate(images):
        picture = av.VideoFrame.from_ndarray(image, format="rgb24")
        picture.pts, picture.time_base = index, tick
        yield picture


def _in_a_thread(work: Callable[[Item], None], items: Iterable[Item]) -> None:
    """`work` on one item after the other while the next ones are made; an error of either ends both."""
    with ThreadPoolExecutor(1, "encoder") as thread:
        waiting: deque[Future[None]] = deque()
        for item in items:
            waiting.append(thread.submit(work, item))
            while len(waiting) > MOST_WAITING:
                waiting.popleft().result()
        for done in waiting:
            done.result()


def _write_gif(path: Path, images: Iterator[Picture], fps: float) -> None:
    """A GIF with the one palette that suits the whole clip: still parts stay still, and the file stays small.

    The palette is known only at the end, so the images wait in a lossless file, not in memory.
    """
    step = math.ceil(fps / GIF_FPS - 1e-9)
    rate = Fraction(fps).limit_denominator(65535) / step
    waiting = beside(path, ".mkv")
    palette = _store(waiting, (image for index, image in enumerate(images) if index % step == 0), rate)
    _paint(path, waiting, palette, rate)


def _store(path: Path, images: Iterator[Picture], rate: Fraction) -> av.VideoFrame:
    """Put the images into a lossless file; return the palette they share."""
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
    """Reduce the waiting images to the palette, one at a time, into a GIF that repeats for ever."""
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
    """Encode every picture that the filters have ready."""
    while True:
        try:
            picture = graph.vpull()
        except (BlockingIOError, EOFError):
            return
        container.mux(stream.encode(picture))


def _write_sheet(path: Path, images: Iterator[Picture], fps: float) -> None:
    """A contact sheet; a single image is written as it is."""
    first = next(images)
    second = next(images, None)
    sheet = first if second is None else _grid([_tile(image) for image in chain([first, second], images)])
    iio.imwrite(path, sheet, extension=".png")


def sheet_picks(count: int) -> list[int]:
    """The indices of the frames on a contact sheet: up to twelve, evenly spaced, with the first and the last."""
    return np.linspace(0, count - 1, min(count, SHEET_PICTURES)).round().astype(int).tolist()


def _tile(image: Picture) -> Picture:
    """The image no larger than a tile of the sheet."""
    height, width = image.shape[:2]
    scale = SHEET_TILE / max(height, width)
    if scale >= 1:
        return image
    size = max(1, round(width * scale)), max(1, round(height * scale))
    if (width, height) == (2 * size[0], 2 * size[1]):  # as `show.for_tiles` has it drawn: quicker, and as smooth
        return np.asarray(Image.fromarray(image).reduce(2))
    return np.asarray(Image.fromarray(image).resize(size, Image.Resampling.LANCZOS))


def _grid(tiles: list[Picture]) -> Picture:
    """The tiles, in reading order, on white; columns such that the sheet is about as wide as a screen."""
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
    """The deviation of a grid from 16:9, with a penalty for empty places."""
    rows = math.ceil(count / columns)
    return abs(math.log(columns * aspect / rows / (16 / 9))) + 0.25 * (rows * columns - count)


_WRITERS: dict[str, Writer] = {".mp4": _write_mp4, ".webm": _write_webm, ".gif": _write_gif, ".png": _write_sheet}
