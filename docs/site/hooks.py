"""Hooks of the site: the README as its home page, pictures beside docs/, links to code, and the package as the
reference's generator reads it."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

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
    """Add the README as the home page, and the pictures of renders/, which it shares with the pages."""
    files.append(File.generated(config, "index.md", content=(ROOT / "README.md").read_text(encoding="utf-8")))
    for picture in sorted(file for file in RENDERS.rglob("*") if file.suffix in (".png", ".webp")):
        place = picture.relative_to(RENDERS.parent).as_posix()
        files.append(File.generated(config, place, abs_src_path=str(picture)))
    return files


def on_page_markdown(markdown: str, page: Page, **_: Any) -> str:
    """Make links relative to the pages, and replace a link to a file that is no page by the name of the file."""
    if page.file.src_uri == "index.md":
        markdown = markdown.replace("](docs/", "](")
        markdown = re.sub(r"\]\((?=[A-Z])", "](../", markdown)
    markdown = markdown.replace("](../renders/", "](renders/").replace("](../README.md", "](index.md")
    return re.sub(r"\[`?([^\]`]+)`?\]\(\.\./[^)]*\)", r"`\1`", markdown)
