"""The text of a BVH file (Biovision hierarchy), to and from numbers; every error names the line.

M. Meredith, S. Maddock, "Motion Capture File Formats Explained", University of Sheffield, 2001. Rotations are intrinsic
Euler angles in degrees, in the order of the channels. As in Blender, position channels of a joint replace its offset.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array

from ...errors import UserError, list_names
from .. import gaps

AXES = "XYZ"
KINDS = tuple(f"{axis}{kind}" for kind in ("position", "rotation") for axis in AXES)
NO_NUMBER = re.compile(r"[+-]?(\d+\.#\w+|nan(\(\w+\))?|inf\w*|null|none|n/?a)", re.IGNORECASE)
MOST_JOINTS = 2000  # most joints of a skeleton; a file with more is damaged


@dataclass(frozen=True)
class Joint:
    """parent: -1 for the root; offset (3,) from the parent; channels in the file's order; end (3,) of the End Site"""

    name: str
    parent: int
    offset: Array
    channels: tuple[str, ...] = ()
    end: Array | None = None


@dataclass(frozen=True)
class Skeleton:
    """Joints, parents first, and their motion: fps [1/s], values (T, channels) in the file's units and degrees."""

    joints: tuple[Joint, ...]
    fps: float
    values: Array

    @property
    def parents(self) -> list[int]:
        return [joint.parent for joint in self.joints]

    @property
    def names(self) -> list[str]:
        return [joint.name for joint in self.joints]

    @cached_property
    def local(self) -> tuple[Array, Array]:
        """Positions (T, J, 3) and rotations (T, J, 4), wxyz, in the parent's axes."""
        count = len(self.values)
        position = np.tile(np.array([joint.offset for joint in self.joints]), (count, 1, 1))
        rotation = np.tile([1.0, 0, 0, 0], (count, len(self.joints), 1))
        column = 0
        for i, joint in enumerate(self.joints):
            for channel in joint.channels:
                axis, value = AXES.index(channel[0]), self.values[:, column]
                column += 1
                if channel.endswith("position"):
                    position[:, i, axis] = value
                else:
                    turn = np.radians(value)[:, None] * np.eye(3)[axis]
                    rotation[:, i] = quat.product(rotation[:, i], quat.from_rotation_vector(turn))
        return position, quat.align_signs(rotation)

    @cached_property
    def world(self) -> tuple[Array, Array]:
        """Positions (T, J, 3) and rotations (T, J, 4) in the file's world."""
        return to_world(self.parents, *self.local)


def to_world(parents: Sequence[int], position: Array, rotation: Array) -> tuple[Array, Array]:
    """Transform positions and rotations from the parents' axes (T, J, ...) to the world's."""
    position, rotation = position.copy(), rotation.copy()
    for i, parent in enumerate(parents):
        if parent >= 0:
            position[:, i] = position[:, parent] + quat.rotate(rotation[:, parent], position[:, i])
            rotation[:, i] = quat.product(rotation[:, parent], rotation[:, i])
    return position, quat.align_signs(quat.normalise(rotation))


