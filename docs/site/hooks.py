"""The site's pages are those of docs/: pictures come along, and code that a page links to is named."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File, Files

RENDERS = Path(__file__).parents[2] / "renders"


def on_files(files: Files, config: Any) -> Files:
    """Pictures lie beside docs/, for the README has them too."""
    for picture in sorted(file for file in RENDERS.rglob("*") if file.suffix in (".png", ".webp")):
        place = picture.relative_to(RENDERS.parent).as_posix()
        files.append(File.generated(config, place, abs_src_path=str(picture)))
    return files


def on_page_markdown(markdown: str, **_: Any) -> str:
    """A link out of docs/ becomes the name of the file."""
    markdown = markdown.replace("](../renders/", "](renders/")
    return re.sub(r"\[`?([^\]`]+)`?\]\(\.\./[^)]*\)", r"`\1`", markdown)
