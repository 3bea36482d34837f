"""The memory that an MJCF model needs, estimated from its text before MuJoCo reads it.

A line can request a million copies or a height field of gigabytes, and MuJoCo allocates them without limit. This module
counts elements, times their replications and attachments, and the numbers that define sizes. The result is an upper
bound for usual models, not a guarantee. Copies have a higher weight, because MuJoCo's time grows with their square.
"""

from __future__ import annotations

import html
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..system import size_limit

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


def check(text: str, where: object, folder: Path | None = None, assets: Mapping[str, bytes] | None = None) -> None:
    """Raise UserError for a model that would be too large; `folder` and `assets` are where MuJoCo would find files."""
    counted = _Count(folder, assets or {})
    size = counted.model(text, "")
    size_limit.check(where, size + counted.keys * NUMBER * KEY_NUMBERS * size / ELEMENT, "the model that it describes")


def check_file(path: Path) -> None:
    """Check a file in the same way. An unreadable one is left to the reader."""
    try:
        size_limit.check(path, path.stat().st_size, "it")
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return
    check(text, path, path.parent)


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
