"""How long the parts of the main job take, beside MuJoCo's own loops, in one run: medians.

    OMP_NUM_THREADS=1 python benchmarks/speed.py [--json FILE]

The values alone are compared with `mj_kinematics` + `mj_inverse` (contacts off) in a Python loop over the same samples.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np

from runner import clip as clips
from solver import Motion, Quadrature, inbetween
from solver.dynamics import velocities
from solver.subdivision import by_weak_form

REPEATS = 5


def median_ms(work: Callable[[], object], repeats: int = REPEATS) -> float:
    """The median time of a piece of work [ms]."""
    times = []
    for _ in range(repeats):
        begin = time.perf_counter()
        work()
        times.append(1e3 * (time.perf_counter() - begin))
    return statistics.median(times)


def mujoco_loop(motion: Motion, samples: int) -> Callable[[], None]:
    """Kinematics and inverse dynamics of the same samples by MuJoCo, one by one."""
    model = motion.figure.model
    flags = int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
    model.opt.disableflags |= flags
    data = mujoco.MjData(model)
    seen = motion.objective.samples(motion.path, np.linspace(*motion.path.span, samples))
    qpos, (qvel, qacc) = motion.figure.to_qpos(seen.y), velocities(seen)

    def run() -> None:
        for q, v, a in zip(qpos, qvel, qacc, strict=True):
            data.qpos[:], data.qvel[:], data.qacc[:] = q, v, a
            mujoco.mj_kinematics(model, data)
            mujoco.mj_inverse(model, data)

    return run


def measure() -> dict[str, float]:
    """The table's figures [ms]."""
    clip = clips.load("run_and_step")

    def solve() -> Motion:
        return inbetween(clip.figure, clip.keys, clip.penalties, clip.settings)

    motion = solve()
    objective = replace(motion.objective, quadrature=Quadrature("uniform", 100))
    keys = replace(motion.timeline, frames=motion.timeline.frames[::2])
    problem = objective.on(keys)
    x, count = problem.unknowns.start, problem.weights.size
    t = np.linspace(*motion.path.span, count)
    return {
        "samples": float(count),
        "objective and gradient, every penalty": median_ms(lambda: problem(x), 40),
        "values alone": median_ms(lambda: objective.density(objective.samples(motion.path, t)), 40),
        "mj_kinematics + mj_inverse, Python loop": median_ms(mujoco_loop(motion, count), 40),
        "weak form over all segments": median_ms(lambda: by_weak_form(motion.objective, motion.timeline), 3),
        "run_and_step, subdivision included": median_ms(solve, 5),
        "evaluations": float(motion.evaluations),
    }


def main() -> None:
    """Prints the table, and writes it as JSON where asked."""
    parser = argparse.ArgumentParser(description="times of the main job's parts")
    parser.add_argument("--json", type=Path, help="write the figures there")
    arguments = parser.parse_args()
    figures = measure()
    versions = {"python": platform.python_version(), "numpy": np.__version__, "mujoco": mujoco.__version__}
    versions["OMP_NUM_THREADS"] = os.environ.get("OMP_NUM_THREADS", "not set")
    print("| what | median |\n|---|---|")
    for name, value in figures.items():
        unit = "" if name in ("samples", "evaluations") else " ms"
        print(f"| {name} | {value:.4g}{unit} |")
    print(", ".join(f"{name} {version}" for name, version in versions.items()))
    if arguments.json is not None:
        arguments.json.write_text(json.dumps({"figures": figures, "versions": versions}, indent=2), encoding="utf-8")


if __name__ == "__main__":
    main()
