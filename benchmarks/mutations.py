"""What the tests would miss: random mutations, one at a time, each against the tests that run its line.

    python benchmarks/mutations.py --record                which tests run which lines: once, half an hour
    python benchmarks/mutations.py --count 200 --seed 1    200 random places of solver/
    python benchmarks/mutations.py --only runner/clip      those of a folder or file
    python benchmarks/mutations.py --only solver/cone.py:49  every mutation of a line

Constants that a module begins with, and numbers with a decimal point in the defaults of a class, are left alone: they
are choices, each with its reason in a comment.

A mutation is a float times 1.001, an integer one up or down, a comparison, a sign or a product turned round, `and` for
`or`. No file is touched: a process of its own compiles the mutated source under the name of the module and runs pytest
in itself, in a time that is bounded: the tests that run the line, the fastest first. A line each says caught, survived
or hung; the last line is their sum; results can be kept as JSON. `--record` needs the package coverage.
"""

from __future__ import annotations

import pinned  # noqa: F401  isort: skip  # before anything that imports NumPy

import argparse
import ast
import contextlib
import copy
import importlib.abc
import importlib.util
import itertools
import json
import math
import os
import random
import resource
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TESTS = ROOT / "tests"
PRODUCT = ("solver", "runner", "models")
RECORD = Path(tempfile.gettempdir()) / "dynsplines_tests_by_line.json"
FAILED = RECORD.with_suffix(f".{os.getpid()}.txt")  # the name of the test that caught the last mutant
SLIGHTLY = 1.001
MOST = 200  # tests of a line that are recorded in a process
FEW = 25  # tests that are tried first, in a process of their own
SECONDS = 60.0  # of a core, for the tests of a mutant
MARGIN = 10.0  # of a core [s], beyond what the tests took when they were recorded
PATIENCE = 10.0  # times as long, on a machine that others use
HEAVY = (
    "numpy",
    "scipy.linalg",
    "scipy.sparse",
    "scipy.interpolate",
    "mujoco",
    "hypothesis",
    "pytest",
    "rich.console",
    "pydantic",
    "scipy.spatial.transform",
    "scipy.optimize",
)
COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
}  # fmt: skip
OPERATIONS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
}  # fmt: skip
NOTHING_TO_RUN = 5  # pytest's exit code for a file whose tests are all slow
CAUGHT, SURVIVED, HUNG = "caught", "survived", "hung"


@dataclass(frozen=True)
class Mutant:
    """One change of one file: its line, the code before and after, and the complete changed source."""

    path: str
    line: int
    before: str
    after: str
    source: str


@dataclass(frozen=True)
class Outcome:
    """The verdict on a mutant, its duration [s], and the tests that were run."""

    path: str
    line: int
    before: str
    after: str
    verdict: str
    seconds: float
    tests: tuple[str, ...]


def changes(node: ast.AST) -> list[ast.AST]:
    """The replacements of a node."""
    if isinstance(node, ast.Constant) and type(node.value) is float and node.value and abs(node.value) < 1e300:
        return [ast.Constant(node.value * SLIGHTLY)]
    if isinstance(node, ast.Constant) and type(node.value) is int:
        return [ast.Constant(node.value + step) for step in (1, -1)]
    if isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in COMPARISONS:
        return [ast.Compare(node.left, [COMPARISONS[type(node.ops[0])]()], node.comparators)]
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
        return [ast.BinOp(node.left, OPERATIONS[type(node.op)](), node.right)]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return [node.operand]
    if isinstance(node, ast.BoolOp):
        return [ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)]
    return []


def mutants_of(path: Path) -> dict[int, list[tuple[int, int]]]:
    """By line, which node of the tree (counted as it is walked) can be changed, and how often."""
    tree, out = ast.parse(path.read_text(encoding="utf-8")), {}
    skipped = {id(part) for part in _ignored_parts(tree)}
    for number, node in enumerate(ast.walk(tree)):
        changes_of_node = [] if id(node) in skipped else changes(node)
        if changes_of_node:
            out.setdefault(node.lineno, []).extend((number, choice) for choice in range(len(changes_of_node)))  # type: ignore[attr-defined]
    return out


