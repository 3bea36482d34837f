"""Recordings brought on to a robot: beside frame-by-frame inverse kinematics with mink, which many retargeters use.

    DYNSPLINES_RECORDINGS=FOLDER_OF_BVH DYNSPLINES_ROBOT=g1.xml python benchmarks/run.py --only framewise

Without the first, walks and runs of ours are written as BVH and read again; without the second they go to the human.
mink gets the same map: of every sample of the recording, brought on to the figure, the places of pelvis, hands and feet
and the rotations of all bodies that the map knows, weighed about as GMR weighs them, in the joints' ranges, from where
the sample before ended. Both are measured by the same functions, on the same stances.
"""

from __future__ import annotations

import io
import os
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from bench import Effort, Section, Target, peer
from rich.console import Console

from dynsplines import kept
from dynsplines.clean import running
from dynsplines.clean.cleaning import Cleaned
from dynsplines.clean.comparing import Comparison, Look, followed
from dynsplines.clip import load as clips
from dynsplines.exchange import formats
from dynsplines.exchange.skeleton import hierarchy
from dynsplines.exchange.skeleton.roles import roles
from dynsplines.solver.array import Array
from dynsplines.solver.curve.spline import Path as Curve
from dynsplines.solver.figure.figure import Figure
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.reading.recorded import Recorded
from dynsplines.system.progress import Teller

STEPS, ROUNDS = 0.02, 10  # [s] of mink's integration, and how many for each sample
DAMPING, POSTURE = 1e-3, 1e-2
PLACE, TURN = 50.0, 10.0  # weights of hands' and feet's places, and of all rotations
FIRM = ("foot", "hand", "pelvis")


def quiet() -> Teller:
    return Teller(Console(file=io.StringIO()))


def recordings(effort: Effort, folder: Path) -> Iterator[Path]:
    told = os.environ.get("DYNSPLINES_RECORDINGS")
    if told is not None:
        yield from sorted(Path(told).glob("*.bvh"))[: effort.count(50, 1)]
        return
    for name in ("walk_loop", "run_and_step", "walk_and_turn")[: effort.count(3, 1)]:
        saved = kept.solved(clips.load(name), quiet()).saved(quiet(), with_report=False)
        formats.export(saved, "bvh", folder / f"{name}.bvh", fps=60)
        yield folder / f"{name}.bvh"


def framewise(mink: Any, figure: Figure, wanted: Array) -> Array:
    """(T, nq) by mink, near the poses that are wanted (T, nq), which may leave the joints' ranges."""
    model = figure.model
    found = roles(hierarchy.names(model)[1:], [int(parent) - 1 for parent in model.body_parentid[1:]])
    bodies = {role: model.body(1 + body).name for role, body in found.items() if model.body(1 + body).name}
    tasks = [
        mink.FrameTask(name, "body", position_cost=PLACE if role.endswith(FIRM) else 0.0, orientation_cost=TURN)
        for role, name in bodies.items()
    ]
    posture = mink.PostureTask(model, cost=POSTURE)
    at, goal = mink.Configuration(model), mujoco.MjData(model)
    at.update(model.qpos0)
    posture.set_target_from_configuration(at)
    limits, out = [mink.ConfigurationLimit(model)], np.empty(wanted.shape)
    for i, row in enumerate(wanted):
        goal.qpos[:] = row
        mujoco.mj_kinematics(model, goal)
        for task in tasks:
            body = goal.body(task.frame_name)
            task.set_target(mink.SE3(np.concatenate([body.xquat, body.xpos])))
        for _ in range(ROUNDS if i else 20 * ROUNDS):
            velocity = mink.solve_ik(at, [*tasks, posture], STEPS, "daqp", damping=DAMPING, limits=limits)
            at.integrate_inplace(velocity, STEPS)
        out[i] = at.q
    return out


def off(figure: Figure, one: Curve, other: Curve, t: Array) -> Array:
    """[cm] by which hands, feet and pelvis are apart: of the worst of them the median and what 95 % stay below."""
    links = np.array(followed(figure))
    centres = np.array([figure.links[i].centre for i in links]).T
    places = [Samples(figure, *path.motion(t)).links.points(links, centres)[0] for path in (one, other)]
    apart = 100 * np.linalg.norm(places[0] - places[1], axis=0)
    return np.array([np.median(apart, axis=1).max(), np.percentile(apart, 95, axis=1).max()])


def measured(found: Cleaned, path: Curve) -> tuple[float, ...]:
    """Depth [mm], slip [mm], off the recording in the median and 95 % [cm], beyond ranges [°], jerk, force."""
    times = Comparison(found).times
    look = Look(found, path, times)
    median, high = off(found.figure, found.recorded.path, path, times)
    return look.depth, look.slip, float(median), float(high), look.range, look.jerk, look.force


def measure(effort: Effort) -> Section:
    section = Section(
        "Recordings on a robot: with `retarget`, and with mink, frame by frame.",
        ("recording", "by", "deepest [mm]", "slip [mm]", "off: median [cm]", "95 % [cm]", "beyond ranges [°]",
         "jerk [m/s³]", "force [weight]", "× real time"),
    )  # fmt: skip
    mink = peer("mink")
    if mink is None:
        section.notes.append("mink is not installed (pip install mink daqp): ours alone")
    robot = os.environ.get("DYNSPLINES_ROBOT", "human")
    ours: list[Array] = []
    theirs: list[Array] = []
    with tempfile.TemporaryDirectory() as folder:
        for file in recordings(effort, Path(folder)):
            effort.tell(file.stem)
            begin = time.perf_counter()
            found, _ = running.made(running.Source(file, robot, apart=True), None, quiet())
            first, last = found.before.span
            row = measured(found, found.after)
            begin = time.perf_counter() - begin
            ours.append(np.array(row))
            section.add(file.stem, "ours", *row, (last - first) / begin)
            if mink is None:
                continue
            t = found.recorded.times
            wanted = found.figure.to_qpos(found.before.at(t))
            begin = time.perf_counter()
            qpos = framewise(mink, found.figure, wanted)
            begin = time.perf_counter() - begin
            path = Recorded.of(found.figure, t, qpos).path
            row = measured(found, path)
            theirs.append(np.array(row))
            section.add(file.stem, "mink", *row, (last - first) / begin)
    most, mine = np.max(ours, axis=0), np.array(ours)
    section.targets = [
        Target("deepest sole", most[0], 2.0, unit="mm"),
        Target("slip of a stance", most[1], 10.0, unit="mm"),
        Target("off the recording, median", most[2], 4.0, unit="cm"),
        Target("off the recording, 95 %", most[3], 9.0, unit="cm"),
        Target("beyond ranges", most[4], 0.0, unit="°"),
    ]
    if theirs:
        share = mine / np.maximum(np.array(theirs), 1e-9)
        section.targets += [
            Target(f"{what}, worst share of mink's", float(share[:, i].max()), bound)
            for what, i, bound in (("slip", 1, 0.2), ("off, 95 %", 3, 1.2), ("jerk", 5, 0.3), ("force", 6, 0.4))
        ]
    return section
