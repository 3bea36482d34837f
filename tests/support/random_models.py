"""Random models, motions, keyframes and samples."""

from pathlib import Path

import motions
import mujoco
import numpy as np
from figures import link_named

from dynsplines.motion import Saved
from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame, Timeline
from dynsplines.solver.figure.figure import Figure, quaternion_columns
from dynsplines.solver.figure.kinematics import Samples
from dynsplines.solver.refine.subdivision import split

# Random models that mix all joints: several trees, several joints a body, bodies welded on, references off zero.

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


# Random motions of a model.


def motion_of(path: str | Path, seed: int, spread: float = 0.6, count: int = 3, step: float = 0.2) -> Saved:
    """The spline through random poses: joints and root within `spread` of their reference [rad, m]."""
    model, rng = mujoco.MjModel.from_xml_path(str(path)), np.random.default_rng(seed)
    qpos = np.tile(model.qpos0, (count, 1))
    for row in qpos:
        mujoco.mj_integratePos(model, row, rng.uniform(-spread, spread, model.nv), 1.0)
    return motions.through(str(path), step * np.arange(count), qpos)


# Random keyframes, whole and partial, and how far a state is from one.

TIMES = [0.0, 0.4, 1.0, 1.3]


def blocks(figure: Figure) -> list[list[int]]:
    """The columns that are fixed together: quaternions whole, all others one by one."""
    quaternions = figure.tables.quaternion_columns.T.tolist()
    taken = {column for block in quaternions for column in block}
    return quaternions + [[column] for column in range(figure.width) if column not in taken]


def mask_without(figure: Figure, *names: str) -> np.ndarray:
    """Everything fixed but these joints; "root x", "root turn" for the parts of the first free root."""
    mask = np.ones(figure.width, bool)
    for name in names:
        if name.startswith("root "):
            mask[slice(3, 7) if name == "root turn" else "xyz".index(name[-1])] = False
            continue
        link = figure.links[link_named(figure, name) or 0]
        mask[quaternion_columns(link) or link.qpos] = False
    return mask


def random_keys(figure: Figure, rng: np.random.Generator, masks: dict[int, np.ndarray] | None = None) -> list[Frame]:
    """Keyframes with moderate steps and quaternions of any sign; what is left out holds zeros."""
    pose, keys = figure.to_qpos(figure.to_state(rng.normal(size=figure.width))), []
    for number, time in enumerate(TIMES):
        pose = pose + 0.25 * rng.normal(size=pose.shape)
        mask = (masks or {}).get(number, np.ones(figure.width, bool))
        qpos = pose.copy()
        for columns in figure.tables.quaternion_columns.T:
            qpos[columns] *= rng.choice([-1, 1])
        keys.append(Frame.key(time, np.where(mask, qpos, 0.0), mask))
    return keys


def distance_from_key(figure: Figure, state: np.ndarray, key: Frame) -> float:
    """The largest difference of a state's qpos from a key in the entries that it fixes, quaternions up to the sign."""
    qpos, apart = figure.to_qpos(state), [0.0]
    for block in blocks(figure):
        if not key.fixed[block].all():
            continue
        a, b = qpos[block], key.state[block]
        if len(block) == 4:
            b = quat.normalise(b)
            a = a * np.sign(a @ b)
        apart.append(float(np.abs(a - b).max()))
    return max(apart)


def masks_by_name(figure: Figure, name: str, rng: np.random.Generator) -> dict[int, np.ndarray]:
    first_joint = figure.links[2].name
    chosen = {
        "whole": {},
        "a joint free, what hangs on it fixed": {1: mask_without(figure, first_joint), 3: mask_without(figure, "root")},
        "root orientation free": {i: mask_without(figure, "root turn") for i in range(3)},
        "root position free on single axes": {
            0: mask_without(figure, "root x", "root z"),
            2: mask_without(figure, "root y"),
        },
    }
    if name in chosen:
        return chosen[name]
    masks = {}
    for i in range(4):
        mask = np.zeros(figure.width, bool)
        for block in blocks(figure):
            mask[block] = rng.random() < 0.5
        masks[i] = mask
    return masks


def partial_keys(figure: Figure, rng: np.random.Generator) -> list[Frame]:
    joint = figure.links[2].name
    return random_keys(figure, rng, {1: mask_without(figure, joint, "root x"), 2: mask_without(figure, "root turn")})


def closed(keys: list[Frame]) -> list[Frame]:
    return [*keys[:-1], Frame.key(TIMES[-1], keys[0].state, keys[0].fixed)]


def random_qpos(figure: Figure, rng: np.random.Generator) -> np.ndarray:
    return figure.to_qpos(figure.to_state(rng.normal(size=figure.width)))


# Random samples of a figure's motion, and what tests change in them.


def random_samples(figure: Figure, rng: np.random.Generator, count: int = 5) -> Samples:
    """States with quaternions well off unit length, and derivatives of every entry."""
    y = figure.to_state(rng.normal(size=(count, figure.width)))
    lengths = rng.uniform(0.7, 1.4, size=(count, figure.width))
    for columns in figure.tables.quaternion_columns.T:
        y[:, columns] *= lengths[:, columns[:1]]
    return Samples(figure, y, rng.normal(size=y.shape), 3 * rng.normal(size=y.shape))


def at_times(samples: Samples, t: np.ndarray) -> Samples:
    return Samples(samples.figure, samples.y, samples.y_d, samples.y_dd, t)


# Variable frames at equal distances.


def evenly(timeline: Timeline, count: int) -> Timeline:
    """The timeline with `count` variable frames at equal distances inside every segment."""
    times = timeline.times
    inner = times[:-1, None] + np.arange(1, count + 1) * (np.diff(times)[:, None] / (count + 1))
    return split(timeline, inner.ravel()) if count else timeline
