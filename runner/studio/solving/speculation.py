"""The speculative result for a text that may follow, computed in the background."""

from __future__ import annotations

from dataclasses import dataclass

from dynsplines.solver.curve.frame import Timeline
from dynsplines.solver.solution import Solution

from ...clip.build import Clip


@dataclass(frozen=True, eq=False)
class Speculation:
    """A clip, and the state of the search of its path.

    Attributes:
        between: The edited interval [s]; None: the whole clip.
        solution: The best path so far; None as long as none is better than `begin`.
    """

    before: Clip
    clip: Clip
    begin: Timeline
    between: tuple[float, float] | None
    solution: Solution | None = None

    def is_of(self, text: str, before: Clip | None) -> bool:
        """Return whether this is the result of a text, edited from the present clip."""
        return self.clip.text == text and self.before is before
