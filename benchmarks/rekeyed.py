"""A clip with other keyframes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from dynsplines.clip.build import Clip, build
from dynsplines.clip.parse import Parsed
from dynsplines.clip.posing.standing_feet import Stander
from dynsplines.solver.curve.frame import Frame


def with_keys(clip: Clip, keys: Sequence[Frame]) -> Clip:
    """The clip with other keyframes. Contacts, gait and poses are inferred again."""
    source = Parsed.of(clip.text, clip.name, clip.name)
    source = source.with_solve(source.table.solve, [key.time for key in keys])
    keys = [replace(key, posed=None) for key in keys]
    if clip.text:
        keys = Stander.of(source, clip.figure).pose_feet(keys)
    rebuilt = build(source, clip.scene, clip.figure, keys, clip.fps)
    with_custom = rebuilt.with_problem(penalties=(*rebuilt.penalties, *clip.custom_penalties))
    return replace(with_custom, custom_penalties=clip.custom_penalties)
