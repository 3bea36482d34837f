"""Code blocks of README and docs/ run from top to bottom and print the output shown; tables, links and site."""

import contextlib
import dataclasses
import doctest
import importlib
import inspect
import io
import pydoc
import re
import shlex
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any
from unittest.mock import patch

import griffe
import numpy as np
import pytest
import shipped
from paper.study import UNIT_LIMIT
from sybil import Example, Sybil
from sybil.parsers.markdown import CodeBlockParser, PythonCodeBlockParser
from typer.main import get_command

from dynsplines import cli, inbetween, models, recordings
from dynsplines.clean import repairs
from dynsplines.clip.parse import LONGEST, SHORTEST
from dynsplines.clip.tracking import recording
from dynsplines.exchange import simulation
from dynsplines.exchange.formats import FORMATS
from dynsplines.measure import bounds, ground, measurement
from dynsplines.measure.bounds import BOUNDS
from dynsplines.motion import Saved
from dynsplines.picture import show
from dynsplines.solver import objective
from dynsplines.solver.contacts.thresholds import Thresholds
from dynsplines.solver.penalty.joints import overshoot
from dynsplines.solver.penalty.motion import prior
from dynsplines.system import size_limit
from dynsplines.system.progress import Progress

ROOT = Path(__file__).parents[2]
PAGES = sorted((ROOT / "docs").glob("*.md"))
TEXTS = {page.stem: page.read_text(encoding="utf-8") for page in (ROOT / "README.md", *PAGES)}
README = TEXTS["README"]


def compare_output(example: Example) -> str | None:
    """Compare a block of text with the output of the code above it; `...` stands for anything."""
    wanted, got = str(example.parsed).strip() + "\n", example.namespace["printed"].strip() + "\n"
    checker, flags = doctest.OutputChecker(), doctest.ELLIPSIS
    if checker.check_output(wanted, got, flags):
        return None
    return checker.output_difference(doctest.Example("", wanted), got, flags)


def run_commands(example: Example) -> None:
    """Run a block of shell and print its output, without progress and the name of the renderer."""
    for line in str(example.parsed).strip().splitlines():
        name, *words = shlex.split(line)
        if name != "dynsplines":
            print(other_command(name, words))
            continue
        output = io.StringIO()
        with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stdout(output):
            patch.setattr(sys, "argv", ["dynsplines", *words])
            patch.setattr(Progress, "step", lambda *_, **__: None)
            with contextlib.redirect_stderr(output), pytest.raises(SystemExit) as ended:
                cli.main()
        assert not ended.value.code, output.getvalue()
        lines = [line.rstrip() for line in output.getvalue().splitlines() if not line.startswith("renderer:")]
        print(*lines, sep="\n")


def other_command(name: str, words: list[str]) -> str:
    """Return the output of grep; install with pip, or skip the page without a connection."""
    assert name in ("grep", "pip")
    start = [name, *words] if name == "grep" else [sys.executable, "-m", "pip", *words, "--no-compile"]
    done = subprocess.run(start, capture_output=True, text=True, check=False)
    if name == "pip" and done.returncode:
        pytest.skip(f"no package index: {done.stderr.strip().splitlines()[-1]}")
    assert not done.returncode, done.stderr
    return done.stdout if name == "grep" else ""


def draw_small(draw: Callable[..., None], saved: Saved, look: show.Look, *more: Any) -> None:
    """Draw few frames, and small ones."""
    draw(saved, dataclasses.replace(look, width=32, height=18, fps=0.5), *more)


def write_file(example: Example) -> None:
    """Write a block of TOML to the file that its first line names, or replace a line of this file by the block."""
    text = str(example.parsed)
    if name := re.match(r"# (\w+\.toml)\n", text):
        Path(name[1]).write_text(text, encoding="utf-8")
    elif change := re.match(r"# (\w+\.toml), instead of the line (\S+)\n", text):
        lines = Path(change[1]).read_text(encoding="utf-8").splitlines(keepends=True)
        (at,) = [i for i, line in enumerate(lines) if line.startswith(change[2])]
        Path(change[1]).write_text("".join([*lines[:at], text, *lines[at + 1 :]]), encoding="utf-8")


