"""Shipped clips, solved once a run, their variations, and measures of their motion by MuJoCo."""

from __future__ import annotations

import hashlib
import os
import pickle
import re
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from paper.penetration import Penetration, penetration, self_penetration
from processes import quiet
from rekeyed import with_keys

from dynsplines import recordings, solving
from dynsplines.clip import load as clips
from dynsplines.clip.build import Clip
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import tables
from dynsplines.motion import Saved, continuous, sampled, samples_at
from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Stance, grasped_links
from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.algebra import dot
from dynsplines.solver.figure.figure import JointKind
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Attachment, BendLimits, JointRange, Sum, joint_ranges
from dynsplines.solver.solution import Solution
from dynsplines.solver.surface.points import places_of
from dynsplines.solver.surface.touch import movers, solids
from dynsplines.solving import Solved
from dynsplines.system.progress import Progress

# Shipped clips, solved once for all tests of a run, whichever of its processes asks first.

SOLVE = solving.solve  # whatever `share` puts in its place, which would wait for its own lock
PLACE = "DYNSPLINES_TESTS_SOLVED"  # the folder of this run's solved clips; its other processes inherit it


def open_folder() -> None:
    """Makes this run's folder, in the first of its processes."""
    if PLACE not in os.environ:
        os.environ[PLACE] = tempfile.mkdtemp(prefix="dynsplines-tests-")


def remove_folder() -> None:
    shutil.rmtree(os.environ[PLACE], ignore_errors=True)


@cache
def solved(name: str) -> Solved:
    """A shipped clip as `dynsplines solve` solves it."""
    return _cached(recordings.load(name), quiet(), SOLVE)


@cache
def unsolved(name: str) -> Saved:
    """The raw motion of a shipped clip, without a report."""
    return solving.unsolved(recordings.load(name)).saved(quiet(), with_report=False)


def _cached(problem: Clip, progress: Progress, solve: Callable[[Clip, Progress], Solved]) -> Solved:
    file = Path(os.environ[PLACE]) / _key(problem)
    with _locked(file.with_suffix(".lock")):
        if not file.exists():
            solved, motion = (result := solve(problem, progress)), result.motion
            about = motion.trace, motion.evaluations, motion.stop
            timeline = None if motion.timeline is motion.raw else replace(motion.timeline)  # without its cached spline
            file.write_bytes(pickle.dumps((timeline, about, solved.seconds)))
            return solved
        timeline, about, seconds = pickle.loads(file.read_bytes())
    raw = problem.problem.raw
    motion = Solution(problem.figure, problem.problem.objective, raw if timeline is None else timeline, raw, *about)
    return Solved(problem, motion, seconds)


def _key(problem: Clip) -> str:
    """A hash of all inputs of the search."""
    content = tables(table_of(problem.text, problem.name)) if problem.text else {}
    keys = [(key.time, key.state.tobytes(), key.fixed.tobytes(), key.known.tobytes()) for key in problem.keys]
    weights = [(penalty.name, weight) for penalty, weight in problem.penalties]
    posed, slope = problem.problem, problem.problem.end_slope
    end = problem.ends, posed.travel, posed.turn, None if slope is None else slope.tobytes()
    scene = problem.scene.mjcf, sorted(problem.scene.assets.items()), problem.figure.coordinates
    return hashlib.sha256(repr((content, keys, weights, end, problem.settings, scene)).encode()).hexdigest()


def share(monkeypatch: pytest.MonkeyPatch) -> None:
    """From here on whatever is solved in a test is solved once for all tests of a run that ask for the same."""
    solve = solving.solve

    def shared(problem: Clip, progress: Progress, **more: Any) -> Solved:
        return (
            solve(problem, progress, **more) if more or problem.custom_penalties else _cached(problem, progress, solve)
        )

    monkeypatch.setattr(solving, "solve", shared)


@contextmanager
def _locked(file: Path) -> Iterator[None]:
    """With no other process of this run in the same place, where the system has locks."""
    if os.name == "nt":
        yield
        return
    import fcntl

    with file.open("w") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX)
        yield


# Variations of a clip: every joint turned by up to 5°, another step height, keyframes lifted until they touch.

TOUCH = 0.005
REACH = 0.05


def nearest(model: mujoco.MjModel, qpos: Array) -> float:
    """Signed distance [m] of the figure's nearest geom to the scene, at most `REACH`."""
    data = kinematics(model, qpos)
    least, moving = REACH, np.array(movers(model))
    for solid in solids(model):
        away = np.maximum(np.abs(data.geom_xpos[moving] - data.geom_xpos[solid]) - model.geom_size[solid], 0)
        if model.geom_type[solid] == mujoco.mjtGeom.mjGEOM_PLANE:
            away = away[:, 2:]
        for geom in moving[np.linalg.norm(away, axis=1) < model.geom_rbound[moving] + REACH].tolist():
            least = min(least, mujoco.mj_geomDistance(model, data, geom, solid, REACH, None))
    return least


