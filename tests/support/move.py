"""A clip and its motion, measured by MuJoCo's kinematics and geometry 500 times a second."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import mujoco
import numpy as np
import shipped
from oracles import kinematics
from paper.penetration import Penetration, penetration, self_penetration

from dynsplines.clip.build import Clip
from dynsplines.motion import continuous, sampled, samples_at
from dynsplines.solver.array import Array
from dynsplines.solver.contacts import Stance, grasped_links
from dynsplines.solver.curve.spline import path_of
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.penalty import Attachment, BendLimits, Sum
from dynsplines.solver.solution import Solution
from dynsplines.solver.surface.points import places_of
from dynsplines.solver.surface.touch import movers

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
    done = shipped.solved(name)
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
