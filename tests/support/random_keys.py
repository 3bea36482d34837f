"""Random keyframes, whole and partial, and how far a state is from one."""

from __future__ import annotations

import numpy as np
from figures import link_named

from dynsplines.solver import quaternion as quat
from dynsplines.solver.curve.frame import Frame
from dynsplines.solver.figure.figure import Figure, quaternion_columns

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
            b = quat.normalised(b)
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
