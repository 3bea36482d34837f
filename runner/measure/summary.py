"""What a solve left, in few words: how it went and what is wrong, without measuring anything at length."""

from __future__ import annotations

from collections.abc import Sequence

from ..motion import Saved
from .violation import Violation, plain


def summary(saved: Saved, found: Sequence[Violation]) -> dict[str, object]:
    """Plain numbers for JSON; the objective where a search left its values, and what the file keeps of that search."""
    times, trace = saved.timeline.times, saved.trace
    values = {"objective before": trace[0][2], "objective": trace[-1][2]} if trace else {}
    return {
        "clip": saved.name,
        "duration, s": float(times[-1] - times[0]),
        "keyframes": len(saved.keys),
        "partial keyframes": sum(not key.is_key for key in saved.keys),
        "variable frames": saved.timeline.variable_count,
        **values,
        **saved.search,
        "violations": plain(found),
    }
