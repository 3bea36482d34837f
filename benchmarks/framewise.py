"""Recordings brought on to a robot: beside frame-by-frame inverse kinematics with mink, which many retargeters use.

    DYNSPLINES_RECORDINGS=FOLDER_OF_BVH DYNSPLINES_ROBOT=g1.xml python benchmarks/run.py --only framewise

Without the first, walks and runs of ours are written as BVH and read again; without the second they go to the human.
mink gets the same bone map. Of every sample it tracks the positions of hands and feet relative to shoulders and hips,
scaled by the lengths of arms and legs, that of the pelvis, and the rotations of all mapped bodies, weighted about as
in GMR, in the joints' ranges, starting from the sample before. Both programs are measured by the same functions, on
the same stances, and on the floor that `retarget` infers; mink's samples are joined by a spline. The errors of hands
and feet are relative to these targets. mink is given the compiled robot model, `retarget` reads and compiles it with
its meshes: the last column excludes that time.
"""

from __future__ import annotations

import io
import os
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from bench import Effort, Section, Target, peer
from rich.console import Console

from dynsplines import solving
from dynsplines.clean import command
from dynsplines.clean.cleaning import RATE, Cleaned, depth
from dynsplines.clean.displacement import slip
from dynsplines.clip import load as clips
from dynsplines.exchange import formats
from dynsplines.exchange.skeleton import bvh_file, hierarchy
from dynsplines.exchange.skeleton.captured_skeleton import CapturedSkeleton
from dynsplines.exchange.skeleton.roles import roles
from dynsplines.motion import even_times, samples_at
from dynsplines.scene.assets import taken_along
from dynsplines.scene.compose import compose, figure_spec
from dynsplines.solver.array import Array
from dynsplines.solver.curve.recording import RecordedMotion
from dynsplines.solver.curve.spline import Path as Curve
from dynsplines.solver.curve.spline import natural_spline
from dynsplines.solver.penalty import JointRange, Support, joint_ranges
from dynsplines.system.progress import Progress

STEPS, ROUNDS = 0.02, 10  # [s] of mink's integration, and how many for each sample
DAMPING, POSTURE = 1e-3, 1e-2
PLACE, TURN = 50.0, 10.0  # weights of hands' and feet's places, and of all rotations
LEG, ARM = ("thigh", "shin"), ("upper_arm", "forearm")
ENDS = {
    f"{side}_{end}": (f"{side}_{first}", f"{side}_{middle}")
    for side in ("left", "right")
    for end, (first, middle) in (("foot", LEG), ("hand", ARM))
}


def quiet() -> Progress:
    return Progress(Console(file=io.StringIO()))


def recordings(effort: Effort, folder: Path) -> Iterator[Path]:
    named_folder = os.environ.get("DYNSPLINES_RECORDINGS")
    if named_folder is not None:
        yield from sorted(Path(named_folder).glob("*.bvh"))[: effort.count(50, 1)]
        return
    for name in ("walk_loop", "run_and_step", "walk_and_turn")[: effort.count(3, 1)]:
        saved = solving.solve(clips.load(name), quiet()).saved(quiet(), with_report=False)
        formats.export(saved, "bvh", folder / f"{name}.bvh", fps=60)
        yield folder / f"{name}.bvh"


@dataclass(frozen=True, eq=False)
class Goal:
    """The targets of both programs: positions of the recording's hands and feet, scaled by the length of the legs.

    bodies  of the figure by role; place {role: (T, 3)} [m], turn {role: (T, 4)} at the times t (T,) of the samples
    """

    model: mujoco.MjModel
    t: Array
    bodies: dict[str, int]
    place: dict[str, Array]
    turn: dict[str, Array]

    @classmethod
    def of(cls, file: Path, result: Cleaned) -> Goal:
        model, t = result.figure.model, result.recorded.times
        skeleton = bvh_file.read(file)
        captured = CapturedSkeleton.of(skeleton)
        at = np.minimum(np.round(t * skeleton.fps).astype(int), len(captured.position) - 1)
        bodies = {r: 1 + i for r, i in roles(hierarchy.names(model)[1:], list(model.body_parentid[1:] - 1)).items()}
        places, turned = poses(model, result.figure.to_qpos(result.before.at(t)))
        raised = np.array([0, 0, np.median((result.recorded.path.at(t) - result.before.at(t))[:, 2])])  # to its floor
        places = places + raised
        rest, _ = poses(model, np.array(model.qpos0)[None])
        seat = {role: first_body(model, body, set(bodies.values())) for role, body in bodies.items()}
        joints = {role: rest[0, body if role in ENDS else seat[role]] for role, body in bodies.items()}
        theirs = captured.roles
        other = {role: captured.at_zero[joint] for role, joint in theirs.items()}
        place = {}
        for role, (first, middle) in ENDS.items():
            if all(part in bodies and part in theirs for part in (role, first, middle)):
                scale = length(joints, (first, middle, role)) / length(other, (first, middle, role))
                about = captured.position[at][:, theirs[role]] - captured.position[at][:, theirs[first]]
                place[role] = places[:, seat[first]] + scale * about
        place["pelvis"] = places[:, bodies["pelvis"]]
        return cls(model, t, bodies, place, {role: turned[:, body] for role, body in bodies.items()})

    def deviation(self, qpos: Array) -> tuple[float, float]:
        """[cm] by which hands and feet of a motion (T, nq) are off: of the worst of them median and 95 %."""
        places, _ = poses(self.model, qpos)
        apart = [100 * np.linalg.norm(places[:, self.bodies[role]] - self.place[role], axis=1) for role in ENDS
                 if role in self.place]  # fmt: skip
        return max(float(np.median(row)) for row in apart), max(float(np.percentile(row, 95)) for row in apart)


