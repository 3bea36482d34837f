"""The examples in the docstrings of the API run and print the output shown."""

import doctest
from pathlib import Path

import pytest
import shipped

from dynsplines.python import functions, motion

FINDER = doctest.DocTestFinder()
EXAMPLES = [test for module in (functions, motion) for test in FINDER.find(module, globs={}) if test.examples]
NAMES = [example.name.removeprefix("dynsplines.python.") for example in EXAMPLES]


@pytest.mark.parametrize("example", EXAMPLES, ids=NAMES)
def test_an_example_prints_the_output_shown(
    example: doctest.DocTest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shipped.share(monkeypatch)
    lines: list[str] = []
    doctest.DocTestRunner(verbose=False).run(example, out=lines.append)
    assert not lines, "".join(lines)


def test_the_functions_that_users_call_most_have_examples() -> None:
    most_called = ("Keyframe", "build", "load", "inbetween", "load_motion", "import_motion")
    methods = ("at", "sampled", "forces", "report", "violations", "difference", "save", "export")
    assert {f"functions.{name}" for name in most_called} <= set(NAMES)
    assert {f"motion.Motion.{name}" for name in methods} <= set(NAMES)