def lifted(model: mujoco.MjModel, qpos: Array, *, drop: bool) -> Array:
    """The configuration raised until nothing penetrates; with `drop`, also lowered until something touches."""
    out = np.array(qpos)
    while nearest(model, out) < 0:
        out[2] += 0.02
    while drop and nearest(model, out) >= REACH:
        out[2] -= 0.02
    low, high = out[2] - 0.08, out[2]
    if not drop and nearest(model, out - 0.02 * np.eye(out.size)[2]) >= 0:
        return out
    for _ in range(16):
        out[2] = (low + high) / 2
        low, high = (low, out[2]) if nearest(model, out) >= 0 else (out[2], high)
    out[2] = high
    return out


def perturbed(text: str, seed: int, degrees: float = 5.0, heights: tuple[float, float] = (0.25, 0.40)) -> clips.Clip:
    """The clip of a TOML text, varied by the seed."""
    rng = np.random.default_rng(seed)
    height = rng.uniform(*heights)
    plain = recordings.from_text(text, name="plain")
    other = recordings.from_text(re.sub(r"height = [\d.]+", f"height = {height:.4f}", text), name=f"perturbed {seed}")
    model, keys = other.figure.model, []
    grounded = [nearest(plain.figure.model, np.array(key.state)) < TOUCH for key in plain.keys]
    for key, touching in zip(other.keys, grounded, strict=True):
        qpos = np.array(key.state)
        for link in other.figure.links[1:]:
            if link.kind is JointKind.BALL:
                columns = slice(link.qpos, link.qpos + 4)
                turn = quat.from_rotation_vector(np.radians(rng.uniform(-degrees, degrees, 3)))
                qpos[columns] = quat.product(qpos[columns], turn)
        keys.append(replace(key, state=lifted(model, qpos, drop=touching)))
    return with_keys(other, keys)


# A clip and its motion, measured by MuJoCo's kinematics and geometry 500 times a second.

RATE = 500.0


@dataclass(frozen=True, eq=False)
class Move:
    clip: Clip
    motion: Solution

    @cached_property
    def time(self) -> Array:
        first, last = self.clip.keys[0].time, self.clip.keys[-1].time
        return np.linspace(first, last, round((last - first) * RATE) + 1)

    @cached_property
    def qpos(self) -> Array:
        return continuous(self.clip.figure, self.motion.at(self.time))

    @cached_property
    def scene(self) -> mujoco.MjModel:
        return self.clip.figure.model

    @cached_property
    def _poses(self) -> tuple[Array, Array, Array]:
        """Sites (T, n, 3), the centre of mass (T, 3) and bodies' upward axes (T, b, 3) at all times."""
        sites, centre, up = [], [], []
        for qpos in self.qpos:
            data = kinematics(self.scene, qpos)
            sites.append(data.site_xpos.copy())
            centre.append(data.subtree_com[1].copy())
            up.append(data.xmat.reshape(-1, 3, 3)[:, :, 2].copy())
        return np.array(sites), np.array(centre), np.array(up)

    def site(self, name: str) -> Array:
        """(T, 3) [m]"""
        return self._poses[0][:, self.scene.site(name).id]

    @property
    def centre(self) -> Array:
        """(T, 3) [m] of mass."""
        return self._poses[1]

    def up(self, body: str) -> Array:
        """(T, 3) a body's upward axis."""
        return self._poses[2][:, self.scene.body(body).id]

    def at(self, time: float) -> int:
        return int(np.argmin(np.abs(self.time - time)))

    def body(self, name: str) -> Array:
        """(T, 7) place [m] and rotation of a body with a free joint."""
        start = int(self.scene.joint(name).qposadr[0])
        return self.qpos[:, start : start + 7]

    def gap(self, time: float, words: tuple[str, ...], obstacle: str) -> float:
        """The least distance [m] of geoms whose names begin with some words from an obstacle."""
        data = kinematics(self.scene, self.qpos[self.at(time)])
        own = [g for g in range(self.scene.ngeom) if self.scene.geom(g).name.startswith(words)]
        solid = self.scene.geom(obstacle).id
        return min(mujoco.mj_geomDistance(self.scene, data, geom, solid, 1.0, None) for geom in own)

    def deep(self, *, raw: bool, rate: float = RATE) -> Penetration:
        run = sampled(self.clip.figure, self.motion.raw if raw else self.motion.timeline, rate)
        return penetration(self.scene, run.time, run.qpos)

    def samples(self, first: float, last: float, count: int) -> Samples:
        return samples_at(self.clip.figure, path_of(self.motion.timeline), np.linspace(first, last, count))

    def all(self) -> Samples:
        return self.samples(self.clip.keys[0].time, self.clip.keys[-1].time, 500)

    def bends(self, samples: Samples | None = None) -> Array:
        """(3, b, T) [degrees] flexion, sideways and twist of knees and elbows."""
        return np.degrees(BendLimits(self.clip.context.bends).angles(self.all() if samples is None else samples))

    @property
    def knees(self) -> list[int]:
        return [i for i, bend in enumerate(self.clip.context.bends) if "knee" in bend.name]

    def stances(self) -> tuple[Stance, ...]:
        penalties = [penalty for penalty, _ in self.clip.penalties]
        parts = [p for penalty in penalties for p in (penalty.parts if isinstance(penalty, Sum) else (penalty,))]
        resting = [part for part in parts if isinstance(part, Attachment) and part.name == "attach.stance"]
        return tuple(stance for part in resting for stance in part.stances)

    def displacement(self, stance: Stance) -> Array:
        """(3, S) [m] how far a point at rest is from its spot."""
        samples = self.samples(stance.first, stance.last, 100)
        places, _ = places_of((stance.point,), samples)
        return places[:, 0] - stance.place(samples.t)

    def keyframe_error(self) -> float:
        """The largest error of an entry that a keyframe fixes, rotations by either quaternion."""
        worst = 0.0
        for key, qpos in zip(self.clip.keys, self.motion.at([key.time for key in self.clip.keys]), strict=True):
            wanted = np.array(key.state)
            for columns in self.clip.figure.tables.quaternion_columns.T:
                wanted[columns] *= np.sign(wanted[columns] @ qpos[columns]) / np.linalg.norm(wanted[columns])
            worst = max(worst, float(np.abs(qpos - wanted)[key.fixed].max(initial=0.0)))
        return worst


