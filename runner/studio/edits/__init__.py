"""Edits of a clip's text. Each is a function of its blocks and of the page's arguments, and returns a description.

tables       the text as blocks, of which an edit parses one; numbers in the notation of files
keys         keyframes: move, add, delete, copy, mirror
poses        a keyframe's joints, root and target positions
constraints  contacts, holds, weights of soft constraints, settings
obstacles    obstacles of the scene
"""

from __future__ import annotations

from collections.abc import Callable

from . import constraints, keys, obstacles, poses

Edit = Callable[..., str]  # (blocks, **arguments of the page) -> description of the edit

EDITS: dict[str, Edit] = {
    **{name: getattr(keys, name) for name in keys.EDITS},
    **{name: getattr(poses, name) for name in poses.EDITS},
    **{name: getattr(constraints, name) for name in constraints.EDITS},
    **{name: getattr(obstacles, name) for name in obstacles.EDITS},
}