SYBIL = Sybil(
    parsers=[
        PythonCodeBlockParser(),
        CodeBlockParser(language="text", evaluator=compare_output),
        CodeBlockParser(language="sh", evaluator=run_commands),
        CodeBlockParser(language="toml", evaluator=write_file),
    ]
)


def test_commands_that_pages_do_not_run_have_valid_options() -> None:
    group: Any = get_command(cli.app)
    count = 0
    for page in TEXTS.values():
        lines = [line for block in blocks("shell", page) for line in block.splitlines()]
        for name, *words in (line.split("#")[0].split()[1:] for line in lines if line.startswith("dynsplines ")):
            group.commands[name].make_context(name, words).close()
            count += 1
    assert count > 5


def test_every_option_on_the_pages_exists() -> None:
    group: Any = get_command(cli.app)
    commands = [group, *group.commands.values()]
    options = {name for each in commands for option in each.params for name in option.opts + option.secondary_opts}
    others = {"--help", "--nthreads", "--figures", "--no-deps", "--target"}  # of Dask, benchmarks.paper and pip
    assert set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", "".join(TEXTS.values()))) - others <= options


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_blocks_of_a_page_run(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    shipped.share(monkeypatch)
    monkeypatch.setattr(show, "draw", partial(draw_small, show.draw))
    document = SYBIL.parse(page)
    ran = 0
    with patch.dict(BOUNDS):  # to which a page adds a kind
        for example in document.examples():
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                example.evaluate()
            document.namespace["printed"] = out.getvalue()
            ran += 1
    assert ran == len(re.findall(r"^```(?:python|text|sh|toml)$", page.read_text(encoding="utf-8"), re.MULTILINE))


def blocks(language: str, page: str = README) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", page, flags=re.S)


@pytest.mark.slow
def test_the_python_example_of_the_readme_equals_its_toml_example(tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    shipped.share(monkeypatch)
    monkeypatch.setattr(show, "draw", partial(draw_small, show.draw))
    (example,) = blocks("python")
    names: dict[str, Any] = {}
    exec(compile(example, "README.md", "exec"), names)
    assert capsys.readouterr().out.startswith("(25, 51) <Motion clip: 0.80 s, 2 keyframes")
    assert {path.name for path in tmp_path.iterdir()} == {"step.png", "mirrored.csv"}
    motion, twin = names["motion"], recordings.from_text(blocks("toml")[0], name="readme")
    assert not motion.violations
    for key, other in zip(motion.saved.keys, twin.keys, strict=True):  # the same problem has the same solution
        assert key.time == other.time
        np.testing.assert_array_equal(key.state, other.state)
        np.testing.assert_array_equal(key.fixed, other.fixed)
    assert motion.saved.scene.mjcf == twin.scene.mjcf


@pytest.mark.slow
def test_the_example_clips_pasted_one_below_the_other_solve_and_nothing_is_wrong_with_them() -> None:
    parts = blocks("toml") + blocks("toml", TEXTS["keyframes"])
    assert len(parts) == 2 and len(parts[0].splitlines()) <= 12
    assert not inbetween(recordings.from_text("".join(parts), name="readme")).violations
    parts += blocks("toml", TEXTS["soft_constraints"])
    assert len(recordings.from_text("".join(parts), name="readme").penalties) > 10


def test_every_format_of_the_table_exists_and_none_is_left_out() -> None:
    table = TEXTS["formats"].split("# Formats")[1].split("##")[0]
    ways = {"both": (True, True), "writes": (True, False), "reads": (False, True)}
    documented = {
        name: ways[way.strip()]
        for names, way in re.findall(r"^\| ([^|]+) \| (both|writes|reads) \|", table, flags=re.MULTILINE)
        for name in re.findall(r"`([\w-]+)`", names)
    }
    assert documented == {each.name: (each.writes, each.reads) for each in FORMATS}


def test_every_command_of_the_table_exists() -> None:
    commands: Any = get_command(cli.app)
    assert {*re.findall(r"`dynsplines ([a-z]+)", README + TEXTS["commands"])} <= set(commands.commands)


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md"], ids=lambda page: page.stem)
def test_links_of_a_page_exist(page: Path) -> None:
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text(encoding="utf-8")):
        assert (page.parent / target).exists(), target


def test_every_name_of_the_package_is_on_the_python_page() -> None:
    import dynsplines

    for name in dynsplines.__all__:
        assert re.search(rf"`[^`]*\b{name}\b", TEXTS["python"]), name


def test_a_page_has_the_same_title_in_the_table_of_contents_on_the_page_and_in_links() -> None:
    config = (ROOT / "docs" / "site" / "mkdocs.yml").read_text(encoding="utf-8")
    titles = {f"{name}.md": re.findall(r"^# (.*)", text)[0] for name, text in TEXTS.items() if name != "README"}
    listed = re.findall(r"- ([^:\n]+): (\w+\.md)$", config, re.MULTILINE)
    assert {page: title for title, page in listed} == titles | {"index.md": "dynamic-splines"}
    assert set(titles) == set(re.findall(r"\]\(docs/(\w+\.md)\)", README))
    for text in TEXTS.values():
        for title, page in re.findall(r"\[([A-Z][^\]]*)\]\((?:docs/)?(\w+\.md)\)", text):
            assert title == titles.get(page, title), page


PERIODS = {  # of gait [s]
    name: tomllib.loads(models.clip_text(name))["keyframe"][-1]["time"] for name in ("walk_loop", "run_loop")
}
NUMBER = r"\d[\d.,]*"
FIGURE = re.compile(rf"\b{NUMBER}(?: times\b| ×| ?(?:%|[MG]B\b|Hz\b|c?m/s\b)| (?:m?s|seconds|minutes?)\b)")
FALL = np.sqrt(2 * np.array([0.1, 0.3, 0.5]) / 9.81)  # [s]
STATED = {  # the only figures outside generated parts: text, and its numbers in the code
    "unit length is below {:g} %": 100 * UNIT_LIMIT,
    "touches nothing for over {:g} s": Thresholds.moment,
    "between keyframes at most {:g} s apart": Thresholds.shortly,
    "are means over {:g} s": ground.WINDOW,
    "first and last {:g} s": ground.WINDOW / 2,
    "clips under {:g} s": ground.WINDOW,
    "average under {:g} m/s": Thresholds.fast,
    "and slower than {:g} m/s": Thresholds.travels,
    "is slower than {:g} m/s": Thresholds.travels,
    "complete keyframes at least {:g} s apart": Thresholds.far_apart,
    "also more than {:g} %": 100 * bounds.SPEED_SHARE,
    "also more than {:g} times": bounds.WHIP_SHARE,
    "measured {:g} times per second, at keyframes": measurement.RATE,
    "measured {:g} times per second.": measurement.RATE / 4,
    "1° during {:g} % of the clip": 100 * objective.SMALL_SHARE,
    "ω = 2π · {:g} Hz": simulation.FREQUENCY,
    "kv = kp · {:.2g} s": 1 / (np.pi * simulation.FREQUENCY),
    "at least {:g} ms apart": 1000 * SHORTEST,
    "at most {:g} s long": LONGEST,
    "| {:g} s |": LONGEST,
    "| {:g} MB;": size_limit.USUAL,
    "a walk takes about {:.1f} s": PERIODS["walk_loop"] / 2,
    "of a run {:.1f} s": PERIODS["run_loop"] / 2,
    "0.1 m takes {:.2f} s": FALL[0],
    "0.3 m {:.2f} s": FALL[1],
    "0.5 m {:.2f} s": FALL[2],
    "gaps of up to {:g} s": repairs.LONGEST_GAP,
    "changes the recording within {:g} s": recording.EASE,
    "a time T > {:g} s apart": objective.LONG,
    "(T / {:g} s)⁴": objective.LONG,
    "less than {:g} s": prior.BRIEF,
    "more than {:g} s apart": prior.ENDLESS,
    "at least {:g} s apart share": overshoot.BRIEF,
}


def test_every_figure_is_generated_or_that_of_the_code(reference: ModuleType) -> None:
    """No page states a measured time, ratio or share by hand."""
    stated = [text.format(value) for text, value in STATED.items()]
    prose = {name: re.sub(r"```.*?```", "", reference.PART.sub("", text), flags=re.S) for name, text in TEXTS.items()}
    joined = {name: " ".join(text.split()) for name, text in prose.items()}
    assert [text for text in stated if not any(text in page for page in joined.values())] == []
    for text in stated:
        joined = {name: page.replace(text, "") for name, page in joined.items()}
    found = {name: FIGURE.findall(re.sub(r"`[^`]*`", "", page)) for name, page in joined.items()}
    assert not any(found.values()), found


def test_the_pages_are_few_and_short() -> None:
    assert len(TEXTS) <= 17
    assert sum(len(text.split()) for text in TEXTS.values()) <= 20_000


@pytest.fixture
def reference(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    return importlib.import_module("reference")


def test_generated_parts_are_up_to_date_and_each_is_on_one_page(reference: ModuleType) -> None:
    pages = [page.read_text(encoding="utf-8") for page in reference.PAGES]
    assert [reference.written(page) for page in pages] == pages
    assert sorted(name for page in pages for _, name, _ in reference.PART.findall(page)) == sorted(reference.PARTS)


def documented() -> Iterator[str]:
    """Yield the names of the Python reference, and the public methods of its classes."""
    for name, listed in re.findall(
        r"^::: ([\w.]+)(?:\n    options: \{members: (.*)\})?$", TEXTS["python"], re.MULTILINE
    ):
        yield name
        value = pydoc.locate(name)
        assert value is not None, name
        if isinstance(value, type):
            members = re.findall(r"\w+", listed) if listed else list(vars(value))
            members = [each for each in members if not each.startswith("_")]
            yield from (f"{name}.{each}" for each in members if isinstance(vars(value)[each], FunctionType))


@pytest.mark.parametrize("name", list(documented()))
def test_the_reference_describes_every_argument_and_result(name: str) -> None:
    value = pydoc.locate(name)
    summary, *sections = griffe.Docstring(inspect.getdoc(value) or "", lineno=1).parse("google", warnings=False)
    assert summary.kind is griffe.DocstringSectionKind.text
    if isinstance(value, type) and not dataclasses.is_dataclass(value):
        return  # the page has its methods one by one
    assert callable(value)
    signature = inspect.signature(value)
    names = {each for each in signature.parameters if each != "self" and not each.startswith("_")}
    kinds = griffe.DocstringSectionKind
    described = [s.value for s in sections if s.kind in (kinds.parameters, kinds.attributes)]
    assert {each.name.strip("*") for items in described for each in items} == names
    has_result = not isinstance(value, type) and signature.return_annotation not in (None, "None")
    assert any(section.kind is kinds.returns for section in sections) == has_result


@pytest.mark.slow
def test_the_site_is_built_without_a_warning(tmp_path: Path) -> None:
    pytest.importorskip("mkdocs")
    config = ROOT / "docs" / "site" / "mkdocs.yml"
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "-f", str(config), "-d", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "tutorial" / "index.html").read_text(encoding="utf-8")
    assert "keys.png" in page and (tmp_path / "renders" / "tutorial" / "keys.png").is_file()


TEST_LINK = re.compile(r"\[([\w/]+)\]\((\.\./tests/[\w/]+\.py)\)")


def test_every_guarantee_has_tests() -> None:
    section = TEXTS["contribute"].split("## Guarantees and their tests")[1]
    rows = [line.strip("|").split("|") for line in section.splitlines() if re.match(r"\| (?!guarantee)", line)]
    assert len(rows) > 20
    for guarantee, *links_cell in rows:
        assert len(links_cell) == 1, guarantee
        links = TEST_LINK.findall(links_cell[0])
        assert links, guarantee
        for name, place in links:
            file = (ROOT / "docs" / place).resolve()
            assert place == f"../tests/{name}.py"
            assert re.search(r"^def test_", file.read_text(encoding="utf-8"), re.MULTILINE), place