@cache
def of(name: str) -> Move:
    """A shipped clip, solved once in a run of the tests."""
    done = solved(name)
    return Move(done.clip, done.motion)


def in_carried(clip: Clip, time: Array, qpos: Array) -> dict[str, Any]:
    """The deepest along qpos (T, nq), and where; empty if it holds nothing."""
    model, links = clip.figure.model, grasped_links(clip.figure, clip.context.schedule.grasps)
    if not links:
        return {}
    geoms = np.array(movers(model), np.intp)
    is_carried = np.isin(clip.figure.body_link[model.geom_bodyid[geoms]], links)
    pairs = np.array(np.meshgrid(geoms[~is_carried], geoms[is_carried])).reshape(2, -1)
    deepest, where = self_penetration(model, pairs, time, qpos)
    return {"deepest": deepest, "where": where}


# What is measured of squats, at 1 kHz: depth of the soles, how far they move, knees, ranges, angular acceleration.

SQUAT_RATE = 1000.0  # [Hz]


@dataclass(frozen=True)
class Measured:
    """The worst of a motion.

    deep, moved  [m] of the sole points: below the ground, and away from where they begin
    beyond       [degrees] beyond its range, by joint, of those that are
    flexion      [degrees] least of the knees and elbows on ball joints; crooked: most sideways and twisted
    acceleration [rad/s²] of a link relative to its parent
    """

    deep: float
    moved: float
    beyond: dict[str, float]
    flexion: float
    crooked: float
    acceleration: float


def solved_squat(problem: Clip, **settings: Any) -> solving.Solved:
    problem = problem.with_problem(settings=replace(problem.settings, **settings))
    return solving.solve(problem, quiet())


def squat(height: float, *, contacts: bool, figure: str = "human") -> Clip:
    """The simplest squat: at rest, the root at a height, at rest again."""
    text = f"""figure = "{figure}"
        [[keyframe]]
        time = 0
        others = "rest"
        [[keyframe]]
        time = 1
        root.position = [0, 0, {height}]
        [[keyframe]]
        time = 2
        others = "rest"
        """
    for point in ("left_heel", "right_heel", "left_toe", "right_toe") if contacts else ():
        text += f'[[contact]]\npoint = "{point}"\nfrom = 0\nto = 2\n'
    return recordings.from_text(text, name="squat")


def measured(problem: Clip, timeline: Timeline) -> Measured:
    path, figure = path_of(timeline), problem.figure
    first, last = path.span
    samples = samples_at(figure, path, np.linspace(first, last, round((last - first) * SQUAT_RATE) + 1))
    centres, _ = places_of(problem.context.points, samples)
    inside = np.max([surface.inside(centres) for surface in problem.context.surfaces], axis=0)
    away = np.sqrt(dot(centres - centres[:, :, :1], centres - centres[:, :, :1]))
    ranges = JointRange(joint_ranges(figure))
    beyond = np.degrees(ranges.beyond(samples).max(axis=1)) if ranges.joints else np.zeros(0)
    bends = next((penalty for penalty, _ in problem.penalties if isinstance(penalty, BendLimits)), None)
    angles = np.zeros((3, 1, 1)) if bends is None else np.degrees(bends.angles(samples))
    return Measured(
        float(inside.max()),
        float(away.max()),
        {joint.name: float(over) for joint, over in zip(ranges.joints, beyond, strict=True) if over > 0},
        float(angles[0].min()),
        float(np.abs(angles[1:]).max()),
        _acceleration(samples),
    )


def _acceleration(samples: Samples) -> float:
    links, figure = samples.links, samples.figure
    relative = np.linalg.norm(links.alpha - links.alpha[:, figure.tables.parents], axis=0)
    turning = [i for i, link in enumerate(figure.links) if i and link.kind in (JointKind.BALL, JointKind.HINGE)]
    return float(relative[turning].max())
