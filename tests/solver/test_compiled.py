"""The compiled kernel gives what NumPy gives, and refuses what does not fit."""

import subprocess
import sys

import numpy as np
import pytest

from dynsplines.clip import load as clips
from dynsplines.solver import compiled
from dynsplines.solver.figure.wrenches import VECTORS, Wrenches
from dynsplines.solver.refine.subdivision import midpoints, split
from dynsplines.solver.search.quadratic import Layout, Model

needs_kernel = pytest.mark.skipif(compiled.kernel is None, reason="the kernel was not built")


@needs_kernel
@pytest.mark.parametrize("name", ["run_and_step", "walk_loop"])
def test_a_model_by_the_kernel_is_numpys(name, monkeypatch):
    problem = clips.load(name).problem
    discretised = problem.objective.on(split(problem.raw, midpoints(problem.raw)))
    x = discretised.unknowns.start
    gradient = discretised(x).gradient
    models, steps = [], []
    for kernel in (compiled.kernel, None):
        monkeypatch.setattr(compiled, "kernel", kernel)
        models.append(Model(Layout(discretised), x, gradient))
        steps.append(models[-1].minimise(models[-1].scale))
    lower = models[1].layout.factor(models[1].curvature)
    assert lower is not None
    np.testing.assert_allclose(
        models[0].layout.factor(models[0].curvature), lower, rtol=1e-6, atol=1e-9 * np.abs(lower).max()
    )
    np.testing.assert_allclose(steps[0].predicted_reduction, steps[1].predicted_reduction, rtol=1e-6)
    np.testing.assert_allclose(steps[0].step, steps[1].step, rtol=0, atol=1e-5 * np.abs(steps[1].step).max())


@needs_kernel
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_weighted_squares_by_the_kernel_are_numpys(sign, rng, monkeypatch):
    problem = clips.load("walk_loop").problem
    discretised = problem.objective.on(problem.raw)
    x = discretised.unknowns.start
    model = Model(Layout(discretised), x, discretised(x).gradient)
    sampling = model.layout.sampling
    at = np.sort(rng.integers(sampling.first.size, size=40))
    rows, weight = rng.normal(size=(40, problem.figure.width)), sign * rng.uniform(0.1, 9, 40)
    matrices = []
    for kernel in (compiled.kernel, None):
        monkeypatch.setattr(compiled, "kernel", kernel)
        matrices.append(np.zeros_like(model.curvature))
        model.layout.add_rows_by_y(matrices[-1], sampling, at, rows, weight)
    np.testing.assert_allclose(matrices[0], matrices[1], rtol=0, atol=1e-12 * np.abs(matrices[0]).max())
    assert np.abs(matrices[0]).max() > 0


@needs_kernel
def test_rows_by_the_kernel_are_numpys(rng, monkeypatch):
    problem = clips.load("run_and_step").problem
    discretised = problem.objective.on(problem.raw)
    samples = discretised.evaluated_runs(discretised.unknowns.start)[0].samples
    at, link = rng.integers(samples.count, size=100), rng.integers(len(samples.figure.links), size=100)
    wrenches = Wrenches(at, link, **{vector: rng.normal(size=(3, 100)) for vector in VECTORS})
    ours = wrenches.rows(samples)
    monkeypatch.setattr(compiled, "kernel", None)
    theirs = wrenches.rows(samples)
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-12 * np.abs(theirs).max())


@needs_kernel
def test_it_refuses_what_does_not_fit():
    rank, first, phi = np.arange(6), np.array([0, 2]), np.ones((2, 4))
    rows, weight, at = np.ones((3, 2)), np.ones(3), np.array([0, 0, 1])
    room = np.zeros((6, 2, 5, 2))
    compiled.call("add_squares", room, rank, first, phi, at, rows, weight)
    assert room.sum() > 0
    for wrong in (
        (rank, first, phi, np.array([0, 0, 2]), rows, weight),  # a sample that there is not
        (rank, np.array([0, 3]), phi, at, rows, weight),  # coefficients past the end
        (rank[::-1] * 2, first, phi, at, rows, weight),
        (rank, first, phi, at[::-1], rows, weight),  # not rising
        (rank, first, phi[:1], at, rows, weight),
        (rank, first, phi, at, rows, weight[:2]),
    ):
        with pytest.raises(ValueError, match="do not fit"):
            compiled.call("add_squares", room, *wrong)
    with pytest.raises(ValueError, match="do not fit"):
        blocks = np.ones((2, 1, 3, 2, 3, 2))
        compiled.call("add_blocks", room, rank, first, np.ones((2, 3, 4)), np.array([[0, 2]]), blocks, 2)


def test_version_prints_the_kernel_in_use():
    code = "from dynsplines.__main__ import main; import sys; sys.argv = ['dynsplines', '--version']; main()"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert ("the compiled kernel" in told) is (compiled.kernel is not None)
    assert ("NumPy alone" in told) is (compiled.kernel is None)
