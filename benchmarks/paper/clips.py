"""The shipped clips with the paper's method, without the soft constraint that was learned from recordings."""

from __future__ import annotations

from dynsplines import recordings
from dynsplines.clip.build import Clip


def loaded(name: str) -> Clip:
    """Return a shipped clip, with a weight of 0 for `prior`."""
    shipped = recordings.load(name)
    return shipped.with_problem(penalties=tuple(pair for pair in shipped.penalties if pair[0].name != "prior"))
