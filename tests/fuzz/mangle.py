"""What becomes of a file on its way: bytes, text, arrays and tables changed at random, again the same for one seed.

Most changes are small, so that what reads the file comes far before it notices; some are coarse.
"""

import io
import re
import struct
import zipfile
from collections.abc import Mapping
from typing import Any

import numpy as np

Rng = np.random.Generator

NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
WORD = re.compile(r"[A-Za-z_]\w*")
LINES = re.compile(r"(?:[^\n]*\n){1,4}")
TOKEN = re.compile(rf"{NUMBER.pattern}|{WORD.pattern}|\s+|.", re.DOTALL)
PIECES = (NUMBER, NUMBER, NUMBER, WORD, LINES, TOKEN)
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
    """Bytes flipped, left out, doubled, exchanged for others or for a size, or cut off."""
    for _ in range(changes(rng)):
        start, other = (int(rng.integers(len(data) + 1)) for _ in range(2))
        stop = min(start + int(rng.integers(1, MOST_BYTES)), len(data))
        piece, size = data[start:stop], struct.pack("<I", int(rng.choice([0, 1, 255, 2**16, 2**31 - 1, 2**32 - 1])))
        flipped = bytes(each ^ (1 << int(rng.integers(8))) for each in data[start : start + 1])
        data = (
            data[:start] + flipped + data[start + 1 :],
            data[:start] + data[stop:],
            data[:other] + piece + data[other:],
            data[:start] + rng.bytes(len(piece)) + data[stop:],
            data[:start] + bytes(len(piece)) + data[stop:],
            data[:start] + size + data[start + 4 :],
            data[:start],
        )[int(rng.integers(7))]
    return data


def mangled_text(text: str, rng: Rng) -> bytes:
    """Text of numbers and words, UTF-8; now and then bytes that are none."""
    for _ in range(changes(rng)):
        text = _other_text(text, rng)
    data = text.encode("utf-8", "surrogatepass")
    return mangled_bytes(data, rng) if rng.random() < 0.1 else data


def _other_text(text: str, rng: Rng) -> str:
    """A number, a word, lines or anything at all left out, doubled, or exchanged for another or an odd one."""
    pattern = PIECES[int(rng.integers(len(PIECES)))]
    pieces = list(pattern.finditer(text))
    if not pieces:
        return text
    one, other = (pieces[int(rng.integers(len(pieces)))] for _ in range(2))
    new = ["", one[0] * 2, other[0], str(rng.choice(NASTY_WORDS))]
    if pattern is NUMBER:
        near = float(one[0]) * float(rng.choice([0.5, 0.9, 1.1, 2, -1])) + float(rng.choice([0, 0.01, -0.1, 1]))
        new = [str(rng.choice(NASTY_NUMBERS)), f"{near:.6g}"]
    return text[: one.start()] + new[int(rng.integers(len(new)))] + text[one.end() :]


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
    """An array with another value, size, shape or kind; zeros of any shape where that cannot be."""
    kinds = ("f4", "i8", "u1", "c16", "U", "S", "?", "f2", ">f8", "M8[s]")
    make = (
        lambda: _with_other_value(array, rng),
        lambda: _with_other_value(array, rng),
        lambda: _with_other_value(array, rng),
        lambda: array[: int(rng.integers(len(array)))],
        lambda: np.concatenate([array, array[-1:]]),
        lambda: array.T if array.ndim > 1 else array[None],
        lambda: array.real.astype(str(rng.choice(kinds))),
        lambda: np.asarray(rng.choice([*NASTY_VALUES, 10**12])),
        lambda: array * rng.choice([0.0, -1.0, 1e3, 1e-9, 1.001]),
    )[int(rng.integers(9))]
    try:
        with np.errstate(all="ignore"):
            return make()
    except (TypeError, ValueError, IndexError, OverflowError):
        return np.zeros(rng.integers(0, 4, size=int(rng.integers(4))))


def _with_other_value(array: Any, rng: Rng) -> Any:
    """A text in it changed as text, a number exchanged."""
    values = array.astype(str).ravel().tolist() if array.dtype.kind in "US" else array.ravel().copy()
    at = int(rng.integers(len(values)))
    is_text = isinstance(values, list)
    values[at] = mangled_text(values[at], rng).decode("utf-8", "replace") if is_text else rng.choice(NASTY_VALUES)
    return np.array(values).reshape(array.shape)


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
    near = 1.1 * value + 0.01 if isinstance(value, int | float) and abs(value) < 1e300 else 0
    deep: Any = value
    for _ in range(int(rng.choice([1, 3, DEEPEST]))):
        deep = [deep]
    odd = (float(rng.choice(NASTY_VALUES)), str(rng.choice(NASTY_WORDS)), 10 ** int(rng.integers(1, 400)))
    return (near, *odd, None, [value, value], {"a": value}, deep)[int(rng.integers(8))]
