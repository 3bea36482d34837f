"""Shipped clips, solved once a run, and measures of their motion by MuJoCo."""

import hashlib
import os
import pickle
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from oracles import kinematics
from paper.penetration import Penetration, penetration, self_penetration
from processes import quiet

from dynsplines import recordings, solving
from dynsplines.clip.build import Clip
from dynsplines.clip.parse import table_of
from dynsplines.clip.text import tables
from dynsplines.motion import Sampled, Saved, continuous, samples_at
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Contact, grasped_links
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Attachment, BendLimits, Sum
from dynsplines.solver.surface.points import places_of
from dynsplines.solver.surface.touch import movers
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
def loaded(name: str) -> Clip:
    """A shipped clip, whose keyframes are posed once in a run of the tests."""
    file = Path(os.environ[PLACE]) / name
    with _locked(file.with_suffix(".loading")):
        if file.exists():
            return pickle.loads(file.read_bytes())
        clip = recordings.load(name)
        file.write_bytes(pickle.dumps(clip))
        return clip


@cache
def solved(name: str) -> Saved:
    """The motion of a shipped clip as `dynsplines solve` solves it."""
    return _cached(loaded(name), quiet(), SOLVE)


@cache
def unsolved(name: str) -> Saved:
    """The raw motion of a shipped clip, without a report."""
    return solving.raw_spline(loaded(name))


def follow() -> None:
    """From here on recordings that are shipped clips are solved once for all tests of a run."""

    @lru_cache
    def shared(name: str) -> Saved:
        return solved(name)

    recordings._shipped_motion = shared


def _cached(problem: Clip, progress: Progress, solve: Callable[[Clip, Progress], Saved]) -> Saved:
    file = Path(os.environ[PLACE]) / _key(problem)
    with _locked(file.with_suffix(".lock")):
        if not file.exists():
            motion = solve(problem, progress)
            timeline = None if motion.timeline is motion.raw else replace(motion.timeline)  # without its cached spline
            file.write_bytes(pickle.dumps((timeline, motion.trace, motion.search)))
            return motion
        timeline, trace, search = pickle.loads(file.read_bytes())
    raw = solving.raw_spline(problem)
    return replace(raw, timeline=timeline or raw.timeline, trace=trace, search=search)


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

    def shared(problem: Clip, progress: Progress, **more: Any) -> Saved:
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


# A clip and its motion, measured by MuJoCo's kinematics and geometry 500 times a second.

RATE = 500.0


@dataclass(frozen=True, eq=False)
class Move:
    clip: Clip
    motion: Saved

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
        data = mujoco.MjData(self.scene)
        sites, centre, up = [], [], []
        for qpos in self.qpos:
            kinematics(self.scene, qpos, data)
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
        run = Sampled.of(self.motion.before if raw else self.motion, rate)
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

    def stances(self) -> tuple[Contact, ...]:
        penalties = [penalty for penalty, _ in self.clip.penalties]
        parts = [p for penalty in penalties for p in (penalty.parts if isinstance(penalty, Sum) else (penalty,))]
        resting = [p for p in parts if isinstance(p, Attachment) and p.name in ("attach.stance", "attach.contact")]
        contacts = (contact for part in resting for contact in part.contacts if contact.is_placed)
        return tuple(piece for contact in contacts for piece in contact.pieces())

    def displacement(self, stance: Contact) -> Array:
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
    return Move(loaded(name), solved(name))


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
