"""Limit on the memory that a file may need: a small untrusted file can request all of the memory.

The arrays of an .npz are checked by their headers, before any array is read. The memory of an MJCF model is estimated
from its text, before MuJoCo reads it: a line can request a million copies or a height field of gigabytes, and MuJoCo
allocates them without limit. Its elements are counted, times their replications and attachments, and the numbers that
define sizes. The result is an upper bound for usual models, not a guarantee. Copies have a higher weight, because
MuJoCo's time grows with their square.
"""

from __future__ import annotations

import html
import math
import os
import re
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

from ..errors import UserError

VARIABLE = "DYNSPLINES_LARGEST"
USUAL = 1000  # [MB] default limit; ten minutes of a hundred joints at 120 Hz need 60 MB per array
MEGABYTE = 1_000_000
ELEMENT = 10_000  # [bytes] of a body, geom or joint, including its text
COPIED = 50_000  # [bytes] of a replicated element; MuJoCo takes 15 s for 20,000 of them
HEIGHT = 16  # [bytes] of a point of a height field
PIXEL = 6  # [bytes] of a pixel of a texture
NUMBER = 8  # [bytes] of a number
KEY_NUMBERS = 2  # numbers per keyframe and element; humanoids need 1, free bodies 9
CUBE = 6  # sides of a cube texture
PNG = b"\x89PNG\r\n\x1a\n"

