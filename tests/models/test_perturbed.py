"""Quick clips do not whip when their keyframes are moved at random; the benchmark solves as the command does."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from dynsplines import solving
from dynsplines.clip import load as clips
from dynsplines.solver import Solution

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


@pytest.fixture(scope="module")
def run(benchmark) -> Solution:
    return benchmark.solved(clips.load("run_loop"))


@pytest.mark.slow
@pytest.mark.parametrize(("name", "count"), [("run_loop", 3), ("walk_loop", 2)])
def test_quick_clips_do_not_whip_when_their_keyframes_move_a_little(benchmark, name, count):
    section = benchmark.compared([name], range(count), benchmark.Effort(quick=True, tell=lambda _: None))
    assert [target.met for target in section.targets] == [True] * 3
    ((clip, sets, *_),) = section.rows
    assert (clip, sets) == (name, count)
    assert len(section.data["sets"]) == count
    assert {each["seed"] for each in section.data["sets"]} == set(range(count))


@pytest.mark.slow
def test_solving_is_what_the_command_does(benchmark, run):
    from dynsplines.system.progress import Progress

    done = solving.solve(clips.load("run_loop"), Progress())
    np.testing.assert_array_equal(done.motion.timeline.rows, run.timeline.rows)