def _ignored_parts(tree: ast.AST) -> Iterator[ast.AST]:
    """Parts that change nothing when they change, annotations, decorators (the size of a cache), messages of errors and
    functions that have a docstring alone, which others stand in for; the −1 of `reshape`, for which any negative number
    does; and constants of a module and floats of a class, which are choices: others would do as well."""
    for node in tree.body if isinstance(tree, ast.Module) else ():
        if isinstance(node, (ast.Assign, ast.AnnAssign)):
            yield from ast.walk(node)
    for node in _class_defaults(tree):
        yield from (part for part in ast.walk(node) if isinstance(part, ast.Constant) and type(part.value) is float)
    for node in ast.walk(tree):
        if isinstance(node, ast.Raise) or (isinstance(node, ast.FunctionDef) and not _does_anything(node)):
            yield from ast.walk(node)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "reshape":
            for word_part in (part for word in node.args for part in ast.walk(word)):
                if isinstance(word_part, ast.UnaryOp) and isinstance(word_part.op, ast.USub):
                    yield from ast.walk(word_part)
        parts = [getattr(node, "annotation", None), getattr(node, "returns", None)]
        for part in (*parts, *getattr(node, "decorator_list", ())):
            if part is not None:
                yield from ast.walk(part)


def _class_defaults(tree: ast.AST) -> Iterator[ast.AST]:
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef):
            yield from (line for line in node.body if isinstance(line, (ast.Assign, ast.AnnAssign)))


def _does_anything(function: ast.FunctionDef) -> bool:
    return not all(isinstance(line, ast.Expr) and isinstance(line.value, ast.Constant) for line in function.body)