SKIPPED = {"<!--": "-->", "<![CDATA[": "]]>", "<?": "?>", "<!": ">"}
TAG = re.compile(r"<(/?)([^\s/<>\"'=]+)((?:\"[^\"]*\"|'[^']*'|[^<>\"'])*+)>")
ATTRIBUTE = re.compile(r"([\w:.-]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
LEADING = re.compile(r"\s*([-+]?[0-9]*\.?[0-9]*(?:[eE][-+]?[0-9]{1,3})?)\s*([KMGTPE]?)")
UNITS = {"": 0, "K": 10, "M": 20, "G": 30, "T": 40, "P": 50, "E": 60}


def bound() -> int:
    """Return the limit in bytes, by default or from the environment. Raises UserError if that is not a number of MB."""
    setting = os.environ.get(VARIABLE, "").strip()
    if not setting:
        return USUAL * MEGABYTE
    if not (setting.isascii() and setting.isdigit() and 0 < len(setting) <= 9 and int(setting)):
        raise UserError(f"{VARIABLE}={setting}: give a number of MB, such as {4 * USUAL}")
    return int(setting) * MEGABYTE


def check(where: object, size: float, what: str) -> None:
    """Raise UserError if `what` would need more bytes than the limit."""
    most = bound()
    if size > most:
        raise UserError(
            f"{where}: {what} comes to {size / MEGABYTE:,.0f} MB in memory, over {most // MEGABYTE:,} MB; "
            f"if you trust it, set {VARIABLE} to more MB"
        )


def check_file(source: Path) -> None:
    """Raise UserError for a folder, a missing file, and a file above the limit."""
    if not source.is_file():
        raise UserError(f"'{source}' is a folder, not a file" if source.is_dir() else f"no file '{source}'")
    check(source, source.stat().st_size, "it")


def check_archive(stream: IO[bytes], where: Path) -> None:
    """Raise UserError for arrays that are too large together, or larger than their data in the archive.

    A damaged archive may raise any exception. The stream is reset to its beginning.
    """
    with zipfile.ZipFile(stream) as archive:
        members = archive.infolist()
        check(where, sum(member.file_size for member in members), "what it holds")
        for member in members:
            with archive.open(member) as content:
                claimed = _claimed(content)
            if claimed > member.file_size:
                raise UserError(f"{where}: '{member.filename}' does not have the size in its header; it is damaged")
    stream.seek(0)


def _claimed(content: IO[bytes]) -> int:
    """Return the bytes that an array's header requests; 0 for other content, which its reader reports."""
    import numpy as np  # imported here because other limits do not need it

    heads = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
    try:
        head: Any = heads.get(np.lib.format.read_magic(content))
        shape, _, kind = head(content) if head else ((0,), False, np.dtype("u1"))
    except ValueError:
        return 0
    return math.prod(shape) * max(kind.itemsize, 1)


def check_mjcf(text: str, where: object, folder: Path | None = None, assets: Mapping[str, bytes] | None = None) -> None:
    """Raise UserError for a model that would be too large; `folder` and `assets` are where MuJoCo would find files."""
    counted = _Count(folder, assets or {})
    size = counted.model(text, "")
    check(where, size + counted.keys * NUMBER * KEY_NUMBERS * size / ELEMENT, "the model that it describes")


def check_mjcf_file(path: Path) -> None:
    """Check a model's file in the same way. An unreadable one is left to the reader."""
    try:
        check(path, path.stat().st_size, "it")
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return
    check_mjcf(text, path, path.parent)


@dataclass
class _Count:
    """The bytes of models by file, and the number of keyframes; `open` are files being counted, to end recursion."""

    folder: Path | None
    assets: Mapping[str, bytes]
    keys: float = 0.0
    sizes: dict[str, float] = field(default_factory=dict)
    open: set[str] = field(default_factory=set)

    def model(self, text: str, name: str) -> float:
        """Return the bytes of a model or of an included part."""
        self.open.add(name)
        total, attached, attachable, factors = 0.0, 0.0, 0.0, [1.0]
        for tag, attributes, closes, empty in _tags(text):
            if closes:
                factors = factors[:-1] or [1.0]
                continue
            factor, copies = factors[-1], 1.0
            if tag == "replicate":
                copies = max(_number(attributes.get("count", "")), 1.0)
            total += factor * ((COPIED if factor > 1 else ELEMENT) + self._extra_bytes(tag, attributes))
            if tag == "include":
                total += factor * self._file(attributes.get("file", ""))
            elif tag == "model":
                attachable += self._file(attributes.get("file", ""))
            elif tag == "attach":
                attached += factor
            if not empty:
                factors.append(factor * copies)
        self.open.discard(name)
        return total + attached * attachable

    def _file(self, name: str) -> float:
        if name not in self.sizes and name not in self.open:
            data = self._read(name)
            self.sizes[name] = 0.0 if data is None else self.model(data.decode("utf-8", errors="replace"), name)
        return self.sizes.get(name, 0.0)

    def _read(self, name: str, most: int = -1) -> bytes | None:
        if name in self.assets:
            return self.assets[name]
        if self.folder is None or not name:
            return None
        try:
            with (self.folder / name).open("rb") as stream:
                return stream.read(most)
        except (OSError, ValueError):
            return None

    def _extra_bytes(self, tag: str, attributes: Mapping[str, str]) -> float:
        """Return the bytes of an element in addition to ELEMENT."""
        number = {name: _number(value) for name, value in attributes.items()}
        match tag:
            case "hfield":
                return HEIGHT * max(number.get("nrow", 0) * number.get("ncol", 0), self._pixels(attributes))
            case "texture":
                sides = CUBE if attributes.get("type", "cube") != "2d" else 1
                width, height = number.get("width", 0), number.get("height", 0)
                return PIXEL * max(sides * width * max(height, width if sides > 1 else 0), self._pixels(attributes))
            case "composite" | "flexcomp":
                return 4 * COPIED * math.prod(max(1.0, _number(part)) for part in attributes.get("count", "").split())
            case "size":
                self.keys += number.get("nkey", 0)
                users = sum(value for name, value in number.items() if name.startswith("nuser_"))
                stack = number.get("nstack", 0) + number.get("nuserdata", 0) + number.get("njmax", 0)
                return number.get("memory", 0) + NUMBER * (stack + users * ELEMENT)
            case "key":
                self.keys += 1
            case "numeric":
                return NUMBER * number.get("size", 0)
            case "mesh":
                finest = max([0.0, *map(_number, attributes.get("params", "").split())])
                return ELEMENT * finest**2 if "builtin" in attributes else 0.0
        return NUMBER * (number.get("dim", 0) + 2 * number.get("nsample", 0))

    def _pixels(self, attributes: Mapping[str, str]) -> float:
        head = self._read(attributes.get("file", ""), 24) or b""
        if head[:8] != PNG:
            return 0.0
        return float(int.from_bytes(head[16:20]) * int.from_bytes(head[20:24]))


def _tags(text: str) -> Iterator[tuple[str, dict[str, str], bool, bool]]:
    """Yield name, attributes, closing and empty flags of tags up to the first invalid one, where MuJoCo stops too."""
    place = text.find("<")
    while place >= 0:
        skipped = next((end for begin, end in SKIPPED.items() if text.startswith(begin, place)), None)
        if skipped is not None:
            place = text.find(skipped, place)
        else:
            match = TAG.match(text, place)
            if match is None:
                return
            closes, tag, inside = match.groups()
            yield tag, attributes_in(inside), bool(closes), inside.endswith("/")
            place = match.end()
        if place >= 0:
            place = text.find("<", place)


def attributes_in(tag: str) -> dict[str, str]:
    """Return the attributes in the text of a tag."""
    return {name: html.unescape(a or b) for name, a, b in ATTRIBUTE.findall(tag)}


def _number(text: str) -> float:
    """Return the number at the beginning of a text, with its unit of bytes; 0 if there is none."""
    match = LEADING.match(text)
    try:
        return max(0.0, float(match[1])) * 2.0 ** UNITS[match[2]] if match else 0.0
    except ValueError:
        return 0.0
