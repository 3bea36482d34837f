"""Every block of code of every page of docs/ runs, from the top to the bottom of its page, and prints what it says."""

from __future__ import annotations

import contextlib
import doctest
import io
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from sybil import Example, Sybil
from sybil.parsers.markdown import CodeBlockParser, PythonCodeBlockParser

ROOT = Path(__file__).parents[2]
PAGES = sorted((ROOT / "docs").glob("*.md"))
COMMAND = "import sys; from dynsplines.cli import main; main()"


def printed(example: Example) -> str | None:
    """A block of text is what the code above it has printed; `...` stands for anything."""
    wanted, got = str(example.parsed).strip() + "\n", example.namespace["printed"].strip() + "\n"
    checker, flags = doctest.OutputChecker(), doctest.ELLIPSIS
    if checker.check_output(wanted, got, flags):
        return None
    return checker.output_difference(doctest.Example("", wanted), got, flags)


def commands(example: Example) -> None:
    """A block of shell: commands of ours."""
    for line in str(example.parsed).strip().splitlines():
        name, *words = shlex.split(line)
        assert name == "dynsplines"
        done = subprocess.run([sys.executable, "-c", COMMAND, *words], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


SYBIL = Sybil(
    parsers=[
        PythonCodeBlockParser(),
        CodeBlockParser(language="text", evaluator=printed),
        CodeBlockParser(language="sh", evaluator=commands),
    ]
)


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_blocks_of_a_page_run(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    document = SYBIL.parse(page)
    ran = 0
    for example in document.examples():
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            example.evaluate()
        document.namespace["printed"] = out.getvalue()
        ran += 1
    assert ran >= 1


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_what_a_page_links_to_is_there(page: Path) -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8")):
        assert (page.parent / target).exists(), target


def test_every_name_of_the_package_is_on_the_first_page() -> None:
    import dynsplines

    told = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    for name in dynsplines.__all__:
        assert re.search(rf"`[^`]*\b{name}\b", told), name


def test_every_page_is_on_the_first() -> None:
    told = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    assert {page.name for page in PAGES} - {"index.md"} == set(re.findall(r"\]\((\w+\.md)\)", told))