def skeleton(joints: Sequence[Joint], place: Array, turn: Array, fps: float) -> Skeleton:
    """Return a skeleton from joints without channels; positions (T, J, 3) and rotations (T, J, 4) in parents' axes."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # gimbal lock: any of the equivalent angles is correct
        angles = Rotation.from_quat(turn.reshape(-1, 4), scalar_first=True).as_euler("ZYX", degrees=True)
    channels = ("Xposition", "Yposition", "Zposition", "Zrotation", "Yrotation", "Xrotation")
    values = np.concatenate([place, angles.reshape(place.shape)], axis=-1)
    return Skeleton(tuple(replace(joint, channels=channels) for joint in joints), fps, values.reshape(len(place), -1))


def fps_of(frame_time: float, digits: int) -> float:
    """Return the rate [1/s] that a rounded frame time of `digits` decimals represents: 120 for 0.0083333."""
    for rate in (round(1 / frame_time), round(1.001 / frame_time) / 1.001):
        if rate > 0 and abs(1 / rate - frame_time) <= 0.6 * 10.0**-digits + 1e-9 * frame_time:
            return float(rate)
    return 1 / frame_time


class _Lines:
    """The non-empty lines, one after the other; every brace counts as a separate line."""

    def __init__(self, path: Path, text: str) -> None:
        self.path, self.number = path, 0
        self.is_ended = text.endswith(("\n", "\r"))
        self._lines = [
            (number, piece)
            for number, line in enumerate(text.splitlines(), 1)
            for piece in map(str.strip, re.split(r"([{}])", line) if "{" in line or "}" in line else [line])
            if piece
        ]
        self._at = 0

    def wrong(self, what: str) -> UserError:
        return UserError(f"{self.path}: line {self.number}: {what}")

    def next(self, wanted: str) -> str:
        if self._at == len(self._lines):
            raise UserError(f"{self.path}: line {self.number}: the file ends where {wanted} should be")
        self.number, line = self._lines[self._at]
        self._at += 1
        return line

    def rest(self) -> Iterator[tuple[int, str]]:
        return iter(self._lines[self._at :])

    def brace(self, which: str, after: str) -> None:
        if (line := self.next(f"'{which}' of {after}")) != which:
            raise self.wrong(f"'{beginning(line)}' where '{which}' of {after} should be")

    def numbers(self, words: list[str], count: int, what: str) -> Array:
        if len(words) != count or not all(map(_is_number, words)):
            raise self.wrong(f"{what} takes {count} number{'s' * (count != 1)}, not '{beginning(' '.join(words))}'")
        return np.array([float(word) for word in words])


def _is_number(word: str) -> bool:
    try:
        return bool(np.isfinite(float(word)))
    except ValueError:
        return False


def beginning(text: str) -> str:
    """Return the beginning of a text."""
    return text if len(text) <= 40 else text[:40] + "..."


def read(path: Path) -> Skeleton:
    """Return the skeleton with its motion; raises UserError that names the line."""
    try:
        text = _text(path.read_bytes())
    except OSError as error:
        raise UserError(f"cannot read '{path}': {error.strerror}") from None
    lines = _Lines(path, text)
    if lines.next("HIERARCHY").upper() != "HIERARCHY":
        raise lines.wrong("a BVH file begins with HIERARCHY")
    joints = _hierarchy(lines)
    width = sum(len(joint.channels) for joint in joints)
    count, fps = _heading(lines)
    return Skeleton(tuple(joints), fps, _finite(lines, joints, _values(lines, count, width)))


def _text(content: bytes) -> str:
    """Return a file's text: UTF-8, or Shift JIS, which programs for MMD write."""
    for encoding in ("utf-8-sig", "cp932"):
        try:
            return content.decode(encoding)
        except UnicodeDecodeError:
            continue
    return content.decode("utf-8-sig", errors="replace")


def _hierarchy(lines: _Lines) -> list[Joint]:
    """Return all joints, up to and including the line MOTION."""
    joints: list[Joint] = []
    inside: list[int] = []
    while True:
        words = lines.next("JOINT, '}' or MOTION").split(maxsplit=1)
        match words[0].upper():
            case "ROOT" | "JOINT" as kind:
                if (kind == "ROOT") != (not joints):
                    raise lines.wrong("a second ROOT; give each its file" if joints else "JOINT before ROOT")
                if kind == "JOINT" and not inside:
                    raise lines.wrong("a JOINT outside the ROOT")
                if len(joints) >= MOST_JOINTS:
                    raise lines.wrong(f"more than {MOST_JOINTS} joints")
                name = words[1].strip() if len(words) > 1 else f"joint{len(joints)}"
                joints.append(_joint(lines, name, inside[-1] if inside else -1))
                inside.append(len(joints) - 1)
            case "END" if inside:
                lines.brace("{", "the End Site")
                end = _offset(lines, lines.next("OFFSET"), "the End Site")
                lines.brace("}", "the End Site")
                joints[inside[-1]] = replace(joints[inside[-1]], end=end)
            case "}" if inside:
                inside.pop()
            case "MOTION" if joints and not inside:
                return joints
            case "MOTION":
                what = f"the joint '{joints[inside[-1]].name}' is not closed" if joints else "there is no ROOT"
                raise lines.wrong(f"MOTION, but {what}")
            case _:
                raise lines.wrong(f"'{beginning(' '.join(words))}' where JOINT, End Site, '}}' or MOTION should be")


def _joint(lines: _Lines, name: str, parent: int) -> Joint:
    """Read the lines before a joint's children: its offset, and its channels if it has any."""
    lines.brace("{", f"'{name}'")
    offset = _offset(lines, lines.next(f"OFFSET of '{name}'"), f"'{name}'")
    words = lines.next(f"CHANNELS of '{name}'").split()
    if words[0].upper() != "CHANNELS":
        raise lines.wrong(f"'{beginning(' '.join(words))}' where CHANNELS of '{name}' should be")
    known = {kind.lower(): kind for kind in KINDS}
    channels = tuple(known.get(word.lower(), "") for word in words[2:])
    if "" in channels:
        raise lines.wrong(f"no channel '{beginning(words[2 + channels.index('')])}'. Channels: {', '.join(KINDS)}")
    if len(words) < 2 or words[1] != str(len(channels)):
        raise lines.wrong(f"CHANNELS {' '.join(words[1:2])} of '{name}' is followed by {len(channels)}")
    moved = [channel for channel in channels if channel.endswith("position")]
    if len(set(moved)) != len(moved):
        raise lines.wrong(f"CHANNELS of '{name}' name a position twice")
    return Joint(name, parent, offset, channels)


