"""The built page is what its sources build, asks for nothing outside, and is small."""

import hashlib
import json
import re
import shutil
import subprocess
from importlib.resources import files
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PAGES = ROOT / "pages"
BUILT = ("index.html", "studio.js", "studio.css", "sources.txt")
OWN = ("build.mjs", "package.json", "package-lock.json", "tsconfig.json")
MOST = 1_500_000  # [bytes] of the page


def digest() -> str:
    """As pages/build.mjs has it."""
    found = hashlib.sha256()
    sources = sorted((PAGES / "src").rglob("*"), key=lambda path: path.relative_to(PAGES).parts)
    for path in [*(path for path in sources if path.is_file()), *(PAGES / name for name in OWN)]:
        found.update(path.relative_to(PAGES).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return found.hexdigest()


def test_the_built_page_is_of_these_sources():
    built = (files("dynsplines.studio") / "built" / "sources.txt").read_text().strip()
    assert built == digest(), "build it again: cd pages && npm ci && npm run build"


@pytest.mark.slow
def test_what_is_built_is_what_the_sources_build(tmp_path):
    if shutil.which("node") is None or not (PAGES / "node_modules" / "esbuild").is_dir():
        pytest.skip("no node, or its packages are not installed: cd pages && npm ci")
    subprocess.run(["node", PAGES / "build.mjs", tmp_path], check=True, capture_output=True)
    for file in sorted(path for path in tmp_path.rglob("*") if path.is_file()):
        assert file.read_bytes() == (ROOT / file.relative_to(tmp_path)).read_bytes(), file.name


def test_the_page_is_small_and_asks_for_nothing_outside():
    folder = files("dynsplines.studio") / "built"
    assert sorted(each.name for each in folder.iterdir()) == sorted(BUILT)
    sizes = [len((folder / name).read_bytes()) for name in BUILT]
    assert sum(sizes) <= MOST
    page = (folder / "index.html").read_text()
    assert re.findall(r'(?:src|href)="([^"]*)"', page) == ["data:,", "studio.css", "studio.js"]
    style = (folder / "studio.css").read_text()
    assert "url(" not in style
    assert "@import" not in style
    program = (folder / "studio.js").read_text()
    assert not re.search(r"\b(importScripts|eval)\s*\(", program)
    assert "MIT License" in program


def luminance(colour: str) -> float:
    """Relative luminance of a colour as #rrggbb, by WCAG."""
    channels = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in channels)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_words_stand_out_from_what_is_behind_them(theme):
    """WCAG's AA: 4.5 : 1 between the colours of text and of what it stands on, 3 : 1 of marks."""
    style = (PAGES / "src" / "studio" / "style.css").read_text(encoding="utf-8")
    (block,) = (text for text in re.findall(r"^:root[^{]*\{(.*?)\}", style, re.M | re.S) if f"scheme: {theme}" in text)
    light = {name: luminance(colour) for name, colour in re.findall(r"--([\w-]+): (#\w{6})", block)}
    least = {"ink": 4.5, "soft": 4.5, "accent": 3, "key": 3, "bad": 3, "good": 3}
    pairs = [(high, low, least[high]) for low in ("panel", "raised", "back") for high in least]
    for high, low, ratio in [*pairs, ("on-accent", "accent", 4.5)]:
        darker, brighter = sorted((light[high], light[low]))
        assert (brighter + 0.05) / (darker + 0.05) >= ratio, (high, low)


def test_the_lock_file_has_no_addresses():
    lock = json.loads((PAGES / "package-lock.json").read_text())
    assert not [name for name, said in lock["packages"].items() if "resolved" in said]
    assert all("integrity" in said for name, said in lock["packages"].items() if name)
