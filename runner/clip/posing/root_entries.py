"""Entries of a keyframe's `root` and `roots.NAME`.

`root` is the figure's root, `roots.NAME` any free joint, by its name or that of its body.
"""

from __future__ import annotations

from dynsplines.solver.array import Array, Mask
from dynsplines.solver.figure.figure import Figure, JointKind
from dynsplines.solver.figure.root import Root, roots_of, sliding_joints
from dynsplines.solver.posing import rest_rotation

from ...errors import UserError, unknown
from ..table import KeyframeTable, RootTable


def root_links(figure: Figure, row: KeyframeTable) -> set[int]:
    """Return the links of the roots that a keyframe's tables set."""
    main = {figure.root.link} if row.root.model_fields_set and figure.root is not None else set()
    named = roots_by_name(figure) if row.roots else {}
    return main | {named[name].link for name in row.roots if name in named}


def roots_by_name(figure: Figure) -> dict[str, Root]:
    """Return the roots by the names that `roots.NAME` accepts: of free joints, then of their bodies."""
    roots = roots_of(figure.model)
    out = {figure.links[root.link].name: root for root in roots}
    for root in roots:
        out.setdefault(str(figure.model.body(root.body).name) or figure.links[root.link].name, root)
    return out


def set_roots(figure: Figure, qpos: Array, fixed: Mask, row: KeyframeTable, where: str) -> None:
    """Set qpos (nq,) and mask (nq,) to a keyframe's `root` and `roots`, in place."""
    if row.root.model_fields_set:
        _set(figure, _main_root(figure, where), qpos, fixed, row.root)
    if not row.roots:
        return
    named = roots_by_name(figure)
    for name, table in row.roots.items():
        if name not in named:
            free = [link.name for link in figure.links[1:] if link.kind is JointKind.FREE]
            raise UserError(f"{where}: roots: {unknown('free joint', name, free)}")
        _set(figure, named[name], qpos, fixed, table)


def _main_root(figure: Figure, where: str) -> Root:
    """Return the root that `root` places; raises UserError if the figure has none, or several."""
    root = figure.root
    if root is None:
        joints = [figure.links[joint + 1].name for joint in sliding_joints(figure.model)]
        listed = ", ".join(f"joints.{name}" for name in joints) or "its joints, by joints.NAME"
        raise UserError(f"{where}: root: the figure has no free joint, so no root to place; specify {listed}")
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


def _set(figure: Figure, root: Root, qpos: Array, fixed: Mask, table: RootTable) -> None:
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
