"""Maps from roles to bodies of a figure and joints of recordings: the map in use, files written, and shipped ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path

from dynsplines import models

from ...clip.text import written
from ...errors import UserError
from .roles import NEEDED, ROLES

HEADING = '# Bone map, by role: a body of the figure, a joint of the recording; "" for none.\n'


@dataclass(frozen=True)
class Map:
    """Bone map: the name of a body of the figure, and of a joint of the recording, by role; "" for none."""

    figure: Mapping[str, str] = field(default_factory=dict)
    recording: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class AppliedMap(Map):
    """A map as it was used, and the names that it may have: bodies of the figure, joints of the recording."""

    bodies: Sequence[str] = ()
    joints: Sequence[str] = ()


_mapping: ContextVar[tuple[Map, list[AppliedMap]] | None] = ContextVar("mapping", default=None)


@contextmanager
def using(chosen: Map) -> Iterator[list[AppliedMap]]:
    """Retarget recordings with a map in this block; yields the maps as they were used."""
    used = list[AppliedMap]()
    before = _mapping.set((chosen, used))
    try:
        yield used
    finally:
        _mapping.reset(before)


def current() -> tuple[Map, list[AppliedMap]]:
    """Return the map to use, and the list to which it is added as it was used."""
    return _mapping.get() or (Map(), [])


def map_of(file: Path | None, *, writes: bool = False) -> Path | None:
    """Return the file of a map, given by its path, or by its name if it ships. Raises UserError if there is neither.

    writes  the map is written to the file, which need not exist
    """
    if writes and file is None:
        raise UserError("--write-map: name the file, --map FILE")
    if writes or file is None or file.exists() or file.suffix or len(file.parts) > 1:
        return file
    try:
        return models.map_file(str(file))
    except models.UnknownName as error:
        raise UserError(f"--map: no file '{file}', and {error}") from None


def text_of(used: AppliedMap) -> str:
    """The file of a map as it was used; roles that were not found are lines to fill in."""
    figure = _table("figure", used.figure, used.recording, used.bodies)
    return f"{HEADING}{figure}\n{_table('recording', used.recording, used.figure, used.joints)}"


def _table(title: str, found: Mapping[str, str], other: Mapping[str, str], names: Sequence[str]) -> str:
    """One table of a map; other, the roles that the other side has."""
    out = f"[{title}]\n" + "".join(f"{line}\n" for line in written(dict(found)).splitlines() if line)
    missing = [role for role in ROLES if role not in found and (role in NEEDED or role in other)]
    if missing:
        unassigned = [name for name in names if name not in found.values()]
        out += f"# Not found by name. Names without a role: {', '.join(unassigned) or 'none'}\n"
        out += "".join(f'# {role} = ""{"  # needed" if role in NEEDED else ""}\n' for role in missing)
    return out
