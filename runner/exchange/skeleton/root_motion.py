"""The root of a figure in a recording, moved on a free joint or on slides."""

from __future__ import annotations

import mujoco
import numpy as np

from dynsplines.solver.array import Array
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.root import Root, roots_of
from dynsplines.solver.posing import WHOLE_TURNS, BodyGoal, PoseSearch

from ...errors import UserError
from ...scene.configuration import posed
from ...scene.framing import root_places
from . import hierarchy

TURNED, MOVED = float(np.radians(0.5)), 0.005  # [rad, m] allowed deviation of a root from the recorded one


def carrying(model: mujoco.MjModel, body: int) -> Root | None:
    """Return the root of the tree of a body; None if the tree is fixed to the world or moves on hinges alone."""
    chain = hierarchy.above(model, body, itself=True)
    return next((root for root in roots_of(model) if root.body in chain), None)


def shifted(model: mujoco.MjModel, root: Root, qpos: Array, by: Array) -> Array:
    """Return qpos (T, nq) with the root translated by vectors (T, 3) [m] in world axes, as far as its slides permit."""
    out = qpos.copy()
    if root.is_free:
        start = int(model.jnt_qposadr[root.joints[0]])
        out[:, start : start + 3] += by
        return out
    slides = [joint for joint in root.joints if model.jnt_type[joint] == JointKind.SLIDE]
    columns = model.jnt_qposadr[slides]
    for row, move, data in zip(out, by, posed(model, qpos), strict=True):
        row[columns] += np.linalg.lstsq(data.xaxis[slides].T, move, rcond=None)[0]
    return out


def placed(model: mujoco.MjModel, root: Root, qpos: Array, position: Array, rotation: Array, where: object) -> Array:
    """Return qpos (T, nq) with a root of slides and hinges at positions (T, 3) [m] and orientations (T, 4) wxyz.

    Each sample is solved from the previous one, so that hinges are continuous. Raises UserError if the joints do not
    reach the recorded root; where: label of the file in errors.
    """
    out, turned, figure = qpos.copy(), np.zeros(len(qpos)), Figure(model)
    free = np.zeros(figure.width, bool)
    for i in root.links:
        free[figure.links[i].columns] = figure.links[i].kind is not JointKind.SLIDE
    for i, row in enumerate(out):
        goal = BodyGoal("root", rotation[i], root.body)
        start = np.where(free, out[max(i - 1, 0)], row)
        pose = PoseSearch(figure, start, free, (goal,), None, beyond=WHOLE_TURNS).exactly(start)
        row[free], turned[i] = pose.qpos[free], pose.worst
    away = position - root_places(model, root, out)
    out = shifted(model, root, out, away)
    missed = np.linalg.norm(position - root_places(model, root, out), axis=1)
    if turned.max() > TURNED or missed.max() > MOVED:
        names = ", ".join(f"'{model.joint(joint).name}'" for joint in root.joints)
        raise UserError(
            f"{where}: the figure's root moves on {names} alone; the file's root goes {missed.max():.2f} m and "
            f"{np.degrees(turned.max()):.0f} degrees beyond them; give a figure with a free joint"
        )
    return out
