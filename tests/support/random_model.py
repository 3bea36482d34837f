"""Random models that mix all joints: several trees, several joints a body, bodies welded on, references off zero."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.figure.figure import Figure

MOST_LINKS = 14
HINGE, SLIDE, BALL = mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_BALL
ON_A_BODY = ((), (HINGE,), (HINGE, HINGE), (SLIDE, HINGE), (BALL,), (BALL,), (BALL,), (SLIDE, BALL), (SLIDE, SLIDE))


def random_model(rng: np.random.Generator) -> mujoco.MjModel:
    """A model of a few trees; free joints only where MuJoCo has them, on bodies of the world."""
    return _random_spec(rng).compile()


def _random_spec(rng: np.random.Generator) -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.option.gravity = rng.normal(size=3) * [1, 1, 9]
    spec.compiler.degree = False
    budget = int(rng.integers(3, MOST_LINKS))
    while budget > 0:
        budget = _grown(spec.worldbody, rng, budget, depth=0)
    return spec


def _grown(parent: mujoco.MjsBody, rng: np.random.Generator, budget: int, depth: int) -> int:
    """A body with its joints and children; returns how many joints are left to give."""
    body = parent.add_body(pos=rng.normal(size=3), quat=_turn(rng))
    body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=rng.uniform(0.05, 0.3, 3), pos=0.2 * rng.normal(size=3))
    if depth == 0 and rng.random() < 0.5:
        body.add_freejoint()
        budget -= 1
    else:
        for kind in ON_A_BODY[rng.integers(len(ON_A_BODY))]:
            where = 0.1 * rng.normal(size=3) if rng.random() < 0.5 else np.zeros(3)
            armature = 0.05 if rng.random() < 0.3 else 0.0
            joint = body.add_joint(type=kind, axis=_axis(rng), pos=where, armature=armature)
            if kind != BALL and rng.random() < 0.5:
                joint.ref = rng.normal()
            budget -= 1
    for _ in range(rng.integers(0, 3) if depth else 2):
        if budget > 0 and depth < 5:
            budget = _grown(body, rng, budget, depth + 1)
    return budget


def _turn(rng: np.random.Generator) -> np.ndarray:
    quat = rng.normal(size=4)
    return quat / np.linalg.norm(quat)


def _axis(rng: np.random.Generator) -> np.ndarray:
    axis = rng.normal(size=3)
    return axis / np.linalg.norm(axis)


def random_figure(seed: int, coordinates: str) -> tuple[Figure, np.random.Generator]:
    rng = np.random.default_rng(seed)
    model = random_model(rng)
    while model.njnt == 0:
        model = random_model(rng)
    return Figure(model, coordinates), rng
