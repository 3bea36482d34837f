"""Every way to change a clip's text: a function of its blocks and of what the page says.

tables       the text as blocks, one of which an edit takes apart; numbers as a file has them
keys         keyframes: move, add, take away, copy, mirror
poses        what a keyframe says of joints, root and places
constraints  contacts, holds, weights of soft constraints, settings
obstacles    what stands about
"""

from __future__ import annotations

from collections.abc import Callable

from . import constraints, keys, obstacles, poses

Edit = Callable[..., str]  # (blocks, **what the page says) -> words for what was done

EDITS: dict[str, Edit] = {
    **{name: getattr(keys, name) for name in keys.EDITS},
    **{name: getattr(poses, name) for name in poses.EDITS},
    **{name: getattr(constraints, name) for name in constraints.EDITS},
    **{name: getattr(obstacles, name) for name in obstacles.EDITS},
}
