"""Hooks of the site: pictures beside docs/, links to code, and the package as the reference's generator reads it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File, Files

ROOT = Path(__file__).parents[2]
RENDERS = ROOT / "renders"
PACKAGE = ROOT / "build" / "site_package" / "dynsplines"  # the site_package of mkdocs.yml


def on_startup(**_: Any) -> None:
    """Copy the modules of the repository into the package that pyproject.toml makes of its folders."""
    shutil.rmtree(PACKAGE, ignore_errors=True)
    for folder, place in (("runner", "."), ("models", "models"), ("solver", "solver")):
        for module in (ROOT / folder).rglob("*.py"):
            target = PACKAGE / place / module.relative_to(ROOT / folder)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(module, target)


def on_files(files: Files, config: Any) -> Files:
    """Add the pictures of renders/, which the README shares with the pages."""
    for picture in sorted(file for file in RENDERS.rglob("*") if file.suffix in (".png", ".webp")):
        place = picture.relative_to(RENDERS.parent).as_posix()
        files.append(File.generated(config, place, abs_src_path=str(picture)))
    return files


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Replace a link out of docs/ by the name of the file."""
    markdown = markdown.replace("](../renders/", "](renders/")
    return re.sub(r"\[`?([^\]`]+)`?\]\(\.\./[^)]*\)", r"`\1`", markdown)
