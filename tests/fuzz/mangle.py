"""What becomes of a file on its way: bytes, text, arrays and tables changed at random, again the same for one seed.

Most changes are small, so that what reads the file comes far before it notices; some are coarse.
"""

from __future__ import annotations

import io
import re
import struct
import zipfile
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

Rng = np.random.Generator

TOKEN = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?|[A-Za-z_]\w*|\s+|.", re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
NASTY_NUMBERS = (
    "nan", "inf", "-inf", "0", "-0", "-1", "1e308", "-1e308", "1e-320", "1e9", "1e400", "99999999999999999999",
    "2147483648", "0.1", "1e-9", "3", "0x10", "1_000", "", "1e", "--1", "9" * 400, "1,5", "true", '"1"', "[]", "{}",
    "[1, 2, 3]",
)  # fmt: skip
NASTY_WORDS = (
    "", " ", "a", "x" * 400, "../x", "/etc/passwd", "C:\\x", "naïve", "人", "\u202e", "\0", "\ufeff", "=1+1", "%s%n",
    "None", "free", "rest", "world", "left_knee", "root", "pelvis", "name", "time",
)  # fmt: skip
NASTY_VALUES = (np.nan, np.inf, -np.inf, 0.0, -1.0, 1e308, 1e-320, 1e9, -1e9, 1e5, 2.0**63)
MOST_CHANGES = 4
MOST_BYTES = 64  # that one change of bytes takes, makes or moves
DEEPEST = 2000  # lists in lists


def changes(rng: Rng) -> int:
    """How many changes a file gets; mostly one."""
    return min(int(rng.geometric(0.5)), MOST_CHANGES)


def mangled_bytes(data: bytes, rng: Rng) -> bytes:
    for _ in range(changes(rng)):
        start = int(rng.integers(len(data) + 1))
        stop = min(start + int(rng.integers(1, MOST_BYTES)), len(data))
        other = int(rng.integers(len(data) + 1))
        match int(rng.integers(8)):
            case 0 if data:
                at = min(start, len(data) - 1)
                data = data[:at] + bytes([data[at] ^ (1 << int(rng.integers(8)))]) + data[at + 1 :]
            case 1 if data:
                at = min(start, len(data) - 1)
                data = data[:at] + rng.bytes(1) + data[at + 1 :]
            case 2:
                data = data[:start] + data[stop:]
            case 3:
                data = data[:other] + data[start:stop] + data[other:]
            case 4:
                data = data[:start] + rng.bytes(stop - start) + data[stop:]
            case 5:
                data = data[:start] + bytes(stop - start) + data[stop:]
            case 6:
                data = data[:start]
            case _:
                size = struct.pack("<I", int(rng.choice([0, 1, 255, 2**16, 2**31 - 1, 2**32 - 1])))
                data = data[:start] + size + data[start + 4 :]
    return data


def mangled_text(text: str, rng: Rng) -> bytes:
    """Text of numbers and words, UTF-8; now and then bytes that are none."""
    for _ in range(changes(rng)):
        text = TEXT_CHANGES[int(rng.integers(len(TEXT_CHANGES)))](text, rng)
    data = text.encode("utf-8", "surrogatepass")
    return mangled_bytes(data, rng) if rng.random() < 0.1 else data


def _with_number(text: str, rng: Rng) -> str:
    found = list(NUMBER.finditer(text))
    if not found:
        return text
    one = found[int(rng.integers(len(found)))]
    return text[: one.start()] + str(rng.choice(NASTY_NUMBERS)) + text[one.end() :]


def _moved_number(text: str, rng: Rng) -> str:
    found = list(NUMBER.finditer(text))
    if not found:
        return text
    one = found[int(rng.integers(len(found)))]
    value = float(one[0]) * float(rng.choice([0.5, 0.9, 1.1, 2, -1])) + float(rng.choice([0, 0.01, -0.1, 1]))
    return text[: one.start()] + f"{value:.6g}" + text[one.end() :]


def _other_word(text: str, rng: Rng) -> str:
    found = [one for one in TOKEN.finditer(text) if one[0][0].isalpha() or one[0][0] == "_"]
    if not found:
        return text
    one = found[int(rng.integers(len(found)))]
    other = found[int(rng.integers(len(found)))][0] if rng.random() < 0.6 else str(rng.choice(NASTY_WORDS))
    return text[: one.start()] + other + text[one.end() :]


def _lines(text: str, rng: Rng) -> str:
    """Lines left out, doubled, exchanged."""
    lines = text.splitlines(keepends=True) or [""]
    a, b = sorted(int(rng.integers(len(lines))) for _ in range(2))
    match int(rng.integers(4)):
        case 0:
            del lines[a]
        case 1:
            lines.insert(b, lines[a])
        case 2:
            lines[a], lines[b] = lines[b], lines[a]
        case _:
            lines[a : b + 1] = []
    return "".join(lines)


def _token(text: str, rng: Rng) -> str:
    """Anything at all left out, doubled or exchanged for another piece of the text."""
    found = list(TOKEN.finditer(text))
    if not found:
        return text
    one, other = (found[int(rng.integers(len(found)))] for _ in range(2))
    return text[: one.start()] + str(rng.choice(["", one[0] * 2, other[0]])) + text[one.end() :]