def first_body(model: mujoco.MjModel, body: int, others: set[int]) -> int:
    """The first body of a part of a limb: robots have one for every hinge."""
    while int(model.body_parentid[body]) not in {0, *others}:
        body = int(model.body_parentid[body])
    return body


def length(joints: Mapping[str, Array], chain: Sequence[str]) -> float:
    """[m] from joint to joint."""
    return float(sum(np.linalg.norm(joints[one] - joints[other]) for one, other in pairwise(chain)))


def poses(model: mujoco.MjModel, qpos: Array) -> tuple[Array, Array]:
    """Places (T, B, 3) [m] and quaternions (T, B, 4) of all bodies."""
    data = mujoco.MjData(model)
    place, turn = np.empty((len(qpos), model.nbody, 3)), np.empty((len(qpos), model.nbody, 4))
    for i, row in enumerate(qpos):
        data.qpos[:] = row
        mujoco.mj_kinematics(model, data)
        place[i], turn[i] = data.xpos, data.xquat
    return place, turn


def framewise(mink: Any, goal: Goal) -> Array:
    """(T, nq) by mink, one sample after the other."""
    model = goal.model
    tasks = {
        role: mink.FrameTask(
            model.body(body).name, "body", position_cost=PLACE if role in goal.place else 0.0, orientation_cost=TURN
        )
        for role, body in goal.bodies.items()
        if model.body(body).name
    }
    posture, at = mink.PostureTask(model, cost=POSTURE), mink.Configuration(model)
    at.update(model.qpos0)
    posture.set_target_from_configuration(at)
    limits, out = [mink.ConfigurationLimit(model)], np.empty((goal.t.size, model.nq))
    for i in range(goal.t.size):
        for role, task in tasks.items():
            place = goal.place[role][i] if role in goal.place else np.zeros(3)
            task.set_target(mink.SE3(np.concatenate([goal.turn[role][i], place])))
        for _ in range(ROUNDS if i else 20 * ROUNDS):
            velocity = mink.solve_ik(at, [*tasks.values(), posture], STEPS, "daqp", damping=DAMPING, limits=limits)
            at.integrate_inplace(velocity, STEPS)
        out[i] = at.q
    return out


def measured(result: Cleaned, path: Curve, goal: Goal) -> tuple[float, ...]:
    """Depth [mm], slip [mm], off the scaled recording in the median and 95 % [cm], beyond ranges [°], jerk, force."""
    times = even_times(path.span, RATE)
    samples = samples_at(result.figure, path, times)
    median, high = goal.deviation(result.figure.to_qpos(path.at(goal.t)))
    slips = [1000 * slip(result.figure, path, rest) for rest in result.rests]
    joints = joint_ranges(result.figure)
    beyond = float(np.degrees(np.sqrt(JointRange(joints).evaluate(samples).max()))) if joints else 0.0
    jerk = np.linalg.norm(np.diff(samples.links.x[:, 1:], 3, axis=2), axis=0).mean() * RATE**3
    support = next((penalty for penalty, _ in result.problem.penalties if isinstance(penalty, Support)), None)
    rest = np.zeros((3, 1)) if support is None else support.rest(samples)[:3][:, support.known(times)]
    force = float(np.linalg.norm(rest, axis=0).mean()) if rest.size else 0.0
    deepest = 1000 * float(depth(result.ground, path, times).max())
    return deepest, max(slips, default=0.0), median, high, beyond, float(jerk), force


def reading(robot: str) -> float:
    """[s] that it takes to read a robot, to put it on a stage and to compile both, as `retarget` does."""
    begin = time.perf_counter()
    spec = figure_spec(robot)
    spec.assets = dict(taken_along(spec))
    model = spec.compile()
    clips.figure_of(compose(spec, bare=model), robot)
    return time.perf_counter() - begin


def measure(effort: Effort) -> Section:
    section = Section(
        "Recordings on a robot: with `retarget`, and with mink, frame by frame.",
        ("recording", "by", "deepest [mm]", "slip [mm]", "off: median [cm]", "95 % [cm]", "beyond ranges [°]",
         "jerk [m/s³]", "force [weight]", "× real time", "× real time, model read"),
    )  # fmt: skip
    mink = peer("mink")
    if mink is None:
        section.notes.append("mink is not installed (pip install mink daqp): ours alone")
    robot = os.environ.get("DYNSPLINES_ROBOT", "human")
    ours: list[Array] = []
    theirs: list[Array] = []
    reading(robot)  # once before all: MuJoCo keeps what it makes of meshes
    with tempfile.TemporaryDirectory() as folder:
        for file in recordings(effort, Path(folder)):
            effort.report(file.stem)
            begin = time.perf_counter()
            result, _ = command.clean_recording(command.Source(file, robot, avoids_self_collision=True), None, quiet())
            first, last = result.before.span
            spent = time.perf_counter() - begin
            goal = Goal.of(file, result)
            row = measured(result, result.after, goal)
            ours.append(np.array(row))
            length, took = last - first, reading(robot)
            section.add(file.stem, "ours", *row, length / spent, length / (spent - took))
            if mink is None:
                continue
            begin = time.perf_counter()
            qpos = framewise(mink, goal)
            spent = time.perf_counter() - begin
            row = measured(result, natural_spline(goal.t, RecordedMotion.of(result.figure, goal.t, qpos).states), goal)
            theirs.append(np.array(row))
            section.add(file.stem, "mink", *row, np.nan, length / spent)
    most, mine = np.max(ours, axis=0), np.array(ours)
    section.targets = [
        Target("deepest penetration", most[0], 2.0, unit="mm"),
        Target("stance slip", most[1], 10.0, unit="mm"),
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
