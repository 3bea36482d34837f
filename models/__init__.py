"""The shipped figures, stages and clips, and functions that locate them.

Everything is read as text through `importlib.resources`, so a checkout, an editable install and a wheel behave alike.
A figure is an MJCF file of this folder and a clip a TOML file in `clips`; `stage.xml` is what surrounds a figure. A
TOML file in `maps` is a bone map of a figure, for retargeting recordings to it. `prior.npz` contains the networks that
predict how people move, see `prior.md`.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from functools import cache
from importlib.resources import as_file, files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

STAGE = "stage"


def _unknown(kind: str, name: str, choices: Iterable[str]) -> KeyError:
    """Return the error for a name that is not shipped; its message lists those that are."""
    names = sorted(choices)
    close = difflib.get_close_matches(name, names, n=1)
    guess = f"; did you mean {close[0]!r}?" if close else "."
    listing = f"{kind.capitalize()}s: {', '.join(names)}" if names else f"No {kind} ships."
    return KeyError(f"no {kind} {name!r}{guess} {listing}")


def figures() -> dict[str, str]:
    """Return the shipped figures.

    Returns:
        Names of figures, each with its description in one line.
    """
    entries = {name: entry for name, entry in _entries(files(__name__), ".xml").items() if name != STAGE}
    return {name: _first_xml_comment(entry.read_text(encoding="utf-8")) for name, entry in entries.items()}


def clips() -> dict[str, str]:
    """Return the shipped clips.

    Returns:
        Names of clips, each with its description in one line.
    """
    entries = _entries(files(__name__) / "clips", ".toml")
    return {name: _first_toml_comment(entry.read_text(encoding="utf-8")) for name, entry in entries.items()}


def figure_text(name: str) -> str:
    """Return the MJCF text of a figure, without floor, light and sky, which belong to the stage; raises KeyError."""
    if name not in figures():
        raise _unknown("figure", name, figures())
    return (files(__name__) / f"{name}.xml").read_text(encoding="utf-8")


def clip_text(name: str) -> str:
    """Return the TOML text of a clip; raises KeyError."""
    if name not in clips():
        raise _unknown("clip", name, clips())
    return (files(__name__) / "clips" / f"{name}.toml").read_text(encoding="utf-8")


def maps() -> dict[str, str]:
    """Return the names of the shipped bone maps, each with its description."""
    entries = _entries(files(__name__) / "maps", ".toml")
    return {name: _first_toml_comment(entry.read_text(encoding="utf-8")) for name, entry in entries.items()}


def map_file(name: str) -> Path:
    """Return the TOML file of a bone map; raises KeyError."""
    if name not in maps():
        raise _unknown("map", name, maps())
    return Path(str(files(__name__) / "maps" / f"{name}.toml"))


def stage_text() -> str:
    """The MJCF text of the stage: sky, floor, lights and the quality of the picture."""
    return (files(__name__) / f"{STAGE}.xml").read_text(encoding="utf-8")


@cache
def prior() -> tuple[dict[str, np.ndarray], ...]:
    """Return the arrays of every network of `prior.npz` by name.

    Rows of matrices are integers of 8 bits in the file, each with a scale.
    """
    import numpy as np  # only here, because the commands that need no network start faster without

    networks: dict[str, dict[str, np.ndarray]] = {}
    with as_file(files(__name__) / "prior.npz") as path, np.load(path) as arrays:
        for key in [key for key in arrays.files if not key.endswith(".scale")]:
            network, _, name = key.partition(".")
            scale = arrays[f"{key}.scale"][:, None] if f"{key}.scale" in arrays.files else 1.0
            networks.setdefault(network, {})[name] = arrays[key] * scale
    return tuple(networks.values())


def _entries(folder: Traversable, suffix: str) -> dict[str, Traversable]:
    """The files of a folder that end in `suffix`, by their name without it, in order; none if there is no folder."""
    if not folder.is_dir():
        return {}
    chosen = sorted((entry for entry in folder.iterdir() if entry.name.endswith(suffix)), key=lambda entry: entry.name)
    return {entry.name.removesuffix(suffix): entry for entry in chosen}


def _first_xml_comment(text: str) -> str:
    opening = re.search(r"<!--\s*(.*?)\s*(?:\n|-->)", text)
    return opening.group(1) if opening else ""


def _first_toml_comment(text: str) -> str:
    lines = (line.strip() for line in text.splitlines())
    return next((line.lstrip("# ") for line in lines if line.startswith("#")), "")
