"""Entries of a keyframe's `root` and `roots.NAME`: of a free joint, or of slides and hinges of another root.

`root` is the figure's root, `roots.NAME` any mobile tree, by the name of its free joint or body. Slides and hinges are
set as far as their degrees of freedom permit: first those that rotate the body, then those that translate it.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import mujoco
import numpy as np

from dynsplines.solver import quaternion as quat
from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.forward import set_qpos
from dynsplines.solver.figure.root import Root, roots_of
from dynsplines.solver.posing import WHOLE_TURNS, BodyGoal, in_winding, posed, rest_rotation

from ...errors import UserError, unknown
from ..table import UP, KeyframeTable, RootTable, RotationTable

MOVED = 1e-6  # [m] tolerance of a root's position
FLAT = 1e-9  # component of a joint's motion below which it is ignored


def root_links(figure: Figure, row: KeyframeTable) -> set[int]:
    """Return the links of the roots that a keyframe's tables set, without those that are posed."""
    posed = {root.body for root, _ in posed_roots(figure, row)}
    return {link for root, _ in _tables(figure, row) if root.body not in posed for link in root.links}


def posed_roots(figure: Figure, row: KeyframeTable) -> list[tuple[Root, Sequence[float | str]]]:
    """Return roots whose position depends on hinges that a keyframe leaves free, where slides follow hinges.

    Each has the position (3,) [m] of the keyframe, with "free" for unspecified axes; it requires a pose.
    """
    if row.others != "free":
        return []
    posed: list[tuple[Root, Sequence[float | str]]] = []
    for root, table in _tables(figure, row):
        is_placed = "rotation" not in table.model_fields_set and table.position != "free"
        if is_placed and not root.is_free and table.position != ("free",) * 3:
            chain = _Chain(figure, root, np.array(figure.model.qpos0), row.joints, "")
            wanted = np.array([axis != "free" for axis in table.position])
            if chain.turner(wanted, np.isin(np.arange(figure.width), _named_entries(figure, row))) is not None:
                posed.append((root, table.position))
    return posed


def _named_entries(figure: Figure, row: KeyframeTable) -> list[int]:
    names = {name for name, value in row.joints.items() if value != "free"}
    named = [link for link in figure.links[1:] if link.name in names]
    return [k for link in named for k in range(link.columns.start, link.columns.stop)]


def _tables(figure: Figure, row: KeyframeTable) -> list[tuple[Root, RootTable]]:
    main = [(figure.root, row.root)] if row.root.model_fields_set and figure.root is not None else []
    named = roots_by_name(figure) if row.roots else {}
    return main + [(named[name], table) for name, table in row.roots.items() if name in named]


def roots_by_name(figure: Figure) -> dict[str, Root]:
    """Return the roots by the names that `roots.NAME` accepts: free joints, then bodies of other roots."""
    roots = roots_of(figure.model)
    out = {figure.links[root.link].name: root for root in roots if root.is_free}
    for root in roots:
        out.setdefault(str(figure.model.body(root.body).name) or figure.links[root.link].name, root)
    return out


def set_roots(
    figure: Figure, qpos: Array, fixed: Mask, row: KeyframeTable, where: str, before: Array | None = None
) -> None:
    """Set qpos (nq,) and mask (nq,) to a keyframe's `root` and `roots`, in place.

    Slides and hinges that the keyframe names are set before and do not change.

    before  (nq,) the previous keyframe, to whose winding a quaternion refers
    """
    if row.root.model_fields_set:
        _set(figure, _own(figure, where), qpos, fixed, row.root, row, f"{where}: root", before)
    if not row.roots:
        return
    named = roots_by_name(figure)
    for name, table in row.roots.items():
        if name not in named:
            free = [link.name for link in figure.links[1:] if link.kind is JointKind.FREE]
            raise UserError(f"{where}: roots: {unknown('free joint', name, free or list(named))}")
        _set(figure, named[name], qpos, fixed, table, row, f"{where}: roots.{name}", before)


def _own(figure: Figure, where: str) -> Root:
    """Return the root that `root` places; raises UserError if the figure has none, or several."""
    root = figure.root
    if root is None:
        raise UserError(f"{where}: the figure has no free joint, so no root to place")
    names = {tree.body: name for name, tree in reversed(roots_by_name(figure).items())}
    if root.is_ambiguous:
        several = ", ".join(f"roots.{names[body]}" for body in (root.body, *root.rivals))
        raise UserError(f"{where}: root: the model has several figures; specify which: {several}")
    called = next((link for link in figure.links[1:] if link.kind is JointKind.FREE and link.name == "root"), None)
    if called is not None and called.body != root.body:
        raise UserError(
            f"{where}: root: the joint 'root' carries '{figure.model.body(called.body).name}', the figure's root "
            f"carries '{figure.model.body(root.body).name}'; specify roots.root or roots.{names[root.body]}"
        )
    return root


