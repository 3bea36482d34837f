"""The house rules, read off the source: imports run one way, third parties stay in their file, no I/O in the solver."""

import ast
import re
import tomllib
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
HOUSE = ("runner", "models", "solver")
FILES = sorted(path.relative_to(ROOT) for folder in HOUSE for path in (ROOT / folder).rglob("*.py"))
SOLVER = [path for path in FILES if path.parts[0] == "solver"]

PACKAGES = {"runner": "dynsplines", "solver": "dynsplines.solver", "models": "dynsplines.models"}  # that they are
MAY_IMPORT = {"runner": set(HOUSE), "solver": {"solver"}, "models": {"models"}}
ONLY_IN = {
    "nlopt": {"solver/search/nlopt_methods.py"},
    "imageio": {"runner/picture/film.py"},
    "threadpoolctl": {"solver/inbetween.py"},
    "tomllib": {"runner/clip/parse.py", "runner/studio/document.py"},
    "typer": {"runner/cli.py", "runner/cli_options.py", "runner/system/exit_status.py"},
    "starlette": {"runner/studio/server.py"},
    "tomlkit": {"runner/studio/blocks.py"},
    "uvicorn": {"runner/studio/launch.py"},
}
SCIPY_IN_SOLVER = {
    "solver/curve/banded.py",
    "solver/curve/elimination.py",
    "solver/curve/spline.py",
    "solver/curve/unknowns.py",
    "solver/posing/drag.py",
    "solver/search/quadratic.py",
}
SETUPTOOLS = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]
TESTS = sorted(path.relative_to(ROOT) for path in (ROOT / "tests").rglob("*.py"))
NO_WORLD = {"os", "sys", "io", "pathlib", "time", "datetime", "shutil", "tempfile", "subprocess", "logging", "random"}


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse((ROOT / path).read_text(encoding="utf-8"))


@cache
def imports(path: Path) -> frozenset[str]:
    """Dotted names of all that a file imports, relative ones resolved; a name imported from a module counts too.

    Of the house by folder: `dynsplines.solver.array` is solver.array, and `dynsplines.clip` is runner.clip.
    """
    return frozenset(map(by_folder, written_imports(path)))


def by_folder(name: str) -> str:
    """A dotted name with the folder at the top of the repository instead of the package that it is."""
    for folder, package in sorted(PACKAGES.items(), key=lambda pair: -len(pair[1])):
        if name == package or name.startswith(f"{package}."):
            return folder + name.removeprefix(package)
    return name


@cache
def written_imports(path: Path) -> frozenset[str]:
    """The same as it is written."""
    names: set[str] = set()
    package = path.parent.parts
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else ()
            base = ".".join([*above, *([node.module] if node.module else [])])
            names |= {base} | {f"{base}.{alias.name}" for alias in node.names}
    return frozenset(names)


@cache
def packages(path: Path) -> set[str]:
    return {name.split(".")[0] for name in imports(path)}


def test_the_folders_are_one_package():
    assert SETUPTOOLS["package-dir"] == {name: folder for folder, name in PACKAGES.items()}
    own = [path.parent for path in FILES if path.name == "__init__.py"]
    named = [".".join([PACKAGES[folder.parts[0]], *folder.parts[1:]]) for folder in own]
    assert sorted(SETUPTOOLS["packages"]) == sorted(named)


def test_everything_is_imported_by_its_name_in_the_package():
    for path in FILES:  # relative imports are resolved by folder
        written = {name.split(".")[0] for name in written_imports(path)}
        assert not written & set(HOUSE) - {path.parts[0]}, path
    for path in TESTS:
        modules = re.findall(r"^ *(?:from|import) +(\w+)", (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE)
        assert not {*modules} & set(HOUSE) and not [name for name in modules if name.startswith("test_")], path


def test_imports_run_from_the_runner_to_solver_and_models_and_never_back():
    assert {"solver/inbetween.py", "solver/penalty/motion/acceleration.py", "models/__init__.py"} <= {*map(str, FILES)}
    for path in FILES:
        assert packages(path) & set(HOUSE) <= MAY_IMPORT[path.parts[0]], path


def test_third_parties_stay_in_the_file_that_knows_them():
    for path in FILES:
        for package, homes in {**ONLY_IN, **({"scipy": SCIPY_IN_SOLVER} if path in SOLVER else {})}.items():
            assert package not in packages(path) or path.as_posix() in homes, path


def test_the_solver_uses_no_files_no_clock_and_no_terminal():
    for path in SOLVER:
        assert not packages(path) & NO_WORLD, path
        called = {n.func.id for n in ast.walk(tree(path)) if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)}
        assert not called & {"open", "print", "input", "exec", "eval", "hasattr"}, path


# every folder, or module beside the folders, rests only on those in lines before its own
STRATA = {
    "solver": """
        array tolerances
        compiled quaternion cone cache
        figure
        curve surface
        contacts
        penalty
        objective posing
        search
        refine
        problem
        inbetween edit
    """,
    "runner": """
        errors
        system
        scene
        motion
        clip
        measure picture
        solving
        exchange
        clean
        recordings
        edit
        inputs
        batch
        python studio
        cli_options
        cli
        __main__
    """,
}


def stratum(name: str) -> str:
    """The folder or module of a top that a dotted name belongs to; "" for the top itself."""
    return name.split(".")[1] if "." in name else ""


@pytest.mark.parametrize("top", STRATA)
def test_folders_rest_only_on_those_below_them(top):
    lines = [line.split() for line in STRATA[top].split("\n") if line.strip()]
    rank = {name: k for k, line in enumerate(lines) for name in line}
    mine = [path for path in FILES if path.parts[0] == top and len(path.parts) + (path.stem != "__init__") > 2]
    assert {Path(path.parts[1]).stem for path in mine} == set(rank)
    for path in mine:
        own = Path(path.parts[1]).stem
        named = {stratum(name) for name in imports(path) if name.split(".")[0] == top} & rank.keys() - {own}
        assert all(rank[other] < rank[own] for other in named), (path, named)


def test_imports_inside_the_solver_make_no_circle():
    below = {p.with_suffix("").as_posix().replace("/", ".").removesuffix(".__init__"): imports(p) for p in SOLVER}
    package = {"solver"}  # named by every `from . import frame`, which needs the module and not the package
    below = {name: (names & below.keys()) - {name} - package for name, names in below.items()}
    done: set[str] = set()
    while len(done) < len(below):
        ready = {name for name, needs in below.items() if name not in done and needs <= done}
        assert ready, f"a circle among {sorted(set(below) - done)}"
        done |= ready


def test_no_folder_of_the_product_has_more_files_than_one_sees_at_a_glance():
    counts = Counter(path.parent for path in FILES if path.name != "__init__.py")
    assert {folder: count for folder, count in counts.items() if count > 15} == {}


@pytest.mark.parametrize("top", ["solver", "runner"])
def test_tests_lie_as_what_they_test_does(top):
    folders = {path.parent for path in TESTS if path.parts[1] == top}
    assert folders
    for folder in folders:
        assert (ROOT / folder.relative_to("tests")).is_dir(), folder
