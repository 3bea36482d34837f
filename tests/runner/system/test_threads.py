"""A search in a program has one thread of linear algebra."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

from dynsplines.system import threads

BUSY = """
import json
from dynsplines import load
from dynsplines.solver import Settings, inbetween
from threadpoolctl import threadpool_info

def threads():
    return [library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"]

clip, seen, before = load("tumble"), [], threads()
inbetween(clip.with_problem(settings=Settings(max_evaluations=2)).problem, improved=lambda _: seen.append(threads()))
print(json.dumps([before, seen, threads()]))
"""


@pytest.mark.slow
def test_a_search_in_a_program_of_the_user_has_one_thread_and_gives_the_others_back() -> None:
    environment = {name: value for name, value in os.environ.items() if name not in threads.THREADS}
    environment["OPENBLAS_NUM_THREADS"] = "2"
    done = subprocess.run([sys.executable, "-c", BUSY], env=environment, capture_output=True, text=True, check=True)
    before, seen, after = json.loads(done.stdout)
    if not before or set(before) == {1}:
        pytest.skip("linear algebra has one thread here anyway")
    assert seen and {count for counts in seen for count in counts} == {1}
    assert after == before