def _set(
    figure: Figure,
    root: Root,
    qpos: Array,
    fixed: Mask,
    table: RootTable,
    row: KeyframeTable,
    where: str,
    before: Array | None,
) -> None:
    if root.is_free:
        _set_free(figure, root, qpos, fixed, table)
        return
    chain, is_posed = _Chain(figure, root, qpos, row.joints, where), root in dict(posed_roots(figure, row))
    if "rotation" in table.model_fields_set:
        if isinstance(table.rotation, RotationTable):
            is_placed = all(fixed[figure.links[i].columns].all() for i in root.links)
            chain.turn(table.rotation, stays=is_placed and "position" not in table.model_fields_set)
            if table.rotation.quat is not None and before is not None:
                turning = np.isin(np.arange(figure.width), [figure.links[i].qpos for i in chain.turning])
                qpos[:] = in_winding(figure, qpos, before, turning)
        chain.fix(fixed, chain.turning, table.rotation != "free")
    if "position" in table.model_fields_set and not is_posed:
        axes: Sequence[float | str] = ("free",) * 3 if table.position == "free" else table.position
        wanted = np.array([axis != "free" for axis in axes])
        moving = chain.moving(wanted, fixed)
        if wanted.any():
            chain.move(np.array([0.0 if axis == "free" else float(axis) for axis in axes]), wanted, moving)
        chain.fix(fixed, chain.sliding, False)
        chain.fix(fixed, moving, True)


def _set_free(figure: Figure, root: Root, qpos: Array, fixed: Mask, table: RootTable) -> None:
    """Set a free joint's position, axis by axis, and its rotation from a table."""
    start = figure.links[root.link].qpos
    if "position" in table.model_fields_set:
        axes = ("free",) * 3 if table.position == "free" else table.position
        for i, value in enumerate(axes):
            fixed[start + i] = value != "free"
            if value != "free":
                qpos[start + i] = float(value)
    if "rotation" in table.model_fields_set:
        fixed[start + 3 : start + 7] = table.rotation != "free"
        if table.rotation != "free":
            qpos[start + 3 : start + 7] = table.rotation.quaternion(rest_rotation(figure.model, root.body))