def mutated(path: Path, number: int, change: int) -> Mutant:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    old = list(ast.walk(tree))[number]
    new = ast.copy_location(copy.deepcopy(changes(old)[change]), old)
    line = old.lineno  # type: ignore[attr-defined]
    before, after = ast.unparse(old), ast.unparse(new)

    class Exchange(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return new if node is old else self.generic_visit(node)

    whole = ast.unparse(ast.fix_missing_locations(Exchange().visit(tree)))
    return Mutant(path.relative_to(ROOT).as_posix(), line, before, after, whole)


def chosen(count: int, seed: int, only: list[str]) -> list[Mutant]:
    """Random lines of the product that can be changed, each once, and a random change of each."""
    if only and all(":" in name for name in only):
        return [mutant for name in only for mutant in _all_of(*name.split(":"))]
    roots = [ROOT / name for name in only or ["solver"]]
    files = sorted(file for root in roots for file in ([root] if root.is_file() else root.rglob("*.py")))
    lines = [(path, places) for path in files for places in mutants_of(path).values()]
    rng = random.Random(seed)
    rng.shuffle(lines)
    return [mutated(path, *rng.choice(places)) for path, places in lines[:count]]


def _all_of(path: str, line: str) -> list[Mutant]:
    """Every change of one line."""
    return [mutated(ROOT / path, *place) for place in mutants_of(ROOT / path).get(int(line), [])]


def module_name(path: str) -> str:
    folder, _, rest = path.removesuffix(".py").partition("/")
    name = rest if folder == "runner" else f"{folder}/{rest}"
    return f"dynsplines.{name}".replace("/", ".").removesuffix(".__init__")


class Recorder:
    """Records which tests run which lines, as a plugin of pytest."""

    def __init__(self) -> None:
        coverage = importlib.import_module("coverage")  # no dependency of the project

        self.seconds: dict[str, float] = {}
        self.coverage = coverage.Coverage(data_file=None, include=[str(ROOT / folder / "*") for folder in PRODUCT])

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        self.coverage.switch_context(nodeid)

    def pytest_runtest_logreport(self, report) -> None:
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration

    def lines(self) -> dict[str, dict[int, list[str]]]:
        """By file and line, the tests that run it, those of its folder and the fastest first, at most `MOST`."""
        data = self.coverage.get_data()
        out: dict[str, dict[int, list[str]]] = {}
        for file in data.measured_files():
            path = Path(file).relative_to(ROOT).as_posix()
            out[path] = {
                line: sorted(filter(self.seconds.get, tests), key=lambda test: _order(test, path, self.seconds))[:MOST]
                for line, tests in data.contexts_by_lineno(file).items()
            }
        return out


def record(part: int, parts: int, target: Path) -> None:
    """Run every `parts`-th file of tests, and write which tests run which lines, and their durations."""
    import pytest

    os.chdir(ROOT)
    recorder, files = Recorder(), sorted(TESTS.rglob("test_*.py"))
    recorder.coverage.start()
    options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-o", "addopts=--import-mode=importlib", "--tb=line"]
    pytest.main([*options, *map(str, files[part::parts])], plugins=[recorder])
    recorder.coverage.stop()
    target.write_text(json.dumps({"seconds": recorder.seconds, "lines": recorder.lines()}), encoding="utf-8")


def record_all() -> None:
    """Record all tests, in as many processes as there are cores."""
    parts = os.cpu_count() or 1
    targets = [RECORD.with_suffix(f".{part}.json") for part in range(parts)]
    children = []
    for part, target in enumerate(targets):
        number = os.fork()
        if not number:
            record(part, parts, target)
            os._exit(0)
        children.append(number)
    for number in children:
        os.waitpid(number, 0)
    seconds: dict[str, float] = {}
    lines: dict[str, dict[str, list[str]]] = {}
    for target in targets:
        read = json.loads(target.read_text(encoding="utf-8"))
        seconds |= read["seconds"]
        for file, tests in read["lines"].items():
            of_file = lines.setdefault(file, {})
            for line, names in tests.items():
                of_file.setdefault(line, []).extend(names)
        target.unlink()
    RECORD.write_text(json.dumps({"seconds": seconds, "lines": lines}), encoding="utf-8")


@cache
def recorded() -> dict:
    if not RECORD.exists():
        raise SystemExit("no record of which tests run which lines: python benchmarks/mutations.py --record")
    return json.loads(RECORD.read_text(encoding="utf-8"))


def _order(test: str, path: str, seconds: dict[str, float]) -> tuple[bool, float]:
    """The place of a test among those that are tried on a file: those of its folder first, then the fastest."""
    return not test.startswith(f"tests/{Path(path).parent.as_posix()}/"), seconds.get(test, math.inf)


def tests_of(path: str, line: int, most: float) -> list[list[str]]:
    """The tests that run a line, those of its folder and the fastest first, then those that run other lines of the
    file, which may depend on a line that only imports run, then the others of the folder and those of neighbouring
    folders, which share fixtures and caches that may have run it; as many as take `most` [s] together: a few, and the
    others."""
    seconds = recorded()["seconds"]
    of_file = recorded()["lines"].get(path, {})
    direct, beside = set(of_file.get(str(line), ())), set(itertools.chain.from_iterable(of_file.values()))
    files = {test.partition("::")[0] for test in direct or beside}
    every = {test for test in seconds if not _order(test, path, seconds)[0] or test.partition("::")[0] in files}
    tests = sorted(
        every | beside, key=lambda test: (test not in direct, test not in beside, *_order(test, path, seconds))
    )
    spent, out = 0.0, list[str]()
    for test in tests:
        spent += seconds.get(test, most)
        if out and spent > most:
            break
        out.append(test)
    return [group for group in (out[:FEW], out[FEW:]) if group]


class Instead(importlib.abc.MetaPathFinder, importlib.abc.InspectLoader):
    """Imports a mutant in the place of its module."""

    def __init__(self, mutant: Mutant) -> None:
        self.name, self.file, self.source = module_name(mutant.path), str(ROOT / mutant.path), mutant.source

    def find_spec(self, fullname: str, path: object = None, target: object = None):
        if fullname != self.name:
            return None
        package = self.file.endswith("__init__.py")
        spec = importlib.util.spec_from_loader(fullname, self, origin=self.file, is_package=package)
        if spec is not None and package:
            spec.submodule_search_locations = [str(Path(self.file).parent)]
        return spec

    def get_source(self, fullname: str) -> str:
        return self.source

    def is_package(self, fullname: str) -> bool:
        return self.file.endswith("__init__.py")


class Failed:
    """Writes the name of a test that fails into a file, as a plugin of pytest."""

    def pytest_runtest_logreport(self, report) -> None:
        if report.failed:
            FAILED.write_text(report.nodeid, encoding="utf-8")


def _run(mutant: Mutant | None, tests: list[str]) -> int:
    """Pytest's exit code, in a process of its own with the mutant in place."""
    import pytest

    os.chdir(ROOT)
    if mutant is not None:
        sys.meta_path.insert(0, Instead(mutant))
    words = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-o", "addopts=--import-mode=importlib"]
    words += ["-W", "ignore::pytest.PytestAssertRewriteWarning", "--hypothesis-seed=0", "--no-header", "--tb=no"]
    sink = open(os.devnull, "w")  # noqa: PTH123, SIM115  # as long as the process is there
    sys.stdout = sys.stderr = sink
    return int(pytest.main([*words, *tests], plugins=[Failed()]))


def start_process(mutant: Mutant | None, tests: list[str], seconds: float) -> int:
    """The number of a new process that runs the tests with a mutant, in so much time of a core [s]."""
    number = os.fork()
    if number:
        return number
    os.setsid()
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    code = 1
    try:
        code = _run(mutant, tests)
    except BaseException:  # a mutant may do anything; whatever ends the tests has caught it
        code = 1
    os._exit(code)


def ended(number: int, seconds: float) -> int | None:
    """The exit code of a process; None if it took so much time of a core, or waited for very much longer."""
    end = time.monotonic() + PATIENCE * seconds
    while time.monotonic() < end:
        process, status = os.waitpid(number, os.WNOHANG)
        if process:
            code = os.waitstatus_to_exitcode(status)
            return None if code in (-signal.SIGXCPU, -signal.SIGKILL) else code
        time.sleep(0.05)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(number, signal.SIGKILL)
    os.waitpid(number, 0)
    return None


@cache
def sound(names: tuple[str, ...], seconds: float) -> bool:
    """Whether tests are there and pass without a mutation; others can catch nothing."""
    return ended(start_process(None, list(names), seconds), seconds) in (0, NOTHING_TO_RUN)


def judged(mutant: Mutant, seconds: float) -> Outcome:
    """A mutant against one group of tests after another, until one catches it or the time is over."""
    start, verdict, tried = time.monotonic(), SURVIVED, []
    for names in tests_of(mutant.path, mutant.line, seconds):
        tried += names
        FAILED.unlink(missing_ok=True)
        most = MARGIN + 3 * sum(recorded()["seconds"][name] for name in names)
        code = ended(start_process(mutant, names, most), most)
        if code is None:
            verdict = HUNG
        elif code not in (0, NOTHING_TO_RUN):
            failed = (FAILED.read_text(encoding="utf-8"),) if FAILED.exists() else tuple(names)
            if not sound(failed, most):
                raise SystemExit(f"{' '.join(failed)}: gone, fails or hangs without a mutation")
            verdict = CAUGHT
        if verdict != SURVIVED:
            break
    spent = time.monotonic() - start
    return Outcome(mutant.path, mutant.line, mutant.before, mutant.after, verdict, round(spent, 1), tuple(tried))


def _without_shrinking() -> None:
    """Disable shrinking: a failure suffices, and the smallest example takes minutes."""
    from hypothesis import Phase, settings

    settings.register_profile("mutations", phases=[Phase.explicit, Phase.generate], database=None)
    settings.load_profile("mutations")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--record", action="store_true", help="record which tests run which lines")
    parser.add_argument("--skip", type=int, default=0, help="of those chosen, the first so many")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="of a core, for the tests of a mutant")
    parser.add_argument(
        "--only",
        nargs="*",
        default=[],
        metavar="FILE",
        help="files or folders, or FILE:LINE for every change of a line",
    )
    parser.add_argument("--json", type=Path, help="a file to which a line each is added")
    arguments = parser.parse_args()
    if arguments.record:
        record_all()
        return
    sys.path[:0] = [str(TESTS), str(TESTS / "support")]
    for name in HEAVY:
        importlib.import_module(name)
    _without_shrinking()
    verdicts: Counter[str] = Counter()
    for mutant in chosen(arguments.count, arguments.seed, arguments.only)[arguments.skip :]:
        outcome = judged(mutant, arguments.seconds)
        verdicts[outcome.verdict] += 1
        where = f"{outcome.path}:{outcome.line}"
        print(f"{outcome.verdict:8} {outcome.seconds:6.1f} s  {where}  {outcome.before} → {outcome.after}", flush=True)
        if arguments.json is not None:
            with arguments.json.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(asdict(outcome)) + "\n")
    total = sum(verdicts.values())
    print(f"{total} mutants: {verdicts[CAUGHT]} caught, {verdicts[SURVIVED]} survived, {verdicts[HUNG]} hung")


if __name__ == "__main__":
    main()
