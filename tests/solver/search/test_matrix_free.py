"""The search without matrices: nearly as low as Gauss-Newton, stopped as asked, in memory linear in the joints."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from dense_hessian import flat_energy
from small_problems import problem_of

from dynsplines.solver.objective import Discretised
from dynsplines.solver.search import descent
from dynsplines.solver.search.descent import Descent
from dynsplines.solver.search.matrix_free import FlatMetric, matrix_free
from dynsplines.solver.search.minimum import Stop
from dynsplines.solver.search.newton import GaussNewton, Search


@pytest.fixture
def problem(rng: np.random.Generator) -> Discretised:
    return problem_of(rng)


@pytest.mark.parametrize("ends", ["free", "clamped", "periodic"])
def test_it_ends_nearly_as_low_as_gauss_newton(rng: np.random.Generator, ends: str) -> None:
    problem = problem_of(rng, ends)
    found = matrix_free(problem, max_evaluations=500, tolerance=1e-8)
    lowest = GaussNewton()(problem, tolerance=1e-9)
    assert found.stop is Stop.CONVERGED
    assert found.value <= 1.01 * lowest.value
    assert problem(found.x).value == found.value


def test_at_a_minimum_it_ends_after_one_more_evaluation(problem: Discretised) -> None:
    found = matrix_free(problem, max_evaluations=500, tolerance=1e-8)
    there = problem.objective.on(problem.timeline.with_rows(problem.unknowns.rows(found.x)))
    again = matrix_free(there, max_evaluations=500, tolerance=1e-8)
    assert (again.stop, again.evaluations) == (Stop.CONVERGED, 2)


def test_figures_of_many_joints_are_searched_like_that(
    problem: Discretised, rng: np.random.Generator, monkeypatch: pytest.MonkeyPatch
) -> None:
    free = problem_of(rng)
    own = Descent(free.objective, free.timeline).run(max_evaluations=4)
    monkeypatch.setattr(descent, "WIDEST", 1)
    found = Descent(free.objective, free.timeline).run(max_evaluations=4)
    wanted = matrix_free(free, max_evaluations=4, tolerance=1e-6)
    assert found.value == wanted.value != own.value


CHAIN = """
import sys
from dataclasses import replace
from dynsplines import inbetween, load

def arm(count):
    links = "".join(
        f'<body pos="0 0 -.1"><joint name="{letter}{i}" axis="{i % 2} {1 - i % 2} 0" range="-90 90"/>'
        '<geom type="capsule" size=".02" fromto="0 0 0 0 0 -.1"/>' for i in range(count))
    return links + "</body>" * count

arms = []
for letter in "abcdefgh"[: int(sys.argv[1])]:
    arms.append(f'<body pos="{ord(letter)} 0 0">{arm(100)}</body>')
open("chain.xml", "w").write(
    '<mujoco><compiler autolimits="true"/><worldbody><geom type="plane" size="1 1 .1"/>'
    f'<body pos="0 0 12"><freejoint/><geom size=".1"/>{"".join(arms)}</body></worldbody></mujoco>')
open("chain.toml", "w").write('figure = "chain.xml"\\n' + "".join(
    f'[[keyframe]]\\ntime = {time}\\nothers = "rest"\\njoints.a3 = {10 * time}\\n' for time in (0, 0.5, 1)))
clip = load("chain.toml")
inbetween(clip.with_problem(settings=replace(clip.settings, max_evaluations=3, frames=0)))
(peak,) = [line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM:")]
print(peak)  # of this program alone: what getrusage says begins with that of whoever started it
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="asks Linux for the most memory it took")
def test_four_hundred_joints_take_little_memory_and_about_twice_that_of_two_hundred(tmp_path) -> None:
    most = []
    for arms in (2, 4):
        words = [sys.executable, "-c", CHAIN, str(arms)]
        out = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
        most.append(int(out.stdout) / 1000)
    assert most[1] < 300  # [MB]; the program itself is 100, what MuJoCo takes to read it 130
    assert most[1] - most[0] < 2.5 * (most[0] - 100)


def test_its_metric_is_the_flat_energy_in_the_unknowns_held_where_keyframes_are() -> None:
    """Where no joint hangs on another's unknowns; such ties are left out."""
    rng = np.random.default_rng(3)
    problem = problem_of(rng, "clamped", "joint")
    metric = FlatMetric(Search(problem, 9, 1.0, None).layout)
    metric.unit = 4.0
    gradients = rng.normal(size=(4, problem.unknowns.size))
    found = np.array([metric.to_x(metric.gradient(g)) for g in gradients])
    expected = np.linalg.solve(metric.unit * flat_energy(problem), gradients.T).T
    np.testing.assert_allclose(found, expected, atol=0.02 * np.abs(expected).max())
