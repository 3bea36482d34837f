"""One evaluation of run_and_step's objective, every penalty with torque, beside MuJoCo's loop over the samples."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise

import mujoco
import numpy as np
from bench import Effort, Section, Target, alternated, median

from dynsplines import recordings
from dynsplines.solver import Frame, Objective, Path, Quadrature, Settings, Timeline, inbetween
from dynsplines.solver.curve.spline import Spline
from dynsplines.solver.figure.dynamics import velocities

SAMPLES = 100
LEAST_PER_SPAN = 4
REPEATS, IN_A_ROW = (20, 3), 10


def coarse(raw: Timeline) -> Timeline:
    """A timeline with as many variable frames as 100 uniform samples allow: four samples in the shortest span."""
    shortest = LEAST_PER_SPAN * (raw.times[-1] - raw.times[0]) / SAMPLES
    path = Path(Spline(raw.times, raw.ends), np.asarray(raw.rows))
    times = [np.linspace(a, b, max(int((b - a) / shortest + 1e-9), 1) + 1)[1:-1] for a, b in pairwise(raw.times)]
    inner = np.concatenate(times)
    return raw.insert(Frame.variable(t, state) for t, state in zip(inner, path.at(inner), strict=True))


def mujoco_loop(objective: Objective, path: Path, t: np.ndarray) -> Callable[[], None]:
    """`mj_kinematics` and `mj_inverse` of the same samples, one by one in Python, contacts and limits off."""
    model = objective.figure.model
    model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
    data = mujoco.MjData(model)
    samples = objective.samples(path, t)
    qpos, (qvel, qacc) = objective.figure.to_qpos(samples.y), velocities(samples)

    def run() -> None:
        for q, v, a in zip(qpos, qvel, qacc, strict=True):
            data.qpos[:], data.qvel[:], data.qacc[:] = q, v, a
            mujoco.mj_kinematics(model, data)
            mujoco.mj_inverse(model, data)

    return run


def in_a_row(work: Callable[[], object]) -> None:
    """Evaluate repeatedly, as a search does: with warm caches except for the first time."""
    for _ in range(IN_A_ROW):
        work()


def measure(effort: Effort) -> Section:
    problem = recordings.load("run_and_step")
    solution = inbetween(replace(problem.problem, settings=Settings(variable=0, frames=0)))
    timeline = coarse(solution.raw)
    objective = replace(solution.objective, quadrature=Quadrature("uniform", SAMPLES))
    discretised = objective.on(timeline)
    x = discretised.unknowns.start
    path = discretised.path(x)
    t, weights = objective.quadrature.nodes(timeline.times)
    effort.report(f"{t.size} samples, {x.size} unknowns")
    works: dict[str, Callable[[], object]] = {
        "objective and gradient": lambda: discretised(x),
        "values alone": lambda: weights @ objective.density(objective.samples(path, t)),
        "mj_kinematics + mj_inverse, Python loop": mujoco_loop(objective, path, t),
    }
    rows = {name: partial(in_a_row, work) for name, work in works.items()}
    times, _ = alternated(rows, effort.count(*REPEATS))
    times = {name: [spent / IN_A_ROW for spent in values] for name, values in times.items()}
    section = Section(
        f"One evaluation of run_and_step, every penalty with torque, {t.size} samples",
        ("what", "median [ms]", "least [ms]", "µs a sample"),
    )
    middle = {name: median(values) for name, values in times.items()}
    for name, values in times.items():
        section.add(name, 1e3 * middle[name], 1e3 * min(values), 1e6 * middle[name] / t.size)
    both, alone, loop = middle.values()
    section.targets = [
        Target("objective and gradient", 1e3 * both, 2.5, unit="ms"),
        Target("values alone / MuJoCo's loop", alone / loop, 5.0),
    ]
    names = ", ".join(penalty.name for penalty, _ in problem.penalties)
    section.notes = [
        f"penalties: {names}; {timeline.variable_count} variable frames, {x.size} unknowns; "
        f"medians of {len(times['values alone'])} runs in turn, each {IN_A_ROW} evaluations in a row; "
        "values alone include the spline at the samples; MuJoCo's loop has kinematics and inverse dynamics of the same "
        "states and no penalty",
    ]
    section.data = {"times": times, "samples": t.size, "unknowns": x.size}
    return section
