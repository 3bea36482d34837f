"""Quick clips do not whip when their keyframes are moved at random; the benchmark solves as the command does."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

FOLDER = Path(__file__).parents[2] / "benchmarks"
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "BLIS_NUM_THREADS", "NUMEXPR_NUM_THREADS",
           "VECLIB_MAXIMUM_THREADS")  # fmt: skip


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    with pytest.MonkeyPatch.context() as patch:
        for name in THREADS:
            patch.setenv(name, "1")
        patch.syspath_prepend(str(FOLDER))
        spec = importlib.util.spec_from_file_location("perturbed_benchmark", FOLDER / "perturbed.py")
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        patch.setitem(sys.modules, spec.name, module)
        own = set(sys.modules)
        spec.loader.exec_module(module)
        for name in set(sys.modules) - own:
            if str(FOLDER) in str(getattr(sys.modules[name], "__file__", "")):
                del sys.modules[name]
        return module


@pytest.mark.slow
def test_a_quick_clip_does_not_whip_when_its_keyframes_move_a_little(benchmark):
    name, count = "run_loop", 3
    section = benchmark.compared([name], range(count), benchmark.Effort(quick=True, report=lambda _: None))
    assert [target.met for target in section.targets] == [True] * 3
    ((clip, sets, *_),) = section.rows
    assert (clip, sets) == (name, count)
    assert len(section.data["sets"]) == count
    assert {each["seed"] for each in section.data["sets"]} == set(range(count))


@pytest.mark.slow
def test_an_arm_comes_over_the_rail_that_the_spline_passes_through(benchmark):
    """The spline through these keyframes crosses the rail; near it, opposite directions lead out on its two sides."""
    section = benchmark.compared(["hand_on_rail"], (48, 60, 109), benchmark.Effort(quick=True, report=lambda _: None))
    assert [target.met for target in section.targets] == [True] * 3
    for outcome in section.data["sets"]:
        assert outcome["parts"]["collision.body"] < 1