class _Chain:
    """The slides and hinges of a root in a pose (nq,), set in place; turning, sliding: links that a table may set."""

    def __init__(self, figure: Figure, root: Root, qpos: Array, named: Collection[str], where: str) -> None:
        self.figure, self.root, self.qpos, self.where = figure, root, qpos, where
        self.data, self.called = mujoco.MjData(figure.model), figure.body_name(root.link)
        loose = [i for i in root.links if figure.links[i].name not in named]
        slides = [figure.links[i].kind is JointKind.SLIDE for i in loose]
        self.turning = [i for i, is_slide in zip(loose, slides, strict=True) if not is_slide]
        self.sliding = [i for i, is_slide in zip(loose, slides, strict=True) if is_slide]

    def fix(self, fixed: Mask, links: Sequence[int], value: bool) -> None:
        """Set a mask (nq,) at the entries of links."""
        for i in links:
            fixed[self.figure.links[i].columns] = value

    def turn(self, table: RotationTable, *, stays: bool) -> None:
        """Rotate the body as a table specifies, about its origin if it `stays` in place and slides permit. Raises
        UserError if its hinges do not reach the rotation."""
        set_qpos(self.figure.model, self.data, self.qpos)
        before = np.array(self.data.xpos[self.root.body])
        where = f"{self.where}.rotation"
        target = table.quaternion(rest_rotation(self.figure.model, self.root.body))
        hint = angles_about(table)
        hinges = [i for i in self.turning if self.figure.links[i].kind is JointKind.HINGE]
        columns = [self.figure.links[i].qpos for i in hinges]
        rest = np.array(self.figure.model.qpos0)
        set_qpos(self.figure.model, self.data, rest)
        near = rest[columns] + np.array([self.data.xaxis[self.figure.links[i].joint] @ hint for i in hinges])
        self.qpos[columns] = near
        free = np.zeros(self.figure.width, bool)
        self.fix(free, self.turning, True)
        goal = BodyGoal(self.called, target, self.root.body)
        pose = posed(self.figure, self.qpos, free, (goal,), beyond=WHOLE_TURNS)
        self.qpos[:] = pose.qpos
        if not pose.is_met:
            raise UserError(
                f"{where}: '{self.called}' turns on {self._listed(self.turning)} alone, which come within "
                f"{np.degrees(pose.worst):.3g} degrees of it; specify a rotation that they reach, or joints.NAME"
            )
        for column, angle in zip(columns, near, strict=True):  # whole turns as specified
            self.qpos[column] += 2 * np.pi * np.round((angle - self.qpos[column]) / (2 * np.pi))
        if stays:
            self._move(before, np.ones(3, bool), self.sliding)

    def moving(self, wanted: Mask, fixed: Mask) -> list[int]:
        """Return the slides that move the body along world axes (3,)."""
        turner = self.turner(wanted, fixed)
        if turner is not None:
            raise UserError(
                f"{self.where}.position: the place depends on '{turner}', which this keyframe leaves free; "
                f"specify {self.where.rpartition(': ')[2]}.rotation or joints.{turner} too"
            )
        jacobian = self._jacobian()[0]
        return [i for i in self.sliding if self._moves(jacobian, i)[wanted].any()]

    def turner(self, wanted: Mask, fixed: Mask) -> str | None:
        """Return the first free hinge or ball joint on which the body's position along axes (3,) depends."""
        jacobian = self._jacobian()[0]
        for i in self.root.links:
            link = self.figure.links[i]
            if link.kind is JointKind.SLIDE or fixed[self.figure.links[i].columns].all():
                continue
            if self._moves(jacobian, i)[wanted].any() or self._turns_slides(i):
                return link.name
        return None

    def move(self, place: Array, wanted: Mask, moving: Sequence[int]) -> None:
        """Move the body to a position (3,) [m] along some axes; raises UserError if its slides do not reach it."""
        self._move(place, wanted, moving)
        set_qpos(self.figure.model, self.data, self.qpos)
        away = np.where(wanted, place - self.data.xpos[self.root.body], 0.0)
        worst = int(np.abs(away).argmax())
        if abs(away[worst]) > MOVED:
            raise UserError(
                f"{self.where}.position: '{self.called}' moves on {self._listed(self.sliding)} alone and stays at "
                f"{'xyz'[worst]} = {self.data.xpos[self.root.body, worst]:.6g} m, not {place[worst]:.6g} m; "
                f'specify that, or "free"'
            )

    def _move(self, place: Array, wanted: Mask, moving: Sequence[int]) -> None:
        """Move the body as near to a position (3,) [m] as its slides permit."""
        jacobian = self._jacobian()[0][wanted][:, [self.figure.links[i].dof for i in moving]]
        if moving:
            away = (place - self.data.xpos[self.root.body])[wanted]
            steps = np.linalg.lstsq(jacobian, away, rcond=None)[0]
            for i, step in zip(moving, steps, strict=True):
                self.qpos[self.figure.links[i].qpos] += step

    def _listed(self, links: Sequence[int]) -> str:
        return ", ".join(f"'{self.figure.links[i].name}'" for i in links) or "no joint"

    def _jacobian(self) -> tuple[Array, Array]:
        """Return the Jacobians (3, nv) of the body's position and rotation."""
        model = self.figure.model
        set_qpos(self.figure.model, self.data, self.qpos)
        move, turn = np.zeros((3, model.nv)), np.zeros((3, model.nv))
        mujoco.mj_jacBody(model, self.data, move, turn, self.root.body)
        return move, turn

    def _moves(self, jacobian: Array, i: int) -> Mask:
        """Return the axes (3,) along which a link's joint moves the body."""
        return np.asarray(np.abs(jacobian[:, self.figure.links[i].dofs]).max(axis=1) > FLAT, bool)

    def _turns_slides(self, i: int) -> bool:
        """Return whether a settable slide follows a rotating link, in another direction than its axis."""
        link = self.figure.links[i]
        after = [k for k in self.sliding if self.root.links.index(k) > self.root.links.index(i)]
        if link.kind is JointKind.BALL:
            return bool(after)
        axes = [self.data.xaxis[self.figure.links[k].joint] for k in after]
        return any(np.linalg.norm(np.cross(self.data.xaxis[link.joint], axis)) > FLAT for axis in axes)


def angles_about(table: RotationTable) -> Array:
    """Return angles (3,) [rad] of a rotation about x, y and z in its notation, including whole turns."""
    out = np.zeros(3)
    if table.heading is not None:
        out += np.radians(table.heading) * UP
    if table.rotvec is not None:
        out += np.radians(table.rotvec)
    if table.quat is not None:
        out += quat.rotation_vector(quat.normalised(table.quat))
    for letter, angle in zip(table.order or "xyz", np.radians(table.euler or []), strict=False):
        out["xyz".index(letter)] += angle
    return out
