"""Soft constraints of a program's own, beside those that clips know: given in Python, and never lost in silence."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from dynsplines.solver.penalty import Penalty

from ..errors import UserError
from .kinds import KINDS
from .load import Clip

Own = Sequence[tuple[Penalty, float]]


def with_own(clip: Clip, own: Own) -> Clip:
    """The clip with soft constraints of a program's own, each with its weight, after those that it has.

    Raises UserError for one that is none, has no weight, or is called as another.
    """
    taken = {penalty.name for penalty, _ in clip.penalties} | {k.term(part) for k in KINDS.values() for part in k.parts}
    where = f"{clip.name}: own"
    for entry in own:
        if not (isinstance(entry, tuple) and len(entry) == 2 and isinstance(entry[0], Penalty)):
            raise UserError(f"{where}: every entry is (penalty, weight), a soft constraint and a number, not {entry!r}")
        penalty, weight = entry
        if isinstance(weight, bool) or not isinstance(weight, int | float) or not 0 <= weight < np.inf:
            raise UserError(f"{where}: the weight of '{penalty.name}' is a number from 0 on, not {weight!r}")
        if penalty.name in taken:
            raise UserError(f"{where}: a soft constraint called '{penalty.name}' is there already; call it otherwise")
        taken.add(penalty.name)
    more = tuple((penalty, float(weight)) for penalty, weight in own if weight > 0)
    return replace(clip, own=(*clip.own, *more), problem=replace(clip.problem, penalties=(*clip.penalties, *more)))


def unknown_here(names: Iterable[str]) -> str:
    """What to say of soft constraints that a file names and nobody here knows."""
    called = " and ".join(f"'{name}'" for name in names)
    return f"its search also kept {called} small, of a program's own: nobody knows it here, so give it again"
