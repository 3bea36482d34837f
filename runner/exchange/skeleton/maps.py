"""Bone maps from roles to a figure's bodies and a recording's joints: the current one, files, and shipped ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path

from dynsplines import models

from ...clip.table import MapTable
from ...clip.text import written
from ...errors import UserError
from ...scene.roles import NEEDED, ROLES

HEADING = '# Bone map, by role: a body of the figure, a joint of the recording; "" for none.\n'


@dataclass(frozen=True)
class AppliedMap:
    """A map as applied, by role, with all names that it may contain: bodies of the figure, joints of the recording."""

    figure: Mapping[str, str]
    recording: Mapping[str, str]
    bodies: Sequence[str]
    joints: Sequence[str]


_mapping: ContextVar[tuple[MapTable, list[AppliedMap]] | None] = ContextVar("mapping", default=None)


@contextmanager
def using(chosen: MapTable) -> Iterator[list[AppliedMap]]:
    """Retarget recordings with a map in this block; yields the maps as applied."""
    used = list[AppliedMap]()
    before = _mapping.set((chosen, used))
    try:
        yield used
    finally:
        _mapping.reset(before)


def current() -> tuple[MapTable, list[AppliedMap]]:
    """Return the current map, and the list that collects maps as applied."""
    return _mapping.get() or (MapTable(), [])


def map_of(file: Path | None, *, writes: bool = False) -> Path | None:
    """Return the file of a map, from its path or the name of a shipped one; raises UserError if there is neither.

    writes  whether the map is to be written to the file, which need not exist
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
    """Return the file of a map as applied; roles without a name are lines to fill in."""
    figure = _table("figure", used.figure, used.recording, used.bodies)
    return f"{HEADING}{figure}\n{_table('recording', used.recording, used.figure, used.joints)}"


def _table(title: str, found: Mapping[str, str], other: Mapping[str, str], names: Sequence[str]) -> str:
    out = f"[{title}]\n" + "".join(f"{line}\n" for line in written(dict(found)).splitlines() if line)
    missing = [role for role in ROLES if role not in found and (role in NEEDED or role in other)]
    if missing:
        unassigned = [name for name in names if name not in found.values()]
        out += f"# Not found by name. Names without a role: {', '.join(unassigned) or 'none'}\n"
        out += "".join(f'# {role} = ""{"  # needed" if role in NEEDED else ""}\n' for role in missing)
    return out
