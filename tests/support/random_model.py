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


def random_forced_spec(rng: np.random.Generator) -> mujoco.MjSpec:
    """A random model with every passive and constraint force of MuJoCo, and some of its flags."""
    spec = _random_spec(rng)
    while not spec.joints:
        spec = _random_spec(rng)
    disable = mujoco.mjtDisableBit
    spec.option.density, spec.option.viscosity = rng.uniform(0, [20, 0.5])
    spec.option.wind = rng.normal(size=3)
    for flag in (disable.mjDSBL_GRAVITY, disable.mjDSBL_FRICTIONLOSS, disable.mjDSBL_LIMIT, disable.mjDSBL_EQUALITY):
        spec.option.disableflags |= int(flag) * int(rng.random() < 0.15)
    for number, body in enumerate(spec.bodies[1:]):
        body.name = f"body_{number}"
        body.gravcomp = rng.choice([0.0, 0.6])
        body.add_site(name=f"site_{number}", pos=0.1 * rng.normal(size=3))
    for number, joint in enumerate(spec.joints):
        joint.name = f"joint_{number}"
        if joint.type == mujoco.mjtJoint.mjJNT_FREE and rng.random() < 0.5:
            continue
        _set_stiffness(joint, rng)
        if joint.type in (HINGE, SLIDE):
            joint.springref, joint.range = rng.normal(), [-0.5, 0.8]
            joint.limited = int(rng.random() < 0.3)
    _add_tendons(spec, rng)
    return spec


def _set_stiffness(element: mujoco.MjsJoint | mujoco.MjsTendon, rng: np.random.Generator) -> None:
    """A spring, a damper and friction; older versions have one number for each, newer ones polynomials."""
    for name, most in (("stiffness", 30.0), ("damping", 4.0), ("frictionloss", 2.0)):
        value = rng.choice([0.0, rng.uniform(0, most)])
        if np.ndim(getattr(element, name)):
            getattr(element, name)[0] = value
        else:
            setattr(element, name, value)


def _add_tendons(spec: mujoco.MjSpec, rng: np.random.Generator) -> None:
    """A tendon between the first and the last body, one over a joint, and two joints that are coupled."""
    sites, scalar = list(spec.sites), [joint for joint in spec.joints if joint.type in (HINGE, SLIDE)]
    if len(sites) > 1:
        tendon = spec.add_tendon(name="spatial")
        tendon.wrap_site(sites[0].name)
        tendon.wrap_site(sites[-1].name)
        _set_stiffness(tendon, rng)
    if scalar:
        tendon = spec.add_tendon(name="fixed")
        tendon.wrap_joint(scalar[0].name, 0.7)
        _set_stiffness(tendon, rng)
    if len(scalar) > 1:
        coupling = spec.add_equality(type=mujoco.mjtEq.mjEQ_JOINT, name1=scalar[0].name, name2=scalar[1].name)
        coupling.objtype = mujoco.mjtObj.mjOBJ_JOINT
        coupling.data[:5] = [0.1, 0.5, 0, 0, 0]


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
