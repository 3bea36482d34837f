"""The speculative result for a text that may follow, computed in the background."""

from __future__ import annotations

from dataclasses import dataclass

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.solution import Solution

from ...clip.build import Clip


@dataclass(frozen=True, eq=False)
class Speculation:
    """A clip, and how far the search of its path has come.

    before    the clip that it was made of by an edit
    begin     where its search began;  between  [s] what alone was edited, None where more was
    found     the best path so far; None as long as none is better than the one that it began with
    """

    before: Clip
    clip: Clip
    begin: Timeline
    between: tuple[float, float] | None
    found: Solution | None = None

    def is_of(self, text: str, before: Clip | None) -> bool:
        """Whether this is the result of a text, edited from the present clip."""
        return self.clip.text == text and self.before is before