def _letters(text: str, rng: Rng) -> str:
    at = int(rng.integers(len(text) + 1))
    return text[:at] + str(rng.choice(NASTY_WORDS)) + text[at + int(rng.integers(3)) :]


TEXT_CHANGES: tuple[Callable[[str, Rng], str], ...] = (
    _with_number, _with_number, _moved_number, _moved_number, _other_word, _lines, _token, _letters,
)  # fmt: skip


def mangled_arrays(arrays: Mapping[str, Any], rng: Rng) -> bytes:
    """An .npz: arrays of other sizes, kinds and values, text changed as text; now and then bytes of it or in it."""
    entries = {name: np.asarray(value) for name, value in arrays.items()}
    for _ in range(changes(rng)):
        name = str(rng.choice(list(entries))) if entries else "a"
        array = entries.pop(name, np.zeros(0))
        match int(rng.integers(12)):
            case 0:
                continue
            case 1:
                entries[str(rng.choice([*arrays, *NASTY_WORDS[2:10]])).replace("\0", "")] = array
                continue
            case 2:
                array = entries.get(str(rng.choice(list(entries))), array) if entries else array
        entries[name] = _other_array(array, rng)
    whole = _npz(entries, rng)
    return mangled_bytes(whole, rng) if rng.random() < 0.1 else whole


def _other_array(array: Any, rng: Rng) -> Any:
    kind = array.dtype.kind
    if kind in "US" and array.size and rng.random() < 0.7:
        texts = array.astype(str).ravel().tolist()
        at = int(rng.integers(len(texts)))
        texts[at] = mangled_text(texts[at], rng).decode("utf-8", "replace")
        return np.array(texts).reshape(array.shape)
    match int(rng.integers(10)):
        case 0 | 1 | 2 if kind == "f" and array.size:
            array = np.array(array)
            array.flat[int(rng.integers(array.size))] = float(rng.choice(NASTY_VALUES))
        case 3 if array.ndim and len(array):
            array = array[: int(rng.integers(len(array)))]
        case 4 if array.ndim and len(array):
            array = np.concatenate([array, array[-1:]])
        case 5:
            array = array.T if array.ndim > 1 else array[None]
        case 6 if kind in "fiub":
            array = _as_kind(array, str(rng.choice(["f4", "i8", "u1", "c16", "U", "S", "?", "f2", ">f8", "M8[s]"])))
        case 7:
            array = np.asarray(rng.choice([0, 1, -1, 10**12]) if rng.random() < 0.5 else rng.choice(NASTY_VALUES))
        case 8 if kind in "fiub" and array.size:
            array = array * rng.choice([0.0, -1.0, 1e3, 1e-9, 1.001])
        case _:
            array = np.zeros(rng.integers(0, 4, size=int(rng.integers(4))))
    return array


def _as_kind(array: Any, kind: str) -> Any:
    with np.errstate(all="ignore"):
        return array.astype("i8").astype(kind) if kind == "M8[s]" else array.astype(kind)


def _npz(entries: Mapping[str, Any], rng: Rng) -> bytes:
    stream = io.BytesIO()
    damaged = str(rng.choice(list(entries))) if entries and rng.random() < 0.15 else None
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED if rng.random() < 0.3 else zipfile.ZIP_STORED) as archive:
        for name, array in entries.items():
            inside = io.BytesIO()
            np.lib.format.write_array(inside, np.asarray(array), allow_pickle=True)
            data = inside.getvalue()
            if name == damaged:  # with the sums that belong to it
                head = mangled_bytes(data[:128], rng)
                data = head + data[128:] if rng.random() < 0.7 else mangled_bytes(data, rng)
            archive.writestr(f"{name}.npy", data)
    return stream.getvalue()


def mangled_tree(value: Any, rng: Rng) -> Any:
    """Numbers, words, lists and tables, as JSON and pickles hold them, some exchanged for others."""
    for _ in range(changes(rng)):
        value = _other_branch(value, rng, 0)
    return value


def _other_branch(value: Any, rng: Rng, depth: int) -> Any:
    """One branch of it changed; down from the root by chance."""
    if isinstance(value, dict) and value and rng.random() < 0.9:
        key = list(value)[int(rng.integers(len(value)))]
        if rng.random() < 0.1:
            return {name: each for name, each in value.items() if name != key}
        return {**value, key: _other_branch(value[key], rng, depth + 1)}
    if isinstance(value, list) and value and rng.random() < 0.85:
        at = int(rng.integers(len(value)))
        if rng.random() < 0.15:
            return value[:at] if rng.random() < 0.5 else [*value, value[at]]
        return [*value[:at], _other_branch(value[at], rng, depth + 1), *value[at + 1 :]]
    return _instead(value, rng)


def _instead(value: Any, rng: Rng) -> Any:
    match int(rng.integers(8)):
        case 0 if isinstance(value, int | float) and abs(value) < 1e300:
            return float(value) * 1.1 + 0.01
        case 1:
            return float(rng.choice(NASTY_VALUES))
        case 2:
            return str(rng.choice(NASTY_WORDS))
        case 3:
            return None
        case 4:
            return [value, value]
        case 5:
            return {"a": value}
        case 6:
            return 10 ** int(rng.integers(1, 400))
        case _:
            deep: Any = value
            for _ in range(int(rng.choice([1, 3, DEEPEST]))):
                deep = [deep]
            return deep
