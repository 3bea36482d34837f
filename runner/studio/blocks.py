"""A clip's text as blocks, each a table with its header. An edit parses one block and leaves the bytes of the others.

Tables inside one of several, such as [keyframe.joints] under a [[keyframe]], are part of its block. tomlkit preserves
comments and order inside a block. It does not parse the whole text, because it would group [[...]] tables that are
separated by others, and because parsing one block of a long clip is fast.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import AoT, InlineTable, Table

from ..errors import UserError
from ..system.quantity import LARGEST
from .document import parse

DIGITS = 5  # decimal places of metres and degrees
DOTTED = ("root", "roots", "joints", "sites", "bodies")  # tables of a keyframe with one entry per line
KEY = r"""(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*')"""
HEADER = re.compile(rf"^[ \t]*(\[\[?)[ \t]*({KEY}(?:[ \t]*\.[ \t]*{KEY})*)[ \t]*(\]\]?)[ \t]*(?:#.*)?$", re.MULTILINE)
ENDING = re.compile(r"(?:^[ \t]*(?:#[^\n]*)?\n?)*\Z", re.MULTILINE)  # empty lines and comments at the end of a block


@dataclass(eq=False)
class TextBlock:
    """A header and the text below it.

    Attributes:
        path: The keys of the header.
        is_row: Whether it is one of several [[...]] tables.
        text: The text, without empty lines and comments at its end, which are `ending`.
        tree: The parsed text, once it is edited.
    """

    path: tuple[str, ...]
    is_row: bool
    text: str
    ending: str = ""
    tree: Any = None

    @property
    def table(self) -> Any:
        """The editable entries."""
        if self.tree is None:
            self.tree = tomlkit.parse(self.text)
        node: Any = self.tree
        for key in self.path:
            node = node[key]
        return node[0] if isinstance(node, AoT) else node

    def write(self) -> str:
        """Return the present text."""
        if self.tree is None:
            return self.text + self.ending
        text = self.tree.as_string()
        return (text if text.endswith("\n") or not text else text + "\n") + self.ending


@dataclass(eq=False)
class Blocks:
    """A whole text: the part before the first header, then block after block."""

    blocks: list[TextBlock] = field(default_factory=list)

    @classmethod
    def of(cls, text: str, where: str) -> Blocks:
        """Return the blocks of a text. Raises UserError for invalid TOML, and for notation that cannot be edited."""
        try:
            entries = parse(text)
        except (RecursionError, ValueError) as error:
            raise UserError(f"{where}: not valid TOML: {error}") from None
        heads: list[tuple[int, tuple[str, ...], bool]] = [(0, (), False)]
        for header in HEADER.finditer(text):
            path = tuple(part.strip("\"'") for part in re.findall(KEY, header[2]))
            is_row, (_, above, in_row) = len(header[1]) == 2, heads[-1]
            if len(header[1]) == len(header[3]) and not (in_row and path[: len(above)] == above != path):
                heads.append((header.start(), path, is_row))
        ends = [start for start, _, _ in heads[1:]] + [len(text)]
        out = cls([_block(path, is_row, text[at:end]) for (at, path, is_row), end in zip(heads, ends, strict=True)])
        out._check(entries, where)
        return out

    def _check(self, entries: Mapping[str, Any], where: str) -> None:
        """Raise UserError if the blocks differ from the parsed text: lines of a list can look like headers."""
        for name in ("keyframe", "contact", "grasp", "penalty"):
            if len(self.rows(name)) != len(entries.get(name, ())):
                raise UserError(f"{where}: '{name}' is written as a list; write [[{name}]] tables to edit it here")
        try:
            whole = all(block.is_row or block.table is not None for block in self.blocks if not block.is_row)
        except (TOMLKitError, KeyError):
            whole = False
        if not whole:
            raise UserError(f"{where}: its tables are written in a way that cannot be edited here")
        for block in self.blocks:
            block.tree = None

    def as_string(self) -> str:
        return "".join(block.write() for block in self.blocks)

    def rows(self, *path: str) -> list[TextBlock]:
        """Return the [[...]] tables of a path."""
        return [block for block in self.blocks if block.is_row and block.path == path]

    def table(self, *path: str, make: bool = False) -> Any:
        """Return the table of a path, under its header or in its parent; else None, or an empty one with `make`."""
        for depth in range(len(path), -1, -1):
            for block in self.blocks:
                if block.is_row or block.path != path[:depth]:
                    continue
                node: Any = block.table
                for key in path[depth:]:
                    node = node.get(key) if node is not None else None
                if node is not None:
                    return node
        if not make:
            return None
        block = _block(path, False, f"[{'.'.join(path)}]\n\n")
        at = next((i for i, block_ in enumerate(self.blocks) if i and block_.path != ("scene",)), len(self.blocks))
        self.insert(at, block)
        return block.table

    def remove_table(self, *path: str) -> None:
        """Remove the table of a path, under its header or in its parent."""
        block = next((block for block in self.blocks if not block.is_row and block.path == path), None)
        if block is None:
            del self.table(*path[:-1])[path[-1]]
        else:
            self.remove(block)

    def insert(self, at: int, block: TextBlock) -> None:
        """Insert a block before another one, with an empty line on either side."""
        before = self.blocks[at - 1] if at else None
        if before is not None and not (text := before.write()).endswith("\n\n") and text:
            before.ending += "\n" if text.endswith("\n") else "\n\n"
        self.blocks.insert(at, block)

    def remove(self, block: TextBlock) -> None:
        """Remove a block, except a comment directly before the next block."""
        at = self.blocks.index(block)
        _, _, remark = ("\n" + block.ending).rpartition("\n\n")
        if at and remark.strip():
            self.blocks[at - 1].ending += remark.lstrip("\n")
        del self.blocks[at]


def _block(path: tuple[str, ...], is_row: bool, text: str) -> TextBlock:
    ending = ENDING.search(text)
    cut = len(text) if ending is None else ending.start()
    return TextBlock(path, is_row, text[:cut], text[cut:])


def row(blocks: Blocks, *at: Any) -> Any:
    """Return one of several tables, by its path and index. Raises UserError for an invalid index."""
    return _row_block(blocks, at).table


def _row_block(blocks: Blocks, at: tuple[Any, ...]) -> TextBlock:
    *path, index = at
    rows = blocks.rows(*path)
    if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(rows):
        raise UserError(f"there is no {path[-1]} {index if not isinstance(index, int) else index + 1} any more")
    return rows[index]


def number(value: Any, what: str) -> float:
    """Return a finite number with few digits. Raises UserError for other values."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise UserError(f"{what}: give a finite number, not {_quote(value)}")
    if abs(value) > LARGEST:
        raise UserError(f"{what}: {value:g} is too large")
    return round(float(value), DIGITS) + 0.0


def _quote(value: Any) -> str:
    return "nothing" if value is None or value == "" else repr(value)[:40]


def item(value: Any) -> Any:
    """Return a value in TOML, with tables on one line."""
    if isinstance(value, Mapping):
        table: InlineTable = tomlkit.inline_table()
        for key, entry in value.items():
            table.append(str(key), item(entry))
        return table
    if isinstance(value, list | tuple):
        out = tomlkit.array()
        for entry in value:
            out.append(item(entry))
        return out
    return number(value, "a number") if isinstance(value, float) else value


def put(table: Any, key: str, value: Any) -> None:
    """Set an entry and preserve its comment."""
    if key in table:
        table[key] = item(value)
    else:
        table.append(key, item(value))


def put_dotted(table: Any, group: str, key: str, value: Any) -> None:
    """Set `group.key`, such as joints.left_hip, on a separate line if it is new."""
    if group in table:
        inner = table[group]
        has_header = isinstance(inner, Table) and not inner.is_super_table()
        if isinstance(inner, InlineTable) or key in inner or has_header:
            put(inner, key, value)
            return
    table.append(tomlkit.key([group, key]), item(value))


def drop_dotted(table: Any, group: str, key: str) -> None:
    """Remove `group.key`, and the group with its last entry."""
    if group not in table or key not in table[group]:
        return
    del table[group][key]
    if not len(table[group]):
        del table[group]


def fill(table: Any, entries: Mapping[str, Any]) -> None:
    """Add the entries of a new table, with those of joints, sites and bodies on separate lines."""
    for key, value in entries.items():
        if key in DOTTED and isinstance(value, Mapping):
            for name, entry in value.items():
                table.append(tomlkit.key([key, str(name)]), item(entry))
        else:
            table.append(key, item(value))


def add(blocks: Blocks, path: tuple[str, ...], entries: Mapping[str, Any], index: int | None = None) -> None:
    """Add a [[...]] table before the one with this index, or after the last one, or before the keyframes."""
    table: Table = tomlkit.table()
    fill(table, entries)
    name = ".".join(item_key(key) for key in path)
    block = TextBlock(path, True, f"[[{name}]]\n{table.as_string()}", "\n")
    rows = blocks.rows(*path)
    if rows and (index is None or index >= len(rows)):
        at = blocks.blocks.index(rows[-1]) + 1
    elif rows:
        at = blocks.blocks.index(rows[index or 0])
    else:
        at = next((i for i, item in enumerate(blocks.blocks) if item.path == ("keyframe",)), len(blocks.blocks))
    blocks.insert(at, block)


def item_key(key: str) -> str:
    """Return a key in the notation of headers."""
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else tomlkit.key(key).as_string()


def remove(blocks: Blocks, *at: Any) -> None:
    """Remove one of several tables, by its path and index."""
    blocks.remove(_row_block(blocks, at))