def _offset(lines: _Lines, line: str, what: str) -> Array:
    words = line.split()
    if words[0].upper() != "OFFSET":
        raise lines.wrong(f"'{beginning(line)}' where OFFSET of {what} should be")
    return lines.numbers(words[1:], 3, f"OFFSET of {what}")


def _heading(lines: _Lines) -> tuple[int, float]:
    """Return the number of frames, and the rate [1/s]."""
    words = lines.next("Frames").replace(":", " ").split()
    if words[0].lower() != "frames" or len(words) != 2 or not words[1].isdigit():
        raise lines.wrong(f"'{beginning(' '.join(words))}' where 'Frames: N' should be")
    count = int(words[1])
    words = lines.next("Frame Time").replace(":", " ").split()
    if [word.lower() for word in words[:2]] != ["frame", "time"]:
        raise lines.wrong(f"'{beginning(' '.join(words))}' where 'Frame Time: S' should be")
    frame_time = float(lines.numbers(words[2:], 1, "Frame Time")[0])
    if frame_time <= 0:
        raise lines.wrong("Frame Time must be more than nought")
    return count, fps_of(frame_time, len(words[2].partition(".")[2]))


def _values(lines: _Lines, count: int, width: int) -> Array:
    """Return the rest of the file (count, width); raises UserError for any other number of frames or channels."""
    rows: list[list[float]] = []
    last_words: list[str] = []
    for number, line in lines.rest():
        lines.number = number
        if len(rows) == count:
            raise lines.wrong(f"more frames than the {count} of 'Frames:'")
        words = line.split()
        row = [value for word in words if (value := _number(word)) is not None]
        if len(row) < len(words):
            word = next(word for word in words if _number(word) is None)
            raise lines.wrong(f"'{beginning(word)}' is no number")
        if len(row) != width:
            raise lines.wrong(f"{len(row)} numbers for the {width} channels of the joints")
        rows.append(row)
        last_words.append(words[-1])
    if not rows or len(rows) < count:
        raise lines.wrong(f"the file ends after {len(rows)} frames; 'Frames:' declares {count}")
    if not lines.is_ended and all(len(word) > len(last_words[-1]) for word in last_words[:-1]):
        raise lines.wrong(f"the file ends within the number {last_words[-1]}; if it is complete, end its line")
    return np.array(rows)


def _number(word: str) -> float | None:
    """Return the number in a word, nan for one that is not finite; None for other words."""
    try:
        return float(word)
    except ValueError:
        return float("nan") if NO_NUMBER.fullmatch(word) else None


def _finite(lines: _Lines, joints: Sequence[Joint], values: Array) -> Array:
    """Return finite values; samples with missing numbers are marked as gaps. Raises UserError for such samples unless
    gaps are allowed, and for joints without any numbers."""
    values = np.where(np.isfinite(values), values, np.nan)
    bad = np.isnan(values)
    if not bad.any():
        return values
    if not gaps.are_allowed():
        lines.number = [number for number, _ in lines.rest()][int(bad.any(axis=1).argmax())]
        raise lines.wrong("a number that is not finite")
    mended = gaps.bridge(values)
    if mended is None:
        of_column = [joint.name for joint in joints for _ in joint.channels]
        lacking = dict.fromkeys(name for name, column in zip(of_column, bad.T, strict=True) if column.any())
        raise lines.wrong(f"no sample has all numbers; write zeros for joints without numbers: {list_names(lacking)}")
    return mended


def text_of(skeleton: Skeleton) -> str:
    """Return the file's text: offsets and values with six decimals, the frame time to the last digit."""
    lines = ["HIERARCHY"]
    children: dict[int, list[int]] = {}
    for i, parent in enumerate(skeleton.parents):
        children.setdefault(parent, []).append(i)

    def block(index: int, depth: int) -> None:
        joint, indent = skeleton.joints[index], "\t" * depth
        lines.append(f"{indent}{'JOINT' if depth else 'ROOT'} {joint.name}")
        lines.append(f"{indent}{{")
        lines.append(f"{indent}\tOFFSET {_row(joint.offset)}")
        lines.append(f"{indent}\tCHANNELS {len(joint.channels)} {' '.join(joint.channels)}")
        for child in children.get(index, []):
            block(child, depth + 1)
        if joint.end is not None:
            lines.extend(f"{indent}\t{text}" for text in ("End Site", "{", f"\tOFFSET {_row(joint.end)}", "}"))
        lines.append(f"{indent}}}")

    block(0, 0)
    lines += ["MOTION", f"Frames: {len(skeleton.values)}", f"Frame Time: {1 / skeleton.fps!r}"]
    lines += [_row(row) for row in skeleton.values]
    return "\n".join(lines) + "\n"


def _row(values: Array) -> str:
    return " ".join(f"{value:.6f}" for value in np.round(values, 6) + 0.0)
